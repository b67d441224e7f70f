//! What the tiles of a picture show of its flat colours, and which of it is one area.

use super::field::Difference;

/// How much a colour may change from one tile to the next, in a channel.
const STEP: f64 = 24.0;
/// Channels darker than this say little of the light.
const DARK: f64 = 24.0;

/// A flat colour in a tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Patch {
    pub(super) tile: usize,
    /// As a share of the tile.
    pub(super) weight: f64,
    pub(super) color: [f64; 3],
    /// The middle of what was seen of it, in cells.
    pub(super) place: [f64; 2],
    /// The first patch of the area that it is in.
    pub(super) region: usize,
}

/// All patches of a picture, tile by tile.
#[derive(Debug)]
pub(super) struct Patches {
    pub(super) list: Vec<Patch>,
    /// Tiles in a row and in a column.
    pub(super) tiles: [usize; 2],
    /// How many tiles were looked at, in pixels.
    pub(super) whole: f64,
    /// Patches of one colour in tiles side by side.
    pub(super) links: Vec<[usize; 2]>,
    /// The first patch of each tile.
    starts: Vec<usize>,
}

impl Patches {
    pub(super) fn new(list: Vec<Patch>, tiles: [usize; 2], whole: f64) -> Self {
        let count = tiles[0] * tiles[1];
        let mut starts = vec![0; count + 1];
        list.iter().for_each(|patch| starts[patch.tile + 1] += 1);
        (0..count).for_each(|tile| starts[tile + 1] += starts[tile]);
        let mut patches = Self { list, tiles, whole, links: Vec::new(), starts };
        patches.link();
        patches.join();
        patches
    }

    /// Of one colour are those of two tiles that are nearest to each other, both ways.
    fn link(&mut self) {
        let [columns, rows] = self.tiles;
        for (from, patch) in self.list.iter().enumerate() {
            let (column, row) = (patch.tile % columns, patch.tile / columns);
            let beside = [(column + 1 < columns, patch.tile + 1), (row + 1 < rows, patch.tile + columns)];
            for (_, tile) in beside.into_iter().filter(|(fits, _)| *fits) {
                if let Some(to) = self.nearest(patch, tile)
                    && self.nearest(&self.list[to], patch.tile) == Some(from)
                {
                    self.links.push([from, to]);
                }
            }
        }
    }

    #[inline(never)]
    fn nearest(&self, patch: &Patch, tile: usize) -> Option<usize> {
        let (mut best, mut least) = (None, STEP);
        for other in self.starts[tile]..self.starts[tile + 1] {
            let gap = |k: usize| (self.list[other].color[k] - patch.color[k]).abs();
            let gap = gap(0).max(gap(1)).max(gap(2));
            if gap < least {
                (best, least) = (Some(other), gap);
            }
        }
        best
    }

    fn join(&mut self) {
        (0..self.list.len()).for_each(|i| self.list[i].region = i);
        for &[from, to] in &self.links {
            let (a, b) = (first(&self.list, from), first(&self.list, to));
            self.list[a.max(b)].region = a.min(b);
        }
        (0..self.list.len()).for_each(|i| self.list[i].region = first(&self.list, i));
    }

    /// Whether a tile has some of a region.
    pub(super) fn shows(&self, tile: usize, region: usize) -> bool {
        self.list[self.starts[tile]..self.starts[tile + 1]].iter().any(|patch| patch.region == region)
    }

    /// What the logarithm of a channel differs by along a link; dark ones say nothing.
    #[inline(never)]
    pub(super) fn difference(&self, [from, to]: [usize; 2], channel: usize) -> Option<Difference> {
        let [from, to] = [&self.list[from], &self.list[to]];
        let (a, b) = (from.color[channel], to.color[channel]);
        (a.min(b) >= DARK).then(|| Difference {
            places: [from.place, to.place],
            gap: libm::log(b / a),
            // The noise of a logarithm is that of the channel over what it is.
            weight: from.weight.min(to.weight) * a * b / 65_025.0,
        })
    }
}

/// The first patch of the region of one, while regions are joined.
fn first(list: &[Patch], mut i: usize) -> usize {
    while list[i].region != i {
        i = list[i].region;
    }
    i
}
