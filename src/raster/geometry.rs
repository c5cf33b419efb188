//! What a scene keeps of its primitives, in issue order: each one's shape, its planes, and in side lists what the larger
//! shapes need. A small triangle is 64 covered-or-not bits in place; everything larger is an index into its list.

use super::coverage::disc::Disc;
use super::coverage::edges::Edges;
use super::coverage::line::AliasedLine;
use super::coverage::outline::Outline;
use super::setup::plane_buffer::PlaneBuffer;
use super::state::Rect;
use super::triangle_batch::TriangleBatch;
use super::triangle_batch::rows::RowCoverage;
use crate::fragment::planes::Planes;

/// Which pixels a primitive covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coverage {
    /// A small triangle: bit (8 row + column) of `bits` says whether pixel (x + column, y + row) is covered.
    Mask {
        /// Leftmost column.
        x: i32,
        /// Lowest row.
        y: i32,
        /// Covered pixels; clipped and stippled.
        bits: u64,
    },
    /// A triangle by its edges: an index of [`SceneGeometry::edges`].
    Edges(u32),
    /// A triangle of at most 16 by 16 pixels by its rows: an index of [`SceneGeometry::blocks`].
    Rows(u32),
    /// An aliased line: an index of [`SceneGeometry::lines`].
    AliasedLine(u32),
    /// Pixels of a rectangle, all of them (an aliased point).
    Rect(Rect),
    /// A smooth point: an index of [`SceneGeometry::discs`].
    Disc(u32),
    /// A smooth line or polygon: an index of [`SceneGeometry::outlines`].
    Outline(u32),
}

/// A primitive: its shape and the draw that it belongs to. Its [`Planes`] have the same index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prim {
    /// Which pixels.
    pub cover: Coverage,
    /// Index of the draw.
    pub draw: u32,
}

/// All primitives of a scene.
#[derive(Clone, Debug, Default)]
pub struct SceneGeometry {
    /// Primitives in issue order.
    pub prims: Vec<Prim>,
    /// Their planes.
    pub planes: Vec<Planes>,
    /// The planes of their slots.
    pub pool: PlaneBuffer,
    /// Small triangles that are not yet among the primitives.
    pub(super) group: Box<TriangleBatch>,
    /// Triangles that are not small.
    pub edges: Vec<Edges>,
    /// Triangles between those two.
    pub blocks: Vec<RowCoverage>,
    /// Aliased lines.
    pub lines: Vec<AliasedLine>,
    /// Smooth points.
    pub discs: Vec<Disc>,
    /// Smooth lines and polygons.
    pub outlines: Vec<Outline>,
    /// About how many pixels the primitives cover.
    pub pixels: u64,
}

/// An index as it is kept; there are never 2^32 of anything, since a scene is flushed long before.
pub(super) fn index(len: usize) -> u32 {
    u32::try_from(len).unwrap_or(u32::MAX)
}

impl SceneGeometry {
    /// Whether nothing has been drawn.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.prims.is_empty() && self.group.count == 0
    }

    /// Forgets all primitives, keeping the memory.
    pub fn clear(&mut self) {
        self.prims.clear();
        self.planes.clear();
        self.pool.clear();
        self.edges.clear();
        self.blocks.clear();
        self.lines.clear();
        self.discs.clear();
        self.outlines.clear();
        self.pixels = 0;
    }

    /// Bytes in use.
    #[must_use]
    pub fn memory(&self) -> usize {
        const fn bytes<T>(v: &[T]) -> usize {
            size_of_val(v)
        }
        bytes(&self.prims)
            + bytes(&self.planes)
            + self.pool.memory()
            + bytes(&self.edges)
            + bytes(&self.blocks)
            + bytes(&self.lines)
            + bytes(&self.discs)
            + bytes(&self.outlines)
    }

    /// Files a primitive whose planes have been made.
    #[inline]
    pub(super) fn file(&mut self, cover: Coverage, draw: u32, planes: Planes, pixels: u64) {
        self.prims.push(Prim { cover, draw });
        self.planes.push(planes);
        self.pixels += pixels;
    }

    /// About how many pixels a primitive covers.
    #[must_use]
    pub fn pixels_of(&self, prim: &Prim) -> u64 {
        let sides = |rect: &Rect| [rect.x1 - rect.x0, rect.y1 - rect.y0].map(|side| side.max(0).unsigned_abs().into());
        let area = |rect: &Rect| sides(rect).iter().product::<u64>();
        match prim.cover {
            Coverage::Mask { bits, .. } => bits.count_ones().into(),
            Coverage::Edges(i) => self.edges.get(i as usize).map_or(0, |edges| area(&edges.rect) / 2),
            Coverage::Rows(_) => 128,
            Coverage::AliasedLine(i) => self.lines.get(i as usize).map_or(0, |line| sides(&line.rect).iter().sum()),
            Coverage::Rect(rect) => area(&rect),
            Coverage::Disc(i) => self.discs.get(i as usize).map_or(0, |disc| area(&disc.rect)),
            Coverage::Outline(i) => self.outlines.get(i as usize).map_or(0, |outline| area(&outline.rect)),
        }
    }

    /// The rows that a primitive may touch.
    #[must_use]
    pub fn rows(&self, prim: &Prim) -> std::ops::Range<i32> {
        let of = |rect: &Rect| rect.y0..rect.y1;
        match prim.cover {
            Coverage::Mask { y, bits, .. } => {
                let low = bits.trailing_zeros() as i32 / 8;
                let high = 7 - bits.leading_zeros() as i32 / 8;
                y + low..y + high + 1
            }
            Coverage::Edges(i) => self.edges.get(i as usize).map_or(0..0, |e| of(&e.rect)),
            Coverage::Rows(i) => self.blocks.get(i as usize).map_or(0..0, RowCoverage::range),
            Coverage::AliasedLine(i) => self.lines.get(i as usize).map_or(0..0, |l| of(&l.rect)),
            Coverage::Rect(rect) => of(&rect),
            Coverage::Disc(i) => self.discs.get(i as usize).map_or(0..0, |d| of(&d.rect)),
            Coverage::Outline(i) => self.outlines.get(i as usize).map_or(0..0, |o| of(&o.rect)),
        }
    }
}
