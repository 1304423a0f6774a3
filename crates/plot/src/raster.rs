//! From SVG to PNG.

use std::fmt::Debug;

use png::{BitDepth, ColorType, Compression, Encoder, Filter, PixelDimensions, Unit};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, WriteOptions};

use super::{PlotError, text};

/// Resolution of the pictures \[dots per inch\].
const DOTS_PER_INCH: f32 = 300.0;

/// Resolution in dots per metre, the unit of PNG.
const DOTS_PER_METRE: u32 = 11811;

/// Units of length in an inch of an SVG.
const SVG_PER_INCH: f32 = 96.0;

/// Returns the picture as a PNG.
pub(super) fn png(svg: &str) -> Result<Vec<u8>, PlotError> {
    let tree = tree(svg)?;
    let scale = DOTS_PER_INCH / SVG_PER_INCH;
    let (width, height) = (dots(tree.size().width() * scale), dots(tree.size().height() * scale));
    let mut pixels = Pixmap::new(width, height).ok_or(PlotError::Renderer { stage: "pixels" })?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    // The paper is white and opaque: every fourth byte, the alpha, is 255.
    let pixels = pixels.data().chunks_exact(4);
    let colours: Vec<u8> = pixels.flat_map(|pixel| [pixel[0], pixel[1], pixel[2]].map(level)).collect();
    // The picture decides which filter packs better.
    let plain = encode(width, height, &colours, Filter::NoFilter)?;
    let differences = encode(width, height, &colours, Filter::Up)?;
    Ok(if plain.len() <= differences.len() { plain } else { differences })
}

/// Returns the picture as an SVG that needs no font.
pub(super) fn outlined(svg: &str) -> Result<String, PlotError> {
    let options = WriteOptions {
        // Units are hundredths of a millimetre: whole numbers except in letters.
        coordinates_precision: 1,
        ..WriteOptions::default()
    };
    Ok(tree(svg)?.to_string(&options))
}

/// Rounds a colour to sixteen levels, 0, 17, …, 255. They suffice for smooth edges and reduce the file by a fifth.
fn level(value: u8) -> u8 {
    (value / 17 + u8::from(value % 17 > 8)) * 17
}

/// Reads an SVG, with only the bundled font.
fn tree(svg: &str) -> Result<Tree, PlotError> {
    let options = Options {
        fontdb: text::database(),
        ..Options::default()
    };
    Tree::from_str(svg, &options).map_err(refused("SVG"))
}

/// Rounds to whole dots.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "`page` bounds the size of paper"
)]
fn dots(length: f32) -> u32 {
    length.round() as u32
}

/// Writes eight bits per colour, as small as the encoder can.
fn encode(width: u32, height: u32, colours: &[u8], filter: Filter) -> Result<Vec<u8>, PlotError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_filter(filter);
    let density = PixelDimensions {
        xppu: DOTS_PER_METRE,
        yppu: DOTS_PER_METRE,
        unit: Unit::Meter,
    };
    encoder.set_pixel_dims(Some(density));
    let mut writer = encoder.write_header().map_err(refused("PNG"))?;
    writer.write_image_data(colours).map_err(refused("PNG"))?;
    writer.finish().map_err(refused("PNG"))?;
    Ok(bytes)
}

/// Names the step of rendering that failed.
fn refused<E: Debug>(stage: &'static str) -> impl FnOnce(E) -> PlotError {
    move |_| PlotError::Renderer { stage }
}

#[cfg(test)]
mod tests {
    use super::super::Shade;
    use super::*;

    #[test]
    fn limit_shades_and_ends_keep_their_colour() {
        assert_eq!([0, 8, 9, 247, 255].map(level), [0, 0, 17, 255, 255]);
        for shade in [
            Shade::Ink,
            Shade::Blue,
            Shade::Vermilion,
            Shade::Green,
            Shade::Amber,
            Shade::Grey,
            Shade::Rose,
            Shade::Mist,
        ] {
            let (red, green, blue) = shade.rgb();
            assert_eq!([red, green, blue].map(level), [red, green, blue]);
        }
    }
}
