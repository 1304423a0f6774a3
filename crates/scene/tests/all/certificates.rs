//! Restitution of contact laws in free impacts: by the exact method, and by stepping methods at short steps.

use pounding_contact::{Calibration, LawName};
use pounding_scene::{Certificate, CertificateRequest, FreeCollision, StepMethod};

const COLLISION: FreeCollision = FreeCollision {
    masses: [75e3, 3e6],
    speed: 0.3,
};

fn wanted(law: LawName, restitution: f64, calibration: Calibration) -> CertificateRequest {
    let linear = law.stiffness_unit() == Some("N/m");
    CertificateRequest {
        law,
        stiffness: if linear { 9.35e7 } else { 2.75e9 },
        restitution,
        calibration,
    }
}

/// Laws with a damping.
fn damped() -> impl Iterator<Item = LawName> {
    LawName::ALL.into_iter().filter(|law| !law.is_elastic())
}

#[test]
fn reference_exact_calibration_delivers_what_is_asked() {
    for law in damped() {
        for restitution in [0.05, 0.2, 0.5, 0.65, 0.9, 0.999, 0.999_999, 1.0] {
            let wanted = wanted(law, restitution, Calibration::Exact);
            let certificate = Certificate::new(&wanted, &COLLISION).expect("a certificate");
            let name = law.name();
            let off = (certificate.by_exact - restitution).abs();
            assert!(off <= 1e-9, "{name}, asked {restitution}: off by {off:e}");
            let impulse = 75e3 * 3e6 / 3.075e6 * (1.0 + restitution) * 0.3;
            let off = (certificate.impulse / impulse - 1.0).abs();
            assert!(off <= 1e-9, "{name}, asked {restitution}: impulse off by {off:e}");
        }
    }
}

#[test]
fn reference_the_exact_method_delivers_what_the_relation_says() {
    for law in damped().filter(|law| law.named().formula.is_some()) {
        for restitution in [0.2, 0.65, 0.9] {
            let wanted = wanted(law, restitution, Calibration::Literature);
            let certificate = Certificate::new(&wanted, &COLLISION).expect("a certificate");
            let relation = certificate.by_relation.expect("a relation");
            let off = (certificate.by_exact - relation).abs();
            let name = law.name();
            assert!(off <= 1e-9, "{name}, asked {restitution}: off by {off:e}");
        }
    }
}

#[test]
fn order_every_stepping_method_delivers_it_at_short_steps() {
    for law in damped() {
        let impulsive = law == LawName::Stereomechanical;
        let wanted = wanted(law, 0.65, Calibration::Exact);
        let certificate = Certificate::new(&wanted, &COLLISION).expect("a certificate");
        for method in StepMethod::differing(impulsive) {
            let error = |step| {
                let delivered = certificate.by(&COLLISION, &method.at(step));
                delivered.expect("a run").error
            };
            let (coarse, fine) = (error(2e-3), error(2e-4));
            let halved = fine <= 0.5 * coarse || fine <= 1e-9;
            let what = format!("{}, {}", law.name(), method.name());
            assert!(halved, "{what}: {coarse:e} at 2 ms, {fine:e} at 0.2 ms");
        }
    }
}
