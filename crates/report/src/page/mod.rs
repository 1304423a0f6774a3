//! `report.html`: one file that a person forwards; it needs no network, and can be printed.

pub(crate) mod answer;
pub(crate) mod markup;

use std::fmt::Write as _;

use markup::{digits, escaped, list, short};
use pounding_scene::{Source, Structure};

use super::Report;
use super::figures::Illustration;
use super::summary::Summary;

/// Title of the warnings.
pub(crate) const BEFORE: &str = "Before the numbers are believed";

/// Title of the unusual values of a scene and its records.
pub(crate) const UNUSUAL: &str = "Unusual: check this first";

/// A few words as a sentence.
pub(crate) fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).chain(['.']).collect()
}

/// The style sheet of pages.
pub const STYLE: &str = include_str!("style.css");

/// The page.
pub(super) fn html(report: &Report<'_>, illustrations: &[Illustration], animation: &str) -> String {
    let summary = report.summary();
    let mut numbered = Numbered::of(illustrations);
    let figure = |name: &str| {
        if name == "animation" {
            animation.to_owned()
        } else {
            numbered.figure(name)
        }
    };
    let body = [
        format!("<h1>{}</h1>\n<p>{}</p>\n", escaped(&summary.scene.name), escaped(&lead(&summary))),
        answer::html(&report.answer(), figure),
        again(&summary),
    ];
    document(&summary.scene.name, "", &body.concat())
}

/// Figures, which are numbered as they are read.
pub(crate) struct Numbered<'a> {
    all: &'a [Illustration],
    shown: usize,
}

impl<'a> Numbered<'a> {
    pub(crate) fn of(all: &'a [Illustration]) -> Self {
        Self { all, shown: 0 }
    }

    /// The figure of a name with its caption; empty if there is none.
    pub(crate) fn figure(&mut self, name: &str) -> String {
        let found = self.all.iter().find(|one| one.name == name);
        found.map_or_else(String::new, |one| {
            self.shown += 1;
            illustrated(self.shown, one)
        })
    }
}

/// A complete page, from its title and markup; on paper the title and who signed it stand below every sheet.
pub(crate) fn document(title: &str, signed: &str, body: &str) -> String {
    let below = match signed {
        "" => title.into(),
        signed => format!("{title} \u{b7} {signed}"),
    };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{} – pounding</title>\n\
         <style>\n{STYLE}@page {{ @bottom-left {{ content: \"{}\"; }} }}\n</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
        escaped(title),
        quoted(&below)
    )
}

/// Text between quotation marks of a style sheet, in which nothing can be taken for markup.
fn quoted(text: &str) -> String {
    let mut quoted = String::new();
    for letter in text.chars() {
        if letter.is_alphanumeric() || " .,:;()-+–·".contains(letter) {
            quoted.push(letter);
        } else {
            let _ = write!(quoted, "\\{:x} ", u32::from(letter));
        }
    }
    quoted
}

/// A picture with sentences: beside it on paper, and below it on screens.
pub(crate) fn beside(parts: &[String]) -> String {
    format!("<div class=\"beside\">\n{}</div>\n", parts.concat())
}

/// Warnings under a heading; empty if there are none.
pub(crate) fn boxed(heading: &str, items: &[String]) -> String {
    if items.is_empty() {
        return String::new();
    }
    format!(
        "<div class=\"warnings\">\n<p><strong>{heading}</strong></p>\n{}</div>\n",
        list(items)
    )
}

/// What was computed, in a sentence.
fn lead(summary: &Summary) -> String {
    let scene = &summary.scene;
    let is_wall = |structure: &&Structure| matches!(structure, Structure::Wall);
    let walls = scene.structures.iter().filter(is_wall).count();
    let structures = match scene.structures.len() - walls {
        1 => "One structure".into(),
        n => format!("{n} structures"),
    };
    let walls = match walls {
        0 => "",
        1 => " and a wall",
        _ => " and walls",
    };
    let steps = summary
        .method
        .time_step_s
        .map_or_else(String::new, |step| format!(" in steps of {} s", digits(step)));
    let source = match &scene.record.source {
        // The folders stand in the table.
        Source::File(file) => file.file.rsplit(['/', '\\']).next().unwrap_or_default(),
        Source::Generated(_) => "a generated motion",
    };
    let processed = match &summary.record.processing[..] {
        [] => "",
        [_] if scene.record.reversed => ", reversed,",
        _ => ", processed as told below,",
    };
    format!(
        "{structures}{walls} in a row, shaken by {source}{processed} with a peak ground acceleration of {} g for {} s, computed by pounding \
         {} with the method “{}”{steps}.",
        short(summary.record.peak_m_per_s2.abs() / scene.record.gravity_m_per_s2),
        digits(summary.method.duration_s),
        summary.version,
        summary.method.name.replace('_', " ")
    )
}

/// A figure with its caption, or why there is none.
fn illustrated(number: usize, one: &Illustration) -> String {
    match &one.drawn {
        Ok((svg, _)) => format!(
            "<figure>\n{}\n<figcaption><strong>Figure {number}.</strong> {}</figcaption>\n</figure>\n",
            inline(svg, &one.caption),
            escaped(&one.caption)
        ),
        Err(reason) => format!(
            "<p class=\"soft\">Figure {number} ({}) could not be drawn: {}</p>\n",
            one.name,
            escaped(&reason.to_string())
        ),
    }
}

/// An SVG as part of a page: without its declarations, as wide as the page, with its caption for those who cannot see it.
fn inline(svg: &str, caption: &str) -> String {
    let start = svg.find("<svg").unwrap_or(0);
    let (head, body) = svg[start..].split_once('>').unwrap_or_default();
    let attribute = |name: &str| {
        let (_, rest) = head.split_once(&format!(" {name}=\""))?;
        rest.split_once('"').map(|(value, _)| value)
    };
    let (width, height) = (attribute("width"), attribute("height"));
    let size = width
        .zip(height)
        .map_or_else(String::new, |(width, height)| format!(" viewBox=\"0 0 {width} {height}\""));
    format!("<svg{size} role=\"img\" aria-label=\"{}\">{}", escaped(caption), body.trim_end())
}

/// How to make the report again.
fn again(summary: &Summary) -> String {
    let scene = serde_json::to_string_pretty(&summary.scene).unwrap_or_default();
    let record = match (&summary.record.file, &summary.record.sha256) {
        (Some(file), Some(hash)) => format!(
            " The record is <code>{}</code>, looked for from the folder of the scene’s file; the SHA-256 of what was read is \
             <code>{}</code>.",
            escaped(file),
            escaped(hash)
        ),
        _ => String::new(),
    };
    format!(
        "<h2>How to repeat it</h2>\n<p>Save the scene below as <code>scene.json</code> and run, with pounding {},</p>\n\
         <pre>pounding run scene.json --out results</pre>\n<p>The same version gives the same numbers, to the last bit; pictures were \
         found to be the same, byte for byte, on Linux x86-64.{record} Beside this page the folder holds \
         <code>history.csv</code> and <code>impacts.csv</code>, which <code>pandas.read_csv</code> reads as they are, and \
         <code>summary.json</code>.</p>\n<pre class=\"scene\">{}</pre>\n",
        escaped(&summary.version),
        escaped(&scene)
    )
}
