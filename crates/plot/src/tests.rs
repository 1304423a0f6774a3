//! Whole figures.

mod axes;

use super::*;

fn wave(n: u32) -> Vec<(f64, f64)> {
    (0..n).map(|k| f64::from(k) / f64::from(n)).map(|x| (x, x * (1.0 - x))).collect()
}

fn figure(curves: Vec<Curve>) -> Figure {
    let panel = Panel {
        y: Axis::auto("Displacement (cm)"),
        curves,
        ..Panel::default()
    };
    Figure {
        x: Axis::auto("Time (s)"),
        panels: vec![panel],
        ..Figure::default()
    }
}

fn of(points: Vec<(f64, f64)>) -> Figure {
    figure(vec![Curve::new(CurveKind::Line, Shade::Blue, points).named("left")])
}

/// Draws a figure as text.
fn drawn(figure: &Figure) -> Result<String, PlotError> {
    page::svg(&*figure.drawing()?)
}

/// Reads a big-endian number of a PNG.
fn number(png: &[u8], at: usize) -> u32 {
    u32::from_be_bytes([png[at], png[at + 1], png[at + 2], png[at + 3]])
}

#[test]
fn reference_png_has_size_and_resolution() {
    let png = render_png(&of(wave(50))).unwrap();
    assert_eq!((number(&png, 16), number(&png, 20)), (2100, 1260));
    assert_eq!((png[24], png[25]), (8, 2), "eight bits, red, green and blue");
    let density = png.windows(4).position(|chunk| chunk == b"pHYs").unwrap();
    assert_eq!((number(&png, density + 4), number(&png, density + 8)), (11811, 11811));
}

#[test]
fn limit_two_renders_are_equal_in_all_threads() {
    let figure = of(wave(500));
    let first = render_png(&figure).unwrap();
    let threads: Vec<_> = (0..4)
        .map(|_| {
            std::thread::spawn({
                let figure = figure.clone();
                move || render_png(&figure)
            })
        })
        .collect();
    for thread in threads {
        assert_eq!(thread.join().unwrap().unwrap(), first);
    }
}

#[test]
fn limit_an_unseen_curve_changes_nothing() {
    let panel = |curves| Panel {
        x: Some(Axis::over("t", 0.0, 1.0)),
        y: Axis::over("u", 0.0, 1.0),
        curves,
        ..Panel::default()
    };
    let outside = [
        CurveKind::Line,
        CurveKind::Thin,
        CurveKind::Dashed,
        CurveKind::Stems,
        CurveKind::Points,
        CurveKind::Bars,
    ]
    .map(|kind| Curve::new(kind, Shade::Blue, vec![(2.0, 5.0), (3.0, 1e300)]).marked(Mark::Ring));
    let base = vec![Curve::new(CurveKind::Stems, Shade::Ink, vec![])];
    let one = Figure {
        panels: vec![panel(base.clone())],
        ..Figure::default()
    };
    let two = Figure {
        panels: vec![panel([base, outside.to_vec()].concat())],
        ..Figure::default()
    };
    assert_eq!(drawn(&one), drawn(&two));
}

#[test]
fn limit_curves_without_extent_are_drawn() {
    for kind in [
        CurveKind::Line,
        CurveKind::Thin,
        CurveKind::Dashed,
        CurveKind::Stems,
        CurveKind::Area,
        CurveKind::Points,
        CurveKind::Bars,
    ] {
        for points in [vec![], vec![(1.0, 2.0)], vec![(0.0, 3.0), (1.0, 3.0)], vec![(0.0, 0.0), (1.0, 0.0)]] {
            let figure = figure(vec![Curve::new(kind, Shade::Green, points.clone()).named("left")]);
            assert!(drawn(&figure).is_ok(), "{kind:?} {points:?}");
        }
    }
}

#[test]
fn extreme_numbers_that_are_not_finite_are_refused() {
    for bad in [(f64::NAN, 0.0), (0.0, f64::INFINITY), (f64::NEG_INFINITY, 0.0)] {
        let refused = drawn(&of(vec![(0.0, 0.0), bad]));
        assert_eq!(
            refused,
            Err(PlotError::CurvePoint {
                panel: 0,
                curve: 0,
                point: 1
            })
        );
    }
    let mut marked = of(wave(5));
    marked.panels[0].markers.push(f64::NAN);
    assert_eq!(drawn(&marked), Err(PlotError::Mark { panel: 0 }));
}

#[test]
fn extreme_figures_are_refused() {
    assert_eq!(drawn(&Figure::default()), Err(PlotError::NoPanel));
    let small = Figure {
        height_in: 0.5,
        ..of(wave(5))
    };
    assert!(matches!(drawn(&small), Err(PlotError::Size { .. })));
    let mut weightless = of(wave(5));
    weightless.panels[0].weight = 0.0;
    assert_eq!(drawn(&weightless), Err(PlotError::Weight { panel: 0, weight: 0.0 }));
    assert!(matches!(
        drawn(&of(vec![(0.0, -1e308), (1.0, 1e308)])),
        Err(PlotError::Range { .. })
    ));
}

#[test]
fn extreme_spread_of_magnitudes_is_drawn() {
    let figure = of(vec![(0.0, 1e-12), (1e-9, 1e12), (1e6, -1e12)]);
    assert!(drawn(&figure).is_ok());
}
