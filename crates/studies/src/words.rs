//! Numbers as people read them, with as many digits as help.

/// A number with four significant digits.
pub fn short(value: f64) -> String {
    // A negative zero loses its sign.
    let scientific = format!("{:.3e}", value + 0.0);
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse().ok());
    match exponent {
        _ if value == 0.0 => "0".into(),
        Some(exponent @ -4..=5_i32) => {
            let decimals = usize::try_from(3 - exponent).unwrap_or(0);
            format!("{value:.decimals$}")
        }
        _ => scientific,
    }
}

/// A relative error in per cent, with two significant digits.
pub fn percent(error: f64) -> String {
    let value = 100.0 * error;
    if value == 0.0 {
        return "0 %".into();
    }
    if value < 1e-9 {
        // The exact run is no better than about this.
        return "<1e-9 %".into();
    }
    if !value.is_finite() {
        return "∞".into();
    }
    let scientific = format!("{value:.1e}");
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse().ok());
    match exponent {
        Some(exponent @ -2..=3_i32) => {
            let decimals = usize::try_from(1 - exponent).unwrap_or(0);
            format!("{value:.decimals$} %")
        }
        _ => format!("{scientific} %"),
    }
}

/// An error of a time, in milliseconds with two significant digits.
pub fn milliseconds(seconds: f64) -> String {
    percent(10.0 * seconds).replace('%', "ms")
}
