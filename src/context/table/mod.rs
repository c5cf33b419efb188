//! The one table of commands (OpenGL 1.5, all chapters). Each command of GL 1.0 to 1.5 is one row in a chapter file, and
//! everything that a command needs outside the engine is made from its row: the method of [`Context`](super::Context),
//! the safe C-named function in `fixedgl::c`, the exported C function, its entry in display lists and in the trace.
//!
//! A chapter file holds rows and nothing else, so that it needs no other file; `chapters.rs` lists them. `ops.rs` makes of the rows what a display
//! list can hold, `methods.rs` the methods of [`Context`](super::Context).
//!
//! # Sections of a chapter
//! - `title`: the heading of the chapter's methods in the documentation.
//! - `canonical`: commands in the one form that the engine knows, without a door of their own.
//! - `commands`: commands that have only one form; the row is the canonical command and the door.
//! - `forms`: typed doors (`=>` says which canonical command with which arguments), grouped in families by a sentence.
//! - `context`: commands that the context carries out itself, in `context_commands.rs`.
//! - `now`: commands that are carried out at once, even while a display list is open.
//! - `queries` and `answers`: typed questions and the engine's one answer to each.
//! - `manual`: rows whose doors are written by hand, because C's pointers have no equivalent.
//!
//! A row is `class glName | glAliasARB snake_name(argument: kind, ...) -> result`. Classes: `begin` may stand between Begin
//! and End and is recorded in lists; `list` is recorded only; `proxy` is a `list` command that is carried out at once when
//! its first argument is a proxy target; `client` is one that is carried out at once when its first argument is a vertex array
//! (client state); `now` is never recorded.
//!
//! # Kinds of arguments (see `arg_kinds.rs`)
//! `enum`, `bits`, `uint`, `size` and Rust's scalars (doors take what C would convert to them); `[f32; 4]` a vector of
//! fixed length; `(slice u32: count(n))` and `(out u32: count(n))` with a count from `param_counts.rs`, `(upto f32:
//! light(pname))` the same where the engine checks how many there are, after the arguments that are an error of their own; `(rect [w, h],
//! format, type)` pixels under the unpack state and `(rect_out ..)` under the pack state; `(bytes n)`; `array` a vertex
//! array; `(indices count, type)`; `{T}`, `params` and `matrix` in canonical rows only.
//!
//! # What the engine implements
//! Inherent methods of `Engine` named as the rows of `canonical`, `commands`, `now` and `answers`, `&mut self`, `pub(crate)`,
//! returning `()`, a value, or an [`Outcome`](crate::error::Outcome) of it. A row
//! whose method is not there does not compile. The canonical ones:
//! ```text
//! vertex([f32;4])  color([f32;4])  secondary_color([f32;4])  normal([f32;3])  tex_coord([f32;4])
//! multi_tex_coord(target: u32, [f32;4])  fog_coord(f32)  index(f32)  edge_flag(bool)
//! raster_pos([f32;4])  window_pos([f32;3])  rect([f32;4]: x1 y1 x2 y2)  begin(mode)  end()
//! load_matrix(&[f64;16])  mult_matrix(&[f64;16])  rotate(angle, x, y, z)  scale(x, y, z)  translate(x, y, z)  (f64)
//! frustum/ortho(6 x f64)  depth_range(f64, f64)  clip_plane(plane, &[f64;4])
//! tex_gen(coord, pname, &Params)  light(light, pname, &Params)  light_model(pname, &Params)  fog(pname, &Params)
//! material(face, pname, &Params)  point_parameter(pname, &Params)  tex_parameter(target, pname, &Params)
//! tex_env(target, pname, &Params)  pixel_transfer(pname, &Params)  pixel_map(map, &[f32])  pixel_storei(pname, i32)  pixel_storef(pname, f32)
//! map1(target, u1, u2, stride, order, &[f64])  map2(..)  map_grid1(un, u1, u2)  map_grid2(..)  eval_coord1(f64)
//! eval_coord2(f64, f64)  color_table_parameter/convolution_parameter(target, pname, &Params)
//! tex_image_2d(target, level, internal_format: i32, width, height, border, format, type, &Pixels)   and its sisters
//! compressed_tex_image_2d(target, level, internal_format: u32, width, height, border, image_size, &Pixels)   ...
//! read_pixels(x, y, width, height, format, type, &mut [u8])  get_tex_image(target, level, format, type, &mut [u8])
//! vertex_pointer(size, type, stride, ArrayData)  ...  draw_arrays(mode, first, count)  array_element(i)
//! draw_elements(mode, count, type, &Indices)  draw_range_elements(mode, start, end, count, type, &Indices)
//! multi_draw_arrays(mode, &[i32], &[i32])  multi_draw_elements(mode, &[i32], type, &[Indices])
//! gen_textures(n, &mut [u32])  delete_textures(n, &[u32])  are_textures_resident(n, &[u32], &mut [u8]) -> bool
//! get(pname) -> Outcome<Values>  get_light(light, pname)  get_material  get_tex_env  get_tex_gen  get_tex_parameter
//! get_tex_level_parameter(target, level, pname)  get_clip_plane_values(plane)  get_pixel_map(map)  get_map(target, query)
//! get_query(target, pname)  get_query_object(id, pname)  get_buffer_parameter  get_buffer_pointer  get_pointer  -> Values
//! render_mode(mode) -> Outcome<i32>  feedback_buffer(size, type)  select_buffer(size)  feedback_values() -> &[f32]
//! select_values() -> &[u32]  map_buffer(target, access) -> Outcome<&mut [u8]>  unmap_buffer(target) -> Outcome<bool>
//! ```
//! `Params` (in `params.rs`) knows the form that was called; `Values` (in `values.rs`) is converted to the type that asked.

pub(crate) mod arg_kinds;
pub(crate) mod arrays;
pub(crate) mod chapters;
pub(crate) mod evaluators;
#[cfg(test)]
mod extensions;
pub(crate) mod fragment;
pub(crate) mod generate;
pub(crate) mod get;
pub(crate) mod imaging;
pub(crate) mod lighting;
pub(crate) mod lists;
pub(crate) mod methods;
pub(crate) mod ops;
pub(crate) mod pixels;
pub(crate) mod raster;
#[cfg(test)]
pub(crate) mod rows;
#[cfg(test)]
mod tests;
pub(crate) mod texture;
pub(crate) mod transform;
#[cfg(test)]
mod versions;
pub(crate) mod vertex;

/// The way of every canonical command to the engine: one associated function each, made by the chapters.
pub(crate) struct Dispatch;

/// The answers to the typed queries before they take the type that was asked for: one associated function each.
pub(crate) struct Query;
