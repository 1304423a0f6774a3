//! `pounding view`: a page in a browser on which the numbers of a scene are turned and the row is seen to move.

mod guides;
mod knobs;
mod latest;
mod server;
mod shown;

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use pounding::report::{Report, STYLE, other_direction};
use pounding::scene::{Error, sha256};
use pounding::text::{Refused, json_text};
use serde::Deserialize;
use serde_json::json;

use crate::new_file;
use guides::Guide;
use knobs::Turned;
use latest::{Latest, Work};
use server::{Asked, RECORD, RECORD_CALL, Reply, Server};
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
    // Detached: Ctrl-C here must not end a browser that this opens.
    if !args.no_open && open::that_detached(&address).is_err() {
        crate::say("no browser was found: open the address above");
    }
    server.serve(move |asked| view.answer(asked));
    Ok(String::new())
}

/// What the page shows: the user's scene, and the guides.
#[derive(Debug)]
struct View {
    own: Arc<Base>,
    /// The file of the scene; `None` for that of `demo`, and for standard input.
    file: Option<PathBuf>,
    guides: Vec<(&'static Guide, Arc<Base>)>,
    /// Scenes under records that were dropped on the page, with the keys that it names them by; the last ones.
    dropped: Mutex<Vec<(String, Arc<Base>)>>,
}

/// Most dropped records that are kept.
const DROPPED: usize = 4;

/// What the page sends with every call.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Call {
    /// A number that the page drew at random: the latest run of a window wins.
    window: u64,
    /// Key of a guide; empty for the user's scene.
    guide: String,
    knobs: Turned,
    /// Key of a dropped record, or the name of a file that is dropped; the record of the scene by default.
    #[serde(default)]
    record: Option<String>,
}

impl View {
    fn of(path: Option<&Path>) -> Result<Self, Refused> {
        let (demo, record) = super::demo::files();
        let own = match path {
            Some(path) => {
                let base = super::read(path).and_then(|scene| Base::read(scene, super::folder(path)));
                base.and_then(Base::checked).map_err(|error| error.in_file(path))?
            }
            None => Base::own(demo, record.as_bytes())?,
        };
        let guides = guides::ALL
            .iter()
            .map(|guide| Ok((guide, Arc::new(Base::own(guide.scene, record.as_bytes())?))));
        Ok(Self {
            own: Arc::new(own),
            dropped: Mutex::default(),
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
            Asked::Call(path, body) => {
                // A record stands behind the first line.
                let end = body.iter().position(|byte| *byte == b'\n').unwrap_or(body.len());
                match serde_json::from_slice(&body[..end]) {
                    Ok(call) => self.call(&path, &call, body.get(end + 1..).unwrap_or_default()),
                    Err(error) => Reply::refused(400, format!("no call: {error}")),
                }
            }
        }
    }

    fn call(&self, path: &str, call: &Call, record: &[u8]) -> Reply {
        let guide = self.guides.iter().find(|(guide, _)| guide.key == call.guide);
        let (guide, base) = match guide {
            Some((guide, base)) => (Some(*guide), base),
            None if call.guide.is_empty() => (None, &self.own),
            None => return Reply::refused(404, "no such guide"),
        };
        let known = |key| self.dropped().iter().find(|(known, _)| known == key).cloned();
        let told = match &call.record {
            None => self.told(path, base, guide, call),
            Some(name) if path == RECORD_CALL => self.drop_record(base, name, record),
            Some(key) => match known(key) {
                Some((_, base)) => self.told(path, &base, guide, call),
                None => return Reply::refused(410, "the dropped record is no longer kept: drop it again, or press Reset"),
            },
        };
        told.unwrap_or_else(|error| Reply::refused(422, error.to_string()))
    }

    fn told(&self, path: &str, base: &Base, guide: Option<&Guide>, call: &Call) -> Result<Reply, Error> {
        Ok(match path {
            "/api/guides" => self.guides(),
            "/api/run" => latest(call, Work::Run, |stop| {
                let shown = base.shown(&call.knobs, stop)?;
                let fact = guide.and_then(|guide| shown.fact(guide));
                // Without a tree in between, which takes as long as a run.
                let text = serde_json::to_vec(&(fact, shown));
                Ok(text.map_or_else(|error| Reply::refused(500, error.to_string()), |text| Reply::of(JSON, text)))
            })?,
            "/api/report" => latest(call, Work::Report, |stop| {
                let prepared = base.prepared(&base.turned(&call.knobs)?, Some(stop))?;
                let report = Report::of(&prepared, true)?.with_other_direction(other_direction(&prepared));
                Ok(Reply::of(HTML, report.files().remove("report.html").unwrap_or_default()))
            })?,
            "/api/stop" => {
                drop([Work::Run, Work::Report].map(|work| Latest::begin((call.window, work))));
                Reply::of(TEXT, "")
            }
            "/api/python" => Reply::of(TEXT, python(&base.turned(&call.knobs)?)),
            "/api/save" if guide.is_none() => self.save(base, call)?,
            _ => Reply::refused(404, "no such call"),
        })
    }

    /// Keeps a scene under a record of the page, and tells its key.
    fn drop_record(&self, base: &Base, name: &str, record: &[u8]) -> Result<Reply, Error> {
        let base = Arc::new(base.under(name, record)?);
        let mut key = sha256(&[base.name().as_bytes(), name.as_bytes(), record].join(&b'\n'));
        key.truncate(16);
        let mut dropped = self.dropped();
        dropped.retain(|(known, _)| *known != key);
        dropped.insert(0, (key.clone(), base));
        dropped.truncate(DROPPED);
        Ok(Reply::of(TEXT, key))
    }

    fn dropped(&self) -> MutexGuard<'_, Vec<(String, Arc<Base>)>> {
        self.dropped.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn guides(&self) -> Reply {
        let guides: Vec<_> = self.guides.iter().map(|(guide, _)| guide.json()).collect();
        let name = self.file.as_ref().map(|path| pounding::files::shown_name(path));
        Reply::of(JSON, json!({"file": name, "guides": guides, "record_bytes": RECORD}).to_string())
    }

    /// Writes the turned scene to a new file beside the scene.
    fn save(&self, base: &Base, call: &Call) -> Result<Reply, Refused> {
        let Some(file) = &self.file else {
            return Err(Refused::that("this scene is in no file: start `pounding view` with one"));
        };
        if call.record.is_some() {
            return Err(Refused::that("a dropped record is in no folder: name its file in the scene first"));
        }
        let scene = base.turned(&call.knobs)?;
        base.prepared(&scene, None)?;
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
        Err(Refused::at(file.as_path()).is("has 999 turned scenes beside it, the most"))
    }
}

/// Does what a window asks for unless it asks for the same again.
fn latest(call: &Call, work: Work, made: impl FnOnce(&'static AtomicBool) -> Result<Reply, Error>) -> Result<Reply, Error> {
    let Some(latest) = Latest::begin((call.window, work)) else {
        return Ok(Reply::refused(503, "too many runs at once"));
    };
    let made = made(latest.stop());
    if latest.is_stopped() {
        return Ok(Reply::refused(409, "a later run has begun"));
    }
    made
}
