//! Begin and End (spec-notes/vertices.md): what is allowed, what a change between vertices does, and that small primitives
//! and large ones are the same to the picture.

use fixedgl::Config;
use fixedgl::Context;
use fixedgl::enums::*;

fn context() -> Context {
    let mut gl = Context::new(32, 32);
    gl.clear(GL_COLOR_BUFFER_BIT);
    gl
}

fn pixel(pixels: &[u8], x: usize, y: usize) -> [u8; 3] {
    let at = (y * 32 + x) * 4;
    [pixels[at], pixels[at + 1], pixels[at + 2]]
}

#[test]
fn begin_and_end_come_in_pairs() {
    let mut gl = context();
    gl.end();
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    gl.begin(GL_POLYGON + 1);
    assert_eq!(gl.get_error(), GL_INVALID_ENUM);
    gl.begin(GL_POINTS);
    gl.begin(GL_POINTS);
    gl.enable(GL_LIGHTING);
    gl.end();
    assert_eq!(gl.get_error(), GL_INVALID_OPERATION);
    assert!(!gl.is_enabled(GL_LIGHTING));
    gl.multi_tex_coord2f(GL_TEXTURE0 + 8, 0.0, 0.0);
    assert_eq!(gl.get_error(), GL_INVALID_ENUM);
    // Vertices outside of Begin and End do nothing.
    gl.vertex2f(0.0, 0.0);
    gl.check().unwrap();
    assert!(gl.pixels().chunks(4).all(|p| p[..3] == [0, 0, 0]));
}

#[test]
fn current_values_come_with_each_vertex_and_stay() {
    let mut gl = context();
    gl.normal3b(127, -128, 0);
    gl.tex_coord3s(1, 2, 3);
    gl.secondary_color3f(0.25, 0.5, 0.75);
    gl.fog_coordd(2.5);
    gl.edge_flag(false);
    gl.indexi(3);
    gl.color3ub(255, 0, 51);
    let mut v = [0.0f32; 4];
    gl.get_floatv(GL_CURRENT_COLOR, &mut v);
    assert_eq!(v, [1.0, 0.0, 0.2, 1.0]);
    gl.get_floatv(GL_CURRENT_NORMAL, &mut v[..3]);
    assert_eq!(v[..3], [1.0, -1.0, 1.0 / 255.0]);
    gl.get_floatv(GL_CURRENT_TEXTURE_COORDS, &mut v);
    assert_eq!(v, [1.0, 2.0, 3.0, 1.0]);
    gl.get_floatv(GL_CURRENT_FOG_COORD, &mut v[..1]);
    assert_eq!(v[0], 2.5);
    let mut flag = [9u8];
    gl.get_booleanv(GL_EDGE_FLAG, &mut flag);
    assert_eq!(flag, [0]);
    gl.check().unwrap();
}

#[test]
fn a_rectangle_is_a_polygon() {
    let mut gl = context();
    gl.color3f(1.0, 1.0, 1.0);
    gl.rectf(-0.5, -0.5, 0.5, 0.5);
    let pixels = gl.pixels();
    assert_eq!(pixels.chunks(4).filter(|p| p[0] == 255).count(), 256);
    assert_eq!((pixel(&pixels, 8, 8), pixel(&pixels, 7, 8)), ([255; 3], [0; 3]));
}

/// A lit quad whose material changes between its halves.
fn striped(gl: &mut Context) {
    gl.enable(GL_LIGHTING);
    gl.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[1.0f32, 1.0, 1.0, 1.0]);
    gl.shade_model(GL_FLAT);
    gl.begin(GL_TRIANGLE_STRIP);
    for i in 0..9 {
        let x = i as f32 / 4.0 - 1.0;
        gl.materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, &[if i % 2 == 0 { 1.0f32 } else { 0.0 }, 0.0, 1.0, 1.0]);
        gl.vertex2f(x, -1.0);
        gl.vertex2f(x, 1.0);
    }
    gl.end();
}

#[test]
fn a_material_may_change_between_vertices() {
    let mut gl = context();
    striped(&mut gl);
    gl.check().unwrap();
    let pixels = gl.pixels();
    // The later column of vertices gives the colour of a stripe of four pixels.
    for x in 0..32 {
        let want = if (x / 4 + 1) % 2 == 0 { [255, 0, 255] } else { [0, 0, 255] };
        assert_eq!(pixel(&pixels, x, 16), want, "column {x}");
    }
}

#[test]
fn state_that_changes_after_end_does_not_reach_back() {
    let quad = |gl: &mut Context, x: f32| {
        gl.begin(GL_QUADS);
        for (dx, y) in [(0.0, -1.0), (1.0, -1.0), (1.0, 1.0), (0.0, 1.0)] {
            gl.vertex2f(x + dx, y);
        }
        gl.end();
    };
    let mut gl = context();
    gl.color3f(1.0, 0.0, 0.0);
    quad(&mut gl, -1.0);
    gl.translatef(1.0, 0.0, 0.0);
    gl.color3f(0.0, 1.0, 0.0);
    quad(&mut gl, -1.0);
    gl.scissor(0, 0, 1, 1);
    gl.enable(GL_SCISSOR_TEST);
    let pixels = gl.pixels();
    assert_eq!(pixel(&pixels, 3, 3), [255, 0, 0]);
    assert_eq!(pixel(&pixels, 20, 3), [0, 255, 0]);
}

#[test]
fn a_q_that_comes_late_is_still_divided_by() {
    let draw = |early: bool| {
        let mut gl = context();
        let mut name = [0];
        gl.gen_textures(1, &mut name);
        gl.bind_texture(GL_TEXTURE_2D, name[0]);
        gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        let texels: Vec<[u8; 4]> = (0..64u8).map(|i| [i * 4, 255 - i * 4, i * 3, 255]).collect();
        gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
        gl.enable(GL_TEXTURE_2D);
        if early {
            gl.tex_coord4f(0.0, 0.0, 0.0, 2.0);
        }
        gl.begin(GL_TRIANGLE_STRIP);
        for (s, t, q, x, y) in [
            (0.0, 0.0, 1.0, -1.0, -1.0),
            (1.0, 0.0, 1.0, 1.0, -1.0),
            (0.0, 2.0, 2.0, -1.0, 1.0),
            (2.0, 2.0, 2.0, 1.0, 1.0),
        ] {
            gl.tex_coord4f(s, t, 0.0, q);
            gl.vertex2f(x, y);
        }
        gl.end();
        gl.check().unwrap();
        gl.pixels()
    };
    assert!(draw(true).chunks(4).any(|p| p[0] > 0));
    assert_eq!(draw(false), draw(true));
}

#[test]
fn neither_level_nor_cut_changes_the_picture() {
    let picture = |config: Config| {
        let mut gl = Context::with_config(32, 32, config);
        gl.clear(GL_COLOR_BUFFER_BIT);
        striped(&mut gl);
        gl.pixels()
    };
    let want = picture(Config::default());
    for level in fixedgl::SimdLevel::available() {
        for batch_cut in [64, 7, 1] {
            assert!(
                picture(Config::default().with_level(level).with_batch_cut(batch_cut)) == want,
                "{level:?}, cut {batch_cut}"
            );
        }
    }
}
