//! Files and requests as nobody means them: an answer or a reason, in good time, and never a fault
//! of the program. `MCKIBBEN_TIMES` takes more.

use crate::Client;
use mckibben_core::random::Random;
use mckibben_server::Config;
use serde_json::{Value, json};
use std::{path::Path, time::Duration};

const TOKENS: [&str; 16] = [
    "1e308",
    "-1e308",
    "1e-320",
    "nan",
    "inf",
    "-1",
    "0",
    "99999999999999999999",
    "1e200 mm",
    "½",
    "\u{0}",
    "\u{feff}",
    "\"",
    "[",
    "=",
    "\n",
];

fn below(random: &mut Random, n: usize) -> usize {
    (random.bits() % n.max(1) as u64) as usize
}

/// A text with one to four changes; every other one is in a digit, as numbers are what files are
/// made of.
fn mutated(random: &mut Random, text: &str) -> String {
    let mut chars: Vec<char> = text.chars().collect();
    for _ in 0..=below(random, 4) {
        let at = below(random, chars.len());
        let digit = (at..chars.len())
            .find(|i| chars[*i].is_ascii_digit())
            .filter(|_| below(random, 2) == 0);
        let (from, to) = digit.map_or((at, at + below(random, 12)), |digit| (digit, digit + 1));
        let new = if below(random, 4) == 0 {
            ""
        } else {
            TOKENS[below(random, TOKENS.len())]
        };
        chars
            .splice(from..to.min(chars.len()), new.chars())
            .for_each(drop);
    }
    chars.into_iter().collect()
}

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../examples")
        .join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

#[tokio::test]
async fn mutated_requests_give_an_answer_or_a_reason() {
    let client = Client::new(Config {
        time: Duration::from_secs(2),
        ..Config::default()
    });
    let file = |name: &str, text: String| json!({ "name": name, "text": text });
    type Kind<'a> = (&'a str, String, &'a dyn Fn(Value) -> Value);
    let kinds: [Kind<'_>; 5] = [
        (
            "force",
            example("prototype.toml"),
            &|f| json!({ "muscle": { "file": f }, "pressure_mpa": 0.2, "contraction": 0.1 }),
        ),
        ("joint", example("elbow.toml"), &|f| {
            let muscle = file("biceps.toml", example("biceps.toml"));
            json!({ "joint": f, "muscles": [muscle, muscle], "model": "ideal", "pressures_mpa": [0.2, 0.1] })
        }),
        (
            "motion",
            example("drive.toml"),
            &|f| json!({ "drive": f, "muscle": file("prototype.toml", example("prototype.toml")), "model": "ideal" }),
        ),
        (
            "compare",
            example("bench.csv"),
            &|f| json!({ "models": ["ideal", "thick-wall"], "data": [f] }),
        ),
        (
            "identify",
            example("bench.csv"),
            &|f| json!({ "data": [f], "model": "thick-wall", "free": ["braid.stiffness"] }),
        ),
    ];
    let mut random = Random(1);
    let rounds = mckibben_core::random::rounds(100);
    for i in 0..rounds {
        let (command, text, request) = &kinds[i % kinds.len()];
        let request = if i % 3 == 0 {
            mutated(
                &mut random,
                &request(file("file", text.clone())).to_string(),
            )
        } else {
            request(file("file", mutated(&mut random, text))).to_string()
        };
        let answer = client.post(command, request.clone()).await;
        assert!(
            [200, 400, 422, 504].contains(&answer.status.as_u16()),
            "{command} {request}: {answer:?}"
        );
    }
}
