//! Uniform sampling, block by block: a Taylor formula that is exact in the space, with shared tables.
//!
//! Any function r of the space span{1, t, cos ωt, sin ωt} (and of its hyperbolic and polynomial kin) has, exactly,
//!
//! ```text
//! r(a ± τ) = [r(a) + r″(a)·τ²c₂(ω²τ²)] ± [r′(a)·τ + r‴(a)·τ³c₃(ω²τ²)]
//! ```
//!
//! with Stumpff's c₂ and c₃. The factors of the derivatives depend on ω and on the step between samples alone: one
//! table serves every block of every segment with this ω (D 7.1). A block costs four derivatives at its middle, and
//! then two points at a time cost three multiplications and four additions per coordinate.

use core::f64::consts::{FRAC_PI_2, PI};

use super::HermiteCurve;
use super::places::{Places, Run, place};
use crate::curve::Segment;
use crate::generator::Space;
use crate::numerics::entire::stumpff;
use crate::numerics::{Point, Vector};

/// Pairs of points in the largest block: 512 points are 8 kB, and the tables another 8 kB.
const PAIRS: usize = 256;
/// Fewer samples than this on a segment are evaluated one by one; of a cubic, which is so quick without tables.
const FEWEST: usize = 4;
const FEWEST_OF_CUBIC: usize = 8;

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
    tables: [[f64; PAIRS]; 4],
    /// Weights of value and derivatives with respect to t: at the segment's middle, or at `place` in a stiff one …
    middle: Rows,
    /// … and where a block has its middle, which is at `place`.
    weights: Rows,
    place: f64,
}

/// For value and three derivatives, the weights of the chord and of the derivatives at the ends.
type Rows = [[f64; 3]; 4];

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
        Self {
            kind: Kind { space: Space::Polynomial, w: f64::NAN, length: f64::NAN, step: f64::NAN },
            omega: f64::NAN,
            square: f64::NAN,
            pairs: 0,
            built: 0,
            tables: [[0.0; PAIRS]; 4],
            middle: [[0.0; 3]; 4],
            weights: [[0.0; 3]; 4],
            place: f64::NAN,
        }
    }
}

impl Default for Sampler {
    fn default() -> Self {
        Self::new()
    }
}

/// Value and three derivatives with respect to t at the middle of a block.
struct Jet([[f64; 2]; 4]);

impl Sampler {
    /// Samples `first`, `first + 1`, … of the uniform sampling of `curve` by `count` points, as many as `out` has
    /// room for, x and y in turn.
    ///
    /// Sample i lies at i/count of the parameter range of a closed curve, at i/(count − 1) of an open one.
    ///
    /// # Accuracy
    ///
    /// Within 4 roundings of the curve's size of [`HermiteCurve::evaluate`]; samples that fall on a point are that
    /// point to the last bit (`tests/curve/sampling.rs`).
    ///
    /// # Cost
    ///
    /// About a nanosecond a point where a segment holds many of them.
    pub fn points(&mut self, curve: &HermiteCurve, count: usize, first: usize, out: &mut [f64]) {
        self.run(curve, count, first, out, 2, false);
    }

    /// The same with the derivative after each point: x, y, dx/dt, dy/dt.
    pub fn points_and_tangents(&mut self, curve: &HermiteCurve, count: usize, first: usize, out: &mut [f64]) {
        self.run(curve, count, first, out, 4, false);
    }

    /// The same for who wants all samples in ranges of any length: as many as fit without cutting a block in two, which
    /// is half the work, with derivatives or without. Returns how many; not 0 while there are any and room for 512.
    pub fn blocks(
        &mut self,
        curve: &HermiteCurve,
        count: usize,
        first: usize,
        tangents: bool,
        out: &mut [f64],
    ) -> usize {
        self.run(curve, count, first, out, if tangents { 4 } else { 2 }, true)
    }

    /// Walks the segments that the range touches, a block at a time; `stride` numbers are written for every sample.
    /// Returns how many samples were made: where only whole blocks are wanted, those that fit.
    #[inline(never)]
    fn run(
        &mut self,
        curve: &HermiteCurve,
        count: usize,
        first: usize,
        out: &mut [f64],
        stride: usize,
        whole: bool,
    ) -> usize {
        // Twice the number of a sample is a number, too; so many have no places of their own anyway.
        let count = count.min(usize::MAX / 4);
        let places = Places::new(curve, count);
        let end = count.min(first.saturating_add(out.len() / stride));
        if first >= end {
            return 0;
        }
        let (mut i, mut rest) = (first, out);
        let mut s = places.segment_of(curve, i);
        let mut start = places.first_sample(curve, s);
        while i < end {
            let stop = if s + 1 == curve.segment_count() { count } else { places.first_sample(curve, s + 1) };
            // A short one between long ones, or one whose knots are the same number.
            if start == stop {
                s += 1;
                continue;
            }
            let segment = curve.nth_segment(s);
            self.suit(&segment, places.step);
            let samples = stop - start;
            let few = samples < FEWEST || self.square == 0.0 && samples < FEWEST_OF_CUBIC;
            if few || self.pairs == 0 {
                let number = (stop - i).min(end - i);
                let (now, later) = rest.split_at_mut(number * stride);
                self.few(curve, &segment, &places, (s, i), now, stride);
                (i, rest) = (i + number, later);
            }
            let block = 2 * self.pairs;
            while i < stop.min(end) {
                let skipped = if i == start { 0 } else { (i - start) % block };
                let begin = i - skipped;
                let size = block.min(stop - begin) & !1;
                // The odd one at the end of a segment.
                if skipped >= size {
                    let (now, later) = rest.split_at_mut(stride);
                    self.few(curve, &segment, &places, (s, i), now, stride);
                    (i, rest) = (i + 1, later);
                    continue;
                }
                let number = (size - skipped).min(end - i);
                if whole && number < size - skipped && i > first {
                    return i - first;
                }
                let place = places.place(curve, s, 2 * begin + size - 1);
                if self.place != place {
                    self.weigh(&segment, place, places.unit(curve, s));
                }
                let jet = self.jet(&segment, &self.weights);
                let (now, later) = rest.split_at_mut(number * stride);
                if number == size {
                    self.fill(&jet, now, stride);
                } else {
                    self.fill_part(&jet, size, skipped, now, stride);
                }
                if i == start && places.is_at_knot(curve, s, i) {
                    put(&mut now[..stride], segment.start, segment.leaving);
                }
                let last = i + number == count && !curve.is_closed();
                if last {
                    put(&mut now[(number - 1) * stride..], segment.end, segment.arriving);
                }
                (i, rest) = (i + number, later);
            }
            (s, start) = (s + 1, stop);
        }
        end - first
    }

    /// Samples `i` and those after it on segment `s`, one by one.
    #[inline(never)]
    fn few(
        &self,
        curve: &HermiteCurve,
        segment: &Segment,
        places: &Places,
        (s, i): (usize, usize),
        out: &mut [f64],
        stride: usize,
    ) {
        let (unit, run) = (places.unit(curve, s), places.run(curve, s));
        if self.square == 0.0 {
            let jet = self.jet(segment, &self.middle);
            let middle = [1.0 / unit, segment.length];
            jet.taylor(middle, run, i, out, stride);
        } else {
            for (k, sample) in out.chunks_exact_mut(stride).enumerate() {
                write(sample, segment, place(run, i + k) / unit);
            }
        }
        if place(run, i) == 0.0 {
            put(&mut out[..stride], segment.start, segment.leaving);
        }
        if i + out.len() / stride == places.count && places.count > 1 && !curve.is_closed() {
            let last = out.len() - stride;
            put(&mut out[last..], segment.end, segment.arriving);
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
        self.weigh_at(segment, 0.5);
    }

    /// Weights at x, as derivatives with respect to t.
    #[inline(never)]
    fn weigh_at(&mut self, segment: &Segment, x: f64) {
        let mut scale = 1.0;
        for (order, row) in self.middle.iter_mut().enumerate() {
            let weights = segment.basis.weights(x, order);
            let ends = scale * segment.length;
            *row = [weights.chord * scale, weights.leaving * ends, weights.arriving * ends];
            scale /= segment.length;
        }
    }

    /// Weights at x = place/unit, by way of the segment's middle, for all segments of one kind.
    #[inline(never)]
    fn weigh(&mut self, segment: &Segment, place: f64, unit: f64) {
        let x = place / unit;
        self.place = place;
        // The middle of a stiff segment knows nothing of its ends.
        if self.kind.space == Space::Hyperbolic && self.kind.w > PI {
            self.weigh_at(segment, x);
            self.weights = self.middle;
            return;
        }
        // (D 2.3), weight by weight.
        let by = Shift::new((x - 0.5) * segment.length, self.square);
        for k in 0..3 {
            let [value, first, second, third] = self.middle.map(|row| row[k]);
            self.weights[0][k] = (value + second * by.second) + (first * by.t + third * by.third);
            self.weights[1][k] = first + second * by.first + third * by.second;
            self.weights[2][k] = second * by.zeroth + third * by.first;
            self.weights[3][k] = third * by.zeroth - second * (self.square * by.first);
        }
    }

    /// Makes sure that the tables hold at least `places` places.
    #[inline(never)]
    fn build(&mut self, places: usize) {
        for k in self.built..places.min(PAIRS) {
            let shift = Shift::new(self.kind.step * (k as f64 + 0.5), self.square);
            self.tables[0][k] = shift.t;
            self.tables[1][k] = shift.first;
            self.tables[2][k] = shift.second;
            self.tables[3][k] = shift.third;
        }
        self.built = places;
    }

    /// Value and derivatives at the middle of a block. Loops over numbers: vectors that are handed around wait for
    /// memory.
    #[inline(always)]
    fn jet(&self, segment: &Segment, weights: &Rows) -> Jet {
        let mut jet = [[0.0; 2]; 4];
        for d in 0..2 {
            let start = segment.start[d];
            let (chord, leaving, arriving) =
                (segment.end[d] - start, segment.leaving[d], segment.arriving[d]);
            for (row, weights) in jet.iter_mut().zip(weights) {
                row[d] = chord * weights[0] + (leaving * weights[1] + arriving * weights[2]);
            }
            jet[0][d] += start;
        }
        Jet(jet)
    }

    /// One block of an even number of samples, pairs of them from its middle outwards.
    fn fill(&mut self, jet: &Jet, samples: &mut [f64], stride: usize) {
        let pairs = samples.len() / (2 * stride);
        if self.built < pairs {
            self.build(pairs);
        }
        let (left, right) = samples.split_at_mut(pairs * stride);
        if stride == 2 {
            jet.fill::<2>(&self.tables, left, right);
        } else {
            jet.fill::<4>(&self.tables, left, right);
        }
    }

    /// Samples of a block of `size` from `skipped` on, where a range of samples begins or ends within a block.
    #[cold]
    #[inline(never)]
    fn fill_part(&mut self, jet: &Jet, size: usize, skipped: usize, samples: &mut [f64], stride: usize) {
        let mut block = [0.0; 8 * PAIRS];
        self.fill(jet, &mut block[..size * stride], stride);
        let skipped = skipped * stride;
        samples.copy_from_slice(&block[skipped..skipped + samples.len()]);
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
    #[inline(never)]
    fn new(t: f64, square: f64) -> Self {
        let c = stumpff(square * t * t);
        Self { t, zeroth: c.c0, first: t * c.c1, second: t * t * c.c2, third: t * t * t * c.c3 }
    }
}

impl Jet {
    /// The samples at middle ± τ for every place of the tables, from the middle outwards.
    ///
    /// Compilers make vector code of this loop, two places at a time; it is on its own so that they can see that
    /// nothing overlaps.
    #[inline(never)]
    fn fill<const N: usize>(&self, tables: &[[f64; PAIRS]; 4], left: &mut [f64], right: &mut [f64]) {
        let [value, slope, bend, twist] = self.0;
        let [tau, first, second, third] = tables;
        let tables = tau.iter().zip(first).zip(second).zip(third);
        let (left, right) = (left.as_chunks_mut::<N>().0, right.as_chunks_mut::<N>().0);
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

impl Jet {
    /// Samples from `first` on by Taylor's formula, which ends here for a cubic; this is the jet in the middle of a
    /// segment. A loop without a call, over which engines would keep nothing in registers.
    #[inline(never)]
    fn taylor(&self, [share, length]: [f64; 2], run: Run, first: usize, out: &mut [f64], stride: usize) {
        let [value, slope, bend, twist] = self.0;
        for (k, sample) in out.chunks_exact_mut(stride).enumerate() {
            let t = (place(run, first + k) * share - 0.5) * length;
            for d in 0..2 {
                sample[d] = value[d] + (slope[d] + (bend[d] * 0.5 + twist[d] * (t * (1.0 / 6.0))) * t) * t;
            }
            if sample.len() == 4 {
                for d in 0..2 {
                    sample[d + 2] = slope[d] + (bend[d] + twist[d] * (0.5 * t)) * t;
                }
            }
        }
    }
}

/// One sample on its own.
#[inline(never)]
fn write(sample: &mut [f64], segment: &Segment, x: f64) {
    let velocity = if sample.len() == 4 { segment.velocity(x) } else { Vector::zeros() };
    put(sample, segment.position(x), velocity);
}

/// Writes a point, and its derivative if there is room for it.
fn put(sample: &mut [f64], point: Point, derivative: Vector) {
    sample[..2].copy_from_slice(point.as_slice());
    if let Some(second) = sample.get_mut(2..4) {
        second.copy_from_slice(derivative.as_slice());
    }
}
