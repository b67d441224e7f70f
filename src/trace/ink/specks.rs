//! How much there is in a small contour. Between centres of pixels it cuts corners, by half a pixel of a pixel, and
//! encloses half of a dot hardly larger than one: whether it is a speck is said by what pixels are covered by.

use crate::numerics::Point;
use crate::numerics::plane::{larger, smaller};
use crate::trace::picture::contour::Contour;
use crate::trace::picture::gray::Gray;
use crate::trace::picture::tones::Tones;

/// A contour encloses at least this share of what is in it, and hardly less than that if it has more points.
pub(super) const ENCLOSED: f64 = 0.25;
const SMALL: usize = 64;

/// Pixels are of one of the two tones if they are no farther from it.
const TONE: f64 = 0.02;

/// What a contour of ink at `level`, or of a hole, is the outline of, in square pixels.
pub(super) fn size(contour: &Contour, gray: &Gray, tones: &Tones, shade: (f64, bool)) -> f64 {
    let area = contour.area.abs();
    let all = if contour.points.len() > SMALL { 0.0 } else { amount(contour, gray, tones, shade) };
    larger(area, smaller(all, area / ENCLOSED))
}

/// Whether there are shades between the tones in it, as in what was drawn. What is lost on a scan has none.
pub(super) fn is_shaded(contour: &Contour, gray: &Gray, tones: &Tones, shade: (f64, bool)) -> bool {
    contour.points.len() <= SMALL && amount(contour, gray, tones, shade) > 0.0
}

/// The ink inside and beside a contour, or the paper of a hole; none where all pixels are of two tones, as what is lost
/// on a scan is.
fn amount(contour: &Contour, gray: &Gray, tones: &Tones, (level, inverted): (f64, bool)) -> f64 {
    let light = inverted == (contour.area > 0.0);
    let ink = |x: usize, y: usize| {
        let share = (tones.paper - gray.shade(x, y)) / (tones.paper - tones.ink);
        (if light { 1.0 - share } else { share }).clamp(0.0, 1.0)
    };
    let is_inside = |x: usize, y: usize| (gray.shade(x, y) > level) == light;
    // Pixels whose centres are in the contour's box, and those around them.
    let span = |at: fn(&Point) -> f64, most: usize| {
        let ends =
            contour.points.iter().fold([f64::MAX, 0.0], |[a, b], p| [smaller(a, at(p)), larger(b, at(p))]);
        let [first, last] = [(ends[0] - 0.5).max(0.0).ceil() as usize, (ends[1] - 0.5).max(0.0) as usize];
        [first, last.min(most - 1)]
    };
    let [left, right] = span(|p| p.x, gray.width());
    let [top, bottom] = span(|p| p.y, gray.height());
    let (mut sum, mut is_mixed) = (0.0, false);
    for y in top.saturating_sub(1)..(bottom + 2).min(gray.height()) {
        for x in left.saturating_sub(1)..(right + 2).min(gray.width()) {
            let rows = y.saturating_sub(1).max(top)..=(y + 1).min(bottom);
            let beside = |row: usize| {
                (x.saturating_sub(1).max(left)..=(x + 1).min(right)).any(|column| is_inside(column, row))
            };
            if rows.into_iter().any(beside) {
                sum += ink(x, y);
                is_mixed |= (ink(x, y) - 0.5).abs() < 0.5 - TONE;
            }
        }
    }
    if is_mixed { sum } else { 0.0 }
}
