//! Arguments of `littlewood lab`.

use std::path::PathBuf;

use clap::Args;

pub(super) const LAB: &str = "\
Serve the laboratory on 127.0.0.1 and open it in the browser: drag a start on the phase plane, and \
watch the hoop roll, slide and jump. The story, 'Does the hoop hop?', is at /story.

Everything runs on this machine, and other machines cannot connect: requests for another host name \
are refused. Ctrl-C ends it.

A program that was built after its page (web/build.sh) contains the page. Another one takes it \
from --page, or builds it if it is run in a folder of the repository; this needs node.";

/// Arguments of `littlewood lab`.
#[derive(Debug, Args)]
pub(crate) struct LabArgs {
    /// Port to listen on; 0 chooses a free one
    #[arg(long, value_name = "PORT", default_value_t = 0)]
    pub(crate) port: u16,
    /// Folder of a built page to serve instead
    #[arg(long, value_name = "FOLDER")]
    pub(crate) page: Option<PathBuf>,
    /// Do not open a browser, only print the address
    #[arg(long)]
    pub(crate) no_open: bool,
}
