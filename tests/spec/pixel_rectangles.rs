//! DrawPixels, CopyPixels, Bitmap, the raster position and PixelZoom (sections 2.12, 3.6.4, 3.6.5, 3.7, 4.3.3) through the
//! commands of a context. Pictures are compared with integer arithmetic on the definitions.

use crate::everywhere::{Frame, reference, variants};
use crate::support::Random;
use fixedgl::enums::*;
use fixedgl::{Config, Context};

const SIZE: i32 = 32;

/// A context with one unit of object coordinates a pixel.
fn context() -> Context {
    let mut gl = Context::new(SIZE as u32, SIZE as u32);
    gl.ortho(0, SIZE, 0, SIZE, -1, 1);
    gl
}

fn pixels(gl: &mut Context) -> Vec<[u8; 4]> {
    let mut out = vec![[0u8; 4]; (SIZE * SIZE) as usize];
    gl.read_pixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, &mut out);
    assert_eq!(gl.get_error(), GL_NO_ERROR);
    out
}

fn depths(gl: &mut Context) -> Vec<u32> {
    let mut out = vec![0u32; (SIZE * SIZE) as usize];
    gl.read_pixels(0, 0, SIZE, SIZE, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &mut out);
    out
}

fn stencils(gl: &mut Context) -> Vec<u8> {
    let mut out = vec![0u8; (SIZE * SIZE) as usize];
    gl.pixel_storei(GL_PACK_ALIGNMENT, 1);
    gl.read_pixels(0, 0, SIZE, SIZE, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &mut out);
    out
}

fn doubles(gl: &mut Context, pname: GLenum) -> [f64; 4] {
    let mut value = [0.0; 4];
    gl.get_doublev(pname, &mut value);
    value
}

/// The group that a pixel shows, by section 3.6.4.
fn shown(pixel: i32, start: f64, zoom: f64, count: i32) -> Option<i32> {
    let centre = f64::from(pixel) + 0.5;
    (0..count).find(|n| {
        let (a, b) = (start + zoom * f64::from(*n), start + zoom * f64::from(n + 1));
        a.min(b) <= centre && centre < a.max(b)
    })
}

#[test]
fn each_group_covers_the_pixels_of_its_rectangle() {
    let mut random = Random(3);
    for round in 0..300 {
        let mut gl = context();
        let size = [1 + random.below(9) as i32, 1 + random.below(9) as i32];
        let image: Vec<[u8; 4]> = (0..size[0] * size[1]).map(|_| [(); 4].map(|()| random.below(256) as u8)).collect();
        let at = [0; 2].map(|_| random.below(160) as f64 / 4.0 - 4.0);
        let zoom = [0; 2].map(|_| match round % 3 {
            0 => 1.0,
            1 => random.below(33) as f64 / 4.0 - 4.0,
            _ => random.below(1 << 20) as f64 / f64::from(1 << 17) - 4.0,
        });
        gl.window_pos2d(at[0], at[1]);
        gl.pixel_zoom(zoom[0] as f32, zoom[1] as f32);
        gl.draw_pixels(size[0], size[1], GL_RGBA, GL_UNSIGNED_BYTE, &image);
        let (zoom, got) = (zoom.map(|z| f64::from(z as f32)), pixels(&mut gl));
        let at = at.map(|v| f64::from(v as f32));
        for y in 0..SIZE {
            for x in 0..SIZE {
                let group = shown(x, at[0], zoom[0], size[0]).zip(shown(y, at[1], zoom[1], size[1]));
                let want = group.map_or([0; 4], |(n, m)| image[(m * size[0] + n) as usize]);
                assert_eq!(got[(y * SIZE + x) as usize], want, "{size:?} at {at:?} zoom {zoom:?}: pixel {x} {y}");
            }
        }
    }
}

#[test]
fn formats_and_types_give_the_colours_that_textures_get() {
    // A 1 x 1 texture that is drawn with NEAREST and REPLACE has the colour of the same pixel drawn by DrawPixels.
    let formats =
        [GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA, GL_BGR, GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA];
    let packed = [GL_UNSIGNED_INT_8_8_8_8, GL_UNSIGNED_SHORT_4_4_4_4, GL_UNSIGNED_INT_2_10_10_10_REV];
    let mut rows = Vec::new();
    for format in formats {
        for type_ in [GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT] {
            rows.push((format, type_));
        }
    }
    rows.extend(packed.map(|type_| (GL_RGBA, type_)));
    rows.extend([(GL_RGB, GL_UNSIGNED_SHORT_5_6_5), (GL_RGB, GL_UNSIGNED_BYTE_3_3_2)]);
    let bytes: Vec<u8> = (0..16).map(|i| 17 + 13 * i).collect();
    for (format, type_) in rows {
        for scaled in [false, true] {
            let mut gl = context();
            if scaled {
                gl.pixel_transferf(GL_GREEN_SCALE, 0.5);
                gl.pixel_transferf(GL_RED_BIAS, 0.25);
            }
            gl.raster_pos2i(3, 4);
            gl.draw_pixels(1, 1, format, type_, &bytes);
            gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 1, 1, 0, format, type_, &bytes);
            // Pixel transfer would apply to what is read, too.
            gl.pixel_transferf(GL_GREEN_SCALE, 1.0);
            gl.pixel_transferf(GL_RED_BIAS, 0.0);
            let drawn = pixels(&mut gl)[(4 * SIZE + 3) as usize];
            let mut texel = [0u8; 4];
            gl.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &mut texel);
            assert_eq!(gl.get_error(), GL_NO_ERROR);
            assert_eq!(drawn, texel, "{format:#X} {type_:#X} scaled {scaled}");
        }
    }
}

#[test]
fn pixels_go_through_the_fragment_operations() {
    // Each row: a state, and what becomes of one pixel of colour (200, 100, 50, 128) over (10, 20, 30, 40).
    type Setup = fn(&mut Context);
    let rows: [(&str, Setup, [u8; 4]); 8] = [
        ("nothing", |_| {}, [200, 100, 50, 128]),
        (
            "blend",
            |gl| {
                gl.enable(GL_BLEND);
                gl.blend_func(GL_ONE, GL_ONE)
            },
            [210, 120, 80, 168],
        ),
        (
            "alpha test",
            |gl| {
                gl.enable(GL_ALPHA_TEST);
                gl.alpha_func(GL_GREATER, 0.6)
            },
            [10, 20, 30, 40],
        ),
        ("mask", |gl| gl.color_mask(true, false, true, false), [200, 20, 50, 40]),
        (
            "logic op",
            |gl| {
                gl.enable(GL_COLOR_LOGIC_OP);
                gl.logic_op(GL_XOR)
            },
            [200 ^ 10, 100 ^ 20, 50 ^ 30, 128 ^ 40],
        ),
        (
            "scissor",
            |gl| {
                gl.enable(GL_SCISSOR_TEST);
                gl.scissor(0, 0, 3, 3)
            },
            [10, 20, 30, 40],
        ),
        (
            "depth",
            |gl| {
                gl.enable(GL_DEPTH_TEST);
                gl.depth_func(GL_GREATER)
            },
            [10, 20, 30, 40],
        ),
        (
            "fog",
            |gl| {
                gl.enable(GL_FOG);
                gl.fogi(GL_FOG_MODE, GL_LINEAR as i32);
                gl.fogf(GL_FOG_START, 1e9);
                gl.fogf(GL_FOG_END, 1e9 - 100.0);
                gl.fogfv(GL_FOG_COLOR, &[1.0, 0.0, 0.0, 0.0]);
            },
            [255, 0, 0, 128],
        ),
    ];
    for (name, setup, want) in rows {
        let mut gl = context();
        gl.clear_color(10.0 / 255.0, 20.0 / 255.0, 30.0 / 255.0, 40.0 / 255.0);
        gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl.raster_pos2i(5, 5);
        setup(&mut gl);
        // Wide enough for the way of spans, too.
        for width in [1, 27] {
            gl.draw_pixels(width, 1, GL_RGBA, GL_UNSIGNED_BYTE, &vec![[200u8, 100, 50, 128]; width as usize]);
            let got = pixels(&mut gl)[(5 * SIZE + 5) as usize];
            assert_eq!(got, want, "{name}, {width} pixels");
            gl.disable(GL_SCISSOR_TEST);
            gl.color_mask(true, true, true, true);
            gl.clear(GL_COLOR_BUFFER_BIT);
            setup(&mut gl);
        }
    }
}

#[test]
fn texturing_applies_with_the_texture_coordinates_of_the_raster_position() {
    let mut gl = context();
    gl.enable(GL_TEXTURE_2D);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST as i32);
    let texels = [[255u8, 0, 0, 255], [0, 255, 0, 255]];
    gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as i32, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    for (s, want) in [(0.25, [200, 0, 0, 255]), (0.75, [0, 100, 0, 255])] {
        gl.tex_coord2f(s, 0.5);
        gl.raster_pos2i(2, 2);
        gl.draw_pixels(2, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[[200u8, 100, 50, 255]; 2]);
        assert_eq!(pixels(&mut gl)[(2 * SIZE + 3) as usize], want, "s = {s}");
        gl.bitmap(8, 1, 0.0, 0.0, 0.0, 0.0, &[0xFFu8]);
        let white = want.map(|c| if c == 0 { 0 } else { 255 });
        assert_eq!(pixels(&mut gl)[(2 * SIZE + 3) as usize], white, "a bitmap, s = {s}");
    }
}

#[test]
fn depths_become_fragments_of_the_raster_colour() {
    for (bits, type_max) in [(24u32, u32::MAX)] {
        let mut gl = context();
        gl.clear_depth(1.0);
        gl.clear(GL_DEPTH_BUFFER_BIT);
        gl.enable(GL_DEPTH_TEST);
        gl.color3ub(10, 20, 30);
        gl.raster_pos2i(1, 1);
        let image: Vec<u32> = (0..25u32).map(|i| (f64::from(type_max) * f64::from(i) / 30.0) as u32).collect();
        gl.draw_pixels(25, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &image);
        let (colors, got) = (pixels(&mut gl), depths(&mut gl));
        for (i, want) in image.iter().enumerate() {
            let at = (SIZE + 1) as usize + i;
            let step = 1u32 << (32 - bits);
            assert!(got[at].abs_diff(*want) <= 2 * step, "{i}: {} {want}", got[at]);
            assert_eq!(colors[at], [10, 20, 30, 255]);
        }
        // Deeper ones fail, nearer ones pass.
        let half: Vec<f32> = image.iter().map(|d| (f64::from(*d) / f64::from(u32::MAX)) as f32 * 0.5 + 0.2).collect();
        gl.color3ub(0, 255, 0);
        gl.raster_pos2i(1, 1);
        gl.draw_pixels(25, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &half);
        let colors = pixels(&mut gl);
        for (i, (old, new)) in image.iter().zip(&half).enumerate() {
            let passes = f64::from(*new) < f64::from(*old) / f64::from(u32::MAX);
            assert_eq!(colors[(SIZE + 1) as usize + i][1] == 255, passes, "{i}");
        }
    }
}

#[test]
fn stencil_indices_go_straight_into_the_buffer_under_the_mask() {
    let mut gl = context();
    gl.clear_stencil(0xF0);
    gl.clear(GL_STENCIL_BUFFER_BIT);
    gl.stencil_mask(0x0F);
    gl.enable(GL_ALPHA_TEST);
    gl.alpha_func(GL_NEVER, 0.0);
    gl.pixel_transferi(GL_INDEX_OFFSET, 1);
    gl.pixel_zoom(2.0, -1.0);
    gl.window_pos2i(4, 10);
    gl.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    gl.draw_pixels(3, 2, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &[0x11u8, 0x22, 0x33, 0x44, 0x55, 0x66]);
    gl.pixel_transferi(GL_INDEX_OFFSET, 0);
    let got = stencils(&mut gl);
    let image = [[0x12, 0x23, 0x34], [0x45, 0x56, 0x67]];
    for y in 0..SIZE {
        for x in 0..SIZE {
            let inside = (4..10).contains(&x) && (8..10).contains(&y);
            let want = if inside { 0xF0 | (image[(9 - y) as usize][((x - 4) / 2) as usize] & 0x0F) } else { 0xF0 };
            assert_eq!(got[(y * SIZE + x) as usize], want, "{x} {y}");
        }
    }
    // A picture beside it is not touched.
    assert!(pixels(&mut gl).iter().all(|p| *p == [0; 4]));
}

#[test]
fn copies_take_what_was_there_even_where_they_overlap() {
    for (what, dx, dy) in [(GL_COLOR, 3, 2), (GL_COLOR, -3, -2), (GL_DEPTH, 1, 0), (GL_STENCIL, 0, 1)] {
        let mut gl = context();
        let mut random = Random(9);
        let colors: Vec<[u8; 4]> = (0..SIZE * SIZE).map(|_| [(); 4].map(|()| random.below(256) as u8)).collect();
        let values: Vec<u32> = (0..SIZE * SIZE).map(|_| (random.below(1 << 24) << 8) as u32).collect();
        let indices: Vec<u8> = (0..SIZE * SIZE).map(|_| random.below(256) as u8).collect();
        gl.raster_pos2i(0, 0);
        gl.draw_pixels(SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, &colors);
        gl.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        gl.draw_pixels(SIZE, SIZE, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &indices);
        gl.enable(GL_DEPTH_TEST);
        gl.depth_func(GL_ALWAYS);
        gl.color_mask(false, false, false, false);
        gl.draw_pixels(SIZE, SIZE, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &values);
        gl.color_mask(true, true, true, true);
        if what != GL_DEPTH {
            gl.disable(GL_DEPTH_TEST);
        }
        let before = (pixels(&mut gl), depths(&mut gl), stencils(&mut gl));
        assert_eq!(before.0, colors);
        assert_eq!(before.2, indices);
        if what == GL_DEPTH {
            gl.color_mask(false, false, false, false);
        }
        gl.raster_pos2i(8 + dx, 8 + dy);
        gl.copy_pixels(8, 8, 12, 10, what);
        let after = (pixels(&mut gl), depths(&mut gl), stencils(&mut gl));
        for y in 0..SIZE {
            for x in 0..SIZE {
                let (sx, sy) = (x - dx, y - dy);
                let inside = (8..20).contains(&sx) && (8..18).contains(&sy);
                let (at, from) = ((y * SIZE + x) as usize, (sy * SIZE + sx) as usize);
                let source = |of: GLenum| if inside && what == of { from } else { at };
                assert_eq!(after.0[at], before.0[source(GL_COLOR)], "{what:#X} colour {x} {y}");
                assert_eq!(after.1[at], before.1[source(GL_DEPTH)], "{what:#X} depth {x} {y}");
                assert_eq!(after.2[at], before.2[source(GL_STENCIL)], "{what:#X} stencil {x} {y}");
            }
        }
    }
}

#[test]
fn bitmaps_colour_the_pixels_of_their_bits_and_move_the_raster_position() {
    let mut random = Random(4);
    for _ in 0..300 {
        let mut gl = context();
        let size = [random.below(24) as i32, random.below(24) as i32];
        let (skip, lsb_first) = (random.below(11) as i32, random.below(2) == 1);
        let row_length = size[0] + skip + random.below(9) as i32;
        let stride = (row_length as usize).div_ceil(8);
        let bytes: Vec<u8> = (0..stride * 26).map(|_| random.below(256) as u8).collect();
        gl.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
        gl.pixel_storei(GL_UNPACK_ROW_LENGTH, row_length);
        gl.pixel_storei(GL_UNPACK_SKIP_PIXELS, skip);
        gl.pixel_storei(GL_UNPACK_LSB_FIRST, i32::from(lsb_first));
        let quarter = |random: &mut Random| random.below(160) as f64 / 4.0 - 8.0;
        let (at, origin) = ([quarter(&mut random), quarter(&mut random)], [quarter(&mut random), quarter(&mut random)]);
        gl.color3ub(255, 128, 0);
        gl.window_pos2d(at[0], at[1]);
        // The zoom does not apply to bitmaps.
        gl.pixel_zoom(3.0, -2.0);
        gl.bitmap(size[0], size[1], origin[0] as f32, origin[1] as f32, 1.5, -0.25, &bytes);
        let got = pixels(&mut gl);
        let corner = [0, 1].map(|i| (at[i] - origin[i]).floor() as i32);
        for y in 0..SIZE {
            for x in 0..SIZE {
                let (n, m) = (x - corner[0], y - corner[1]);
                let inside = (0..size[0]).contains(&n) && (0..size[1]).contains(&m);
                let bit = inside && {
                    let at = (n + skip) as usize;
                    let byte = bytes[m as usize * stride + at / 8];
                    if lsb_first { byte >> (at % 8) & 1 == 1 } else { byte << (at % 8) & 0x80 != 0 }
                };
                let want = if bit { [255, 128, 0, 255] } else { [0; 4] };
                assert_eq!(got[(y * SIZE + x) as usize], want, "{size:?} at {at:?} origin {origin:?}: {x} {y}");
            }
        }
        let [x, y, ..] = doubles(&mut gl, GL_CURRENT_RASTER_POSITION);
        assert_eq!([x, y], [at[0] + 1.5, at[1] - 0.25]);
    }
}

#[test]
fn an_invalid_raster_position_draws_nothing_and_does_not_move() {
    let mut gl = context();
    gl.raster_pos2f(SIZE as f32 + 0.5, 4.0);
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_POSITION_VALID)[0], 0.0);
    let before = doubles(&mut gl, GL_CURRENT_RASTER_POSITION);
    gl.bitmap(8, 1, 0.0, 0.0, -20.0, 0.0, &[0xFFu8]);
    gl.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[255u8; 4]);
    assert!(pixels(&mut gl).iter().all(|p| *p == [0; 4]));
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_POSITION), before);
    // A position on the border is inside, and a bitmap without bits moves it beyond without making it invalid.
    gl.raster_pos2f(SIZE as f32, 4.0);
    gl.bitmap(0, 0, 0.0, 0.0, 5.0, 0.0, fixedgl::NULL);
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_POSITION_VALID)[0], 1.0);
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_POSITION)[0], f64::from(SIZE) + 5.0);
    // A user clip plane cuts it off.
    gl.clip_plane(GL_CLIP_PLANE0, &[1.0, 0.0, 0.0, -10.0]);
    gl.enable(GL_CLIP_PLANE0);
    for (x, valid) in [(9.0, 0.0), (10.0, 1.0), (11.0, 1.0)] {
        gl.raster_pos2d(x, 4.0);
        assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_POSITION_VALID)[0], valid, "x = {x}");
    }
}

#[test]
fn the_raster_position_takes_what_the_vertex_stages_make() {
    let mut gl = context();
    gl.load_identity();
    gl.translatef(0.25, -0.5, 0.5);
    gl.depth_range(0.2, 0.6);
    gl.matrix_mode(GL_TEXTURE);
    gl.scalef(2.0, 3.0, 4.0);
    gl.matrix_mode(GL_MODELVIEW);
    gl.color4f(0.5, 0.25, 2.0, 0.75);
    gl.tex_coord3f(1.0, 2.0, 3.0);
    gl.raster_pos4f(0.0, 1.0, -0.5, 2.0);
    // Clip coordinates (0.5, 0, 0.5, 2).
    let half = f64::from(SIZE) / 2.0;
    let want = [half * 1.25, half, 0.2 + 0.4 * (0.25 + 1.0) / 2.0, 2.0];
    let got = doubles(&mut gl, GL_CURRENT_RASTER_POSITION);
    assert!(got.iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-12), "{got:?} {want:?}");
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_COLOR), [0.5, 0.25, 1.0, 0.75]);
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_TEXTURE_COORDS), [2.0, 6.0, 12.0, 1.0]);
    // Lighting and texture generation apply to RasterPos, and not to WindowPos.
    gl.enable(GL_LIGHTING);
    gl.enable(GL_TEXTURE_GEN_S);
    gl.tex_geni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR as i32);
    gl.tex_genfv(GL_S, GL_OBJECT_PLANE, &[0.0, 5.0, 0.0, 0.0]);
    gl.materialfv(GL_FRONT, GL_EMISSION, &[0.5, 0.0, 0.25, 1.0]);
    gl.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0; 4]);
    gl.raster_pos4f(0.0, 1.0, -0.5, 2.0);
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_COLOR)[..3], [0.5, 0.0, 0.25]);
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_TEXTURE_COORDS), [10.0, 6.0, 12.0, 1.0]);
    gl.window_pos3f(3.0, 4.0, 0.5);
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_COLOR), [0.5, 0.25, 1.0, 0.75]);
    assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_TEXTURE_COORDS), [1.0, 2.0, 3.0, 1.0]);
    let got = doubles(&mut gl, GL_CURRENT_RASTER_POSITION);
    assert!(got.iter().zip([3.0, 4.0, 0.4, 1.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{got:?}");
}

#[test]
fn errors_change_nothing() {
    type Call = fn(&mut Context);
    let rows: [(&str, Call, GLenum); 9] = [
        ("negative width", |gl| gl.draw_pixels(-1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &[0u8; 4]), GL_INVALID_VALUE),
        ("no format", |gl| gl.draw_pixels(1, 1, GL_LINEAR, GL_UNSIGNED_BYTE, &[0u8; 4]), GL_INVALID_ENUM),
        ("no type", |gl| gl.draw_pixels(1, 1, GL_RGBA, GL_LINEAR, &[0u8; 4]), GL_INVALID_ENUM),
        ("bits of colours", |gl| gl.draw_pixels(1, 1, GL_RGBA, GL_BITMAP, &[0u8; 4]), GL_INVALID_ENUM),
        ("packed pair", |gl| gl.draw_pixels(1, 1, GL_RGB, GL_UNSIGNED_INT_8_8_8_8, &[0u8; 4]), GL_INVALID_OPERATION),
        ("no kind", |gl| gl.copy_pixels(0, 0, 1, 1, GL_RGBA), GL_INVALID_ENUM),
        ("negative height", |gl| gl.copy_pixels(0, 0, 1, -1, GL_COLOR), GL_INVALID_VALUE),
        ("negative bitmap", |gl| gl.bitmap(-1, 1, 0.0, 0.0, 1.0, 0.0, &[0u8]), GL_INVALID_VALUE),
        (
            "within Begin",
            |gl| {
                gl.begin(GL_POINTS);
                gl.bitmap(1, 1, 0.0, 0.0, 1.0, 0.0, &[0u8]);
                gl.end();
            },
            GL_INVALID_OPERATION,
        ),
    ];
    for (name, call, want) in rows {
        let mut gl = context();
        call(&mut gl);
        assert_eq!(gl.get_error(), want, "{name}");
        assert_eq!(doubles(&mut gl, GL_CURRENT_RASTER_POSITION), [0.0, 0.0, 0.0, 1.0], "{name}");
        assert!(pixels(&mut gl).iter().all(|p| *p == [0; 4]), "{name}");
    }
}

#[test]
fn lists_hold_pixels_and_bitmaps() {
    let draw = |gl: &mut Context| {
        gl.color3ub(0, 0, 255);
        gl.raster_pos2i(2, 3);
        gl.bitmap(8, 2, 0.0, 0.0, 9.0, 1.0, &[0b1010_1100u8, 0, 0, 0, 0b0101_0011, 0, 0, 0]);
        gl.draw_pixels(
            2,
            2,
            GL_RGBA,
            GL_UNSIGNED_BYTE,
            &[[1u8, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12], [13, 14, 15, 16]],
        );
        gl.copy_pixels(2, 3, 12, 3, GL_COLOR);
    };
    let mut gl = context();
    draw(&mut gl);
    let want = pixels(&mut gl);
    let mut gl = context();
    gl.new_list(7, GL_COMPILE);
    draw(&mut gl);
    gl.end_list();
    assert!(pixels(&mut gl).iter().all(|p| *p == [0; 4]));
    gl.call_list(7);
    assert_eq!(pixels(&mut gl), want);
}

#[test]
fn every_way_of_running_gives_the_same_bytes() {
    let draw = |config: Config| {
        let mut random = Random(77);
        let mut gl = Context::with_config(200, 150, config);
        gl.ortho(0.0, 200.0, 0.0, 150.0, -1.0, 1.0);
        gl.clear_color(0.2, 0.4, 0.6, 0.8);
        gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGB as i32, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, &[200u8, 150, 100, 0]);
        gl.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR as i32);
        let image: Vec<u8> = (0..64 * 64 * 4).map(|_| random.below(256) as u8).collect();
        let floats: Vec<f32> = (0..64 * 64 * 4).map(|_| random.range(0.0, 1.0) as f32).collect();
        for _ in 0..120 {
            for cap in [GL_BLEND, GL_DEPTH_TEST, GL_TEXTURE_2D, GL_FOG, GL_ALPHA_TEST, GL_STENCIL_TEST, GL_LINE_SMOOTH]
            {
                if random.below(3) == 0 { gl.enable(cap) } else { gl.disable(cap) }
            }
            gl.blend_func(GL_SRC_ALPHA, random.pick(&[GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_DST_COLOR]));
            gl.alpha_func(GL_GREATER, 0.3);
            gl.depth_func(random.pick(&[GL_LESS, GL_LEQUAL, GL_GREATER, GL_ALWAYS]));
            gl.stencil_op(GL_KEEP, GL_INCR, GL_INVERT);
            gl.color4f(random.range(0.0, 1.0) as f32, 0.5, 0.25, 0.75);
            gl.raster_pos3d(random.range(0.0, 200.0), random.range(0.0, 150.0), random.range(-1.0, 1.0));
            gl.pixel_zoom(random.pick(&[1.0, 1.0, 2.5, -1.0, 0.3]), random.pick(&[1.0, 1.0, -2.0, 0.7]));
            match random.below(6) {
                0 => gl.draw_pixels(64, 60, GL_RGBA, GL_UNSIGNED_BYTE, &image),
                1 => gl.draw_pixels(30, 64, GL_LUMINANCE, GL_FLOAT, &floats),
                2 => gl.draw_pixels(64, 20, GL_DEPTH_COMPONENT, GL_FLOAT, &floats),
                3 => gl.bitmap(61, 37, 3.0, 2.0, 0.0, 0.0, &image),
                4 => gl.copy_pixels(20, 10, 90, 40, random.pick(&[GL_COLOR, GL_DEPTH, GL_STENCIL])),
                _ => gl.rectd(10.0, 20.0, random.range(20.0, 190.0), 140.0),
            }
        }
        assert_eq!(gl.get_error(), GL_NO_ERROR);
        Frame::of(&mut gl)
    };
    let want = draw(reference());
    for config in variants() {
        assert!(draw(config) == want, "{config:?}");
    }
}
