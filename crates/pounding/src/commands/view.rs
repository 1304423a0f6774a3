//! `pounding view`: a page in a browser on which the numbers of a scene are turned and the row is seen to move.

mod guides;
mod knobs;
mod latest;
mod server;
mod shown;

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use pounding::report::{Report, STYLE, other_direction};
use pounding::scene::Error;
use pounding::text::{Refused, json_text};
use serde::Deserialize;
use serde_json::json;

use crate::new_file;
use guides::Guide;
use knobs::Turned;
use latest::Latest;
use server::{Asked, Reply, Server};
use shown::{Base, python};

const EXAMPLES: &str = "\
Examples:
  pounding view
  pounding view studies/examples/towers-of-storeys.toml
  pounding view scene.toml --no-open

Without a scene the page shows that of `pounding demo`. Ctrl-C ends it.

The page comes from this machine alone, under an address with a token that only
this run knows. It reads the scene and its record once, and writes nothing
unless `Save scene` is pressed: then a new file beside the scene.";

/// The arguments of `view`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file; by default that of `demo`.
    #[arg(value_name = "SCENE")]
    scene: Option<PathBuf>,
    /// Print the address and open no browser.
    #[arg(long)]
    no_open: bool,
}

/// The files of the page: path, type and content.
const FILES: [(&str, &str, &str); 9] = [
    ("/", HTML, include_str!("../../assets/view/index.html")),
    ("/report.css", CSS, STYLE),
    ("/view.css", CSS, include_str!("../../assets/view/view.css")),
    ("/main.js", SCRIPT, include_str!("../../assets/view/main.js")),
    ("/api.js", SCRIPT, include_str!("../../assets/view/api.js")),
    ("/draw.js", SCRIPT, include_str!("../../assets/view/draw.js")),
    ("/row.js", SCRIPT, include_str!("../../assets/view/row.js")),
    ("/charts.js", SCRIPT, include_str!("../../assets/view/charts.js")),
    ("/knobs.js", SCRIPT, include_str!("../../assets/view/knobs.js")),
];
const HTML: &str = "text/html; charset=utf-8";
const CSS: &str = "text/css; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";
const JSON: &str = "application/json";
const TEXT: &str = "text/plain; charset=utf-8";

/// Serves the page until the process is ended.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let view = View::of(args.scene.as_deref())?;
    let server = Server::open().map_err(|error| Refused::that(format!("no port of this machine can be opened: {error}")))?;
    let address = server.address();
    crate::print(&format!("{address}\n"))?;
    crate::say("Ctrl-C ends it");
    if !args.no_open {
        open(&address);
    }
    server.serve(move |asked| view.answer(asked));
    Ok(String::new())
}

/// Opens a browser if the system has one.
fn open(address: &str) {
    let (program, arguments): (&str, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        ("rundll32", &["url.dll,FileProtocolHandler"])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(arguments).arg(address);
    let quiet = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    if quiet.spawn().is_err() {
        crate::say("no browser was found: open the address above");
    }
}

/// What the page shows: the user's scene, and the guides.
#[derive(Debug)]
struct View {
    own: Base,
    /// The file of the scene; `None` for that of `demo`, and for standard input.
    file: Option<PathBuf>,
    guides: Vec<(&'static Guide, Base)>,
}

/// What the page sends with every call.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Call {
    /// A number that the page drew at random: the latest run of a window wins.
    window: u64,
    /// Key of a guide; empty for the user's scene.
    guide: String,
    knobs: Turned,
}

impl View {
    fn of(path: Option<&Path>) -> Result<Self, Refused> {
        let (demo, record) = super::demo::files();
        let own = match path {
            Some(path) => {
                let base = super::read(path).and_then(|scene| Base::read(scene, super::folder(path)));
                let checked = base.and_then(|base| {
                    base.prepared(&base.turned(&Turned::new())?, None)?;
                    Ok(base)
                });
                checked.map_err(|error| error.in_file(path))?
            }
            None => Base::own(demo, record.as_bytes())?,
        };
        let guides = guides::ALL
            .iter()
            .map(|guide| Ok((guide, Base::own(guide.scene, record.as_bytes())?)));
        Ok(Self {
            own,
            file: path.filter(|path| *path != Path::new("-")).map(Path::to_path_buf),
            guides: guides.collect::<Result<_, Error>>()?,
        })
    }

    fn answer(&self, asked: Asked) -> Reply {
        match asked {
            Asked::File(path) => {
                let file = FILES.iter().find(|(known, ..)| *known == path);
                file.map_or_else(|| Reply::refused(404, "no such file"), |(_, kind, text)| Reply::of(kind, *text))
            }
            Asked::Call(path, body) => match serde_json::from_slice(&body) {
                Ok(call) => self.call(&path, &call),
                Err(error) => Reply::refused(400, format!("no call: {error}")),
            },
        }
    }

    fn call(&self, path: &str, call: &Call) -> Reply {
        let guide = self.guides.iter().find(|(guide, _)| guide.key == call.guide);
        let base = match guide {
            Some((_, base)) => base,
            None if call.guide.is_empty() => &self.own,
            None => return Reply::refused(404, "no such guide"),
        };
        let told = match path {
            "/api/guides" => Ok(self.guides()),
            "/api/run" => return run_latest(base, guide.map(|(guide, _)| *guide), call),
            "/api/stop" => {
                drop(Latest::begin(call.window));
                Ok(Reply::of(TEXT, ""))
            }
            "/api/report" => report(base, &call.knobs),
            "/api/python" => base.turned(&call.knobs).map(|scene| Reply::of(TEXT, python(&scene))),
            "/api/save" if guide.is_none() => self.save(&call.knobs),
            _ => return Reply::refused(404, "no such call"),
        };
        told.unwrap_or_else(|refused| Reply::refused(422, refused.to_string()))
    }

    fn guides(&self) -> Reply {
        let guides: Vec<_> = self.guides.iter().map(|(guide, _)| guide.json()).collect();
        let name = self.file.as_ref().map(|path| pounding::files::shown_name(path));
        Reply::of(JSON, json!({"scene": self.own.name(), "file": name, "guides": guides}).to_string())
    }

    /// Writes the turned scene to a new file beside the scene.
    fn save(&self, knobs: &Turned) -> Result<Reply, Refused> {
        let Some(file) = &self.file else {
            return Err(Refused::that("this scene is in no file: start `pounding view` with one"));
        };
        let scene = self.own.turned(knobs)?;
        self.own.prepared(&scene, None)?;
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let names = (1..1000).map(|n| file.with_file_name(format!("{stem}-turned-{n}.json")));
        for path in names {
            let written = pounding::files::write(&path, json_text(&scene).as_bytes(), new_file::existing(false));
            match written {
                Ok(()) => return Ok(Reply::of(TEXT, pounding::files::shown_name(&path))),
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(Refused::at(path.as_path()).is(format!("cannot be written: {error}"))),
            }
        }
        Err(Refused::at(file.as_path())
            .is("has 999 turned scenes beside it")
            .allowed_is("fewer"))
    }
}

/// Runs a turned scene unless a later run of its window comes.
fn run_latest(base: &Base, guide: Option<&Guide>, call: &Call) -> Reply {
    let Some(latest) = Latest::begin(call.window) else {
        return Reply::refused(503, "too many runs at once");
    };
    match base.shown(&call.knobs, latest.stop()) {
        _ if latest.is_stopped() => Reply::refused(409, "a later run has begun"),
        Ok(shown) => {
            let fact = guide.and_then(|guide| shown.fact(guide));
            // Without a tree in between, which takes as long as a run.
            serde_json::to_vec(&(fact, shown)).map_or_else(|error| Reply::refused(500, error.to_string()), |text| Reply::of(JSON, text))
        }
        Err(error) => Reply::refused(422, error.to_string()),
    }
}

/// The page of a report, to be saved by the browser.
fn report(base: &Base, knobs: &Turned) -> Result<Reply, Refused> {
    let prepared = base.prepared(&base.turned(knobs)?, None)?;
    let report = Report::of(&prepared, true)?.with_other_direction(other_direction(&prepared));
    let page = report.files().remove("report.html").unwrap_or_default();
    Ok(Reply::of(HTML, page))
}
