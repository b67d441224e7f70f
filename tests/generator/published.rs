//! What is printed in [CRU15], number by number: reproduced where it is right, shown wrong where we correct it.
//!
//! The misprints are listed in docs/SOURCES.md, each with the name of its test here.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::{generators, tolerance};
use core::f64::consts::PI;
use expline::generator::{Basis, HermiteGenerators, Space};
use expline::refine::{HermiteData, ScalarMask, control_polygon, subdivide_hermite, subdivide_scalar};
use nalgebra::{Complex, Vector2};

/// The printed closed forms lose eps·ω⁻² and more at small ω, and nothing to speak of from here on.
const FREQUENCIES: [f64; 5] = [1.5, 2.0, 2.0 * PI / 3.0, 2.7, PI];

/// Printed forms in plain double arithmetic: some twenty roundings of terms up to thirty times the result.
const PRINTED: f64 = 2e-14;

fn trigonometric(omega: f64) -> HermiteGenerators {
    generators(Space::Trigonometric, omega)
}

/// s(ω) = 2 sin(ω/2) − ω cos(ω/2), eq. 6.
fn s(w: f64) -> f64 {
    2.0 * (0.5 * w).sin() - w * (0.5 * w).cos()
}

/// e^(i·angle).
fn cis(angle: f64) -> Complex<f64> {
    Complex::new(angle.cos(), angle.sin())
}

fn places() -> impl Iterator<Item = f64> {
    (0..=40).map(|k| f64::from(k) / 40.0)
}

#[test]
fn complex_coefficients_of_equations_3_and_4_are_right() {
    let i = Complex::new(0.0, 1.0);
    for w in FREQUENCIES {
        let turn = cis(w);
        let p = turn * turn * (i * w - 1.0) + i * w + 1.0;
        let q = turn * (i * w - 2.0) + i * w + 2.0;
        let first = [
            (i * w + 1.0 + turn * (i * w - 1.0)) / q,
            -i * w * (turn + 1.0) / q,
            Complex::from(1.0) / q,
            -turn / q,
        ];
        let bottom = i * w * (turn - 1.0) * q;
        let second = [
            p / bottom,
            -(turn - 1.0) / q,
            (turn - i * w - 1.0) / bottom,
            -turn * (turn * (i * w - 1.0) + 1.0) / bottom,
        ];
        for x in places().take(40) {
            let got = trigonometric(w).at(x, 0);
            for (got, c) in [(got.0, first), (got.1, second)] {
                let printed = c[0] + c[1] * x + c[2] * cis(w * x) + c[3] * cis(-w * x);
                assert!((got - printed.re).abs() < PRINTED, "w {w} x {x}: {got} for {printed}");
                assert!(printed.im.abs() < PRINTED, "the printed sum is real");
            }
        }
    }
}

#[test]
fn real_forms_of_equations_5_to_7_are_right() {
    for w in FREQUENCIES {
        let (sine, cosine) = w.sin_cos();
        let (half_sine, half_cosine) = (0.5 * w).sin_cos();
        let t = 2.0 * half_sine + w * half_cosine;
        let u = w * sine - 2.0 * (1.0 - cosine);
        let v = 2.0 * sine + w * (1.0 - cosine);
        for x in places().take(40) {
            let got = trigonometric(w).at(x, 0);
            let first = 1.0 - half_sine / s(w) + w * half_cosine / s(w) * x + (0.5 * w - w * x).sin() / s(w);
            let bracket = w * w * half_cosine * (w * (1.0 - x)).cos()
                + half_sine * ((w * x).sin() * u - (w * x).cos() * v);
            let second = (sine - w * cosine) / (w * u) + half_sine / s(w) * x
                - bracket / (2.0 * w * half_sine * s(w) * t);
            assert!((got.0 - first).abs() < PRINTED, "g1, w {w} x {x}: {} for {first}", got.0);
            assert!((got.1 - second).abs() < PRINTED, "g2, w {w} x {x}: {} for {second}", got.1);
        }
    }
}

#[test]
fn section_2_the_second_generator_interpolates_slopes_and_not_values() {
    // Printed: φ₂(n) = δₙ and φ₂′(n) = 0. Right, as in section 3: φ₂(n) = 0 and φ₂′(n) = δₙ.
    for w in FREQUENCIES {
        let generators = trigonometric(w);
        for n in [-1.0, 0.0, 1.0] {
            let delta = if n == 0.0 { 1.0 } else { 0.0 };
            let (value, slope) = (generators.at(n, 0), generators.at(n, 1));
            assert_eq!((value.0, slope.0), (delta, 0.0), "phi1 at {n}");
            assert_eq!((value.1, slope.1), (0.0, delta), "phi2 at {n}");
        }
    }
}

#[test]
fn green_s_functions_are_those_of_equations_13_and_14() {
    for w in FREQUENCIES {
        let x: Vec<f64> = (-30..=30).map(|k| f64::from(k) / 10.0).collect();
        let (first, second) = trigonometric(w).greens(&x).expect("the places are finite");
        for ((x, first), second) in x.iter().zip(first).zip(second) {
            let sign = if *x < 0.0 { -1.0 } else { 1.0 };
            let printed = (w * x - (w * x).sin()) / (2.0 * w.powi(3)) * sign;
            assert!((first - printed).abs() < PRINTED, "rho1 at {x}: {first} for {printed}");
            let printed = (1.0 - (w * x).cos()) / (2.0 * w * w) * sign;
            assert!((second - printed).abs() < PRINTED, "rho2 at {x}: {second} for {printed}");
        }
    }
}

/// ρ₁ and ρ₂ at one place.
fn greens(generators: &HermiteGenerators, x: f64) -> (f64, f64) {
    let (first, second) = generators.greens(&[x]).expect("the place is finite");
    (first[0], second[0])
}

#[test]
fn b_splines_of_equations_23_and_24_are_the_differences_of_equations_21_and_22() {
    for w in FREQUENCIES {
        let generators = trigonometric(w);
        let scale = (0.5 * w / (0.5 * w).sin()).powi(2);
        // Δ over (0, ω, −ω) and over (0, 0, ω, −ω), multiplied out.
        let pair = [1.0, -2.0 * w.cos(), 1.0];
        let times = |a: &[f64]| -> Vec<f64> {
            (0..=a.len()).map(|k| a.get(k).unwrap_or(&0.0) - if k > 0 { a[k - 1] } else { 0.0 }).collect()
        };
        let third = times(&pair);
        let fourth = times(&third);
        for k in 0..=160 {
            let x = f64::from(k) / 40.0;
            let b3: f64 =
                third.iter().zip(0..).map(|(c, n)| c * greens(&generators, x - f64::from(n)).1).sum();
            let b4: f64 =
                fourth.iter().zip(0..).map(|(c, n)| c * greens(&generators, x - f64::from(n)).0).sum();
            assert!((generators.b_spline3(x, 0) - scale * b3).abs() < PRINTED, "B3, w {w} x {x}");
            assert!((generators.b_spline4(x, 0) - scale * b4).abs() < PRINTED, "B4, w {w} x {x}");
        }
        let (gamma, mu) = generators.b_spline_weights();
        let printed = (w - w.sin()) / (4.0 * w * (0.5 * w).sin().powi(2));
        assert!((gamma - printed).abs() < PRINTED, "gamma, w {w}");
        assert!((mu - 0.5 * w / (0.5 * w).tan()).abs() < PRINTED, "mu, w {w}");
    }
}

#[test]
fn equation_27_needs_a_central_first_and_a_centred_second_difference() {
    for w in FREQUENCIES {
        let generators = trigonometric(w);
        let (sine, cosine) = (0.5 * w).sin_cos();
        let (one, two) = (|x: f64| greens(&generators, x).0, |x: f64| greens(&generators, x).1);
        let mut printed_worst = 0.0_f64;
        for k in -80..=80 {
            let x = f64::from(k) / 40.0;
            let expected = generators.at(x, 0).0;
            let corrected = w * w / s(w)
                * (sine * (two(x + 1.0) - two(x - 1.0))
                    - w * cosine * (one(x + 1.0) - 2.0 * one(x) + one(x - 1.0)));
            let printed = w * w / s(w)
                * (sine * (two(x) - two(x - 1.0))
                    - w * cosine * (one(x) - 2.0 * one(x - 1.0) + one(x - 2.0)));
            assert!((corrected - expected).abs() < PRINTED, "w {w} x {x}: {corrected} for {expected}");
            printed_worst = printed_worst.max((printed - expected).abs());
        }
        assert!(printed_worst > 0.5, "as printed it is off by {printed_worst}");
    }
}

#[test]
fn equation_28_needs_a_central_first_difference() {
    for w in FREQUENCIES {
        let generators = trigonometric(w);
        let (sine, cosine) = (0.5 * w).sin_cos();
        let (one, two) = (|x: f64| greens(&generators, x).0, |x: f64| greens(&generators, x).1);
        let mut printed_worst = 0.0_f64;
        for k in -80..=80 {
            let x = f64::from(k) / 40.0;
            let expected = generators.at(x, 0).1;
            let rest = cosine * (two(x + 1.0) - 2.0 * two(x) + two(x - 1.0))
                - w / (2.0 * sine) * (two(x + 1.0) - 2.0 * w.cos() * two(x) + two(x - 1.0));
            let corrected = w / s(w) * (w * sine * (one(x + 1.0) - one(x - 1.0)) + rest);
            let printed = w / s(w) * (w * sine * (one(x) - one(x - 1.0)) + rest);
            assert!((corrected - expected).abs() < PRINTED, "w {w} x {x}: {corrected} for {expected}");
            printed_worst = printed_worst.max((printed - expected).abs());
        }
        assert!(printed_worst > 0.1, "as printed it is off by {printed_worst}");
    }
}

#[test]
fn closed_forms_of_the_gram_entries_in_section_5_are_right() {
    for w in FREQUENCIES {
        let gram = trigonometric(w).gram();
        let (sine, cosine) = w.sin_cos();
        let (half, half_cosine) = (0.5 * w).sin_cos();
        let (three, three_cosine) = (1.5 * w).sin_cos();
        let ss = s(w) * s(w);
        let a =
            (w * (w * w - 18.0) * cosine - 6.0 * (w * w - 5.0) * sine + w * (w * w - 12.0)) / (12.0 * w * ss);
        let b =
            (w * (w * w + 3.0) * cosine - 3.0 * (w * w + 5.0) * sine + w * (w * w + 12.0)) / (3.0 * w * ss);
        let c = (5.0 * w * (w * w + 3.0) * half_cosine + w * (w * w - 15.0) * three_cosine
            - 72.0 * half
            - 6.0 * (w * w - 4.0) * three)
            / (24.0 * w * w * half * ss);
        let bottom = w.powi(3) * half * half * ss;
        let (sine2, cosine2) = (2.0 * w).sin_cos();
        let d = (6.0 * (7.0 * w * w + 6.0) * sine + 6.0 * (w * w - 3.0) * sine2
            - w * (2.0 * (7.0 * w * w - 30.0) * cosine + (w * w - 12.0) * cosine2 + 3.0 * (w * w + 24.0)))
            / (48.0 * bottom);
        let e = (-12.0 * (2.0 * w * w + 3.0) * sine - 3.0 * (5.0 * w * w - 6.0) * sine2
            + 2.0 * w * (2.0 * (w * w + 9.0) * cosine + (w * w - 18.0) * cosine2 + 6.0 * w * w))
            / (24.0 * bottom);
        let got = [gram.a, gram.b, gram.c, gram.d, gram.e];
        for (name, (got, printed)) in ["a", "b", "c", "d", "e"].iter().zip(got.iter().zip([a, b, c, d, e])) {
            // The printed forms cancel to eps·ω⁻⁷.
            assert!((got / printed - 1.0).abs() < 1e-11, "{name} at {w}: {got} for {printed}");
        }
    }
}

#[test]
fn theorem_1_the_lower_bound_of_the_determinant_increases_with_the_frequency() {
    let bound = |w: f64| {
        let g = trigonometric(w).gram();
        let a = 2.0 * (g.a * g.d + g.c * g.c);
        let b = 2.0 * (g.a * g.e + g.b * g.d);
        let c = 2.0 * (g.a * g.d - g.c * g.c) + g.b * g.e;
        assert!(b <= 0.0 && a >= 0.0, "so that the bound is C + B − A");
        c + b - a
    };
    assert!((bound(0.0) - 29.0 / 6300.0).abs() < 1e-16, "G(0) is 29/6300");
    for k in 0..62 {
        let w = f64::from(k) * 0.05;
        assert!(bound(w + 0.05) > bound(w), "G increases at {w}");
    }
}

#[test]
fn proposition_2_and_remark_5_the_limit_is_the_cubic() {
    for w in [0.0, 1e-9, 1e-5] {
        let generators = trigonometric(w);
        for x in places().take(40) {
            let got = generators.at(x, 0);
            assert!((got.0 - (2.0 * x + 1.0) * (x - 1.0).powi(2)).abs() < 1e-11, "phi1 at {x}");
            assert!((got.1 - x * (x - 1.0).powi(2)).abs() < 1e-11, "phi2 at {x}");
        }
        assert!((generators.basis().kappa() - 1.0 / 3.0).abs() < 1e-11, "kappa is 1/3");
    }
}

#[test]
fn remark_2_the_order_of_approximation_is_four() {
    // One component of a closed curve, e^(sin t)·cos t, sampled at N points: the deviation falls sixteenfold.
    let f = |t: f64| t.sin().exp() * t.cos();
    let df = |t: f64| t.sin().exp() * (t.cos().powi(2) - t.sin());
    let deviation = |count: usize| {
        let step = 2.0 * PI / count as f64;
        let basis = Basis::new(Space::Trigonometric, step);
        let mut worst = 0.0_f64;
        for n in 0..count {
            let (t0, t1) = (n as f64 * step, (n + 1) as f64 * step);
            for x in places() {
                let w = basis.weights(x, 0);
                let value =
                    f(t0) + (f(t1) - f(t0)) * w.chord + (df(t0) * w.leaving + df(t1) * w.arriving) * step;
                worst = worst.max((value - f(t0 + x * step)).abs());
            }
        }
        worst
    };
    let mut before = deviation(32);
    for count in [64, 128, 256, 512] {
        let now = deviation(count);
        let order = (before / now).log2();
        assert!((order - 4.0).abs() < 0.1, "order {order} from {count} points");
        before = now;
    }
}

/// Closed data of one component, doubled into the plane.
fn closed_data(omega: f64) -> HermiteData {
    let values = [(-1.0, 0.5), (0.25, 1.5), (2.0, -0.75), (0.5, -2.0), (-0.5, 1.0)];
    let derivatives: Vec<_> = values.iter().map(|&(_, d)| Vector2::new(d, 0.5 * d)).collect();
    HermiteData {
        space: Space::Trigonometric,
        closed: true,
        points: values.iter().map(|&(f, _)| Vector2::new(f, 0.5 * f)).collect(),
        leaving: derivatives.clone(),
        arriving: derivatives,
        omega: vec![omega; values.len()],
        lengths: vec![1.0; values.len()],
    }
}

#[test]
fn equation_34_needs_the_index_n_minus_m_l() {
    let (omega, arity) = (2.5, 3_isize);
    let data = closed_data(omega);
    let masks = trigonometric(omega).mask(3, 0).expect("the arity is in range");
    let tap = |n: isize| match usize::try_from(n + arity - 1) {
        Ok(k) if k < 5 => [masks[4 * k], masks[4 * k + 1], masks[4 * k + 2], masks[4 * k + 3]],
        _ => [0.0; 4],
    };
    let count = data.points.len() as isize;
    let at = |l: isize| l.rem_euclid(count) as usize;
    let expected = subdivide_hermite(&data, 3, 1).expect("in range");
    let (mut worst, mut printed_worst) = (0.0_f64, 0.0_f64);
    for (n, point) in expected.points.iter().enumerate() {
        let n = n as isize;
        let sum = |index: &dyn Fn(isize) -> isize| -> f64 {
            (-2 * count..2 * count)
                .map(|l| {
                    let h = tap(index(l));
                    h[0] * data.points[at(l)].x + h[1] * data.leaving[at(l)].x
                })
                .sum()
        };
        worst = worst.max((sum(&|l| n - arity * l) - point.x).abs());
        printed_worst = printed_worst.max((sum(&|l| arity * n - l) - point.x).abs());
    }
    assert!(worst < tolerance::SCHEME_POINTS, "the corrected index gives the samples: {worst:e}");
    assert!(printed_worst > 0.1, "as printed it is off by {printed_worst}");
}

#[test]
fn masks_of_equation_35_and_their_limit_of_remark_3_are_right() {
    for w in FREQUENCIES {
        for level in 0..3_i32 {
            let (local, step) = (w / 2.0_f64.powi(level), 2.0_f64.powi(-level));
            let masks = trigonometric(w).mask(2, level as usize).expect("in range");
            let printed = [
                0.5,
                (0.25 * local).tan() / (2.0 * local) * step,
                -2.0 * local * (0.25 * local).sin().powi(2) / s(local) / step,
                (2.0 * (0.5 * local).sin() - local) / (2.0 * s(local)),
            ];
            for (k, printed) in printed.iter().enumerate() {
                // The printed forms cancel to eps/ω² of the level's frequency.
                assert!((masks[8 + k] - printed).abs() < 1e-12, "entry {k} at level {level}, w {w}");
                let mirrored = if k == 1 || k == 2 { -printed } else { *printed };
                assert!((masks[k] - mirrored).abs() < 1e-12, "entry {k} of H[-1] at level {level}, w {w}");
            }
        }
        let level = 20;
        let masks = trigonometric(w).mask(2, level).expect("in range");
        let step = 2.0_f64.powi(-(level as i32));
        let scaled = [masks[8], masks[9] / step, masks[10] * step, masks[11]];
        for (got, limit) in scaled.iter().zip([0.5, 0.125, -1.5, -0.25]) {
            assert!((got - limit).abs() < 1e-11, "Remark 3: {got} for {limit}");
        }
    }
}

#[test]
fn equation_36_holds_in_its_real_forms_and_needs_an_i_in_the_complex_form_of_b0() {
    let i = Complex::new(0.0, 1.0);
    for w in FREQUENCIES {
        let basis = Basis::new(Space::Trigonometric, w);
        let (half, half_cosine) = (0.5 * w).sin_cos();
        let rest = w - w.sin();
        let turn = cis(w);
        let r = 1.0 + 2.0 * i * w * turn - turn * turn;
        let mut printed_worst = 0.0_f64;
        for x in places() {
            let got = basis.bernstein(x, 0);
            let b3 = w / rest * x - (w * x).sin() / rest;
            let b2 = half / s(w) - 2.0 * w * half.powi(3) / (s(w) * rest) * x
                + (1.0 / rest + half_cosine / s(w)) * (w * x).sin()
                - half / s(w) * (w * x).cos();
            assert!((got[3] - b3).abs() < PRINTED, "b3, w {w} x {x}");
            assert!((got[2] - b2).abs() < PRINTED, "b2, w {w} x {x}");
            let start = 2.0 * i * w * turn / r * (1.0 - x) + cis(w * x) / r;
            let corrected: Complex<f64> = start - turn * turn / r * cis(-w * x);
            let printed: Complex<f64> = start - turn * turn / r * (-w * x).exp();
            assert!(
                (corrected - got[0]).norm_sqr().sqrt() < PRINTED,
                "b0, w {w} x {x}: {corrected} for {}",
                got[0]
            );
            printed_worst = printed_worst.max((printed - got[0]).norm_sqr().sqrt());
        }
        assert!(printed_worst > 0.1, "as printed b0 is off by {printed_worst}");
        let slope = w * (w.cos() - 1.0) / rest;
        let slopes = [basis.bernstein(0.0, 1), basis.bernstein(1.0, 1)];
        for got in [slopes[0][0], slopes[1][2], -slopes[0][1], -slopes[1][3]] {
            assert!((got - slope).abs() < PRINTED, "end slopes: {got} for {slope}");
        }
    }
}

#[test]
fn equations_39_to_42_need_the_frequency_of_the_level() {
    let omega = 2.5;
    let data = closed_data(omega);
    let levels = 3;
    let expected =
        control_polygon(&subdivide_hermite(&data, 2, levels).expect("in range")).expect("in range");
    let distance = |polygon: &[Vector2<f64>]| {
        polygon.iter().zip(&expected).map(|(p, q)| (p - q).norm()).fold(0.0, f64::max)
    };
    let corrected = subdivide_scalar(&data, levels).expect("in range");
    assert!(distance(&corrected) < 4.0 * tolerance::SCHEME_POINTS, "off by {:e}", distance(&corrected));
    // As printed, M has the constant ω: its κ for the right data of the level.
    let mut fine = subdivide_hermite(&data, 2, levels).expect("in range");
    fine.omega.fill(omega * 2.0_f64.powi(levels as i32));
    let printed = control_polygon(&fine).expect("in range");
    assert!(distance(&printed) > 1e-2, "as printed it is off by {}", distance(&printed));
}

#[test]
fn the_scalar_rules_of_the_cubic_are_those_of_schwanecke_and_juttler() {
    let mask = ScalarMask::new(Space::Polynomial, 0.0).expect("in range");
    assert_eq!(mask.reach, 0.5, "3/4 and 1/4 at the old points");
    for (got, expected) in mask.inner.iter().zip([0.125, 0.625, 0.25]) {
        assert!((got - expected).abs() < 1e-15, "{got} for {expected}");
    }
}
