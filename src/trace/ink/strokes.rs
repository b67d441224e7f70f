//! What is all ink in a drawing of strokes so thin that no pixel need be all ink.
//!
//! The darkest pixel of such strokes lacks of their ink what it lacks of being covered: taken for ink it makes them as
//! much too thick. But it may show the ink, too, if that is gray. So outlines are refined by inks between that shade
//! and black, or white on a dark ground, and the one that explains the picture best is the ink (D 14.28). Where many
//! do, as where all strokes run along rows or columns, it is black or white.

use super::{InkWork, Kind, Phase};
use crate::error::Result;
use crate::limits::probe;
use crate::numerics::Point;
use crate::numerics::order::sort_by_number;
use crate::numerics::plane::{larger, smaller};
use crate::trace::outline::Outline;
use crate::trace::picture::gray::Gray;
use crate::trace::picture::tones::Tones;

/// The extreme shades.
const BLACK: f64 = 0.0;
const WHITE: f64 = 65_280.0;
/// What the rounding of bytes leaves, in shades, with a little more: nothing can be better.
const EXACT: f64 = 192.0;
/// Along rows and columns the ink that was seen leaves no more than this, in shades, whatever the ink is: the extreme
/// one is it if it leaves no more than that, as outlines that it shrinks have some steps left then.
const NOTHING: f64 = 64.0;
const PERHAPS: f64 = 1024.0;
/// Elsewhere the ink that was seen is better than the extreme one if that leaves so many times as much: of gray strokes
/// 1.2 and 1.5 pixels wide it mostly leaves 2 to 20 times as much, of black ones of .85 pixels and more hardly ever so
/// much.
const CLEARLY: f64 = 1.6;
/// The extreme ink may leave so many times as much as the best, and so much more, in shades: of strokes half a pixel
/// wide it leaves up to 2.1 times as much where it is the ink, and from 2.6 times on where the ink is gray.
const AS_WELL: f64 = 2.2;
const LITTLE: f64 = 64.0;
/// Inks that are tried, at most.
const MOST: usize = 5;
/// Every ink is at least this part of a stretch away from its ends.
const APART: f64 = 0.1;
/// Outlines begin so far inside a pixel that has ink beside one that has none, of which at most this share: a side in
/// the pixel without ink would not be called into the other.
const INSIDE: f64 = 0.2;
const NO_INK: f64 = 0.1;
/// Contours are followed so far from paper to the darkest shade: half-way, strokes would break where they run between
/// two rows of pixels.
const LEVEL: f64 = 0.4;
/// Strokes are lifted while their contours are looked for if the darkest shade is so far on the way from paper to the
/// extreme one: where it is farther from that, the picture is soft or its ink gray, and nothing breaks.
const DARK: f64 = 0.7;

/// What outlines of lifted strokes have of the area of their contours, at least; where there is as much as that, others
/// are as large as they are.
const LIFTED: f64 = 0.45;

/// The inks on trial.
#[derive(Debug)]
pub(super) struct Strokes {
    seen: Tones,
    inverted: bool,
    /// The outlines before they are refined.
    first: Vec<Outline>,
    /// The ink on trial, and those that were tried, with what they left: 0 is the darkest shade that was seen, 1 the
    /// extreme one.
    depth: f64,
    tried: Vec<(f64, f64)>,
}

impl Strokes {
    /// Of tones that were seen; none if the ink is the extreme shade.
    pub(super) fn new(seen: Tones, inverted: bool) -> Option<Self> {
        let strokes = Self { seen, inverted, first: Vec::new(), depth: 1.0, tried: Vec::new() };
        (strokes.tones() != seen).then_some(strokes)
    }

    /// The shade that contours are followed at.
    pub(super) fn level(&self) -> f64 {
        let Tones { ink, paper, .. } = self.seen;
        if self.inverted { ink + LEVEL * (paper - ink) } else { paper - LEVEL * (paper - ink) }
    }

    /// Whether the darkest shade is so near the extreme one that the rest is hardly gray.
    pub(super) fn is_dark(&self) -> bool {
        let Tones { ink, paper, .. } = self.seen;
        let [seen, all] =
            if self.inverted { [paper - ink, WHITE - ink] } else { [paper - ink, paper - BLACK] };
        seen >= DARK * all
    }

    /// The tones with the ink on trial.
    fn tones(&self) -> Tones {
        let Tones { ink, paper, noise } = self.seen;
        let [dark, light] = if self.inverted {
            [ink, paper + self.depth * (WHITE - paper)]
        } else {
            [ink + self.depth * (BLACK - ink), paper]
        };
        Tones { ink: dark, paper: light, noise: noise * (paper - ink) / (light - dark) }
    }

    /// The ink on trial left so much, in shades: what becomes of it.
    fn judge(&mut self, left: f64) -> Verdict {
        self.tried.push((self.depth, left));
        self.depth = match *self.tried.as_slice() {
            [(_, extreme)] if extreme <= EXACT => return Verdict::Stays,
            [_] => 0.0,
            [(_, extreme), (_, seen)] if seen <= EXACT => {
                let most = if seen <= NOTHING { PERHAPS } else { CLEARLY * seen };
                self.depth = if extreme <= most { 1.0 } else { 0.0 };
                return if extreme <= most { Verdict::Returns } else { Verdict::Stays };
            }
            [(_, extreme), (_, seen)] => (seen / (seen + extreme)).clamp(APART, 1.0 - APART),
            _ if self.tried.len() < MOST && left > EXACT => self.between(),
            _ => {
                let last = self.depth;
                self.depth = self.best();
                return if self.depth == last { Verdict::Stays } else { Verdict::Returns };
            }
        };
        Verdict::Another
    }

    /// The ink that left least, or the extreme one, if that is as good and the one that was seen is not clearly better.
    fn best(&self) -> f64 {
        let least = |best: (f64, f64), &one: &(f64, f64)| if one.1 < best.1 { one } else { best };
        let [(_, extreme), (_, seen), ..] = *self.tried.as_slice() else { return 1.0 };
        let best = self.tried.iter().fold((1.0, f64::MAX), least);
        if extreme <= AS_WELL * best.1 + LITTLE && extreme <= CLEARLY * seen { 1.0 } else { best.0 }
    }

    /// An ink beside the best one: at the vertex of the parabola through it and its neighbours, or half-way to its only
    /// neighbour.
    fn between(&self) -> f64 {
        let mut inks = self.tried.clone();
        sort_by_number(&mut inks, &|ink| ink.0);
        let best = (0..inks.len()).fold(0, |best, i| if inks[i].1 < inks[best].1 { i } else { best });
        let last = inks.len() - 1;
        if best == 0 || best == last {
            return 0.5 * (inks[best].0 + inks[if best == 0 { 1 } else { last - 1 }].0);
        }
        let [(a, before), (b, least), (c, after)] = [inks[best - 1], inks[best], inks[best + 1]];
        let (p, q) = ((b - a) * (least - after), (b - c) * (least - before));
        let vertex = b - 0.5 * ((b - a) * p - (b - c) * q) / (p - q).min(-1e-12);
        // Beside the best, where that is the vertex.
        let [left, right] = [b - APART * (b - a), b + APART * (c - b)];
        let beside = if vertex < b { vertex.min(left) } else { vertex.max(right) };
        smaller(larger(beside, a + APART * (b - a)), c - APART * (c - b))
    }
}

/// What becomes of an ink on trial: it stays, another one is tried, or the best of all stays.
#[derive(PartialEq)]
enum Verdict {
    Stays,
    Another,
    Returns,
}

impl InkWork {
    /// Begins the trial with first outlines, if all of them are of coverage; else the tones are those that were seen.
    pub(super) fn try_inks(&mut self) -> Result<()> {
        let covered = self.kinds.iter().all(|&kind| kind == Kind::Covered);
        let Some(strokes) = self.strokes.as_mut().filter(|_| covered) else {
            self.strokes = None;
            return Ok(());
        };
        probe(self.outlines.iter().map(Outline::bytes).sum())?;
        strokes.first = self.outlines.clone();
        self.tones = strokes.tones();
        Ok(())
    }

    /// Outlines that were refined by the ink on trial leave so much of coverage: it stays, or it begins again with
    /// another one.
    pub(super) fn judge_ink(&mut self, left: f64) -> Result<()> {
        let Some(strokes) = &mut self.strokes else { return Ok(()) };
        let verdict = strokes.judge(left * (self.tones.paper - self.tones.ink));
        self.tones = strokes.tones();
        if verdict == Verdict::Stays {
            self.strokes = None;
            self.gray.clear();
            return Ok(());
        }
        if verdict == Verdict::Returns {
            self.outlines = core::mem::take(&mut strokes.first);
            self.strokes = None;
        } else {
            self.outlines = strokes.first.clone();
        }
        // Both refinements together would take twice the memory.
        self.phase = Phase::Splines;
        self.refinement(Kind::Covered)
    }

    /// The share of its darkest pixel that the thickest stroke covers, at most: outlines have about this share of the
    /// area of their contours.
    pub(super) fn covered(&self) -> f64 {
        if self.lifted {
            return LIFTED;
        }
        let seen = self.trace.tones;
        (seen.paper - seen.ink) / (self.tones.paper - self.tones.ink)
    }
}

/// Moves points of a contour to where there is some ink of the pixels beside them, unless one of these is full.
pub(super) fn move_inside(contour: &mut [Point], gray: &Gray, tones: &Tones, (inverted, full): (bool, f64)) {
    let all = tones.paper - tones.ink;
    let ink = |column: f64, row: f64| {
        let inside =
            column >= 0.0 && row >= 0.0 && column < gray.width() as f64 && row < gray.height() as f64;
        let shade = if inside { gray.shade(column as usize, row as usize) } else { return 0.0 };
        if inverted { (shade - tones.ink) / all } else { (tones.paper - shade) / all }
    };
    for p in contour {
        let (x, y) = (p.x.floor(), p.y.floor());
        // One coordinate is that of the centres of two pixels: the other says how far the point is from the first of
        // them.
        let upright = p.x - x == 0.5;
        let at = if upright { p.y } else { p.x };
        let first = (at - 0.5).floor();
        let [before, after] = [0.0, 1.0].map(|k| if upright { ink(x, first + k) } else { ink(first + k, y) });
        let border = first + 1.0;
        let moved = if larger(before, after) >= full {
            continue;
        } else if before < NO_INK && before < after {
            larger(at, border + INSIDE)
        } else if after < NO_INK && after < before {
            smaller(at, border - INSIDE)
        } else {
            continue;
        };
        if upright { p.y = moved } else { p.x = moved }
    }
}
