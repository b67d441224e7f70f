//! Laws of the basis, the generators and the schemes, at thousands of random places.
#![cfg(not(target_arch = "wasm32"))]

use crate::support::{generators, tolerance};
use core::f64::consts::PI;
use expline::generator::{Basis, HermiteGenerators, Space};
use expline::numerics::entire::stumpff;
use expline::refine::MatrixMask;
use proptest::prelude::*;

/// A space and a frequency: small and large ones by their logarithm, and the whole range evenly.
fn frequency() -> impl Strategy<Value = (Space, f64)> {
    prop_oneof![
        (0.0..6.2_f64).prop_map(|w| (Space::Trigonometric, w)),
        (-170.0..0.5_f64).prop_map(|e| (Space::Trigonometric, 10.0_f64.powf(e))),
        (0.0..12.0_f64).prop_map(|w| (Space::Hyperbolic, w)),
        (-170.0..4.0_f64).prop_map(|e| (Space::Hyperbolic, 10.0_f64.powf(e))),
        Just((Space::Polynomial, 0.0)),
    ]
}

/// A place in [0, 1], often close to an end.
fn place() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => 0.0..=1.0_f64,
        1 => (-12.0..-0.3_f64).prop_map(|e| 10.0_f64.powf(e)),
        1 => (-12.0..-0.3_f64).prop_map(|e| 1.0 - 10.0_f64.powf(e)),
    ]
}

/// How large the weights get: near the pole at 2π the leaving one grows like 1/(2π − w).
fn size(basis: &Basis, derivative: usize) -> f64 {
    (0..=16)
        .map(|k| basis.weights(f64::from(k) / 16.0, derivative))
        .fold(1.0, |most: f64, w| most.max(w.chord.abs()).max(w.leaving.abs()))
}

/// The four functions of the space and their derivatives at x, scaled so that none exceeds about 1.
fn space_functions(space: Space, w: f64, x: f64) -> [(f64, f64); 4] {
    let (even, odd) = match space {
        Space::Polynomial => ((x * x, 2.0 * x), (x * x * x, 3.0 * x * x)),
        Space::Trigonometric => (((w * x).cos(), -w * (w * x).sin()), ((w * x).sin(), w * (w * x).cos())),
        // e^{wx − w} and e^{−wx} span the same.
        Space::Hyperbolic => {
            let (up, down) = ((w * x - w).exp(), (-w * x).exp());
            ((up, w * up), (down, -w * down))
        }
    };
    [(1.0, 0.0), (x, 1.0), even, odd]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_function_of_the_space_comes_back((space, w) in frequency(), x in place()) {
        let basis = Basis::new(space, w);
        let weights = basis.weights(x, 0);
        let (start, end) = (space_functions(space, w, 0.0), space_functions(space, w, 1.0));
        for (k, (value, _)) in space_functions(space, w, x).into_iter().enumerate() {
            let got = start[k].0
                + weights.chord * (end[k].0 - start[k].0)
                + weights.leaving * start[k].1
                + weights.arriving * end[k].1;
            // Each weight's own error times the derivative that it takes, and e^(wx) itself is off by w roundings.
            let scale = 1.0 + size(&basis, 0) * (start[k].1.abs() + end[k].1.abs()) + 0.1 * w;
            prop_assert!((got - value).abs() <= 2.0 * tolerance::WEIGHTS * scale, "{k}: {got} for {value}");
        }
    }

    #[test]
    fn shifts_sum_to_one_and_reproduce_the_parameter((space, w) in frequency(), x in place()) {
        let generators = generators(space, w);
        let (here, there) = (generators.at(x, 0), generators.at(x - 1.0, 0));
        if x < 1.0 {
            // x − 1 is rounded to 1e-16, and φ₁ falls by up to 3 a unit.
            prop_assert!((here.0 + there.0 - 1.0).abs() <= 1e-15, "sum of phi1");
            let line = there.0 + here.1 + there.1;
            let scale = 1.0 + size(generators.basis(), 0);
            prop_assert!((line - x).abs() <= tolerance::WEIGHTS * scale, "{line} for {x}");
        }
    }

    #[test]
    fn the_first_generator_is_even_and_the_second_odd((space, w) in frequency(), x in place(), derivative in 0..4_usize) {
        prop_assume!(x > 0.0 && x < 1.0);
        let generators = generators(space, w);
        let (right, left) = (generators.at(x, derivative), generators.at(-x, derivative));
        let sign = if derivative % 2 == 0 { 1.0 } else { -1.0 };
        prop_assert_eq!((right.0, right.1), (sign * left.0, -sign * left.1));
    }

    #[test]
    fn a_segment_read_backwards_is_its_mirror_image((space, w) in frequency(), x in place(), derivative in 0..4_usize) {
        let basis = Basis::new(space, w);
        // A mirrored place that is exact, so that only the weights are compared.
        let z = 1.0 - x;
        let (here, there) = (basis.weights(1.0 - z, derivative), basis.weights(z, derivative));
        let sign = if derivative % 2 == 0 { 1.0 } else { -1.0 };
        let bound = 2.0 * tolerance::WEIGHTS * size(&basis, derivative) + 3e-16 * size(&basis, derivative + 1);
        prop_assert!((here.leaving + sign * there.arriving).abs() <= bound, "{here:?} {there:?}");
        let chord = if derivative == 0 { 1.0 - there.chord } else { -sign * there.chord };
        prop_assert!((here.chord - chord).abs() <= bound, "{here:?} {there:?}");
    }

    #[test]
    fn derivatives_are_derivatives((space, w) in frequency(), x in 0.0..=1.0_f64, far in 0.0..=1.0_f64) {
        prop_assume!(w <= 12.0);
        // Taylor's formula in the space joins all orders, with no difference quotient in between.
        let basis = Basis::new(space, w);
        let t = far - x;
        let c = stumpff(basis.square() * t * t);
        let (first, second, third) = (t * c.c1, t * t * c.c2, t * t * t * c.c3);
        let at: Vec<_> = (0..4).map(|d| basis.weights(x, d)).collect();
        let (value, slope) = (basis.weights(far, 0), basis.weights(far, 1));
        let growth: f64 = if space == Space::Hyperbolic { (w * t.abs()).exp() } else { 1.0 };
        let bound = 8.0 * tolerance::WEIGHTS * growth * (size(&basis, 0) + size(&basis, 1) + size(&basis, 2) + size(&basis, 3));
        for pick in [|w: &expline::generator::Weights| w.chord, |w: &expline::generator::Weights| w.leaving, |w: &expline::generator::Weights| w.arriving] {
            let r: Vec<f64> = at.iter().map(pick).collect();
            let got = r[0] + t * r[1] + second * r[2] + third * r[3];
            prop_assert!((got - pick(&value)).abs() <= bound, "{got} for {}", pick(&value));
            let got = r[1] + first * r[2] + second * r[3];
            prop_assert!((got - pick(&slope)).abs() <= bound, "{got} for {}", pick(&slope));
        }
    }

    #[test]
    fn bernstein_functions_are_not_negative_and_sum_to_one((space, w) in frequency(), x in place()) {
        let b = Basis::new(space, w).bernstein(x, 0);
        prop_assert!((b.iter().sum::<f64>() - 1.0).abs() <= 2.0 * tolerance::VALUES, "{b:?}");
        prop_assert!(b.iter().all(|&b| b >= -1e-16), "{b:?}");
    }

    #[test]
    fn generators_satisfy_the_refinement_equation(
        (space, w) in frequency(),
        x in -1.0..1.0_f64,
        arity in 1..7_usize,
        level in 0..6_usize,
    ) {
        // φ on the grid of this level from φ on the next finer one; both times in the coarser grid's unit.
        let step = (arity as f64).powi(-(level as i32));
        let coarse = HermiteGenerators::new(w * step, space).expect("smaller than w");
        let fine = HermiteGenerators::new(w * step / arity as f64, space).expect("smaller than w");
        let masks = generators(space, w).mask(arity, level).expect("in range");
        let mut sums = (0.0, 0.0);
        for (k, h) in masks.chunks(4).enumerate() {
            let n = k as f64 - (arity as f64 - 1.0);
            let (one, two) = fine.at(x * arity as f64 - n, 0);
            // Rows of H act on values, columns are the generators: φ₁ takes h[0] and h[2], φ₂ takes h[1] and h[3].
            sums.0 += h[0] * one + h[2] * step * two / arity as f64;
            sums.1 += h[1] / step * one + h[3] * two / arity as f64;
        }
        let expected = coarse.at(x, 0);
        let bound = 8.0 * tolerance::WEIGHTS * size(coarse.basis(), 0).max(size(coarse.basis(), 1));
        prop_assert!((sums.0 - expected.0).abs() <= bound, "phi1: {} for {}", sums.0, expected.0);
        prop_assert!((sums.1 - expected.1).abs() <= bound, "phi2: {} for {}", sums.1, expected.1);
    }

    #[test]
    fn masks_keep_constants_and_the_parameter((space, w) in frequency(), arity in 1..9_usize, length in 0.01..100.0_f64) {
        let mask = MatrixMask::new(space, w / length, length, arity).expect("in range");
        let scale = size(&Basis::new(space, w), 0).max(size(&Basis::new(space, w), 1));
        for k in 1..arity {
            let (left, right) = (mask.matrix(k as isize), mask.matrix(k as isize - arity as isize));
            prop_assert!((left[0] + right[0] - 1.0).abs() <= 3e-16, "values of a constant");
            prop_assert!((left[2] + right[2]).abs() * length <= 1e-15 * scale, "derivatives of a constant");
            let x = k as f64 / arity as f64;
            let value = right[0] * length + left[1] + right[1];
            prop_assert!((value / length - x).abs() <= 2.0 * tolerance::WEIGHTS * scale, "values of t: {value}");
            let slope = right[2] * length + left[3] + right[3];
            prop_assert!((slope - 1.0).abs() <= 4.0 * tolerance::WEIGHTS * scale, "derivatives of t: {slope}");
        }
    }

    #[test]
    fn b_splines_are_positive_bumps_whose_shifts_sum_to_one(w in 0.0..=PI, x in 0.0..1.0_f64) {
        let generators = generators(Space::Trigonometric, w);
        let four: Vec<f64> = (0..4).map(|n| generators.b_spline4(x + f64::from(n), 0)).collect();
        let three: Vec<f64> = (0..3).map(|n| generators.b_spline3(x + f64::from(n), 0)).collect();
        prop_assert!((four.iter().sum::<f64>() - 1.0).abs() <= tolerance::VALUES, "{four:?}");
        prop_assert!((three.iter().sum::<f64>() - 1.0).abs() <= tolerance::VALUES, "{three:?}");
        prop_assert!(four.iter().chain(&three).all(|&v| v >= -1e-16), "{four:?} {three:?}");
    }

    #[test]
    fn b_splines_are_as_smooth_as_b_splines_are(w in 0.0..=PI, knot in 0..=4_i32) {
        // Order 4: two continuous derivatives; order 3: one. The generators alone have one.
        let generators = generators(Space::Trigonometric, w);
        let (before, after) = (f64::from(knot) - 1e-12, f64::from(knot));
        for derivative in 0..3 {
            let jump = generators.b_spline4(before, derivative) - generators.b_spline4(after, derivative);
            prop_assert!(jump.abs() < 1e-10, "order 4, derivative {derivative}: {jump:e}");
        }
        for derivative in 0..2 {
            let jump = generators.b_spline3(before, derivative) - generators.b_spline3(after, derivative);
            prop_assert!(jump.abs() < 1e-10, "order 3, derivative {derivative}: {jump:e}");
        }
    }

    #[test]
    fn no_finite_frequency_and_place_gives_anything_but_numbers(
        bits in any::<u64>(),
        kind in 0..3_usize,
        x in -3.0..3.0_f64,
    ) {
        let space = [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial][kind];
        let omega = f64::from_bits(bits);
        match HermiteGenerators::new(omega, space) {
            Ok(generators) => {
                for derivative in 0..3 {
                    let (one, two) = generators.at(x, derivative);
                    prop_assert!(one.is_finite() && two.is_finite(), "{space:?} {omega} {x}: {one} {two}");
                }
                let bounds = generators.riesz_bounds();
                prop_assert!(bounds.lower > 0.0 && bounds.upper.is_finite(), "{bounds:?}");
            }
            Err(error) => prop_assert!(matches!(error.code(), "E_NOT_FINITE" | "E_RANGE"), "{error}"),
        }
    }
}
