//! Files with one mistake each: the line it is found in, and what the message must say.

use super::{MAX_BYTES, Problem, parse_muscle, read_muscle};
use mckibben_io::files::ReadError;

const BAD: &[(&str, usize, &str)] = &[
    // Values that make no muscle.
    (
        "[tube]\nwall_thickness = \"-3 mm\"",
        2,
        "tube.wall_thickness = \"-3 mm\": is -3 mm; it must be above zero and finite",
    ),
    ("[tube]\n\nouter_diameter = 0", 3, "tube.outer_diameter = 0: is 0 mm; it must be above zero"),
    ("[tube]\nlength = -0.0", 2, "tube.length = -0.0: is -0 mm; it must be above zero"),
    (
        "[tube]\nouter_diameter = 30\nwall_thickness = 15",
        3,
        "tube.wall_thickness = 15: is 15 mm, but the radius is 15 mm",
    ),
    (
        "[tube]\nouter_diameter = \"5 mm\"",
        2,
        "tube.outer_diameter = \"5 mm\": tube.wall_thickness is 3 mm, but the radius is 2.5 mm",
    ),
    (
        "[tube]\nwall_thickness = 16",
        2,
        "(half of tube.outer_diameter); tube.outer_diameter is not written, so this is its default",
    ),
    ("[braid]\nangle = \"80 deg\"", 2, "braid.angle = \"80 deg\": is 80 deg; the angle of the strands"),
    ("[braid]\nangle = 0", 2, "between 0 and 75 deg"),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nsoftening = { r = 0.8, m = 0.05 }",
        4,
        "r is 0.8; it must be 1 or above",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nsoftening = { r = 1.5 }",
        4,
        "tube.material.softening.m",
    ),
    ("[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nsoftening = 1.5", 4, "expected a table of keys"),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nsoftening = { r = 1.5, m = 0.05, s = 1 }",
        4,
        "tube.material.softening.s: unknown key",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nconditioned = \"2.5 bar\"",
        4,
        "the rubber has no tube.material.softening",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nsoftening = { r = 1.5, m = 0.05 }\nconditioned = \"0 bar\"",
        5,
        "is 0 MPa; it must be above zero",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nprony = [[0.6, 2], [0.5, 20]]",
        4,
        "below 1: what is left is the rubber at rest",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nprony = [[0.2, 0]]",
        4,
        "a branch's time constant in s is 0; it must be above zero",
    ),
    ("[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nprony = [0.2, 2]", 4, "pairs of a share and a time"),
    ("[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nprony = [[1.2, 2]]\nheld = \"long\"", 4, "below 1"),
    ("[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nheld = \"long\"", 4, "tube.material.prony"),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nprony = [[0.2, 2]]\nheld = \"for ever\"",
        5,
        "\"long\", or a time",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nprony = [[0.2, 2]]\nheld = \"-1 s\"",
        5,
        "is -1 s; it must not be below zero",
    ),
    ("[braid]\nstiffness = \"0 N/mm\"", 2, "braid.stiffness = \"0 N/mm\": is 0 N/mm; it must be above zero"),
    ("[terminals]\ninsertion = -1", 2, "terminals.insertion = -1: is -1 mm; it must not be below zero"),
    (
        "[terminals]\nseating = \"-1 mm\"",
        2,
        "terminals.seating = \"-1 mm\": is -1 mm; it must not be below zero",
    ),
    ("[terminals]\ngrip = 150", 2, "must be below the muscle's length of 285 mm"),
    ("[terminals]\nslip = \"-1 mm/N\"", 2, "must not be below zero"),
    ("[terminals]\nseating = 300", 2, "it must be below the muscle's length of 285 mm"),
    ("[terminals]\nend_factor = 0", 2, "terminals.end_factor = 0: is 0; it must"),
    ("[terminals]\nend_factor = { a = -2, b = 1 }", 2, "at 0 MPa (a + b) is -1"),
    ("[terminals]\ncone_factor = -0.1", 2, "terminals.cone_factor = -0.1: is -0.1"),
    ("[friction]\ncoefficient = -5\nexponent = 1", 2, "friction.coefficient = -5: is -5 N/MPa^exponent"),
    // Quantities.
    (
        "[tube]\nlength = \"30 bar\"",
        2,
        "tube.length = \"30 bar\": is a pressure; expected a length such as 30mm, 3cm or 1.2in",
    ),
    ("[tube]\nlength = \"30 furlongs\"", 2, "\"furlongs\" is not a known unit; expected a length"),
    (
        "[tube]\nlength = \"long\"",
        2,
        "tube.length = \"long\": does not start with a number; expected a length",
    ),
    ("[tube]\nlength = \"\"", 2, "the value is empty; expected a length"),
    ("[tube]\nlength = nan", 2, "tube.length = nan: is not a finite number; expected a length"),
    ("[tube]\nlength = \"inf\"", 2, "tube.length = \"inf\": is not a finite number"),
    ("[tube]\nlength = \"1e999 mm\"", 2, "is not a finite number"),
    ("[tube]\nlength = true", 2, "tube.length = true: is true or false; expected a length"),
    ("[tube]\nlength = [1, 2]", 2, "tube.length = [1, 2]: is a list; expected a length"),
    ("[tube]\nlength = { mm = 3 }", 2, "is a table; expected a length"),
    ("[tube]\nlength = 1979-05-27", 2, "is a date or time; expected a length"),
    ("[braid]\nangle = \"28 mm\"", 2, "is a length; expected an angle such as 28deg"),
    // Keys.
    (
        "[tube]\nouter_diamter = 30",
        2,
        "tube.outer_diamter: unknown key (did you mean outer_diameter?); known here: outer_diameter, wall_thickness",
    ),
    ("[tube]\nthickness = 3", 2, "tube.thickness: unknown key (did you mean wall_thickness?)"),
    ("[tube]\nangle = 28", 2, "tube.angle: unknown key (did you mean braid.angle?)"),
    ("\nouter_diameter = 30", 2, "outer_diameter: unknown key (did you mean tube.outer_diameter?)"),
    ("[tubes]\n", 1, "tubes: unknown key (did you mean tube?); known here: tube, braid, terminals"),
    ("[tube]\ncolour = \"red\"", 2, "tube.colour: unknown key; known here"),
    ("[material]\nlaw = \"gent\"", 1, "material: unknown key (did you mean tube.material?)"),
    ("tube = 3", 1, "tube = 3: is a number; expected a table of keys"),
    ("[[tube]]\nlength = 3", 1, "tube: is a list of tables; expected a table of keys"),
    ("name = 3", 1, "name = 3: is a number; expected a text in quotes"),
    // The rubber.
    (
        "[tube]\nrubber = \"dragonskin-30\"",
        2,
        "there is no rubber named \"dragonskin-30\" (did you mean dragon-skin-30?)",
    ),
    (
        "[tube]\nrubber = \"rebound-25:yoeh\"",
        2,
        "rebound-25 has no fit of the law \"yoeh\"; it has neo-hookean",
    ),
    ("[tube]\nrubber = 30", 2, "tube.rubber = 30: is a number; expected the name of a rubber"),
    (
        "[tube]\nrubber = \"paper\"\n[tube.material]\nlaw = \"neo-hookean\"\nmu = 1",
        2,
        "give either `rubber` or [tube.material]",
    ),
    (
        "[tube.material]\nc10 = 1",
        1,
        "tube.material: tube.material.law is missing; it is one of mooney-rivlin",
    ),
    (
        "[tube.material]\nlaw = \"mooney-rivlyn\"",
        2,
        "tube.material.law = \"mooney-rivlyn\": is not known (did you mean mooney-rivlin?)",
    ),
    (
        "[tube.material]\nlaw = \"mooney-rivlin\"\nc10 = 0.1",
        2,
        "tube.material.c01 is missing; a law needs all of its constants",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 0.2\nc10 = 0.1",
        4,
        "tube.material.c10: is not a constant of the neo-hookean law; its constants are mu",
    ),
    (
        "[tube.material]\nlaw = \"mooney-rivlin\"\nmu = 0.2",
        3,
        "tube.material.mu: is not a constant of the mooney-rivlin law; its constants are c10, c01",
    ),
    (
        "[tube.material]\nlaw = \"mooney-rivlin\"\nc10 = 0.1\nc01 = -0.2",
        3,
        "tube.material.c10 = 0.1: the mooney-rivlin constants give a shear modulus of -0.2 MPa",
    ),
    ("[tube.material]\nlaw = \"gent\"\nmu = 1\njm = -3", 4, "tube.material.jm = -3: "),
    (
        "[tube.material]\nlaw = \"gent\"\nmu = 1\njm = \"3 MPa\"",
        4,
        "is a text; expected a number without unit",
    ),
    (
        "[tube.material]\nlaw = \"ogden\"\nmu = [1, 2]\nalpha = [2]",
        4,
        "tube.material.alpha = [2]: has 1 numbers, but mu has 2",
    ),
    (
        "[tube.material]\nlaw = \"ogden\"\nmu = []\nalpha = []",
        4,
        "an ogden law needs one alpha other than zero",
    ),
    ("[tube.material]\nlaw = \"ogden\"\nmu = 1\nalpha = [2]", 3, "is a number; expected a list such as"),
    (
        "[tube.material]\nlaw = \"ogden\"\nmu = [\n 1,\n \"2 mm\"]\nalpha = [2, 3]",
        3,
        "is a length; expected a pressure",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 1\nbulk_modulus = \"compressible\"",
        4,
        "is not known (did you mean incompressible?); expected \"incompressible\", or a pressure",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 1\nbulk_modulus = -3",
        4,
        "tube.material.bulk_modulus = -3: is -3 MPa; it must be above zero",
    ),
    (
        "[tube.material]\nlaw = \"neo-hookean\"\nmu = 1\nfitted_to_stretch = 0",
        4,
        "tube.material.fitted_to_stretch = 0: is 0; it must be above zero",
    ),
    // The braid.
    (
        "[braid]\nstiffness = \"papr\"",
        2,
        "braid.stiffness = \"papr\": is not known (did you mean paper?); expected \"paper\", \"inextensible\", or a stiffness",
    ),
    (
        "[braid]\nstrand_area = 1\nstiffness = \"paper\"\nstrand_modulus = 2",
        3,
        "braid.stiffness = \"paper\": give either `stiffness`, or `strands`",
    ),
    (
        "[braid]\nstrands = 48\nstrand_area = \"0.3 mm2\"",
        3,
        "strand_modulus is missing; a braid described by its",
    ),
    ("[braid]\nstrands = 48\nstrand_modulus = 2500", 3, "strand_area is missing"),
    ("[braid]\nstrand_area = 1\nstrand_modulus = 2500", 2, "strands is missing"),
    ("[braid]\nstrands = 47", 2, "braid.strands = 47: is 47; it must be an even whole number"),
    ("[braid]\nstrands = 0", 2, "braid.strands = 0: is 0; it must be an even whole number"),
    ("[braid]\nstrands = -2", 2, "it must be an even whole number"),
    ("[braid]\nstrands = 48.5", 2, "is 48.5; it must be an even whole number"),
    ("[braid]\nstrands = \"48\"", 2, "is a text; expected a number without unit"),
    ("[braid]\nstrand_strength = \"40 N\"", 2, "braid.strand_strength = \"40 N\": needs braid.strands"),
    ("[braid]\nstrand_length = 340", 2, "braid.turns is missing; a strand measured on the muscle has both"),
    ("[braid]\nturns = 2", 2, "braid.strand_length is missing"),
    ("[braid]\nthickness = -0.3", 2, "braid.thickness = -0.3: is -0.3 mm; it must not be below zero"),
    (
        "[braid]\nthickness = 40",
        2,
        "it must be below the tube's outer diameter of 30 mm (both layers of strands",
    ),
    (
        "[braid]\ndiameter = 29",
        2,
        "braid.diameter = 29: is 29 mm, but the tube has an outer diameter of 30 mm",
    ),
    ("[braid]\ncrimp = 0", 2, "braid.crimp = 0: is 0; it must be above zero"),
    ("[braid]\ncrimp_stiffness = 0.1", 2, "braid.crimp is missing"),
    (
        "[braid]\ncrimp = \"1%\"\ncrimp_stiffness = 1.1",
        3,
        "the share of the strands' stiffness that they have before they are straight",
    ),
    ("[braid]\nstiffness = \"inextensible\"\ncrimp = \"1%\"", 3, "needs strands with a stiffness"),
    ("[friction]\nlever = -1", 2, "friction.lever = -1: is -1 mm; it must not be below zero"),
    // A named sleeve.
    (
        "[braid]\nname = \"nfl-18\"",
        2,
        "braid.name = \"nfl-18\": there is no sleeve named \"nfl-18\" (did you mean nfl-19?)",
    ),
    ("[braid]\nname = 19", 2, "braid.name = 19: is a number; expected the name of a sleeve"),
    (
        "[tube]\nouter_diameter = 20\n[braid]\nname = \"nfl-19\"\nstiffness_factor = 0.5",
        5,
        "braid.stiffness_factor",
    ),
    (
        "[braid]\nname = \"s-muscle-20\"\nstiffness = \"inextensible\"",
        2,
        "s-muscle-20 fits tubes from 0.4788 to 6.4544 mm; the tube has an outer diameter of 30 mm",
    ),
    (
        "[tube]\nouter_diameter = 34\n[braid]\nangle = 50\nname = \"nfl-19\"\nstiffness = 300",
        5,
        "nfl-19 has an angle of 63.24 deg on 34 mm, and a muscle contracts below 54.7356 deg only",
    ),
    (
        "[tube]\nouter_diameter = 20\n[braid]\nname = \"nfl-19\"\nstiffness = 300\nangle = 28",
        6,
        "braid.angle = 28: is 28 deg, but nfl-19 has 31.68 deg on a tube of 20 mm: leave one of them out",
    ),
    (
        "[tube]\nouter_diameter = 20\n[braid]\nname = \"nfl-19\"\nstiffness = 300\nstrand_modulus = 8000",
        5,
        "give either `stiffness`, or `strands`",
    ),
    (
        "[braid]\nstrands = 48\nstrand_area = 0.1\nstrand_diameter = 0.3\nstrand_modulus = 2500",
        4,
        "give either `strand_area` or `strand_diameter`; both are given",
    ),
    (
        "[braid]\nstrands = 48\nstrand_diameter = \"-0.3 mm\"\nstrand_modulus = 2500",
        3,
        "braid.strand_diameter = \"-0.3 mm\": is -0.3 mm; it must be above zero",
    ),
    ("[braid]\nstrands = 48\nstrand_diameter = 0.3", 3, "strand_modulus is missing"),
    ("[braid]\nstrand_diameter = 0.3\nstrand_modulus = 2500", 2, "strands is missing"),
    ("[braid]\nstrand_diametr = 0.3", 2, "did you mean strand_diameter?"),
    ("[braid]\ncompression = \"yes\"", 2, "is a text; expected true or false, without quotes"),
    // Terminals and friction.
    (
        "[terminals]\nend_factor = { a = 1 }",
        2,
        "terminals.end_factor.b is missing; an end factor is a number, or",
    ),
    ("[terminals.end_factor]\na = 1\nc = 2", 3, "terminals.end_factor.c: unknown key"),
    ("[terminals]\nend_factor = \"1.2\"", 2, "is a text; expected a number without unit"),
    ("[friction]\ncoefficient = 61", 2, "friction.exponent is missing; friction is C·P^β"),
    (
        "[friction]\npresliding = 1",
        2,
        "friction.presliding = 1: needs the friction itself: friction.lever, or",
    ),
    // TOML itself.
    ("[tube]\nlength = 3\nlength = 4", 3, "not valid TOML: duplicate key in `length = 4`"),
    ("[tube]\n[braid]\n[tube]", 3, "not valid TOML: duplicate key"),
    ("[tube]\nlength = 30 mm", 2, "(write a quantity with a unit in quotes: \"30 mm\")"),
    ("[tube]\nlength = \"30", 2, "not valid TOML"),
    ("[tube\nlength = 30", 1, "not valid TOML"),
    ("[tube]\nlength", 2, "not valid TOML"),
    ("[tube]\r\nlength = 30\r\nwall = = 3", 3, "not valid TOML"),
    ("outer diameter: 30 mm", 1, "not valid TOML"),
];

#[test]
fn bad_files_are_refused_with_line_key_and_expectation() {
    let mut wrong = Vec::new();
    for (text, line, fragment) in BAD {
        // A BOM in front and CRLF move nothing.
        for text in
            [text.to_string(), format!("\u{feff}{text}"), text.replace("\r\n", "\n").replace('\n', "\r\n")]
        {
            match parse_muscle(&text) {
                Ok(_) => wrong.push(format!("{text:?} is accepted")),
                Err(e) => {
                    let message = e.to_string();
                    if e.place.map(|p| p.line) != Some(*line) || !message.contains(fragment) {
                        wrong.push(format!("{text:?}: {message}"));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_column_counts_characters() {
    let error = parse_muscle("name = \"é\"\n[tube]\n  \"rubber\" = \"päper\" # ä\n").unwrap_err();
    assert_eq!(error.place.map(|p| (p.line, p.column)), Some((3, 14)));
}

/// A directory of its own for one test, removed at the end.
struct Scratch(std::path::PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("mckibben-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str, bytes: &[u8]) -> std::path::PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn what_is_no_readable_file_is_refused_by_name() {
    let dir = Scratch::new("bad-files");
    let message = |path: &std::path::Path| read_muscle(path).unwrap_err().to_string();
    let bad = dir.file("muscle.toml", b"[tube]\n\nwall_thickness = \"-3 mm\"\n");
    assert!(message(&bad).ends_with(
        "muscle.toml:3:18: tube.wall_thickness = \"-3 mm\": is -3 mm; it must be above zero and finite"
    ));
    let missing = read_muscle(dir.0.join("none.toml")).unwrap_err();
    assert!(matches!(*missing.problem, Problem::Unread(ReadError::System(_))));
    assert!(missing.to_string().contains("none.toml: cannot be read: "));
    assert!(message(&dir.0).contains("is a directory; it must be a regular file"));
    #[cfg(unix)]
    assert!(message("/dev/null".as_ref()).contains("is a device or a pipe"));
    let latin = dir.file("latin.toml", b"[tube]\n# 28\xb0\nlength = 3\n");
    assert!(message(&latin).contains("latin.toml:2:5: the byte at offset 11 is not UTF-8"));
    let utf16 = dir.file("utf16.toml", b"\xff\xfe[\0t\0");
    assert!(
        message(&utf16).contains("offset 0 is not UTF-8 text (this looks like UTF-16: save it as UTF-8)")
    );
    let long = dir.file("long.toml", &vec![b'\n'; MAX_BYTES + 1]);
    assert!(message(&long).contains("is longer than 1048576 bytes"));
    let full = dir.file("full.toml", &vec![b'\n'; MAX_BYTES]);
    assert!(read_muscle(full).is_ok());
    let good = dir.file("good.toml", "\u{feff}[tube]\r\nlength = \"300 mm\"\r\n".as_bytes());
    assert_eq!(read_muscle(good).unwrap().length_mm(), 300.0);
}
