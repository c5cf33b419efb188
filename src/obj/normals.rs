//! Normals for corners that have none. The normal of a corner is the sum of the normals of the faces that meet at its
//! position, weighted by their areas. Which of them count is said by the smoothing groups of the file; if it has none,
//! those that lean less than 60 degrees from the corner's own face: curved surfaces become smooth, the edges of a box stay
//! sharp. Positions meet when their coordinates are equal.

use super::Obj;
use super::text::Smoothing;
use std::collections::{BTreeMap, HashMap};

/// The cosine of the angle from which on an edge is sharp.
const SHARP: f64 = 0.5;
/// Where more faces meet, those of about the same direction share one sum: looking at every pair would take too long.
const MANY: usize = 256;
/// How fine directions are told apart there, in parts of a unit vector's component: about ten degrees.
const FINENESS: f64 = 6.0;

/// Computes the normals that are (0, 0, 0); vertices on sharp edges are split. `smoothing` says from which triangle on
/// which faces count.
pub(super) fn complete(obj: &mut Obj, smoothing: &[(usize, Smoothing)]) {
    if obj.normals.iter().all(|n| *n != [0.0; 3]) {
        return;
    }
    let points = points(&obj.positions);
    let triangles: Vec<[u32; 3]> = obj.groups.iter().flat_map(|g| g.indices.as_chunks::<3>().0).copied().collect();
    let meetings = Meetings::new(&points, &triangles);
    let faces = Faces::new(obj, &triangles, smoothing);
    let mut crowds: HashMap<u32, BTreeMap<FaceKind, [f64; 3]>> = HashMap::new();

    let mut new = SplitVertices::default();
    let mut indices = Vec::with_capacity(triangles.len() * 3);
    for (f, triangle) in triangles.iter().enumerate() {
        for &corner in triangle {
            let own = obj.normals.get(corner as usize).copied().unwrap_or_default();
            if own != [0.0; 3] {
                indices.push(new.index(obj, corner, own));
                continue;
            }
            let point = points.get(corner as usize).copied().unwrap_or(0);
            let around = meetings.at(point);
            let sum = if around.len() > MANY {
                let sums = crowds.entry(point).or_insert_with(|| faces.sums_by_kind(around));
                sums.get(&faces.kind(f)).copied().unwrap_or_default()
            } else {
                faces.sum(around, faces.units[f], faces.smoothing[f])
            };
            let sum = if faces.smoothing[f] == Smoothing::Off { faces.normals[f] } else { sum };
            let normal = [unit(sum), faces.units[f]].into_iter().find(|n| *n != [0.0; 3]).unwrap_or([0.0, 0.0, 1.0]);
            indices.push(new.index(obj, corner, normal.map(|c| c as f32)));
        }
    }
    let mut rest = indices.as_slice();
    for group in &mut obj.groups {
        let (own, after) = rest.split_at(group.indices.len() / 3 * 3);
        group.indices = own.to_vec();
        rest = after;
    }
    obj.positions = new.positions;
    obj.tex_coords = new.tex_coords;
    obj.colors = new.colors;
    obj.normals = new.normals;
}

/// What is known of each triangle.
struct Faces {
    /// The normals, as long as twice the area.
    normals: Vec<[f64; 3]>,
    /// The normals, of length one.
    units: Vec<[f64; 3]>,
    smoothing: Vec<Smoothing>,
}

/// Triangles that share a sum where many meet.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct FaceKind {
    smoothing: Smoothing,
    /// The direction, in parts of 1 / `FINENESS`; of no account in smoothing groups.
    direction: [i8; 3],
}

impl FaceKind {
    /// Whether faces of another kind count for a corner of this kind.
    fn takes(self, other: Self) -> bool {
        let [a, b] = [self, other].map(|kind| unit(kind.direction.map(f64::from)));
        self.smoothing == other.smoothing && (self.smoothing != Smoothing::ByAngle || dot(a, b) > SHARP)
    }
}

impl Faces {
    fn new(obj: &Obj, triangles: &[[u32; 3]], changes: &[(usize, Smoothing)]) -> Self {
        let normals: Vec<_> = triangles.iter().map(|f| area_normal(f.map(|i| position(obj, i)))).collect();
        let units = normals.iter().map(|&n| unit(n)).collect();
        let mut smoothing = vec![Smoothing::default(); triangles.len()];
        for (i, &(from, kind)) in changes.iter().enumerate() {
            let to = changes.get(i + 1).map_or(triangles.len(), |next| next.0);
            smoothing.get_mut(from..to).unwrap_or_default().fill(kind);
        }
        Self { normals, units, smoothing }
    }

    fn kind(&self, f: usize) -> FaceKind {
        let smoothing = self.smoothing[f];
        let by_angle = smoothing == Smoothing::ByAngle;
        let direction = if by_angle { self.units[f].map(|c| (c * FINENESS).round() as i8) } else { [0; 3] };
        FaceKind { smoothing, direction }
    }

    /// The sum for a corner whose own face has this direction and smoothing.
    fn sum(&self, around: &[u32], direction: [f64; 3], smoothing: Smoothing) -> [f64; 3] {
        let counts = |g: usize| {
            self.smoothing[g] == smoothing && (smoothing != Smoothing::ByAngle || dot(direction, self.units[g]) > SHARP)
        };
        let around = around.iter().map(|&g| g as usize);
        around.filter(|&g| counts(g)).fold([0.0; 3], |sum, g| add(sum, self.normals[g]))
    }

    /// The sum for each kind of face of a point where many meet.
    fn sums_by_kind(&self, around: &[u32]) -> BTreeMap<FaceKind, [f64; 3]> {
        let mut own: BTreeMap<FaceKind, [f64; 3]> = BTreeMap::new();
        for g in around.iter().map(|&g| g as usize) {
            let sum = own.entry(self.kind(g)).or_default();
            *sum = add(*sum, self.normals[g]);
        }
        let total = |kind: FaceKind| {
            own.iter().filter(|(other, _)| kind.takes(**other)).fold([0.0; 3], |sum, (_, normal)| add(sum, *normal))
        };
        own.keys().map(|&kind| (kind, total(kind))).collect()
    }
}

/// The arrays that come out.
#[derive(Default)]
struct SplitVertices {
    positions: Vec<[f32; 3]>,
    tex_coords: Vec<[f32; 2]>,
    colors: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    places: HashMap<(u32, [u32; 3]), u32>,
}

impl SplitVertices {
    /// The vertex that is an old one with a normal.
    fn index(&mut self, obj: &Obj, old: u32, normal: [f32; 3]) -> u32 {
        *self.places.entry((old, normal.map(f32::to_bits))).or_insert_with(|| {
            self.positions.push(position(obj, old));
            self.tex_coords.push(obj.tex_coords.get(old as usize).copied().unwrap_or_default());
            self.colors.push(obj.colors.get(old as usize).copied().unwrap_or([1.0; 3]));
            self.normals.push(normal);
            (self.positions.len() - 1) as u32
        })
    }
}

/// Which faces meet at each point: lists one after the other, and where each begins.
struct Meetings {
    faces: Vec<u32>,
    starts: Vec<usize>,
}

impl Meetings {
    fn new(points: &[u32], faces: &[[u32; 3]]) -> Self {
        let point = |i: u32| points.get(i as usize).copied().unwrap_or(0) as usize;
        let count = points.iter().max().map_or(1, |&p| p as usize + 1);
        let mut starts = vec![0usize; count + 1];
        for &corner in faces.as_flattened() {
            starts[point(corner) + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut lists = vec![0; faces.len() * 3];
        for (f, face) in faces.iter().enumerate() {
            for &corner in face {
                lists[next[point(corner)]] = f as u32;
                next[point(corner)] += 1;
            }
        }
        Self { faces: lists, starts }
    }

    fn at(&self, point: u32) -> &[u32] {
        let p = point as usize;
        match (self.starts.get(p), self.starts.get(p + 1)) {
            (Some(&from), Some(&to)) => self.faces.get(from..to).unwrap_or(&[]),
            _ => &[],
        }
    }
}

/// A number for each vertex, the same for equal positions.
fn points(positions: &[[f32; 3]]) -> Vec<u32> {
    let mut numbers: HashMap<[u32; 3], u32> = HashMap::new();
    positions
        .iter()
        .map(|p| {
            let next = numbers.len() as u32;
            // -0 meets +0.
            *numbers.entry(p.map(|c| (c + 0.0).to_bits())).or_insert(next)
        })
        .collect()
}

fn position(obj: &Obj, i: u32) -> [f32; 3] {
    obj.positions.get(i as usize).copied().unwrap_or_default()
}

/// The normal of a triangle, as long as twice its area.
fn area_normal(corners: [[f32; 3]; 3]) -> [f64; 3] {
    let [a, b, c] = corners.map(|p| p.map(f64::from));
    let (e, f) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    if length > 0.0 { v.map(|c| c / length) } else { [0.0; 3] }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
