//! Tests of fragilities and frequencies; the kind of each is in its name.

mod fragility;
mod hazard;

use pounding_risk::{EventShare, Stripe, Stripes};
use serde_json::Value;

/// A case of fragility and annual frequency by another program, to sixteen digits.
fn case() -> Value {
    let text = include_str!("../reach/fragility-mle-and-annual-frequency.json");
    serde_json::from_str(text).expect("JSON")
}

/// A number that the case writes as text.
fn number(value: &Value) -> f64 {
    value.as_str().expect("a number as text").parse().expect("a number")
}

/// Stripes of which so many of `n` events exceed a state: those with the lowest numbers.
fn stripes(n: usize, all: &[(f64, usize)]) -> Stripes {
    let stripe = |(intensity, exceeding): &(f64, usize)| Stripe {
        intensity: *intensity,
        events: (0..n)
            .map(|event| EventShare {
                event,
                share: f64::from(u8::from(event < *exceeding)),
            })
            .collect(),
    };
    Stripes {
        all: all.iter().map(stripe).collect(),
        same_events: true,
    }
}

/// The stripes of the case.
fn of_case() -> Stripes {
    let inputs = &case()["inputs"];
    let list = |name: &str| inputs[name].as_array().expect("a list").clone();
    let both = list("im_g").into_iter().zip(list("touch"));
    let whole = |value: &Value| usize::try_from(value.as_u64().expect("a whole number")).expect("small");
    let all: Vec<(f64, usize)> = both.map(|(im, touch)| (im.as_f64().expect("a number"), whole(&touch))).collect();
    assert!(list("n").iter().all(|n| whole(n) == 40), "forty motions each");
    stripes(40, &all)
}
