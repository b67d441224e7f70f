//! How far apart one or two segments are, by foot points: for small edits, not for whole drawings.

use crate::curve::Segment;
use crate::numerics::Point;

/// Places on every segment from which the distance is measured, and among which a foot point is looked for.
const PLACES: usize = 97;

/// Newton's steps to a foot point: beside a sharp bend it takes more than the three that are usual.
const STEPS: usize = 8;
/// A step of this share of a segment moves a foot by less than its distance is told to.
const STILL: f64 = 1e-9;

/// How close to the farthest place is close enough, as a share of a segment.
const CLOSE: f64 = 1e-6;

/// Squares of distances by which places are told apart.
const ALIKE: f64 = 1.0 + 1e-6;

/// The larger of the two directed distances; where it is not below `most`, anything that is not either.
pub(super) fn two_way_deviation(first: &[Segment], second: &[Segment], most: f64) -> f64 {
    let there = deviation_of(first, second, most);
    if there < most { there.max(deviation_of(second, first, most)) } else { there }
}

/// The largest distance of a place on `from` to the nearest place on `to`; where it is not below `most`, anything that
/// is not either.
#[inline(never)]
pub(super) fn deviation_of(from: &[Segment], to: &[Segment], most: f64) -> f64 {
    let (ways, lattice) = (places(from), places(to));
    let (ways, lattice) = (&ways[..from.len() * PLACES], &lattice[..to.len() * PLACES]);
    let (mut before, mut here, mut largest) = (0.0_f64, 0.0_f64, 0.0_f64);
    for next in 0..=ways.len() {
        let after = ways.get(next).map_or(0.0, |&way| distance(way, lattice, to));
        // Uphill from every place that is farther than those beside it, and back by shorter steps: a long handle goes
        // far between places. A joint is two places, of which one leads up on each side.
        let mut top = here;
        if next > 0 && ALIKE * here >= before.max(after) {
            let k = next - 1;
            let (mut x, mut step) = (place(k), 1.0 / PLACES as f64);
            while step.abs() > CLOSE {
                let trial = (x + step).clamp(0.0, 1.0);
                let there = distance(from[k / PLACES].position(trial), lattice, to);
                if there > top {
                    (x, top) = (trial, there);
                } else {
                    step *= -0.6;
                }
            }
        }
        largest = largest.max(top);
        if largest >= most {
            break;
        }
        (before, here) = (here, after);
    }
    largest
}

/// The distance of a point to one or two segments, from the foot next to each place of theirs that is nearer than those
/// beside it.
///
/// The nearest place alone may be on another branch, which is farther. A joint is two places, as its foot may lie on
/// either segment.
fn distance(target: Point, lattice: &[Point], to: &[Segment]) -> f64 {
    let square = |k: usize| lattice.get(k).map_or(f64::INFINITY, |point| (point - target).norm_squared());
    let mut least = f64::INFINITY;
    let (mut before, mut here, mut tried) = (f64::INFINITY, square(0), false);
    for k in 0..lattice.len() {
        let after = square(k + 1);
        // Of places that are all as near, as those of a circle to its middle, the first stands for all; the two places
        // of a joint are one but for rounding.
        tried &= before <= ALIKE * here && k % PLACES > 0;
        if !tried && here <= ALIKE * before && here <= ALIKE * after {
            tried = true;
            let (segment, mut x) = (&to[k / PLACES], place(k));
            for _ in 0..STEPS {
                let next = segment.foot(target, x);
                let step = (next - x).abs();
                x = next;
                if step <= STILL {
                    break;
                }
            }
            least = least.min(here.sqrt()).min((segment.position(x) - target).norm());
        }
        (before, here) = (here, after);
    }
    least
}

/// `PLACES` on each of one or two segments, its ends among them.
#[inline(never)]
fn places(segments: &[Segment]) -> [Point; 2 * PLACES] {
    // Made from what is computed: a list of zeros would be two hundred instructions.
    core::array::from_fn(|k| match segments.get(k / PLACES) {
        Some(segment) => segment.position(place(k)),
        None => Point::zeros(),
    })
}

fn place(k: usize) -> f64 {
    (k % PLACES) as f64 / (PLACES - 1) as f64
}

impl Segment<'_> {
    /// One step of Newton's method from x towards the foot of the perpendicular from `target`.
    #[inline(never)]
    pub(super) fn foot(&self, target: Point, x: f64) -> f64 {
        let offset = self.position(x) - target;
        let (velocity, acceleration) = (self.velocity(x), self.acceleration(x));
        let square = velocity.norm_squared();
        // Where the curve bends away, the step of a straight line is the safe one.
        let curved = square + offset.dot(&acceleration);
        let slope = if curved > 0.25 * square { curved } else { square };
        if slope == 0.0 {
            // At a cusp no step is the right one: it goes on from a quarter of a place inside.
            return x + (0.5 - x) / (2 * PLACES) as f64;
        }
        (x - offset.dot(&velocity) / (slope * self.length)).clamp(0.0, 1.0)
    }
}
