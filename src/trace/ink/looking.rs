//! What is done with a picture until the contours of its ink are known.

use core::f64::consts::FRAC_PI_8;

use super::specks::{ENCLOSED, is_shaded, size};
use super::strokes::Strokes;
use super::{InkWork, Phase};
use crate::error::{Error, Result};
use crate::trace::chain_work::speckle_for;
use crate::trace::options::TraceOptions;
use crate::trace::picture::blur::Blurring;
use crate::trace::picture::contour::{Contour, ContourScan};
use crate::trace::picture::lifting::Lifting;
use crate::trace::picture::ridges::Ridges;
use crate::trace::picture::softness::softness;
use crate::trace::picture::tones::{ToneScan, Tones};
use crate::trace::quality::{Quality, evened};
use crate::trace::work::Stage;

/// Noise above which pictures are blurred before they are followed, as a share of the way from ink to paper.
const NOISY: f64 = 3.0 / 255.0;
/// By how much they are, a deviation in pixels.
const EVENED: f64 = 1.2;
/// The blur of a picture from which on it is not taken for exact coverage, a deviation in pixels: what scales pictures
/// down leaves less.
const SOFT: f64 = 0.4;
/// Contours of less area, in pixels, are noise in a noisy picture.
const NOISY_SPECKLE: f64 = 6.0;
/// Thin strokes beside others are looked for where they would break in so many places: the tips of a star or two are as
/// many. Where all is thin, one is enough.
const THIN: usize = 12;
/// And by how much where strokes are thin.
const EVENED_LESS: f64 = 0.8;
/// In noise they are where one in so many places along contours is missing: tips leave no more than one in sixty.
const FAINT: usize = 20;
/// In pictures of more pixels nobody sees a stroke of less than one, and outlines all over take all the memory that
/// there is.
const MOST_LIFTED: usize = 1 << 22;
/// Contours of this area, in pixels, are those of dots, or of holes, in drawings of thin strokes. They are smaller than
/// what they are contours of: of what pixels share little is above half.
const FINE: f64 = 0.25;
/// Beside thicker strokes, in pixels, small things are dust, or crumbs. A stroke has π/8 of the area of one that is a
/// pixel thick for each place of its contour, which are where it crosses rows and columns of centres.
const THICK: f64 = 4.0;
/// Pixels of one bit of work.
const BIT: usize = 131_072;

impl InkWork {
    /// Tones are known, that of ink from flat places or not: noise decides whether the picture is blurred.
    fn toned(&mut self, tones: Tones, seen: bool, thin: usize) -> Result<()> {
        (self.tones, self.trace.tones) = (tones, tones);
        if tones.noise > NOISY {
            self.quality = Quality::Noisy;
        }
        if self.quality == Quality::Clean && self.options.refined && self.options.threshold.is_none() {
            if !seen {
                self.strokes = Strokes::new(tones, self.options.inverted);
            }
            let small = self.gray.width() * self.gray.height() <= MOST_LIFTED;
            let is_dark = self.strokes.as_ref().is_none_or(Strokes::is_dark);
            let least = if seen { THIN } else { 1 };
            if is_dark && small && self.options.blur.is_none() && thin >= least {
                self.lifting = Some(Lifting::new(self.gray.width(), &tones, self.options.inverted)?);
                self.lifted = true;
            }
        }
        let width = self.gray.width();
        let TraceOptions { blur, threshold, refined, inverted, .. } = self.options;
        let sigma = blur.unwrap_or(if self.quality == Quality::Noisy { EVENED } else { 0.0 });
        if sigma > 0.0 && blur.is_none() && threshold.is_none() && refined {
            self.ridges = Some(Ridges::new(width, sigma, &self.tones, (inverted, false))?);
        } else if sigma > 0.0 {
            self.blurring = Some(Blurring::new(width, sigma)?);
        }
        let level = self.strokes.as_ref().map_or(self.level(), Strokes::level);
        let scan = ContourScan::new(&self.gray, level, self.options.inverted);
        self.enter(Phase::Contours(scan), Stage::Contours, self.gray.height() + 1);
        Ok(())
    }

    /// All contours at a level are known; those of less than a speckle are left out.
    fn scanned(&mut self, mut found: Vec<Contour>, level: f64, speckle: f64) -> Result<()> {
        let (gray, tones, shade) = (&self.gray, &self.tones, (level, self.options.inverted));
        let extent = |contour: &Contour| size(contour, gray, tones, shade);
        let fine = self.is_fine(&found);
        found.retain(|contour| {
            contour.area.abs() >= speckle
                || extent(contour) >= speckle
                || fine && is_shaded(contour, gray, tones, shade)
        });
        if found.len() > self.options.most_contours {
            let most = self.options.most_contours;
            self.offer = speckle_for(most, found.iter().map(extent).collect());
            return Err(Error::limit("data", "maxContours", most, found.len() as f64));
        }
        if self.is_soft(&found)? {
            return Ok(());
        }
        self.found = found;
        self.enter(Phase::Corners, Stage::Corners, self.found.len());
        Ok(())
    }

    /// Whether dots of less than a speckle may count: none was asked for, and pixels say what they are covered by.
    fn may_be_fine(&self) -> bool {
        let TraceOptions { speckle, blur, refined, .. } = self.options;
        self.quality == Quality::Clean && refined && speckle.is_none() && blur.is_none()
    }

    /// Whether they do: strokes are hardly thicker, and all together are no more than a drawing has.
    fn is_fine(&self, found: &[Contour]) -> bool {
        let area: f64 = found.iter().map(|contour| contour.area).sum();
        let places: usize = found.iter().map(|contour| contour.points.len()).sum();
        let is_thin = area < THICK * FRAC_PI_8 * places as f64;
        self.may_be_fine() && is_thin && found.len() <= self.options.most_contours
    }

    /// Whether the picture is blurred; then its contours are looked for once more, where they do not wind as scaling up
    /// makes them.
    fn is_soft(&mut self, found: &[Contour]) -> Result<bool> {
        if self.quality != Quality::Clean
            || self.options.blur.is_some()
            || !self.options.refined
            || self.strokes.is_some()
        {
            return Ok(false);
        }
        let softness =
            softness(found.iter().map(|contour| contour.points.as_slice()), &self.gray, &self.tones);
        if softness < SOFT {
            return Ok(false);
        }
        (self.quality, self.softness) = (Quality::Soft, softness);
        (self.lifting, self.lifted) = (None, false);
        self.blurring = Some(Blurring::new(self.gray.width(), evened(softness))?);
        let scan = ContourScan::new(&self.gray, self.level(), self.options.inverted);
        self.enter(Phase::Contours(scan), Stage::Contours, self.gray.height() + 1);
        Ok(true)
    }

    /// Whether so many thin places between contours are more than tips; then contours are looked for once more.
    fn breaks(&mut self, found: &[Contour], faint: usize) -> Result<bool> {
        let places: usize = found.iter().map(|contour| contour.points.len()).sum();
        if FAINT * faint < places {
            return Ok(false);
        }
        let (width, inverted) = (self.gray.width(), self.options.inverted);
        self.ridges = Some(Ridges::new(width, EVENED_LESS, &self.tones, (inverted, true))?);
        let scan = ContourScan::new(&self.gray, self.level(), inverted);
        self.enter(Phase::Contours(scan), Stage::Contours, self.gray.height() + 1);
        Ok(true)
    }

    /// Some rows of the picture more, until contours are known.
    pub(super) fn look(&mut self) -> Result<f64> {
        let (width, height) = (self.gray.width(), self.gray.height());
        let rows = (BIT / width).max(1);
        let row = 0.2 * (width as f64);
        let may_be_fine = self.may_be_fine();
        // Where strokes are lifted contours have about twice the area.
        let fine = if self.lifted { 2.0 * FINE } else { FINE };
        match &mut self.phase {
            Phase::Light(evening) => {
                if evening.step(&mut self.gray) {
                    self.phase = Phase::Tones(ToneScan::new(None));
                }
                return Ok(row);
            }
            Phase::Tones(scan) => {
                if let Some(tones) = scan.step(&self.gray) {
                    let seen = scan.is_seen(self.options.inverted);
                    let thin = scan.thin(self.options.inverted);
                    self.toned(tones, seen, thin)?;
                }
                return Ok(row);
            }
            Phase::Contours(scan) => {
                // A row takes eight times as long where it is blurred.
                let is_plain = self.blurring.is_none() && self.lifting.is_none() && self.ridges.is_none();
                let rows = if is_plain { rows } else { (rows / 8).max(1) };
                for _ in 0..rows {
                    let more = match (&mut self.blurring, &mut self.lifting, &mut self.ridges) {
                        (Some(blurring), _, _) => scan.step_between(blurring.step(&self.gray))?,
                        (_, Some(lifting), _) => scan.step_between(lifting.step(&self.gray))?,
                        (_, _, Some(ridges)) => scan.step_between(ridges.step(&self.gray))?,
                        _ => scan.step(&self.gray)?,
                    };
                    if !more {
                        (self.blurring, self.lifting) = (None, None);
                        let faint = self.ridges.take().map_or(0, |ridges| ridges.faint());
                        let asked = self.options.least();
                        let (least, speckle) = match self.quality {
                            Quality::Noisy => (asked.max(NOISY_SPECKLE), 0.0),
                            _ if may_be_fine => (fine, asked),
                            _ => (ENCLOSED * asked, asked),
                        };
                        let (found, level) = (scan.contours(least)?, scan.level());
                        if faint >= THIN && self.breaks(&found, faint)? {
                            return Ok(1000.0);
                        }
                        self.scanned(found, level, speckle)?;
                        return Ok(1000.0);
                    }
                }
                self.progress.completed = scan.rows().min(height);
            }
            _ => {}
        }
        Ok(1000.0)
    }
}
