//! Chords of a cubic: spread, proved and written in one pass, several at a time in single precision.
//!
//! Let v, a, j be the derivatives of the cubic in the middle of a chord c of parameter width h. With s from 0 to 1 along it
//! the cubic is off the chord's line by
//!
//! ```text
//! h²·s(1 − s)((A − B)(1 − s) + (A + B)s)/|c|
//! A = (h/2)·v × a − (h³/48)·a × j     B = (h²/12)·v × j     c = h(v + (h²/24)·j)
//! ```
//!
//! which is at most h²·max(|A|/4 + (8/27 − 1/4)|B|, 4/27·(|A| + |B|))/|c|. Where (h/2)|a| + (h²/12)|j| ≤ |c|/2h its
//! control points project into the chord, and that bounds the distance both ways. Where not (cusps, turns) it says nothing,
//! and the chords of all kinds of pieces do ([`super::chords`]).

use super::flatten::{beyond, chord_count};
use super::limits::MOST_OUTPUT_POINTS;
use crate::error::{Error, Result};
use crate::numerics::plane::{cross, taxi};
use crate::numerics::{Point, Vector};

/// Where the density is looked at.
const CELLS: usize = 11;
/// Lists of what cells have, in whole vectors.
const ROOM: usize = 12;
/// Points that are spread and chords that are proved at a time: they stay in the nearest cache.
const BATCH: usize = 64;
const LANES: usize = 4;
/// How often more chords are tried.
const ATTEMPTS: usize = 3;
/// What smooth densities may be off, and what those of a piece with an inflection.
const MARGINS: [f64; 2] = [1.01, 1.05];
/// Chords along which a cubic moves slower than this share of its derivatives' sum, squared, have no bound here.
const SLOW: f32 = 1e-5;
/// Roundings of the turning, as a share of the products that it is made of.
const ROUNDING: f32 = 4e-7;
/// Roundings of speeds, which are at least √[`SLOW`].
const SAFETY: f32 = 1.0005;

/// The edges of the cells.
const EDGES: [f32; ROOM] = {
    let mut edges = [0.5; ROOM];
    let mut k = 0;
    while k < CELLS {
        edges[k] = k as f32 / CELLS as f32 - 0.5;
        k += 1;
    }
    edges
};

/// Appends the start of a cubic and the points between its ends, and returns the bound of the distance; nothing, and nothing
/// appended, where the bound is not good enough. `middle` is the point and the three derivatives in the middle.
#[inline(never)]
pub(super) fn cut(
    middle: &[Vector; 4],
    start: Point,
    tolerance: f64,
    out: &mut Vec<f64>,
) -> Result<Option<f64>> {
    let turning = Turning::new(middle);
    let mut cells = Cells::new(&turning);
    let wanted = f64::from(cells.total) * (0.5 / CELLS as f64) * (turning.size / (8.0 * tolerance)).sqrt();
    let mut wanted = wanted * MARGINS[usize::from(turning.turns())];
    let written = out.len();
    for _ in 0..ATTEMPTS {
        let all = wanted + (written / 2) as f64;
        if all > MOST_OUTPUT_POINTS as f64 {
            return Err(beyond(all as usize));
        }
        let count = chord_count(wanted);
        out.try_reserve(2 * count).map_err(|_| Error::OutOfMemory { bytes: 16 * count })?;
        out.resize(written + 2 * count, 0.0);
        cells.divide(count);
        let points = out[written..].as_chunks_mut::<2>().0;
        points[0] = [start.x, start.y];
        let worst = run(&turning, &cells, middle, points);
        let bound = f64::from(worst).sqrt() * turning.size;
        if bound <= tolerance {
            return Ok(Some(bound));
        }
        // The bound goes with the square of the number; where it takes many more, chords of other lengths do with fewer.
        let next = 1.005 * (count as f64) * (bound / tolerance).sqrt();
        if next > 1.02 * (count as f64) + 1.0 {
            break;
        }
        wanted = next;
    }
    out.truncate(written);
    Ok(None)
}

/// Spreads the chords, writes the points behind the first and returns the largest squared bound.
///
/// Each loop is a function of its own here: an engine has sixteen registers, and none is left over a call.
fn run(turning: &Turning, cells: &Cells, middle: &[Vector; 4], points: &mut [[f64; 2]]) -> f32 {
    let [a, b, p, q] = *middle;
    let (p, q) = (p * 0.5, q * (1.0 / 6.0));
    let mut places = [0.5_f32; BATCH + LANES + 1];
    places[0] = -0.5;
    let (mut first, mut worst) = (1, 0.0_f32);
    loop {
        let inner = (points.len() - first).min(BATCH);
        cells.spread(first, &mut places[1..=inner]);
        places[inner + 1..=inner + LANES].fill(0.5);
        write([a, b, p, q], &places[1..=inner], &mut points[first..]);
        // The last one of all ends at the end; what fills up the lanes there has no length.
        let chords = if inner < BATCH { inner + 1 } else { BATCH };
        let bound = turning.largest(&places[..=chords.next_multiple_of(LANES)]);
        worst = if bound > worst { bound } else { worst };
        if inner < BATCH {
            return worst;
        }
        places[0] = places[BATCH];
        first += BATCH;
    }
}

#[inline(never)]
fn write([a, b, p, q]: [Vector; 4], places: &[f32], points: &mut [[f64; 2]]) {
    for (point, &y) in points.iter_mut().zip(places) {
        let y = f64::from(y);
        for k in 0..2 {
            point[k] = a[k] + y * (b[k] + y * (p[k] + y * q[k]));
        }
    }
}

/// How a cubic's chords are spread: the density of chords is linear in each cell.
struct Cells {
    /// Twice the densities at the edges, summed: what is before each edge.
    before: [f32; ROOM],
    total: f32,
    /// 1/(sum of the densities at both ends) of each cell, and by how much of it they differ.
    inverse: [f32; ROOM],
    tilt: [f32; ROOM],
    /// Point j is at s = offset + rate·j of the cell.
    offset: [f32; ROOM],
    rate: [f32; ROOM],
    /// The first point at or behind the start of each cell.
    first: [u32; ROOM],
}

impl Cells {
    #[inline(never)]
    fn new(turning: &Turning) -> Self {
        let zeros = [0.0; ROOM];
        let mut roots = [0.0; ROOM + 1];
        for (root, &y) in roots.iter_mut().zip(&EDGES) {
            *root = turning.density(y);
        }
        let (mut inverse, mut tilt, mut sums) = (zeros, zeros, zeros);
        for k in 0..ROOM {
            sums[k] = roots[k] + roots[k + 1] + 1e-30;
            inverse[k] = 1.0 / sums[k];
            tilt[k] = (roots[k + 1] - roots[k]) * inverse[k];
        }
        let (mut before, mut total) = (zeros, 0.0);
        for k in 0..CELLS {
            before[k] = total;
            total += sums[k];
        }
        before[CELLS] = f32::MAX;
        Self { before, total, inverse, tilt, offset: zeros, rate: zeros, first: [0; ROOM] }
    }

    /// Divides what there is into so many chords.
    #[inline(never)]
    fn divide(&mut self, count: usize) {
        let step = self.total / count as f32;
        let each = 1.0 / step;
        for k in 0..ROOM {
            self.offset[k] = -self.before[k] * self.inverse[k];
            self.rate[k] = step * self.inverse[k];
            self.first[k] = (self.before[k] * each).ceil() as u32;
        }
    }

    /// Fills in the places of the points from `from` on.
    #[inline(never)]
    fn spread(&self, from: usize, places: &mut [f32]) {
        // Which cell begins at each point, counted from 1: later ones that begin at the same point take it.
        let mut begins = [1_u32; BATCH];
        for (k, &first) in self.first.iter().enumerate().take(CELLS) {
            let at = (first as usize).saturating_sub(from);
            if let Some(begin) = begins.get_mut(at) {
                *begin = k as u32 + 1;
            }
        }
        let mut cell = 1;
        for (k, (place, &begin)) in places.iter_mut().zip(&begins).enumerate() {
            cell = if begin > cell { begin } else { cell };
            let at = (cell as usize - 1).min(CELLS - 1);
            let s = self.offset[at] + self.rate[at] * (from + k) as f32;
            let s = if s > 0.0 { s } else { 0.0 };
            let s = if s < 1.0 { s } else { 1.0 };
            // The inverse of the integral of a linear density, to first order in its tilt.
            *place = EDGES[at] + (1.0 / CELLS as f32) * (s + self.tilt[at] * (s * (1.0 - s)));
        }
    }
}

/// A cubic's velocity and turning as polynomials in single precision, scaled to about 1.
struct Turning {
    /// What lengths are in units of.
    size: f64,
    b: [f32; 2],
    p: [f32; 2],
    q: [f32; 2],
    /// b × p, b × q and p × q.
    products: [f32; 3],
    /// What the turning may be off.
    rounding: f32,
}

impl Turning {
    #[inline(never)]
    fn new([_, b, p, q]: &[Vector; 4]) -> Self {
        let size = taxi(*b) + taxi(*p) + taxi(*q);
        let size = if size > f64::MIN_POSITIVE { size } else { f64::MIN_POSITIVE };
        let scale = 1.0 / size;
        let (b, p, q) = (b * scale, p * scale, q * scale);
        let single = |v: Vector| [v.x as f32, v.y as f32];
        let products = [cross(b, p) as f32, cross(b, q) as f32, cross(p, q) as f32];
        let rounding = ROUNDING * (products[0].abs() + products[1].abs() + products[2].abs());
        Self { size, b: single(b), p: single(p), q: single(q), products, rounding }
    }

    /// r′ and r′ × r″ at y.
    #[inline(always)]
    fn at(&self, y: f32) -> [f32; 3] {
        let Self { b, p, q, products: [bp, bq, pq], .. } = *self;
        let half = 0.5 * y;
        [b[0] + y * (p[0] + half * q[0]), b[1] + y * (p[1] + half * q[1]), bp + y * (bq + half * pq)]
    }

    /// Whether there is an inflection, or so it seems.
    #[inline(always)]
    fn turns(&self) -> bool {
        let (start, middle, end) = (self.at(-0.5)[2], self.at(0.0)[2], self.at(0.5)[2]);
        start * end < 0.0 || start * middle < 0.0
    }

    /// √(|r′ × r″|/|r′|): to it the number of chords is proportional.
    #[inline(always)]
    fn density(&self, y: f32) -> f32 {
        let [x, y, turn] = self.at(y);
        (turn.abs() / ((x * x + y * y).sqrt() + 1e-12)).sqrt()
    }

    /// The largest squared bound of the chords between the places.
    #[inline(never)]
    fn largest(&self, places: &[f32]) -> f32 {
        let mut bounds = [1.0_f32; BATCH];
        let ends = places.get(1..).unwrap_or_default();
        // Stored and looked through again: only so do compilers make vector code of it.
        for ((bound, &lo), &hi) in bounds.iter_mut().zip(places).zip(ends) {
            *bound = self.squared_bound(0.5 * (lo + hi), hi - lo);
        }
        let mut most = [0.0_f32; LANES];
        let chords = bounds.get(..ends.len()).unwrap_or_default();
        for bounds in chords.as_chunks::<LANES>().0 {
            for (most, &bound) in most.iter_mut().zip(bounds) {
                *most = if bound > *most { bound } else { *most };
            }
        }
        most.iter().fold(0.0, |a: f32, &b| if b > a { b } else { a })
    }

    /// The squared bound of a chord by its middle and width; infinite where its control points may leave it.
    #[inline(always)]
    fn squared_bound(&self, middle: f32, width: f32) -> f32 {
        let Self { p, q, products: [_, bq, pq], rounding, .. } = *self;
        let [x, y, turn] = self.at(middle);
        let square = width * width;
        let even = (0.5 * turn - square * (1.0 / 48.0) * pq).abs() + rounding;
        let odd = (width * (1.0 / 12.0) * (bq + middle * pq)).abs();
        let (one, two) = (0.25 * even + (8.0 / 27.0 - 0.25) * odd, (4.0 / 27.0) * (even + odd));
        let off = square * if one > two { one } else { two };
        // c/h, and (h/2)|a| + (h²/12)|j| by the sums of the coordinates.
        let (x, y) = (x + square * (1.0 / 24.0) * q[0], y + square * (1.0 / 24.0) * q[1]);
        let length = x * x + y * y;
        let bend = (p[0] + middle * q[0]).abs() + (p[1] + middle * q[1]).abs();
        let spread = width * (0.5 * bend + width * (1.0 / 12.0) * (q[0].abs() + q[1].abs()));
        let safe = 4.0 * SAFETY * (spread * spread);
        let least = if safe > SLOW { safe } else { SLOW };
        if length >= least { SAFETY * (off * off) / length } else { f32::INFINITY }
    }
}
