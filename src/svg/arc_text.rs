//! The numbers of an `A` command: chosen so that what a viewer draws from them is as close as their digits allow.
//!
//! A viewer finds the centre from the rounded end points and radii. For arcs near a half turn that is ill-conditioned:
//! a radius too large by δ moves the centre by √(2rδ). So the radii are not those of the ellipse but those of an
//! ellipse of the same shape that passes through the *rounded* ends with the same height over the chord; digits are
//! added, or radii rounded down (a viewer scales radii that are too small), until what would be drawn is
//! close; and it is measured.

use core::f64::consts::{FRAC_PI_4, PI, TAU};

use super::arc::{Arc, ArcCommand, cos_sin_degrees};
use super::text::{ArcText, Grid, Placed, Plain};
use crate::curve::{EllipseArc, HermiteCurve};
use crate::limits::LARGEST_COORDINATE;
use crate::numerics::angle::sin_cos;
use crate::numerics::{Point, Vector};

/// Places per piece at which the deviation is measured.
const SAMPLES: u32 = 16;
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
    /// Segments with the part of each.
    fn parts(self) -> impl Iterator<Item = (usize, f64, f64)> {
        (self.first..=self.last).map(move |i| {
            (i, if i == self.first { self.from } else { 0.0 }, if i == self.last { self.to } else { 1.0 })
        })
    }

    fn end(self, curve: &HermiteCurve) -> Point {
        let segment = curve.segment(self.last);
        if self.to == 1.0 { segment.end } else { segment.position(self.to) }
    }

    /// The angle that it covers, if it lies on an ellipse.
    pub(super) fn sweep(self, curve: &HermiteCurve) -> f64 {
        self.parts().map(|(i, from, to)| curve.segment(i).basis.frequency() * (to - from)).sum()
    }

    /// Cut at the point of the curve next to its middle, or in the middle where there is none inside.
    pub(super) fn halves(self, curve: &HermiteCurve) -> [Self; 2] {
        if self.first == self.last {
            let middle = 0.5 * (self.from + self.to);
            return [Self { to: middle, ..self }, Self { from: middle, ..self }];
        }
        let half = 0.5 * self.sweep(curve);
        let (mut cut, mut covered) = (self.first, 0.0);
        for (i, from, to) in self.parts().take(self.last - self.first) {
            let sweep = curve.segment(i).basis.frequency() * (to - from);
            if i > self.first && covered + 0.5 * sweep > half {
                break;
            }
            (cut, covered) = (i, covered + sweep);
        }
        [Self { last: cut, to: 1.0, ..self }, Self { first: cut + 1, from: 0.0, ..self }]
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
pub(super) fn plan(
    curve: &HermiteCurve,
    ellipse: &EllipseArc,
    span: Span,
    from: Placed,
    grid: Grid,
    tolerance: f64,
) -> Option<Planned> {
    let end = span.end(curve);
    let to = grid.place(end);
    let chord = to.point() - from.point();
    if chord == Vector::zeros() {
        return None;
    }
    let rounded =
        (from.point() - curve.segment(span.first).position(span.from)).norm().max((to.point() - end).norm());
    let floor = 1e-13 * (ellipse.radii.x + ellipse.center.amax());
    let good = 1.5 * rounded + 0.75 * grid.unit() + floor;
    let shape = Shape::new(ellipse, span.sweep(curve), grid.unit());
    let mut best: Option<Planned> = None;
    for extra in 0..=MOST_EXTRA_DIGITS {
        for down in [false, true] {
            let Some((text, command)) = shape.command(chord, grid, extra, down) else { continue };
            let deviation = measure(curve, span, &Arc::new(from.point(), chord, &command, 0.0));
            if best.is_none_or(|best| deviation < best.deviation) {
                best = Some(Planned { text, to, deviation });
            }
            if deviation <= good {
                return best;
            }
        }
        if grid == Grid::EXACT {
            break;
        }
    }
    best.filter(|best| best.deviation <= tolerance.max(4.0 * good))
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
            large: sweep > PI,
            positive: ellipse.sweep > 0.0,
        }
    }

    /// The parameters with `extra` digits more than the grid has, and their text.
    fn command(&self, chord: Vector, grid: Grid, extra: u32, down: bool) -> Option<(ArcText, ArcCommand)> {
        let rotation = match grid.decimals() {
            Some(decimals) => {
                Plain::nearest(self.degrees, fitting(decimals + extra + self.rotation_digits(), 360.0))
            }
            None => Plain::shortest(self.degrees),
        };
        let (cos, sin) = cos_sin_degrees(rotation.value());
        let half = Vector::new(
            (chord.x * cos + chord.y * sin) / self.radii.x,
            (chord.y * cos - chord.x * sin) / self.radii.y,
        ) * 0.5;
        // Chord 2s and height h on a circle of radius k: k² = s² + (k − h)².
        let k = 0.5 * (half.norm_squared() / self.height + self.height);
        let radii = self.radii * k;
        if radii.amax().is_nan() || radii.amax() > LARGEST_COORDINATE {
            return None;
        }
        let text = |radius: f64| match grid.decimals() {
            Some(decimals) => {
                let nearest = Plain::nearest(radius, fitting(decimals + extra, radius));
                if down && nearest.value() >= radius * (1.0 - 4.0 * f64::EPSILON) {
                    nearest.less()
                } else {
                    nearest
                }
            }
            None => Plain::shortest(if down { radius * (1.0 - 8.0 * f64::EPSILON) } else { radius }),
        };
        let (rx, ry) = (text(radii.x), text(radii.y));
        let radii = Vector::new(rx.value(), ry.value());
        let (large, positive) = (self.large, self.positive);
        let command = ArcCommand { radii, rotation: rotation.value(), large, positive };
        (radii.min() > 0.0).then_some(((rx, ry, rotation, large, positive), command))
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

/// As many of `decimals` as make 17 significant digits of numbers up to `largest`.
fn fitting(decimals: u32, largest: f64) -> u32 {
    let (mut digits, mut rest) = (17, largest);
    while rest >= 1.0 && digits > 0 {
        rest *= 0.1;
        digits -= 1;
    }
    decimals.min(digits)
}

/// A bound of the distance between a span of the curve and an arc, both ways.
///
/// The two are compared at corresponding places: at each end of a segment the arc's angle is that of the curve's
/// point, between them it grows evenly. The difference f of two such pieces is smooth; between samples a step s
/// apart it exceeds them by at most s²/8·max|f″|, and f″ is sampled with it (in pieces of at most a turn, 16 samples
/// catch its maximum to 2 %; a quarter is added).
fn measure(curve: &HermiteCurve, span: Span, arc: &Arc) -> f64 {
    let angle_of = |e: Vector| libm::atan2(e.y, e.x);
    let (uu, vv) = (arc.u.norm_squared(), arc.v.norm_squared());
    let start = angle_of(arc.first);
    let (mut angle, mut deviation) = (start, 0.0_f64);
    for (i, from, to) in span.parts() {
        let segment = curve.segment(i);
        let expected = angle + segment.basis.frequency() * (to - from) * arc.sweep.signum();
        let next = if i == span.last {
            start + arc.sweep
        } else {
            let offset = segment.position(to) - arc.center;
            let turned = angle_of(Vector::new(offset.dot(&arc.u) / uu, offset.dot(&arc.v) / vv)) - expected;
            expected + turned - TAU * (turned / TAU).round_ties_even()
        };
        let (width, turn) = (segment.length * (to - from), next - angle);
        let (mut apart, mut bent) = (0.0_f64, 0.0_f64);
        for k in 0..=SAMPLES {
            let part = f64::from(k) / f64::from(SAMPLES);
            let (sin, cos) = sin_cos(angle + turn * part);
            let drawn = arc.u * cos + arc.v * sin;
            let x = from + (to - from) * part;
            apart = apart.max((segment.position(x) - arc.center - drawn).norm());
            bent = bent.max((segment.acceleration(x) * (width * width) + drawn * (turn * turn)).norm());
        }
        let step = 1.0 / f64::from(SAMPLES);
        deviation = deviation.max(apart + 1.25 * bent * (step * step / 8.0));
        angle = next;
    }
    deviation
}
