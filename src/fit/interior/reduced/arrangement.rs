//! The order of the unknowns in which their equations are a narrow band with a small border.
//!
//! Along the curve, by the middles of their supports, coefficients couple with those beside them; round a circle the
//! last couple with the first, and are the border. Where one spline has few knots and the other many, supports of the
//! one reach over many coefficients of the other, and no band is narrow: the widest then stand in the border as well,
//! which couples with everything anyway.

use super::{Part, Reduced};
use crate::error::Result;
use crate::fit::convex::spline_space::KnotSpace;
use crate::numerics::banded::Bordered;
use crate::numerics::order::sort_by_number;

/// A band with its border that are so wide together are not worth another order.
const NARROW: usize = 24;

/// A coefficient: the middle of its support, its part, and its number there.
type Unknown = (f64, usize, usize);

/// Unknowns in the band, how far they couple there, and how many are left for the border.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Shape {
    banded: usize,
    reach: usize,
    border: usize,
}

impl Shape {
    /// About how many products the elimination takes.
    pub(super) fn work(self) -> f64 {
        let [banded, wide, border] =
            [self.banded, self.reach + self.border, self.border].map(|count| count as f64);
        banded * wide * wide + border * border * border / 3.0
    }
}

impl Reduced {
    /// Orders the unknowns, and makes room for their equations.
    pub(super) fn arrange(&mut self) -> Result<()> {
        let along = along(&self.parts);
        let mut best = self.arranged(&along, &|_| false);
        if best.reach + best.border > NARROW {
            best = self.with_wide_ones_last(&along, best);
        }
        self.shape = best;
        self.quadratic = Bordered::new(best.banded, best.reach, best.border)?;
        self.system = self.quadratic.of_points()?;
        Ok(())
    }

    /// The cheapest shape of those where unknowns that reach over many come last, and the one where none does.
    fn with_wide_ones_last(&mut self, along: &[Unknown], none: Shape) -> Shape {
        let widths = widths(&self.parts, along);
        let (mut best, mut most, mut widest) = (none, usize::MAX, along.len() / 2);
        while widest > NARROW / 2 {
            let shape = self.arranged(along, &|i| widths[i] > widest);
            if shape.work() < best.work() {
                (best, most) = (shape, widest);
            }
            widest /= 2;
        }
        self.arranged(along, &|i| widths[i] > most)
    }

    /// The shape where those come last that are wide.
    fn arranged(&mut self, along: &[Unknown], is_wide: &dyn Fn(usize) -> bool) -> Shape {
        let (narrow, wide): (Vec<usize>, Vec<usize>) = (0..along.len()).partition(|&i| !is_wide(i));
        for (place, &i) in narrow.iter().chain(&wide).enumerate() {
            let (_, part, coefficient) = along[i];
            self.parts[part].order[coefficient] = place;
        }
        for part in &mut self.parts {
            for row in &mut part.rows {
                for (i, unknown) in row.unknowns.iter_mut().enumerate().take(part.space.degree() + 2) {
                    *unknown = part.order[part.space.coefficient(row.first + i)];
                }
            }
        }
        self.measured(narrow.len())
    }

    /// How far unknowns couple of which only the first `narrow` may be in the band.
    fn measured(&self, narrow: usize) -> Shape {
        let (mut reach, mut border) = (0, 0);
        let mut couple = |set: &mut dyn Iterator<Item = usize>| {
            let (mut low, mut high, mut late) = (narrow, 0, narrow);
            let (mut first, mut last) = (narrow, 0);
            for unknown in set.filter(|unknown| *unknown < narrow) {
                (first, last) = (first.min(unknown), last.max(unknown));
                if 2 * unknown >= narrow {
                    late = late.min(unknown);
                } else {
                    (low, high) = (low.min(unknown), high.max(unknown));
                }
            }
            if first < narrow && 2 * (last - first) > narrow {
                border = border.max(narrow - late);
                reach = reach.max(high.saturating_sub(low));
            } else {
                reach = reach.max(last.saturating_sub(first));
            }
        };
        for part in &self.parts {
            for row in &part.rows {
                couple(&mut row.unknowns[..part.space.degree() + 2].iter().copied());
            }
        }
        for locals in self.locals.chunks_exact(self.parts.len()) {
            couple(&mut self.parts.iter().zip(locals).flat_map(|(part, (first, local))| {
                (*first..=first + local.degree).map(|j| part.order[part.space.coefficient(j)])
            }));
        }
        if 2 * border > narrow || 2 * reach > narrow {
            (border, reach) = (narrow, 0);
        }
        Shape { banded: narrow - border, reach, border: border + self.unknowns - narrow }
    }
}

/// The coefficients of all parts along the curve, by the middles of their supports.
fn along(parts: &[Part]) -> Vec<Unknown> {
    let mut centres = Vec::new();
    for (p, part) in parts.iter().enumerate() {
        let (start, end) = part.space.domain();
        for j in 0..part.space.dimension() {
            let (from, to) = part.space.support(j);
            let mut centre = 0.5 * (from + to);
            if part.space.is_closed() && centre < start {
                centre += end - start;
            }
            if part.space.is_closed() && centre >= end {
                centre -= end - start;
            }
            centres.push((centre, p, j));
        }
    }
    sort_by_number(&mut centres, &|centre| centre.0);
    centres
}

/// How many middles the support of each reaches over; round a circle as many times as it takes.
fn widths(parts: &[Part], along: &[Unknown]) -> Vec<usize> {
    let before = |space: &KnotSpace, t: f64| {
        let (start, end) = space.domain();
        let turns = if space.is_closed() { ((t - start) / (end - start)).floor() } else { 0.0 };
        let t = t - turns * (end - start);
        along.partition_point(|(centre, ..)| *centre < t) as f64 + turns * along.len() as f64
    };
    let width = |&(_, part, j): &Unknown| {
        let space = &parts[part].space;
        let (from, to) = space.support(j);
        (before(space, to) - before(space, from)) as usize
    };
    along.iter().map(width).collect()
}

#[cfg(test)]
mod tests {
    use crate::error::Result;
    use crate::fit::convex::problem::Problem;
    use crate::fit::convex::scaled::Scaled;
    use crate::fit::interior::reduced::Reduced;
    use crate::numerics::Vector;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// How many unknowns are in the band, how many are not, and how far they couple: corners at some of 400 places,
    /// smooth pieces between all.
    fn arranged(closed: bool, corners: &[usize]) -> Result<(usize, usize, usize)> {
        let circle = |i: usize| Vector::new((i as f64 / 64.0).cos(), (i as f64 / 64.0).sin());
        let points: Vec<Vector> = (0..400).map(circle).collect();
        let problem = Problem::of_points(&points, closed, &[(1, 1.0, 400), (3, 1.0, 400)])?;
        let data = Scaled::new(&problem)?;
        let all = (0..data.components[1].grid.len()).collect();
        let reduced = Reduced::new(&data, vec![corners.to_vec(), all], &[])?;
        Ok((reduced.shape.banded, reduced.shape.border, reduced.shape.reach))
    }

    #[test]
    fn a_few_wide_supports_do_not_widen_the_band() -> Result<()> {
        for closed in [false, true] {
            for corners in [vec![], vec![7, 200], vec![20, 21, 22, 23, 24, 25, 390], (100..300).collect()] {
                let (banded, border, reach) = arranged(closed, &corners)?;
                // No support in the band reaches over more than 25 others; in the border are those around a corner that
                // is far from the next, and what closes the circle.
                assert!(reach <= 25, "closed {closed}, {} corners: the band is {reach} wide", corners.len());
                assert!(border <= 24, "closed {closed}, {} corners: {border} of {banded}", corners.len());
            }
        }
        Ok(())
    }
}
