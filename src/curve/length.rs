//! Arc length, and the parameter at a length.

use super::HermiteCurve;
use super::limits::{MOST_OUTPUT_POINTS, too_many, with_room};
use super::piece::{Jet, Piece, panels};
use crate::error::{Error, Result};
use crate::numerics::Vector;
use crate::numerics::entire::stumpff;
use crate::numerics::quadrature::{EIGHT, FOUR, Rule, SIX, SIXTEEN, TWELVE, TWENTY_FOUR};
use crate::numerics::roots::bracketed_root;

/// Lengths are computed to this share of the curve's size at best: rounding makes more digits meaningless.
const ROUNDING: f64 = 1e-14;
/// Halvings of a segment after which what is left counts as nothing.
const MOST_HALVINGS: u32 = 60;

impl HermiteCurve {
    /// The length of the curve.
    ///
    /// Gauss–Legendre sums of the speed, with as many nodes as the proved bound of their error asks for:
    ///
    /// ```text
    /// |∫ − sum of n nodes| ≤ (64/15)·M·ρ⁻²ⁿ/(1 − ρ⁻²)
    /// ```
    ///
    /// where ρ is the sum of the half-axes of the largest ellipse around the interval in which the speed is analytic,
    /// and M its largest modulus there [Trefethen, thm 19.3]. The speed is singular only where x′ ± iy′ vanishes, which is at the
    /// two roots of a quadratic for every segment in every space, so ρ is known exactly. Where a cusp or near-cusp
    /// leaves no room the interval is halved.
    ///
    /// # Accuracy
    ///
    /// `tolerance`, absolute, but not below 1e-14 of the size of the curve.
    ///
    /// # Errors
    ///
    /// `tolerance` not finite, or not positive.
    ///
    /// # Cost
    ///
    /// 4 to 24 speeds per segment, about a thousand at a cusp. No allocation.
    pub fn length(&self, tolerance: f64) -> Result<f64> {
        check_tolerance(tolerance)?;
        let share = self.length_share(tolerance);
        Ok(self.segments().map(|segment| piece_length(&Piece::new(&segment), -0.5, 0.5, share)).sum())
    }

    /// The parameter at which the curve has the length `length` behind it.
    ///
    /// # Accuracy
    ///
    /// The length up to the parameter that is returned is within `tolerance` of `length`, as for [`Self::length`].
    ///
    /// # Errors
    ///
    /// `tolerance` not finite or not positive, `length` not finite, negative or beyond the length of the curve.
    pub fn parameter_at_length(&self, length: f64, tolerance: f64) -> Result<f64> {
        check_tolerance(tolerance)?;
        if !length.is_finite() {
            return Err(Error::NotFinite { argument: "length", index: None });
        }
        let share = self.length_share(tolerance);
        let mut before = 0.0;
        for (i, segment) in self.segments().enumerate() {
            let piece = Piece::new(&segment);
            let whole = piece_length(&piece, -0.5, 0.5, share);
            if length >= 0.0 && length <= before + whole {
                let y = parameter_on_piece(&piece, length - before, whole, share);
                return Ok((self.knots()[i] + (y + 0.5) * segment.length).min(self.knots()[i + 1]));
            }
            before += whole;
        }
        if length > before && length <= before + tolerance.min(ROUNDING * before) {
            return Ok(self.domain().1);
        }
        Err(Error::OutOfRange { argument: "length", index: None, value: length, least: 0.0, most: before })
    }

    /// The parameters of `count` points that are equally far apart along the curve.
    ///
    /// An open curve gets both ends; a closed one starts at t = 0 and the last point is one step before it.
    ///
    /// # Accuracy
    ///
    /// Every point is within `tolerance` of its place along the curve.
    ///
    /// # Errors
    ///
    /// `tolerance` not finite or not positive; more than 4 000 000 points.
    pub fn sample_by_length(&self, count: usize, tolerance: f64) -> Result<Vec<f64>> {
        check_tolerance(tolerance)?;
        if count > MOST_OUTPUT_POINTS {
            return Err(too_many("count", "maxOutputPoints", MOST_OUTPUT_POINTS, count));
        }
        let share = self.length_share(tolerance);
        let mut lengths = with_room(self.segment_count())?;
        lengths.extend(self.segments().map(|segment| piece_length(&Piece::new(&segment), -0.5, 0.5, share)));
        let total: f64 = lengths.iter().sum();
        let steps = if self.is_closed() { count } else { count.saturating_sub(1) };
        let mut parameters = with_room(count)?;
        let (mut i, mut before) = (0, 0.0);
        for k in 0..count {
            let target = if k == 0 { 0.0 } else { total * (k as f64 / steps as f64) };
            while i + 1 < lengths.len() && target > before + lengths[i] {
                before += lengths[i];
                i += 1;
            }
            let segment = self.segment(i);
            let y = parameter_on_piece(&Piece::new(&segment), target - before, lengths[i], share);
            parameters.push((self.knots()[i] + (y + 0.5) * segment.length).min(self.knots()[i + 1]));
        }
        Ok(parameters)
    }

    /// What each segment may contribute to the error of the length.
    fn length_share(&self, tolerance: f64) -> f64 {
        let mut size: f64 = 0.0;
        for segment in self.segments() {
            let chord = segment.end - segment.start;
            size = size
                .max(chord.x.abs() + chord.y.abs())
                .max((segment.leaving.x.abs() + segment.leaving.y.abs()) * segment.length);
        }
        tolerance.max(ROUNDING * size).max(f64::MIN_POSITIVE) / self.segment_count() as f64
    }
}

/// An error where a tolerance is not a positive number.
pub(crate) fn check_tolerance(tolerance: f64) -> Result<()> {
    if !tolerance.is_finite() {
        return Err(Error::NotFinite { argument: "tolerance", index: None });
    }
    if tolerance <= 0.0 {
        let (value, least, most) = (tolerance, f64::MIN_POSITIVE, f64::MAX);
        return Err(Error::OutOfRange { argument: "tolerance", index: None, value, least, most });
    }
    Ok(())
}

/// The length of a piece between two parameters, within `tolerance`.
pub(crate) fn piece_length(piece: &Piece, lo: f64, hi: f64, tolerance: f64) -> f64 {
    if !piece.is_decaying() {
        return interval_length(piece, lo, hi, tolerance);
    }
    let mut total = 0.0;
    panels(piece, |from, to| {
        let (from, to) = (from.max(lo), to.min(hi));
        if from < to {
            total += interval_length(piece, from, to, tolerance / 24.0);
        }
    });
    total
}

fn interval_length(piece: &Piece, lo: f64, hi: f64, tolerance: f64) -> f64 {
    let mut total = 0.0;
    let mut stack = [(0.0, 0.0); MOST_HALVINGS as usize + 1];
    stack[0] = (lo, hi);
    let mut open = 1;
    let width = hi - lo;
    // Half of the tolerance is shared by width, half is kept for the intervals that close in on cusps.
    let (density, speck) = (0.5 * tolerance / width.max(f64::MIN_POSITIVE), tolerance / 16.0);
    while open > 0 {
        open -= 1;
        let (lo, hi) = stack[open];
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let jet = piece.jet(middle);
        let rule = if piece.is_straight_on(lo, hi) {
            Some(&FOUR as &Rule)
        } else {
            rule_for(&jet, piece.rate(), half, density * (hi - lo), speck)
        };
        match rule {
            None if open + 2 <= stack.len() && middle > lo && middle < hi => {
                stack[open] = (middle, hi);
                stack[open + 1] = (lo, middle);
                open += 2;
            }
            rule => total += half * speed_sum(piece, &jet, half, middle, rule.unwrap_or(&EIGHT)),
        }
    }
    total
}

/// Σ wᵢ|r′(middle + half·xᵢ)|.
#[inline]
fn speed_sum(piece: &Piece, jet: &Jet, half: f64, middle: f64, rule: &Rule) -> f64 {
    let mut sum = 0.0;
    if piece.is_cubic() {
        let (first, second, third) = (jet.first, jet.second * half, jet.third * (0.5 * half * half));
        for &(x, weight) in rule {
            let even = first + third * (x * x);
            let odd = second * x;
            sum += weight * ((even + odd).norm() + (even - odd).norm());
        }
        return sum;
    }
    for &(x, weight) in rule {
        let step = half * x;
        sum += weight * (piece.jet(middle + step).first.norm() + piece.jet(middle - step).first.norm());
    }
    sum
}

/// The smallest rule whose proved error on [−half, half] about the jet is at most `tolerance`; none where the
/// interval must be halved.
fn rule_for(jet: &Jet, rate: f64, half: f64, tolerance: f64, speck: f64) -> Option<&'static Rule> {
    let (b, p, q) = (jet.first, jet.second, jet.third);
    let axis = half_axis(b, p, q, rate, half).min(8.0);
    let reach = axis * half;
    let growth = if rate == 0.0 { 1.0 } else { stumpff(-(rate.abs() * reach * reach).min(490_000.0)).c0 };
    let largest = taxi(b) + growth * reach * (taxi(p) + 0.5 * reach * taxi(q));
    if 2.0 * half * largest <= speck {
        return Some(&EIGHT);
    }
    let rho = axis + (axis * axis - 1.0).max(0.0).sqrt();
    let square = rho * rho;
    let needed = (64.0 / 15.0) * largest * half * square / ((square - 1.0) * tolerance);
    let fourth = square * square;
    let eighth = fourth * fourth;
    let sixteenth = eighth * eighth;
    // A rule with n nodes is good for ρ²ⁿ.
    if eighth >= needed {
        Some(&FOUR)
    } else if eighth * fourth >= needed {
        Some(&SIX)
    } else if sixteenth >= needed {
        Some(&EIGHT)
    } else if sixteenth * eighth >= needed {
        Some(&TWELVE)
    } else if sixteenth * sixteenth >= needed {
        Some(&SIXTEEN)
    } else if sixteenth * sixteenth * sixteenth >= needed {
        Some(&TWENTY_FOUR)
    } else {
        None
    }
}

/// |x| + |y|, at least the length.
#[inline]
fn taxi(v: Vector) -> f64 {
    v.x.abs() + v.y.abs()
}

/// The larger half-axis, in units of `half`, of the largest ellipse with foci ±half in which the speed is analytic.
///
/// With z = x + iy and τ = tan(wu/2)/(w/2), z′ = b + p·sin(wu)/w + q·(1 − cos wu)/w² is zero where
/// (q/2 + w²b/4)τ² + pτ + b = 0; the conjugate's zeros lie in the mirror.
#[inline]
fn half_axis(b: Vector, p: Vector, q: Vector, rate: f64, half: f64) -> f64 {
    let lead = (q * 0.5 + b * (0.25 * rate)) * half;
    let b_over = b / half;
    let discriminant = product(p, p) - product(lead, b_over) * 4.0;
    let mut root = square_root(discriminant);
    if root.dot(&p) < 0.0 {
        root = -root;
    }
    // In units of half: τ = s/lead and b/s.
    let s = (p + root) * -0.5;
    if rate == 0.0 {
        return focal(s, lead).min(focal(b_over, s));
    }
    let w = rate.abs().sqrt();
    focal_of(preimage(s, lead, rate, w * half)).min(focal_of(preimage(b_over, s, rate, w * half)))
}

/// (|z − 1| + |z + 1|)/2 for z = numerator/denominator.
#[inline]
fn focal(numerator: Vector, denominator: Vector) -> f64 {
    let scale = denominator.norm_squared();
    let ends = (numerator - denominator).norm_squared();
    let other = (numerator + denominator).norm_squared();
    let sum = 0.5 * ((ends / scale).sqrt() + (other / scale).sqrt());
    // 0/0 happens where everything is zero: no speed, no singularity that matters.
    if sum >= 1.0 { sum } else { far_or_touching(sum) }
}

fn far_or_touching(sum: f64) -> f64 {
    if sum.is_nan() { f64::INFINITY } else { 1.0 }
}

fn focal_of(z: Vector) -> f64 {
    let one = Vector::new(1.0, 0.0);
    let sum = 0.5 * ((z - one).norm() + (z + one).norm());
    if sum >= 1.0 { sum } else { far_or_touching(sum) }
}

/// u in units of `half` with tan(wu/2)/(w/2) = half·numerator/denominator; `reach` is w·half.
fn preimage(numerator: Vector, denominator: Vector, rate: f64, reach: f64) -> Vector {
    // tan v = ζ: v = (1/2i)·log((1 + iζ)/(1 − iζ)); tanh v = ζ: v = (1/2)·log((1 + ζ)/(1 − ζ)).
    let zeta = numerator * (0.5 * reach);
    let turned = if rate > 0.0 { Vector::new(-zeta.y, zeta.x) } else { zeta };
    let (above, below) = (denominator + turned, denominator - turned);
    let quotient = product(above, Vector::new(below.x, -below.y));
    // Beyond 34 the logarithm is of a rounding: the singularity is at least that far away.
    let size = 0.5 * libm::log(above.norm_squared() / below.norm_squared());
    let log = Vector::new(size.clamp(-34.0, 34.0), libm::atan2(quotient.y, quotient.x)) / reach;
    if rate > 0.0 { Vector::new(log.y, -log.x) } else { log }
}

/// The product of two complex numbers.
#[inline]
fn product(u: Vector, v: Vector) -> Vector {
    Vector::new(u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x)
}

/// A complex square root.
#[inline]
fn square_root(z: Vector) -> Vector {
    let size = (0.5 * (z.norm() + z.x.abs())).sqrt();
    let other = if size > 0.0 { 0.5 * z.y / size } else { 0.0 };
    if z.x >= 0.0 { Vector::new(size, other) } else { Vector::new(other, size) }
}

/// The y at which a piece of length `whole` has `length` behind it.
fn parameter_on_piece(piece: &Piece, length: f64, whole: f64, tolerance: f64) -> f64 {
    if length <= 0.0 {
        return -0.5;
    }
    if length >= whole {
        return 0.5;
    }
    let guess = length / whole - 0.5;
    bracketed_root(-0.5, 0.5, true, guess, |y| {
        let gap = piece_length(piece, -0.5, y, tolerance) - length;
        (if gap.abs() <= 0.5 * tolerance { 0.0 } else { gap }, piece.jet(y).first.norm())
    })
}
