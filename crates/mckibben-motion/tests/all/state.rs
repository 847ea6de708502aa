//! The numbers of a state in their places.

use mckibben_core::{model::Ideal, muscle::Muscle};
use mckibben_motion::{state::Layout, *};

#[test]
fn every_number_of_a_state_has_one_place() {
    let model = Ideal::between_ends(&Muscle::prototype());
    let load = SingleMuscle::hanging(&model, 1.0);
    let kind = ValveKind::Proportional {
        time_constant_s: 0.01,
        gain_per_mpa: 20.0,
    };
    let valve = Valve {
        kind,
        ..Valve::new(Orifice::new(0.5, 0.3).unwrap())
    };
    let muscle = Actuated {
        rubber: Prony(vec![
            Branch {
                share: 0.1,
                time_constant_s: 0.1
            };
            3
        ]),
        ..Actuated::new(model.clone(), Actuator::Valve(valve))
    };
    let output = PidOutput::Opening;
    let pid = Pid {
        proportional: 1.0,
        integral_per_s: 0.0,
        derivative_s: 0.0,
        filter_s: 0.01,
        tracking_s: 0.1,
        output,
    };
    let target = Commanded::Position {
        command: Command::Constant(0.1),
        pid,
    };
    let layout = Layout::new(&Drive::new(load.clone(), vec![muscle], target, 1.0));
    // q, v; p, m, opening, three branches; two of the controller; supplied, exhausted; nine
    // totals.
    assert_eq!((layout.core, layout.len), (2 + 6 + 2, 2 + 6 + 2 + 2 + 9));
    let numbers: Vec<f64> = (0..layout.len).map(|i| i as f64 + 0.5).collect();
    let mut state = layout.state(&numbers);
    assert_eq!((state.coordinate, state.velocity), (0.5, 1.5));
    assert_eq!(
        (state.muscles[0].absolute_mpa, state.muscles[0].exhausted_g),
        (2.5, 11.5)
    );
    assert_eq!(state.totals.positive_work, layout.len as f64 - 0.5);
    assert_eq!(state.to_vec(), numbers);
    let mut written = vec![0.0; layout.len];
    state.write(&mut written);
    assert_eq!(written, numbers);
}
