//! Memory for requests and answers: each takes what it needs when it needs it, and nothing by promise.

use crate::refusal::Refusal;
use axum::body::Bytes;
use std::sync::Arc;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

/// Bytes that may be held.
#[derive(Debug, Clone)]
pub struct Room(Arc<Semaphore>);

/// A share of them, given back when it is dropped.
#[derive(Debug)]
pub struct Held {
    room: Room,
    permit: Option<OwnedSemaphorePermit>,
}

/// Bytes that are held until the last copy of them is dropped.
struct HeldBytes {
    bytes: Vec<u8>,
    _held: Held,
}

impl AsRef<[u8]> for HeldBytes {
    fn as_ref(&self) -> &[u8] {
        &self.bytes
    }
}

impl Room {
    pub fn new(bytes: usize) -> Self {
        Self(Arc::new(Semaphore::new(bytes.min(Semaphore::MAX_PERMITS))))
    }

    /// A share of nothing yet.
    pub fn held(&self) -> Held {
        Held { room: self.clone(), permit: None }
    }

    /// An answer with its share.
    pub fn keep(&self, bytes: Vec<u8>) -> Result<Bytes, Refusal> {
        let mut held = self.held();
        held.grow(bytes.len())?;
        Ok(Bytes::from_owner(HeldBytes { bytes, _held: held }))
    }
}

impl Held {
    /// Takes so many bytes more.
    pub fn grow(&mut self, bytes: usize) -> Result<(), Refusal> {
        let more = u32::try_from(bytes).unwrap_or(u32::MAX);
        let more = Arc::clone(&self.room.0).try_acquire_many_owned(more);
        let more = more.map_err(|_| Refusal::busy("the server is busy: too much work at once"))?;
        match &mut self.permit {
            Some(permit) => permit.merge(more),
            permit => *permit = Some(more),
        }
        Ok(())
    }
}
