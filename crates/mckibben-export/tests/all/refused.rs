//! Models that cannot be exported: each is refused with its numbers and what to do.

use mckibben_core::{
    model::{ForceModel, Ideal, ModelError, ModelInfo, Response, Workspace},
    muscle::Muscle,
};
use mckibben_export::{BoxRequest, ExportError, ExportedMuscle};

/// The ideal muscle with its answers changed.
struct Changed(Ideal, fn(&mut Response));

impl ForceModel for Changed {
    fn info(&self) -> &ModelInfo {
        self.0.info()
    }

    fn response(&self, w: &mut Workspace, p: f64, e: f64) -> Result<Response, ModelError> {
        let mut response = self.0.response(w, p, e)?;
        self.1(&mut response);
        Ok(response)
    }
}

/// Why the changed muscle is refused.
fn refused(change: fn(&mut Response), wanted: BoxRequest) -> ExportError {
    let model = Changed(Ideal::between_ends(&Muscle::prototype()), change);
    ExportedMuscle::fit(&model, "changed", wanted).unwrap_err()
}

const WANTED: BoxRequest = BoxRequest {
    supply_mpa: 0.25,
    contraction_low: 0.0,
    contraction_high: None,
};

#[test]
fn a_pull_that_the_form_misses() {
    let error = refused(
        |r| r.force_n *= 1.0 + 0.2 * (80.0 * r.contraction).sin(),
        WANTED,
    );
    assert!(matches!(error, ExportError::Misses(_)), "{error}");
    assert!(
        error.to_string().contains("choose a smaller box"),
        "{error}"
    );
}

#[test]
fn a_muscle_that_does_not_pull() {
    let error = refused(|r| r.force_n = -r.force_n.abs(), WANTED);
    let at_supply = matches!(error, ExportError::NoPull(supply_mpa) if supply_mpa == 0.25);
    assert!(
        at_supply || matches!(error, ExportError::Analysis(_)),
        "{error}"
    );
}

#[test]
fn a_model_without_a_volume() {
    let error = refused(|r| r.volume_mm3 = None, WANTED);
    assert!(matches!(error, ExportError::NoVolume { .. }), "{error}");
    assert!(
        error.to_string().contains("`fe` and thick-wall do"),
        "{error}"
    );
}

#[test]
fn a_box_that_is_none() {
    for (contraction_low, contraction_high) in [
        (0.1, None),
        (-0.3, None),
        (0.0, Some(-0.1)),
        (0.0, Some(0.6)),
    ] {
        let error = refused(
            |_| (),
            BoxRequest {
                contraction_low,
                contraction_high,
                ..WANTED
            },
        );
        assert!(matches!(error, ExportError::Box { .. }), "{error}");
        assert!(
            error
                .to_string()
                .contains("the lower end lies at or below zero"),
            "{error}"
        );
    }
}
