//! What the server answers, apart from how it is sent.

use std::borrow::Cow;

use super::assets::Asset;

/// What the page may do: run its own code and WebAssembly, draw, and load from this server only. The page has the same
/// line for other hosts, without `frame-ancestors`, which only a header can have.
const POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; \
                      img-src 'self' data: blob:; media-src blob:; connect-src 'self'; worker-src 'self'; manifest-src 'self'; \
                      base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

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

const OTHER_HOST: Refusal =
    Refusal { status: 421, text: "421: this server answers for 127.0.0.1 and localhost alone\n" };
const WRITES: Refusal = Refusal { status: 405, text: "405: only GET and HEAD\n" };
const HAS_BODY: Refusal = Refusal { status: 413, text: "413: a request has no body here\n" };
const NO_FILE: Refusal = Refusal { status: 404, text: "404: there is no such file\n" };
/// Of a request that is not HTTP/1.1.
pub(super) const MALFORMED: Refusal = Refusal { status: 400, text: "400: this is no request of HTTP/1.1\n" };
/// Of a request whose head does not end.
pub(super) const TOO_LONG: Refusal =
    Refusal { status: 431, text: "431: the head of the request is too long\n" };

impl Refusal {
    pub(super) fn answer(self) -> Answer {
        let mut headers = vec![("Content-Type", "text/plain; charset=utf-8"), ("Cache-Control", "no-store")];
        headers.extend((self == WRITES).then_some(("Allow", "GET, HEAD")));
        with_headers(self.status, &headers, self.text.as_bytes().into())
    }
}

/// Answers a request to the server on `port`.
///
/// The host is checked because a page elsewhere may have its own name point at 127.0.0.1 (DNS rebinding): its requests
/// carry that name, and are refused.
pub(super) fn answer(question: &Question<'_>, port: u16, find: impl Fn(&str) -> Option<Asset>) -> Answer {
    let ours = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
    if !question.host.is_some_and(|host| ours.iter().any(|name| name.eq_ignore_ascii_case(host))) {
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
    // The service worker would stay in the browser, with its files, for every port that was ever taken. A page is found without its
    // ending, too.
    let file = find(name).filter(|_| name != "sw.js").or_else(|| find(&format!("{name}.html")));
    let Some(Asset { content, kind }) = file else {
        return NO_FILE.answer();
    };
    // The names of assets change with their content; the other files keep theirs.
    let lasts = if name.starts_with("assets/") { "max-age=31536000, immutable" } else { "no-cache" };
    with_headers(200, &[("Content-Type", kind), ("Cache-Control", lasts)], content)
}

fn with_headers(status: u16, headers: &[(&'static str, &str)], body: Cow<'static, [u8]>) -> Answer {
    let headers = HEADERS.iter().chain(headers).map(|(name, value)| (*name, (*value).to_owned())).collect();
    Answer { status, headers, body }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(name: &str) -> Option<Asset> {
        let (content, kind) = match name {
            "index.html" | "story.html" => ("<!doctype html>", "text/html; charset=utf-8"),
            "sw.js" | "assets/a.js" => ("1", "text/javascript; charset=utf-8"),
            _ => return None,
        };
        Some(Asset { content: content.as_bytes().into(), kind })
    }

    fn ask(host: Option<&str>, path: &str) -> Answer {
        answer(&Question { reads: true, has_body: false, host, path }, 4000, page)
    }

    fn header<'a>(answer: &'a Answer, name: &str) -> Option<&'a str> {
        answer.headers.iter().find(|(known, _)| *known == name).map(|(_, value)| value.as_str())
    }

    #[test]
    fn the_page_comes_with_its_policy() {
        let page = ask(Some("127.0.0.1:4000"), "/?x=1");
        assert_eq!((page.status, &*page.body), (200, &b"<!doctype html>"[..]));
        assert_eq!(header(&page, "Content-Type"), Some("text/html; charset=utf-8"));
        assert_eq!(header(&page, "X-Content-Type-Options"), Some("nosniff"));
        assert!(header(&page, "Content-Security-Policy").is_some_and(|it| it.contains("default-src 'none'")));
        assert_eq!(header(&page, "Cache-Control"), Some("no-cache"));
        let script = ask(Some("localhost:4000"), "/assets/a.js");
        assert_eq!(header(&script, "Cache-Control"), Some("max-age=31536000, immutable"));
    }

    #[test]
    fn the_story_has_an_address_without_its_ending() {
        for path in ["/story", "/story.html", "/story?x=1"] {
            let story = ask(Some("127.0.0.1:4000"), path);
            assert_eq!(
                (story.status, header(&story, "Content-Type")),
                (200, Some("text/html; charset=utf-8"))
            );
        }
        assert_eq!(ask(Some("127.0.0.1:4000"), "/sheet").status, 404);
    }

    #[test]
    fn other_hosts_are_refused() {
        for host in
            [None, Some("evil.example"), Some("evil.example:4000"), Some("127.0.0.1"), Some("127.0.0.1:4001")]
        {
            let answer = ask(host, "/");
            assert_eq!(answer.status, 421, "{host:?}");
            assert!(!answer.body.starts_with(b"<"));
        }
    }

    #[test]
    fn only_files_of_the_page_and_only_reading() {
        let question = Question { reads: true, has_body: false, host: Some("localhost:4000"), path: "/" };
        let written = answer(&Question { reads: false, ..question }, 4000, page);
        assert_eq!((written.status, header(&written, "Allow")), (405, Some("GET, HEAD")));
        assert_eq!(answer(&Question { has_body: true, ..question }, 4000, page).status, 413);
        for path in ["/etc/passwd", "/../Cargo.toml", "//index.html", "index.html", "*", "/sw.js"] {
            assert_eq!(ask(Some("localhost:4000"), path).status, 404, "{path}");
        }
    }
}
