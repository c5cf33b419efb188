//! The bridge: an oracle scene as GL commands to a context of the crate. Nothing here computes; it only says the same in
//! the other language. Light positions, eye planes and clip planes are in eye coordinates in the oracle, so they are given
//! under an identity matrix.

use super::images::expand;
use super::{no_error, pixels};
use crate::oracle::env::Env;
use crate::oracle::fragment::to_byte;
use crate::oracle::light::{Lighting, Material};
use crate::oracle::scene::{Scene, Unit};
use crate::oracle::texel::{Image, Texture};
use crate::oracle::vertex::{CoordUnit, Vertex};
use fixedgl::Context;
use fixedgl::enums::*;

/// The scene with every number that GL takes as a float rounded to one, so that both sides start from the same.
pub fn as_given(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    let f = |x: &mut f64| *x = f64::from(*x as f32);
    for v in scene.triangles.iter_mut().flatten() {
        v.position.iter_mut().chain(&mut v.normal).chain(&mut v.color).chain(&mut v.secondary).for_each(f);
        v.tex.iter_mut().flatten().chain([&mut v.fog_coord]).for_each(f);
    }
    scene
}

fn f4(v: [f64; 4]) -> [f32; 4] {
    v.map(|x| x as f32)
}

/// Draws the scene in a new context and returns its colour buffer.
#[track_caller]
pub fn draw(scene: &Scene) -> Vec<[u8; 4]> {
    let mut cx = Context::new(scene.width, scene.height);
    state(&mut cx, scene);
    triangles(&mut cx, scene);
    pixels(&mut cx, scene.width, scene.height)
}

/// Clears and draws the triangles of the scene.
#[track_caller]
pub fn triangles(cx: &mut Context, scene: &Scene) {
    let c = f4(scene.clear);
    cx.clear_color(c[0], c[1], c[2], c[3]);
    cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    cx.begin(GL_TRIANGLES);
    for v in scene.triangles.iter().flatten() {
        vertex(cx, v);
    }
    cx.end();
    no_error(cx);
}

/// One vertex with all its attributes.
pub fn vertex(cx: &mut Context, v: &Vertex) {
    let [r, g, b, a] = f4(v.color);
    cx.color4f(r, g, b, a);
    let [r, g, b, _] = f4(v.secondary);
    cx.secondary_color3f(r, g, b);
    let [x, y, z] = v.normal.map(|x| x as f32);
    cx.normal3f(x, y, z);
    cx.fog_coordf(v.fog_coord as f32);
    for (u, t) in v.tex.iter().enumerate() {
        let [s, t, r, q] = f4(*t);
        cx.multi_tex_coord4f(GL_TEXTURE0 + u as u32, s, t, r, q);
    }
    let [x, y, z, w] = f4(v.position);
    cx.vertex4f(x, y, z, w);
}

fn enable(cx: &mut Context, cap: GLenum, on: bool) {
    if on { cx.enable(cap) } else { cx.disable(cap) }
}

/// All state of the scene.
#[track_caller]
pub fn state(cx: &mut Context, scene: &Scene) {
    let v = &scene.viewport;
    cx.viewport(v.x as i32, v.y as i32, v.width as i32, v.height as i32);
    cx.depth_range(v.near, v.far);
    cx.matrix_mode(GL_PROJECTION);
    cx.load_matrixd(&scene.vertex.projection.to_gl());
    cx.matrix_mode(GL_MODELVIEW);
    cx.load_identity();
    if let Some(l) = &scene.vertex.lighting {
        lighting(cx, l);
    }
    for (i, plane) in scene.clip_planes.iter().enumerate() {
        cx.clip_plane(GL_CLIP_PLANE0 + i as u32, plane);
        cx.enable(GL_CLIP_PLANE0 + i as u32);
    }
    for (i, unit) in scene.units.iter().enumerate() {
        cx.active_texture(GL_TEXTURE0 + i as u32);
        if let Some(coords) = scene.vertex.units.get(i) {
            coord_unit(cx, coords);
        }
        texture_unit(cx, unit, i);
    }
    cx.active_texture(GL_TEXTURE0);
    cx.matrix_mode(GL_MODELVIEW);
    cx.load_matrixd(&scene.vertex.modelview.to_gl());
    enable(cx, GL_NORMALIZE, scene.vertex.normalize);
    enable(cx, GL_RESCALE_NORMAL, scene.vertex.rescale_normal);
    cx.shade_model(if scene.flat { GL_FLAT } else { GL_SMOOTH });
    cx.front_face(if scene.clockwise { GL_CW } else { GL_CCW });
    fragments(cx, scene);
    no_error(cx);
}

fn lighting(cx: &mut Context, l: &Lighting) {
    cx.enable(GL_LIGHTING);
    cx.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &f4(l.scene_ambient));
    cx.light_modeli(GL_LIGHT_MODEL_LOCAL_VIEWER, l.local_viewer);
    cx.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, l.two_side);
    let control = if l.separate_specular { GL_SEPARATE_SPECULAR_COLOR } else { GL_SINGLE_COLOR };
    cx.light_modeli(GL_LIGHT_MODEL_COLOR_CONTROL, control);
    material(cx, GL_FRONT, &l.front);
    material(cx, GL_BACK, &l.back);
    if let Some((face, mode)) = l.color_material {
        cx.color_material(face, mode);
        cx.enable(GL_COLOR_MATERIAL);
    }
    for (i, light) in l.lights.iter().enumerate() {
        let name = GL_LIGHT0 + i as u32;
        cx.enable(name);
        cx.lightfv(name, GL_AMBIENT, &f4(light.ambient));
        cx.lightfv(name, GL_DIFFUSE, &f4(light.diffuse));
        cx.lightfv(name, GL_SPECULAR, &f4(light.specular));
        cx.lightfv(name, GL_POSITION, &f4(light.position));
        cx.lightfv(name, GL_SPOT_DIRECTION, &light.spot_direction.map(|x| x as f32));
        cx.lightf(name, GL_SPOT_EXPONENT, light.spot_exponent as f32);
        cx.lightf(name, GL_SPOT_CUTOFF, light.spot_cutoff as f32);
        let terms = [GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION];
        for (term, k) in terms.iter().zip(light.attenuation) {
            cx.lightf(name, *term, k as f32);
        }
    }
}

fn material(cx: &mut Context, face: GLenum, m: &Material) {
    cx.materialfv(face, GL_AMBIENT, &f4(m.ambient));
    cx.materialfv(face, GL_DIFFUSE, &f4(m.diffuse));
    cx.materialfv(face, GL_SPECULAR, &f4(m.specular));
    cx.materialfv(face, GL_EMISSION, &f4(m.emission));
    cx.materialf(face, GL_SHININESS, m.shininess as f32);
}

fn coord_unit(cx: &mut Context, unit: &CoordUnit) {
    let rows = [(GL_S, GL_TEXTURE_GEN_S), (GL_T, GL_TEXTURE_GEN_T), (GL_R, GL_TEXTURE_GEN_R), (GL_Q, GL_TEXTURE_GEN_Q)];
    for ((coord, cap), generation) in rows.into_iter().zip(unit.texgen) {
        if let Some(g) = generation {
            cx.enable(cap);
            cx.tex_geni(coord, GL_TEXTURE_GEN_MODE, g.mode);
            cx.tex_genfv(coord, GL_OBJECT_PLANE, &f4(g.object_plane));
            cx.tex_genfv(coord, GL_EYE_PLANE, &f4(g.eye_plane));
        }
    }
    cx.matrix_mode(GL_TEXTURE);
    cx.load_matrixd(&unit.matrix.to_gl());
    cx.matrix_mode(GL_MODELVIEW);
}

fn texture_unit(cx: &mut Context, unit: &Unit, index: usize) {
    if let Some(t) = &unit.texture {
        let mut name = [0u32];
        cx.gen_textures(1, &mut name);
        cx.bind_texture(t.target, name[0]);
        texture(cx, t);
        cx.enable(t.target);
        no_error(cx);
        assert_eq!(super::get_i(cx, GL_ACTIVE_TEXTURE), (GL_TEXTURE0 as usize + index) as i32);
        cx.tex_envf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, t.lod.unit_bias as f32);
    }
    environment(cx, &unit.env);
}

/// Parameters and images of the texture that is bound to its target.
pub fn texture(cx: &mut Context, t: &Texture) {
    let wraps = [GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R];
    for (pname, wrap) in wraps.into_iter().zip(t.wrap) {
        cx.tex_parameteri(t.target, pname, wrap);
    }
    cx.tex_parameteri(t.target, GL_TEXTURE_MIN_FILTER, t.lod.min_filter);
    cx.tex_parameteri(t.target, GL_TEXTURE_MAG_FILTER, t.lod.mag_filter);
    cx.tex_parameterfv(t.target, GL_TEXTURE_BORDER_COLOR, &f4(t.border_color));
    cx.tex_parameterf(t.target, GL_TEXTURE_MIN_LOD, t.lod.min_lod as f32);
    cx.tex_parameterf(t.target, GL_TEXTURE_MAX_LOD, t.lod.max_lod as f32);
    cx.tex_parameterf(t.target, GL_TEXTURE_LOD_BIAS, t.lod.object_bias as f32);
    if t.target != GL_TEXTURE_RECTANGLE_ARB {
        cx.tex_parameteri(t.target, GL_TEXTURE_BASE_LEVEL, t.lod.base_level);
    }
    cx.tex_parameteri(t.target, GL_TEXTURE_MAX_LEVEL, t.lod.max_level);
    cx.tex_parameterf(t.target, GL_TEXTURE_MAX_ANISOTROPY_EXT, t.lod.anisotropy as f32);
    if t.base_format == GL_DEPTH_COMPONENT {
        cx.tex_parameteri(t.target, GL_DEPTH_TEXTURE_MODE, t.depth_mode);
        let mode = if t.compare.is_some() { GL_COMPARE_R_TO_TEXTURE } else { GL_NONE };
        cx.tex_parameteri(t.target, GL_TEXTURE_COMPARE_MODE, mode);
        cx.tex_parameteri(t.target, GL_TEXTURE_COMPARE_FUNC, t.compare.unwrap_or(GL_LEQUAL));
    }
    cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    for (level, faces) in t.levels.iter().enumerate() {
        for (face, image) in faces.iter().enumerate() {
            upload(cx, t, level as i32, face as u32, image);
        }
    }
}

fn upload(cx: &mut Context, t: &Texture, level: i32, face: u32, image: &Image) {
    let [w, h, d] = [0, 1, 2].map(|k| (image.size[k] + 2 * image.border[k]) as i32);
    let border = image.border[0] as i32;
    if t.base_format == GL_DEPTH_COMPONENT {
        let depths: Vec<f32> = image.texels.iter().map(|c| c[0] as f32).collect();
        let inner = GL_DEPTH_COMPONENT24;
        if t.target == GL_TEXTURE_1D {
            cx.tex_image_1d(t.target, level, inner, w, border, GL_DEPTH_COMPONENT, GL_FLOAT, &depths);
        } else {
            cx.tex_image_2d(t.target, level, inner, w, h, border, GL_DEPTH_COMPONENT, GL_FLOAT, &depths);
        }
        return;
    }
    let (inner, format, channels): (GLenum, GLenum, &[usize]) = match t.base_format {
        GL_ALPHA => (GL_ALPHA8, GL_ALPHA, &[3]),
        GL_LUMINANCE => (GL_LUMINANCE8, GL_LUMINANCE, &[0]),
        GL_LUMINANCE_ALPHA => (GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, &[0, 3]),
        GL_INTENSITY => (GL_INTENSITY8, GL_LUMINANCE, &[0]),
        GL_RGB => (GL_RGB8, GL_RGB, &[0, 1, 2]),
        _ => (GL_RGBA8, GL_RGBA, &[0, 1, 2, 3]),
    };
    let px: Vec<u8> = image.texels.iter().flat_map(|c| channels.iter().map(|&k| to_byte(c[k]))).collect();
    debug_assert!(image.texels.iter().all(|c| expand(t.base_format, *c) == *c), "the image must be expanded");
    match t.target {
        GL_TEXTURE_1D => cx.tex_image_1d(t.target, level, inner, w, border, format, GL_UNSIGNED_BYTE, &px),
        GL_TEXTURE_3D => cx.tex_image_3d(t.target, level, inner, w, h, d, border, format, GL_UNSIGNED_BYTE, &px),
        GL_TEXTURE_CUBE_MAP => {
            let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
            cx.tex_image_2d(target, level, inner, w, h, border, format, GL_UNSIGNED_BYTE, &px);
        }
        _ => cx.tex_image_2d(t.target, level, inner, w, h, border, format, GL_UNSIGNED_BYTE, &px),
    }
}

fn environment(cx: &mut Context, env: &Env) {
    let t = GL_TEXTURE_ENV;
    cx.tex_envi(t, GL_TEXTURE_ENV_MODE, env.mode);
    cx.tex_envfv(t, GL_TEXTURE_ENV_COLOR, &f4(env.color));
    if !matches!(env.mode, GL_COMBINE | GL_COMBINE4_NV) {
        return;
    }
    let c = &env.combine;
    cx.tex_envi(t, GL_COMBINE_RGB, c.rgb);
    cx.tex_envi(t, GL_COMBINE_ALPHA, c.alpha);
    cx.tex_envf(t, GL_RGB_SCALE, c.rgb_scale as f32);
    cx.tex_envf(t, GL_ALPHA_SCALE, c.alpha_scale as f32);
    for i in 0..4 {
        let k = i as u32;
        cx.tex_envi(t, GL_SOURCE0_RGB + k, c.rgb_args[i].source);
        cx.tex_envi(t, GL_OPERAND0_RGB + k, c.rgb_args[i].operand);
        cx.tex_envi(t, GL_SOURCE0_ALPHA + k, c.alpha_args[i].source);
        cx.tex_envi(t, GL_OPERAND0_ALPHA + k, c.alpha_args[i].operand);
    }
}

/// Chapters 3.9 to 4: colour sum, fog, culling, offset, tests, blending.
fn fragments(cx: &mut Context, scene: &Scene) {
    if let Some(face) = scene.cull {
        cx.enable(GL_CULL_FACE);
        cx.cull_face(face);
    }
    if let Some((factor, units)) = scene.offset {
        cx.enable(GL_POLYGON_OFFSET_FILL);
        cx.polygon_offset(factor as f32, units as f32);
    }
    enable(cx, GL_COLOR_SUM, scene.color_sum);
    if let Some(fog) = &scene.fog {
        cx.enable(GL_FOG);
        cx.fogi(GL_FOG_MODE, fog.mode);
        cx.fogf(GL_FOG_DENSITY, fog.density as f32);
        cx.fogf(GL_FOG_START, fog.start as f32);
        cx.fogf(GL_FOG_END, fog.end as f32);
        cx.fogfv(GL_FOG_COLOR, &f4(fog.color));
        let source = if scene.vertex.fog_from_coordinate { GL_FOG_COORDINATE } else { GL_FRAGMENT_DEPTH };
        cx.fogi(GL_FOG_COORDINATE_SOURCE, source);
        cx.fogi(GL_FOG_DISTANCE_MODE_NV, scene.vertex.fog_distance);
    }
    if let Some((func, reference)) = scene.alpha {
        cx.enable(GL_ALPHA_TEST);
        cx.alpha_func(func, reference as f32);
    }
    if let Some((func, mask)) = scene.depth {
        cx.enable(GL_DEPTH_TEST);
        cx.depth_func(func);
        cx.depth_mask(mask);
    }
    if let Some(b) = &scene.blend {
        cx.enable(GL_BLEND);
        cx.blend_equation_separate(b.equation[0], b.equation[1]);
        cx.blend_func_separate(b.source[0], b.destination[0], b.source[1], b.destination[1]);
        let [r, g, bl, a] = f4(b.constant);
        cx.blend_color(r, g, bl, a);
    }
}
