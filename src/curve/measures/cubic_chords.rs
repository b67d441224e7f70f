//! Chords of cubics: spread, proved and written in single precision, several cubics or several chords at a time.
//!
//! Let v, a, j be the derivatives of the cubic in the middle of a chord c of parameter width h. With u from −1 to 1
//! along it the cubic is off the chord's line by
//!
//! ```text
//! (h²/4)·(1 − u²)(A + Bu)/|c/h|
//! A = ½·v × a − (h²/48)·a × j     B = (h/12)·v × j     c/h = v + (h²/24)·j
//! ```
//!
//! which is at most (h²/4)·√(A² + B²/2)/|c/h|: (A + Bu)² ≤ (A² + B²/2)(1 + 2u²), and
//! (1 − u²)²(1 + 2u²) = 1 − 3u⁴ + 2u⁶ ≤ 1. Where (h/2)|a| + (h²/12)|j| ≤ |c|/2h its control points project into the
//! chord, and that bounds the distance both ways. Where not (cusps, turns) it says nothing, and the chords of all kinds
//! of pieces do ([`super::chords`]).

use super::spreading::part_count;
use super::tolerance::beyond;
use crate::error::{Error, Result};
use crate::limits::MOST_OUTPUT_POINTS;
use crate::numerics::plane::{cross, taxi};
use crate::numerics::{Point, Vector};

/// Parts of a cubic in each of which the density of chords is linear.
const CELLS: usize = 11;
/// Cubics whose densities are worked on at a time.
pub(super) const GROUP: usize = 16;
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
/// Densities are about 1; where there is none at all, this keeps a cell's from being 0.
const LEAST_DENSITY: f32 = 1e-12;

/// Cuts groups of cubics into chords.
///
/// Work on one cubic is a long chain of sums and roots, each of which waits for the one before; side by side, cubics do
/// not wait for each other.
pub(super) struct Cutter {
    /// The point and the three derivatives in the middle of each cubic, and where it starts.
    middles: [[Vector; 4]; GROUP],
    starts: [Point; GROUP],
    /// What lengths are in units of.
    sizes: [f64; GROUP],
    turnings: Turnings,
    sums: Sums,
    cells: [Cell; CELLS],
    /// The ends of the chords of a batch, and what fills up the lanes behind them.
    places: [f32; BATCH + LANES + 1],
    bounds: [f32; BATCH],
}

/// Velocities and turnings of cubics as polynomials in single precision, scaled to about 1; lane by lane.
struct Turnings {
    b: [[f32; GROUP]; 2],
    p: [[f32; GROUP]; 2],
    q: [[f32; GROUP]; 2],
    /// b × p, b × q and p × q.
    products: [[f32; GROUP]; 3],
}

/// What is known of the density at the last edge that was looked at.
struct Sums {
    root: [f32; GROUP],
    /// Twice the densities at the ends of the cells before, summed.
    total: [f32; GROUP],
}

/// A cell of each cubic. With d of its sum before it a point is at share·d − bend·d² of the cell, from its start: the
/// inverse of the integral of a linear density, to first order in its tilt.
#[derive(Clone, Copy)]
struct Cell {
    /// The sum up to its end.
    until: [f32; GROUP],
    share: [f32; GROUP],
    bend: [f32; GROUP],
}

impl Cutter {
    pub(super) const fn new() -> Self {
        let zeros = [0.0; GROUP];
        let zero = Vector::new(0.0, 0.0);
        Self {
            middles: [[zero; 4]; GROUP],
            starts: [zero; GROUP],
            sizes: [0.0; GROUP],
            turnings: Turnings { b: [zeros; 2], p: [zeros; 2], q: [zeros; 2], products: [zeros; 3] },
            sums: Sums { root: zeros, total: zeros },
            cells: [Cell { until: zeros, share: zeros, bend: zeros }; CELLS],
            places: [0.0; BATCH + LANES + 1],
            bounds: [0.0; BATCH],
        }
    }

    /// Takes in the cubic of a lane: the point and the three derivatives in its middle, and its start.
    #[inline(never)]
    pub(super) fn take(&mut self, lane: usize, middle: &[Vector; 4], start: Point) {
        let [_, b, p, q] = *middle;
        let size = taxi(b) + taxi(p) + taxi(q);
        let size = if size > f64::MIN_POSITIVE { size } else { f64::MIN_POSITIVE };
        let scale = 1.0 / size;
        let (b, p, q) = (b * scale, p * scale, q * scale);
        let turnings = &mut self.turnings;
        for d in 0..2 {
            turnings.b[d][lane] = b[d] as f32;
            turnings.p[d][lane] = p[d] as f32;
            turnings.q[d][lane] = q[d] as f32;
        }
        for (products, product) in turnings.products.iter_mut().zip([cross(b, p), cross(b, q), cross(p, q)]) {
            products[lane] = product as f32;
        }
        (self.middles[lane], self.starts[lane], self.sizes[lane]) = (*middle, start, size);
    }

    /// Looks at the densities of the first `count` cubics.
    pub(super) fn look(&mut self, count: usize) {
        let count = count.next_multiple_of(LANES).min(GROUP);
        // What comes before the first edge is no cell.
        self.turnings.add(&mut self.sums, &mut self.cells[0], -0.5, count);
        self.sums.total = [0.0; GROUP];
        for (k, cell) in self.cells.iter_mut().enumerate() {
            self.turnings.add(&mut self.sums, cell, (k + 1) as f32 / CELLS as f32 - 0.5, count);
        }
    }

    /// Appends the start of a cubic and the points between its ends, and returns the bound of the distance; nothing,
    /// and nothing appended, where the bound is not good enough.
    #[inline(never)]
    pub(super) fn cut(
        &mut self,
        lane: usize,
        tolerance: f64,
        out: &mut Vec<[f64; 2]>,
    ) -> Result<Option<f64>> {
        let turning = self.turnings.of(lane);
        let size = self.sizes[lane];
        let all = f64::from(self.sums.total[lane]) * (0.5 / CELLS as f64);
        let margin = MARGINS[usize::from(turning.turns())];
        let mut wanted = all * margin * (size / (8.0 * tolerance)).sqrt();
        let written = out.len();
        for _ in 0..ATTEMPTS {
            let all = wanted + written as f64;
            if all > MOST_OUTPUT_POINTS as f64 {
                return Err(beyond(all as usize));
            }
            let count = part_count(wanted);
            out.try_reserve(count).map_err(|_| Error::memory(16 * count))?;
            out.push(self.starts[lane].into());
            let bound = f64::from(self.run(&turning, lane, count, out)).sqrt() * size;
            if bound <= tolerance {
                return Ok(Some(bound));
            }
            out.truncate(written);
            // The bound goes with the square of the number; where it takes many more, chords of other lengths do with
            // fewer.
            let next = 1.005 * (count as f64) * (bound / tolerance).sqrt();
            if next > 1.02 * (count as f64) + 1.0 {
                break;
            }
            wanted = next;
        }
        Ok(None)
    }

    /// Spreads the chords, writes the points between the ends and returns the largest squared bound.
    ///
    /// Each loop is a function of its own here: an engine has sixteen registers, and none is left over a call.
    fn run(&mut self, turning: &Turning, lane: usize, count: usize, out: &mut Vec<[f64; 2]>) -> f32 {
        let [a, b, p, q] = self.middles[lane];
        let (p, q) = (p * 0.5, q * (1.0 / 6.0));
        let step = self.sums.total[lane] / count as f32;
        self.places[0] = -0.5;
        let (mut first, mut worst) = (1, 0.0_f32);
        loop {
            let inner = (count - first).min(BATCH);
            let lanes = &mut self.places[1..=inner.next_multiple_of(LANES)];
            spread(&self.cells, lane, step, first, lanes);
            write([a, b, p, q], &lanes[..inner], out);
            // The last one of all ends at the end; what fills up the lanes there has no length.
            self.places[inner + 1..=inner + LANES].copy_from_slice(&[0.5; LANES]);
            let chords = if inner < BATCH { inner + 1 } else { BATCH };
            let bound = turning.largest(&self.places, &mut self.bounds[..chords.next_multiple_of(LANES)]);
            worst = if bound > worst { bound } else { worst };
            if inner < BATCH {
                return worst;
            }
            self.places[0] = self.places[BATCH];
            first += BATCH;
        }
    }
}

impl Turnings {
    /// √(|r′ × r″|/|r′|) of a lane at y: to it the number of chords is proportional.
    #[inline(always)]
    fn density(&self, lane: usize, y: f32) -> f32 {
        let Self { b, p, q, products } = self;
        let half = 0.5 * y;
        let along = |d: usize| b[d][lane] + y * (p[d][lane] + half * q[d][lane]);
        let turn = products[0][lane] + y * (products[1][lane] + half * products[2][lane]);
        let (x, y) = (along(0), along(1));
        (turn.abs() / ((x * x + y * y).sqrt() + 1e-12)).sqrt()
    }

    /// The cells that end at y, which go on from the last ones.
    #[inline(never)]
    fn add(&self, sums: &mut Sums, cell: &mut Cell, y: f32, count: usize) {
        // A whole number of lanes, as compilers can see.
        for lane in 0..count.min(GROUP) / LANES * LANES {
            let (from, to) = (sums.root[lane], self.density(lane, y));
            let sum = from + to + LEAST_DENSITY;
            let inverse = 1.0 / sum;
            let tilt = (to - from) * inverse;
            let width = (1.0 / CELLS as f32) * inverse;
            cell.share[lane] = width * (1.0 + tilt);
            cell.bend[lane] = width * tilt * inverse;
            sums.root[lane] = to;
            sums.total[lane] += sum;
            cell.until[lane] = sums.total[lane];
        }
    }

    /// One of them.
    #[inline(always)]
    fn of(&self, lane: usize) -> Turning {
        let at = |lanes: &[[f32; GROUP]; 2]| [lanes[0][lane], lanes[1][lane]];
        let products = [0, 1, 2].map(|k| self.products[k][lane]);
        let rounding = ROUNDING * (products[0].abs() + products[1].abs() + products[2].abs());
        Turning { b: at(&self.b), p: at(&self.p), q: at(&self.q), products, rounding }
    }
}

#[inline(never)]
fn write([a, b, p, q]: [Vector; 4], places: &[f32], out: &mut Vec<[f64; 2]>) {
    out.extend(places.iter().map(|&y| {
        let y = f64::from(y);
        [0, 1].map(|k| a[k] + y * (b[k] + y * (p[k] + y * q[k])))
    }));
}

/// Fills in the places of the points from `from` on, which are `step` apart in the sum of the densities.
///
/// All cells are looked at for every point, several points at a time: finding the one that a point is in takes longer.
#[inline(never)]
fn spread(cells: &[Cell; CELLS], lane: usize, step: f32, from: usize, places: &mut [f32]) {
    let lane = lane % GROUP;
    let count = places.len() / LANES * LANES;
    for (k, place) in places[..count].iter_mut().enumerate() {
        let at = (from as i32 + k as i32) as f32 * step;
        let (mut y, mut before) = (-0.5, 0.0);
        for cell in cells {
            let here = if at < cell.until[lane] { at } else { cell.until[lane] };
            let d = here - before;
            y += d * (cell.share[lane] - cell.bend[lane] * d);
            before = here;
        }
        *place = y;
    }
}

/// A cubic's velocity and turning as polynomials.
struct Turning {
    b: [f32; 2],
    p: [f32; 2],
    q: [f32; 2],
    products: [f32; 3],
    /// What the turning may be off.
    rounding: f32,
}

impl Turning {
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

    /// The largest squared bound of the chords between the places, as many as there are bounds, a multiple of the
    /// lanes.
    #[inline(never)]
    fn largest(&self, places: &[f32; BATCH + LANES + 1], bounds: &mut [f32]) -> f32 {
        let count = bounds.len() / LANES * LANES;
        let (starts, ends) = (&places[..count], &places[1..=count]);
        // Stored and looked through again: only so do compilers make vector code of it.
        for ((bound, &lo), &hi) in bounds.iter_mut().zip(starts).zip(ends) {
            *bound = self.squared_bound(0.5 * (lo + hi), hi - lo);
        }
        let mut most = [0.0_f32; LANES];
        for bounds in bounds.as_chunks::<LANES>().0 {
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
        let even = (0.5 * turn - square * (1.0 / 48.0 * pq)).abs() + rounding;
        let odd = width * (bq + middle * pq);
        let off = even * even + odd * odd * (1.0 / 288.0);
        // c/h, and (h/2)|a| + (h²/12)|j| by the sums of the coordinates.
        let (x, y) = (x + square * (1.0 / 24.0 * q[0]), y + square * (1.0 / 24.0 * q[1]));
        let length = x * x + y * y;
        let bend = (p[0] + middle * q[0]).abs() + (p[1] + middle * q[1]).abs();
        let spread = width * (0.5 * bend + width * (1.0 / 12.0 * (q[0].abs() + q[1].abs())));
        let safe = 4.0 * SAFETY * (spread * spread);
        let least = if safe > SLOW { safe } else { SLOW };
        if length >= least { SAFETY / 16.0 * (square * square) * off / length } else { f32::INFINITY }
    }
}
