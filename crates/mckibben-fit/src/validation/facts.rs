//! What is known of something that was measured.

/// What is known of something that was measured.
#[derive(Debug, Clone, PartialEq, serde::Serialize, schemars::JsonSchema)]
#[schemars(rename = "MeasuredFacts")]
pub struct Facts {
    /// Name of its folder.
    pub name: String,
    /// Which muscle or rubber.
    pub title: String,
    /// Who measured it.
    pub source: String,
    /// Terms of use of the points.
    pub terms: String,
    /// What is known of it.
    pub known: String,
    /// What is not.
    pub unknown: String,
    /// The product, where one can buy it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub product: Option<String>,
}
