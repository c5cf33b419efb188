//! Point sprites (ARB_point_sprite): squares of the exact size, whose texture coordinates are the place within the square;
//! and the textures of EXT_packed_depth_stencil.

use crate::support::{Random, get_i, raises};
use fixedgl::Context;
use fixedgl::enums::*;

const SIDE: i32 = 32;
/// Texels in each row and column of the test's texture.
const TEXELS: i32 = 4;

/// A texel's colour says where it is.
fn texel(i: i32, j: i32) -> [u8; 4] {
    [50 + 50 * i as u8, 50 + 50 * j as u8, 7, 255]
}

/// A context with the texture in a unit, one pixel a unit of length.
fn context(unit: u32) -> Context {
    let mut cx = Context::new(SIDE as u32, SIDE as u32);
    cx.active_texture(GL_TEXTURE0 + unit);
    let texels: Vec<u8> = (0..TEXELS).flat_map(|j| (0..TEXELS).flat_map(move |i| texel(i, j))).collect();
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8, TEXELS, TEXELS, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    cx.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    cx.enable(GL_TEXTURE_2D);
    cx.enable(GL_POINT_SPRITE_ARB);
    cx.tex_envi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, 1);
    cx.matrix_mode(GL_PROJECTION);
    cx.ortho(0.0, f64::from(SIDE), 0.0, f64::from(SIDE), -1.0, 1.0);
    cx.matrix_mode(GL_MODELVIEW);
    assert_eq!(cx.check(), Ok(()));
    cx
}

/// Compares the picture of one sprite with the equations of the extension. Pixels whose place is on the line between two
/// texels are left out.
fn check(cx: &mut Context, [x, y]: [f64; 2], size: f64, what: &str) {
    let pixels = cx.pixels();
    for py in 0..SIDE {
        for px in 0..SIDE {
            let got: [u8; 4] = pixels[4 * (py * SIDE + px) as usize..][..4].try_into().unwrap();
            let (dx, dy) = (f64::from(px) + 0.5 - x, f64::from(py) + 0.5 - y);
            let inside = |d: f64| -size / 2.0 <= d && d < size / 2.0;
            if !inside(dx) || !inside(dy) {
                assert_eq!(got, [0; 4], "{px} {py} lies outside, {what}");
                continue;
            }
            // s grows to the right, t downwards.
            let [s, t] = [0.5 + dx / size, 0.5 - dy / size].map(|v| v * f64::from(TEXELS));
            if (s - s.round()).abs() < 1e-3 || (t - t.round()).abs() < 1e-3 {
                continue;
            }
            assert_eq!(got, texel(s as i32, t as i32), "{px} {py}, {what}");
        }
    }
}

#[test]
fn a_sprite_is_a_square_whose_coordinates_are_the_place_in_it() {
    let mut random = Random(3);
    for case in 0..200 {
        let unit = random.below(3) as u32;
        let mut cx = context(unit);
        // On the grid of window positions, so that no rounding is in the way.
        let at: [f64; 2] = std::array::from_fn(|_| random.below(32 * 256) as f64 / 256.0);
        let size = random.pick(&[1.0, 2.0, 3.25, 7.5, 8.0, 20.0, 63.0]);
        // Neither the coordinates of the vertex, nor a matrix, generation, q or smoothness change anything.
        cx.matrix_mode(GL_TEXTURE);
        cx.scalef(3.0, 0.5, 1.0);
        if case % 3 == 0 {
            cx.enable(GL_TEXTURE_GEN_S);
            cx.enable(GL_POINT_SMOOTH);
        }
        cx.point_size(size as f32);
        cx.begin(GL_POINTS);
        cx.multi_tex_coord4f(GL_TEXTURE0 + unit, 5.0, 6.0, 7.0, random.pick(&[1.0, 0.25]));
        cx.vertex2d(at[0], at[1]);
        cx.end();
        assert_eq!(cx.check(), Ok(()));
        check(&mut cx, at, size, &format!("case {case}, unit {unit}, {at:?}, size {size}"));
    }
}

#[test]
fn the_points_of_polygons_are_sprites_and_lines_are_not() {
    let mut cx = context(0);
    cx.polygon_mode(GL_FRONT_AND_BACK, GL_POINT);
    cx.point_size(6.0);
    cx.begin(GL_TRIANGLES);
    for p in [[8.0_f32, 8.0], [8.0, 8.0], [8.0, 8.0]] {
        cx.vertex2fv(&p);
    }
    cx.end();
    check(&mut cx, [8.0, 8.0], 6.0, "a vertex of a polygon");
    let mut cx = context(0);
    cx.line_width(4.0);
    cx.begin(GL_LINES);
    cx.tex_coord2f(0.1, 0.1);
    cx.vertex2f(2.0, 8.0);
    cx.vertex2f(30.0, 8.0);
    cx.end();
    let pixels = cx.pixels();
    assert_eq!(pixels[4 * (8 * SIDE + 9) as usize..][..4], texel(0, 0));
}

#[test]
fn a_unit_that_does_not_replace_keeps_the_coordinates_of_the_vertex() {
    let mut cx = context(0);
    cx.tex_envi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, 0);
    cx.point_size(8.0);
    cx.begin(GL_POINTS);
    cx.tex_coord2f(0.9, 0.4);
    cx.vertex2f(16.0, 16.0);
    cx.end();
    let pixels = cx.pixels();
    let drawn: Vec<_> = pixels.chunks(4).filter(|p| *p != [0; 4]).collect();
    assert_eq!(drawn.len(), 64);
    assert!(drawn.iter().all(|p| *p == texel(3, 1)));
}

#[test]
fn the_state_of_sprites_can_be_asked_for_saved_and_is_checked() {
    let mut cx = Context::new(4, 4);
    assert_eq!(get_i(&mut cx, GL_POINT_SPRITE_ARB), 0);
    let replaces = |cx: &mut Context| {
        let mut value = [-1];
        cx.get_tex_enviv(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, &mut value);
        value[0]
    };
    assert_eq!(replaces(&mut cx), 0);
    for mask in [GL_POINT_BIT, GL_ENABLE_BIT] {
        cx.push_attrib(mask);
        cx.enable(GL_POINT_SPRITE_ARB);
        assert!(cx.is_enabled(GL_POINT_SPRITE_ARB));
        cx.pop_attrib();
        assert!(!cx.is_enabled(GL_POINT_SPRITE_ARB));
    }
    cx.active_texture(GL_TEXTURE2);
    cx.tex_envf(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, 1.0);
    assert_eq!(replaces(&mut cx), 1);
    cx.active_texture(GL_TEXTURE0);
    assert_eq!(replaces(&mut cx), 0);
    raises(&mut cx, GL_INVALID_VALUE, |cx| cx.tex_envi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, 2));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_envi(GL_POINT_SPRITE_ARB, GL_TEXTURE_ENV_MODE, 1));
    raises(&mut cx, GL_INVALID_ENUM, |cx| cx.tex_envi(GL_TEXTURE_ENV, GL_COORD_REPLACE_ARB, 1));
}

#[test]
fn depth_stencil_textures_keep_depths_and_stencil_indices() {
    const PAIR: (GLenum, GLenum) = (GL_DEPTH_STENCIL_EXT, GL_UNSIGNED_INT_24_8_EXT);
    let groups: [u32; 6] = [0, 0xFFFF_FFFF, 0x8000_0012, 0x1234_5678, 0x0000_01FE, 0xABCD_EF00];
    let read = |cx: &mut Context| {
        let mut back = [0_u32; 6];
        cx.get_tex_image(GL_TEXTURE_2D, 0, PAIR.0, PAIR.1, &mut back);
        back
    };
    for internal in [GL_DEPTH_STENCIL_EXT, GL_DEPTH24_STENCIL8_EXT] {
        let mut cx = Context::new(3, 2);
        cx.tex_image_2d(GL_TEXTURE_2D, 0, internal, 3, 2, 0, PAIR.0, PAIR.1, &groups);
        assert_eq!((read(&mut cx), cx.check()), (groups, Ok(())));
        let size = |cx: &mut Context, pname| {
            let mut value = [-1];
            cx.get_tex_level_parameteriv(GL_TEXTURE_2D, 0, pname, &mut value);
            value[0]
        };
        assert_eq!([size(&mut cx, GL_TEXTURE_STENCIL_SIZE_EXT), size(&mut cx, GL_TEXTURE_DEPTH_SIZE)], [8, 24]);
        // A part of it; depths alone leave the stencil indices.
        cx.tex_sub_image_2d(GL_TEXTURE_2D, 0, 1, 0, 1, 1, PAIR.0, PAIR.1, &[0x0102_0304_u32]);
        cx.tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 1, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &[u32::MAX]);
        let want = [groups[0], 0x0102_0304, groups[2], 0xFFFF_FF78, groups[4], groups[5]];
        assert_eq!((read(&mut cx), cx.check()), (want, Ok(())));
        // The framebuffer gives both.
        cx.clear_depth(1.0);
        cx.clear_stencil(0x5A);
        cx.clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        cx.copy_tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 3, 2);
        assert_eq!((read(&mut cx), cx.check()), ([0xFFFF_FF5A; 6], Ok(())));
        cx.copy_tex_image_2d(GL_TEXTURE_2D, 0, internal, 0, 0, 3, 2, 0);
        assert_eq!((read(&mut cx), cx.check()), ([0xFFFF_FF5A; 6], Ok(())));
    }
}

#[test]
fn what_does_not_go_with_depth_and_stencil_is_refused() {
    let mut cx = Context::new(2, 2);
    let image = |cx: &mut Context, internal: GLenum, format, type_| {
        cx.tex_image_2d(GL_TEXTURE_2D, 0, internal, 1, 1, 0, format, type_, &[0_u32; 4]);
    };
    let (pair, packed) = (GL_DEPTH_STENCIL_EXT, GL_UNSIGNED_INT_24_8_EXT);
    raises(&mut cx, GL_INVALID_OPERATION, |cx| image(cx, GL_RGBA, pair, packed));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| image(cx, pair, GL_RGBA, GL_UNSIGNED_BYTE));
    raises(&mut cx, GL_INVALID_ENUM, |cx| image(cx, pair, pair, GL_UNSIGNED_INT));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| image(cx, pair, GL_DEPTH_COMPONENT, packed));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| {
        cx.tex_image_3d(GL_TEXTURE_3D, 0, pair, 1, 1, 1, 0, pair, packed, &[0_u32; 4]);
    });
    // Depths may be given to both kinds; a plain depth texture has no stencil indices to give.
    image(&mut cx, pair, GL_DEPTH_COMPONENT, GL_FLOAT);
    image(&mut cx, GL_DEPTH_COMPONENT, pair, packed);
    assert_eq!(cx.check(), Ok(()));
    raises(&mut cx, GL_INVALID_OPERATION, |cx| cx.get_tex_image(GL_TEXTURE_2D, 0, pair, packed, &mut [0_u32; 1]));
    for (internal, want) in [(GL_RGBA, 0), (GL_DEPTH_COMPONENT24, 0), (GL_DEPTH24_STENCIL8_EXT, 8)] {
        cx.tex_image_2d(GL_PROXY_TEXTURE_2D, 0, internal, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, fixedgl::NULL);
        cx.tex_image_2d(GL_PROXY_TEXTURE_2D, 0, internal, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, fixedgl::NULL);
        let _ = cx.check();
        let mut size = [-1];
        cx.get_tex_level_parameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_STENCIL_SIZE_EXT, &mut size);
        assert_eq!(size[0], want, "{}", name(internal));
    }
}
