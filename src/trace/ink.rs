//! Logos and drawings: outlines of ink, as few pieces as their coverage allows.

mod first_outlines;
mod looking;
mod specks;
mod strokes;

use self::first_outlines::{ROUND, sampled};
use self::strokes::Strokes;
use super::agreement::Comparison;
use super::options::TraceOptions;
use super::outline::Outline;
use super::outline::arcs::arcs;
use super::outline::corners::{Corner, corners};
use super::outline::division::{Division, DivisionRule};
use super::outline::ellipse::{ellipse, round};
use super::outline::rounds::Rounding;
use super::picture::blur::Blurring;
use super::picture::contour::{Contour, ContourScan};
use super::picture::gray::Gray;
use super::picture::lifting::Lifting;
use super::picture::light::Evening;
use super::picture::ridges::Ridges;
use super::picture::tones::{ToneScan, Tones};
use super::quality::Quality;
use super::refinement::field::Shading;
use super::refinement::{Other, Pixels, Refinement};
use super::samples::Samples;
use super::work::{Progress, Stage, Trace, TracedContour, Work};
use crate::curve::HermiteCurve;
use crate::error::Result;
use crate::limits::probe;
use crate::numerics::Point;
use crate::numerics::plane::larger;

/// An outline may be at most so many times farther from an arc of a circle, with which less of it could be compared.
const BENT: f64 = 4.0;

/// Outlines of ink on their way.
#[derive(Debug)]
pub(super) struct InkWork {
    gray: Gray,
    options: TraceOptions,
    phase: Phase,
    progress: Progress,
    tones: Tones,
    quality: Quality,
    /// The blur of a soft picture, a deviation in pixels.
    softness: f64,
    /// What may be ink, until that is known.
    strokes: Option<Strokes>,
    /// What pixels say of each outline, and of those that are refined now.
    kinds: Vec<Kind>,
    kind: Kind,
    /// How near outlines are to what they are: those of coverage, and sampled ones.
    nearness: [Nearness; 2],
    /// What blurs the picture while contours are looked for in it.
    blurring: Option<Blurring>,
    /// What lifts thin strokes beside others meanwhile, and whether it did.
    lifting: Option<Lifting>,
    /// And what lifts them in noise.
    ridges: Option<Ridges>,
    lifted: bool,
    found: Vec<Contour>,
    /// Whether the contour that is looked at goes between pixels of two tones by now.
    between: bool,
    /// Places along the contour that is being looked at.
    samples: Option<Samples>,
    corners: Vec<Vec<Corner>>,
    /// The contour whose first outline is on its way.
    division: Option<Division>,
    /// Corners of the contour whose coarser outline is on its way.
    rough_corners: Option<Vec<Corner>>,
    outlines: Vec<Outline>,
    /// Arcs that are looked for in an outline.
    rounding: Option<Rounding>,
    /// The curve that is being compared with its contour.
    compared: Option<Box<Compared>>,
    trace: Trace,
    offer: Option<f64>,
}

/// A curve, its cusps, and how far it is from its contour, once that is looked at.
#[derive(Debug)]
struct Compared {
    curve: HermiteCurve,
    cusps: Vec<Point>,
    comparison: Option<Comparison>,
}

/// How near an outline is to an ellipse or an arc that it is.
#[derive(Clone, Copy, Debug)]
struct Nearness {
    /// How many times farther it may be from an ellipse than in a picture of exact coverage.
    slack: f64,
    /// How far a piece may be from an arc, in pixels.
    bow: f64,
}

/// What pixels say of an outline, in the order in which outlines are refined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// How much of them is inside.
    Covered,
    /// Whether their centre is inside.
    Sampled,
    /// They are squares, which it goes around.
    Stairs,
}

/// What is done next.
#[derive(Debug)]
enum Phase {
    Light(Evening),
    Tones(ToneScan),
    Contours(ContourScan),
    Corners,
    Splines,
    Refinement(Box<Refinement>),
    Curves,
}

impl InkWork {
    pub(super) fn new(gray: Gray, options: TraceOptions) -> Result<Self> {
        let tones = Tones { ink: 0.0, paper: 65_280.0, noise: 0.0 };
        let total = gray.height();
        let phase = if options.finds_light() {
            Phase::Light(Evening::new(&gray)?)
        } else {
            Phase::Tones(ToneScan::new(options.threshold.map(|shade| shade as usize)))
        };
        Ok(Self {
            gray,
            options,
            phase,
            progress: Progress { done: false, stage: Stage::Edges, completed: 0, total },
            tones,
            quality: Quality::Clean,
            softness: 0.0,
            strokes: None,
            kinds: Vec::new(),
            kind: Kind::Covered,
            nearness: [Nearness { slack: Quality::Clean.slack(), bow: 0.0 }; 2],
            blurring: None,
            lifting: None,
            ridges: None,
            lifted: false,
            found: Vec::new(),
            between: false,
            samples: None,
            corners: Vec::new(),
            division: None,
            rough_corners: None,
            outlines: Vec::new(),
            rounding: None,
            compared: None,
            trace: Trace { contours: Vec::new(), tones, residual: 0.0 },
            offer: None,
        })
    }

    fn enter(&mut self, phase: Phase, stage: Stage, total: usize) {
        self.phase = phase;
        self.progress = Progress { done: false, stage, completed: 0, total };
    }

    /// The shade between ink and paper.
    fn level(&self) -> f64 {
        self.options.threshold.map_or(self.tones.middle(), |shade| 256.0 * shade)
    }

    /// Begins to refine the outlines of a kind, while the others stay; without outlines of that kind, those of the
    /// next.
    fn refinement(&mut self, kind: Kind) -> Result<()> {
        let is_there = |kind: Kind| self.kinds.contains(&kind);
        let Some(kind) =
            [Kind::Covered, Kind::Sampled].into_iter().find(|&next| next >= kind && is_there(next))
        else {
            if self.progress.stage != Stage::Refinement {
                self.enter(Phase::Curves, Stage::Refinement, self.found.len());
            }
            self.phase = Phase::Curves;
            return Ok(());
        };
        let (ink, paper) = (self.tones.ink, self.tones.paper);
        let level = if kind == Kind::Sampled { self.tones.middle() } else { self.level() };
        let level = level.max(ink + 0.05 * (paper - ink)).min(paper - 0.05 * (paper - ink));
        let shading = Shading { ink, paper, level, inverted: self.options.inverted };
        let contours = self.found.iter().map(|contour| contour.points.as_slice());
        let outlines = core::mem::take(&mut self.outlines);
        let quality = if kind == Kind::Sampled { Quality::Sampled } else { self.quality };
        let still = self.kinds.iter().map(|&other| other != kind).collect();
        let last = self.strokes.is_none() && (kind == Kind::Sampled || !is_there(Kind::Sampled));
        let (noise, softness) = (self.tones.noise, self.softness);
        let pixels = Pixels { gray: &mut self.gray, noise, softness, last };
        let mut refinement = Refinement::new(pixels, &shading, outlines, contours, quality, still)?;
        refinement.allow(self.options.tolerance, self.options.corner);
        let covered = self.covered();
        if self.strokes.is_some() || covered < 1.0 || self.lifted {
            refinement.expect_strokes(covered);
        }
        let rounds = 1 + usize::from(is_there(Kind::Covered) && is_there(Kind::Sampled));
        let total = rounds * refinement.total() + self.found.len();
        self.kind = kind;
        if self.progress.stage == Stage::Refinement {
            self.phase = Phase::Refinement(Box::new(refinement));
        } else {
            self.enter(Phase::Refinement(Box::new(refinement)), Stage::Refinement, total);
        }
        Ok(())
    }

    /// A bit of the curve of one outline: first itself, then how far it is from its contour.
    fn curve(&mut self, i: usize) -> Result<f64> {
        let contour = &self.found[i];
        let cost = 0.2 * contour.points.len() as f64;
        let Some(compared) = &mut self.compared else {
            probe(4 * self.outlines[i].bytes())?;
            let Some((curve, cusps)) = self.curve_of(i)? else { return Ok(cost) };
            self.compared = Some(Box::new(Compared { curve, cusps, comparison: None }));
            return Ok(cost);
        };
        let Some(comparison) = &mut compared.comparison else {
            compared.comparison = Some(Comparison::new(&compared.curve, &contour.points)?);
            return Ok(cost);
        };
        let Some(metrics) = comparison.step()? else { return Ok(cost) };
        let hole = contour.area < 0.0;
        if let Some(Compared { curve, cusps, .. }) = self.compared.take().map(|compared| *compared) {
            self.trace.contours.push(TracedContour { curve, closed: true, hole, cusps, metrics });
            self.progress.completed += 1;
        }
        Ok(cost)
    }

    /// A bit of the curve of one outline and its cusps, which are there in the end.
    fn curve_of(&mut self, i: usize) -> Result<Option<(HermiteCurve, Vec<Point>)>> {
        let (outline, kind) = (&mut self.outlines[i], self.kinds[i]);
        let Nearness { slack, bow } = self.nearness[usize::from(kind == Kind::Sampled)];
        let mut rounding = None;
        if self.options.refined && kind != Kind::Stairs {
            if self.rounding.is_none()
                && let Some(curve) = ellipse(outline, slack)?
            {
                return Ok(Some((curve, outline.cusps(self.options.corner))));
            }
            if !self.rounding.get_or_insert_default().step(outline, bow) {
                return Ok(None);
            }
            rounding = self.rounding.take();
        }
        let angles = match rounding {
            Some(rounding) => {
                let mut angles = rounding.finish(outline);
                arcs(outline, &mut angles, slack.min(BENT));
                angles
            }
            None => vec![0.0; outline.len()],
        };
        // Arcs that are recognised move the joints at their ends.
        Ok(Some((outline.to_curve(angles)?, outline.cusps(self.options.corner))))
    }

    /// A bit of one contour more in this phase, which says what it cost and whether it was the contour's last; whether
    /// it was the last of all.
    fn advance(&mut self, work: fn(&mut Self, usize) -> Result<(f64, bool)>) -> Result<(f64, bool)> {
        let i = self.progress.completed;
        if i >= self.found.len() {
            return Ok((0.0, true));
        }
        let (cost, done) = work(self, i)?;
        self.progress.completed += usize::from(done);
        Ok((cost, done && i + 1 == self.found.len()))
    }

    /// A bit of the refinement.
    fn refine(&mut self) -> Result<f64> {
        let Phase::Refinement(refinement) = &mut self.phase else { return Ok(0.0) };
        let chords = refinement.is_grainy();
        let rough = DivisionRule { chords, ..Quality::Rough.division_rule(&self.options) };
        let (contours, kinds, places) = (&self.found, &self.kinds, &mut self.samples);
        let corner_rules = Quality::Rough.corner_rules(self.options.corner);
        let (found, division) = (&mut self.rough_corners, &mut self.division);
        let mut begin = |i: usize, other: Other| {
            let Some(samples) = places else {
                *places = Some(sampled(&contours[i], kinds[i])?);
                return Ok(None);
            };
            let coarse = other == Other::Coarse;
            let outline = if let Some(corners) = found.as_ref() {
                let rule = if coarse { &rough } else { &DivisionRule::ALONG };
                division.get_or_insert_with(Division::new).step(samples, corners, rule)
            } else if coarse {
                *found = Some(corners(samples, &corner_rules));
                round(samples.places(), ROUND * Quality::Rough.slack())
            } else {
                *found = Some(Vec::new());
                None
            };
            if outline.is_some() {
                (*found, *division, *places) = (None, None, None);
            }
            Ok(outline)
        };
        let cost = refinement.step(&mut begin)?;
        if self.strokes.is_some()
            && let Some(left) = refinement.settled()?
        {
            self.judge_ink(left)?;
            return Ok(cost);
        }
        let is_sampled = self.kind == Kind::Sampled;
        let before = self.progress.total - self.found.len() - refinement.total();
        let completed = refinement.completed() + if is_sampled { before } else { 0 };
        // Another ink begins again.
        self.progress.completed = self.progress.completed.max(completed);
        if refinement.is_done() {
            self.nearness[usize::from(is_sampled)] =
                Nearness { slack: refinement.slack(), bow: refinement.bow() };
            let (outlines, residual) = refinement.finish();
            self.outlines = outlines;
            self.trace.residual = larger(self.trace.residual, residual);
            if is_sampled {
                self.phase = Phase::Curves;
            } else {
                self.refinement(Kind::Sampled)?;
            }
        }
        Ok(cost)
    }
}

impl Work for InkWork {
    fn step(&mut self) -> Result<f64> {
        match &self.phase {
            Phase::Light(_) | Phase::Tones(_) | Phase::Contours(_) => self.look(),
            Phase::Corners => {
                let (cost, last) = self.advance(Self::corner)?;
                if last {
                    let again = if self.options.refined { 1 } else { 2 };
                    self.enter(Phase::Splines, Stage::Splines, again * self.found.len());
                }
                Ok(cost)
            }
            Phase::Splines => {
                let (cost, last) = self.advance(Self::spline)?;
                if last && self.options.refined {
                    self.try_inks()?;
                    self.refinement(Kind::Covered)?;
                } else if last {
                    self.phase = Phase::Curves;
                }
                Ok(cost)
            }
            Phase::Refinement(_) => self.refine(),
            Phase::Curves => {
                let i = self.trace.contours.len();
                self.progress.done = i >= self.found.len();
                if self.progress.done {
                    self.trace.tones = self.tones;
                    self.progress.completed = self.progress.total;
                    return Ok(0.0);
                }
                self.curve(i)
            }
        }
    }

    fn progress(&self) -> Progress {
        self.progress
    }

    fn trace(&self) -> Option<&Trace> {
        self.progress.done.then_some(&self.trace)
    }

    fn offer(&self) -> Option<f64> {
        self.offer
    }
}
