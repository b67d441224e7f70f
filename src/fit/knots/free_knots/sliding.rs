//! Knots that slide or count more often: functions outside the space, and what the sum of squares would lose by them.

use super::moments::product;
use super::{FreeKnots, Located};
use crate::fit::knots::breaks::{Breaks, HIGHEST};
use crate::fit::knots::envelope::Envelope;
use crate::fit::knots::space::{Polynomial, derivative};
use crate::numerics::Point;
use crate::numerics::lists::dot;

/// A part of a list of coefficients, and those of the border; all others are 0.
#[derive(Clone, Debug)]
struct Part {
    from: usize,
    to: usize,
    /// Those of the part, then those of the border.
    values: Vec<f64>,
}

impl Part {
    fn dot(&self, other: &Self) -> f64 {
        let (from, to) = (self.from.max(other.from), self.to.min(other.to));
        let border = dot(&self.values[self.to - self.from..], &other.values[other.to - other.from..]);
        if from >= to {
            return border;
        }
        let near = &self.values[from - self.from..to - self.from];
        border + dot(near, &other.values[from - other.from..to - other.from])
    }
}

/// A function outside the space: its pieces, these weighted by the points, its products with the basis, left-solved,
/// and with the residuals of both coordinates.
#[derive(Clone, Debug)]
struct Bump {
    pieces: Vec<(usize, Polynomial)>,
    weighted: Vec<Polynomial>,
    column: Part,
    along: [f64; 2],
}

/// The equations of one Gauss–Newton step of all knots.
#[derive(Clone, Debug)]
pub(in super::super) struct Sliding {
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
    pub(in super::super) fn promise(&self) -> f64 {
        dot(&self.steps(1e-3), &self.right)
    }
}

impl FreeKnots {
    /// A function that is not in the space, with all that is asked of it. The room is for as many numbers as there are
    /// coefficients, all 0, and is left so.
    fn bump(&self, k: usize, more: usize, room: &mut [f64]) -> (Bump, f64) {
        let degree = self.space.breaks.degree;
        let (pieces, jump) = self.space.bump(k, more);
        let mut along = [0.0; 2];
        let (mut from, mut last) = (self.space.count, 0);
        let mut weighted = Vec::with_capacity(pieces.len());
        for (s, polynomial) in &pieces {
            let sums = &self.moments[*s];
            let own = sums.weighted(degree, polynomial);
            along[0] += product(polynomial, &sums.x);
            along[1] += product(polynomial, &sums.y);
            for (i, basis) in self.space.basis[*s].iter().enumerate().take(degree + 1) {
                let row = self.space.index(*s, i);
                let value = product(basis, &own);
                room[row] += value;
                along[0] -= value * self.x[row];
                along[1] -= value * self.y[row];
                (from, last) = (from.min(row), last.max(row));
            }
            weighted.push(own);
        }
        let border = self.factor.border();
        let to = self.factor.forward_near(room, from, last);
        let from = from.min(to);
        let mut values = Vec::with_capacity(to - from + room.len() - border);
        values.extend_from_slice(&room[from..to]);
        values.extend_from_slice(&room[border..]);
        room[from..to].fill(0.0);
        room[border..].fill(0.0);
        (Bump { pieces, weighted, column: Part { from, to, values }, along }, jump)
    }

    /// Σ w·a·b of two functions, less what the space has of it.
    fn across(&self, a: &Bump, b: &Bump) -> f64 {
        let mut sum = -a.column.dot(&b.column);
        for ((s, _), weighted) in a.pieces.iter().zip(&a.weighted) {
            for (other, q) in &b.pieces {
                if other == s {
                    sum += product(weighted, q);
                }
            }
        }
        sum
    }

    /// Exactly what the sum of squares would lose if knot k counted once more, twice more and so on (D 13.2).
    pub(in super::super) fn gains(&self, k: usize, most: usize) -> [f64; HIGHEST] {
        let mut room = vec![0.0; self.space.count];
        let bumps: Vec<_> = (1..=most).map(|i| self.bump(k, i, &mut room).0).collect();
        let mut gram = Envelope::new(vec![0; most]);
        for p in 0..most {
            for q in 0..=p {
                gram.add(p, q, self.across(&bumps[p], &bumps[q]));
            }
        }
        gram.factor();
        let mut gains = [0.0; HIGHEST];
        for c in 0..2 {
            let mut w: Vec<f64> = bumps.iter().map(|bump| bump.along[c]).collect();
            gram.forward(&mut w, 0);
            let mut sum = 0.0;
            for (gain, w) in gains.iter_mut().zip(&w) {
                sum += w * w;
                *gain += sum;
            }
        }
        gains
    }

    /// The knots moved by one Gauss–Newton step of the sum of squares as a function of the knots alone (variable
    /// projection, \[GP73\], in the form (D 13.3)); `None` where no step makes it smaller. `damping` is Levenberg's.
    pub fn slide(&self, data: &Located, damping: &mut f64) -> Option<Self> {
        self.slid(&self.slide_equations(), data, damping)
    }

    /// One step by equations that are known.
    pub(in super::super) fn slid(
        &self,
        equations: &Sliding,
        data: &Located,
        damping: &mut f64,
    ) -> Option<Self> {
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

    /// How a derivative of the curve with these pieces jumps at knot k.
    fn jump(&self, pieces: &[(Polynomial, Polynomial)], k: usize, order: usize) -> Point {
        let (before, after) = self.space.sides(k);
        let degree = self.space.breaks.degree;
        let ((bx, by), (ax, ay)) = (&pieces[before], &pieces[after]);
        let (hb, ha) = (self.space.spans[before].half, self.space.spans[after].half);
        Point::new(
            derivative(ax, degree, -1.0, ha, order) - derivative(bx, degree, 1.0, hb, order),
            derivative(ay, degree, -1.0, ha, order) - derivative(by, degree, 1.0, hb, order),
        )
    }

    /// The equations of [`FreeKnots::slide`].
    pub(in super::super) fn slide_equations(&self) -> Sliding {
        let breaks = &self.space.breaks;
        let (degree, count) = (breaks.degree, breaks.len());
        let pieces: Vec<_> = (0..self.space.spans.len()).map(|s| self.piece(s)).collect();
        let mut bumps = Vec::with_capacity(count);
        let mut room = vec![0.0; self.space.count];
        for k in 0..count {
            let (bump, jump) = self.bump(k, 1, &mut room);
            let order = degree + 1 - breaks.multiplicity[k];
            bumps.push((bump, -self.jump(&pieces, k, order) / jump));
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
pub(in super::super) fn in_order(breaks: &mut Breaks) {
    if !breaks.closed || breaks.is_empty() {
        return;
    }
    while breaks.at[0] < 0.0 {
        let (t, m) = (breaks.at.remove(0) + breaks.end, breaks.multiplicity.remove(0));
        breaks.at.push(t);
        breaks.multiplicity.push(m);
        turn(&mut breaks.straight, 1);
    }
    while breaks.at[breaks.at.len() - 1] >= breaks.end {
        let last = breaks.at.len() - 1;
        let (t, m) = (breaks.at.remove(last) - breaks.end, breaks.multiplicity.remove(last));
        breaks.at.insert(0, t.max(0.0));
        breaks.multiplicity.insert(0, m);
        let last = breaks.straight.len().saturating_sub(1);
        turn(&mut breaks.straight, last);
    }
}

/// Begins the list at another of its places; the list of a curve without straight pieces is empty.
fn turn(list: &mut [bool], by: usize) {
    if by < list.len() {
        list.rotate_left(by);
    }
}
