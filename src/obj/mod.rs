//! OBJ files (cargo feature `tobj`): a model as arrays ready for `glDrawElements`.
//!
//! Reading has three steps. `text` checks the file line by line and brings it into a plain form (what cannot be read is
//! noted with its line), `tobj` reads that and joins equal corners, `normals` computes what normals are missing. The
//! result is one set of vertex arrays with a list of indices for each run of faces of one material.
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

mod faces;
mod files;
mod material;
mod mtl;
mod normals;
mod notes;
mod source;
#[cfg(test)]
mod tests;
mod text;

pub use material::Material;

use crate::context::Context;
use crate::enums::*;
use crate::error::FileError;
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
    /// A colour for each vertex; white where the file has none.
    pub colors: Vec<[f32; 3]>,
    /// Whether any vertex got its colour from the file.
    pub has_colors: bool,
    /// What was subtracted from the file's positions, to be given to `glTranslated` where the model has to stand in its
    /// place. It is (0, 0, 0) unless the model is so far from the origin (over 16 times its size, as with surveyors'
    /// coordinates) that f32 would not keep its shape.
    pub offset: [f64; 3],
    /// The triangles, in the order of the file.
    pub groups: Vec<Group>,
    /// The materials that groups refer to.
    pub materials: Vec<Material>,
    /// What was not as it should be but did not stop the reading: a material file that is missing, faces left out. A note
    /// names the first line of its kind and how many there are.
    pub notes: Vec<String>,
}

/// Triangles of one material.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Group {
    /// The name of the first object or group of the file that is in it (its first 128 bytes); empty if there is none.
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
    /// A file that cannot be read, that is no OBJ file, or of which no face can be read; the message names the line.
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
        if let Some((_, what)) = OTHER_FILES.iter().find(|(start, _)| content.starts_with(start)) {
            return Err(format!("is not an OBJ file, but {what}"));
        }
        let mut notes = notes::Notes::default();
        let parsed = text::Parsed::new(&source::decode(content), &mut notes);
        if !parsed.is_obj {
            let empty = content.iter().all(u8::is_ascii_whitespace);
            return Err(if empty { "is empty" } else { "is not an OBJ file: no line of it is one" }.into());
        }
        let mut library = mtl::Library::default();
        for names in &parsed.libraries {
            library.load(folder, names);
        }
        let checked = parsed.plain(&mut notes, |name| library.find(name));
        let options =
            tobj::LoadOptions { triangulate: true, single_index: true, ignore_points: true, ignore_lines: true };
        let mut numbers = String::from("mtllib numbers\n");
        numbers.push_str(&checked.text);
        let count = library.materials.len();
        let (models, _) = tobj::load_obj_buf(&mut numbers.as_bytes(), &options, |_| Ok(numbered(count)))
            .map_err(|e| format!("is not a model that can be read: {e}"))?;
        let mut obj = Obj {
            has_tex_coords: checked.has_tex_coords,
            has_colors: checked.has_colors,
            offset: checked.offset,
            materials: library.materials,
            notes: notes.sentences(None).chain(library.notes).collect(),
            ..Obj::default()
        };
        for model in &models {
            obj.append(model, &checked.names)?;
        }
        if obj.groups.is_empty() {
            return Err(notes.first().unwrap_or("has no faces").to_owned());
        }
        normals::complete(&mut obj, &checked.smoothing);
        Ok(obj)
    }

    /// Appends the arrays of a part of the file.
    fn append(&mut self, model: &tobj::Model, names: &[String]) -> Result<(), String> {
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
        self.normals.resize(self.positions.len(), [0.0; 3]);
        self.colors.extend_from_slice(mesh.vertex_color.as_chunks::<3>().0);
        self.colors.resize(self.positions.len(), [1.0; 3]);
        let material = mesh.material_id.filter(|&m| m < self.materials.len());
        if self.groups.last().is_none_or(|last| last.material != material) {
            let name = model.name.parse().ok().and_then(|number: usize| names.get(number)).cloned().unwrap_or_default();
            self.groups.push(Group { name, material, indices: Vec::new() });
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

    /// Draws all triangles with positions, normals and texture coordinates, and with colours if the file has some (they
    /// count under lighting where `GL_COLOR_MATERIAL` is enabled).
    #[track_caller]
    pub fn draw(&self, cx: &mut Context) {
        self.draw_with(cx, |_, _| {});
    }

    /// Draws all triangles; `before` is called before each group with its material, to set it or to bind a texture.
    /// Texture coordinates go to the texture unit that is active on the client side. The client state stays.
    #[track_caller]
    pub fn draw_with(&self, cx: &mut Context, mut before: impl FnMut(&mut Context, Option<&Material>)) {
        self.draw_where(cx, |cx, material| {
            before(cx, material);
            true
        });
    }

    /// Draws the groups for which `before` answers `true` after it has set what they need, as `draw_with` draws all: for
    /// programs that draw what is opaque first and blend the rest over it.
    #[track_caller]
    pub fn draw_where(&self, cx: &mut Context, mut before: impl FnMut(&mut Context, Option<&Material>) -> bool) {
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
        if self.has_colors {
            cx.enable_client_state(GL_COLOR_ARRAY);
            cx.color_pointer(3, GL_FLOAT, 0, &self.colors);
        }
        cx.vertex_pointer(3, GL_FLOAT, 0, &self.positions);
        cx.normal_pointer(GL_FLOAT, 0, &self.normals);
        cx.tex_coord_pointer(2, GL_FLOAT, 0, &self.tex_coords);
        for group in &self.groups {
            if !before(cx, group.material.and_then(|m| self.materials.get(m))) {
                continue;
            }
            // A count beyond GLsizei goes in pieces of whole triangles.
            for part in group.indices.chunks(3 << 28) {
                cx.draw_elements(GL_TRIANGLES, part.len() as i32, GL_UNSIGNED_INT, part);
            }
        }
        cx.pop_client_attrib();
    }
}

/// What is given as a model most often but is none, by how it begins.
const OTHER_FILES: [(&[u8], &str); 10] = [
    (b"\x89PNG", "a PNG image"),
    (b"\xff\xd8\xff", "a JPEG image"),
    (b"GIF8", "a GIF image"),
    (b"BM", "a BMP image"),
    (b"glTF", "a glTF model; export it as OBJ"),
    (b"ply\n", "a PLY model; export it as OBJ"),
    (b"ply\r", "a PLY model; export it as OBJ"),
    (b"solid ", "an STL model; export it as OBJ"),
    (b"Kaydara FBX", "an FBX model; export it as OBJ"),
    (b"PK\x03\x04", "a ZIP archive; unpack it first"),
];

/// Materials named by their numbers from 1 on, as the plain form has them.
fn numbered(count: usize) -> (Vec<tobj::Material>, std::collections::HashMap<String, usize>) {
    (vec![tobj::Material::default(); count], (0..count).map(|i| ((i + 1).to_string(), i)).collect())
}
