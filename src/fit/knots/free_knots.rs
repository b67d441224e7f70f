//! Least squares on splines whose knots may go, come together or slide: everything that changes the knots is judged
//! by what it does to the sum of squares, exactly or to first order, from one pass over the data.

mod moments;
mod sliding;

pub(super) use self::moments::product;
use self::moments::{Moments, gather};
pub(super) use self::sliding::in_order;
use super::breaks::{Breaks, HIGHEST};
use super::envelope::Envelope;
use super::space::{Polynomial, STIFF, Space, derivative};
use crate::error::Result;
use crate::limits;
use crate::numerics::Point;
use crate::numerics::lists::dot;
use crate::numerics::pair::Pair;

/// Points with the parameters that they belong to, and their weights (empty: all one).
#[derive(Clone, Debug, Default)]
pub struct Located {
    /// The points.
    pub points: Vec<Point>,
    /// One parameter per point; neighbours in the list should be neighbours on the curve.
    pub parameters: Vec<f64>,
    /// One weight per point, or none at all.
    pub weights: Vec<f64>,
}

impl Located {
    /// The same again, or an error where there is no memory for it.
    pub(in crate::fit) fn copied(&self) -> Result<Self> {
        let mut copy = Self {
            points: limits::with_room(self.points.len())?,
            parameters: limits::with_room(self.parameters.len())?,
            weights: limits::with_room(self.weights.len())?,
        };
        copy.points.extend_from_slice(&self.points);
        copy.parameters.extend_from_slice(&self.parameters);
        copy.weights.extend_from_slice(&self.weights);
        Ok(copy)
    }

    /// Weight of point m.
    pub(super) fn weight(&self, m: usize) -> f64 {
        self.weights.get(m).copied().unwrap_or(1.0)
    }
}

/// A spline fitted to points by least squares, ready to be changed.
#[derive(Clone, Debug)]
pub struct FreeKnots {
    pub(super) space: Space,
    pub(super) moments: Vec<Moments>,
    factor: Envelope,
    /// Coefficients of both coordinates.
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
    /// The weighted sum of squares that is left.
    pub(super) squares: f64,
}

/// What it costs, in the sum of squares, to make a knot smoother by one and to take it away.
#[derive(Clone, Copy, Debug)]
pub(super) struct Removal {
    pub(super) one: f64,
    pub(super) whole: f64,
}

impl FreeKnots {
    /// Least squares with the knots given. O(M·degree + K·degree²).
    pub fn new(breaks: Breaks, data: &Located) -> Self {
        let space = Space::new(breaks);
        let moments = gather(&space, data);
        let degree = space.breaks.degree;
        let mut factor = space.equations();
        let (mut right_x, mut right_y) = (vec![0.0; space.count], vec![0.0; space.count]);
        for (s, sums) in moments.iter().enumerate() {
            if sums.count == 0 && sums.stiff <= 0.0 {
                continue;
            }
            let basis = &space.basis[s];
            for p in 0..=degree {
                let row = space.index(s, p);
                right_x[row] += product(&basis[p], &sums.x);
                right_y[row] += product(&basis[p], &sums.y);
                let weighted = sums.weighted(degree, &basis[p]);
                for (q, basis) in basis[..=p].iter().enumerate() {
                    let (other, value) = (space.index(s, q), product(&weighted, basis));
                    // Two functions of a piece may be one and the same where a closed curve has few knots.
                    let twice = if p != q && row == other { 2.0 } else { 1.0 };
                    factor.add(row.max(other), row.min(other), twice * value);
                }
            }
        }
        let stiff = if space.breaks.straight.is_empty() { 1.0 } else { STIFF };
        anchor(&mut factor, space.breaks.closed, 1e-11 / stiff);
        factor.factor();
        let mut both: Vec<Pair> = right_x.iter().zip(&right_y).map(|(x, y)| Pair::new(*x, *y)).collect();
        factor.solve_both(&mut both);
        let x: Vec<f64> = both.iter().map(|both| both.first()).collect();
        let y: Vec<f64> = both.iter().map(|both| both.second()).collect();
        let whole: f64 = moments.iter().map(|sums| sums.square).sum();
        let squares = (whole - dot(&x, &right_x) - dot(&y, &right_y)).max(0.0);
        Self { space, moments, factor, x, y, squares }
    }

    /// Where the spline breaks.
    pub fn breaks(&self) -> &Breaks {
        &self.space.breaks
    }

    /// The weighted sum of squares that is left.
    pub fn squares(&self) -> f64 {
        self.squares
    }

    /// How many points there are.
    pub(super) fn points(&self) -> usize {
        self.moments.iter().map(|sums| sums.count).sum()
    }

    /// The curve's polynomials on piece s, one per coordinate.
    pub(super) fn piece(&self, s: usize) -> (Polynomial, Polynomial) {
        (self.space.piece(s, &self.x), self.space.piece(s, &self.y))
    }

    /// The sum of squares that is left on piece s.
    pub(super) fn left(&self, s: usize) -> f64 {
        let (degree, sums) = (self.space.breaks.degree, &self.moments[s]);
        let (px, py) = self.piece(s);
        let twice = product(&px, &sums.x) + product(&py, &sums.y);
        let whole = |p: &Polynomial| product(&sums.weighted(degree, p), p);
        sums.square - 2.0 * twice + whole(&px) + whole(&py)
    }

    /// The point at t, or a derivative of it. O(pieces).
    pub fn evaluate(&self, t: f64, order: usize) -> Point {
        let (s, t) = self.space.find(t, 0);
        let (px, py) = self.piece(s);
        let span = self.space.spans[s];
        let u = (t - span.middle) / span.half;
        let degree = self.space.breaks.degree;
        Point::new(derivative(&px, degree, u, span.half, order), derivative(&py, degree, u, span.half, order))
    }

    /// For every knot exactly what the sum of squares would grow by without it: with w the jumps, L their rows and G
    /// the equations, wᵀ(LG⁻¹Lᵀ)⁻¹w (D 13.1). O(K²·degree).
    #[inline(never)]
    pub(super) fn removals(&self) -> Vec<Removal> {
        let mut rows = vec![vec![0.0; self.space.count]; HIGHEST];
        (0..self.space.breaks.len()).map(|k| self.removal(k, &mut rows)).collect()
    }

    fn removal(&self, k: usize, rows: &mut [Vec<f64>]) -> Removal {
        let degree = self.space.breaks.degree;
        let m = self.space.breaks.multiplicity[k];
        let (before, after) = self.space.sides(k);
        let (hb, ha) = (self.space.spans[before].half, self.space.spans[after].half);
        let scale = hb.min(ha);
        let (mut lowest, mut highest) = (self.space.count, 0);
        for (r, row) in rows.iter_mut().enumerate().take(m) {
            let order = degree + 1 - m + r;
            // In units of the shorter piece: the rows are then of one size.
            let unit = (0..order).fold(1.0, |unit, _| unit * scale);
            for i in 0..=degree {
                let (a, b) = (self.space.index(after, i), self.space.index(before, i));
                row[a] += unit * derivative(&self.space.basis[after][i], degree, -1.0, ha, order);
                row[b] -= unit * derivative(&self.space.basis[before][i], degree, 1.0, hb, order);
                lowest = lowest.min(a).min(b);
                highest = highest.max(a).max(b);
            }
        }
        self.forced(&mut rows[..m], lowest, highest)
    }

    /// For every piece exactly what the sum of squares would grow by if it were straight: (D 13.1) with the higher
    /// coefficients of the piece for jumps. O(K·degree³).
    pub(super) fn straightenings(&self) -> Vec<f64> {
        let degree = self.space.breaks.degree;
        let mut rows = vec![vec![0.0; self.space.count]; degree - 1];
        let one = |s: usize| {
            let (mut lowest, mut highest) = (self.space.count, 0);
            for i in 0..=degree {
                let at = self.space.index(s, i);
                for (row, term) in rows.iter_mut().zip(&self.space.basis[s][i][2..]) {
                    row[at] += term;
                }
                (lowest, highest) = (lowest.min(at), highest.max(at));
            }
            self.forced(&mut rows, lowest, highest).whole
        };
        (0..self.space.spans.len()).map(one).collect()
    }

    /// What it costs to have the products of coefficients with the first of some rows vanish, and with all of them. The
    /// rows have entries from `lowest` to `highest`, and are left empty.
    fn forced(&self, rows: &mut [Vec<f64>], lowest: usize, highest: usize) -> Removal {
        let m = rows.len();
        let mut jumps = [[0.0; 2]; HIGHEST];
        let (border, mut end) = (self.factor.border(), 0);
        for (row, jump) in rows.iter_mut().zip(&mut jumps) {
            let entries = &row[lowest..=highest];
            *jump = [dot(entries, &self.x[lowest..=highest]), dot(entries, &self.y[lowest..=highest])];
            end = end.max(self.factor.forward_near(row, lowest, highest));
        }
        let lowest = lowest.min(end);
        let mut gram = Envelope::new(vec![0; m]);
        for p in 0..m {
            for q in 0..=p {
                let near = dot(&rows[p][lowest..end], &rows[q][lowest..end]);
                gram.add(p, q, near + dot(&rows[p][border..], &rows[q][border..]));
            }
        }
        for row in rows {
            row[lowest..end].fill(0.0);
            row[border..].fill(0.0);
        }
        let one = (jumps[0][0] * jumps[0][0] + jumps[0][1] * jumps[0][1]) / gram.diagonal(0).max(1e-300);
        gram.factor();
        let mut whole = 0.0;
        for coordinate in [0, 1] {
            let mut w = jumps.map(|jump| jump[coordinate]);
            gram.forward(&mut w[..m], 0);
            whole += dot(&w[..m], &w[..m]);
        }
        Removal { one, whole }
    }
}

/// A faint pull between neighbouring coefficients: where there are no points, there is still one solution.
fn anchor(equations: &mut Envelope, closed: bool, share: f64) {
    let n = equations.size();
    let pull = (0..n).map(|i| equations.diagonal(i)).sum::<f64>() * share / n as f64 + 1e-280;
    for i in 0..n {
        let next = if i + 1 < n { i + 1 } else { 0 };
        if next == i || (next == 0 && !closed) {
            continue;
        }
        equations.add(i, i, pull);
        equations.add(next, next, pull);
        if i + 1 < n || n > 2 {
            equations.add(i.max(next), i.min(next), -pull);
        }
    }
}
