//! The texture objects of a context by name, as data (OpenGL 1.5, section 3.8.12). Name 0 of a target is an object like
//! any other, kept beside the named ones.

use crate::state::texture::{Target, TexParameters, TextureState};
use crate::texture::object::TextureObject;
use std::collections::HashMap;

/// All texture objects of a context.
#[derive(Debug)]
pub(crate) struct Textures {
    defaults: [TextureObject; 5],
    /// Names in use; `None` for a generated name that was not bound yet.
    pub(super) named: HashMap<u32, Option<TextureObject>>,
    next: u32,
    /// Mipmap levels that GENERATE_MIPMAP has built, for those who count.
    pub(crate) levels_built: u64,
}

impl Default for Textures {
    fn default() -> Self {
        Self { defaults: Target::ALL.map(TextureObject::new), named: HashMap::new(), next: 1, levels_built: 0 }
    }
}

impl Textures {
    /// The object that a name stands for on a target.
    pub(crate) fn object(&self, target: Target, name: u32) -> &TextureObject {
        let default = &self.defaults[target as usize];
        self.named.get(&name).and_then(Option::as_ref).filter(|object| object.target == target).unwrap_or(default)
    }

    /// The object that a name stands for on a target, to be changed.
    pub(crate) fn object_mut(&mut self, target: Target, name: u32) -> &mut TextureObject {
        let default = &mut self.defaults[target as usize];
        match self.named.get_mut(&name) {
            Some(Some(object)) if object.target == target => object,
            _ => default,
        }
    }

    /// Parameters of all bound textures, for PushAttrib.
    pub(crate) fn bound_parameters(&self, state: &TextureState, all: &mut Vec<(u32, Target, TexParameters)>) {
        let [first, ..] = &state.units;
        for (i, unit) in state.units.iter().enumerate() {
            for (target, texture) in Target::ALL.into_iter().zip(unit.bound) {
                // What most units have is what the first one has.
                let seen = i > 0 && texture == first.bound[target as usize];
                if !seen && !all.iter().any(|(n, t, _)| (*n, *t) == (texture, target)) {
                    all.push((texture, target, self.object(target, texture).parameters));
                }
            }
        }
    }

    /// Puts back what [`Self::bound_parameters`] saved, unless the texture was deleted since.
    pub(crate) fn restore_parameters(&mut self, texture: u32, target: Target, parameters: TexParameters) {
        if texture == 0 || self.exists(texture) {
            self.object_mut(target, texture).parameters = parameters;
        }
    }

    /// A binding that PopAttrib brought back may name a texture that was deleted since: it becomes 0.
    pub(crate) fn forget_deleted_bindings(&self, state: &mut TextureState) {
        for bound in state.units.iter_mut().flat_map(|unit| &mut unit.bound) {
            if *bound != 0 && !self.exists(*bound) {
                *bound = 0;
            }
        }
    }

    /// Whether a name is that of an object.
    pub(super) fn exists(&self, name: u32) -> bool {
        matches!(self.named.get(&name), Some(Some(_)))
    }

    /// A name that is not in use, which now is.
    pub(super) fn generate(&mut self) -> u32 {
        while self.next == 0 || self.named.contains_key(&self.next) {
            self.next = self.next.wrapping_add(1);
        }
        self.named.insert(self.next, None);
        self.next
    }
}
