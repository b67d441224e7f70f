//! Chords of arcs: spread, proved and written, several arcs or several chords at a time, where that can be in single
//! precision.
//!
//! An arc is a part of a piece, or all of it, whose width times frequency is at most [`WIDEST`].
//! Let v, a, j be its derivatives in the middle of a chord c of parameter width h. With u from −1 to 1 along it the
//! cubic with the chord's ends and the same a and j is off the chord, at equal parameters, by
//!
//! ```text
//! −(h²/4)·(1 − u²)(A + B·u)     A = a/2     B = (h/12)·j
//! ```
//!
//! which is at most (h²/4)(|A| + |B|), both ways. Where (h/2)|a| + (h²/12)|j| ≤ |c/h| the cubic's control points
//! project into the chord, and what counts is only how far it is off the chord's line: with the cross products of A and
//! B with c/h, over |c/h|, that is at most (h²/4)·√(A² + B²/2), for (A + B·u)² ≤ (A² + B²/2)(1 + 2u²), and
//! (1 − u²)²(1 + 2u²) = 1 − 3u⁴ + 2u⁶ ≤ 1.
//!
//! A cubic arc is that cubic, with c/h = v + (h²/24)·j. With r⁗ = −w²·r″ an arc is farther from it by h⁴/192·max|r⁗|
//! at most, what Taylor's sum lacks at u and at the ends, and c/h is off by h⁴/1920·max|r⁽⁵⁾| at most
//! ([`Turning::off_cubics`]).

use crate::numerics::entire::{Stumpff, stumpff};
use crate::numerics::plane::{cross, taxi};
use crate::numerics::{Point, Vector};

/// The most that an arc runs through: its width times its frequency.
pub(super) const WIDEST: f64 = core::f64::consts::FRAC_PI_2;
/// Parts of an arc in each of which the density of chords is linear.
const CELLS: usize = 11;
/// Arcs whose densities are worked on at a time.
pub(super) const GROUP: usize = 16;
/// Points that are spread and chords that are proved at a time: they stay in the nearest cache.
const BATCH: usize = 64;
const LANES: usize = 4;
/// Chords along which an arc moves slower than this share of its derivatives' sum, squared, are not known to be safe.
const SLOW: f32 = 1e-5;
/// Roundings of the turning, and what its series lacks, as a share of the products that it is made of.
const ROUNDING: f32 = 8e-7;
/// Roundings of speeds, which are at least √[`SLOW`].
const SAFETY: f32 = 1.0005;
/// How many times the square of what it is compared with |c/h|² is at least, so that |c/h| can be .021 off.
const CLEAR: f32 = 1.05;
/// Densities are about 1; where there is none at all, this keeps a cell's from being 0.
const LEAST_DENSITY: f32 = 1e-12;

/// A cubic, or a part of a piece that runs through [`WIDEST`] at most.
#[derive(Clone, Copy)]
pub(super) struct Arc {
    /// The point and the three derivatives in the middle, by a y from −1/2 to 1/2.
    pub(super) middle: [Vector; 4],
    /// w² for trigonometric, −w² for hyperbolic arcs, 0 for cubics.
    pub(super) rate: f64,
    pub(super) start: Point,
}

/// The densities of a group of arcs.
///
/// Work on one arc is a long chain of sums and roots, each of which waits for the one before; side by side, arcs do not
/// wait for each other.
pub(super) struct Densities {
    turnings: Turnings,
    sums: Sums,
    cells: [Cell; CELLS],
}

/// What a velocity r′ = b + s₁p + s₂q and a turning r′ × r″ are made of in single precision, scaled to about 1; lane by
/// lane. s₁ and s₂ are those of [`terms`].
struct Turnings {
    b: [[f32; GROUP]; 2],
    p: [[f32; GROUP]; 2],
    q: [[f32; GROUP]; 2],
    /// w², negative where the arc is hyperbolic.
    rate: [f32; GROUP],
    /// b × p, b × q and p × q − w²·b × p: r‴ + w²r′ is the same everywhere, and so is r″ × r‴.
    products: [[f32; GROUP]; 3],
}

/// What is known of the density at the last edge that was looked at.
struct Sums {
    root: [f32; GROUP],
    /// Twice the densities at the ends of the cells before, summed.
    total: [f32; GROUP],
}

/// A cell of each arc. With d of its sum before it a point is at share·d − bend·d² of the cell, from its start: the
/// inverse of the integral of a linear density, to first order in its tilt.
#[derive(Clone, Copy)]
struct Cell {
    /// The sum up to its end.
    until: [f32; GROUP],
    share: [f32; GROUP],
    bend: [f32; GROUP],
}

impl Densities {
    pub(super) const fn new() -> Self {
        let zeros = [0.0; GROUP];
        let turnings =
            Turnings { b: [zeros; 2], p: [zeros; 2], q: [zeros; 2], rate: zeros, products: [zeros; 3] };
        let cell = Cell { until: zeros, share: zeros, bend: zeros };
        Self { turnings, sums: Sums { root: zeros, total: zeros }, cells: [cell; CELLS] }
    }

    /// Takes in the arc of a lane and returns what lengths are in units of.
    #[inline(never)]
    pub(super) fn take(&mut self, lane: usize, arc: &Arc) -> f64 {
        let [_, b, p, q] = arc.middle;
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
        turnings.rate[lane] = arc.rate as f32;
        let turn = cross(b, p);
        let all = [turn, cross(b, q), cross(p, q) - arc.rate * turn];
        for (products, product) in turnings.products.iter_mut().zip(all) {
            products[lane] = product as f32;
        }
        size
    }

    /// Looks at the densities of the first `count` arcs.
    pub(super) fn look(&mut self, count: usize) {
        let count = count.next_multiple_of(LANES).min(GROUP);
        let cubic = self.turnings.rate.iter().all(|&rate| rate == 0.0);
        let add = if cubic { Turnings::add::<true> } else { Turnings::add::<false> };
        // What comes before the first edge is no cell.
        add(&self.turnings, &mut self.sums, &mut self.cells[0], -0.5, count);
        self.sums.total = [0.0; GROUP];
        for (k, cell) in self.cells.iter_mut().enumerate() {
            add(&self.turnings, &mut self.sums, cell, (k + 1) as f32 / CELLS as f32 - 0.5, count);
        }
    }

    /// The integral of √(|r′ × r″|/|r′|) over the arc of a lane, in units of the root of its size.
    pub(super) fn total(&self, lane: usize) -> f64 {
        f64::from(self.sums.total[lane]) * (0.5 / CELLS as f64)
    }

    /// Whether the arc of a lane has an inflection, or so it seems.
    #[inline(always)]
    pub(super) fn turns(&self, lane: usize) -> bool {
        let [middle, even, odd] = [0, 1, 2].map(|k| self.turnings.products[k][lane]);
        let (ends, half) = (middle + 0.125 * odd, 0.5 * even);
        let (start, end) = (ends - half, ends + half);
        start * end < 0.0 || start * middle < 0.0
    }
}

impl Turnings {
    /// √(|r′ × r″|/|r′|) of a lane at y: to it the number of chords is proportional.
    #[inline(always)]
    fn density<const CUBIC: bool>(&self, lane: usize, y: f32) -> f32 {
        let Self { b, p, q, rate, products } = self;
        let [_, s1, s2] = terms::<CUBIC>(rate[lane], y);
        let along = |d: usize| b[d][lane] + (s1 * p[d][lane] + s2 * q[d][lane]);
        let turn = products[0][lane] + (s1 * products[1][lane] + s2 * products[2][lane]);
        let (x, y) = (along(0), along(1));
        (turn.abs() / ((x * x + y * y).sqrt() + 1e-12)).sqrt()
    }

    /// The cells that end at y, which go on from the last ones.
    #[inline(never)]
    fn add<const CUBIC: bool>(&self, sums: &mut Sums, cell: &mut Cell, y: f32, count: usize) {
        // A whole number of lanes, and not none, as compilers can see: they leave out what would do single ones.
        for lane in 0..count.clamp(LANES, GROUP) / LANES * LANES {
            let (from, to) = (sums.root[lane], self.density::<CUBIC>(lane, y));
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
        Turning { b: at(&self.b), p: at(&self.p), q: at(&self.q), rate: self.rate[lane], products, rounding }
    }
}

/// cos wy, sin wy/w and (1 − cos wy)/w² by their series: within 4e-7 for w|y| ≤ π/4. Of cubics 1, y and y²/2, for less
/// work.
#[inline(always)]
fn terms<const CUBIC: bool>(rate: f32, y: f32) -> [f32; 3] {
    let square = y * y;
    if CUBIC {
        return [1.0, y, 0.5 * square];
    }
    let z = rate * square;
    let s1 = y * (1.0 - z * (1.0 / 6.0 - z * (1.0 / 120.0 - z * (1.0 / 5040.0))));
    let s2 = square * (0.5 - z * (1.0 / 24.0 - z * (1.0 / 720.0 - z * (1.0 / 40320.0))));
    [1.0 - rate * s2, s1, s2]
}

/// The chords of a batch: where they end, what fills up the lanes behind them, and their bounds.
pub(super) struct Chords {
    places: [f32; BATCH + LANES + 1],
    bounds: [f32; BATCH],
}

impl Chords {
    pub(super) const fn new() -> Self {
        Self { places: [0.0; BATCH + LANES + 1], bounds: [0.0; BATCH] }
    }

    /// Spreads so many chords of the arc of a lane, writes the points between the ends and returns the largest bound.
    ///
    /// Each loop is a function of its own here: an engine has sixteen registers, and none is left over a call.
    pub(super) fn run(
        &mut self,
        arc: &Arc,
        lane: usize,
        densities: &Densities,
        count: usize,
        out: &mut Vec<[f64; 2]>,
    ) -> f32 {
        let turning = densities.turnings.of(lane);
        let step = densities.sums.total[lane] / count as f32;
        self.places[0] = -0.5;
        let (mut first, mut worst, mut widest) = (1, 0.0_f32, 0.0_f32);
        loop {
            let inner = (count - first).min(BATCH);
            let lanes = &mut self.places[1..=inner.next_multiple_of(LANES)];
            spread(&densities.cells, lane, step, first, lanes);
            write(arc, &lanes[..inner], out);
            // The last one of all ends at the end; what fills up the lanes there has no length.
            self.places[inner + 1..=inner + LANES].copy_from_slice(&[0.5; LANES]);
            let chords = if inner < BATCH { inner + 1 } else { BATCH };
            let bounds = &mut self.bounds[..chords.next_multiple_of(LANES)];
            let cubic = turning.rate == 0.0;
            let largest = if cubic { Turning::largest::<true> } else { Turning::largest::<false> };
            let bound = largest(&turning, &self.places, bounds);
            worst = if bound > worst { bound } else { worst };
            if !cubic {
                for pair in self.places[..=chords].windows(2) {
                    let width = pair[1] - pair[0];
                    widest = if width > widest { width } else { widest };
                }
            }
            if inner < BATCH {
                let bound = worst.sqrt();
                return if cubic { bound } else { bound + turning.off_cubics(bound, widest) };
            }
            self.places[0] = self.places[BATCH];
            first += BATCH;
        }
    }
}

/// Appends the points at the places.
#[inline(never)]
fn write(arc: &Arc, places: &[f32], out: &mut Vec<[f64; 2]>) {
    let Arc { middle: [a, b, p, q], rate, .. } = *arc;
    if rate == 0.0 {
        let (p, q) = (p * 0.5, q * (1.0 / 6.0));
        out.extend(places.iter().map(|&y| {
            let y = f64::from(y);
            [0, 1].map(|k| a[k] + y * (b[k] + y * (p[k] + y * q[k])))
        }));
        return;
    }
    out.extend(places.iter().map(|&y| {
        let y = f64::from(y);
        let square = y * y;
        let Stumpff { c2, c3, .. } = stumpff(rate * square);
        let (s2, s3) = (square * c2, y * square * c3);
        [0, 1].map(|k| a[k] + (y * b[k] + (s2 * p[k] + s3 * q[k])))
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

/// An arc's velocity and turning; see [`Turnings`].
struct Turning {
    b: [f32; 2],
    p: [f32; 2],
    q: [f32; 2],
    rate: f32,
    products: [f32; 3],
    /// What the turning may be off.
    rounding: f32,
}

impl Turning {
    /// What an arc's distance may be more than its cubics', where the widest chord has this width.
    ///
    /// Arcs run through π/2 at most. There cosh is below 1.33, so |r⁗| is at most w²(1.33·|p| + .55·|q|). For a chord
    /// along which control points project into it |j|h² ≤ 12·|c/h| and |a|h ≤ 2·|c/h|, and h⁴/1920·|r⁽⁵⁾| is at most
    /// .0083·w²h² of |c/h|, .021 at most: the distance by the line is more by that share, and by a fifth of h⁴/192·|r⁗|
    /// as the chord is turned.
    #[inline(always)]
    fn off_cubics(&self, bound: f32, widest: f32) -> f32 {
        let size = |v: [f32; 2]| v[0].abs() + v[1].abs();
        let turned = self.rate.abs() * (widest * widest);
        let fourth = size(self.p) * (1.0 / 120.0) + size(self.q) * (1.0 / 280.0);
        turned * (0.0085 * bound + (widest * widest) * fourth)
    }

    /// The largest squared bound of the chords between the places, as many as there are bounds, a multiple of the
    /// lanes.
    #[inline(never)]
    fn largest<const CUBIC: bool>(&self, places: &[f32; BATCH + LANES + 1], bounds: &mut [f32]) -> f32 {
        let count = bounds.len() / LANES * LANES;
        let (starts, ends) = (&places[..count], &places[1..=count]);
        // Stored and looked through again: only so do compilers make vector code of it.
        for ((bound, &lo), &hi) in bounds.iter_mut().zip(starts).zip(ends) {
            *bound = self.squared_bound::<CUBIC>(0.5 * (lo + hi), hi - lo);
        }
        let mut most = [0.0_f32; LANES];
        for bounds in bounds.as_chunks::<LANES>().0 {
            for (most, &bound) in most.iter_mut().zip(bounds) {
                *most = if bound > *most { bound } else { *most };
            }
        }
        most.iter().fold(0.0, |a: f32, &b| if b > a { b } else { a })
    }

    /// The squared bound of the distance between a chord, by its middle and width, and the cubic with its ends.
    #[inline(always)]
    fn squared_bound<const CUBIC: bool>(&self, middle: f32, width: f32) -> f32 {
        let Self { b, p, q, rate, products: [turn, even, odd], rounding } = *self;
        // r″ × r‴ and r‴ + w²r′, which are the same everywhere.
        let jolt = odd + rate * turn;
        let steady = [0, 1].map(|d| q[d] + rate * b[d]);
        let [c0, s1, s2] = terms::<CUBIC>(rate, middle);
        let square = width * width;
        let turned = turn + (s1 * even + s2 * odd);
        let turning = width * (c0 * even + s1 * odd);
        let even = (0.5 * turned - square * (1.0 / 48.0 * jolt)).abs() + rounding;
        let off = even * even + turning * turning * (1.0 / 288.0);
        let v = [0, 1].map(|d| b[d] + (s1 * p[d] + s2 * q[d]));
        let a = [0, 1].map(|d| c0 * p[d] + s1 * q[d]);
        let j = if CUBIC { q } else { [0, 1].map(|d| steady[d] - rate * v[d]) };
        let c = [0, 1].map(|d| v[d] + square * (1.0 / 24.0) * j[d]);
        let length = c[0] * c[0] + c[1] * c[1];
        let bend = 0.5 * (a[0].abs() + a[1].abs()) + width * (1.0 / 12.0 * (j[0].abs() + j[1].abs()));
        let along = bend * bend;
        let safe = CLEAR * (square * along);
        let least = if safe > SLOW { safe } else { SLOW };
        let squared = if length >= least { off / length } else { along };
        SAFETY / 16.0 * (square * square) * squared
    }
}
