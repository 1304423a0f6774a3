//! Figures with logarithmic axes, names, and shared axes.

use super::super::*;
use super::{drawn, figure, of, wave};

/// Draws curves on axes that run over decades or over their exponents.
fn exponents(log: bool) -> Drawing {
    let value = |exponent: i32| {
        if log {
            format!("1e{exponent}").parse().unwrap()
        } else {
            f64::from(exponent)
        }
    };
    let axis = |from, to| {
        let axis = Axis::over("", value(from), value(to));
        if log { axis.log() } else { axis }
    };
    let points = (2..=8).map(|n| (value(n), value(1 - 2 * n))).collect();
    let panel = Panel {
        y: axis(-12, 0),
        curves: vec![Curve::new(CurveKind::Dashed, Shade::Vermilion, points).marked(Mark::HollowSquare)],
        ..Panel::default()
    };
    let figure = Figure {
        x: axis(2, 9),
        panels: vec![panel],
        ..Figure::default()
    };
    figure.drawing().unwrap().into_owned()
}

#[test]
fn limit_decades_stand_where_their_exponents_do() {
    let (decades, linear) = (exponents(true), exponents(false));
    let frame = |drawing: &Drawing| {
        // The axes are a single line through three corners.
        let corners = drawing.shapes.iter().find_map(|shape| {
            if let Shape::Line { points, .. } = shape {
                (points.len() == 3).then(|| points.clone())
            } else {
                None
            }
        });
        corners.unwrap()
    };
    let marks = |drawing: &Drawing| {
        let ((left, top), (right, bottom)) = (frame(drawing)[0], frame(drawing)[2]);
        let corners = drawing.shapes.iter().filter_map(|shape| {
            if let Shape::Polygon { corners, .. } = shape {
                Some(corners.clone())
            } else {
                None
            }
        });
        corners
            .map(|c| (f64::midpoint(c[0].0, c[1].0), f64::midpoint(c[0].1, c[2].1)))
            .map(|(x, y)| ((x - left) / (right - left), (y - bottom) / (top - bottom)))
            .collect::<Vec<_>>()
    };
    let (found, expected) = (marks(&decades), marks(&linear));
    assert_eq!((found.len(), expected.len()), (5, 5), "those from 1e-3 to 1e-11");
    for (a, b) in found.iter().zip(&expected) {
        assert!((a.0 - b.0).abs() < 1e-12 && (a.1 - b.1).abs() < 1e-12, "{a:?} {b:?}");
    }
}

#[test]
fn extreme_values_without_a_logarithm_are_refused() {
    for bad in [0.0, -1.0] {
        let mut refused = of(vec![(1.0, 1.0), (2.0, bad)]);
        refused.panels[0].y = Axis::auto("Error").log();
        let expected = PlotError::CurvePoint {
            panel: 0,
            curve: 0,
            point: 1,
        };
        assert_eq!(drawn(&refused), Err(expected));
        let mut marked = of(vec![(1.0, 1.0), (2.0, 2.0)]);
        marked.x = Axis::auto("Work").log();
        marked.panels[0].markers.push(bad);
        assert_eq!(drawn(&marked), Err(PlotError::Mark { panel: 0 }));
    }
}

/// Returns the texts of a figure with their places.
fn texts(figure: &Figure) -> Vec<(String, PaperPoint)> {
    let shapes = figure.drawing().unwrap().into_owned().shapes;
    let text = |shape| {
        if let Shape::Text { text, at, .. } = shape {
            Some((text, at))
        } else {
            None
        }
    };
    shapes.into_iter().filter_map(text).collect()
}

#[test]
fn limit_a_shared_legend_explains_a_label_once() {
    let panel = |labels: &[&str]| Panel {
        y: Axis::over("Error", 0.0, 1.0),
        curves: labels
            .iter()
            .map(|label| Curve::new(CurveKind::Line, Shade::Blue, wave(5)).named(*label))
            .collect(),
        legend: Legend::Shared,
        ..Panel::default()
    };
    let figure = Figure {
        columns: 2,
        panels: vec![panel(&["one", "two"]), panel(&["two", "three"])],
        ..Figure::default()
    };
    let texts = texts(&figure);
    let places: Vec<PaperPoint> = ["one", "two", "three"]
        .map(|label| {
            let mut found = texts.iter().filter(|(text, _)| text == label);
            let place = found.next().unwrap().1;
            assert!(found.next().is_none(), "{label} is explained once");
            place
        })
        .to_vec();
    assert!(places[0].0 < places[1].0 && places[1].0 < places[2].0);
}

#[test]
fn limit_an_axis_equal_to_that_at_its_left_is_numbered_once() {
    let numbers = |second: Axis| {
        let panel = |y| Panel { y, ..Panel::default() };
        let figure = Figure {
            columns: 2,
            panels: vec![panel(Axis::over("Error", 1e-6, 1.0).log()), panel(second)],
            ..Figure::default()
        };
        let texts = texts(&figure);
        texts.iter().filter(|(text, _)| text == "10⁻⁴").count()
    };
    assert_eq!(numbers(Axis::over("", 1e-6, 1.0).log()), 1);
    assert_eq!(numbers(Axis::over("Residual", 1e-6, 1.0).log()), 2);
    assert_eq!(numbers(Axis::over("", 1e-7, 1.0).log()), 2);
}

/// Returns a strip of rows with a bar each.
fn strip(n: u32) -> Figure {
    let bars: Vec<_> = (0..n).map(|row| (0.0, 1.0, f64::from(row))).collect();
    let mut figure = figure(vec![Curve::bars(Shade::Silver, &bars)]);
    figure.panels[0].y = Axis::names((0..n).map(|row| format!("row {row}")).collect());
    figure
}

#[test]
fn reference_bars_stand_beside_their_names() {
    let figure = strip(3);
    let bars = figure.drawing().unwrap().into_owned().shapes;
    let middles: Vec<f64> = bars
        .iter()
        .filter_map(|shape| {
            if let Shape::Rectangle { corner, size, .. } = shape {
                Some(corner.1 + size.1 / 2.0)
            } else {
                None
            }
        })
        .collect();
    let named = texts(&figure);
    let names = named.iter().filter(|(text, _)| text.starts_with("row"));
    let heights: Vec<f64> = names.map(|(_, at)| at.1).collect();
    assert_eq!(middles.len(), 3);
    for (middle, height) in middles.iter().zip(&heights) {
        assert!((middle - height).abs() < 1e-9, "{middles:?} {heights:?}");
    }
    assert!(heights[0] > heights[1] && heights[1] > heights[2], "from the top");
}

#[test]
fn extreme_names_without_room_are_refused() {
    assert!(drawn(&strip(20)).is_ok());
    assert!(matches!(drawn(&strip(60)), Err(PlotError::Size { .. })));
    let mut long = strip(3);
    long.panels[0].y = Axis::names(vec!["a name that leaves no room for the panel ".repeat(3)]);
    assert!(matches!(drawn(&long), Err(PlotError::Size { .. })));
}

#[test]
fn extreme_texts_that_run_into_a_neighbour_are_refused() {
    let two = |title: &str, label: &str| {
        let mut panel = of(wave(5)).panels.remove(0);
        panel.title = title.into();
        Figure {
            columns: 2,
            x: Axis::auto(label),
            panels: vec![panel.clone(), panel],
            ..Figure::default()
        }
    };
    let long = "Relative error of the peak displacement in every scene and step";
    let refused = Err(PlotError::LongText { text: long.into() });
    assert!(drawn(&two("Error", "Work")).is_ok());
    assert_eq!(drawn(&two(long, "Work")), refused);
    assert_eq!(drawn(&two("Error", long)), refused);
}
