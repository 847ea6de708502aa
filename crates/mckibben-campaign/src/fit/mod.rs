//! Formulas from tables.
