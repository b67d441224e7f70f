//! The few colours of a picture: clusters of what was counted.

use super::compression::Compression;
use super::hues::{is_shared, is_wave};
use super::mixture::{Premultiplied, is_between};
use super::tint::{Tint, on_white, rounded};

/// The most colours of a palette.
pub const MOST_COLORS: usize = 64;

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
/// A colour that is nowhere broader than two pixels has less than one part in so many alike all around.
const NARROW: f64 = 40.0;
/// How much lighter or darker than two colours one may be that is made of their hues.
const ROUNDED: i32 = 8;
/// A colour that waves make in a compressed picture has less than one part in so many that is even.
const UNEVEN: f64 = 16.0;
/// What is nearer than this to a cluster's heaviest bin belongs to the same flat colour.
const CORE: f64 = 0.04;
/// Fewer pixels are no colour.
const LEAST: f64 = 2.0;
/// So many bins with less around them are looked at for first centres.
const MOST_WEAK: usize = 256;
/// Rounds in which clusters settle.
const ROUNDS: usize = 12;

/// Pixels of nearly one colour, among others that become clusters.
pub(super) struct Item {
    weight: f64,
    /// How much of that is flat.
    flat: f64,
    /// How much of it is alike all around, and how much the same.
    inner: f64,
    even: f64,
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

impl Item {
    /// Of so many pixels, as many of them flat, as many alike all around, and as many the same.
    pub(super) fn new(weight: f64, [flat, inner, even]: [f64; 3], rgb: [f64; 3], opacity: f64) -> Self {
        let lab = oklab(on_white(rgb, opacity));
        Self { weight, flat, inner, even, lab, rgb, opacity, cluster: 0, gap: 1.0, is_weak: false }
    }
}

/// A colour that was found.
struct Found {
    weight: f64,
    lab: [f64; 3],
    color: Tint,
    /// Whether it was seen in thin places mostly.
    is_thin: bool,
    is_pure: bool,
    /// Whether it was hardly seen anywhere but in things of one or two pixels.
    is_narrow: bool,
    /// Whether hardly anything of it was even.
    is_uneven: bool,
}

/// At most `most` colours, those of most pixels first. Every colour after the first is the one that most pixels are far
/// from; then k-means \[Llo82\], in Oklab \[Ott20\], where distances are what eyes see. Where some of them turn out to
/// be mixtures, there is room for pure ones that are nearer to others.
pub(super) fn palette_of(items: &mut [Item], most: usize, compression: Compression) -> Vec<Tint> {
    let mut centers: Vec<[f64; 3]> = Vec::new();
    add_seeds(items, &mut centers, most, false);
    let mut colors = colors_around(items, centers.clone(), compression);
    let first = centers.len();
    if colors.len() < most {
        add_seeds(items, &mut centers, MOST_COLORS, true);
    }
    if centers.len() > first {
        colors = colors_around(items, centers, compression);
        colors.truncate(most);
    }
    // Few of them: the heaviest first by insertion.
    for i in 1..colors.len() {
        let mut k = i;
        while k > 0 && colors[k - 1].weight < colors[k].weight {
            colors.swap(k - 1, k);
            k -= 1;
        }
    }
    colors.into_iter().map(|found| found.color).collect()
}

/// The colours of the clusters that settle from those centres, in their order.
fn colors_around(items: &mut [Item], mut centers: Vec<[f64; 3]>, compression: Compression) -> Vec<Found> {
    for _ in 0..ROUNDS {
        settle(items, &mut centers);
    }
    let mut colors: Vec<Found> = Vec::new();
    for cluster in 0..centers.len() {
        if let Some(found) = color_of(items, cluster)
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
    if compression.squares || compression.shared_hues {
        leave_waves_out(&mut colors, compression.squares);
    }
    colors
}

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum()
}

/// More centres: the heaviest bin, then the one that counts most by its pixels and its distance from all before; or
/// pure ones, which may be nearer to each other.
fn add_seeds(items: &mut [Item], centers: &mut Vec<[f64; 3]>, most: usize, must_be_pure: bool) {
    let apart = if must_be_pure { APART_PURE } else { APART };
    let mut weak = 0;
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

/// Thin places show a colour mixed with what is beside them as well: such a mixture of two others is no colour. A
/// stroke of a pixel that two rows share looks like one of two pixels, where nothing of its own colour is any broader.
fn leave_mixtures_out(colors: &mut Vec<Found>) {
    let mut k = 0;
    while k < colors.len() {
        let here = &colors[k];
        let color = here.color.premultiplied();
        let is_between = |from: &Found, to: &Found| {
            is_between(&color, &from.color.premultiplied(), &to.color.premultiplied(), MIXED)
        };
        let is_shared = here.is_narrow && !here.is_pure;
        let others = || colors.iter().enumerate().filter(|&(i, _)| i != k).map(|(_, other)| other);
        let is_mixture = |from: &Found| {
            (here.is_thin || is_shared && from.is_narrow) && others().any(|to| is_between(from, to))
        };
        if others().any(is_mixture) {
            colors.remove(k);
        } else {
            k += 1;
        }
    }
}

/// Beside edges compression makes waves of each colour, and mixtures of their hues. What was drawn is even somewhere,
/// or it is unlike all that there is more of. Where only hues tell of compression, there may be too few squares for
/// that: what was drawn is alike somewhere then.
fn leave_waves_out(colors: &mut Vec<Found>, has_squares: bool) {
    let mut k = 0;
    while k < colors.len() {
        let here = &colors[k];
        let color = here.color.premultiplied();
        let more = || {
            let more = colors.iter().filter(|other| other.weight > here.weight);
            more.map(|other| other.color.premultiplied())
        };
        let is_made = |from: Premultiplied| {
            is_wave(&color, &from) || more().any(|to| is_shared(&color, &from, &to, ROUNDED))
        };
        let may_be_made = here.is_uneven && (has_squares || here.is_narrow);
        if may_be_made && more().any(is_made) {
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

/// The colour of a cluster: the mean of what is near its heaviest bin or, where it was seen in thin places mostly, of
/// all of it.
fn color_of(items: &[Item], cluster: usize) -> Option<Found> {
    let own = || items.iter().filter(|item| item.cluster == cluster);
    let heaviest = own().fold(None, |best: Option<&Item>, item| match best {
        Some(other) if other.weight >= item.weight => best,
        _ => Some(item),
    })?;
    let whole: f64 = own().map(|item| item.weight).sum();
    let is_thin = 2.0 * own().map(|item| item.flat).sum::<f64>() < whole;
    let is_uneven = UNEVEN * own().map(|item| item.even).sum::<f64>() < whole;
    let is_narrow = NARROW * own().map(|item| item.inner).sum::<f64>() < whole;
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
    Some(Found {
        weight: whole,
        lab,
        color,
        is_thin,
        is_pure: is_pure(items, heaviest),
        is_narrow,
        is_uneven,
    })
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
