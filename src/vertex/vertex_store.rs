//! Vertices stored as batches are: blocks of 64, one array for each number, only the attributes that are needed. A long
//! Begin/End is collected in a store, so that several threads can share it, and a display list keeps one for each of its
//! primitives. Filling a batch is copying arrays.

use super::batch::{Lanes, VertexBatch, needs};
use super::cache::IndexList;
use super::source::{ElementOrder, Keys, VertexSource};
use crate::simd::LANES;
use crate::state::primitive::PrimitiveMode;

/// Numbers of a position.
const POSITION: usize = 4;
/// Vertices of most blocks.
const EACH: u32 = LANES as u32;

/// A store of vertices.
#[derive(Clone, Debug, Default)]
pub struct VertexStore {
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

impl VertexStore {
    /// Forgets all vertices. The next ones have the attributes `kept` and come in blocks of `each`.
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
    pub fn order(&self) -> ElementOrder<IndexList<'static>> {
        ElementOrder::Range(0..u32::try_from(self.count).unwrap_or(u32::MAX))
    }

    /// Appends the vertices of a batch; all batches but the last must be whole blocks. False where there is no memory.
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

    /// Loads a block into a batch.
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
        // Division by a constant is a shift.
        let (block, lane) = match self.each as u32 {
            EACH => (vertex / EACH, vertex % EACH),
            each => (vertex / each.max(1), vertex % each.max(1)),
        };
        (block as usize, lane as usize)
    }

    fn block(&self, block: usize) -> Option<&[Lanes]> {
        self.lanes.get(block * self.per_block..(block + 1) * self.per_block)
    }

    /// Copies some numbers of some vertices.
    fn copy<'a>(&self, keys: &Keys<'_>, skip: usize, to: impl Iterator<Item = &'a mut Lanes>) {
        match keys {
            Keys::Range(range) => {
                let (block, lane) = self.place(range.start);
                let here = range.len().min(self.each - lane);
                let beyond = range.len() - here;
                if beyond > self.each {
                    let list: [u32; LANES] = std::array::from_fn(|i| range.start.saturating_add(i as u32));
                    return self.copy_each(&list[..range.len().min(LANES)], skip, to);
                }
                let numbers = |block: usize| self.block(block).and_then(|lanes| lanes.get(skip..)).unwrap_or_default();
                if lane == 0 && beyond == 0 {
                    to.zip(numbers(block)).for_each(|(to, from)| *to = *from);
                    return;
                }
                // The range lies in two blocks.
                let next = numbers(block + 1).iter().map(Some).chain(std::iter::repeat(None));
                for ((to, from), next) in to.zip(numbers(block)).zip(next) {
                    let (first, last) = to.split_at_mut(here);
                    first.copy_from_slice(&from[lane..lane + here]);
                    if let Some(next) = next {
                        last[..beyond].copy_from_slice(&next[..beyond]);
                    }
                }
            }
            Keys::List(list) => self.copy_each(list, skip, to),
        }
    }

    fn copy_each<'a>(&self, list: &[u32], skip: usize, to: impl Iterator<Item = &'a mut Lanes>) {
        let mut at = [0; LANES];
        for (at, key) in at.iter_mut().zip(list) {
            let (block, lane) = self.place(*key);
            *at = (block * self.per_block + skip) * LANES + lane;
        }
        let numbers = self.lanes.as_flattened();
        for (k, to) in to.enumerate() {
            for (to, at) in to.iter_mut().zip(at).take(list.len()) {
                *to = numbers.get(at + k * LANES).copied().unwrap_or(0.0);
            }
        }
    }
}

impl VertexSource for VertexStore {
    fn positions(&self, keys: &Keys<'_>, batch: &mut VertexBatch) {
        batch.n = keys.len().min(LANES);
        batch.w_is_one = self.w_is_one;
        self.copy(keys, 0, batch.position.iter_mut());
    }

    fn block(&self, _: PrimitiveMode) -> usize {
        self.each
    }

    fn attributes(&self, keys: &Keys<'_>, batch: &mut VertexBatch) {
        self.copy(keys, POSITION, attributes(batch, self.kept));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::current::Current;

    #[test]
    fn vertices_come_back_whatever_blocks_they_lie_in() {
        for each in [48, LANES] {
            let (mut store, mut batch) = (VertexStore::default(), VertexBatch::new());
            store.clear(needs::COLOR, each);
            let color = |i: u32| [i as f32, 0.5, -(i as f32), 1.0];
            for i in 0..200 {
                batch.push(
                    [i as f32, 2.0 * i as f32, 0.0, 1.0],
                    &Current { color: color(i), ..Current::default() },
                    u32::MAX,
                );
                if batch.n == each {
                    assert!(store.push(&mut batch));
                    batch.clear();
                }
            }
            assert!(store.push(&mut batch));
            assert_eq!((store.len(), store.blocks()), (200, 200_usize.div_ceil(each)));
            let mut check = |keys: &Keys<'_>| {
                store.positions(keys, &mut batch);
                store.attributes(keys, &mut batch);
                assert_eq!(batch.n, keys.len());
                for lane in 0..batch.n {
                    let i = keys.get(lane).expect("a vertex");
                    let position = batch.position.map(|lanes| lanes[lane]);
                    assert_eq!(position, [i as f32, 2.0 * i as f32, 0.0, 1.0], "blocks of {each}, {keys:?}");
                    assert_eq!(batch.current(lane).color, color(i));
                }
            };
            for (from, until) in [(0, 48), (0, 64), (47, 111), (48, 96), (5, 6), (60, 124), (130, 194), (192, 200)] {
                check(&Keys::Range(from..until));
            }
            check(&Keys::List(&[199, 0, 64, 63, 48, 47, 3]));
        }
    }
}
