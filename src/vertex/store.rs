//! Vertices kept as lanes: blocks of 64, one array a number, only the attributes that somebody needs. A long Begin/End is
//! collected in a store, so that several threads can share it, and a display list keeps one for each of its primitives.
//! To fill a batch is to copy arrays.

use super::batch::{Lanes, VertexBatch, needs};
use super::cache::IndexList;
use super::{Keys, Order, Source};
use crate::batch::LANES;
use crate::enums::GLenum;

/// Numbers of a position.
const POSITION: usize = 4;
/// Vertices of most blocks.
const EACH: u32 = LANES as u32;

/// A store of vertices.
#[derive(Clone, Debug, Default)]
pub struct Store {
    /// Which attributes are kept besides the position, bits of [`needs`].
    kept: u32,
    /// Arrays of a block.
    per_block: usize,
    lanes: Vec<Lanes>,
    /// Vertices of a block.
    each: usize,
    count: usize,
    /// Whether w is 1 in every position.
    w_is_one: bool,
}

/// The attributes of a batch that are kept, without the position; edge flags are not among them.
fn attributes(batch: &mut VertexBatch, kept: u32) -> impl Iterator<Item = &mut Lanes> {
    let VertexBatch { normal, color, secondary, fog, tex, .. } = batch;
    let on = move |bit: u32| kept & bit != 0;
    let tex = tex.iter_mut().enumerate().filter(move |(unit, _)| on(needs::TEX << unit)).flat_map(|(_, t)| t);
    let normal = normal.iter_mut().filter(move |_| on(needs::NORMAL));
    let color = color.iter_mut().filter(move |_| on(needs::COLOR));
    let secondary = secondary.iter_mut().filter(move |_| on(needs::SECONDARY));
    let fog = std::iter::once(fog).filter(move |_| on(needs::FOG));
    normal.chain(color).chain(secondary).chain(fog).chain(tex)
}

/// How many arrays the attributes take.
fn arrays(kept: u32) -> usize {
    let sizes = [(needs::NORMAL, 3), (needs::COLOR, 4), (needs::SECONDARY, 3), (needs::FOG, 1)];
    let units = (kept & needs::TEX_ALL).count_ones() as usize;
    sizes.iter().filter(|(bit, _)| kept & bit != 0).map(|(_, n)| n).sum::<usize>() + 4 * units
}

impl Store {
    /// Forgets all vertices and says which attributes the next ones have, and how many come at a time.
    pub fn clear(&mut self, kept: u32, each: usize) {
        self.lanes.clear();
        self.each = each.clamp(1, LANES);
        (self.kept, self.per_block, self.count, self.w_is_one) = (kept, POSITION + arrays(kept), 0, true);
    }

    /// How many vertices there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count
    }

    /// How many blocks they are.
    #[must_use]
    pub fn blocks(&self) -> usize {
        self.count.div_ceil(self.each.max(1))
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// All vertices in order.
    #[must_use]
    pub fn order(&self) -> Order<IndexList<'static>> {
        Order::Range(0..u32::try_from(self.count).unwrap_or(u32::MAX))
    }

    /// Appends the vertices of a batch; all batches but the last must have as many as come at a time. False where there is no memory.
    pub fn push(&mut self, batch: &mut VertexBatch) -> bool {
        if self.lanes.try_reserve(self.per_block).is_err() {
            return false;
        }
        self.lanes.extend_from_slice(&batch.position);
        self.lanes.extend(attributes(batch, self.kept).map(|lanes| *lanes));
        self.count += batch.n.min(LANES);
        self.w_is_one &= batch.w_is_one;
        true
    }

    /// A batch of the store: its number of vertices.
    pub fn load(&self, block: usize, batch: &mut VertexBatch) {
        batch.n = self.count.saturating_sub(block * self.each).min(self.each);
        batch.w_is_one = self.w_is_one;
        let Some(lanes) = self.block(block) else { return };
        let (position, rest) = lanes.split_at(POSITION);
        batch.position.copy_from_slice(position);
        for (to, from) in attributes(batch, self.kept).zip(rest) {
            *to = *from;
        }
    }

    /// The numbers of a vertex.
    pub fn numbers(&self, vertex: u32) -> impl Iterator<Item = f32> + '_ {
        let (block, lane) = self.place(vertex);
        self.block(block).unwrap_or_default().iter().map(move |lanes| lanes[lane])
    }

    /// A store of some of the vertices; `None` where there is no memory.
    #[must_use]
    pub fn chosen(&self, vertices: &[u32]) -> Option<Self> {
        let mut lanes = Vec::new();
        lanes.try_reserve_exact(vertices.len().div_ceil(LANES) * self.per_block).ok()?;
        for block in vertices.chunks(LANES) {
            let first = lanes.len();
            lanes.resize(first + self.per_block, [0.0; LANES]);
            for (lane, vertex) in block.iter().enumerate() {
                for (to, value) in lanes[first..].iter_mut().zip(self.numbers(*vertex)) {
                    to[lane] = value;
                }
            }
        }
        let Self { kept, per_block, w_is_one, .. } = *self;
        Some(Self { kept, per_block, lanes, each: LANES, count: vertices.len(), w_is_one })
    }

    /// The block and the lane of a vertex.
    #[inline]
    fn place(&self, vertex: u32) -> (usize, usize) {
        // A number that is known need not be divided by.
        let (block, lane) = match self.each as u32 {
            EACH => (vertex / EACH, vertex % EACH),
            each => (vertex / each.max(1), vertex % each.max(1)),
        };
        (block as usize, lane as usize)
    }

    fn block(&self, block: usize) -> Option<&[Lanes]> {
        self.lanes.get(block * self.per_block..(block + 1) * self.per_block)
    }

    /// Copies some numbers of some vertices: those of one block at once, where they are all of it.
    fn copy<'a>(&self, keys: &Keys<'_>, skip: usize, to: impl Iterator<Item = &'a mut Lanes>) {
        let whole = match keys {
            Keys::Range(range) if range.len() <= self.each => {
                let (block, lane) = self.place(range.start);
                self.block(block).filter(|_| lane == 0)
            }
            _ => None,
        };
        match whole {
            Some(block) => {
                for (to, from) in to.zip(block.iter().skip(skip)) {
                    *to = *from;
                }
            }
            None => {
                let mut at = [0; LANES];
                for (i, at) in at.iter_mut().enumerate() {
                    let (block, lane) = self.place(keys.get(i).unwrap_or(0));
                    *at = (block * self.per_block + skip) * LANES + lane;
                }
                let numbers = self.lanes.as_flattened();
                for (k, to) in to.enumerate() {
                    for (to, at) in to.iter_mut().zip(at).take(keys.len()) {
                        *to = numbers.get(at + k * LANES).copied().unwrap_or(0.0);
                    }
                }
            }
        }
    }
}

impl Source for Store {
    fn places(&self, keys: &Keys<'_>, batch: &mut VertexBatch) {
        batch.n = keys.len().min(LANES);
        batch.w_is_one = self.w_is_one;
        self.copy(keys, 0, batch.position.iter_mut());
    }

    fn block(&self, _: GLenum) -> usize {
        self.each
    }

    fn values(&self, keys: &Keys<'_>, batch: &mut VertexBatch) {
        self.copy(keys, POSITION, attributes(batch, self.kept));
    }
}
