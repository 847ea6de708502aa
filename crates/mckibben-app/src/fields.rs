//! Fields that requests share.

use crate::Problem;
pub use crate::muscle_fields::{MuscleFields, NamedFields};
pub use mckibben::muscle::measures::MeasureValues;
pub use mckibben::muscle::{BraidStiffness as Stiffness, Direction};
use mckibben_fem::three_dimensional::{Match, Plug};
use mckibben_io::table::TableError;
pub use mckibben_io::table::{Columns, Understood, UnderstoodColumn};
use schemars::{JsonSchema, Schema, transform::Transform};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;

/// A file that a front end read, or that its user dropped in.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub struct TextFile {
    /// What to call it in messages: a path or a name.
    pub name: String,
    /// What is in it.
    pub text: String,
}

/// A file, or a name alone, such as `lib:dmsp-20-300`.
pub(crate) fn name_or_file<'de, D: Deserializer<'de>>(
    from: D,
) -> Result<Option<TextFile>, D::Error> {
    #[derive(Deserialize)]
    #[serde(
        untagged,
        expecting = "a name such as \"lib:dmsp-20-300\" or an object with `name` and `text` is \
            expected"
    )]
    enum Given {
        File(TextFile),
        Name(String),
    }
    Ok(
        Option::<Given>::deserialize(from)?.map(|given| match given {
            Given::File(file) => file,
            Given::Name(name) => TextFile {
                name,
                text: String::new(),
            },
        }),
    )
}

/// Measured tables, and what they do not state.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct DataFields {
    /// Tables of measured points: pressures, contractions (or shortenings, or lengths) and pulls;
    /// of tests of a rubber: stretches, strains or extensions and stresses or forces. With their
    /// units, and more.
    pub data: Vec<TextFile>,
    /// Columns of `data` whose heading does not say what they are: quantity to "heading:unit".
    pub columns: Columns,
    /// Constants of a whole table, such as pressure=3bar; a quantity that is given once for each of
    /// `data` has one value in each. {pressure}bar takes the number from the name of the file;
    /// branch=velocity cuts rows in time order into branches by the sign of their velocity.
    pub set: Vec<String>,
}

impl DataFields {
    /// Reads each table.
    pub(crate) fn read<T>(
        &self,
        read: impl Fn(&str, Columns) -> Result<(T, Understood), TableError>,
    ) -> Result<Vec<(T, UnderstoodTable)>, Problem> {
        let used = [
            ("columns", self.columns != Columns::default()),
            ("set", !self.set.is_empty()),
        ];
        if self.data.is_empty() {
            Problem::refuse_unused(&used, "it belongs to tables, and no `data` are given")?;
        }
        let one = |(place, file): (usize, &TextFile)| {
            let columns =
                self.columns
                    .clone()
                    .with(&self.set, (place, self.data.len()), &file.name);
            let (data, table) = columns
                .and_then(|columns| read(&file.text, columns))
                .map_err(|error| Problem::of_table(&file.name, &error))?;
            Ok((
                data,
                UnderstoodTable {
                    data: file.name.clone(),
                    table,
                },
            ))
        };
        self.data.iter().enumerate().map(one).collect()
    }

    /// The tables by their names.
    pub fn names(&self) -> String {
        self.data
            .iter()
            .map(|file| file.name.as_str())
            .collect::<Vec<_>>()
            .join(", ")
    }
}

/// What was understood of a table.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct UnderstoodTable {
    /// The table.
    pub data: String,
    /// What was understood of it.
    #[serde(flatten)]
    pub table: Understood,
}

impl UnderstoodTable {
    /// One line for people: `bench.csv: 45 points; P1 → pressure (kPa), …`.
    pub fn line(&self) -> String {
        format!("{}: {}", self.data, self.table.line())
    }
}

/// Says of all fields of a schema to which group they belong in a form or a help text.
pub(crate) struct InGroup(pub &'static str);

impl Transform for InGroup {
    fn transform(&mut self, schema: &mut Schema) {
        let fields = schema.get_mut("properties").and_then(Value::as_object_mut);
        for field in fields
            .into_iter()
            .flat_map(|fields| fields.values_mut())
            .filter_map(Value::as_object_mut)
        {
            field.insert("x-group".into(), self.0.into());
        }
    }
}

/// Which model answers: `fe` unless another one is named.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(transform = InGroup("model"))]
pub struct ModelFields {
    /// Name of the model, or of one of the formulas.
    pub model: Option<String>,
    /// Files of fitted formulas, which are models by the names of their files.
    pub formulas: Vec<TextFile>,
    /// The mesh of finite elements.
    #[serde(flatten)]
    pub mesh: MeshFields,
}

/// The mesh of finite elements.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(transform = InGroup("model"))]
pub struct MeshFields {
    /// Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a
    /// grading towards the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12),
    /// through x around (2x12), through x around x along (2x12x39), with :quadratic or :circle
    /// behind.
    pub mesh: Option<String>,
    /// Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
    #[serde(rename = "match")]
    pub keep: Match,
    /// Terminal of `fe3d` that is a body; without it a rigid plane.
    pub terminal: Option<Plug>,
}

/// How a model is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(transform = InGroup("model"))]
pub struct AskFields {
    /// Compute outside the model's range too, with a warning.
    pub extrapolate: bool,
    /// Give the negative force, not slack, where the muscle would have to push.
    pub two_sided: bool,
    /// Branch of the friction hysteresis: contraction to lift, elongation to lower. The friction is
    /// that of the muscle, or else estimated.
    pub direction: Direction,
}
