//! What the server answers, apart from how it is sent.

use std::borrow::Cow;

use super::assets::Asset;

/// What the page may do: run its own code and WebAssembly, draw, and load from this server only;
/// and be a frame in pages of this machine, on any port, and in no others. The page has the same
/// line for other hosts, without `frame-ancestors`, which only a header can have.
const POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; \
                      img-src 'self' data: blob:; media-src blob:; connect-src 'self'; worker-src 'self'; manifest-src 'self'; \
                      base-uri 'none'; form-action 'none'; frame-ancestors http://127.0.0.1:* http://localhost:*";

const HEADERS: [(&str, &str); 6] = [
    ("Content-Security-Policy", POLICY),
    ("X-Content-Type-Options", "nosniff"),
    ("Referrer-Policy", "no-referrer"),
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("Cross-Origin-Embedder-Policy", "require-corp"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Question<'a> {
    pub(super) reads: bool,
    /// Whether it says that a body follows.
    pub(super) has_body: bool,
    /// The header `Host`.
    pub(super) host: Option<&'a str>,
    /// Path, with a query if there is one.
    pub(super) path: &'a str,
}

#[derive(Clone, Debug)]
pub(super) struct Answer {
    pub(super) status: u16,
    pub(super) headers: Vec<(&'static str, String)>,
    pub(super) body: Cow<'static, [u8]>,
}

/// A request that is not answered with a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Refusal {
    status: u16,
    text: &'static str,
}

const OTHER_HOST: Refusal = Refusal {
    status: 421,
    text: "421: this server answers for 127.0.0.1 and localhost alone\n",
};
const WRITES: Refusal = Refusal {
    status: 405,
    text: "405: only GET and HEAD\n",
};
const HAS_BODY: Refusal = Refusal {
    status: 413,
    text: "413: a request has no body here\n",
};
const NO_FILE: Refusal = Refusal {
    status: 404,
    text: "404: there is no such file\n",
};
/// The service worker of this server. That of the page would stay in the browser, with its files,
/// for every port that was ever taken; this one ends itself, and one that stayed from another server
/// at the port.
const WORKER: &str = "self.addEventListener('install', () => self.skipWaiting());
self.addEventListener('activate', () => self.registration.unregister());
";

/// Of a request that is not HTTP/1.1.
pub(super) const MALFORMED: Refusal = Refusal {
    status: 400,
    text: "400: this is no request of HTTP/1.1\n",
};
/// Of a request whose head does not end.
pub(super) const TOO_LONG: Refusal = Refusal {
    status: 431,
    text: "431: the head of the request is too long\n",
};

impl Refusal {
    pub(super) fn answer(self) -> Answer {
        let mut headers = vec![
            ("Content-Type", "text/plain; charset=utf-8"),
            ("Cache-Control", "no-store"),
        ];
        headers.extend((self == WRITES).then_some(("Allow", "GET, HEAD")));
        with_headers(self.status, &headers, self.text.as_bytes().into())
    }
}

/// Answers a request to the server on `port`.
///
/// The host is checked because a page elsewhere may have its own name point at 127.0.0.1 (DNS
/// rebinding): its requests carry that name, and are refused.
pub(super) fn answer(
    question: &Question<'_>,
    port: u16,
    find: impl Fn(&str) -> Option<Asset>,
) -> Answer {
    let ours = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
    if !question
        .host
        .is_some_and(|host| ours.iter().any(|name| name.eq_ignore_ascii_case(host)))
    {
        return OTHER_HOST.answer();
    }
    if !question.reads {
        return WRITES.answer();
    }
    if question.has_body {
        return HAS_BODY.answer();
    }
    let path = question.path.split(['?', '#']).next().unwrap_or_default();
    let name = match path.strip_prefix('/') {
        Some("") => "index.html",
        Some(name) => name,
        None => "",
    };
    // A page is found without its ending, too.
    let file = find(name)
        .map(|file| match name {
            "sw.js" => Asset {
                content: WORKER.as_bytes().into(),
                ..file
            },
            _ => file,
        })
        .or_else(|| find(&format!("{name}.html")));
    let Some(Asset { content, kind }) = file else {
        return NO_FILE.answer();
    };
    // The names of assets change with their content; the other files keep theirs.
    let lasts = if name.starts_with("assets/") {
        "max-age=31536000, immutable"
    } else {
        "no-cache"
    };
    with_headers(
        200,
        &[("Content-Type", kind), ("Cache-Control", lasts)],
        content,
    )
}

fn with_headers(status: u16, headers: &[(&'static str, &str)], body: Cow<'static, [u8]>) -> Answer {
    let headers = HEADERS
        .iter()
        .chain(headers)
        .map(|(name, value)| (*name, (*value).to_owned()))
        .collect();
    Answer {
        status,
        headers,
        body,
    }
}
