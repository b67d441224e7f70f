//! Sparse fits reach the optimum: golden objectives, errors, knots and curves, each with a gap proved by the
//! certificate.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::golden;
use expline::fit::certificate::verify;
use expline::fit::{Norm, Problem, Settings, Solution, Solver, Status};
use expline::numerics::Vector;
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Deserialize)]
struct Case {
    name: String,
    source: String,
    closed: bool,
    norm: String,
    degrees: Vec<usize>,
    lambdas: Vec<f64>,
    grid: Vec<usize>,
    objective: f64,
    qfe: f64,
    regularizers: Vec<f64>,
    knots: Vec<Vec<f64>>,
    jumps: Vec<Vec<f64>>,
    curve_t: Vec<f64>,
    curve_xy: Vec<f64>,
    loose: Vec<Vec<f64>>,
}

#[derive(Deserialize)]
struct Golden {
    sets: BTreeMap<String, Vec<f64>>,
    cases: Vec<Case>,
}

fn golden_data() -> Golden {
    golden::parse(include_str!("../golden/sparse/grid.json"))
}

fn vectors(values: &[f64]) -> Vec<Vector> {
    values.chunks_exact(2).map(|v| Vector::new(v[0], v[1])).collect()
}

fn problem(case: &Case, points: &[Vector]) -> Problem {
    let splines: Vec<(usize, f64, usize)> =
        (0..case.degrees.len()).map(|i| (case.degrees[i], case.lambdas[i], case.grid[i])).collect();
    let mut problem =
        Problem::of_points(points, case.closed, &splines).expect("golden problems can be posed");
    problem.norm = if case.norm == "l1" { Norm::L1 } else { Norm::L2 };
    problem
}

fn solved(problem: &Problem, gap: f64) -> Solution {
    let mut solver = Solver::new(problem, Settings { gap, most_iterations: 100 }).expect("a good problem");
    assert_eq!(solver.run().expect("memory"), Status::Converged, "the run ends at gap {:e}", solver.gap());
    solver.solution().expect("memory")
}

#[test]
fn golden_problems_are_solved_and_the_certificate_proves_it() {
    let golden = golden_data();
    for case in &golden.cases {
        let problem = problem(case, &vectors(&golden.sets[&case.source]));
        let solution = solved(&problem, 5e-9);
        // The conic solver of the optima is good to 1e-9, and to 1e-7 where it says "almost"; the others to 1e-15.
        let most = if case.loose.is_empty() { 1e-12 } else { 1e-7 };
        let error = solution.objective / case.objective - 1.0;
        assert!(error.abs() < most, "{}: objective off by {error:e}", case.name);
        let qfe = solution.quadratic_fitting_error(&problem);
        assert!(
            (qfe / case.qfe - 1.0).abs() < if case.loose.is_empty() { 1e-9 } else { 1e-3 },
            "{}",
            case.name
        );
        let proof = verify(&problem, &solution).expect("a solution of this problem");
        let off = (proof.objective / solution.objective - 1.0).abs();
        assert!(off < 1e-13, "{}: the same objective, but for {off:e}", case.name);
        let most = if case.degrees.len() > 1 { 1e-8 } else { 1e-10 };
        assert!(proof.gap < most && proof.gap > -1e-12, "{}: proved gap {:e}", case.name, proof.gap);
    }
}

#[test]
fn a_certificate_promises_no_more_than_is_true_however_early_a_run_stops() {
    let golden = golden_data();
    for case in &golden.cases {
        let problem = problem(case, &vectors(&golden.sets[&case.source]));
        // How well the optimum is known, as above.
        let known = if case.loose.is_empty() { 1e-12 } else { 1e-7 };
        for asked in [0.3, 1e-2, 1e-5] {
            let solution = solved(&problem, asked);
            let proof = verify(&problem, &solution).expect("a solution of this problem");
            let share = (proof.objective - proof.bound) / proof.objective;
            assert!(
                (proof.gap - share).abs() <= 1e-14,
                "{}: a gap of {:e} is {share:e}",
                case.name,
                proof.gap
            );
            let above = proof.bound / case.objective - 1.0;
            assert!(above <= known, "{}, {asked}: the bound is {above:e} above the optimum", case.name);
            let below = solution.objective / case.objective - 1.0;
            assert!(below >= -known, "{}, {asked}: the objective is {below:e} of the optimum's", case.name);
        }
    }
}

#[test]
fn knots_are_exactly_where_the_optimum_has_them() {
    let golden = golden_data();
    for case in golden.cases.iter().filter(|case| case.loose.is_empty()) {
        let solution = solved(&problem(case, &vectors(&golden.sets[&case.source])), 5e-9);
        for (i, spline) in solution.components.iter().enumerate() {
            let mut expected: Vec<(f64, Vector)> =
                case.knots[i].iter().copied().zip(vectors(&case.jumps[i])).collect();
            expected.sort_by(|a, b| a.0.total_cmp(&b.0));
            assert_eq!(spline.knots.len(), expected.len(), "{}: number of knots", case.name);
            let largest = expected.iter().fold(0.0_f64, |most, (_, jump)| most.max(jump.norm()));
            for ((knot, jump), (t, expected)) in spline.knots.iter().zip(&spline.jumps).zip(&expected) {
                assert!((knot - t).abs() < 1e-9, "{}: knot {knot} for {t}", case.name);
                assert!(
                    (jump - expected).norm() < 1e-6 * largest,
                    "{}: jump {jump} for {expected}",
                    case.name
                );
            }
            assert!((solution.regularizers[i] / case.regularizers[i] - 1.0).abs() < 1e-8, "{}", case.name);
        }
        let curve = solution.evaluate(&case.curve_t, 0).expect("spaces");
        for (found, expected) in curve.iter().zip(vectors(&case.curve_xy)) {
            assert!((found - expected).norm() < 1e-6, "{}: {found} for {expected}", case.name);
        }
    }
}

#[test]
fn the_conic_solvers_knots_are_found_too() {
    let golden = golden_data();
    for case in golden.cases.iter().filter(|case| !case.loose.is_empty() && case.norm == "l2") {
        let problem = problem(case, &vectors(&golden.sets[&case.source]));
        let solution = solved(&problem, 5e-9);
        for (spline, loose) in solution.components.iter().zip(&case.loose) {
            // Its list has what is above 1e-5 of the largest: every true knot, and some that are zero.
            for knot in &spline.knots {
                let near = loose.iter().any(|t| (t - knot).abs() < 1e-6);
                let jump = spline.jumps[spline.knots.iter().position(|k| k == knot).unwrap_or(0)].norm();
                let largest = spline.jumps.iter().fold(0.0_f64, |most, j| most.max(j.norm()));
                assert!(near || jump < 2e-5 * largest, "{}: a knot at {knot}", case.name);
            }
        }
    }
}
