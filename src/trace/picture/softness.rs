//! How soft a picture's edges are: what a pixel shows beyond the share of it that is covered.

use super::gray::Gray;
use super::tones::Tones;
use crate::numerics::Point;
use crate::numerics::order::nth;
use crate::numerics::plane::{larger, smaller};

/// As many places along all contours are looked at, about.
const PLACES: usize = 2048;
/// Fewer than this are the tips and crumbs of a drawing.
const FEWEST: usize = 16;
/// Pixels from a contour to where its edge ends.
const REACH: isize = 12;
/// What changes by less does not change.
const SHADE: f64 = 1.0 / 255.0;

/// The deviation of the Gaussian that blurred exact coverage, in pixels, by the edge in the middle of all along some
/// contours.
///
/// With c the coverage across an edge, ∫ c (1 − c) is half the mean distance of two numbers by lot from what one pixel
/// gathers: σ/√π for a Gaussian, and for the square of a pixel, at any angle, nearly what a Gaussian of the same
/// variance has, 1/12. So their variances add up.
///
/// # Cost
///
/// O(1) for each of some thousand places.
pub(in crate::trace) fn softness<'a>(
    contours: impl Iterator<Item = &'a [Point]> + Clone,
    gray: &Gray,
    tones: &Tones,
) -> f64 {
    let total: usize = contours.clone().map(<[Point]>::len).sum();
    let places = contours.flatten().step_by(total.div_ceil(PLACES).max(1));
    let mut widths: Vec<f64> = places.filter_map(|place| width(place, gray, tones)).collect();
    if widths.len() < FEWEST {
        return 0.0;
    }
    let half = widths.len() / 2;
    let gathered = nth(&mut widths, half);
    (core::f64::consts::PI * gathered * gathered - 1.0 / 12.0).max(0.0).sqrt()
}

/// The coverage that a pixel shows, if it is in the picture.
#[inline(never)]
fn cover(gray: &Gray, tones: &Tones, x: isize, y: isize) -> Option<f64> {
    let inside = (0..gray.width() as isize).contains(&x) && (0..gray.height() as isize).contains(&y);
    inside.then(|| (tones.paper - gray.shade(x as usize, y as usize)) / (tones.paper - tones.ink))
}

/// ∫ c (1 − c) across the edge at a place of a contour, which lies between the centres of two pixels of a row or a
/// column. c is 0 at one end of the edge's way and 1 at the other, whether it reaches both tones or not.
fn width(place: &Point, gray: &Gray, tones: &Tones) -> Option<f64> {
    let cover = |x: isize, y: isize| cover(gray, tones, x, y);
    let (x, y) = ((place.x - 0.5).floor() as isize, (place.y - 0.5).floor() as isize);
    let slope = |dx: isize, dy: isize| Some(cover(x + dx, y + dy)? - cover(x - dx, y - dy)?);
    let (right, down) = (slope(1, 0)?, slope(0, 1)?);
    let (dx, dy) = if right.abs() > down.abs() { (1, 0) } else { (0, 1) };
    // A row or column crosses more of an edge that runs aslant than a line straight across it.
    let steepest = (right * right + down * down).sqrt();
    if steepest == 0.0 {
        return None;
    }
    let share = larger(right.abs(), down.abs()) / steepest;
    let here = cover(x, y)?;
    let (mut least, mut most) = (here, here);
    let [mut count, mut sum, mut squares] = [1.0, here, here * here];
    for side in [-1, 1] {
        let (mut before, mut way) = (here, 0.0);
        for k in 1..=REACH {
            let value = cover(x + side * k * dx, y + side * k * dy)?;
            let step = value - before;
            // Beyond its end an edge comes back, or nothing changes.
            if step * way < 0.0 || step.abs() < SHADE {
                break;
            }
            way += step;
            before = value;
            (least, most) = (smaller(least, value), larger(most, value));
            (count, sum, squares) = (count + 1.0, sum + value, squares + value * value);
        }
    }
    // Thin things have another edge before this one reaches the tone: its way ends where that begins.
    let way = most - least;
    (way > SHADE).then(|| share * ((least + most) * sum - squares - count * least * most) / (way * way))
}

#[cfg(test)]
mod tests {
    use super::softness;
    use crate::error::Result;
    use crate::trace::Gray;
    use crate::trace::picture::contour::contours;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    const SIDE: usize = 48;

    /// What is measured of a half-plane whose edge runs at an angle; samples of a pixel are moved across it by a
    /// Gaussian of some deviation.
    fn of_edge(angle: f64, sigma: f64) -> Result<f64> {
        let (sin, cos) = angle.sin_cos();
        let mut bytes = Vec::new();
        for pixel in 0..SIDE * SIDE {
            let (mut sum, mut total) = (0.0, 0.0);
            for k in 0..64 {
                let x = (pixel % SIDE) as f64 + ((k % 8) as f64 + 0.5) / 8.0 - 24.3;
                let y = (pixel / SIDE) as f64 + ((k / 8) as f64 + 0.5) / 8.0 - 23.8;
                for step in -20..=20 {
                    let (off, weight) = (f64::from(step) / 5.0, (-f64::from(step * step) / 50.0).exp());
                    total += weight;
                    sum += if x * cos + y * sin + sigma * off > 0.0 { weight } else { 0.0 };
                }
            }
            bytes.push((255.0 * sum / total).round() as u8);
        }
        let gray = Gray::from_bytes(SIDE, SIDE, &bytes)?;
        let tones = gray.tones();
        let found = contours(&gray, tones.middle(), false, 2.0)?;
        // The picture's border is no edge of it.
        let beside = |v: f64| v > 6.0 && v < SIDE as f64 - 6.0;
        let inner: Vec<_> =
            found.iter().flat_map(|c| &c.points).filter(|p| beside(p.x) && beside(p.y)).copied().collect();
        Ok(softness([inner.as_slice()].into_iter(), &gray, &tones))
    }

    #[test]
    fn the_blur_of_an_edge_is_found_at_every_angle() -> Result<()> {
        for angle in [0.1, 0.4, 0.7, 1.2, 2.0, 3.0] {
            for sigma in [0.75, 1.0, 1.5, 2.0] {
                let found = of_edge(angle, sigma)?;
                // What a pixel's square gathers is that of a Gaussian to a few hundredths.
                assert!((found / sigma - 1.0).abs() < 0.06, "{found} for {sigma} at {angle}");
            }
        }
        Ok(())
    }

    #[test]
    fn edges_of_exact_coverage_are_not_soft() -> Result<()> {
        for angle in [0.1, 0.3, 0.4, 0.6, 0.785, 1.2, 2.0, 3.0] {
            let found = of_edge(angle, 0.0)?;
            assert!(found < 0.3, "{found} at {angle}");
        }
        Ok(())
    }

    #[test]
    fn lines_one_pixel_wide_have_no_edge_that_ends() -> Result<()> {
        let bytes: Vec<u8> = (0..SIDE * SIDE).map(|i| if i % SIDE == 20 { 0 } else { 255 }).collect();
        let gray = Gray::from_bytes(SIDE, SIDE, &bytes)?;
        let tones = gray.tones();
        let found = contours(&gray, tones.middle(), false, 2.0)?;
        let softness = softness(found.iter().map(|c| c.points.as_slice()), &gray, &tones);
        assert!(softness < 0.3, "{softness}");
        Ok(())
    }
}
