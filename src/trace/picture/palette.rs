//! The few colours of a picture: a count of what is flat, and the clusters in it.

use crate::error::Result;
use crate::limits::{check, with_room};

/// Red, green, blue.
pub type Color = [u8; 3];

/// The most colours of a palette.
pub const MOST_COLORS: usize = 64;

/// Bits of each channel that tell bins apart.
const BITS: u32 = 5;
/// Neighbours whose channels differ by no more are one colour.
const ALIKE: u8 = 8;
/// The least distance of two colours of a palette, in the units of Oklab: three times what an eye tells apart.
const APART: f64 = 0.06;
/// What is nearer than this to a cluster's heaviest bin belongs to the same flat colour.
const CORE: f64 = 0.04;
/// Fewer pixels are no colour.
const LEAST: f64 = 4.0;
/// Rounds in which clusters settle.
const ROUNDS: usize = 12;

/// How many pixels of a bin are like their neighbours, how many there are at all, and the sums of their channels.
#[derive(Clone, Copy, Debug, Default)]
struct Bin {
    flat: u64,
    all: u64,
    sums: [u64; 3],
}

/// Counts the colours of a picture that is given row by row. Pixels between two colours are unlike their neighbours, so they do not count.
#[derive(Clone, Debug)]
pub struct Census {
    width: usize,
    bins: Vec<Bin>,
    above: Vec<u8>,
}

/// One bin among others that become clusters.
struct Item {
    weight: f64,
    lab: [f64; 3],
    rgb: [f64; 3],
    cluster: usize,
}

impl Census {
    /// Begins a picture of that many columns.
    ///
    /// # Errors
    ///
    /// No memory: it needs 1.3 MB.
    pub fn new(width: usize) -> Result<Self> {
        let count = 1 << (3 * BITS);
        let mut bins = with_room(count)?;
        bins.resize(count, Bin::default());
        Ok(Self { width, bins, above: Vec::new() })
    }

    /// More rows, from red, green, blue and opacity, a byte each.
    pub fn push_rgba_rows(&mut self, bytes: &[u8]) {
        for row in bytes.chunks_exact(4 * self.width.max(1)) {
            for column in 0..self.width {
                let at = 4 * column;
                let pixel = &row[at..at + 4];
                if pixel[3] < 250 {
                    continue;
                }
                let like = |other: &[u8]| (0..4).all(|k| pixel[k].abs_diff(other[k]) <= ALIKE);
                let left = if column > 0 { &row[at - 4..at] } else { pixel };
                let above = self.above.get(at..at + 4).unwrap_or(pixel);
                let bin = &mut self.bins[index(pixel)];
                bin.all += 1;
                if like(left) && like(above) {
                    bin.flat += 1;
                    for (sum, &channel) in bin.sums.iter_mut().zip(pixel) {
                        *sum += u64::from(channel);
                    }
                }
            }
            self.above.clear();
            self.above.extend_from_slice(row);
        }
    }

    /// At most `most` colours, those of most pixels first; fewer where there are no more, none where all is transparent.
    ///
    /// Every colour after the first is the one that most pixels are far from; then k-means, in Oklab, where distances are what eyes see.
    ///
    /// # Errors
    ///
    /// `most` below 2 or beyond 64.
    ///
    /// # Source
    ///
    /// \[Llo82\], \[Ott20\].
    pub fn palette(&self, most: usize) -> Result<Vec<Color>> {
        check("colors", None, most as f64, 2.0, MOST_COLORS as f64)?;
        let mut items = self.items()?;
        let mut centers = seeds(&mut items, most);
        for _ in 0..ROUNDS {
            settle(&mut items, &mut centers);
        }
        let mut colors: Vec<(f64, [f64; 3], Color)> = Vec::new();
        for cluster in 0..centers.len() {
            if let Some(found) = flat_color(&items, cluster) {
                let near = colors.iter_mut().find(|(_, lab, _)| distance(lab, &found.1) < APART * APART);
                match near {
                    Some(other) if other.0 < found.0 => *other = found,
                    Some(_) => {}
                    None => colors.push(found),
                }
            }
        }
        // Few of them: the heaviest first by insertion.
        for i in 1..colors.len() {
            let mut k = i;
            while k > 0 && colors[k - 1].0 < colors[k].0 {
                colors.swap(k - 1, k);
                k -= 1;
            }
        }
        Ok(colors.into_iter().map(|(_, _, color)| color).collect())
    }

    /// Bins with something in them: by what is flat or, where nothing is, by all pixels.
    fn items(&self) -> Result<Vec<Item>> {
        let flat = self.bins.iter().any(|bin| bin.flat > 0);
        let mut items = with_room(self.bins.iter().filter(|bin| bin.all > 0).count())?;
        for (i, bin) in self.bins.iter().enumerate() {
            let count = if flat { bin.flat } else { bin.all };
            if count == 0 {
                continue;
            }
            let middle = |k: u32| (((i >> (BITS * k)) & ((1 << BITS) - 1)) << (8 - BITS)) as f64 + 3.5;
            let mut rgb = [middle(2), middle(1), middle(0)];
            if bin.flat > 0 {
                rgb = bin.sums.map(|sum| sum as f64 / bin.flat as f64);
            }
            items.push(Item { weight: count as f64, lab: oklab(rgb), rgb, cluster: 0 });
        }
        Ok(items)
    }
}

fn index(pixel: &[u8]) -> usize {
    let high = |k: usize| usize::from(pixel[k]) >> (8 - BITS);
    (high(0) << (2 * BITS)) | (high(1) << BITS) | high(2)
}

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum()
}

/// The first centres: the heaviest bin, then the one that counts most by its pixels and its distance from all before.
fn seeds(items: &mut [Item], most: usize) -> Vec<[f64; 3]> {
    let mut centers: Vec<[f64; 3]> = Vec::new();
    while centers.len() < most {
        let far = |item: &Item| centers.iter().map(|center| distance(center, &item.lab)).fold(1.0, f64::min);
        let (mut best, mut value) = (None, 0.0);
        for item in items.iter() {
            let gap = far(item);
            let apart = centers.is_empty() || (gap >= APART * APART && item.weight >= LEAST);
            if apart && item.weight * gap > value {
                (best, value) = (Some(item.lab), item.weight * gap);
            }
        }
        match best {
            Some(lab) => centers.push(lab),
            None => break,
        }
    }
    centers
}

/// One round: every bin goes to the nearest centre, every centre to the mean of its bins.
fn settle(items: &mut [Item], centers: &mut [[f64; 3]]) {
    let mut sums = [[0.0; 4]; MOST_COLORS];
    for item in items {
        let mut nearest = f64::INFINITY;
        for (i, center) in centers.iter().enumerate() {
            let gap = distance(center, &item.lab);
            if gap < nearest {
                (item.cluster, nearest) = (i, gap);
            }
        }
        let sum = &mut sums[item.cluster];
        for (total, value) in sum.iter_mut().zip(item.lab) {
            *total += item.weight * value;
        }
        sum[3] += item.weight;
    }
    for (center, sum) in centers.iter_mut().zip(&sums) {
        if sum[3] > 0.0 {
            *center = [sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]];
        }
    }
}

/// The weight of a cluster, and the mean of what is near its heaviest bin.
fn flat_color(items: &[Item], cluster: usize) -> Option<(f64, [f64; 3], Color)> {
    let own = || items.iter().filter(|item| item.cluster == cluster);
    let heaviest = own().fold(None, |best: Option<&Item>, item| match best {
        Some(other) if other.weight >= item.weight => best,
        _ => Some(item),
    })?;
    let (mut weight, mut sum, mut whole) = (0.0, [0.0; 3], 0.0);
    for item in own() {
        whole += item.weight;
        if distance(&item.lab, &heaviest.lab) < CORE * CORE {
            weight += item.weight;
            for (total, value) in sum.iter_mut().zip(item.rgb) {
                *total += item.weight * value;
            }
        }
    }
    let rgb = sum.map(|channel| channel / weight);
    Some((whole, oklab(rgb), rgb.map(|channel| (channel + 0.5) as u8)))
}

/// A colour of sRGB in Oklab.
fn oklab(rgb: [f64; 3]) -> [f64; 3] {
    let [r, g, b] = rgb.map(|channel| {
        let c = channel / 255.0;
        if c <= 0.040_45 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
    });
    let l = libm::cbrt(0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b);
    let m = libm::cbrt(0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b);
    let s = libm::cbrt(0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b);
    [
        0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
        1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
        0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
    ]
}
