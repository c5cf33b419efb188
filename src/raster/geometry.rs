//! What a scene keeps of its primitives, in issue order: coverage and planes of each. A small triangle's coverage is 64 bits;
//! that of everything larger is an index into a list of its kind.

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
        /// Covered pixels, clipped and stippled.
        bits: u64,
    },
    /// A triangle by its edges: an index of [`SceneGeometry::edges`].
    Edges(u32),
    /// A triangle of at most 16 by 16 pixels by its rows: an index of [`SceneGeometry::blocks`].
    Rows(u32),
    /// An aliased line: an index of [`SceneGeometry::lines`].
    Line(u32),
    /// All pixels of a rectangle (an aliased point).
    Rect(Rect),
    /// A smooth point: an index of [`SceneGeometry::discs`].
    Disc(u32),
    /// A smooth line or polygon: an index of [`SceneGeometry::outlines`].
    Outline(u32),
}

/// A primitive: its coverage and the draw that it belongs to. Its [`Planes`] have the same index.
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
    /// Triangles that wait to be set up together.
    pub(super) batch: Box<TriangleBatch>,
    /// Triangles that are larger than 16 by 16 pixels, or that were set up alone.
    pub edges: Vec<Edges>,
    /// Triangles of at most 16 by 16 pixels.
    pub blocks: Vec<RowCoverage>,
    /// Aliased lines.
    pub lines: Vec<AliasedLine>,
    /// Smooth points.
    pub discs: Vec<Disc>,
    /// Smooth lines and polygons.
    pub outlines: Vec<Outline>,
    /// About how many pixels the primitives cover.
    pub pixels: u64,
    /// Bytes of the images of pixel rectangles, which the draws hold.
    pub image_memory: usize,
}

/// An index as it is kept. There are never 2^32 of anything: a scene is flushed long before.
pub(super) fn index(len: usize) -> u32 {
    u32::try_from(len).unwrap_or(u32::MAX)
}

impl SceneGeometry {
    /// Whether nothing has been drawn.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.prims.is_empty() && self.batch.count == 0
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
        self.image_memory = 0;
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
            + self.image_memory
    }

    /// Appends a primitive.
    #[inline]
    pub(super) fn push(&mut self, cover: Coverage, draw: u32, planes: Planes, pixels: u64) {
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
            Coverage::Line(i) => self.lines.get(i as usize).map_or(0, |line| sides(&line.rect).iter().sum()),
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
            Coverage::Line(i) => self.lines.get(i as usize).map_or(0..0, |l| of(&l.rect)),
            Coverage::Rect(rect) => of(&rect),
            Coverage::Disc(i) => self.discs.get(i as usize).map_or(0..0, |d| of(&d.rect)),
            Coverage::Outline(i) => self.outlines.get(i as usize).map_or(0..0, |o| of(&o.rect)),
        }
    }
}
