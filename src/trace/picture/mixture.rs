//! Pixels that are a mixture of two others, and pixels that are a colour of their own.

/// Red, green and blue as far as they are there, and how far: nothing is (0, 0, 0, 0).
pub(super) type Premultiplied = [i32; 4];

/// Neighbours whose channels differ by no more are of one shade.
const ALIKE: u32 = 8;
/// Squared distance of two neighbours of a pixel with an edge between them.
const STEP: i32 = 24 * 24;
/// Squared distance up to which a pixel is taken for a mixture of its neighbours.
const BESIDE: f64 = 32.0 * 32.0;

/// A pixel's channels as far as they are there.
pub(super) fn premultiplied(pixel: [u8; 4]) -> Premultiplied {
    let [red, green, blue, opacity] = pixel.map(i32::from);
    let there = |channel: i32| (channel * opacity + 127) / 255;
    [there(red), there(green), there(blue), opacity]
}

pub(super) fn squared(a: &Premultiplied, b: &Premultiplied) -> i32 {
    (0..4).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum()
}

/// Whether two pixels are of one shade.
pub(super) fn is_like(a: &Premultiplied, b: &Premultiplied) -> bool {
    (0..4).all(|k| a[k].abs_diff(b[k]) <= ALIKE)
}

/// The mixture of two colours that is nearest to a third.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mixture {
    /// The share of the second of the two.
    pub(super) share: f64,
    /// The squared distance to the third.
    pub(super) gap: f64,
    /// As much of it as is a difference in light, not in hue.
    pub(super) light: f64,
}

impl Mixture {
    pub(super) fn new(pixel: &Premultiplied, from: &Premultiplied, to: &Premultiplied) -> Self {
        let whole = squared(from, to);
        let along: i32 = (0..4).map(|k| (pixel[k] - from[k]) * (to[k] - from[k])).sum();
        let share = if whole == 0 { 0.0 } else { (f64::from(along) / f64::from(whole)).clamp(0.0, 1.0) };
        let off: [f64; 4] =
            core::array::from_fn(|k| f64::from(pixel[k] - from[k]) - share * f64::from(to[k] - from[k]));
        let light = off[0] + off[1] + off[2];
        Self { share, gap: off.iter().map(|off| off * off).sum(), light: light * light / 3.0 }
    }
}

/// What a pixel takes of the second of two shapes side by side that were blended one after the other, each by what it
/// covers, over a third colour: both let a quarter of it through where each has a half (D 14.29).
#[derive(Clone, Copy, Debug)]
pub(super) struct Seam {
    /// The share of the second of the two.
    pub(super) share: f64,
    /// The squared distance to the pixel.
    pub(super) gap: f64,
}

impl Seam {
    /// None where the third colour is near a mixture of the two: then pixels do not say how much of it there is.
    pub(super) fn new(
        pixel: &Premultiplied,
        from: &Premultiplied,
        to: &Premultiplied,
        ground: &Premultiplied,
    ) -> Option<Self> {
        let whole = f64::from(squared(from, to));
        if whole == 0.0 {
            return None;
        }
        let along = |color: &Premultiplied| {
            let sum: i32 = (0..4).map(|k| (color[k] - from[k]) * (to[k] - from[k])).sum();
            f64::from(sum) / whole
        };
        let (pixel_along, ground_along) = (along(pixel), along(ground));
        let beside = |color: &Premultiplied, along: f64| -> [f64; 4] {
            core::array::from_fn(|k| f64::from(color[k] - from[k]) - along * f64::from(to[k] - from[k]))
        };
        let (off, ground_off) = (beside(pixel, pixel_along), beside(ground, ground_along));
        let dot = |a: &[f64; 4], b: &[f64; 4]| (0..4).map(|k| a[k] * b[k]).sum::<f64>();
        let aside = dot(&ground_off, &ground_off);
        if aside < f64::from(STEP) {
            return None;
        }
        let through = dot(&off, &ground_off) / aside;
        let left = dot(&off, &off) - through * through * aside;
        let second = pixel_along - through * ground_along;
        let first = 1.0 - through - second;
        // Whoever came last has all of its share, and lets as much through as the other one had.
        let miss = |last: f64| (through - last * (1.0 - last)).abs();
        let share = if miss(second) <= miss(first) { second } else { 1.0 - first };
        let miss = miss(second).min(miss(first));
        ((0.0..=1.0).contains(&share)).then_some(Self { share, gap: left + miss * miss * aside })
    }
}

/// Whether a colour is a mixture of two that are unlike, up to a squared distance, and near neither of them.
pub(super) fn is_between(pixel: &Premultiplied, from: &Premultiplied, to: &Premultiplied, most: f64) -> bool {
    if squared(from, to) <= STEP {
        return false;
    }
    let Mixture { share, gap, .. } = Mixture::new(pixel, from, to);
    share > 0.05 && share < 0.95 && gap < most
}

/// Whether a pixel is on the way from one neighbour to the one on the other side. In the middle of something thin it is
/// not, nor where it is flat: there it shows a colour of its own.
pub(super) fn is_on_edge(pixel: &Premultiplied, [left, right, above, below]: [&Premultiplied; 4]) -> bool {
    is_between(pixel, left, right, BESIDE) || is_between(pixel, above, below, BESIDE)
}
