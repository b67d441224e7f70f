//! The dual curve η on all places where knots may be, in one pass over samples and places.
//!
//! η is a spline of the degree a of its component whose a-th derivative jumps by (−1)ᵃ⁺¹ 2 w e / λ at each sample.
//! At the knots in play it is known. Between two of them it is integrated from zero, which cannot run away over so
//! short a way, and corrected by the polynomial that the known values around ask for. (D 12.5)

use super::cone::dot;
use crate::fit::convex::interval::TERMS;
use crate::fit::convex::scaled::{Scaled, ScaledComponent};
use crate::numerics::Vector;
use crate::numerics::enclosing_circle::enclosing_circle;

/// Taylor coefficients of η at a place.
type State = [Vector; TERMS];

const ZERO: State = [Vector::new(0.0, 0.0); TERMS];

/// Binomial coefficients up to the highest degree.
const BINOMIAL: [[f64; TERMS]; TERMS] = {
    let mut rows = [[0.0; TERMS]; TERMS];
    let mut n = 0;
    while n < TERMS {
        rows[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            rows[n][k] = rows[n - 1][k - 1] + if k < n { rows[n - 1][k] } else { 0.0 };
            k += 1;
        }
        n += 1;
    }
    rows
};

/// The Taylor coefficients a step further.
#[inline(always)]
fn shift<const A: usize>(state: &mut State, step: f64) {
    for i in 0..A {
        for j in (i..A).rev() {
            let next = state[j + 1];
            state[j] += next * step;
        }
    }
}

fn shift_by_degree(degree: usize, state: &mut State, step: f64) {
    match degree {
        1 => shift::<1>(state, step),
        2 => shift::<2>(state, step),
        3 => shift::<3>(state, step),
        4 => shift::<4>(state, step),
        _ => shift::<5>(state, step),
    }
}

/// The state a step further, where the integral from zero over that step ends in `own`.
fn advance(degree: usize, state: &mut State, step: f64, own: &State) {
    shift_by_degree(degree, state, step);
    for (term, own) in state.iter_mut().zip(own) {
        *term += own;
    }
}

/// One component's residuals and places.
struct Walk<'a> {
    data: &'a Scaled,
    component: &'a ScaledComponent,
    weighted: &'a [Vector],
    /// What a unit of weighted residual adds to the highest Taylor coefficient.
    factor: f64,
}

impl Walk<'_> {
    /// Adds the samples from..to, seen from `end` on an axis moved by `moved`.
    #[inline(always)]
    fn gather<const A: usize>(&self, state: &mut State, from: usize, to: usize, end: f64) {
        for m in from..to {
            let step = end - self.data.t[m];
            let mut force = self.weighted[m] * self.factor;
            state[A] += force;
            for j in (0..A).rev() {
                force *= step;
                state[j] += force * BINOMIAL[A][j];
            }
        }
    }

    /// From place `from` to place `to` (or the end of the domain, or over it to the first places again), from zero:
    /// leaves the values at the places and answers the state at the end.
    fn run<const A: usize>(&self, from: usize, to: usize, out: &mut [Vector]) -> State {
        let places = self.component.grid.len();
        let mut state = ZERO;
        let mut c = from;
        while c != to {
            out[c] = state[0];
            let (here, last) = (self.component.grid[c], c + 1 == places);
            let next = if last { self.data.length } else { self.component.grid[c + 1] };
            shift::<A>(&mut state, next - here);
            self.gather::<A>(
                &mut state,
                self.component.first_sample[c],
                self.component.first_sample[c + 1],
                next,
            );
            c += 1;
            if last && self.data.closed {
                c = 0;
                self.start::<A>(&mut state);
            }
            if last && !self.data.closed {
                break;
            }
        }
        state
    }

    /// From the start of the domain to the first place.
    fn start<const A: usize>(&self, state: &mut State) {
        let first = self.component.grid[0];
        shift::<A>(state, first);
        self.gather::<A>(state, 0, self.component.first_sample[0], first);
    }

    fn run_by_degree(&self, from: usize, to: usize, out: &mut [Vector]) -> State {
        match self.component.degree {
            1 => self.run::<1>(from, to, out),
            2 => self.run::<2>(from, to, out),
            3 => self.run::<3>(from, to, out),
            4 => self.run::<4>(from, to, out),
            _ => self.run::<5>(from, to, out),
        }
    }

    /// The place that ends the piece after knot k: the next knot, or the end of the domain.
    fn end_of_piece(&self, chosen: &[usize], k: usize) -> usize {
        let last = if self.data.closed { chosen[0] } else { self.component.grid.len() };
        chosen.get(k + 1).copied().unwrap_or(last)
    }

    /// How long the piece after knot k is.
    fn spacing(&self, chosen: &[usize], k: usize) -> f64 {
        let grid = &self.component.grid;
        let from = grid[chosen[k]];
        match chosen.get(k + 1) {
            Some(&next) => grid[next] - from,
            None if self.data.closed => grid[chosen[0]] + self.data.length - from,
            None => self.data.length - from,
        }
    }

    fn start_by_degree(&self, state: &mut State) {
        match self.component.degree {
            1 => self.start::<1>(state),
            2 => self.start::<2>(state),
            3 => self.start::<3>(state),
            4 => self.start::<4>(state),
            _ => self.start::<5>(state),
        }
    }
}

/// η at all places of a component's grid, from the weighted residuals and from its values `known` at the knots in play.
pub(crate) fn dual_curve(
    data: &Scaled,
    component: &ScaledComponent,
    chosen: &[usize],
    weighted: &[Vector],
    known: &[Vector],
    eta: &mut Vec<Vector>,
) {
    let degree = component.degree;
    let places = component.grid.len();
    eta.clear();
    eta.resize(places, Vector::zeros());
    if places == 0 {
        return;
    }
    let walk = Walk { data, component, weighted, factor: factor(component) };
    let knots = chosen.len();
    if data.closed && knots <= degree {
        around(&walk, chosen, known, eta);
        return;
    }
    let mut ends: Vec<State> = Vec::with_capacity(knots + 1);
    for (k, &from) in chosen.iter().enumerate() {
        ends.push(walk.run_by_degree(from, walk.end_of_piece(chosen, k), eta));
    }
    let mut state = if data.closed { ZERO } else { lead_in(&walk, chosen, eta) };
    for k in 0..knots {
        let correction = if !data.closed && k + 1 == knots {
            // η ends with the domain: the state there is zero.
            let mut state = ends[k].map(|v| -v);
            shift_by_degree(degree, &mut state, -walk.spacing(chosen, k));
            state
        } else if knots > degree {
            window(&walk, chosen, k, known, &ends)
        } else {
            state
        };
        if knots <= degree {
            advance(degree, &mut state, walk.spacing(chosen, k), &ends[k]);
        }
        add_polynomial(data, component, chosen[k], walk.end_of_piece(chosen, k), &correction, eta);
    }
}

/// (−1)ᵃ⁺¹ 2 / λ, and the factorial that makes a derivative a Taylor coefficient.
fn factor(component: &ScaledComponent) -> f64 {
    let mut factor = if component.degree.is_multiple_of(2) { -2.0 } else { 2.0 } / component.lambda;
    for i in 2..=component.degree {
        factor /= i as f64;
    }
    factor
}

/// From the start of an open domain, where η is zero, to the first knot: leaves η on the way and answers the state
/// there.
fn lead_in(walk: &Walk<'_>, chosen: &[usize], eta: &mut [Vector]) -> State {
    let grid = &walk.component.grid;
    let to = chosen.first().copied().unwrap_or(grid.len());
    let mut state = ZERO;
    walk.start_by_degree(&mut state);
    if to > 0 {
        let own = walk.run_by_degree(0, to, eta);
        add_polynomial(walk.data, walk.component, 0, to, &state, eta);
        let end = grid.get(to).copied().unwrap_or(walk.data.length);
        advance(walk.component.degree, &mut state, end - grid[0], &own);
    }
    state
}

/// A closed η known at no more knots than its degree: once round from zero, then the polynomial that closes it.
fn around(walk: &Walk<'_>, chosen: &[usize], known: &[Vector], eta: &mut [Vector]) {
    let (data, component) = (walk.data, walk.component);
    let degree = component.degree;
    // To the last place, and from there over the seam to the first one.
    let last = component.grid.len() - 1;
    let mut end = walk.run_by_degree(0, last, eta);
    let mut closing = vec![Vector::zeros(); component.grid.len()];
    let rest = walk.run_by_degree(last, 0, &mut closing);
    eta[last] = end[0];
    advance(degree, &mut end, component.grid[0] + data.length - component.grid[last], &rest);
    let mut state = ZERO;
    for j in (1..=degree).rev() {
        let (mut sum, mut power) = (end[j - 1], data.length);
        for i in j + 1..=degree {
            power *= data.length;
            sum += state[i] * (BINOMIAL[i][j - 1] * power);
        }
        state[j] = sum / (-(j as f64) * data.length);
    }
    add_polynomial(data, component, 0, component.grid.len(), &state, eta);
    // The constant: from the known values, or so that the longest is shortest.
    let mut constant = Vector::zeros();
    if chosen.is_empty() {
        constant -= enclosing_circle(eta).centre;
    } else {
        for (&k, value) in chosen.iter().zip(known) {
            constant += (value - eta[k]) / chosen.len() as f64;
        }
    }
    for value in eta {
        *value += constant;
    }
}

/// Adds a polynomial, given at place `from`, to the values at the places from..to, over the seam if it must.
fn add_polynomial(
    data: &Scaled,
    component: &ScaledComponent,
    from: usize,
    to: usize,
    state: &State,
    eta: &mut [Vector],
) {
    let start = component.grid[from];
    let mut add = |range: core::ops::Range<usize>, moved: f64| {
        for (value, place) in eta[range.clone()].iter_mut().zip(&component.grid[range]) {
            let step = place - start + moved;
            let mut sum = state[component.degree];
            for term in state[..component.degree].iter().rev() {
                sum = sum * step + term;
            }
            *value += sum;
        }
    };
    if to > from {
        add(from..to, 0.0);
    } else {
        add(from..component.grid.len(), 0.0);
        add(0..to, data.length);
    }
}

/// The state at knot k of the polynomial that makes the integrated η take its known values at the degree + 1 knots
/// around.
fn window(walk: &Walk<'_>, chosen: &[usize], k: usize, known: &[Vector], ends: &[State]) -> State {
    let degree = walk.component.degree;
    let knots = chosen.len();
    let back = (degree - 1) / 2;
    let first = if walk.data.closed {
        (k + knots - back) % knots
    } else {
        k.saturating_sub(back).min(knots - 1 - degree)
    };
    let mut places = [0.0; TERMS];
    let mut missing = ZERO;
    let mut state = ZERO;
    let (mut here, mut result, mut centre) = (ZERO, ZERO, 0.0);
    let mut knot = first;
    for i in 0..=degree {
        if knot == k {
            (here, centre) = (state, places[i]);
        }
        missing[i] = known[knot] - state[0];
        if i < degree {
            let step = walk.spacing(chosen, knot);
            places[i + 1] = places[i] + step;
            advance(degree, &mut state, step, &ends[knot]);
            knot = if knot + 1 == knots { 0 } else { knot + 1 };
        }
    }
    // Newton's divided differences, then his form expanded about the knot.
    for order in 1..=degree {
        for i in (order..=degree).rev() {
            missing[i] = (missing[i] - missing[i - 1]) / (places[i] - places[i - order]);
        }
    }
    for i in (0..=degree).rev() {
        let offset = centre - places[i];
        for j in (1..=degree).rev() {
            result[j] = result[j] * offset + result[j - 1];
        }
        result[0] = result[0] * offset + missing[i];
    }
    for (term, own) in result.iter_mut().zip(&here) {
        *term += own;
    }
    result
}

/// Places where the dual curve is locally longest and longer than `threshold`.
pub(crate) fn maxima(eta: &[Vector], closed: bool, threshold: f64) -> Vec<usize> {
    let count = eta.len();
    let size = |v: Vector| dot(v, v);
    let threshold = threshold * threshold;
    let outside = if closed { eta.last().map_or(0.0, |v| size(*v)) } else { 0.0 };
    let (mut before, mut found) = (outside, Vec::new());
    for (k, v) in eta.iter().enumerate() {
        let here = size(*v);
        if here > threshold && here > before {
            let after = match eta.get(k + 1) {
                Some(next) => size(*next),
                None if closed && count > 1 => size(eta[0]),
                None => 0.0,
            };
            if here >= after {
                found.push(k);
            }
        }
        before = here;
    }
    found
}
