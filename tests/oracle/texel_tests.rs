//! The texel rules worked out by hand.

use super::super::assert_near;
use super::*;

fn ramp(n: i64) -> Texture {
    let image = Image::new([n, 1, 1], [0; 3], |[i, ..]| [i as f64; 4]);
    Texture { border_color: [100.0; 4], ..Texture::new(GL_TEXTURE_1D, GL_RGBA, vec![vec![image]]) }
}

fn at(t: &Texture, filter: GLenum, s: f64) -> f64 {
    t.filter(0, 0, filter, [s, 0.0, 0.0], 0.0)[0]
}

#[test]
fn nearest_wraps_in_every_mode() {
    let rows: [(GLenum, [i64; 7]); 8] = [
        // s =                         -1.1 -0.1  0.0 0.26 0.99  1.0 1.30
        (GL_REPEAT, [3, 3, 0, 1, 3, 0, 1]),
        (GL_CLAMP, [0, 0, 0, 1, 3, 3, 3]),
        (GL_CLAMP_TO_EDGE, [0, 0, 0, 1, 3, 3, 3]),
        (GL_CLAMP_TO_BORDER, [-1, -1, 0, 1, 3, 4, 4]),
        (GL_MIRRORED_REPEAT, [3, 0, 0, 1, 3, 3, 2]),
        (GL_MIRROR_CLAMP_EXT, [3, 0, 0, 1, 3, 3, 3]),
        (GL_MIRROR_CLAMP_TO_EDGE_EXT, [3, 0, 0, 1, 3, 3, 3]),
        (GL_MIRROR_CLAMP_TO_BORDER_EXT, [4, 0, 0, 1, 3, 4, 4]),
    ];
    for (mode, want) in rows {
        let got = [-1.1, -0.1, 0.0, 0.26, 0.99, 1.0, 1.3].map(|s| nearest_index(mode, s, 4));
        assert_eq!(got, want, "wrap mode {mode:#x}");
    }
}

#[test]
fn linear_between_texels_and_over_the_edge() {
    let mut t = ramp(4);
    // Texel centres at 1/8, 3/8 ..: half way between texels 1 and 2.
    assert_near(&[at(&t, GL_LINEAR, 0.5)], &[1.5], 1e-15);
    assert_near(&[at(&t, GL_LINEAR, 0.0)], &[1.5], 1e-15); // texels 3 and 0
    t.wrap[0] = GL_CLAMP;
    assert_near(&[at(&t, GL_LINEAR, 0.0), at(&t, GL_LINEAR, 5.0)], &[50.0, 51.5], 1e-15);
    t.wrap[0] = GL_CLAMP_TO_EDGE;
    assert_near(&[at(&t, GL_LINEAR, 0.0), at(&t, GL_LINEAR, 5.0)], &[0.0, 3.0], 1e-15);
    t.wrap[0] = GL_CLAMP_TO_BORDER;
    assert_near(
        &[at(&t, GL_LINEAR, -1.0), at(&t, GL_LINEAR, 1.0), at(&t, GL_LINEAR, 5.0)],
        &[100.0, 51.5, 100.0],
        1e-15,
    );
    t.wrap[0] = GL_MIRROR_CLAMP_TO_EDGE_EXT;
    assert_near(&[at(&t, GL_LINEAR, -0.5), at(&t, GL_LINEAR, -0.01)], &[1.5, 0.0], 1e-15);
}

#[test]
fn border_texels_are_used_where_the_image_has_them() {
    let image = Image::new([2, 1, 1], [1, 0, 0], |[i, ..]| [[7.0, 1.0, 2.0, 9.0][(i + 1) as usize]; 4]);
    let t = Texture { wrap: [GL_CLAMP; 3], ..Texture::new(GL_TEXTURE_1D, GL_RGBA, vec![vec![image]]) };
    assert_near(&[at(&t, GL_LINEAR, 0.0), at(&t, GL_LINEAR, 1.0)], &[4.0, 5.5], 1e-15);
    assert_near(&[at(&t, GL_NEAREST, 0.0), at(&t, GL_NEAREST, 1.0)], &[1.0, 2.0], 1e-15);
}

#[test]
fn two_and_three_dimensions_are_filtered() {
    let image = Image::from_fn(2, 2, |i, j| [(i + 10 * j) as f64; 4]);
    let t = Texture::flat(GL_RGBA, image);
    assert_near(&t.filter(0, 0, GL_LINEAR, [0.5, 0.5, 0.0], 0.0)[..1], &[5.5], 1e-15);
    assert_near(&t.filter(0, 0, GL_LINEAR, [0.375, 0.25, 0.0], 0.0)[..1], &[0.25], 1e-15);
    let image = Image::new([2, 2, 2], [0; 3], |[i, j, k]| [(i + 10 * j + 100 * k) as f64; 4]);
    let t = Texture::new(GL_TEXTURE_3D, GL_RGBA, vec![vec![image]]);
    assert_near(&t.filter(0, 0, GL_LINEAR, [0.5; 3], 0.0)[..1], &[55.5], 1e-13);
    assert_near(&t.filter(0, 0, GL_NEAREST, [0.9, 0.1, 0.9], 0.0)[..1], &[101.0], 1e-15);
}

#[test]
fn cube_faces_are_chosen_and_ties_are_broken() {
    assert_eq!(cube_face([2.0, 1.0, -1.0]), (0, [0.75, 0.25]));
    assert_eq!(cube_face([-2.0, 1.0, -1.0]), (1, [0.25, 0.25]));
    assert_eq!(cube_face([1.0, 2.0, -1.0]), (2, [0.75, 0.25]));
    assert_eq!(cube_face([1.0, -2.0, -1.0]), (3, [0.75, 0.75]));
    assert_eq!(cube_face([1.0, -1.0, 2.0]), (4, [0.75, 0.75]));
    assert_eq!(cube_face([1.0, -1.0, -2.0]), (5, [0.25, 0.75]));
    assert_eq!([cube_face([1.0, 1.0, 1.0]).0, cube_face([1.0, -1.0, 0.5]).0, cube_face([0.0; 3]).0], [4, 3, 4]);
    let (r, d, h) = ([2.0, 1.0, -1.0], [0.3, 0.2, -0.7], 1e-7);
    let ahead = cube_face(std::array::from_fn(|i| r[i] + d[i] * h)).1;
    assert_near(&face_derivative(0, r, d)[..2], &[(ahead[0] - 0.75) / h, (ahead[1] - 0.25) / h], 1e-6);
}

#[test]
fn a_sample_reports_its_level_and_its_distance_to_a_boundary() {
    let level = |n: i64, v: f64| vec![Image::from_fn(n, n, |_, _| [v; 4])];
    let mut t = Texture::new(GL_TEXTURE_2D, GL_RGBA, vec![level(4, 0.0), level(2, 0.5), level(1, 1.0)]);
    t.lod.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    // ds/dx = 1/sqrt 2: rho = 4/sqrt 2 = 2^1.5.
    let s = t.sample([0.3, 0.55, 0.0], [0.5f64.sqrt(), 0.0, 0.0], [0.0, 0.1, 0.0]);
    assert_near(&[s.lambda, s.color[0]], &[1.5, 0.75], 1e-14);
    t.lod.min_filter = GL_NEAREST;
    let s = t.sample([0.3, 0.55, 0.0], [1.0, 0.0, 0.0], [0.0, 0.1, 0.0]);
    assert_near(&[s.to_boundary], &[0.2], 1e-14);
    t.target = GL_TEXTURE_RECTANGLE_ARB;
    t.lod.min_filter = GL_LINEAR;
    assert_near(&[t.sample([1.3, 2.2, 0.0], [3.0, 0.0, 0.0], [0.0; 3]).to_boundary], &[0.2], 1e-14);
}

#[test]
fn a_depth_comparison_gives_0_or_1() {
    let mut t = Texture::flat(GL_DEPTH_COMPONENT, Image::from_fn(1, 1, |_, _| [0.5, 0.0, 0.0, 0.0]));
    let at = |t: &Texture, r: f64| t.filter(0, 0, GL_NEAREST, [0.5, 0.5, 0.0], r);
    assert_eq!(at(&t, 0.7), [0.5, 0.5, 0.5, 1.0]);
    t.compare = Some(GL_LEQUAL);
    assert_eq!(at(&t, 0.7), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(at(&t, 0.5), [1.0; 4]);
    t.depth_mode = GL_ALPHA;
    assert_eq!(at(&t, 0.2), [0.0, 0.0, 0.0, 1.0]);
}
