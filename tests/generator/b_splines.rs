//! Exponential B-splines of any roots, against 50 digits and against what defines them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::{golden, roots, tolerance};
use expline::Error;
use expline::generator::{ExponentialBSpline, Root, Roots};
use serde::Deserialize;

#[derive(Deserialize)]
struct File {
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    alpha: Vec<Vec<f64>>,
    beta_hat0: f64,
    t: Vec<f64>,
    d: Vec<Vec<f64>>,
}

fn file() -> File {
    golden::parse(include_str!("../golden/splines/exponential_bsplines.json"))
}

#[test]
fn values_and_all_continuous_derivatives_agree_with_fifty_digits() {
    for case in file().cases {
        let roots = roots(&case.alpha);
        let spline = ExponentialBSpline::new(&roots).expect("the golden roots are in range");
        let shift = 0.5 * roots.order() as f64;
        for (order, expected) in case.d.iter().enumerate() {
            let largest = expected.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let mut worst: f64 = 0.0;
            for (t, expected) in case.t.iter().zip(expected) {
                let got = spline.at(t - shift, order);
                worst = worst.max((got - expected).abs() / largest);
            }
            assert!(worst <= tolerance::B_SPLINES, "{} derivative {order}: off by {worst:e}", case.name);
        }
        let off = (roots.integral() / case.beta_hat0 - 1.0).abs();
        assert!(off < 2e-15, "{}: the integral is off by {off:e}", case.name);
    }
}

fn list(reals: &[f64], pairs: &[(f64, f64)]) -> Roots {
    let mut roots: Vec<Root> = reals.iter().map(|&re| Root { re, im: 0.0 }).collect();
    for &(re, im) in pairs {
        roots.extend([Root { re, im }, Root { re, im: -im }]);
    }
    Roots::new(&roots, "roots").expect("within the limits")
}

/// Lists that are hard on other methods: repeated, clustered, tiny and large roots, symmetric and not.
fn hard() -> Vec<Roots> {
    vec![
        list(&[0.0, 0.0, 5.0, -5.0], &[]),
        list(&[0.0, 20.0, -20.0], &[]),
        list(&[5.0, -5.0, 5.0, -5.0, 4.0, -4.0, 4.0, -4.0], &[]),
        list(&[20.0, -20.0, 20.0, -20.0, 19.0, -19.0], &[]),
        list(&[10.0, -10.0, 10.0, -10.0, 10.0, -10.0, 10.0, -10.0, 10.0, -10.0, 10.0, -10.0], &[]),
        list(&[3.0, 3.0, 2.0, 0.0], &[]),
        list(&[20.0, 7.0, -12.0], &[(3.0, 2.0)]),
        list(&[1.0, 1.0 + 1e-7, -1.0, 1e-7 - 1.0, 1.0 - 1e-7, -1.0], &[]),
        list(&[0.0], &[(0.0, 1.0), (0.0, 1.0 + 1e-8)]),
        list(&[0.0], &[(0.0, 1e-8)]),
        list(&[0.0], &[(0.0, 6.0)]),
        list(&[], &[(0.0, 1.0), (0.0, 1.0), (0.0, 1.0), (0.0, 1.0)]),
        list(&[0.0; 16], &[]),
        list(&[0.0; 8], &[(0.0, 3.1), (0.0, 3.1), (0.0, 3.1), (0.0, 3.1)]),
    ]
}

#[test]
fn shifts_reproduce_the_exponential_of_every_root() {
    for roots in hard() {
        let spline = ExponentialBSpline::new(&roots).expect("in range");
        let reach = roots.order() as i32;
        let places = (0..=8 * reach).map(|i| spline.at(f64::from(i) / 8.0 - 0.5 * f64::from(reach), 0));
        // Values are exact to the largest one's last digits.
        let largest = places.fold(0.0, f64::max);
        for root in roots.as_slice() {
            // Σ e^{α(k − x)} β(x − k) does not depend on x.
            let sums: Vec<(f64, f64, f64)> = (0..=16)
                .map(|i| {
                    let x = f64::from(i) / 16.0;
                    let mut sums = (0.0, 0.0, 0.0);
                    for k in -reach..=reach {
                        let away = f64::from(k) - x;
                        if 2.0 * away.abs() < f64::from(reach) {
                            let weight = (root.re * away).exp();
                            sums.0 += weight * spline.at(-away, 0) * (root.im * away).cos();
                            sums.1 += weight * spline.at(-away, 0) * (root.im * away).sin();
                            sums.2 += weight * largest;
                        }
                    }
                    sums
                })
                .collect();
            for (re, im, size) in &sums {
                let off = (re - sums[0].0).hypot(im - sums[0].1) / size;

                assert!(off < tolerance::B_SPLINES, "{roots:?}: {root:?} is off by {off:e}");
            }
        }
    }
}

#[test]
fn every_derivative_is_the_difference_of_the_one_below_without_the_root_0() {
    // β⁽ᵈ⁾(x) = γ⁽ᵈ⁻¹⁾(x + ½) − γ⁽ᵈ⁻¹⁾(x − ½), with γ of all roots but one 0.
    let mut lists: Vec<Roots> =
        hard().into_iter().filter(|roots| roots.order() > 1 && roots.keeps_constants()).collect();
    for (zeros, rate) in [(6, 12.0), (10, 8.0), (14, 5.0)] {
        lists.push(list(&[vec![0.0; zeros], vec![rate, -rate]].concat(), &[]));
    }
    for roots in lists {
        let mut fewer = roots.as_slice().to_vec();
        let zero =
            fewer.iter().position(|root| root.re == 0.0 && root.im == 0.0).expect("it keeps constants");
        fewer.remove(zero);
        let spline = ExponentialBSpline::new(&roots).expect("in range");
        let lower =
            Roots::new(&fewer, "roots").and_then(|fewer| ExponentialBSpline::new(&fewer)).expect("in range");
        for derivative in 1..roots.order() {
            let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
            // Not at knots: the highest derivative jumps there.
            for i in 0..37 * roots.order() {
                let x = (i as f64 + 0.5) / 37.0 - 0.5 * roots.order() as f64;
                let (above, below) = (lower.at(x + 0.5, derivative - 1), lower.at(x - 0.5, derivative - 1));
                worst = worst.max((spline.at(x, derivative) - (above - below)).abs());
                largest = largest.max(spline.at(x, derivative).abs());
            }
            let off = worst / largest;
            assert!(off < 1e-13, "{roots:?}: derivative {derivative} is off by {off:e}");
        }
    }
}

#[test]
fn roots_that_leave_no_digits_are_refused() {
    let zeros_and = |zeros: usize, rate: f64| {
        let mut reals = vec![0.0; zeros];
        reals.extend([rate, -rate]);
        ExponentialBSpline::new(&list(&reals, &[])).map(|_| ()).map_err(|error| *error)
    };
    assert!(matches!(zeros_and(14, 20.0), Err(Error::Degenerate { argument: "roots", .. })));
    assert!(zeros_and(6, 20.0).is_ok() && zeros_and(14, 8.0).is_ok(), "few digits are digits");
    // Where the integral is 0 it says as much.
    assert!(ExponentialBSpline::new(&list(&[0.0], &[(0.0, core::f64::consts::TAU)])).is_ok());
}
