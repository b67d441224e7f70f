//! Curves → SVG path data.

mod arcs;
mod beziers;

use super::number;
use super::text::{DecimalGrid, Placed, Text};
use crate::curve::measures::tolerance::{LEAST_DIGITS, LEAST_TOLERANCE, check_tolerance};
use crate::curve::{Curve, HermiteCurve, Pieces, Segment, frame, to_hermite};
use crate::error::Result;
use crate::limits::{LARGEST_COORDINATE, check};
use crate::numerics::plane::larger;
use crate::numerics::{Point, Vector};

/// From this many decimals on, coordinates are written so that every bit comes back.
const EXACT_DECIMALS: u32 = 17;
/// How much of the tolerance the rounding of points may use where the number of decimals is free.
const ROUNDING_SHARE: f64 = 0.15;
/// A point moves by at most this part of the grid's unit: half a diagonal.
const HALF_DIAGONAL: f64 = core::f64::consts::FRAC_1_SQRT_2;
/// Segments this straight, relative to the extent, are lines: rounding alone bends them more.
const STRAIGHT: f64 = 1e-13;
/// Segments this close to an ellipse, relative to the extent, are arcs of it.
const ELLIPTIC: f64 = 1e-8;

/// Bézier points more tangents away than this say nothing about how large the curve is: beyond a turn of 4.5 radians.
const FAR: f64 = 1.0;

/// How [`to_path_d`] writes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrintOptions {
    /// The largest distance between the curve and what the text draws, by default 0.02; below 1e-9 of the extent of
    /// points and Bézier points, or 1e-15 of the largest coordinate of these, it is raised to that.
    pub tolerance: f64,
    /// Digits behind the point, up to 17; `None` for as many as the tolerance needs. With 17 every coordinate is read
    /// back to the last bit.
    pub decimals: Option<u32>,
    /// Whether arcs of ellipses become `A`, as they do by default; else they become cubics.
    pub arcs: bool,
    /// Whether relative commands are used where they are shorter; by default all are absolute.
    pub relative: bool,
}

impl Default for PrintOptions {
    /// Tolerance 0.02, as many decimals as it needs, arcs as arcs, absolute commands.
    fn default() -> Self {
        Self { tolerance: 0.02, decimals: None, arcs: true, relative: false }
    }
}

/// What [`to_path_d`] wrote.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Printed {
    /// The path data.
    pub d: String,
    /// A bound of the distance between the curve and what the text draws, both ways: approximation and rounding
    /// together, measured on the numbers that were written.
    pub deviation: f64,
}

/// The curve as SVG path data.
///
/// Straight segments become `L`, `H` or `V`, arcs of ellipses `A` (neighbours on the same ellipse share one),
/// parabolas `Q`, all else `C` and `S`: exactly for cubics, within the tolerance otherwise. Closed curves end in `Z`,
/// without the closing line that it implies.
///
/// # Domain
///
/// Any curve of the plane. Numbers have the form `-?[0-9]*\.?[0-9]+(e-[0-9]+)?`, and an exponent only where 17 decimals
/// are asked for and 22 would not do.
///
/// # Accuracy
///
/// The deviation is at most the tolerance where `decimals` is `None`. With few decimals it can be more, and
/// says so. Points are rounded each for itself, in relative commands as well, so errors do not add up. With 17
/// decimals, lines, cubics and quadratics that were read by [`parse_path`](super::parse_path) come back bit for bit.
///
/// # Errors
///
/// `tolerance` that is not finite or not positive; more than 17 decimals; a curve in space; `handles` where a Bézier
/// point of what would be written is beyond ±1e9, where [`parse_path`](super::parse_path) reads no numbers.
///
/// # Cost
///
/// O(segments + pieces).
///
/// # Example
///
/// ```
/// use expline::svg::{PrintOptions, to_path_d};
/// use expline::HermiteCurve;
/// let circle = HermiteCurve::ellipse([50.0, 50.0].into(), [40.0, 40.0].into(), 0.0, 2)?;
/// let printed = to_path_d(&circle, &PrintOptions::default())?;
/// assert_eq!(printed.d, "M90 50A40 40 0 0 1 10 50 40 40 0 0 1 90 50Z");
/// assert!(printed.deviation < 1e-13);
/// # Ok::<(), expline::Error>(())
/// ```
pub fn to_path_d(curve: &dyn Curve, options: &PrintOptions) -> Result<Printed> {
    let (text, deviation) = match curve.as_hermite() {
        Some(curve) => print_hermite(curve, options, &mut None)?,
        None => print_converted(curve, options)?,
    };
    // All of it is ASCII.
    Ok(Printed { d: String::from_utf8(text).unwrap_or_default(), deviation })
}

/// A curve of another kind is printed as the Hermite curve that it is, or that is near; the tolerance is shared then.
fn print_converted(curve: &dyn Curve, options: &PrintOptions) -> Result<(Vec<u8>, f64)> {
    let (curve, near, rest) = outline(curve.as_pieces(), options.tolerance)?;
    let (text, deviation) = print_hermite(&curve, &PrintOptions { tolerance: rest, ..*options }, &mut None)?;
    Ok((text, deviation + near))
}

/// The Hermite curve that is printed in place of a curve, how far it is from that, and what is left of the tolerance.
pub(crate) fn outline(curve: &dyn Pieces, tolerance: f64) -> Result<(HermiteCurve, f64, f64)> {
    let (curve, near) = to_hermite(curve, 0.5 * tolerance)?;
    Ok((curve, near, (tolerance - near).max(near)))
}

/// The path data as bytes, which need no check, and the deviation.
///
/// `pen` is where the path before has ended, if there is one: a text that goes on from there may begin with `m`. It
/// moves to where this one ends.
pub(crate) fn print_hermite(
    curve: &HermiteCurve,
    options: &PrintOptions,
    pen: &mut Option<Point>,
) -> Result<(Vec<u8>, f64)> {
    let mut printer = Printer::new(curve, options, *pen)?;
    let start = printer.text.current();
    printer.draw_all();
    // What is beyond is not read back. The Bézier points of an arc may lie there, but not what draws it.
    check("handles", None, printer.text.largest, 0.0, LARGEST_COORDINATE)?;
    *pen = Some(if curve.is_closed() { start } else { printer.text.current() }.point());
    Ok(printer.finish())
}

struct Printer<'a> {
    curve: &'a HermiteCurve,
    text: Text,
    grid: DecimalGrid,
    arcs: bool,
    tolerance: f64,
    /// What is left of the tolerance for approximations.
    share: f64,
    straight: f64,
    /// What a coordinate is off by its last place.
    rounding: f64,
    elliptic: f64,
    deviation: f64,
    /// The last control point written, for `S`.
    control: Option<Placed>,
    pieces: Vec<[Point; 4]>,
}

impl<'a> Printer<'a> {
    fn new(curve: &'a HermiteCurve, options: &PrintOptions, pen: Option<Point>) -> Result<Self> {
        let PrintOptions { tolerance, decimals, arcs, relative } = *options;
        check_tolerance(tolerance)?;
        if let Some(asked) = decimals {
            check("decimals", None, f64::from(asked), 0.0, f64::from(EXACT_DECIMALS))?;
        }
        let (extent, largest) = size(curve);
        let least = (LEAST_TOLERANCE * extent).max(LEAST_DIGITS * largest);
        let tolerance = tolerance.max(least).max(f64::MIN_POSITIVE);
        let grid = match decimals {
            Some(EXACT_DECIMALS..) => DecimalGrid::EXACT,
            Some(decimals) => DecimalGrid::new(decimals, largest),
            None => grid_for(tolerance, largest),
        };
        let start = grid.place(curve.points()[0]);
        // A mirrored control point can be off by three half diagonals, at a weight of 4/9 of the curve.
        let rounding = (1.0 + 8.0 / 9.0) * HALF_DIAGONAL * grid.unit();
        let share = (tolerance - rounding).max(0.5 * tolerance);
        Ok(Self {
            curve,
            text: Text::new(grid, relative, start, pen),
            grid,
            arcs,
            tolerance,
            share,
            straight: (STRAIGHT * extent.max(largest)).min(0.25 * tolerance),
            rounding: f64::EPSILON * extent.max(largest),
            elliptic: ELLIPTIC * extent,
            deviation: 0.0,
            control: None,
            pieces: Vec::new(),
        })
    }

    fn draw_all(&mut self) {
        let count = self.curve.segment_count();
        let mut i = 0;
        while i < count {
            let segment = self.curve.nth_segment(i);
            let end = self.curve.is_closed() && i + 1 == count;
            if self.is_line(&segment) {
                self.line(&segment, end);
            } else if let Some((ellipse, run)) = self.arc_run(i) {
                self.arcs(&ellipse, run);
                i = run.last;
            } else {
                self.bezier(&segment);
            }
            i += 1;
        }
    }

    fn finish(mut self) -> (Vec<u8>, f64) {
        if self.curve.is_closed() {
            self.text.close();
        }
        (self.text.into_bytes(), self.deviation)
    }

    fn measured(&mut self, deviation: f64) {
        self.deviation = larger(self.deviation, deviation);
    }

    fn is_line(&self, segment: &Segment<'_>) -> bool {
        if self.grid == DecimalGrid::EXACT {
            // Only what a reader of `L` gets back as it was.
            let chord = segment.end - segment.start;
            return segment.leaving * segment.length == chord && segment.arriving * segment.length == chord;
        }
        segment.as_line(self.straight)
    }

    /// A straight segment; the last one of a closed curve is what `Z` draws.
    fn line(&mut self, segment: &Segment<'_>, last: bool) {
        let end = self.grid.place(segment.end);
        let ends = larger(displacement(self.text.current(), segment.start), displacement(end, segment.end));
        let bend = segment.bend();
        self.measured(ends + if bend > self.rounding { bend } else { 0.0 });
        // Where nothing is written, a reader goes on mirroring the control point before.
        if !last && end != self.text.current() {
            self.text.line(end);
            self.control = None;
        }
    }
}

#[inline(never)]
fn displacement(placed: Placed, p: Point) -> f64 {
    (placed.point() - p).norm()
}

/// Fewest decimals for which rounding uses no more than its share of the tolerance.
fn grid_for(tolerance: f64, largest: f64) -> DecimalGrid {
    // Not known to the compiler, which would unroll the loop.
    let most = core::hint::black_box(EXACT_DECIMALS);
    let mut decimals = 0;
    while decimals < most && HALF_DIAGONAL > ROUNDING_SHARE * tolerance * number::power(decimals) {
        decimals += 1;
    }
    let grid = DecimalGrid::new(decimals, largest);
    let fine = HALF_DIAGONAL <= ROUNDING_SHARE * tolerance * number::power(decimals);
    if fine && grid.decimals() == Some(decimals) { grid } else { DecimalGrid::EXACT }
}

/// Extent and largest coordinate of the points and their generalised Bézier points, in whose hull the curve lies; of
/// nearly full turns, whose Bézier points lie anywhere out there, those of the curve itself.
fn size(curve: &HermiteCurve) -> (f64, f64) {
    let far = curve.segments().any(|segment| segment.basis.kappa() > FAR);
    let b = if far { curve.bounds() } else { frame(curve, 1.0 / 3.0) };
    (Vector::new(b.max_x - b.min_x, b.max_y - b.min_y).norm(), b.largest())
}
