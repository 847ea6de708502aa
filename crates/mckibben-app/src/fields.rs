//! Fields that requests share.

pub use crate::muscle_fields::{Measures, MuscleFields};
use crate::{
    Problem, Result,
    flags::{self, Args},
    print::Page,
};
pub use mckibben_core::muscle::{BraidStiffness as Stiffness, Direction, measures::MeasureValues};
use mckibben_core::{joined, muscle::file::FileError};
use mckibben_fem::three_dimensional::{Match, Plug};
use mckibben_io::table::TableError;
pub use mckibben_io::table::{Columns, Understood, UnderstoodColumn};
use schemars::JsonSchema;
use serde::{
    Deserialize, Deserializer, Serialize,
    de::{self, MapAccess, Visitor, value::MapAccessDeserializer},
};
use std::{fmt, path::Path};

/// A file that a front end read, or that its user dropped in.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct TextFile {
    /// What to call it in messages: a path or a name.
    pub name: String,
    /// What is in it.
    pub text: String,
}

impl TextFile {
    /// What its text says; an error names the file.
    pub fn parsed<T>(&self, parse: fn(&str) -> Result<T, FileError>) -> Result<T> {
        parse(&self.text).map_err(|e| e.in_file(Path::new(&self.name)).into())
    }
}

/// A name, or a file in its place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "a name or an object with `name` and `text` is expected"
)]
pub enum NameOrFile {
    /// A name, such as `fe` or `dragon-skin-30`.
    Name(String),
    /// A file.
    File(TextFile),
}

impl NameOrFile {
    /// The name, or that of the file.
    pub fn name(&self) -> &str {
        match self {
            Self::Name(name) => name.trim(),
            Self::File(file) => &file.name,
        }
    }
}

impl From<&str> for NameOrFile {
    fn from(name: &str) -> Self {
        Self::Name(name.to_owned())
    }
}

/// A file, or a name alone, such as `lib:dmsp-20-300`.
pub fn name_or_file<'de, D: Deserializer<'de>>(from: D) -> Result<Option<TextFile>, D::Error> {
    let given = Option::<NameOrFile>::deserialize(from)?;
    Ok(given.map(|given| match given {
        NameOrFile::File(file) => file,
        NameOrFile::Name(name) => TextFile {
            name,
            text: String::new(),
        },
    }))
}

/// Measured tables, and what they do not state.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct DataFields {
    /// Measured points: a table of pressures, contractions (or shortenings, lengths, extensions) and
    /// forces, with units; may be repeated
    ///
    /// Of tests of a rubber: stretches, strains or extensions and stresses or forces.
    #[arg(long, value_name = "FILE.csv", value_parser = flags::table)]
    pub data: Vec<TextFile>,
    /// Quantity and unit of columns: QUANTITY="HEADING:UNIT",…
    ///
    /// Of columns that the program does not recognise (#2 is the second column), such as
    /// pressure="P1:kPa",contraction="x:mm".
    #[arg(long, value_name = "LIST", value_parser = Columns::parse)]
    pub columns: Option<Columns>,
    /// Constants of a whole table: QUANTITY=VALUE,…, such as pressure=3bar,branch=contraction
    ///
    /// Once for all tables, or once for each; {pressure}bar takes the number from the name of the
    /// file; branch=velocity cuts rows in time order into branches by the sign of their velocity.
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    pub set: Vec<String>,
}

impl DataFields {
    /// Reads each table.
    pub fn read<T>(
        &self,
        read: impl Fn(&str, Columns) -> Result<(T, Understood), TableError>,
    ) -> Result<Vec<(T, UnderstoodTable)>> {
        let used = [
            ("columns", self.columns.is_some()),
            ("set", !self.set.is_empty()),
        ];
        if self.data.is_empty() {
            Problem::refuse_unused(&used, "it belongs to tables, and no `data` are given")?;
        }
        let one = |(place, file): (usize, &TextFile)| {
            let columns = self.columns.clone().unwrap_or_default().with_constants(
                &self.set,
                (place, self.data.len()),
                &file.name,
            );
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
        joined(self.data.iter().map(|file| file.name.as_str()), ", ")
    }
}

/// What was understood of a table.
#[derive(Debug, Serialize, JsonSchema)]
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
        format!("{}: {}", self.data, self.table.line()).replace('\n', "\\n")
    }

    /// The lines of several.
    pub fn lines(tables: &[Self]) -> Page {
        let mut page = Page::default();
        page.lines(tables.iter().map(Self::line));
        page
    }
}

/// Which model answers: `fe` unless another one is named.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
#[command(next_help_heading = "Advanced")]
pub struct ModelFields {
    /// Force model [fe]
    ///
    /// A name (`mckibben parts list models`), or the JSON file of a fitted formula.
    #[arg(id = "model", long = "model", value_name = "NAME", value_parser = flags::model(), hide_possible_values = true)]
    pub name: Option<NameOrFile>,
    /// The mesh of finite elements.
    #[serde(flatten)]
    #[command(flatten)]
    pub mesh: MeshFields,
}

impl ModelFields {
    /// A model by its name alone.
    pub fn named(name: &str) -> Self {
        Self {
            name: Some(name.into()),
            ..Self::default()
        }
    }

    /// An object of fields, or a name alone.
    pub fn or_name<'de, D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        object_or(from, |name| ModelFields::named(&name))
    }
}

/// Reads an object of fields, or a text in its place.
pub fn object_or<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
    from: D,
    named: fn(String) -> T,
) -> Result<T, D::Error> {
    struct ObjectOr<T>(fn(String) -> T);

    impl<'de, T: Deserialize<'de>> Visitor<'de> for ObjectOr<T> {
        type Value = T;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a name or an object of fields")
        }

        fn visit_str<E: de::Error>(self, name: &str) -> Result<T, E> {
            Ok((self.0)(name.to_owned()))
        }

        fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<T, A::Error> {
            T::deserialize(MapAccessDeserializer::new(map))
        }
    }

    from.deserialize_any(ObjectOr(named))
}

/// The mesh of finite elements.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct MeshFields {
    /// Mesh of `fe` and `fe3d`
    ///
    /// Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading
    /// towards the terminal behind (2x8:2). Of `fe3d`: bricks around the quarter (12), through x
    /// around (2x12), through x around x along (2x12x39), with :quadratic behind.
    #[arg(long, value_name = "N or MxN:G", hide_short_help = true)]
    pub mesh: Option<String>,
    /// Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly
    #[serde(rename = "match")]
    #[arg(id = "match", long = "match", value_name = "WHAT", value_parser = flags::word::<Match>(), default_value = "length", hide_short_help = true)]
    pub keep: Match,
    /// Terminal of `fe3d` that is a body [none, a rigid plane]
    ///
    /// `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
    /// aluminium:20mm:3mm.
    #[arg(long, value_name = "WORD:MM:MM", value_parser = flags::terminal, hide_short_help = true)]
    pub terminal: Option<Plug>,
}

/// How a model is evaluated.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
#[command(next_help_heading = "Advanced")]
pub struct AskFields {
    /// Compute outside the model's range too, with a warning
    #[arg(long, hide_short_help = true)]
    pub extrapolate: bool,
    /// Give the negative force, not slack, where the muscle would have to push
    #[arg(long, hide_short_help = true)]
    pub two_sided: bool,
    /// Branch of the friction hysteresis: contraction to lift, elongation to lower [mean, or that
    /// of the muscle file's job]
    ///
    /// The friction is that of the muscle, or else estimated.
    #[arg(long = "branch", value_name = "BRANCH", value_parser = flags::word::<Direction>(), hide_short_help = true)]
    pub direction: Option<Direction>,
}
