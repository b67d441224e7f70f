//! From splines near unit size to what the caller sees, in the caller's units.

use super::knots::breaks::HIGHEST;
use super::knots::free_knots::Located;
use super::knots::spline::{Spline, derivative_of};
use super::outcome::{Fit, FitStatus, Joints, Knot, Part};
use super::outline::only;
use super::samples::Samples;
use crate::curve::HermiteCurve;
use crate::error::Result;
use crate::limits::{self, LARGEST_COORDINATE};
use crate::numerics::Vector;
use crate::numerics::enclosing_circle::enclosing_circle;

/// Most cubics that a piece of degree 4 or 5 becomes.
const MOST_CUTS: usize = 64;
/// How far, in units of the drawing, these cubics may be from it.
const CLOSE: f64 = 1e-9;
/// A distance of so many standard deviations is no noise.
const OUTLYING: f64 = 5.0;

/// Bytes that a piece and each of its cubics take on the way to what the caller sees: polynomials and knots; joints,
/// curve, part.
const PER_PIECE: usize = 250;
const PER_CUBIC: usize = 300;

/// Between inner and outer units.
pub(super) struct Frame<'a> {
    pub(super) samples: &'a Samples,
    pub(super) unit: f64,
    pub(super) noise: f64,
    /// Whether outliers are looked for.
    pub(super) robust: bool,
    /// The numbers that the samples have among the points that were fitted, where others were put between them; else
    /// empty.
    pub(super) own: &'a [u32],
    /// Whether one step towards the foot of every point will do: that overestimates distances a little.
    pub(super) hurried: bool,
}

/// The diameter of the smallest circle around the points, in the caller's unit: the same however they are turned.
pub(super) fn diameter(samples: &Samples) -> f64 {
    samples.scale * 2.0 * enclosing_circle(&samples.points).radius
}

/// The longer side of a box around some points.
pub(super) fn size_of(points: &[Vector]) -> f64 {
    let (low, high) = points.iter().fold((points[0], points[0]), |(low, high), p| (low.inf(p), high.sup(p)));
    (high - low).max()
}

/// What the coordinates of a curve are off by where it lies: joints are rounded as they are put there, and values
/// between them in products and sums of joints, two roundings of each coordinate in all. Points that repeat others are
/// where those are.
pub(super) fn rounding(samples: &Samples) -> f64 {
    const ROUNDINGS: f64 = 4.0;
    ROUNDINGS * f64::EPSILON * (samples.center.amax() + samples.scale) + samples.moved * samples.scale
}

/// (ℓ/2π)^(degree + 1).
pub(super) fn power(detail: f64, degree: usize) -> f64 {
    let turn = detail / core::f64::consts::TAU;
    (0..=degree).fold(1.0, |power, _| power * turn)
}

/// The sum of all weights.
pub(super) fn weight(located: &Located) -> f64 {
    if located.weights.is_empty() { located.points.len() as f64 } else { located.weights.iter().sum() }
}

/// The curve and its distances from the points; `squares` is their sum at the points' parameters where that is known,
/// and what only one of the ways to fit knows is left open.
pub(super) fn fit(
    frame: &Frame<'_>,
    spline: &Spline,
    located: &Located,
    squares: Option<f64>,
) -> Result<Fit> {
    let samples = frame.samples;
    let given;
    let located = if frame.robust || !frame.own.is_empty() {
        let own = if frame.own.is_empty() { located.copied()? } else { only(located, frame.own) };
        // What is far off was pulled near; the distances are those of the points as they came.
        given = Located { points: samples.points.clone(), ..own };
        &given
    } else {
        located
    };
    let breaks = &spline.space.breaks;
    let (cuts, deviation) = cuts(spline);
    limits::probe(breaks.pieces().saturating_mul(PER_PIECE + PER_CUBIC * cuts))?;
    let at_parameters = squares.unwrap_or_else(|| spline.squares(located));
    let mut feet = located.parameters.clone();
    let distances =
        if frame.hurried { spline.feet(located, &mut feet, 1) } else { spline.settle(located, &mut feet) };
    let mut joints = spline.joints(samples.center, samples.scale, frame.unit, cuts);
    let slip = joints.slip(breaks.end * frame.unit);
    let moved = joints.bound(distances.largest.max(CLOSE) * samples.scale)
        + joints.tell_apart(breaks.closed, breaks.end * frame.unit);
    let deviation = deviation * samples.scale + moved;
    let curve = joints.curve(breaks.closed, breaks.end * frame.unit)?;
    let (_, last) = curve.domain();
    let square = samples.scale * samples.scale;
    let total = weight(located);
    let shift = if breaks.closed { breaks.at.first().copied().unwrap_or(0.0) } else { 0.0 };
    let own = |t: f64| {
        let t = if t < shift { t - shift + breaks.end } else { t - shift };
        // The curve ends where its lengths add up to, an ulp before or after.
        (t * frame.unit).min(last)
    };
    let parameters = samples.place.iter().map(|&m| own(feet[m as usize])).collect();
    Ok(Fit {
        deviation,
        data_term: at_parameters * square,
        qfe: at_parameters * square / total,
        max_error: distances.largest * samples.scale + deviation + rounding(samples) + slip,
        rms: (distances.squares / total).sqrt() * samples.scale,
        outliers: outliers(frame, spline, located, feet),
        ..drawn(frame, curve, parameters)
    })
}

/// A curve that is off nowhere and of which no more is known.
fn drawn(frame: &Frame<'_>, curve: HermiteCurve, parameters: Vec<f64>) -> Fit {
    Fit {
        curve,
        deviation: 0.0,
        parts: Vec::new(),
        knots: Vec::new(),
        parameters,
        objective: f64::INFINITY,
        data_term: 0.0,
        regularizer: f64::INFINITY,
        gap: f64::INFINITY,
        qfe: 0.0,
        max_error: 0.0,
        rms: 0.0,
        iterations: 0,
        lambda: Vec::new(),
        smoothing: None,
        noise: frame.noise * frame.samples.scale,
        outliers: Vec::new(),
        status: FitStatus::Running,
        changes: Vec::new(),
    }
}

/// The points joined by lines, for points near the limit of coordinates. Its parameter runs four times as fast as their
/// number, so that its tangents keep within the limit too.
pub(super) fn polygon(frame: &Frame<'_>) -> Result<Fit> {
    const STEP: f64 = 4.0;
    let samples = frame.samples;
    let bounded = |v: f64| v.clamp(-LARGEST_COORDINATE, LARGEST_COORDINATE);
    let place = |p: &Vector| {
        let p = samples.center + p * samples.scale;
        Vector::new(bounded(p.x), bounded(p.y))
    };
    let points: Vec<Vector> = samples.points.iter().map(place).collect();
    let (count, closed) = (points.len(), samples.closed);
    let leaving = |m: usize| match (m + 1 < count, closed) {
        (true, _) => (points[m + 1] - points[m]) / STEP,
        (false, true) => (points[0] - points[m]) / STEP,
        (false, false) => (points[m] - points[m - 1]) / STEP,
    };
    let arriving = |m: usize| if m == 0 && !closed { leaving(0) } else { leaving((m + count - 1) % count) };
    let joints = Joints {
        at: (0..count).map(|m| m as f64 * STEP).collect(),
        points: points.clone(),
        arriving: (0..count).map(arriving).collect(),
        leaving: (0..count).map(leaving).collect(),
    };
    let curve = joints.curve(closed, count as f64 * STEP)?;
    let corner =
        |m: usize| Knot { t: m as f64 * STEP, point: points[m], degree: 1, jump: leaving(m) - arriving(m) };
    let inner = if closed { 0..count } else { 1..count - 1 };
    // Points are centred and scaled on the way: the last digit may change.
    let rounding = samples.scale * f64::EPSILON;
    let parameters = samples.place.iter().map(|&m| f64::from(m) * STEP).collect();
    Ok(Fit {
        knots: inner.map(corner).collect(),
        parts: vec![Part {
            degree: 1,
            curve: curve.clone(),
            coefficients: samples.points.iter().map(|p| p * samples.scale).collect(),
        }],
        max_error: rounding,
        status: FitStatus::Stalled,
        ..drawn(frame, curve, parameters)
    })
}

/// Given points whose distance is no noise.
fn outliers(frame: &Frame<'_>, spline: &Spline, located: &Located, feet: Vec<f64>) -> Vec<usize> {
    let limit = OUTLYING * frame.noise;
    if limit <= 0.0 || !frame.robust {
        return Vec::new();
    }
    let feet = Located { parameters: feet, ..located.clone() };
    let far: Vec<bool> = spline.distances(&feet).into_iter().map(|distance| distance > limit).collect();
    let place = &frame.samples.place;
    (0..place.len()).filter(|&m| far[place[m] as usize]).collect()
}

/// Into how many cubics every piece is to be cut, and what that leaves. (D 13.7)
fn cuts(spline: &Spline) -> (usize, f64) {
    if spline.space.breaks.degree <= 3 {
        return (1, 0.0);
    }
    let mut most = 0.0_f64;
    for s in 0..spline.space.spans.len() {
        for coefficients in [&spline.x, &spline.y] {
            let p = spline.space.piece(s, coefficients);
            most = most.max(24.0 * p[4].abs() + 120.0 * p[HIGHEST].abs());
        }
    }
    // Both coordinates: the length is at most √2 times the larger.
    let error = |cuts: usize| {
        let step = 2.0 / cuts as f64;
        step * step * step * step / 384.0 * most * core::f64::consts::SQRT_2
    };
    let mut cuts = 1;
    while cuts < MOST_CUTS && error(cuts) > CLOSE {
        cuts *= 2;
    }
    (cuts, error(cuts))
}

/// The knots of a spline that was searched for.
pub(super) fn knots(frame: &Frame<'_>, spline: &Spline) -> Vec<Knot> {
    let samples = frame.samples;
    let mut knots = spline.knots(samples.center, samples.scale);
    for knot in &mut knots {
        outwards(knot, frame.unit);
    }
    knots
}

/// The knots of one summand, placed on the whole curve.
pub(super) fn simple_knots(frame: &Frame<'_>, part: &Spline, whole: &Spline, shift: f64) -> Vec<Knot> {
    let samples = frame.samples;
    let mut knots = part.knots(Vector::zeros(), samples.scale);
    let (breaks, pieces, mut at) = (&part.space.breaks, whole.pieces(), 0);
    for (knot, &t) in knots.iter_mut().zip(&breaks.at) {
        knot.t = if t < shift { t - shift + breaks.end } else { t - shift };
        let (s, inner) = whole.space.find(t, at);
        at = s;
        let span = &whole.space.spans[s];
        let u = (inner - span.middle) / span.half;
        let place = derivative_of(&pieces[s], whole.space.breaks.degree, u, span.half, 0);
        knot.point = samples.center + place * samples.scale;
        outwards(knot, frame.unit);
    }
    knots
}

fn outwards(knot: &mut Knot, unit: f64) {
    knot.t *= unit;
    for _ in 0..knot.degree {
        knot.jump /= unit;
    }
}

/// A summand as a curve of its own, about a point.
pub(super) fn part(frame: &Frame<'_>, spline: &Spline, center: Vector) -> Result<Part> {
    let breaks = &spline.space.breaks;
    let (cuts, _) = cuts(spline);
    let mut joints = spline.joints(center, frame.samples.scale, frame.unit, cuts);
    joints.bound(CLOSE * frame.samples.scale);
    joints.tell_apart(breaks.closed, breaks.end * frame.unit);
    let curve = joints.curve(breaks.closed, breaks.end * frame.unit)?;
    Ok(Part { degree: breaks.degree, curve, coefficients: coefficients(frame, spline) })
}

/// The coefficients in the caller's unit, about the middle of the points.
pub(super) fn coefficients(frame: &Frame<'_>, spline: &Spline) -> Vec<Vector> {
    spline.x.iter().zip(&spline.y).map(|(&x, &y)| Vector::new(x, y) * frame.samples.scale).collect()
}
