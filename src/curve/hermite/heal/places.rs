//! Places on the two old segments that the new one is compared with.

use crate::curve::Segment;
use crate::numerics::Vector;

/// How many there are on each.
const EACH: usize = 24;
/// How many there are.
pub(super) const COUNT: usize = 2 * EACH;

/// Places on the old segments, x and y, each after its x in the new one.
pub(super) type Places = [[f64; 3]; COUNT];

/// The places, each after the x that it would have in the new segment if the first old one were this share of the
/// whole.
#[inline(never)]
pub(super) fn places(old: &[Segment; 2], share: f64) -> Places {
    let mut places = [[0.0; 3]; COUNT];
    for (k, place) in places.iter_mut().enumerate() {
        let (segment, from, to) = if k < EACH { (&old[0], 0.0, share) } else { (&old[1], share, 1.0) };
        // The joint is one of them: of a corner it is what may be farthest away.
        let x = (k % EACH + 1) as f64 / (EACH + k / EACH) as f64;
        let point = segment.position(x);
        *place = [from + (to - from) * x, point.x, point.y];
    }
    places
}

/// The direction in which a segment leaves x = 0 or arrives at x = 1, also where its speed is 0 there.
#[inline(never)]
pub(super) fn heading(segment: &Segment, x: f64) -> Vector {
    let towards_inside = if x == 0.0 { 1.0 } else { -1.0 };
    let chord = segment.end - segment.start;
    for direction in [segment.velocity(x), segment.acceleration(x) * towards_inside, chord] {
        let size = direction.norm();
        if size > 1e-12 * chord.norm() / segment.length.max(1.0) && size > 0.0 {
            return direction / size;
        }
    }
    Vector::zeros()
}
