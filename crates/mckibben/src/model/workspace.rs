//! What changes while a model answers.

use std::any::Any;
use std::fmt;
use std::sync::Arc;

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

/// Memory in which a model works: states near which it looks for the next one, factorisations, counts.
///
/// A model is immutable and may be shared by threads; each thread, and each curve, holds a workspace of its own. It makes
/// neighbouring questions cheap and never changes what is answered. One workspace serves one model at a time: used
/// with another model it begins anew.
///
/// ```
/// use mckibben::model::{ForceModel, ModelKind, Workspace};
/// use mckibben::muscle::Muscle;
///
/// let model = ModelKind::Universal.build(&Muscle::prototype())?;
/// std::thread::scope(|threads| {
///     for contraction in [0.0, 0.1] {
///         let model = &model;
///         threads.spawn(move || model.force_n(&mut Workspace::new(), 0.2, contraction));
///     }
/// });
/// # Ok::<(), mckibben::model::ModelError>(())
/// ```
#[derive(Default)]
pub struct Workspace {
    content: Option<(ModelId, Box<dyn Any + Send>)>,
}

impl Workspace {
    /// An empty one.
    pub fn new() -> Self {
        Self::default()
    }

    /// The content that belongs to a model, made by `make` where this workspace has none of that model.
    pub fn of<T: Any + Send>(&mut self, id: &ModelId, make: impl FnOnce() -> T) -> &mut T {
        let mine = matches!(&self.content, Some((of, content)) if of == id && content.is::<T>());
        if !mine {
            self.content = None;
        }
        let (_, content) = self.content.get_or_insert_with(|| (id.clone(), Box::new(make())));
        // The type was checked above: a model asks for one type only.
        match content.downcast_mut::<T>() {
            Some(content) => content,
            None => unreachable!("the content of a workspace has the type it was made with"),
        }
    }

    /// The content that belongs to a model, where this workspace has one.
    pub fn get<T: Any>(&self, id: &ModelId) -> Option<&T> {
        let (of, content) = self.content.as_ref()?;
        (of == id).then(|| content.downcast_ref::<T>()).flatten()
    }
}

impl fmt::Debug for Workspace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Workspace").field("of", &self.content.as_ref().map(|c| &c.0)).finish()
    }
}
