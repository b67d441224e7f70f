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

impl Tones {
    /// The shade half-way from ink to paper.
    pub(in crate::trace) fn middle(&self) -> f64 {
        0.5 * (self.ink + self.paper)
    }
}

/// Rows that are looked at in one step.
const ROWS: usize = 64;
/// About as many pixels are looked at for flat places.
const ENOUGH: usize = 65_536;

/// Noise leaves fewer than one flat place in so many even, to a shade: an eighteenth, where it is just more than a
/// drawing has. Of drawings as dense as hatching and letters of seven pixels a sixth of the places and more are even,
/// and edges beside the others are no noise.
const EVEN: u64 = 8;
const SHADE: u64 = 256;

/// Fewer flat places than one in so many pixels of their side are few.
const FEW: u32 = 8;

/// More pixels than flat places that are beyond their tone by so many shades say that it is no tone, but that small
/// letters are dense there.
const DEEPER: usize = 16;

/// Pixels that are looked at together, and where they are not all alike.
const BLOCK: usize = 32;
const PART: usize = 8;

/// A look at a picture, some rows at a time: first how many pixels have which shade, then flat places.
#[derive(Debug)]
pub(in crate::trace) struct ToneScan {
    /// The shade up to which pixels are dark, if it was given.
    given: Option<usize>,
    row: usize,
    /// One row in so many is looked at for flat places.
    stride: usize,
    shades: Box<[[u32; 256]; 4]>,
    flat: Option<Box<Flat>>,
}

/// Flat places on both sides of a threshold.
#[derive(Debug)]
struct Flat {
    threshold: usize,
    histogram: [[u32; 256]; 2],
    /// What the shades of each bin exceed it by, together.
    excess: [[u64; 256]; 2],
    sum: u64,
    count: u64,
    even: u64,
    /// Quarters of the way from the darkest to the lightest shade, and the thin places of dark ink and of light.
    quarters: [u16; 3],
    thin: [usize; 2],
}

impl Gray {
    /// Finds the two tones and the noise. A picture of one tone is all ink or all paper, as it is dark or light.
    ///
    /// Otsu's threshold parts the shades; pixels whose eight neighbours are on the same side are flat. The medians of
    /// the flat ones are the tones, their means where there is noise. A drawing so thin that nothing is flat, or only a
    /// few places that do not agree, has its extreme shades. Where one flat place in eight or more is even there is no
    /// noise: what the others leave is edges.
    ///
    /// # Cost
    ///
    /// O(pixels), three rows at a time. Of pictures beyond 65,536 pixels evenly spread rows are looked at for flat
    /// places.
    ///
    /// # Source
    ///
    /// \[Ots79\]; the noise is measured with the mask of \[Imm96\].
    pub fn tones(&self) -> Tones {
        let mut scan = ToneScan::new(None);
        loop {
            if let Some(tones) = scan.step(self) {
                return tones;
            }
        }
    }
}

impl ToneScan {
    /// `threshold` is the shade, 0 … 255, up to which pixels are dark; found if it is not given.
    pub(in crate::trace) fn new(threshold: Option<usize>) -> Self {
        Self { given: threshold, row: 0, stride: 1, shades: Box::new([[0; 256]; 4]), flat: None }
    }

    /// Some rows more; the tones, when they are the last.
    pub(in crate::trace) fn step(&mut self, gray: &Gray) -> Option<Tones> {
        let height = gray.height();
        let Some(flat) = &mut self.flat else {
            let last = (self.row + ROWS).min(height);
            for row in self.row..last {
                count_shades(&mut self.shades, gray.row(row));
            }
            self.row = last;
            if last < height {
                return None;
            }
            self.row = 1;
            self.stride = (gray.width() * height).div_ceil(ENOUGH);
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
            self.flat = Some(Box::new(Flat {
                threshold,
                histogram: [[0; 256]; 2],
                excess: [[0; 256]; 2],
                sum: 0,
                count: 0,
                even: 0,
                quarters: [1, 2, 3].map(|k| (64 * (4 * least + k * (most - least))) as u16),
                thin: [0; 2],
            }));
            return None;
        };
        // Every so many rows: noise and tones are the same everywhere.
        for _ in 0..ROWS.div_ceil(self.stride) {
            if self.row + 1 >= height {
                return Some(self.tones());
            }
            flat.look(gray, self.row);
            self.row += self.stride;
        }
        None
    }

    /// Whether flat places say what the dark tone is, or the light one; else it is the extreme shade.
    pub(in crate::trace) fn is_seen(&self, light: bool) -> bool {
        self.flat.as_ref().is_none_or(|flat| self.median(flat, usize::from(light)).is_some())
    }

    /// About how many pixels are ink by a quarter to a half and have none that is by three beside them, but paper: ends
    /// of tips, and thin strokes that break.
    pub(in crate::trace) fn thin(&self, light: bool) -> usize {
        self.flat.as_ref().map_or(0, |flat| self.stride * flat.thin[usize::from(light)])
    }

    /// The median shade of the flat places of one side, if they show a tone: where they are few beside all that is on
    /// that side, as where strokes meet that are hardly thicker than a pixel, most of them have to agree.
    fn median(&self, flat: &Flat, side: usize) -> Option<usize> {
        let bins = &flat.histogram[side];
        let total: u32 = bins.iter().sum();
        let mut below = 0;
        let middle = bins.iter().position(|&n| {
            below += n;
            n > 0 && 2 * below >= total
        })?;
        let near: u32 = bins[middle.saturating_sub(1)..(middle + 2).min(256)].iter().sum();
        let (dark, light) = self.shades[0].split_at((flat.threshold + 1).min(256));
        let all: u32 = if side == 0 { dark } else { light }.iter().sum();
        let flat = total * self.stride as u32;
        let beyond: u32 = match side {
            0 => &self.shades[0][..middle.saturating_sub(DEEPER)],
            _ => &self.shades[0][(middle + DEEPER).min(256)..],
        }
        .iter()
        .sum();
        (beyond <= flat && (FEW * flat >= all || 2 * near >= total)).then_some(middle)
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
        let sum = if EVEN * flat.even > flat.count { 0 } else { flat.sum };
        let mean = sum as f64 / flat.count.max(1) as f64;
        let roughness = mean * core::f64::consts::FRAC_PI_2.sqrt() / 6.0;
        let tone = |side: usize| {
            let bins = &flat.histogram[side];
            let total: u32 = bins.iter().sum();
            if roughness > 768.0 && total > 0 {
                let moment: f64 = bins.iter().enumerate().map(|(i, &n)| (i << 8) as f64 * f64::from(n)).sum();
                return moment / f64::from(total);
            }
            let Some(bin) = self.median(flat, side) else { return (extreme(side) << 8) as f64 };
            // Colours have shades between those of bytes.
            (bin << 8) as f64 + (flat.excess[side][bin] as f64 / f64::from(bins[bin])).round()
        };
        let (ink, paper) = (tone(0), tone(1).max(tone(0) + 256.0));
        Tones { ink, paper, noise: roughness / (paper - ink) }
    }
}

/// How many pixels have which shade. Most lie in rows of one shade, which are counted at once.
fn count_shades(shades: &mut [[u32; 256]; 4], row: &[u16]) {
    let (blocks, rest) = row.as_chunks::<BLOCK>();
    for block in blocks {
        if is_even(block) {
            shades[0][usize::from(block[0] >> 8)] += BLOCK as u32;
            continue;
        }
        for part in block.as_chunks::<PART>().0 {
            if is_even(part) {
                shades[0][usize::from(part[0] >> 8)] += PART as u32;
                continue;
            }
            // Equal shades come in runs: counts in turn do not wait for each other.
            for (i, &value) in part.iter().enumerate() {
                shades[i % 4][usize::from(value >> 8)] += 1;
            }
        }
    }
    for &value in rest {
        shades[0][usize::from(value >> 8)] += 1;
    }
}

/// Whether so many pixels have one shade: lanes, as their number is known.
#[inline]
fn is_even<const N: usize>(pixels: &[u16; N]) -> bool {
    pixels.iter().fold(0, |off, &value| off | (value ^ pixels[0])) == 0
}

/// Whether all pixels have one shade.
#[inline(never)]
fn alike(pixels: &[u16], shade: u16) -> bool {
    pixels.iter().fold(0, |off, &value| off | (value ^ shade)) == 0
}

impl Flat {
    /// Looks at one row, which has one above and one below.
    fn look(&mut self, gray: &Gray, row: usize) {
        let rows = [gray.row(row - 1), gray.row(row), gray.row(row + 1)];
        self.look_by(BLOCK, rows, ((self.threshold << 8) | 255) as u16);
    }

    /// Looks at the middle row but for its first and last column, so many columns at once where all is of one shade.
    fn look_by(&mut self, block: usize, rows: [&[u16]; 3], most: u16) {
        let end = rows[1].len().saturating_sub(1);
        let mut at = 1;
        while at < end {
            let last = (at + block - 2).min(end);
            let around = rows.map(|row| &row[at - 1..=last]);
            let shade = around[1][0];
            if around.iter().all(|row| alike(row, shade)) {
                self.note(usize::from(shade > most), shade, (last - at) as u32);
                self.count += (last - at) as u64;
                self.even += (last - at) as u64;
            } else if block > PART {
                self.look_by(PART, around, most);
            } else {
                self.mixed(around, most);
            }
            at = last;
        }
    }

    /// So many pixels have a shade.
    #[inline]
    fn note(&mut self, side: usize, shade: u16, pixels: u32) {
        let bin = usize::from(shade >> 8);
        self.histogram[side][bin] += pixels;
        self.excess[side][bin] += u64::from(shade & 0xff) * u64::from(pixels);
    }

    /// Looks at them one by one.
    #[inline(never)]
    fn mixed(&mut self, rows: [&[u16]; 3], most: u16) {
        let column = |at: usize| rows.iter().map(|row| u8::from(row[at] > most)).sum::<u8>();
        let (mut before, mut middle) = (column(0), column(1));
        let [low, half, high] = self.quarters;
        let [least, most] = [low - (half - low), high + (high - half)];
        for at in 1..rows[1].len() - 1 {
            let shade = rows[1][at];
            if (low..high).contains(&shade) && shade != half {
                let light = shade < half;
                let paper = if light { least } else { most };
                let is_faint = |&v: &u16| if light { v < high } else { v > low };
                let is_paper =
                    |&v: &u16| if light { v < low / 2 + paper / 2 } else { v > high / 2 + paper / 2 };
                let around = || rows.iter().flat_map(|row| &row[at - 1..=at + 1]);
                let thin = around().all(is_faint) && around().any(is_paper);
                self.thin[usize::from(light)] += usize::from(thin);
            }
            let after = column(at + 1);
            let sum = before + middle + after;
            (before, middle) = (middle, after);
            if sum != 0 && sum != 9 {
                continue;
            }
            self.note(usize::from(sum == 9), rows[1][at], 1);
            let value = |r: usize, c: usize| i64::from(rows[r][at + c - 1]);
            let corners = value(0, 0) + value(0, 2) + value(2, 0) + value(2, 2);
            let sides = value(0, 1) + value(1, 0) + value(1, 2) + value(2, 1);
            let off = (corners - 2 * sides + 4 * value(1, 1)).unsigned_abs();
            self.sum += off;
            self.count += 1;
            self.even += u64::from(off < SHADE);
        }
    }
}

/// The shade up to which pixels are dark: the variance between both sides is largest.
pub(in crate::trace) fn otsu(histogram: &[u32; 256]) -> usize {
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
