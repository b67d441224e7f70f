//! How far a curve is from the contour that it follows.

use super::metrics::{Metrics, one_number, tolerant_jaccard};
use crate::curve::{HermiteCurve, Segment};
use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::plane::{dot, larger, norm, smaller, square};
use crate::numerics::{Point, Vector};

/// How far ahead the nearest place is looked for, in pixels: contours and their curves run side by side.
const AHEAD: f64 = 4.0;
/// A point that is farther away than this, in pixels, may have left the walk behind: at the other side of a corner that
/// stands out, say, where all that is ahead is the way to its tip and back.
const ASTRAY: f64 = 1.0;
/// The pixels of a polyline are looked for at about this distance, in pixels.
const PIXEL: f64 = 0.75;
/// Chords of a curve are about this long, in pixels: a parabola over each is as good as the curve.
const CHORD: f64 = 1.5;

/// Compares a curve with a contour that turns the same way, both closed or both open, in pixels.
///
/// Both are walked side by side, so the time is that of one walk. Where that leads away, all of the other is looked at.
pub(super) fn agreement(curve: &HermiteCurve, contour: &[Point]) -> Result<Metrics> {
    let mut comparison = Comparison::new(curve, contour)?;
    loop {
        if let Some(metrics) = comparison.step()? {
            return Ok(metrics);
        }
    }
}

/// A curve that is being compared with a contour, in three steps or, where they are far from each other, in six.
#[derive(Debug)]
pub(super) struct Comparison {
    curve: Vec<Chord>,
    sides: Vec<Chord>,
    closed: bool,
    there: Option<Offs>,
    back: Option<Offs>,
    /// The pixels of the contour, and of the curve.
    pixels: Vec<Vec<u64>>,
}

impl Comparison {
    pub(super) fn new(curve: &HermiteCurve, contour: &[Point]) -> Result<Self> {
        let closed = curve.is_closed();
        let (curve, sides) = (Chord::follow(curve), Chord::along(contour, closed)?);
        Ok(Self { curve, sides, closed, there: None, back: None, pixels: Vec::new() })
    }

    /// Goes on with the contour; how far the curve is from it, in the end.
    pub(super) fn step(&mut self) -> Result<Option<Metrics>> {
        let Some(there) = &self.there else {
            self.there = Some(Offs::of(&self.sides, &self.curve, self.closed));
            return Ok(None);
        };
        let Some(back) = &self.back else {
            self.back = Some(Offs::of(&self.curve, &self.sides, self.closed));
            return Ok(None);
        };
        let count = larger(there.count, 1.0);
        let hausdorff = there.most.max(back.most);
        // Points that are no farther than a pixel are in neighbouring pixels.
        let mut share = 1.0;
        if hausdorff > 1.0 {
            let [first, second] = self.pixels.as_slice() else {
                let chords = [&self.sides, &self.curve];
                self.pixels.push(pixels(chords[self.pixels.len().min(1)], pixel(chords)));
                return Ok(None);
            };
            share = tolerant_jaccard(first, second)?;
        }
        let (rmse, mae) = ((there.square / count).sqrt(), there.sum / count);
        Ok(Some(Metrics { rmse, mae, max: there.most, hausdorff, jaccard: share }))
    }
}

/// The side of the pixels that two polylines are compared by: those of more than 400,000 grow.
fn pixel(polylines: [&Vec<Chord>; 2]) -> f64 {
    let [first, second] = polylines.map(|chords| chords.iter().map(|chord| chord.length).sum::<f64>());
    larger(larger(first, second) / 4e5, 1.0)
}

/// The pixels of a polyline, none twice in a row.
fn pixels(chords: &[Chord], pixel: f64) -> Vec<u64> {
    let (mut pixels, mut last) = (Vec::with_capacity(chords.len()), None);
    let scale = 1.0 / pixel;
    for chord in chords {
        let steps = (chord.length * scale / PIXEL).ceil().clamp(1.0, 1e6);
        for step in 0..steps as usize {
            let p = (chord.from + chord.way * (step as f64 / steps)) * scale;
            let here = one_number((p.x.floor() as i32, p.y.floor() as i32));
            if last != Some(here) {
                pixels.push(here);
                last = Some(here);
            }
        }
    }
    pixels
}

/// A stretch of a curve, and how far its middle is from the chord's.
#[derive(Clone, Copy, Debug)]
struct Chord {
    from: Point,
    way: Vector,
    bow: Vector,
    length: f64,
    /// One over the square of the length; 0 for no length.
    inverse: f64,
}

impl Chord {
    fn new(from: Point, to: Point, bow: Vector) -> Self {
        let way = to - from;
        let square = square(way);
        let inverse = if square > 0.0 { 1.0 / square } else { 0.0 };
        Self { from, way, bow, length: square.sqrt(), inverse }
    }

    /// The chords of a polyline.
    fn along(points: &[Point], closed: bool) -> Result<Vec<Self>> {
        let mut chords = with_room(points.len())?;
        for pair in points.windows(2) {
            chords.push(Self::new(pair[0], pair[1], Vector::zeros()));
        }
        if let (Some(&first), Some(&last)) = (points.first(), points.last())
            && (closed || chords.is_empty())
        {
            chords.push(Self::new(last, first, Vector::zeros()));
        }
        Ok(chords)
    }

    /// The chords of a curve.
    fn follow(curve: &HermiteCurve) -> Vec<Self> {
        let mut chords = Vec::new();
        for segment in curve.segments() {
            let (start, end) = (segment.start, segment.end);
            if segment.as_line(1e-9) {
                chords.push(Self::new(start, end, Vector::zeros()));
                continue;
            }
            let middle = place(&segment, 0.5);
            let length = larger(norm(end - start), 2.0 * norm(middle - start));
            let steps = (length / CHORD).ceil().clamp(2.0, 20_000.0);
            let count = steps as usize;
            let mut from = start;
            for step in 0..count {
                let x = (step as f64 + 0.5) / steps;
                let to = if step + 1 == count { end } else { place(&segment, (step + 1) as f64 / steps) };
                chords.push(Self::new(from, to, place(&segment, x) - (from + to) * 0.5));
                from = to;
            }
        }
        chords
    }

    /// The squared distance of a point from the chord, and the share of the chord at which it is nearest.
    #[inline]
    fn off(&self, p: Point) -> (f64, f64) {
        let off = p - self.from;
        let share = dot(off, self.way) * self.inverse;
        let share = smaller(larger(share, 0.0), 1.0);
        (square(off - self.way * share), share)
    }

    /// The distance of a point from the parabola over the chord, near a share of it, where it is so far from the chord.
    #[inline]
    fn distance(&self, p: Point, share: f64, root: f64) -> f64 {
        if self.bow == Vector::zeros() {
            return root;
        }
        norm(p - self.from - self.way * share - self.bow * (4.0 * share * (1.0 - share)))
    }
}

/// A point of a segment; most are cubics, which take a tenth of the time of others.
#[inline(never)]
fn place(segment: &Segment<'_>, x: f64) -> Point {
    if segment.basis.square() != 0.0 {
        return segment.position(x);
    }
    let way = segment.end - segment.start;
    let [first, last] = [segment.leaving * segment.length, segment.arriving * segment.length];
    let (bend, twist) = (way * 3.0 - first * 2.0 - last, first + last - way * 2.0);
    segment.start + (first + (bend + twist * x) * x) * x
}

#[derive(Debug)]
struct Offs {
    count: f64,
    sum: f64,
    square: f64,
    most: f64,
}

impl Offs {
    /// The distances of the ends of chords from others that run beside them.
    fn of(ends: &[Chord], chords: &[Chord], closed: bool) -> Self {
        let mut offs = Self { count: 0.0, sum: 0.0, square: 0.0, most: 0.0 };
        let (Some(first), Some(last), Some(_)) = (ends.first(), ends.last(), chords.first()) else {
            return offs;
        };
        let mut walk = Walk { chords, closed, at: nearest(first.from, chords), trusted: ASTRAY };
        let mut stride = 0.0;
        for &Chord { from, length, .. } in ends {
            offs.note(walk.distance(from, stride));
            stride = length;
        }
        if !closed {
            offs.note(walk.distance(last.from + last.way, stride));
        }
        offs
    }

    fn note(&mut self, distance: f64) {
        self.count += 1.0;
        self.square += distance * distance;
        self.sum += distance;
        self.most = larger(self.most, distance);
    }
}

/// A walk along chords, beside points.
struct Walk<'a> {
    chords: &'a [Chord],
    closed: bool,
    /// The chord that is nearest to the last point.
    at: usize,
    /// As far as that is believed without looking at all of the chords: twice of what was found when they were last.
    trusted: f64,
}

impl Walk<'_> {
    /// The distance of the next point, so far from the last one.
    #[inline(always)]
    fn distance(&mut self, p: Point, stride: f64) -> f64 {
        let Self { chords, closed, .. } = *self;
        let (mut best, mut share) = chords[self.at].off(p);
        let mut root = best.sqrt();
        // A contour is not much longer than the chords of its curve. What is left of this chord, and then chord by
        // chord.
        let mut ahead = AHEAD + 2.0 * stride + root - (1.0 - share) * chords[self.at].length;
        let (start, mut i) = (self.at, self.at);
        while ahead > 0.0 {
            i += 1;
            if i == chords.len() {
                i = 0;
            }
            if i == start || (i == 0 && !closed) {
                break;
            }
            let (here, place) = chords[i].off(p);
            if here < best {
                (best, share, self.at, root) = (here, place, i, here.sqrt());
            } else if here >= (root + ahead) * (root + ahead) {
                // All of what is left is too short to come back.
                break;
            }
            ahead -= chords[i].length;
        }
        if root <= ASTRAY {
            self.trusted = ASTRAY;
        } else if root > self.trusted {
            // After a long side the walk may have gone on to the other edge of a narrow place.
            self.at = nearest(p, chords);
            (best, share) = chords[self.at].off(p);
            root = best.sqrt();
            self.trusted = larger(2.0 * root, ASTRAY);
        }
        chords[self.at].distance(p, share, root)
    }
}

/// The chord that is nearest to a point: after one that is far away as many are left out as do not reach back.
#[inline(never)]
fn nearest(p: Point, chords: &[Chord]) -> usize {
    let (mut at, mut best, mut root) = (0, f64::MAX, f64::MAX);
    let (mut far, mut way) = (0.0, 0.0);
    for (i, chord) in chords.iter().enumerate() {
        way += chord.length;
        if far < (root + way) * (root + way) {
            (far, _) = chord.off(p);
            way = chord.length;
            if far < best {
                (best, at, root) = (far, i, far.sqrt());
            }
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use super::{Chord, Offs};
    use crate::numerics::Point;
    use crate::numerics::plane::larger;

    fn closed(points: &[Point]) -> Vec<Chord> {
        Chord::along(points, true).expect("memory")
    }

    /// A closed wavy line with a narrow tip, moved outwards by a share of its waves.
    fn wavy(count: usize, wave: f64) -> Vec<Point> {
        let place = |i: usize| {
            let t = core::f64::consts::TAU * i as f64 / count as f64;
            let tip = 30.0 / (1.0 + 400.0 * (1.0 - t.cos()));
            let r = 40.0 + tip + wave * (9.0 * t).sin();
            Point::new(60.0 + r * t.cos(), 60.0 + r * t.sin())
        };
        (0..count).map(place).collect()
    }

    #[test]
    fn corners_nearer_to_the_other_edge_of_a_narrow_place_do_not_lead_the_walk_astray() {
        // Two gaps all but cut the band in two, and end a little earlier in the picture.
        let band = |gap: f64| {
            [
                [38.0, 0.0],
                [89.0, 0.0],
                [101.0, 12.0],
                [83.0, 13.0],
                [78.0, gap],
                [63.0, 37.0],
                [49.0, gap],
                [44.0, 13.0],
                [26.0, 12.0],
            ]
            .map(|[x, y]| Point::new(x, y))
        };
        let contour = band(4.0);
        let sides = (0..9).map(|i| (contour[i], contour[(i + 1) % 9]));
        let dense: Vec<Point> =
            sides.flat_map(|(a, b)| (0..40).map(move |k| a + (b - a) * (f64::from(k) / 40.0))).collect();
        let chords = closed(&dense);
        let Offs { most, .. } = Offs::of(&closed(&band(1.0)), &chords, true);
        // The gaps' corners are 3 from where these end, and the other edge is nearer still.
        assert!(most <= 3.0, "{most}");
    }

    #[test]
    fn a_corner_that_stands_beyond_its_contour_does_not_keep_the_walk_at_its_tip() {
        // A needle whose contour ends up to 12 before it does.
        for cut in [1.0, 3.0, 6.0, 12.0] {
            let slope = 0.06;
            let tip = [[0.0, 100.0 * slope], [100.0, 0.0], [0.0, -100.0 * slope], [-60.0, 0.0]];
            let blunt = [
                [0.0, 100.0 * slope],
                [100.0 - cut, cut * slope],
                [100.0 - cut, -cut * slope],
                [0.0, -100.0 * slope],
                [-60.0, 0.0],
            ];
            let chords = closed(&tip.map(|[x, y]| Point::new(x, y)));
            let corners = blunt.map(|[x, y]| Point::new(x, y));
            let sides = (0..5).map(|i| (corners[i], corners[(i + 1) % 5]));
            let dense: Vec<Point> = sides
                .flat_map(|(a, b)| (0..150).map(move |k| a + (b - a) * (f64::from(k) / 150.0)))
                .collect();
            let Offs { most, .. } = Offs::of(&closed(&dense), &chords, true);
            assert!(most <= 1.0, "{cut}: {most}");
            // The other way, the tip is as far from its contour as that ends before it.
            let Offs { most, .. } = Offs::of(&chords, &closed(&dense), true);
            assert!((most - cut).abs() < 1e-3 * cut, "{cut}: {most}");
        }
    }

    #[test]
    fn both_ends_of_what_is_open_are_looked_at_once() {
        let line = |y: f64| [0.0, 3.0, 7.0].map(|x| Point::new(x, y));
        let [ends, chords] = [line(0.0), line(1.5)].map(|line| Chord::along(&line, false).expect("memory"));
        let Offs { count, sum, square, most } = Offs::of(&ends, &chords, false);
        assert_eq!((count, sum, square, most), (3.0, 4.5, 6.75, 1.5));
    }

    #[test]
    fn what_lies_side_by_side_is_measured_as_if_every_chord_were_looked_at() {
        for (count, wave) in [(420, 0.3), (420, -0.8), (900, 1.5)] {
            let points = wavy(count, 0.0);
            let chords = closed(&wavy(300, wave));
            let Offs { sum, most, .. } = Offs::of(&closed(&points), &chords, true);
            let (mut all, mut largest) = (0.0, 0.0);
            for &p in &points {
                let off = chords.iter().fold(f64::MAX, |least, chord| least.min(chord.off(p).0)).sqrt();
                (all, largest) = (all + off, larger(largest, off));
            }
            assert!(
                (sum - all).abs() < 1e-9 && (most - largest).abs() < 1e-9,
                "{sum} {all}, {most} {largest}"
            );
        }
    }
}
