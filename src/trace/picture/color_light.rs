//! Uneven light on pictures of flat colours: the same colour is darker where less light falls on it (D 14.30).

mod evidence;
mod field;
mod patches;

use self::evidence::lights;
use self::field::{CELLS, Field, corners};
use self::patches::{Patch, Patches};
use crate::error::Result;
use crate::limits::with_room;

/// Pixels that are averaged, if they are alike.
const RUN: usize = 8;
/// One row in so many is looked at.
const EVERY: usize = 4;
/// About so many tiles along the longer side.
const TILES: usize = 24;
/// Fewer tiles along a side say too little of the light.
const FEWEST: usize = 6;
/// So many colours of a tile are kept.
const KEPT: usize = 4;
/// How much the pixels of a run differ in a channel, with noise,
const SPAN: u8 = 28;
/// and runs of one colour in a tile.
const NEAR: f64 = 20.0;
/// A colour is brightened by no more than this, as a logarithm.
const MOST_GAIN: f64 = 1.6;

/// Runs of one colour in a tile: how many, and the sums of their channels and places.
#[derive(Clone, Copy, Debug, Default)]
struct Runs {
    count: f64,
    sums: [f64; 3],
    places: [f64; 2],
}

/// Looks at the light on a picture of flat colours that is given row by row, as [`Census`](super::census::Census) is.
#[derive(Clone, Debug)]
pub struct LightScan {
    size: [usize; 2],
    /// Pixels along the sides of a tile, and tiles in a row and in a column; none where the picture is too small.
    tile: usize,
    tiles: [usize; 2],
    row: usize,
    looked: f64,
    found: Vec<Runs>,
}

/// Uneven light that was found, to be divided out of the same rows.
#[derive(Clone, Debug)]
pub struct ColorLight {
    size: [usize; 2],
    gains: [Field; 3],
}

impl LightScan {
    /// Begins a picture of that many columns and rows. In less than about a hundred pixels along a side no light is
    /// looked for.
    ///
    /// # Errors
    ///
    /// No memory: it needs 110 kB at most.
    pub fn new(width: usize, height: usize) -> Result<Self> {
        let tile = width.max(height).div_ceil(TILES * RUN).max(2) * RUN;
        let mut tiles = [width / tile, height / tile];
        if tiles[0].min(tiles[1]) < FEWEST {
            tiles = [0, 0];
        }
        let count = KEPT * tiles[0] * tiles[1];
        let mut found = with_room(count)?;
        found.resize(count, Runs::default());
        Ok(Self { size: [width, height], tile, tiles, row: 0, looked: 0.0, found })
    }

    /// More rows, from red, green, blue and opacity, a byte each.
    pub fn push_rgba_rows(&mut self, bytes: &[u8]) {
        if self.found.is_empty() {
            return;
        }
        for row in bytes.chunks_exact(4 * self.size[0]) {
            if self.row % EVERY == EVERY / 2 && self.row < self.tiles[1] * self.tile {
                self.look(row);
            }
            self.row += 1;
        }
    }

    /// The light, once all rows are there; none where it is even, and where it is not clear that what varies is light:
    /// large gradients of one colour, photographs.
    ///
    /// # Cost
    ///
    /// That of solving 81 equations some 20 times, where a large area varies.
    pub fn light(&self) -> Option<ColorLight> {
        let whole = self.looked.max(1.0);
        let each = (self.tile / RUN * self.tile / EVERY) as f64;
        let patches = self.found.chunks_exact(KEPT).enumerate().flat_map(|(tile, runs)| {
            runs.iter().filter(|runs| runs.count >= 2.0).map(move |runs| Patch {
                tile,
                weight: runs.count / each,
                color: runs.sums.map(|sum| sum / runs.count),
                place: [0, 1].map(|k| runs.places[k] / runs.count * CELLS as f64 / self.size[k] as f64),
                region: 0,
            })
        });
        let patches = Patches::new(patches.collect(), self.tiles, whole / each);
        let gains = lights(&patches)?.map(|field| {
            let most = patches.list.iter().fold(f64::MIN, |most, patch| most.max(field.at(patch.place)));
            Field(field.0.iter().map(|v| libm::exp((most - v).clamp(0.0, MOST_GAIN))).collect())
        });
        Some(ColorLight { size: self.size, gains })
    }

    fn look(&mut self, row: &[u8]) {
        let first = self.row / self.tile * self.tiles[0];
        let runs = row.as_chunks::<{ 4 * RUN }>().0;
        for (i, run) in runs.iter().enumerate().take(self.tiles[0] * self.tile / RUN) {
            self.looked += 1.0;
            let (mut least, mut most, mut sums) = ([255; 4], [0; 4], [0; 4]);
            for pixel in run.as_chunks::<4>().0 {
                for k in 0..4 {
                    least[k] = pixel[k].min(least[k]);
                    most[k] = pixel[k].max(most[k]);
                    sums[k] += u32::from(pixel[k]);
                }
            }
            if least[3] < 255 || (0..3).any(|k| most[k] - least[k] > SPAN) {
                continue;
            }
            let mean = [0, 1, 2].map(|k| f64::from(sums[k]) / RUN as f64);
            let tile = KEPT * (first + i * RUN / self.tile);
            let is_near = |runs: &&mut Runs| {
                (0..3).all(|k| (runs.sums[k] - mean[k] * runs.count).abs() < NEAR * runs.count)
                    || runs.count == 0.0
            };
            // Colours beyond those that are kept are in other tiles as well, or small.
            if let Some(runs) = self.found[tile..tile + KEPT].iter_mut().find(is_near) {
                runs.count += 1.0;
                (0..3).for_each(|k| runs.sums[k] += mean[k]);
                runs.places[0] += (i * RUN + RUN / 2) as f64;
                runs.places[1] += self.row as f64 + 0.5;
            }
        }
    }
}

impl ColorLight {
    /// Makes some rows, the first of which has that number, what they were if as much light fell on all of the picture
    /// as where there is most.
    pub fn even(&self, first: usize, rgba_rows: &mut [u8]) {
        let [width, height] = self.size.map(|side| CELLS as f64 / side as f64);
        for (i, row) in rgba_rows.chunks_exact_mut(4 * self.size[0]).enumerate() {
            let v = ((first + i) as f64 + 0.5) * height;
            for (column, pixel) in row.as_chunks_mut::<4>().0.iter_mut().enumerate() {
                let corners = corners([(column as f64 + 0.5) * width, v]);
                for (channel, gains) in pixel.iter_mut().zip(&self.gains) {
                    let gain: f64 = corners.iter().map(|&(node, share)| share * gains.0[node]).sum();
                    *channel = (f64::from(*channel) * gain + 0.5).min(255.0) as u8;
                }
            }
        }
    }
}
