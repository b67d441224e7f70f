//! Interpolators of compact support, against 50 digits and against what defines them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod support;

use core::f64::consts::{PI, TAU};

use expline::Error;
use expline::generator::{ExponentialBSpline, Interpolator, Root, Roots};
use serde::Deserialize;
use support::curves::Random;
use support::{golden, roots, tolerance, unboxed};

#[derive(Deserialize)]
struct File {
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    name: String,
    alpha: Vec<Vec<f64>>,
    lam: Vec<f64>,
    t: Vec<f64>,
    d: Vec<Vec<f64>>,
    riesz: [f64; 2],
    bounds: [f64; 2],
    beta_riesz: [f64; 2],
    lebesgue: f64,
}

fn file() -> File {
    golden::parse(include_str!("golden/splines/interpolators.json"))
}

#[test]
fn weights_and_values_agree_with_fifty_digits() {
    for case in file().cases {
        let phi = Interpolator::new(&roots(&case.alpha)).expect("the golden roots are in range");
        let largest = case.lam.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        for (got, expected) in phi.lambda().iter().zip(&case.lam) {
            let off = (got - expected).abs() / largest;
            assert!(off <= tolerance::LAMBDA, "{}: λ off by {off:e}", case.name);
        }
        let cancelled = 1.0 + 2.0 * case.lam.iter().map(|l| l.abs()).sum::<f64>();
        for (order, expected) in case.d.iter().enumerate() {
            let largest = expected.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            for (t, expected) in case.t.iter().zip(expected) {
                let off = (phi.at(*t, order) - expected).abs() / largest / cancelled;
                assert!(off <= tolerance::INTERPOLATORS, "{} order {order}: off by {off:e}", case.name);
            }
        }
        assert!(
            phi.identity() < 1e-12 * cancelled,
            "{}: the identity is off by {:e}",
            case.name,
            phi.identity()
        );
    }
}

#[test]
fn riesz_bounds_are_exact_and_within_the_estimates_of_the_paper() {
    for case in file().cases {
        let phi = Interpolator::new(&roots(&case.alpha)).expect("the golden roots are in range");
        let own = phi.riesz_bounds().expect("finite");
        let spline = phi.b_spline().riesz_bounds().expect("finite");
        for (got, expected) in [(own, case.riesz), (spline, case.beta_riesz)] {
            let off = (got.lower / expected[0] - 1.0).abs().max((got.upper / expected[1] - 1.0).abs());
            assert!(off < tolerance::RIESZ, "{}: off by {off:e}", case.name);
        }
        // (A.6) and (A.7) are bounds, and not equalities as printed.
        let [least, most] = case.bounds;
        assert!(least <= own.lower && own.upper <= most, "{}: {least} {own:?} {most}", case.name);
    }
}

#[test]
fn the_lebesgue_constant_is_no_less_than_at_any_place_looked_at() {
    for case in file().cases {
        let phi = Interpolator::new(&roots(&case.alpha)).expect("the golden roots are in range");
        // The golden value is the largest of 41 places.
        let ratio = phi.lebesgue() / case.lebesgue;
        assert!((1.0 - 1e-13..1.0 + 2e-3).contains(&ratio), "{}: {ratio}", case.name);
    }
}

fn pair(re: f64, im: f64) -> [Root; 2] {
    [Root { re, im }, Root { re, im: -im }]
}

fn list(roots: &[Root]) -> Roots {
    Roots::new(roots, "roots").expect("closed under conjugation")
}

/// A list of 3 to 8 roots that is closed under conjugation and negation, |im| < π, |re| ≤ 4.
fn random_list(random: &mut Random) -> Roots {
    let order = 3 + random.below(6);
    let mut roots = Vec::new();
    let kinds = 1 + random.below(7);
    while roots.len() < order {
        let room = order - roots.len();
        let im = PI * random.unit();
        let re = 4.0 * random.unit();
        match random.below(4) {
            0 if kinds & 1 > 0 && room >= 2 => roots.extend(pair(0.0, im)),
            1 if kinds & 2 > 0 && room >= 2 => {
                roots.extend([Root { re, im: 0.0 }, Root { re: -re, im: 0.0 }])
            }
            2 if kinds & 4 > 0 && room >= 4 => roots.extend([pair(re, im), pair(-re, im)].concat()),
            _ => roots.push(Root::default()),
        }
        // Some come again, and some almost.
        if random.below(4) == 0 && roots.len() + 2 <= order {
            let near = if random.below(2) == 0 { 0.0 } else { 1e-7 };
            roots.extend(pair(0.0, (im + near).min(3.14)));
        }
    }
    list(&roots)
}

#[test]
fn ten_thousand_random_lists_below_pi_all_interpolate() {
    let mut random = Random::new(1);
    let mut worst: f64 = 0.0;
    for case in 0..10_000 {
        let roots = random_list(&mut random);
        let phi = Interpolator::new(&roots);
        let phi = match unboxed(phi) {
            Ok(phi) => phi,
            Err(error) => panic!("case {case}: {roots:?}: {error}"),
        };
        let lebesgue = phi.lebesgue();
        for k in 1 - (phi.support() as i32)..=phi.support() as i32 {
            // From the right, and from the left on the half interval before it.
            let before = phi.half_piece(2 * k as isize - 1).iter().rev().fold(0.0, |sum, c| 0.25 * sum + c);
            for value in [before, phi.at(f64::from(k), 0)] {
                if k == 0 {
                    assert!(
                        (value - 1.0).abs() < 1e-10_f64.min(2e-16 * (1.0 + lebesgue)),
                        "case {case}: {value} at 0"
                    );
                } else {
                    assert_eq!(value, 0.0, "case {case}: {roots:?} at {k}");
                }
            }
        }
        // In between, the functions of the roots come back as far as the weights let them.
        let (re, im) = (roots.as_slice()[0].re, roots.as_slice()[0].im);
        let x = random.unit();
        let reach = phi.support() as i32;
        let (mut sum, mut size) = (0.0, 0.0_f64);
        for k in 1 - reach..=reach {
            let value = (re * f64::from(k)).exp() * (im * f64::from(k)).cos();
            sum += value * phi.at(x - f64::from(k), 0);
            size = size.max(value.abs());
        }
        let off = (sum - (re * x).exp() * (im * x).cos()).abs();
        worst = worst.max(off / (size * lebesgue));
        assert!(
            off < 1e-13 * size * lebesgue,
            "case {case}: {roots:?}: off by {off:e} of {size} and {lebesgue}"
        );
    }
    println!("worst {worst:e}");
}
