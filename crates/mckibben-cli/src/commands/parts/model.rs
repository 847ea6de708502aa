//! Force models as text.

use crate::output::text::table;
use mckibben_app::{ModelDetails, ModelEntry};

pub(super) fn list(list: &[ModelEntry]) -> String {
    let row = |m: &ModelEntry| vec![m.name.into(), m.description.into()];
    table(&["model", ""], list.iter().map(row).collect())
}

pub(super) fn details(m: &ModelDetails) -> String {
    let head = format!("{}: {}\n", m.name, m.description);
    if let Some(needs) = &m.needs {
        return format!("{head}\n{needs}\n");
    }
    let parts: String = m.uncertainty_basis.split("; ").map(|part| format!("  - {part}\n")).collect();
    format!(
        "{head}\nSource: {}\n\nThe ± is a 95 % half-width against a measured muscle. Its parts:\n{parts}",
        m.source
    )
}
