//! The edges that a sweep line meets, in order: a list in blocks, in which places are found by bisection.

/// Blocks are cut when they are twice as long.
const BLOCK: usize = 128;

/// An ordered list of numbers of edges. No block is empty.
#[derive(Default)]
pub(super) struct Ordered {
    blocks: Vec<Vec<u32>>,
}

/// A place between two edges of the list: before the one with this index, or at the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    block: usize,
    at: usize,
}

impl Ordered {
    /// Whether there is no edge.
    pub(super) fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// The place before the first edge for which `before` is false; it is true for those that come earlier.
    pub(super) fn place(&self, mut before: impl FnMut(u32) -> bool) -> Place {
        let block = self.blocks.partition_point(|b| b.last().is_some_and(|e| before(*e)));
        let at = self.blocks.get(block).map_or(0, |b| b.partition_point(|e| before(*e)));
        Place { block, at }
    }

    /// The edge before a place.
    pub(super) fn before(&self, place: Place) -> Option<u32> {
        match place.at.checked_sub(1) {
            Some(at) => Some(self.blocks[place.block][at]),
            None => self.blocks[..place.block].last()?.last().copied(),
        }
    }

    /// The edge behind a place.
    pub(super) fn after(&self, place: Place) -> Option<u32> {
        self.blocks.get(place.block)?.get(place.at).copied()
    }

    /// Puts the edges between two places into `found`.
    pub(super) fn between(&self, from: Place, to: Place, found: &mut Vec<u32>) {
        found.clear();
        for block in from.block..=to.block.min(self.blocks.len().saturating_sub(1)) {
            let Some(edges) = self.blocks.get(block) else { break };
            let first = if block == from.block { from.at } else { 0 };
            let end = if block == to.block { to.at } else { edges.len() };
            found.extend_from_slice(&edges[first..end]);
        }
    }

    /// Replaces the edges between two places.
    pub(super) fn replace(&mut self, from: Place, to: Place, new: &[u32]) {
        if from.block == self.blocks.len() {
            // The end: the last block grows.
            let Some(last) = self.blocks.len().checked_sub(1) else {
                self.blocks.push(Vec::new());
                return self.fill(0, 0..0, new);
            };
            let end = self.blocks[last].len();
            return self.fill(last, end..end, new);
        }
        if from.block == to.block {
            return self.fill(from.block, from.at..to.at, new);
        }
        if let Some(last) = self.blocks.get_mut(to.block) {
            last.drain(..to.at);
        }
        self.blocks.drain(from.block + 1..to.block);
        let end = self.blocks[from.block].len();
        self.fill(from.block, from.at..end, new);
    }

    /// Replaces a part of a block and keeps blocks short and not empty.
    fn fill(&mut self, block: usize, part: std::ops::Range<usize>, new: &[u32]) {
        self.blocks[block].splice(part, new.iter().copied());
        let length = self.blocks[block].len();
        if length == 0 {
            self.blocks.remove(block);
        } else if length > 2 * BLOCK {
            let edges = std::mem::take(&mut self.blocks[block]);
            self.blocks.splice(block..=block, edges.chunks(BLOCK).map(<[u32]>::to_vec));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_what_one_long_list_would_be() {
        let (mut list, mut plain, mut seed) = (Ordered::default(), Vec::<u32>::new(), 1u64);
        let mut random = |n: usize| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as usize % n
        };
        let mut found = Vec::new();
        for round in 0..4000 {
            // Numbers stay sorted: a range goes, numbers within it or just above its lower end come.
            let low = random(100_000) as u32;
            let high = low + random(if round % 50 == 0 { 40_000 } else { 30 }) as u32;
            let (from, to) = (list.place(|e| e < low), list.place(|e| e < high));
            let (a, b) = (plain.partition_point(|e| *e < low), plain.partition_point(|e| *e < high));
            assert_eq!(list.before(from), a.checked_sub(1).map(|i| plain[i]));
            assert_eq!(list.after(to), plain.get(b).copied());
            list.between(from, to, &mut found);
            assert_eq!(found, plain[a..b]);
            let count = if round % 40 == 0 { 700 } else { random(4) as u32 };
            let new: Vec<u32> = (low..high).take(count as usize).collect();
            list.replace(from, to, &new);
            plain.splice(a..b, new);
        }
        list.between(list.place(|_| false), list.place(|_| true), &mut found);
        assert_eq!(found, plain);
        assert!(!plain.is_empty() && !list.is_empty());
    }
}
