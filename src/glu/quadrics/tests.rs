//! Quadrics against the values of the original GLU, the sides of their faces, their draw styles, their errors.

use super::*;

/// A primitive: its mode and for each vertex the current normal, texture coordinates and the position.
type Primitive = (GLenum, Vec<([f64; 3], [f64; 2], [f64; 3])>);

#[derive(Default)]
struct Recorder {
    primitives: Vec<Primitive>,
    normal: [f64; 3],
    tex_coord: [f64; 2],
    normals: usize,
}

impl QuadricSink for Recorder {
    fn begin(&mut self, mode: GLenum) {
        self.primitives.push((mode, Vec::new()));
    }
    fn end(&mut self) {}
    fn normal(&mut self, n: [f64; 3]) {
        self.normal = n;
        self.normals += 1;
    }
    fn tex_coord(&mut self, t: [f64; 2]) {
        self.tex_coord = t;
    }
    fn vertex(&mut self, v: [f64; 3]) {
        if let Some((_, vertices)) = self.primitives.last_mut() {
            vertices.push((self.normal, self.tex_coord, v));
        }
    }
}

const LOOK: Look = Look { style: GLU_FILL, normals: GLU_SMOOTH, inside: false, texture: true };

fn record(draw: impl FnOnce(&mut Recorder) -> Result<(), GLenum>) -> Recorder {
    let mut recorder = Recorder::default();
    draw(&mut recorder).expect("legal");
    recorder
}

fn near<const N: usize>(a: [f64; N], b: [f64; N]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-5)
}

#[track_caller]
fn assert_vertices(primitive: &Primitive, mode: GLenum, want: &[([f64; 2], [f64; 3])]) {
    assert_eq!(primitive.0, mode);
    assert!(primitive.1.len() >= want.len());
    for ((_, t, v), (want_t, want_v)) in primitive.1.iter().zip(want) {
        assert!(near(*t, *want_t) && near(*v, *want_v), "{t:?} {v:?}, not {want_t:?} {want_v:?}");
    }
}

/// The values of the original GLU for gluSphere(2, 4, 3) and gluCylinder(2, 1, 3, 4, 2).
#[test]
fn surfaces_lie_around_the_axis() {
    let sphere = record(|r| sphere(LOOK, 2.0, 4, 3, r));
    assert_eq!(sphere.primitives.len(), 3);
    let (third, r) = (1.0 / 3.0, 3f64.sqrt());
    let top = [
        ([1.0, 2.0 * third], [0.0, r, 1.0]),
        ([1.0, 1.0], [0.0, 0.0, 2.0]),
        ([0.75, 2.0 * third], [r, 0.0, 1.0]),
        ([0.75, 1.0], [0.0, 0.0, 2.0]),
        ([0.5, 2.0 * third], [0.0, -r, 1.0]),
        ([0.5, 1.0], [0.0, 0.0, 2.0]),
        ([0.25, 2.0 * third], [-r, 0.0, 1.0]),
        ([0.25, 1.0], [0.0, 0.0, 2.0]),
        ([0.0, 2.0 * third], [0.0, r, 1.0]),
    ];
    assert_vertices(&sphere.primitives[0], GL_QUAD_STRIP, &top);
    assert!(sphere.primitives.iter().flat_map(|p| &p.1).all(|(n, _, v)| near(n.map(|c| c * 2.0), *v)));
    let cylinder = record(|r| cylinder(LOOK, [2.0, 1.0], 3.0, 4, 2, r));
    let base = [
        ([1.0, 0.0], [0.0, 2.0, 0.0]),
        ([1.0, 0.5], [0.0, 1.5, 1.5]),
        ([0.75, 0.0], [2.0, 0.0, 0.0]),
        ([0.75, 0.5], [1.5, 0.0, 1.5]),
    ];
    assert_vertices(&cylinder.primitives[0], GL_QUAD_STRIP, &base);
    assert!(near(cylinder.primitives[0].1[0].0, [0.0, 0.948_683_3, 0.316_227_8]));
}

/// The values of the original GLU for gluDisk(0.5, 2, 4, 2), gluDisk(0, 2, 4, 2), gluPartialDisk(0.5, 2, 4, 2, 30, 120).
#[test]
fn disks_cut_a_circle_out_of_the_image() {
    let ring = record(|r| partial_disk(LOOK, [0.5, 2.0], 4, 2, [0.0, 360.0], r));
    let outer = [
        ([0.5, 1.0], [0.0, 2.0, 0.0]),
        ([0.5, 0.8125], [0.0, 1.25, 0.0]),
        ([1.0, 0.5], [2.0, 0.0, 0.0]),
        ([0.8125, 0.5], [1.25, 0.0, 0.0]),
    ];
    assert_eq!(ring.primitives.len(), 2);
    assert_vertices(&ring.primitives[0], GL_QUAD_STRIP, &outer);
    let disk = record(|r| partial_disk(LOOK, [0.0, 2.0], 4, 2, [0.0, 360.0], r));
    let fan = [
        ([0.5, 0.5], [0.0, 0.0, 0.0]),
        ([0.5, 0.75], [0.0, 1.0, 0.0]),
        ([0.25, 0.5], [-1.0, 0.0, 0.0]),
        ([0.5, 0.25], [0.0, -1.0, 0.0]),
    ];
    assert_vertices(&disk.primitives[0], GL_TRIANGLE_FAN, &fan);
    let part = record(|r| partial_disk(LOOK, [0.5, 2.0], 4, 2, [30.0, 120.0], r));
    let arc = [
        ([0.75, 0.933_012_7], [1.0, 1.732_050_8, 0.0]),
        ([0.65625, 0.770_632_9], [0.625, 1.082_531_8, 0.0]),
        ([0.933_012_7, 0.75], [1.732_050_8, 1.0, 0.0]),
    ];
    assert_vertices(&part.primitives[0], GL_QUAD_STRIP, &arc);
    // Swept backwards from 30 over -120 degrees: the part from -90 to 30.
    let back = record(|r| partial_disk(LOOK, [0.5, 2.0], 4, 2, [30.0, -120.0], r));
    assert_vertices(&back.primitives[0], GL_QUAD_STRIP, &[([0.0, 0.5], [-2.0, 0.0, 0.0])]);
}

/// Twice the signed areas of a primitive's faces along their normals: positive where they face their normals.
fn faces(primitive: &Primitive) -> Vec<f64> {
    let v: Vec<[f64; 3]> = primitive.1.iter().map(|p| p.2).collect();
    let n: Vec<[f64; 3]> = primitive.1.iter().map(|p| p.0).collect();
    let triangles: Vec<[usize; 3]> = match primitive.0 {
        GL_QUAD_STRIP => {
            (0..v.len() / 2 - 1).flat_map(|i| [[2 * i, 2 * i + 1, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 2]]).collect()
        }
        _ => (1..v.len() - 1).map(|i| [0, i, i + 1]).collect(),
    };
    let sub = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    triangles
        .into_iter()
        .map(|[a, b, c]| {
            let (e, f) = (sub(v[b], v[a]), sub(v[c], v[a]));
            let cross = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
            cross.iter().zip(n[c]).map(|(x, y)| x * y).sum()
        })
        .collect()
}

#[test]
fn faces_are_on_the_side_of_their_normals() {
    for inside in [false, true] {
        for normals in [GLU_SMOOTH, GLU_FLAT] {
            let look = Look { inside, normals, ..LOOK };
            let all = [
                record(|r| sphere(look, 1.5, 7, 5, r)),
                record(|r| cylinder(look, [1.0, 0.0], 2.0, 7, 3, r)),
                record(|r| cylinder(look, [0.5, 1.0], 2.0, 7, 3, r)),
                record(|r| partial_disk(look, [0.0, 1.0], 7, 3, [0.0, 360.0], r)),
                record(|r| partial_disk(look, [0.25, 1.0], 7, 3, [10.0, -200.0], r)),
            ];
            for (i, recorder) in all.iter().enumerate() {
                let areas: Vec<f64> = recorder.primitives.iter().flat_map(faces).collect();
                // Degenerate faces at poles and tips have no side.
                assert!(areas.iter().all(|&a| a > -1e-12), "surface {i}, inside {inside}: {areas:?}");
                assert!(areas.iter().filter(|&&a| a > 1e-6).count() * 2 > areas.len(), "surface {i}: {areas:?}");
            }
        }
    }
}

#[test]
fn styles_draw_what_they_say() {
    let count = |style, draw: &dyn Fn(Look, &mut Recorder) -> Result<(), GLenum>| {
        let recorder = record(|r| draw(Look { style, normals: GLU_NONE, texture: false, ..LOOK }, r));
        assert_eq!(recorder.normals, 0);
        let mode = recorder.primitives[0].0;
        assert!(recorder.primitives.iter().all(|p| p.0 == mode));
        (mode, recorder.primitives.iter().map(|p| p.1.len()).collect::<Vec<_>>())
    };
    let ball = |look, r: &mut Recorder| sphere(look, 2.0, 4, 3, r);
    let tube = |look, r: &mut Recorder| cylinder(look, [2.0, 1.0], 3.0, 4, 2, r);
    let disk = |look, r: &mut Recorder| partial_disk(look, [0.5, 2.0], 4, 2, [0.0, 360.0], r);
    let part = |look, r: &mut Recorder| partial_disk(look, [0.5, 2.0], 4, 2, [0.0, 90.0], r);
    assert_eq!(count(GLU_POINT, &ball), (GL_POINTS, vec![16]));
    assert_eq!(count(GLU_LINE, &ball), (GL_LINE_STRIP, vec![5, 5, 4, 4, 4, 4]));
    assert_eq!(count(GLU_SILHOUETTE, &tube), (GL_LINE_STRIP, vec![5, 5, 3, 3, 3, 3]));
    assert_eq!(count(GLU_LINE, &tube), (GL_LINE_STRIP, vec![5, 5, 5, 3, 3, 3, 3]));
    assert_eq!(count(GLU_LINE, &disk), (GL_LINE_STRIP, vec![5, 5, 5, 3, 3, 3, 3]));
    assert_eq!(count(GLU_SILHOUETTE, &disk), (GL_LINE_STRIP, vec![5, 5]));
    assert_eq!(count(GLU_SILHOUETTE, &part), (GL_LINE_STRIP, vec![5, 5, 3, 3]));
    assert_eq!(count(GLU_POINT, &part), (GL_POINTS, vec![15]));
}

#[test]
fn a_whole_turn_ends_where_it_began() {
    for slices in 2..200 {
        let ball = record(|r| sphere(LOOK, 1.0, slices, 2, r));
        for (_, vertices) in &ball.primitives {
            let n = vertices.len();
            assert_eq!((vertices[0].2, vertices[1].2), (vertices[n - 2].2, vertices[n - 1].2), "{slices} slices");
        }
    }
}

#[test]
fn bad_numbers_are_errors_and_draw_nothing() {
    let mut sink = Recorder::default();
    let invalid = Err(GLU_INVALID_VALUE);
    for (radius, slices, stacks) in [(-1.0, 4, 4), (1.0, 1, 4), (1.0, 4, 0), (f64::NAN, 4, 4), (1.0, i32::MIN, 4)] {
        assert_eq!(sphere(LOOK, radius, slices, stacks, &mut sink), invalid);
    }
    assert_eq!(cylinder(LOOK, [1.0, 1.0], 0.0, 4, 1, &mut sink), invalid);
    assert_eq!(cylinder(LOOK, [1.0, 1.0], -1.0, 4, 1, &mut sink), invalid);
    assert_eq!(partial_disk(LOOK, [2.0, 1.0], 4, 1, [0.0, 360.0], &mut sink), invalid);
    assert_eq!(partial_disk(LOOK, [0.0, 0.0], 4, 1, [0.0, 360.0], &mut sink), invalid);
    assert_eq!(partial_disk(LOOK, [0.0, 1.0], 4, 1, [0.0, f64::NAN], &mut sink), invalid);
    assert!(sink.primitives.is_empty());
    // Equal radii draw a circle of no width, as the original does.
    assert_eq!(partial_disk(LOOK, [1.0, 1.0], 4, 1, [0.0, 360.0], &mut sink), Ok(()));
}

#[test]
fn setters_check_and_report() {
    let mut q = Quadric::new();
    q.draw_style(1);
    assert_eq!(q.take_error(), Some(GLU_INVALID_ENUM));
    assert_eq!(q.take_error(), None);
    q.normals(GLU_FILL);
    q.orientation(GLU_FLAT);
    q.callback(77, None);
    assert_eq!(q.take_error(), Some(GLU_INVALID_ENUM));
    let look = q.look();
    assert_eq!((look.style, look.normals, look.inside, look.texture), (GLU_FILL, GLU_SMOOTH, false, false));
}
