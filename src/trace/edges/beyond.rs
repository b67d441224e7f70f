//! Strokes that the border of the picture cuts off, gone on with beyond it, so that their centre lines run straight to
//! it.
//!
//! Where a stroke is cut off, its outline turns and follows the border. Taken for an end of the stroke, that would stop
//! the centre line half a width before the border, and where the stroke comes at an angle, lead it into the sharper
//! corner.

use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::plane::{cross, dot, larger, norm, smaller};
use crate::numerics::{Point, Vector};
use crate::trace::picture::contour::Contour;
use crate::trace::picture::gray::Gray;
use crate::trace::samples::{Line, line_through, unit};
use crate::trace::tubes::chain::Chain;

/// The two sides of a stroke turn from each other by less.
const PARALLEL: f64 = 0.77;
/// What comes to the border at a flatter angle runs along it: its sine.
const STEEP: f64 = 0.12;
/// How much of its width a stroke has on the border, across it: less where it ends there, more where it meets another.
const WHOLE: [f64; 2] = [0.9, 1.6];
/// Wider is no stroke.
const MOST_WIDTH: f64 = 100.0;
/// Lines are smoothed over 8 pixels and end half a width before their strokes: so much more than the width goes on.
const MORE: f64 = 14.0;
/// As much of a side next to the border says nothing of where it goes, in pixels.
const ROUNDED: f64 = 1.0;
/// At least and at most so much of a side is looked at,
const SIDE: [f64; 2] = [5.0, 10.0];
/// and is no farther from a line than this part of it.
const STRAIGHT: f64 = 0.08;

/// What goes on of a stroke that the border cuts off.
struct Cut {
    /// The middle of the cut.
    middle: Point,
    /// Outwards, of length 1.
    ahead: Vector,
    /// How far it goes on from its middle, and how wide it is.
    length: f64,
    width: f64,
}

/// Lets outlines of strokes that the border cuts off go on, and draws their ink in a wider picture, which has a margin
/// of so many pixels on each side; `None` where there are none.
pub(super) fn go_on(gray: &Gray, sign: f64, contours: &mut [Contour]) -> Result<Option<(Gray, usize)>> {
    let size = Vector::new(gray.width() as f64, gray.height() as f64);
    let mut cuts = Vec::new();
    for contour in contours {
        outline_on(&mut contour.points, size, &mut cuts)?;
    }
    if cuts.is_empty() {
        return Ok(None);
    }
    let margin = cuts.iter().map(Cut::reach).fold(0.0, larger).ceil();
    let mut wide = gray.framed(margin as usize, if sign > 0.0 { u16::MAX } else { 0 })?;
    for cut in &cuts {
        cut.paint(gray, sign, margin, &mut wide);
    }
    Ok(Some((wide, margin as usize)))
}

/// How far outside of the picture a place is, along the axis that is farther; negative inside.
#[inline(never)]
pub(super) fn outside(p: Point, size: Vector) -> f64 {
    larger(larger(-p.x, p.x - size.x), larger(-p.y, p.y - size.y))
}

fn is_inside(p: Point, size: Vector) -> bool {
    outside(p, size) < 0.0
}

/// Looks at every stretch of an outline that follows the border.
fn outline_on(points: &mut Vec<Point>, size: Vector, cuts: &mut Vec<Cut>) -> Result<()> {
    let Some(start) = points.iter().position(|&p| is_inside(p, size)) else { return Ok(()) };
    let (count, before) = (points.len(), cuts.len());
    let mut ring: Vec<Point> = with_room(count)?;
    ring.extend_from_slice(&points[start..]);
    ring.extend_from_slice(&points[..start]);
    let mut on: Vec<Point> = with_room(count + 2)?;
    let mut i = 0;
    while i < count {
        let first = i;
        while i < count && !is_inside(ring[i], size) {
            i += 1;
        }
        if i > first {
            let sides = [ring[first - 1], ring[i % count]];
            if let Some(cut) = Cut::between(sides, &ring, [first - 1, i], size) {
                on.extend(sides.map(|side| side + cut.ahead * (cut.length - cut.along(side))));
                cuts.push(cut);
            } else {
                on.extend_from_slice(&ring[first..i]);
            }
        } else {
            on.push(ring[i]);
            i += 1;
        }
    }
    if cuts.len() > before {
        *points = on;
    }
    Ok(())
}

/// The line of the places that lead away from the border; `None` where they are none, or are soon there again.
#[inline(never)]
fn side_from(ring: &[Point], from: usize, forwards: bool, reach: f64, size: Vector) -> Option<Line> {
    let count = ring.len();
    let mut stretch = Vec::new();
    let (mut travelled, mut before) = (0.0, ring[from % count]);
    for k in 1..count {
        let p = ring[(if forwards { from + k } else { from + count - k }) % count];
        travelled += norm(p - before);
        if travelled > reach || !is_inside(p, size) {
            break;
        }
        if travelled >= ROUNDED {
            stretch.push(p);
        }
        before = p;
    }
    if travelled <= reach || stretch.len() < 4 {
        return None;
    }
    let line = line_through(&stretch);
    stretch.iter().all(|&p| line.offset(p).abs() < STRAIGHT * reach).then_some(line)
}

impl Cut {
    /// What goes on between two sides that come to the border; `None` for what is no stroke that is cut off.
    fn between(sides: [Point; 2], ring: &[Point], from: [usize; 2], size: Vector) -> Option<Self> {
        let way = sides[1] - sides[0];
        let middle = sides[0] + way * 0.5;
        let mut reach = norm(way).clamp(SIDE[0], SIDE[1]);
        let mut cut = None;
        // Thick strokes are straight over more.
        for _ in 0..2 {
            let before = side_from(ring, from[0], false, reach, size)?;
            let after = side_from(ring, from[1], true, reach, size)?;
            let ahead = -unit(before.direction + after.direction);
            let (width, between) =
                (cross(ahead, way).abs(), cross(ahead, after.middle - before.middle).abs());
            let length = width + dot(ahead, way).abs() + MORE;
            if dot(before.direction, after.direction) < PARALLEL
                || width < WHOLE[0] * between
                || width > WHOLE[1] * between
                || width > MOST_WIDTH
                || outside(middle + ahead * length, size) < STEEP * length
            {
                return None;
            }
            reach = larger(width, SIDE[0]);
            cut = Some(Self { middle, ahead, length, width });
        }
        cut
    }

    /// How far ahead of the middle of the cut a place is.
    fn along(&self, p: Point) -> f64 {
        dot(self.ahead, p - self.middle)
    }

    /// No part of what goes on is farther from the middle of the cut, to be on the safe side.
    fn reach(&self) -> f64 {
        self.length + self.width
    }

    /// Draws what goes on into a picture with a margin: along its way every pixel has the shade that the stroke has on
    /// the border.
    fn paint(&self, gray: &Gray, sign: f64, margin: f64, wide: &mut Gray) {
        let size = Vector::new(gray.width() as f64, gray.height() as f64);
        let from = self.middle + Vector::new(margin, margin);
        let reach = self.reach();
        for row in (from.y - reach).max(0.0) as usize..wide.height().min((from.y + reach) as usize) {
            for column in (from.x - reach).max(0.0) as usize..wide.width().min((from.x + reach) as usize) {
                let p = Point::new(column as f64 + 0.5 - margin, row as f64 + 0.5 - margin);
                let aside = cross(self.ahead, p - self.middle).abs();
                if is_inside(p, size) || self.along(p) > self.length || aside > 0.5 * self.width + 2.0 {
                    continue;
                }
                // Back to where the outermost centres of pixels are.
                let over = |p: f64, most: f64, ahead: f64| (p - smaller(larger(p, 0.5), most - 0.5)) / ahead;
                let back =
                    larger(larger(0.0, over(p.x, size.x, self.ahead.x)), over(p.y, size.y, self.ahead.y));
                let entry = p - self.ahead * back;
                let shade = &mut wide.row_mut(row)[column];
                if is_inside(entry, size) && sign * (gray.between(entry) - f64::from(*shade)) < 0.0 {
                    *shade = gray.between(entry) as u16;
                }
            }
        }
    }
}

/// What of the lines is in the picture, out to its border.
pub(super) fn inside(lines: Vec<Chain>, gray: &Gray) -> Result<Vec<Chain>> {
    let size = Vector::new(gray.width() as f64, gray.height() as f64);
    let mut chains = with_room(lines.len())?;
    for line in lines {
        let points = line.points();
        let Some(beyond) = points.iter().position(|&p| !is_inside(p, size)) else {
            chains.push(line);
            continue;
        };
        // A closed line that leaves the picture is open; it begins outside.
        let (start, last) = if line.is_closed() { (beyond, points.len()) } else { (0, points.len() - 1) };
        let mut piece: Vec<Point> = Vec::new();
        for k in 0..=last {
            let p = points[(start + k) % points.len()];
            let q = points[(start + k.saturating_sub(1)) % points.len()];
            let (here, before) = (outside(p, size), outside(q, size));
            if (here < 0.0) != (before < 0.0) {
                piece.push(q + (p - q) * (before / (before - here)));
            }
            if here < 0.0 {
                piece.push(p);
            }
            if (here >= 0.0 || k == last) && !piece.is_empty() {
                let piece = core::mem::take(&mut piece);
                // What only touches the picture is nothing.
                if piece.len() > 2 {
                    chains.push(Chain::new(piece, false)?);
                }
            }
        }
    }
    Ok(chains)
}
