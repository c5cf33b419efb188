//! The elisions, one row each: a scene in which the work is not done at all, its counter being 0, and a near miss (w off
//! by one unit in the last place, a density of 1e-30, one channel of the colour mask) in which it must be done. The tests
//! hold the rows to that; the benchmark counts what each elision saves.

use fixedgl::Context;
use fixedgl::enums::*;
use fixedgl::explain::Counters;
use fixedgl::explain::{Explanation, Fate};

/// What was done: how often some stages ran over a fragment, or some other count.
pub struct Work<'a> {
    pub counters: &'a Counters,
    pub plan: &'a Explanation,
}

impl Work<'_> {
    /// Fragments that came to a stage.
    fn stage(&self, name: &str) -> u64 {
        self.counters.stage(name).fragments
    }

    /// How many stages of the vertex plan have names that begin so.
    fn vertex(&self, start: &str) -> u64 {
        self.plan.vertex_stages.iter().filter(|name| name.starts_with(start)).count() as u64
    }

    /// 1 if a stage is kept.
    fn kept(&self, stage: &str) -> u64 {
        let decision = self.plan.decision(stage).unwrap_or_else(|| panic!("a line about {stage}"));
        u64::from(decision.fate == Fate::Kept)
    }
}

/// Sets state and draws.
pub type Draw = fn(&mut Context);

/// An elision.
pub struct Row {
    pub name: &'static str,
    /// State of both scenes.
    pub state: Draw,
    /// The work is left out.
    pub left_out: Draw,
    /// It nearly is, and is done.
    pub near_miss: Draw,
    /// How much of the work was done.
    pub count: fn(&Work<'_>) -> u64,
}

/// A quadrilateral over the whole picture whose colours, coordinates and depth vary.
fn quad_with(gl: &mut Context, vertex: impl Fn(&mut Context, usize, [f32; 2])) {
    gl.begin(GL_QUADS);
    for (i, [x, y]) in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0f32]].into_iter().enumerate() {
        gl.color4f(0.5 + 0.5 * x, 0.3, 0.5 - 0.4 * y, 0.75);
        gl.normal3f(0.3 * x, 0.2 * y, 1.0);
        gl.tex_coord2f(0.8 * x + 0.9, 0.7 * y + 0.8);
        vertex(gl, i, [x, y]);
    }
    gl.end();
}

fn quad(gl: &mut Context) {
    quad_with(gl, |gl, _, [x, y]| gl.vertex3f(0.95 * x, 0.95 * y, 0.25));
}

/// Many small quadrilaterals side by side: what a vertex costs counts.
fn mesh(gl: &mut Context) {
    gl.begin(GL_QUADS);
    for i in 0..24 * 24 {
        let [left, low] = [(i % 24) as f32 / 12.0 - 1.0, (i / 24) as f32 / 12.0 - 1.0];
        for [x, y] in [[0.0, 0.0], [0.08, 0.0], [0.08, 0.08], [0.0, 0.08]] {
            gl.color4f(0.5 + 0.5 * left, 0.3, 0.5 - 0.4 * low, 0.75);
            gl.normal3f(left, low + y, 1.0);
            gl.tex_coord2f(left + x, low);
            gl.vertex3f(left + x, low + y, 0.25);
        }
    }
    gl.end();
}

/// The quadrilateral with corner 1 at another w.
fn quad_w(gl: &mut Context, w: f32) {
    quad_with(gl, |gl, i, [x, y]| {
        let w = if i == 1 { w } else { 3.0 };
        gl.vertex4f(0.95 * x * w, 0.95 * y * w, 0.0, w);
    });
}

/// A triangle over more than the picture, with corner 1 at another w.
fn triangle_w(gl: &mut Context, w: f32) {
    gl.begin(GL_TRIANGLES);
    for (i, [x, y]) in [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0f32]].into_iter().enumerate() {
        let w = if i == 1 { w } else { 3.0 };
        gl.tex_coord2f(3.1 * x, 2.3 * y + 0.4 * x);
        gl.vertex4f(x * w, y * w, 0.0, w);
    }
    gl.end();
}

/// The quadrilateral with corner 1 at another z.
fn quad_z(gl: &mut Context, z: f32) {
    quad_with(gl, |gl, i, [x, y]| gl.vertex3f(x, y, if i == 1 { z } else { 0.0 }));
}

/// The quadrilateral with corner 1 at another q.
fn quad_q(gl: &mut Context, q: f32) {
    quad_with(gl, |gl, i, [x, y]| {
        gl.tex_coord4f(x, y, 0.0, if i == 1 { q } else { 1.0 });
        gl.vertex2f(0.95 * x, 0.95 * y);
    });
}

/// A triangle whose coordinates go from 0 to a number.
fn half(gl: &mut Context, greatest: f32) {
    gl.begin(GL_TRIANGLES);
    for [s, t] in [[0.0, 0.0], [greatest, 0.0], [0.0, greatest]] {
        gl.tex_coord2f(s, t);
        gl.vertex2f(1.9 * s - 0.95, 1.9 * t - 0.95);
    }
    gl.end();
}

/// The next number after 3 and after 1.
const THREE_AND_A_BIT: f32 = f32::from_bits(3.0f32.to_bits() + 1);
const ONE_AND_A_BIT: f32 = f32::from_bits(1.0f32.to_bits() + 1);

/// A mipmapped texture of 32 by 32 random texels with the filters NEAREST and LINEAR_MIPMAP_LINEAR in use.
fn texture(gl: &mut Context, internal: GLenum) {
    let mut r = super::random::Random::new(5);
    let texels: Vec<u8> = (0..4 * 32 * 32).map(|_| r.below(256) as u8).collect();
    gl.bind_texture(GL_TEXTURE_2D, internal);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
    gl.tex_image_2d(GL_TEXTURE_2D, 0, internal, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    filters(gl, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    gl.enable(GL_TEXTURE_2D);
}

fn textured(gl: &mut Context) {
    texture(gl, GL_RGBA8);
}

fn filters(gl: &mut Context, min: GLenum, mag: GLenum) {
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, mag);
}

/// A texture whose alpha is 1 but for that of the last texel of a part that is written later.
fn last_alpha(gl: &mut Context, alpha: u8) {
    let texels: Vec<u8> = (0..4 * 32 * 32).map(|i| if i % 4 == 3 { 255 } else { (i * 37 % 251) as u8 }).collect();
    gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    let part = [9, 8, 7, 255, 6, 5, 4, alpha];
    gl.tex_sub_image_2d(GL_TEXTURE_2D, 0, 7, 9, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, &part);
    gl.enable(GL_TEXTURE_2D);
}

fn parameter(gl: &mut Context, name: GLenum, value: f32) {
    gl.tex_parameterf(GL_TEXTURE_2D, name, value);
}

fn lit(gl: &mut Context) {
    gl.enable(GL_LIGHTING);
    gl.enable(GL_LIGHT0);
    gl.lightfv(GL_LIGHT0, GL_POSITION, &[0.2, 0.3, 1.0, 0.0]);
    gl.materialfv(GL_FRONT, GL_SPECULAR, &[0.0, 0.0, 0.0, 1.0]);
}

fn specular(gl: &mut Context, color: f32) {
    gl.materialfv(GL_FRONT, GL_SPECULAR, &[0.0, color, 0.0, 1.0]);
    mesh(gl);
}

fn fog(gl: &mut Context, density: f32) {
    gl.enable(GL_FOG);
    gl.fogfv(GL_FOG_COLOR, &[0.1, 0.9, 0.4, 1.0]);
    gl.fogf(GL_FOG_DENSITY, density);
    quad(gl);
}

fn depth(gl: &mut Context, func: GLenum) {
    gl.enable(GL_DEPTH_TEST);
    gl.depth_mask(false);
    gl.depth_func(func);
    quad(gl);
}

/// A quadrilateral over the whole picture at a depth, untextured, then the textured one behind or in front of it.
fn hidden(gl: &mut Context, z: f32) {
    gl.enable(GL_DEPTH_TEST);
    gl.disable(GL_TEXTURE_2D);
    quad_with(gl, |gl, _, [x, y]| gl.vertex3f(x, y, -z));
    gl.enable(GL_TEXTURE_2D);
    quad(gl);
}

fn blend(gl: &mut Context, src: GLenum, dst: GLenum) {
    gl.enable(GL_BLEND);
    gl.blend_func(src, dst);
    quad(gl);
}

fn alpha(gl: &mut Context, func: GLenum, reference: f32) {
    gl.enable(GL_ALPHA_TEST);
    gl.alpha_func(func, reference);
    quad(gl);
}

fn stencil(gl: &mut Context, func: GLenum, pass: GLenum) {
    gl.enable(GL_STENCIL_TEST);
    gl.stencil_func(func, 0, u32::MAX);
    gl.stencil_op(GL_KEEP, GL_KEEP, pass);
    quad(gl);
}

/// All of them.
pub const ROWS: &[Row] = &[
    Row {
        name: "the division by w, where all w of a primitive are equal",
        state: |_| {},
        left_out: |gl| quad_w(gl, 3.0),
        near_miss: |gl| quad_w(gl, THREE_AND_A_BIT),
        count: |w| w.counters.divisions,
    },
    Row {
        name: "the division by q, where q is 1",
        state: textured,
        left_out: |gl| quad_q(gl, 1.0),
        near_miss: |gl| quad_q(gl, ONE_AND_A_BIT),
        count: |w| w.counters.divisions,
    },
    Row {
        name: "the level of detail, where both filters are the same and read one level",
        state: textured,
        left_out: |gl| (filters(gl, GL_LINEAR, GL_LINEAR), quad(gl)).1,
        near_miss: |gl| (filters(gl, GL_NEAREST, GL_LINEAR), quad(gl)).1,
        count: |w| w.counters.logarithms,
    },
    Row {
        name: "the level of detail, where there is one level",
        state: textured,
        left_out: |gl| (parameter(gl, GL_TEXTURE_MAX_LEVEL, 0.0), quad(gl)).1,
        near_miss: |gl| (parameter(gl, GL_TEXTURE_MAX_LEVEL, 1.0), quad(gl)).1,
        count: |w| w.counters.logarithms,
    },
    Row {
        name: "the level of detail, where its limits leave one value",
        state: |gl| (textured(gl), parameter(gl, GL_TEXTURE_MIN_LOD, 1.5)).1,
        left_out: |gl| (parameter(gl, GL_TEXTURE_MAX_LOD, 1.5), quad(gl)).1,
        near_miss: |gl| (parameter(gl, GL_TEXTURE_MAX_LOD, 1.500_000_1), quad(gl)).1,
        count: |w| w.counters.logarithms,
    },
    Row {
        name: "the level of detail, where everything is magnified",
        state: textured,
        left_out: |gl| (parameter(gl, GL_TEXTURE_MAX_LOD, 0.0), quad(gl)).1,
        near_miss: |gl| (parameter(gl, GL_TEXTURE_MAX_LOD, 1e-7), quad(gl)).1,
        count: |w| w.counters.logarithms,
    },
    Row {
        name: "lambda of each fragment but one in a batch, where w is constant",
        state: textured,
        left_out: |gl| triangle_w(gl, 3.0),
        near_miss: |gl| triangle_w(gl, THREE_AND_A_BIT),
        count: |w| {
            let once = ["LAMBDA_2D", "SHORT_LINEAR_RGBA"].map(|name| w.counters.stage(name).batches);
            w.counters.logarithms - once.iter().sum::<u64>()
        },
    },
    Row {
        name: "alpha of an RGBA texture, where it is 1 in every texel",
        state: |gl| filters(gl, GL_LINEAR, GL_LINEAR),
        left_out: |gl| (last_alpha(gl, 255), quad(gl)).1,
        near_miss: |gl| (last_alpha(gl, 254), quad(gl)).1,
        count: |w| ["BILINEAR_2D_RGBA", "LONG_LINEAR_RGBA", "SHORT_LINEAR_RGBA"].map(|name| w.stage(name)).iter().sum(),
    },
    Row {
        name: "the wrap of coordinates, where those of a primitive are within 0 to 1",
        state: |gl| (textured(gl), filters(gl, GL_LINEAR, GL_LINEAR)).1,
        left_out: |gl| half(gl, 1.0),
        near_miss: |gl| half(gl, ONE_AND_A_BIT),
        count: |w| w.counters.wraps,
    },
    Row {
        name: "the texture matrix, where it is the identity",
        state: |gl| (textured(gl), gl.matrix_mode(GL_TEXTURE)).1,
        left_out: |gl| (gl.scalef(1.0, 1.0, 1.0), mesh(gl)).1,
        near_miss: |gl| (gl.scalef(ONE_AND_A_BIT, 1.0, 1.0), mesh(gl)).1,
        count: |w| w.vertex("TEX_MATRIX"),
    },
    Row {
        name: "generation of a coordinate that the target does not use",
        state: textured,
        left_out: |gl| (gl.enable(GL_TEXTURE_GEN_R), mesh(gl)).1,
        near_miss: |gl| (gl.enable(GL_TEXTURE_GEN_T), mesh(gl)).1,
        count: |w| w.vertex("GEN_"),
    },
    Row {
        name: "the primary colour, where a texture replaces all of it",
        state: |gl| gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE),
        left_out: |gl| (texture(gl, GL_RGBA8), quad(gl)).1,
        near_miss: |gl| (texture(gl, GL_RGB8), quad(gl)).1,
        count: |w| w.kept("colour"),
    },
    Row {
        name: "a texture unit whose colour a later unit replaces",
        state: |gl| {
            textured(gl);
            gl.active_texture(GL_TEXTURE1);
            textured(gl);
            gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        },
        left_out: quad,
        near_miss: |gl| (texture(gl, GL_RGB8), quad(gl)).1,
        count: |w| w.plan.fragment_stages.iter().filter(|name| **name == "COORDINATES").count() as u64 - 1,
    },
    Row {
        name: "mipmap levels that no filter reads",
        state: textured,
        left_out: |gl| (filters(gl, GL_LINEAR, GL_LINEAR), quad(gl)).1,
        near_miss: |gl| (filters(gl, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR), quad(gl)).1,
        count: |w| w.counters.levels_built,
    },
    Row {
        name: "the specular term, where its colour is black",
        state: lit,
        left_out: |gl| specular(gl, 0.0),
        near_miss: |gl| specular(gl, 1e-7),
        count: |w| w.vertex("LIGHT_SPECULAR"),
    },
    Row {
        name: "attenuation, where the light is directional",
        state: lit,
        left_out: |gl| (gl.lightfv(GL_LIGHT0, GL_POSITION, &[0.0, 0.0, 1.0, 0.0]), mesh(gl)).1,
        near_miss: |gl| {
            gl.lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1e-7);
            gl.lightfv(GL_LIGHT0, GL_POSITION, &[0.0, 0.0, 1.0, 1e-7]);
            mesh(gl);
        },
        count: |w| w.vertex("LIGHT_LOCAL"),
    },
    Row {
        name: "normals, where no light needs them",
        state: |gl| gl.enable(GL_LIGHTING),
        left_out: mesh,
        near_miss: |gl| (gl.enable(GL_LIGHT0), mesh(gl)).1,
        count: |w| w.vertex("NORMAL"),
    },
    Row {
        name: "fog, where its density is 0",
        state: |_| {},
        left_out: |gl| fog(gl, 0.0),
        near_miss: |gl| fog(gl, 1e-30),
        count: |w| w.kept("fog"),
    },
    Row {
        name: "the depth test, where it passes all and writes nothing",
        state: |_| {},
        left_out: |gl| depth(gl, GL_ALWAYS),
        near_miss: |gl| depth(gl, GL_LEQUAL),
        count: |w| w.stage("DEPTH_TEST") + w.kept("depth test"),
    },
    Row {
        name: "the alpha test, where it passes all",
        state: |_| {},
        left_out: |gl| alpha(gl, GL_ALWAYS, 0.5),
        near_miss: |gl| alpha(gl, GL_GEQUAL, 1.0 / 255.0),
        count: |w| w.stage("ALPHA_TEST"),
    },
    Row {
        name: "the stencil test, where it passes all and writes nothing",
        state: |_| {},
        left_out: |gl| stencil(gl, GL_ALWAYS, GL_KEEP),
        near_miss: |gl| stencil(gl, GL_ALWAYS, GL_REPLACE),
        count: |w| w.stage("STENCIL_TEST") + w.stage("STENCIL_WRITE"),
    },
    Row {
        name: "reading what is there, where blending ignores it",
        state: |_| {},
        left_out: |gl| blend(gl, GL_ONE, GL_ZERO),
        near_miss: |gl| blend(gl, GL_ONE, GL_ONE_MINUS_SRC_ALPHA),
        count: |w| w.kept("blending"),
    },
    Row {
        name: "texturing of what is hidden",
        state: textured,
        left_out: |gl| hidden(gl, 0.5),
        near_miss: |gl| hidden(gl, -0.5),
        count: |w| w.counters.texels,
    },
    Row {
        name: "draws that write nothing",
        state: |gl| gl.color_mask(false, false, false, false),
        left_out: quad,
        near_miss: |gl| (gl.color_mask(false, false, true, false), quad(gl)).1,
        count: |w| w.counters.fragments,
    },
    Row {
        name: "clipping, where the whole primitive is inside",
        state: |_| {},
        left_out: |gl| quad_z(gl, 1.0),
        near_miss: |gl| quad_z(gl, ONE_AND_A_BIT),
        count: |w| w.counters.clipped,
    },
    Row {
        name: "lighting and coordinates of vertices that nothing seen uses",
        state: |gl| gl.enable(GL_CULL_FACE),
        left_out: |gl| (gl.cull_face(GL_FRONT), mesh(gl)).1,
        near_miss: |gl| (gl.cull_face(GL_BACK), mesh(gl)).1,
        count: |w| w.counters.vertices_valued,
    },
    Row {
        name: "fragments of the side that is culled",
        state: |gl| gl.enable(GL_CULL_FACE),
        left_out: |gl| (gl.cull_face(GL_FRONT), mesh(gl)).1,
        near_miss: |gl| (gl.cull_face(GL_BACK), mesh(gl)).1,
        count: |w| w.counters.fragments,
    },
];
