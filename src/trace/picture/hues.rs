//! Pictures that keep one hue for several pixels together, as compression (JPEG) does: edges of hues are wider there
//! than those of light, and what they show is a mixture of neither.

use super::mixture::Premultiplied;

/// Pixels of a row across an edge.
const ACROSS: usize = 5;
/// The least step in light from one side of an edge to the other,
const LIGHT_STEP: i32 = 24;
/// and in hue, squared: as differences of channels have it, three times that of channels.
const HUE_STEP: i32 = 3 * 48 * 48;
/// An edge is sharp where more than so many twentieths of its step are between the neighbours of one pixel.
const SHARP: i32 = 17;
/// Beyond both sides by more of them is something thin between.
const BEYOND: i32 = 1;
/// Half as many wide edges say nothing of hues, if none is sharp.
const LEAST: usize = 26;
/// The least squared distance of two hues that have others between them,
const STEP: i32 = 3 * 16 * 16;
/// and that up to which a hue is one of these.
const BESIDE: f64 = 3.0 * 32.0 * 32.0;
/// and that up to which it is still the hue of one whose light waves.
const WAVING: i32 = 32 * 32;
/// How much lighter or darker than both of its neighbours a pixel on the edge of their hues may be: compression waves.
const FRINGE: i32 = 40;

/// Edges of light in the rows of a picture: where hue changes as fast, and where not.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Edges {
    sharp: usize,
    wide: usize,
}

impl Edges {
    /// Counts those of one more row.
    pub(super) fn count(&mut self, row: &[[u8; 4]]) {
        for pixels in row.windows(ACROSS) {
            let pixel = |k: usize| pixels[k].map(i32::from);
            let (from, to) = (light(&pixel(0)), light(&pixel(ACROSS - 1)));
            let step = (to - from).abs();
            if step < LIGHT_STEP {
                continue;
            }
            let along = |k: usize| 20 * (light(&pixel(k)) - from) * (to - from).signum();
            let is_beyond = |k: usize| !(-BEYOND * step..=(20 + BEYOND) * step).contains(&along(k));
            if along(3) - along(1) <= SHARP * step || (1..4).any(is_beyond) {
                continue;
            }
            let from = hue(&pixel(0));
            let step = less(&hue(&pixel(ACROSS - 1)), &from);
            let whole = dot(&step, &step);
            let along = |k: usize| 20 * dot(&less(&hue(&pixel(k)), &from), &step);
            let is_beyond = |k: usize| !(-BEYOND * whole..=(20 + BEYOND) * whole).contains(&along(k));
            if whole >= HUE_STEP && !(1..4).any(is_beyond) {
                let is_sharp = along(3) - along(1) > SHARP * whole;
                *(if is_sharp { &mut self.sharp } else { &mut self.wide }) += 1;
            }
        }
    }

    /// Whether edges of hues are wider than those of light. Up to half of those of small pictures are not, where
    /// something is as thin as they are wide.
    pub(super) fn are_wide(&self) -> bool {
        2 * self.wide > self.sharp + LEAST
    }
}

/// Whether a pixel has its hue on the way from one neighbour to the one on the other side, and its light within theirs.
pub(super) fn is_bled(pixel: &Premultiplied, [left, right, above, below]: &[Premultiplied; 4]) -> bool {
    is_shared(pixel, left, right, FRINGE) || is_shared(pixel, above, below, FRINGE)
}

/// Whether a colour has its hue on the way from one to another, and its light within theirs, or no farther beyond.
pub(super) fn is_shared(
    color: &Premultiplied,
    from: &Premultiplied,
    to: &Premultiplied,
    beyond: i32,
) -> bool {
    let [from_light, to_light] = [light(from), light(to)];
    let within = from_light.min(to_light) - beyond..=from_light.max(to_light) + beyond;
    within.contains(&light(color)) && is_hue_between(color, from, to)
}

/// Whether a colour is what the waves of compression make of another one: a bit lighter or darker, of about its hue.
pub(super) fn is_wave(color: &Premultiplied, of: &Premultiplied) -> bool {
    let off = less(&hue(color), &hue(of));
    (light(color) - light(of)).abs() <= FRINGE && dot(&off, &off) < WAVING
}

/// Whether a hue is on the way from one to another. Differences with a channel at the end of its range do not count: it
/// would go on.
fn is_hue_between(pixel: &Premultiplied, from: &Premultiplied, to: &Premultiplied) -> bool {
    let ends = |k: usize| matches!(pixel[k], 0 | 255);
    let known: [i32; 3] = core::array::from_fn(|k| i32::from(!ends(k) && !ends((k + 1) % 3)));
    let [pixel, from, to] = [pixel, from, to].map(|color| {
        let hue = hue(color);
        [0, 1, 2].map(|k| known[k] * hue[k])
    });
    let (step, off) = (less(&to, &from), less(&pixel, &from));
    let whole = dot(&step, &step);
    if whole < STEP {
        return false;
    }
    let whole = f64::from(whole);
    let share = f64::from(dot(&off, &step)) / whole;
    share > 0.05 && share < 0.95 && f64::from(dot(&off, &off)) - share * share * whole < BESIDE
}

/// A colour as its light, four times over, what red and blue are off it, and its opacity.
pub(super) fn by_light(color: &Premultiplied) -> Premultiplied {
    let light = light(color);
    [4 * light, color[0] - light, color[2] - light, 4 * color[3]]
}

fn light(color: &[i32; 4]) -> i32 {
    (77 * color[0] + 150 * color[1] + 29 * color[2]) >> 8
}

fn hue(color: &[i32; 4]) -> [i32; 3] {
    [color[0] - color[1], color[1] - color[2], color[2] - color[0]]
}

fn less(a: &[i32; 3], b: &[i32; 3]) -> [i32; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: &[i32; 3], b: &[i32; 3]) -> i32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
