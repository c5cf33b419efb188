//! Texture filters (OpenGL 1.5, sections 3.8.8 and 3.8.9): NEAREST takes the oracle's texel wherever the coordinate is more
//! than 2^-10 texel from a boundary, LINEAR and the mipmap filters give the oracle's colour within one step of 8 bits.

use crate::oracle::scene::Scene;
use crate::oracle::texel::{Image, Texture};
use crate::support::compare::{EDGES, Figures, NEAREST, compare};
use crate::support::images::{BASE_FORMATS, bytes, chain, nearest, noise, numbered};
use crate::support::scenes::{facing, floor, heap, replace};
use crate::support::{Random, no_error};
use fixedgl::Context;
use fixedgl::enums::*;

const WRAPS: [GLenum; 4] = [GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT, GL_CLAMP_TO_BORDER];

fn textured(mut scene: Scene, texture: Texture) -> Scene {
    scene.units = vec![replace(texture)];
    scene
}

fn one_level(target: GLenum, image: Image) -> Texture {
    Texture::new(target, GL_RGBA, vec![vec![image]])
}

fn linear(mut texture: Texture) -> Texture {
    texture.lod.min_filter = GL_LINEAR;
    texture
}

#[test]
fn the_initial_filters_are_the_tables() {
    let mut cx = Context::new(4, 4);
    let mut v = [0i32];
    cx.get_tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &mut v);
    assert_eq!(v[0] as u32, GL_NEAREST_MIPMAP_LINEAR);
    cx.get_tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, &mut v);
    assert_eq!(v[0] as u32, GL_LINEAR);
    cx.get_tex_parameteriv(GL_TEXTURE_RECTANGLE_ARB, GL_TEXTURE_MIN_FILTER, &mut v);
    assert_eq!(v[0] as u32, GL_LINEAR);
    no_error(&mut cx);
}

#[test]
fn nearest_takes_the_texel_of_the_oracle() {
    let mut figures = Figures::default();
    let mut random = Random(7);
    for (i, size) in [[64, 64, 1], [80, 80, 1], [37, 5, 1], [1, 64, 1], [83, 83, 1]].into_iter().enumerate() {
        let mut t = nearest(one_level(GL_TEXTURE_2D, numbered(size, [0; 3], 0)));
        t.wrap = [random.pick(&WRAPS), random.pick(&WRAPS), GL_REPEAT];
        t.border_color = bytes([1, 2, 3, 4]);
        for scene in [heap(96, 96, 12, 3.0, 11 + i as u64), floor(96, 96, 40.0, 0.7, 23.0)] {
            let f = compare(&textured(scene, t.clone()), NEAREST);
            f.exact(&format!("NEAREST {size:?}"));
            figures.compared += f.compared;
            figures.doubtful += f.doubtful;
        }
    }
    eprintln!(
        "NEAREST: 0 wrong texels in {} pixels, {:.2} % doubtful",
        figures.compared,
        100.0 * figures.doubtful as f64 / (figures.compared + figures.doubtful) as f64
    );
}

#[test]
fn nearest_in_one_and_three_dimensions_and_rectangles() {
    let t1 = nearest(one_level(GL_TEXTURE_1D, numbered([64, 1, 1], [0; 3], 0)));
    compare(&textured(heap(96, 96, 10, 2.0, 3), t1), NEAREST).exact("NEAREST 1D");
    let t3 = nearest(one_level(GL_TEXTURE_3D, numbered([16, 8, 12], [0; 3], 0)));
    compare(&textured(heap(96, 96, 10, 2.0, 4), t3), NEAREST).exact("NEAREST 3D");
    let rect = nearest(one_level(GL_TEXTURE_RECTANGLE_ARB, numbered([50, 31, 1], [0; 3], 0)));
    compare(&textured(heap(96, 96, 10, 60.0, 5), rect), NEAREST).exact("NEAREST rectangle");
}

#[test]
fn linear_is_within_one_lsb() {
    let mut all = Figures::default();
    let mut random = Random(5);
    let targets = [
        (GL_TEXTURE_1D, [64, 1, 1]),
        (GL_TEXTURE_2D, [64, 32, 1]),
        (GL_TEXTURE_2D, [61, 19, 1]),
        (GL_TEXTURE_3D, [16, 8, 4]),
        (GL_TEXTURE_RECTANGLE_ARB, [40, 30, 1]),
    ];
    for (i, (target, size)) in targets.into_iter().enumerate() {
        let mut t = linear(one_level(target, noise(size, [0; 3], i as u64, GL_RGBA)));
        if target != GL_TEXTURE_RECTANGLE_ARB {
            t.wrap = std::array::from_fn(|_| random.pick(&WRAPS));
        }
        t.border_color = bytes([200, 100, 50, 25]);
        let range = if target == GL_TEXTURE_RECTANGLE_ARB { 50.0 } else { 2.5 };
        let f = compare(&textured(heap(128, 128, 12, range, 40 + i as u64), t), EDGES);
        f.print(&format!("LINEAR {target:#x} {size:?}"));
        all.merge(&f);
    }
    all.within_one_lsb("LINEAR, all targets");
}

#[test]
fn mipmap_filters_are_within_one_lsb() {
    for min in [GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR]
    {
        let mut all = Figures::default();
        for (i, size) in [[128, 128, 1], [64, 16, 1], [45, 77, 1]].into_iter().enumerate() {
            let make = |s, level| noise(s, [0; 3], 100 + level as u64, GL_RGBA);
            let mut t = chain(GL_TEXTURE_2D, GL_RGBA, size, make);
            t.lod.min_filter = min;
            t.lod.mag_filter = if i == 1 { GL_NEAREST } else { GL_LINEAR };
            let sharp = min == GL_NEAREST_MIPMAP_NEAREST || min == GL_NEAREST_MIPMAP_LINEAR || i == 1;
            let doubt = if sharp { NEAREST } else { EDGES };
            all.merge(&compare(&textured(floor(128, 128, 60.0, 0.25, 31.0), t.clone()), doubt));
            all.merge(&compare(&textured(heap(128, 128, 8, 6.0, 9 + i as u64), t), doubt));
        }
        let name = format!("minification {}", fixedgl::enums::name(min));
        if min == GL_LINEAR_MIPMAP_LINEAR || min == GL_NEAREST_MIPMAP_LINEAR {
            all.within_one_lsb(&name);
        } else {
            // A lambda on the tie between two levels may fall to either side: a handful of pixels at most.
            all.print(&name);
            assert!(all.drawn > 10_000 && all.share() < 1e-3, "{name}: {:?}", all.place);
        }
    }
}

#[test]
fn coordinates_over_many_texels_cost_a_fraction_of_an_lsb() {
    // 7000 texels across one triangle: an f32 coordinate is known to 2^-11 texel there, which is at most an eighth LSB.
    let mut t = chain(GL_TEXTURE_2D, GL_RGBA, [128, 128, 1], |s, level| noise(s, [0; 3], 9 + level as u64, GL_RGBA));
    t.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    let f = compare(&textured(floor(128, 128, 60.0, 0.9, 31.0), t), EDGES);
    f.print("trilinear over 7000 texels");
    assert!(f.drawn > 5000 && f.off == 0 && f.worst < 0.625 && f.share() < 1e-2, "{f:?}");
}

#[test]
fn every_base_format_reads_its_components() {
    for base in BASE_FORMATS {
        let t = linear(Texture::flat(base, noise([16, 16, 1], [0; 3], 77, base)));
        compare(&textured(facing(64, 64, [0.1, -0.3], [1.7, 1.1]), t), EDGES)
            .within_one_lsb(&format!("base {base:#x}"));
    }
}

#[test]
fn a_texel_a_pixel_is_copied_exactly() {
    for filter in [GL_NEAREST, GL_LINEAR] {
        let mut t = one_level(GL_TEXTURE_2D, noise([64, 64, 1], [0; 3], 3, GL_RGBA));
        t.lod.min_filter = filter;
        t.lod.mag_filter = filter;
        compare(&textured(facing(64, 64, [0.0, 0.0], [1.0, 1.0]), t), EDGES).exact("one to one");
    }
}

#[test]
fn a_constant_texture_stays_constant() {
    let color = bytes([201, 77, 3, 129]);
    for min in [GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR] {
        let mut t = chain(GL_TEXTURE_2D, GL_RGBA, [32, 8, 1], |s, _| Image::new(s, [0; 3], |_| color));
        t.lod.min_filter = min;
        compare(&textured(heap(96, 96, 10, 5.0, 21), t), EDGES).exact("constant");
    }
}

#[test]
fn projective_coordinates_divide_by_q() {
    for (filter, doubt) in [(GL_NEAREST, NEAREST), (GL_LINEAR, EDGES)] {
        let mut t = one_level(GL_TEXTURE_2D, noise([32, 32, 1], [0; 3], 8, GL_RGBA));
        t.lod.min_filter = filter;
        t.lod.mag_filter = filter;
        let mut scene = textured(heap(96, 96, 10, 2.0, 33), t);
        let mut random = Random(99);
        for v in scene.triangles.iter_mut().flatten() {
            v.tex[0][3] = random.range(0.25, 4.0);
        }
        let f = compare(&scene, doubt);
        f.within_one_lsb("projective");
    }
}
