//! Work of the kinds that the scenes of the benchmark do not show: small and middle-sized triangles, short draws with
//! changes of state between them, solids, points, lines, pixels; and every combination of filter, environment, what
//! happens to a fragment, and shape that a row of a triangle may be drawn by.

use super::bench::stage::{Arrays, Stage, Tex};
use fixedgl::Context;
use fixedgl::enums::*;
use fixedgl::math::{cos, sin};

/// A piece of work: its name and what draws it into a fresh stage.
pub type Work = (&'static str, fn(&mut Stage));

/// All of it.
pub const WORK: &[Work] = &[
    ("long_rows_plain", |s| rows(s, None, Stage::strip)),
    ("long_rows_nearest", |s| rows(s, Some([GL_NEAREST, GL_NEAREST]), Stage::strip)),
    ("long_rows_linear", |s| rows(s, Some([GL_LINEAR, GL_LINEAR]), Stage::strip)),
    ("long_rows_mipmaps_nearest", |s| rows(s, Some([GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST]), Stage::strip)),
    ("long_rows_mipmaps_linear", |s| rows(s, Some([GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR]), Stage::strip)),
    ("long_rows_trilinear", |s| rows(s, Some([GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR]), Stage::strip)),
    ("long_rows_trilinear_of_nearest", |s| rows(s, Some([GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST]), Stage::strip)),
    ("short_rows_plain", |s| rows(s, None, Stage::wedge)),
    ("short_rows_nearest", |s| rows(s, Some([GL_NEAREST, GL_NEAREST]), Stage::wedge)),
    ("short_rows_linear", |s| rows(s, Some([GL_LINEAR, GL_LINEAR]), Stage::wedge)),
    ("short_rows_mipmaps_nearest", |s| rows(s, Some([GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST]), Stage::wedge)),
    ("short_rows_mipmaps_linear", |s| rows(s, Some([GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR]), Stage::wedge)),
    ("short_rows_trilinear", |s| rows(s, Some([GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR]), Stage::wedge)),
    ("two_units_in_rows", two_units),
    ("wraps_and_formats", wraps_and_formats),
    ("level_of_detail_on_a_step", own_size),
    ("cubes_by_vertex", |s| cubes(s, [true, true], false)),
    ("cubes_by_elements", |s| cubes(s, [true, true], true)),
    ("cubes_of_other_colours", |s| cubes(s, [false, true], false)),
    ("cubes_of_other_colours_by_elements", |s| cubes(s, [false, true], true)),
    ("attributes_pushed_and_popped", pushed),
    ("triangles_of_200_pixels", |s| scattered(s, 200.0, 120)),
    ("triangles_of_40_pixels", |s| scattered(s, 40.0, 500)),
    ("sprites_of_16_pixels", |s| sprites(s, 16.0, 200)),
    ("sprites_of_64_pixels", |s| sprites(s, 64.0, 30)),
    ("textured_spheres", |s| spheres(s, GL_LINEAR, false, 24)),
    ("textured_spheres_culled", |s| spheres(s, GL_LINEAR, true, 24)),
    ("trilinear_spheres", |s| spheres(s, GL_LINEAR_MIPMAP_LINEAR, true, 12)),
    ("nearest_spheres", |s| spheres(s, GL_NEAREST, true, 12)),
    ("lit_sphere_by_vertex", |s| lit(s, false)),
    ("lit_sphere_from_a_list", |s| lit(s, true)),
    ("light_mapped_room", room),
    ("terrain_in_strips", terrain),
    ("solid_texture_on_a_torus", solid_torus),
    ("smooth_points", |s| points(s, true)),
    ("points", |s| points(s, false)),
    ("smooth_lines", |s| lines(s, GL_LINE_SMOOTH)),
    ("lines", |s| lines(s, GL_DITHER)),
    ("stippled_lines", |s| lines(s, GL_LINE_STIPPLE)),
    ("wire_frame", wire),
    ("smooth_polygons", smooth_polygons),
    ("long_begin_end_of_strips", long_strips),
    ("stencil_and_shadow", mirror),
    ("pixels_to_and_fro", pixels),
    ("mipmaps_of_all_kinds", mipmaps),
];

/// A number in [0, 1) that an index stands for.
fn any(index: usize) -> f32 {
    let mut x = (index as u32).wrapping_mul(0x9E37_79B1) ^ 0x5BD1_E995;
    for factor in [0x7FEB_352D, 0x846C_A68B] {
        x = (x ^ (x >> 15)).wrapping_mul(factor);
    }
    ((x ^ (x >> 16)) >> 8) as f32 / 16_777_216.0
}

/// A colour for an index.
fn color(gl: &mut Context, index: usize, alpha: f32) {
    gl.color4f(any(index), any(index + 71), any(index + 913), alpha);
}

/// Cosine and sine of so many turns.
fn circle(turns: f32) -> [f32; 2] {
    let angle = f64::from(turns) * std::f64::consts::TAU;
    [cos(angle) as f32, sin(angle) as f32]
}

fn clear(s: &mut Stage) {
    s.gl.clear_color(0.1, 0.2, 0.3, 1.0);
    s.gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

/// A projection with the eye `back` from the middle, looking down.
fn eye(s: &mut Stage, back: f32, down: f32) {
    s.perspective(45.0, 0.5, 100.0);
    s.gl.translatef(0.0, 0.0, -back);
    s.gl.rotatef(down, 1.0, 0.0, 0.0);
    s.depth(GL_LESS);
}

fn light(s: &mut Stage) {
    for capability in [GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE] {
        s.gl.enable(capability);
    }
    s.gl.lightfv(GL_LIGHT0, GL_POSITION, &[4.0, 7.0, 9.0, 0.0]);
    s.gl.lightfv(GL_LIGHT0, GL_SPECULAR, &[1.0; 4]);
    s.gl.materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, &[0.6; 4]);
    s.gl.materialf(GL_FRONT_AND_BACK, GL_SHININESS, 30.0);
}

/// What a primitive is drawn with: a corner of it may be nearer than another.
#[derive(Clone, Copy)]
struct Shape {
    place: usize,
    smooth: bool,
    perspective: bool,
}

impl Stage {
    fn corner(&mut self, shape: Shape, corner: usize, [x, y]: [f32; 2], alpha: f32) {
        // In perspective the third and fourth corner are twice as far away, and seem to be at the same place.
        let w = if shape.perspective && corner >= 2 { 2.0 } else { 1.0 };
        let (scale, z) = (0.7 + 0.15 * (shape.place % 7) as f32, 0.9 - 1.8 * any(shape.place + corner % 2));
        if shape.smooth || corner == 0 {
            color(&mut self.gl, 4 * shape.place + corner, alpha);
        }
        for unit in 0..self.units as u32 {
            let [u, v] = [x * scale - y * 0.2, y * scale + x * 0.1].map(|texels| texels / 64.0);
            self.gl.multi_tex_coord2f(GL_TEXTURE0 + unit, u, v);
        }
        self.gl.vertex4f(x * w, y * w, z * w, w);
    }

    /// A quadrilateral as wide as the framebuffer, eight rows high.
    fn strip(&mut self, shape: Shape, alpha: f32) {
        let side = self.size as f32;
        let y = (8 * shape.place % self.size as usize) as f32;
        self.gl.begin(GL_QUADS);
        for (corner, at) in [[0.0f32, y], [side, y], [side, y + 8.0], [0.0, y + 8.0]].into_iter().enumerate() {
            self.corner(shape, corner, at, alpha);
        }
        self.gl.end();
    }

    /// Two triangles whose rows are up to 60 pixels long.
    fn wedge(&mut self, shape: Shape, alpha: f32) {
        let [x, y] = [0, 1].map(|i| (self.size as f32 - 60.0) * any(2 * shape.place + i));
        self.gl.begin(GL_TRIANGLE_STRIP);
        let corners = [[x, y], [x + 20.0, y + 2.5], [x + 3.0, y + 25.5], [x + 60.0, y + 22.0]];
        for (corner, at) in corners.into_iter().enumerate() {
            self.corner(shape, corner, at, alpha);
        }
        self.gl.end();
    }

    /// A lattice on a surface of which `at` says the points: u and v to position, normal and coordinate.
    fn surface(&mut self, cells: [usize; 2], at: fn([f32; 2]) -> [f32; 8]) {
        self.lattice(cells, |i, j| at([i as f32 / cells[0] as f32, j as f32 / cells[1] as f32]));
    }

    /// Its triangles, vertex by vertex.
    fn by_vertex(&mut self, mode: GLenum) {
        self.gl.begin(mode);
        for i in &self.indices {
            let [x, y, z, nx, ny, nz, u, v] = self.vertices[*i as usize];
            self.gl.tex_coord2f(u, v);
            self.gl.normal3f(nx, ny, nz);
            self.gl.vertex3f(x, y, z);
        }
        self.gl.end();
    }
}

fn sphere([u, v]: [f32; 2]) -> [f32; 8] {
    let ([c, s], [down, ring]) = (circle(u), circle(0.5 * v));
    let [x, y, z] = [ring * c, -down, -ring * s];
    [x, y, z, x, y, z, 2.0 * u, v]
}

fn ring([u, v]: [f32; 2]) -> [f32; 8] {
    let ([c, s], [out, up]) = (circle(u), circle(v));
    let r = 0.7 + 0.3 * out;
    [r * c, 0.3 * up, -r * s, out * c, up, -out * s, 6.0 * u, 2.0 * v]
}

fn hill([u, v]: [f32; 2]) -> [f32; 8] {
    let ([a, b], [c, d]) = (circle(1.5 * u), circle(1.2 * v));
    [2.0 * u - 1.0, 0.25 * b * c, 1.0 - 2.0 * v, -0.8 * a * c, 1.0, -0.6 * b * d, 4.0 * u, 4.0 * v]
}

/// Every environment, what may happen to a fragment, flat and smooth, in perspective and not, drawn over each other.
fn rows(s: &mut Stage, filter: Option<[GLenum; 2]>, draw: fn(&mut Stage, Shape, f32)) {
    clear(s);
    let mut place = 0;
    for alpha in [false, true] {
        if let Some([min, mag]) = filter {
            s.texture(Tex { size: 64, min, mag, alpha, ..Tex::default() });
        }
        for env in [GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD] {
            s.gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, env);
            for after in 0..9 {
                fate(&mut s.gl, after);
                for bits in 0..4 {
                    let shape = Shape { place, smooth: bits & 1 != 0, perspective: bits & 2 != 0 };
                    s.gl.shade_model(if shape.smooth { GL_SMOOTH } else { GL_FLAT });
                    draw(s, shape, if after == 3 { 0.5 } else { 1.0 });
                    place += 1;
                }
            }
        }
    }
    fate(&mut s.gl, 0);
}

/// What happens to a fragment: one of nine ways.
fn fate(gl: &mut Context, way: usize) {
    for capability in [GL_DEPTH_TEST, GL_BLEND, GL_ALPHA_TEST, GL_FOG, GL_SCISSOR_TEST] {
        gl.disable(capability);
    }
    gl.depth_mask(true);
    gl.color_mask(true, true, true, true);
    match way {
        0 => {}
        1 => (gl.enable(GL_DEPTH_TEST), gl.depth_func(GL_LEQUAL)).1,
        2 => (gl.enable(GL_DEPTH_TEST), gl.depth_func(GL_GREATER), gl.depth_mask(false)).2,
        3 => (gl.enable(GL_BLEND), gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)).1,
        4 => (gl.enable(GL_BLEND), gl.blend_func(GL_SRC_ALPHA, GL_ONE), gl.enable(GL_DEPTH_TEST)).2,
        5 => (gl.enable(GL_ALPHA_TEST), gl.alpha_func(GL_GREATER, 0.5), gl.enable(GL_DEPTH_TEST)).2,
        6 => (gl.enable(GL_FOG), gl.fogi(GL_FOG_MODE, GL_EXP2), gl.fogf(GL_FOG_DENSITY, 0.7)).2,
        7 => (gl.enable(GL_SCISSOR_TEST), gl.scissor(11, 3, 150, 170), gl.color_mask(true, false, true, true)).2,
        _ => (gl.enable(GL_DEPTH_TEST), gl.depth_func(GL_EQUAL)).1,
    }
}

/// Two units whose filters and environments differ, in long and short rows.
fn two_units(s: &mut Stage) {
    clear(s);
    s.depth(GL_LEQUAL);
    s.units = 2;
    let filters = [GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR];
    for (place, pair) in (0..64).zip((0..4).flat_map(|a| (0..4).map(move |b| [a, b])).cycle()) {
        for (unit, filter) in pair.into_iter().enumerate() {
            s.gl.active_texture(GL_TEXTURE0 + unit as u32);
            let mag = if filter == 0 { GL_NEAREST } else { GL_LINEAR };
            s.texture(Tex { size: 64 >> unit, min: filters[filter], mag, alpha: place & 16 != 0, ..Tex::default() });
            let env = if place & (32 >> unit) != 0 { GL_MODULATE } else { [GL_REPLACE, GL_ADD][unit] };
            s.gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, env);
        }
        for perspective in [false, true] {
            s.strip(Shape { place: 2 * place, smooth: true, perspective }, 1.0);
            s.wedge(Shape { place: 2 * place + 1, smooth: true, perspective }, 1.0);
        }
    }
}

/// Every way to wrap, on sizes that are and are not powers of two, in every format of a texture.
fn wraps_and_formats(s: &mut Stage) {
    clear(s);
    let formats = [GL_RGB8, GL_ALPHA8, GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8, GL_INTENSITY8, GL_RGBA4, GL_RGB10_A2];
    let wraps = [GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT];
    for (place, format) in (0..70).zip(formats.into_iter().cycle()) {
        let filter = [GL_NEAREST, GL_LINEAR][place & 1];
        s.texture(Tex {
            size: 32,
            min: filter,
            mag: filter,
            wrap: wraps[place / 2 % 5],
            alpha: true,
            ..Tex::default()
        });
        let texels = super::bench::stage::noise(32, true);
        s.gl.tex_image_2d(GL_TEXTURE_2D, 0, format, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
        s.gl.tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[0.9, 0.1, 0.5, 0.7]);
        let shape = Shape { place, smooth: place % 3 == 0, perspective: place % 4 == 1 };
        s.strip(shape, 1.0);
        s.wedge(shape, 1.0);
    }
}

/// An image in its own size, halved, and a little more and less than that: the level of detail is on a step.
fn own_size(s: &mut Stage) {
    clear(s);
    for (place, min) in
        [GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR].into_iter().enumerate()
    {
        s.texture(Tex { size: 64, min, ..Tex::default() });
        for (i, texels) in [1.0, 2.0, 0.999, 1.001, 2.001, 1.5, 4.0].into_iter().enumerate() {
            s.turn(texels / 64.0, if i == 5 { 30.0 } else { 0.0 });
            s.gl.enable(GL_SCISSOR_TEST);
            s.gl.scissor(0, 64 * place as i32 + 9 * i as i32, 192, 9);
            s.quad();
        }
    }
}

/// A turned cube: by vertices or from arrays.
fn cube(s: &mut Stage, by_elements: bool) {
    const FACES: [[[f32; 3]; 3]; 6] = [
        [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        [[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]],
        [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
        [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
        [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
    ];
    if s.vertices.is_empty() {
        for (f, [n, a, b]) in FACES.into_iter().enumerate() {
            for [u, v] in [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                let p = [0, 1, 2].map(|k| n[k] + (2.0 * u - 1.0) * a[k] + (2.0 * v - 1.0) * b[k]);
                s.vertices.push([p[0], p[1], p[2], n[0], n[1], n[2], u, v]);
            }
            s.indices.extend([0, 1, 2, 0, 2, 3].map(|k| 4 * f as u32 + k));
        }
        s.bind_mesh(Arrays::Client);
    }
    if by_elements { s.mesh() } else { s.by_vertex(GL_TRIANGLES) }
}

/// Many cubes with a change of state before each: texture and blending, colour and matrix.
fn cubes(s: &mut Stage, [textures, colors]: [bool; 2], by_elements: bool) {
    clear(s);
    let names = [32, 16].map(|size| s.texture(Tex { size, alpha: size == 16, ..Tex::default() }));
    eye(s, 20.0, 20.0);
    for i in 0..100 {
        if textures {
            s.gl.bind_texture(GL_TEXTURE_2D, names[i % 2]);
            [Context::disable, Context::enable][i / 2 % 2](&mut s.gl, GL_BLEND);
            s.gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        }
        if colors {
            color(&mut s.gl, i, 0.7);
        }
        s.gl.push_matrix();
        s.gl.translatef(1.5 * (i % 10) as f32 - 7.0, 1.5 * (i / 10) as f32 - 7.0, -2.0 * any(i));
        s.gl.rotatef(25.0 * i as f32, 1.0, any(i + 5), 0.4);
        s.gl.scalef(0.5, 0.5, 0.5);
        cube(s, by_elements);
        s.gl.pop_matrix();
    }
}

/// Triangles with everything pushed before and popped after each.
fn pushed(s: &mut Stage) {
    clear(s);
    s.texture(Tex { size: 16, ..Tex::default() });
    for i in 0..60 {
        s.gl.push_attrib([GL_ALL_ATTRIB_BITS, GL_ENABLE_BIT | GL_CURRENT_BIT, GL_COLOR_BUFFER_BIT][i % 3]);
        if i % 2 == 0 {
            s.gl.disable(GL_TEXTURE_2D);
            s.gl.enable(GL_BLEND);
            s.gl.blend_func(GL_ONE, GL_ONE);
        }
        s.wedge(Shape { place: i, smooth: i % 4 == 0, perspective: false }, 1.0);
        s.gl.pop_attrib();
    }
}

/// Triangles of so many pixels at any place, a material before each; then the same with a texture.
fn scattered(s: &mut Stage, area: f32, count: usize) {
    clear(s);
    light(s);
    s.depth(GL_LESS);
    let reach = (0.77 * area).sqrt();
    for i in 0..2 * count {
        if i == count {
            s.texture(Tex { size: 32, min: GL_LINEAR, ..Tex::default() });
        }
        if i % 3 == 0 {
            s.gl.materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, &[any(i), any(i + 1), any(i + 2), 1.0]);
        }
        let [x, y, z] = [0, 1, 2].map(|k| any(3 * i + k));
        s.gl.begin(GL_TRIANGLES);
        for corner in 0..3 {
            let [c, d] = circle(any(7 * i) + corner as f32 / 3.0);
            s.gl.normal3f(c, d, 1.0);
            s.gl.tex_coord2f(c, d);
            let [x, y] = [x, y].map(|place| place * s.size as f32);
            s.gl.vertex3f(x + reach * c, y + reach * d, 1.6 * z - 0.8 + 0.1 * c);
        }
        s.gl.end();
    }
}

/// Quadrilaterals with a texture, blended, at any place.
fn sprites(s: &mut Stage, side: f32, count: usize) {
    clear(s);
    s.gl.enable(GL_BLEND);
    s.gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for filter in [GL_NEAREST, GL_LINEAR] {
        s.texture(Tex { size: 32, min: filter, mag: filter, wrap: GL_CLAMP_TO_EDGE, alpha: true, ..Tex::default() });
        s.gl.begin(GL_QUADS);
        for i in 0..count {
            let [x, y] = [0, 1].map(|k| (any(2 * i + k) * (s.size as f32 - side)).floor() + 0.25 * (i % 2) as f32);
            color(&mut s.gl, i, 0.9);
            for [u, v] in [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                s.gl.tex_coord2f(u, v);
                s.gl.vertex2f(x + side * u, y + side * v);
            }
        }
        s.gl.end();
    }
}

/// Textured spheres before and beside each other.
fn spheres(s: &mut Stage, min: GLenum, culled: bool, cells: usize) {
    clear(s);
    let mag = if min == GL_NEAREST { GL_NEAREST } else { GL_LINEAR };
    s.texture(Tex { size: 64, min, mag, ..Tex::default() });
    eye(s, 4.0, 15.0);
    light(s);
    if culled {
        s.gl.enable(GL_CULL_FACE);
    }
    s.surface([cells, cells], sphere);
    s.bind_mesh(Arrays::Client);
    for i in 0..8 {
        s.gl.push_matrix();
        s.gl.translatef(1.4 * (any(i) - 0.5), 1.4 * (any(i + 8) - 0.5), 1.5 * (any(i + 16) - 0.5));
        s.gl.rotatef(40.0 * i as f32, 0.3, 1.0, 0.2);
        s.mesh();
        s.gl.pop_matrix();
    }
}

/// A sphere of one material without a texture, both sides lit on one half of its copies.
fn lit(s: &mut Stage, listed: bool) {
    clear(s);
    eye(s, 3.2, 25.0);
    light(s);
    s.surface([48, 40], sphere);
    if listed {
        s.gl.new_list(1, GL_COMPILE);
        s.by_vertex(GL_TRIANGLES);
        s.gl.end_list();
    }
    for i in 0..3 {
        s.gl.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, i % 2);
        s.gl.translatef(0.4, -0.2, 0.1);
        if listed { s.gl.call_list(1) } else { s.by_vertex(GL_TRIANGLES) }
    }
}

/// A room: walls of quadrilaterals, a trilinear texture times a light map.
fn room(s: &mut Stage) {
    clear(s);
    s.texture(Tex { size: 64, ..Tex::default() });
    s.gl.active_texture(GL_TEXTURE1);
    s.texture(Tex { size: 16, min: GL_LINEAR, wrap: GL_CLAMP_TO_EDGE, ..Tex::default() });
    s.gl.active_texture(GL_TEXTURE0);
    eye(s, 0.5, 10.0);
    s.gl.rotatef(25.0, 0.0, 1.0, 0.0);
    for wall in 0..6 {
        s.gl.push_matrix();
        match wall {
            0..4 => s.gl.rotatef(90.0 * wall as f32, 0.0, 1.0, 0.0),
            _ => s.gl.rotatef(180.0 * wall as f32 + 90.0, 1.0, 0.0, 0.0),
        }
        s.gl.begin(GL_QUADS);
        for cell in 0..36 {
            for [du, dv] in [[0, 0], [1, 0], [1, 1], [0, 1]] {
                let [u, v] = [cell % 6 + du, cell / 6 + dv].map(|step| step as f32);
                s.gl.tex_coord2f(u, v);
                s.gl.multi_tex_coord2f(GL_TEXTURE1, u / 6.0, v / 6.0);
                s.gl.vertex3f(u - 3.0, v - 3.0, -3.0);
            }
        }
        s.gl.end();
        s.gl.pop_matrix();
    }
}

/// A landscape: triangle strips from arrays, two units, fog, seen from near.
fn terrain(s: &mut Stage) {
    clear(s);
    s.texture(Tex { size: 64, ..Tex::default() });
    s.gl.active_texture(GL_TEXTURE1);
    s.texture(Tex { size: 32, min: GL_LINEAR_MIPMAP_NEAREST, ..Tex::default() });
    s.gl.active_texture(GL_TEXTURE0);
    eye(s, 1.2, 20.0);
    s.gl.enable(GL_FOG);
    s.gl.fogi(GL_FOG_MODE, GL_LINEAR);
    s.gl.fogf(GL_FOG_END, 2.2);
    let [nu, nv] = [90, 60];
    s.surface([nu, nv], hill);
    s.bind_mesh(Arrays::Client);
    s.gl.client_active_texture(GL_TEXTURE1);
    s.gl.tex_coord_pointer(2, GL_FLOAT, 32, s.vertices.as_flattened());
    s.gl.enable_client_state(GL_TEXTURE_COORD_ARRAY);
    let strip = |j: usize| (0..=nu).flat_map(move |i| [(j + 1) * (nu + 1) + i, j * (nu + 1) + i]);
    for j in 0..nv / 2 {
        let indices: Vec<u16> = strip(j).map(|i| i as u16).collect();
        s.gl.draw_elements(GL_TRIANGLE_STRIP, indices.len() as i32, GL_UNSIGNED_SHORT, &indices);
    }
    // The other half in one draw, joined by triangles without area: enough for several threads.
    let rest: Vec<u32> = (nv / 2..nv)
        .flat_map(|j| {
            let mut row: Vec<usize> = strip(j).collect();
            row.extend([j * (nu + 1) + nu, (j + 2).min(nv) * (nu + 1)]);
            row
        })
        .map(|i| i as u32)
        .collect();
    for _ in 0..3 {
        s.gl.draw_elements(GL_TRIANGLE_STRIP, rest.len() as i32, GL_UNSIGNED_INT, &rest);
        s.gl.translatef(0.0, 0.05, 0.0);
    }
}

/// A 3D texture on a torus, lit, with specular light apart.
fn solid_torus(s: &mut Stage) {
    clear(s);
    for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        s.gl.tex_parameteri(GL_TEXTURE_3D, pname, GL_LINEAR);
    }
    let texels = super::bench::stage::noise(64, false);
    s.gl.tex_image_3d(GL_TEXTURE_3D, 0, GL_RGBA8, 16, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    s.gl.enable(GL_TEXTURE_3D);
    eye(s, 2.4, 40.0);
    light(s);
    s.gl.light_modeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR as i32);
    s.surface([48, 24], ring);
    s.gl.begin(GL_TRIANGLES);
    for i in &s.indices {
        let [x, y, z, nx, ny, nz, ..] = s.vertices[*i as usize];
        s.gl.tex_coord3f(x, y, z);
        s.gl.normal3f(nx, ny, nz);
        s.gl.vertex3f(x, y, z);
    }
    s.gl.end();
}

/// Points of several sizes, blended, with depth.
fn points(s: &mut Stage, smooth: bool) {
    clear(s);
    [Context::disable, Context::enable][usize::from(smooth)](&mut s.gl, GL_POINT_SMOOTH);
    s.gl.enable(GL_BLEND);
    s.gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    s.depth(GL_LESS);
    for (i, size) in [1.0f32, 5.0, 6.5, 20.0].into_iter().enumerate() {
        s.gl.point_size(size);
        s.gl.begin(GL_POINTS);
        for k in 0..150 {
            let [x, y, z] = [0, 1, 2].map(|c| any(1000 * i + 3 * k + c));
            color(&mut s.gl, k, 0.8);
            s.gl.vertex3f(s.size as f32 * x, s.size as f32 * y, z);
        }
        s.gl.end();
    }
}

/// Lines of 10 to 200 pixels, of three widths, with a capability.
fn lines(s: &mut Stage, capability: GLenum) {
    clear(s);
    s.gl.enable(capability);
    s.gl.line_stipple(2, 0x3F27);
    s.gl.enable(GL_BLEND);
    s.gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (i, width) in [1.0f32, 1.5, 6.0].into_iter().enumerate() {
        s.gl.line_width(width);
        for (mode, count) in [(GL_LINES, 120), (GL_LINE_STRIP, 20)] {
            s.gl.begin(mode);
            for k in 0..count {
                let seed = 1000 * i + 5 * k;
                let (long, [c, d]) = (10.0 + 190.0 * any(seed) * any(seed + 4), circle(any(seed + 1)));
                let [x, y] = [2, 3].map(|n| s.size as f32 * any(seed + n));
                color(&mut s.gl, k, 0.7);
                s.gl.vertex2f(x, y);
                s.gl.vertex2f(x + long * c, y + long * d);
            }
            s.gl.end();
        }
    }
}

/// A surface as lines and as points, culled and offset.
fn wire(s: &mut Stage) {
    clear(s);
    eye(s, 2.6, 35.0);
    s.surface([30, 30], hill);
    for (i, mode) in [GL_FILL, GL_LINE, GL_POINT].into_iter().enumerate() {
        s.gl.polygon_mode(GL_FRONT_AND_BACK, mode);
        s.gl.enable(GL_POLYGON_OFFSET_FILL);
        s.gl.polygon_offset(1.0, 1.0);
        color(&mut s.gl, i, 1.0);
        s.by_vertex(GL_TRIANGLES);
    }
}

fn smooth_polygons(s: &mut Stage) {
    clear(s);
    s.gl.enable(GL_POLYGON_SMOOTH);
    s.gl.enable(GL_BLEND);
    s.gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    s.gl.begin(GL_TRIANGLES);
    for i in 0..60 {
        color(&mut s.gl, i, 0.8);
        for corner in 0..3 {
            let ([c, d], reach) = (circle(any(9 * i) + corner as f32 / 3.0), 5.0 + 60.0 * any(9 * i + 1));
            let [x, y] = [2, 3].map(|n| s.size as f32 * any(9 * i + n));
            s.gl.vertex2f(x + reach * c, y + reach * d);
        }
    }
    s.gl.end();
}

/// One Begin and End of each kind of strip with more vertices than a thread keeps to itself.
fn long_strips(s: &mut Stage) {
    clear(s);
    s.texture(Tex { size: 64, ..Tex::default() });
    s.depth(GL_LESS);
    for (round, mode) in
        [GL_TRIANGLE_STRIP, GL_QUAD_STRIP, GL_QUADS, GL_TRIANGLE_FAN, GL_TRIANGLES].into_iter().enumerate()
    {
        s.gl.begin(mode);
        for i in 0..18_000 {
            let (turn, out) = (i as f32 / 180.0, 0.5 * (i + 900 * (i % 2)) as f32 / 18_900.0);
            let [c, d] = circle(turn);
            let middle = 0.5 * s.size as f32;
            color(&mut s.gl, i / 7, 1.0);
            s.gl.tex_coord2f(turn, 8.0 * out);
            let z = 0.8 - 0.3 * round as f32 - 0.2 * any(i);
            s.gl.vertex3f(middle + out * s.size as f32 * c, middle + out * s.size as f32 * d, z);
        }
        s.gl.end();
    }
}

/// A mirror and a shadow by the stencil buffer, a clipping plane, an offset, a logical operation.
fn mirror(s: &mut Stage) {
    clear(s);
    eye(s, 5.0, 30.0);
    let floor = |s: &mut Stage, alpha: f32| {
        s.gl.begin(GL_QUADS);
        for [x, z] in [[-2.0f32, -2.0], [-2.0, 2.0], [2.0, 2.0], [2.0, -2.0]] {
            s.gl.color4f(0.5 + 0.2 * x, 0.6, 0.5 + 0.1 * z, alpha);
            s.gl.vertex3f(x, 0.0, z);
        }
        s.gl.end();
    };
    s.surface([16, 12], |at| {
        let mut vertex = sphere(at);
        vertex[1] += 1.3;
        vertex
    });
    s.gl.enable(GL_STENCIL_TEST);
    s.gl.stencil_func(GL_ALWAYS, 1, 255);
    s.gl.stencil_op(GL_KEEP, GL_KEEP, GL_REPLACE);
    s.gl.color_mask(false, false, false, false);
    s.gl.depth_mask(false);
    floor(s, 1.0);
    s.gl.color_mask(true, true, true, true);
    s.gl.depth_mask(true);
    s.gl.stencil_func(GL_EQUAL, 1, 255);
    s.gl.stencil_op(GL_KEEP, GL_KEEP, GL_KEEP);
    s.gl.clip_plane(GL_CLIP_PLANE0, &[0.0, -1.0, 0.0, 0.0]);
    s.gl.enable(GL_CLIP_PLANE0);
    light(s);
    s.gl.push_matrix();
    s.gl.scalef(1.0, -1.0, 1.0);
    s.by_vertex(GL_TRIANGLES);
    s.gl.pop_matrix();
    s.gl.disable(GL_CLIP_PLANE0);
    s.gl.disable(GL_LIGHTING);
    s.gl.enable(GL_BLEND);
    s.gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    floor(s, 0.6);
    s.gl.stencil_op(GL_KEEP, GL_KEEP, GL_INCR);
    s.gl.enable(GL_POLYGON_OFFSET_FILL);
    s.gl.polygon_offset(-1.0, -2.0);
    s.gl.color4f(0.0, 0.0, 0.0, 0.5);
    s.gl.push_matrix();
    s.gl.mult_matrixf(&[1.0, 0.0, 0.0, 0.0, -0.3, 0.0, -0.4, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    s.by_vertex(GL_TRIANGLES);
    s.gl.pop_matrix();
    for capability in [GL_BLEND, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL] {
        s.gl.disable(capability);
    }
    s.gl.enable(GL_LIGHTING);
    s.by_vertex(GL_TRIANGLES);
    s.gl.disable(GL_LIGHTING);
    s.gl.disable(GL_DEPTH_TEST);
    s.gl.enable(GL_COLOR_LOGIC_OP);
    s.gl.logic_op(GL_XOR);
    s.gl.scalef(0.4, 0.4, 0.4);
    floor(s, 1.0);
}

/// What was drawn, read as floats and as bytes, and given back as textures.
fn pixels(s: &mut Stage) {
    rows(s, None, Stage::strip);
    s.gl.disable(GL_DEPTH_TEST);
    let mut floats = vec![0.0f32; 64 * 64 * 3];
    s.gl.read_pixels(10, 60, 64, 64, GL_RGB, GL_FLOAT, &mut floats);
    let mut depths = vec![0u16; 32 * 32];
    s.gl.read_pixels(40, 3, 32, 32, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, &mut depths);
    let mut bytes = vec![0u8; 16 * 16 * 4];
    s.gl.read_pixels(100, 100, 16, 16, GL_BGRA, GL_UNSIGNED_BYTE, &mut bytes);
    s.texture(Tex { size: 64, min: GL_LINEAR, ..Tex::default() });
    for i in 0..4 {
        let (target, internal) = (GL_TEXTURE_2D, GL_RGBA8);
        match i {
            0 => s.gl.tex_image_2d(target, 0, internal, 64, 64, 0, GL_RGB, GL_FLOAT, &floats),
            1 => s.gl.tex_image_2d(target, 0, internal, 32, 32, 0, GL_LUMINANCE, GL_UNSIGNED_SHORT, &depths),
            2 => s.gl.tex_image_2d(target, 0, internal, 16, 16, 0, GL_BGRA, GL_UNSIGNED_BYTE, &bytes),
            _ => s.gl.copy_tex_image_2d(target, 0, internal, 5, 7, 64, 32, 0),
        }
        s.gl.enable(GL_SCISSOR_TEST);
        s.gl.scissor(96 * (i % 2), 96 * (i / 2), 96, 96);
        s.turn(1.0 / 80.0, 10.0);
        s.quad();
    }
}

/// Mipmaps made by the context and by GLU, even and odd sizes, whole images and parts of them.
fn mipmaps(s: &mut Stage) {
    clear(s);
    s.texture(Tex { size: 64, ..Tex::default() });
    let texels = super::bench::stage::noise(64, true);
    for (place, [w, h]) in [[64, 64], [64, 16], [32, 1], [1, 8], [48, 20], [33, 17]].into_iter().enumerate() {
        for glu in [false, true] {
            s.gl.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, i32::from(!glu));
            let (target, bytes) = (GL_TEXTURE_2D, GL_UNSIGNED_BYTE);
            if glu {
                fixedgl::glu::build_2d_mipmaps(&mut s.gl, target, GL_RGBA8, w, h, GL_RGBA, bytes, &texels);
            } else {
                let power = [w, h].map(|side: i32| 1 << side.ilog2());
                s.gl.tex_image_2d(target, 0, GL_RGBA8, power[0], power[1], 0, GL_RGBA, bytes, &texels);
                let [w, h] = power.map(|side| (side / 2).max(1));
                s.gl.tex_sub_image_2d(target, 0, 0, 0, w, h, GL_RGBA, bytes, &texels[64..]);
            }
            for level in 0..3 {
                s.turn(f64::from(1 << level) / 40.0, 20.0);
                s.gl.enable(GL_SCISSOR_TEST);
                s.gl.scissor(64 * level, 32 * place as i32 + 16 * i32::from(glu), 64, 16);
                s.quad();
            }
        }
    }
}
