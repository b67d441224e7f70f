//! Splines on any knots: what they reproduce, where they jump, and that refining never changes them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::fit::KnotSpace;
use expline::numerics::Vector;

/// Numbers in [0, 1) that are the same on every machine.
fn uniform(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

fn coefficients(count: usize, seed: &mut u64) -> Vec<Vector> {
    (0..count).map(|_| Vector::new(uniform(seed) - 0.5, uniform(seed) - 0.5)).collect()
}

/// Spaces of all degrees, open and closed, on no, few and many knots of very uneven distance.
fn spaces() -> Vec<KnotSpace> {
    let mut seed = 7;
    let mut spaces = Vec::new();
    for degree in 1..=5 {
        for count in [0, 1, 2, 3, 5, 12] {
            let mut knots: Vec<f64> = (0..count)
                .map(|k| 2.0 + 8.0 * (k as f64 + 0.1 + 0.85 * uniform(&mut seed)) / count as f64)
                .collect();
            if count > 3 {
                knots[2] = knots[1] + 0.01;
            }
            for closed in [false, true] {
                spaces.push(KnotSpace::new(degree, &knots, 2.0, 10.0, closed).expect("good knots"));
            }
        }
    }
    spaces
}

#[test]
fn the_basis_sums_to_one_and_derivatives_are_differences() {
    for space in spaces() {
        let mut seed = 3;
        let c = coefficients(space.dimension(), &mut seed);
        for i in 0..40 {
            let t = 2.0 + 8.0 * (f64::from(i) + 0.37) / 40.0;
            let (_, basis) = space.basis(t, 0);
            assert!((basis.iter().sum::<f64>() - 1.0).abs() < 1e-13, "partition of unity");
            assert!(basis.iter().all(|b| *b > -1e-15), "no basis function is negative");
            let step = 1e-6;
            let near_knot = (0..space.knot_count()).any(|k| (space.knot(k) - t).abs() < 2.0 * step);
            if !near_knot {
                let difference =
                    (space.evaluate(&c, t + step, 0) - space.evaluate(&c, t - step, 0)) / (2.0 * step);
                let slope = space.evaluate(&c, t, 1);
                // The third derivative is below 1e6 here: knots are 0.01 apart at the least.
                assert!((difference - slope).norm() < 1e-4 * (1.0 + slope.norm()), "{difference} {slope}");
            }
        }
    }
}

#[test]
fn jumps_are_what_one_sided_derivatives_leave() {
    for space in spaces() {
        let mut seed = 5;
        let c = coefficients(space.dimension(), &mut seed);
        let jumps = space.jumps(&c);
        let degree = space.degree();
        if space.is_closed() && space.knot_count() == 1 {
            assert!(jumps[0].norm() < 1e-12, "a closed curve cannot jump once");
        }
        for (k, jump) in jumps.iter().enumerate() {
            let knot = space.knot(k);
            let sides = space.evaluate(&c, knot + 1e-9, degree) - space.evaluate(&c, knot - 1e-9, degree);
            let size = (0..20).map(|i| space.evaluate(&c, 2.0 + 0.4 * f64::from(i), degree).norm());
            let size = size.fold(sides.norm() + 1.0, f64::max);
            assert!((sides - jump).norm() < 1e-9 * size, "degree {degree}, knot {k}: {sides} {jump}");
            for order in 0..degree {
                let gap = space.evaluate(&c, knot + 1e-12, order) - space.evaluate(&c, knot - 1e-12, order);
                assert!(gap.norm() < 1e-9 * size, "derivative {order} is continuous");
            }
        }
    }
}

#[test]
fn a_double_knot_lets_two_derivatives_jump() {
    for degree in 2..=5 {
        for closed in [false, true] {
            let knots = [2.5, 4.0, 4.0, 5.0, 6.5, 6.5, 9.0];
            let space = KnotSpace::new(degree, &knots, 2.0, 10.0, closed).expect("double knots");
            let mut seed = 11;
            let c = coefficients(space.dimension(), &mut seed);
            for k in [1, 4] {
                let (first, weights) = space.jump_weights(k, degree - 1);
                let mut jump = Vector::zeros();
                for (i, weight) in weights.iter().enumerate().take(degree + 1) {
                    jump += c[space.coefficient(first + i)] * *weight;
                }
                let knot = knots[k];
                let sides =
                    space.evaluate(&c, knot, degree - 1) - space.evaluate(&c, knot - 1e-13, degree - 1);
                assert!((sides - jump).norm() < 1e-8 * (1.0 + jump.norm()), "{sides} {jump}");
            }
        }
    }
}

#[test]
fn one_more_knot_never_changes_the_function() {
    for space in spaces() {
        let mut seed = 13;
        let c = coefficients(space.dimension(), &mut seed);
        let (mut finer, mut fine) = (space.clone(), c.clone());
        for knot in [2.3, 9.999, 5.5, 5.500_001, 2.000_1] {
            (finer, fine) = finer.insert(&fine, knot).expect("a new knot");
        }
        for i in 0..60 {
            let t = 2.0 + 8.0 * f64::from(i) / 60.0;
            let error = (space.evaluate(&c, t, 0) - finer.evaluate(&fine, t, 0)).norm();
            assert!(error < 1e-14, "degree {}, {} knots: {error:e}", space.degree(), space.knot_count());
        }
    }
}

#[test]
fn least_squares_finds_the_function_that_was_sampled() {
    for space in spaces() {
        let mut seed = 17;
        let c = coefficients(space.dimension(), &mut seed);
        let parameters: Vec<f64> = (0..400).map(|m| 2.0 + 0.02 * f64::from(m) + 1e-3).collect();
        let weights: Vec<f64> = (0..400).map(|_| 0.5 + uniform(&mut seed)).collect();
        let points: Vec<Vector> = parameters.iter().map(|&t| space.evaluate(&c, t, 0)).collect();
        let mut matrix = space.normal_matrix(&parameters, &weights).expect("small");
        let mut found = space.right_side(&parameters, &weights, &points).expect("small");
        let _ = matrix.factor(1e-13);
        matrix.solve_points(&mut found).expect("small");
        for (m, &t) in parameters.iter().enumerate() {
            let error = (space.evaluate(&found, t, 0) - points[m]).norm();
            // A closed space on few knots may have functions that are no polynomials' basis: the fit is what counts.
            assert!(error < 1e-8, "degree {}, {} knots: {error:e}", space.degree(), space.knot_count());
        }
    }
}

#[test]
fn knots_that_make_no_sense_are_refused_by_name() {
    let new = |knots: &[f64], closed| KnotSpace::new(3, knots, 0.0, 1.0, closed);
    for knots in [&[0.5, 0.4][..], &[1.0], &[-0.1], &[0.2, 0.2, 0.2, 0.2]] {
        for closed in [false, true] {
            let error = new(knots, closed).expect_err("bad knots");
            assert_eq!((error.code(), error.argument()), ("E_DEGENERATE", Some("knots")), "{knots:?}");
        }
    }
    assert!(new(&[0.0], true).is_ok(), "a circle may have a knot at its start");
    assert!(new(&[0.0], false).is_err(), "a line may not");
    assert_eq!(new(&[f64::NAN], true).expect_err("NaN").code(), "E_NOT_FINITE");
    assert_eq!(KnotSpace::new(3, &[], 1.0, 1.0, true).expect_err("no length").argument(), Some("domain"));
    assert_eq!(KnotSpace::new(6, &[], 0.0, 1.0, true).expect_err("degree").code(), "E_RANGE");
}
