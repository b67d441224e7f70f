//! Jumps measured by |x| + |y|: objective and gap are those of the curve that comes out, whatever is fitted.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::fit::certificate::verify;
use expline::fit::{Ask, Finish, Fit, FitStatus, Options, fit};
use expline::fit::{
    Norm, Problem, Settings, Solution, Solver, Status, detail_of_smoothing, lambda_of_detail,
};
use expline::numerics::Vector;

/// Evenly distributed numbers in [0, 1), the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// About normally distributed, of variance 1: the sum of twelve.
    fn noise(&mut self) -> f64 {
        (0..12).map(|_| self.next()).sum::<f64>() - 6.0
    }
}

fn points(random: &mut Random, count: usize, closed: bool) -> Vec<Vector> {
    let (waves, depth, noise) = (2.0 + (random.next() * 5.0).floor(), 0.3 * random.next(), random.next());
    let turn = if closed { core::f64::consts::TAU } else { 4.0 };
    let place = |m: usize| {
        let angle = turn * m as f64 / count as f64;
        let radius = 1.0 + depth * (waves * angle).cos();
        Vector::new(100.0 * radius * angle.cos(), 60.0 * radius * angle.sin())
    };
    (0..count).map(|m| place(m) + Vector::new(noise * random.noise(), noise * random.noise())).collect()
}

fn problem(points: &[Vector], closed: bool, degrees: &[usize], smoothing: f64) -> Problem {
    let unknown: Vec<_> = degrees.iter().map(|&degree| (degree, 1.0, points.len().max(degree + 2))).collect();
    let mut problem = Problem::of_points(points, closed, &unknown).expect("enough points");
    let detail = detail_of_smoothing(&problem, smoothing);
    for i in 0..degrees.len() {
        // The first of two a little shorter, so that both have knots.
        let own = if i + 1 < degrees.len() { detail / 4.0 } else { detail };
        problem.components[i].lambda = lambda_of_detail(&problem, degrees[i], own);
    }
    problem
}

fn solved(problem: &Problem, norm: Norm, gap: f64) -> Solution {
    let problem = Problem { norm, ..problem.clone() };
    let mut solver = Solver::new(&problem, Settings { gap, most_iterations: 120 }).expect("a good problem");
    solver.run().expect("memory");
    solver.solution().expect("memory")
}

/// What a curve costs by |x| + |y|: the data term that it says, and its jumps.
fn cost(solution: &Solution) -> f64 {
    let price = |s: &expline::fit::Spline| {
        s.lambda * s.jumps.iter().map(|jump| jump.x.abs() + jump.y.abs()).sum::<f64>()
    };
    solution.data_term + solution.components.iter().map(price).sum::<f64>()
}

#[test]
fn what_a_fit_by_coordinates_says_of_its_curve_is_true_of_it() {
    let mut random = Random(5);
    let all: [&[usize]; 8] = [&[1], &[2], &[3], &[4], &[5], &[1, 2], &[1, 3], &[2, 3]];
    for round in 0..12 {
        for degrees in all {
            for closed in [true, false] {
                let count = 20 + (random.next() * 180.0) as usize;
                let points = points(&mut random, count, closed);
                let smoothing = 0.1 + 0.9 * random.next();
                let mut problem = problem(&points, closed, degrees, smoothing);
                let asked = if round % 4 == 3 { 1e-9 } else { 1e-6 };
                let (own, other) = (solved(&problem, Norm::L1, asked), solved(&problem, Norm::L2, asked));
                let what = format!("degrees {degrees:?}, closed {closed}, {count} points, {smoothing:.3}");
                assert_eq!(own.status, Status::Converged, "{what}: gap {:e}", own.gap);
                assert!(own.gap <= asked, "{what}: converged with a gap of {:e}", own.gap);
                // By de Boor's rule from the coefficients: 1e-11 of a jump is what differences of degree 5 leave of
                // them.
                problem.norm = Norm::L1;
                let proof = verify(&problem, &own).expect("a solution of this problem");
                let off = (proof.objective / own.objective - 1.0).abs();
                assert!(
                    off < 1e-9,
                    "{what}: the curve costs {:e} instead of {:e}",
                    proof.objective,
                    own.objective
                );
                let off = (cost(&own) / own.objective - 1.0).abs();
                assert!(off < 1e-12, "{what}: so it says itself, but for {off:e}");
                // The residuals' rounding, integrated up to six times, loosens the bound: on true knots 1e-5 is the
                // most seen. A curve of degree 4 or 5, or of two, with other knots than these may prove little of
                // itself: the optimum is proved.
                let finer = solved(&problem, Norm::L1, 1e-10);
                if matches!(degrees, [1..=3]) || own.knot_count() == finer.knot_count() {
                    assert!(proof.gap < 2.0 * asked + 1e-4, "{what}: proved {:e}", proof.gap);
                }
                let proof = verify(&problem, &finer).expect("a solution of this problem");
                assert!(proof.gap < 1e-7, "{what}: the optimum is proved {:e}", proof.gap);
                let above = own.objective / finer.objective - 1.0;
                assert!(above < asked, "{what}: {above:e} above what is proved to be the optimum");
                // |x| + |y| is at least the length, so no optimum by it is below that by length, nor above what the
                // curve of that one costs.
                let (least, most) = (other.objective * (1.0 - other.gap), cost(&other) * (1.0 + own.gap));
                let rounding = 1e-12 * own.objective;
                assert!(own.objective >= least - rounding, "{what}: {:e} below {least:e}", own.objective);
                assert!(own.objective <= most + rounding, "{what}: {:e} above {most:e}", own.objective);
                let none = own.components.iter().flat_map(|s| &s.jumps).any(|j| j.x == 0.0 && j.y == 0.0);
                assert!(!none, "{what}: every knot jumps");
            }
        }
    }
}

#[test]
fn a_coordinate_in_which_all_points_are_one_stays_so() {
    let mut random = Random(9);
    for degree in 1..=5 {
        for closed in [true, false] {
            let flat: Vec<Vector> =
                points(&mut random, 90, closed).iter().map(|p| Vector::new(p.x, 7.0)).collect();
            let problem = problem(&flat, closed, &[degree], 0.5);
            let (own, other) = (solved(&problem, Norm::L1, 1e-7), solved(&problem, Norm::L2, 1e-7));
            assert_eq!(own.status, Status::Converged, "degree {degree}");
            let off = (own.objective / other.objective - 1.0).abs();
            assert!(off <= 2e-7, "degree {degree}: on a line both norms are one, but {off:e}");
            let level = own.components[0].coefficients.iter().all(|c| (c.y - 7.0).abs() < 1e-12);
            assert!(
                level && own.components[0].jumps.iter().all(|j| j.y == 0.0),
                "degree {degree}: it is level"
            );
        }
    }
}

#[test]
fn another_price_by_coordinates_ends_where_a_new_run_does() {
    let mut random = Random(3);
    for degree in [1, 3] {
        let points = points(&mut random, 150, true);
        let mut problem = problem(&points, true, &[degree], 0.5);
        problem.norm = Norm::L1;
        let settings = Settings { gap: 1e-8, most_iterations: 120 };
        let mut solver = Solver::new(&problem, settings).expect("a good problem");
        solver.run().expect("memory");
        let first = problem.components[0].lambda;
        for factor in [0.5, 1.1, 0.0, 3.0] {
            problem.components[0].lambda = first * factor;
            solver.set_lambdas(&[first * factor]).expect("a good λ");
            solver.run().expect("memory");
            let (warm, cold) = (solver.solution().expect("memory"), solved(&problem, Norm::L1, 1e-8));
            let off = (warm.objective - cold.objective).abs();
            // Below 1e-20 of the drawing's square both go through the points.
            assert!(off <= 2e-8 * cold.objective + 1e-16, "{degree}, {factor}: objectives differ by {off:e}");
        }
    }
}

fn ellipse(noise: f64) -> Vec<Vector> {
    let mut random = Random(1);
    let place = |m: usize| core::f64::consts::TAU * m as f64 / 200.0;
    (0..200)
        .map(|m| {
            let off = Vector::new(noise * random.noise(), noise * random.noise());
            Vector::new(100.0 * place(m).cos(), 60.0 * place(m).sin()) + off
        })
        .collect()
}

fn smoothed(norm: Norm, finish: Finish) -> Fit {
    let options = Options { degrees: vec![3], closed: Some(true), norm, finish, ..Options::default() };
    fit(&ellipse(0.5), Ask::Smoothing(0.7), &options).expect("an ellipse can be fitted")
}

#[test]
fn a_smoothed_ellipse_has_as_few_knots_by_coordinates_as_by_length() {
    let (own, other) = (smoothed(Norm::L1, Finish::default()), smoothed(Norm::L2, Finish::default()));
    assert_eq!(own.status, FitStatus::Converged, "gap {:e}", own.gap);
    // Two coordinates have knots of their own: up to twice as many.
    assert!(own.knots.len() <= 2 * other.knots.len(), "{} for {}", own.knots.len(), other.knots.len());
    let price: f64 = own.knots.iter().map(|k| own.lambda[0] * (k.jump.x.abs() + k.jump.y.abs())).sum();
    // Jumps of the curve itself: differences of cubics in double precision.
    assert!((price / own.regularizer - 1.0).abs() < 1e-8, "{price:e} for {:e}", own.regularizer);
    assert!(own.objective >= other.objective * (1.0 - 1e-6), "{:e} < {:e}", own.objective, other.objective);
}
