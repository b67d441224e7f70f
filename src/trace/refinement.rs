//! All outlines of a picture refined against it, one after another: first as they are, then with fewer and fewer
//! joints.

mod again;
mod bends;
mod blocks;
mod coverage;
mod equations;
mod exactness;
mod fewer;
pub(super) mod field;
mod fillets;
mod grain;
mod halving;
mod left;
mod phases;
mod refine;
mod restraint;
mod room;
mod settling;
mod showing;
mod sides;
mod simplify;
mod skyline;
mod straight;
mod sweep;
mod tidying;
mod tips;
mod trial;
mod unknowns;
mod window;

use self::again::Again;
use self::bends::BendRule;
use self::blocks::{BLOCK, block_end};
use self::exactness::Exactness;
use self::fewer::Thinning;
use self::field::{Alike, Blurring, Field, Shading};
use self::grain::level;
use self::left::Left;
use self::refine::{Descent, Refiner, Relaxing, Shape};
use self::trial::Limits;
use super::outline::Outline;
use super::picture::gray::Gray;
use super::quality::{Quality, evened};
use crate::error::Result;
use crate::limits::probe;
use crate::numerics::Point;

/// The tolerance at which outlines are as near as pixels tell.
const USUAL: f64 = 0.22;
/// Steps of all nodes at first and at last, and the share of what is left that a step has to take away for another.
const STEPS: (usize, f64) = (6, 0.02);
const LAST_STEPS: (usize, f64) = (8, 4e-3);
/// And where a step takes only its share.
const SHARED_STEPS: (usize, f64) = (12, 4e-3);
/// Pictures that say only which centres are inside are blurred by so many pixels, together with the coverage of their
/// outlines (D 14.27).
const AVERAGED: f64 = 1.2;

/// Another first outline of a contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Other {
    /// Along it, whatever may be corners.
    Along,
    /// As of pixels that say less.
    Coarse,
}

/// Goes on with another first outline of a contour, and gives it in the end.
pub(super) type Begin<'a> = dyn FnMut(usize, Other) -> Result<Option<Outline>> + 'a;

/// What a picture shows, and how exactly.
pub(super) struct Pixels<'a> {
    pub(super) gray: &'a mut Gray,
    /// The noise of a pixel, as a share of the way from ink to paper.
    pub(super) noise: f64,
    /// The blur of a soft picture, a deviation in pixels.
    pub(super) softness: f64,
    /// Whether this is the last time that its pixels are asked for: then it gives them back.
    pub(super) last: bool,
}

/// Refinement on its way.
#[derive(Debug)]
pub(super) struct Refinement {
    field: Field,
    refiner: Refiner,
    shapes: Vec<Shape>,
    /// The outlines as they were at first.
    first: Vec<Outline>,
    /// Which outlines stay as they are.
    still: Vec<bool>,
    /// What makes the field as blurred as the picture, once all outlines are shown.
    blurring: Option<Blurring>,
    picture: Exactness,
    /// The noise of a pixel, as a share of the way from ink to paper.
    noise: f64,
    limits: Limits,
    /// What share of the area of its contour an outline has, about.
    share: f64,
    bends: BendRule,
    place: Place,
    /// The outline and phase that there is room for, in numbers of outlines that have been through phases.
    sure: Option<usize>,
    fine: Fine,
    thinning: Thinning,
    /// What an outline leaves that begins again, root mean square of coverage.
    poor: f64,
}

/// Where the work is.
#[derive(Debug, Default)]
struct Place {
    phase: Phase,
    /// The outline that is next.
    at: usize,
    /// The node of a long outline that moves next, or the piece that is shown next.
    block: usize,
    /// Whether the outline takes the place of another and is not yet in the field, and the outline until the other has
    /// gone.
    arriving: bool,
    coming: Option<Outline>,
    /// The steps of the nodes that are moving.
    descent: Option<Descent>,
    /// Whether the last of them has been, and pieces are to be looked at.
    refined: bool,
    /// How often the pieces of this outline have been halved.
    halvings: usize,
    /// What the outline was, while it begins again.
    again: Option<Again>,
}

/// What the outlines were before pieces were halved.
#[derive(Debug, Default)]
struct Fine {
    outlines: Vec<FineOutline>,
    /// What all left together, once all have begun.
    left: Left,
    /// Outlines that rough ones took the place of.
    replaced: usize,
}

/// One of them.
#[derive(Debug, Default)]
struct FineOutline {
    outline: Outline,
    /// What it left of the picture, and where it runs nearly along rows or columns.
    left: Left,
    level: Vec<f64>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
enum Phase {
    #[default]
    Show,
    First,
    Again,
    Rough,
    Fewer,
    Done,
}

impl Refinement {
    /// Begins with outlines of contours, some of which stay as they are. A noisy or soft picture is blurred; by how
    /// much is found.
    pub(super) fn new<'a>(
        pixels: Pixels<'_>,
        shading: &Shading,
        outlines: Vec<Outline>,
        contours: impl Iterator<Item = &'a [Point]> + Clone,
        quality: Quality,
        still: Vec<bool>,
    ) -> Result<Self> {
        let Pixels { gray, noise, softness, last } = pixels;
        let (reach, alike) = match quality {
            Quality::Clean | Quality::Rough => (2.5, None),
            Quality::Sampled => (2.5, Some(Alike::Both(AVERAGED))),
            Quality::Soft => (8.0, Some(Alike::Found(evened(softness)))),
            Quality::Noisy => (8.0, Some(Alike::Found(0.0))),
        };
        // Of a compressed picture it is found.
        let slack = quality.slack();
        let mut field = Field::new(gray, shading, contours, reach)?;
        if last {
            gray.clear();
        }
        let quality = match quality {
            Quality::Clean if field.is_compressed() => Quality::Rough,
            quality => quality,
        };
        let blurring = alike.map(|alike| Blurring::new(&mut field, alike)).transpose()?;
        probe(4 * outlines.iter().map(Outline::bytes).sum::<usize>())?;
        let first = outlines.clone();
        let shapes = outlines.into_iter().map(Shape::new).collect();
        let relaxing = if quality == Quality::Clean { Relaxing::BOLD } else { Relaxing::CAREFUL };
        Ok(Self {
            field,
            refiner: Refiner::new(relaxing),
            shapes,
            first,
            still,
            blurring,
            picture: Exactness { quality, grain: 0.0, slack },
            noise,
            limits: Limits::of(quality),
            share: 1.0,
            bends: BendRule::of(quality),
            place: Place::default(),
            sure: None,
            fine: Fine::default(),
            thinning: Thinning::default(),
            poor: 0.0,
        })
    }

    /// Joints may go that leave so much more as the tolerance, in pixels, is above the usual one; corners turn by at
    /// least an angle.
    pub(super) fn allow(&mut self, tolerance: f64, corner: f64) {
        self.bends.corner = corner;
        let scale = (tolerance / USUAL).max(1.0);
        self.limits.rms *= scale;
        self.limits.most *= scale;
        self.limits.off *= scale;
    }

    /// Outlines are those of strokes of which no pixel need be all ink, and have about this share of the areas of their
    /// contours.
    pub(super) fn expect_strokes(&mut self, share: f64) {
        self.share = share;
        self.refiner = Refiner::new(Relaxing::SHARED);
    }

    /// How many outlines have been through how many phases.
    pub(super) fn completed(&self) -> usize {
        self.place.phase as usize * self.shapes.len() + self.place.at
    }

    /// Outlines times phases.
    pub(super) fn total(&self) -> usize {
        Phase::Done as usize * self.shapes.len()
    }

    /// A bit more; its cost in about microseconds.
    pub(super) fn step(&mut self, begin: &mut Begin) -> Result<f64> {
        if self.blurring.is_some() && self.place.phase > Phase::Show {
            self.blur_on()?;
            return Ok(2000.0);
        }
        if self.place.arriving {
            if self.leave_on() && self.show_on() {
                self.place.arriving = false;
                self.field.settle();
            }
            return Ok(self.cost());
        }
        if self.place.at >= self.shapes.len() {
            self.next_phase();
            return Ok(1.0);
        }
        if self.passes_over() {
            return Ok(1.0);
        }
        self.make_sure()?;
        let done = match self.place.phase {
            Phase::Show => self.show_on(),
            Phase::First => self.first_on()?,
            Phase::Again => self.again_on(begin)?,
            Phase::Rough => self.rough_on(begin)?,
            Phase::Fewer => {
                if let Some(cost) = self.fewer()? {
                    return Ok(cost);
                }
                self.restrain();
                true
            }
            Phase::Done => true,
        };
        let cost = self.cost();
        if done {
            self.place.at += 1;
            self.place.halvings = 0;
        }
        Ok(cost)
    }

    /// The field becomes as blurred as the picture. What an outline lacks is then spread over more pixels, and less of
    /// it in each.
    fn blur_on(&mut self) -> Result<()> {
        if let Some(blurring) = &mut self.blurring
            && blurring.step(&mut self.field)?
        {
            self.blurring = None;
            if self.picture.quality == Quality::Soft {
                let share = self.field.middle();
                self.limits.rms *= share;
                self.limits.most *= share;
            }
        }
        Ok(())
    }

    /// A bit of the first steps of the outline; whether that was the last. What it is before pieces are halved is kept.
    fn first_on(&mut self) -> Result<bool> {
        let done = self.converge_on()?;
        if self.place.refined && self.fine.outlines.len() == self.place.at {
            self.fine.outlines.push(FineOutline::of(&self.shapes[self.place.at], &self.field));
        }
        Ok(done)
    }

    /// A bit of the outline's steps, before and after pieces are halved; whether that was the last.
    fn converge_on(&mut self) -> Result<bool> {
        if self.place.refined {
            self.place.refined = false;
            return Ok(!self.is_halved()?);
        }
        let steps = if self.refiner.shares() { SHARED_STEPS } else { STEPS };
        self.place.refined = self.refine_on(steps)?;
        Ok(false)
    }

    /// A coarser outline takes the place of the fine one, and then its steps; whether that was the last bit.
    fn rough_on(&mut self, begin: &mut Begin) -> Result<bool> {
        let at = self.place.at;
        if self.fine.replaced == at {
            if let Some(mut outline) = begin(at, Other::Coarse)? {
                outline.cut_to(self.field.extent);
                self.exchange(outline);
                self.fine.replaced += 1;
            }
            return Ok(false);
        }
        Ok(self.refine_on(STEPS)? && !self.is_halved()?)
    }

    /// Whether the outline is one that stays as it is: then the next one is next.
    fn passes_over(&mut self) -> bool {
        let at = self.place.at;
        if self.place.phase == Phase::Show || !self.still[at] {
            return false;
        }
        match self.place.phase {
            Phase::First => self
                .fine
                .outlines
                .push(FineOutline { outline: self.shapes[at].outline.clone(), ..FineOutline::default() }),
            Phase::Rough => self.fine.replaced += 1,
            _ => {}
        }
        self.place.at += 1;
        true
    }

    /// About how many microseconds a step of all nodes of the outline takes, or of as many as are moved together.
    fn cost(&self) -> f64 {
        let parts = &self.shapes[self.place.at].parts;
        0.3 * parts.iter().take(2 * BLOCK).map(Vec::len).sum::<usize>() as f64
    }

    /// Moves all nodes of the outline, or the next ones of a long one, by a step; whether that was the last of all.
    fn refine_on(&mut self, steps: (usize, f64)) -> Result<bool> {
        let steps = self.picture.steps(steps);
        let (refiner, field, shape) = (&mut self.refiner, &mut self.field, &mut self.shapes[self.place.at]);
        let (count, first) = (shape.outline.len(), self.place.block);
        let end = block_end(shape, first);
        let nodes = if end - first == count { shape.nodes() } else { (first..end).collect() };
        let descent = self.place.descent.get_or_insert(Descent::new(steps));
        if refiner.descend(field, shape, &nodes, descent)? {
            return Ok(false);
        }
        self.place.descent = None;
        self.place.block = if end == count { 0 } else { end };
        Ok(end == count)
    }

    /// Whether flat places are flat, so that a rough picture is one of edges that samples or chords made.
    pub(super) fn is_grainy(&self) -> bool {
        !self.field.is_compressed()
    }

    /// How many times farther than in a picture of exact coverage an outline may be from an ellipse that it is.
    pub(super) fn slack(&self) -> f64 {
        self.picture.slack
    }

    /// How far pieces may be from an arc that they are, in pixels.
    pub(super) fn bow(&self) -> f64 {
        self.picture.bow(self.is_grainy())
    }

    /// Whether all is done.
    pub(super) fn is_done(&self) -> bool {
        self.place.phase == Phase::Done
    }

    /// The outlines, and the root mean square of what they leave in the pixels that they cross.
    pub(super) fn finish(&mut self) -> (Vec<Outline>, f64) {
        let left = self.crossed();
        let extent = self.field.extent;
        let cut = |Shape { mut outline, .. }| {
            // Its last steps may have led a corner out again.
            outline.cut_to(extent);
            outline
        };
        (core::mem::take(&mut self.shapes).into_iter().map(cut).collect(), left.rms())
    }
}

impl FineOutline {
    fn of(shape: &Shape, field: &Field) -> Self {
        let mut fine = Self { outline: shape.outline.clone(), left: shape.left(field), level: Vec::new() };
        level(shape, field, &mut fine.level);
        fine
    }
}
