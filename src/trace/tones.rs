//! What can be said of a picture before any outline is known: ink, paper, noise.

use super::gray::Gray;

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

/// Rows that are looked at in one step.
const ROWS: usize = 64;
/// About as many pixels are looked at for flat places.
const ENOUGH: usize = 131_072;

/// A look at a picture, some rows at a time: first how many pixels have which shade, then flat places.
#[derive(Debug)]
pub(super) struct ToneScan {
    /// The shade up to which pixels are dark, if it was given.
    given: Option<usize>,
    row: usize,
    shades: Box<[[u32; 256]; 4]>,
    flat: Option<Box<Flat>>,
}

/// Flat places on both sides of a threshold.
#[derive(Debug)]
struct Flat {
    threshold: usize,
    histogram: [[u32; 256]; 2],
    sum: u64,
    count: u64,
    /// Which pixels of three rows are light, row r at r modulo 3.
    light: [Vec<u8>; 3],
}

impl ToneScan {
    /// `threshold` is the shade, 0 … 255, up to which pixels are dark; found if it is not given.
    pub(super) fn new(threshold: Option<usize>) -> Self {
        Self { given: threshold, row: 0, shades: Box::new([[0; 256]; 4]), flat: None }
    }

    /// Some rows more; the tones, when they are the last.
    pub(super) fn step(&mut self, gray: &Gray) -> Option<Tones> {
        let height = gray.height();
        let Some(flat) = &mut self.flat else {
            let last = (self.row + ROWS).min(height);
            for row in self.row..last {
                // Equal shades come in runs: counts in turn do not wait for each other.
                for (i, &value) in gray.row(row).iter().enumerate() {
                    self.shades[i % 4][usize::from(value >> 8)] += 1;
                }
            }
            self.row = last;
            if last < height {
                return None;
            }
            self.row = 1;
            for shade in 0..256 {
                self.shades[0][shade] = self.shades.iter().map(|counts| counts[shade]).sum();
            }
            let (least, most) = self.extremes();
            if most - least < 8 {
                let shade = (least << 8) as f64;
                let (ink, paper) = if least < 128 { (shade, 65_280.0) } else { (0.0, shade) };
                return Some(Tones { ink, paper, noise: 0.0 });
            }
            let threshold = self.given.unwrap_or_else(|| otsu(&self.shades[0]));
            self.flat = Some(Box::new(Flat::new(threshold, gray.width())));
            return None;
        };
        // Every so many rows: noise and tones are the same everywhere.
        let stride = (gray.width() * height).div_ceil(ENOUGH);
        for _ in 0..ROWS.div_ceil(stride) {
            if self.row + 1 >= height {
                return Some(self.tones());
            }
            flat.look(gray, self.row);
            self.row += stride;
        }
        None
    }

    fn extremes(&self) -> (usize, usize) {
        let least = self.shades[0].iter().position(|&n| n > 0).unwrap_or(0);
        (least, self.shades[0].iter().rposition(|&n| n > 0).unwrap_or(255))
    }

    fn tones(&self) -> Tones {
        let (least, most) = self.extremes();
        let extreme = |side: usize| if side == 0 { least } else { most };
        let Some(flat) = &self.flat else {
            return Tones { ink: 0.0, paper: 65_280.0, noise: 0.0 };
        };
        // The mask's answer to noise of deviation σ has the deviation 6σ, its absolute value the mean 6σ√(2/π).
        let mean = flat.sum as f64 / flat.count.max(1) as f64;
        let roughness = mean * core::f64::consts::FRAC_PI_2.sqrt() / 6.0;
        let tone = |side: usize| {
            let bins = &flat.histogram[side];
            let total: u32 = bins.iter().sum();
            if total == 0 {
                return (extreme(side) << 8) as f64;
            }
            if roughness > 768.0 {
                let moment: f64 = bins.iter().enumerate().map(|(i, &n)| (i << 8) as f64 * f64::from(n)).sum();
                return moment / f64::from(total);
            }
            let mut below = 0;
            let middle = bins.iter().position(|&n| {
                below += n;
                2 * below >= total
            });
            (middle.unwrap_or(extreme(side)) << 8) as f64
        };
        let (ink, paper) = (tone(0), tone(1).max(tone(0) + 256.0));
        Tones { ink, paper, noise: roughness / (paper - ink) }
    }
}

impl Flat {
    fn new(threshold: usize, width: usize) -> Self {
        let light = [vec![2; width], vec![2; width], vec![2; width]];
        Self { threshold, histogram: [[0; 256]; 2], sum: 0, count: 0, light }
    }

    fn look(&mut self, gray: &Gray, row: usize) {
        let rows = [gray.row(row - 1), gray.row(row), gray.row(row + 1)];
        let most = ((self.threshold << 8) | 255) as u16;
        for (light, shades) in self.light.iter_mut().zip(rows) {
            for (light, &shade) in light.iter_mut().zip(shades) {
                *light = u8::from(shade > most);
            }
        }
        let [above, here, below] = &self.light;
        let column = |at: usize| above[at] + here[at] + below[at];
        let width = here.len();
        if width < 3 {
            return;
        }
        let (mut before, mut middle) = (column(0), column(1));
        for at in 1..width - 1 {
            let after = column(at + 1);
            let sum = before + middle + after;
            (before, middle) = (middle, after);
            if sum != 0 && sum != 9 {
                continue;
            }
            self.histogram[usize::from(here[at])][usize::from(rows[1][at] >> 8)] += 1;
            let value = |r: usize, c: usize| i64::from(rows[r][at + c - 1]);
            let corners = value(0, 0) + value(0, 2) + value(2, 0) + value(2, 2);
            let sides = value(0, 1) + value(1, 0) + value(1, 2) + value(2, 1);
            self.sum += (corners - 2 * sides + 4 * value(1, 1)).unsigned_abs();
            self.count += 1;
        }
    }
}

/// The shade up to which pixels are dark: the variance between both sides is largest.
pub(super) fn otsu(histogram: &[u32; 256]) -> usize {
    let total: f64 = histogram.iter().map(|&n| f64::from(n)).sum();
    let moment: f64 = histogram.iter().enumerate().map(|(i, &n)| i as f64 * f64::from(n)).sum();
    let (mut below, mut sum) = (0.0, 0.0);
    let mut best = (0.0, 0, 0);
    for (i, &n) in histogram.iter().enumerate() {
        below += f64::from(n);
        sum += i as f64 * f64::from(n);
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
