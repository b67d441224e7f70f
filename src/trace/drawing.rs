//! Logos and drawings: outlines of ink, as few pieces as their coverage allows.

use super::contour::{Contour, contours};
use super::corners::{CornerRule, corners};
use super::coverage::Band;
use super::division::{DivisionRule, divide};
use super::ellipse::ellipse;
use super::gray::{Gray, Tones};
use super::outline::Outline;
use super::refine::{refine, rest_of};
use super::samples::Samples;
use super::simplify::{Limits, finish};
use crate::curve::HermiteCurve;
use crate::error::{Error, Result};
use crate::limits::check;
use crate::numerics::Point;

/// How a drawing is traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawingOptions {
    /// The level between ink and paper, as a share of the way from ink to paper; ½ is the middle.
    pub threshold: f64,
    /// Light ink on dark paper.
    pub inverted: bool,
    /// Contours that enclose fewer square pixels are left out.
    pub speckle: f64,
    /// The least turning of a corner, in radians.
    pub corner: f64,
    /// The largest deviation of the first outline from the contour, in pixels; refined outlines are nearer.
    pub tolerance: f64,
    /// Whether outlines are refined against the picture's coverage.
    pub refined: bool,
}

impl Default for DrawingOptions {
    fn default() -> Self {
        Self { threshold: 0.5, inverted: false, speckle: 2.0, corner: 0.49, tolerance: 0.22, refined: true }
    }
}

/// One closed outline.
#[derive(Clone, Debug)]
pub struct TracedContour {
    /// The outline; ink has a positive area, holes a negative one.
    pub curve: HermiteCurve,
    /// Whether it bounds a hole.
    pub hole: bool,
    /// Corners, where the tangent jumps.
    pub cusps: Vec<Point>,
}

/// What was found in a picture.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// All outlines, in the order of their first points, row by row.
    pub contours: Vec<TracedContour>,
    /// Ink, paper and noise.
    pub tones: Tones,
    /// The root mean square difference between the picture and the coverage of the outlines near them; 0 without refinement.
    pub residual: f64,
}

/// Noise above which pictures are blurred before they are followed, as a share of the way from ink to paper.
const NOISY: f64 = 3.0 / 255.0;
/// What refined outlines leave of most pixels of a picture of exact coverage.
const ROUGH: f64 = 0.0005;
/// More contours than this is not a drawing but a photograph.
pub const MOST_CONTOURS: usize = 1_500;

/// Traces the outlines of a drawing.
///
/// # Errors
///
/// Options out of range; a picture with more contours than a drawing has.
///
/// # Cost
///
/// O(pixels + length of the outlines); 4 bytes for each pixel, 8 where there is noise.
pub fn trace_drawing(gray: &Gray, options: &DrawingOptions) -> Result<Drawing> {
    check("threshold", None, options.threshold, 0.01, 0.99)?;
    check("corner", None, options.corner, 0.05, core::f64::consts::PI)?;
    check("tolerance", None, options.tolerance, 0.01, 1e3)?;
    check("speckle", None, options.speckle, 0.0, 1e9)?;
    let tones = gray.tones();
    let noisy = tones.noise > NOISY;
    let smoothed = if noisy { Some(gray.blurred(1.2)?) } else { None };
    let level = tones.ink + options.threshold * (tones.paper - tones.ink);
    let speckle = if noisy { options.speckle.max(6.0) } else { options.speckle };
    let found = contours(smoothed.as_ref().unwrap_or(gray), level, options.inverted, speckle)?;
    if found.len() > MOST_CONTOURS {
        return Err(Error::limit("data", "maxContours", MOST_CONTOURS, found.len() as f64));
    }
    let quality = if noisy { Quality::Noisy } else { Quality::Clean };
    let mut outlines: Vec<Outline> = found.iter().map(|contour| follow(contour, options, quality)).collect();
    let mut residual = 0.0;
    if options.refined {
        let polylines = found.iter().map(|contour| contour.points.as_slice());
        let mut band = Band::new(gray, &tones, options.inverted, polylines, if noisy { 4 } else { 2 })?;
        if noisy {
            band.find_blur(&outlines)?;
        }
        residual = refine(&mut outlines, &band, 6)?;
        let mut noise = if noisy { residual } else { 0.0 };
        if !noisy && typical(&outlines, &band)? > ROUGH {
            let mut rough: Vec<Outline> =
                found.iter().map(|contour| follow(contour, options, Quality::Rough)).collect();
            let left = refine(&mut rough, &band, 6)?;
            // If fewer pieces explain the picture as well, the rest is not in the drawing.
            if left < 1.25 * residual {
                (outlines, noise) = (rough, left);
            }
        }
        let limits = Limits { rms: 0.012, most: 0.055, noise, share: 12.0 };
        residual = finish(&mut outlines, &band, &limits)?;
    }
    let mut contours = Vec::new();
    for (outline, contour) in outlines.iter().zip(&found) {
        let cusps = outline.nodes.iter().filter(|node| !node.smooth).map(|node| node.point).collect();
        let curve = match ellipse(outline)? {
            Some(curve) if options.refined => curve,
            _ => outline.to_curve()?,
        };
        contours.push(TracedContour { curve, hole: contour.area < 0.0, cusps });
    }
    Ok(Drawing { contours, tones, residual })
}

/// The median of what the outlines leave of the picture: a few pixels that are wrong do not count.
fn typical(outlines: &[Outline], band: &Band) -> Result<f64> {
    let mut rest: Vec<f32> = rest_of(outlines, band)?.iter().map(|r| r.abs()).collect();
    rest.sort_by(f32::total_cmp);
    Ok(rest.get(rest.len() / 2).map_or(0.0, |&r| f64::from(r)))
}

/// What kind of picture it is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Quality {
    /// Exact coverage.
    Clean,
    /// Flat places are flat, but outlines are not what was drawn, as after strong compression.
    Rough,
    /// Noise everywhere.
    Noisy,
}

fn follow(contour: &Contour, options: &DrawingOptions, quality: Quality) -> Outline {
    let samples = Samples::new(&contour.points);
    let angle = options.corner;
    let rules = match quality {
        Quality::Clean => [
            CornerRule { gap: 1.0, window: 3.0, angle, reach: 1.0 },
            CornerRule { gap: 0.75, window: 1.75, angle: angle + 0.25, reach: 1.0 },
        ],
        Quality::Rough => [
            CornerRule { gap: 1.2, window: 4.0, angle: angle + 0.1, reach: 1.2 },
            CornerRule { gap: 1.0, window: 2.5, angle: angle + 0.4, reach: 1.2 },
        ],
        Quality::Noisy => [
            CornerRule { gap: 1.6, window: 5.0, angle, reach: 1.8 },
            CornerRule { gap: 1.5, window: 3.0, angle: angle + 0.2, reach: 1.8 },
        ],
    };
    let corners = corners(&samples, &rules);
    let scale = if quality == Quality::Clean { 1.0 } else { 2.0 };
    let division = DivisionRule {
        gap: 1.2 * rules[0].gap,
        straight: 0.12 * scale,
        least_run: 6.0 * scale,
        most: options.tolerance * scale,
        rms: 0.41 * options.tolerance * scale,
        reach: 3.0 * scale,
    };
    divide(&samples, &corners, &division)
}
