//! Any answer as a page: rows, then tables, field by field.

use super::{
    Amount, Column, Page, Rows,
    field::{HEADING, ROW, label, named},
    schema::{self, items, properties, variants},
};
use crate::{Scale, Units, words::in_a_row};
use mckibben_core::joined;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::{Map, Value, to_value};
use std::iter;

/// Fields that no page has: figures and files; warnings stand before or behind it.
const APART: [&str; 4] = ["figure", "figures", "files", "warnings"];
/// Values of a row, and letters of an object in a row, at most.
const IN_A_ROW: usize = 10;
const ON_A_LINE: usize = 150;

type Object = Map<String, Value>;

impl Page {
    /// An answer by its schema, without some of its fields.
    pub fn of<T: Serialize + JsonSchema>(answer: &T, u: &Units, without: &[&str]) -> Self {
        let mut page = Self::default();
        let root = &schema::of::<T>();
        let walk = Walk { root, u, without };
        if let Ok(Value::Object(object)) = to_value(answer) {
            walk.object(&mut page, root, &object);
        }
        page
    }

    /// A list as a table with these fields as columns.
    pub fn list<T: Serialize + JsonSchema>(
        &mut self,
        heading: &str,
        list: &[T],
        u: &Units,
        only: &[&str],
    ) {
        let root = &schema::of::<T>();
        let walk = Walk {
            root,
            u,
            without: &[],
        };
        let rows = list.iter().filter_map(|row| match to_value(row).ok()? {
            Value::Object(row) => Some(row),
            _ => None,
        });
        let mut columns = walk.columns(root, &rows.collect::<Vec<_>>());
        let place = |c: &Amounts| only.iter().position(|name| *name == c.name);
        columns.retain(|c| place(c).is_some());
        columns.sort_by_key(place);
        self.columns(heading, columns);
    }

    fn columns(&mut self, heading: &str, columns: Vec<Amounts>) {
        let is_none = |amount: &Amount| matches!(amount, Amount::Words(count) if count == "0");
        let columns: Vec<Column> = columns
            .into_iter()
            .filter(|c| !c.amounts.iter().all(is_none))
            .filter_map(|c| Column::of(&c.label, &c.scale, &c.amounts))
            .collect();
        if !columns.is_empty() {
            if heading.is_empty() {
                self.gap();
            } else {
                self.paragraph(heading);
            }
            self.blocks.push(super::Block::Table(columns));
        }
    }
}

/// The values of a column.
struct Amounts {
    name: String,
    label: String,
    scale: Scale,
    amounts: Vec<Amount>,
}

/// A field of an object: its value and ±, its schema, its unit, and its name in words.
struct Field<'a> {
    name: &'a str,
    value: &'a Value,
    half: Option<f64>,
    node: &'a Value,
    scale: Scale,
    words: String,
}

impl Field<'_> {
    fn label(&self, most: usize) -> String {
        label(about(self.node), &self.words, most)
    }
}

struct Walk<'a> {
    root: &'a Value,
    u: &'a Units,
    without: &'a [&'a str],
}

impl Walk<'_> {
    /// What an object has to show, each number with its ±, the field behind it.
    fn fields<'a>(&'a self, node: &'a Value, object: &'a Object) -> Vec<Field<'a>> {
        let known = Vec::from_iter(properties(self.root, node));
        let mut out: Vec<Field<'a>> = vec![];
        for (name, value) in object {
            let is_half = name.starts_with("uncertainty") || name.ends_with("standard_error");
            let last = out.iter_mut().rev().find(|field| field.name != "unit");
            match (last, value.as_f64()) {
                (Some(last), Some(half)) if is_half && last.value.is_number() => {
                    last.half = Some(half).filter(|half| *half > 0.0);
                }
                _ if self.is_apart(name, value) => {}
                _ => {
                    let node = self.node_of(name, value, &known);
                    let (scale, words) = named(name, about(node), self.u);
                    out.push(Field {
                        name,
                        value,
                        half: None,
                        node,
                        scale,
                        words,
                    });
                }
            }
        }
        out
    }

    /// The schema of a field: of several that which knows most of its value.
    fn node_of<'a>(&self, name: &str, value: &Value, known: &[(&String, &'a Value)]) -> &'a Value {
        let nodes = known.iter().rev().filter(|field| field.0 == name);
        let has = |field: &&(&String, &Value)| {
            properties(self.root, field.1)
                .filter(|(name, _)| value.get(name).is_some())
                .count()
        };
        nodes.max_by_key(has).map_or(&Value::Null, |field| field.1)
    }

    fn is_apart(&self, name: &str, value: &Value) -> bool {
        APART.contains(&name)
            || self.without.contains(&name)
            || match value {
                Value::Null => true,
                Value::String(text) => text.is_empty() || text.contains('\n'),
                // Warnings come before the page.
                Value::Array(list) => {
                    list.is_empty() || (name == "warnings" && list[0].is_string())
                }
                Value::Object(object) => object.is_empty(),
                _ => false,
            }
    }

    fn object(&self, page: &mut Page, node: &Value, object: &Object) {
        let mut rows = Rows::default();
        let mut parts = vec![];
        for field in self.fields(node, object) {
            match self.text(&field) {
                Some(text) => rows = rows.text(&field.label(ROW), text),
                None => parts.push(field),
            }
        }
        page.rows(rows);
        for field in parts {
            self.part(page, &field);
        }
    }

    /// What is longer than a row.
    fn part(&self, page: &mut Page, field: &Field<'_>) {
        let heading = &field.label(2 * ROW);
        match field.value {
            Value::Array(list) => {
                let rows = list.iter().filter_map(Value::as_object).cloned();
                self.table(
                    page,
                    heading,
                    items(self.root, field.node).unwrap_or(&Value::Null),
                    &rows.collect::<Vec<_>>(),
                );
            }
            Value::Object(object) if is_map(self.root, field.node) => {
                let rows = object.iter().filter_map(|(name, value)| {
                    Some(
                        iter::once((field.name.to_owned(), name.as_str().into()))
                            .chain(value.as_object()?.clone())
                            .collect(),
                    )
                });
                let of = variants(self.root, field.node)
                    .iter()
                    .find_map(|node| node.get("additionalProperties"));
                self.table(
                    page,
                    heading,
                    of.unwrap_or(&Value::Null),
                    &rows.collect::<Vec<_>>(),
                );
            }
            Value::Object(object) => {
                page.paragraph(heading);
                self.object(page, field.node, object);
            }
            _ => {}
        }
    }

    /// A table of rows, and one of each list in them, with the first text of the row.
    fn table(&self, page: &mut Page, heading: &str, node: &Value, rows: &[Object]) {
        page.columns(heading, self.columns(node, rows));
        let mut lists = Object::new();
        for row in rows {
            let fields = self.fields(node, row);
            let title = fields
                .iter()
                .find(|field| field.value.is_string())
                .map(|field| (field.name.to_owned(), field.value.clone()));
            for field in &fields {
                let titled = field
                    .value
                    .as_array()
                    .into_iter()
                    .flatten()
                    .filter_map(Value::as_object)
                    .map(|object| {
                        Value::from_iter(title.clone().into_iter().chain(object.clone()))
                    });
                let list = lists.entry(field.name);
                if let Value::Array(list) = list.or_insert_with(|| Value::Array(vec![])) {
                    list.extend(titled);
                }
            }
        }
        for field in self.fields(node, &lists) {
            self.part(page, &field);
        }
    }

    fn columns(&self, node: &Value, rows: &[Object]) -> Vec<Amounts> {
        let mut columns = vec![];
        for (i, row) in rows.iter().enumerate() {
            self.cells(i, node, row, &mut columns);
        }
        for column in &mut columns {
            column.amounts.resize_with(rows.len(), || Amount::Nothing);
        }
        columns
    }

    /// The cells of a row; those of objects in it are beside them.
    fn cells(&self, i: usize, node: &Value, row: &Object, columns: &mut Vec<Amounts>) {
        for field in self.fields(node, row) {
            let amount = match field.value {
                Value::Object(inner) if !is_map(self.root, field.node) => {
                    self.cells(i, field.node, inner, columns);
                    continue;
                }
                Value::Array(_) | Value::Object(_) => match self.text(&field) {
                    Some(text) => text.into(),
                    None => continue,
                },
                value => self.amount(value, field.half, &field.scale),
            };
            let at = columns
                .iter()
                .position(|c| c.name == field.name)
                .unwrap_or_else(|| {
                    columns.push(Amounts {
                        name: field.name.into(),
                        label: field.label(HEADING),
                        scale: field.scale,
                        amounts: vec![],
                    });
                    columns.len() - 1
                });
            columns[at].amounts.resize_with(i, || Amount::Nothing);
            columns[at].amounts.push(amount);
        }
    }

    /// A value in a row.
    fn text(&self, field: &Field<'_>) -> Option<String> {
        let scale = &field.scale;
        match field.value {
            Value::Array(list) if list.len() <= IN_A_ROW => {
                let bare = |value: &Value| match value {
                    Value::Array(_) | Value::Object(_) => None,
                    _ => Some(
                        self.amount(value, None, scale)
                            .bare(scale)
                            .unwrap_or("–".into()),
                    ),
                };
                let texts = list.iter().map(bare).collect::<Option<Vec<_>>>()?;
                let is_range = variants(self.root, field.node)
                    .iter()
                    .any(|node| node.get("prefixItems").is_some());
                let texts = joined(texts, if is_range { " to " } else { ", " });
                Some(if list[0].is_number() {
                    scale.with_unit(texts)
                } else {
                    texts
                })
            }
            Value::Object(object) => {
                let fields = self.fields(field.node, object);
                let one = |field: &Field<'_>| {
                    let text = (!field.value.is_object()).then(|| self.text(field))??;
                    Some(format!("{} {text}", field.label(HEADING)))
                };
                let texts: Option<Vec<String>> = fields.iter().map(one).collect();
                texts.map(in_a_row).filter(|text| text.len() <= ON_A_LINE)
            }
            Value::Array(_) => None,
            value => self.amount(value, field.half, scale).text(scale),
        }
    }

    fn amount(&self, value: &Value, half: Option<f64>, scale: &Scale) -> Amount {
        match value {
            Value::Number(count) if !count.is_f64() && ["", "%"].contains(&&*scale.name) => {
                count.to_string().into()
            }
            Value::Bool(is) => (*is).into(),
            Value::String(text) => self.u.sentence(text).into(),
            value => (value.as_f64(), half).into(),
        }
    }
}

fn about(node: &Value) -> &str {
    node["description"].as_str().unwrap_or_default()
}

/// Whether the keys of an object are values, such as names of constants.
fn is_map(root: &Value, node: &Value) -> bool {
    properties(root, node).next().is_none()
}
