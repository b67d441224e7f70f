//! The few colours of a picture: a count of the pixels that show one, and the clusters in it.

use super::hues::{Edges, is_bled};
use super::mixture::{Premultiplied, is_between, is_like, is_on_edge, premultiplied};
use crate::error::Result;
use crate::limits::{check, with_room};

/// Red, green, blue.
pub type Color = [u8; 3];

/// A colour and how much of it is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tint {
    /// Its own, as if all of it were there.
    pub color: Color,
    /// 255 where nothing shows through it.
    pub opacity: u8,
}

impl From<Color> for Tint {
    fn from(color: Color) -> Self {
        Self { color, opacity: 255 }
    }
}

impl Tint {
    /// The colour that it has on white paper.
    pub fn on_white(&self) -> Color {
        on_white(self.color.map(f64::from), f64::from(self.opacity)).map(rounded)
    }

    pub(super) fn premultiplied(&self) -> Premultiplied {
        let [red, green, blue] = self.color;
        premultiplied([red, green, blue, self.opacity])
    }
}

/// The most colours of a palette.
pub const MOST_COLORS: usize = 64;

/// Bits of each channel that tell bins apart.
const BITS: u32 = 5;
/// Less opacity is a share of a colour, not a colour, but where all around is the same.
const OPAQUE: u8 = 250;
/// Less is nothing.
const FAINT: u8 = 24;
/// Bits of each channel that tell bins of translucent colours apart.
const CLEAR_BITS: u32 = 4;
/// A pixel that is like its neighbours counts for as many in the middle of something thin, which mostly show more than one colour.
const FLAT: u64 = 4;
/// Squared distance up to which a colour of thin places is taken for a mixture of two others.
const MIXED: f64 = 12.0 * 12.0;
/// The least distance of two colours of a palette, in the units of Oklab: three times what an eye tells apart.
const APART: f64 = 0.06;
/// The least distance of two pure colours: half as much, because they are shades that were drawn so.
const APART_PURE: f64 = 0.03;
/// A bin is pure where no more than one part in so many is around it: noise and gradients fill the bins beside,
const MOST_AROUND: f64 = 8.0;
/// which are nearer than this,
const AROUND: f64 = 0.022;
/// and where as many pixels show it, most of them flat.
const LEAST_PURE: f64 = 8.0;
/// What is nearer than this to a cluster's heaviest bin belongs to the same flat colour.
const CORE: f64 = 0.04;
/// Fewer pixels are no colour.
const LEAST: f64 = 2.0;
/// So many bins with less around them are looked at for first centres.
const MOST_WEAK: usize = 256;
/// Rounds in which clusters settle.
const ROUNDS: usize = 12;

/// Rows that say which pixels of the one in the middle show a colour.
const ROWS: usize = 5;

/// What the pixels of a bin weigh that show a colour, how many of them are flat, how many there are at all, and the weighted sums of channels and opacity.
#[derive(Clone, Copy, Debug, Default)]
struct Bin {
    weight: u64,
    flat: u64,
    all: u64,
    sums: [u64; 4],
    /// As much of the weight, and of the flat ones, as is on an edge of hues.
    bled: u64,
    bled_flat: u64,
}

/// Counts the colours of a picture that is given row by row. Pixels between two colours are on the way from one neighbour to the one on the
/// other side, so they do not count.
#[derive(Clone, Debug)]
pub struct Census {
    width: usize,
    /// Those of opaque colours, and then those of translucent ones, by what they are on white.
    bins: Vec<Bin>,
    /// The last rows. The one in the middle is counted next, once those below have come.
    window: [Vec<u8>; ROWS],
    edges: Edges,
}

/// One bin among others that become clusters.
struct Item {
    weight: f64,
    /// How much of that is flat.
    flat: f64,
    /// On white.
    lab: [f64; 3],
    rgb: [f64; 3],
    opacity: f64,
    cluster: usize,
    /// Squared distance to the nearest of the first centres.
    gap: f64,
    /// Whether there is too little around it for a centre.
    is_weak: bool,
}

/// A colour that was found.
struct Found {
    weight: f64,
    lab: [f64; 3],
    color: Tint,
    /// Whether it was seen in thin places mostly.
    is_thin: bool,
    is_pure: bool,
}

impl Census {
    /// Begins a picture of that many columns.
    ///
    /// # Errors
    ///
    /// No memory: it needs 2.7 MB.
    pub fn new(width: usize) -> Result<Self> {
        let count = (1 << (3 * BITS)) + (1 << (3 * CLEAR_BITS));
        let mut bins = with_room(count)?;
        bins.resize(count, Bin::default());
        Ok(Self { width, bins, window: Default::default(), edges: Edges::default() })
    }

    /// More rows, from red, green, blue and opacity, a byte each.
    pub fn push_rgba_rows(&mut self, bytes: &[u8]) {
        for row in bytes.chunks_exact(4 * self.width.max(1)) {
            self.push(row);
        }
    }

    fn push(&mut self, row: &[u8]) {
        self.window.rotate_left(1);
        self.window[ROWS - 1].clear();
        self.window[ROWS - 1].extend_from_slice(row);
        self.count();
    }

    /// Counts the row in the middle of the window.
    fn count(&mut self) {
        let rows = self.window.each_ref().map(|row| row.as_chunks::<4>().0);
        let row = rows[ROWS / 2];
        self.edges.count(row);
        for (column, pixel) in row.iter().enumerate() {
            if pixel[3] < FAINT {
                continue;
            }
            let (weight, is_bled) = weight(&rows, column);
            // A share of a colour says which one that is, if nothing else does.
            let bin = &mut self.bins[index(pixel, weight > 0)];
            bin.all += 1;
            bin.weight += weight;
            let flat = u64::from(weight == FLAT);
            bin.flat += flat;
            if is_bled {
                bin.bled += weight;
                bin.bled_flat += flat;
            }
            for (sum, &channel) in bin.sums.iter_mut().zip(pixel) {
                *sum += weight * u64::from(channel);
            }
        }
    }

    /// At most `most` colours of all rows given, the last row being the lowest; those of most pixels first; fewer where there are no more, none where all is transparent.
    ///
    /// What is translucent is a colour where it is the same all around, and compared as it is on white. Every colour after the first is the one that most pixels are far from; then k-means, in Oklab, where distances are what eyes see.
    ///
    /// # Errors
    ///
    /// `most` below 2 or beyond 64.
    ///
    /// # Source
    ///
    /// \[Llo82\], \[Ott20\].
    pub fn palette(&mut self, most: usize) -> Result<Vec<Tint>> {
        check("colors", None, most as f64, 2.0, MOST_COLORS as f64)?;
        self.push(&[]);
        self.push(&[]);
        let mut items = self.items()?;
        let mut centers = seeds(&mut items, most);
        for _ in 0..ROUNDS {
            settle(&mut items, &mut centers);
        }
        let mut colors: Vec<Found> = Vec::new();
        for cluster in 0..centers.len() {
            if let Some(found) = color_of(&items, cluster)
                && (colors.is_empty() || found.weight >= LEAST)
            {
                let is_near = |other: &&mut Found| {
                    let least = if other.is_pure && found.is_pure { APART_PURE } else { APART };
                    distance(&other.lab, &found.lab) < least * least
                };
                match colors.iter_mut().find(is_near) {
                    Some(other) if other.weight < found.weight => *other = found,
                    Some(_) => {}
                    None => colors.push(found),
                }
            }
        }
        leave_mixtures_out(&mut colors);
        // Few of them: the heaviest first by insertion.
        for i in 1..colors.len() {
            let mut k = i;
            while k > 0 && colors[k - 1].weight < colors[k].weight {
                colors.swap(k - 1, k);
                k -= 1;
            }
        }
        Ok(colors.into_iter().map(|found| found.color).collect())
    }

    /// Bins with something in them: by the pixels that show a colour or, where none is, by all of them.
    fn items(&self) -> Result<Vec<Item>> {
        let is_wide = self.edges.are_wide();
        let counts = |bin: &Bin| {
            if is_wide { (bin.weight - bin.bled, bin.flat - bin.bled_flat) } else { (bin.weight, bin.flat) }
        };
        let some = self.bins.iter().any(|bin| counts(bin).0 > 0);
        let mut items = with_room(self.bins.iter().filter(|bin| bin.all > 0).count())?;
        for (i, bin) in self.bins.iter().enumerate() {
            let (weight, flat) = counts(bin);
            let count = if some { weight } else { FLAT * bin.all };
            if count == 0 {
                continue;
            }
            let middle = |k: u32| (((i >> (BITS * k)) & ((1 << BITS) - 1)) << (8 - BITS)) as f64 + 3.5;
            let (mut rgb, mut opacity) = ([middle(2), middle(1), middle(0)], 255.0);
            if bin.weight > 0 {
                let [red, green, blue, all] = bin.sums.map(|sum| sum as f64 / bin.weight as f64);
                rgb = [red, green, blue];
                opacity = if i >> (3 * BITS) == 0 { 255.0 } else { all };
            }
            let weight = count as f64 / FLAT as f64;
            let (flat, lab) = (flat as f64, oklab(on_white(rgb, opacity)));
            items.push(Item { weight, flat, lab, rgb, opacity, cluster: 0, gap: 1.0, is_weak: false });
        }
        Ok(items)
    }
}

/// What is to the left, to the right, above and below at a distance. Beyond the border all is as it is on the other side.
#[inline(never)]
fn around(rows: &[&[[u8; 4]]; ROWS], column: usize, reach: usize) -> [[u8; 4]; 4] {
    let middle = ROWS / 2;
    let at = |row: usize, column: usize| rows[row].get(column);
    let (left, right) = (at(middle, column.wrapping_sub(reach)), at(middle, column + reach));
    let (above, below) = (at(middle - reach, column), at(middle + reach, column));
    let or = |one: Option<&[u8; 4]>, other: Option<&[u8; 4]>| *one.or(other).unwrap_or(&rows[middle][column]);
    [or(left, right), or(right, left), or(above, below), or(below, above)]
}

/// What a pixel counts for, by the rows around it, and whether it is on an edge of hues.
fn weight(rows: &[&[[u8; 4]]; ROWS], column: usize) -> (u64, bool) {
    let pixel = rows[ROWS / 2][column];
    let near = around(rows, column, 1);
    if near == [pixel; 4] {
        return (FLAT, false);
    }
    if pixel[3] < OPAQUE {
        return (0, false);
    }
    let (color, near) = (pixel.map(i32::from), near.map(|near| near.map(i32::from)));
    let is_alike = |k: usize| is_like(&color, &near[k]);
    let is_flat = is_alike(0) && is_alike(2);
    if is_flat && is_alike(1) && is_alike(3) {
        return (FLAT, false);
    }
    if is_on_edge(&color, near.each_ref()) {
        return (0, false);
    }
    let is_bled =
        is_bled(&color, &near) || is_bled(&color, &around(rows, column, 2).map(|far| far.map(i32::from)));
    (if is_flat { FLAT } else { 1 }, is_bled)
}

fn index(pixel: &[u8; 4], is_color: bool) -> usize {
    let number = |[red, green, blue]: Color, bits: u32| {
        let high = |channel: u8| usize::from(channel) >> (8 - bits);
        (high(red) << (2 * bits)) | (high(green) << bits) | high(blue)
    };
    let &[red, green, blue, opacity] = pixel;
    let own = Tint { color: [red, green, blue], opacity };
    if is_color && opacity < OPAQUE {
        return (1 << (3 * BITS)) + number(own.on_white(), CLEAR_BITS);
    }
    number(own.color, BITS)
}

/// What a colour of some opacity is on white.
fn on_white(rgb: [f64; 3], opacity: f64) -> [f64; 3] {
    rgb.map(|channel| 255.0 + (channel - 255.0) * (opacity / 255.0))
}

fn rounded(channel: f64) -> u8 {
    (channel + 0.5) as u8
}

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum()
}

/// The first centres: the heaviest bin, then the one that counts most by its pixels and its distance from all before. Where there is room
/// left, pure ones may be nearer to each other.
fn seeds(items: &mut [Item], most: usize) -> Vec<[f64; 3]> {
    let mut centers: Vec<[f64; 3]> = Vec::new();
    let mut weak = 0;
    for (apart, must_be_pure) in [(APART, false), (APART_PURE, true)] {
        while centers.len() < most && weak < MOST_WEAK {
            let Some(best) = farthest(items, apart) else { break };
            let lab = items[best].lab;
            let is_seed = if must_be_pure {
                is_pure_beside_pure(items, best)
            } else {
                centers.is_empty() || weight_around(items, &lab, CORE) >= LEAST
            };
            if !is_seed {
                items[best].is_weak = true;
                weak += 1;
                continue;
            }
            centers.push(lab);
            for item in items.iter_mut() {
                item.gap = item.gap.min(distance(&item.lab, &lab));
            }
        }
    }
    centers
}

/// The bin that counts most by its pixels and its distance from all centres, of those that are so far from them.
fn farthest(items: &[Item], apart: f64) -> Option<usize> {
    let (mut best, mut value) = (None, 0.0);
    for (i, item) in items.iter().enumerate() {
        if item.gap >= apart * apart && !item.is_weak && item.weight * item.gap > value {
            (best, value) = (Some(i), item.weight * item.gap);
        }
    }
    best
}

/// Whether a bin is pure, and the centres near it are.
fn is_pure_beside_pure(items: &[Item], i: usize) -> bool {
    let is_near_center = |item: &&Item| item.gap == 0.0 && distance(&item.lab, &items[i].lab) < APART * APART;
    is_pure(items, &items[i]) && items.iter().filter(is_near_center).all(|center| is_pure(items, center))
}

fn weight_around(items: &[Item], lab: &[f64; 3], reach: f64) -> f64 {
    items.iter().filter(|item| distance(&item.lab, lab) < reach * reach).map(|item| item.weight).sum()
}

/// Whether a bin is one flat colour, with next to nothing around it.
fn is_pure(items: &[Item], item: &Item) -> bool {
    2.0 * item.flat > item.weight
        && item.weight >= LEAST_PURE
        && MOST_AROUND * (weight_around(items, &item.lab, AROUND) - item.weight) < item.weight
}

/// Thin places show a colour mixed with what is beside them as well: such a mixture of two others is no colour.
fn leave_mixtures_out(colors: &mut Vec<Found>) {
    let mut k = 0;
    while k < colors.len() {
        let others: Vec<_> =
            (0..colors.len()).filter(|&i| i != k).map(|i| colors[i].color.premultiplied()).collect();
        let here = colors[k].color.premultiplied();
        let is_mixture =
            || others.iter().any(|from| others.iter().any(|to| is_between(&here, from, to, MIXED)));
        if colors[k].is_thin && is_mixture() {
            colors.remove(k);
        } else {
            k += 1;
        }
    }
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

/// The colour of a cluster: the mean of what is near its heaviest bin or, where it was seen in thin places mostly, of all of it.
fn color_of(items: &[Item], cluster: usize) -> Option<Found> {
    let own = || items.iter().filter(|item| item.cluster == cluster);
    let heaviest = own().fold(None, |best: Option<&Item>, item| match best {
        Some(other) if other.weight >= item.weight => best,
        _ => Some(item),
    })?;
    let whole: f64 = own().map(|item| item.weight).sum();
    let is_thin = 2.0 * own().map(|item| item.flat).sum::<f64>() < whole;
    let (mut weight, mut sum) = (0.0, [0.0; 4]);
    let is_alike = |item: &&Item| {
        // Of the same look, but not of the same opacity.
        (item.opacity < 255.0) == (heaviest.opacity < 255.0)
            && (is_thin || distance(&item.lab, &heaviest.lab) < CORE * CORE)
    };
    for item in own().filter(is_alike) {
        weight += item.weight;
        for (total, value) in sum.iter_mut().zip(item.rgb.into_iter().chain([item.opacity])) {
            *total += item.weight * value;
        }
    }
    let [red, green, blue, opacity] = sum.map(|channel| channel / weight);
    let rgb = [red, green, blue];
    let color = Tint { color: rgb.map(rounded), opacity: rounded(opacity) };
    let lab = oklab(on_white(rgb, opacity));
    Some(Found { weight: whole, lab, color, is_thin, is_pure: is_pure(items, heaviest) })
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
