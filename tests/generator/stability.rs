//! How stable the representation is: Gram entries and Riesz bounds against independent computations.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::{generators, golden, space, tolerance};
use expline::generator::{Gram, Space};
use serde::Deserialize;

#[derive(Deserialize)]
struct GramFile {
    cases: Vec<GramCase>,
}

#[derive(Deserialize)]
struct GramCase {
    w0: f64,
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    e: f64,
    alpha: f64,
    beta: f64,
    min_det: f64,
    omega: Vec<f64>,
    lambda_min: Vec<f64>,
    lambda_max: Vec<f64>,
}

#[derive(Deserialize)]
struct StabilityFile {
    cases: Vec<StabilityCase>,
}

#[derive(Deserialize)]
struct StabilityCase {
    space: String,
    w: f64,
    gram: Vec<f64>,
    lower: f64,
    upper: f64,
}

fn assert_relative(what: &str, got: f64, expected: f64, tolerance: f64) {
    let deviation = (got / expected - 1.0).abs();
    assert!(deviation <= tolerance, "{what}: {got} for {expected}, relative {deviation:e}");
}

fn entries(gram: &Gram) -> [f64; 5] {
    [gram.a, gram.b, gram.c, gram.d, gram.e]
}

#[test]
fn gram_entries_eigenvalues_and_riesz_bounds_agree_with_fifty_digits() {
    let file: GramFile = golden::parse(include_str!("../golden/splines/gram.json"));
    for case in file.cases {
        let generators = generators(Space::Trigonometric, case.w0);
        let gram = generators.gram();
        let expected = [case.a, case.b, case.c, case.d, case.e];
        for (name, (got, expected)) in
            ["a", "b", "c", "d", "e"].iter().zip(entries(&gram).into_iter().zip(expected))
        {
            assert_relative(&format!("{name} at w {}", case.w0), got, expected, tolerance::GRAM);
        }
        let bounds = generators.riesz_bounds();
        assert_relative("lower bound", bounds.lower, case.alpha, tolerance::RIESZ);
        assert_relative("upper bound", bounds.upper, case.beta, tolerance::RIESZ);
        let determinant = (2.0 * gram.a + gram.b) * (2.0 * gram.d + gram.e);
        assert_relative("least determinant", determinant, case.min_det, tolerance::RIESZ);
        for (&omega, (&least, &most)) in case.omega.iter().zip(case.lambda_min.iter().zip(&case.lambda_max)) {
            let got = gram.eigenvalues(omega.cos());
            assert_relative("smaller eigenvalue", got.0, least, tolerance::RIESZ);
            assert_relative("larger eigenvalue", got.1, most, tolerance::RIESZ);
        }
    }
}

#[test]
fn gram_entries_and_riesz_bounds_hold_beyond_pi_and_in_the_hyperbolic_space() {
    let file: StabilityFile = golden::parse(include_str!("../golden/splines/stability.json"));
    for case in file.cases {
        let what = format!("{} {}", case.space, case.w);
        let generators = generators(space(&case.space), case.w);
        for (got, &expected) in entries(&generators.gram()).into_iter().zip(&case.gram) {
            assert_relative(&what, got, expected, tolerance::GRAM);
        }
        let bounds = generators.riesz_bounds();
        assert_relative(&format!("lower bound, {what}"), bounds.lower, case.lower, tolerance::RIESZ);
        assert_relative(&format!("upper bound, {what}"), bounds.upper, case.upper, tolerance::RIESZ);
    }
}

#[test]
fn no_frequency_of_a_dense_scan_leaves_the_riesz_bounds_and_some_frequency_attains_them() {
    let mut omegas: Vec<(Space, f64)> = (0..63).map(|k| (Space::Trigonometric, f64::from(k) * 0.1)).collect();
    // Around 5.82 the upper bound leaves 1, around 5.9 it reaches the alternating sequences.
    omegas.extend((0..=40).map(|k| (Space::Trigonometric, 5.8 + f64::from(k) * 0.005)));
    omegas.extend((0..40).map(|k| (Space::Hyperbolic, 0.01 * 1.4_f64.powi(k))));
    for (space, omega) in omegas {
        let generators = generators(space, omega);
        let (gram, bounds) = (generators.gram(), generators.riesz_bounds());
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        let steps = 20_000;
        for k in 0..=steps {
            let eigenvalues =
                gram.eigenvalues((core::f64::consts::PI * f64::from(k) / f64::from(steps)).cos());
            least = least.min(eigenvalues.0);
            most = most.max(eigenvalues.1);
        }
        let (lower, upper) = (bounds.lower * bounds.lower, bounds.upper * bounds.upper);
        assert!(lower <= least * (1.0 + 1e-13), "{space:?} {omega}: {lower} against {least} of the scan");
        assert!(upper >= most * (1.0 - 1e-13), "{space:?} {omega}: {upper} against {most} of the scan");
        // A scan of this step misses a smooth extreme by less than 1e-7 of it.
        assert!(least <= lower * (1.0 + 1e-7), "{space:?} {omega}: {lower} is not attained, {least}");
        assert!(most >= upper * (1.0 - 1e-7), "{space:?} {omega}: {upper} is not attained, {most}");
    }
}

#[test]
fn a_random_sequence_keeps_its_norm_within_the_riesz_bounds() {
    // ‖Σ aᵀφ‖² of a periodic sequence by quadrature, with no Gram matrix in between.
    let mut seed = 12_345_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    for (space, omega) in [
        (Space::Trigonometric, 1.0),
        (Space::Trigonometric, 6.1),
        (Space::Hyperbolic, 5.0),
        (Space::Polynomial, 0.0),
    ] {
        let generators = generators(space, omega);
        let bounds = generators.riesz_bounds();
        for _ in 0..20 {
            let data: Vec<(f64, f64)> = (0..7).map(|_| (random(), random())).collect();
            let norm: f64 = data.iter().map(|(f, d)| f * f + d * d).sum();
            let steps = 400;
            let mut integral = 0.0;
            for (n, &(f0, d0)) in data.iter().enumerate() {
                let (f1, d1) = data[(n + 1) % data.len()];
                for k in 0..steps {
                    let x = (f64::from(k) + 0.5) / f64::from(steps);
                    let (here, there) = (generators.at(x, 0), generators.at(x - 1.0, 0));
                    let value = f0 * here.0 + d0 * here.1 + f1 * there.0 + d1 * there.1;
                    integral += value * value / f64::from(steps);
                }
            }
            // The midpoint rule with 400 points is good to 1e-4 here.
            let ratio = (integral / norm).sqrt();
            assert!(
                ratio >= bounds.lower * 0.999 && ratio <= bounds.upper * 1.001,
                "{space:?} {omega} {ratio}"
            );
        }
    }
}
