//! Interpolators of compact support, against 50 digits and against what defines them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::{PI, TAU};

use crate::support::curves::Random;
use crate::support::{golden, roots, tolerance, unboxed};
use expline::Error;
use expline::generator::{ExponentialBSpline, Interpolator, Root, Roots};
use serde::Deserialize;

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
    golden::parse(include_str!("../golden/splines/interpolators.json"))
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
        let own = phi.riesz_bounds();
        let spline = phi.b_spline().riesz_bounds();
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
            roots.extend(pair(0.0, (im + near).min(3.1399)));
        }
    }
    list(&roots)
}

#[test]
fn ten_thousand_random_lists_below_pi_all_interpolate() {
    let mut random = Random::new(1);
    let mut worst: f64 = 0.0;
    // A host of wasm takes its time; the numbers are the same.
    let cases = if cfg!(target_arch = "wasm32") { 1000 } else { 10_000 };
    for case in 0..cases {
        let roots = random_list(&mut random);
        let phi = Interpolator::new(&roots).expect("below π there is one");
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
    assert!(worst < 1e-14, "the worst is {worst:e}");
}

#[test]
fn where_there_is_no_interpolator_the_error_says_so() {
    let refused = |roots: &[Root]| {
        let roots = list(roots);
        assert!(matches!(
            unboxed(Interpolator::new(&roots)),
            Err(Error::OutOfRange { argument: "roots", index: Some(_), .. })
        ));
        unboxed(Interpolator::beyond_pi(&roots))
    };
    let none = |result| matches!(result, Err(Error::Degenerate { argument: "roots", index: None, .. }));
    // The two families against the conjecture of [SFBGU17, sec. 4.2]: the linear system is singular.
    let zero = Root::default();
    assert!(none(refused(&[[zero, zero], pair(0.0, 8.986_818_915_818_128)].concat())));
    for a in [0.1, 0.7, 2.0] {
        assert!(none(refused(&[pair(a, PI), pair(-a, PI)].concat())), "±{a} ± iπ");
        assert!(
            none(refused(&[&[pair(a, PI), pair(-a, PI)].concat()[..], &[zero]].concat())),
            "0, ±{a} ± iπ"
        );
    }
    // No Riesz basis: M = 1, 2 for ±2πi/M, M = 1, 2, 4 for the Roman surface's ±4πi/M.
    assert!(none(refused(&[&[zero], &pair(0.0, TAU)[..]].concat())));
    assert!(none(refused(&[&[zero], &pair(0.0, PI)[..]].concat())));
    // Its M = 3 is beyond π, and there all the same.
    let phi = refused(&[&[zero], &pair(0.0, 2.0 * TAU / 3.0)[..]].concat()).expect("it exists");
    assert!((phi.at(0.0, 0) - 1.0).abs() < 1e-15 && phi.at(1.0, 0) == 0.0, "it interpolates");
}

#[test]
fn far_from_the_axis_and_close_to_it_all_is_well() {
    let zero = Root::default();
    let real = |re: f64| [Root { re, im: 0.0 }, Root { re: -re, im: 0.0 }];
    for roots in [
        [&[zero][..], &real(20.0)].concat(),
        [real(20.0), real(20.0), real(19.0)].concat(),
        [pair(10.0, 3.0), pair(-10.0, 3.0)].concat(),
        [&[zero][..], &pair(0.0, 1e-300)].concat(),
        [&[zero][..], &pair(0.0, 5e-324)].concat(),
        [&[zero][..], &pair(1e-13, 1e-8), &pair(-1e-13, 1e-8)].concat(),
        vec![Root { re: -0.0, im: -0.0 }; 3],
    ] {
        let phi = Interpolator::new(&list(&roots)).expect("it exists");
        assert!((phi.at(0.0, 0) - 1.0).abs() < 1e-15 && phi.at(1.0, 0) == 0.0, "{roots:?} interpolates");
        assert!(phi.lebesgue() < 2.0, "{roots:?}: {}", phi.lebesgue());
        let tiny = roots.iter().all(|r| r.re.abs().max(r.im.abs()) < 1e-7) && roots.len() == 3;
        if tiny {
            assert!((phi.at(0.5, 0) - 0.5625).abs() < 1e-15, "{roots:?} is the polynomial case");
        }
    }
}

#[test]
fn real_roots_as_large_as_any_have_their_interpolator() {
    for (zeros, rate) in [(3, 14.0), (2, 20.0), (4, 11.0), (6, 8.0), (12, 4.0), (14, 1.0)] {
        let ends = [Root { re: rate, im: 0.0 }, Root { re: -rate, im: 0.0 }];
        let roots = list(&[vec![Root::default(); zeros], ends.to_vec()].concat());
        let phi = Interpolator::new(&roots).expect("λ is there, and right");
        // The check itself: some roundings of the transform, of up to 16 factors.
        assert!(phi.identity() < 1e-13, "{zeros} {rate}: {:e}", phi.identity());
        // e^{αt} comes back between the points, to the roundings of what is added up.
        let (reach, x) = (phi.support() as i32, 0.37);
        let (mut sum, mut size) = (0.0, 0.0);
        for k in 1 - reach..=reach {
            let term = (rate * (f64::from(k) - x)).exp() * phi.at(x - f64::from(k), 0);
            (sum, size) = (sum + term, size + term.abs());
        }
        // The tail of φ is right to 1e-15 of its largest value, and e^{20·15} times that is no number to compare with.
        if f64::from(reach) * rate < 30.0 {
            assert!(
                (sum - 1.0).abs() < 1e-13 * size + 1e-15 * (rate * f64::from(reach)).exp(),
                "{zeros} {rate}: {sum}"
            );
        }
    }
}

#[test]
fn lists_that_make_no_sense_are_named() {
    let new = |roots: &[Root]| unboxed(Roots::new(roots, "roots"));
    let zero = Root::default();
    assert!(matches!(new(&[]), Err(Error::TooFewPoints { argument: "roots", got: 0, .. })));
    assert!(matches!(new(&[zero; 17]), Err(Error::LimitExceeded { limit: "maxRoots", .. })));
    assert!(matches!(
        new(&[zero, Root { re: f64::NAN, im: 0.0 }]),
        Err(Error::NotFinite { argument: "roots", index: Some(1) })
    ));
    assert!(matches!(
        new(&[Root { re: 0.0, im: f64::INFINITY }]),
        Err(Error::NotFinite { argument: "roots", index: Some(0) })
    ));
    assert!(matches!(new(&[Root { re: 21.0, im: 0.0 }]), Err(Error::OutOfRange { index: Some(0), .. })));
    assert!(matches!(
        new(&[zero, Root { re: 0.0, im: 1.0 }]),
        Err(Error::Degenerate { argument: "roots", index: Some(1), .. })
    ));
    // Closed under negation is not closed under conjugation.
    assert!(new(&[Root { re: 1.0, im: 2.0 }, Root { re: -1.0, im: -2.0 }]).is_err());
    // A conjugate that is off by roundings is one.
    let near =
        new(&[Root { re: 1e-14, im: 2.0 }, Root { re: 0.0, im: -2.0 - 1e-14 }, zero]).expect("close enough");
    assert!(near.is_symmetric() && near.as_slice()[0].im == -near.as_slice()[1].im, "made exact");
    let interpolator = |roots: &[Root]| unboxed(Interpolator::new(&list(roots)));
    assert!(matches!(interpolator(&[zero, zero]), Err(Error::TooFewPoints { needed: 3, .. })));
    assert!(matches!(
        interpolator(&[zero, zero, Root { re: 0.5, im: 0.0 }]),
        Err(Error::Degenerate { argument: "roots", index: Some(2), .. })
    ));
    let phi = Interpolator::for_ellipse(5).expect("five points");
    assert!(matches!(
        unboxed(phi.evaluate(&[0.0, f64::NAN], 0)),
        Err(Error::NotFinite { index: Some(1), .. })
    ));
    assert!(matches!(
        unboxed(phi.evaluate(&[0.0], 3)),
        Err(Error::OutOfRange { argument: "derivative", .. })
    ));
    assert!(matches!(unboxed(phi.pre_filter(3)), Err(Error::Degenerate { argument: "m0", .. })));
    assert!(matches!(unboxed(phi.pre_filter(0)), Err(Error::OutOfRange { argument: "m0", .. })));
    assert!(matches!(
        unboxed(phi.b_spline().refinement_filter(0)),
        Err(Error::OutOfRange { argument: "m", .. })
    ));
    assert!(matches!(unboxed(phi.b_spline().refinement_filter(1 << 30)), Err(Error::OutOfRange { .. })));
    assert_eq!(phi.b_spline().refinement_filter(1).expect("the identity"), [1.0], "m = 1");
    assert!(matches!(
        unboxed(Interpolator::for_ellipse(2)),
        Err(Error::OutOfRange { argument: "count", .. })
    ));
    assert!(matches!(unboxed(Roots::polynomials(16)), Err(Error::OutOfRange { argument: "degree", .. })));
    assert!(matches!(unboxed(Roots::hyperbola(f64::NAN)), Err(Error::NotFinite { argument: "rate", .. })));
}

#[test]
fn lists_by_intent_hold_what_they_say() {
    let both =
        Roots::union(&[Roots::ellipse(7).expect("in range"), Roots::polynomials(2).expect("in range")]);
    let both = both.expect("five roots");
    assert_eq!(both.order(), 5, "0 three times and the pair once");
    assert!(both.is_symmetric() && both.keeps_constants(), "{both:?}");
    let more =
        Roots::union(&[both.clone(), Roots::harmonics(7, 3).expect("in range"), both]).expect("nine roots");
    assert_eq!(more.order(), 9, "{more:?}");
    let odd = Roots::hyperbola(0.5).expect("in range");
    assert_eq!(odd.as_slice().iter().map(|r| r.re).collect::<Vec<_>>(), [0.0, 0.5, -0.5]);
    let spline = ExponentialBSpline::new(&list(&[Root { re: 0.7, im: 0.0 }])).expect("a box");
    assert!((spline.at(-0.5, 0) - 1.0).abs() < 1e-15 && spline.at(0.5, 0) == 0.0, "from the left end on");
}
