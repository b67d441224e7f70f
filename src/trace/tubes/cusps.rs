//! Cusps of a chain: where its tangent jumps.

use super::chain::Chain;
use super::parabola::Parabola;
use crate::error::Result;
use crate::limits::{LARGEST_COORDINATE, check, with_room};
use crate::numerics::Point;
use crate::numerics::order::sort_numbers;
use crate::numerics::plane::norm;
use crate::trace::samples::{Line, line_through, turn};

/// What a cusp of a chain is, in pixels and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CuspRule {
    /// How much of both sides next to the place is not looked at: 0 for pixels, 1 and more where edges were blurred.
    pub gap: f64,
    /// How much of both sides is looked at.
    pub window: f64,
    /// The least turning.
    pub angle: f64,
    /// How far from the chain both sides may meet.
    pub reach: f64,
}

/// A cusp near a point of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cusp {
    /// The index of the point.
    pub index: usize,
    /// Where the lines along both sides meet.
    pub point: Point,
}

/// One side of a place.
struct Wing {
    points: Vec<Point>,
    parabola: Parabola,
    forward: bool,
}

impl Wing {
    /// The line through the side, in the order of the chain.
    fn line(&self) -> Line {
        let line = line_through(&self.points);
        let direction = if self.forward { line.direction } else { -line.direction };
        Line { direction, ..line }
    }
}

impl Chain {
    /// The cusps, by index.
    ///
    /// Both sides of a point are followed by a line and by a parabola. The turning between the lines, or 1.6 times that
    /// between the parabolas' tangents at the point if it is less, has to be a local maximum over the window and at
    /// least the rule's angle (D 14.5). Where the lines meet farther from the chain than the rule's reach it is a small
    /// round and no cusp.
    ///
    /// # Errors
    ///
    /// Numbers of the rule out of range.
    ///
    /// # Cost
    ///
    /// O(points in the windows).
    pub fn cusps(&self, rule: &CuspRule) -> Result<Vec<Cusp>> {
        check("gap", None, rule.gap, 0.0, LARGEST_COORDINATE)?;
        check("window", None, rule.window, 1e-9, LARGEST_COORDINATE)?;
        check("angle", None, rule.angle, 0.05, core::f64::consts::PI)?;
        check("reach", None, rule.reach, 0.0, LARGEST_COORDINATE)?;
        let count = self.points().len();
        let mut scores = with_room(count)?;
        // Beside a sharp corner the lines are as good as at it: the nearest place counts.
        scores.extend((0..count).map(|i| match self.sharpness(i, rule) {
            score if score < rule.angle => 0.0,
            score => score - 0.02 * self.meeting(i, rule).map_or(f64::MAX, |p| norm(p - self.points()[i])),
        }));
        let mut found = Vec::new();
        for i in 0..count {
            if scores[i] > 0.0
                && self.is_sharpest(i, &scores, rule.window.max(2.2))
                && let Some(point) = self.meeting(i, rule)
            {
                found.push(Cusp { index: i, point });
            }
        }
        Ok(found)
    }

    /// The points on one side of point i with their distances from it along the chain, nearest first; `None` where the
    /// side is not long enough.
    fn wing(&self, i: usize, rule: &CuspRule, forward: bool) -> Option<Wing> {
        let here = self.points()[i];
        let mut wing = Wing { points: Vec::new(), parabola: Parabola::new(), forward };
        let mut travelled = 0.0;
        let mut add = |distance: f64, p: Point| {
            travelled = distance.abs();
            if travelled >= rule.gap {
                wing.points.push(p);
                wing.parabola.add(distance, p - here);
            }
        };
        add(0.0, here);
        self.side(i, rule.gap + rule.window, forward, &mut add);
        (wing.points.len() >= 2 && travelled >= rule.gap + 0.5 * rule.window).then_some(wing)
    }

    fn sharpness(&self, i: usize, rule: &CuspRule) -> f64 {
        let (Some(before), Some(after)) = (self.wing(i, rule, false), self.wing(i, rule, true)) else {
            return 0.0;
        };
        let lines = turn(before.line().direction, after.line().direction);
        let (Some([_, before, _]), Some([_, after, _])) = (before.parabola.solve(), after.parabola.solve())
        else {
            return lines.abs();
        };
        let tangents = turn(before, after);
        if lines * tangents < 0.0 && lines.abs() < 2.0 {
            return 0.0;
        }
        lines.abs().min(1.6 * tangents.abs())
    }

    /// Whether no point within `apart` scores higher; of equal ones the first counts.
    fn is_sharpest(&self, i: usize, scores: &[f64], apart: f64) -> bool {
        let mut sharpest = true;
        for forward in [false, true] {
            let mut at = i;
            let mut travelled = 0.0;
            for _ in 1..scores.len() {
                let Some(next) = self.step(at, forward) else { break };
                travelled += norm(self.points()[next] - self.points()[at]);
                if travelled >= apart {
                    break;
                }
                at = next;
                sharpest &= if forward { scores[i] >= scores[at] } else { scores[i] > scores[at] };
            }
        }
        sharpest
    }

    fn meeting(&self, i: usize, rule: &CuspRule) -> Option<Point> {
        let (before, after) = (self.wing(i, rule, false)?, self.wing(i, rule, true)?);
        let (first, second) = (before.line(), after.line());
        let here = self.points()[i];
        // Pixels and blur cut more off a sharp tip than off a right angle.
        let half = 0.5 * turn(first.direction, second.direction).abs();
        let (sine, cosine) = crate::numerics::angle::sin_cos(half);
        let reach = rule.reach * (0.5 + 0.5 * sine / cosine.max(0.15)).min(2.5);
        let point = first.meets(&second)?;
        (norm(point - here) <= reach).then_some(point)
    }

    /// How far points are off the chain, as a standard deviation: the root mean square distance of each from the line
    /// through its neighbours, without the largest twentieth, over √1.5.
    ///
    /// The middle of the distances would not do: along straight rows of pixels most of them are 0.
    pub fn noise(&self) -> f64 {
        let mut squares: Vec<f64> = Vec::new();
        for (i, &p) in self.points().iter().enumerate() {
            if let (Some(before), Some(after)) = (self.step(i, false), self.step(i, true)) {
                let (a, b) = (self.points()[before], self.points()[after]);
                let chord = norm(b - a);
                let off = if chord > 0.0 { crate::numerics::plane::cross(b - a, p - a) / chord } else { 0.0 };
                squares.push(off * off);
            }
        }
        sort_numbers(&mut squares);
        squares.truncate(squares.len() - squares.len() / 20);
        (squares.iter().sum::<f64>() / (1.5 * squares.len().max(1) as f64)).sqrt()
    }
}
