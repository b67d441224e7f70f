//! Uniform sampling, block by block: a Taylor formula that is exact in the space, with shared tables.
//!
//! Any function r of the space span{1, t, cos ωt, sin ωt} (and of its hyperbolic and polynomial kin) has, exactly,
//!
//! ```text
//! r(a ± τ) = [r(a) + r″(a)·τ²c₂(ω²τ²)] ± [r′(a)·τ + r‴(a)·τ³c₃(ω²τ²)]
//! ```
//!
//! with Stumpff's c₂ and c₃. The factors of the derivatives depend on ω and on the step between samples alone: one
//! table serves every block of every segment with this ω (D 7.1). A block costs four derivatives at its middle, and then
//! two points at a time cost three multiplications and four additions per coordinate.

use core::f64::consts::{FRAC_PI_2, PI};

use super::Segment;
use super::grid::Grid;
use super::hermite::HermiteCurve;
use crate::generator::{Space, Weights};
use crate::numerics::entire::{series, stumpff};
use crate::numerics::{Point, Vector};

/// Pairs of points in the largest block: 256 points are 4 kB, and the tables another 4 kB.
const PAIRS: usize = 128;
/// The odd point of a block lies one place beyond its pairs.
const PLACES: usize = PAIRS + 1;
/// Fewer samples than this on a segment are evaluated one by one.
const FEWEST: usize = 4;

/// Samples curves uniformly and remembers its tables from one call to the next.
///
/// The results do not depend on what it remembers, nor on how a sampling is cut into ranges: the same curve and
/// the same count give the same bits.
#[derive(Clone, Debug)]
pub struct Sampler {
    kind: Kind,
    /// The kind's ω and ±ω², negative in the hyperbolic space.
    omega: f64,
    square: f64,
    /// Pairs of samples in a full block.
    pairs: usize,
    /// How many places of the tables are filled in.
    built: usize,
    /// τ = step·(k + ½), τc₁, τ²c₂ and τ³c₃.
    tau: [f64; PLACES],
    first: [f64; PLACES],
    second: [f64; PLACES],
    third: [f64; PLACES],
    /// The weights of value and derivatives at x = `place`.
    place: f64,
    weights: [Weights; 4],
    shift: Shift,
}

/// What segments have in common that are sampled alike: space, ω·length, length, and the step in t.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Kind {
    space: Space,
    w: f64,
    length: f64,
    step: f64,
}

impl Sampler {
    /// A sampler that remembers nothing yet.
    pub const fn new() -> Self {
        let blank = [0.0; PLACES];
        Self {
            kind: Kind { space: Space::Polynomial, w: f64::NAN, length: f64::NAN, step: f64::NAN },
            omega: f64::NAN,
            square: f64::NAN,
            pairs: 0,
            built: 0,
            tau: blank,
            first: blank,
            second: blank,
            third: blank,
            place: f64::NAN,
            weights: [Weights { chord: 0.0, leaving: 0.0, arriving: 0.0 }; 4],
            shift: Shift::NONE,
        }
    }
}

impl Default for Sampler {
    fn default() -> Self {
        Self::new()
    }
}

/// Value and derivatives with respect to t at the middle of a block.
struct Jet {
    value: Vector,
    first: Vector,
    second: Vector,
    third: Vector,
}

impl Sampler {
    /// Samples `first`, `first + 1`, … of the uniform sampling of `curve` by `count` points, as many as `out` has
    /// room for, x and y in turn.
    ///
    /// Sample i lies at i/count of the parameter range of a closed curve, at i/(count − 1) of an open one.
    ///
    /// # Accuracy
    ///
    /// Within 4 roundings of the curve's size of [`HermiteCurve::evaluate`]; samples that fall on a point are that
    /// point to the last bit (`tests/sampling.rs`).
    ///
    /// # Cost
    ///
    /// About a nanosecond a point where a segment holds many of them.
    pub fn points(&mut self, curve: &HermiteCurve, count: usize, first: usize, out: &mut [f64]) {
        self.run::<2>(curve, count, first, out);
    }

    /// The same with the derivative after each point: x, y, dx/dt, dy/dt.
    pub fn points_and_tangents(&mut self, curve: &HermiteCurve, count: usize, first: usize, out: &mut [f64]) {
        self.run::<4>(curve, count, first, out);
    }

    /// Walks the segments that the range touches; `N` numbers are written for every sample.
    fn run<const N: usize>(&mut self, curve: &HermiteCurve, count: usize, first: usize, out: &mut [f64]) {
        let grid = Grid::new(curve, count);
        let (samples, _) = out.as_chunks_mut::<N>();
        let end = count.min(first.saturating_add(samples.len()));
        let mut i = first;
        if i >= end {
            return;
        }
        let mut s = grid.segment_of(curve, i);
        let mut start = grid.first_sample(curve, s);
        while i < end {
            let stop = if s + 1 == curve.segment_count() { count } else { grid.first_sample(curve, s + 1) };
            if stop > i {
                let to = stop.min(end);
                if let Some(samples) = samples.get_mut(i - first..to - first) {
                    self.segment(curve, &grid, s, (start, stop), i, samples);
                    pin(curve, &grid, s, i, to == count, samples);
                }
                i = to;
            }
            start = stop;
            s += 1;
        }
    }

    /// Samples `from`, … of segment s, which holds the samples from `start` up to `stop`.
    fn segment<const N: usize>(
        &mut self,
        curve: &HermiteCurve,
        grid: &Grid,
        s: usize,
        (start, stop): (usize, usize),
        from: usize,
        samples: &mut [[f64; N]],
    ) {
        let segment = curve.segment(s);
        self.suit(&segment, grid.step);
        let block = 2 * self.pairs;
        if block == 0 || stop - start < FEWEST {
            for (i, sample) in (from..).zip(samples) {
                write(sample, &segment, grid.local(curve, s, 2 * i));
            }
            return;
        }
        let (mut at, mut rest) = (from, samples);
        while !rest.is_empty() {
            let skipped = if at == start { 0 } else { (at - start) % block };
            let begin = at - skipped;
            let size = block.min(stop - begin);
            self.tables(size / 2 + 1);
            let x = grid.local(curve, s, 2 * begin + 2 * (size / 2) - 1);
            let jet = self.jet(&segment, x);
            let (now, later) = rest.split_at_mut(rest.len().min(size - skipped));
            if now.len() == size {
                self.fill(&jet, now);
            } else {
                self.fill_part(&jet, size, skipped, now);
            }
            at = begin + size;
            rest = later;
        }
    }

    /// Makes `kind` that of this segment, and the tables empty if they are of another ω.
    fn suit(&mut self, segment: &Segment, step: f64) {
        let (space, w, length) = (segment.basis.space(), segment.basis.frequency(), segment.length);
        let kind = Kind { space, w, length, step };
        if self.kind == kind {
            return;
        }
        let omega = w / length;
        if (self.kind.space, self.omega, self.kind.step) != (space, omega, step) {
            self.built = 0;
        }
        // Half a block may span π/2 radians: that is as far as the series of the tables reach.
        let reach = FRAC_PI_2 / (omega * step) - 1.0;
        self.pairs = if reach >= PAIRS as f64 { PAIRS } else { reach as usize };
        self.square = if space == Space::Hyperbolic { -omega * omega } else { omega * omega };
        (self.kind, self.omega) = (kind, omega);
        self.place = f64::NAN;
        self.shift = Shift::NONE;
    }

    /// Makes sure that the tables hold at least `places` places.
    fn tables(&mut self, places: usize) {
        if self.built >= places {
            return;
        }
        let (step, square, built) = (self.kind.step, self.square, self.built);
        let tables = self.tau.iter_mut().zip(&mut self.first).zip(&mut self.second).zip(&mut self.third);
        for (k, (((tau, first), second), third)) in tables.enumerate().take(places).skip(built) {
            let t = step * (k as f64 + 0.5);
            let u = square * t * t;
            let (c2, c3) = series(u);
            (*tau, *first, *second, *third) = (t, t * (1.0 - u * c3), t * t * c2, t * t * t * c3);
        }
        self.built = places;
    }

    /// Value and derivatives at x, by way of the segment's middle, where they are the same combinations of the
    /// data for all segments of one kind.
    fn jet(&mut self, segment: &Segment, x: f64) -> Jet {
        // The middle of a stiff segment knows nothing of its ends.
        let stiff = self.kind.space == Space::Hyperbolic && self.kind.w > PI;
        let place = if stiff { x } else { 0.5 };
        if self.place != place {
            self.place = place;
            self.weights = [0, 1, 2, 3].map(|order| segment.basis.weights(place, order));
        }
        let [value, first, second, third] = self.weights.map(|weights| segment.combine(weights));
        let inverse = 1.0 / segment.length;
        let (first, second, third) =
            (first * inverse, second * (inverse * inverse), third * (inverse * inverse * inverse));
        let jet = Jet { value: segment.start + value, first, second, third };
        if stiff {
            return jet;
        }
        let t = (x - 0.5) * segment.length;
        if self.shift.t != t {
            self.shift = Shift::new(t, self.square);
        }
        jet.shifted(&self.shift, self.square)
    }

    /// One block: pairs of samples from its middle outwards, and the odd one at its end.
    fn fill<const N: usize>(&self, jet: &Jet, samples: &mut [[f64; N]]) {
        let pairs = samples.len() / 2;
        let (left, right) = samples.split_at_mut(pairs);
        if let (Some(odd), true) = (right.get_mut(pairs), pairs < PLACES) {
            let at = pairs..pairs + 1;
            let tables = [&self.tau, &self.first, &self.second, &self.third].map(|table| &table[at.clone()]);
            jet.fill(tables, &mut [*odd], core::slice::from_mut(odd));
        }
        let tables =
            [&self.tau, &self.first, &self.second, &self.third].map(|table| &table[..pairs.min(PLACES)]);
        jet.fill(tables, left, right);
    }

    /// Samples of a block of `size` from `skipped` on, where a range of samples begins or ends within a block.
    #[cold]
    fn fill_part<const N: usize>(&self, jet: &Jet, size: usize, skipped: usize, samples: &mut [[f64; N]]) {
        let mut block = [[0.0; N]; 2 * PAIRS];
        if let Some(block) = block.get_mut(..size) {
            self.fill(jet, block);
            for (sample, value) in samples.iter_mut().zip(block.iter().skip(skipped)) {
                *sample = *value;
            }
        }
    }
}

/// How derivatives change over a distance t in the parameter.
#[derive(Clone, Copy, Debug)]
struct Shift {
    t: f64,
    zeroth: f64,
    first: f64,
    second: f64,
    third: f64,
}

impl Shift {
    const NONE: Self = Self { t: 0.0, zeroth: 1.0, first: 0.0, second: 0.0, third: 0.0 };

    fn new(t: f64, square: f64) -> Self {
        let c = stumpff(square * t * t);
        Self { t, zeroth: c.c0, first: t * c.c1, second: t * t * c.c2, third: t * t * t * c.c3 }
    }
}

impl Jet {
    /// The same at another place, exactly: (D 2.3).
    fn shifted(&self, by: &Shift, square: f64) -> Self {
        Self {
            value: (self.value + self.second * by.second) + (self.first * by.t + self.third * by.third),
            first: self.first + self.second * by.first + self.third * by.second,
            second: self.second * by.zeroth + self.third * by.first,
            third: self.third * by.zeroth - self.second * (square * by.first),
        }
    }

    /// The samples at middle ± τ for every place of the tables, from the middle outwards.
    ///
    /// Compilers make vector code of this loop, two places at a time; it is on its own so that they can see that
    /// nothing overlaps.
    #[inline(never)]
    fn fill<const N: usize>(
        &self,
        [tau, first, second, third]: [&[f64]; 4],
        left: &mut [[f64; N]],
        right: &mut [[f64; N]],
    ) {
        let [value, slope, bend, twist] =
            [self.value, self.first, self.second, self.third].map(|v| [v.x, v.y]);
        let tables = tau.iter().zip(first).zip(second).zip(third);
        for ((((tau, first), second), third), (left, right)) in tables.zip(left.iter_mut().rev().zip(right)) {
            for k in 0..2 {
                let even = value[k] + bend[k] * second;
                let odd = slope[k] * tau + twist[k] * third;
                (left[k], right[k]) = (even - odd, even + odd);
            }
            if N == 4 {
                for k in 0..2 {
                    let even = slope[k] + twist[k] * second;
                    let odd = bend[k] * first;
                    (left[k + 2], right[k + 2]) = (even - odd, even + odd);
                }
            }
        }
    }
}

/// Puts samples that fall on a point there to the last bit.
fn pin<const N: usize>(
    curve: &HermiteCurve,
    grid: &Grid,
    s: usize,
    from: usize,
    is_last: bool,
    samples: &mut [[f64; N]],
) {
    if grid.is_at_knot(curve, s, from)
        && let Some(sample) = samples.first_mut()
    {
        put(sample, curve.points()[s], curve.tangents()[s]);
    }
    if is_last
        && !curve.is_closed()
        && from + samples.len() > 1
        && let Some(sample) = samples.last_mut()
    {
        put(sample, curve.points()[s + 1], curve.tangents_in()[s + 1]);
    }
}

fn put<const N: usize>(sample: &mut [f64; N], position: Point, velocity: Vector) {
    (sample[0], sample[1]) = (position.x, position.y);
    if N == 4 {
        (sample[2], sample[3]) = (velocity.x, velocity.y);
    }
}

fn write<const N: usize>(sample: &mut [f64; N], segment: &Segment, x: f64) {
    let velocity = if N == 4 { segment.velocity(x) } else { Vector::zeros() };
    put(sample, segment.position(x), velocity);
}
