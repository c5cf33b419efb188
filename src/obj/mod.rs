//! OBJ files (cargo feature `tobj`): a model as arrays ready for `glDrawElements`.
//!
//! Reading has three steps. `text` checks the file line by line and completes it (so that an error can say in which
//! line it is), `tobj` makes triangles and joins equal corners, `normals` computes what normals are missing. The result
//! is one set of vertex arrays with a list of indices for each run of faces of one material.
//!
//! ```no_run
//! # fn main() -> Result<(), fixedgl::FileError> {
//! let mut cx = fixedgl::Context::new(640, 480);
//! let model = fixedgl::obj::Obj::open("teapot.obj")?;
//! model.draw_with(&mut cx, |cx, material| {
//!     if let Some(material) = material {
//!         material.apply(cx);
//!     }
//! });
//! # Ok(())
//! # }
//! ```

mod material;
mod normals;
#[cfg(test)]
mod tests;
mod text;

pub use material::Material;

use crate::context::Context;
use crate::enums::*;
use crate::error::FileError;
use std::cell::RefCell;
use std::path::Path;

/// A model: vertex arrays, groups of triangles, materials.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct Obj {
    /// A position for each vertex.
    pub positions: Vec<[f32; 3]>,
    /// A normal for each vertex: the file's, or computed if a corner of the file has none.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates for each vertex; (0, 0) where the file has none.
    pub tex_coords: Vec<[f32; 2]>,
    /// Whether any vertex got its texture coordinates from the file.
    pub has_tex_coords: bool,
    /// The triangles, in the order of the file.
    pub groups: Vec<Group>,
    /// The materials that groups refer to.
    pub materials: Vec<Material>,
    /// What was not as it should be but did not stop the reading: a material file that is missing, faces left out.
    pub notes: Vec<String>,
}

/// Triangles of one material.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Group {
    /// The name of the first object or group of the file that is in it.
    pub name: String,
    /// Which of the materials it has.
    pub material: Option<usize>,
    /// Three indices into the vertex arrays for each triangle.
    pub indices: Vec<u32>,
}

impl Obj {
    /// Reads an OBJ file and the material files that it names.
    ///
    /// # Errors
    /// A file that cannot be read, or that is no OBJ file; the message names the line.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, FileError> {
        let path = path.as_ref();
        let bytes = std::fs::read(path).map_err(|e| FileError::new(path, format!("cannot be read: {e}")))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::parse(&bytes, folder).map_err(|message| FileError::new(path, message))
    }

    /// Reads the content of an OBJ file; material files are looked for in `folder`.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    pub fn parse(content: &[u8], folder: &Path) -> Result<Self, String> {
        let checked = text::check(&String::from_utf8_lossy(content))?;
        let mut obj = Obj { has_tex_coords: checked.has_tex_coords, notes: checked.notes, ..Obj::default() };
        let options =
            tobj::LoadOptions { triangulate: true, single_index: true, ignore_points: true, ignore_lines: true };
        let library = RefCell::new(material::Library::default());
        let (models, materials) = tobj::load_obj_buf(&mut checked.text.as_bytes(), &options, |names| {
            library.borrow_mut().load(folder, names)
        })
        .map_err(|e| format!("is not a model that can be read: {e}"))?;
        let library = library.into_inner();
        obj.notes.extend(library.notes);
        for material in materials.unwrap_or_default() {
            let home = library.homes.get(&material.name).map_or(folder, |home| home.as_path());
            obj.materials.push(Material::new(&material, home));
        }
        for model in &models {
            obj.append(model)?;
        }
        if obj.groups.is_empty() {
            return Err("has no faces".into());
        }
        if !checked.has_normals {
            normals::compute(&mut obj);
        }
        Ok(obj)
    }

    /// Appends the arrays of a part of the file.
    fn append(&mut self, model: &tobj::Model) -> Result<(), String> {
        let mesh = &model.mesh;
        if mesh.indices.is_empty() {
            return Ok(());
        }
        let base =
            u32::try_from(self.positions.len()).map_err(|_| "has more vertices than 32 bits count".to_string())?;
        let positions = mesh.positions.as_chunks::<3>().0;
        let count = positions.len();
        self.positions.extend_from_slice(positions);
        // The checked text has texture coordinates and normals for every corner or for none.
        self.tex_coords.extend_from_slice(mesh.texcoords.as_chunks::<2>().0);
        self.tex_coords.resize(self.positions.len(), [0.0; 2]);
        self.normals.extend_from_slice(mesh.normals.as_chunks::<3>().0);
        self.normals.resize(self.positions.len(), [0.0, 0.0, 1.0]);
        let material = mesh.material_id.filter(|&m| m < self.materials.len());
        if self.groups.last().is_none_or(|last| last.material != material) {
            self.groups.push(Group { name: model.name.clone(), material, indices: Vec::new() });
        }
        if let Some(group) = self.groups.last_mut() {
            let triangles = mesh.indices.as_chunks::<3>().0.iter().filter(|t| t.iter().all(|&i| (i as usize) < count));
            group.indices.extend(triangles.flatten().map(|i| i.saturating_add(base)));
        }
        Ok(())
    }

    /// The number of triangles.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.groups.iter().map(|g| g.indices.len() / 3).sum()
    }

    /// The smallest and the largest coordinates.
    #[must_use]
    pub fn bounds(&self) -> ([f32; 3], [f32; 3]) {
        let first = self.positions.first().copied().unwrap_or_default();
        self.positions.iter().fold((first, first), |(mut low, mut high), p| {
            for i in 0..3 {
                low[i] = crate::num::min_f32(low[i], p[i]);
                high[i] = crate::num::max_f32(high[i], p[i]);
            }
            (low, high)
        })
    }

    /// The middle of the bounds, and the distance of the farthest vertex from it: what a camera needs.
    #[must_use]
    pub fn sphere(&self) -> ([f32; 3], f32) {
        let (low, high) = self.bounds();
        let middle: [f32; 3] = std::array::from_fn(|i| (low[i] * 0.5) + (high[i] * 0.5));
        let square = |p: &[f32; 3]| {
            let d: [f64; 3] = std::array::from_fn(|i| f64::from(p[i]) - f64::from(middle[i]));
            d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
        };
        (middle, self.positions.iter().map(square).fold(0.0f64, f64::max).sqrt() as f32)
    }

    /// Draws all triangles with positions, normals and texture coordinates.
    #[track_caller]
    pub fn draw(&self, cx: &mut Context) {
        self.draw_with(cx, |_, _| {});
    }

    /// Draws all triangles; `before` is called before each group with its material, to set it or to bind a texture.
    /// Texture coordinates go to the texture unit that is active on the client side. The client state stays.
    #[track_caller]
    pub fn draw_with(&self, cx: &mut Context, mut before: impl FnMut(&mut Context, Option<&Material>)) {
        cx.push_client_attrib(GL_CLIENT_VERTEX_ARRAY_BIT);
        cx.bind_buffer(GL_ARRAY_BUFFER, 0);
        cx.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        for array in [GL_EDGE_FLAG_ARRAY, GL_INDEX_ARRAY, GL_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY]
        {
            cx.disable_client_state(array);
        }
        for array in [GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY] {
            cx.enable_client_state(array);
        }
        cx.vertex_pointer(3, GL_FLOAT, 0, &self.positions);
        cx.normal_pointer(GL_FLOAT, 0, &self.normals);
        cx.tex_coord_pointer(2, GL_FLOAT, 0, &self.tex_coords);
        for group in &self.groups {
            before(cx, group.material.and_then(|m| self.materials.get(m)));
            // A count beyond GLsizei goes in pieces of whole triangles.
            for part in group.indices.chunks(3 << 28) {
                cx.draw_elements(GL_TRIANGLES, part.len() as i32, GL_UNSIGNED_INT, part);
            }
        }
        cx.pop_client_attrib();
    }
}
