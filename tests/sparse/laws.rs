//! Sparse fits obey the laws of their problem: prices, rotations, scales, weights, warm starts; and nothing breaks
//! them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::contours::contour;
use expline::fit::admm::Admm;
use expline::fit::certificate::verify;
use expline::fit::{
    Ask, Norm, Options, Problem, Settings, Solution, Solver, Status, fit, lambda_max, lambda_of_detail,
    uniform_grid,
};
use expline::numerics::Vector;

fn solve(problem: &Problem, gap: f64) -> (Solver, Solution) {
    let mut solver = Solver::new(problem, Settings { gap, most_iterations: 100 }).expect("a good problem");
    let _ = solver.run().expect("memory");
    let solution = solver.solution().expect("memory");
    (solver, solution)
}

fn uniform(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

fn turned(points: &[Vector], degrees: f64) -> Vec<Vector> {
    let (s, c) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
    points.iter().map(|p| Vector::new(c * p.x - s * p.y, s * p.x + c * p.y)).collect()
}

#[test]
fn no_knot_is_left_from_lambda_max_on_and_some_just_below() {
    for (name, closed, size) in [("heart120", true, 120), ("open300_snr45", false, 299)] {
        let points = contour(name);
        for degree in 1..=3 {
            let mut problem = Problem::of_points(&points, closed, &[(degree, 1.0, size)]).expect("good");
            let most = lambda_max(&problem).expect("good")[0];
            problem.components[0].lambda = 1.01 * most;
            let (_, solution) = solve(&problem, 1e-9);
            assert_eq!(solution.knot_count(), 0, "{name}, degree {degree}: above");
            assert!(verify(&problem, &solution).expect("good").gap < 1e-9, "{name}, degree {degree}: proved");
            problem.components[0].lambda = 0.99 * most;
            let (_, solution) = solve(&problem, 1e-9);
            // The jumps of a closed curve sum to zero: there are two knots at least.
            assert!(solution.knot_count() > usize::from(closed), "{name}, degree {degree}: below");
        }
    }
}

#[test]
fn a_circle_has_the_lambda_max_that_the_scale_of_smoothing_is_made_of() {
    let count = 720;
    let circle: Vec<Vector> = (0..count)
        .map(|m| {
            let angle = core::f64::consts::TAU * f64::from(m) / f64::from(count);
            Vector::new(50.0 * libm::cos(angle), 50.0 * libm::sin(angle))
        })
        .collect();
    for degree in 1..=3 {
        let problem = Problem::of_points(&circle, true, &[(degree, 1.0, 720)]).expect("good");
        let found = lambda_max(&problem).expect("good")[0];
        let scale = lambda_of_detail(&problem, degree, f64::from(count));
        // The sum over 720 samples is the integral to (π/720)² times a small number.
        assert!((found / scale - 1.0).abs() < 1e-4, "degree {degree}: {found} {scale}");
    }
}

#[test]
fn a_rotation_of_the_points_rotates_the_curve_and_keeps_every_knot() {
    let points = contour("polygon488_snr47");
    let optimum = |degrees: f64, norm: Norm| {
        let mut problem =
            Problem::of_points(&turned(&points, degrees), true, &[(1, 700.0, 256)]).expect("good");
        problem.norm = norm;
        solve(&problem, 1e-9).1
    };
    let straight = optimum(0.0, Norm::L2);
    for degrees in [40.0, 77.7, 180.0] {
        let other = optimum(degrees, Norm::L2);
        assert_eq!(other.components[0].knots, straight.components[0].knots, "the same knots at {degrees}°");
        assert!(
            (other.objective / straight.objective - 1.0).abs() < 1e-11,
            "the same objective at {degrees}°"
        );
    }
    // The paper's comparison: with |x| + |y| the knots depend on the frame.
    let (straight, other) = (optimum(0.0, Norm::L1), optimum(40.0, Norm::L1));
    assert_ne!(other.components[0].knots, straight.components[0].knots, "other knots in another frame");
}

#[test]
fn a_smoothing_means_the_same_however_the_drawing_is_turned() {
    // Round a square, a box grows most when it is turned: by 1.41.
    let side = |k: usize| {
        let x = (k % 20) as f64 - 10.0;
        [Vector::new(x, -10.0), Vector::new(10.0, x), Vector::new(-x, 10.0), Vector::new(-10.0, -x)][k / 20]
    };
    let square: Vec<Vector> = (0..80).map(side).collect();
    let options = Options { degrees: vec![3], ..Options::default() };
    for points in [square.clone(), contour("polygon488_snr47")] {
        let asked = |degrees: f64| {
            fit(&turned(&points, degrees), Ask::Smoothing(0.4), &options).expect("it can be fitted")
        };
        let scale = |degrees: f64| {
            let problem = Problem::of_points(&turned(&points, degrees), true, &[(3, 1.0, 80)]).expect("good");
            lambda_of_detail(&problem, 3, 10.0)
        };
        let straight = asked(0.0);
        for degrees in [18.0, 45.0, 77.7] {
            let other = asked(degrees);
            // Coordinates are rounded as they are turned, to 2e-16 of where they are.
            assert!((other.lambda[0] / straight.lambda[0] - 1.0).abs() < 1e-13, "λ at {degrees}°");
            assert!((scale(degrees) / scale(0.0) - 1.0).abs() < 1e-13, "the scale of λ at {degrees}°");
            // Of a square without noise several sets of knots are as good.
            if points.len() > square.len() {
                assert_eq!(other.knots.len(), straight.knots.len(), "knots at {degrees}°");
            }
        }
    }
}

#[test]
fn a_warm_start_ends_where_a_cold_one_does() {
    let points = contour("polygon488_snr47");
    for splines in [&[(1, 300.0, 488)][..], &[(3, 4000.0, 244)], &[(1, 600.0, 122), (3, 2e5, 122)]] {
        let problem = Problem::of_points(&points, true, splines).expect("good");
        let (mut solver, _) = solve(&problem, 1e-8);
        for factor in [1.05, 1.3, 0.9, 3.0, 0.1] {
            let lambdas: Vec<f64> = splines.iter().map(|(_, lambda, _)| lambda * factor).collect();
            solver.set_lambdas(&lambdas).expect("good");
            let _ = solver.run().expect("memory");
            let warm = solver.solution().expect("memory");
            let mut problem = problem.clone();
            for (component, lambda) in problem.components.iter_mut().zip(&lambdas) {
                component.lambda = *lambda;
            }
            let (_, cold) = solve(&problem, 1e-8);
            assert!((warm.objective / cold.objective - 1.0).abs() < 2e-8, "λ × {factor}: the same optimum");
            assert!(verify(&problem, &warm).expect("good").gap < 1e-7, "λ × {factor}: proved");
        }
    }
    let problem = Problem::of_points(&points, true, &[(1, 300.0, 488)]).expect("good");
    let (mut solver, _) = solve(&problem, 1e-6);
    assert_eq!(solver.set_lambdas(&[-1.0]).expect_err("negative").code(), "E_RANGE");
    assert_eq!(solver.set_lambdas(&[1.0, 1.0]).expect_err("too many").code(), "E_LENGTH");
}

#[test]
fn scaling_points_and_prices_scales_the_curve() {
    let heart = contour("heart120");
    let fit = |scale: f64, degree: usize, lambda: f64| {
        let scaled: Vec<Vector> = heart.iter().map(|p| p * scale).collect();
        let problem = Problem::of_points(&scaled, true, &[(degree, lambda * scale, 60)]).expect("good");
        solve(&problem, 1e-9).1
    };
    for (degree, lambda) in [(1, 100.0), (3, 3000.0)] {
        let one = fit(1.0, degree, lambda);
        for scale in [1e-12, 1e-6, 1e6] {
            let other = fit(scale, degree, lambda);
            assert_eq!(other.components[0].knots, one.components[0].knots, "scale {scale:e}");
            assert!(
                (other.objective / (scale * scale) / one.objective - 1.0).abs() < 1e-9,
                "scale {scale:e}"
            );
        }
    }
}

#[test]
fn a_weight_counts_points_and_many_points_per_place_change_nothing() {
    // 40 samples in each step of the grid are replaced by four inside; a certificate on the samples themselves says
    // whether that was right. Twice each sample is the weight two.
    let mut seed = 3;
    let count = 4800;
    let contour: Vec<Vector> = (0..count)
        .map(|m| {
            let angle = core::f64::consts::TAU * f64::from(m) / f64::from(count);
            let radius = 100.0 + 20.0 * libm::cos(3.0 * angle) + uniform(&mut seed);
            Vector::new(radius * libm::cos(angle), radius * libm::sin(angle))
        })
        .collect();
    for (degree, closed) in [(1, true), (3, true), (3, false), (2, true)] {
        let mut problem = Problem::of_points(&contour, closed, &[(degree, 1.0, 120)]).expect("good");
        problem.components[0].lambda = lambda_of_detail(&problem, degree, 300.0);
        let (_, solution) = solve(&problem, 1e-8);
        let proof = verify(&problem, &solution).expect("good");
        assert!(proof.gap < 1e-8, "degree {degree}: {:e}", proof.gap);
        assert!(
            (proof.objective / solution.objective - 1.0).abs() < 1e-11,
            "degree {degree}: the same objective"
        );
        let mut heavy = problem.clone();
        heavy.weights = vec![2.0; count as usize];
        heavy.components[0].lambda *= 2.0;
        let (_, twice) = solve(&heavy, 1e-8);
        assert_eq!(
            twice.components[0].knots, solution.components[0].knots,
            "weights and λ twice: the same curve"
        );
    }
}

#[test]
fn planted_corners_are_found_where_they_are() {
    let corners = [(0.0, 0.0), (90.0, 10.0), (70.0, 60.0), (95.0, 110.0), (20.0, 80.0)];
    let mut contour = Vec::new();
    for (i, &(x, y)) in corners.iter().enumerate() {
        let (p, q) = (Vector::new(x, y), corners[(i + 1) % corners.len()]);
        let q = Vector::new(q.0, q.1);
        contour.extend((0..30).map(|k| p + (q - p) * (f64::from(k) / 30.0)));
    }
    let problem = Problem::of_points(&contour, true, &[(1, 1e-3, 150)]).expect("good");
    let (solver, solution) = solve(&problem, 1e-9);
    assert_eq!(solver.status(), Status::Converged, "clean data are no harder");
    // A price, however low, rounds a corner by a sample on either side.
    for knot in &solution.components[0].knots {
        let off = (knot / 30.0 - (knot / 30.0).round()).abs() * 30.0;
        assert!(off < 1.5, "{knot} is at a corner");
    }
    for corner in [0.0, 30.0, 60.0, 90.0, 120.0] {
        let at = solution.components[0].knots.iter().position(|knot| (knot - corner).abs() < 0.5);
        let jump = at.map_or(0.0, |k| solution.components[0].jumps[k].norm());
        assert!(jump > 0.5, "a corner at {corner}");
    }
}

#[test]
fn the_method_of_the_paper_comes_to_the_same_objective() {
    let heart = contour("heart120");
    for splines in [&[(1, 150.0, 64)][..], &[(2, 400.0, 60)], &[(3, 2000.0, 60)]] {
        let problem = Problem::of_points(&heart, true, splines).expect("good");
        let (_, solution) = solve(&problem, 1e-9);
        let mut admm = Admm::new(&problem).expect("good");
        for _ in 0..3000 {
            admm.step();
        }
        let excess = admm.objective() / solution.objective - 1.0;
        assert!((-1e-10..1e-3).contains(&excess), "{splines:?}: {excess:e} above ours");
    }
}

#[test]
fn the_method_of_the_paper_does_not_lose_itself_between_two_components() {
    let kinked = contour("kinked560_px");
    let splines = [(1, 2000.0, 140), (3, 5e6, 140)];
    let problem = Problem::of_points(&kinked, true, &splines).expect("good");
    let (_, solution) = solve(&problem, 1e-7);
    let mut admm = Admm::new(&problem).expect("good");
    for _ in 0..1500 {
        admm.step();
        let above = admm.objective() / solution.objective;
        assert!(above < 1e3, "{above:e} times ours after {} iterations", admm.iterations());
    }
    let excess = admm.objective() / solution.objective - 1.0;
    assert!((-1e-7..1e-2).contains(&excess), "{excess:e} above ours");
}

/// Runs a problem that nobody would pose; whatever it is, the answer is finite and comes.
fn survives(problem: &Problem, what: &str) {
    let mut solver = Solver::new(problem, Settings { gap: 1e-6, most_iterations: 60 }).expect(what);
    let _ = solver.run().expect(what);
    assert!(solver.iterations() <= 60, "{what}: ends");
    let solution = solver.solution().expect(what);
    let numbers = [solution.objective, solution.data_term, solution.gap];
    assert!(numbers.iter().all(|v| v.is_finite()), "{what}: {numbers:?}");
    let curve = solution.evaluate(&problem.parameters, 0).expect(what);
    assert!(curve.iter().all(|p| p.x.is_finite() && p.y.is_finite()), "{what}: the curve is finite");
    let proof = verify(problem, &solution).expect(what);
    assert!(proof.objective.is_finite() && !proof.gap.is_nan(), "{what}: {proof:?}");
}

#[test]
fn nothing_hangs_traps_or_gives_what_is_no_number() {
    let mut seed = 19;
    let mut random = |count: usize, size: f64, around: f64| -> Vec<Vector> {
        (0..count)
            .map(|_| Vector::new(around + size * uniform(&mut seed), around + size * uniform(&mut seed)))
            .collect()
    };
    let clouds = [
        ("noise", random(40, 1.0, 0.0)),
        ("tiny and far", random(40, 1e-12, 1e6)),
        ("huge", random(40, 9e8, 0.0)),
        ("one point", vec![Vector::new(7.0, 7.0); 40]),
        ("back and forth", (0..40).map(|i| Vector::new(f64::from(20 - (20_i32 - i).abs()), 0.0)).collect()),
        ("held still", (0..40).map(|i| Vector::new(f64::from((i - 30_i32).max(0)), 1.0)).collect()),
        ("an outlier", (0..40).map(|i| Vector::new(if i == 9 { 1e9 } else { f64::from(i) }, 2.0)).collect()),
    ];
    for (name, cloud) in &clouds {
        for closed in [false, true] {
            for splines in
                [&[(1, 1.0, 40)][..], &[(3, 1.0, 20)], &[(5, 1.0, 40)], &[(1, 1.0, 40), (3, 1.0, 40)]]
            {
                for lambda in [0.0, 1e-12, 1.0, 1e12] {
                    let mut problem = Problem::of_points(cloud, closed, splines).expect("well formed");
                    for component in &mut problem.components {
                        component.lambda = lambda;
                    }
                    survives(&problem, &format!("{name}, closed {closed}, {splines:?}, λ = {lambda:e}"));
                }
            }
        }
    }
}

#[test]
fn parameters_may_meet_and_cluster() {
    let mut seed = 23;
    for round in 0..12 {
        let count = 30;
        let mut t: Vec<f64> = (0..count).map(|_| 10.0 * uniform(&mut seed)).collect();
        if round % 2 == 0 {
            for i in (1..count).step_by(2) {
                t[i] = t[i - 1] + 1e-13 * f64::from(round);
            }
        }
        t.sort_by(f64::total_cmp);
        let cloud: Vec<Vector> = t.iter().map(|t| Vector::new(libm::cos(*t), libm::sin(2.0 * t))).collect();
        for degree in [1, 2, 3] {
            let mut problem = Problem::of_points(&cloud, false, &[(degree, 0.01, 30)]).expect("good");
            problem.parameters.clone_from(&t);
            (problem.start, problem.end) = (0.0, 10.0);
            problem.components[0].grid = uniform_grid(degree, 57, 0.0, 10.0, false);
            problem.check().expect("equal parameters are allowed");
            survives(&problem, "clustered parameters");
        }
    }
}

#[test]
fn problems_that_cannot_be_posed_are_refused_by_name() {
    let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Vector::new(x, y));
    let refused = |change: &dyn Fn(&mut Problem)| {
        let mut problem = Problem::of_points(&square, true, &[(1, 1.0, 4)]).expect("good");
        change(&mut problem);
        let error = Solver::new(&problem, Settings::default()).expect_err("bad");
        (error.code(), error.argument().unwrap_or(""))
    };
    assert_eq!(refused(&|p| p.components[0].lambda = -1.0), ("E_RANGE", "lambda"));
    assert_eq!(refused(&|p| p.components[0].lambda = 1e300), ("E_RANGE", "lambda"));
    assert_eq!(refused(&|p| p.components[0].lambda = f64::NAN), ("E_NOT_FINITE", "lambda"));
    assert_eq!(refused(&|p| p.components[0].degree = 6), ("E_RANGE", "degree"));
    assert_eq!(refused(&|p| p.points[1].x = f64::INFINITY), ("E_NOT_FINITE", "points"));
    assert_eq!(refused(&|p| p.points[1].x = 2e9), ("E_RANGE", "points"));
    assert_eq!(refused(&|p| p.parameters[1] = 3.5), ("E_DEGENERATE", "parameters"));
    assert_eq!(refused(&|p| p.parameters.truncate(3)), ("E_LENGTH", "parameters"));
    assert_eq!(refused(&|p| p.parameters.fill(0.5)), ("E_TOO_FEW_POINTS", "points"));
    assert_eq!(refused(&|p| p.weights = vec![1.0, 0.0, 1.0, 1.0]), ("E_RANGE", "weights"));
    assert_eq!(refused(&|p| p.components[0].grid.swap(0, 1)), ("E_DEGENERATE", "grid"));
    assert_eq!(refused(&|p| p.components.clear()), ("E_LENGTH", "components"));
    let few = Problem::of_points(&square[..1], true, &[(1, 1.0, 4)]).expect_err("one point");
    assert_eq!(few.code(), "E_TOO_FEW_POINTS");
    let fine = Problem::of_points(&square, true, &[(1, 1.0, 10_000_000)]).expect_err("a grid without end");
    assert_eq!(fine.code(), "E_LIMIT");
}
