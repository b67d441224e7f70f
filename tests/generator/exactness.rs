//! One segment is exact: the basis against 50 digits and more in all three spaces, and the laws it obeys.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support;
use crate::support::{assert_all_close, generators, golden, space, tolerance};
use expline::generator::{Basis, Space};
use expline::numerics::angle::sin_cos;
use expline::numerics::entire::stumpff;
use serde::Deserialize;

#[derive(Deserialize)]
struct WeightTable {
    x: Vec<f64>,
    cases: Vec<WeightCase>,
}

/// Rows: chord and leaving weight, derivative by derivative.
#[derive(Deserialize)]
struct WeightCase {
    space: String,
    w: f64,
    weights: Vec<Vec<f64>>,
    bernstein: Vec<Vec<f64>>,
}

#[test]
fn weights_and_three_derivatives_agree_with_sixty_digits() {
    let table: WeightTable = golden::parse(include_str!("../golden/splines/weights.json"));
    for case in &table.cases {
        let basis = Basis::new(space(&case.space), case.w);
        for (row, expected) in case.weights.iter().enumerate() {
            let (derivative, which) = (row / 2, row % 2);
            let got: Vec<f64> = table
                .x
                .iter()
                .map(|&x| basis.weights(x, derivative))
                .map(|weights| if which == 0 { weights.chord } else { weights.leaving })
                .collect();
            let largest = expected.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
            for ((got, expected), x) in got.iter().zip(expected).zip(&table.x) {
                let deviation = (got - expected).abs() / largest;
                assert!(
                    deviation <= tolerance::WEIGHTS,
                    "{} w = {} x = {x} derivative {derivative}, {which}: {got} for {expected}, {deviation:e}",
                    case.space,
                    case.w
                );
            }
        }
    }
}

#[test]
fn bernstein_functions_agree_with_sixty_digits_in_all_spaces() {
    let table: WeightTable = golden::parse(include_str!("../golden/splines/weights.json"));
    for case in &table.cases {
        let basis = Basis::new(space(&case.space), case.w);
        for (derivative, expected) in case.bernstein.chunks(2).enumerate() {
            let largest = expected.iter().flatten().fold(0.0_f64, |most, v| most.max(v.abs()));
            for (i, &x) in table.x.iter().enumerate() {
                let got = basis.bernstein(x, derivative);
                for (got, expected) in [(got[1], expected[0][i]), (got[3], expected[1][i])] {
                    let deviation = (got - expected).abs() / largest;
                    assert!(
                        deviation <= tolerance::VALUES,
                        "{} w = {} x = {x} derivative {derivative}: {got} for {expected}, {deviation:e}",
                        case.space,
                        case.w
                    );
                }
            }
        }
    }
}

/// Frequencies of every regime, and both sides of every switch from one formula to another.
fn frequencies() -> Vec<(Space, f64)> {
    let mut list = vec![(Space::Polynomial, 0.0), (Space::Polynomial, 3.0)];
    for w in [0.0, 1e-155, 1e-8, 1e-3, 0.3, 1.0, 2.0, 3.0, 3.2, 4.5, 5.9, 6.2] {
        list.push((Space::Trigonometric, w));
    }
    for w in [1e-155, 1e-8, 1e-3, 0.3, 1.0, 2.0, 3.0, 3.2, 5.0, 12.0, 50.0, 709.0, 711.0, 1e4] {
        list.push((Space::Hyperbolic, w));
    }
    for w in [core::f64::consts::PI, core::f64::consts::FRAC_PI_2] {
        for near in [w.next_down(), w, w.next_up()] {
            list.extend([(Space::Trigonometric, near), (Space::Hyperbolic, near)]);
        }
    }
    list
}

#[test]
fn ends_are_interpolated_to_the_last_bit() {
    for (space, w) in frequencies() {
        let basis = Basis::new(space, w);
        let at = |x: f64, d: usize| {
            let weights = basis.weights(x, d);
            [weights.chord, weights.leaving, weights.arriving]
        };
        assert_eq!(at(0.0, 0), [0.0, 0.0, 0.0], "{space:?} {w} at the start");
        assert_eq!(at(1.0, 0), [1.0, 0.0, 0.0], "{space:?} {w} at the end");
        assert_eq!(at(0.0, 1), [0.0, 1.0, 0.0], "{space:?} {w} leaving");
        assert_eq!(at(1.0, 1), [0.0, 0.0, 1.0], "{space:?} {w} arriving");
    }
}

/// The largest weight of this order on the segment, at least 1.
fn largest(basis: &Basis, derivative: usize) -> f64 {
    if derivative == 4 {
        return basis.square().abs() * largest(basis, 2);
    }
    (0..=16)
        .map(|k| basis.weights(f64::from(k) / 16.0, derivative))
        .fold(1.0, |most: f64, w| most.max(w.chord.abs()).max(w.leaving.abs()))
}

#[test]
fn nothing_jumps_where_one_formula_takes_over_from_another() {
    // The switches: w·x = π/2 inside a segment, w = π in the constants, x = 1/2 between the two halves.
    for (space, w) in frequencies().into_iter().filter(|&(_, w)| w > 1e-3) {
        let basis = Basis::new(space, w);
        for x in [0.5, core::f64::consts::FRAC_PI_2 / w, 1.0 - core::f64::consts::FRAC_PI_2 / w] {
            if !(0.0..1.0).contains(&x) {
                continue;
            }
            for derivative in 0..4 {
                let (before, after) =
                    (basis.weights(x.next_down(), derivative), basis.weights(x.next_up(), derivative));
                // A step of two ulps in x, and what every weight may be off anywhere.
                let bound = 4e-16 * largest(&basis, derivative + 1)
                    + tolerance::WEIGHTS * largest(&basis, derivative);
                for (before, after) in [
                    (before.chord, after.chord),
                    (before.leaving, after.leaving),
                    (before.arriving, after.arriving),
                ] {
                    assert!(
                        (before - after).abs() <= bound,
                        "{space:?} {w} x {x} d{derivative}: {before} {after}"
                    );
                }
            }
        }
    }
    for w in [core::f64::consts::PI, core::f64::consts::FRAC_PI_2, 1e-8, 1e-154] {
        for space in [Space::Trigonometric, Space::Hyperbolic] {
            let (below, above) = (Basis::new(space, w * (1.0 - 1e-15)), Basis::new(space, w * (1.0 + 1e-15)));
            for k in 0..=64 {
                let x = f64::from(k) / 64.0;
                let (below, above) = (below.weights(x, 0), above.weights(x, 0));
                for jump in [
                    below.chord - above.chord,
                    below.leaving - above.leaving,
                    below.arriving - above.arriving,
                ] {
                    assert!(jump.abs() <= 1e-15, "{space:?} w = {w}, x = {x}: jump {jump:e}");
                }
            }
        }
    }
}

#[test]
fn frequencies_too_small_to_have_a_square_give_the_cubic_to_the_last_bit() {
    let cubic = Basis::new(Space::Polynomial, 0.0);
    for space in [Space::Trigonometric, Space::Hyperbolic] {
        for w in [0.0, 5e-324, 1e-300, 1e-155, 1e-9] {
            let basis = Basis::new(space, w);
            for k in 0..=32 {
                for derivative in 0..4 {
                    let x = f64::from(k) / 32.0;
                    assert_eq!(
                        basis.weights(x, derivative),
                        cubic.weights(x, derivative),
                        "{space:?} {w} {x}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_largest_hyperbolic_frequency_gives_the_polyline() {
    let basis = Basis::new(Space::Hyperbolic, 1e4);
    for k in 0..=1000 {
        let x = f64::from(k) / 1000.0;
        let weights = basis.weights(x, 0);
        assert!((weights.chord - x).abs() < 1.1e-4, "chord at {x}: {}", weights.chord);
        assert!(weights.leaving.abs() < 1.1e-4 && weights.arriving.abs() < 1.1e-4, "tangents at {x}");
    }
}

#[test]
fn taylor_s_formula_holds_in_every_space() {
    // (D 2.3) from the middle: four derivatives there and Stumpff's functions give the whole segment.
    for (space, w) in frequencies().into_iter().filter(|&(_, w)| w < 7.0) {
        let basis = Basis::new(space, w);
        let middle: Vec<_> = (0..4).map(|d| basis.weights(0.5, d)).collect();
        // Near the pole the values themselves are large.
        let scale = 1.0 + 8.0 * middle[0].leaving.abs();
        for j in 0..=128 {
            let x = f64::from(j) / 128.0;
            let t = x - 0.5;
            let c = stumpff(basis.square() * t * t);
            let (first, second, third) = (t * c.c1, t * t * c.c2, t * t * t * c.c3);
            let (expected, slope) = (basis.weights(x, 0), basis.weights(x, 1));
            let got = middle[0].leaving
                + t * middle[1].leaving
                + second * middle[2].leaving
                + third * middle[3].leaving;
            assert!((got - expected.leaving).abs() < 4e-16 * scale, "{space:?} {w} {x}: {got} {expected:?}");
            let got = middle[1].chord + first * middle[2].chord + second * middle[3].chord;
            assert!((got - slope.chord).abs() < 3e-15 * scale, "{space:?} {w} {x}: {got} {slope:?}");
        }
    }
}

#[derive(Deserialize)]
struct HermiteFile {
    cases: Vec<HermiteCase>,
    rescaled: Vec<RescaledCase>,
    curves: Vec<CurveCase>,
    normalised_bsplines: Vec<BSplineCase>,
}

#[derive(Deserialize)]
struct HermiteCase {
    w0: f64,
    x: Vec<f64>,
    phi1: Vec<f64>,
    phi2: Vec<f64>,
    dphi1: Vec<f64>,
    dphi2: Vec<f64>,
    d2phi1: Vec<f64>,
    d2phi2: Vec<f64>,
}

#[derive(Deserialize)]
struct RescaledCase {
    w0: f64,
    h: f64,
    x: Vec<f64>,
    phi1: Vec<f64>,
    phi2: Vec<f64>,
    dphi1: Vec<f64>,
    dphi2: Vec<f64>,
}

#[derive(Deserialize)]
struct CurveCase {
    w0: f64,
    points: Vec<Vec<f64>>,
    tangents: Vec<Vec<f64>>,
    t: Vec<f64>,
    r: Vec<Vec<f64>>,
    dr: Vec<Vec<f64>>,
    d2r: Vec<Vec<f64>>,
}

#[derive(Deserialize)]
struct BSplineCase {
    w0: f64,
    x: Vec<f64>,
    #[serde(rename = "B4")]
    b4: Vec<f64>,
    #[serde(rename = "B3")]
    b3: Vec<f64>,
    gamma1: f64,
    mu1_deg2: f64,
}

fn hermite_file() -> HermiteFile {
    golden::parse(include_str!("../golden/splines/hermite.json"))
}

#[test]
fn generators_and_their_derivatives_agree_with_fifty_digits() {
    for case in hermite_file().cases {
        let generators = generators(Space::Trigonometric, case.w0);
        let expected = [(case.phi1, case.phi2), (case.dphi1, case.dphi2), (case.d2phi1, case.d2phi2)];
        for (derivative, (first, second)) in expected.iter().enumerate() {
            let got = generators.evaluate(&case.x, derivative).expect("the places are finite");
            let bound = if derivative < 2 { tolerance::VALUES } else { tolerance::SECOND_DERIVATIVES };
            assert_all_close(&format!("phi1, w {}, d{derivative}", case.w0), &got.0, first, bound);
            assert_all_close(&format!("phi2, w {}, d{derivative}", case.w0), &got.1, second, bound);
        }
    }
}

#[test]
fn generators_on_a_grid_of_another_step_are_the_same_functions_rescaled() {
    for case in hermite_file().rescaled {
        let generators = generators(Space::Trigonometric, case.w0 * case.h);
        let places: Vec<f64> = case.x.iter().map(|x| x / case.h).collect();
        let (first, second) = generators.evaluate(&places, 0).expect("the places are finite");
        let second: Vec<f64> = second.iter().map(|v| v * case.h).collect();
        assert_all_close("phi1", &first, &case.phi1, tolerance::VALUES);
        assert_all_close("phi2", &second, &case.phi2, tolerance::VALUES);
        let (first, second) = generators.evaluate(&places, 1).expect("the places are finite");
        let first: Vec<f64> = first.iter().map(|v| v / case.h).collect();
        assert_all_close("phi1'", &first, &case.dphi1, tolerance::VALUES);
        assert_all_close("phi2'", &second, &case.dphi2, tolerance::VALUES);
    }
}

#[test]
fn curves_in_the_plane_and_in_space_agree_with_fifty_digits() {
    for case in hermite_file().curves {
        let generators = generators(Space::Trigonometric, case.w0);
        let count = case.points.len();
        for (derivative, expected) in [&case.r, &case.dr, &case.d2r].into_iter().enumerate() {
            let bound = if derivative < 2 { tolerance::VALUES } else { tolerance::SECOND_DERIVATIVES };
            for axis in 0..case.points[0].len() {
                let component = |rows: &[Vec<f64>]| rows.iter().map(|row| row[axis]).collect::<Vec<f64>>();
                let got: Vec<f64> = case
                    .t
                    .iter()
                    .map(|&t| {
                        // Every shift of the generators that reaches t, on a closed curve of `count` points.
                        let n = t.floor() as usize;
                        (0..2)
                            .map(|k| {
                                let (one, two) = generators.at(t - (n + k) as f64, derivative);
                                let i = (n + k) % count;
                                one * case.points[i][axis] + two * case.tangents[i][axis]
                            })
                            .sum()
                    })
                    .collect();
                let largest = 1.0_f64.max(support::scale(&expected.concat()));
                for (got, expected) in got.iter().zip(component(expected)) {
                    assert!((got - expected).abs() <= bound * largest, "d{derivative}: {got} for {expected}");
                }
            }
        }
    }
}

#[test]
fn exponential_b_splines_in_terms_of_the_generators_agree_with_fifty_digits() {
    for case in hermite_file().normalised_bsplines {
        let generators = generators(Space::Trigonometric, case.w0);
        let b4: Vec<f64> = case.x.iter().map(|&x| generators.b_spline4(x, 0)).collect();
        let b3: Vec<f64> = case.x.iter().map(|&x| generators.b_spline3(x, 0)).collect();
        let (gamma, mu) = generators.b_spline_weights();
        assert_all_close("B4", &b4, &case.b4, tolerance::VALUES);
        assert_all_close("B3", &b3, &case.b3, tolerance::VALUES);
        assert_all_close("weights", &[gamma, mu], &[case.gamma1, case.mu1_deg2], tolerance::VALUES);
    }
}

#[derive(Deserialize)]
struct BernsteinFile {
    cases: Vec<BernsteinCase>,
    conversions: Vec<ConversionCase>,
}

#[derive(Deserialize)]
struct BernsteinCase {
    w0: f64,
    kappa: f64,
    x: Vec<f64>,
    b0: Vec<f64>,
    b1: Vec<f64>,
    b2: Vec<f64>,
    b3: Vec<f64>,
    db0: Vec<f64>,
    db1: Vec<f64>,
    db2: Vec<f64>,
    db3: Vec<f64>,
}

#[derive(Deserialize)]
struct ConversionCase {
    w0: f64,
    h: f64,
    f0: f64,
    d0: f64,
    f1: f64,
    d1: f64,
    bezier: Vec<f64>,
    t: Vec<f64>,
    value: Vec<f64>,
}

#[test]
fn bernstein_functions_and_kappa_agree_with_fifty_digits() {
    let file: BernsteinFile = golden::parse(include_str!("../golden/splines/bernstein.json"));
    for case in file.cases {
        let generators = generators(Space::Trigonometric, case.w0);
        assert_all_close("kappa", &[generators.basis().kappa()], &[case.kappa], tolerance::VALUES);
        let expected =
            [[&case.b0, &case.b1, &case.b2, &case.b3], [&case.db0, &case.db1, &case.db2, &case.db3]];
        for (derivative, expected) in expected.iter().enumerate() {
            let got = generators.bernstein(&case.x, derivative).expect("the places are in [0, 1]");
            for (k, expected) in expected.iter().enumerate() {
                let got: Vec<f64> = got.iter().skip(k).step_by(4).copied().collect();
                assert_all_close(
                    &format!("b{k} d{derivative} w {}", case.w0),
                    &got,
                    expected,
                    tolerance::VALUES,
                );
            }
        }
    }
}

#[test]
fn bernstein_form_and_hermite_form_are_the_same_segment() {
    let file: BernsteinFile = golden::parse(include_str!("../golden/splines/bernstein.json"));
    for case in file.conversions {
        let basis = Basis::new(Space::Trigonometric, case.w0 * case.h);
        let reach = case.h * basis.kappa();
        let ordinates = [case.f0, case.f0 + reach * case.d0, case.f1 - reach * case.d1, case.f1];
        assert_all_close("ordinates", &ordinates, &case.bezier, tolerance::VALUES);
        for (&t, &expected) in case.t.iter().zip(&case.value) {
            let sum: f64 = basis.bernstein(t, 0).iter().zip(&ordinates).map(|(b, p)| b * p).sum();
            assert_all_close("value", &[sum], &[expected], tolerance::VALUES);
        }
    }
}

#[test]
fn sine_and_cosine_are_right_to_the_last_place_next_to_every_multiple_of_a_quarter_turn_too() {
    let mut angles = vec![0.0, 1e-300, 0.5, 1.0, 2.0, 3.0, 1e3, 12_345.678, 1e6, 1e9, -0.7, -1e5];
    for k in -40..=40 {
        let quarter = f64::from(k) * core::f64::consts::FRAC_PI_2;
        angles.extend([quarter.next_down(), quarter, quarter.next_up(), quarter + 1e-7, quarter + 0.4]);
    }
    for angle in angles {
        // The package libm is the oracle: it follows another algorithm, with a reduction to any size.
        let (sine, cosine) = sin_cos(angle);
        for (got, expected) in [(sine, libm::sin(angle)), (cosine, libm::cos(angle))] {
            let deviation = (got - expected).abs();
            assert!(deviation <= 2.3e-16 * expected.abs(), "{angle}: {got} for {expected}");
        }
    }
    assert_eq!(sin_cos(f64::NAN), (0.0, 1.0), "no angle at all");
    assert_eq!(sin_cos(1e300), (0.0, 1.0), "an angle that is no direction any more");
}
