//! How each scene of the benchmark is set up and drawn: through the methods of [`Context`], as a program of the time would
//! do it. What several scenes share is in [`Stage`].

use super::stage::{Arrays, Stage, Tex, noise};
use fixedgl::enums::*;
use fixedgl::{Context, glu};

pub fn with_depth(s: &mut Stage, set_up: fn(&mut Stage)) {
    set_up(s);
    s.depth(GL_LEQUAL);
}

pub fn clear(s: &mut Stage) {
    s.gl.clear_color(0.2, 0.4, 0.6, 1.0);
    s.depth(GL_LESS);
}

pub fn draw_clear(s: &mut Stage) {
    s.gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

pub fn flat(s: &mut Stage) {
    s.gl.shade_model(GL_FLAT);
    s.gl.color4f(0.8, 0.9, 0.7, 1.0);
    s.colored = false;
}

pub fn gouraud(s: &mut Stage) {
    s.colored = true;
}

pub fn nearest(s: &mut Stage) {
    s.texture(Tex { size: 256, min: GL_NEAREST, mag: GL_NEAREST, ..Tex::default() });
    s.gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    s.turn(1.0 / 256.0, 0.0);
}

pub fn nearest_tilted(s: &mut Stage) {
    nearest(s);
    s.tilt();
}

pub fn bilinear(s: &mut Stage) {
    s.texture(Tex { size: 256, min: GL_LINEAR, mag: GL_LINEAR, ..Tex::default() });
    s.colored = true;
    s.turn(0.45 / 256.0, 30.0);
}

pub fn bilinear_tilted(s: &mut Stage) {
    bilinear(s);
    s.tilt();
}

/// A plane; the filter of magnification is that within a level.
pub fn ground(s: &mut Stage, min: GLenum, anisotropy: f32) {
    let nearest = matches!(min, GL_NEAREST | GL_NEAREST_MIPMAP_NEAREST);
    let mag = if nearest { GL_NEAREST } else { GL_LINEAR };
    s.texture(Tex { size: 1024, min, mag, ..Tex::default() });
    s.gl.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
    s.gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    s.stand_on_ground();
}

pub fn trilinear(s: &mut Stage) {
    anisotropic(s, 1.0);
}

pub fn anisotropic(s: &mut Stage, most: f32) {
    ground(s, GL_LINEAR_MIPMAP_LINEAR, most);
}

pub fn two_units(s: &mut Stage) {
    trilinear(s);
    s.gl.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    s.gl.active_texture(GL_TEXTURE1);
    s.texture(Tex { size: 128, min: GL_LINEAR, mag: GL_LINEAR, ..Tex::default() });
    s.gl.active_texture(GL_TEXTURE0);
    s.units = 2;
}

pub fn blended(s: &mut Stage) {
    bilinear(s);
    s.texture(Tex { size: 256, min: GL_LINEAR, mag: GL_LINEAR, alpha: true, ..Tex::default() });
    s.gl.enable(GL_BLEND);
    s.gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    s.depth(GL_LEQUAL);
    s.gl.depth_mask(false);
}

pub fn generate(gl: &mut Context, coordinates: &[GLenum], mode: GLenum) {
    for (i, coordinate) in coordinates.iter().enumerate() {
        gl.tex_geni(*coordinate, GL_TEXTURE_GEN_MODE, mode);
        gl.enable(GL_TEXTURE_GEN_S + i as u32);
    }
}

pub fn reflections(s: &mut Stage, arrays: Arrays) {
    for face in 0..6 {
        let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
        s.texture(Tex { target, size: 256, wrap: GL_CLAMP_TO_EDGE, ..Tex::default() });
    }
    generate(&mut s.gl, &[GL_S, GL_T, GL_R], GL_REFLECTION_MAP);
    s.torus(arrays);
}

pub fn sphere_map(s: &mut Stage) {
    s.texture(Tex { size: 256, ..Tex::default() });
    generate(&mut s.gl, &[GL_S, GL_T], GL_SPHERE_MAP);
    s.torus(Arrays::Client);
}

pub fn small_triangles(s: &mut Stage, arrays: Arrays) {
    s.texture(Tex { size: 256, ..Tex::default() });
    let gl = &mut s.gl;
    gl.enable(GL_LIGHTING);
    gl.enable(GL_LIGHT0);
    for (pname, values) in
        [(GL_POSITION, [0.3, 0.4, 0.86, 0.0]), (GL_DIFFUSE, [0.9, 0.85, 0.8, 1.0]), (GL_AMBIENT, [0.2, 0.2, 0.25, 1.0])]
    {
        gl.lightfv(GL_LIGHT0, pname, &values);
    }
    for (pname, values) in [(GL_DIFFUSE, [1.0; 4]), (GL_AMBIENT, [1.0; 4]), (GL_SPECULAR, [0.5, 0.5, 0.5, 1.0])] {
        gl.materialfv(GL_FRONT_AND_BACK, pname, &values);
    }
    gl.materialf(GL_FRONT_AND_BACK, GL_SHININESS, 20.0);
    s.depth(GL_LEQUAL);
    // 250,000 triangles of four pixels at 1024 x 1024, fewer of them on a smaller framebuffer.
    let n = (s.size as usize * 353).div_ceil(1024);
    s.grid(n, n + 1);
    s.bind_mesh(arrays);
    s.triangles *= 4;
}

pub fn culled_triangles(s: &mut Stage) {
    small_triangles(s, Arrays::Client);
    s.gl.enable(GL_CULL_FACE);
    s.gl.cull_face(GL_FRONT);
}

pub fn four_meshes(s: &mut Stage) {
    for _ in 0..4 {
        s.mesh();
    }
}

pub fn immediate(s: &mut Stage) {
    s.texture(Tex { size: 256, ..Tex::default() });
    s.depth(GL_LEQUAL);
    let n = 316 / s.coarser;
    s.grid(n, n);
}

pub fn draw_immediate(s: &mut Stage) {
    s.gl.begin(GL_TRIANGLES);
    for i in &s.indices {
        let Some([x, y, z, _, _, nz, u, v]) = s.vertices.get(*i as usize).copied() else { continue };
        s.gl.color4f(nz, 1.0, 1.0, 1.0);
        s.gl.tex_coord2f(u, v);
        s.gl.vertex3f(x, y, z);
    }
    s.gl.end();
}

pub fn listed(s: &mut Stage) {
    immediate(s);
    s.gl.new_list(1, GL_COMPILE);
    draw_immediate(s);
    s.gl.end_list();
}

pub fn draw_list(s: &mut Stage) {
    s.gl.call_list(1);
}

pub fn layers(s: &mut Stage) {
    bilinear(s);
    s.texture(Tex { size: 256, ..Tex::default() });
    s.depth(GL_LESS);
}

pub fn front_to_back(s: &mut Stage) {
    stack(s, [-0.8, -0.6, -0.4, -0.2, 0.0, 0.2, 0.4, 0.6].map(|z: f32| -z));
}

pub fn back_to_front(s: &mut Stage) {
    stack(s, [-0.8, -0.6, -0.4, -0.2, 0.0, 0.2, 0.4, 0.6]);
}

pub fn stack(s: &mut Stage, depths: [f32; 8]) {
    draw_clear(s);
    for z in depths {
        s.z = z;
        s.quad();
    }
}

/// A texture of 1024 x 1024 and the texels to give it again.
pub fn uploads(s: &mut Stage, min: GLenum, generate: bool) {
    s.texture(Tex { size: 1024, min: GL_LINEAR, mag: GL_LINEAR, ..Tex::default() });
    s.gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min);
    s.gl.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, i32::from(generate));
    s.upload = noise(1024, false);
}

pub fn upload(s: &mut Stage) {
    s.gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, 1024, 1024, 0, GL_RGBA, GL_UNSIGNED_BYTE, &s.upload);
    small_triangle(s);
}

pub fn upload_part(s: &mut Stage) {
    s.gl.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1024, 1024, GL_RGBA, GL_UNSIGNED_BYTE, &s.upload);
    small_triangle(s);
}

pub fn upload_by_glu(s: &mut Stage) {
    let (texels, byte) = (&s.upload, GL_UNSIGNED_BYTE);
    glu::build_2d_mipmaps(&mut s.gl, GL_TEXTURE_2D, GL_RGBA8, 1024, 1024, GL_RGBA, byte, texels);
    small_triangle(s);
}

/// What needs the texture, so that an upload cannot be left out.
fn small_triangle(s: &mut Stage) {
    s.gl.begin(GL_TRIANGLES);
    for [x, y] in [[0.0f32, 0.0], [1.0, 0.0], [0.0, 1.0]] {
        s.gl.tex_coord2f(x, y);
        s.gl.vertex3f(8.0 * x, 8.0 * y, 0.0);
    }
    s.gl.end();
}

pub fn solid(s: &mut Stage) {
    let gl = &mut s.gl;
    for pname in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        gl.tex_parameteri(GL_TEXTURE_3D, pname, GL_LINEAR);
    }
    let texels = noise(512, false);
    gl.tex_image_3d(GL_TEXTURE_3D, 0, GL_RGBA8, 64, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    gl.enable(GL_TEXTURE_3D);
    s.depth(GL_LEQUAL);
}

pub fn draw_solid(s: &mut Stage) {
    let (w, h) = (s.size as f32, s.size as f32);
    s.gl.begin(GL_QUADS);
    for ([x, y], [u, v, r]) in [
        ([0.0, 0.0], [0.0, 0.0, 0.0]),
        ([w, 0.0], [3.0, 0.2, 0.5]),
        ([w, h], [3.0, 3.0, 1.0]),
        ([0.0, h], [0.0, 2.8, 0.5]),
    ] {
        s.gl.tex_coord3f(u, v, r);
        s.gl.vertex3f(x, y, 0.0);
    }
    s.gl.end();
}

pub fn alpha_fog(s: &mut Stage) {
    s.texture(Tex { size: 1024, min: GL_LINEAR_MIPMAP_NEAREST, alpha: true, ..Tex::default() });
    s.stand_on_ground();
    let gl = &mut s.gl;
    gl.enable(GL_ALPHA_TEST);
    gl.alpha_func(GL_GREATER, 0.4);
    gl.enable(GL_FOG);
    gl.fogi(GL_FOG_MODE, GL_EXP2);
    gl.fogf(GL_FOG_DENSITY, 0.03);
    gl.fogfv(GL_FOG_COLOR, &[0.6, 0.65, 0.7, 1.0]);
}
