//! Curves that a program drew as chords: one arc or far fewer cubics in place of many lines.

use super::stretch::Way;
use super::{Anchor, Divider, DivisionRule};
use crate::numerics::Point;
use crate::numerics::angle::sin_cos;
use crate::trace::outline::cubic::Tangent;
use crate::trace::outline::rounds::Arc;
use crate::trace::outline::{Node, Outline, Piece};
use crate::trace::samples::{turn, unit};

/// How far a curve is from the chords that it was drawn by, and its root mean square, as shares of what a cubic may be
/// off by.
const CHORDS: [f64; 2] = [0.8, 0.75];
/// How many times as much of a contour a tangent is taken from where it may be of chords.
const SEVERAL: f64 = 2.5;
/// How many straight pieces a cubic costs.
const CUBIC: usize = 2;
/// What may be chords of an arc costs more than a cubic, and what may be those of other curves more than this.
const MANY: usize = 4;
/// Places that tell an arc.
const FEWEST: isize = 6;

impl Divider<'_> {
    /// Puts one arc or far fewer cubics in place of pieces that may be their chords, from the first of these on.
    /// Whether that was all.
    #[inline(never)]
    pub(super) fn fewer_on(
        &mut self,
        first: usize,
        (start, end): (Anchor, Anchor),
        way: &mut Option<Way>,
        room: &mut isize,
    ) -> bool {
        let pieces = &self.outline.pieces[first..];
        let lines = pieces.iter().filter(|&piece| *piece == Piece::Line).count();
        let limit = CUBIC * pieces.len() - (CUBIC - 1) * lines;
        if !self.rule.chords || limit <= CUBIC {
            return true;
        }
        let [most, rms] = [CHORDS[0] * self.rule.most, CHORDS[1] * self.rule.rms];
        if way.is_none() {
            if let Some(arc) = self.arc(start, end, (most, rms)) {
                self.outline.truncate(first);
                self.emit_arc(start, &arc);
                return true;
            }
            if limit <= MANY {
                return true;
            }
        }
        let rule = DivisionRule { most, rms, reach: SEVERAL * self.rule.reach, ..*self.rule };
        let mut none = Outline::default();
        let looser = Divider { rule: &rule, outline: &mut none, ..*self };
        let Some(cubics) = looser.follow(start, end, way, room) else { return false };
        if 3 * CUBIC * cubics.len() <= 2 * limit {
            self.outline.truncate(first);
            self.emit_cubics(cubics);
        }
        true
    }

    /// The arc of a circle that a whole stretch between corners is on.
    fn arc(&self, start: Anchor, end: Anchor, within: (f64, f64)) -> Option<Arc> {
        let gap = self.samples.steps(self.rule.gap);
        let (first, last) = (start.index + gap, end.index - gap);
        let sharp = start.tangent == Tangent::Free && end.tangent == Tangent::Free;
        if !sharp || last - first < FEWEST || end.index - start.index >= 2 * self.longest {
            return None;
        }
        let places = self.samples.stretch(first, last);
        let Arc { circle, turning } = Arc::near(places, within)?;
        let way = |place: Point| place - circle.center;
        let before = turn(way(start.point), way(places[0]));
        let after = turn(way(places[places.len() - 1]), way(end.point));
        Some(Arc { circle, turning: before + turning + after })
    }

    /// An arc from corner to corner as cubics of a quarter turn at most.
    fn emit_arc(&mut self, start: Anchor, &Arc { circle, turning }: &Arc) {
        let count = (turning.abs() / core::f64::consts::FRAC_PI_2).ceil().max(1.0) as usize;
        let angle = turning / count as f64;
        let (sin, cos) = sin_cos(0.25 * angle);
        let from = unit(start.point - circle.center) * circle.radius;
        let node = Node { point: start.point, smooth: false, kept: false };
        circle.follow(self.outline, node, from, (angle, count), 4.0 / 3.0 * sin / cos);
    }
}
