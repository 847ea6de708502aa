//! Named rubbers.
/// x
#[derive(Debug, Clone)]
pub struct RubberEntry;
/// x
#[derive(Debug, Clone)]
pub struct UnknownRubber;
