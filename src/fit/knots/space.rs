//! The space of the splines that break where some knots are: its basis, as polynomials piece by piece.

use super::breaks::{Breaks, HIGHEST};
use super::envelope::Envelope;

/// How much more bending costs on pieces that are to be straight than what points say.
pub(super) const STIFF: f64 = 1e5;
/// Coefficients of one polynomial, in ascending powers.
pub(in crate::fit) type Polynomial = [f64; HIGHEST + 1];

/// One polynomial piece: parameters middle ± half, u = (t − middle)/half in [−1, 1].
#[derive(Clone, Copy, Debug)]
pub(in crate::fit) struct Span {
    pub(in crate::fit) middle: f64,
    pub(in crate::fit) half: f64,
    /// Number of the piece's first coefficient.
    pub(super) first: usize,
}

/// The spline space over some breaks: its pieces and the polynomials of its basis there.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Space {
    pub(in crate::fit) breaks: Breaks,
    pub(in crate::fit) spans: Vec<Span>,
    /// For every piece the degree + 1 basis functions that live there.
    pub(in crate::fit) basis: Vec<[Polynomial; HIGHEST + 1]>,
    pub(in crate::fit) count: usize,
    flat: Vec<f64>,
}

impl Space {
    /// The space; breaks must be ascending with positive gaps, and closed ones not empty.
    pub(in crate::fit) fn new(breaks: Breaks) -> Self {
        let degree = breaks.degree;
        let clamp = if breaks.closed { 0 } else { degree + 1 };
        let mut flat = Vec::with_capacity(breaks.coefficients() + clamp);
        flat.resize(clamp, 0.0);
        // The last copy of the break that a span starts with.
        let mut last = Vec::with_capacity(breaks.pieces());
        if !breaks.closed {
            last.push(degree);
        }
        for (&t, &m) in breaks.at.iter().zip(&breaks.multiplicity) {
            flat.extend(core::iter::repeat_n(t, m));
            last.push(flat.len() - 1);
        }
        flat.extend(core::iter::repeat_n(breaks.end, clamp));
        let count = breaks.coefficients();
        let (spans, basis) = (Vec::with_capacity(last.len()), Vec::with_capacity(last.len()));
        let mut space = Self { breaks, spans, basis, count: count.max(1), flat };
        for mu in last {
            let mut local = [0.0; 2 * HIGHEST];
            for (i, knot) in local.iter_mut().take(2 * degree).enumerate() {
                *knot = space.knot((mu + i) as isize + 1 - degree as isize);
            }
            let (start, end) = (local[degree - 1], local[degree]);
            let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
            let first = space.wrap(mu as isize - degree as isize);
            space.spans.push(Span { middle, half, first });
            space.basis.push(triangle(degree, &local, middle, half));
        }
        space
    }

    /// Knot i of the sequence in which every knot stands as often as it counts, going on for ever if closed.
    fn knot(&self, i: isize) -> f64 {
        let n = self.flat.len() as isize;
        if self.breaks.closed {
            // Hardly ever more than once round, and divisions take long.
            let (mut i, mut rounds) = (i, 0.0);
            while i < 0 {
                (i, rounds) = (i + n, rounds - 1.0);
            }
            while i >= n {
                (i, rounds) = (i - n, rounds + 1.0);
            }
            self.flat[i as usize] + self.breaks.end * rounds
        } else {
            self.flat[i.clamp(0, n - 1) as usize]
        }
    }

    fn wrap(&self, i: isize) -> usize {
        i.rem_euclid(self.count as isize) as usize
    }

    /// Number of the coefficient of basis function i of a piece.
    #[inline(always)]
    pub(in crate::fit) fn index(&self, span: usize, i: usize) -> usize {
        let index = self.spans[span].first + i;
        if index < self.count { index } else { index % self.count }
    }

    /// The knots inside the support of basis function i of a piece, as the piece counts parameters.
    pub(super) fn inner_knots(&self, span: usize, i: usize) -> [f64; HIGHEST] {
        let degree = self.breaks.degree;
        let lead = if self.breaks.closed { 0 } else { degree + 1 };
        let knots = if self.breaks.closed { span + 1 } else { span };
        let mu = (lead + self.breaks.multiplicity[..knots].iter().sum::<usize>()) as isize - 1;
        let mut inner = [0.0; HIGHEST];
        for (k, knot) in inner.iter_mut().enumerate().take(degree) {
            *knot = self.knot(mu - degree as isize + (i + k) as isize + 1);
        }
        inner
    }

    /// The piece that t lies in, tried from `guess`, and t as that piece counts it.
    pub(in crate::fit) fn find(&self, t: f64, guess: usize) -> (usize, f64) {
        let (mut t, mut i) = (t, guess.min(self.spans.len() - 1));
        if self.breaks.closed && t < self.breaks.at[0] {
            t += self.breaks.end;
        }
        while i + 1 < self.spans.len() && t >= self.spans[i].middle + self.spans[i].half {
            i += 1;
        }
        while i > 0 && t < self.spans[i].middle - self.spans[i].half {
            i -= 1;
        }
        (i, t)
    }

    /// The pieces that parameters lie in, one after the other, and each parameter as its piece counts it; quick where
    /// they follow one another.
    #[inline(always)]
    pub(super) fn places(&self, parameters: &[f64]) -> impl Iterator<Item = (usize, f64)> {
        let mut at = 0;
        parameters.iter().map(move |&t| {
            let place = self.find(t, at);
            at = place.0;
            place
        })
    }

    /// For every coefficient the first one that it meets on some piece.
    pub(super) fn reaches(&self) -> Vec<usize> {
        let mut first: Vec<usize> = (0..self.count).collect();
        for s in 0..self.spans.len() {
            let lowest = (0..=self.breaks.degree).map(|i| self.index(s, i)).min().unwrap_or(0);
            for i in 0..=self.breaks.degree {
                let row = self.index(s, i);
                first[row] = first[row].min(lowest);
            }
        }
        first
    }

    /// Adds to the equations of both coordinates a price for what bends pieces that are to be straight, `stiff` times
    /// what the coefficients of their polynomials are, and to their right side what the price asks of these
    /// coefficients.
    pub(super) fn stiffen(
        &self,
        equations: &mut Envelope,
        right: &mut [f64],
        [x, y]: [&[f64]; 2],
        stiff: f64,
    ) {
        let degree = self.breaks.degree;
        for s in (0..self.spans.len()).filter(|&s| self.breaks.is_straight(s)) {
            let basis = &self.basis[s];
            for p in 0..=degree {
                for q in 0..=degree {
                    let (row, other) = (self.index(s, p), self.index(s, q));
                    let bend: f64 = stiff * (2..=degree).map(|k| basis[p][k] * basis[q][k]).sum::<f64>();
                    for (lane, c) in [x, y].into_iter().enumerate() {
                        equations.add(2 * row + lane, 2 * other + lane, bend);
                        right[2 * row + lane] -= bend * c[other];
                    }
                }
            }
        }
    }

    /// Zeros in the shape of the equations.
    pub(super) fn equations(&self) -> Envelope {
        Envelope::new(self.reaches())
    }

    /// The curve's polynomial on a piece, for one coordinate.
    pub(in crate::fit) fn piece(&self, span: usize, coefficients: &[f64]) -> Polynomial {
        let mut sum = [0.0; HIGHEST + 1];
        for i in 0..=self.breaks.degree {
            let c = coefficients[self.index(span, i)];
            for (sum, b) in sum.iter_mut().zip(&self.basis[span][i]) {
                *sum += c * b;
            }
        }
        sum
    }

    /// The piece that ends at knot k and the one that starts there.
    pub(in crate::fit) fn sides(&self, k: usize) -> (usize, usize) {
        if self.breaks.closed { ((k + self.spans.len() - 1) % self.spans.len(), k) } else { (k, k + 1) }
    }

    /// A function that belongs to the space only after knot k counts `more` times more: its pieces, as
    /// (piece, polynomial), and the jump that it brings, in the lowest derivative that did not jump before.
    pub(in crate::fit) fn bump(&self, k: usize, more: usize) -> (Vec<(usize, Polynomial)>, f64) {
        let degree = self.breaks.degree;
        let m = self.breaks.multiplicity[k] + more;
        let lead = if self.breaks.closed { 0 } else { degree + 1 };
        let copy = (lead + self.breaks.multiplicity[..k].iter().sum::<usize>()) as isize;
        let others = degree + 2 - m;
        let left = others / 2;
        let mut window = [0.0; HIGHEST + 2];
        for (i, knot) in window.iter_mut().take(degree + 2).enumerate() {
            *knot = if i < left {
                self.knot(copy + i as isize - left as isize)
            } else if i < left + m {
                self.breaks.at[k]
            } else {
                let after = (i - left - m) as isize;
                self.knot(copy + self.breaks.multiplicity[k] as isize + after)
            };
        }
        let mut pieces = Vec::new();
        let (before, after) = self.sides(k);
        let order = degree + 1 - m;
        let mut jump = 0.0;
        let spans = self.spans.len();
        for q in 0..=degree {
            let (start, end) = (window[q], window[q + 1]);
            if end <= start {
                continue;
            }
            // Pieces follow one another from the knot on, to both sides.
            let (span, far) = if q < left {
                let back = distinct(&window[q + 1..=left]);
                ((before + spans * (degree + 2) - back) % spans, false)
            } else {
                let on = distinct(&window[left + m - 1..=q]);
                ((after + on) % spans, true)
            };
            let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
            let polynomial = window_piece(degree, &window, q, middle, half);
            if end == self.breaks.at[k] && !far {
                jump -= derivative(&polynomial, degree, 1.0, half, order);
            }
            if start == self.breaks.at[k] && far {
                jump += derivative(&polynomial, degree, -1.0, half, order);
            }
            pieces.push((span, polynomial));
        }
        (pieces, jump)
    }
}

/// How many steps up there are in an ascending list.
fn distinct(list: &[f64]) -> usize {
    list.windows(2).filter(|pair| pair[1] > pair[0]).count()
}

/// Derivative of some order of a polynomial in u, by t.
pub(in crate::fit) fn derivative(p: &Polynomial, degree: usize, u: f64, half: f64, order: usize) -> f64 {
    let mut sum = 0.0;
    for k in (order..=degree).rev() {
        let factor: f64 = ((k - order + 1)..=k).map(|i| i as f64).product();
        sum = sum * u + p[k] * factor;
    }
    for _ in 0..order {
        sum /= half;
    }
    sum
}

/// a ← a + (slope·u + offset)·b, for b with so many terms.
fn add_linear(a: &mut Polynomial, b: &Polynomial, terms: usize, offset: f64, slope: f64) {
    for (k, b) in b.iter().enumerate().take(terms.min(HIGHEST)) {
        a[k] += offset * b;
        a[k + 1] += slope * b;
    }
}

/// Cox and de Boor's recursion, in polynomials: all basis functions of a piece between the two middle ones of the
/// 2·degree knots around.
fn triangle(degree: usize, local: &[f64], middle: f64, half: f64) -> [Polynomial; HIGHEST + 1] {
    let mut basis = [[0.0; HIGHEST + 1]; HIGHEST + 1];
    basis[0][0] = 1.0;
    for p in 1..=degree {
        let mut next = [[0.0; HIGHEST + 1]; HIGHEST + 1];
        for r in 0..p {
            // Function r of degree p − 1 lives on knots from degree − p + r to degree + r of the local list.
            let (lo, hi) = (local[degree - p + r], local[degree + r]);
            let scale = 1.0 / (hi - lo);
            add_linear(&mut next[r], &basis[r], p, (hi - middle) * scale, -half * scale);
            add_linear(&mut next[r + 1], &basis[r], p, (middle - lo) * scale, half * scale);
        }
        basis = next;
    }
    basis
}

/// The B-spline over the degree + 2 knots of a window, on the piece between knots q and q + 1.
fn window_piece(degree: usize, window: &[f64], q: usize, middle: f64, half: f64) -> Polynomial {
    let mut level = [[0.0; HIGHEST + 1]; HIGHEST + 1];
    level[q][0] = 1.0;
    for p in 1..=degree {
        // Functions that start behind the piece or end before it are 0 there.
        for i in q.saturating_sub(p)..=q.min(degree - p) {
            let mut sum = [0.0; HIGHEST + 1];
            let (lo, hi) = (window[i], window[i + p]);
            if hi > lo {
                let scale = 1.0 / (hi - lo);
                add_linear(&mut sum, &level[i], p, (middle - lo) * scale, half * scale);
            }
            let (lo, hi) = (window[i + 1], window[i + p + 1]);
            if hi > lo {
                let scale = 1.0 / (hi - lo);
                add_linear(&mut sum, &level[i + 1], p, (hi - middle) * scale, -half * scale);
            }
            level[i] = sum;
        }
    }
    level[0]
}
