//! A picture as shades of one quantity, and what can be said of it before any outline is known.

use crate::error::{Error, Result};
use crate::limits::{check, with_room};

/// The most columns or rows of a picture.
pub const MOST_SIDE: usize = 16_384;
/// The most pixels of a picture.
pub const MOST_PIXELS: usize = 67_108_864;

/// Shades from 0 (black) to 65,280 (white): two bytes for every pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Gray {
    width: usize,
    height: usize,
    values: Vec<u16>,
}

/// What tells ink from paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tones {
    /// The shade of full coverage.
    pub ink: f64,
    /// The shade of no coverage.
    pub paper: f64,
    /// The standard deviation of the shades in flat places, in units of `paper − ink`.
    pub noise: f64,
}

impl Gray {
    /// A picture from one byte per pixel, row by row.
    ///
    /// # Errors
    ///
    /// A side of 0 or beyond 16,384, more than 67,108,864 pixels, a list of another length.
    pub fn from_bytes(width: usize, height: usize, bytes: &[u8]) -> Result<Self> {
        let pixels = count(width, height)?;
        if bytes.len() != pixels {
            return Err(Error::wrong_length("data", bytes.len(), pixels));
        }
        let mut values = with_room(pixels)?;
        values.extend(bytes.iter().map(|&byte| u16::from(byte) << 8));
        Ok(Self { width, height, values })
    }

    /// A picture from red, green, blue and opacity, a byte each. The shade is the luma of Rec. 709. Where something is
    /// transparent, that is paper: white under dark ink, black under light ink.
    ///
    /// # Errors
    ///
    /// As [`Gray::from_bytes`].
    pub fn from_rgba(width: usize, height: usize, bytes: &[u8]) -> Result<Self> {
        let pixels = count(width, height)?;
        if bytes.len() != 4 * pixels {
            return Err(Error::wrong_length("data", bytes.len(), 4 * pixels));
        }
        // 54 + 183 + 19 = 256: 0.2126, 0.7152 and 0.0722 to a thousandth.
        let luma = |p: &[u8]| 54 * u32::from(p[0]) + 183 * u32::from(p[1]) + 19 * u32::from(p[2]);
        let (mut light, mut opaque) = (0_u64, 0_u64);
        for pixel in bytes.chunks_exact(4) {
            light += u64::from(luma(pixel)) * u64::from(pixel[3]);
            opaque += u64::from(pixel[3]);
        }
        let paper = if light > opaque * 32_640 && opaque < 255 * pixels as u64 { 0 } else { 65_280 };
        let mut values = with_room(pixels)?;
        values.extend(bytes.chunks_exact(4).map(|pixel| {
            let alpha = u32::from(pixel[3]);
            ((luma(pixel) * alpha + paper * (255 - alpha) + 127) / 255) as u16
        }));
        Ok(Self { width, height, values })
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// The shade of a pixel.
    pub(super) fn shade(&self, column: usize, row: usize) -> f64 {
        f64::from(self.values[row * self.width + column])
    }

    /// One row of shades.
    pub(super) fn row(&self, row: usize) -> &[u16] {
        &self.values[row * self.width..(row + 1) * self.width]
    }

    /// Finds the two tones and the noise. A picture of one tone is all ink or all paper, as it is dark or light.
    ///
    /// Otsu's threshold parts the shades; pixels whose eight neighbours are on the same side are flat. The medians of the flat ones are
    /// the tones, their means where there is noise. A drawing so thin that nothing is flat has its extreme shades.
    ///
    /// # Cost
    ///
    /// O(pixels), three rows at a time.
    ///
    /// # Source
    ///
    /// \[Ots79\]; the noise is measured with the mask of \[Imm96\].
    pub fn tones(&self) -> Tones {
        let mut all = [0_u64; 256];
        for &value in &self.values {
            all[usize::from(value >> 8)] += 1;
        }
        let least = all.iter().position(|&n| n > 0).unwrap_or(0);
        let most = all.iter().rposition(|&n| n > 0).unwrap_or(255);
        if most - least < 8 {
            let shade = (least << 8) as f64;
            let (ink, paper) = if least < 128 { (shade, 65_280.0) } else { (0.0, shade) };
            return Tones { ink, paper, noise: 0.0 };
        }
        let threshold = otsu(&all);
        let flat = self.flat_places(threshold);
        let tone = |side: usize, extreme: usize| {
            let bins = &flat.histogram[side];
            let total: u64 = bins.iter().sum();
            if total == 0 {
                return (extreme << 8) as f64;
            }
            if flat.roughness > 768.0 {
                return bins.iter().enumerate().map(|(i, &n)| (i << 8) as f64 * n as f64).sum::<f64>()
                    / total as f64;
            }
            let mut below = 0;
            let middle = bins.iter().position(|&n| {
                below += n;
                2 * below >= total
            });
            (middle.unwrap_or(extreme) << 8) as f64
        };
        let (ink, paper) = (tone(0, least), tone(1, most));
        Tones { ink, paper, noise: flat.roughness / (paper - ink) }
    }

    fn flat_places(&self, threshold: usize) -> Flat {
        let mut flat = Flat { histogram: [[0; 256]; 2], roughness: 0.0 };
        let (mut sum, mut count) = (0.0, 0_u64);
        for row in 1..self.height.saturating_sub(1) {
            let rows = [self.row(row - 1), self.row(row), self.row(row + 1)];
            for column in 1..self.width.saturating_sub(1) {
                let at = |r: usize, c: usize| rows[r][column + c - 1];
                let side = usize::from(at(1, 1) >> 8) > threshold;
                if (0..9).any(|i| (usize::from(at(i / 3, i % 3) >> 8) > threshold) != side) {
                    continue;
                }
                flat.histogram[usize::from(side)][usize::from(at(1, 1) >> 8)] += 1;
                let value = |r: usize, c: usize| f64::from(at(r, c));
                let corners = value(0, 0) + value(0, 2) + value(2, 0) + value(2, 2);
                let sides = value(0, 1) + value(1, 0) + value(1, 2) + value(2, 1);
                sum += (corners - 2.0 * sides + 4.0 * value(1, 1)).abs();
                count += 1;
            }
        }
        // The mask's answer to noise of deviation σ has the deviation 6σ, its absolute value the mean 6σ√(2/π).
        flat.roughness = sum / count.max(1) as f64 * core::f64::consts::FRAC_PI_2.sqrt() / 6.0;
        flat
    }

    /// The picture blurred by a Gaussian of deviation `sigma` pixels, edges repeated. Rows are kept for as long as they are needed.
    pub(super) fn blurred(&self, sigma: f64) -> Result<Self> {
        let half = half_gaussian(sigma);
        let reach = half.len() - 1;
        let mut values: Vec<u16> = with_room(self.values.len())?;
        // A ring of rows that are blurred along themselves.
        let size = 2 * reach + 1;
        let mut ring: Vec<f32> = with_room(size * self.width)?;
        ring.resize(size * self.width, 0.0);
        let mut blurred_rows = 0;
        for row in 0..self.height {
            while blurred_rows <= (row + reach).min(self.height - 1) {
                let place = (blurred_rows % size) * self.width;
                blur_row(self.row(blurred_rows), &half, &mut ring[place..place + self.width]);
                blurred_rows += 1;
            }
            for column in 0..self.width {
                let at = |r: usize| f64::from(ring[(r % size) * self.width + column]);
                let mut sum = half[0] * at(row);
                for (d, weight) in half.iter().enumerate().skip(1) {
                    sum += weight * (at(row.saturating_sub(d)) + at((row + d).min(self.height - 1)));
                }
                values.push((sum + 0.5) as u16);
            }
        }
        Ok(Self { width: self.width, height: self.height, values })
    }
}

struct Flat {
    histogram: [[u64; 256]; 2],
    roughness: f64,
}

fn count(width: usize, height: usize) -> Result<usize> {
    check("width", None, width as f64, 1.0, MOST_SIDE as f64)?;
    check("height", None, height as f64, 1.0, MOST_SIDE as f64)?;
    let pixels = width * height;
    if pixels > MOST_PIXELS {
        return Err(Error::limit("data", "maxPixels", MOST_PIXELS, pixels as f64));
    }
    Ok(pixels)
}

fn blur_row(row: &[u16], half: &[f64], out: &mut [f32]) {
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
pub(super) fn half_gaussian(sigma: f64) -> Vec<f64> {
    let reach = (3.0 * sigma).ceil().clamp(0.0, 30.0) as usize;
    let weight = |d: usize| if d == 0 { 1.0 } else { libm::exp(-0.5 * (d * d) as f64 / (sigma * sigma)) };
    let total: f64 = (0..=reach).map(|d| if d == 0 { 1.0 } else { 2.0 * weight(d) }).sum();
    (0..=reach).map(|d| weight(d) / total).collect()
}

/// The shade up to which pixels are dark: the variance between both sides is largest.
fn otsu(histogram: &[u64; 256]) -> usize {
    let total: f64 = histogram.iter().map(|&n| n as f64).sum();
    let moment: f64 = histogram.iter().enumerate().map(|(i, &n)| i as f64 * n as f64).sum();
    let (mut below, mut sum) = (0.0, 0.0);
    let mut best = (0.0, 0, 0);
    for (i, &n) in histogram.iter().enumerate() {
        below += n as f64;
        sum += i as f64 * n as f64;
        if below == 0.0 || below >= total {
            continue;
        }
        let gap = sum / below - (moment - sum) / (total - below);
        let variance = below * (total - below) * gap * gap;
        if variance > best.0 {
            best = (variance, i, i);
        } else if variance == best.0 {
            best.2 = i;
        }
    }
    // Between two lone tones every threshold is as good: the one half-way.
    best.1.midpoint(best.2)
}
