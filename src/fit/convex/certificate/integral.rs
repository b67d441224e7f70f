//! The dual curve by integrating its highest derivative, which is a sum of pulses at the samples.

use crate::error::Result;
use crate::fit::convex::problem::Problem;
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::twofold::Twofold;

/// A number of 106 bits for each coordinate.
type Pair = [Twofold; 2];

/// D^{a+1}η = (−1)^{a+1} v/λ at the samples.
pub(crate) struct Integral<'a> {
    pub(crate) problem: &'a Problem,
    pub(crate) degree: usize,
    pub(crate) lambda: f64,
    pub(crate) v: &'a [Vector],
}

/// How far an integration is.
#[derive(Clone, Debug)]
struct Walk {
    state: [Pair; 6],
    here: f64,
    /// Samples and places passed.
    samples: usize,
    places: usize,
}

/// The dual curve at some places, found some samples at a time; closed ones are gone round once before, for their
/// state.
#[derive(Clone, Debug)]
pub(crate) struct Sweep {
    walk: Walk,
    around: bool,
    /// At the places passed.
    pub(crate) values: Vec<Vector>,
}

impl Sweep {
    pub(crate) fn new(problem: &Problem, places: usize) -> Result<Self> {
        let walk = Walk::from(problem, [[Twofold::ZERO; 2]; 6]);
        Ok(Self { walk, around: problem.closed, values: limits::with_room(places)? })
    }

    /// So many samples more; answers whether the end is reached.
    #[inline(never)]
    pub(crate) fn round(&mut self, integral: &Integral<'_>, places: &[f64], samples: usize) -> bool {
        if !self.around {
            return integral.advance(&mut self.walk, places, &mut self.values, samples);
        }
        if integral.advance(&mut self.walk, &[], &mut self.values, samples) {
            self.walk = Walk::from(integral.problem, integral.periodic(&self.walk.state));
            self.around = false;
        }
        false
    }
}

impl Walk {
    fn from(problem: &Problem, state: [Pair; 6]) -> Self {
        Self { state, here: problem.start, samples: 0, places: 0 }
    }
}

impl Integral<'_> {
    /// Past so many samples more, and at last to the end of the domain; leaves the values at the places and answers
    /// whether the end is reached.
    #[inline(never)]
    fn advance(&self, walk: &mut Walk, places: &[f64], values: &mut Vec<Vector>, samples: usize) -> bool {
        let parameters = &self.problem.parameters;
        let mut inverse = if self.degree.is_multiple_of(2) { -1.0 } else { 1.0 } / self.lambda;
        for i in 2..=self.degree {
            inverse /= i as f64;
        }
        let until = walk.samples.saturating_add(samples).min(parameters.len());
        let next = walk.samples..until;
        for (&t, v) in parameters[next.clone()].iter().zip(&self.v[next]) {
            self.pass(walk, places, values, t);
            for (term, force) in walk.state[self.degree].iter_mut().zip([v.x, v.y]) {
                *term = term.plus(Twofold::product(force, inverse));
            }
        }
        walk.samples = until;
        let over = until == parameters.len();
        if over {
            self.pass(walk, places, values, self.problem.end);
        }
        over
    }

    /// To `t`, by the places on the way.
    #[inline(never)]
    fn pass(&self, walk: &mut Walk, places: &[f64], values: &mut Vec<Vector>, t: f64) {
        while let Some(&place) = places.get(walk.places).filter(|place| **place <= t) {
            self.shift(&mut walk.state, walk.here, place);
            walk.here = place;
            values.push(Vector::new(walk.state[0][0].value(), walk.state[0][1].value()));
            walk.places += 1;
        }
        self.shift(&mut walk.state, walk.here, t);
        walk.here = t;
    }

    /// Taylor coefficients at `to` of those at `from`.
    #[allow(clippy::needless_range_loop, reason = "matrices are written with their indices")]
    fn shift(&self, state: &mut [Pair; 6], from: f64, to: f64) {
        let step = Twofold::sum(to, -from);
        if step.high == 0.0 {
            return;
        }
        for i in 0..self.degree {
            for j in (i..self.degree).rev() {
                for axis in 0..2 {
                    state[j][axis] = state[j][axis].plus(state[j + 1][axis].times(step));
                }
            }
        }
    }

    /// The state at the start of a periodic η whose run from zero ends in `end`; its constant is zero.
    #[allow(clippy::needless_range_loop, reason = "matrices are written with their indices")]
    fn periodic(&self, end: &[Pair; 6]) -> [Pair; 6] {
        let period = Twofold::sum(self.problem.end, -self.problem.start);
        let mut state = [[Twofold::ZERO; 2]; 6];
        for j in (1..=self.degree).rev() {
            for axis in 0..2 {
                // Coefficient j − 1 after a period, but for its own term: Σ C(i, j−1) Tⁱ⁻ʲ⁺¹ xᵢ + end = 0.
                let (mut sum, mut binomial, mut power) = (end[j - 1][axis], j as f64, period);
                let own = power.times(Twofold::new(binomial));
                for i in j + 1..=self.degree {
                    binomial = binomial * i as f64 / (i - j + 1) as f64;
                    power = power.times(period);
                    sum = sum.plus(state[i][axis].times(power).times(Twofold::new(binomial)));
                }
                state[j][axis] = sum.negative().over(own);
            }
        }
        state
    }
}
