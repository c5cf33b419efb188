//! The tessellator (GLU 1.3, chapter 5) against a reference that shares nothing with it: winding numbers by counting
//! signed crossings in whole numbers, areas by slabs between all x at which edges begin, end or cross.

use fixedgl::enums::*;
use fixedgl::glu::*;

type Inside = fn(i64) -> bool;

/// The rules, and what they say of a winding number.
const RULES: [(GLenum, Inside); 5] = [
    (GLU_TESS_WINDING_ODD, |w| w % 2 != 0),
    (GLU_TESS_WINDING_NONZERO, |w| w != 0),
    (GLU_TESS_WINDING_POSITIVE, |w| w > 0),
    (GLU_TESS_WINDING_NEGATIVE, |w| w < 0),
    (GLU_TESS_WINDING_ABS_GEQ_TWO, |w| w.abs() >= 2),
];

type Contours = Vec<Vec<[i64; 2]>>;
type Flat = [f64; 2];

/// Everything that the callbacks are told. The data of a vertex is its position.
#[derive(Default)]
struct Told {
    primitives: Vec<(GLenum, Vec<[f64; 3]>)>,
    flags: Vec<bool>,
    flag: Option<bool>,
    open: bool,
    errors: Vec<GLenum>,
    combined: usize,
    refuses: bool,
}

impl TessCallbacks<[f64; 3]> for Told {
    fn begin(&mut self, mode: GLenum) {
        assert!(!self.open);
        self.open = true;
        self.primitives.push((mode, Vec::new()));
    }
    fn edge_flag(&mut self, boundary: bool) {
        assert!(self.open && self.flag != Some(boundary));
        self.flag = Some(boundary);
    }
    fn vertex(&mut self, p: &[f64; 3]) {
        assert!(self.open);
        self.primitives.last_mut().expect("begin").1.push(*p);
        self.flags.extend(self.flag);
    }
    fn end(&mut self) {
        assert!(self.open);
        self.open = false;
    }
    fn combine(&mut self, p: [f64; 3], data: [Option<&[f64; 3]>; 4], weights: [f32; 4]) -> Option<[f64; 3]> {
        self.combined += 1;
        let sum: f32 = weights.iter().sum();
        assert!((sum - 1.0).abs() < 1e-6);
        assert_eq!(data.iter().flatten().count(), if weights[2] == 0.0 && weights[3] == 0.0 { 2 } else { 4 });
        for i in 0..3 {
            let mean: f64 = data.iter().zip(weights).map(|(d, w)| d.map_or(0.0, |d| d[i]) * f64::from(w)).sum();
            let size = data.iter().flatten().map(|d| d[i].abs()).fold(0.0, f64::max);
            assert!((mean - p[i]).abs() <= 1e-6 * size, "{mean} {p:?}");
        }
        (!self.refuses).then_some(p)
    }
    fn error(&mut self, error: GLenum) {
        self.errors.push(error);
    }
}

impl Told {
    fn triangles(&self) -> Vec<[Flat; 3]> {
        assert!(self.primitives.len() <= 1);
        let Some((mode, vertices)) = self.primitives.first() else { return Vec::new() };
        assert_eq!(*mode, GL_TRIANGLES);
        assert!(!vertices.is_empty() && vertices.len() % 3 == 0);
        vertices.chunks(3).map(|t| [0, 1, 2].map(|i| [t[i][0], t[i][1]])).collect()
    }

    fn loops(&self) -> Vec<Vec<Flat>> {
        assert!(self.primitives.iter().all(|(mode, _)| *mode == GL_LINE_LOOP));
        self.primitives.iter().map(|(_, l)| l.iter().map(|p| [p[0], p[1]]).collect()).collect()
    }
}

fn tessellate(contours: &Contours, rule: GLenum, boundary_only: bool) -> Told {
    let mut tess = Tessellator::new();
    tess.property(GLU_TESS_WINDING_RULE, f64::from(rule));
    tess.property(GLU_TESS_BOUNDARY_ONLY, f64::from(u8::from(boundary_only)));
    tess.normal(0.0, 0.0, 1.0);
    run(&mut tess, contours, Told::default())
}

fn run(tess: &mut Tessellator<[f64; 3]>, contours: &Contours, mut told: Told) -> Told {
    tess.begin_polygon();
    for contour in contours {
        tess.begin_contour();
        for p in contour {
            let p = [p[0] as f64, p[1] as f64, 0.0];
            tess.vertex(p, p);
        }
        tess.end_contour();
    }
    tess.end_polygon(&mut told);
    assert!(!told.open);
    told
}

fn edges<T: Copy>(contours: &[Vec<T>]) -> impl Iterator<Item = [T; 2]> + '_ {
    contours.iter().flat_map(|c| (0..c.len()).map(|i| [c[i], c[(i + 1) % c.len()]]))
}

/// How often contours wind around the point `q / scale`, which lies on none of them.
fn winding(contours: &Contours, q: [i64; 2], scale: i64) -> i64 {
    let wide = |p: [i64; 2]| p.map(|c| i128::from(c) * i128::from(scale));
    let [x, y] = q.map(i128::from);
    let mut sum = 0;
    for [a, b] in edges(contours) {
        let (a, b) = (wide(a), wide(b));
        let left = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        if a[1] <= y && y < b[1] && left > 0 {
            sum += 1;
        } else if b[1] <= y && y < a[1] && left < 0 {
            sum -= 1;
        }
    }
    sum
}

/// The same for loops of rounded points.
fn winding_of_loops(loops: &[Vec<Flat>], [x, y]: Flat) -> i64 {
    let mut sum = 0;
    for [a, b] in edges(loops) {
        let left = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        if a[1] <= y && y < b[1] && left > 0.0 {
            sum += 1;
        } else if b[1] <= y && y < a[1] && left < 0.0 {
            sum -= 1;
        }
    }
    sum
}

/// The distance of a point from an edge.
fn distance([a, b]: [[i64; 2]; 2], q: Flat) -> f64 {
    let (a, b) = (a.map(|c| c as f64), b.map(|c| c as f64));
    let (d, to) = ([b[0] - a[0], b[1] - a[1]], [q[0] - a[0], q[1] - a[1]]);
    let length = d[0] * d[0] + d[1] * d[1];
    let t = if length == 0.0 { 0.0 } else { ((to[0] * d[0] + to[1] * d[1]) / length).clamp(0.0, 1.0) };
    let away = [to[0] - t * d[0], to[1] - t * d[1]];
    (away[0] * away[0] + away[1] * away[1]).sqrt()
}

/// The area of what a rule takes as inside: between two neighbouring x no edge begins, ends or crosses another.
fn reference_area(contours: &Contours, inside: Inside) -> f64 {
    let all: Vec<_> = edges(contours).filter(|[a, b]| a[0] != b[0]).collect();
    let mut xs: Vec<f64> = all.iter().flatten().map(|p| p[0] as f64).collect();
    for (i, [a, b]) in all.iter().enumerate() {
        for [c, d] in &all[..i] {
            let (u, v) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]);
            let of = u[0] * v[1] - u[1] * v[0];
            if of != 0 {
                let s = ((c[0] - a[0]) * v[1] - (c[1] - a[1]) * v[0]) as f64 / of as f64;
                if (0.0..=1.0).contains(&s) {
                    xs.push(a[0] as f64 + s * u[0] as f64);
                }
            }
        }
    }
    xs.sort_by(f64::total_cmp);
    let mut area = 0.0;
    for x in xs.windows(2).filter(|x| x[1] - x[0] > 1e-9) {
        let middle = (x[0] + x[1]) / 2.0;
        let mut lines = Vec::new();
        for [a, b] in &all {
            let (low, high) = if a[0] < b[0] { (a, b) } else { (b, a) };
            if (low[0] as f64) < middle && middle < high[0] as f64 {
                let slope = (high[1] - low[1]) as f64 / (high[0] - low[0]) as f64;
                lines.push((low[1] as f64 + slope * (middle - low[0] as f64), if a[0] < b[0] { 1 } else { -1 }));
            }
        }
        lines.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut w = 0;
        for pair in lines.windows(2) {
            w += pair[0].1;
            if inside(w) {
                area += (pair[1].0 - pair[0].0) * (x[1] - x[0]);
            }
        }
    }
    area
}

fn cross(a: Flat, b: Flat, c: Flat) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn area_of_loops(loops: &[Vec<Flat>]) -> f64 {
    edges(loops).map(|[a, b]| (a[0] * b[1] - a[1] * b[0]) / 2.0).sum()
}

/// A small generator of random numbers.
struct Random(u64);

impl Random {
    fn below(&mut self, n: i64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as i64 % n
    }
}

/// Contours on few points, so that many of them coincide, lie on a line or cross.
fn random_contours(r: &mut Random) -> Contours {
    let size = [3, 4, 6, 9, 15, 40][r.below(6) as usize];
    let count = 1 + r.below(4);
    let mut contours: Contours = Vec::new();
    for _ in 0..count {
        let mut contour: Vec<[i64; 2]> = (0..r.below(9)).map(|_| [r.below(size), r.below(size)]).collect();
        match r.below(6) {
            // The same contour again, or backwards; a box.
            0 => contour = contours.last().cloned().unwrap_or(contour),
            1 => contour = contours.last().map_or(contour, |c| c.iter().rev().copied().collect()),
            2 => {
                let ([x, y], w, h) = ([r.below(size), r.below(size)], 1 + r.below(size), 1 + r.below(size));
                contour = vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
            }
            _ => {}
        }
        contours.push(contour);
    }
    contours
}

/// Everything that has to hold of a set of contours by one rule.
fn examine(contours: &Contours, (rule, inside): (GLenum, Inside), r: &mut Random) {
    let told = tessellate(contours, rule, false);
    assert_eq!(told.errors, []);
    let triangles = told.triangles();
    let mut area = 0.0;
    for [a, b, c] in &triangles {
        let twice = cross(*a, *b, *c);
        // Rounded crossings may turn a triangle that is thinner than the grid.
        assert!(twice > -1e-6, "{twice}");
        area += twice / 2.0;
    }
    let expected = reference_area(contours, inside);
    assert!((area - expected).abs() < 1e-5 * (1.0 + expected), "triangles {area}, exactly {expected}");

    let boundary = tessellate(contours, rule, true);
    assert_eq!(boundary.errors, []);
    assert_eq!(boundary.combined, told.combined);
    assert!(boundary.flags.is_empty());
    let loops = boundary.loops();
    assert!(loops.iter().all(|l| l.len() >= 3));
    let enclosed = area_of_loops(&loops);
    assert!((enclosed - expected).abs() < 1e-5 * (1.0 + expected), "loops {enclosed}, exactly {expected}");

    // The edges that are flagged are those of the loops.
    let bits = |[a, b]: [Flat; 2]| [a, b].map(|p| p.map(f64::to_bits));
    let mut of_loops: Vec<_> = edges(&loops).map(bits).collect();
    let sides = triangles.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
    let mut flagged: Vec<_> = sides.zip(&told.flags).filter(|(_, f)| **f).map(|(e, _)| bits(e)).collect();
    assert_eq!(told.flags.len(), 3 * triangles.len());
    of_loops.sort_unstable();
    flagged.sort_unstable();
    assert_eq!(of_loops, flagged);

    for _ in 0..12 {
        const SCALE: i64 = 1_000_003;
        let q = [0, 1].map(|_| r.below(42 * SCALE) % (1 + r.below(42 * SCALE)) - SCALE / 2);
        let at = q.map(|c| c as f64 / SCALE as f64);
        if edges(contours).any(|e| distance(e, at) < 1e-5) {
            continue;
        }
        let expected = i64::from(inside(winding(contours, q, SCALE)));
        let covering: i64 = triangles.iter().map(|t| winding_of_loops(&[t.to_vec()], at)).sum();
        assert_eq!(covering, expected, "triangles at {at:?}");
        assert_eq!(winding_of_loops(&loops, at), expected, "loops at {at:?}");
    }
}

/// Sets of random contours; more by hand with FIXEDGL_TESS_SETS.
#[test]
fn random_contours_agree_with_exact_winding_numbers_by_every_rule() {
    let sets = std::env::var("FIXEDGL_TESS_SETS").ok().and_then(|n| n.parse().ok()).unwrap_or(2000);
    let (mut r, mut total) = (Random(20), 0);
    for set in 0..sets {
        let contours = random_contours(&mut r);
        total += contours.len();
        for rule in RULES {
            let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| examine(&contours, rule, &mut r)));
            assert!(result.is_ok(), "set {set}, rule {}: {contours:?}", rule.0);
        }
    }
    println!("{sets} sets, {total} contours, {} rules each", RULES.len());
}

fn square(low: i64, high: i64) -> Vec<[i64; 2]> {
    vec![[low, low], [high, low], [high, high], [low, high]]
}

fn turned(mut contour: Vec<[i64; 2]>) -> Vec<[i64; 2]> {
    contour.reverse();
    contour
}

/// Contours with their areas by the rules odd, nonzero, positive, negative, at least two.
#[test]
fn every_rule_takes_its_parts_of_known_polygons() {
    // A pentagram with whole coordinates: its middle is wound around twice.
    let star = vec![[-6, -8], [0, 10], [6, -8], [-10, 3], [10, 3]];
    let all = reference_area(&vec![star.clone()], |w| w != 0);
    let middle = reference_area(&vec![star.clone()], |w| w.abs() == 2);
    assert!(middle > 10.0 && all > 2.0 * middle);
    let rows: [(Contours, [f64; 5]); 10] = [
        (vec![square(0, 10)], [100.0, 100.0, 100.0, 0.0, 0.0]),
        (vec![turned(square(0, 10))], [100.0, 100.0, 0.0, 100.0, 0.0]),
        // A hole: turned the other way, then the same way.
        (vec![square(0, 10), turned(square(2, 5))], [91.0, 91.0, 91.0, 0.0, 0.0]),
        (vec![square(0, 10), square(2, 5)], [91.0, 100.0, 100.0, 0.0, 9.0]),
        // An island in a lake on an island.
        (vec![square(0, 10), turned(square(1, 9)), square(2, 8)], [72.0, 72.0, 72.0, 0.0, 0.0]),
        (vec![square(0, 10), square(1, 9), square(2, 8)], [72.0, 100.0, 100.0, 0.0, 64.0]),
        // The same square twice, and once more the other way.
        (vec![square(0, 10), square(0, 10)], [0.0, 100.0, 100.0, 0.0, 100.0]),
        (vec![square(0, 10), turned(square(0, 10))], [0.0; 5]),
        // Two that touch along a side.
        (vec![square(0, 4), vec![[4, 0], [8, 0], [8, 4], [4, 4]]], [32.0, 32.0, 32.0, 0.0, 0.0]),
        (vec![turned(star)], [all - middle, all, all, 0.0, middle]),
    ];
    for (contours, areas) in rows {
        for ((rule, inside), expected) in RULES.into_iter().zip(areas) {
            let triangles = tessellate(&contours, rule, false).triangles();
            let area: f64 = triangles.iter().map(|[a, b, c]| cross(*a, *b, *c) / 2.0).sum();
            assert!((area - expected).abs() < 1e-5, "{contours:?} {rule}: {area}, exactly {expected}");
            examine(&contours, (rule, inside), &mut Random(1));
        }
    }
}

#[test]
fn contours_without_an_area_make_nothing() {
    let rows: [Contours; 9] = [
        vec![],
        vec![vec![]],
        vec![vec![[1, 1]]],
        vec![vec![[1, 1], [5, 2]]],
        vec![vec![[3, 3]; 7]],
        vec![vec![[0, 0], [1, 1], [2, 2], [9, 9]]],
        vec![vec![[0, 0], [9, 9], [2, 2], [5, 5], [1, 1]]],
        vec![vec![[0, 0], [4, 0], [4, 4], [4, 0]]],
        vec![vec![], vec![[1, 2], [3, 4]], vec![[5, 5]]],
    ];
    for contours in rows {
        for (rule, boundary_only) in RULES.iter().flat_map(|(rule, _)| [(*rule, false), (*rule, true)]) {
            let told = tessellate(&contours, rule, boundary_only);
            assert!(told.primitives.is_empty() && told.errors.is_empty(), "{contours:?}");
        }
    }
}

#[test]
fn a_boundary_of_parts_that_touch_is_loops_that_do_not_cross() {
    // Two squares that touch at a corner, and a square with a hole that touches its side at a point.
    let corner: Contours = vec![vec![[0, 0], [2, 0], [2, 4], [4, 4], [4, 2], [0, 2]]];
    let told = tessellate(&corner, GLU_TESS_WINDING_ODD, true);
    assert_eq!(told.loops().iter().map(Vec::len).collect::<Vec<_>>(), [4, 4]);
    let hole: Contours = vec![square(0, 8), vec![[0, 4], [3, 6], [3, 2]]];
    let loops = tessellate(&hole, GLU_TESS_WINDING_ODD, true).loops();
    assert_eq!(area_of_loops(&loops), 64.0 - 6.0);
    assert_eq!(loops.len(), 1);
    assert_eq!(loops[0].len(), 8);
}

#[test]
fn without_an_answer_to_combine_a_crossing_is_an_error_and_nothing_is_drawn() {
    let bow: Contours = vec![vec![[0, 0], [4, 4], [4, 0], [0, 4]]];
    let mut tess = Tessellator::new();
    let told = run(&mut tess, &bow, Told { refuses: true, ..Told::default() });
    assert_eq!(told.errors, [GLU_TESS_NEED_COMBINE_CALLBACK]);
    assert!(told.primitives.is_empty());
    // Vertices that fall together need none: the first data stay. The next polygon is not concerned.
    let twice: Contours = vec![vec![[0, 0], [0, 0], [4, 0], [4, 4], [0, 0]]];
    let told = run(&mut tess, &twice, Told { refuses: true, ..Told::default() });
    assert_eq!((told.errors.len(), told.triangles().len(), told.combined), (0, 1, 2));
    // With it, the vertex in the middle is made of a quarter of each.
    let told = run(&mut tess, &bow, Told::default());
    assert_eq!((told.combined, told.triangles().len()), (1, 2));
    assert!(told.triangles().iter().flatten().any(|p| *p == [2.0, 2.0]));
}

#[test]
fn what_is_missing_is_an_error_and_done_by_itself() {
    type Tess = Tessellator<[f64; 3]>;
    type Call = fn(&mut Tess, &mut Told);
    let rows: [(Call, &[GLenum]); 12] = [
        (|t, told| t.end_polygon(told), &[GLU_TESS_MISSING_BEGIN_POLYGON]),
        (|t, _| t.begin_contour(), &[GLU_TESS_MISSING_BEGIN_POLYGON]),
        (|t, _| t.vertex([0.0; 3], [0.0; 3]), &[GLU_TESS_MISSING_BEGIN_POLYGON, GLU_TESS_MISSING_BEGIN_CONTOUR]),
        (|t, _| t.end_contour(), &[GLU_TESS_MISSING_BEGIN_POLYGON, GLU_TESS_MISSING_BEGIN_CONTOUR]),
        (
            |t, told| {
                t.begin_polygon();
                t.begin_contour();
                t.end_polygon(told);
            },
            &[GLU_TESS_MISSING_END_CONTOUR],
        ),
        (
            |t, _| {
                t.begin_polygon();
                t.begin_polygon();
            },
            &[GLU_TESS_MISSING_END_POLYGON],
        ),
        (
            |t, _| {
                t.begin_polygon();
                t.begin_contour();
                t.begin_polygon();
            },
            &[GLU_TESS_MISSING_END_CONTOUR, GLU_TESS_MISSING_END_POLYGON],
        ),
        (
            |t, _| {
                t.begin_polygon();
                t.begin_contour();
                t.begin_contour();
            },
            &[GLU_TESS_MISSING_END_CONTOUR],
        ),
        (|t, _| t.property(GLU_TESS_WINDING_RULE, 7.0), &[GLU_INVALID_VALUE]),
        (|t, _| t.property(GLU_TESS_TOLERANCE, 1.5), &[GLU_INVALID_VALUE]),
        (|t, _| t.property(GLU_TESS_TOLERANCE, f64::NAN), &[GLU_INVALID_VALUE]),
        (
            |t, _| {
                t.property(GLU_VERSION, 0.0);
                assert_eq!(t.get_property(GLU_VERSION), 0.0);
            },
            &[GLU_INVALID_ENUM],
        ),
    ];
    for (i, (call, errors)) in rows.into_iter().enumerate() {
        let (mut tess, mut told) = (Tessellator::new(), Told::default());
        call(&mut tess, &mut told);
        told.errors.extend(std::iter::from_fn(|| tess.take_error()));
        assert_eq!(told.errors, errors, "row {i}");
        assert!(errors.iter().all(|e| error_string(*e).is_some()));
        let [rule, only, tolerance] =
            [GLU_TESS_WINDING_RULE, GLU_TESS_BOUNDARY_ONLY, GLU_TESS_TOLERANCE].map(|p| tess.get_property(p));
        assert_eq!((rule, only, tolerance), (f64::from(GLU_TESS_WINDING_ODD), 0.0, 0.0), "row {i}");
    }
}

#[test]
fn coordinates_too_large_are_limited() {
    for bad in [1.5e150, -1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let mut tess = Tessellator::new();
        tess.begin_polygon();
        tess.begin_contour();
        for p in [[0.0, 0.0, 0.0], [bad, 0.0, 0.0], [1e150, 1e150, 0.0], [-1e150, 1e150, 0.0]] {
            tess.vertex(p, p.map(|c| if c.is_nan() { 0.0 } else { c.clamp(-1e150, 1e150) }));
        }
        tess.end_contour();
        let mut told = Told::default();
        tess.end_polygon(&mut told);
        assert_eq!(told.errors, [GLU_TESS_COORD_TOO_LARGE], "{bad}");
        assert!(!told.triangles().is_empty());
    }
}

/// A square with a hole and a crossing in tilted planes: with a computed normal, and with the true one either way.
#[test]
fn polygons_in_any_plane_are_seen_along_their_normal() {
    let flat: Contours = vec![square(0, 8), turned(square(2, 5)), vec![[1, 7], [9, 9], [9, 7], [1, 9]]];
    let expected = reference_area(&flat, |w| w % 2 != 0);
    let planes =
        [([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), ([0.0, 2.0, 0.0], [0.0, 0.0, 3.0]), ([1.0, 2.0, -1.0], [3.0, 0.5, 2.0])];
    for (u, v) in planes {
        let n: [f64; 3] = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let size = n.iter().map(|c| c * c).sum::<f64>();
        for (normal, sign) in [([0.0; 3], 1.0), (n, 1.0), (n.map(|c| -c), -1.0)] {
            let mut tess = Tessellator::new();
            tess.normal(normal[0], normal[1], normal[2]);
            tess.begin_polygon();
            for contour in &flat {
                tess.begin_contour();
                for p in contour {
                    let p = [0, 1, 2].map(|i| u[i] * p[0] as f64 + v[i] * p[1] as f64);
                    tess.vertex(p, p);
                }
                tess.end_contour();
            }
            let mut told = Told::default();
            tess.end_polygon(&mut told);
            assert_eq!(told.errors, []);
            let mut area = 0.0;
            for t in told.primitives[0].1.chunks(3) {
                let [a, b] = [1, 2].map(|i| [0, 1, 2].map(|k| t[i][k] - t[0][k]));
                let c = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                let part = c.iter().zip(n).map(|(c, n)| c * n).sum::<f64>() * sign / size / 2.0;
                assert!(part > -1e-6);
                area += part;
            }
            assert!((area - expected).abs() < 1e-5, "{u:?} {v:?} {normal:?}: {area}, exactly {expected}");
        }
    }
}

#[test]
fn tolerance_merges_what_is_close() {
    let contour: Contours = vec![vec![[0, 0], [1000, 0], [1000, 1], [1001, 2], [1000, 1000], [0, 1000]]];
    let mut tess = Tessellator::new();
    let exact = run(&mut tess, &contour, Told::default());
    tess.property(GLU_TESS_TOLERANCE, 0.02);
    let merged = run(&mut tess, &contour, Told::default());
    assert_eq!((exact.triangles().len(), exact.combined), (4, 0));
    assert_eq!((merged.triangles().len(), merged.combined), (2, 2));
}

#[test]
fn a_panic_in_a_callback_leaves_the_tessellator_as_new() {
    struct Panics;
    impl TessCallbacks<[f64; 3]> for Panics {
        fn vertex(&mut self, _: &[f64; 3]) {
            panic!("not today");
        }
    }
    let mut tess = Tessellator::new();
    let describe = |tess: &mut Tessellator<[f64; 3]>| {
        tess.begin_polygon();
        tess.begin_contour();
        for p in square(0, 3) {
            let p = [p[0] as f64, p[1] as f64, 0.0];
            tess.vertex(p, p);
        }
        tess.end_contour();
    };
    describe(&mut tess);
    let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| tess.end_polygon(&mut Panics)));
    assert!(result.is_err());
    describe(&mut tess);
    let mut told = Told::default();
    tess.end_polygon(&mut told);
    assert_eq!((told.errors.len(), told.triangles().len()), (0, 2));
}

/// Long contours of several forms: so many triangles as vertices less 2 for each, in a time that grows as n log n does.
#[test]
fn a_contour_of_100_000_vertices_ends_quickly() {
    const N: i64 = 100_000;
    let comb = |i: i64| [i, if i % 2 == 0 { 10 } else { 4 * N }];
    let lie = |[x, y]: [i64; 2]| [y, -x];
    let lean = |[x, y]: [i64; 2]| [x + y, y - x];
    let teeth = |turn: &dyn Fn([i64; 2]) -> [i64; 2]| {
        let mut contour: Vec<_> = (0..N - 2).map(|i| turn(comb(N - i))).collect();
        contour.extend([turn([0, 0]), turn([N, 0])]);
        contour
    };
    // A spiral of thin turns, there and back.
    let turn = |i: i64| [[i, i], [-i, i], [-i, -i], [i, -i]][i as usize % 4];
    let out = (4..N / 2 + 4).map(|i| turn(i).map(|c| 4 * c));
    let back = (4..N / 2 + 4).rev().map(|i| turn(i).map(|c| 4 * c - c.signum()));
    let forms: [(&str, Vec<[i64; 2]>); 4] = [
        ("upright comb", teeth(&|p| p)),
        ("lying comb", teeth(&lie)),
        ("leaning comb", teeth(&lean)),
        ("spiral", out.chain(back).collect()),
    ];
    for (name, contour) in forms {
        let start = std::time::Instant::now();
        let told = tessellate(&vec![contour], GLU_TESS_WINDING_NONZERO, false);
        let time = start.elapsed();
        println!("{name}: {} triangles, {time:?}", told.triangles().len());
        assert_eq!((told.errors.len(), told.combined), (0, 0), "{name}");
        assert_eq!(told.triangles().len() as i64, N - 2, "{name}");
        assert!(time.as_secs() < 60, "{name}: {time:?}");
    }
}

mod c_names {
    //! The same through the names of C.

    use fixedgl::c::*;
    use std::sync::Mutex;

    static SEEN: Mutex<Vec<String>> = Mutex::new(Vec::new());

    fn seen(what: String) {
        SEEN.lock().expect("one test").push(what);
    }

    #[test]
    fn callbacks_get_the_data_of_the_polygon_where_they_ask_for_it() {
        type Tess = GLUtesselator<u32, char>;
        let tess: Tess = gluNewTess();
        let set = |which, function| gluTessCallback(&tess, which, function);
        set(GLU_TESS_BEGIN, GLUtessFunction::Begin(|_| panic!("the other one has priority")));
        set(GLU_TESS_BEGIN_DATA, GLUtessFunction::BeginData(|mode, polygon| seen(format!("begin {mode} {polygon}"))));
        set(GLU_TESS_EDGE_FLAG, GLUtessFunction::EdgeFlag(|flag| seen(format!("flag {flag}"))));
        set(GLU_TESS_VERTEX_DATA, GLUtessFunction::VertexData(|v, polygon| seen(format!("vertex {v} {polygon}"))));
        set(GLU_TESS_END, GLUtessFunction::End(|| seen("end".into())));
        set(GLU_TESS_ERROR_DATA, GLUtessFunction::ErrorData(|e, polygon| seen(format!("error {e} {polygon}"))));
        gluTessProperty(&tess, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_POSITIVE);
        gluTessNormal(&tess, 0, 0, 1);
        gluTessBeginPolygon(&tess, 'p');
        gluTessBeginContour(&tess);
        for (i, p) in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].iter().enumerate() {
            gluTessVertex(&tess, p, i as u32);
        }
        gluTessEndPolygon(&tess);
        // A function of another kind is refused; none takes the first one's place away.
        set(GLU_TESS_END, GLUtessFunction::Begin(|_| ()));
        set(GLU_TESS_BEGIN_DATA, GLUtessFunction::None);
        set(GLU_TESS_BEGIN, GLUtessFunction::None);
        set(GLU_TESS_EDGE_FLAG, GLUtessFunction::None);
        gluBeginPolygon(&tess);
        gluNextContour(&tess, GLU_INTERIOR);
        gluEndPolygon(&tess);
        let mut rule = 0.0;
        gluGetTessProperty(&tess, GLU_TESS_WINDING_RULE, &mut rule);
        assert_eq!(rule, f64::from(GLU_TESS_WINDING_POSITIVE));
        gluTessBeginPolygon(&tess, 'q');
        gluDeleteTess(tess);
        let expected = [
            "error 100154 p",
            "begin 4 p",
            "flag true",
            "vertex 2 p",
            "vertex 0 p",
            "vertex 1 p",
            "end",
            "error 100900 p",
            "error 100153 q",
        ];
        let mut seen = SEEN.lock().expect("one test").clone();
        seen[3..6].sort();
        let mut expected = expected.map(String::from);
        expected[3..6].sort();
        assert_eq!(seen, expected);
    }
}
