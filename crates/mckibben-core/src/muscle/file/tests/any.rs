//! Any muscle.

use super::*;

fn number(low: f64, high: f64) -> BoxedStrategy<f64> {
    // Plain decimals as people write them, and any double in the range.
    let thousandths = move |n: u32| low + (high - low) * f64::from(n) / 1000.0;
    prop_oneof![(1..999u32).prop_map(thousandths), low..high].boxed()
}

fn law() -> impl Strategy<Value = Law> {
    let m = || number(1e-4, 1.0);
    prop_oneof![
        (m(), -5e-5..1.0)
            .prop_map(|(c10_mpa, c01_mpa)| Law::MooneyRivlin(MooneyRivlin { c10_mpa, c01_mpa })),
        m().prop_map(|mu_mpa| Law::NeoHookean(NeoHookean { mu_mpa })),
        (m(), -1e-3..1e-3f64, -1e-9..1e-4f64).prop_map(|(c10_mpa, c20_mpa, c30_mpa)| Law::Yeoh(
            Yeoh {
                c10_mpa,
                c20_mpa,
                c30_mpa
            }
        )),
        (m(), 1.0..200.0).prop_map(|(mu_mpa, jm)| Law::Gent(Gent { mu_mpa, jm })),
        prop::collection::vec(
            (m(), 0.1..9.0f64)
                .prop_flat_map(|t: (f64, f64)| prop_oneof![Just(t), Just((-t.0, -t.1))]),
            1..4
        )
        .prop_map(|terms| Law::Ogden(Ogden { terms })),
    ]
}

fn rubber() -> impl Strategy<Value = Rubber> {
    let named: Vec<Rubber> = library::entries()
        .unwrap()
        .iter()
        .flat_map(|e| {
            e.laws()
                .into_iter()
                .map(|law| library::find(&format!("{}:{law}", e.name)).unwrap())
        })
        .collect();
    let bulk = prop_oneof![
        Just(Bulk::Incompressible),
        number(1.0, 3000.0).prop_map(Bulk::Modulus)
    ];
    let name = prop::option::of("[ -~äµ\n\"\\\\]{0,12}");
    let softening = (1.0..9.0, number(1e-6, 0.5), number(0.0, 1.0))
        .prop_map(|(r, m_mpa, beta)| OgdenRoxburgh { r, m_mpa, beta });
    let conditioned = prop_oneof![
        number(1e-3, 2.0).prop_map(Conditioned::Pressure),
        (1..20u32).prop_map(|n| Conditioned::Strain {
            strain: f64::from(n) / 100.0
        }),
    ];
    let memory = prop_oneof![
        Just((None, None)),
        (softening, prop::option::of(conditioned))
            .prop_map(|(s, conditioned)| (Some(s), conditioned)),
    ];
    let branch = (number(0.0, 0.3), number(1e-3, 1e5));
    let prony = prop::option::of(prop::collection::vec(branch, 1..4).prop_map(Prony::from));
    let reach = || prop::option::of(1.0..9.0);
    // In percent, as it is written.
    let breaks = prop::option::of((1..900u32).prop_map(|n| f64::from(n) / 100.0));
    let written = (name, law(), bulk, (reach(), breaks), memory, prony).prop_map(
        |(
            name,
            law,
            bulk,
            (fitted_to_stretch, elongation_at_break),
            (softening, conditioned),
            prony,
        )| Rubber {
            name,
            law,
            bulk,
            fitted_to_stretch,
            elongation_at_break,
            softening,
            conditioned,
            prony,
        },
    );
    prop_oneof![prop::sample::select(named), written]
}

fn braid() -> impl Strategy<Value = Braid> {
    let count = (1..200u32).prop_map(|n| 2 * n);
    let strength = || prop::option::of(number(1.0, 900.0));
    let section = (number(1e-9, 3.0), number(1.0, 2e5));
    let stiffness = prop_oneof![
        Just(BraidStiffness::Paper),
        Just(BraidStiffness::Inextensible),
        number(1.0, 1e4).prop_map(BraidStiffness::NewtonPerMm),
    ];
    let area = prop::option::of(number(1e-4, 3.0));
    let counted = (count.clone(), area, strength()).prop_map(|(c, area_mm2, s)| Strands {
        area_mm2,
        ..Strands::new(c, None, s)
    });
    let factors = (prop_oneof![Just(1.0), number(1.0, 9.0)], number(1.0, 9.0));
    let described =
        (count, section, strength(), factors).prop_map(|(count, section, strength_n, factors)| {
            let strands = Strands {
                count_factor: factors.0,
                strength_factor: strength_n.map_or(1.0, |_| factors.1),
                ..Strands::new(count, Some(section), strength_n)
            };
            (BraidStiffness::OfStrands, Some(strands))
        });
    let make = prop_oneof![(stiffness, prop::option::of(counted)), described];
    let measured =
        (1e3..5e3, number(0.1, 9.0)).prop_map(|(strand_length_mm, turns)| MeasuredStrand {
            strand_length_mm,
            turns,
        });
    let crimp = (number(1e-4, 0.1), 0.01..1.0).prop_map(|(strain, stiffness_ratio)| Crimp {
        strain,
        stiffness_ratio,
    });
    let lay = (
        prop_oneof![Just(0.0), number(0.01, 0.9)],
        prop::option::of(number(200.0, 300.0)),
        prop::option::of(crimp),
    );
    (
        number(1.0, 54.0),
        make,
        prop::option::of(measured),
        any::<bool>(),
        lay,
    )
        .prop_map(
            |(
                angle_deg,
                (stiffness, strands),
                measured,
                compression,
                (thickness_mm, diameter_mm, crimp),
            )| {
                Braid {
                    angle_deg,
                    stiffness,
                    strands,
                    measured,
                    compression,
                    in_rubber: compression,
                    take_up_mpa: diameter_mm.map(|mm| 1e-4 * mm),
                    thickness_mm,
                    diameter_mm,
                    crimp: crimp.filter(|_| stiffness != BraidStiffness::Inextensible),
                    stiffness_factor: 1.0,
                    strands_per_carrier: strands.map(|_| 4.0),
                    sleeve: None,
                }
            },
        )
}

prop_compose! {
    pub fn muscle()(
        outer_diameter_mm in number(1.0, 200.0),
        share in 0.01..0.99f64,
        length_mm in number(5.0, 900.0),
        rubber in rubber(),
        braid in braid(),
        insertion_mm in prop::option::of(number(0.0, 90.0)),
        seating_mm in prop::option::of(number(0.0, 5.0)),
        slip_mm_per_n in prop::option::of(number(0.0, 0.01)),
        grip_share in prop::option::of(number(0.0, 0.9)),
        end_factor in prop::option::of(prop_oneof![
            number(0.5, 2.0).prop_map(EndFactor::Constant),
            (-0.4..2.0, 0.5..2.0).prop_map(|(a, b)| EndFactor::OfPressure { a, b }),
        ]),
        friction in prop::option::of((number(0.0, 200.0), number(0.0, 2.0), prop_oneof![Just(0.0), number(0.01, 5.0)], prop::option::of(number(0.01, 5.0)))),
    ) -> Muscle {
        // A strand is no thicker than the tube.
        let strand_area_mm2 = braid.strands.and_then(|s| s.area_mm2).unwrap_or(0.0);
        let strand_mm = (4.0 * strand_area_mm2 / std::f64::consts::PI).sqrt();
        let outer_diameter_mm = outer_diameter_mm.max(braid.diameter_mm.unwrap_or(0.0)).max(1.01 * strand_mm);
        let tube = Tube::new(outer_diameter_mm, share * outer_diameter_mm / 2.0, length_mm, rubber);
        let grip_mm = grip_share.map(|share| share * 0.5 * (length_mm - seating_mm.unwrap_or(0.0)));
        let pull_off_n = seating_mm.map(|v| 100.0 + v);
        let rated_pressure_mpa = grip_mm.map(|_| 0.8);
        let terminals = Terminals {
            made: grip_mm.map(|_| EndsMade::Tied),
            insertion_mm,
            seating_mm,
            slip_mm_per_n,
            grip_mm,
            plug_diameter_mm: grip_mm.map(|_| 1.1 * 2.0 * tube.inner_radius_mm()),
            pull_off_n,
            rated_pressure_mpa,
            end_factor,
        };
        let friction = friction.map(|(coefficient, exponent, lever_mm, length_mm)| {
            Friction { coefficient, exponent, lever_mm, presliding_mm: length_mm.filter(|_| coefficient > 0.0 || lever_mm > 0.0) }
        });
        Muscle::new(tube, braid, terminals, friction).unwrap()
    }
}
