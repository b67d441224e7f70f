//! Contours of pixels that are ink or paper and nothing between.

use super::gray::Gray;
use super::tones::Tones;
use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::Point;

/// How far a pixel may be from its tone, as a share of the way from ink to paper.
const NEAR: f64 = 0.02;
/// So many steps by one pixel to one side, and back into the old direction, tell an edge that runs aslant from squares.
const STEPS: usize = 2;
/// A contour of fewer sides of pixels is what its pixels are.
const FEWEST: usize = 28;
/// So is one with more than half of its sides beside ink or paper one pixel wide; of fewer sides than this, one in
/// sixteen: glyphs are drawn so.
const SMALL: usize = 48;
/// Among outlines that run aslant, each of as many sides at least, small ones are parts of the same drawing rather than
/// glyphs.
const LARGE: usize = 2 * SMALL;

/// A contour as the middles of pixels' sides, if all pixels beside it have one of the two tones.
///
/// # Cost
///
/// O(points); where edges have shades between, most often the first point says so.
///
/// # Errors
///
/// `OutOfMemory` only.
pub(in crate::trace) fn steps(contour: &[Point], gray: &Gray, tones: &Tones) -> Result<Option<Vec<Point>>> {
    let near = NEAR * (tones.paper - tones.ink);
    let is_tone = |column: f64, row: f64| {
        if column < 0.0 || row < 0.0 || column >= gray.width() as f64 || row >= gray.height() as f64 {
            return true;
        }
        let shade = gray.shade(column as usize, row as usize);
        (shade - tones.ink).abs() <= near || (shade - tones.paper).abs() <= near
    };
    let middle = |p: &Point| {
        // One coordinate is that of the centres of two pixels.
        let (x, y) = (p.x.floor(), p.y.floor());
        let (beside, above) = (p.y - y == 0.5, p.x - x == 0.5);
        let (column, row) = ((p.x - 0.5).floor(), (p.y - 0.5).floor());
        if above && !beside {
            (is_tone(x, row) && is_tone(x, row + 1.0)).then(|| Point::new(p.x, row + 1.0))
        } else if beside && !above {
            (is_tone(column, y) && is_tone(column + 1.0, y)).then(|| Point::new(column + 1.0, p.y))
        } else {
            None
        }
    };
    let mut middles = with_room(contour.len())?;
    for point in contour {
        let Some(middle) = middle(point) else { return Ok(None) };
        middles.push(middle);
    }
    Ok(Some(middles))
}

/// Whether contours together are a drawing of edges that run aslant: most of their sides are those of large ones that
/// do.
pub(in crate::trace) fn is_mostly_sampled(contours: impl Iterator<Item = (usize, bool)>) -> bool {
    let (mut large, mut all) = (0, 0);
    for (sides, sampled) in contours {
        all += sides;
        large += if sampled && sides >= LARGE { sides } else { 0 };
    }
    2 * large > all
}

/// Whether such a contour is that of a shape whose edges run aslant, rather than of squares. `among` such shapes a
/// small one rather is.
///
/// # Cost
///
/// O(points).
pub(in crate::trace) fn is_sampled(steps: &[Point], gray: &Gray, level: f64, among: bool) -> bool {
    let count = steps.len();
    let is_dark = |x: f64, y: f64| {
        // Beyond the border all is as it is there.
        let inside = |v: f64, most: usize| (v.max(0.0) as usize).min(most - 1);
        gray.shade(inside(x, gray.width()), inside(y, gray.height())) < level
    };
    let (mut single, mut thin) = (0, 0);
    let mut before = steps[0] - steps[count - 1];
    for (i, &here) in steps.iter().enumerate() {
        let after = steps[if i + 1 == count { 0 } else { i + 1 }] - here;
        single += usize::from(after == before && after.x != 0.0 && after.y != 0.0);
        let (x, y) = if here.x == here.x.floor() { (1.0, 0.0) } else { (0.0, 1.0) };
        let at = |d: f64| is_dark(here.x + d * x, here.y + d * y);
        thin += usize::from(at(-1.5) != at(-0.5) || at(1.5) != at(0.5));
        before = after;
    }
    let most = if count < SMALL && !among { count / 16 } else { count / 2 };
    single >= STEPS && count >= FEWEST && thin <= most
}
