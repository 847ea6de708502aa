//! What the crate offers, by rustdoc's JSON of the workspace's crates: against docs/rust-api.txt, at most
//! 150 types, and no type in a signature that is not among them. `checks/api.sh` makes the JSON and runs it.
#![allow(clippy::unwrap_used, clippy::panic)]

use serde_json::Value;
use std::{
    collections::{BTreeMap, BTreeSet, HashMap},
    path::Path,
};

/// Types that may be offered.
const MOST_TYPES: usize = 150;
const STORED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/rust-api.txt");

/// A crate and the number of an item in its JSON.
type Key = (String, String);

struct Docs {
    crates: BTreeMap<String, Value>,
    /// By kind and the path at which it is defined.
    defined: HashMap<(String, String), Key>,
}

/// Its kind, and what there is of that kind.
fn inner(item: &Value) -> (&str, &Value) {
    let (kind, inner) = item["inner"].as_object().unwrap().iter().next().unwrap();
    (kind, inner)
}

fn number(id: &Value) -> Option<String> {
    id.as_u64().map(|id| id.to_string())
}

fn path_of(known: &Value) -> String {
    let names = known["path"].as_array().unwrap().iter();
    Vec::from_iter(names.map(|name| name.as_str().unwrap())).join("::")
}

fn is_type(kind: &str) -> bool {
    matches!(kind, "struct" | "enum" | "union" | "trait")
}

impl Docs {
    fn read(folder: &Path) -> Self {
        let mut docs = Self {
            crates: BTreeMap::new(),
            defined: HashMap::new(),
        };
        for file in std::fs::read_dir(folder).unwrap() {
            let file = file.unwrap().path();
            let name = file.file_stem().unwrap().to_str().unwrap().to_owned();
            if name.starts_with("mckibben") && file.extension().is_some_and(|end| end == "json") {
                let text = std::fs::read_to_string(&file).unwrap();
                docs.crates
                    .insert(name, serde_json::from_str(&text).unwrap());
            }
        }
        for (name, one) in &docs.crates {
            for (id, known) in one["paths"].as_object().unwrap() {
                if known["crate_id"] == 0 && one["index"].get(id).is_some() {
                    let kind = known["kind"].as_str().unwrap().to_owned();
                    docs.defined
                        .insert((kind, path_of(known)), (name.clone(), id.clone()));
                }
            }
        }
        docs
    }

    fn item(&self, (name, id): &Key) -> Option<&Value> {
        self.crates[name]["index"].get(id)
    }

    /// Where an item that a crate names is defined; none of what no crate of the workspace documents.
    fn key(&self, name: &str, id: &str) -> Option<Key> {
        let one = &self.crates[name];
        if one["index"]
            .get(id)
            .is_some_and(|item| item["crate_id"] == 0)
        {
            return Some((name.into(), id.into()));
        }
        let known = one["paths"].get(id)?;
        let kind = known["kind"].as_str().unwrap().to_owned();
        self.defined.get(&(kind, path_of(known))).cloned()
    }

    /// Everything public in a module, by its shortest name.
    fn walk(&self, module: &Key, path: &str, found: &mut BTreeMap<Key, String>) {
        let items = &inner(self.item(module).unwrap()).1["items"];
        for id in items.as_array().unwrap().iter().filter_map(number) {
            let here = (module.0.clone(), id);
            let Some(item) = self.item(&here) else {
                continue;
            };
            let (key, name) = match inner(item) {
                ("use", used) => {
                    let target = number(&used["id"]).and_then(|id| self.key(&module.0, &id));
                    let Some(target) = target else {
                        panic!("{path} offers {}, which is hidden", used["source"]);
                    };
                    assert_eq!(used["is_glob"], false, "{path}: {}", used["source"]);
                    (target, used["name"].as_str().unwrap())
                }
                _ if item["visibility"] == "public" => (here, item["name"].as_str().unwrap()),
                _ => continue,
            };
            let path = format!("{path}::{name}");
            if inner(self.item(&key).unwrap()).0 == "module" {
                self.walk(&key, &path, found);
            } else {
                let shortest = found.entry(key).or_insert_with(|| path.clone());
                if path.len() < shortest.len() {
                    *shortest = path;
                }
            }
        }
    }

    /// Fields, variants and functions of an item, by name.
    fn members(&self, key: &Key) -> Vec<(String, &Value)> {
        let (kind, of) = inner(self.item(key).unwrap());
        let items = |ids: &Value| {
            let ids = ids.as_array().into_iter().flatten().filter_map(number);
            Vec::from_iter(ids.filter_map(|id| self.item(&(key.0.clone(), id))))
        };
        let named = |item: &Value| item["name"].as_str().unwrap_or_default().to_owned();
        let fields = |kind: &Value| {
            let tuple = if kind["tuple"].is_array() {
                &kind["tuple"]
            } else {
                &kind["fields"]
            };
            items(if kind["plain"].is_object() {
                &kind["plain"]["fields"]
            } else {
                tuple
            })
        };
        let mut members = vec![];
        match kind {
            "struct" => {
                let public = fields(&of["kind"])
                    .into_iter()
                    .filter(|f| f["visibility"] == "public");
                members.extend(public.map(|field| (named(field), field)));
            }
            "enum" => {
                for variant in items(&of["variants"]) {
                    members.push((named(variant), variant));
                    let kind = &inner(variant).1["kind"];
                    let kind = if kind["struct"].is_object() {
                        &kind["struct"]
                    } else {
                        kind
                    };
                    let name = |field| format!("{}::{}", named(variant), named(field));
                    members.extend(fields(kind).into_iter().map(|field| (name(field), field)));
                }
            }
            "trait" => members.extend(items(&of["items"]).into_iter().map(|m| (named(m), m))),
            _ => {}
        }
        for block in items(&of["impls"]) {
            let block = inner(block).1;
            let own = block["trait"].is_null();
            let taken = items(&block["items"]).into_iter().filter(|item| {
                if own {
                    item["visibility"] == "public"
                } else {
                    inner(item).0 == "assoc_type"
                }
            });
            members.extend(taken.map(|item| {
                let of = block["trait"]["path"]
                    .as_str()
                    .map(|path| format!("<{path}>::"));
                (of.unwrap_or_default() + &named(item), item)
            }));
        }
        members
    }

    /// Types that a signature names, aliases taken apart.
    fn named_types(
        &self,
        name: &str,
        signature: &Value,
        found: &mut BTreeSet<String>,
        known: &BTreeMap<Key, String>,
    ) {
        match signature {
            Value::Array(list) => list
                .iter()
                .for_each(|v| self.named_types(name, v, found, known)),
            Value::Object(map) => {
                let path = map.get("resolved_path").or_else(|| map.get("trait"));
                if let Some(id) = path.and_then(|path| number(&path["id"])) {
                    let key = self.key(name, &id);
                    let alias = key.as_ref().map(|key| inner(self.item(key).unwrap()));
                    let defined = self.crates[name]["paths"].get(&id).map(path_of);
                    if let (Some(key), Some(("type_alias", alias))) = (&key, alias) {
                        self.named_types(&key.0, alias, found, known);
                    } else if defined
                        .as_ref()
                        .is_none_or(|path| path.starts_with("mckibben"))
                        && key.is_none_or(|key| !known.contains_key(&key))
                    {
                        found.insert(defined.unwrap_or_else(|| path.unwrap()["path"].to_string()));
                    }
                }
                map.values()
                    .for_each(|v| self.named_types(name, v, found, known));
            }
            _ => {}
        }
    }
}

#[test]
#[ignore = "needs rustdoc's JSON: checks/api.sh"]
fn the_public_api_is_the_one_that_is_stored() {
    let docs = Docs::read(Path::new(&std::env::var("MCKIBBEN_API").unwrap()));
    let root = (
        "mckibben".to_owned(),
        number(&docs.crates["mckibben"]["root"]).unwrap(),
    );
    let mut offered = BTreeMap::new();
    docs.walk(&root, "mckibben", &mut offered);
    let (mut lines, mut hidden, mut undocumented) = (BTreeSet::new(), vec![], vec![]);
    for (key, path) in &offered {
        let item = docs.item(key).unwrap();
        let kind = inner(item).0;
        lines.insert(format!("{path} ({kind})"));
        let own = (String::new(), item);
        let members = if is_type(kind) {
            docs.members(key)
        } else {
            vec![own]
        };
        for (name, member) in members {
            let mut types = BTreeSet::new();
            docs.named_types(&key.0, &member["inner"], &mut types, &offered);
            hidden.extend(types.into_iter().map(|of| format!("{path}::{name}: {of}")));
            if !name.is_empty() && !name.starts_with('<') {
                lines.insert(format!("{path}::{name}"));
            }
        }
        if item["docs"].is_null() {
            undocumented.push(path);
        }
    }
    let types = offered
        .keys()
        .filter(|key| is_type(inner(docs.item(key).unwrap()).0))
        .count();
    println!("{types} types, {} names", lines.len());
    assert!(types <= MOST_TYPES, "{types} types; at most {MOST_TYPES}");
    assert!(
        hidden.is_empty(),
        "signatures name types that are not offered: {hidden:#?}"
    );
    assert!(
        undocumented.is_empty(),
        "without documentation: {undocumented:?}"
    );
    let text = lines
        .into_iter()
        .map(|line| line + "\n")
        .collect::<String>();
    if std::env::var_os("MCKIBBEN_API_WRITE").is_some() {
        std::fs::write(STORED, text).unwrap();
        return;
    }
    let stored = std::fs::read_to_string(STORED).unwrap();
    let of = |text: &str| BTreeSet::from_iter(text.lines().map(str::to_owned));
    let (stored, now): (BTreeSet<_>, BTreeSet<_>) = (of(&stored), of(&text));
    let (gone, new) = (stored.difference(&now), now.difference(&stored));
    assert!(
        stored == now,
        "gone: {:#?}\nnew: {:#?}\n`checks/api.sh --write` writes docs/rust-api.txt",
        Vec::from_iter(gone),
        Vec::from_iter(new)
    );
}
