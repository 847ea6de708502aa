//! Memory that a model uses and changes while it computes an answer.

use crate::muscle::{EndState, Muscle};
use std::{any::Any, fmt, sync::Arc};

/// Which model a workspace's content belongs to. Copies of a model share it.
#[derive(Debug, Clone, Default)]
pub struct ModelId(Arc<()>);

impl ModelId {
    /// One that no other model has.
    pub fn new() -> Self {
        Self::default()
    }
}

impl PartialEq for ModelId {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// Memory in which a model works: states near which it looks for the next one, factorisations,
/// counts.
///
/// A model is immutable and may be shared by threads; each thread, and each curve, holds a
/// workspace of its own. It makes neighbouring questions cheap and never changes what is answered.
/// One workspace serves one model at a time: used with another model it begins anew.
///
/// ```
/// use mckibben_core::model::{ForceModel, ModelKind, Workspace};
/// use mckibben_core::muscle::Muscle;
///
/// let model = ModelKind::Universal.build(&Muscle::prototype())?;
/// std::thread::scope(|threads| {
///     for contraction in [0.0, 0.1] {
///         let model = &model;
///         threads.spawn(move || model.force_n(&mut Workspace::new(), 0.2, contraction));
///     }
/// });
/// # Ok::<(), mckibben_core::model::ModelError>(())
/// ```
#[derive(Default)]
pub struct Workspace {
    content: Option<(ModelId, Box<dyn Any + Send + Sync>)>,
    /// The last state of the ends of a muscle that slip.
    last: Option<(ModelId, EndState)>,
    /// What was made once for the muscle of a model.
    of_muscle: Option<(Arc<Muscle>, Arc<dyn Any + Send + Sync>)>,
}

impl Workspace {
    /// An empty one.
    pub fn new() -> Self {
        Self::default()
    }

    /// The content that belongs to a model, made by `make` where this workspace has none of that
    /// model.
    #[doc(hidden)]
    pub fn try_state<T: Any + Send + Sync, E>(
        &mut self,
        id: &ModelId,
        make: impl FnOnce() -> Result<T, E>,
    ) -> Result<&mut T, E> {
        if self.get::<T>(id).is_none() {
            // What is not needed any more goes first: it may be large.
            self.content = None;
            self.content = Some((id.clone(), Box::new(make()?)));
        }
        let content = self
            .content
            .as_mut()
            .and_then(|(_, content)| content.downcast_mut());
        Ok(content.unwrap_or_else(|| unreachable!("the content was made or found just before")))
    }

    /// What is made once for a muscle.
    pub(crate) fn of_muscle<T: Any + Send + Sync>(
        &mut self,
        muscle: &Arc<Muscle>,
        make: impl FnOnce() -> T,
    ) -> Arc<T> {
        let known = self
            .of_muscle
            .as_ref()
            .filter(|(of, _)| Arc::ptr_eq(of, muscle));
        if let Some(known) = known.and_then(|(_, it)| Arc::clone(it).downcast().ok()) {
            return known;
        }
        let made = Arc::new(make());
        self.of_muscle = Some((Arc::clone(muscle), Arc::clone(&made) as _));
        made
    }

    /// The last state of a model's ends, where this workspace has one.
    pub(super) fn last_ends(&self, id: &ModelId) -> Option<&EndState> {
        self.last
            .as_ref()
            .filter(|(of, _)| of == id)
            .map(|(_, state)| state)
    }

    /// Keeps the last state of a model's ends beside the content of the model between them.
    pub(super) fn keep_ends(&mut self, id: &ModelId, state: EndState) {
        self.last = Some((id.clone(), state));
    }

    /// The content that belongs to a model, where this workspace has one.
    #[doc(hidden)]
    pub fn get<T: Any>(&self, id: &ModelId) -> Option<&T> {
        let (of, content) = self.content.as_ref()?;
        (of == id).then(|| content.downcast_ref::<T>()).flatten()
    }
}

/// An empty one: whoever takes a copy of a model begins anew.
impl Clone for Workspace {
    fn clone(&self) -> Self {
        Self::new()
    }
}

impl fmt::Debug for Workspace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Workspace")
            .field("of", &self.content.as_ref().map(|c| &c.0))
            .finish()
    }
}
