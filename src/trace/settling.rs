//! Tight bends settled: a corner or a smooth way round, whichever the picture says.

use super::bends::{Bend, BendRule, bends};
use super::coverage::{Part, parts};
use super::cubic::Cubic;
use super::outline::Outline;
use super::refine::{Left, Shape};
use super::samples::turn;
use super::sides::{Change, Sides, sides};
use super::simplify::{Limits, Trial};
use crate::error::Result;
use crate::numerics::Point;
use crate::numerics::plane::{dot, square};
use core::cmp::Ordering;

/// The most turning that a smooth piece takes the place of a corner for, in radians.
const MOST: f64 = 1.2;
/// Turning to and fro, or beside a corner, that no bend needs, in radians.
const NEEDLESS: f64 = 0.35;
/// Bends this near each other are one, in pixels.
const SAME: f64 = 0.6;
/// How far from a bend the picture says most of it, in pixels.
const NEAR: f64 = 2.5;
const STEPS: [(usize, f64); 2] = [(3, 5e-4), (5, 5e-4)];
/// What leaves so many times as much after the first steps will not get good.
const HOPELESS: f64 = 6.0;
/// Pieces longer than this may turn back, in pixels.
const LONG: f64 = 6.0;
/// A root mean square beside a bend that asks for nothing better.
const ENOUGH: f64 = 0.0065;

/// The bends of an outline, tried one by one.
#[derive(Clone, Debug)]
pub(super) struct Settling {
    /// Wide bends and then narrow ones.
    rules: [BendRule; 2],
    /// The rule that is next.
    at: usize,
    /// Where this rule's trials were.
    tried: Vec<Point>,
    /// Bends that wait; nothing where the outline has changed.
    found: Option<Vec<Bend>>,
}

impl Settling {
    pub(super) fn new(rule: &BendRule) -> Self {
        let narrow = BendRule { window: 0.55 * rule.window, ..*rule };
        Self { rules: [*rule, narrow], at: 0, tried: Vec::new(), found: None }
    }

    pub(super) fn is_done(&self) -> bool {
        self.at == self.rules.len()
    }

    /// Tries the next bend: it becomes a corner, or a corner a bend, where the picture is explained better, or as well by
    /// less.
    ///
    /// # Cost
    ///
    /// O(pieces of the outline), and O(length of the outline) where it changes.
    pub(super) fn step(&mut self, mut trial: Trial) -> Result<()> {
        let Some(rule) = self.rules.get(self.at) else { return Ok(()) };
        let found = self.found.get_or_insert_with(|| bends(&trial.shape.outline, rule));
        while let Some(bend) = found.pop() {
            if self.tried.iter().any(|&p| square(p - bend.middle) < SAME * SAME) {
                continue;
            }
            self.tried.push(bend.middle);
            if trial.corner(&bend, rule)? || trial.smooth(&bend, rule)? {
                self.found = None;
            }
            return Ok(());
        }
        (self.found, self.at) = (None, self.at + 1);
        self.tried.clear();
        Ok(())
    }
}

impl Trial<'_> {
    /// A corner in place of the bend; whether it was better.
    fn corner(&mut self, bend: &Bend, rule: &BendRule) -> Result<bool> {
        let outline = &self.shape.outline;
        let Some(sides) = sides(outline, bend) else { return Ok(false) };
        let turning = turn(sides.tangents[0], sides.tangents[1]).abs();
        let Some(point) = sides.meet().filter(|_| turning > rule.corner) else { return Ok(false) };
        let (sharp, beside) = self.within(&sides);
        if sharp == 1 && sides.count == 2 && beside < NEEDLESS {
            return Ok(false);
        }
        let needless = bend.total - bend.net.abs() > NEEDLESS || sharp > 1;
        let want = if needless { Want::Tidy } else { Want::Sharp };
        let (good, nearer) = self.exchange(&sides, sides.corner(outline, point), want, rule)?;
        if good || !nearer || self.limits.noise > 0.0 {
            return Ok(good);
        }
        let change = sides.led_corner(&self.shape.outline, point);
        Ok(self.exchange(&sides, change, want, rule)?.0)
    }

    /// A smooth joint in place of the bend; whether it was better.
    fn smooth(&mut self, bend: &Bend, rule: &BendRule) -> Result<bool> {
        let outline = &self.shape.outline;
        let Some(sides) = sides(outline, bend) else { return Ok(false) };
        let (sharp, _) = self.within(&sides);
        let needless = bend.total - bend.net.abs() > NEEDLESS || sides.count > 4;
        if turn(sides.tangents[0], sides.tangents[1]).abs() > MOST || (sharp == 0 && !needless) {
            return Ok(false);
        }
        // A bridge has more that noise could move.
        let change = if self.limits.noise > 0.0 { sides.joint(outline) } else { sides.bridge(outline) };
        Ok(self.exchange(&sides, change, if needless { Want::Tidy } else { Want::Smooth }, rule)?.0)
    }

    /// How many corners there are between the sides, and how much the pieces there turn besides.
    fn within(&self, sides: &Sides) -> (usize, f64) {
        let outline = &self.shape.outline;
        let (mut sharp, mut piece) = (0, sides.pieces[0]);
        let mut beside = 0.0;
        let turning = |cubic: &Cubic| {
            let middle = cubic.velocity(0.5);
            turn(cubic.velocity(0.0), middle).abs() + turn(middle, cubic.velocity(1.0)).abs()
        };
        let whole = |piece: usize| turning(&outline.cubic(piece));
        beside += whole(sides.pieces[0]) - turning(&sides.cubics[0]);
        for step in 1..sides.count {
            piece = outline.next(piece);
            sharp += usize::from(!outline.nodes[piece].smooth);
            if step + 1 < sides.count {
                beside += whole(piece);
            }
        }
        if sides.count > 1 {
            beside += whole(sides.pieces[1]) - turning(&sides.cubics[1]);
        }
        (sharp, beside)
    }

    /// What a piece leaves, and what of it is near a bend.
    fn add(&self, piece: usize, bend: Point, left: &mut [Left; 2]) {
        let (cubic, parts) = (self.shape.outline.cubic(piece), &self.shape.parts[piece]);
        left[0].add(parts, self.field);
        let is_near = |part: &Part| square(cubic.point(f64::from(part.t)) - bend) < NEAR * NEAR;
        let near: Vec<Part> = parts.iter().copied().filter(is_near).collect();
        left[1].add(&near, self.field);
    }

    /// Changes the outline: the sides are its first and last new pieces. If that is not better, all is as it was.
    /// Whether it was better, and whether it was at least as wanted and nearer to the picture beside the bend.
    fn exchange(
        &mut self,
        sides: &Sides,
        change: Change,
        want: Want,
        rule: &BendRule,
    ) -> Result<(bool, bool)> {
        let saved = self.shape.outline.clone();
        let (fresh, corner) = (change.pieces.len(), change.corner);
        let bend = change.between[change.between.len() / 2].point;
        let mut old = [Left::default(); 2];
        let mut piece = saved.before(sides.pieces[0]);
        for _ in 0..(sides.count + 2).min(saved.len()) {
            self.add(piece, bend, &mut old);
            piece = saved.next(piece);
        }
        let gone = self.apply(sides, change);
        let nodes: Vec<usize> = (0..=fresh).collect();
        let mut new = old;
        for steps in STEPS {
            self.refiner.refine(self.field, self.shape, &nodes, steps)?;
            new = [Left::default(); 2];
            let count = self.shape.outline.len();
            // The last piece leads to the first.
            for piece in (0..=fresh).chain((fresh + 1).max(count - 1)..count) {
                self.add(piece, bend, &mut new);
            }
            if new[0].square > HOPELESS * old[0].square.max(limit_of(&new[0], self.limits)) {
                break;
            }
        }
        let outline = &self.shape.outline;
        let turning =
            |i: usize| turn(outline.cubic(i - 1).velocity(1.0), outline.cubic(i).velocity(0.0)).abs();
        let turns = corner.is_none_or(|i| turning(i) > rule.corner);
        let good = turns
            && want.is_met(&new, &old, (sides.count, fresh), self.limits)
            && (0..fresh).all(|i| is_plain(&outline.cubic(i)));
        if !good {
            self.restore(sides, saved, gone, fresh);
        }
        Ok((good, turns && new[1].square < old[1].square))
    }

    /// The changed outline, the first side first; the parts of the pieces that are gone.
    fn apply(&mut self, sides: &Sides, change: Change) -> Vec<Vec<Part>> {
        let outline = &self.shape.outline;
        let first = sides.pieces[0];
        let mut gone = Vec::with_capacity(sides.count);
        let mut at = first;
        for _ in 0..sides.count {
            gone.push(core::mem::take(&mut self.shape.parts[at]));
            at = outline.next(at);
        }
        let Change { between, pieces, .. } = change;
        let fresh = pieces.len();
        let mut changed = Outline { nodes: vec![outline.nodes[first]], pieces };
        changed.nodes.extend(between);
        let mut all: Vec<Vec<Part>> = vec![Vec::new(); fresh];
        while at != first {
            changed.nodes.push(outline.nodes[at]);
            changed.pieces.push(outline.pieces[at]);
            all.push(core::mem::take(&mut self.shape.parts[at]));
            at = outline.next(at);
        }
        changed.nodes[0].kept = false;
        changed.nodes[fresh].kept = false;
        for (i, own) in all.iter_mut().enumerate().take(fresh) {
            parts(&changed.cubic(i), self.field, own);
        }
        self.refiner.sweep.exchange(self.field, &gone.concat(), &all[..fresh].concat());
        self.field.settle();
        self.shape.outline = changed;
        self.shape.parts = all;
        gone
    }

    fn restore(&mut self, sides: &Sides, saved: Outline, gone: Vec<Vec<Part>>, fresh: usize) {
        let Shape { outline, parts: all } = &mut *self.shape;
        let (mut now, mut then) = (all[..fresh].concat(), gone.concat());
        let mut back: Vec<Vec<Part>> = vec![Vec::new(); saved.len()];
        let mut at = sides.pieces[0];
        for own in gone {
            back[at] = own;
            at = saved.next(at);
        }
        for (i, own) in all.iter_mut().enumerate().skip(fresh) {
            let mut own = core::mem::take(own);
            if outline.cubic(i) != saved.cubic(at) {
                now.extend_from_slice(&own);
                parts(&saved.cubic(at), self.field, &mut own);
                then.extend_from_slice(&own);
            }
            back[at] = own;
            at = saved.next(at);
        }
        self.refiner.sweep.exchange(self.field, &now, &then);
        self.field.settle();
        *outline = saved;
        *all = back;
    }
}

/// What may be left of so many pixels, squared.
fn limit_of(left: &Left, limits: &Limits) -> f64 {
    limits.rms * limits.rms * left.count
}

/// What a change is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Want {
    /// A corner where there was none.
    Sharp,
    /// No corner where there was one.
    Smooth,
    /// Less turning.
    Tidy,
}

impl Want {
    /// Whether what is left, of the pieces and near the bend, is as it has to be where so many pieces are replaced by so many.
    fn is_met(
        self,
        new: &[Left; 2],
        old: &[Left; 2],
        (count, fresh): (usize, usize),
        limits: &Limits,
    ) -> bool {
        let noise = limits.noise * limits.noise;
        // As few pieces as before may leave a little more; more pieces have to leave much less.
        let beside = match count.cmp(&fresh) {
            Ordering::Less => 0.5 * old[1].square,
            Ordering::Equal => old[1].square.max(ENOUGH * ENOUGH * new[1].count),
            Ordering::Greater => (1.5 * old[1].square).max(ENOUGH * ENOUGH * new[1].count),
        };
        if noise > 0.0 {
            // A smooth joint has less that noise could move.
            let share = if self == Self::Sharp { 0.0 } else { 6.0 };
            return new[0].square < old[0].square + share * noise;
        }
        match self {
            Self::Sharp => limits.allow(&new[0], &old[0], 1.0) && new[1].square < beside,
            Self::Smooth => new[0].square < old[0].square && new[1].square < 1.5 * beside,
            Self::Tidy => {
                let enough = new[1].square < 1.5 * beside || new[0].square < old[0].square;
                limits.allow(&new[0], &old[0], 1.0) && enough
            }
        }
    }
}

/// Whether a piece does not run against its own tangents; long ones may turn back.
fn is_plain(cubic: &Cubic) -> bool {
    let chord = cubic.end - cubic.start;
    let along = [cubic.leaving, cubic.velocity(0.5), cubic.arriving];
    square(chord) > LONG * LONG || along.iter().all(|&way| dot(way, chord) >= 0.0)
}
