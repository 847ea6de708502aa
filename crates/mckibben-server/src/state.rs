//! What all requests share.

use crate::config::Config;
use crate::jobs::Jobs;
use crate::room::Room;
use crate::work::Gate;
use std::sync::Arc;
use tokio::sync::watch;

/// What all requests share.
pub struct State {
    pub config: Arc<Config>,
    pub gate: Gate,
    pub jobs: Jobs,
    /// Memory for requests and answers.
    pub room: Room,
    pub stopping: watch::Receiver<bool>,
}
