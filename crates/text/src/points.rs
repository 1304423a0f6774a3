//! Curves as text: two numbers to a line.

use crate::Refused;

/// What the points of a curve must be, and how messages name them.
#[derive(Debug, Clone, Copy)]
pub struct CurveWords<'w> {
    /// The option or field that names the curve.
    pub place: &'w str,
    /// What a line holds, such as `a period in s and an acceleration in g, periods rising`.
    pub allowed: &'static str,
}

/// Reads the points of a curve: two numbers to a line, separated by commas, semicolons or blanks. A heading in the first line and lines that
/// begin with # are skipped. `fits` says whether a point may follow the last one; `None` if there is no last one.
///
/// # Errors
/// Refuses the first line that is not a point, or that does not fit.
pub fn curve_points(
    text: &str,
    words: CurveWords<'_>,
    fits: impl Fn(Option<[f64; 2]>, [f64; 2]) -> bool,
) -> Result<Vec<[f64; 2]>, Refused> {
    let mut points: Vec<[f64; 2]> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let fields: Vec<&str> = line.split([',', ';', ' ', '\t']).filter(|field| !field.is_empty()).collect();
        let numbers: Vec<f64> = fields.iter().filter_map(|field| field.parse().ok()).collect();
        let is_heading = index == 0 && numbers.is_empty();
        if fields.is_empty() || is_heading || line.starts_with('#') {
            continue;
        }
        match numbers[..] {
            [x, y] if fields.len() == 2 && x.is_finite() && y.is_finite() && fits(points.last().copied(), [x, y]) => points.push([x, y]),
            _ => {
                let found: String = line.chars().take(60).collect();
                let line = Refused::at(format!("{}: line {}", words.place, index + 1));
                return Err(match with_points(&found) {
                    Some(right) => line
                        .found(format!("\"{found}\" with decimal commas"))
                        .allowed_are(format!("decimal points: \"{right}\"")),
                    None => line.found(format!("\"{found}\"")).allowed_are(words.allowed),
                });
            }
        }
    }
    Ok(points)
}

/// Rewrites a line of two numbers with decimal commas, separated by a semicolon or blanks, with decimal points; `None` for any other line.
fn with_points(line: &str) -> Option<String> {
    let fields: Vec<&str> = line.split([';', ' ', '\t']).filter(|field| !field.is_empty()).collect();
    let numbers: Vec<String> = fields.iter().map(|one| one.replacen(',', ".", 1)).collect();
    let are_numbers = numbers.iter().all(|one| one.parse::<f64>().is_ok());
    (numbers.len() == 2 && are_numbers && line.contains(',')).then(|| numbers.join("; "))
}
