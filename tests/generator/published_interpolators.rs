//! What is printed in [SFBGU17], number by number: reproduced where it is right, shown wrong where we correct it.
//!
//! The misprints are listed in docs/SOURCES.md, each with the name of its test here.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::{PI, TAU};

use expline::InterpolatingCurve;
use expline::generator::{ExponentialBSpline, Interpolator, Root, Roots};

fn pair(im: f64) -> [Root; 2] {
    [Root { re: 0.0, im }, Root { re: 0.0, im: -im }]
}

fn list(roots: &[Root]) -> Roots {
    Roots::new(roots, "roots").expect("closed under conjugation")
}

fn lambda(roots: &Roots) -> Vec<f64> {
    Interpolator::new(roots).expect("it exists").lambda().to_vec()
}

/// Both agree to the digits printed.
fn assert_printed(got: &[f64], printed: &[f64], digits: i32) {
    assert_eq!(got.len(), printed.len(), "the number of weights");
    for (got, printed) in got.iter().zip(printed) {
        assert!((got - printed).abs() <= 0.51 * 10.0_f64.powi(-digits), "{got} is printed as {printed}");
    }
}

#[test]
fn the_weights_of_the_roman_surface_are_right() {
    let fast = [pair(TAU / 5.0), pair(2.0 * TAU / 5.0)].concat();
    assert_printed(&lambda(&list(&fast)), &[18.118, -10.128, 1.730], 3);
    let slow = [&[Root::default()], &pair(2.0 * TAU / 5.0)[..]].concat();
    assert_printed(&lambda(&list(&slow)), &[7.396, -2.825], 3);
}

#[test]
fn the_weights_of_the_hyperbolic_paraboloid_are_right() {
    assert_printed(&lambda(&Roots::hyperbola(1.0 / 3.0).expect("in range")), &[1.968, -0.489], 3);
    assert_printed(&lambda(&Roots::polynomials(2).expect("in range")), &[2.0, -0.5], 15);
}

#[test]
fn section_4_1_needs_two_for_the_quadratic_weight() {
    // Printed (1, −1/2): φ(0) would be β(0) − β(1/2) = 3/4 − 1/2.
    let quadratic = Roots::polynomials(2).expect("in range");
    let beta = ExponentialBSpline::new(&quadratic).expect("in range");
    let at_0 = |zero: f64| zero * beta.at(0.0, 0) - beta.at(0.5, 0);
    assert!((at_0(1.0) - 0.25).abs() < 1e-15, "as printed");
    assert!((at_0(2.0) - 1.0).abs() < 1e-15, "corrected");
}

#[test]
fn appendix_e_prints_half_of_the_first_weight_of_ellipses() {
    for count in [3.0_f64, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 24.0, 100.0] {
        let [zero, one] = lambda(&Roots::ellipse(count as usize).expect("in range"))[..] else {
            unreachable!("three roots have two weights")
        };
        let square = (PI / count).powi(2);
        let printed = 0.25 * square / ((PI / (2.0 * count)).sin().powi(2) * (PI / count).cos());
        assert!((zero / printed - 2.0).abs() < 1e-12, "λ₀ of {count}: {zero}, printed {printed}");
        let printed = -square / ((PI / count).sin() * (TAU / count).sin());
        assert!((one / printed - 1.0).abs() < 1e-12, "λ₁ of {count}: {one}, printed {printed}");
    }
}

#[test]
fn polynomial_weights_are_these_fractions() {
    let fractions: [&[(f64, f64)]; 5] = [
        &[(2.0, 1.0), (-1.0, 2.0)],
        &[(10.0, 3.0), (-4.0, 3.0), (1.0, 6.0)],
        &[(56.0, 9.0), (-59.0, 18.0), (32.0, 45.0), (-2.0, 45.0)],
        &[(37679.0, 3120.0), (-113.0, 15.0), (239.0, 104.0), (-61.0, 195.0), (61.0, 6240.0)],
        &[
            (40388.0, 1647.0),
            (-748_151.0, 43920.0),
            (124_448.0, 19215.0),
            (-2_432_377.0, 1_844_640.0),
            (6754.0, 57645.0),
            (-3377.0, 1_844_640.0),
        ],
    ];
    for (degree, fractions) in (2..).zip(fractions) {
        let lambda = lambda(&Roots::polynomials(degree).expect("in range"));
        assert_eq!(lambda.len(), fractions.len(), "degree {degree}");
        for (got, (numerator, denominator)) in lambda.iter().zip(fractions) {
            let off = (got - numerator / denominator).abs();
            assert!(off < 4e-15 * lambda[0], "degree {degree}: {got} for {numerator}/{denominator}");
        }
    }
}

#[test]
fn figure_e6_three_points_are_a_cosine_a_sine_and_a_circle() {
    let points: Vec<f64> =
        (0..3).flat_map(|k| [(TAU * f64::from(k) / 3.0).cos(), (TAU * f64::from(k) / 3.0).sin()]).collect();
    let circle = InterpolatingCurve::new(points, 2, true, None).expect("three points");
    for i in 0..300 {
        let t = f64::from(i) / 100.0;
        let point = circle.evaluate(t, 0).expect("closed");
        assert!((point[0] - (TAU * t / 3.0).cos()).abs() < 3e-15, "cosine at {t}");
        assert!((point[1] - (TAU * t / 3.0).sin()).abs() < 3e-15, "sine at {t}");
    }
}

#[test]
fn proposition_2_keeps_whatever_the_roots_stand_for() {
    // tᵏe^{αt} for every root and power below its multiplicity: here 1, t and cos, sin times 1, t.
    let roots = list(&[[Root::default(); 2], pair(1.1), pair(1.1)].concat());
    let phi = Interpolator::new(&roots).expect("it exists");
    let functions: [fn(f64) -> f64; 6] = [
        |_| 1.0,
        |t| t,
        |t| (1.1 * t).cos(),
        |t| (1.1 * t).sin(),
        |t| t * (1.1 * t).cos(),
        |t| t * (1.1 * t).sin(),
    ];
    for function in functions {
        for i in 0..50 {
            let t = f64::from(i) / 50.0;
            let sum: f64 = (-6..=6).map(|k| function(f64::from(k)) * phi.at(t - f64::from(k), 0)).sum();
            assert!((sum - function(t)).abs() < 2e-14, "{sum} at {t}");
        }
    }
}

#[test]
fn equation_12_is_the_sum_of_the_weights_times_the_transform() {
    // Only where both signs of every root are there is φ even, and only conjugates make it real: both are needed.
    for roots in [Roots::harmonics(9, 3), Roots::hyperbola(1.2), Roots::polynomials(5)] {
        let phi = Interpolator::new(&roots.expect("in range")).expect("it exists");
        assert!(phi.identity() < 1e-13, "off by {:e}", phi.identity());
        for x in [0.1, 0.9, 1.7] {
            assert!((phi.at(x, 0) - phi.at(-x, 0)).abs() < 1e-15, "φ is even");
        }
    }
}

#[test]
fn the_roman_list_needs_the_root_0_to_follow_a_translation() {
    let without = list(&[pair(TAU / 5.0), pair(2.0 * TAU / 5.0)].concat());
    let sum = |roots: &Roots| {
        let phi = Interpolator::new(roots).expect("it exists");
        (-5..=5).map(|k| phi.at(0.5 - f64::from(k), 0)).sum::<f64>()
    };
    assert!((sum(&without) - 0.326).abs() < 1e-3, "{}", sum(&without));
    let with = Roots::union(&[without, Roots::polynomials(0).expect("in range")]).expect("five roots");
    assert!((sum(&with) - 1.0).abs() < 1e-14, "{}", sum(&with));
}

#[test]
fn equations_17_to_20_divide_the_roots_once() {
    // g built from h of roots divided twice does not reproduce φ; ours does.
    let roots = Roots::ellipse(3).expect("in range");
    let phi = Interpolator::new(&roots).expect("it exists");
    let fine = ExponentialBSpline::new(&roots.scaled(2.0).expect("in range")).expect("in range");
    let g = phi.pre_filter(2).expect("even");
    let twice = Interpolator::new(&roots.scaled(2.0).expect("in range"))
        .expect("it exists")
        .pre_filter(2)
        .expect("even");
    let combine = |g: &[f64], t: f64| -> f64 {
        // φ⁺(t/2) with both causal: φ⁺ = φ(· − 2), β⁺ = β(· − 3/2).
        g.iter().enumerate().map(|(k, tap)| tap * fine.at(t - k as f64 - 1.5, 0)).sum()
    };
    let mut worst: f64 = 0.0;
    for i in 0..80 {
        let t = f64::from(i) / 10.0;
        let value = phi.at(0.5 * t - 2.0, 0);
        assert!((combine(&g, t) - value).abs() < 2e-14, "at {t}");
        worst = worst.max((combine(&twice, t) - value).abs());
    }
    assert!(worst > 0.1, "read literally it is off by {worst}");
}

#[test]
fn equation_19_and_proposition_4_hide_a_delay_and_an_offset() {
    let points: Vec<f64> =
        (0..3).flat_map(|k| [(TAU * f64::from(k) / 3.0).cos(), (TAU * f64::from(k) / 3.0).sin()]).collect();
    let circle = InterpolatingCurve::new(points, 2, true, None).expect("three points");
    let distance = |levels: usize, offset: f64| {
        let fine = circle.refine(levels, 2, 2).expect("in range");
        let mut worst: f64 = 0.0;
        for (l, point) in fine.points().chunks_exact(2).enumerate() {
            let on = circle.evaluate(fine.offset() + (l as f64 + offset) * fine.step(), 0).expect("closed");
            worst = worst.max((on[0] - point[0]).hypot(on[1] - point[1]));
        }
        worst
    };
    // Centred: second order, and the polygon of a circle is circumscribed about it: 1/cos(w/2) − 1 away.
    for levels in 1..=5 {
        let w = TAU / 3.0 / f64::from(1 << levels);
        let expected = 1.0 / (0.5 * w).cos() - 1.0;
        assert!((distance(levels, 0.0) - expected).abs() < 1e-12, "level {levels}");
    }
    // With the delay n₀ − 1 only and the offset n₀/2 left out: first order. Without either it stays off by the size.
    let ratio = distance(5, -0.5) / distance(6, -0.5);
    assert!((1.9..2.1).contains(&ratio), "{ratio}");
    let fine = circle.refine(6, 2, 2).expect("in range");
    let delay = 2.0 / fine.step();
    assert!(distance(6, delay) > 1.0, "{}", distance(6, delay));
}
