//! Tests of the commands in the documents: they run and print what the page shows.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::folder;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// A block of a page: its kind, the name of its file if it has one, and its lines.
struct Block<'a> {
    kind: &'a str,
    file: Option<&'a str>,
    body: Vec<&'a str>,
}

/// The blocks of a page between fences. A preceding line that names a file in backticks and ends with a colon gives the file.
fn blocks(page: &str) -> Vec<Block<'_>> {
    let mut blocks = Vec::new();
    let mut open: Option<Block<'_>> = None;
    let mut named = None;
    for line in page.lines() {
        match (line.strip_prefix("```"), open.take()) {
            (Some(kind), None) => {
                open = Some(Block {
                    kind,
                    file: named.take(),
                    body: Vec::new(),
                });
            }
            (Some(_), Some(block)) => blocks.push(block),
            (None, Some(mut block)) => {
                block.body.push(line);
                open = Some(block);
            }
            (None, None) if line.ends_with(':') => named = line.split('`').nth(1),
            (None, None) if line.is_empty() => (),
            (None, None) => named = None,
        }
    }
    blocks
}

/// A command of a block with the output lines that the page shows.
struct Shown<'a> {
    command: String,
    output: Vec<&'a str>,
}

fn commands<'a>(block: &Block<'a>) -> Vec<Shown<'a>> {
    let mut all: Vec<Shown<'a>> = Vec::new();
    for line in &block.body {
        match (line.strip_prefix("$ "), all.last_mut()) {
            (Some(command), _) => all.push(Shown {
                command: command.into(),
                output: Vec::new(),
            }),
            (None, Some(last)) if last.command.ends_with('\\') => {
                last.command.pop();
                last.command.push_str(line);
            }
            (None, Some(last)) => last.output.push(line),
            (None, None) => (),
        }
    }
    all
}

/// Every file below a folder for which `wanted` is true.
fn files(folder: &Path, wanted: fn(&Path) -> bool) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let below = entries.flat_map(|entry| {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files(&path, wanted)
        } else {
            vec![path].into_iter().filter(|path| wanted(path)).collect()
        }
    });
    below.collect()
}

fn copy(from: &Path, to: &Path) {
    for file in files(from, |_| true) {
        let inside = file.strip_prefix(from).expect("it is below");
        let target = to.join(inside);
        fs::create_dir_all(target.parent().expect("a folder")).expect("it can be made");
        fs::copy(&file, target).expect("it can be copied");
    }
}

/// The folder in which the commands of a page run. It has the files of a clone that pages name, a user's record, and a folder of records.
fn workplace(name: &str) -> PathBuf {
    let (root, work) = (Path::new(ROOT), folder(&format!("documents-{name}")));
    for shared in ["studies", "crates/motion/tests/files"] {
        copy(&root.join(shared), &work.join(shared));
    }
    copy(&root.join("studies/records"), &work.join("folder"));
    // The format of a file follows from its content, not from its name.
    let record = root.join("crates/motion/tests/files/usgs.smc");
    fs::copy(record, work.join("quake.AT2")).expect("it can be copied");
    work
}

/// The faults of a page, and the number of its commands that ran.
fn faults(page: &Path) -> (Vec<String>, usize) {
    let inside = page.strip_prefix(ROOT).expect("a page of the project");
    let name = inside.display().to_string().replace(['/', '.'], "-");
    let text = fs::read_to_string(page).expect("a page is text");
    let work = workplace(&name);
    let program = Path::new(assert_cmd::cargo::cargo_bin!("pounding"));
    let own = program.parent().expect("a folder").to_path_buf();
    let path = env::var_os("PATH").unwrap_or_default();
    let path = env::join_paths(std::iter::once(own).chain(env::split_paths(&path)));
    let path = path.expect("folders");
    let (mut faults, mut ran) = (Vec::new(), 0);
    for block in blocks(&text) {
        if let Some(file) = block.file.filter(|_| block.kind == "toml" || block.kind == "json") {
            let target = work.join(file);
            fs::create_dir_all(target.parent().expect("a folder")).expect("it can be made");
            fs::write(target, block.body.join("\n") + "\n").expect("it can be written");
        }
        for Shown { command, output } in commands(&block) {
            // These commands build, leave the workplace, or depend on the speed of the machine.
            let elsewhere = ["cargo ", "git ", "cd ", "pip ", "timeout "];
            if block.kind != "console" || elsewhere.iter().any(|one| command.starts_with(one)) {
                continue;
            }
            ran += 1;
            let mut shell = Command::new("sh");
            let shell = shell.args(["-c", &command]).current_dir(&work);
            let ended = shell.env("PATH", &path).output().expect("a shell");
            let printed = [ended.stdout, ended.stderr].concat();
            let printed = String::from_utf8(printed).expect("UTF-8");
            let refused = output.iter().any(|line| line.starts_with("error: "));
            if ended.status.success() == refused {
                faults.push(format!("{name}: {command}: {}\n{printed}", ended.status));
            }
            // A page shows some of the printed lines, in their order.
            let mut lines = printed.lines().map(str::trim_end);
            let wanted = output.iter().map(|line| line.trim_end());
            let missing = wanted
                .filter(|line| !line.is_empty())
                .find(|line| !lines.any(|printed| printed == *line));
            if let Some(line) = missing {
                faults.push(format!("{name}: {command}: does not print, or not there:\n{line}"));
            }
        }
    }
    (faults, ran)
}

#[cfg(unix)]
#[test]
fn limit_every_command_of_the_documents_prints_what_they_say() {
    use rayon::prelude::*;

    let root = Path::new(ROOT);
    let is_page = |path: &Path| path.extension().is_some_and(|ending| ending == "md");
    let mut pages = files(&root.join("docs"), is_page);
    pages.extend(files(&root.join("studies/examples"), is_page));
    pages.extend(["README.md", "CONTRIBUTING.md"].map(|page| root.join(page)));
    assert!(pages.len() > 15, "{pages:?}");
    let (faults, ran): (Vec<_>, Vec<_>) = pages.par_iter().map(|page| faults(page)).unzip();
    let (faults, ran) = (faults.concat(), ran.iter().sum::<usize>());
    assert!(
        faults.is_empty(),
        "{}",
        faults.join(
            "
"
        )
    );
    assert!(ran > 50, "{ran} commands");
}
