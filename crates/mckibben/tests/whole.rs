//! A muscle in Rust is the whole muscle, as every other front end has it.
#![cfg(all(feature = "design", feature = "fem", feature = "fit"))]

use mckibben::{ForceModel, WarningKind, Workspace, prelude::*};
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_fit::library::file;

/// The hose of the library, which gives way at its ends: 407.3 N on the command line.
#[test]
fn the_ends_of_a_muscle_are_part_of_it() {
    let hose: Muscle = file("dmsp-10-hose").unwrap().parse().unwrap();
    let whole = Model::FE.of(&hose).unwrap().force_n(0.592, 0.0).unwrap();
    assert!((whole - 407.29777642855).abs() < 1e-6, "{whole}");
    let between = Axisymmetric::between_ends(&hose).unwrap();
    let between = between.force_n(&mut Workspace::new(), 0.592, 0.0).unwrap();
    assert!(between > 1.5 * whole, "{between}");
}

#[test]
fn a_point_is_the_same_alone_in_a_list_and_in_an_answer() {
    let muscle = Muscle::prototype();
    let points = [(0.05, 0.0), (0.25, 0.1), (0.25, 0.3), (0.1, 0.2)];
    for model in [Model::FE, Model::UNIVERSAL] {
        let m = model.of(&muscle).unwrap();
        for (pull, (p, e)) in m.forces_n(&points).into_iter().zip(points) {
            let pull = pull.unwrap();
            assert_eq!(m.clone().force_n(p, e).unwrap(), pull, "{p} {e}");
            let answered = m
                .clone()
                .at(Pressure(p), Contraction(e))
                .unwrap()
                .response
                .force_n;
            assert!((answered - pull).abs() <= 1e-9 * pull.max(1.0), "{p} {e}");
        }
    }
}

#[test]
fn a_muscle_is_written_and_read_as_text() {
    let muscle = Muscle::prototype().with_length(200.0).unwrap();
    assert_eq!(muscle.to_string().parse::<Muscle>().unwrap(), muscle);
    let typo = "[tube]\nouter_diametr = 30".parse::<Muscle>().unwrap_err();
    assert!(typo.to_string().contains("outer_diameter"), "{typo}");
}

/// What one thread owns another one takes.
#[test]
fn models_and_joints_are_sent_to_other_threads() {
    fn sent<T: Send + 'static>(_: &T) {}
    let muscle = Model::FE.of(&Muscle::prototype()).unwrap();
    sent(&muscle);
    sent(&JointModel::antagonists(&muscle, 25.0, 0.1, (-60.0, 60.0)).unwrap());
}

/// Gent's law once more, as a law of one's own.
mod custom {
    use mckibben::{
        Constant, InvariantDerivatives, InvariantLaw, LawConstants, check_law,
        design::Spec,
        fit::{DataPoint, MeasuredPoint},
        prelude::*,
    };
    use mckibben_core::rubber::Gent;

    #[derive(Debug)]
    struct Mine(Gent);

    impl InvariantLaw for Mine {
        fn invariant(&self, i1: f64, i2: f64) -> InvariantDerivatives {
            self.0.invariant(i1, i2)
        }
    }

    impl LawConstants for Mine {
        const NAME: &'static str = "mine";
        const CONSTANTS: &'static [Constant] = <Gent as LawConstants>::CONSTANTS;
        const EXAMPLE: &'static [f64] = <Gent as LawConstants>::EXAMPLE;

        fn from_values(values: &[f64]) -> Option<Self> {
            Gent::from_values(values).map(Mine)
        }

        fn values(&self) -> Vec<f64> {
            self.0.values()
        }
    }

    /// The same muscle of both laws.
    #[allow(clippy::unwrap_used)]
    fn both() -> [Muscle; 2] {
        let gent = Gent {
            mu_mpa: 0.25,
            jm: 20.0,
        };
        let laws = [Law::from(gent), Law::custom(Mine(gent))];
        laws.map(|law| {
            check_law(&law).unwrap();
            Muscle::prototype().with_rubber(Rubber::new(law)).unwrap()
        })
    }

    #[test]
    fn a_law_of_ones_own_is_that_of_the_list_in_every_model() {
        for name in ["thick-wall", "universal", "fe", "fe3d"] {
            let model: Model = name.parse().unwrap();
            let [listed, own] = both().map(|m| model.of(&m).unwrap().force_n(0.2, 0.1).unwrap());
            assert!((own / listed - 1.0).abs() < 1e-8, "{name}: {own} {listed}");
        }
        let by = |m: Muscle| {
            let mut model = Model::FE.of(&m).unwrap();
            let by = model.gradient(0.2, 0.1, &["tube.material.jm"]).unwrap();
            by.by_parameters[0]
        };
        let [listed, own] = both().map(by);
        assert!((own / listed - 1.0).abs() < 1e-6, "{own} {listed}");
    }

    #[test]
    fn a_law_of_ones_own_is_designed_with_and_identified() {
        let found = both().map(|base| {
            let spec = Spec::pull(300.0, Contraction(0.1), Pressure(0.3)).length_mm(200.0);
            let spec = spec.outer_diameter_mm(20.0, 40.0);
            mckibben::decide(&Spec {
                base,
                top: 1,
                ..spec
            })
            .unwrap()
        });
        let [listed, own] = found.map(|design| design.candidates[0].pressure_mpa);
        assert!((own / listed - 1.0).abs() < 1e-3, "{own} {listed}");

        let points: Vec<DataPoint> = [(0.1, 0.0), (0.2, 0.05), (0.2, 0.1), (0.3, 0.1), (0.3, 0.2)]
            .iter()
            .map(|&(pressure_mpa, contraction)| {
                let mut model = Model::UNIVERSAL.of(&both()[0]).unwrap();
                let force_n = model.force_n(pressure_mpa, contraction).unwrap();
                let branch = Some(Direction::Mean);
                DataPoint::new(MeasuredPoint {
                    pressure_mpa,
                    contraction,
                    force_n,
                    branch,
                })
            })
            .collect();
        let found = both().map(|m| {
            let points = points.clone();
            Model::UNIVERSAL
                .identify(&m)
                .points(points)
                .solve()
                .unwrap()
        });
        let [listed, own] = found.map(|found| found.rms_n);
        assert!(
            (own - listed).abs() < 1e-3 * (1.0 + listed),
            "{own} {listed}"
        );
    }
}

/// The facts of a dozen muscles as `force` answers them, which `identity_every_output_has_…` of the
/// application reads from all commands, are those of Rust: pull as built, interval, limits, warnings.
#[test]
fn identity_a_muscle_in_rust_has_the_facts_of_every_other_output() {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../mckibben-app/tests/layer/truth/"
    );
    let read = |name: &str| std::fs::read_to_string(format!("{folder}{name}")).unwrap();
    let table = read("facts.tsv");
    let mut rows = table.lines().map(|line| line.split('\t'));
    let keys: Vec<&str> = rows.next().unwrap().collect();
    for row in rows {
        let row: Vec<&str> = row.collect();
        let fact = |key: &str| row[keys.iter().position(|k| *k == key).unwrap()];
        let name = fact("muscle");
        let text = name.strip_prefix("lib:").map(|name| file(name).unwrap());
        let text = text.map_or_else(|| read(name), str::to_owned);
        let mut model = Model::FE.of(&text.parse().unwrap()).unwrap();
        let [p, e] = ["pressure_mpa", "contraction"].map(|key| fact(key).parse().unwrap());
        let answer = model.at(Pressure(p), Contraction(e)).unwrap();
        let built = answer.built.as_ref().unwrap();
        let burst = model.burst();
        let allowed = burst.allowed();
        for (key, value) in [
            ("predicted_n", Some(built.predicted_n)),
            ("predicted_low_n", Some(built.predicted_low_n)),
            ("predicted_high_n", Some(built.predicted_high_n)),
            ("allowed_pressure_mpa", allowed.map(|allowed| allowed.mpa)),
            ("burst_pressure_mpa", burst.least().map(|(_, mpa)| mpa)),
        ] {
            let wanted = fact(key).parse::<f64>().ok();
            let (x, y) = (value.unwrap_or(-1.0), wanted.unwrap_or(-1.0));
            assert!(
                (x - y).abs() <= 2e-6 + 1e-6 * y.abs(),
                "{name}: {key} {x} {y}"
            );
        }
        let of_muscle = [
            WarningKind::Burst,
            WarningKind::BurstNotChecked,
            WarningKind::AboveAllowed,
            WarningKind::NotMeasured,
        ];
        let kinds = answer.warnings.iter().map(|w| w.kind);
        let mut kinds: Vec<String> = kinds
            .filter(|kind| of_muscle.contains(kind))
            .map(|kind| serde_json::to_value(kind).unwrap())
            .map(|kind| kind.as_str().unwrap().to_owned())
            .collect();
        kinds.sort();
        kinds.dedup();
        assert_eq!(kinds.join(","), fact("warnings"), "{name}");
    }
}
