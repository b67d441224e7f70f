//! All outlines of a picture refined against it, one after another: first as they are, then with fewer and fewer joints.

mod bends;
mod coverage;
mod equations;
mod fewer;
pub(super) mod field;
mod fillets;
mod grain;
mod phases;
mod refine;
mod settling;
mod sides;
mod simplify;
mod skyline;
mod straight;
mod tidying;
mod tips;
mod trial;
mod unknowns;
mod window;

use self::bends::BendRule;
use self::field::{Field, Shading};
use self::grain::level;
use self::refine::{Left, NOISY_SHARE, Refiner, Relaxing, Shape};
use self::settling::Settling;
use self::simplify::Merging;
use self::straight::Straightening;
use self::tidying::Tidying;
use self::trial::Limits;
use super::outline::Outline;
use super::outline::ellipse::ellipse;
use super::picture::gray::Gray;
use crate::error::Result;
use crate::numerics::Point;

/// How far pieces may be from an arc that they are, in pixels: in a picture of exact coverage, a compressed, a noisy and one that samples and chords made.
const BOWS: [f64; 4] = [0.01, 0.05, 0.075, 0.15];
/// Outlines follow some of the grain, so that what is known of it is this share of what it is at most.
const KNOWN: f64 = 4.0;
/// The tolerance at which outlines are as near as pixels tell.
const USUAL: f64 = 0.22;
/// How often pieces are halved; in a compressed picture once.
const HALVINGS: usize = 2;
/// By how many of its standard deviations a sum of squares is above what noise makes it where something is missing.
const SURELY: f64 = 2.0;
/// Pixels that a piece crosses at least to be halved.
const PIXELS: f64 = 8.0;
/// Steps of all nodes at first and at last, and the share of what is left that a step has to take away for another.
const STEPS: (usize, f64) = (6, 0.02);
const LAST_STEPS: (usize, f64) = (8, 4e-3);
/// Nodes of a long outline that move together.
const BLOCK: usize = 512;

/// Refinement on its way.
#[derive(Debug)]
pub(super) struct Refinement {
    field: Field,
    refiner: Refiner,
    shapes: Vec<Shape>,
    phase: Phase,
    /// The outline that is next.
    at: usize,
    /// The node of a long outline that moves next.
    block: usize,
    /// Whether cubics that hardly bend are lines by now, and what the outline was before and left.
    straightened: bool,
    bent: Option<(Outline, Left)>,
    /// How often the pieces of this outline have been halved.
    halvings: usize,
    /// Rounds of merging that this outline has had, and the one that it is in.
    round: usize,
    merging: Option<Merging>,
    /// Its folds, tips and rounded corners; its rounded corners at the end.
    tidying: Option<Tidying>,
    ending: Option<Tidying>,
    /// Its bends, when all that may be merged is, and what they are.
    settling: Option<Settling>,
    bends: BendRule,
    /// Its sides, where pixels do not tell a shallow curve from a line.
    straightening: Option<Straightening>,
    /// What the outlines were before pieces were halved, what each left, and all together.
    fine: Vec<(Outline, Left)>,
    left: Left,
    /// Outlines that rough ones took the place of.
    replaced: usize,
    /// Whether its pixels do not say exactly where edges are, although flat places are flat.
    rough: bool,
    /// What no outline explains in a pixel of a rough picture.
    grain: f64,
    /// What is left before pieces are halved where outlines run nearly along rows or columns.
    level: Vec<f64>,
    limits: Limits,
    /// The outline before joints were taken away, and what it left.
    start: Option<(Outline, f64)>,
    noisy: bool,
    slack: f64,
    /// What the picture shows, until the blur is found.
    target: Option<Vec<f32>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Phase {
    Show,
    First,
    Rough,
    Fewer,
    Done,
}

impl Refinement {
    /// Begins with outlines of contours. A noisy picture may be blurred; by how much is found.
    pub(super) fn new<'a>(
        gray: &Gray,
        shading: &Shading,
        outlines: Vec<Outline>,
        contours: impl Iterator<Item = &'a [Point]>,
        noisy: bool,
    ) -> Result<Self> {
        let field = Field::new(gray, shading, contours, if noisy { 8.0 } else { 2.5 })?;
        let rough = !noisy && field.is_compressed();
        let exact = !noisy && !rough;
        let target = noisy.then(|| field.rest.clone());
        let shapes = outlines.into_iter().map(Shape::new).collect();
        Ok(Self {
            field,
            refiner: Refiner::new(if exact { Relaxing::BOLD } else { Relaxing::CAREFUL }),
            shapes,
            phase: Phase::Show,
            at: 0,
            block: 0,
            straightened: false,
            bent: None,
            halvings: 0,
            round: 0,
            merging: None,
            tidying: None,
            ending: None,
            settling: None,
            straightening: None,
            bends: BendRule {
                window: if noisy { 5.0 } else { 3.0 },
                margin: if noisy { 1.0 } else { 0.5 },
                corner: 0.49,
                // What compression leaves looks like corners more often than noise of single pixels does.
                evidence: if noisy { 0.0 } else { 6.0 },
            },
            fine: Vec::new(),
            left: Left::default(),
            replaced: 0,
            rough,
            grain: 0.0,
            level: Vec::new(),
            limits: Limits {
                rms: 0.012,
                most: 0.055,
                off: if exact { 0.25 } else { 0.4 },
                noise: 0.0,
                share: 12.0,
                grain: 0.0,
            },
            start: None,
            noisy,
            slack: if noisy { 4.0 } else { 1.0 },
            target,
        })
    }

    /// Joints may go that leave so much more as the tolerance, in pixels, is above the usual one; corners turn by at least an angle.
    pub(super) fn allow(&mut self, tolerance: f64, corner: f64) {
        self.bends.corner = corner;
        let scale = (tolerance / USUAL).max(1.0);
        self.limits.rms *= scale;
        self.limits.most *= scale;
        self.limits.off *= scale;
    }

    /// How many outlines have been through how many phases.
    pub(super) fn completed(&self) -> usize {
        self.phase as usize * self.shapes.len() + self.at
    }

    /// Outlines times phases.
    pub(super) fn total(&self) -> usize {
        Phase::Done as usize * self.shapes.len()
    }

    /// A bit more; its cost in about microseconds. `rough` gives a coarser outline of a contour.
    pub(super) fn step(&mut self, rough: &dyn Fn(usize) -> Outline) -> Result<f64> {
        if self.at >= self.shapes.len() {
            self.next_phase();
            return Ok(1.0);
        }
        match self.phase {
            Phase::Show => {
                if !self.show_on() {
                    return Ok(self.cost());
                }
            }
            Phase::First => {
                if !self.refine_on(STEPS)? {
                    return Ok(self.cost());
                }
                if self.fine.len() == self.at {
                    let shape = &self.shapes[self.at];
                    let left = shape.left(&self.field);
                    self.fine.push((shape.outline.clone(), left));
                    self.left.join(&left);
                    level(shape, &self.field, &mut self.level);
                }
                if self.is_halved()? {
                    return Ok(self.cost());
                }
                self.halvings = 0;
            }
            Phase::Rough => {
                if self.replaced == self.at {
                    self.refiner.replace(&mut self.field, &mut self.shapes[self.at], rough(self.at));
                    self.replaced += 1;
                }
                if !self.refine_on(STEPS)? || self.is_halved()? {
                    return Ok(self.cost());
                }
                self.halvings = 0;
            }
            Phase::Fewer => {
                if let Some(cost) = self.fewer()? {
                    return Ok(cost);
                }
            }
            Phase::Done => {}
        }
        let cost = self.cost();
        self.at += 1;
        Ok(cost)
    }

    /// About how many microseconds it takes to move all nodes of the outline, or as many as are moved together.
    fn cost(&self) -> f64 {
        let parts = &self.shapes[self.at].parts;
        0.3 * parts.iter().take(2 * BLOCK).map(Vec::len).sum::<usize>() as f64
    }

    /// Puts the outline into the field, or the next pieces of a long one; whether these were the last.
    fn show_on(&mut self) -> bool {
        let shape = &mut self.shapes[self.at];
        let count = shape.outline.len();
        let end = (self.block + 2 * BLOCK).min(count);
        self.refiner.show(&mut self.field, shape, self.block..end);
        self.block = if end == count { 0 } else { end };
        end == count
    }

    /// Moves all nodes of the outline, or the next ones of a long one; whether these were the last.
    fn refine_on(&mut self, steps: (usize, f64)) -> Result<bool> {
        let steps = self.steps(steps);
        let (refiner, field, shape) = (&mut self.refiner, &mut self.field, &mut self.shapes[self.at]);
        let count = shape.outline.len();
        if count <= 2 * BLOCK {
            let nodes = shape.nodes();
            refiner.refine(field, shape, &nodes, steps)?;
            return Ok(true);
        }
        let end = (self.block + BLOCK).min(count);
        let nodes: Vec<usize> = (self.block..end).collect();
        refiner.refine(field, shape, &nodes, steps)?;
        self.block = if end == count { 0 } else { end };
        Ok(end == count)
    }

    /// Halves pieces that explain the picture worse than joints are taken away for, or than noise; whether there were any.
    fn is_halved(&mut self) -> Result<bool> {
        let shape = &mut self.shapes[self.at];
        let most = match self.phase {
            Phase::Rough => usize::from(self.field.is_compressed()),
            _ if self.noisy || self.rough => 0,
            _ => HALVINGS,
        };
        if self.halvings == most {
            return Ok(false);
        }
        // A circle that was not drawn by exact coverage is still a circle.
        if self.halvings == 0 && ellipse(&shape.outline, self.slack)?.is_some() {
            return Ok(false);
        }
        let (limits, noise) = (&self.limits, self.left.rms());
        let is_much = |left: &Left| {
            if self.rough {
                // More than noise of that deviation leaves (D 14.26).
                left.square > noise * noise * (left.count + SURELY * (2.0 * left.count).sqrt())
            } else {
                left.rms() > 1.5 * limits.rms || left.most > 2.0 * limits.most
            }
        };
        let far = far(shape, &self.field, is_much);
        let any = far.contains(&true);
        if any {
            let halved = shape.outline.halved(&far);
            self.refiner.replace(&mut self.field, shape, halved);
            self.halvings += 1;
        }
        Ok(any)
    }

    /// Steps that stop where the picture says no more.
    fn steps(&self, (most, enough): (usize, f64)) -> (usize, f64) {
        (most, if self.noisy || self.rough { NOISY_SHARE } else { enough })
    }

    /// Whether flat places are flat, so that a rough picture is one of edges that samples or chords made.
    pub(super) fn is_grainy(&self) -> bool {
        !self.field.is_compressed()
    }

    /// How many times farther than in a picture of exact coverage an outline may be from an ellipse that it is.
    pub(super) fn slack(&self) -> f64 {
        self.slack
    }

    /// How far pieces may be from an arc that they are, in pixels: where programs drew chords farthest.
    pub(super) fn bow(&self) -> f64 {
        match (self.noisy, self.rough) {
            (true, _) => BOWS[2],
            (_, false) => BOWS[0],
            _ => BOWS[if self.is_grainy() { 3 } else { 1 }],
        }
    }

    /// Whether all is done.
    pub(super) fn is_done(&self) -> bool {
        self.phase == Phase::Done
    }

    /// The outlines, and the root mean square of what they leave in the pixels that they cross.
    pub(super) fn finish(&mut self) -> (Vec<Outline>, f64) {
        let left = self.crossed();
        let outlines = core::mem::take(&mut self.shapes).into_iter().map(|shape| shape.outline).collect();
        (outlines, left.rms())
    }
}

/// Which curved pieces leave what is too much.
fn far(shape: &Shape, field: &Field, is_much: impl Fn(&Left) -> bool) -> Vec<bool> {
    let is_far = |i: usize| {
        let mut left = Left::default();
        left.add(&shape.parts[i], field);
        !shape.outline.is_line(i) && left.count > PIXELS && is_much(&left)
    };
    (0..shape.outline.len()).map(is_far).collect()
}
