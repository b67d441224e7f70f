//! The end speeds of a segment that replaces two: a survey of many pairs of speeds, and the nearest segments from the
//! best of them (D 7.3).

use super::places::{COUNT, Places, heading};
use super::{Best, CHORDS, turning, way};
use crate::curve::Segment;
use crate::numerics::dense::damped_step;
use crate::numerics::{Point, Vector};

/// Speeds that are surveyed: with two of 1 a straight segment would be as long as the old ones.
const SPEEDS: [f64; 9] = [0.06, 0.15, 0.35, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0];
/// The least speed that comes out, wherever it began: where a handle is shorter, the curve turns there as sharply as at
/// a corner, and nobody can seize it.
const LEAST: f64 = 0.1;
/// The largest: no cubic is faster at an end than nine times its way, as |q(0)| ≤ 9 ∫|q| for parabolas q, and steps
/// beyond that never come back.
const MOST: f64 = 9.0;
/// Where all that the steps led to is this share of the way apart, or has a loop, the survey itself may have what is
/// nearer.
const FAR: f64 = 0.25;
/// Pairs of them.
const SURVEYED: usize = SPEEDS.len() * SPEEDS.len();
/// Steps for each power of the distances, those included that went too far; most take six.
const STEPS: usize = 24;
/// A step by no more than this share of the speeds is the last: the next one would be of the size of its square.
const STILL: f64 = 1e-6;

/// Looks at segments that have the ends of `merged` and are nearest to the places: one from each least value of the
/// survey, which leaves out what turns too much, and where they are far apart the survey's own.
#[inline(never)]
pub(super) fn nearest(merged: &Segment, places: &Places, best: &mut Best<'_>) {
    let directions = [heading(&best.old[0], 0.0), heading(&best.old[1], 1.0)];
    let mut fit = Fit { merged: *merged, directions, places, unit: 0.0, shares: [0.0; COUNT] };
    fit.measure();
    let (mut survey, mut feet) = ([0.0; SURVEYED], [0.0; COUNT]);
    for (k, squares) in survey.iter_mut().enumerate() {
        let way = way(&fit.with(fit.speeds(k)));
        *squares = if turning(&[&way]) > best.most { f64::INFINITY } else { fit.lay(&way, &mut feet) };
    }
    for k in 0..SURVEYED {
        if is_least(&survey, k) {
            fit.lay(&way(&fit.with(fit.speeds(k))), &mut feet);
            best.look(&fit.nearest(fit.speeds(k), feet));
        }
    }
    if best.healed.deviation > FAR * fit.unit * merged.length {
        // Places at equal shares of the length are no nearer than the nearest ones: what is farther on the average is
        // skipped.
        for (k, &squares) in survey.iter().enumerate() {
            if squares < COUNT as f64 * best.healed.deviation * best.healed.deviation {
                best.look(&fit.with(fit.bounded(fit.speeds(k))));
            }
        }
    }
}

/// Whether a value is less than those around it, of equal ones the first.
#[inline(never)]
fn is_least(survey: &[f64], k: usize) -> bool {
    let apart = |a: usize, b: usize| a.abs_diff(b) > 1;
    survey.iter().enumerate().all(|(l, other)| {
        let beside = !apart(k / SPEEDS.len(), l / SPEEDS.len()) && !apart(k % SPEEDS.len(), l % SPEEDS.len());
        !beside || survey[k] < *other || (l >= k && survey[k] <= *other)
    })
}

/// A segment of which the directions at the ends stay, and the places that it is to come near to.
struct Fit<'a> {
    merged: Segment<'a>,
    directions: [Vector; 2],
    places: &'a Places,
    /// How much of the way from place to place lies before each.
    shares: [f64; COUNT],
    /// A speed with which a straight segment would be as long as that way.
    unit: f64,
}

/// What a step is made of: the matrix and the right side of its equations, and the sum that it lessens.
#[derive(Clone, Copy, Default)]
struct Equations {
    matrix: [f64; 3],
    right: [f64; 2],
    sum: f64,
}

impl<'a> Fit<'a> {
    /// Measures the way from place to place.
    #[inline(never)]
    fn measure(&mut self) {
        let (mut length, mut last) = (0.0, self.merged.start);
        for (share, &[_, x, y]) in self.shares.iter_mut().zip(self.places) {
            let here = Point::new(x, y);
            length += (here - last).norm();
            (*share, last) = (length, here);
        }
        length += (self.merged.end - last).norm();
        for share in &mut self.shares {
            *share /= length;
        }
        self.unit = length / self.merged.length;
    }

    /// Pair k of the speeds that are surveyed.
    #[inline(never)]
    fn speeds(&self, k: usize) -> [f64; 2] {
        [SPEEDS[k / SPEEDS.len()] * self.unit, SPEEDS[k % SPEEDS.len()] * self.unit]
    }

    #[inline(never)]
    fn bounded(&self, speeds: [f64; 2]) -> [f64; 2] {
        speeds.map(|speed| speed.max(LEAST * self.unit).min(MOST * self.unit))
    }

    #[inline(never)]
    fn with(&self, [out, inn]: [f64; 2]) -> Segment<'a> {
        Segment { leaving: self.directions[0] * out, arriving: self.directions[1] * inn, ..self.merged }
    }

    /// Where a segment of these chords has the places if each is as far along them as it is along their way, and the
    /// sum of the squared distances.
    #[inline(never)]
    fn lay(&self, ends: &[Point], feet: &mut [f64; COUNT]) -> f64 {
        let mut lengths = [0.0; CHORDS + 1];
        for (k, pair) in ends.windows(2).enumerate() {
            lengths[k + 1] = lengths[k] + (pair[1] - pair[0]).norm();
        }
        let (mut chord, mut sum) = (0, 0.0);
        for (k, &[_, x, y]) in self.places.iter().enumerate() {
            let goal = self.shares[k] * lengths[CHORDS];
            while chord + 1 < CHORDS && lengths[chord + 1] < goal {
                chord += 1;
            }
            let part = (goal - lengths[chord]) / (lengths[chord + 1] - lengths[chord]).max(f64::MIN_POSITIVE);
            feet[k] = (chord as f64 + part) / CHORDS as f64;
            sum += (ends[chord] + (ends[chord + 1] - ends[chord]) * part - Point::new(x, y)).norm_squared();
        }
        sum
    }

    /// The segment that is nearest to the places, from speeds with which their feet are about here.
    #[inline(never)]
    fn nearest(&self, speeds: [f64; 2], mut feet: [f64; COUNT]) -> Segment<'a> {
        let mut speeds = self.bounded(speeds);
        for farthest in [false, true] {
            let mut unit = 0.0;
            let mut here = self.equations(speeds, &mut feet, farthest, &mut unit);
            let mut damping = 1e-6;
            for _ in 0..STEPS {
                // Collinear tangents leave a speed undetermined: a trace of damping stays.
                let step = damped_step(here.matrix, here.right, damping);
                let trial = self.bounded([speeds[0] + step[0], speeds[1] + step[1]]);
                let mut trial_feet = feet;
                let there = self.equations(trial, &mut trial_feet, farthest, &mut unit);
                if there.sum < here.sum {
                    (speeds, feet, here) = (trial, trial_feet, there);
                    damping = (damping * 0.1).max(1e-12);
                } else {
                    damping *= 10.0;
                }
                if step[0].abs() + step[1].abs() <= STILL * (speeds[0] + speeds[1]) {
                    break;
                }
            }
        }
        self.with(speeds)
    }

    /// The equations for a change of the speeds that lessens the sum of the squared distances of the places, or of
    /// their fourth powers: almost only of the farthest, but smoothly. Squares are counted in `unit`, the largest of
    /// them if that is 0.
    #[inline(never)]
    fn equations(
        &self,
        speeds: [f64; 2],
        feet: &mut [f64; COUNT],
        farthest: bool,
        unit: &mut f64,
    ) -> Equations {
        let segment = self.with(speeds);
        let mut offsets = [Vector::zeros(); COUNT];
        let mut largest = f64::MIN_POSITIVE;
        for (k, x) in feet.iter_mut().enumerate() {
            let target = Point::new(self.places[k][1], self.places[k][2]);
            *x = segment.foot(target, segment.foot(target, *x));
            offsets[k] = target - segment.position(*x);
            largest = largest.max(offsets[k].norm_squared());
        }
        if *unit == 0.0 {
            *unit = largest;
        }
        let mut equations = Equations::default();
        for (&x, offset) in feet.iter().zip(&offsets) {
            let square = offset.norm_squared() / *unit;
            let (weight, order) = if farthest { (square * square * square, 7.0) } else { (1.0, 1.0) };
            equations.sum += weight * square;
            let velocity = segment.velocity(x);
            let across = Vector::new(-velocity.y, velocity.x) / velocity.norm().max(f64::MIN_POSITIVE);
            let weights = segment.basis.weights(x, 0);
            let row = [
                across.dot(&self.directions[0]) * weights.leaving * segment.length,
                across.dot(&self.directions[1]) * weights.arriving * segment.length,
            ];
            for (sum, product) in
                equations.matrix.iter_mut().zip([row[0] * row[0], row[0] * row[1], row[1] * row[1]])
            {
                *sum += weight * order * product;
            }
            for (sum, row) in equations.right.iter_mut().zip(row) {
                *sum += weight * across.dot(offset) * row;
            }
        }
        equations
    }
}
