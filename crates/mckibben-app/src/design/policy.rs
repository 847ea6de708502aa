//! Which model ranks the muscles of a search, and which one decides in the end.

use crate::{MeshFields, Model, ModelFields, Result};
use mckibben_core::{
    model::{ForceModel, ModelError},
    muscle::Muscle,
};
use mckibben_design::{Build, Models, SearchedMuscles, near_the_box};

pub struct ModelPolicy {
    /// Where none was named: what searches the muscles that it is good for.
    quick: Option<(Model, SearchedMuscles)>,
    /// What searches all others, and decides.
    pub model: Model,
}

impl ModelPolicy {
    /// The policy of a request for pulls, or for pushes.
    pub fn choose(fields: &ModelFields, extends: bool) -> Result<Self> {
        let model = Model::choose(fields)?;
        if fields.name.is_some() {
            return Ok(Self { quick: None, model });
        }
        // `universal` was not fitted for muscles that extend.
        let (name, is_good): (&str, SearchedMuscles) = if extends {
            ("thick-wall", |_| true)
        } else {
            ("universal", near_the_box)
        };
        let quick = Model::named(name, &MeshFields::default())?;
        Ok(Self {
            quick: Some((quick, is_good)),
            model,
        })
    }

    /// Does something with the models of a search.
    pub fn with_models<T>(&self, work: impl FnOnce(Models<'_>) -> T) -> T {
        let look = |m: &Muscle| self.look(m);
        let decide = |m: &Muscle| self.model.bound(m);
        let settle = self
            .quick
            .as_ref()
            .map(|quick| (&decide as &Build<'_>, quick.1));
        work(Models {
            search: &look,
            settle,
        })
    }

    /// Name of the model that searches.
    pub fn searches(&self) -> &str {
        self.quick
            .as_ref()
            .map_or(&self.model, |quick| &quick.0)
            .name()
    }

    /// The model that searches, bound to a muscle.
    fn look(&self, muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
        match &self.quick {
            Some((quick, is_good)) if is_good(muscle) => quick.build(muscle),
            _ => self.model.bound(muscle),
        }
    }
}
