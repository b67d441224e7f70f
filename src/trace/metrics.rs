//! How far a curve is from the points and pixels that it was made from.

use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::Point;
use crate::numerics::order::{key_of, sort_by_keys, sort_in_place};
use crate::numerics::plane::{cross, norm};

/// How far a curve is from the contour that it follows, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Metrics {
    /// The root mean square distance of the contour's points.
    pub rmse: f64,
    /// Their mean distance.
    pub mae: f64,
    /// Their largest distance.
    pub max: f64,
    /// The largest distance between both, in both directions: more than `max` where a sharp corner stands beyond its
    /// contour, which pixels cut off.
    pub hausdorff: f64,
    /// The share of their pixels that are next to each other: see [`Jaccard::tolerant`].
    pub jaccard: f64,
}

/// The root of the mean square of some residuals; 0 for none, ∞ where their squares are beyond what doubles hold.
pub fn root_mean_square(residuals: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = residuals.fold((0.0, 0_usize), |(sum, count), r| (sum + r * r, count + 1));
    (sum / count.max(1) as f64).sqrt()
}

/// The mean of the absolute values of some residuals; 0 for none. It is at most [`root_mean_square`].
pub fn mean_absolute(residuals: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = residuals.fold((0.0, 0_usize), |(sum, count), r| (sum + r.abs(), count + 1));
    sum / count.max(1) as f64
}

/// The largest distance from a point of `from` to the nearest of `to`; 0 if one of them is empty.
///
/// Not symmetric: points of `to` that are far from all of `from` do not count.
///
/// # Cost
///
/// O((M + N) log N) for points along a curve: `to` is sorted by x, and the search stops where x alone is farther.
pub fn directed_hausdorff(from: &[Point], to: &[Point]) -> f64 {
    let mut sorted = to.to_vec();
    sort_by_keys(&mut sorted, &|p| [key_of(p.x), key_of(p.y)]);
    if sorted.is_empty() {
        return 0.0;
    }
    from.iter().fold(0.0, |most: f64, &point| most.max(nearest_distance(point, &sorted)))
}

/// The distance to the nearest of points that are sorted by x.
fn nearest_distance(point: Point, sorted: &[Point]) -> f64 {
    let middle = sorted.partition_point(|other| other.x < point.x);
    let mut best = f64::MAX;
    for other in &sorted[middle..] {
        if other.x - point.x >= best {
            break;
        }
        best = best.min(norm(other - point));
    }
    for other in sorted[..middle].iter().rev() {
        if point.x - other.x >= best {
            break;
        }
        best = best.min(norm(other - point));
    }
    best
}

/// The largest distance between two of the points: measured between corners of the convex hull.
///
/// # Cost
///
/// O(N log N), and the square of the number of the hull's corners.
pub fn diameter(points: &[Point]) -> f64 {
    let mut sorted = points.to_vec();
    sort_by_keys(&mut sorted, &|p| [key_of(p.x), key_of(p.y)]);
    let mut hull: Vec<Point> = Vec::new();
    // The lower side left to right, then the upper side back.
    for back in [false, true] {
        let start = hull.len();
        for i in 0..sorted.len() {
            let point = sorted[if back { sorted.len() - 1 - i } else { i }];
            while hull.len() >= start + 2 {
                let (last, before) = (hull[hull.len() - 1], hull[hull.len() - 2]);
                if cross(last - before, point - last) > 0.0 {
                    break;
                }
                hull.pop();
            }
            hull.push(point);
        }
    }
    let mut most = 0.0_f64;
    for (i, p) in hull.iter().enumerate() {
        most = hull[i..].iter().fold(most, |most, q| most.max(norm(q - p)));
    }
    most
}

/// The row of a pixel that is one number.
const ROW: u64 = u32::MAX as u64;
/// So many pixels of a box for each of a line in it, at most, are looked at.
const SPARSE: f64 = 256.0;

/// Two readings of the Jaccard index of a profile's pixels and a curve's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jaccard {
    /// Shared pixels over all pixels, a pixel counted as shared if the other side has one among its 8 neighbours or
    /// itself.
    pub tolerant: f64,
    /// Intersection over union of the profile and the curve's pixels with all their neighbours, as printed: a third at
    /// best for thin profiles.
    pub literal: f64,
}

/// Compares pixels of a profile with pixels of a curve, each given as (column, row).
///
/// # Cost
///
/// O(N log N).
///
/// # Source
///
/// \[RB21, section 4\]; the tolerant reading is (D 14.3).
pub fn jaccard(profile: &[(i32, i32)], curve: &[(i32, i32)]) -> Jaccard {
    let all = |pixels: &[(i32, i32)]| set(pixels.iter().copied().map(one_number).collect());
    let (profile, curve) = (all(profile), all(curve));
    let dilated = set(curve.iter().flat_map(|&pixel| neighbourhood(pixel)).collect());
    let shared = profile.iter().filter(|pixel| dilated.binary_search(pixel).is_ok()).count();
    Jaccard {
        tolerant: of_sets(&profile, &curve),
        literal: share(shared, profile.len() + dilated.len() - shared),
    }
}

/// A pixel as one number: in the order of columns, and of rows in each.
#[inline]
pub(super) fn one_number((column, row): (i32, i32)) -> u64 {
    let from_least = |at: i32| u64::from(at.abs_diff(i32::MIN));
    from_least(column) << 32 | from_least(row)
}

/// [`Jaccard::tolerant`] alone, of pixels that are one number each, in any order and more than once.
///
/// # Cost
///
/// O(N) where the pixels are a line's: marks on a sheet, a byte for each pixel of the box round them. Otherwise they
/// are sorted.
pub(super) fn tolerant_jaccard(profile: &[u64], curve: &[u64]) -> Result<f64> {
    let (mut least, mut most) = ([u64::MAX; 2], [0; 2]);
    for &pixel in profile.iter().chain(curve) {
        for (k, at) in [pixel >> 32, pixel & ROW].into_iter().enumerate() {
            (least[k], most[k]) = (least[k].min(at), most[k].max(at));
        }
    }
    // With a frame, so that every pixel has neighbours.
    let [columns, rows] = [0, 1].map(|k| most[k].saturating_sub(least[k]) + 3);
    if columns as f64 * rows as f64 > SPARSE * (profile.len() + curve.len()) as f64 + 1e4 {
        return Ok(of_sets(&set(profile.to_vec()), &set(curve.to_vec())));
    }
    let columns = columns as usize;
    let mut sheet = with_room(columns * rows as usize)?;
    sheet.resize(columns * rows as usize, 0_u8);
    let place = |pixel: u64| {
        let [column, row] = [(pixel >> 32) - least[0], (pixel & ROW) - least[1]];
        (row as usize + 1) * columns + column as usize + 1
    };
    profile.iter().for_each(|&pixel| sheet[place(pixel)] |= 1);
    curve.iter().for_each(|&pixel| sheet[place(pixel)] |= 2);
    // How many pixels there are, each counted once, and how many have one of the other side next to them.
    let mut count = |pixels: &[u64], own: u8, other: u8| {
        let (mut all, mut near) = (0, 0);
        for at in pixels.iter().map(|&pixel| place(pixel)) {
            if sheet[at] & own == 0 {
                continue;
            }
            sheet[at] ^= own | own << 2;
            all += 1;
            let around = |row: usize| (sheet[row - 1] | sheet[row] | sheet[row + 1]) & other != 0;
            near += usize::from([at, at - columns, at + columns].into_iter().any(around));
        }
        (all, near)
    };
    let (all, hit) = count(profile, 1, 2);
    let (others, near) = count(curve, 2, 4);
    Ok(share(hit, all + others - near))
}

fn of_sets(profile: &[u64], curve: &[u64]) -> f64 {
    let hit = profile.iter().filter(|&&pixel| near(curve, pixel)).count();
    let stray = curve.iter().filter(|&&pixel| !near(profile, pixel)).count();
    share(hit, profile.len() + stray)
}

fn share(part: usize, whole: usize) -> f64 {
    if whole == 0 { 1.0 } else { part as f64 / whole as f64 }
}

fn set(mut pixels: Vec<u64>) -> Vec<u64> {
    sort_in_place(&mut pixels);
    pixels.dedup();
    pixels
}

/// A pixel and those around it; beyond the last column or row there is none.
fn neighbourhood(pixel: u64) -> impl Iterator<Item = u64> {
    let near = |at: u64, step: u64| (at + step).saturating_sub(1).min(ROW);
    (0..9).map(move |i| near(pixel >> 32, i % 3) << 32 | near(pixel & ROW, i / 3))
}

fn near(sorted: &[u64], pixel: u64) -> bool {
    // Most have the same pixel on the other side.
    sorted.binary_search(&pixel).is_ok()
        || neighbourhood(pixel).any(|other| sorted.binary_search(&other).is_ok())
}

#[cfg(test)]
mod tests {
    use super::{jaccard, one_number, tolerant_jaccard};

    /// A walk by steps to neighbours that the multiples of an odd number choose; it meets itself.
    fn walk(start: (i32, i32), steps: u32, seed: u32) -> Vec<(i32, i32)> {
        let mut at = start;
        (1..=steps)
            .map(|i| {
                let lot = i.wrapping_mul(seed) >> 16;
                at = (at.0 + (lot % 3) as i32 - 1, at.1 + (lot / 3 % 3) as i32 - 1);
                at
            })
            .collect()
    }

    #[test]
    fn marks_on_a_sheet_count_what_sorted_pixels_count() {
        for (steps, seed, far) in
            [(0, 1, 0), (1, 1, 0), (40, 2_654_435_761, 1), (900, 40_503_117, 3), (900, 77_777_777, 4_000)]
        {
            let [first, second] =
                [walk((-2, 5), steps, seed), walk((far - 2, 5 - far), steps + 9, seed ^ 0x5555)];
            let numbers =
                |pixels: &[(i32, i32)]| pixels.iter().copied().map(one_number).collect::<Vec<u64>>();
            let found = tolerant_jaccard(&numbers(&first), &numbers(&second));
            let expected = jaccard(&first, &second).tolerant;
            assert!(
                found.as_ref().is_ok_and(|&share| share == expected),
                "{steps} steps: {found:?}, not {expected}"
            );
        }
    }
}
