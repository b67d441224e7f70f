//! The pixels near outlines, in tiles: what the picture shows of their coverage that the outlines do not explain.

use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::Point;
use crate::numerics::four::Four;
use crate::numerics::order::sort_in_place;
use crate::numerics::plane::larger;
use crate::trace::picture::blur::half_gaussian;
use crate::trace::picture::gray::Gray;

/// Pixels along a tile's side, and around the picture: one tile of paper.
pub(super) const SIDE: usize = 8;
/// Pixels of a tile.
pub(super) const AREA: usize = SIDE * SIDE;
/// No tile, no pixel.
pub(super) const NONE: u32 = u32::MAX;
/// The farthest that a blur reaches, in pixels: tiles next to each other.
const REACH: usize = SIDE;
/// Pixels along the side of a tile with those around it.
const WIDE: usize = SIDE + 2 * REACH;
/// A tile and the eight around it, column by column.
type Block = [[[f32; SIDE]; 3]; WIDE];
const EMPTY: Block = [[[0.0; SIDE]; 3]; WIDE];

/// The share of pixels beside outlines that are off their tone from which on a picture is not one of exact coverage.
const ROUGH: f64 = 0.2;

/// How shades become coverage.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct Shading {
    pub(in crate::trace) ink: f64,
    pub(in crate::trace) paper: f64,
    /// The shade of half coverage.
    pub(in crate::trace) level: f64,
    pub(in crate::trace) inverted: bool,
}

/// What an exchange of parts does to one tile: areas to the right of them inside pixels, and heights, in the order of the pixels.
#[derive(Clone, Debug, Default)]
pub(super) struct Change {
    areas: [[f32; 4]; AREA / 4],
    heights: [[f32; 4]; AREA / 4],
    /// What the tile was before.
    before: [[f32; 4]; AREA / 4],
}

impl Change {
    /// What one part adds in a pixel of the tile.
    #[inline(always)]
    pub(super) fn add(&mut self, pixel: usize, area: f32, height: f32) {
        self.areas.as_flattened_mut()[pixel % AREA] += area;
        self.heights.as_flattened_mut()[pixel % AREA] += height;
    }
}

/// Tiles of pixels near the outlines, column by column: what runs through a row is done for all rows of a tile at once.
#[derive(Debug)]
pub(super) struct Field {
    /// Tiles in a row.
    across: usize,
    down: usize,
    /// Columns and rows of the picture.
    extent: [f64; 2],
    slots: Vec<u32>,
    /// Where each tile is.
    places: Vec<u32>,
    /// What is left: what the picture shows less what the outlines cover, blurred like the picture.
    pub(super) rest: Vec<f32>,
    /// Of the pixels that are nearly ink or nearly paper, the share that is neither: strong compression leaves most of them so.
    stain: f64,
    blur: Option<Blur>,
}

/// A picture that is blurred.
#[derive(Debug)]
struct Blur {
    half: Vec<f32>,
    target: Vec<f32>,
    cover: Vec<f32>,
    /// What is left, blurred once more: what it says to the outlines. Found for tiles that are asked, as most trials ask few.
    lead: Vec<f32>,
    /// Tiles whose lead is not known.
    unheard: Vec<bool>,
    /// Tiles whose coverage has changed.
    changed: Vec<u32>,
}

impl Shading {
    /// The coverage of a shade, piecewise linear: ink is 1, the level ½, paper 0.
    fn coverage(&self) -> impl Fn(f64) -> f64 {
        let Self { ink, paper, level, inverted } = *self;
        let (dark, light) = (0.5 / larger(level - ink, 1.0), 0.5 / larger(paper - level, 1.0));
        move |shade| {
            let cover = if shade < level { 1.0 - (shade - ink) * dark } else { (paper - shade) * light };
            if inverted { 1.0 - cover } else { cover }
        }
    }
}

impl Field {
    /// The tiles within `reach` pixels of the polylines; nothing covers them yet.
    pub(super) fn new<'a>(
        gray: &Gray,
        shading: &Shading,
        polylines: impl Iterator<Item = &'a [Point]>,
        reach: f64,
    ) -> Result<Self> {
        let (across, down) = (gray.width().div_ceil(SIDE) + 2, gray.height().div_ceil(SIDE) + 2);
        let mut slots: Vec<u32> = with_room(across * down)?;
        slots.resize(across * down, NONE);
        let mut places = Vec::new();
        let side = SIDE as f64;
        for polyline in polylines {
            for p in polyline {
                let tile = |v: f64, most: usize| (((v + side) / side).max(0.0) as usize).min(most - 1);
                let (left, right) = (tile(p.x - reach, across), tile(p.x + reach, across));
                for row in tile(p.y - reach, down)..=tile(p.y + reach, down) {
                    let first = row * across + left;
                    for (slot, place) in slots[first..=row * across + right].iter_mut().zip(first..) {
                        if *slot == NONE {
                            *slot = places.len() as u32;
                            places.push(place as u32);
                        }
                    }
                }
            }
        }
        let mut rest: Vec<f32> = with_room(AREA * places.len())?;
        let paper = if shading.inverted { shading.ink } else { shading.paper };
        let coverage = shading.coverage();
        for &place in &places {
            let (row, column) = (place as usize / across * SIDE, place as usize % across * SIDE);
            for x in column..column + SIDE {
                for y in row..row + SIDE {
                    let inside =
                        x >= SIDE && y >= SIDE && x - SIDE < gray.width() && y - SIDE < gray.height();
                    let shade = if inside { gray.shade(x - SIDE, y - SIDE) } else { paper };
                    rest.push(coverage(shade) as f32);
                }
            }
        }
        let (mut near, mut off) = (0_usize, 0_usize);
        for value in &rest {
            let from_tone = value.abs().min((1.0 - value).abs());
            near += usize::from(from_tone < 0.08);
            off += usize::from(from_tone < 0.08 && from_tone > 0.003);
        }
        let stain = off as f64 / near.max(1) as f64;
        let extent = [gray.width() as f64, gray.height() as f64];
        Ok(Self { across, down, extent, slots, places, rest, stain, blur: None })
    }

    /// Whether pixels beside outlines are off their tone, as compression leaves them.
    pub(super) fn is_compressed(&self) -> bool {
        self.stain > ROUGH
    }

    /// Whether a point is so far outside the picture that no pixel speaks of it.
    pub(super) fn is_beyond(&self, point: Point) -> bool {
        let [width, height] = self.extent;
        !(point.x > -1.0 && point.y > -1.0 && point.x < width + 1.0 && point.y < height + 1.0)
    }

    /// Pixels in a row, and rows.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.across * SIDE, self.down * SIDE)
    }

    /// The pixel at a column and a row, counted from the frame's corner.
    pub(super) fn pixel(&self, x: usize, y: usize) -> u32 {
        let slot = self.slots[y / SIDE * self.across + x / SIDE];
        if slot == NONE { NONE } else { slot * AREA as u32 + (x % SIDE * SIDE + y % SIDE) as u32 }
    }

    /// How many tiles there are.
    pub(super) fn tiles(&self) -> usize {
        self.places.len()
    }

    /// The place of a tile, of the tile at a column and a row, and which tile is there.
    pub(super) fn place(&self, slot: usize) -> u32 {
        self.places[slot]
    }

    pub(super) fn place_at(&self, x: usize, y: usize) -> u32 {
        (y / SIDE * self.across + x / SIDE) as u32
    }

    pub(super) fn slot(&self, place: u32) -> Option<usize> {
        let slot = self.slots[place as usize];
        (slot != NONE).then_some(slot as usize)
    }

    /// The first place behind the row of tiles that a place is in.
    pub(super) fn row_end(&self, place: u32) -> u32 {
        let across = self.across as u32;
        (place / across + 1) * across
    }

    /// The outlines cover more or less of the pixels of a tile, with heights that run in from the left and on to the right; how much the sum
    /// of squares grows, if that is known at once. The change is used up, but for what takes it back.
    pub(super) fn cover(&mut self, slot: usize, change: &mut Change, running: &mut [f32; SIDE]) -> f64 {
        let sign = if self.blur.is_some() { -1.0 } else { 1.0 };
        let pixels = self.covered(slot);
        let mut growth = 0.0;
        for (half, running) in running.as_chunks_mut().0.iter_mut().enumerate() {
            let part = cover_half(pixels, change, half, (running, sign));
            growth = part.into_iter().fold(growth, |sum, part| sum + f64::from(part));
        }
        if sign < 0.0 { 0.0 } else { growth }
    }

    /// A tile is again what it was before a change that covered it.
    pub(super) fn take_back(&mut self, slot: usize, change: &Change) {
        for (pixels, before) in self.covered(slot).iter_mut().zip(&change.before) {
            *pixels = *before;
        }
    }

    /// The pixels of a tile that are about to be covered, or no longer.
    fn covered(&mut self, slot: usize) -> &mut [[f32; 4]] {
        let plane = match &mut self.blur {
            Some(blur) => {
                blur.changed.push(slot as u32);
                &mut blur.cover
            }
            None => &mut self.rest,
        };
        plane[slot * AREA..(slot + 1) * AREA].as_chunks_mut().0
    }

    /// Takes what has changed into account; how much the sum of squares has grown by it.
    pub(super) fn settle(&mut self) -> f64 {
        let Some(mut blur) = self.blur.take() else { return 0.0 };
        let mut changed = core::mem::take(&mut blur.changed);
        sort_in_place(&mut changed);
        changed.dedup();
        let mut near = self.around(&changed);
        sort_in_place(&mut near);
        near.dedup();
        let (mut growth, mut block) = (0.0, EMPTY);
        for &slot in &near {
            let blurred = self.blurred(&mut block, &blur.cover, slot, &blur.half, true);
            let from = slot as usize * AREA;
            for (i, value) in blurred.iter().enumerate() {
                let (before, after) = (self.rest[from + i], blur.target[from + i] - value);
                self.rest[from + i] = after;
                growth += f64::from(after) * f64::from(after) - f64::from(before) * f64::from(before);
            }
        }
        for slot in self.around(&near) {
            blur.unheard[slot as usize] = true;
        }
        self.blur = Some(blur);
        growth
    }

    /// What these pixels say to the outlines becomes known.
    pub(super) fn hear(&mut self, pixels: impl Iterator<Item = u32>) {
        let Some(mut blur) = self.blur.take() else { return };
        let mut block = EMPTY;
        for pixel in pixels {
            let slot = pixel / AREA as u32;
            if let Some(unheard) = blur.unheard.get_mut(slot as usize)
                && core::mem::take(unheard)
            {
                let from = slot as usize * AREA;
                let blurred = self.blurred(&mut block, &self.rest, slot, &blur.half, false);
                blur.lead[from..from + AREA].copy_from_slice(&blurred);
            }
        }
        self.blur = Some(blur);
    }

    /// What every pixel that was heard says to the outlines.
    pub(super) fn lead(&self) -> &[f32] {
        self.blur.as_ref().map_or(&self.rest, |blur| &blur.lead)
    }

    /// How much of the sharp picture's stiffness is left after the blur.
    pub(super) fn stiffness(&self) -> f64 {
        let Some(blur) = &self.blur else { return 1.0 };
        // Across an edge a pixel's box and the blur leave about the sum of squares of the blur's weights.
        let one = f64::from(blur.half[0]);
        one * one + 2.0 * blur.half[1..].iter().map(|&w| f64::from(w) * f64::from(w)).sum::<f64>()
    }

    /// The root mean square of what is left.
    pub(super) fn left(&self) -> f64 {
        let square: f64 = self.rest.iter().map(|&r| f64::from(r) * f64::from(r)).sum();
        (square / self.rest.len().max(1) as f64).sqrt()
    }

    /// The picture is found to be blurred by as much as makes the outlines, which are rendered, most like it.
    pub(super) fn find_blur(&mut self, target: Vec<f32>) {
        const STEP: f64 = 0.25;
        let cover: Vec<f32> = target.iter().zip(&self.rest).map(|(t, r)| t - r).collect();
        let square = |field: &Self, sigma: f64| {
            let half = half_of(sigma);
            let (mut sum, mut block) = (0.0, EMPTY);
            for slot in 0..field.places.len() {
                let blurred = field.blurred(&mut block, &cover, slot as u32, &half, true);
                for (value, target) in blurred.iter().zip(&target[slot * AREA..]) {
                    sum += f64::from(target - value) * f64::from(target - value);
                }
            }
            sum
        };
        let squares: [f64; 9] = core::array::from_fn(|i| square(self, STEP * i as f64));
        let best = (0..squares.len()).fold(0, |best, i| if squares[i] < squares[best] { i } else { best });
        if best == 0 {
            return;
        }
        let mut sigma = STEP * best as f64;
        if best + 1 < squares.len() {
            let (before, after) = (squares[best - 1] - squares[best], squares[best + 1] - squares[best]);
            sigma += STEP * 0.5 * (before - after) / (before + after).max(1e-12);
        }
        let half = half_of(sigma);
        self.blur(target, cover, half);
    }

    /// The picture is blurred like the outlines, so that it says where an edge is by more than the pixels that the edge is in.
    pub(super) fn blur_both(&mut self, target: Vec<f32>, sigma: f64) {
        let half = half_of(sigma);
        let cover: Vec<f32> = target.iter().zip(&self.rest).map(|(t, r)| t - r).collect();
        let (mut blurred, mut block) = (Vec::with_capacity(target.len()), EMPTY);
        for slot in 0..self.places.len() {
            blurred.extend(self.blurred(&mut block, &target, slot as u32, &half, true));
        }
        self.blur(blurred, cover, half);
    }

    fn blur(&mut self, target: Vec<f32>, cover: Vec<f32>, half: Vec<f32>) {
        let changed = (0..self.places.len() as u32).collect();
        let (lead, unheard) = (self.rest.clone(), vec![true; self.places.len()]);
        self.blur = Some(Blur { half, target, cover, lead, unheard, changed });
        self.settle();
    }

    /// Tiles and those next to them, some more than once.
    #[inline(never)]
    fn around(&self, slots: &[u32]) -> Vec<u32> {
        let mut found = Vec::with_capacity(slots.len() * 9);
        for &slot in slots {
            let place = self.places[slot as usize] as usize;
            for dy in 0..3 {
                for dx in 0..3 {
                    let at = (place + dy * self.across + dx).checked_sub(self.across + 1);
                    if let Some(&other) = at.and_then(|at| self.slots.get(at))
                        && other != NONE
                    {
                        found.push(other);
                    }
                }
            }
        }
        found
    }

    /// The pixels of one tile, blurred. Where no tile is, the nearest pixel's own side counts, or nothing.
    fn blurred(&self, block: &mut Block, plane: &[f32], slot: u32, half: &[f32], own: bool) -> [f32; AREA] {
        let reach = (half.len() - 1).min(REACH);
        self.fill(block, plane, slot, own);
        let mut out = [0.0; AREA];
        for (x, out) in out.as_chunks_mut::<SIDE>().0.iter_mut().enumerate() {
            // Rows beyond the reach say nothing.
            let rows = REACH - reach..REACH + SIDE + reach;
            let column = |at: usize| &block[at].as_flattened()[rows.clone()];
            let mut along = [0.0; WIDE];
            weigh(&mut along[rows.clone()], half[0], [column(REACH + x), &[0.0; WIDE]]);
            for (d, &weight) in (1..).zip(&half[1..=reach]) {
                weigh(&mut along[rows.clone()], weight, [column(REACH + x - d), column(REACH + x + d)]);
            }
            weigh(out, half[0], [&along[REACH..REACH + SIDE], &[0.0; SIDE]]);
            for (d, &weight) in (1..).zip(&half[1..=reach]) {
                weigh(out, weight, [&along[REACH - d..][..SIDE], &along[REACH + d..][..SIDE]]);
            }
        }
        out
    }

    /// Fills a block with a tile and the eight around it.
    fn fill(&self, block: &mut Block, plane: &[f32], slot: u32, own: bool) {
        let columns = |slot: u32| &plane.as_chunks::<SIDE>().0[slot as usize * SIDE..][..SIDE];
        let middle = columns(slot);
        let place = self.places[slot as usize] as usize;
        for k in 0..9 {
            let (right, below) = (k % 3, k / 3);
            let (column, row) = (place % self.across + right, place / self.across + below);
            let inside = column > 0 && row > 0 && column <= self.across && row <= self.down;
            let other = if inside { self.slots[(row - 1) * self.across + column - 1] } else { NONE };
            if other != NONE {
                for (x, from) in columns(other).iter().enumerate() {
                    block[right * SIDE + x][below] = *from;
                }
            } else {
                let nearest = |at: usize, side: usize| [0, at, SIDE - 1][side];
                for x in 0..SIDE {
                    for y in 0..SIDE {
                        let ink = own && middle[nearest(x, right)][nearest(y, below)] >= 0.5;
                        block[right * SIDE + x][below][y] = if ink { 1.0 } else { 0.0 };
                    }
                }
            }
        }
    }
}

/// The weights of a Gaussian from the middle outwards.
fn half_of(sigma: f64) -> Vec<f32> {
    half_gaussian(sigma).iter().map(|&weight| weight as f32).collect()
}

/// Covers the upper or the lower half of a tile's rows, column by column; how much the sum of squares grows in each row.
#[inline(always)]
fn cover_half(
    pixels: &mut [[f32; 4]],
    change: &mut Change,
    half: usize,
    (running, sign): (&mut [f32; 4], f32),
) -> [f32; 4] {
    let (mut heights, sign) = (Four::new(*running), Four::equal(sign));
    let mut growth = Four::equal(0.0);
    for column in 0..SIDE {
        let at = 2 * column + half;
        let before = Four::new(pixels[at]);
        let after = before + sign * (heights + Four::new(change.areas[at]));
        pixels[at] = after.each();
        growth = growth + (after - before) * (after + before);
        heights = heights + Four::new(change.heights[at]);
        (change.areas[at], change.heights[at], change.before[at]) = ([0.0; 4], [0.0; 4], before.each());
    }
    *running = heights.each();
    growth.each()
}

/// Adds the weighted sums of two lists of the same length.
#[inline(always)]
fn weigh(sums: &mut [f32], weight: f32, [a, b]: [&[f32]; 2]) {
    for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
        *sum += weight * (a + b);
    }
}
