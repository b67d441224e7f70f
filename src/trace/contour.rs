//! Iso-contours between pixel centres: closed polylines with the ink on one side.

use super::gray::Gray;
use crate::error::{Error, Result};
use crate::limits::with_room;
use crate::numerics::Point;
use crate::numerics::plane::cross;

/// A closed polyline; ink lies on the right as x goes right and y down, so that ink has a positive area.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// Where the contour crosses the lines between neighbouring pixel centres.
    pub points: Vec<Point>,
    /// The area inside in square pixels; negative for holes.
    pub area: f64,
}

/// No crossing yet.
const NONE: u32 = u32::MAX;

/// Links of crossings: every crossing has one before and one after it.
struct Crossings {
    places: Vec<[f32; 2]>,
    next: Vec<u32>,
    most: usize,
}

impl Crossings {
    fn add(&mut self, x: f64, y: f64) -> Result<u32> {
        if self.places.len() >= self.most {
            return Err(Error::limit("data", "maxContourPoints", self.most, self.places.len() as f64 + 1.0));
        }
        self.places.push([x as f32, y as f32]);
        self.next.push(NONE);
        Ok(self.places.len() as u32 - 1)
    }
}

/// All contours at `level` between `dark` ink and light paper (or light ink, if `inverted`) that enclose at least `speckle` square pixels.
///
/// The picture is taken to lie on paper: ink at its border is closed along the border. Where two diagonal pixels are ink,
/// the mean of the four decides whether they are joined.
///
/// # Errors
///
/// A picture with more contour points than half of its pixels and 65,536: not a drawing.
///
/// # Cost
///
/// O(pixels), in two rows; 12 bytes for each point.
pub fn contours(gray: &Gray, level: f64, inverted: bool, speckle: f64) -> Result<Vec<Contour>> {
    let most = gray.width() * gray.height() / 2 + 65_536;
    let mut crossings = Crossings { places: Vec::new(), next: Vec::new(), most };
    link(gray, level, inverted, &mut crossings)?;
    walk(&mut crossings, speckle)
}

/// Walks over all cells between four pixel centres, two rows at a time, with a frame of paper around.
fn link(gray: &Gray, level: f64, inverted: bool, crossings: &mut Crossings) -> Result<()> {
    let (width, height) = (gray.width(), gray.height());
    let sign = if inverted { -1.0 } else { 1.0 };
    // Positive is ink. Paper beyond the border is as far from the level as ink is.
    let fill = |row: Option<usize>, out: &mut Vec<f64>| {
        out.clear();
        out.resize(width + 2, f64::NAN);
        if let Some(row) = row {
            for (value, &shade) in out[1..].iter_mut().zip(gray.row(row)) {
                *value = sign * (level - f64::from(shade));
            }
        }
    };
    let (mut above, mut below): (Vec<f64>, Vec<f64>) = (with_room(width + 2)?, with_room(width + 2)?);
    let mut on_above = vec![NONE; width + 2];
    let mut on_below = vec![NONE; width + 2];
    fill(None, &mut above);
    for line in 0..=height {
        fill((line < height).then_some(line), &mut below);
        let y = line as f64 - 0.5;
        on_below.fill(NONE);
        let mut on_left = NONE;
        for cell in 0..=width {
            let x = cell as f64 - 0.5;
            let corners = [above[cell], above[cell + 1], below[cell + 1], below[cell]];
            let ink = corners.map(|value| value > 0.0);
            let right = if ink[1] == ink[2] {
                NONE
            } else {
                crossings.add(x + 1.0, y + between(corners[1], corners[2]))?
            };
            let bottom = if ink[3] == ink[2] {
                NONE
            } else {
                crossings.add(x + between(corners[3], corners[2]), y + 1.0)?
            };
            join(crossings, corners, ink, [on_above[cell], right, bottom, on_left]);
            on_below[cell] = bottom;
            on_left = right;
        }
        core::mem::swap(&mut above, &mut below);
        core::mem::swap(&mut on_above, &mut on_below);
    }
    Ok(())
}

/// Where between two centres the level lies; half-way to the paper beyond the border.
fn between(first: f64, second: f64) -> f64 {
    if first.is_nan() || second.is_nan() { 0.5 } else { first / (first - second) }
}

/// Joins the crossings on a cell's four sides, with the ink on the right.
fn join(crossings: &mut Crossings, corners: [f64; 4], ink: [bool; 4], sides: [u32; 4]) {
    // Side i runs from corner i to corner i + 1 around the cell. Contours enter where ink ends, and leave where it begins.
    let mut link = |from: usize, to: usize| crossings.next[sides[from] as usize] = sides[to];
    let enters = |i: usize| ink[i] && !ink[(i + 1) % 4];
    let leaves = |i: usize| !ink[i] && ink[(i + 1) % 4];
    let count = (0..4).filter(|&i| enters(i)).count();
    if count == 2 {
        // A saddle: the four together say whether the ink is joined through the middle.
        let mean = corners.iter().filter(|value| !value.is_nan()).sum::<f64>();
        let joined = mean > 0.0;
        for from in (0..4).filter(|&i| enters(i)) {
            link(from, if joined { (from + 1) % 4 } else { (from + 3) % 4 });
        }
        return;
    }
    if let (Some(from), Some(to)) = ((0..4).find(|&i| enters(i)), (0..4).find(|&i| leaves(i))) {
        link(from, to);
    }
}

/// Follows the links, round by round, in the order in which the crossings were met.
fn walk(crossings: &mut Crossings, speckle: f64) -> Result<Vec<Contour>> {
    let mut found = Vec::new();
    for start in 0..crossings.next.len() {
        if crossings.next[start] == NONE {
            continue;
        }
        let mut count = 0;
        let mut area = 0.0;
        let mut at = start;
        let place =
            |i: usize| Point::new(f64::from(crossings.places[i][0]), f64::from(crossings.places[i][1]));
        let first = place(start);
        loop {
            let next = crossings.next[at] as usize;
            area += 0.5 * cross(place(at) - first, place(next) - first);
            count += 1;
            at = next;
            if at == start {
                break;
            }
        }
        let mut points: Vec<Point> = Vec::new();
        let kept = area.abs() >= speckle && count >= 4;
        if kept {
            points = with_room(count)?;
        }
        loop {
            if kept {
                points.push(place(at));
            }
            let next = crossings.next[at] as usize;
            crossings.next[at] = NONE;
            at = next;
            if at == start {
                break;
            }
        }
        if kept {
            found.push(Contour { points, area });
        }
    }
    Ok(found)
}
