//! Two pictures of one scene, the oracle's and the crate's, and the figures of their difference. A pixel is doubtful, and
//! left out, where its centre lies so near an edge that rounding the positions to 1/256 pixel decides, or (where the
//! filter is NEAREST) where a coordinate lies within 2^-10 texel of a boundary. The share of doubtful pixels is part of
//! the figures, so that nothing hides there.

use super::bridge;
use crate::oracle::fragment::to_byte;
use crate::oracle::scene::{Picture, Scene};

/// How the pictures differ.
#[derive(Clone, Debug, Default)]
pub struct Figures {
    /// Pixels that were compared, and those left out.
    pub compared: usize,
    pub doubtful: usize,
    /// Pixels that some triangle covers, of those compared.
    pub drawn: usize,
    /// Pixels with a byte that is not the rounded ideal, ties (within [`TIE`] of a half) not counted.
    pub differ: usize,
    /// Pixels with a channel that is more than 1 away from the rounded ideal.
    pub off: usize,
    /// The greatest distance of a byte from the unrounded ideal, in LSB (one rounding: 0.5).
    pub worst: f64,
    /// Where that was: x, y, what the crate has, what it should have.
    pub place: Option<(u32, u32, [u8; 4], [f64; 4])>,
}

/// What makes a pixel doubtful.
#[derive(Clone, Copy, Debug)]
pub struct Doubt {
    /// Distance to an edge in pixels.
    pub edge: f64,
    /// Distance to a texel boundary in texels.
    pub boundary: f64,
}

/// An ideal that is this near the middle between two bytes, in LSB, may be rounded either way.
pub const TIE: f64 = 1.0 / 1024.0;

/// Edges only.
pub const EDGES: Doubt = Doubt { edge: 1.0 / 128.0, boundary: 0.0 };
/// Edges and boundaries of texels.
pub const NEAREST: Doubt = Doubt { edge: 1.0 / 128.0, boundary: 1.0 / 1024.0 };

impl Figures {
    /// Adds the pixels of one picture.
    pub fn add(&mut self, ideal: &Picture, got: &[[u8; 4]], doubt: Doubt) {
        for y in 0..ideal.height {
            for x in 0..ideal.width {
                let p = ideal.at(x, y);
                let boundary = p.story.as_ref().map_or(f64::INFINITY, |s| s.to_boundary);
                if p.nearest_edge < doubt.edge || boundary <= doubt.boundary && doubt.boundary > 0.0 {
                    self.doubtful += 1;
                    continue;
                }
                let bytes = got[(y * ideal.width + x) as usize];
                self.compared += 1;
                self.drawn += usize::from(p.hits > 0);
                let far = |i: usize| (i16::from(bytes[i]) - i16::from(to_byte(p.ideal[i]))).abs() > 1;
                self.off += usize::from((0..4).any(far));
                let error = |i: usize| (f64::from(bytes[i]) - 255.0 * p.ideal[i]).abs();
                let worst = (0..4).map(error).fold(0.0, f64::max);
                self.differ += usize::from(worst > 0.5 + TIE);
                if worst > self.worst {
                    self.worst = worst;
                    self.place = Some((x, y, bytes, p.ideal.map(|v| v * 255.0)));
                }
            }
        }
    }

    /// The share of compared pixels that are not the rounded ideal.
    pub fn share(&self) -> f64 {
        self.differ as f64 / self.compared.max(1) as f64
    }

    /// Prints the figures.
    pub fn print(&self, name: &str) {
        eprintln!(
            "{name}: {} pixels compared ({} drawn, {} doubtful), {} differ ({:.4} %), {} by more than 1 LSB, worst {:.3} LSB",
            self.compared,
            self.drawn,
            self.doubtful,
            self.differ,
            100.0 * self.share(),
            self.off,
            self.worst
        );
    }

    /// Prints, and panics unless nothing is off by more than 1 LSB, less than 0.1 % is off at all, and enough was drawn
    /// and certain for this to mean something.
    #[track_caller]
    pub fn within_one_lsb(&self, name: &str) {
        self.print(name);
        self.means_something();
        assert_eq!(self.off, 0, "{name}: more than 1 LSB off, worst at {:?}", self.place);
        assert!(self.share() < 1e-3, "{name}: {:.4} % are off, worst at {:?}", 100.0 * self.share(), self.place);
    }

    /// Adds other figures to these.
    pub fn merge(&mut self, f: &Figures) {
        self.compared += f.compared;
        self.doubtful += f.doubtful;
        self.drawn += f.drawn;
        self.differ += f.differ;
        self.off += f.off;
        if f.worst > self.worst {
            (self.worst, self.place) = (f.worst, f.place);
        }
    }

    /// Prints, and panics unless every compared pixel is the same byte for byte.
    #[track_caller]
    pub fn exact(&self, name: &str) {
        self.print(name);
        self.means_something();
        assert_eq!(self.differ, 0, "{name}: worst at {:?}", self.place);
    }

    #[track_caller]
    fn means_something(&self) {
        assert!(self.drawn > 0, "nothing was drawn");
        assert!(self.doubtful * 10 <= self.compared, "too much is doubtful: {self:?}");
    }
}

/// Draws a scene with both and compares.
#[track_caller]
pub fn compare(scene: &Scene, doubt: Doubt) -> Figures {
    let scene = bridge::as_given(scene);
    let mut figures = Figures::default();
    figures.add(&scene.render(), &bridge::draw(&scene), doubt);
    figures
}
