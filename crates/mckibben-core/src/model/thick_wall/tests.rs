//! The thick wall against verification G, its limits, and its own derivatives.

use super::*;
use crate::{
    model::{ForceModel, ModelError, Workspace},
    muscle::{Braid, BraidStiffness, Crimp, Rubber, Terminals, Tube, measures::PRESTRETCH},
    rubber::{MooneyRivlin, RubberLaw},
};
use std::f64::consts::PI;

fn muscle(stiffness: BraidStiffness) -> Muscle {
    let law = Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.10,
        c01_mpa: 0.02,
    });
    let tube = Tube::new(19.0, 1.5, 200.0, Rubber::new(law));
    let braid = Braid {
        angle_deg: 25.0,
        stiffness,
        ..Braid::paper()
    };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

/// Verification G: A = 8, B = 9.5, α = 25°, p = 0.3 (kinematics of Liu & Rahn 2003 \[liu2003\]).
#[test]
fn verification_g_rigid_strands() {
    let model = ThickWall::between_ends(&muscle(BraidStiffness::Inextensible));
    let rows = [
        (1.00, 697.295254, 8.0, 9.5),
        (0.95, 535.363511, 10.15312534, 11.43317686),
        (0.90, 415.638252, 11.82975661, 13.00422270),
        (0.80, 214.347501, 14.38249226, 15.48123327),
        (0.75, 124.603748, 15.38944717, 16.48742200),
    ];
    for (l, force, a, b) in rows {
        let response = model.response(&mut Workspace::new(), 0.3, 1.0 - l).unwrap();
        assert!(
            (response.force_n - force).abs() < 1e-6,
            "λ {l}: {}",
            response.force_n
        );
        let r = 0.5 * response.bulged_diameter_mm.unwrap();
        assert!((r - b).abs() < 1e-8, "λ {l}: b {r}");
        assert!((model.wall.bore2(l, r).sqrt() - a).abs() < 1e-8, "λ {l}: a");
    }
    assert!(
        model
            .force_n(&mut Workspace::new(), 0.3, 1.0 - 0.67479861)
            .unwrap()
            .abs()
            < 1e-5
    );
}

#[test]
fn strands_that_stretch_tend_to_rigid_ones_like_1_over_k() {
    let rigid = ThickWall::between_ends(&muscle(BraidStiffness::Inextensible));
    for e in [0.0, 0.1, 0.2] {
        let exact = rigid.response(&mut Workspace::new(), 0.3, e).unwrap();
        let mut before = f64::NAN;
        for k in [1e4, 1e5, 1e6, 1e7] {
            let soft = ThickWall::between_ends(&muscle(BraidStiffness::NewtonPerMm(k)))
                .response(&mut Workspace::new(), 0.3, e)
                .unwrap();
            let error = exact.force_n - soft.force_n;
            // error = c/k + O(1/k²): the ratio of neighbours is 10 up to O(1/k).
            let ratio = before / error / 10.0;
            assert!(
                before.is_nan() || (ratio - 1.0).abs() < 2e3 / k,
                "ε {e}, k {k}: {ratio}"
            );
            before = error;
            let tension = soft.braid_tension_n.unwrap() / exact.braid_tension_n.unwrap();
            assert!((tension - 1.0).abs() < 1e2 / k, "ε {e}, k {k}: {tension}");
        }
    }
}

#[test]
fn derivatives_are_those_of_finite_differences_and_maxwell_holds() {
    let rigid = muscle(BraidStiffness::Inextensible);
    let soft = muscle(BraidStiffness::NewtonPerMm(200.0));
    let crimp = Some(Crimp {
        strain: 0.01,
        stiffness_ratio: 0.1,
    });
    let lain = |m: &Muscle, crimp| {
        let braid = Braid {
            thickness_mm: 0.8,
            diameter_mm: Some(20.0),
            crimp,
            ..m.braid().clone()
        };
        m.with_braid(braid).unwrap()
    };
    for m in [lain(&rigid, None), lain(&soft, crimp), rigid, soft] {
        let model = ThickWall::between_ends(&m);
        let p = 0.3;
        let e = 0.12;
        let h = 1e-5;
        let at = |p: f64, e: f64| model.response(&mut Workspace::new(), p, e).unwrap();
        let r = at(p, e);
        let length = m.length_mm();
        let stiffness = -(at(p, e + h).force_n - at(p, e - h).force_n) / (2.0 * h * length);
        assert!((stiffness - r.stiffness_n_per_mm.unwrap()).abs() < 1e-7 * stiffness.abs());
        let f_p = (at(p + h, e).force_n - at(p - h, e).force_n) / (2.0 * h);
        assert!((f_p - r.force_per_pressure_mm2.unwrap()).abs() < 1e-7 * f_p.abs());
        // Maxwell: ∂F/∂P at fixed L = −∂V/∂L at fixed P.
        let v_l = -(at(p, e + h).volume_mm3.unwrap() - at(p, e - h).volume_mm3.unwrap())
            / (2.0 * h * length);
        assert!((f_p + v_l).abs() < 1e-7 * f_p.abs(), "{f_p} {v_l}");
    }
}

/// Axial balance of a cut through the muscle: F + Pπa² = strands + rubber, here with the rubber
/// made negligible.
#[test]
fn without_rubber_the_strands_carry_all() {
    let mut tube = muscle(BraidStiffness::Inextensible).tube().clone();
    tube.rubber.law = tube.rubber.law.scaled(1e-9);
    tube.wall_mm = 1e-3;
    let m = muscle(BraidStiffness::NewtonPerMm(300.0))
        .with_tube(tube)
        .unwrap();
    let response = ThickWall::between_ends(&m)
        .response(&mut Workspace::new(), 0.3, 0.1)
        .unwrap();
    let d = response.bulged_diameter_mm.unwrap();
    let stretch = 1.0
        + response.braid_tension_n.unwrap()
            / (2.0 * PI * 19.0 * m.braid().angle_rad().cos() * 300.0);
    let cos_now = 0.9 * m.braid().angle_rad().cos() / stretch;
    let axial = response.braid_tension_n.unwrap() * cos_now - 0.3 * PI * d * d / 4.0;
    assert!(
        (axial / response.force_n - 1.0).abs() < 1e-3,
        "{axial} {}",
        response.force_n
    );
}

#[test]
fn soft_strands_and_high_pressure_end_in_a_typed_error() {
    let model = ThickWall::between_ends(&muscle(BraidStiffness::NewtonPerMm(1.0)));
    assert!(
        matches!(
            model.force_n(&mut Workspace::new(), 1.0, 0.0),
            Err(ModelError::Overstretched { .. })
        ),
        "{:?}",
        model.force_n(&mut Workspace::new(), 1.0, 0.0)
    );
    assert!(matches!(
        model.force_n(&mut Workspace::new(), 0.1, 1.0),
        Err(ModelError::Geometry { .. })
    ));
    assert!(matches!(
        model.force_n(&mut Workspace::new(), 0.1, f64::NAN),
        Err(ModelError::Geometry { .. })
    ));
}

#[test]
fn without_pressure_a_shortened_tube_leaves_the_braid_and_pushes() {
    for stiffness in [
        BraidStiffness::Inextensible,
        BraidStiffness::NewtonPerMm(200.0),
    ] {
        let model = ThickWall::between_ends(&muscle(stiffness));
        let response = model.response(&mut Workspace::new(), 0.0, 0.1).unwrap();
        // Uniaxial compression of the rubber alone: nominal stress × section.
        let law = MooneyRivlin {
            c10_mpa: 0.10,
            c01_mpa: 0.02,
        };
        let expected = law.uniaxial_stress_mpa(0.9) * PI * (9.5f64.powi(2) - 8.0f64.powi(2));
        assert!(
            (response.force_n - expected).abs() < 1e-9,
            "{} {expected}",
            response.force_n
        );
        assert_eq!(response.braid_tension_n, Some(0.0));
    }
}

/// Work of the pressure on rigid strands whose midline lies t/2 off the tube, F = π P r (2 rb cot²θ
/// − r); by hand for a tube of 14 mm at 20° with 0.3 mm: (2·7.15·7.5486 − 7)/(2·7·7.5486 − 7) =
/// 1.02295 of the blocked force.
#[test]
fn without_rubber_a_thick_braid_pulls_as_the_work_of_the_pressure_says() {
    let bare = |thickness_mm: f64| {
        let law = Law::MooneyRivlin(MooneyRivlin {
            c10_mpa: 1e-12,
            c01_mpa: 0.0,
        });
        let tube = Tube::new(14.0, 1.0, 200.0, Rubber::new(law));
        let braid = Braid {
            angle_deg: 20.0,
            stiffness: BraidStiffness::Inextensible,
            thickness_mm,
            ..Braid::paper()
        };
        ThickWall::between_ends(&Muscle::new(tube, braid, Terminals::default(), None).unwrap())
    };
    for (t, e) in [(0.3, 0.0), (0.3, 0.2), (1.2, 0.1)] {
        let cos = (1.0 - e) * 20f64.to_radians().cos();
        let cot2 = cos * cos / (1.0 - cos * cos);
        let rb = (7.0 + 0.5 * t) * (1.0 - cos * cos).sqrt() / 20f64.to_radians().sin();
        let r = rb - 0.5 * t;
        let exact = PI * 0.4 * r * (2.0 * rb * cot2 - r);
        let pull = bare(t).force_n(&mut Workspace::new(), 0.4, e).unwrap();
        assert!(
            (pull / exact - 1.0).abs() < 1e-9,
            "t {t}, ε {e}: {pull} {exact}"
        );
    }
    let blocked = |t: f64| bare(t).force_n(&mut Workspace::new(), 0.4, 0.0).unwrap();
    assert!((blocked(0.3) / blocked(0.0) - 1.02295).abs() < 1e-5);
}

#[test]
fn a_sleeve_of_the_tubes_own_diameter_and_no_thickness_leave_every_digit() {
    for stiffness in [
        BraidStiffness::Inextensible,
        BraidStiffness::NewtonPerMm(200.0),
    ] {
        let m = muscle(stiffness);
        let same = Braid {
            diameter_mm: Some(19.0),
            thickness_mm: 0.0,
            ..m.braid().clone()
        };
        let other = ThickWall::between_ends(&m.with_braid(same).unwrap());
        let model = ThickWall::between_ends(&m);
        for (p, e) in [(0.1, 0.0), (0.3, 0.12), (0.0, 0.1)] {
            let response = |model: &ThickWall| model.response(&mut Workspace::new(), p, e).unwrap();
            assert_eq!(response(&model), response(&other));
        }
    }
}

fn prestretched(wall_mm: f64, mu_mpa: f64, stiffness: BraidStiffness, prestretch: f64) -> Muscle {
    let rubber = Rubber::new(Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.5 * mu_mpa,
        c01_mpa: 0.0,
    }));
    let braid = Braid {
        angle_deg: 25.0,
        stiffness,
        ..Braid::paper()
    };
    let tube = Tube::new(19.0, wall_mm, 200.0, rubber);
    Muscle::new(tube, braid, Terminals::default(), None)
        .unwrap()
        .with(&PRESTRETCH, prestretch)
        .unwrap()
}

/// By hand for a thin tube of neo-Hookean rubber under strands that do not stretch, ρ = r/Ro = √((1
/// − λ² cos²θ0)/sin²θ0): natural stretches are λp λ along and ρ/√λp around, so that w = ½μ (λp²
/// λ² + ρ²/λp + 1/(λp λ² ρ²) − 3) per volume, and with ρρ' = −λ cot²θ0
///
///   F = π Ro² P (3 λ² cos²θ0 − 1)/sin²θ0 + 2π Ro s μ (λp² λ + ρρ'/λp − (ρρ'/ρ⁴λ² + 1/ρ²λ³)/λp).
#[test]
fn a_thin_tube_with_a_prestretch_is_the_membrane() {
    let wall = 1e-5;
    let ro = 9.5f64;
    let p = 0.3;
    let mu = 0.4 / wall;
    let sin2 = 25f64.to_radians().sin().powi(2);
    let cos2 = 25f64.to_radians().cos().powi(2);
    for stretch in [0.8, 1.0, 1.25] {
        let model = ThickWall::between_ends(&prestretched(
            wall,
            mu,
            BraidStiffness::Inextensible,
            stretch,
        ));
        for l in [1.0, 0.95, 0.85] {
            let rho2 = (1.0 - l * l * cos2) / sin2;
            let slope = -l * cos2 / sin2;
            let squeezed = slope / (rho2 * rho2 * l * l) + 1.0 / (rho2 * l * l * l);
            let rubber = stretch * stretch * l + (slope - squeezed) / stretch;
            let ideal = PI * ro * ro * p * (3.0 * l * l * cos2 - 1.0) / sin2;
            let exact = ideal + 2.0 * PI * ro * wall * mu * rubber;
            let force = model.force_n(&mut Workspace::new(), p, 1.0 - l).unwrap();
            assert!(
                (force - exact).abs() < 1e-5 * exact.abs().max(100.0),
                "λp {stretch}, λ {l}: {force} {exact}"
            );
        }
    }
}

/// A tension test: without pressure at rest length σ = μ (λp² − 1/λp) over π (Ro² − Ri²), whatever
/// the wall and the strands.
#[test]
fn without_pressure_it_pulls_as_in_a_tension_test() {
    for (wall, stiffness, on_plugs) in [
        (1.5, BraidStiffness::NewtonPerMm(300.0), 40.0),
        (4.0, BraidStiffness::Inextensible, 28.0),
    ] {
        for stretch in [0.9, 1.1, 1.4] {
            let m = prestretched(wall, 0.4, stiffness, stretch);
            let force = ThickWall::between_ends(&m)
                .force_n(&mut Workspace::new(), 0.0, 0.0)
                .unwrap();
            let section = PI * (9.5f64.powi(2) - (9.5 - wall).powi(2));
            let exact = 0.4 * (stretch * stretch - 1.0 / stretch) * section;
            // 200 mm of it were 200/λp mm before, and 1.25 bores on each plug: 20 and 13.75 mm,
            // rounded.
            let cut_mm = 200.0 / stretch + on_plugs;
            assert!((m.build_sheet().tube_cut_mm - cut_mm).abs() < 1e-12);
            assert!(
                (force / exact - 1.0).abs() < 1e-9,
                "{wall} {stretch}: {force} {exact}"
            );
        }
    }
}

/// F dL − P dV is what the energy of wall and braid changes by (virtual work), and slopes are those
/// of differences, for laws in closed form and by integration.
#[test]
fn with_a_prestretch_the_pull_is_the_slope_of_the_energy() {
    let yeoh = Law::Yeoh(crate::rubber::Yeoh {
        c10_mpa: 0.1,
        c20_mpa: 0.01,
        c30_mpa: 0.0,
    });
    for law in [
        Law::MooneyRivlin(MooneyRivlin {
            c10_mpa: 0.10,
            c01_mpa: 0.02,
        }),
        yeoh,
    ] {
        let m = prestretched(1.5, 0.4, BraidStiffness::NewtonPerMm(300.0), 1.2);
        let m = m
            .with_tube(Tube {
                rubber: Rubber::new(law),
                ..m.tube().clone()
            })
            .unwrap();
        let model = ThickWall::between_ends(&m);
        let p = 0.3;
        let l = 0.9;
        let h = 1e-5;
        let above = model.state(p, l + h).unwrap();
        let below = model.state(p, l - h).unwrap();
        let here = model.state(p, l).unwrap();
        let volume = |s: &State, l: f64| PI * s.r * s.r * l;
        let work =
            (above.energy - below.energy) - p * (volume(&above, l + h) - volume(&below, l - h));
        assert!(
            (work / (2.0 * h) / here.force - 1.0).abs() < 1e-8,
            "{}",
            here.force
        );
        assert!(((above.force - below.force) / (2.0 * h) / here.force_l - 1.0).abs() < 1e-7);
        let more = model.state(p + h, l).unwrap();
        let less = model.state(p - h, l).unwrap();
        assert!(((more.force - less.force) / (2.0 * h) / here.force_p - 1.0).abs() < 1e-7);
        let square = model.sheet(l, here.r * here.r);
        assert!(
            (square.w / here.energy - 1.0).abs() < 1e-12
                && (square.l / here.axial - 1.0).abs() < 1e-12
        );
    }
}
