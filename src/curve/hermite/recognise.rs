//! Recognition back: which segments are straight, which are arcs of an ellipse, which curves are ellipses.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use super::HermiteCurve;
use crate::curve::Segment;
use crate::generator::Space;
use crate::numerics::angle::sin_cos;
use crate::numerics::entire::stumpff;
use crate::numerics::{Point, Vector};

/// A long axis along y has the angle π/2, not −π/2, though its angle is rounded.
const SEAM: f64 = 1e-12;

/// An arc of an ellipse: centre + the rotated (rx·cos θ, ry·sin θ) for θ from `start` to `start + sweep`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct EllipseArc {
    /// The centre.
    pub center: Point,
    /// The half axes, the longer first; of a circle they may differ by a rounding, either way.
    pub radii: Vector,
    /// The angle of the first axis against the x axis, in (−π/2, π/2]; 0 for a circle.
    pub rotation: f64,
    /// Where it starts, in radians from the first axis, in (−π, π].
    pub start: f64,
    /// How far it runs, in radians; negative from the second axis towards the first.
    pub sweep: f64,
}

impl EllipseArc {
    /// The point at angle θ from the first axis.
    pub fn point(&self, angle: f64) -> Point {
        let (sin, cos) = sin_cos(angle);
        self.center + turned(Vector::new(self.radii.x * cos, self.radii.y * sin), self.rotation)
    }

    /// A bound of how far a point is from the whole ellipse.
    ///
    /// Straight to the centre, or along the shorter axis, whichever is less: of a thin ellipse roundings of the
    /// coordinates are long ways to the centre, of a round one next to its ends long ways along an axis.
    #[inline(never)]
    fn beside(&self, point: Point) -> f64 {
        // As it lies where the ellipse is the unit circle.
        let local = turned(point - self.center, -self.rotation).component_div(&self.radii);
        let x = local.x.clamp(-1.0, 1.0);
        let across = local - Vector::new(x, (1.0 - x * x).sqrt().copysign(local.y));
        let inwards = (local.norm() - 1.0).abs() * self.radii.x;
        across.component_mul(&self.radii).norm().min(inwards)
    }
}

fn turned(v: Vector, angle: f64) -> Vector {
    let (sin, cos) = sin_cos(angle);
    Vector::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
}

impl Segment<'_> {
    /// Whether the segment stays within `tolerance` of its chord.
    ///
    /// Proved, not sampled: the segment lies in the hull of its generalised Bézier points, and those are measured.
    pub fn as_line(&self, tolerance: f64) -> bool {
        let [first, second] = self.inner_offsets();
        self.beside(first) <= tolerance && self.beside(second) <= tolerance
    }

    /// A bound of the distance from the segment to its chord.
    pub(crate) fn bend(&self) -> f64 {
        let [first, second] = self.inner_offsets();
        self.beside(first).max(self.beside(second))
    }

    /// The inner generalised Bézier points, from the start.
    #[inline]
    fn inner_offsets(&self) -> [Vector; 2] {
        let reach = self.basis.kappa() * self.length;
        [self.leaving * reach, self.end - self.start - self.arriving * reach]
    }

    /// The distance of a point, given from the start, to the chord.
    #[inline(never)]
    fn beside(&self, offset: Vector) -> f64 {
        let chord = self.end - self.start;
        let square = chord.norm_squared();
        let along = if square > 0.0 { (offset.dot(&chord) / square).clamp(0.0, 1.0) } else { 0.0 };
        (offset - chord * along).norm()
    }

    /// The arc of an ellipse that the segment is, if it deviates from one by no more than `tolerance`.
    ///
    /// Exact arcs are recognised from the coefficients, in closed form: about its middle the segment is
    ///
    /// ```text
    /// r(s) = R + R′·s + R″·(1 − cos ωs)/ω² + R‴·(ωs − sin ωs)/ω³
    /// ```
    ///
    /// and its linear term R′ + R‴/ω² vanishes for arcs only (D 7.4). The deviation that setting it to zero causes is
    /// |R‴ + ω²R′|·(ωs − sin ωs)/ω³, largest at the ends, where it is measured.
    ///
    /// `None` for lines, for the other spaces, and where the ellipse is so large that coordinates on it round to
    /// more than the tolerance.
    pub fn as_ellipse_arc(&self, tolerance: f64) -> Option<EllipseArc> {
        let w = self.basis.frequency();
        if self.basis.space() != Space::Trigonometric || w == 0.0 {
            return None;
        }
        let Middle { center, p, q, deviation } = Middle::new(self, w);
        let arc = arc_about(center, p, q, w)?;
        let rounding = 4.0 * f64::EPSILON * (arc.radii.x + center.norm());
        (deviation <= tolerance && rounding <= tolerance).then_some(arc)
    }
}

/// The arc center + p·cos ωs + q·sin ωs about a segment's middle, s = 0, and how far the segment is from it.
struct Middle {
    center: Point,
    p: Vector,
    q: Vector,
    deviation: f64,
}

impl Middle {
    fn new(segment: &Segment, w: f64) -> Self {
        // In x = s/H, where the frequency is w.
        let middle = |order| segment.combine(&segment.basis.weights(0.5, order));
        let (first, second, third) = (middle(1), middle(2), middle(3));
        let square = w * w;
        let excess = (third + first * square).norm();
        let deviation = excess * stumpff(0.25 * square).c3 / 8.0;
        let p = -second / square;
        Self { center: segment.start + middle(0) - p, p, q: first / w, deviation }
    }
}

/// The arc center + p·cos θ + q·sin θ, θ from −w/2 to w/2, by its axes (D 7.5).
fn arc_about(center: Point, p: Vector, q: Vector, w: f64) -> Option<EllipseArc> {
    let (difference, mixed) = (p.norm_squared() - q.norm_squared(), 2.0 * p.dot(&q));
    let size = p.norm_squared() + q.norm_squared();
    let round = difference.abs().max(mixed.abs()) <= 1e-13 * size;
    let phase = if round { 0.0 } else { 0.5 * libm::atan2(mixed, difference) };
    let (sin, cos) = sin_cos(phase);
    let (major, minor) = (p * cos + q * sin, q * cos - p * sin);
    let radii = Vector::new(major.norm(), minor.norm());
    if radii.y.is_nan() || radii.y <= 1e-12 * radii.x {
        return None;
    }
    let sense = if major.perp(&minor) > 0.0 { 1.0 } else { -1.0 };
    let mut rotation = libm::atan2(major.y, major.x);
    let mut start = sense * (-0.5 * w - phase);
    if round {
        (start, rotation) = (start + rotation, 0.0);
    } else if rotation > FRAC_PI_2 + SEAM || rotation <= SEAM - FRAC_PI_2 {
        let half_turn = if rotation > 0.0 { PI } else { -PI };
        (start, rotation) = (start + half_turn, rotation - half_turn);
    }
    Some(EllipseArc { center, radii, rotation, start: centred(start), sweep: sense * w })
}

/// An angle between −3π and 3π without the turn that leads out of (−π, π].
#[inline(never)]
fn centred(angle: f64) -> f64 {
    if angle > PI {
        angle - TAU
    } else if angle <= -PI {
        angle + TAU
    } else {
        angle
    }
}

impl HermiteCurve {
    /// The one ellipse, or arc of it, that the whole curve is, if it deviates by no more than `tolerance`.
    ///
    /// A closed curve must run round exactly once, and every segment be an arc: lines, cubics and hyperbolic segments
    /// are none, however near an ellipse they run. Cost: O(M).
    pub fn as_ellipse(&self, tolerance: f64) -> Option<EllipseArc> {
        // The longest arc knows its ellipse best.
        let (mut longest, mut most) = (0, 0.0);
        for (i, segment) in self.segments().enumerate() {
            if segment.basis.frequency() > most {
                (longest, most) = (i, segment.basis.frequency());
            }
        }
        let ellipse = self.nth_segment(longest).as_ellipse_arc(tolerance)?;
        let (mut start, mut sweep) = (0.0, 0.0);
        for (i, segment) in self.segments().enumerate() {
            let arc = segment.as_ellipse_arc(tolerance)?;
            if i == longest {
                start = centred(ellipse.start - sweep);
            }
            sweep += arc.sweep;
            let mut within = arc.sweep * ellipse.sweep > 0.0;
            for x in [0.0, 0.25, 0.5, 0.75, 1.0] {
                within &= ellipse.beside(segment.position(x)) <= tolerance;
            }
            if !within {
                return None;
            }
        }
        let turns = sweep.abs() / TAU;
        if self.is_closed() && (turns - 1.0).abs() > 1e-9 || turns > 1.0 + 1e-9 {
            return None;
        }
        let sweep = if self.is_closed() { TAU.copysign(sweep) } else { sweep };
        Some(EllipseArc { start, sweep, ..ellipse })
    }
}
