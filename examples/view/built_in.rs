//! The model that is drawn where none is named: a knot of a tube, written as an OBJ file and read as one, with bricks on it.

use crate::support::textures::bricks;
use fixedgl::Context;
use fixedgl::c::*;
use fixedgl::math::sin_cos;
use fixedgl::obj::Obj;
use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::Path;

/// How often the tube is cut along its way, and around.
const ALONG: usize = 240;
const AROUND: usize = 24;

/// The middle of the tube at a fraction of its way: it goes twice around the upright axis and three times up and down.
fn middle(way: f64) -> [f64; 3] {
    let ((s2, c2), (s3, c3)) = (sin_cos(2.0 * TAU * way), sin_cos(3.0 * TAU * way));
    let r = 2.0 + c3;
    [r * c2, r * s2, s3]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

/// The model.
pub fn model() -> Result<Obj, String> {
    let mut text = String::from("o knot\n");
    for i in 0..ALONG {
        let way = i as f64 / ALONG as f64;
        let (at, next) = (middle(way), middle(way + 1e-4));
        let along = unit(std::array::from_fn(|k| next[k] - at[k]));
        let side = unit(cross(along, at));
        let up = cross(side, along);
        for j in 0..AROUND {
            let (s, c) = sin_cos(TAU * j as f64 / AROUND as f64);
            let p: [f64; 3] = std::array::from_fn(|k| at[k] + 0.42 * (c * up[k] + s * side[k]));
            let _ = writeln!(text, "v {} {} {}", p[0], p[1], p[2]);
        }
    }
    for i in 0..=ALONG {
        for j in 0..=AROUND {
            let _ = writeln!(text, "vt {} {}", 12.0 * i as f64 / ALONG as f64, 2.0 * j as f64 / AROUND as f64);
        }
    }
    for i in 0..ALONG {
        for j in 0..AROUND {
            text.push('f');
            for (di, dj) in [(0, 0), (0, 1), (1, 1), (1, 0)] {
                let (along, around) = (i + di, j + dj);
                let v = along % ALONG * AROUND + around % AROUND + 1;
                let _ = write!(text, " {v}/{}", along * (AROUND + 1) + around + 1);
            }
            text.push('\n');
        }
    }
    Obj::parse(text.as_bytes(), Path::new(""))
}

/// Loads its texture into the one that is bound.
pub fn load_texture(cx: &mut Context) {
    let side = 256;
    let size = side as GLsizei;
    cx.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    fixedgl::glu::build_2d_mipmaps(cx, GL_TEXTURE_2D, GL_RGB8, size, size, GL_RGB, GL_UNSIGNED_BYTE, &bricks(side));
}
