//! Maxima of the gradient across edges, row by row.

use crate::error::{Error, Result};
use crate::limits::with_room;
use crate::numerics::{Point, Vector};
use crate::trace::picture::blur::{blur_row, half_gaussian};
use crate::trace::picture::gray::Gray;

/// A place where the shade changes most across an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePoint {
    /// Column of the pixel.
    pub column: u32,
    /// Row of the pixel.
    pub row: u32,
    /// Where the change is largest: beside the pixel's centre, along the axis that the gradient is nearer to.
    pub point: Point,
    /// The change in shades (0 … 255) per pixel, towards the light.
    pub gradient: Vector,
}

/// A local maximum of the gradient, before any threshold.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) pixel: u32,
    gradient: [f32; 2],
    pub(super) offset: f32,
}

impl Candidate {
    pub(super) fn size(&self) -> f32 {
        size(self.gradient)
    }

    pub(super) fn edge_point(&self, column: usize, row: usize) -> EdgePoint {
        let [x, y] = self.gradient.map(|g| f64::from(g) / SCALE);
        let mut point = Point::new(column as f64 + 0.5, row as f64 + 0.5);
        if self.gradient[0].abs() >= self.gradient[1].abs() {
            point.x += f64::from(self.offset);
        } else {
            point.y += f64::from(self.offset);
        }
        EdgePoint { column: column as u32, row: row as u32, point, gradient: Vector::new(x, y) }
    }
}

/// Changes below this, in the units of [`Gray`] per pixel, are what rounding to bytes leaves.
const FLOOR: f32 = 16.0;
/// Shades of [`Gray`] for one of 0 … 255.
pub(super) const SCALE: f64 = 256.0;
/// Rows of the blurred picture and of its gradient, as many as the maxima of one row need.
#[derive(Debug)]
pub(in crate::trace) struct MaximaScan {
    half: Vec<f64>,
    /// Rows blurred along themselves, a ring.
    along: Vec<f32>,
    done: usize,
    /// Three blurred rows, a ring.
    blurred: Vec<f32>,
    /// Three rows of gradients, a ring.
    gradients: Vec<[f32; 2]>,
    next: usize,
    row: usize,
    pub(super) found: Vec<Candidate>,
    most: usize,
}

impl MaximaScan {
    pub(in crate::trace) fn new(gray: &Gray, sigma: f64) -> Result<Self> {
        let width = gray.width();
        let half = half_gaussian(sigma);
        let mut along = with_room((2 * half.len() - 1) * width)?;
        along.resize((2 * half.len() - 1) * width, 0.0);
        let mut blurred = with_room(3 * width)?;
        blurred.resize(3 * width, 0.0);
        let mut gradients = with_room(3 * width)?;
        gradients.resize(3 * width, [0.0; 2]);
        let most = width * gray.height() / 2 + 65_536;
        Ok(Self { half, along, done: 0, blurred, gradients, next: 0, row: 0, found: Vec::new(), most })
    }

    fn blur(&mut self, gray: &Gray, row: usize) {
        let (width, last) = (gray.width(), gray.height() - 1);
        let reach = self.half.len() - 1;
        let size = 2 * reach + 1;
        while self.done <= (row + reach).min(last) {
            let place = (self.done % size) * width;
            blur_row(gray.row(self.done), &self.half, &mut self.along[place..place + width]);
            self.done += 1;
        }
        let out = (row % 3) * width;
        for column in 0..width {
            let at = |r: usize| f64::from(self.along[(r % size) * width + column]);
            let mut sum = self.half[0] * at(row);
            for (d, weight) in self.half.iter().enumerate().skip(1) {
                sum += weight * (at(row.saturating_sub(d)) + at((row + d).min(last)));
            }
            self.blurred[out + column] = sum as f32;
        }
    }

    /// Sobel's gradient along a row, edges repeated. Mirrored rows give mirrored gradients: sums are symmetric.
    fn gradient(&mut self, gray: &Gray, row: usize) {
        let (width, last) = (gray.width(), gray.height() - 1);
        let line = |r: usize| &self.blurred[(r % 3) * width..(r % 3 + 1) * width];
        let (above, here, below) = (line(row.saturating_sub(1)), line(row), line((row + 1).min(last)));
        let out = &mut self.gradients[(row % 3) * width..(row % 3 + 1) * width];
        for (column, gradient) in out.iter_mut().enumerate() {
            let (left, right) = (column.saturating_sub(1), (column + 1).min(width - 1));
            let upright = |c: usize| (above[c] + below[c]) + 2.0 * here[c];
            let flat = |line: &[f32]| (line[left] + line[right]) + 2.0 * line[column];
            *gradient = [(upright(right) - upright(left)) * 0.125, (flat(below) - flat(above)) * 0.125];
        }
    }

    /// The maxima of one row more; whether it was the last.
    pub(in crate::trace) fn step(&mut self, gray: &Gray) -> Result<bool> {
        let (width, height, row) = (gray.width(), gray.height(), self.row);
        // The gradient of a row needs the next blurred row; maxima need the gradient of the next row.
        while self.next <= (row + 1).min(height - 1) {
            if self.next == 0 {
                self.blur(gray, 0);
            }
            if self.next + 1 < height {
                self.blur(gray, self.next + 1);
            }
            self.gradient(gray, self.next);
            self.next += 1;
        }
        for column in 0..width {
            let gradient = self.gradients[(row % 3) * width + column];
            let own = size(gradient);
            if own < FLOOR {
                continue;
            }
            let at = |column: Option<usize>, row: Option<usize>| match (column, row) {
                (Some(c), Some(r)) if c < width && r < height => size(self.gradients[(r % 3) * width + c]),
                _ => 0.0,
            };
            let (before, after) = if gradient[0].abs() >= gradient[1].abs() {
                (at(column.checked_sub(1), Some(row)), at(Some(column + 1), Some(row)))
            } else {
                (at(Some(column), row.checked_sub(1)), at(Some(column), Some(row + 1)))
            };
            if before > own || after > own || (before == own && after == own) {
                continue;
            }
            let offset = 0.5 * (before - after) / ((before + after) - 2.0 * own);
            if self.found.len() >= self.most {
                return Err(Error::limit("data", "maxEdgePoints", self.most, self.most as f64 + 1.0));
            }
            self.found.push(Candidate { pixel: (row * width + column) as u32, gradient, offset });
        }
        self.row += 1;
        Ok(self.row == height)
    }
}

fn size([x, y]: [f32; 2]) -> f32 {
    (x * x + y * y).sqrt()
}
