//! The dual curve by integrating its highest derivative, which is a sum of pulses at the samples.

use crate::fit::convex::problem::Problem;
use crate::numerics::Vector;
use crate::numerics::twofold::Twofold;

/// A number of 106 bits for each coordinate.
type Pair = [Twofold; 2];

/// D^{a+1}η = (−1)^{a+1} v/λ at the samples.
pub(super) struct Integral<'a> {
    pub(super) problem: &'a Problem,
    pub(super) degree: usize,
    pub(super) lambda: f64,
    pub(super) v: &'a [Vector],
}

impl Integral<'_> {
    /// From the start to the end of the domain; leaves the values at the places and answers the last state.
    pub(super) fn run(&self, start: &[Pair; 6], places: &[f64], values: &mut Vec<Vector>) -> [Pair; 6] {
        let mut state = *start;
        let mut here = self.problem.start;
        let mut places = places.iter().peekable();
        let mut inverse = if self.degree.is_multiple_of(2) { -1.0 } else { 1.0 } / self.lambda;
        for i in 2..=self.degree {
            inverse /= i as f64;
        }
        let mut emit = |state: &mut [Pair; 6], here: &mut f64, until: f64, inclusive: bool| {
            while let Some(&&place) = places.peek() {
                if place > until || (place >= until && !inclusive) {
                    break;
                }
                self.shift(state, *here, place);
                *here = place;
                values.push(Vector::new(state[0][0].value(), state[0][1].value()));
                places.next();
            }
        };
        for (m, &t) in self.problem.parameters.iter().enumerate() {
            emit(&mut state, &mut here, t, true);
            self.shift(&mut state, here, t);
            here = t;
            for (term, force) in state[self.degree].iter_mut().zip([self.v[m].x, self.v[m].y]) {
                *term = term.plus(Twofold::product(force, inverse));
            }
        }
        emit(&mut state, &mut here, self.problem.end, true);
        self.shift(&mut state, here, self.problem.end);
        state
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
    pub(super) fn periodic(&self, end: &[Pair; 6]) -> [Pair; 6] {
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
