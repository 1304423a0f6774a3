//! Line styles of methods in figures.

use pounding_plot::{CurveKind, Mark, Shade};
use pounding_scene::ComparedMethod;

/// The line style of a method, by its name in tables. `None` if the method's curve would hide behind another method's.
pub(crate) fn line_of(key: &str) -> Option<(Shade, CurveKind, Mark)> {
    Some(match key {
        // Elastic structures with impacts give it and velocity Verlet equal numbers: dashes and rings leave the line below visible.
        ComparedMethod::RIVAL => (Shade::Blue, CurveKind::Dashed, Mark::Ring),
        "central_difference_10_contact_substeps" => (Shade::Amber, CurveKind::Line, Mark::Diamond),
        "velocity_verlet" => (Shade::Green, CurveKind::Line, Mark::Diamond),
        "velocity_verlet_located" => (Shade::Green, CurveKind::Dashed, Mark::HollowDiamond),
        "newmark_average_acceleration" => (Shade::Vermilion, CurveKind::Line, Mark::Square),
        "moreau_jean" => (Shade::Grey, CurveKind::Line, Mark::Cross),
        "rk4" => (Shade::Rose, CurveKind::Line, Mark::Inverted),
        ComparedMethod::REFERENCE => (Shade::Ink, CurveKind::Line, Mark::Triangle),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use pounding_scene::ComparedMethod;

    use super::*;

    #[test]
    fn limit_lines_of_methods_can_be_told_apart() {
        let lines: Vec<_> = ComparedMethod::ALL.iter().filter_map(|one| line_of(one.key)).collect();
        assert!(lines.len() > 5, "most methods have one");
        for (n, (shade, kind, _)) in lines.iter().enumerate() {
            for other in &lines[..n] {
                assert_ne!((*shade, *kind), (other.0, other.1));
            }
        }
    }
}
