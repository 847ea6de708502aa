//! Files and numbers of requests and answers.

use super::root;
use mckibben_app::{JointFields, MotionRequest, TextFile};
use serde_json::{Value, json};

/// A text as a file of a request.
pub fn file(name: &str, text: &str) -> Value {
    json!({ "name": name, "text": text })
}

/// The text of a file of the repository.
pub fn text_of(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// A file of the repository under its own name, without its folder.
pub fn example(path: &str) -> Value {
    file(path.rsplit('/').next().unwrap(), &text_of(path))
}

/// A muscle that is a file of the repository.
pub fn muscle(path: &str) -> Value {
    json!({ "file": example(path) })
}

/// A table of the repository, in whatever encoding, under its own name, without its folder.
pub fn table(path: &str) -> Value {
    let TextFile { name, text } = TextFile::table(&root().join(path)).unwrap();
    file(name.rsplit('/').next().unwrap(), &text)
}

/// A joint file of the repository with the muscle files that it names.
pub fn joint_file(path: &str) -> Value {
    serde_json::to_value(JointFields::read(&root().join(path)).unwrap()).unwrap()
}

/// A drive file of the repository with the files that it names.
pub fn drive_file(path: &str) -> Value {
    let request = MotionRequest::default().with_drive(&root().join(path));
    serde_json::to_value(request.unwrap()).unwrap()
}

/// A request with more fields, which take the place of those of the same name.
pub fn with(mut request: Value, more: Value) -> Value {
    let fields = request.as_object_mut().unwrap();
    fields.extend(more.as_object().unwrap().clone());
    request
}

/// A number that is there.
#[track_caller]
pub fn number(value: &Value, key: &str) -> f64 {
    let found = value[key].as_f64();
    found.unwrap_or_else(|| panic!("{key} is not a number in {value:#}"))
}

#[track_caller]
pub fn assert_close(a: f64, b: f64, relative: f64) {
    assert!(
        (a - b).abs() <= relative * b.abs().max(1e-9),
        "{a} is not {b}"
    );
}

/// The parameter of this name in the answer of `identify`.
#[track_caller]
pub fn parameter<'a>(answer: &'a Value, name: &str) -> &'a Value {
    let mut all = answer["parameters"].as_array().unwrap().iter();
    all.find(|p| p["name"] == name).unwrap()
}

/// The last value of a series of a motion.
#[track_caller]
pub fn last(answer: &Value, key: &str) -> f64 {
    let series = answer["series"][key].as_array().unwrap();
    series.last().unwrap().as_f64().unwrap()
}
