//! Tight bends settled: a corner or a smooth way round, whichever the picture says.

use super::bends::{Bend, BendRule, Looking, Place, Sweeping};
use super::coverage::Part;
use super::field::Field;
use super::left::Left;
use super::refine::{Descent, Shape};
use super::sides::{Change, Sides, sides};
use super::trial::{Limits, Trial};
use super::window::{Stretch, Window};
use crate::error::Result;
use crate::numerics::order::sort_by_number;
use crate::numerics::plane::{dot, square};
use crate::numerics::{Point, Vector};
use crate::trace::outline::Outline;
use crate::trace::outline::cubic::Cubic;
use crate::trace::samples::turn;
use core::cmp::Ordering;

/// The most turning that a smooth piece takes the place of a corner for, in radians.
const MOST: f64 = 1.2;
/// Turning to and fro, or beside a corner, that no bend needs, in radians.
const NEEDLESS: f64 = 0.35;
/// An outline of so many pieces is looked through to its end before bends are found anew, and that at most so often. A
/// shorter one begins with its last change: so what has been changed comes last.
const MANY: usize = 256;
const MOST_ROUNDS: usize = 12;
/// Bends this near each other are one, in pixels.
const SAME: f64 = 0.6;
/// How far from a bend the picture says most of it, in pixels.
const NEAR: f64 = 2.5;
const STEPS: [(usize, f64); 2] = [(3, 5e-4), (5, 5e-4)];
/// What leaves so many times as much after the first steps will not get good.
const HOPELESS: f64 = 6.0;
/// A corner that turns by less than this share of what it has to, after any step, will not turn by more: of the 154
/// that were good on 240 drawings of 64, 256 and 1024 pixels none had less than .99 on its way; 599 of the 1,019 others
/// have.
const FLAT: f64 = 0.9;
/// What turns to and fro by so much more than before will not become calm, in radians: on the way to what was good it
/// was .45 at most.
const WILD: f64 = 0.55;
/// Pieces longer than this may turn back, in pixels.
const LONG: f64 = 6.0;
/// A root mean square beside a bend that asks for nothing better.
const ENOUGH: f64 = 0.0065;

/// What a bend is tried as.
#[derive(Clone, Copy, Debug)]
enum Form {
    /// A corner where its sides meet as they are.
    Corner,
    /// A corner to which its sides are led on.
    LedCorner,
    /// A smooth way round.
    Smooth,
}

/// The bends of an outline, tried one by one.
#[derive(Clone, Debug)]
pub(super) struct Settling {
    /// Wide bends and then narrow ones.
    rules: [BendRule; 2],
    /// The rule that is next.
    at: usize,
    /// How often this rule has gone through the outline.
    round: usize,
    /// Where this rule's trials were: in the rounds before in order, and in this one.
    tried: Vec<Point>,
    fresh: Vec<Point>,
    /// Places of the outline, from which bends are to be found.
    looking: Looking,
    places: Option<Vec<Place>>,
    sweeping: Sweeping,
    /// Bends that wait: those before a piece, where the outline has changed since they were found.
    found: Option<Vec<Bend>>,
    until: usize,
    /// The bend that was no better, and what it is tried as next.
    trying: Option<(Bend, Form)>,
}

impl Settling {
    pub(super) fn new(rule: &BendRule) -> Self {
        let narrow = BendRule { window: 0.55 * rule.window, ..*rule };
        Self {
            rules: [*rule, narrow],
            at: 0,
            round: 0,
            tried: Vec::new(),
            fresh: Vec::new(),
            looking: Looking::default(),
            places: None,
            sweeping: Sweeping::default(),
            found: None,
            until: usize::MAX,
            trying: None,
        }
    }

    pub(super) fn is_done(&self) -> bool {
        self.at == self.rules.len()
    }

    /// Tries the next bend as a corner, or the one that is none as a smooth way round: whichever explains the picture
    /// better, or as well by less.
    ///
    /// # Cost
    ///
    /// O(length of the pieces beside the bend), and O(pieces of the outline) where that changes.
    pub(super) fn step(&mut self, trial: &mut Trial) -> Result<()> {
        let Some(rule) = self.rules.get(self.at) else { return Ok(()) };
        let Some(found) = &mut self.found else {
            let outline = &trial.shape.outline;
            match &self.places {
                Some(places) => {
                    self.found = self.sweeping.step(outline, places, rule);
                    if self.found.is_some() {
                        (self.places, self.sweeping) = (None, Sweeping::default());
                    }
                }
                None => self.places = self.looking.step(outline),
            }
            return Ok(());
        };
        if let Some((bend, form)) = self.trying.take() {
            return self.attempt(bend, form, trial);
        }
        while let Some(bend) = found.pop() {
            let [(first, _), (last, _)] = bend.sides;
            if first.max(last) >= self.until || is_known(&self.tried, bend.middle) {
                continue;
            }
            self.fresh.push(bend.middle);
            return self.attempt(bend, Form::Corner, trial);
        }
        self.round += 1;
        let over = self.until == usize::MAX || self.round == MOST_ROUNDS;
        self.look_again();
        if over {
            (self.at, self.round) = (self.at + 1, 0);
            self.tried.clear();
        }
        Ok(())
    }

    /// Tries a bend in one form; if that is no better, another is next.
    fn attempt(&mut self, bend: Bend, form: Form, trial: &mut Trial) -> Result<()> {
        let Some(rule) = self.rules.get(self.at) else { return Ok(()) };
        let [(first, _), (last, _)] = bend.sides;
        let inside = first <= last && last + 1 < trial.shape.outline.len();
        let (good, next) = match form {
            Form::Corner => trial.corner(&bend, rule, false)?,
            Form::LedCorner => trial.corner(&bend, rule, true)?,
            Form::Smooth => (trial.smooth(&bend, rule)?, None),
        };
        if good {
            // Pieces well before the bend keep their numbers.
            self.until = if inside { first.saturating_sub(2) } else { 0 };
            if trial.shape.outline.len() < MANY {
                self.look_again();
            }
        } else {
            self.trying = next.map(|form| (bend, form));
        }
        Ok(())
    }

    /// Bends are to be found anew.
    fn look_again(&mut self) {
        (self.looking, self.found, self.until) = (Looking::default(), None, usize::MAX);
        self.tried.append(&mut self.fresh);
        sort_by_number(&mut self.tried, &|place| place.y);
    }
}

/// Whether one of the places, which are sorted by y, is as good as the same.
fn is_known(places: &[Point], place: Point) -> bool {
    let from = places.partition_point(|known| known.y <= place.y - SAME);
    let near = places[from..].iter().take_while(|known| known.y < place.y + SAME);
    near.into_iter().any(|&known| square(known - place) < SAME * SAME)
}

impl Trial<'_> {
    /// A corner in place of the bend, its sides led on to it or not; whether it was better, and what is to be tried
    /// next otherwise.
    fn corner(&mut self, bend: &Bend, rule: &BendRule, led: bool) -> Result<(bool, Option<Form>)> {
        let smooth = (false, Some(Form::Smooth));
        let outline = &self.shape.outline;
        let Some(sides) = sides(outline, bend) else { return Ok(smooth) };
        let turning = turn(sides.tangents[0], sides.tangents[1]).abs();
        let Some(point) = sides.meet().filter(|_| turning > rule.corner) else { return Ok(smooth) };
        let (sharp, beside) = self.within(&sides);
        if sharp == 1 && sides.count == 2 && beside < NEEDLESS {
            return Ok(smooth);
        }
        let needless = bend.total - bend.net.abs() > NEEDLESS || sharp > 1;
        let want = if needless { Want::Tidy } else { Want::Sharp };
        let change = if led { sides.led_corner(outline, point) } else { sides.corner(outline, point) };
        let (good, nearer) = self.exchange(&sides, change, want, rule)?;
        let again = !led && nearer && self.limits.noise == 0.0;
        Ok((good, Some(if again { Form::LedCorner } else { Form::Smooth })))
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

    /// Changes the outline: the sides are its first and last new pieces. If that is not better, all is as it was.
    /// Whether it was better, and whether it was at least as wanted and nearer to the picture beside the bend.
    fn exchange(
        &mut self,
        sides: &Sides,
        change: Change,
        want: Want,
        rule: &BendRule,
    ) -> Result<(bool, bool)> {
        let (fresh, corner) = (change.pieces.len(), change.corner);
        let bend = change.between[change.between.len() / 2].point;
        let outline = &self.shape.outline;
        let mut old = [Left::default(); 2];
        let mut piece = outline.before(sides.pieces[0]);
        for _ in 0..(sides.count + 2).min(outline.len()) {
            add(self.shape, self.field, piece, bend, &mut old);
            piece = outline.next(piece);
        }
        if want == Want::Smooth && self.limits.noise == 0.0 && old[1].rms() <= ENOUGH {
            return Ok((false, false));
        }
        let then = turning(outline, sides.pieces[0], sides.count);
        let stretch = Stretch {
            first: sides.pieces[0],
            count: sides.count,
            pieces: change.pieces,
            between: change.between,
        };
        let mut window = Window::open(self.refiner, self.field, self.shape, stretch);
        window.shape.outline.nodes[0].kept = false;
        window.shape.outline.nodes[fresh].kept = false;
        let new = self.pursue(&mut window, (want, bend), (&old[0], then), (corner, rule.corner))?;
        let (turns, good) = match &new {
            None => (false, false),
            Some(new) => {
                let outline = &window.shape.outline;
                let turns = turns(outline, corner, rule.corner);
                let calm = turning(outline, 0, fresh) < then + NEEDLESS;
                let met = want.is_met(new, &old, (sides.count, fresh), (self.limits, rule.evidence));
                (turns, turns && calm && met && (0..fresh).all(|i| is_plain(&outline.cubic(i))))
            }
        };
        if good {
            let first = window.keep(self.field, self.shape);
            if self.shape.outline.len() < MANY {
                self.shape.begin_at(first);
            }
        } else {
            window.close(self.refiner, self.field);
        }
        Ok((good, turns && new.is_some_and(|[_, new]| new.square < old[1].square)))
    }

    /// Refines the new pieces of a window: what they leave, and near the bend, with the pieces beside them. Nothing, if
    /// on the way they are where nothing good has come from.
    fn pursue(
        &mut self,
        window: &mut Window,
        (want, bend): (Want, Point),
        (old, then): (&Left, f64),
        (corner, least): (Option<usize>, f64),
    ) -> Result<Option<[Left; 2]>> {
        let (shape, fresh, clean) = (&mut window.shape, window.fresh, self.limits.noise == 0.0);
        let nodes: Vec<usize> = (0..=fresh).collect();
        let mut new = [Left::default(); 2];
        for steps in STEPS {
            let mut descent = Descent::new(steps);
            let mut goes_on = true;
            while goes_on {
                goes_on = self.refiner.descend(self.field, shape, &nodes, &mut descent)?;
                let outline = &shape.outline;
                let wild = || want != Want::Tidy && turning(outline, 0, fresh) > then + WILD;
                if clean && (!turns(outline, corner, FLAT * least) || wild()) {
                    return Ok(None);
                }
            }
            new = [Left::default(); 2];
            let count = shape.outline.len();
            // The last piece leads to the first.
            for piece in (0..=fresh).chain((fresh + 1).max(count - 1)..count) {
                add(shape, self.field, piece, bend, &mut new);
            }
            if new[0].square > HOPELESS * old.square.max(limit_of(&new[0], self.limits)) {
                break;
            }
        }
        Ok(Some(new))
    }
}

/// Whether the new corner, if there is one, turns by more than an angle.
fn turns(outline: &Outline, corner: Option<usize>, least: f64) -> bool {
    let turning = |i: usize| turn(outline.cubic(i - 1).velocity(1.0), outline.cubic(i).velocity(0.0)).abs();
    corner.is_none_or(|i| turning(i) > least)
}

/// What a piece leaves, and what of it is near a bend.
fn add(shape: &Shape, field: &Field, piece: usize, bend: Point, left: &mut [Left; 2]) {
    let (cubic, parts) = (shape.outline.cubic(piece), &shape.parts[piece]);
    left[0].add(parts, field);
    if is_far(&cubic, bend) {
        return;
    }
    let is_near = |part: &&Part| square(cubic.point(f64::from(part.t)) - bend) < NEAR * NEAR;
    left[1].add_some(parts.iter().filter(is_near), field);
}

/// Whether a piece stays on one side of what is near a bend: it is where its control points are.
fn is_far(cubic: &Cubic, bend: Point) -> bool {
    let ways =
        [cubic.start, cubic.start + cubic.leaving, cubic.end - cubic.arriving, cubic.end].map(|p| p - bend);
    let beyond = |far: fn(&Vector) -> bool| ways.iter().all(far);
    beyond(|way| way.x > NEAR)
        || beyond(|way| way.x < -NEAR)
        || beyond(|way| way.y > NEAR)
        || beyond(|way| way.y < -NEAR)
}

/// How much so many pieces turn, to and fro, and the joints between them.
pub(super) fn turning(outline: &Outline, first: usize, count: usize) -> f64 {
    let (mut sum, mut piece) = (0.0, first);
    let mut way = outline.cubic(first).velocity(0.0);
    for _ in 0..count {
        let cubic = outline.cubic(piece);
        for k in 0..=4 {
            let next = cubic.velocity(0.25 * f64::from(k));
            sum += turn(way, next).abs();
            way = next;
        }
        piece = outline.next(piece);
    }
    sum
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
    /// Whether what is left, of the pieces and near the bend, is as it has to be where so many pieces are replaced by
    /// so many.
    fn is_met(
        self,
        new: &[Left; 2],
        old: &[Left; 2],
        (count, fresh): (usize, usize),
        (limits, evidence): (&Limits, f64),
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
            let share = if self == Self::Sharp { -evidence } else { 6.0 };
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
