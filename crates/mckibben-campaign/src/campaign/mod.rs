//! Plans, runs and stores.
