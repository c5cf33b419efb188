//! A scene of the oracle as GL commands. Scenes are written once, as the oracle's state; the oracle draws them by its
//! equations, and this file says the same to any [`Gl`]. Nothing is computed here. Numbers that GL takes as floats are
//! rounded to floats first ([`as_given`]), so that both sides start from the same.

use super::gl::Gl;
use super::oracle::env::Env;
use super::oracle::fragment::to_byte;
use super::oracle::matrix::M4;
use super::oracle::scene::{Scene, Unit};
use super::oracle::texel::Texture;
use super::oracle::vertex::Vertex;
use fixedgl::enums::*;

/// The scene with every number that GL takes as a float rounded to one.
pub fn as_given(mut scene: Scene) -> Scene {
    let f = |x: &mut f64| *x = f64::from(*x as f32);
    for v in scene.triangles.iter_mut().flatten() {
        v.position.iter_mut().chain(&mut v.normal).chain(&mut v.color).for_each(f);
        v.tex.iter_mut().flatten().chain([&mut v.fog_coord]).for_each(f);
    }
    for unit in &mut scene.vertex.units {
        for generation in unit.texgen.iter_mut().flatten() {
            generation.eye_plane.iter_mut().for_each(f);
        }
    }
    if let Some(fog) = &mut scene.fog {
        [&mut fog.density, &mut fog.start, &mut fog.end].into_iter().chain(&mut fog.color).for_each(f);
    }
    scene.units.iter_mut().for_each(|unit| unit.env.color.iter_mut().for_each(f));
    scene.clear.iter_mut().for_each(f);
    scene
}

fn f4(v: [f64; 4]) -> [f32; 4] {
    v.map(|x| x as f32)
}

/// All state of the scene, and its triangles as display list 1.
pub fn state(gl: &mut dyn Gl, scene: &Scene) {
    gl.make_current();
    gl.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    gl.viewport(0, 0, scene.width as i32, scene.height as i32);
    let v = &scene.viewport;
    gl.depth_range(v.near, v.far);
    projection(gl, scene, [0.0; 2]);
    gl.load_identity();
    for (i, unit) in scene.units.iter().enumerate() {
        gl.active_texture(GL_TEXTURE0 + i as u32);
        generation(gl, scene, i);
        texture_unit(gl, unit, i as u32 + 1);
    }
    gl.active_texture(GL_TEXTURE0);
    gl.load_matrixd(&scene.vertex.modelview.to_gl());
    if scene.vertex.normalize {
        gl.enable(GL_NORMALIZE);
    }
    if let Some(face) = scene.cull {
        gl.enable(GL_CULL_FACE);
        gl.cull_face(face);
    }
    fragments(gl, scene);
    let [r, g, b, a] = f4(scene.clear);
    gl.clear_color(r, g, b, a);
    gl.new_list(1, GL_COMPILE);
    gl.begin(GL_TRIANGLES);
    for v in scene.triangles.iter().flatten() {
        vertex(gl, v);
    }
    gl.end();
    gl.end_list();
    let error = gl.error();
    assert_eq!(error, 0, "the state of a scene raises {}", fixedgl::enums::name(error));
}

/// Clears colour and depth and draws the scene.
pub fn picture(gl: &mut dyn Gl) {
    gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.call_list(1);
}

/// The projection of the scene, the picture moved by (x, y) pixels. Leaves the matrix mode at MODELVIEW.
pub fn projection(gl: &mut dyn Gl, scene: &Scene, by: [f64; 2]) {
    gl.matrix_mode(GL_PROJECTION);
    gl.load_matrixd(&moved(scene, by).to_gl());
    gl.matrix_mode(GL_MODELVIEW);
}

/// The projection matrix of the scene, the picture moved by (x, y) pixels.
pub fn moved(scene: &Scene, [x, y]: [f64; 2]) -> M4 {
    let shift = M4::translation(2.0 * x / f64::from(scene.width), 2.0 * y / f64::from(scene.height), 0.0);
    shift.times(scene.vertex.projection)
}

/// One vertex with its attributes.
pub fn vertex(gl: &mut dyn Gl, v: &Vertex) {
    let [r, g, b, a] = f4(v.color);
    gl.color4f(r, g, b, a);
    let [x, y, z] = v.normal.map(|x| x as f32);
    gl.normal3f(x, y, z);
    gl.fog_coordf(v.fog_coord as f32);
    for (u, t) in v.tex.iter().enumerate() {
        let [s, t, r, q] = f4(*t);
        gl.multi_tex_coord4f(GL_TEXTURE0 + u as u32, s, t, r, q);
    }
    let [x, y, z, w] = f4(v.position);
    gl.vertex4f(x, y, z, w);
}

fn generation(gl: &mut dyn Gl, scene: &Scene, unit: usize) {
    let Some(unit) = scene.vertex.units.get(unit) else { return };
    let rows = [(GL_S, GL_TEXTURE_GEN_S), (GL_T, GL_TEXTURE_GEN_T), (GL_R, GL_TEXTURE_GEN_R), (GL_Q, GL_TEXTURE_GEN_Q)];
    for ((coord, cap), generation) in rows.into_iter().zip(unit.texgen) {
        if let Some(g) = generation {
            gl.enable(cap);
            gl.tex_geni(coord, GL_TEXTURE_GEN_MODE, g.mode as i32);
            if g.mode == GL_EYE_LINEAR {
                // The modelview matrix is the identity here, and the oracle's plane is in eye coordinates already.
                gl.tex_genfv(coord, GL_EYE_PLANE, &f4(g.eye_plane));
            }
        }
    }
}

fn texture_unit(gl: &mut dyn Gl, unit: &Unit, name: u32) {
    if let Some(t) = &unit.texture {
        gl.bind_texture(GL_TEXTURE_2D, name);
        parameters(gl, t);
        gl.enable(GL_TEXTURE_2D);
    }
    environment(gl, &unit.env);
}

/// Parameters and images of the texture that is bound.
fn parameters(gl: &mut dyn Gl, t: &Texture) {
    let two = GL_TEXTURE_2D;
    gl.tex_parameteri(two, GL_TEXTURE_WRAP_S, t.wrap[0] as i32);
    gl.tex_parameteri(two, GL_TEXTURE_WRAP_T, t.wrap[1] as i32);
    gl.tex_parameteri(two, GL_TEXTURE_MIN_FILTER, t.lod.min_filter as i32);
    gl.tex_parameteri(two, GL_TEXTURE_MAG_FILTER, t.lod.mag_filter as i32);
    gl.tex_parameterf(two, GL_TEXTURE_LOD_BIAS, t.lod.object_bias as f32);
    if t.lod.anisotropy > 1.0 {
        gl.tex_parameterf(two, GL_TEXTURE_MAX_ANISOTROPY_EXT, t.lod.anisotropy as f32);
    }
    gl.tex_parameterfv(two, GL_TEXTURE_BORDER_COLOR, &f4(t.border_color));
    for (level, faces) in t.levels.iter().enumerate() {
        let image = &faces[0];
        let texels: Vec<u8> = image.texels.iter().flat_map(|c| c.map(to_byte)).collect();
        gl.tex_image_2d(level as i32, GL_RGBA8 as i32, [image.size[0] as i32, image.size[1] as i32], &texels);
    }
}

fn environment(gl: &mut dyn Gl, env: &Env) {
    let t = GL_TEXTURE_ENV;
    gl.tex_envi(t, GL_TEXTURE_ENV_MODE, env.mode as i32);
    gl.tex_envfv(t, GL_TEXTURE_ENV_COLOR, &f4(env.color));
    if env.mode != GL_COMBINE {
        return;
    }
    let c = &env.combine;
    gl.tex_envi(t, GL_COMBINE_RGB, c.rgb as i32);
    gl.tex_envi(t, GL_COMBINE_ALPHA, c.alpha as i32);
    gl.tex_envf(t, GL_RGB_SCALE, c.rgb_scale as f32);
    gl.tex_envf(t, GL_ALPHA_SCALE, c.alpha_scale as f32);
    for i in 0..3 {
        let k = i as u32;
        gl.tex_envi(t, GL_SOURCE0_RGB + k, c.rgb_args[i].source as i32);
        gl.tex_envi(t, GL_OPERAND0_RGB + k, c.rgb_args[i].operand as i32);
        gl.tex_envi(t, GL_SOURCE0_ALPHA + k, c.alpha_args[i].source as i32);
        gl.tex_envi(t, GL_OPERAND0_ALPHA + k, c.alpha_args[i].operand as i32);
    }
}

fn fragments(gl: &mut dyn Gl, scene: &Scene) {
    if let Some(fog) = &scene.fog {
        gl.enable(GL_FOG);
        gl.fogi(GL_FOG_MODE, fog.mode as i32);
        gl.fogf(GL_FOG_DENSITY, fog.density as f32);
        gl.fogf(GL_FOG_START, fog.start as f32);
        gl.fogf(GL_FOG_END, fog.end as f32);
        gl.fogfv(GL_FOG_COLOR, &f4(fog.color));
        let source = if scene.vertex.fog_from_coordinate { GL_FOG_COORDINATE } else { GL_FRAGMENT_DEPTH };
        gl.fogi(GL_FOG_COORDINATE_SOURCE, source as i32);
    }
    if let Some((func, _)) = scene.depth {
        gl.enable(GL_DEPTH_TEST);
        gl.depth_func(func);
    }
    if let Some(b) = &scene.blend {
        gl.enable(GL_BLEND);
        gl.blend_func(b.source[0], b.destination[0]);
    }
}
