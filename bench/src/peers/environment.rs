//! The Python environment of the other programs, and its worker process.

use std::fs;
use std::io::{BufRead, BufReader, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::{Value, json};

use super::entrants::Entrant;
use super::scenes::{Answers, Measured};
use crate::measure::Outcome;

/// Installed packages. Newer versions change measurements, so that updates are deliberate.
const PACKAGES: [&str; 5] = [
    "numpy==2.4.6",
    "numba==0.68.1",
    "scipy==1.17.1",
    "scikit-sundae==1.2.0",
    "openseespy==3.7.1.2",
];

/// Source files of the environment.
const FILES: [(&str, &str); 8] = [
    ("worker.py", include_str!("worker.py")),
    ("exchange.py", include_str!("exchange.py")),
    ("loops.py", include_str!("loops.py")),
    ("c_loops.py", include_str!("c_loops.py")),
    ("loops.c", include_str!("loops.c")),
    ("scipy_ivp.py", include_str!("scipy_ivp.py")),
    ("cvode.py", include_str!("cvode.py")),
    ("opensees.py", include_str!("opensees.py")),
];

/// Creates the environment in a folder, or keeps an existing one, and writes the sources and the scenes.
pub(super) fn prepare(home: &Path, scenes: &Value) -> Outcome<()> {
    let write = |name: &str, text: &str| fs::write(home.join(name), text);
    fs::create_dir_all(home)?;
    let wanted = PACKAGES.join("\n");
    let installed = fs::read_to_string(home.join("installed.txt")).unwrap_or_default();
    if installed != wanted {
        let environment = home.join("env");
        println!("Python environment: {}", environment.display());
        let venv = &mut Command::new("python3");
        step(venv.args(["-m", "venv", "--clear"]).arg(&environment)).map_err(|said| no_python(&said))?;
        let pip = &mut Command::new(environment.join("bin/python"));
        let words = "-m pip install --quiet --disable-pip-version-check";
        step(pip.args(words.split(' ')).args(PACKAGES)).map_err(|said| no_network(&said))?;
        write("installed.txt", &wanted)?;
    }
    for (name, text) in FILES {
        write(name, text)?;
    }
    Ok(write("scenes.json", &scenes.to_string())?)
}

fn no_python(said: &str) -> String {
    format!("no Python environment ({said}); other programs need Python 3 with its module venv: install it, or leave `--peers` out")
}

fn no_network(said: &str) -> String {
    format!(
        "packages cannot be installed ({said}); the first run needs the Python package index and a Python for which it has {}: \
         connect, or leave `--peers` out",
        PACKAGES.join(", ")
    )
}

fn step(command: &mut Command) -> Result<(), String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let status = command.status();
    let status = status.map_err(|error| format!("{name}: {error}"))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{name}: {status}"))
    }
}

/// The process that answers requests, line by line.
pub(super) struct Worker {
    child: Child,
    requests: ChildStdin,
    answers: BufReader<ChildStdout>,
    present: Value,
}

impl Worker {
    /// Starts the process; imports and their compilation take some seconds.
    pub(super) fn start(home: &Path) -> Outcome<Self> {
        let log = fs::File::create(home.join("worker.log"))?;
        let mut child = Command::new(home.join("env/bin/python"))
            .arg("worker.py")
            .current_dir(home)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(log)
            .spawn()?;
        let requests = child.stdin.take().ok_or("no way to ask")?;
        let answers = BufReader::new(child.stdout.take().ok_or("no way to answer")?);
        let mut worker = Self {
            child,
            requests,
            answers,
            present: Value::Null,
        };
        worker.present = worker.read(home.join("worker.log").as_path())?;
        Ok(worker)
    }

    fn read(&mut self, log: &Path) -> Outcome<Value> {
        let mut line = String::new();
        self.answers.read_line(&mut line)?;
        let said = |_| format!("the Python process ended; {} says why", log.display());
        Ok(serde_json::from_str(&line).map_err(said)?)
    }

    /// The available programs, one per line.
    pub(super) fn present(&self) -> String {
        let programs = self.present.as_object().into_iter().flatten();
        let line = |(name, version): (&String, &Value)| {
            let is_raced = name != "octave" && name != "siconos";
            match version.as_str() {
                Some(version) if is_raced => format!("{name}: {version}"),
                Some(place) => {
                    format!("{name}: installed ({place}), but no entrant is written for it")
                }
                None => format!("{name}: not installed"),
            }
        };
        programs.map(line).collect::<Vec<_>>().join("\n")
    }

    /// Whether a tool is available.
    pub(super) fn has(&self, tool: &str) -> bool {
        self.present[tool].is_string()
    }

    /// Result of a program, or its error.
    pub(super) fn ask(&mut self, entrant: &Entrant, setting: f64, law: &str) -> Outcome<Measured> {
        let request = json!({
            "tool": entrant.tool,
            "method": entrant.method,
            "setting": setting,
            "law": law,
        });
        writeln!(self.requests, "{request}")?;
        let answer = self.read(Path::new("worker.log"))?;
        let seconds = answer["seconds"].as_f64();
        let Some(seconds) = seconds else {
            let (tool, method) = (entrant.tool, entrant.method);
            return Err(format!("{tool} {method}: {}", answer["failed"]).into());
        };
        let number = |value: &Value| value.as_str().and_then(|text| text.parse().ok());
        let scene = |line: &Value| -> Answers { [0, 1, 2].map(|index| number(&line[index]).unwrap_or(f64::NAN)) };
        let found = answer["found"].as_array().into_iter().flatten();
        Ok(Measured {
            seconds,
            found: found.map(scene).collect(),
        })
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // The process has nothing to save.
        let ended = self.child.kill().and_then(|()| self.child.wait());
        drop(ended);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn issue_what_is_missing_is_named_with_what_helps() {
        let said = step(&mut Command::new("no-such-python")).unwrap_err();
        assert!(said.starts_with("no-such-python: "), "{said}");
        let python = no_python(&said);
        assert!(python.contains("Python 3") && python.contains(&said), "{python}");
        let network = no_network("exit status: 1");
        assert!(network.contains("scipy==1.17.1"), "{network}");
    }
}
