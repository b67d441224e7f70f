//! Several splines as one of the highest degree: exactly, by polar forms.

use super::breaks::{Breaks, HIGHEST};
use super::look::Piece;
use super::space::{Polynomial, Space};
use super::spline::Spline;
use crate::numerics::Vector;
use crate::numerics::order::sort_by_number;

/// One spline of a sum: simple knots, and the coefficients of its B-splines counted as [`crate::fit::KnotSpace`]
/// counts.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Summand {
    pub(in crate::fit) degree: usize,
    pub(in crate::fit) knots: Vec<f64>,
    pub(in crate::fit) coefficients: Vec<Vector>,
}

impl Summand {
    /// The summand as a spline.
    pub(in crate::fit) fn spline(&self, closed: bool, end: f64) -> Spline {
        // A closed spline without knots has one where nothing jumps.
        let at = if closed && self.knots.is_empty() { vec![0.0] } else { self.knots.clone() };
        let degree = self.degree;
        let space = Space::new(Breaks::simple(degree, closed, end, at));
        let count = self.coefficients.len().max(1);
        // On circles the first function here starts at the first knot, there it ends its first piece.
        let shift = if closed { degree } else { 0 };
        let of = |pick: &dyn Fn(&Vector) -> f64| {
            (0..space.count).map(|i| self.coefficients.get((i + shift) % count).map_or(0.0, pick)).collect()
        };
        let (x, y) = (of(&|v| v.x), of(&|v| v.y));
        Spline { space, x, y }
    }
}

/// The sum as one spline of the highest degree. (D 13.6)
pub(in crate::fit) fn combined(parts: &[Spline]) -> Option<Spline> {
    let highest = parts.iter().map(|part| part.space.breaks.degree).max()?;
    let first = &parts.first()?.space.breaks;
    let (closed, end) = (first.closed, first.end);
    if parts.len() == 1 {
        return parts.first().cloned();
    }
    let mut marks: Vec<(f64, usize)> = Vec::new();
    for part in parts {
        let raise = highest - part.space.breaks.degree;
        let breaks = &part.space.breaks;
        marks.extend(breaks.at.iter().zip(&breaks.multiplicity).map(|(&t, &m)| (t, m + raise)));
    }
    sort_by_number(&mut marks, &|mark| mark.0);
    let mut breaks = Breaks::even(highest, closed, end, 0);
    for (t, m) in marks {
        match breaks.at.last() {
            Some(&last) if t - last <= 1e-12 * end => {
                let k = breaks.multiplicity.len() - 1;
                breaks.multiplicity[k] = breaks.multiplicity[k].max(m);
            }
            _ => {
                breaks.at.push(t);
                breaks.multiplicity.push(m);
            }
        }
    }
    Some(expressed(Space::new(breaks), &|middle, half| sum_on(parts, middle, half, end)))
}

/// The spline of a space whose polynomials on middle ± half are known.
#[inline(never)]
pub(super) fn expressed(space: Space, on: &dyn Fn(f64, f64) -> (Polynomial, Polynomial)) -> Spline {
    let degree = space.breaks.degree;
    let (mut x, mut y) = (vec![0.0; space.count], vec![0.0; space.count]);
    let mut farthest = vec![f64::INFINITY; space.count];
    for (s, span) in space.spans.iter().enumerate() {
        let (px, py) = on(span.middle, span.half);
        for i in 0..=degree {
            let index = space.index(s, i);
            let knots = space.inner_knots(s, i);
            // The piece that is widest, and nearest to the knots, tells a coefficient best: a narrow one multiplies
            // what its numbers are rounded by.
            let far: f64 = knots[..degree].iter().map(|knot| (knot - span.middle).abs() / span.half).sum();
            if far < farthest[index] {
                farthest[index] = far;
                x[index] = blossom(&px, degree, &knots, span.middle, span.half);
                y[index] = blossom(&py, degree, &knots, span.middle, span.half);
            }
        }
    }
    Spline { space, x, y }
}

/// The polynomials of the sum on middle ± half, inside one piece of every part.
#[inline(never)]
pub(super) fn sum_on(parts: &[Spline], middle: f64, half: f64, end: f64) -> (Polynomial, Polynomial) {
    let (mut x, mut y) = ([0.0; HIGHEST + 1], [0.0; HIGHEST + 1]);
    for part in parts {
        let degree = part.space.breaks.degree;
        let turned = if middle >= end { middle - end } else { middle };
        let (s, t) = part.space.find(turned, 0);
        let mut factor = 1.0;
        for k in 0..=degree {
            let value = part.on(s, t, k) * factor;
            x[k] += value.x;
            y[k] += value.y;
            factor *= half / (k + 1) as f64;
        }
    }
    (x, y)
}

/// The polynomials of a piece, whose parameters are middle ± half, on another such interval.
#[inline(never)]
pub(super) fn onto(
    piece: &Piece,
    [middle, half]: [f64; 2],
    [onto, width]: [f64; 2],
) -> (Polynomial, Polynomial) {
    let (mut moved, by) = (*piece, (onto - middle) / half);
    for i in 0..HIGHEST {
        for k in (i..HIGHEST).rev() {
            moved[k] += moved[k + 1] * by;
        }
    }
    let mut power = 1.0;
    for c in &mut moved {
        *c *= power;
        power *= width / half;
    }
    (moved.map(|c| c.x), moved.map(|c| c.y))
}

/// The polar form of a polynomial in u at the knots of a B-spline: its coefficient there.
#[inline(never)]
pub(super) fn blossom(p: &Polynomial, degree: usize, knots: &[f64; HIGHEST], middle: f64, half: f64) -> f64 {
    let mut symmetric = [0.0; HIGHEST + 1];
    symmetric[0] = 1.0;
    for &knot in &knots[..degree] {
        let u = (knot - middle) / half;
        for k in (1..=degree).rev() {
            symmetric[k] += symmetric[k - 1] * u;
        }
    }
    let (mut sum, mut choose) = (0.0, 1.0);
    for k in 0..=degree {
        sum += p[k] * symmetric[k] / choose;
        choose *= (degree - k) as f64 / (k + 1) as f64;
    }
    sum
}
