//! From contours to first outlines: what pixels say of each, its corners, and as few pieces as its places allow.

use super::strokes::move_inside;
use super::{InkWork, Kind};
use crate::error::Result;
use crate::limits::probe;
use crate::trace::outline::Outline;
use crate::trace::outline::corners::corners;
use crate::trace::outline::division::Division;
use crate::trace::outline::ellipse::round;
use crate::trace::outline::stairs::stairs;
use crate::trace::picture::contour::Contour;
use crate::trace::picture::lifting::FULL;
use crate::trace::picture::steps::{is_mostly_sampled, is_sampled, steps};
use crate::trace::quality::Quality;
use crate::trace::samples::Samples;

/// How far the contour of an ellipse may be from it, in pixels.
pub(super) const ROUND: f64 = 0.16;
/// Contours of sampled edges are evened over so many pixels before their first outline is made, the deviation of a
/// Gaussian.
const EVENED: f64 = 1.7;

/// Bytes that corners and a first outline take for each place of their contour, at most.
const ROOM: usize = 32;

/// And that an outline takes that goes around pixels, for each side of them.
const STAIRS: usize = 96;

impl InkWork {
    /// What pixels say of a contour; where they are of two tones, it goes between them first.
    fn look_at(&mut self, i: usize) -> Result<Option<Kind>> {
        let (contour, tones) = (&mut self.found[i], &self.tones);
        if !self.between {
            let middles = if self.quality == Quality::Clean {
                steps(&contour.points, &self.gray, tones)?
            } else {
                None
            };
            self.between = middles.is_some();
            if middles.is_none() && (self.strokes.is_some() || self.lifted) {
                let full = if self.lifted && self.strokes.is_none() { FULL } else { f64::INFINITY };
                move_inside(&mut contour.points, &self.gray, tones, (self.options.inverted, full));
            }
            return Ok(middles.map_or(Some(Kind::Covered), |middles| {
                contour.points = middles;
                None
            }));
        }
        self.between = false;
        let aslant = !self.gray.by_pixels && is_sampled(&contour.points, &self.gray, tones.middle(), false);
        Ok(Some(if aslant { Kind::Sampled } else { Kind::Stairs }))
    }

    fn quality_of(&self, i: usize) -> Quality {
        if self.kinds[i] == Kind::Sampled { Quality::Sampled } else { self.quality }
    }

    /// What pixels say of small contours among large ones.
    fn look_again(&mut self) {
        let kinds = self.found.iter().zip(&self.kinds);
        if is_mostly_sampled(kinds.map(|(contour, &kind)| (contour.points.len(), kind == Kind::Sampled))) {
            for (contour, kind) in self.found.iter().zip(&mut self.kinds) {
                if *kind == Kind::Stairs && is_sampled(&contour.points, &self.gray, self.tones.middle(), true)
                {
                    *kind = Kind::Sampled;
                }
            }
        }
    }

    /// Finds places along a contour; what it cost.
    fn sample(&mut self, i: usize) -> Result<f64> {
        let samples = self.samples.insert(sampled(&self.found[i], self.kinds[i])?);
        Ok(0.25 * samples.len() as f64)
    }

    /// First what pixels say of each contour; then places along one, and its corners: what it cost, and whether that
    /// was all.
    pub(super) fn corner(&mut self, i: usize) -> Result<(f64, bool)> {
        let next = self.kinds.len();
        if next < self.found.len() {
            if let Some(kind) = self.look_at(next)? {
                self.kinds.push(kind);
                if next + 1 == self.found.len() {
                    self.look_again();
                }
            }
            return Ok((0.25 * self.found[next].points.len() as f64, false));
        }
        if self.kinds[i] == Kind::Stairs {
            self.corners.push(Vec::new());
            return Ok((1.0, true));
        }
        if self.samples.is_none() {
            return Ok((self.sample(i)?, false));
        }
        let rules = self.quality_of(i).corner_rules(self.options.corner);
        let samples = self.samples.take();
        self.corners.extend(samples.as_ref().map(|samples| corners(samples, &rules)));
        Ok((0.25 * samples.map_or(0.0, |samples| samples.len() as f64), true))
    }

    /// A bit of the first outline of one contour: its cost, and whether it was the last.
    pub(super) fn spline(&mut self, i: usize) -> Result<(f64, bool)> {
        if self.kinds[i] == Kind::Stairs {
            let points = &self.found[i].points;
            probe(STAIRS * points.len())?;
            self.outlines.push(stairs(points));
            return Ok((0.5 * points.len() as f64, true));
        }
        let Some(samples) = &self.samples else { return Ok((self.sample(i)?, false)) };
        let cost = 0.5 * samples.len() as f64;
        let quality = self.quality_of(i);
        let whole = if self.options.refined && self.division.is_none() {
            round(samples.places(), ROUND * quality.slack())
        } else {
            None
        };
        let rule = quality.division_rule(&self.options);
        let division = self.division.get_or_insert_with(Division::new);
        let Some(mut outline) = whole.or_else(|| division.step(samples, &self.corners[i], &rule)) else {
            return Ok((cost, false));
        };
        self.division = None;
        if !outline.encloses(self.found[i].area, 1.0) {
            outline = Outline::polygon(samples.places())?;
        }
        outline.cut_to([self.gray.width() as f64, self.gray.height() as f64]);
        self.outlines.push(outline);
        self.samples = None;
        Ok((cost, true))
    }
}

/// Places along a contour. They are not kept: those of all contours take more memory than all else.
pub(super) fn sampled(contour: &Contour, kind: Kind) -> Result<Samples> {
    let mut samples = Samples::new(&contour.points)?;
    if kind == Kind::Sampled {
        samples = samples.evened(EVENED)?;
    }
    probe(ROOM * samples.len())?;
    Ok(samples)
}
