//! Patches of finer control points: the shape does not change when room is made, and only there when it is used.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use crate::support::unboxed;
use expline::generator::Roots;
use expline::{Curve, Error, InterpolatingCurve, LocalCurve};

fn lists() -> Vec<Roots> {
    [Roots::polynomials(2), Roots::polynomials(3), Roots::ellipse(16), Roots::harmonics(16, 2)]
        .into_iter()
        .map(|r| r.expect("in range"))
        .collect()
}

fn blob(random: &mut Random, roots: &Roots, dimension: usize, closed: bool) -> LocalCurve {
    let points = (0..16 * dimension).map(|_| random.symmetric()).collect();
    LocalCurve::new(InterpolatingCurve::new(points, dimension, closed, Some(roots.clone())).expect("finite"))
}

#[test]
fn making_room_changes_no_bit_and_adds_control_points_only_there() {
    let mut random = Random::new(1);
    for roots in lists() {
        for (dimension, closed) in [(2, true), (3, false)] {
            let curve = blob(&mut random, &roots, dimension, closed);
            let finer = curve.refine_at(5.3, 3, 0.5).expect("inside").refine_at(5.4, 5, 0.1).expect("inside");
            let (level, _, count) = finer.patch_window(0).expect("there");
            assert_eq!((level, count), (3, 8), "0.5 to either side in steps of 1/8");
            let many = curve.sample(1601, 0).expect("in range");
            assert_eq!(finer.sample(1601, 0).expect("in range"), many, "{roots:?}");
            // Its control points are those of the whole curve at that level.
            let whole = curve.base().refine(5, 2, 2).expect("in range");
            let (_, first, count) = finer.patch_window(1).expect("there");
            let points = finer.patch_points(1).expect("there");
            assert_eq!(points.len(), count * dimension, "as many as the window says");
            for (i, number) in points.iter().enumerate() {
                let all = whole.points().len();
                assert_eq!(*number, whole.points()[(first * dimension + i) % all], "{roots:?}");
            }
        }
    }
}

#[test]
fn an_edit_moves_the_control_point_there_and_the_curve_only_nearby() {
    let mut random = Random::new(2);
    for roots in lists() {
        for closed in [true, false] {
            // Near the end of the list too, where a closed patch goes round.
            for t in [7.2, 0.1, 14.9] {
                let curve = blob(&mut random, &roots, 2, closed).refine_at(t, 2, 0.5).expect("inside");
                let curve = curve.refine_at(t, 4, 0.2).expect("inside");
                let at = curve.patch_points(1).expect("there");
                let to = [at[2] + 0.3, at[3] - 0.1];
                let edited = curve.with_patch_point(1, 1, &to).expect("finite");
                let is = edited.patch_points(1).expect("there");
                assert!((is[2] - to[0]).abs() < 1e-14 && (is[3] - to[1]).abs() < 1e-14, "{is:?} {to:?}");
                assert!(is[..2] == at[..2] && is[4..] == at[4..], "the others stay");
                let reach = 0.2 + 0.5 * roots.order() as f64 / 16.0;
                let (_, end) = curve.base().domain();
                for i in 0..=3200 {
                    let here = (end * f64::from(i) / 3200.0).min(end);
                    let away = (here - t).abs();
                    let away = if closed { away.min(16.0 - away) } else { away };
                    let [was, now] = [&curve, &edited].map(|c| c.evaluate(here, 0).expect("inside"));
                    assert!(away < reach || was == now, "{roots:?} {closed}: {here} moved");
                }
                // A coarse patch moves what the finer one shows, and its detail stays.
                let coarse = edited.patch_points(0).expect("there");
                let moved = edited.with_patch_point(0, 1, &[coarse[2] + 1.0, coarse[3]]).expect("finite");
                assert_ne!(moved.patch_points(1).expect("there"), is, "{roots:?}");
                assert_eq!(moved.displacements(1).expect("there"), edited.displacements(1).expect("there"));
                // The same by way of the numbers.
                let mut again = LocalCurve::new(moved.base().clone());
                for k in [1, 0] {
                    let d = moved.displacements(k).expect("there");
                    again =
                        again.add_patch(moved.patch_window(k).expect("there"), d).expect("its own numbers");
                }
                assert_eq!(
                    again.sample(333, 0).expect("few"),
                    moved.sample(333, 0).expect("few"),
                    "{roots:?}"
                );
                let without = moved.without_patch(1).expect("there").without_patch(0).expect("there");
                assert_eq!(
                    without.sample(99, 0).expect("few"),
                    curve.sample(99, 0).expect("few"),
                    "{roots:?}"
                );
            }
        }
    }
}

#[test]
fn a_point_of_the_base_takes_the_detail_along() {
    let mut random = Random::new(3);
    let curve = blob(&mut random, &Roots::polynomials(3).expect("in range"), 2, true);
    let detailed = curve.refine_at(4.0, 3, 0.3).expect("inside");
    let at = detailed.patch_points(0).expect("there");
    let detailed = detailed.with_patch_point(0, 2, &[at[4] + 0.2, at[5]]).expect("finite");
    let base = detailed.base().with_point(4, &[3.0, 3.0]).expect("finite");
    let moved = detailed.with_base(base.clone()).expect("as many points");
    let plain = LocalCurve::new(base);
    for i in 0..400 {
        let t = f64::from(i) / 25.0;
        let [a, b, c, d] = [&detailed, &curve, &moved, &plain].map(|c| c.evaluate(t, 0).expect("finite"));
        assert!((a[0] - b[0] - (c[0] - d[0])).abs() < 1e-14, "the same displacement at {t}");
    }
}

#[test]
fn pieces_and_derivatives_are_those_of_the_curve() {
    let mut random = Random::new(4);
    for roots in lists() {
        for closed in [true, false] {
            let mut curve = blob(&mut random, &roots, 2, closed);
            for (t, level, reach) in [(0.2, 2, 0.6), (7.3, 1, 9.0), (7.3, 5, 0.1)] {
                curve = curve.refine_at(t, level, reach).expect("inside");
            }
            for k in 0..3 {
                let at = curve.patch_points(k).expect("there");
                curve = curve.with_patch_point(k, 1, &[at[2] + 0.1, at[3] - 0.3]).expect("finite");
            }
            let (_, end) = curve.base().domain();
            // Lengths come from the pieces, chords from evaluation.
            let length = curve.length(1e-10).expect("a tolerance");
            let count = 40_000;
            let points = curve.sample(count + usize::from(!closed), 0).expect("in range");
            let mut chords: f64 =
                points.windows(4).step_by(2).map(|p| (p[2] - p[0]).hypot(p[3] - p[1])).sum();
            if closed {
                let [x, y] = [points[0], points[1]];
                chords += (x - points[2 * count - 2]).hypot(y - points[2 * count - 1]);
            }
            assert!((length - chords).abs() < 1e-4 * length, "{roots:?} {closed}: {length} {chords}");
            for i in 1..200 {
                let t = end * (f64::from(i) + 0.123) / 201.0;
                let h = 1e-5;
                let [before, after] = [t - h, t + h].map(|t| curve.evaluate(t, 0).expect("inside"));
                let slope = curve.evaluate(t, 1).expect("inside");
                for d in 0..2 {
                    let expected = (after[d] - before[d]) / (2.0 * h);
                    assert!((slope[d] - expected).abs() < 2e-4, "{roots:?} {t}: {slope:?} {expected}");
                }
            }
        }
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    let mut random = Random::new(5);
    let roots = Roots::polynomials(3).expect("in range");
    let curve = blob(&mut random, &roots, 2, false);
    assert!(matches!(unboxed(curve.refine_at(16.0, 2, 1.0)), Err(Error::OutOfRange { argument: "t", .. })));
    assert!(matches!(
        unboxed(curve.refine_at(f64::NAN, 2, 1.0)),
        Err(Error::NotFinite { argument: "t", .. })
    ));
    assert!(matches!(
        unboxed(curve.refine_at(1.0, 0, 1.0)),
        Err(Error::OutOfRange { argument: "levels", .. })
    ));
    assert!(matches!(
        unboxed(curve.refine_at(1.0, 13, 1.0)),
        Err(Error::OutOfRange { argument: "levels", .. })
    ));
    assert!(matches!(
        unboxed(curve.refine_at(1.1, 1, 0.01)),
        Err(Error::Degenerate { argument: "reach", .. })
    ));
    assert!(matches!(
        unboxed(curve.refine_at(1.0, 1, -1.0)),
        Err(Error::OutOfRange { argument: "reach", .. })
    ));
    assert!(matches!(unboxed(curve.patch_points(0)), Err(Error::OutOfRange { argument: "patch", .. })));
    assert!(matches!(
        unboxed(curve.add_patch((1, 30, 9), &[0.0; 18])),
        Err(Error::OutOfRange { argument: "displacements", .. })
    ));
    assert!(matches!(
        unboxed(curve.add_patch((1, 0, 2), &[0.0; 3])),
        Err(Error::WrongLength { needed: 4, .. })
    ));
    assert!(matches!(
        unboxed(curve.add_patch((1, 0, 1), &[0.0, f64::NAN])),
        Err(Error::NotFinite { index: Some(1), .. })
    ));
    let patched = curve.refine_at(1.0, 1, 1.0).expect("inside");
    assert!(matches!(
        unboxed(patched.with_patch_point(0, 99, &[0.0, 0.0])),
        Err(Error::OutOfRange { argument: "i", .. })
    ));
    assert!(matches!(
        unboxed(patched.with_patch_point(0, 0, &[0.0])),
        Err(Error::WrongLength { argument: "point", .. })
    ));
}

#[test]
fn a_point_of_a_patch_moves_by_what_can_be_loaded_again_or_not_at_all() {
    let points = vec![-9e8, 0.0, 0.0, -9e8, 9e8, 0.0, 0.0, 9e8, 1e8, 1e8];
    let base = InterpolatingCurve::new(points, 2, true, None).expect("finite");
    let mut curve = LocalCurve::new(base);
    for _ in 0..2 {
        curve = curve.refine_at(0.0, 1, 0.6).expect("inside");
    }
    // Two patches of one grid that pull to either side: each step is from one end of the coordinates to the other.
    let mut refused = false;
    for (k, x) in [(0, 1e9), (1, -1e9), (0, 1e9), (1, -1e9), (0, 1e9)] {
        match unboxed(curve.with_patch_point(k, 0, &[x, 0.0])) {
            Ok(moved) => curve = moved,
            Err(error) => {
                let fits =
                    matches!(error, Error::OutOfRange { argument: "displacements", index: Some(0), .. });
                assert!(fits, "{error:?}");
                refused = true;
            }
        }
        let mut again = LocalCurve::new(curve.base().clone());
        for k in 0..curve.patch_count() {
            let window = curve.patch_window(k).expect("there");
            again =
                again.add_patch(window, curve.displacements(k).expect("there")).expect("what was made fits");
        }
        assert_eq!(again.sample(64, 0).expect("in range"), curve.sample(64, 0).expect("in range"));
    }
    assert!(refused, "displacements of more than 2e9 were asked for");
}

#[test]
fn many_patches_at_once_are_the_same_as_one_after_the_other() {
    let mut random = Random::new(7);
    for closed in [true, false] {
        let base = blob(&mut random, &lists()[0], 2, closed);
        let patches: Vec<_> =
            (0..40).map(|k| ((1 + 7 * k % 5, k % 9, 1 + k % 3), [0.1 + k as f64; 6])).collect();
        let given = || patches.iter().map(|(window, d)| (*window, &d[..2 * window.2]));
        let all = base.add_patches(given()).expect("they fit");
        let mut each = base.clone();
        for (window, displacements) in given() {
            each = each.add_patch(window, displacements).expect("it fits");
        }
        assert_eq!(all.patch_count(), 40);
        for k in 0..40 {
            assert_eq!(all.patch_window(k).expect("there"), each.patch_window(k).expect("there"));
            assert_eq!(all.displacements(k).expect("there"), each.displacements(k).expect("there"));
        }
        assert_eq!(all.piece_count(), each.piece_count());
        assert_eq!(all.sample(200, 0).expect("points"), each.sample(200, 0).expect("points"));
        let moved = all.with_base(base.base().clone()).expect("the same base");
        assert_eq!(moved.sample(200, 0).expect("points"), all.sample(200, 0).expect("points"));
    }
}

#[test]
fn a_patch_that_does_not_fit_is_named_before_any_is_added() {
    let base = blob(&mut Random::new(8), &lists()[0], 2, true);
    let (mut seen, fine) = (0, [0.0; 2]);
    let patches = [((1, 0, 1), &fine[..]), ((1, 99, 1), &fine[..]), ((2, 0, 1), &fine[..])];
    let refused = unboxed(base.add_patches(patches.into_iter().inspect(|_| seen += 1)));
    assert!(matches!(refused, Err(Error::OutOfRange { argument: "first", .. })));
    assert_eq!(seen, 2, "no further than the one that is wrong");
}

#[test]
fn as_many_patches_as_there_may_be_are_made_in_a_moment() {
    // One after the other, with knots cut anew for each, they took seconds: 60 times this.
    let base = blob(&mut Random::new(9), &lists()[0], 2, true);
    let one = [0.5, 0.5];
    let patches = |count: usize| (0..count).map(|k| ((12, 16 * k % 4096, 1), &one[..])).collect::<Vec<_>>();
    let curve = base.add_patches(patches(4096)).expect("they fit");
    assert_eq!(curve.patch_count(), 4096);
    assert_eq!(curve.with_base(base.base().clone()).expect("they fit").patch_count(), 4096);
}

#[test]
fn a_reach_beyond_the_curve_is_all_of_it() {
    let mut random = Random::new(10);
    let roots = Roots::polynomials(3).expect("in range");
    for closed in [true, false] {
        let curve = blob(&mut random, &roots, 2, closed);
        let all =
            (curve.base().points().len() / 2 - usize::from(!closed)) * 4096 + if closed { 0 } else { 3 };
        // To both sides 4e9 steps, more than 32 bits count.
        let patched = curve.refine_at(0.5, 12, 1e6).expect("within the limits");
        assert_eq!(patched.patch_window(0).expect("there").2, all);
    }
}

#[test]
fn too_many_levels_are_refused_by_their_name_before_memory_is_asked_for() {
    let points = (0..2 * 5000).map(|i| libm::sin(f64::from(i))).collect();
    let curve = LocalCurve::new(InterpolatingCurve::new(points, 2, true, None).expect("points"));
    for reach in [0.01, 1e3, 1e6] {
        assert!(matches!(
            unboxed(curve.refine_at(0.5, 12, reach)),
            Err(Error::LimitExceeded { argument: "levels", limit: "maxOutputPoints", .. })
        ));
    }
}

#[test]
fn a_hair_before_the_start_of_a_closed_curve_is_its_start() {
    let mut random = Random::new(6);
    for roots in lists() {
        let base = blob(&mut random, &roots, 2, true);
        let curve = base.refine_at(0.3, 2, 0.5).expect("inside");
        for t in [-1e-20, -1e-300, 16.0 - 1e-16, -16.0 - 1e-20] {
            let (start, before) =
                (curve.curvature(0.0).expect("moving"), curve.curvature(t).expect("moving"));
            // The same place of the same piece, to the last bit; the piece at the end has another curvature where roots
            // are few.
            assert_eq!(before, start, "{roots:?} {t}");
        }
    }
}
