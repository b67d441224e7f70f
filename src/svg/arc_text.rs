//! The numbers of an `A` command: chosen so that what a viewer draws from them is as close as their digits allow.
//!
//! A viewer finds the centre from the rounded end points and radii. For arcs near a half turn that is ill-conditioned:
//! a radius too large by δ moves the centre by √(2rδ). So the radii are not those of the ellipse but those of an
//! ellipse of the same shape that passes through the *rounded* ends with the same height over the chord; digits are
//! added, or radii rounded down (a viewer scales radii that are too small), until what would be drawn is
//! close; and it is measured.

use core::f64::consts::{FRAC_PI_4, PI};

use super::arc::{Arc, ArcCommand, cos_sin_degrees};
use super::text::{ArcText, DecimalGrid, Placed, Plain};
use crate::curve::{EllipseArc, HermiteCurve};
use crate::limits::LARGEST_COORDINATE;
use crate::numerics::angle::sin_cos;
use crate::numerics::plane::larger;
use crate::numerics::{Point, Vector};

/// Chords this close to the diameter may be taken for it.
const HALF_TURN_SLACK: f64 = 1e-13;
/// So much more than a half turn counts as one: what is drawn is measured.
const HALF_TURN_SUM: f64 = 1e-9;
/// Digits are added to radii and rotation up to this many.
const MOST_EXTRA_DIGITS: u32 = 7;

/// A part of a curve: from the place `from` in segment `first` to the place `to` in segment `last`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) first: usize,
    pub(super) from: f64,
    pub(super) last: usize,
    pub(super) to: f64,
}

impl Span {
    /// The part of segment `i` that belongs to it.
    fn part(self, i: usize) -> (f64, f64) {
        (if i == self.first { self.from } else { 0.0 }, if i == self.last { self.to } else { 1.0 })
    }

    fn end(self, curve: &HermiteCurve) -> Point {
        let segment = curve.nth_segment(self.last);
        if self.to == 1.0 { segment.end } else { segment.position(self.to) }
    }

    /// The angle that it covers, if it lies on an ellipse.
    pub(super) fn sweep(self, curve: &HermiteCurve) -> f64 {
        (self.first..=self.last).map(|i| self.sweep_of(curve, i)).sum()
    }

    /// The angle that its part of segment `i` covers.
    fn sweep_of(self, curve: &HermiteCurve, i: usize) -> f64 {
        let (from, to) = self.part(i);
        curve.nth_segment(i).basis.frequency() * (to - from)
    }

    /// Cut at the point of the curve next to its middle, or in the middle where there is none inside.
    pub(super) fn halves(self, curve: &HermiteCurve) -> [Self; 2] {
        if self.first == self.last {
            let middle = 0.5 * (self.from + self.to);
            return [Self { to: middle, ..self }, Self { from: middle, ..self }];
        }
        let whole = self.sweep(curve);
        let (mut last, mut sweep) = (self.first, self.sweep_of(curve, self.first));
        while last + 1 < self.last {
            let longer = sweep + self.sweep_of(curve, last + 1);
            if sweep + longer > whole {
                break;
            }
            (last, sweep) = (last + 1, longer);
        }
        [Self { last, to: 1.0, ..self }, Self { first: last + 1, from: 0.0, ..self }]
    }
}

/// An `A` command that was found good enough.
#[derive(Clone, Copy, Debug)]
pub(super) struct Planned {
    pub(super) text: ArcText,
    pub(super) to: Placed,
    /// A bound of the distance between the span and what is drawn.
    pub(super) deviation: f64,
}

/// The `A` command for a span of the curve that lies on `ellipse`, drawn from the point `from` on.
#[inline(never)]
pub(super) fn plan(
    curve: &HermiteCurve,
    ellipse: &EllipseArc,
    span: Span,
    from: Placed,
    grid: DecimalGrid,
    tolerance: f64,
) -> Option<Planned> {
    let end = span.end(curve);
    let to = grid.place(end);
    let chord = to.point() - from.point();
    if chord == Vector::zeros() {
        return None;
    }
    let rounded = (from.point() - curve.nth_segment(span.first).position(span.from))
        .norm()
        .max((to.point() - end).norm());
    let floor = 1e-13 * (ellipse.radii.x + ellipse.center.amax());
    let good = 1.5 * rounded + 0.75 * grid.unit() + floor;
    let shape = Shape::new(ellipse, span.sweep(curve), grid.unit());
    let mut best: Option<Planned> = None;
    // The ellipse's own radii first: where the ends have moved, those that reach over the chord are off by more than
    // the ends. What a radius is off by moves a quarter's centre 1.4 times as far: it has a digit more.
    let fitted = (0..=MOST_EXTRA_DIGITS).flat_map(|extra| [false, true].map(|down| (extra, down, true)));
    for (extra, down, over_chord) in core::iter::once((1, false, false)).chain(fitted) {
        if over_chord && extra > 0 && grid == DecimalGrid::EXACT {
            break;
        }
        let Some((text, command)) = shape.command(over_chord.then_some(chord), grid, extra, down) else {
            break;
        };
        let mut deviation = 1.02 * rounded;
        // A chord that is the diameter but for rounding is a half turn to some viewers, to others it moves the centre.
        for slack in [0.0, HALF_TURN_SLACK] {
            deviation = deviation.max(measure(curve, span, &Arc::new(from.point(), chord, &command, slack)));
        }
        if best.is_none_or(|best| deviation < best.deviation) {
            best = Some(Planned { text, to, deviation });
        }
        if deviation <= good {
            return best;
        }
    }
    // On a grid this fine, cubics are within the tolerance; on a coarser one they are no better than a good arc.
    let most = if 3.0 * grid.unit() <= tolerance { tolerance } else { tolerance.max(4.0 * good) };
    best.filter(|best| best.deviation <= most)
}

/// An ellipse's proportions and direction, and the arc wanted of it.
struct Shape {
    radii: Vector,
    degrees: f64,
    /// Of the arc over its chord, where the ellipse is the unit circle.
    height: f64,
    large: bool,
    positive: bool,
}

impl Shape {
    fn new(ellipse: &EllipseArc, sweep: f64, unit: f64) -> Self {
        let (mut radii, mut rotation) = (ellipse.radii, ellipse.rotation);
        if radii.x - radii.y <= 0.1 * unit {
            radii = Vector::repeat(0.5 * (radii.x + radii.y));
            rotation = 0.0;
        } else if rotation.abs() > FRAC_PI_4 {
            radii = radii.yx();
            rotation -= if rotation > 0.0 { 0.5 * PI } else { -0.5 * PI };
        }
        let quarter = sin_cos(0.25 * sweep).0;
        Self {
            radii,
            degrees: rotation * (180.0 / PI),
            height: 2.0 * quarter * quarter,
            // Of half a turn in very many parts the sum is a rounding more or less.
            large: sweep > PI + HALF_TURN_SUM,
            positive: ellipse.sweep > 0.0,
        }
    }

    /// The parameters with `extra` digits more than the grid has, and their text. The radii are those of which the arc
    /// over `chord` has the height wanted, or the ellipse's own.
    fn command(
        &self,
        chord: Option<Vector>,
        grid: DecimalGrid,
        extra: u32,
        down: bool,
    ) -> Option<(ArcText, ArcCommand)> {
        let rotation = match grid.decimals() {
            Some(decimals) => {
                Plain::nearest(self.degrees, fitting(decimals + extra + self.rotation_digits(), 360.0))
            }
            None => Plain::shortest(self.degrees),
        };
        let k = chord.map_or(1.0, |chord| {
            let (cos, sin) = cos_sin_degrees(rotation.value());
            let half = Vector::new(
                (chord.x * cos + chord.y * sin) / self.radii.x,
                (chord.y * cos - chord.x * sin) / self.radii.y,
            ) * 0.5;
            // Chord 2s and height h on a circle of radius k: k² = s² + (k − h)² (D 8.3).
            0.5 * (half.norm_squared() / self.height + self.height)
        });
        let radii = self.radii * k;
        if radii.amax().is_nan() || radii.amax() > LARGEST_COORDINATE {
            return None;
        }
        let mut numbers = [rotation; 3];
        for (number, &radius) in numbers.iter_mut().zip(radii.iter()) {
            *number = radius_text(radius, grid, extra, down);
        }
        let [rx, ry, _] = numbers;
        let radii = Vector::new(rx.value(), ry.value());
        let (large, positive) = (self.large, self.positive);
        let command = ArcCommand { radii, rotation: rotation.value(), large, positive };
        (radii.min() > 0.0).then_some((ArcText { numbers, large, positive }, command))
    }

    /// A degree moves the ends of the longer axis by (rx − ry)·π/180: that many digits more than lengths.
    fn rotation_digits(&self) -> u32 {
        let (mut moves, mut digits) = ((self.radii.x - self.radii.y).abs() * (PI / 180.0), 0);
        while moves > 1.0 {
            moves *= 0.1;
            digits += 1;
        }
        digits
    }
}

/// A radius with `extra` digits more than the grid has, rounded down if so wanted.
#[inline(never)]
fn radius_text(radius: f64, grid: DecimalGrid, extra: u32, down: bool) -> Plain {
    let number = match grid.decimals() {
        Some(decimals) => Plain::nearest(radius, fitting(decimals + extra, radius)),
        None => Plain::shortest(if down { radius * (1.0 - 8.0 * f64::EPSILON) } else { radius }),
    };
    if down && number.value() >= radius * (1.0 - 4.0 * f64::EPSILON) { number.less() } else { number }
}

/// As many of `decimals` as make 17 significant digits of numbers up to `largest`.
#[inline(never)]
fn fitting(decimals: u32, largest: f64) -> u32 {
    let (mut digits, mut rest) = (17, largest);
    while rest >= 1.0 && digits > 0 {
        rest *= 0.1;
        digits -= 1;
    }
    decimals.min(digits)
}

/// A bound of the distance between a span of the curve and an arc, both ways, measured along rays from the arc's
/// centre; infinite where the curve does not turn about it as the arc does: ends of a few units of the grid may be
/// rounded to ends between which the rest of the ellipse is drawn.
///
/// Between fixed ends the distance along rays is a bump over each segment, over longer arcs a trigonometric polynomial
/// of degree 2 in the angle: nine samples or more, every tenth of a radian, miss at most 1.6 % of its largest value; 2
/// % are added.
#[inline(never)]
fn measure(curve: &HermiteCurve, span: Span, arc: &Arc) -> f64 {
    let (uu, vv) = (arc.u.norm_squared(), arc.v.norm_squared());
    let (first, last) = (arc.point(arc.first), arc.point(arc.last));
    let mut apart = 0.0_f64;
    // Where the curve was seen last from the centre, in the unit circle, and how far the arc has turned there.
    let (mut seen, mut turned) = (arc.first, 0.0);
    for i in span.first..=span.last {
        let segment = curve.nth_segment(i);
        let (from, to) = span.part(i);
        let count = (segment.basis.frequency() * (to - from) * 10.0) as u32 + 8;
        for k in 0..=count {
            let place = segment.position(from + (to - from) * (f64::from(k) / f64::from(count)));
            let p = place - arc.center;
            let e = Vector::new(p.dot(&arc.u) / uu, p.dot(&arc.v) / vv);
            let norm = e.norm();
            let e = e / norm;
            if norm == 0.0 || seen.dot(&e) < 0.5 {
                return f64::INFINITY;
            }
            let step = seen.perp(&e);
            turned += (step + step * step * step / 6.0) * arc.sweep.signum();
            let away = if turned < 0.0 {
                (place - first).norm()
            } else if turned > arc.sweep.abs() {
                (place - last).norm()
            } else {
                p.norm() * (1.0 - 1.0 / norm).abs()
            };
            apart = apart.max(away);
            if k == 0 && i == span.first && turned > 0.0 {
                apart = apart.max(farthest(arc, arc.first, e, place));
            }
            seen = e;
        }
    }
    let end = span.end(curve);
    let rest = arc.sweep.abs() - turned;
    if rest.abs() > 0.5 * PI {
        return f64::INFINITY;
    }
    if rest > 0.0 {
        apart = apart.max(farthest(arc, seen, arc.last, end));
    }
    1.02 * apart
}

/// How far a place is from that part of an arc which lies between two directions, less than half a turn apart.
#[inline(never)]
fn farthest(arc: &Arc, from: Vector, to: Vector, place: Point) -> f64 {
    let mut far = 0.0;
    for k in 0..=8 {
        let e = from + (to - from) * (0.125 * f64::from(k));
        far = larger(far, (arc.point(e / e.norm()) - place).norm());
    }
    far
}
