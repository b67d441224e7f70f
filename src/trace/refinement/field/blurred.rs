//! Fields of pictures that are blurred: what is left is compared with the outlines blurred alike, tile by tile, where something has changed.

use super::{AREA, Field, NONE, SIDE, tile};
use crate::numerics::order::sort_in_place;
use crate::trace::picture::blur::half_gaussian;
use core::ops::Range;
use wide::f32x4;

/// The farthest that a blur reaches, in pixels: tiles next to each other.
const REACH: usize = SIDE;
/// Pixels along the side of a tile with those around it.
const WIDE: usize = SIDE + 2 * REACH;
/// A tile and the eight around it, column by column.
pub(super) type Block = [[[f32; 4]; WIDE / 4]; WIDE];
pub(super) const EMPTY: Block = [[[0.0; 4]; WIDE / 4]; WIDE];

/// A picture that is blurred.
#[derive(Debug)]
pub(super) struct Blur {
    half: Vec<f32>,
    /// What the picture shows.
    target: Vec<f32>,
    pub(super) cover: Vec<f32>,
    /// What is left, blurred once more: what it says to the outlines. Found for tiles that are asked, as most trials ask few.
    lead: Vec<f32>,
    /// Columns of each tile whose lead is not known.
    unheard: Vec<u8>,
    /// Where coverage has changed.
    changed: Vec<Touched>,
    /// Columns of each tile that have to be blurred again; none between two steps.
    stale: Vec<u8>,
}

impl Blur {
    /// The blurred picture and what covers it before blurs; room for as many numbers.
    pub(super) fn new(half: Vec<f32>, [target, cover, lead]: [Vec<f32>; 3]) -> Self {
        let stale = vec![0; target.len() / AREA];
        Self { half, target, cover, lead, unheard: vec![u8::MAX; stale.len()], changed: Vec::new(), stale }
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
        let mut near = Vec::with_capacity(2 * blur.changed.len());
        for touched in blur.changed.drain(..) {
            self.around(touched, &blur.half, |slot, columns| {
                let stale = &mut blur.stale[slot as usize];
                if *stale == 0 {
                    near.push(slot);
                }
                *stale |= columns;
            });
        }
        sort_in_place(&mut near);
        let (mut growth, mut block) = (0.0, EMPTY);
        for slot in near {
            let columns = core::mem::take(&mut blur.stale[slot as usize]);
            let blurred = self.blurred(&mut block, &blur.cover, (slot, columns), &blur.half, true);
            let from = slot as usize * AREA;
            let mut touched = Touched { slot, columns: 0, rows: 0 };
            for x in bits(columns) {
                let here = from + x * SIDE..from + (x + 1) * SIDE;
                let (rest, target) = (&mut self.rest[here.clone()], &blur.target[here]);
                let mut rows = 0;
                for (y, ((rest, target), value)) in rest.iter_mut().zip(target).zip(&blurred[x]).enumerate() {
                    let (before, after) = (*rest, target - value);
                    *rest = after;
                    rows |= u8::from(before != after) << y;
                    growth += f64::from(after) * f64::from(after) - f64::from(before) * f64::from(before);
                }
                touched.column(x, rows);
            }
            self.around(touched, &blur.half, |slot, columns| blur.unheard[slot as usize] |= columns);
        }
        self.blur = Some(blur);
        growth
    }

    /// What these pixels say to the outlines becomes known.
    pub(in crate::trace::refinement) fn hear(&mut self, pixels: impl Iterator<Item = u32>) {
        let Some(mut blur) = self.blur.take() else { return };
        let mut block = EMPTY;
        for pixel in pixels {
            let slot = pixel / AREA as u32;
            if let Some(unheard) = blur.unheard.get_mut(slot as usize)
                && *unheard != 0
            {
                let columns = core::mem::take(unheard);
                let blurred = self.blurred(&mut block, &self.rest, (slot, columns), &blur.half, false);
                for x in bits(columns) {
                    let from = slot as usize * AREA + x * SIDE;
                    blur.lead[from..from + SIDE].copy_from_slice(&blurred[x]);
                }
            }
        }
        self.blur = Some(blur);
    }

    /// What every pixel that was heard says to the outlines.
    pub(in crate::trace::refinement) fn lead(&self) -> &[f32] {
        self.blur.as_ref().map_or(&self.rest, |blur| &blur.lead)
    }

    /// How much of the sharp picture's stiffness is left after the blur.
    pub(in crate::trace::refinement) fn stiffness(&self) -> f64 {
        let Some(blur) = &self.blur else { return 1.0 };
        // Across an edge a pixel's box and the blur leave about the sum of squares of the blur's weights.
        let one = f64::from(blur.half[0]);
        one * one + 2.0 * blur.half[1..].iter().map(|&w| f64::from(w) * f64::from(w)).sum::<f64>()
    }

    /// The tiles that a blur takes what was touched to, each with the columns that it takes it to.
    #[inline(always)]
    fn around(&self, Touched { slot, columns, rows }: Touched, half: &[f32], mut each: impl FnMut(u32, u8)) {
        let reach = (half.len() - 1).min(REACH);
        let (columns, rows) = (spread(columns, reach), spread(rows, reach));
        let place = self.places[slot as usize] as usize;
        for (dy, _) in rows.iter().enumerate().filter(|&(_, &rows)| rows != 0) {
            for (dx, &columns) in columns.iter().enumerate().filter(|&(_, &columns)| columns != 0) {
                let at = (place + dy * self.across + dx).checked_sub(self.across + 1);
                if let Some(&other) = at.and_then(|at| self.slots.get(at))
                    && other != NONE
                {
                    each(other, columns);
                }
            }
        }
    }

    /// The pixels of some columns of one tile, blurred. Where no tile is, the nearest pixel's own side counts, or nothing.
    pub(super) fn blurred(
        &self,
        block: &mut Block,
        plane: &[f32],
        (slot, columns): (u32, u8),
        half: &[f32],
        own: bool,
    ) -> [[f32; SIDE]; SIDE] {
        let reach = (half.len() - 1).min(REACH);
        let (first, last) = (columns.trailing_zeros() as usize, SIDE - columns.leading_zeros() as usize);
        self.fill(block, plane, slot, own, REACH + first - reach..REACH + last + reach);
        let mut out = [[0.0; SIDE]; SIDE];
        for x in bits(columns) {
            let column = |at: usize| block[at].map(f32x4::new);
            let along = weighted(half, reach, |d| [column(REACH + x - d), column(REACH + x + d)]);
            let along = along.map(f32x4::to_array);
            let sums = weighted(half, reach, |d| [rows(&along, REACH - d), rows(&along, REACH + d)]);
            out[x].copy_from_slice(sums.map(f32x4::to_array).as_flattened());
        }
        out
    }

    /// Fills some columns of a block with a tile and the eight around it.
    fn fill(&self, block: &mut Block, plane: &[f32], slot: u32, own: bool, wanted: Range<usize>) {
        let columns = |slot: u32| &plane.as_chunks::<SIDE>().0[slot as usize * SIDE..][..SIDE];
        let middle = columns(slot);
        let place = self.places[slot as usize] as usize;
        for k in 0..9 {
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
                let nearest = |at: usize, side: usize| [0, at, SIDE - 1][side];
                for x in wanted {
                    let column = &mut block[from + x].as_flattened_mut()[below * SIDE..][..SIDE];
                    for (y, pixel) in column.iter_mut().enumerate() {
                        let ink = own && middle[nearest(x, right)][nearest(y, below)] >= 0.5;
                        *pixel = if ink { 1.0 } else { 0.0 };
                    }
                }
            }
        }
    }
}

/// Which of four numbers differ, a bit each.
#[inline(always)]
fn differing(before: [f32; 4], after: [f32; 4]) -> u8 {
    f32x4::new(before).simd_ne(f32x4::new(after)).to_bitmask() as u8
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

/// The weights of a Gaussian from the middle outwards.
pub(super) fn half_of(sigma: f64) -> Vec<f32> {
    half_gaussian(sigma).iter().map(|&weight| weight as f32).collect()
}

/// As many rows of a column as a tile has, from one on.
#[inline(always)]
fn rows(column: &[[f32; 4]; WIDE / 4], from: usize) -> [f32x4; SIDE / 4] {
    let mut rows = [[0.0; 4]; SIDE / 4];
    rows.as_flattened_mut().copy_from_slice(&column.as_flattened()[from..from + SIDE]);
    rows.map(f32x4::new)
}

/// What is in the middle, and at every distance up to `reach` on both sides of it, by the weights of a blur.
#[inline(always)]
fn weighted<const N: usize>(half: &[f32], reach: usize, at: impl Fn(usize) -> [[f32x4; N]; 2]) -> [f32x4; N] {
    let [middle, _] = at(0);
    let mut sums = middle.map(|value| half[0] * value);
    for (d, &weight) in (1..).zip(&half[1..=reach]) {
        let [before, behind] = at(d);
        sums = core::array::from_fn(|i| sums[i] + weight * (before[i] + behind[i]));
    }
    sums
}
