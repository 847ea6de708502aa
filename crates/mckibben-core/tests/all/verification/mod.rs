//! Cases with exact values: are the equations solved right?

mod joint;
pub mod rows;

rows::cases! {
    virtual_work_of_an_elbow:
        "virtual work: τ = d/dφ (Σ ∫F dΔ − E of weight and spring)" => joint::virtual_work;
    symmetry_of_two_equal_muscles:
        "symmetry: two equal muscles at one pressure" => joint::symmetric;
    identity_of_torque_and_stiffness_of_pressures_found_for_them:
        "identity: torque and stiffness of the pressures found for them" => joint::inverses;
}
