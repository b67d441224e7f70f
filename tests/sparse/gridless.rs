//! Knots off the grid: the optimum of the continuous problem, certified on the continuum.
#![cfg(not(target_arch = "wasm32"))]

use crate::support::contours::contour;
use crate::support::golden;
use expline::fit::certificate::verify;
use expline::fit::gridless::gridless;
use expline::fit::{Ask, Finish, FitStatus, Knot, Norm, Options, Problem, Settings, Solver, fit};
use expline::numerics::Point;
use serde::Deserialize;
#[derive(Deserialize)]
struct Continuous {
    name: String,
    source: String,
    closed: bool,
    degree: usize,
    lam: f64,
    upper: f64,
    lower: f64,
    knots: Vec<f64>,
}

#[test]
fn three_slides_certify_the_continuous_optimum() {
    let cases: Vec<Continuous> = golden::parse(include_str!("../golden/sparse/continuous.json"));
    assert_eq!(cases.len(), 4, "all problems are there");
    for case in cases {
        let points = contour(&case.source);
        let steps = if case.closed { points.len() } else { points.len() - 1 };
        let problem = Problem::of_points(&points, case.closed, &[(case.degree, case.lam, steps)])
            .expect("the problem is fine");
        let settings = Settings { gap: 1e-8, most_iterations: 200 };
        let mut solver = Solver::new(&problem, settings).expect("the problem is fine");
        solver.run().expect("there is memory");
        let solution = solver.solution().expect("there is memory");
        let found = gridless(&problem, &solution, 1e-4, 3).expect("the problem is fine");
        assert!(found.gap <= 1e-4, "{}: gap {:e} after {} slides", case.name, found.gap, found.slides);
        let bound = case.upper * (1.0 + 1e-4);
        assert!(found.solution.objective <= bound, "{}: {}", case.name, found.solution.objective);
        // Nothing is better than the certified bound of the reference.
        let least = case.lower * (1.0 - 1e-9);
        assert!(found.solution.objective >= least, "{}: {}", case.name, found.solution.objective);
        let (got, expected) = (found.solution.knot_count(), case.knots.len());
        assert!(got.abs_diff(expected) <= 1, "{}: {got} knots for {expected}", case.name);
    }
}

/// A regular hexagon, `side` points on each side; its corners lie in the middle between two points.
fn hexagon(side: usize) -> Vec<Point> {
    let corner = |k: usize| {
        let angle = core::f64::consts::TAU * k as f64 / 6.0;
        Point::new(100.0 * angle.cos(), 100.0 * angle.sin())
    };
    let place = |i: usize| {
        let along = ((i % side) as f64 + 0.5) / side as f64;
        corner(i / side) * (1.0 - along) + corner(i / side + 1) * along
    };
    (0..6 * side).map(place).collect()
}

#[test]
fn an_extreme_point_is_as_good_with_no_more_knots_than_points_can_tell_apart() {
    let points = hexagon(8);
    for norm in [Norm::L2, Norm::L1] {
        // Four places between two points: where a corner is a jump at several of them is as good as at one or two.
        let mut problem =
            Problem::of_points(&points, true, &[(1, 30.0, 4 * points.len())]).expect("it is fine");
        problem.norm = norm;
        let mut solver =
            Solver::new(&problem, Settings { gap: 1e-7, most_iterations: 200 }).expect("the problem is fine");
        solver.run().expect("there is memory");
        let (any, extreme) = (solver.solution().expect("memory"), solver.extreme().expect("memory"));
        assert!(extreme.knot_count() <= any.knot_count(), "{} of {}", extreme.knot_count(), any.knot_count());
        let off = (extreme.objective / any.objective - 1.0).abs();
        assert!(off <= 1e-8, "{norm:?}: the objective changed by {off:e} of it");
        let proof = verify(&problem, &extreme).expect("the problem is fine");
        assert!(proof.gap <= 1e-6, "{norm:?}: certified {:e}", proof.gap);
        for m in 0..points.len() {
            let between = |t: &&f64| (m as f64..(m + 1) as f64).contains(*t);
            let count = extreme.components[0].knots.iter().filter(between).count();
            assert!(count <= 2, "{norm:?}: {count} knots between points {m} and {}", m + 1);
        }
        let (before, after) = (
            any.evaluate(&problem.parameters, 0).expect("inside"),
            extreme.evaluate(&problem.parameters, 0).expect("inside"),
        );
        let moved = before.iter().zip(&after).fold(0.0_f64, |most, (a, b)| most.max((a - b).norm()));
        assert!(moved <= 1e-4, "{norm:?}: the curve at the points moved by {moved:e}");
    }
}

#[test]
fn every_step_after_the_optimum_says_what_it_changed() {
    let points = contour("smooth400_snr45");
    let finish = Finish { extreme: true, merge: true, slide: true, debias: true, prune: false };
    let options = Options { degrees: vec![3], closed: Some(true), finish, ..Options::default() };
    let fitted = fit(&points, Ask::Lambda(vec![5000.0]), &options).expect("it can be fitted");
    let steps: Vec<&str> = fitted.changes.iter().map(|change| change.step).collect();
    assert_eq!(steps, ["extreme", "merge", "slide", "debias"], "in this order");
    let (extreme, merge) = (&fitted.changes[0], &fitted.changes[1]);
    // As many places as points: the optimum is the only one.
    assert_eq!(extreme.knots.0, extreme.knots.1, "nothing can be exchanged");
    assert!(merge.knots.1 < merge.knots.0, "{} of {} knots are left", merge.knots.1, merge.knots.0);
    for pair in fitted.changes.windows(2) {
        assert_eq!(pair[0].knots.1, pair[1].knots.0, "a step begins with what the one before left");
        let off = (pair[0].qfe.1 / pair[1].qfe.0 - 1.0).abs();
        assert!(off <= 1e-9, "the mean square after {} is not that before {}", pair[0].step, pair[1].step);
    }
}

/// A rounded shape of `count` points with some waves, smooth or scattered.
fn waves(random: &mut impl FnMut() -> f64, count: usize, sigma: f64) -> Vec<Point> {
    let (waves, depth) = (1.0 + (5.0 * random()).floor(), 0.4 * random());
    let place = |i: usize| {
        let t = core::f64::consts::TAU * i as f64 / count as f64;
        let radius = 1.0 + depth * (waves * t).cos();
        Point::new(100.0 * radius * t.cos(), 80.0 * radius * t.sin())
    };
    // The sum of twelve is about normal, of variance 1.
    let mut noise = || sigma * ((0..12).map(|_| random()).sum::<f64>() - 6.0);
    (0..count).map(|i| place(i) + Point::new(noise(), noise())).collect()
}

#[test]
fn a_curve_off_the_grid_is_converged_only_where_the_gap_that_it_says_is_the_one_asked_for() {
    let mut state = 7_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut near, mut all) = (0, 0);
    for round in 0..24 {
        for (degree, norm) in [(2, Norm::L2), (3, Norm::L2), (2, Norm::L1), (3, Norm::L1)] {
            let count = 40 + (random() * 160.0) as usize;
            let points = waves(&mut random, count, [0.0, 0.1, 1.0, 3.0][round % 4]);
            let finish = Finish { merge: true, slide: true, ..Finish::default() };
            let closed = Some(round % 2 == 0);
            let options = Options { degrees: vec![degree], closed, finish, norm, ..Options::default() };
            let smoothing = 0.3 + 0.6 * random();
            let fitted = fit(&points, Ask::Smoothing(smoothing), &options).expect("it can be fitted");
            let what = format!("degree {degree}, {norm:?}, {count} points, {smoothing:.3}");
            let reached = fitted.gap <= options.gap;
            assert_eq!(fitted.status == FitStatus::Converged, reached, "{what}: gap {:e}", fitted.gap);
            // What the curve is said to cost is what it costs: jumps of cubics have eight digits.
            let own =
                |k: &Knot| if norm == Norm::L1 { k.jump.x.abs() + k.jump.y.abs() } else { k.jump.norm() };
            let cost = fitted.lambda[0] * fitted.knots.iter().map(own).sum::<f64>() + fitted.data_term;
            assert!((cost / fitted.objective - 1.0).abs() < 1e-7, "{what}: {cost:e}, {:e}", fitted.objective);
            // The optimum on the grid is one of all curves: not below the bound that the gap gives.
            let plain = Options { finish: Finish::default(), ..options.clone() };
            let grid = fit(&points, Ask::Smoothing(smoothing), &plain).expect("it can be fitted");
            let bound = fitted.objective * (1.0 - fitted.gap);
            assert!(grid.objective >= bound * (1.0 - 1e-9), "{what}: {:e} for {bound:e}", grid.objective);
            (near, all) = (near + usize::from(fitted.gap < 1e-2), all + 1);
        }
    }
    // By |x| + |y| all gaps were .25, which is no bound at all.
    assert!(10 * near > 9 * all, "{near} of {all} gaps are below a hundredth");
}
