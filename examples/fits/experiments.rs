//! The experiments of [LDAU22], made again: what was measured, a figure and lines of a table for each.

use super::contours::{CASTLE, FOX, SHIELD, along, noisy, on_pixels, turned};
use super::matched::{Matched, Splines, at_mean_square, solved};
use super::panels::{Panel, figure, polygon};
use expline::Result;
use expline::fit::{Breaks, Finish, Fit, FreeKnots, Located, Norm};
use expline::numerics::Point;
use expline::svg::{PrintOptions, to_path_d};
use std::fmt::Write as _;

/// What an experiment leaves: its figure, and the lines below its heading.
pub(crate) struct Shown {
    pub(crate) figure: String,
    pub(crate) table: String,
}

/// Points of a contour in the paper's figures 2 to 4, and places for knots: a step of 488/256.
const COUNT: usize = 488;
const PLACES: usize = 256;
const LAMBDA: f64 = 700.0;
/// The deviation of the noise in each coordinate at 47, 40 and 35 dB, for a contour of this size.
const DEVIATIONS: [f64; 3] = [1.27, 2.93, 5.2];

const PRUNED: Finish = Finish { extreme: false, merge: true, slide: true, debias: true, prune: true };

fn castle(deviation: f64) -> Result<(Vec<Point>, Vec<Point>)> {
    let places = along(CASTLE, COUNT, 1.0)?;
    let points = noisy(&places, deviation, 5);
    Ok((places, points))
}

/// A panel of a polygon: degree 1, all knots corners.
fn polygonal(name: &str, note: String, data: usize, matched: &Matched) -> Result<Panel> {
    let corners = matched.places()?.concat();
    Ok(Panel { name: name.into(), note, data, curve: polygon(&corners), corners, knots: Vec::new() })
}

/// A panel of a fit whose knots may be of two kinds.
fn mixed(name: &str, note: String, data: usize, fit: &Fit) -> Result<Panel> {
    let options = PrintOptions { tolerance: 1e-2, decimals: Some(1), arcs: false, relative: true };
    let places = |corner: bool| -> Vec<Point> {
        fit.knots.iter().filter(|knot| (knot.degree == 1) == corner).map(|knot| knot.point).collect()
    };
    let curve = to_path_d(&fit.curve, &options)?.d;
    Ok(Panel { name: name.into(), note, data, curve, corners: places(true), knots: places(false) })
}

/// One norm at one angle.
pub(crate) struct Turned {
    pub(crate) degrees: f64,
    pub(crate) coupled: Matched,
    pub(crate) apart: Matched,
}

/// Figure 2: the norm of jumps does not depend on the axes, the sum of their coordinates does. λ of the latter is such
/// that the mean squares agree.
pub(crate) fn rotation() -> Result<(Vec<Turned>, Shown)> {
    let (_, points) = castle(DEVIATIONS[0])?;
    let mut rows = Vec::new();
    for degrees in [0.0, 10.0, 20.0, 30.0, 40.0] {
        let points = turned(&points, degrees);
        let coupled = solved(&points, &[(1, LAMBDA, PLACES)], Norm::L2)?;
        let apart = at_mean_square(&points, &[(1, 0.7 * LAMBDA, PLACES)], Norm::L1, coupled.square())?;
        rows.push(Turned { degrees, coupled, apart });
    }
    let mut table = String::from(
        "\n| turned by | RI-TV: λ, knots | TV-ℓ1 at the same mean square: λ, knots |\n|---|---|---|\n",
    );
    for row in &rows {
        let _ = writeln!(
            table,
            "| {:.0}° | {LAMBDA:.0}, {} | {:.0}, {} |",
            row.degrees,
            row.coupled.knots().0,
            row.apart.lambdas[0],
            row.apart.knots().0
        );
    }
    let mut panels = Vec::new();
    let mut data = Vec::new();
    for row in [&rows[0], &rows[4]] {
        for (name, one) in [("RI-TV", &row.coupled), ("TV-ℓ1", &row.apart)] {
            let note = format!("{:.0}°, λ = {:.0}, K = {}", row.degrees, one.lambdas[0], one.knots().0);
            panels.push(polygonal(name, note, data.len(), one)?);
        }
        data.push(row.coupled.problem.points.clone());
    }
    let figure = figure("A polygon turned: knots of both norms", &data, &panels, 4, 430.0);
    Ok((rows, Shown { figure, table }))
}

/// What is left of a mean square with as many knots.
pub(crate) struct Sparse {
    pub(crate) knots: usize,
    pub(crate) square: f64,
    /// The mean square of as many knots, evenly spread over the points.
    pub(crate) even: f64,
    /// How many evenly spread knots have the mean square.
    pub(crate) as_good: usize,
}

/// The least squares of a closed polygon whose knots are evenly spread over the points: what knot removal by averaging
/// begins and ends with.
fn evenly_spread(points: &[Point], knots: usize) -> FreeKnots {
    let located = Located {
        points: points.to_vec(),
        parameters: (0..points.len()).map(|i| i as f64).collect(),
        weights: Vec::new(),
    };
    FreeKnots::new(Breaks::even(1, true, points.len() as f64, knots), &located)
}

/// Figure 3: as many knots where nobody looked for them.
pub(crate) fn sparsity() -> Result<(Sparse, Shown)> {
    let (_, points) = castle(DEVIATIONS[0])?;
    let optimum = at_mean_square(&points, &[(1, LAMBDA, PLACES)], Norm::L2, 12.09)?;
    let pruned = optimum.fitted(PRUNED)?;
    let square_of = |knots: usize| evenly_spread(&points, knots).squares() / points.len() as f64;
    let knots = pruned.knots.len();
    let found = Sparse {
        knots,
        square: pruned.qfe,
        even: square_of(knots),
        as_good: (knots..points.len()).find(|&n| square_of(n) <= pruned.qfe).unwrap_or(points.len()),
    };
    let mut table = String::from("\n| | knots | mean square |\n|---|---|---|\n");
    let (grid, joined) = optimum.knots();
    let _ = writeln!(table, "| the convex optimum on the grid | {grid} | {:.2} |", optimum.square());
    let _ = writeln!(table, "| the same, neighbours joined | {joined} | |");
    let _ = writeln!(table, "| pruned at the same mean square | {} | {:.2} |", found.knots, found.square);
    let _ = writeln!(table, "| least squares, evenly spread knots | {knots} | {:.2} |", found.even);
    let _ = writeln!(
        table,
        "| least squares, evenly spread knots | {} | {:.2} |",
        found.as_good,
        square_of(found.as_good)
    );
    let even = evenly_spread(&points, knots);
    let corners: Vec<Point> = even.breaks().at.iter().map(|&t| even.evaluate(t, 0)).collect();
    let panels = [
        mixed("fewest knots", format!("K = {knots}, mean square {:.1}", found.square), 0, &pruned)?,
        Panel {
            name: "evenly spread".into(),
            note: format!("K = {knots}, mean square {:.1}", found.even),
            data: 0,
            curve: polygon(&corners),
            corners,
            knots: Vec::new(),
        },
    ];
    Ok((
        found,
        Shown { figure: figure("As many knots, found and spread", &[points], &panels, 2, 430.0), table },
    ))
}

/// Both norms at one level of noise.
pub(crate) struct Noise {
    pub(crate) square: f64,
    pub(crate) coupled: Matched,
    pub(crate) apart: Matched,
    /// Mean squares to the contour without noise.
    pub(crate) truth: [f64; 2],
}

/// Figure 4: three levels of noise, the mean square that of the noise.
pub(crate) fn noise() -> Result<(Vec<Noise>, Shown)> {
    let mut rows = Vec::new();
    for deviation in DEVIATIONS {
        let (places, points) = castle(deviation)?;
        let square = 2.0 * deviation * deviation;
        let at = |norm| at_mean_square(&points, &[(1, LAMBDA, PLACES)], norm, square);
        let (coupled, apart) = (at(Norm::L2)?, at(Norm::L1)?);
        let truth = [coupled.square_to(&places)?, apart.square_to(&places)?];
        rows.push(Noise { square, coupled, apart, truth });
    }
    let mut table = String::from(
        "\n| mean square of the noise | RI-TV: knots on the grid, joined, mean square to the truth | TV-ℓ1: the same |\n|---|---|---|\n",
    );
    let (mut panels, mut data) = (Vec::new(), Vec::new());
    for row in &rows {
        let one = |matched: &Matched, truth: f64| {
            let (grid, joined) = matched.knots();
            format!("{grid}, {joined}, {truth:.2}")
        };
        let (coupled, apart) = (one(&row.coupled, row.truth[0]), one(&row.apart, row.truth[1]));
        let _ = writeln!(table, "| {:.1} | {coupled} | {apart} |", row.square);
        let note = format!("mean square {:.1}, K = {}", row.square, row.coupled.knots().0);
        panels.push(polygonal("RI-TV", note, data.len(), &row.coupled)?);
        data.push(row.coupled.problem.points.clone());
    }
    for (i, row) in rows.iter().enumerate() {
        let note = format!("mean square {:.1}, K = {}", row.square, row.apart.knots().0);
        panels.push(polygonal("TV-ℓ1", note, i, &row.apart)?);
    }
    let figure = figure("Three levels of noise and two norms", &data, &panels, 3, 430.0);
    Ok((rows, Shown { figure, table }))
}

/// One choice of degrees at the common mean square.
pub(crate) struct Degrees {
    pub(crate) name: &'static str,
    pub(crate) matched: Matched,
    pub(crate) pruned: Fit,
}

impl Degrees {
    /// A pruned curve's numbers: a place for each knot, and two coordinates for each derivative that jumps.
    pub(crate) fn numbers(&self) -> usize {
        let highest = self.matched.problem.components.iter().map(|c| c.degree).max().unwrap_or(1);
        self.pruned.knots.iter().map(|knot| 1 + 2 * (highest + 1 - knot.degree)).sum()
    }
}

/// Figure 5: straight sides, arcs and kinks by one degree and by two, at one mean square.
pub(crate) fn hybrid() -> Result<(Vec<Degrees>, Shown)> {
    const MEAN_SQUARE: f64 = 6.0;
    const STEPS: usize = 280;
    let points = on_pixels(&along(SHIELD, 560, 1.0)?);
    // λ of the same length of detail; the second degree's reaches farther.
    let lambda = |degree: usize, detail: f64| {
        let turn = detail / core::f64::consts::TAU;
        (0..=degree).fold(400.0, |value, _| value * turn)
    };
    let mut rows = Vec::new();
    let mut add = |name, splines: &Splines| -> Result<()> {
        let matched = at_mean_square(&points, splines, Norm::L2, MEAN_SQUARE)?;
        let pruned = matched.fitted(PRUNED)?;
        rows.push(Degrees { name, matched, pruned });
        Ok(())
    };
    add("degree 1", &[(1, lambda(1, 12.0), STEPS)])?;
    add("degree 2", &[(2, lambda(2, 14.0), STEPS)])?;
    add("degree 3", &[(3, lambda(3, 16.0), STEPS)])?;
    add("degrees 1 and 3", &[(1, lambda(1, 40.0 / 2.6), STEPS), (3, lambda(3, 40.0), STEPS)])?;
    let mut table = String::from(
        "\n| | knots of the optimum | joined | after pruning | their numbers | mean square |\n|---|---|---|---|---|---|\n",
    );
    let mut panels = Vec::new();
    for row in &rows {
        let (grid, joined) = row.matched.knots();
        let (left, numbers) = (row.pruned.knots.len(), row.numbers());
        let (optimum, after) = (row.matched.square(), row.pruned.qfe);
        let _ = writeln!(
            table,
            "| {} | {grid} | {joined} | {left} | {numbers} | {optimum:.2}, {after:.2} |",
            row.name
        );
        let note = format!("optimum, K = {joined}");
        panels.push(mixed(row.name, note, 0, &row.matched.fitted(Finish::default())?)?);
    }
    for row in &rows {
        panels.push(mixed(row.name, format!("pruned, K = {}", row.pruned.knots.len()), 0, &row.pruned)?);
    }
    let figure =
        figure("Straight sides, arcs and kinks by one degree and by two", &[points], &panels, 4, 430.0);
    Ok((rows, Shown { figure, table }))
}

/// Figure 6: a contour of 2,714 points, λ rising, the two degrees' in one ratio.
pub(crate) fn sweep() -> Result<(Vec<Matched>, Shown)> {
    let points = on_pixels(&along(FOX, 2714, 2.0)?);
    let (mut rows, mut panels) = (Vec::new(), Vec::new());
    let mut table = String::from(
        "\n| detail, points | knots of degree 1 | of degree 3 | mean square |\n|---|---|---|---|\n",
    );
    for detail in [28.0, 56.0, 112.0, 224.0] {
        let lambda = |degree: usize, detail: f64| {
            let turn = detail / core::f64::consts::TAU;
            (0..=degree).fold(800.0, |value, _| value * turn)
        };
        let splines = [(1, lambda(1, detail / 3.5), 678), (3, lambda(3, detail), 678)];
        let matched = solved(&points, &splines, Norm::L2)?;
        let counts: Vec<usize> =
            matched.solution.components.iter().map(|spline| spline.knots.len()).collect();
        let _ = writeln!(table, "| {detail:.0} | {} | {} | {:.1} |", counts[0], counts[1], matched.square());
        let fitted = matched.fitted(Finish::default())?;
        panels.push(mixed(
            &format!("detail {detail:.0}"),
            format!("K = {} + {}", counts[0], counts[1]),
            0,
            &fitted,
        )?);
        rows.push(matched);
    }
    let few: Vec<Point> = points.iter().step_by(4).copied().collect();
    let figure = figure("A contour of 2,714 points, simplified more and more", &[few], &panels, 4, 880.0);
    Ok((rows, Shown { figure, table }))
}
