//! One curve at many resolutions: the masks against 50 digits, and schemes that stay on their curve.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::{assert_all_close, generators, golden, tolerance};
use expline::Error;
use expline::generator::{Basis, Space};
use expline::numerics::{Point, Vector};
use expline::refine::{
    HermiteData, MatrixMask, ScalarMask, control_polygon, subdivide_hermite, subdivide_scalar,
};
use serde::Deserialize;

#[derive(Deserialize)]
struct MaskFile {
    dyadic: Vec<DyadicCase>,
    mary: Vec<MaryCase>,
    scalar: Vec<ScalarCase>,
    examples: Vec<ExampleCase>,
}

#[derive(Deserialize)]
struct DyadicCase {
    w0: f64,
    j: u32,
    #[serde(rename = "Hm1")]
    left: Vec<Vec<f64>>,
    #[serde(rename = "Hp1")]
    right: Vec<Vec<f64>>,
}

#[derive(Deserialize)]
struct MaryCase {
    m: usize,
    w0: f64,
    j: u32,
    n: Vec<i32>,
    #[serde(rename = "H")]
    matrices: Vec<Vec<Vec<f64>>>,
}

#[derive(Deserialize)]
struct ScalarCase {
    w: f64,
    rho: f64,
    even: Vec<f64>,
    odd: Vec<f64>,
}

#[derive(Deserialize)]
struct ExampleCase {
    m: usize,
    levels: usize,
    w0: f64,
    data: Vec<Vec<f64>>,
    f: Vec<f64>,
    d: Vec<f64>,
    #[serde(default)]
    scalar_p: Vec<Vec<f64>>,
}

fn mask_file() -> MaskFile {
    golden::parse(include_str!("../golden/splines/masks.json"))
}

#[test]
fn dyadic_masks_at_every_level_agree_with_fifty_digits() {
    for case in mask_file().dyadic {
        let generators = generators(Space::Trigonometric, case.w0);
        let masks = generators.mask(2, case.j as usize).expect("arity and level are in range");
        let what = format!("w {} level {}", case.w0, case.j);
        assert_all_close(&what, &masks[0..4], &case.left.concat(), tolerance::MASKS);
        assert_eq!(masks[4..8], [1.0, 0.0, 0.0, 1.0], "{what}: the old points stay");
        assert_all_close(&what, &masks[8..12], &case.right.concat(), tolerance::MASKS);
    }
}

#[test]
fn masks_of_other_arities_agree_with_fifty_digits() {
    for case in mask_file().mary {
        let generators = generators(Space::Trigonometric, case.w0);
        let masks = generators.mask(case.m, case.j as usize).expect("arity and level are in range");
        assert_eq!(case.n.len() * 4, masks.len(), "one matrix for every n");
        assert_all_close("masks", &masks, &case.matrices.concat().concat(), tolerance::MASKS);
    }
}

#[test]
fn the_mask_of_one_segment_is_the_mask_of_the_generators_at_that_level() {
    for (space, omega) in [(Space::Trigonometric, 2.5), (Space::Hyperbolic, 7.0), (Space::Polynomial, 0.0)] {
        for (arity, level) in [(1, 0), (2, 0), (2, 5), (3, 2), (5, 1), (7, 0)] {
            let step = (arity as f64).powi(-(level as i32));
            let mask = MatrixMask::new(space, omega, step, arity).expect("in range");
            let expected = generators(space, omega).mask(arity, level).expect("in range");
            let reach = arity as isize - 1;
            let got: Vec<f64> = (-reach..=reach).flat_map(|n| mask.matrix(n)).collect();
            assert_all_close("mask", &got, &expected, tolerance::MASKS);
            assert_eq!(mask.matrix(reach + 1), [0.0; 4], "nothing beyond the support");
            assert_eq!(mask.matrix(-reach - 1), [0.0; 4], "nothing beyond the support");
        }
    }
}

#[test]
fn scalar_rules_agree_with_fifty_digits() {
    for case in mask_file().scalar {
        let mask = ScalarMask::new(Space::Trigonometric, case.w).expect("in range");
        let even = [0.5 * (1.0 + mask.reach), 0.5 * (1.0 - mask.reach)];
        assert_all_close("rho", &[mask.reach], &[case.rho], tolerance::MASKS);
        assert_all_close("even rule", &even, &case.even, tolerance::MASKS);
        assert_all_close("odd rule", &mask.inner, &case.odd[..3], tolerance::MASKS);
        assert!(mask.inner.iter().all(|&c| c > 0.0), "every new point lies between old ones");
    }
}

/// Two copies of one golden component as the two coordinates of closed data.
fn data_of(case: &ExampleCase) -> HermiteData {
    let column = |k: usize| case.data.iter().map(|row| Point::new(row[k], -2.0 * row[k])).collect::<Vec<_>>();
    let count = case.data.len();
    HermiteData {
        space: Space::Trigonometric,
        closed: true,
        points: column(0),
        leaving: column(1),
        arriving: column(1),
        omega: vec![case.w0; count],
        lengths: vec![1.0; count],
    }
}

#[test]
fn the_vector_scheme_gives_the_samples_of_the_spline() {
    for case in mask_file().examples {
        let data = data_of(&case);
        let result = subdivide_hermite(&data, case.m, case.levels).expect("the data is in range");
        let values: Vec<f64> = result.points.iter().map(|p| p.x).collect();
        let derivatives: Vec<f64> = result.leaving.iter().map(|d| d.x).collect();
        assert_all_close("values", &values, &case.f, tolerance::SCHEME_POINTS);
        assert_all_close("derivatives", &derivatives, &case.d, tolerance::SCHEME_DERIVATIVES);
    }
}

#[test]
fn the_scalar_scheme_gives_the_control_points_of_every_level() {
    for case in mask_file().examples.iter().filter(|case| !case.scalar_p.is_empty()) {
        let data = data_of(case);
        for (level, expected) in case.scalar_p.iter().enumerate() {
            let polygon = subdivide_scalar(&data, level).expect("the data is in range");
            let got: Vec<f64> = polygon.iter().map(|p| p.x).collect();
            assert_all_close(&format!("level {level}"), &got, expected, tolerance::SCHEME_POINTS);
        }
    }
}

/// Data with corners, mixed frequencies and lengths, in the given space.
fn mixed(space: Space, closed: bool) -> HermiteData {
    let count = 5;
    let at = |k: usize, a: f64, b: f64| Vector::new((a * k as f64 + b).sin(), (b * k as f64 - a).cos());
    let segments = if closed { count } else { count - 1 };
    HermiteData {
        space,
        closed,
        points: (0..count).map(|k| at(k, 1.3, 0.4) * 10.0).collect(),
        leaving: (0..count).map(|k| at(k, 0.7, 1.9) * 5.0).collect(),
        arriving: (0..count).map(|k| if k == 2 { at(k, 2.0, 0.3) } else { at(k, 0.7, 1.9) * 5.0 }).collect(),
        omega: (0..segments).map(|k| [2.0, 0.0, 1.1, 3.0, 3.0][k]).collect(),
        lengths: (0..segments).map(|k| [1.0, 2.0, 0.5, 1.0, 1.0][k]).collect(),
    }
}

fn point_on(data: &HermiteData, segment: usize, x: f64) -> Point {
    let next = (segment + 1) % data.points.len();
    let h = data.lengths[segment];
    let weights = Basis::new(data.space, data.omega[segment] * h).weights(x, 0);
    data.points[segment]
        + (data.points[next] - data.points[segment]) * weights.chord
        + (data.leaving[segment] * weights.leaving + data.arriving[next] * weights.arriving) * h
}

#[test]
fn every_level_of_any_arity_stays_on_a_curve_with_corners_and_mixed_frequencies() {
    for space in [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial] {
        for closed in [true, false] {
            let data = mixed(space, closed);
            for (arity, levels) in [(2, 6), (3, 4), (5, 2), (1, 3)] {
                let result = subdivide_hermite(&data, arity, levels).expect("in range");
                let pieces = arity.pow(levels as u32);
                for (i, point) in result.points.iter().enumerate() {
                    let segment = (i / pieces).min(data.lengths.len() - 1);
                    let x = (i - segment * pieces) as f64 / pieces as f64;
                    let off = (point - point_on(&data, segment, x)).norm();
                    assert!(
                        off < 40.0 * tolerance::SCHEME_POINTS,
                        "{space:?} arity {arity} point {i}: {off:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_circle_of_two_points_keeps_its_radius_through_twenty_levels() {
    let radius = 5.0;
    let turn = core::f64::consts::PI;
    let data = HermiteData {
        space: Space::Trigonometric,
        closed: true,
        points: vec![Point::new(radius, 0.0), Point::new(-radius, 0.0)],
        leaving: vec![Vector::new(0.0, turn * radius), Vector::new(0.0, -turn * radius)],
        arriving: vec![Vector::new(0.0, turn * radius), Vector::new(0.0, -turn * radius)],
        omega: vec![turn; 2],
        lengths: vec![1.0; 2],
    };
    let levels = if cfg!(debug_assertions) { 16 } else { 20 };
    let result = subdivide_hermite(&data, 2, levels).expect("two million points are allowed");
    let worst = result.points.iter().map(|p| (p.norm() / radius - 1.0).abs()).fold(0.0, f64::max);
    assert!(worst < tolerance::SCHEME_POINTS, "worst relative error of the radius: {worst:e}");
}

#[test]
fn four_point_rules_and_vector_scheme_make_the_same_control_polygon() {
    for space in [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial] {
        for closed in [true, false] {
            let mut data = mixed(space, closed);
            data.arriving = data.leaving.clone();
            data.omega.fill(2.8);
            data.lengths.fill(1.0);
            for level in 0..6 {
                let fine = subdivide_hermite(&data, 2, level).expect("in range");
                let expected = control_polygon(&fine).expect("in range");
                let got = subdivide_scalar(&data, level).expect("in range");
                assert_eq!(got.len(), expected.len(), "as many control points");
                for (got, expected) in got.iter().zip(&expected) {
                    let off = (got - expected).norm();
                    assert!(off < 40.0 * tolerance::SCHEME_POINTS, "{space:?} level {level}: {off:e}");
                }
            }
        }
    }
}

#[test]
fn the_scalar_scheme_closes_in_on_the_curve_fourfold_a_level() {
    let mut data = mixed(Space::Trigonometric, true);
    data.arriving = data.leaving.clone();
    let distance = |level: usize| {
        let polygon = subdivide_scalar(&data, level).expect("in range");
        let fine = subdivide_hermite(&data, 2, level).expect("in range");
        let off = |i: usize| {
            let kappa = Basis::new(fine.space, fine.omega[i] * fine.lengths[i]).kappa();
            (polygon[2 * i + 1] - point_on(&fine, i, kappa)).norm()
        };
        (0..fine.lengths.len()).map(off).fold(0.0, f64::max)
    };
    let mut before = distance(3);
    for level in 4..9 {
        let now = distance(level);
        assert!(now < 0.27 * before, "level {level}: {now} after {before}");
        before = now;
    }
}

#[test]
fn a_translation_of_the_data_is_a_translation_of_the_result() {
    let data = mixed(Space::Trigonometric, true);
    let shift = Vector::new(1024.0, -4096.0);
    let mut moved = data.clone();
    moved.points.iter_mut().for_each(|p| *p += shift);
    let (here, there) = (subdivide_hermite(&data, 3, 3), subdivide_hermite(&moved, 3, 3));
    let (here, there) = (here.expect("in range"), there.expect("in range"));
    for (here, there) in here.points.iter().zip(&there.points) {
        // Coordinates around 4096 are stored to 4.5e-13.
        assert!((here + shift - there).norm() < 3e-12, "{here:?} {there:?}");
    }
}

#[test]
fn limits_of_levels_and_arity_are_checked_before_anything_is_allocated() {
    let data = mixed(Space::Trigonometric, true);
    let code =
        |arity, levels| subdivide_hermite(&data, arity, levels).map(|_| ()).map_err(|error| error.code());
    assert_eq!(code(2, 24), Err("E_LIMIT"), "84 million points");
    assert_eq!(code(2, 53), Err("E_RANGE"), "more than 24 levels");
    assert_eq!(code(0, 1), Err("E_RANGE"), "no pieces");
    assert_eq!(code(usize::MAX, 2), Err("E_LIMIT"), "the count overflows");
    assert_eq!(code(2, 0), Ok(()), "level 0 is a copy");
    assert_eq!(subdivide_hermite(&data, 2, 0), Ok(data.clone()), "level 0 is a copy");
    let short = HermiteData { omega: vec![1.0], ..data.clone() };
    assert_eq!(
        subdivide_hermite(&short, 2, 1),
        Err(Box::new(Error::WrongLength { argument: "omega", got: 1, needed: 5 })),
        "one frequency for five segments"
    );
    let scalar = subdivide_scalar(&data, 24).map(|_| ()).map_err(|error| error.code());
    assert_eq!(scalar, Err("E_LIMIT"), "the scalar scheme has the same limits");
}

#[test]
fn masks_of_wrong_arity_or_level_are_refused() {
    let generators = generators(Space::Trigonometric, 1.0);
    let code = |arity, level| generators.mask(arity, level).map(|_| ()).map_err(|error| error.code());
    assert_eq!(code(0, 0), Err("E_RANGE"), "no pieces");
    assert_eq!(code(2, 25), Err("E_RANGE"), "too fine");
    assert_eq!(code(500_001, 0), Err("E_RANGE"), "more than 4 million numbers");
    assert_eq!(code(1000, 24), Ok(()), "a grid step of 1e-72 is still a number");
}
