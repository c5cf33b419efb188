//! Normals for a model that has none. The normal of a corner is the sum of the normals of the faces that meet at its
//! position, weighted by their areas, as far as they lean less than 60 degrees from the corner's own face: curved
//! surfaces become smooth, the edges of a box stay sharp. Positions meet when their coordinates are equal.

use super::Obj;
use std::collections::HashMap;

/// The cosine of the angle from which on an edge is sharp.
const SHARP: f64 = 0.5;
/// Where more faces meet (the tip of a cone) all of them count: looking at every pair would take too long.
const MANY: usize = 256;

/// Computes all normals anew; vertices on sharp edges are split.
pub(super) fn compute(obj: &mut Obj) {
    let points = points(&obj.positions);
    let faces: Vec<[u32; 3]> = obj.groups.iter().flat_map(|g| g.indices.as_chunks::<3>().0).copied().collect();
    let normals: Vec<[f64; 3]> = faces.iter().map(|f| area_normal(f.map(|i| position(obj, i)))).collect();
    let units: Vec<[f64; 3]> = normals.iter().map(|&n| unit(n)).collect();
    let meetings = Meetings::new(&points, &faces);

    let mut new = SplitVertices::default();
    let mut indices = Vec::with_capacity(faces.len() * 3);
    for (f, face) in faces.iter().enumerate() {
        for &corner in face {
            let around = meetings.at(points.get(corner as usize).copied().unwrap_or(0));
            let mut sum = [0.0; 3];
            for &g in around {
                if around.len() > MANY || g == f as u32 || dot(units[f], units[g as usize]) > SHARP {
                    sum = add(sum, normals[g as usize]);
                }
            }
            let normal = [unit(sum), units[f]].into_iter().find(|n| *n != [0.0; 3]).unwrap_or([0.0, 0.0, 1.0]);
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
    obj.normals = new.normals;
}

/// The arrays that come out.
#[derive(Default)]
struct SplitVertices {
    positions: Vec<[f32; 3]>,
    tex_coords: Vec<[f32; 2]>,
    normals: Vec<[f32; 3]>,
    places: HashMap<(u32, [u32; 3]), u32>,
}

impl SplitVertices {
    /// The vertex that is an old one with a normal.
    fn index(&mut self, obj: &Obj, old: u32, normal: [f32; 3]) -> u32 {
        *self.places.entry((old, normal.map(f32::to_bits))).or_insert_with(|| {
            self.positions.push(position(obj, old));
            self.tex_coords.push(obj.tex_coords.get(old as usize).copied().unwrap_or_default());
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
