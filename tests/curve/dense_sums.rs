//! Surfaces and curves in space against what they are by definition: the sum over all points, wherever it comes from,
//! and brute force.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use crate::support::tolerance::{SUMS, SURFACES};
use expline::generator::{ExponentialBSpline, Interpolator, Root, Roots};
use expline::numerics::Vector3;
use expline::surface::{Direction, Grid};
use expline::{Curve, InterpolatingCurve, LocalCurve, TensorSurface};

/// Three to six roots: 0 some times, imaginary pairs, real pairs, some of them nearly 0 or nearly the same.
fn random_roots(random: &mut Random) -> Roots {
    let mut list = vec![Root::default(); random.below(4)];
    while list.len() < 3 || (list.len() < 5 && random.below(2) == 0) {
        let rate = [2.6 * random.unit(), 1.3, 1e-12, 1e-3][random.below(4)];
        let (re, im) = if random.below(3) == 0 { (0.5 * rate, 0.0) } else { (0.0, rate) };
        list.extend([Root { re, im }, Root { re: -re, im: -im }]);
    }
    Roots::new(&list, "roots").expect("closed under everything")
}

fn random_direction(random: &mut Random) -> Direction {
    let (roots, closed) = (random_roots(random), random.below(2) == 0);
    let level = [0, 0, 1, 2][random.below(4)];
    let least = match (closed, level) {
        (true, _) => 3,
        (false, 0) => 2 * roots.order() - 2,
        (false, _) => roots.order(),
    };
    let count = least + random.below(7);
    Direction { roots, count, closed, level }
}

/// What every row of a direction weighs at t: the function's shift to where the row is, and of a closed one all turns
/// of it.
fn weights(direction: &Direction, t: f64, derivative: usize) -> Vec<f64> {
    let Direction { roots, count, closed, level } = direction;
    let (scale, order) = (f64::from(1 << level), roots.order() as f64);
    let generator: Box<dyn Fn(f64) -> f64> = if *level == 0 {
        let interpolator = Interpolator::new(roots).expect("there is one");
        Box::new(move |x| interpolator.at(x, derivative))
    } else {
        let fine = roots.scaled(scale).expect("in range");
        let spline = ExponentialBSpline::new(&fine).expect("there is one");
        Box::new(move |x| spline.at(x, derivative) / fine.integral())
    };
    let first = match (level, closed) {
        (0, true) => 0.0,
        (0, false) => 2.0 - order,
        (_, true) => 0.5 * (order % 2.0),
        (_, false) => 1.0 - 0.5 * order,
    };
    let turns = if *closed { -8..=8 } else { 0..=0 };
    let at = |k: usize| -> f64 {
        let from = t * scale - k as f64 - first;
        turns.clone().map(|turn| generator(from + f64::from(turn) * *count as f64)).sum()
    };
    let unit = scale.powi(derivative as i32);
    (0..*count).map(|k| unit * at(k)).collect()
}

/// The sum over a net, and the sizes of what is added up.
fn sum(net: &[f64], u: &[f64], v: &[f64]) -> (Vector3, f64) {
    let (mut total, mut size) = (Vector3::zeros(), 0.0);
    for (point, k) in net.as_chunks::<3>().0.iter().zip(0..) {
        let term = Vector3::from(*point) * (u[k / v.len()] * v[k % v.len()]);
        total += term;
        size += term.norm();
    }
    (total, size)
}

#[test]
fn a_surface_is_the_sum_over_its_net_whatever_its_roots_and_ends() {
    let mut random = Random::new(47);
    for case in 0..60 {
        let (u, v) = (random_direction(&mut random), random_direction(&mut random));
        let net: Vec<f64> = (0..3 * u.count * v.count).map(|_| random.symmetric()).collect();
        let surface = TensorSurface::new(net.clone(), u.clone(), v.clone()).expect("the net fits");
        let [end_u, end_v] = surface.domain();
        for _ in 0..4 {
            let (s, t) = (end_u * random.unit(), end_v * random.unit());
            for (du, dv) in [(0, 0), (1, 0), (0, 1), (1, 1), (2, 0)] {
                let (expected, size) = sum(&net, &weights(&u, s, du), &weights(&v, t, dv));
                let got = surface.evaluate(s, t, du, dv).expect("in the domain");
                let off = (got - expected).norm() / size;
                assert!(off <= SUMS, "case {case} at {s}, {t}, derivative {du}, {dv}: {off:e}");
            }
        }
        let grid = Grid { rows: 2 + random.below(6), cols: 2 + random.below(6) };
        let mut vertices = [vec![0.0; 3 * grid.rows * grid.cols], vec![0.0; 3 * grid.rows * grid.cols]];
        let [positions, normals] = &mut vertices;
        surface.mesh_into(grid, &grid.whole(), positions, normals).expect("within the limits");
        let steps = |count: usize, closed: bool| if closed { count } else { count - 1 };
        for k in 0..grid.rows * grid.cols {
            let s = end_u * (k / grid.cols) as f64 / steps(grid.rows, u.closed) as f64;
            let t = end_v * (k % grid.cols) as f64 / steps(grid.cols, v.closed) as f64;
            let at = |list: &[f64]| Vector3::from_column_slice(&list[3 * k..3 * k + 3]);
            let [in_u, in_v] = [0, 1].map(|d| (weights(&u, s, d), weights(&v, t, d)));
            let (place, size) = sum(&net, &in_u.0, &in_u.1);
            let off = (at(positions) - place).norm() / size;
            assert!(off <= SUMS, "case {case}, vertex {k}: {off:e}");
            let ((by_u, _), (by_v, _)) = (sum(&net, &in_v.0, &in_u.1), sum(&net, &in_u.0, &in_v.1));
            let across = by_u.cross(&by_v);
            let sine = across.norm() / (by_u.norm() * by_v.norm());
            let turned = (at(normals) - across.normalize()).norm();
            // Derivatives are sums of what may be a thousand times as large.
            assert!(turned * sine <= 1e3 * SURFACES, "case {case}, normal {k}: {turned:e}");
        }
    }
}

/// Forty places of every piece, and how large the curve is.
struct Sampled {
    points: Vec<[f64; 3]>,
    size: f64,
}

fn sampled(curve: &dyn Curve, at: &dyn Fn(f64) -> Vec<f64>) -> Sampled {
    let pieces = curve.as_pieces();
    let mut points = Vec::new();
    for i in 0..pieces.piece_count() {
        let (from, to) = (pieces.knot(i), pieces.knot(i + 1));
        points.extend((0..=40).map(|k| at((from + (to - from) * f64::from(k) / 40.0).min(to))));
    }
    let points: Vec<[f64; 3]> = points.iter().map(|p| [p[0], p[1], p[2]]).collect();
    let size = points.iter().map(|p| apart(p, &points[0])).fold(0.0, f64::max);
    Sampled { points, size }
}

fn apart(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// From a place to the nearest chord between neighbours of a list.
fn to_chords(place: &[f64; 3], list: &[[f64; 3]]) -> f64 {
    let to = |a: &[f64; 3], b: &[f64; 3]| {
        let ([p, a, b], mut foot) = ([*place, *a, *b].map(Vector3::from), Vector3::from(*a));
        let chord = b - a;
        if chord.norm_squared() > 0.0 {
            foot += chord * ((p - a).dot(&chord) / chord.norm_squared()).clamp(0.0, 1.0);
        }
        (p - foot).norm()
    };
    list.windows(2).map(|pair| to(&pair[0], &pair[1])).fold(f64::INFINITY, f64::min)
}

fn check_measures(what: &str, random: &mut Random, curve: &dyn Curve, at: &dyn Fn(f64) -> Vec<f64>) {
    let Sampled { points, size } = sampled(curve, at);
    // Chords of 1/40 of a piece see a bend of it to this.
    let coarse = 2e-3 * size;
    let bounds = curve.bounds();
    for p in &points {
        for (k, (low, high)) in
            [(bounds.min_x, bounds.max_x), (bounds.min_y, bounds.max_y), (bounds.min_z, bounds.max_z)]
                .into_iter()
                .enumerate()
        {
            assert!(low - p[k] <= SUMS * size && p[k] - high <= SUMS * size, "{what}: {p:?} in {bounds:?}");
        }
    }
    let chords: f64 = points.windows(2).map(|pair| apart(&pair[0], &pair[1])).sum();
    let length = curve.length(1e-9 * size).expect("a length");
    assert!(length >= chords * (1.0 - 1e-9) && length - chords <= 1e-2 * chords, "{what}: {length} {chords}");
    for _ in 0..3 {
        let near = points[random.below(points.len())];
        let place = near.map(|x| x + 0.3 * size * random.symmetric());
        let found = curve.nearest_in_space(place);
        let least = points.iter().map(|p| apart(p, &place)).fold(f64::INFINITY, f64::min);
        assert!(found.distance <= least + 1e-12 * size, "{what}: {} for {least}", found.distance);
        let there = at(found.t);
        assert!(apart(&found.point, &[there[0], there[1], there[2]]) <= 1e-11 * size, "{what}: where it is");
    }
    let tolerance = 1e-2 * size;
    let (polyline, bound) = curve.flatten(tolerance).expect("a polyline");
    let mut polyline: Vec<[f64; 3]> = polyline.as_chunks::<3>().0.to_vec();
    if curve.as_pieces().closed() {
        polyline.push(polyline[0]);
    }
    let cubics = curve.to_cubics(tolerance).expect("cubics");
    let mut drawn = Vec::new();
    for cubic in cubics.path.as_chunks::<12>().0 {
        for k in 0..=20 {
            let t = f64::from(k) / 20.0;
            let s = 1.0 - t;
            let w = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
            drawn.push([0, 1, 2].map(|d| (0..4).map(|j| w[j] * cubic[3 * j + d]).sum::<f64>()));
        }
    }
    assert!(bound <= tolerance && cubics.deviation <= tolerance, "{what}: {bound} {}", cubics.deviation);
    for p in points.iter().step_by(17) {
        assert!(to_chords(p, &polyline) <= bound + SUMS * size, "{what}: off the polyline");
        assert!(to_chords(p, &drawn) <= cubics.deviation + coarse, "{what}: off the cubics");
    }
    for p in drawn.iter().step_by(7) {
        assert!(to_chords(p, &points) <= cubics.deviation + coarse, "{what}: cubics astray");
    }
}

#[test]
fn curves_in_space_are_sums_over_their_points_and_measured_as_their_samples_are() {
    let mut random = Random::new(48);
    for case in 0..24 {
        let (roots, closed) = (random_roots(&mut random), random.below(2) == 0);
        let count = if closed { 3 } else { 2 } + random.below(6);
        let points: Vec<f64> = (0..3 * count).map(|_| random.symmetric()).collect();
        let interpolator = Interpolator::new(&roots).expect("there is one");
        let curve =
            InterpolatingCurve::new(points.clone(), 3, closed, Some(roots)).expect("points and roots");
        let what = format!("case {case}");
        if closed {
            for _ in 0..5 {
                let t = count as f64 * random.unit();
                for order in 0..=2 {
                    let (mut expected, mut size) = ([0.0; 3], 0.0);
                    for k in -9..=count as i32 + 9 {
                        let weight = interpolator.at(t - f64::from(k), order);
                        let at = 3 * k.rem_euclid(count as i32) as usize;
                        size += weight.abs();
                        for (sum, x) in expected.iter_mut().zip(&points[at..at + 3]) {
                            *sum += weight * x;
                        }
                    }
                    let got = curve.evaluate(t, order).expect("closed");
                    let off = apart(&[got[0], got[1], got[2]], &expected) / size;
                    assert!(off <= SUMS, "{what} at {t}, derivative {order}: {off:e}");
                }
            }
        }
        check_measures(&what, &mut random, &curve, &|t| curve.evaluate(t, 0).expect("in the domain"));
        let fine = curve.refine(2, 2, 3).expect("within the limits");
        check_measures(&what, &mut random, &fine, &|t| fine.evaluate(t, 0).expect("in the domain"));
        // Again and again at one place, the seam of a closed curve.
        let mut local = LocalCurve::new(curve);
        for levels in [1, 2, 2, 3] {
            local = local.refine_at(0.0, levels, 1.0).expect("room");
            let patch = random.below(local.patch_count());
            let moved: Vec<f64> = (0..3).map(|_| random.symmetric()).collect();
            local = local.with_patch_point(patch, 0, &moved).expect("it is there");
            let there = local.patch_points(patch).expect("it is there");
            assert!(
                there.iter().zip(&moved).all(|(a, b)| (a - b).abs() <= 1e-12),
                "{what}: {there:?} {moved:?}"
            );
        }
        check_measures(&what, &mut random, &local, &|t| local.evaluate(t, 0).expect("in the domain"));
    }
}
