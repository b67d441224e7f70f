//! How far a curve is from the contour that it follows.

use super::metrics::tolerant_jaccard;
use super::tracer::Metrics;
use crate::curve::HermiteCurve;
use crate::error::Result;
use crate::numerics::Point;
use crate::numerics::plane::{dot, norm, square};

/// How far ahead the nearest place is looked for, in pixels: contours and their curves run side by side.
const AHEAD: f64 = 4.0;
/// Chords of a curve are about this long, in pixels.
const CHORD: f64 = 0.75;

/// Compares a curve with a contour that turns the same way, both closed or both open, in pixels.
///
/// Both are walked side by side, so the time is that of one walk.
pub(super) fn agreement(curve: &HermiteCurve, contour: &[Point]) -> Result<Metrics> {
    let places = flattened(curve)?;
    let closed = curve.is_closed();
    let (there, back) = (Offs::of(contour, &places, closed), Offs::of(&places, contour, closed));
    let count = contour.len().max(1) as f64;
    let hausdorff = there.most.max(back.most);
    // Points that are no farther than a pixel are in neighbouring pixels.
    let share = if hausdorff <= 1.0 { 1.0 } else { tolerant_jaccard(pixels(contour), pixels(&places)) };
    Ok(Metrics { rmse: (there.square / count).sqrt(), mae: there.sum / count, hausdorff, jaccard: share })
}

/// The pixels of a closed polyline.
fn pixels(points: &[Point]) -> Vec<(i32, i32)> {
    let mut pixels = Vec::new();
    for (i, &from) in points.iter().enumerate() {
        let to = points[if i + 1 == points.len() { 0 } else { i + 1 }];
        let steps = (norm(to - from) / CHORD).ceil().clamp(1.0, 40_000.0) as usize;
        for step in 0..steps {
            let p = from + (to - from) * (step as f64 / steps as f64);
            pixels.push((p.x.floor() as i32, p.y.floor() as i32));
        }
    }
    pixels
}

/// Places along the curve, close enough that chords are as good as it.
fn flattened(curve: &HermiteCurve) -> Result<Vec<Point>> {
    let mut places = Vec::new();
    for i in 0..curve.segment_count() {
        let knots = curve.knots();
        let (first, last) = (knots[i], knots[i + 1]);
        let chord = norm(curve.evaluate(last, 0)? - curve.evaluate(first, 0)?);
        let middle = curve.evaluate(0.5 * (first + last), 0)?;
        let length = chord.max(norm(middle - curve.evaluate(first, 0)?) * 2.0);
        let steps = if curve.segment(i).as_line(1e-9) {
            1
        } else {
            (length / CHORD).ceil().clamp(4.0, 20_000.0) as usize
        };
        for step in 0..steps {
            places.push(curve.evaluate(first + (last - first) * step as f64 / steps as f64, 0)?);
        }
    }
    if !curve.is_closed() {
        places.push(curve.evaluate(curve.domain().1, 0)?);
    }
    Ok(places)
}

struct Offs {
    sum: f64,
    square: f64,
    most: f64,
}

impl Offs {
    /// The distances of points from a polyline that runs beside them.
    fn of(points: &[Point], polyline: &[Point], closed: bool) -> Self {
        let mut offs = Self { sum: 0.0, square: 0.0, most: 0.0 };
        let count = polyline.len();
        let Some(&first) = points.first() else { return offs };
        if count == 0 {
            return offs;
        }
        let next = |i: usize| if i + 1 == count { 0 } else { i + 1 };
        let off = |p: Point, i: usize| {
            let last = !closed && i + 1 == count;
            from_chord(p, polyline[i], polyline[if last { i } else { next(i) }])
        };
        let mut at =
            (0..count).fold(0, |best, i| if off(first, i).0 < off(first, best).0 { i } else { best });
        let mut last = first;
        for &p in points {
            // A contour is not much longer than a chord of its curve.
            let ahead = AHEAD + 2.0 * norm(p - last);
            last = p;
            let (mut best, share) = off(p, at);
            // What is left of this chord, and then chord by chord.
            let mut travelled = (1.0 - share) * norm(polyline[next(at)] - polyline[at]);
            let mut i = next(at);
            let start = at;
            while travelled < ahead + best.sqrt() && i != start {
                let (here, _) = off(p, i);
                if here < best {
                    (best, at) = (here, i);
                }
                travelled += norm(polyline[next(i)] - polyline[i]).max(1e-3);
                i = next(i);
            }
            offs.square += best;
            let distance = best.sqrt();
            offs.sum += distance;
            offs.most = offs.most.max(distance);
        }
        offs
    }
}

/// The squared distance of a point from a chord, and the share of the chord at which it is nearest.
fn from_chord(p: Point, from: Point, to: Point) -> (f64, f64) {
    let (way, off) = (to - from, p - from);
    let length = square(way);
    let share = if length > 0.0 { (dot(off, way) / length).clamp(0.0, 1.0) } else { 0.0 };
    (square(off - way * share), share)
}
