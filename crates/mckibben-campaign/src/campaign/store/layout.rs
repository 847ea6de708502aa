//! The columns of a table; their names are the contract's words with units.

use parquet::schema::types::TypePtr;
use std::sync::Arc;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// 64-bit integer
    Int64,
    /// 32-bit integer
    Int32,
    /// double
    Double,
    /// double or nothing
    Optional,
    /// text
    Text,
}

/// The columns of a campaign.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Layout {
    /// Constants of the law: `c10_mpa`.
    pub(crate) constants: Vec<String>,
    /// Keys of the sensitivities: `tube.material.c10`.
    pub(crate) sensitivities: Vec<String>,
}

/// The columns before and behind those that depend on the plan.
const HEAD: [(&str, Kind); 6] = [
    ("muscle", Kind::Int64),
    ("outer_diameter_mm", Kind::Double),
    ("wall_mm", Kind::Double),
    ("length_mm", Kind::Double),
    ("angle_deg", Kind::Double),
    ("law", Kind::Text),
];
const MIDDLE: [(&str, Kind); 7] = [
    ("braid_stiffness_n_per_mm", Kind::Optional),
    ("pressure_mpa", Kind::Double),
    ("contraction", Kind::Double),
    ("force_n", Kind::Optional),
    ("volume_mm3", Kind::Optional),
    ("stiffness_n_per_mm", Kind::Optional),
    ("force_per_pressure_n_per_mpa", Kind::Optional),
];
const TAIL: [(&str, Kind); 3] = [("status", Kind::Text), ("cause", Kind::Text), ("iterations", Kind::Int32)];

impl Layout {
    /// Names and kinds of all columns.
    pub(crate) fn columns(&self) -> Vec<(String, Kind)> {
        let fixed = |list: &[(&str, Kind)]| list.iter().map(|c| (c.0.to_owned(), c.1)).collect::<Vec<_>>();
        let mut out = fixed(&HEAD);
        out.extend(self.constants.iter().map(|c| (c.clone(), Kind::Double)));
        out.extend(fixed(&MIDDLE));
        let sensitivity = |k: &String| (format!("d_force_d_{}", k.replace('.', "_")), Kind::Optional);
        out.extend(self.sensitivities.iter().map(sensitivity));
        out.extend(fixed(&TAIL));
        out
    }

    /// The same as a schema of Parquet.
    pub(crate) fn schema(&self) -> Result<TypePtr, String> {
        let mut text = String::from("message campaign {\n");
        for (name, kind) in self.columns() {
            let line = match kind {
                Kind::Int64 => format!("  REQUIRED INT64 {name};\n"),
                Kind::Int32 => format!("  REQUIRED INT32 {name};\n"),
                Kind::Double => format!("  REQUIRED DOUBLE {name};\n"),
                Kind::Optional => format!("  OPTIONAL DOUBLE {name};\n"),
                Kind::Text => format!("  REQUIRED BYTE_ARRAY {name} (UTF8);\n"),
            };
            text.push_str(&line);
        }
        text.push('}');
        parquet::schema::parser::parse_message_type(&text).map(Arc::new).map_err(|e| e.to_string())
    }

    /// Whether a column repeats few values, so that a dictionary of them is worth its bytes.
    pub(crate) fn repeats(name: &str) -> bool {
        !["force_n", "volume_mm3", "stiffness_n_per_mm", "force_per_pressure_n_per_mpa"].contains(&name)
            && !name.starts_with("d_force_d_")
    }
}
