//! Fields of pictures that are blurred: what is left is compared with the outlines blurred alike, tile by tile, where
//! something has changed.

use super::levels::Levels;
use super::{AREA, Field, NONE, SIDE, tile};
use crate::numerics::order::sort_in_place;
use crate::trace::picture::blur::half_gaussian;
use core::ops::Range;
use wide::f32x4;

/// The farthest that a blur reaches, in pixels: tiles next to each other.
const REACH: usize = SIDE;
/// Most blurs reach no farther.
const NEAR: usize = SIDE / 2;
/// Pixels along the side of a tile with those around it.
const WIDE: usize = SIDE + 2 * REACH;
/// A pixel's column with those that a blur brings to it.
type Around = [[[f32; 4]; WIDE / 4]; 2 * REACH + 1];
/// A tile and the eight around it, column by column.
pub(super) type Block = [[[f32; 4]; WIDE / 4]; WIDE];
pub(super) const EMPTY: Block = [[[0.0; 4]; WIDE / 4]; WIDE];

/// A picture that is blurred.
#[derive(Debug)]
pub(super) struct Blur {
    gaussian: Gaussian,
    /// What the picture shows.
    target: Levels,
    pub(super) cover: Vec<f32>,
    /// What is left, blurred once more: what it says to the outlines. Found for tiles that are asked, as most trials
    /// ask few.
    lead: Vec<f32>,
    /// The region of each tile whose lead is not known.
    unheard: Vec<Region>,
    /// Where coverage has changed.
    changed: Vec<Touched>,
    /// The region of each tile that has to be blurred again; none between two steps.
    stale: Vec<Region>,
    undo: Undo,
}

/// The weights of a Gaussian from the middle outwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gaussian {
    weights: [f32; REACH + 1],
    /// How far it reaches.
    reach: usize,
}

impl Gaussian {
    pub(super) fn new(sigma: f64) -> Self {
        let half = half_gaussian(sigma);
        let mut weights = [0.0; REACH + 1];
        weights.iter_mut().zip(&half).for_each(|(weight, &given)| *weight = given as f32);
        Self { weights, reach: (half.len() - 1).min(REACH) }
    }

    /// Whether it reaches no farther than half a tile.
    fn is_near(&self) -> bool {
        self.reach <= NEAR
    }
}

/// Some columns of a tile, a bit each, and of these its upper and its lower half.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Region {
    columns: u8,
    halves: u8,
}

impl Region {
    pub(super) const ALL: Self = Self { columns: u8::MAX, halves: 3 };

    fn is_empty(self) -> bool {
        self.columns == 0
    }

    fn join(self, other: Self) -> Self {
        Self { columns: self.columns | other.columns, halves: self.halves | other.halves }
    }

    /// The first row of it, and the one behind its last.
    fn rows(self) -> Range<usize> {
        let first = if self.halves & 1 == 0 { SIDE / 2 } else { 0 };
        first..if self.halves & 2 == 0 { SIDE / 2 } else { SIDE }
    }
}

/// What takes back the last time that changes were taken into account.
#[derive(Debug, Default)]
struct Undo {
    /// Tiles with columns that were others, which follow one another in `rest`.
    tiles: Vec<(u32, u8)>,
    rest: Vec<f32>,
    /// What was not heard of tiles, in the order in which more of them became so.
    unheard: Vec<(u32, Region)>,
}

impl Undo {
    fn clear(&mut self) {
        self.tiles.clear();
        self.rest.clear();
        self.unheard.clear();
    }
}

impl Blur {
    /// The blurred picture; what covers it before blurs, and room for as many numbers.
    pub(super) fn new(gaussian: Gaussian, target: Levels, [cover, lead]: [Vec<f32>; 2]) -> Self {
        let tiles = target.len() / AREA;
        let (unheard, stale) = (vec![Region::ALL; tiles], vec![Region::default(); tiles]);
        Self { gaussian, target, cover, lead, unheard, changed: Vec::new(), stale, undo: Undo::default() }
    }
}

/// The columns and the rows of a tile in which pixels are others than before, a bit each.
#[derive(Clone, Copy, Debug)]
struct Touched {
    slot: u32,
    columns: u8,
    rows: u8,
}

impl Touched {
    /// Where two states of a tile differ.
    fn new(slot: usize, before: &[[f32; 4]], after: &[[f32; 4]]) -> Self {
        let mut touched = Self { slot: slot as u32, columns: 0, rows: 0 };
        for (x, (before, after)) in before.chunks_exact(2).zip(after.chunks_exact(2)).enumerate() {
            touched.column(x, differing(before[0], after[0]) | differing(before[1], after[1]) << 4);
        }
        touched
    }

    /// These rows of a column differ.
    #[inline(always)]
    fn column(&mut self, x: usize, rows: u8) {
        self.columns |= u8::from(rows != 0) << x;
        self.rows |= rows;
    }
}

impl Field {
    /// A tile has been covered, which was like this before.
    pub(super) fn touch(&mut self, slot: usize, before: &[[f32; 4]]) {
        if let Some(blur) = &mut self.blur {
            let touched = Touched::new(slot, before, tile(&mut blur.cover, slot));
            blur.changed.push(touched);
        }
    }

    /// Takes what has changed into account; how much the sum of squares has grown by it.
    pub(in crate::trace::refinement) fn settle(&mut self) -> f64 {
        let Some(mut blur) = self.blur.take() else { return 0.0 };
        blur.undo.clear();
        let mut near = Vec::with_capacity(2 * blur.changed.len());
        for touched in blur.changed.drain(..) {
            self.around(touched, blur.gaussian.reach, |slot, region| {
                let stale = &mut blur.stale[slot as usize];
                if stale.is_empty() {
                    near.push(slot);
                }
                *stale = stale.join(region);
            });
        }
        sort_in_place(&mut near);
        let (mut growth, mut block, mut target) = (0.0, EMPTY, [0.0; AREA]);
        for slot in near {
            let region = core::mem::take(&mut blur.stale[slot as usize]);
            let blurred = self.blurred(&mut block, &blur.cover, (slot, region), &blur.gaussian, true);
            let from = slot as usize * AREA;
            blur.undo.tiles.push((slot, region.columns));
            let mut touched = Touched { slot, columns: 0, rows: 0 };
            blur.target.read(from, &mut target);
            for x in bits(region.columns) {
                let (rest, target) = (&mut self.rest[from + x * SIDE..][..SIDE], &target[x * SIDE..]);
                blur.undo.rest.extend_from_slice(rest);
                let halves = rest.as_chunks_mut().0.iter_mut().zip(target.as_chunks().0);
                let halves = halves.zip(blurred[x].as_chunks().0).enumerate();
                for (lower, ((rest, target), value)) in halves.filter(|(i, _)| region.halves >> i & 1 == 1) {
                    let (before, after) = (*rest, subtract(target, value));
                    *rest = after;
                    touched.column(x, differing(before, after) << (4 * lower));
                    for (before, after) in before.into_iter().zip(after) {
                        growth += f64::from(after) * f64::from(after) - f64::from(before) * f64::from(before);
                    }
                }
            }
            self.around(touched, blur.gaussian.reach, |slot, region| {
                let unheard = &mut blur.unheard[slot as usize];
                let more = unheard.join(region);
                if more != *unheard {
                    blur.undo.unheard.push((slot, *unheard));
                    *unheard = more;
                }
            });
        }
        self.blur = Some(blur);
        growth
    }

    /// All is again what it was before changes were taken into account the last time, which have been taken back.
    pub(in crate::trace::refinement) fn unsettle(&mut self) {
        let Some(blur) = &mut self.blur else { return };
        let mut rest = blur.undo.rest.as_chunks::<SIDE>().0.iter();
        for &(slot, columns) in &blur.undo.tiles {
            for (x, column) in bits(columns).zip(rest.by_ref()) {
                let from = slot as usize * AREA + x * SIDE;
                self.rest[from..from + SIDE].copy_from_slice(column);
            }
        }
        for &(slot, unheard) in blur.undo.unheard.iter().rev() {
            blur.unheard[slot as usize] = unheard;
        }
        blur.undo.clear();
    }

    /// What these pixels say to the outlines becomes known.
    pub(in crate::trace::refinement) fn hear(&mut self, pixels: impl Iterator<Item = u32>) {
        let Some(mut blur) = self.blur.take() else { return };
        let mut block = EMPTY;
        for pixel in pixels {
            let slot = pixel / AREA as u32;
            if let Some(unheard) = blur.unheard.get_mut(slot as usize)
                && !unheard.is_empty()
            {
                let region = core::mem::take(unheard);
                let blurred = self.blurred(&mut block, &self.rest, (slot, region), &blur.gaussian, false);
                for x in bits(region.columns) {
                    let (from, rows) = (slot as usize * AREA + x * SIDE, region.rows());
                    blur.lead[from + rows.start..from + rows.end].copy_from_slice(&blurred[x][rows]);
                }
            }
        }
        self.blur = Some(blur);
    }

    /// What every pixel that was heard says to the outlines.
    pub(in crate::trace::refinement) fn lead(&self) -> &[f32] {
        self.blur.as_ref().map_or(&self.rest, |blur| &blur.lead)
    }

    /// How much of what a pixel lacks is left in it by the blur.
    pub(in crate::trace::refinement) fn middle(&self) -> f64 {
        self.blur.as_ref().map_or(1.0, |blur| f64::from(blur.gaussian.weights[0]))
    }

    /// How much of the sharp picture's stiffness is left after the blur.
    pub(in crate::trace::refinement) fn stiffness(&self) -> f64 {
        let Some(blur) = &self.blur else { return 1.0 };
        // Across an edge a pixel's box and the blur leave about the sum of squares of the blur's weights.
        let [one, others @ ..] = blur.gaussian.weights;
        f64::from(one) * f64::from(one)
            + 2.0 * others.iter().map(|&w| f64::from(w) * f64::from(w)).sum::<f64>()
    }

    /// The tiles that a blur takes what was touched to, each with the region that it takes it to.
    #[inline(always)]
    fn around(
        &self,
        Touched { slot, columns, rows }: Touched,
        reach: usize,
        mut each: impl FnMut(u32, Region),
    ) {
        let (columns, rows) = (spread(columns, reach), spread(rows, reach));
        let place = self.places[slot as usize] as usize;
        for (dy, &rows) in rows.iter().enumerate().filter(|&(_, &rows)| rows != 0) {
            let halves = u8::from(rows & 15 != 0) | u8::from(rows >> 4 != 0) << 1;
            for (dx, &columns) in columns.iter().enumerate().filter(|&(_, &columns)| columns != 0) {
                let at = (place + dy * self.across + dx).checked_sub(self.across + 1);
                if let Some(&other) = at.and_then(|at| self.slots.get(at))
                    && other != NONE
                {
                    each(other, Region { columns, halves });
                }
            }
        }
    }

    /// The pixels of a region of one tile, blurred. Where no tile is, the nearest pixel's own side counts, or nothing.
    pub(super) fn blurred(
        &self,
        block: &mut Block,
        plane: &[f32],
        (slot, region): (u32, Region),
        gaussian: &Gaussian,
        own: bool,
    ) -> [[f32; SIDE]; SIDE] {
        let (reach, columns) = (gaussian.reach, region.columns);
        let (first, last) = (columns.trailing_zeros() as usize, SIDE - columns.leading_zeros() as usize);
        let high = region.rows();
        let wanted = [first..last, high.clone()].map(|Range { start, end }| {
            // Places in the block.
            REACH + start - reach..REACH + end + reach
        });
        self.fill(block, plane, slot, own, wanted);
        let mut out = [[0.0; SIDE]; SIDE];
        for x in bits(columns) {
            let Some(around) = block[x..].first_chunk() else { break };
            let along = if gaussian.is_near() {
                along::<{ WIDE / 4 - 2 }>(around, gaussian)
            } else {
                along::<{ WIDE / 4 }>(around, gaussian)
            };
            let along: &[f32] = along.as_flattened();
            if high.len() == SIDE {
                let sums = weighted::<{ SIDE / 4 }>(gaussian, |at| rows(along, at));
                out[x].copy_from_slice(sums.map(f32x4::to_array).as_flattened());
            } else {
                let [sums] = weighted(gaussian, |at| rows(along, at + high.start));
                out[x].as_chunks_mut().0[high.start / 4] = sums.to_array();
            }
        }
        out
    }

    /// Fills some columns and rows of a block, at least, with a tile and the eight around it.
    fn fill(
        &self,
        block: &mut Block,
        plane: &[f32],
        slot: u32,
        own: bool,
        [wanted, high]: [Range<usize>; 2],
    ) {
        let columns = |slot: u32| &plane.as_chunks::<SIDE>().0[slot as usize * SIDE..][..SIDE];
        let middle = columns(slot);
        let place = self.places[slot as usize] as usize;
        for k in 3 * (high.start / SIDE)..3 * high.end.div_ceil(SIDE) {
            let (right, below) = (k % 3, k / 3);
            let (column, row) = (place % self.across + right, place / self.across + below);
            let inside = column > 0 && row > 0 && column <= self.across && row <= self.down;
            let other = if inside { self.slots[(row - 1) * self.across + column - 1] } else { NONE };
            let from = right * SIDE;
            let wanted =
                wanted.start.clamp(from, from + SIDE) - from..wanted.end.clamp(from, from + SIDE) - from;
            if other != NONE {
                for (x, column) in wanted.clone().zip(&columns(other)[wanted]) {
                    block[from + x][2 * below..][..2].copy_from_slice(column.as_chunks().0);
                }
            } else {
                for x in wanted {
                    let nearest =
                        if own { beside(middle[[0, x, SIDE - 1][right]], below) } else { [0.0; SIDE] };
                    block[from + x][2 * below..][..2].copy_from_slice(nearest.as_chunks().0);
                }
            }
        }
    }
}

/// What is above, in or below a column as the side of the nearest pixel.
fn beside(column: [f32; SIDE], below: usize) -> [f32; SIDE] {
    let side = |shade: f32| if shade >= 0.5 { 1.0 } else { 0.0 };
    match below {
        0 => [side(column[0]); SIDE],
        1 => column.map(side),
        _ => [side(column[SIDE - 1]); SIDE],
    }
}

/// Which of four numbers differ, a bit each.
#[inline(always)]
fn differing(before: [f32; 4], after: [f32; 4]) -> u8 {
    f32x4::new(before).simd_ne(f32x4::new(after)).to_bitmask() as u8
}

/// Four numbers less four others.
#[inline(always)]
fn subtract(from: &[f32; 4], value: &[f32; 4]) -> [f32; 4] {
    (f32x4::new(*from) - f32x4::new(*value)).to_array()
}

/// The numbers of the bits that are set.
fn bits(mask: u8) -> impl Iterator<Item = usize> {
    (0..SIDE).filter(move |&k| mask & (1 << k) != 0)
}

/// Where a blur takes columns, or rows, of a tile to: in the tile before, in this one and in the one behind.
fn spread(mask: u8, reach: usize) -> [u8; 3] {
    let here = u32::from(mask) << SIDE;
    let wide = (1..=reach).fold(here, |wide, d| wide | (here << d) | (here >> d));
    [wide as u8, (wide >> SIDE) as u8, (wide >> (2 * SIDE)) as u8]
}

/// A column blurred by those beside it: `N` times four rows, in the middle.
#[inline(always)]
fn along<const N: usize>(around: &Around, gaussian: &Gaussian) -> [[f32; 4]; WIDE / 4] {
    let skipped = (WIDE / 4 - N) / 2;
    let sums = weighted::<N>(gaussian, |at| core::array::from_fn(|i| f32x4::new(around[at][i + skipped])));
    let mut along = [[0.0; 4]; WIDE / 4];
    along[skipped..skipped + N].copy_from_slice(&sums.map(f32x4::to_array));
    along
}

/// Some rows of a column, from one on, four at a time.
#[inline(always)]
fn rows<const N: usize>(column: &[f32], from: usize) -> [f32x4; N] {
    let mut rows = [[0.0; 4]; N];
    rows.as_flattened_mut().copy_from_slice(&column[from..from + 4 * N]);
    rows.map(f32x4::new)
}

/// What is in the middle, `REACH` places from the first, and at every distance on both sides of it, by the weights of a
/// blur.
#[inline(always)]
fn weighted<const N: usize>(gaussian: &Gaussian, at: impl Fn(usize) -> [f32x4; N]) -> [f32x4; N] {
    let &Gaussian { weights: [middle, ref others @ ..], reach } = gaussian;
    let mut sums = at(REACH).map(|value| middle * value);
    for (d, &weight) in (1..).zip(others.iter().take(reach)) {
        let (before, behind) = (at(REACH - d), at(REACH + d));
        sums = core::array::from_fn(|i| sums[i] + weight * (before[i] + behind[i]));
    }
    sums
}
