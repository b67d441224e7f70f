//! Edges of a picture: where the shade changes most, to a fraction of a pixel.

use super::maxima::{Candidate, EdgePoint, MaximaScan, SCALE};
use crate::error::Result;
use crate::limits::{check, with_room};
use crate::trace::picture::bitmap::Bitmap;
use crate::trace::picture::gray::Gray;
use crate::trace::picture::tones::{ToneScan, otsu};

/// How edges are found. What is `None` is found from the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EdgeOptions {
    /// The deviation of the Gaussian that the picture is blurred with, in pixels: 1, or 2 where there is noise.
    pub sigma: Option<f64>,
    /// From here on a change of shade is an edge, in shades (0 … 255) per pixel.
    pub high: Option<f64>,
    /// Down to here an edge goes on; 0.4 of `high`.
    pub low: Option<f64>,
}

/// The edges of a picture, row by row, and what they were found with.
#[derive(Clone, Debug, PartialEq)]
pub struct Edges {
    /// The edge points, by row and column.
    pub points: Vec<EdgePoint>,
    /// The deviation of the blur, in pixels.
    pub sigma: f64,
    /// The upper threshold.
    pub high: f64,
    /// The lower threshold.
    pub low: f64,
    pub(super) width: usize,
    pub(super) height: usize,
}

/// Noise, as a share of the way from ink to paper, from which on the blur is doubled.
const NOISY: f64 = 6.0 / 255.0;

impl Edges {
    /// The index of the edge point at a pixel.
    pub(super) fn find(&self, column: usize, row: usize) -> Option<usize> {
        let wanted = (row as u32, column as u32);
        self.points.binary_search_by(|p| (p.row, p.column).cmp(&wanted)).ok()
    }
}

/// Finds the edges of a picture: a Gaussian, Sobel's gradient, its maxima across the edge, and two thresholds.
///
/// A place is a maximum if no neighbour along the axis that the gradient is nearer to is larger; the vertex of the
/// parabola through the three is where the edge is. The upper threshold is Otsu's over all maxima, at most 0.6 of the
/// largest; weaker places count where they are joined to stronger ones. A mirrored picture has the mirrored edges, to
/// the last bit.
///
/// # Errors
///
/// A deviation that is not within 0.3 … 8, thresholds below 0 or `low` above `high`; a picture with more places than
/// half of its pixels and 65,536.
///
/// # Cost
///
/// O(pixels), in seven rows and the Gaussian's; 16 bytes for each maximum.
///
/// # Source
///
/// \[Can86\], the place between pixels \[Dev95\], thresholds (D 14.8).
pub fn edges(gray: &Gray, options: &EdgeOptions) -> Result<Edges> {
    let mut tones = ToneScan::new(None);
    let noise = loop {
        if let Some(tones) = tones.step(gray) {
            break tones.noise;
        }
    };
    options.check()?;
    let mut scan = MaximaScan::new(gray, options.sigma(noise))?;
    while !scan.step(gray)? {}
    scan.edges(gray, options, options.sigma(noise))
}

impl EdgeOptions {
    pub(super) fn check(&self) -> Result<()> {
        if let Some(sigma) = self.sigma {
            check("sigma", None, sigma, 0.3, 8.0)?;
        }
        if let Some(high) = self.high {
            check("high", None, high, 0.0, 1e6)?;
        }
        if let Some(low) = self.low {
            check("low", None, low, 0.0, self.high.unwrap_or(1e6))?;
        }
        Ok(())
    }

    /// The deviation of the blur for a picture with some noise, as [`Tones::noise`](crate::trace::Tones::noise).
    pub(in crate::trace) fn sigma(&self, noise: f64) -> f64 {
        self.sigma.unwrap_or(if noise > NOISY { 2.0 } else { 1.0 })
    }
}

impl MaximaScan {
    /// The maxima that are edges.
    pub(in crate::trace) fn edges(self, gray: &Gray, options: &EdgeOptions, sigma: f64) -> Result<Edges> {
        let mut candidates = self.found;
        let largest = candidates.iter().fold(0.0_f32, |most, c| most.max(c.size()));
        let high = options.high.unwrap_or_else(|| automatic(&candidates, largest) / SCALE);
        let low = options.low.unwrap_or(0.4 * high).min(high);
        let bound = (low * SCALE) as f32;
        candidates.retain(|c| c.size() >= bound);
        let kept = joined(gray, &candidates, (high * SCALE) as f32)?;
        let mut points: Vec<EdgePoint> = with_room(kept.count())?;
        for c in &candidates {
            let (row, column) = (c.pixel as usize / gray.width(), c.pixel as usize % gray.width());
            if !kept.get(column, row) {
                continue;
            }
            let found = c.edge_point(column, row);
            // Half-way between two pixels it is the place of both, and counts once.
            if c.offset > -0.5 || !is_known(&points, &found) {
                points.push(found);
            }
        }
        Ok(Edges { points, sigma, high, low, width: gray.width(), height: gray.height() })
    }
}

/// Whether the place is that of the pixel before it as well.
fn is_known(points: &[EdgePoint], found: &EdgePoint) -> bool {
    let upright = found.gradient.y.abs() > found.gradient.x.abs();
    let column = found.column.wrapping_sub(u32::from(!upright));
    let row = found.row.wrapping_sub(u32::from(upright));
    let before = points.binary_search_by(|p| (p.row, p.column).cmp(&(row, column)));
    before.is_ok_and(|i| points[i].point == found.point)
}

fn automatic(candidates: &[Candidate], largest: f32) -> f64 {
    if largest <= 0.0 {
        return 0.0;
    }
    let mut histogram = [0_u32; 256];
    for c in candidates {
        histogram[((c.size() / largest * 255.0) as usize).min(255)] += 1;
    }
    let share = (otsu(&histogram) as f64 + 1.0) / 256.0;
    f64::from(largest) * share.min(0.6)
}

/// The candidates that are joined, by neighbours, to one of at least `high`.
fn joined(gray: &Gray, candidates: &[Candidate], high: f32) -> Result<Bitmap> {
    let (width, height) = (gray.width(), gray.height());
    let mut left = Bitmap::new(width, height)?;
    let mut kept = Bitmap::new(width, height)?;
    let place = |pixel: u32| (pixel as usize % width, pixel as usize / width);
    for c in candidates {
        let (column, row) = place(c.pixel);
        left.set(column, row, true);
    }
    let mut stack: Vec<u32> = Vec::new();
    for c in candidates.iter().filter(|c| c.size() >= high) {
        let (column, row) = place(c.pixel);
        if left.take(column, row) {
            stack.push(c.pixel);
        }
        while let Some(pixel) = stack.pop() {
            let (column, row) = place(pixel);
            kept.set(column, row, true);
            for direction in 0..8 {
                if let Some((c, r)) = left.beside(column, row, direction)
                    && left.take(c, r)
                {
                    stack.push((r * width + c) as u32);
                }
            }
        }
    }
    Ok(kept)
}
