//! Sampling in bulk gives the points of the curve: the same as one by one, whatever the range or the order of calls.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::curve::Sampler;
use expline::{HermiteCurve, HermiteOptions, Space};
use nalgebra::Vector2;

type Point = Vector2<f64>;

/// Numbers between −1 and 1 that look random and are the same everywhere.
fn scatter(seed: usize) -> f64 {
    let hash = (seed as u64).wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let hash = (hash ^ (hash >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    ((hash ^ (hash >> 32)) & 0xffff_ffff) as f64 / 2_147_483_648.0 - 1.0
}

fn curve(points: usize, closed: bool, space: Space, omega: &[f64], lengths: &[f64]) -> HermiteCurve {
    let vectors = |seed: usize| {
        (0..points).map(|i| Point::new(scatter(seed + 2 * i), scatter(seed + 2 * i + 1)) * 10.0).collect()
    };
    let segments = if closed { points } else { points - 1 };
    let cycle = |values: &[f64]| values.iter().copied().cycle().take(segments).collect::<Vec<_>>();
    HermiteCurve::new(HermiteOptions {
        points: vectors(0),
        tangents: vectors(1000),
        tangents_in: vectors(2000),
        closed,
        space: Some(space),
        omega: cycle(omega),
        lengths: cycle(lengths),
    })
    .expect("a valid curve")
}

fn curves() -> Vec<HermiteCurve> {
    let spaces = [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial];
    let mut curves = Vec::new();
    for (space, closed) in spaces.into_iter().flat_map(|space| [(space, true), (space, false)]) {
        curves.push(curve(16, closed, space, &[0.4], &[1.0]));
        curves.push(curve(2, closed, space, &[3.1], &[1.0]));
        curves.push(curve(7, closed, space, &[1.0], &[1.0, 0.3, 2.0, 0.7]));
        curves.push(curve(5, closed, space, &[0.0, 2.0, 5.0], &[0.5, 0.25]));
        curves.push(curve(300, closed, space, &[0.02], &[1.0]));
    }
    curves.push(curve(4, true, Space::Hyperbolic, &[3000.0, 20.0], &[1.0]));
    curves
}

const COUNTS: [usize; 10] = [1, 2, 3, 16, 64, 100, 257, 1024, 4000, 20_011];

/// The segment and the place in it of sample i, without the rounding of a parameter where lengths are all one.
fn place(curve: &HermiteCurve, count: usize, i: usize) -> (usize, f64) {
    let (_, end) = curve.domain();
    let steps = if curve.is_closed() { count } else { (count - 1).max(1) };
    let segments = curve.segment_count();
    if curve.lengths().iter().all(|length| *length == 1.0) {
        let k = (i * segments / steps).min(segments - 1);
        return (k, (i * segments - k * steps) as f64 / steps as f64);
    }
    curve.locate((i as f64 * end / steps as f64).min(end)).expect("inside")
}

/// What the two promises below measure: the largest deviation of points and of tangents, each relative to what the
/// curve's numbers and the rounding of t let one expect.
fn worst(curve: &HermiteCurve, count: usize) -> (f64, f64) {
    let mut both = vec![0.0; 4 * count];
    Sampler::default().points_and_tangents(curve, count, 0, &mut both);
    let even = curve.lengths().iter().all(|length| *length == 1.0);
    let (mut points, mut tangents) = (0.0_f64, 0.0_f64);
    for (i, found) in both.chunks_exact(4).enumerate() {
        let (k, x) = place(curve, count, i);
        let segment = curve.segment(k).expect("it is there");
        let w = segment.basis.frequency();
        let speed = [segment.leaving, segment.arriving, (segment.end - segment.start) / segment.length]
            .iter()
            .map(|v| v.norm())
            .fold(0.0, f64::max);
        let size = segment.start.norm().max(segment.end.norm()).max(speed * segment.length);
        // An ulp of t, at the speed and the change of speed that the data give.
        let late = if even { 0.0 } else { f64::EPSILON * (curve.knots()[k] + segment.length) };
        let bend = speed * (12.0 + w * w) / segment.length;
        let error = (Point::new(found[0], found[1]) - segment.position(x)).norm();
        points = points.max(error / (f64::EPSILON * size * (1.0 + w) + late * 3.0 * speed));
        let error = (Point::new(found[2], found[3]) - segment.velocity(x)).norm();
        tangents = tangents.max(error / (f64::EPSILON * bend * segment.length + late * bend));
    }
    (points, tangents)
}

#[test]
fn bulk_sampling_agrees_with_evaluation_one_by_one() {
    for (k, curve) in curves().iter().enumerate() {
        for count in COUNTS {
            let (points, tangents) = worst(curve, count);
            assert!(points <= 4.0, "curve {k}, {count} samples: {points} roundings");
            assert!(tangents <= 1.5, "curve {k}, {count} tangents: {tangents} roundings");
        }
    }
}

#[test]
fn segments_too_short_for_a_sample_of_their_own_are_passed_over() {
    for (closed, lengths) in [
        (true, [1e9, 1e-12, 1e9]),
        (false, [1e9, 1e-12, 1e9]),
        (false, [1e9, 1e9, 1e-12]),
        (true, [1.0, 1e-12, 1e3]),
    ] {
        for space in [Space::Polynomial, Space::Hyperbolic] {
            let curve = curve(if closed { 3 } else { 4 }, closed, space, &[1e-9], &lengths);
            for count in 2..200 {
                let mut all = vec![f64::NAN; 2 * count];
                Sampler::default().points(&curve, count, 0, &mut all);
                for (i, found) in all.chunks_exact(2).enumerate() {
                    let end = !closed && i + 1 == count;
                    let (k, x) = if end { (2, 1.0) } else { place(&curve, count, i) };
                    let segment = curve.segment(k).expect("it is there");
                    let size = 1e2 * (1.0 + segment.length);
                    let error = (Point::new(found[0], found[1]) - segment.position(x)).norm();
                    assert!(error <= 64.0 * f64::EPSILON * size, "{lengths:?} {count} {i}: {error}");
                }
            }
        }
    }
}

#[test]
fn tangents_come_with_the_same_points() {
    for curve in curves() {
        for count in COUNTS {
            let mut both = vec![0.0; 4 * count];
            Sampler::default().points_and_tangents(&curve, count, 0, &mut both);
            let points = curve.sample(count).expect("within limits");
            for (both, point) in both.chunks_exact(4).zip(points.chunks_exact(2)) {
                assert_eq!(&both[..2], point, "of {count}");
            }
        }
    }
}

#[test]
fn samples_that_fall_on_a_point_are_the_point() {
    for curve in curves() {
        let segments = curve.segment_count();
        if !curve.lengths().iter().all(|length| *length == 1.0) {
            continue;
        }
        for each in [1, 3, 10, 64, 999] {
            let count = each * segments + usize::from(!curve.is_closed());
            let sampled = curve.sample(count).expect("within limits");
            for (k, point) in curve.points().iter().enumerate() {
                let at = 2 * k * each;
                assert_eq!(&sampled[at..at + 2], point.as_slice(), "point {k}, {each} to a segment");
            }
        }
    }
    let ends = curve(7, false, Space::Trigonometric, &[1.0], &[1.0, 0.3, 2.0, 0.7]);
    for count in COUNTS.into_iter().filter(|count| *count > 1) {
        let sampled = ends.sample(count).expect("within limits");
        assert_eq!(&sampled[..2], ends.points()[0].as_slice(), "the first of {count}");
        assert_eq!(&sampled[2 * count - 2..], ends.points()[6].as_slice(), "the last of {count}");
    }
}

#[test]
fn a_sampling_cut_into_ranges_is_the_same_to_the_last_bit() {
    let mut sampler = Sampler::default();
    for curve in curves() {
        for count in COUNTS {
            let whole = curve.sample(count).expect("within limits");
            for length in [1, 7, 256, 1000] {
                if count / length > 300 {
                    continue;
                }
                let mut pieces = vec![f64::NAN; 2 * count];
                for (k, piece) in pieces.chunks_mut(2 * length).enumerate() {
                    sampler.points(&curve, count, k * length, piece);
                }
                assert_eq!(
                    pieces, whole,
                    "{count} samples in ranges of {length}, with a sampler used before"
                );
            }
        }
    }
}

#[test]
fn samples_beyond_the_last_are_not_written() {
    let curve = curve(5, true, Space::Trigonometric, &[1.0], &[1.0]);
    let mut out = vec![7.0; 20];
    curve.sample_range(8, 4, &mut out);
    assert!(out[..8].iter().all(|value| *value != 7.0), "four samples are left");
    assert!(out[8..].iter().all(|value| *value == 7.0), "the rest is untouched");
    curve.sample_range(8, 8, &mut out[8..]);
    curve.sample_range(8, usize::MAX, &mut out[8..]);
    curve.sample_range(0, 0, &mut out[8..]);
    assert!(out[8..].iter().all(|value| *value == 7.0), "and stays so");
    assert_eq!(curve.sample(0), Ok(Vec::new()), "no samples");
    assert_eq!(
        curve.sample(usize::MAX).expect_err("too many").code(),
        "E_LIMIT",
        "checked before allocating"
    );
}

#[test]
fn a_million_points_make_a_circle_that_samples_and_refines_within_rounding() {
    let count = 1_000_000;
    let circle =
        HermiteCurve::ellipse(Point::zeros(), Point::new(1.0, 1.0), 0.0, count).expect("a valid circle");
    let round =
        |values: &[f64]| values.chunks_exact(2).map(|p| (p[0].hypot(p[1]) - 1.0).abs()).fold(0.0, f64::max);
    assert!(round(&circle.sample(1_500_000).expect("within limits")) < 1e-9, "between the points");
    let refined = circle.refine(2).expect("within limits");
    let error = refined.points().iter().map(|p| (p.norm() - 1.0).abs()).fold(0.0, f64::max);
    assert!(error < 1e-9, "twice the points: {error:e}");
}

#[test]
fn evaluation_of_many_parameters_is_checked_before_anything_is_written() {
    let open = curve(4, false, Space::Trigonometric, &[1.0], &[1.0]);
    let mut out = [7.0; 6];
    for (t, code) in [([0.0, 3.1, 1.0], "E_RANGE"), ([0.0, 1.0, f64::NAN], "E_NOT_FINITE")] {
        let error = open.evaluate_into(&t, 0, &mut out).expect_err("invalid");
        assert_eq!((error.code(), error.argument()), (code, Some("t")), "{error}");
        assert_eq!(out, [7.0; 6], "untouched");
    }
    assert_eq!(
        open.evaluate_into(&[0.0; 2], 0, &mut out).expect_err("too long").argument(),
        Some("out"),
        "length"
    );
    assert_eq!(
        open.evaluate_into(&[0.0; 3], 3, &mut out).expect_err("order").argument(),
        Some("derivative"),
        "order"
    );
    let many = vec![0.0; 4_000_001];
    assert_eq!(open.evaluate_into(&many, 0, &mut out).expect_err("too many").code(), "E_LIMIT", "limit");
    let t = [3.0, 0.25, 1.0];
    for order in 0..=2 {
        open.evaluate_into(&t, order, &mut out).expect("valid");
        for (t, value) in t.iter().zip(out.chunks_exact(2)) {
            assert_eq!(
                open.evaluate(*t, order).expect("inside").as_slice(),
                value,
                "derivative {order} at {t}"
            );
        }
    }
}

#[test]
fn every_machine_gives_the_same_bits() {
    // FNV-1a over the bits of all samples: native code and WebAssembly, scalar and vector code must agree.
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for curve in curves() {
        for count in [100, 1000, 4001] {
            let mut out = vec![0.0; 4 * count];
            Sampler::default().points_and_tangents(&curve, count, 0, &mut out);
            for value in out {
                hash = (hash ^ (value + 0.0).to_bits()).wrapping_mul(0x0000_0100_0000_01b3);
            }
        }
    }
    assert_eq!(hash, 0x0f61_f6b5_c16d_5655, "the bits have changed: {hash:#x}");
}
