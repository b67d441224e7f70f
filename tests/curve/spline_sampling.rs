//! Uniform sampling of interpolating and B-spline curves: the points of evaluation, however they are asked for.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use crate::support::unboxed;
use expline::curve::SplineSampler;
use expline::generator::{Interpolator, Roots};
use expline::{BSplineCurve, Error, InterpolatingCurve};

fn lists() -> Vec<Roots> {
    let all = [
        Roots::polynomials(2),
        Roots::polynomials(3),
        Roots::polynomials(4),
        Roots::polynomials(7),
        Roots::ellipse(3),
        Roots::ellipse(40),
        Roots::harmonics(7, 2),
        Roots::hyperbola(4.5),
    ];
    let mut lists: Vec<Roots> = all.into_iter().map(|r| r.expect("in range")).collect();
    // Without the root 0 nothing sums to 1.
    lists.push(
        Roots::new(&Roots::harmonics(7, 2).expect("in range").as_slice()[1..], "roots").expect("closed"),
    );
    lists
}

#[test]
fn samples_are_the_points_of_evaluation() {
    let mut random = Random::new(1);
    for roots in lists() {
        let phi = Interpolator::new(&roots).expect("it exists");
        let cancelled = 1.0 + 2.0 * phi.lambda().iter().map(|l| l.abs()).sum::<f64>();
        for (dimension, closed) in [(2, true), (3, true), (2, false), (3, false)] {
            for count in [3, 5, 16] {
                let points: Vec<f64> = (0..count * dimension).map(|_| random.symmetric()).collect();
                let curve =
                    InterpolatingCurve::new(points, dimension, closed, Some(roots.clone())).expect("finite");
                let fine = curve.refine(2, 2, 3).expect("in range");
                for number in [1, 2, 7, 64, 100, 1001, 4800] {
                    for derivative in 0..=2 {
                        let got = curve.sample(number, derivative).expect("in range");
                        let (_, end) = curve.domain();
                        let steps = if closed { number } else { (number - 1).max(1) };
                        let t: Vec<f64> = (0..number).map(|i| i as f64 * end / steps as f64).collect();
                        let mut expected = vec![0.0; dimension * number];
                        curve.evaluate_into(&t, derivative, &mut expected).expect("in the domain");
                        // A parameter's rounding of 1e-15 times the next derivative; n₀ = 3 jumps in the second one.
                        let size = cancelled * [1.0, 10.0, 100.0][derivative];
                        let jumps = roots.order() == 3 && derivative == 2;
                        for (i, (a, b)) in got.iter().zip(&expected).enumerate() {
                            let at_knot =
                                (2.0 * t[i / dimension] - (2.0 * t[i / dimension]).round()).abs() < 1e-9;
                            let off = (a - b).abs();
                            assert!(
                                off < 2e-14 * size || (jumps && at_knot),
                                "{roots:?} {count} {number}[{i}] {derivative}: {a} {b}"
                            );
                        }
                        let got = fine.sample(number, derivative).expect("in range");
                        fine.evaluate_into(
                            &t.iter().map(|t| t.min(fine.domain().1)).collect::<Vec<_>>(),
                            derivative,
                            &mut expected,
                        )
                        .expect("in the domain");
                        for (i, (a, b)) in got.iter().zip(&expected).enumerate() {
                            let u = t[i / dimension] / fine.step();
                            let at_knot = (u - u.round()).abs() < 1e-9;
                            let off = (a - b).abs();
                            assert!(
                                off < 2e-14 * size * 10.0 || (jumps && at_knot),
                                "fine {roots:?} {count} {number}[{i}] {derivative}: {a} {b}"
                            );
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn samples_at_points_are_the_points_to_the_last_bit() {
    let mut random = Random::new(2);
    for roots in lists() {
        for closed in [true, false] {
            let points: Vec<f64> = (0..22).map(|_| random.symmetric()).collect();
            let curve =
                InterpolatingCurve::new(points.clone(), 2, closed, Some(roots.clone())).expect("finite");
            for each in [1, 2, 3, 31, 600] {
                let count = if closed { 11 * each } else { 10 * each + 1 };
                let samples = curve.sample(count, 0).expect("in range");
                for (k, point) in points.chunks_exact(2).enumerate() {
                    assert_eq!(
                        samples[2 * k * each..2 * k * each + 2],
                        *point,
                        "{roots:?} {closed} {each} {k}"
                    );
                }
            }
        }
    }
}

#[test]
fn neither_ranges_nor_what_was_sampled_before_change_a_bit() {
    let mut random = Random::new(3);
    let mut sampler = SplineSampler::new();
    for roots in lists() {
        let points: Vec<f64> = (0..15).map(|_| random.symmetric()).collect();
        let curve = InterpolatingCurve::new(points, 3, true, Some(roots.clone())).expect("finite");
        let fine = curve.refine(1, 2, 2).expect("in range");
        for count in [997, 5000] {
            for (first, number) in [(0, count), (3, 1), (250, 257), (count - 20, 20), (count - 5, 9)] {
                let whole = curve.sample(count, 0).expect("in range");
                let mut part = vec![f64::NAN; 3 * number];
                sampler.points(&curve, count, first, 0, &mut part).expect("in range");
                let there = (count - first).min(number);
                assert_eq!(
                    part[..3 * there],
                    whole[3 * first..3 * (first + there)],
                    "{roots:?} {count} {first}"
                );
                sampler.points(&fine, count, first, 1, &mut part).expect("in range");
                let whole = fine.sample(count, 1).expect("in range");
                assert_eq!(
                    part[..3 * there],
                    whole[3 * first..3 * (first + there)],
                    "{roots:?} {count} {first}"
                );
            }
        }
    }
}

#[test]
fn whole_blocks_are_the_same_samples() {
    let points: Vec<f64> = (0..14).map(|k| (f64::from(k) * 1.3).cos()).collect();
    let curve = InterpolatingCurve::new(points, 2, true, None).expect("finite");
    for (count, room) in [(20_000, 1500), (997, 512), (40, 600)] {
        for derivative in 0..2 {
            let whole = curve.sample(count, derivative).expect("in range");
            let (mut sampler, mut first) = (SplineSampler::new(), 0);
            while first < count {
                let mut part = vec![f64::NAN; 2 * room];
                let made = sampler.blocks(&curve, count, first, derivative, &mut part).expect("in range");
                assert!(made > 0 && made <= room, "{made} of {count} from {first}");
                assert_eq!(part[..2 * made], whole[2 * first..2 * (first + made)], "{count} {first}");
                first += made;
            }
            assert_eq!(sampler.blocks(&curve, count, first, derivative, &mut [0.0; 2]), Ok(0));
        }
    }
}

#[test]
fn too_much_is_refused_and_nothing_is_fine() {
    let points = vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0];
    let curve = InterpolatingCurve::new(points, 2, true, None).expect("finite");
    assert!(matches!(
        unboxed(curve.sample(usize::MAX, 0)),
        Err(Error::LimitExceeded { argument: "count", .. })
    ));
    assert!(matches!(unboxed(curve.sample(10, 3)), Err(Error::OutOfRange { argument: "derivative", .. })));
    assert!(curve.sample(0, 0).expect("nothing").is_empty(), "no samples");
    let roots = Roots::polynomials(3).expect("in range");
    let line = BSplineCurve::new(vec![0.0; 8], 2, false, roots, 1.0, -1.0).expect("one cell");
    assert_eq!(line.sample(2, 0).expect("two"), [0.0; 4], "a curve of no size");
}
