//! The bundled font, and the size of text.

use std::sync::{Arc, OnceLock};

use plotters::style::{FontDesc, FontFamily, FontStyle, register_font};
use resvg::usvg::fontdb;

use super::{Align, Drawing, PlotError, Shape};

/// Millimetres in a point (1/72 inch).
pub(super) const MM_PER_POINT: f64 = 25.4 / 72.0;

/// Name of the bundled font in pictures.
pub(super) const FAMILY: &str = "DejaVu Sans";

/// Height of the capital letters of the font, as a part of its size.
pub(super) const CAPITAL: f64 = 0.729;

/// The bundled font; see `assets/README.md`.
const FONT: &[u8] = include_bytes!("../assets/DejaVuSans-subset.ttf");

/// Letters for one size unit of the font, as plotters counts it: ascent and descent together.
const EXTENT: f64 = (1901.0 + 483.0) / 2048.0;

/// Largest excess of a measured text over the edge; the white next to its letters counts \[mm\].
const SLACK: f64 = 0.2;

/// The characters of the bundled font, as first and last of each stretch.
const COVERED: [(char, char); 28] = [
    ('\u{20}', '\u{7E}'),
    ('\u{A0}', '\u{FF}'),
    ('\u{300}', '\u{305}'),
    ('\u{307}', '\u{308}'),
    ('\u{391}', '\u{3A1}'),
    ('\u{3A3}', '\u{3A9}'),
    ('\u{3B1}', '\u{3C9}'),
    ('\u{2010}', '\u{2015}'),
    ('\u{2018}', '\u{2019}'),
    ('\u{201C}', '\u{201D}'),
    ('\u{2022}', '\u{2022}'),
    ('\u{2026}', '\u{2026}'),
    ('\u{2032}', '\u{2033}'),
    ('\u{2070}', '\u{2070}'),
    ('\u{2074}', '\u{208E}'),
    ('\u{2190}', '\u{2195}'),
    ('\u{2202}', '\u{2202}'),
    ('\u{2206}', '\u{2206}'),
    ('\u{2211}', '\u{2211}'),
    ('\u{2212}', '\u{2212}'),
    ('\u{221A}', '\u{221A}'),
    ('\u{221E}', '\u{221E}'),
    ('\u{222B}', '\u{222B}'),
    ('\u{2248}', '\u{2248}'),
    ('\u{2260}', '\u{2260}'),
    ('\u{2264}', '\u{2264}'),
    ('\u{2265}', '\u{2265}'),
    ('\u{22C5}', '\u{22C5}'),
];

/// Returns the font for plotters at a size in units of its canvas.
pub(super) fn font(size: f64) -> FontDesc<'static> {
    static REGISTERED: OnceLock<bool> = OnceLock::new();
    let sound = *REGISTERED.get_or_init(|| register_font(FAMILY, FontStyle::Normal, FONT).is_ok());
    assert!(sound, "the bundled font is sound");
    FontDesc::new(FontFamily::Name(FAMILY), size, FontStyle::Normal)
}

/// Returns the font database of the renderer, with the bundled font alone.
pub(super) fn database() -> Arc<fontdb::Database> {
    static DATABASE: OnceLock<Arc<fontdb::Database>> = OnceLock::new();
    Arc::clone(DATABASE.get_or_init(|| {
        let mut database = fontdb::Database::new();
        database.load_font_data(FONT.to_vec());
        Arc::new(database)
    }))
}

/// Returns the width of a text of a size in points \[mm\].
pub(super) fn width(text: &str, points: f64) -> f64 {
    // Measured large, since plotters counts in whole units.
    const LARGE: f64 = 1000.0;
    let units = font(LARGE * EXTENT).layout_box(text).map_or(0, |(_, (right, _))| right);
    f64::from(units) / LARGE * points * MM_PER_POINT
}

/// Returns the height of the capital letters of a text of a size in points \[mm\].
pub(super) fn height(points: f64) -> f64 {
    CAPITAL * points * MM_PER_POINT
}

/// Breaks a text at a space into two lines if it is wider than the room \[mm\] and has a space.
pub(super) fn broken(text: &str, points: f64, room: f64) -> Vec<&str> {
    let middle = text.len() / 2;
    let space = text.match_indices(' ').map(|(at, _)| at).min_by_key(|at| at.abs_diff(middle));
    match space {
        Some(at) if width(text, points) > room => vec![&text[..at], &text[at + 1..]],
        _ => vec![text],
    }
}

/// Refuses texts that the font cannot write or that run off the paper.
pub(super) fn check(drawing: &Drawing) -> Result<(), PlotError> {
    for shape in &drawing.shapes {
        let Shape::Text {
            at,
            text,
            points,
            align,
            upright,
            ..
        } = shape
        else {
            continue;
        };
        if let Some(character) = text.chars().find(|&c| !covered(c)) {
            return Err(PlotError::Character {
                character,
                text: text.clone(),
            });
        }
        let (along, paper) = if *upright { (at.1, drawing.height) } else { (at.0, drawing.width) };
        let width = width(text, *points);
        let start = match align {
            Align::Start => along,
            Align::Middle => along - width / 2.0,
            Align::End => along - width,
        };
        if start < -SLACK || start + width > paper + SLACK {
            return Err(PlotError::LongText { text: text.clone() });
        }
    }
    Ok(())
}

/// Tells whether the font has a character.
pub(super) fn covered(character: char) -> bool {
    COVERED.iter().any(|&(first, last)| (first..=last).contains(&character))
}

#[cfg(test)]
mod tests {
    use super::super::{Align, page, raster};
    use super::*;

    fn picture(character: char) -> Vec<u8> {
        let text = Shape::text((5.0, 5.0), character, 10.0, Align::Middle);
        // Bypasses the check on purpose.
        let sheet = Drawing {
            width: 10.0,
            height: 10.0,
            shapes: vec![text],
        };
        raster::png(&page::unchecked(&sheet).unwrap()).unwrap()
    }

    #[test]
    fn reference_the_font_has_what_the_list_says() {
        let stranger = picture('\u{4E00}');
        let blank = picture(' ');
        for character in COVERED.iter().flat_map(|&(first, last)| first..=last) {
            let drawn = picture(character);
            assert_ne!(drawn, stranger, "{character:?} is not in the font");
            assert!(
                drawn != blank || character.is_whitespace() || character == '\u{AD}',
                "{character:?} is blank"
            );
        }
    }

    #[test]
    fn reference_width_is_what_the_renderer_draws() {
        for text in ["Pounding force (kN)", "−12.5", "ü, β̄ = 2.75×10⁹"] {
            let sheet = Drawing {
                width: 80.0,
                height: 10.0,
                shapes: vec![Shape::text((1.0, 5.0), text, 9.0, Align::Start)],
            };
            let options = resvg::usvg::Options {
                fontdb: database(),
                ..Default::default()
            };
            let svg = page::unchecked(&sheet).unwrap();
            let tree = resvg::usvg::Tree::from_str(&svg, &options).unwrap();
            let mut node = tree.root().children().last().unwrap();
            while let resvg::usvg::Node::Group(group) = node {
                node = group.children().last().unwrap();
            }
            let drawn = f64::from(node.abs_bounding_box().width()) / 96.0 * 25.4;
            let measured = width(text, 9.0);
            assert!((measured - drawn).abs() < 0.06 * measured, "{text}: {measured} against {drawn}");
        }
    }

    #[test]
    fn extreme_long_texts_are_refused() {
        let text = "Displacement relative to the ground";
        for align in [Align::Start, Align::Middle, Align::End] {
            let shapes = vec![Shape::text((5.0, 5.0), text, 10.0, align)];
            let refused = PlotError::LongText { text: text.to_owned() };
            assert_eq!(
                page::svg(&Drawing {
                    width: 10.0,
                    height: 10.0,
                    shapes
                }),
                Err(refused)
            );
        }
    }

    #[test]
    fn extreme_unknown_characters_are_refused() {
        let text = Shape::text((5.0, 5.0), "柱", 10.0, Align::Middle);
        let sheet = Drawing {
            width: 10.0,
            height: 10.0,
            shapes: vec![text],
        };
        let expected = PlotError::Character {
            character: '柱',
            text: "柱".to_owned(),
        };
        assert_eq!(page::svg(&sheet), Err(expected));
    }
}
