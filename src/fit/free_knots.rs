//! Least squares on splines whose knots may go, come together or slide: everything that changes the knots is judged
//! by what it does to the sum of squares, exactly or to first order, from one pass over the data.

use super::breaks::{Breaks, HIGHEST, Polynomial, Space, derivative};
use super::envelope::{Envelope, dot};
use crate::numerics::Point;

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
    /// Weight of point m.
    pub(super) fn weight(&self, m: usize) -> f64 {
        self.weights.get(m).copied().unwrap_or(1.0)
    }
}

/// Sums over the points of one piece: all that least squares needs to know of them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Moments {
    pub(super) count: usize,
    powers: [f64; 2 * HIGHEST + 1],
    x: Polynomial,
    y: Polynomial,
    square: f64,
}

impl Moments {
    /// Σ w·a(u)·uʲ for all j: with the coefficients of another polynomial its scalar product is Σ w·a(u)·b(u).
    fn weighted(&self, degree: usize, a: &Polynomial) -> Polynomial {
        let mut sums = [0.0; HIGHEST + 1];
        for (i, a) in a[..=degree].iter().enumerate() {
            for (sum, power) in sums[..=degree].iter_mut().zip(&self.powers[i..]) {
                *sum += a * power;
            }
        }
        sums
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

/// Behind the last entry of a right side a solution falls by a factor of about 4 for every coefficient.
const DECAYED: usize = 40;

/// A part of a list of coefficients; all others are 0.
#[derive(Clone, Debug)]
struct Part {
    from: usize,
    values: Vec<f64>,
}

impl Part {
    fn dot(&self, other: &Self) -> f64 {
        let from = self.from.max(other.from);
        let to = (self.from + self.values.len()).min(other.from + other.values.len());
        if from >= to {
            return 0.0;
        }
        dot(&self.values[from - self.from..to - self.from], &other.values[from - other.from..to - other.from])
    }
}

/// A function outside the space: its pieces, these weighted by the points, its products with the basis, left-solved, and
/// with the residuals of both coordinates.
#[derive(Clone, Debug)]
struct Bump {
    pieces: Vec<(usize, Polynomial)>,
    weighted: Vec<Polynomial>,
    column: Part,
    along: [f64; 2],
}

/// What it costs, in the sum of squares, to make a knot smoother by one and to take it away.
#[derive(Clone, Copy, Debug)]
pub(super) struct Removal {
    pub(super) one: f64,
    pub(super) whole: f64,
}

/// The equations of one Gauss–Newton step of all knots.
#[derive(Clone, Debug)]
pub(super) struct Sliding {
    equations: Envelope,
    right: Vec<f64>,
}

impl Sliding {
    fn steps(&self, damping: f64) -> Vec<f64> {
        let mut equations = self.equations.clone();
        let count = self.right.len();
        let floor = (0..count).map(|j| equations.diagonal(j)).sum::<f64>() * 1e-9 / count.max(1) as f64;
        for j in 0..count {
            let more = damping * equations.diagonal(j) + floor;
            equations.add(j, j, more);
        }
        let mut steps = self.right.clone();
        equations.factor();
        equations.solve(&mut steps);
        steps
    }

    /// By how much the sum of squares would fall if it were a parabola of the knots' places.
    pub(super) fn promise(&self) -> f64 {
        dot(&self.steps(1e-3), &self.right)
    }
}

impl FreeKnots {
    /// Least squares with the knots given. O(M·degree + K·degree²).
    pub fn new(breaks: Breaks, data: &Located) -> Self {
        let space = Space::new(breaks);
        let moments = gather(&space, data);
        let degree = space.breaks.degree;
        let mut factor = space.equations();
        let (mut x, mut y) = (vec![0.0; space.count], vec![0.0; space.count]);
        for (s, sums) in moments.iter().enumerate() {
            if sums.count == 0 {
                continue;
            }
            let basis = &space.basis[s];
            for p in 0..=degree {
                let row = space.index(s, p);
                x[row] += dot(&basis[p][..=degree], &sums.x[..=degree]);
                y[row] += dot(&basis[p][..=degree], &sums.y[..=degree]);
                let weighted = sums.weighted(degree, &basis[p]);
                for (q, basis) in basis[..=p].iter().enumerate() {
                    let (other, value) = (space.index(s, q), dot(&weighted[..=degree], &basis[..=degree]));
                    // Two functions of a piece may be one and the same where a closed curve has few knots.
                    let twice = if p != q && row == other { 2.0 } else { 1.0 };
                    factor.add(row.max(other), row.min(other), twice * value);
                }
            }
        }
        anchor(&mut factor, space.breaks.closed);
        let (right_x, right_y) = (x.clone(), y.clone());
        factor.factor();
        factor.solve(&mut x);
        factor.solve(&mut y);
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
        let twice = dot(&px[..=degree], &sums.x[..=degree]) + dot(&py[..=degree], &sums.y[..=degree]);
        let whole = |p: &Polynomial| dot(&sums.weighted(degree, p)[..=degree], &p[..=degree]);
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

    /// How a derivative of the curve jumps at knot k.
    pub(super) fn jump(&self, k: usize, order: usize) -> Point {
        let (before, after) = self.space.sides(k);
        let degree = self.space.breaks.degree;
        let (bx, by) = self.piece(before);
        let (ax, ay) = self.piece(after);
        let (hb, ha) = (self.space.spans[before].half, self.space.spans[after].half);
        Point::new(
            derivative(&ax, degree, -1.0, ha, order) - derivative(&bx, degree, 1.0, hb, order),
            derivative(&ay, degree, -1.0, ha, order) - derivative(&by, degree, 1.0, hb, order),
        )
    }

    /// For every knot exactly what the sum of squares would grow by without it: with w the jumps, L their rows and G the
    /// equations, wᵀ(LG⁻¹Lᵀ)⁻¹w (D 13.1). O(K²·degree).
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

    /// What it costs to have the products of coefficients with the first of some rows vanish, and with all of them. The
    /// rows have entries from `lowest` to `highest`, and are left empty.
    fn forced(&self, rows: &mut [Vec<f64>], lowest: usize, highest: usize) -> Removal {
        let m = rows.len();
        let mut jumps = [[0.0; 2]; HIGHEST];
        for (row, jump) in rows.iter_mut().zip(&mut jumps) {
            let entries = &row[lowest..=highest];
            *jump = [dot(entries, &self.x[lowest..=highest]), dot(entries, &self.y[lowest..=highest])];
            self.factor.forward_near(row, lowest, highest + DECAYED);
        }
        let end = (highest + DECAYED).min(self.space.count);
        let mut gram = Envelope::new(vec![0; m]);
        for p in 0..m {
            for q in 0..=p {
                gram.add(p, q, dot(&rows[p][lowest..end], &rows[q][lowest..end]));
            }
        }
        rows.iter_mut().for_each(|row| row[lowest..end].fill(0.0));
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

    /// A function that is not in the space, with all that is asked of it.
    fn bump(&self, k: usize, more: usize) -> (Bump, f64) {
        let degree = self.space.breaks.degree;
        let (pieces, jump) = self.space.bump(k, more);
        let mut along = [0.0; 2];
        let indices = || pieces.iter().flat_map(|(s, _)| (0..=degree).map(|i| self.space.index(*s, i)));
        let from = indices().min().unwrap_or(0);
        let to = (indices().max().unwrap_or(0) + DECAYED).min(self.space.count);
        let mut column = vec![0.0; to];
        let mut weighted = Vec::with_capacity(pieces.len());
        for (s, polynomial) in &pieces {
            let sums = &self.moments[*s];
            let own = sums.weighted(degree, polynomial);
            along[0] += dot(&polynomial[..=degree], &sums.x[..=degree]);
            along[1] += dot(&polynomial[..=degree], &sums.y[..=degree]);
            for i in 0..=degree {
                let row = self.space.index(*s, i);
                let product = dot(&self.space.basis[*s][i][..=degree], &own[..=degree]);
                column[row] += product;
                along[0] -= product * self.x[row];
                along[1] -= product * self.y[row];
            }
            weighted.push(own);
        }
        self.factor.forward_near(&mut column, from, to);
        column.drain(..from);
        (Bump { pieces, weighted, column: Part { from, values: column }, along }, jump)
    }

    /// Σ w·a·b of two functions, less what the space has of it.
    fn across(&self, a: &Bump, b: &Bump) -> f64 {
        let degree = self.space.breaks.degree;
        let mut sum = -a.column.dot(&b.column);
        for ((s, _), weighted) in a.pieces.iter().zip(&a.weighted) {
            for (_, q) in b.pieces.iter().filter(|(other, _)| other == s) {
                sum += dot(&weighted[..=degree], &q[..=degree]);
            }
        }
        sum
    }

    /// Exactly what the sum of squares would lose if knot k counted `more` times more (D 13.2).
    pub(super) fn gain(&self, k: usize, more: usize) -> f64 {
        let bumps: Vec<_> = (1..=more).map(|i| self.bump(k, i).0).collect();
        let mut gram = Envelope::new(vec![0; more]);
        for p in 0..more {
            for q in 0..=p {
                gram.add(p, q, self.across(&bumps[p], &bumps[q]));
            }
        }
        gram.factor();
        let mut gain = 0.0;
        for c in 0..2 {
            let mut w: Vec<f64> = bumps.iter().map(|bump| bump.along[c]).collect();
            gram.forward(&mut w, 0);
            gain += dot(&w, &w);
        }
        gain
    }

    /// The knots moved by one Gauss–Newton step of the sum of squares as a function of the knots alone (variable
    /// projection, \[GP73\], in the form (D 13.3)); `None` where no step makes it smaller. `damping` is Levenberg's.
    pub fn slide(&self, data: &Located, damping: &mut f64) -> Option<Self> {
        self.slid(&self.slide_equations(), data, damping)
    }

    /// One step by equations that are known.
    pub(super) fn slid(&self, equations: &Sliding, data: &Located, damping: &mut f64) -> Option<Self> {
        for _ in 0..3 {
            let moved = self.moved(equations, *damping);
            let fitted = Self::new(moved, data);
            if fitted.squares < self.squares {
                *damping = (*damping * 0.2).max(1e-6);
                return Some(fitted);
            }
            *damping = (*damping * 10.0).max(1e-3);
        }
        None
    }

    /// The equations of [`FreeKnots::slide`].
    pub(super) fn slide_equations(&self) -> Sliding {
        let breaks = &self.space.breaks;
        let (degree, count) = (breaks.degree, breaks.len());
        let mut bumps = Vec::with_capacity(count);
        for k in 0..count {
            let (bump, jump) = self.bump(k, 1);
            let order = degree + 1 - breaks.multiplicity[k];
            bumps.push((bump, -self.jump(k, order) / jump));
        }
        // Far knots hardly know of one another.
        let reach = if count <= 40 { count } else { 5 };
        let border = count.saturating_sub(if breaks.closed { 5 } else { 0 });
        let first = (0..count).map(|j| if j >= border { 0 } else { j.saturating_sub(reach) }).collect();
        let mut equations = Envelope::new(first);
        let mut right = vec![0.0; count];
        for j in 0..count {
            let (bump, direction) = &bumps[j];
            right[j] = direction.x * bump.along[0] + direction.y * bump.along[1];
            let from = if j >= border { 0 } else { j.saturating_sub(reach) };
            for (k, (other, towards)) in bumps.iter().enumerate().take(j + 1).skip(from) {
                equations.add(j, k, direction.dot(towards) * self.across(bump, other));
            }
        }
        Sliding { equations, right }
    }

    fn moved(&self, sliding: &Sliding, damping: f64) -> Breaks {
        let mut breaks = self.space.breaks.clone();
        let count = breaks.len();
        let steps = sliding.steps(damping);
        // Knots that want to be closer than points are want to be one.
        let closest = breaks.end / self.points().max(1) as f64;
        let room = |gap: f64| (0.3 * gap).min(0.5 * (gap - closest)).max(0.0);
        let most: Vec<f64> =
            (0..count).map(|k| room(breaks.gap_before(k)).min(room(breaks.gap_after(k)))).collect();
        for k in 0..count {
            if steps[k].is_finite() {
                breaks.at[k] += steps[k].max(-most[k]).min(most[k]);
            }
        }
        in_order(&mut breaks);
        breaks
    }
}

/// Brings knots that slid past the seam of a closed curve back to the other side.
pub(super) fn in_order(breaks: &mut Breaks) {
    if !breaks.closed || breaks.is_empty() {
        return;
    }
    while breaks.at[0] < 0.0 {
        let (t, m) = (breaks.at.remove(0) + breaks.end, breaks.multiplicity.remove(0));
        breaks.at.push(t);
        breaks.multiplicity.push(m);
    }
    while breaks.at[breaks.at.len() - 1] >= breaks.end {
        let last = breaks.at.len() - 1;
        let (t, m) = (breaks.at.remove(last) - breaks.end, breaks.multiplicity.remove(last));
        breaks.at.insert(0, t.max(0.0));
        breaks.multiplicity.insert(0, m);
    }
}

/// The sums of every piece, in one pass.
fn gather(space: &Space, data: &Located) -> Vec<Moments> {
    // Loops of a length that is known are unrolled.
    match space.breaks.degree {
        3 => gathered(space, data, 3),
        degree => gathered(space, data, degree),
    }
}

#[inline(always)]
fn gathered(space: &Space, data: &Located, degree: usize) -> Vec<Moments> {
    let mut moments = vec![Moments::default(); space.spans.len()];
    let mut at = 0;
    for (m, (point, &t)) in data.points.iter().zip(&data.parameters).enumerate() {
        let (s, t) = space.find(t, at);
        at = s;
        let span = &space.spans[s];
        let u = (t - span.middle) / span.half;
        let sums = &mut moments[s];
        let weight = data.weight(m);
        sums.count += 1;
        sums.square += weight * point.norm_squared();
        let mut power = weight;
        for k in 0..=degree {
            sums.powers[k] += power;
            sums.x[k] += power * point.x;
            sums.y[k] += power * point.y;
            power *= u;
        }
        for sum in &mut sums.powers[degree + 1..=2 * degree] {
            *sum += power;
            power *= u;
        }
    }
    moments
}

/// A faint pull between neighbouring coefficients: where there are no points, there is still one solution.
fn anchor(equations: &mut Envelope, closed: bool) {
    let n = equations.size();
    let pull = (0..n).map(|i| equations.diagonal(i)).sum::<f64>() * 1e-11 / n as f64 + 1e-280;
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
