//! Segments that are no lines: `C`, `S` and `Q`.

use super::{Printer, displacement};
use crate::curve::{Segment, segment_cubics};
use crate::numerics::plane::{cross, dot, larger, smaller};
use crate::numerics::{Point, Vector};
use crate::svg::returning::{returning, returning_both};
use crate::svg::text::{DecimalGrid, Placed};

/// No handle has to be turned less by the grid, in radians: two of them at a joint are twice as much.
const TURNED: f64 = 0.0175;
/// How much longer other handles are that are tried then, in halves of the grid's unit.
const OTHERS: [f64; 9] = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0];

impl Printer<'_> {
    /// Any other segment, as cubic Béziers.
    #[inline(never)]
    pub(super) fn bezier(&mut self, segment: &Segment<'_>) {
        if segment.basis.frequency() == 0.0 {
            let (leaving, arriving) = (segment.leaving * segment.length, segment.arriving * segment.length);
            return self.cubic(segment.start, leaving, arriving, segment.end, 0.0);
        }
        let mut pieces = core::mem::take(&mut self.pieces);
        pieces.clear();
        let proved = segment_cubics(segment, self.share, &mut pieces);
        for &[start, first, second, end] in &pieces {
            self.cubic(start, (first - start) * 3.0, (end - second) * 3.0, end, proved);
        }
        self.pieces = pieces;
    }

    /// One cubic, by its end derivatives, which is known to be `near` from the curve.
    #[inline(never)]
    fn cubic(&mut self, start: Point, leaving: Vector, arriving: Vector, end: Point, near: f64) {
        let from = self.text.current();
        let to = self.grid.place(end);
        let ends = larger(displacement(from, start), displacement(to, end));
        if self.quadratic(start, leaving, arriving, end, near) {
            return;
        }
        let most = self.tolerance - near;
        let first = self.handle(start, leaving, from, most);
        let second = self.handle(end, -arriving, to, most);
        let truth = [start + leaving / 3.0, end - arriving / 3.0];
        let mirrored = match self.control {
            Some(control) => self.grid.mirrored(control, from),
            None => from,
        };
        let (one, two) = (displacement(first, truth[0]), displacement(second, truth[1]));
        let plain = near + moved(ends, one, two);
        let short = near + moved(ends, displacement(mirrored, truth[0]), two);
        if [first, second, to] == [from; 3] {
            // Smaller than the grid.
            return self.measured(plain);
        }
        if self.mirrors(leaving, mirrored, first)
            || self.grid != DecimalGrid::EXACT && short <= self.tolerable(plain)
        {
            self.measured(short);
            self.text.bezier(b'S', &[second, to]);
        } else {
            self.measured(plain);
            self.text.bezier(b'C', &[first, second, to]);
        }
        self.control = Some(second);
    }

    /// Whether a reader of `S` gets just what it would get from `C`.
    fn mirrors(&self, leaving: Vector, mirrored: Placed, first: Placed) -> bool {
        match self.control {
            // Readers of this crate go on with the derivative itself, not with the mirrored point.
            Some(control) if self.grid == DecimalGrid::EXACT => {
                let from = self.text.current().point();
                let arrived = (from - control.point()) * 3.0;
                arrived == leaving || arrived == (first.point() - from) * 3.0
            }
            _ => mirrored == first,
        }
    }

    /// The deviation up to which a shorter form may be used.
    fn tolerable(&self, plain: f64) -> f64 {
        larger(plain, smaller(self.tolerance, plain + 2.0 * self.grid.unit()))
    }

    /// Writes `Q` where the cubic is a parabola.
    fn quadratic(&mut self, start: Point, leaving: Vector, arriving: Vector, end: Point, near: f64) -> bool {
        let (one, two) = (start + leaving * 0.5, end - arriving * 0.5);
        let gap = (one - two).norm();
        if near > 0.0 || gap > self.straight {
            return false;
        }
        let (from, to) = (self.text.current(), self.grid.place(end));
        let control = if self.grid == DecimalGrid::EXACT {
            let mut control = Point::zeros();
            for k in 0..2 {
                let Some(c) = returning_both(start[k], leaving[k], end[k], arriving[k]) else { return false };
                control[k] = c;
            }
            self.grid.place(control)
        } else {
            self.grid.place(one)
        };
        let ends = larger(displacement(from, start), displacement(to, end));
        self.measured(ends + 0.5 * larger(displacement(control, one) - ends, 0.0) + 0.5 * gap);
        self.text.bezier(b'Q', &[control, to]);
        self.control = None;
        true
    }

    /// The control point that a cubic with derivative `d` at the end `p` has next to it.
    ///
    /// Where every bit counts it is the one from which a reader gets `d` back, if there is one. Where the grid would
    /// turn a short one, it is one along `d` that is turned less, at most so far from where it should be: a joint that
    /// is smooth has to look it.
    fn handle(&self, p: Point, d: Vector, end: Placed, most: f64) -> Placed {
        let q = end.point();
        if self.grid == DecimalGrid::EXACT {
            return self.grid.place(Point::new(returning(q.x, d.x), returning(q.y, d.y)));
        }
        let way = d / 3.0;
        let (mut best, mut least) = (self.grid.place(p + way), f64::INFINITY);
        if best == end {
            return best;
        }
        for k in OTHERS {
            let longer = || way * (k * 0.5 * self.grid.unit() / way.norm());
            let other = if k == 0.0 { best } else { self.grid.place(q + way + longer()) };
            let there = other.point() - q;
            let (across, along) = (cross(way, there).abs(), dot(way, there));
            let turned = if along > 0.0 { across / along } else { f64::MAX };
            if turned < least && (k == 0.0 || displacement(other, p + way) <= most) {
                (best, least) = (other, turned);
            }
            if least <= TURNED {
                break;
            }
        }
        best
    }
}

/// How far a cubic moves at most when its ends do by `ends` and its handles by `one` and `two`: the Bernstein weights
/// of the handles reach 4/9 each, 3/4 together (D 8.4).
fn moved(ends: f64, one: f64, two: f64) -> f64 {
    let (one, two) = (larger(one - ends, 0.0), larger(two - ends, 0.0));
    ends + smaller(4.0 / 9.0 * (one + two), 0.75 * larger(one, two))
}
