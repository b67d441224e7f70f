//! Whether what varies in the colours of a picture is light.

use super::field::{Difference, Field};
use super::patches::Patches;

/// A region is large that has so much of the picture,
const LARGE: f64 = 0.05;
/// and varies if its darkest place is so dark beside its brightest.
const VARIES: f64 = 0.92;
/// How stiff the light is, and how stiff is what its hue adds.
const STIFFNESS: f64 = 0.02;
const HUE_STIFFNESS: f64 = 1.0;
/// Logarithms of sRGB: light that varies by less is even; by more, it is none.
const EVEN: f64 = 0.105;
const MOST: f64 = 1.0;
/// So much its hue may vary.
const HUE: f64 = 0.15;
/// The share of the picture that must be flat, and the share of what varies that must be explained.
const FLAT: f64 = 0.6;
const EXPLAINED: f64 = 0.6;
/// What other colours say of the light counts from so much on,
const HEARD: f64 = 0.00125;
/// and must agree with what the largest region says; 1 is all of it, 0 nothing.
const AGREES: f64 = 0.55;
/// They are looked at where that is no farther than so many tiles.
const REACH: usize = 2;
/// Where other colours say nothing, so much of the picture must be paper, of all ninths of it so much,
const PAPER: f64 = 0.6;
const PAPER_EVERYWHERE: f64 = 0.25;
/// and something must be drawn on it.
const BLANK: f64 = 0.98;

/// The logarithm of the light for every channel, if there is any that is uneven.
pub(super) fn lights(patches: &Patches) -> Option<[Field; 3]> {
    let flat: f64 = patches.list.iter().map(|patch| patch.weight).sum();
    let largest = largest_that_varies(patches)?;
    if flat < FLAT * patches.whole {
        return None;
    }
    let all = differences(patches, &|_| true);
    let light = Field::fitted(&all, STIFFNESS);
    let fields = [0, 1, 2].map(|channel| with_hue(patches, &light, channel));
    if !is_plausible(patches, &fields) || !explains(&light, &all) {
        return None;
    }
    let is_light = match agreement(patches, largest) {
        Some(agreement) => agreement >= AGREES,
        None => flat <= BLANK * patches.whole && is_paper(patches, largest),
    };
    is_light.then_some(fields)
}

/// The largest region, if a large one varies.
#[inline(never)]
fn largest_that_varies(patches: &Patches) -> Option<usize> {
    let count = patches.list.len();
    let (mut sizes, mut least, mut most) = (vec![0.0; count], vec![f64::INFINITY; count], vec![0.0; count]);
    for patch in &patches.list {
        let (region, bright) = (patch.region, patch.color.iter().sum::<f64>() + 12.0);
        sizes[region] += patch.weight;
        least[region] = bright.min(least[region]);
        most[region] = bright.max(most[region]);
    }
    let varies = (0..count).any(|i| sizes[i] > LARGE * patches.whole && least[i] < VARIES * most[i]);
    varies.then(|| (0..count).fold(0, |best, i| if sizes[i] > sizes[best] { i } else { best }))
}

/// What all channels differ by, in those regions.
#[inline(never)]
fn differences(patches: &Patches, takes: &dyn Fn(usize) -> bool) -> Vec<Difference> {
    let own = patches.links.iter().filter(|link| takes(patches.list[link[0]].region));
    own.flat_map(|&link| (0..3).filter_map(move |channel| patches.difference(link, channel))).collect()
}

/// The light of one channel: the light, and what its hue adds.
#[inline(never)]
fn with_hue(patches: &Patches, light: &Field, channel: usize) -> Field {
    let mut own: Vec<Difference> =
        patches.links.iter().filter_map(|&link| patches.difference(link, channel)).collect();
    own.iter_mut().for_each(|d| d.gap -= light.along(&d.places));
    let mut field = Field::fitted(&own, HUE_STIFFNESS);
    field.0.iter_mut().zip(&light.0).for_each(|(value, common)| *value += common);
    field
}

/// Whether light varies enough, and neither it nor its hue too much.
fn is_plausible(patches: &Patches, fields: &[Field; 3]) -> bool {
    let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 4];
    for patch in &patches.list {
        let [r, g, b] = [0, 1, 2].map(|k| fields[k].at(patch.place));
        let mean = (r + g + b) / 3.0;
        for (range, value) in ranges.iter_mut().zip([mean, r - mean, g - mean, b - mean]) {
            *range = [value.min(range[0]), value.max(range[1])];
        }
    }
    let [light, hues @ ..] = ranges.map(|[least, most]| most - least);
    (EVEN..=MOST).contains(&light) && hues.iter().all(|&hue| hue <= HUE)
}

/// Whether the light is what most of the differences are.
fn explains(light: &Field, differences: &[Difference]) -> bool {
    let (mut before, mut after) = (0.0, 0.0);
    for d in differences {
        let rest = d.gap - light.along(&d.places);
        before += d.weight * d.gap * d.gap;
        after += d.weight * rest * rest;
    }
    after <= (1.0 - EXPLAINED) * before
}

/// How much other colours near the largest region agree with the light that it shows by itself; none where they hardly
/// say anything. What is drawn as a gradient has others beside it that are not.
#[inline(never)]
fn agreement(patches: &Patches, largest: usize) -> Option<f64> {
    let light = Field::fitted(&differences(patches, &|region| region == largest), STIFFNESS);
    let is_near = |tile: usize| {
        let [columns, rows] = patches.tiles;
        let around = |at: usize, count: usize| at.saturating_sub(REACH)..(at + REACH + 1).min(count);
        around(tile / columns, rows).any(|row| {
            around(tile % columns, columns).any(|column| patches.shows(row * columns + column, largest))
        })
    };
    let (mut both, mut squares) = (0.0, 0.0);
    for &link in &patches.links {
        let [from, to] = link.map(|i| &patches.list[i]);
        if from.region == largest || !is_near(from.tile) || !is_near(to.tile) {
            continue;
        }
        for d in (0..3).filter_map(|channel| patches.difference(link, channel)) {
            let expected = light.along(&d.places);
            both += d.weight * d.gap * expected;
            squares += d.weight * (d.gap * d.gap + expected * expected);
        }
    }
    (squares >= HEARD).then(|| 2.0 * both / squares)
}

/// Whether a region is most of the picture, and a good part of every ninth of it.
fn is_paper(patches: &Patches, region: usize) -> bool {
    let [columns, rows] = patches.tiles;
    let mut parts = [(0.0, 0.0); 9];
    for tile in 0..columns * rows {
        let part = &mut parts[3 * (tile / columns) / rows * 3 + 3 * (tile % columns) / columns];
        *part = (part.0 + f64::from(u8::from(patches.shows(tile, region))), part.1 + 1.0);
    }
    let own = patches.list.iter().filter(|patch| patch.region == region);
    own.map(|patch| patch.weight).sum::<f64>() >= PAPER * patches.whole
        && parts.iter().all(|part| part.0 >= PAPER_EVERYWHERE * part.1)
}
