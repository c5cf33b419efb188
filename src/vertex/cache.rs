//! The vertex cache of indexed draws (OpenGL 1.5, section 2.8): each vertex of a mesh is transformed once, however many
//! indices name it. A chunk of the index list becomes a list of its different vertices and, for each index, the id of its
//! vertex.

use super::source::{ElementList, Keys};
use std::ops::Range;

/// Different vertices of a chunk.
const CHUNK_VERTICES: u32 = 4096;
/// Indices of a chunk.
const CHUNK_INDICES: usize = 6 * CHUNK_VERTICES as usize;
/// Entries of the cache; a vertex has one entry, by its index.
const ENTRIES: usize = 8192;
/// Bits of a vertex id: ids are below [`CHUNK_VERTICES`] plus what a primitive holds.
const ID_BITS: u32 = 13;

/// A list of indices as it is in memory.
#[derive(Clone, Copy, Debug)]
pub struct IndexList<'a> {
    /// The bytes.
    pub bytes: &'a [u8],
    /// Bytes of an index: 1, 2 or 4.
    pub size: usize,
}

impl<'a> IndexList<'a> {
    /// How many indices there are.
    #[must_use]
    pub fn len(self) -> usize {
        self.bytes.len() / self.size.max(1)
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// The least and the greatest index.
    #[must_use]
    pub fn limits(self) -> (u32, u32) {
        match self.size {
            1 => limits(self.bytes.as_chunks::<1>().0),
            2 => limits(self.bytes.as_chunks::<2>().0),
            _ => limits(self.bytes.as_chunks::<4>().0),
        }
    }

    /// The indices as numbers.
    pub fn numbers(self) -> impl Iterator<Item = u32> + 'a {
        self.bytes.chunks_exact(self.size.max(1)).map(|b| match *b {
            [a] => u32::from(a),
            [a, b] => u32::from(u16::from_ne_bytes([a, b])),
            [a, b, c, d] => u32::from_ne_bytes([a, b, c, d]),
            _ => 0,
        })
    }
}

impl ElementList for IndexList<'_> {
    fn count(self) -> usize {
        self.len()
    }

    fn part(self, from: usize, until: usize) -> Self {
        let until = until.min(self.len());
        Self { bytes: self.bytes.get(from * self.size..until * self.size).unwrap_or_default(), size: self.size }
    }
}

/// Vertices of a source and how an indexed draw joins them.
#[derive(Clone, Debug)]
pub struct IndexedChunk<'a> {
    /// The id of the vertex of each index.
    pub ids: &'a [u32],
    /// Elements of the source that are the new vertices, in the order of their ids.
    pub keys: Keys<'a>,
}

/// A direct-mapped cache of the ids of a chunk's vertices, by index. A vertex that was evicted is transformed again, which
/// costs only time.
#[derive(Clone, Debug, Default)]
pub struct VertexCache {
    /// Index, number of the chunk, and the vertex's id, from the highest bits down.
    entries: Vec<u64>,
    chunk: u64,
    /// The ids of the chunk's indices.
    ids: Vec<u32>,
    /// The indices of its different vertices.
    keys: Vec<u32>,
    /// The same as a range, where the list is empty.
    range: Range<u32>,
}

impl VertexCache {
    /// Finds ids for the next indices of a list, where the ids below `held` are taken. Returns for how many.
    pub fn next_chunk(&mut self, list: IndexList<'_>, held: u32) -> usize {
        // No more room than the list asks for: a short draw would fill it with zeros for nothing.
        let most = CHUNK_INDICES.min(list.len());
        self.ids.resize(most, 0);
        let range = match list.size {
            1 => as_range(list.bytes.as_chunks::<1>().0, held, &mut self.ids),
            2 => as_range(list.bytes.as_chunks::<2>().0, held, &mut self.ids),
            _ => as_range(list.bytes.as_chunks::<4>().0, held, &mut self.ids),
        };
        if let Some((taken, range)) = range {
            self.ids.truncate(taken);
            self.keys.clear();
            self.range = range;
            return taken;
        }
        self.chunk = (self.chunk + 1) & u64::from(u32::MAX >> ID_BITS);
        if self.chunk == 0 || self.entries.is_empty() {
            self.entries.clear();
            self.entries.resize(ENTRIES, 0);
            self.chunk = 1;
        }
        self.keys.resize(most.min(CHUNK_VERTICES as usize), 0);
        let (taken, vertices) = match list.size {
            1 => self.fill(list.bytes.as_chunks::<1>().0, held),
            2 => self.fill(list.bytes.as_chunks::<2>().0, held),
            _ => self.fill(list.bytes.as_chunks::<4>().0, held),
        };
        self.ids.truncate(taken);
        self.keys.truncate(vertices);
        self.range = 0..0;
        taken
    }

    /// Finds the ids of the next indices by the cache. Returns for how many, and how many different vertices they have.
    #[inline]
    fn fill<const BYTES: usize>(&mut self, indices: &[[u8; BYTES]], held: u32) -> (usize, usize) {
        let Some(entries) = self.entries.first_chunk_mut::<ENTRIES>() else { return (0, 0) };
        let mut vertices = 0;
        for (taken, (id, bytes)) in self.ids.iter_mut().zip(indices).enumerate() {
            let index = number(*bytes);
            let key = u64::from(index) << 32 | self.chunk << ID_BITS;
            let entry = &mut entries[index as usize % ENTRIES];
            let found = *entry ^ key;
            if found < 1 << ID_BITS {
                *id = found as u32;
                continue;
            }
            let Some(new) = self.keys.get_mut(vertices) else { return (taken, vertices) };
            *new = index;
            *id = held + vertices as u32;
            *entry = key | u64::from(*id);
            vertices += 1;
        }
        (self.ids.len().min(indices.len()), vertices)
    }

    /// The chunk that was made last.
    #[must_use]
    pub fn elements(&self) -> IndexedChunk<'_> {
        let keys = if self.keys.is_empty() { Keys::Range(self.range.clone()) } else { Keys::List(&self.keys) };
        IndexedChunk { ids: &self.ids, keys }
    }
}

/// Indices that are looked at together; a multiple of 3 and 4.
const BLOCK: usize = 192;

/// Ids for indices that are close together, as those of a mesh are: a whole range of vertices is transformed, and an id is an
/// index less the begin of the range. Returns how many indices were taken and the range; `None` where the range has too many
/// vertices for so few indices.
#[inline]
fn as_range<const BYTES: usize>(indices: &[[u8; BYTES]], held: u32, ids: &mut [u32]) -> Option<(usize, Range<u32>)> {
    let indices = indices.get(..ids.len()).unwrap_or(indices);
    let block = indices.get(..BLOCK).unwrap_or(indices);
    let (first, last) = (number(*indices.first()?), number(*indices.last()?));
    // Falling indices are complemented first.
    let turn = if last < first { u32::MAX } else { 0 };
    let base = block.iter().map(|bytes| number(*bytes) ^ turn).min()?;
    let (mut taken, mut most) = (0, 0);
    for (ids, block) in ids.chunks_mut(BLOCK).zip(indices.chunks(BLOCK)) {
        let (mut all, mut greatest) = (0, 0);
        for (id, bytes) in ids.iter_mut().zip(block) {
            let distance = (number(*bytes) ^ turn).wrapping_sub(base);
            all |= distance;
            greatest = greatest.max(distance as i32);
            // Ids with too great a distance are not used.
            *id = held.wrapping_add(distance);
        }
        if all >= CHUNK_VERTICES {
            break;
        }
        (taken, most) = (taken + block.len(), greatest.max(most));
    }
    let most = most.unsigned_abs();
    if 2 * (most as usize + 1) > taken {
        return None;
    }
    if turn == 0 {
        return Some((taken, base..base.checked_add(most + 1)?));
    }
    for id in ids.iter_mut().take(taken) {
        *id = held + most - (*id - held);
    }
    let end = !base;
    Some((taken, end - most..end.checked_add(1)?))
}

/// The least and the greatest of some indices. Floats have them in one instruction on every processor, and hold whole
/// numbers below 2^24.
fn limits<const BYTES: usize>(indices: &[[u8; BYTES]]) -> (u32, u32) {
    let (groups, rest) = indices.as_chunks::<8>();
    let (mut all, mut low, mut high) = ([0; 8], [f32::MAX; 8], [0.0; 8]);
    for group in groups {
        for i in 0..8 {
            let n = number(group[i]);
            let v = n as i32 as f32;
            all[i] |= n;
            low[i] = if v < low[i] { v } else { low[i] };
            high[i] = if v > high[i] { v } else { high[i] };
        }
    }
    let exact = !groups.is_empty() && all.iter().all(|n| *n < 1 << 24);
    let start = if exact {
        let least = low.iter().fold(f32::MAX, |a, b| a.min(*b));
        (least as u32, high.iter().fold(0.0f32, |a, b| a.max(*b)) as u32)
    } else {
        (u32::MAX, 0)
    };
    let rest = if exact { rest } else { indices };
    rest.iter().map(|bytes| number(*bytes)).fold(start, |(low, high), i| (low.min(i), high.max(i)))
}

/// A number of the list.
#[inline(always)]
fn number<const BYTES: usize>(bytes: [u8; BYTES]) -> u32 {
    let mut wide = [0; 4];
    wide[..BYTES].copy_from_slice(&bytes);
    u32::from_le_bytes(if cfg!(target_endian = "big") { swapped(bytes) } else { wide })
}

/// Bytes of a number from the lowest on.
fn swapped<const BYTES: usize>(mut bytes: [u8; BYTES]) -> [u8; 4] {
    bytes.reverse();
    let mut wide = [0; 4];
    wide[..BYTES].copy_from_slice(&bytes);
    wide
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes a list apart and looks every index up again; how many vertices were transformed, and whether all of them
    /// came as ranges.
    fn walk(indices: &[u32], held: u32) -> (usize, bool) {
        let bytes: Vec<u8> = indices.iter().flat_map(|i| i.to_ne_bytes()).collect();
        let mut list = IndexList { bytes: &bytes, size: 4 };
        assert_eq!(list.limits(), (*indices.iter().min().unwrap(), *indices.iter().max().unwrap()));
        let (mut cache, mut at, mut vertices, mut ranges) = (VertexCache::default(), 0, 0, true);
        while !list.is_empty() {
            let taken = cache.next_chunk(list, held);
            let IndexedChunk { ids, keys } = cache.elements();
            assert!(taken > 0 && ids.len() == taken && keys.len() <= CHUNK_VERTICES as usize);
            for (id, index) in ids.iter().zip(&indices[at..]) {
                assert_eq!(keys.get((id - held) as usize), Some(*index));
            }
            (at, vertices) = (at + taken, vertices + keys.len());
            ranges &= matches!(keys, Keys::Range(_));
            list = list.part(taken, usize::MAX);
        }
        assert_eq!(at, indices.len());
        (vertices, ranges)
    }

    #[test]
    fn every_id_is_the_vertex_of_its_index() {
        let quads = |rows: u32, width: u32, from: u32| -> Vec<u32> {
            let cell = |i: u32| {
                let a = from + i / width * (width + 1) + i % width;
                [a, a + 1, a + width + 2, a, a + width + 2, a + width + 1]
            };
            (0..rows * width).flat_map(cell).collect()
        };
        let mesh = quads(90, 350, 7);
        let (vertices, ranges) = walk(&mesh, 3);
        assert!(ranges && vertices < 91 * 351 * 10 / 9, "{vertices}");
        let falling: Vec<u32> = mesh.iter().rev().copied().collect();
        assert_eq!(walk(&falling, 0), walk(&mesh, 0));
        // At the end of all numbers, and beyond what a float holds.
        walk(&quads(2, 40, u32::MAX - 124), 1);
        walk(&quads(9, 40, (1 << 24) - 99), 1);
        // Here and there: no range.
        let scattered: Vec<u32> = (0..40_000u32).map(|i| i.wrapping_mul(2_654_435_761) >> 8).collect();
        assert!(!walk(&scattered, 2).1);
        let far: Vec<u32> = mesh.iter().map(|i| i * 100).collect();
        assert!(!walk(&far, 0).1);
        walk(&[5, 4, 3], 0);
        // Just below the least of the first block.
        let mut below: Vec<u32> = (0..3 * BLOCK as u32).map(|i| 1000 + i / 6).collect();
        below.push(999);
        walk(&below, 3);
    }
}
