//! A picture blurred by a Gaussian, a few rows at a time.

use super::gray::Gray;
use crate::error::Result;
use crate::limits::with_room;

/// A picture that is being blurred: rows are kept for as long as they are needed.
#[derive(Debug)]
pub(in crate::trace) struct Blurring {
    half: Vec<f64>,
    /// A ring of rows that are blurred along themselves.
    ring: Vec<f32>,
    /// How many rows have been in it, and how many are blurred.
    along: usize,
    done: usize,
    /// The last two rows.
    rows: [Vec<u16>; 2],
}

impl Blurring {
    /// Begins to blur by a Gaussian of deviation `sigma` pixels, edges repeated.
    pub(in crate::trace) fn new(width: usize, sigma: f64) -> Result<Self> {
        let half = half_gaussian(sigma);
        let room = (2 * half.len() - 1) * width;
        let mut ring: Vec<f32> = with_room(room)?;
        ring.resize(room, 0.0);
        let rows = [with_room(width)?, with_room(width)?];
        Ok(Self { half, ring, along: 0, done: 0, rows })
    }

    /// Blurs the next row, if there is one: the row before it, and itself. Beyond the picture rows are empty.
    pub(in crate::trace) fn step(&mut self, gray: &Gray) -> [&[u16]; 2] {
        self.rows.swap(0, 1);
        self.rows[1].clear();
        if self.done < gray.height() {
            self.blur(gray);
            self.done += 1;
        }
        let [before, here] = &self.rows;
        [before, here]
    }

    fn blur(&mut self, gray: &Gray) {
        let (width, last, row) = (gray.width(), gray.height() - 1, self.done);
        let reach = self.half.len() - 1;
        let size = 2 * reach + 1;
        while self.along <= (row + reach).min(last) {
            let place = (self.along % size) * width;
            blur_row(gray.row(self.along), &self.half, &mut self.ring[place..place + width]);
            self.along += 1;
        }
        for column in 0..width {
            let at = |r: usize| f64::from(self.ring[(r % size) * width + column]);
            let mut sum = self.half[0] * at(row);
            for (d, weight) in self.half.iter().enumerate().skip(1) {
                sum += weight * (at(row.saturating_sub(d)) + at((row + d).min(last)));
            }
            self.rows[1].push((sum + 0.5) as u16);
        }
    }
}

pub(in crate::trace) fn blur_row(row: &[u16], half: &[f64], out: &mut [f32]) {
    let last = row.len() - 1;
    for (column, value) in out.iter_mut().enumerate() {
        let mut sum = half[0] * f64::from(row[column]);
        for (d, weight) in half.iter().enumerate().skip(1) {
            sum +=
                weight * (f64::from(row[column.saturating_sub(d)]) + f64::from(row[(column + d).min(last)]));
        }
        *value = sum as f32;
    }
}

/// The weights of a Gaussian from the middle outwards; both sides together sum to 1.
pub(in crate::trace) fn half_gaussian(sigma: f64) -> Vec<f64> {
    let reach = (3.0 * sigma).ceil().clamp(0.0, 30.0) as usize;
    let weight = |d: usize| if d == 0 { 1.0 } else { libm::exp(-0.5 * (d * d) as f64 / (sigma * sigma)) };
    let total: f64 = (0..=reach).map(|d| if d == 0 { 1.0 } else { 2.0 * weight(d) }).sum();
    (0..=reach).map(|d| weight(d) / total).collect()
}
