//! The pixels near outlines, in tiles: what the picture shows of their coverage that the outlines do not explain.

mod blurred;
mod blurring;
mod journal;
mod levels;

use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::Point;
use crate::numerics::plane::larger;
use crate::trace::picture::gray::Gray;
use blurred::Blur;
pub(super) use blurring::{Alike, Blurring};
use journal::Journal;
use wide::f32x4;

/// Pixels along a tile's side, and around the picture: one tile of paper.
pub(super) const SIDE: usize = 8;
/// Pixels of a tile.
pub(super) const AREA: usize = SIDE * SIDE;
/// No tile.
pub(super) const NONE: u32 = u32::MAX;
/// From here on numbers are not of pixels but of rows where no tile is: rows of a tile times its place, and the row.
pub(super) const BEYOND: u32 = 1 << 31;
/// The share of pixels beside outlines that are off their tone from which on a picture is not one of exact coverage.
const ROUGH: f64 = 0.2;

/// So many pixels side by side that are of one shade are of a tone of their own.
const RUN: usize = 3;

/// Tiles reach farther than this from contours of a blurred picture, in pixels: corners are twice as far from those.
const BLURRED: f64 = 4.0;

/// How shades become coverage.
#[derive(Clone, Copy, Debug)]
pub(in crate::trace) struct Shading {
    pub(in crate::trace) ink: f64,
    pub(in crate::trace) paper: f64,
    /// The shade of half coverage.
    pub(in crate::trace) level: f64,
    pub(in crate::trace) inverted: bool,
}

/// What an exchange of parts does to one tile: areas to the right of them inside pixels, and heights, in the order of
/// the pixels.
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
    pub(super) extent: [f64; 2],
    slots: Vec<u32>,
    /// Where each tile is.
    places: Vec<u32>,
    /// Which pixels of each tile are next to a point of the polylines: one bit for each.
    near: Vec<u64>,
    /// What is left: what the picture shows less what the outlines cover, blurred like the picture.
    pub(super) rest: Vec<f32>,
    /// Of the pixels that are nearly ink or nearly paper, the share that is neither: strong compression leaves most of
    /// them so.
    stain: f64,
    blur: Option<Blur>,
    journal: Journal,
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

/// Of the pixels that are nearly ink or nearly paper, the share that is neither, nor of one shade with others of their
/// column and their row, as the inside of a shape is that is a little darker than paper.
fn stain(pixels: &[f32]) -> f64 {
    let (mut near, mut off) = (0_usize, 0_usize);
    for tile in pixels.as_chunks().0 {
        for (place, value) in tile.iter().enumerate() {
            let from_tone = value.abs().min((1.0 - value).abs());
            near += usize::from(from_tone < 0.08);
            let stained = from_tone < 0.08 && from_tone > 0.003;
            off += usize::from(stained && !(is_even(tile, place, 1) && is_even(tile, place, SIDE)));
        }
    }
    off as f64 / near.max(1) as f64
}

/// Whether a pixel of a tile is one of a run of one shade, along its column or, in steps of a column, its row.
fn is_even(tile: &[f32; AREA], place: usize, step: usize) -> bool {
    let at = place / step % SIDE;
    let line = place - at * step;
    let same = |k: usize| tile[line + k * step] == tile[place];
    (at.saturating_sub(RUN - 1)..=at.min(SIDE - RUN)).any(|first| (first..first + RUN).all(same))
}

impl Field {
    /// The tiles within `reach` pixels of the polylines; nothing covers them yet.
    pub(super) fn new<'a>(
        gray: &Gray,
        shading: &Shading,
        polylines: impl Iterator<Item = &'a [Point]> + Clone,
        reach: f64,
    ) -> Result<Self> {
        let mut field = Self::of_pixels(gray, shading, polylines.clone(), reach)?;
        field.near = with_room(field.tiles())?;
        field.near.resize(field.tiles(), 0);
        for polyline in polylines {
            polyline.iter().for_each(|&point| field.mark(point, if reach > BLURRED { 2 } else { 1 }));
        }
        Ok(field)
    }

    /// The same, before it is known what is next to the polylines.
    fn of_pixels<'a>(
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
        let (blank, width) = (coverage(paper) as f32, gray.width());
        for &place in &places {
            let (row, column) = (place as usize / across * SIDE, place as usize % across * SIDE);
            let columns = column.max(SIDE)..(column + SIDE).min(width + SIDE);
            let mut tile = [[blank; SIDE]; SIDE];
            for y in row.max(SIDE)..(row + SIDE).min(gray.height() + SIDE) {
                let shades =
                    gray.row(y - SIDE).get(columns.start - SIDE..columns.end - SIDE).unwrap_or_default();
                for (tile, &shade) in tile[columns.start - column..].iter_mut().zip(shades) {
                    tile[y - row] = coverage(f64::from(shade)) as f32;
                }
            }
            rest.extend_from_slice(tile.as_flattened());
        }
        let stain = stain(&rest);
        let extent = [gray.width() as f64, gray.height() as f64];
        let (near, blur, journal) = (Vec::new(), None, Journal::default());
        Ok(Self { across, down, extent, slots, places, near, rest, stain, blur, journal })
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

    /// The pixel around a point and those so near to it are near.
    fn mark(&mut self, point: Point, reach: i32) {
        let (columns, rows) = self.size();
        let [column, row] = [point.x, point.y].map(|v| (v + SIDE as f64).floor() as i32);
        for (x, y) in (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| (column + x, row + y))) {
            if (0..columns as i32).contains(&x) && (0..rows as i32).contains(&y) {
                let pixel = self.pixel(x as usize, y as usize) as usize;
                if let Some(tile) = self.near.get_mut(pixel / AREA) {
                    *tile |= 1 << (pixel % AREA);
                }
            }
        }
    }

    /// Whether a point is within a pixel of the polylines, or less than three. What is beyond the picture is not.
    pub(super) fn is_near(&self, point: Point) -> bool {
        let [x, y] = [point.x, point.y].map(|v| v + SIDE as f64);
        let (columns, rows) = self.size();
        if !(x >= 0.0 && y >= 0.0 && x < columns as f64 && y < rows as f64) {
            return false;
        }
        let pixel = self.pixel(x as usize, y as usize) as usize;
        self.near.get(pixel / AREA).is_some_and(|tile| tile >> (pixel % AREA) & 1 == 1)
    }

    /// Pixels in a row, and rows.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.across * SIDE, self.down * SIDE)
    }

    /// The pixel at a column and a row, counted from the frame's corner.
    pub(super) fn pixel(&self, x: usize, y: usize) -> u32 {
        let place = y / SIDE * self.across + x / SIDE;
        let slot = self.slots[place];
        if slot == NONE {
            Self::row(place, y)
        } else {
            slot * AREA as u32 + (x % SIDE * SIDE + y % SIDE) as u32
        }
    }

    /// A row of the tile that could be at a place.
    fn row(place: usize, y: usize) -> u32 {
        BEYOND | (place * SIDE + y % SIDE) as u32
    }

    /// The row that a column and a row are in, counted from the frame's corner, whether a tile is there or not.
    pub(super) fn row_at(&self, x: usize, y: usize) -> u32 {
        Self::row(y / SIDE * self.across + x / SIDE, y)
    }

    /// How many tiles there are.
    pub(super) fn tiles(&self) -> usize {
        self.places.len()
    }

    /// The place of a tile, and which tile is there.
    pub(super) fn place(&self, slot: usize) -> u32 {
        self.places[slot]
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

    /// The outlines cover more or less of the pixels of a tile, with heights that run in from the left and on to the
    /// right; how much the sum of squares grows, if that is known at once. The change is used up, but for what takes it
    /// back.
    pub(super) fn cover(&mut self, slot: usize, change: &mut Change, running: &mut [f32; SIDE]) -> f64 {
        let sign = if self.blur.is_some() { -1.0 } else { 1.0 };
        let pixels = tile(covered(&mut self.rest, &mut self.blur), slot);
        self.journal.note(slot, pixels);
        let mut growth = 0.0;
        for (half, running) in running.as_chunks_mut().0.iter_mut().enumerate() {
            let part = cover_half(pixels, change, half, (running, sign));
            growth = part.into_iter().fold(growth, |sum, part| sum + f64::from(part));
        }
        if sign < 0.0 {
            self.touch(slot, &change.before);
            return 0.0;
        }
        growth
    }

    /// A tile is again what it was before a change that covered it.
    pub(super) fn take_back(&mut self, slot: usize, change: &Change) {
        tile(covered(&mut self.rest, &mut self.blur), slot).copy_from_slice(&change.before);
    }

    /// The root mean square of what is left.
    pub(super) fn left(&self) -> f64 {
        let square: f64 = self.rest.iter().map(|&r| f64::from(r) * f64::from(r)).sum();
        (square / self.rest.len().max(1) as f64).sqrt()
    }
}

/// Covers the upper or the lower half of a tile's rows, column by column; how much the sum of squares grows in each
/// row.
#[inline(always)]
fn cover_half(
    pixels: &mut [[f32; 4]],
    change: &mut Change,
    half: usize,
    (running, sign): (&mut [f32; 4], f32),
) -> [f32; 4] {
    let (mut heights, sign) = (f32x4::new(*running), f32x4::splat(sign));
    let mut growth = f32x4::splat(0.0);
    for column in 0..SIDE {
        let at = 2 * column + half;
        let before = f32x4::new(pixels[at]);
        let after = before + sign * (heights + f32x4::new(change.areas[at]));
        pixels[at] = after.to_array();
        growth += (after - before) * (after + before);
        heights += f32x4::new(change.heights[at]);
        (change.areas[at], change.heights[at], change.before[at]) = ([0.0; 4], [0.0; 4], before.to_array());
    }
    *running = heights.to_array();
    growth.to_array()
}

/// The plane that outlines cover: what is left itself, unless that is blurred.
fn covered<'a>(rest: &'a mut [f32], blur: &'a mut Option<Blur>) -> &'a mut [f32] {
    blur.as_mut().map_or(rest, |blur| &mut blur.cover)
}

/// The pixels of a tile.
fn tile(plane: &mut [f32], slot: usize) -> &mut [[f32; 4]] {
    plane[slot * AREA..(slot + 1) * AREA].as_chunks_mut().0
}

#[cfg(test)]
mod tests {
    use super::{AREA, SIDE, stain};
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn what_is_of_one_shade_is_no_stain_however_near_to_paper_it_is() {
        // The inside of a shape, one shade in 250 darker than paper, with paper on the other side.
        let tile: Vec<f32> = (0..AREA).map(|place| if place < 3 * SIDE { 0.0 } else { 0.004 }).collect();
        assert!(stain(&tile).abs() < 1e-12);
    }

    #[test]
    fn what_compression_leaves_is_a_stain_where_it_is_of_one_shade_along_an_edge_as_well() {
        let ripples = |place: usize| 0.004 * (1 + place % 3) as f32;
        let across: Vec<f32> = (0..AREA).map(|place| ripples(place / SIDE)).collect();
        let along: Vec<f32> = (0..AREA).map(ripples).collect();
        assert!((stain(&across) - 1.0).abs() < 1e-12);
        assert!((stain(&along) - 1.0).abs() < 1e-12);
    }
}
