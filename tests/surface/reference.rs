//! Surfaces: the reference's points and derivatives, seams, poles, and shapes that are exact.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use crate::support::golden;
use crate::support::tolerance::{EXACT, SEAM, SURFACES};
use crate::support::unboxed;
use expline::generator::{Root, Roots};
use expline::numerics::Vector3;
use expline::surface::Direction;
use expline::{Error, TensorSurface};

#[derive(serde::Deserialize)]
struct Golden {
    surfaces: Vec<Case>,
}

#[derive(serde::Deserialize)]
struct Case {
    name: String,
    alpha_u: Vec<[f64; 2]>,
    alpha_v: Vec<[f64; 2]>,
    m_u: f64,
    m_v: f64,
    closed_u: bool,
    closed_v: bool,
    from_u: f64,
    from_v: f64,
    net: Vec<f64>,
    samples: Vec<[f64; 11]>,
    generic_net: Vec<f64>,
    generic_samples: Vec<[f64; 11]>,
}

fn direction(alpha: &[[f64; 2]], count: usize, closed: bool) -> Direction {
    let roots: Vec<Root> = alpha.iter().map(|&[re, im]| Root { re, im }).collect();
    let roots = Roots::new(&roots, "roots").expect("the reference's roots are closed under conjugation");
    Direction { roots, count, closed, level: 0 }
}

/// A surface of the reference with one of its nets.
fn surface(case: &Case, net: &[f64]) -> TensorSurface {
    let points = net.len() / 3;
    let rows = |closed: bool, m: f64, from: f64, other: usize| {
        if closed {
            m as usize
        } else if from == 0.0 {
            m as usize + 3
        } else {
            points / other
        }
    };
    let cols = rows(case.closed_v, case.m_v, case.from_v, if case.closed_u { case.m_u as usize } else { 9 });
    let u = direction(&case.alpha_u, points / cols, case.closed_u);
    let v = direction(&case.alpha_v, cols, case.closed_v);
    TensorSurface::new(net.to_vec(), u, v).expect("the reference's net fits")
}

#[test]
fn points_and_derivatives_are_the_references() {
    let golden: Golden = golden::parse(include_str!("../golden/splines/surfaces.json"));
    for case in &golden.surfaces {
        for (net, samples) in [(&case.net, &case.samples), (&case.generic_net, &case.generic_samples)] {
            let surface = surface(case, net);
            let size = 10.0 * net.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            for sample in samples {
                let (u, v) = (case.m_u * (sample[0] - case.from_u), case.m_v * (sample[1] - case.from_v));
                for (at, (du, dv), unit) in [(2, (0, 0), 1.0), (5, (1, 0), case.m_u), (8, (0, 1), case.m_v)] {
                    let got = surface.evaluate(u, v, du, dv).expect("the place is in the domain") * unit;
                    let expected = Vector3::from_column_slice(&sample[at..at + 3]);
                    let deviation = (got - expected).amax() / size;
                    assert!(deviation <= SURFACES * unit, "{} at {u}, {v}: off by {deviation:e}", case.name);
                }
            }
        }
    }
}

/// Name, surface, a function that vanishes on it, and a size.
type Quadric = (&'static str, TensorSurface, fn(Vector3) -> f64, f64);

/// The shapes, with the implicit equation of each: a function that vanishes on it, and a size for its rounding.
fn quadrics() -> Vec<Quadric> {
    let made = |surface: expline::Result<TensorSurface>| surface.expect("the numbers are in their ranges");
    let sphere = |p: Vector3| p.norm() - 2.0;
    let ellipsoid = |p: Vector3| (p.x / 1.0).powi(2) + (p.y / 2.0).powi(2) + (p.z / 3.0).powi(2) - 1.0;
    let torus = |p: Vector3| (p.x.hypot(p.y) - 3.0).hypot(p.z) - 1.0;
    let cylinder = |p: Vector3| p.x.hypot(p.y) - 2.0;
    // x²y² + y²z² + z²x² = r²·xyz for the Roman surface of size r.
    let roman = |p: Vector3| {
        (p.x * p.y).powi(2) + (p.y * p.z).powi(2) + (p.z * p.x).powi(2) - 9.0 * (p.x * p.y * p.z)
    };
    let saddle = |p: Vector3| (p.x / 4.0).powi(2) - (p.y / 4.0).powi(2) - p.z / 8.0;
    vec![
        ("sphere", made(TensorSurface::sphere(2.0, [8, 4])), sphere, 2.0),
        ("smallest sphere", made(TensorSurface::sphere(2.0, [3, 2])), sphere, 2.0),
        ("ellipsoid", made(TensorSurface::ellipsoid(Vector3::new(1.0, 2.0, 3.0), [5, 4])), ellipsoid, 3.0),
        ("torus", made(TensorSurface::torus(3.0, 1.0, [8, 6])), torus, 4.0),
        ("smallest torus", made(TensorSurface::torus(3.0, 1.0, [3, 3])), torus, 4.0),
        ("cylinder", made(TensorSurface::cylinder(2.0, 5.0, [8, 2])), cylinder, 5.0),
        ("Roman surface", made(TensorSurface::roman_surface(3.0, [5, 5])), roman, 100.0),
        ("saddle", made(TensorSurface::hyperbolic_paraboloid([4.0, 4.0, 8.0], [6, 6])), saddle, 8.0),
    ]
}

/// Parameters all over the domain of a surface, both ends among them.
fn places(surface: &TensorSurface, count: usize) -> Vec<(f64, f64)> {
    let [end_u, end_v] = surface.domain();
    let at = |i: usize, end: f64| end * (i as f64 / (count - 1) as f64);
    (0..count * count).map(|i| (at(i / count, end_u), at(i % count, end_v))).collect()
}

#[test]
fn every_quadric_is_exact() {
    for (name, surface, vanishes, size) in quadrics() {
        for (u, v) in places(&surface, 33) {
            let point = surface.evaluate(u, v, 0, 0).expect("in the domain");
            let deviation = vanishes(point).abs();
            assert!(deviation <= EXACT * size, "{name} at {u}, {v}: {deviation:e}");
        }
    }
}

#[test]
fn the_surface_goes_through_its_net() {
    for (name, surface, _, size) in quadrics() {
        let [u, v] = surface.directions().map(|direction| direction.count);
        for i in 0..u {
            for j in 0..v {
                let [at_u, at_v] = surface.parameters(i, j);
                let [end_u, end_v] = surface.domain();
                if (0.0..=end_u).contains(&at_u) && (0.0..=end_v).contains(&at_v) {
                    let got = surface.evaluate(at_u, at_v, 0, 0).expect("in the domain");
                    let expected = Vector3::from_column_slice(&surface.net()[3 * (i * v + j)..][..3]);
                    assert!((got - expected).norm() <= EXACT * size, "{name} at net point {i}, {j}");
                }
            }
        }
    }
}

#[test]
fn seams_have_one_value_from_both_sides_and_closed_parameters_are_periodic() {
    for (name, surface, _, size) in quadrics() {
        let [end_u, end_v] = surface.domain();
        let closed = surface.directions().map(|direction| direction.closed);
        for k in 0..20 {
            let (u, v) = (end_u * 0.05 * f64::from(k), end_v * 0.05 * f64::from(k));
            for (du, dv) in [(0, 0), (1, 0), (0, 1)] {
                let at = |u: f64, v: f64| surface.evaluate(u, v, du, dv).expect("in the domain");
                if closed[0] {
                    let seam = (at(0.0, v) - at(end_u * (1.0 - f64::EPSILON), v)).norm();
                    let round = (at(u, v) - at(u - 3.0 * end_u, v)).norm();
                    assert!(seam.max(round) <= SEAM * size, "{name}: {seam:e}, {round:e}");
                }
                if closed[1] {
                    let seam = (at(u, 0.0) - at(u, end_v * (1.0 - f64::EPSILON))).norm();
                    let round = (at(u, v) - at(u, v + 2.0 * end_v)).norm();
                    assert!(seam.max(round) <= SEAM * size, "{name}: {seam:e}, {round:e}");
                }
            }
        }
    }
}

#[test]
fn a_net_moves_its_surface_under_affine_maps() {
    let matrix = nalgebra::Matrix3::new(1.0, 0.5, -0.25, 0.0, 2.0, 1.0, 0.5, -1.0, 1.5);
    let shift = Vector3::new(10.0, -7.0, 3.0);
    for (name, surface, _, size) in quadrics() {
        for finer in [surface.clone(), surface.refine(1, 2).expect("within the limits")] {
            let moved: Vec<f64> = finer
                .net()
                .chunks_exact(3)
                .flat_map(|p| (matrix * Vector3::from_column_slice(p) + shift).data.0[0])
                .collect();
            let [u, v] = finer.directions().map(Clone::clone);
            let image = TensorSurface::new(moved, u, v).expect("the net fits");
            for (u, v) in places(&finer, 9) {
                let expected = matrix * finer.evaluate(u, v, 0, 0).expect("in the domain") + shift;
                let got = image.evaluate(u, v, 0, 0).expect("in the domain");
                assert!((got - expected).norm() <= EXACT * (size + 20.0), "{name} at {u}, {v}");
            }
        }
    }
}

#[test]
fn moving_a_point_moves_the_surface_there_and_nowhere_far() {
    let mut random = Random::new(3);
    let net: Vec<f64> = (0..12 * 14 * 3).map(|_| random.symmetric()).collect();
    let direction = |count, closed| Direction {
        roots: Roots::ellipse(12).expect("a root list by intent"),
        count,
        closed,
        level: 0,
    };
    let surface = TensorSurface::new(net, direction(12, true), direction(14, false)).expect("the net fits");
    let mut moved = surface.clone();
    moved.set_point(0, 6, Vector3::new(4.0, 5.0, 6.0)).expect("in the net");
    let at = |surface: &TensorSurface, u: f64, v: f64| surface.evaluate(u, v, 0, 0).expect("in the domain");
    assert!((at(&moved, 0.0, 5.0) - Vector3::new(4.0, 5.0, 6.0)).norm() < 1e-14, "through the moved point");
    for (u, v) in places(&surface, 45) {
        let far = (u - 12.0 * (u / 12.0).round()).abs() >= 2.0 || (v - 5.0).abs() >= 2.0;
        // At the very end of its reach a weight is 0 but for its rounding.
        let change = (at(&surface, u, v) - at(&moved, u, v)).norm();
        assert!(!far || change <= 1e-15, "unchanged at {u}, {v}");
    }
}

#[test]
fn a_pole_stays_smooth_when_points_around_it_move() {
    let mut random = Random::new(5);
    for round in [3, 4, 5, 6, 8, 11] {
        let mut surface = TensorSurface::sphere(1.0, [round, 4]).expect("in the ranges");
        for _ in 0..6 {
            let (i, j) = (random.below(round), 2 + random.below(3));
            let point = Vector3::new(random.symmetric(), random.symmetric(), random.symmetric());
            surface.set_point(i, j, point).expect("in the net");
        }
        surface.set_point(1, 5, Vector3::new(0.1, 0.2, 1.5)).expect("in the net");
        for v in [0.0, 4.0] {
            let normals: Vec<_> = (0..24)
                .map(|k| surface.normal(f64::from(k) * round as f64 / 24.0, v).expect("in the domain"))
                .collect();
            let first = normals[0].expect("there is one");
            for normal in normals.into_iter().flatten() {
                assert!(
                    (normal - first).norm() < 1e-12,
                    "one normal at the pole of {round}: {normal} and {first}"
                );
            }
            let point = surface.evaluate(0.3, v, 0, 0).expect("in the domain");
            assert!(
                (surface.evaluate(1.7, v, 0, 0).expect("in the domain") - point).norm() < 1e-14,
                "one point"
            );
        }
    }
}

/// How far apart the normals all round an end of v are.
fn spread_of_normals(surface: &TensorSurface, v: f64) -> f64 {
    let [round, _] = surface.domain();
    let normal =
        |k: u32| surface.normal(round * f64::from(k) / 24.0, v).expect("in the domain").expect("one");
    (1..24).map(|k| (normal(k) - normal(0)).norm()).fold(0.0, f64::max)
}

#[test]
fn poles_stay_smooth_where_the_row_of_one_is_a_row_inside_the_other() {
    // Cubics in v, two units from pole to pole: rows −2 to 4, of which 2, the north pole, is what row −2 follows.
    let round = 8;
    let u =
        Direction { roots: Roots::ellipse(round).expect("in range"), count: round, closed: true, level: 0 };
    let v = Direction { roots: Roots::polynomials(3).expect("in range"), count: 7, closed: false, level: 0 };
    let meridian = [(0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
    let net = (0..round).flat_map(|k| {
        let angle = core::f64::consts::TAU * k as f64 / round as f64;
        meridian.iter().flat_map(move |(r, z)| [r * libm::cos(angle), r * libm::sin(angle), *z])
    });
    let mut surface = TensorSurface::new(net.collect(), u, v).expect("the net fits");
    for (row, to) in [
        (4, Vector3::new(0.1, 0.2, 1.5)),
        (2, Vector3::new(-0.2, 0.1, -1.2)),
        (3, Vector3::new(1.1, 0.3, 0.2)),
        (4, Vector3::new(0.0, 0.1, 1.1)),
    ] {
        assert!(surface.set_point(3, row, to).expect("in the net"), "others move along with row {row}");
        for end in [0.0, 2.0] {
            let apart = spread_of_normals(&surface, end);
            assert!(apart < 1e-12, "after row {row} the normals at {end} are {apart:e} apart");
        }
    }
}

#[test]
fn poles_stay_smooth_wherever_the_surface_lies() {
    for far in [1e3, 1e6, 1e7, 1e8, 9e8] {
        let mut away = [0.0; 16];
        (0..4).for_each(|i| away[5 * i] = 1.0);
        away[12..15].fill(far);
        let sphere = TensorSurface::sphere(1.0, [8, 4]).expect("in the ranges");
        let mut surface = sphere.transformed(&away).expect("within the limits");
        let to = Vector3::new(far + 0.8, far + 0.1, far - 0.9);
        assert!(surface.set_point(0, 2, to).expect("in the net"), "at {far:e} the row beyond follows");
        // A point is a rounding of 1e-16 off there, and a tangent some of them.
        let apart = spread_of_normals(&surface, 0.0);
        assert!(apart < 1e-12 + 1e-14 * far, "at {far:e} the normals are {apart:e} apart");
    }
}

#[test]
fn a_point_far_away_makes_no_pole_smooth() {
    let mut surface = TensorSurface::sphere(1.0, [8, 4]).expect("in the ranges");
    surface.set_point(2, 0, Vector3::new(0.1, -0.6, -0.7)).expect("in the net");
    surface.set_point(5, 5, Vector3::new(0.0, 0.0, 1e9)).expect("in the net");
    let before = surface.net().to_vec();
    surface.set_point(2, 2, Vector3::new(0.0, 0.7, -0.6)).expect("in the net");
    let changed = before.iter().zip(surface.net()).filter(|(a, b)| a != b).count();
    assert!(changed <= 3, "{changed} numbers changed");
}

#[test]
fn what_is_too_small_to_be_computed_with_is_0_wherever_it_is_set() {
    let torus = TensorSurface::torus(3.0, 1.0, [8, 6]).expect("in the ranges");
    let (mut surface, small) = (torus.clone(), Vector3::new(1e-60, -1e-200, 2.0));
    surface.set_point(1, 2, small).expect("in the net");
    assert_eq!(surface.net()[3 * 8..][..3], [0.0, 0.0, 2.0], "as in a net");
    let [u, v] = surface.directions().map(Clone::clone);
    let flat = TensorSurface::new(vec![0.0; surface.net().len()], u, v).expect("the net fits");
    let mut patched = flat.refine_at(1.0, 2.0, 1, 1.0).expect("within the limits");
    patched.set_patch_point(0, 1, 1, small).expect("in the patch");
    let displaced: Vec<f64> =
        patched.displacements(0).expect("one").iter().copied().filter(|x| *x != 0.0).collect();
    assert_eq!(displaced, [2.0], "as in a patch that is loaded");
}

#[test]
fn points_beyond_a_pole_are_the_callers_once_one_was_moved() {
    let mut surface = TensorSurface::sphere(1.0, [8, 4]).expect("in the ranges");
    surface.set_point(2, 0, Vector3::new(0.0, 3.0, 0.0)).expect("in the net");
    let before = surface.net().to_vec();
    surface.set_point(2, 2, Vector3::new(0.0, 2.0, 0.0)).expect("in the net");
    let changed = before.iter().zip(surface.net()).filter(|(a, b)| a != b).count();
    assert!(changed <= 3, "{changed} numbers changed");
}

#[test]
fn what_is_wrong_with_a_net_is_said_before_anything_is_made() {
    let direction = |count, closed| Direction {
        roots: Roots::polynomials(2).expect("a root list by intent"),
        count,
        closed,
        level: 0,
    };
    let made = |net: Vec<f64>, u, v| unboxed(TensorSurface::new(net, u, v)).map(|_| ());
    let wrong = made(vec![0.0; 4 * 3 * 3], direction(4, false), direction(4, false));
    assert_eq!(wrong, Err(Error::WrongLength { argument: "net", got: 36, needed: 48 }), "another length");
    let many = made(Vec::new(), direction(65536, false), direction(65536, false));
    assert!(matches!(many, Err(Error::LimitExceeded { argument: "net", .. })), "{many:?}");
    let few = made(vec![0.0; 24], direction(4, false), direction(2, true));
    assert_eq!(
        few,
        Err(Error::TooFewPoints { argument: "v.count", got: 2, needed: 3 }),
        "two closed columns"
    );
    let short = made(vec![0.0; 36], direction(3, false), direction(4, false));
    assert_eq!(short, Err(Error::TooFewPoints { argument: "u.count", got: 3, needed: 4 }), "three open rows");
    let mut net = vec![0.0; 48];
    net[35] = f64::NAN;
    let nan = made(net, direction(4, false), direction(4, false));
    assert_eq!(nan, Err(Error::NotFinite { argument: "net", index: Some(35) }), "NaN");
    let surface =
        TensorSurface::new(vec![0.0; 48], direction(4, false), direction(4, false)).expect("the net fits");
    let beyond = unboxed(surface.evaluate(1.0 + 1e-15, 0.5, 0, 0));
    assert!(matches!(beyond, Err(Error::OutOfRange { argument: "u", index: None, .. })), "{beyond:?}");
    let beyond = unboxed(surface.normal(0.5, f64::NAN));
    assert_eq!(beyond, Err(Error::NotFinite { argument: "v", index: None }), "one number has no index");
    let beyond = unboxed(surface.curvature(-1.0, 0.5));
    assert!(matches!(beyond, Err(Error::OutOfRange { argument: "u", index: None, .. })), "{beyond:?}");
    let huge = unboxed(surface.refine(12, 12)).map(|_| ());
    assert!(matches!(huge, Err(Error::LimitExceeded { argument: "levels", .. })), "{huge:?}");
}

#[test]
fn roots_without_an_interpolator_are_refused_at_every_level() {
    let root = |re: f64| Root { re, im: 0.0 };
    let ellipse = Direction {
        roots: Roots::ellipse(8).expect("a root list by intent"),
        count: 8,
        closed: true,
        level: 1,
    };
    let mut one_sided = ellipse.clone();
    one_sided.roots = Roots::new(&[root(0.0), root(0.0), root(1.0)], "roots").expect("conjugates are there");
    let mut two = ellipse.clone();
    two.roots = Roots::polynomials(1).expect("a root list by intent");
    for level in [0, 1, 5] {
        for list in [&mut one_sided, &mut two] {
            list.level = level;
            for (u, v, name) in [(&*list, &ellipse, "u.roots"), (&ellipse, &*list, "v.roots")] {
                let refused = unboxed(TensorSurface::new(vec![0.5; 192], u.clone(), v.clone())).map(|_| ());
                let named = match refused {
                    Err(Error::Degenerate { argument, .. } | Error::TooFewPoints { argument, .. }) => {
                        argument
                    }
                    _ => "nothing",
                };
                assert_eq!(named, name, "level {level}: {refused:?}");
            }
        }
    }
}

#[test]
fn a_torus_may_reach_as_far_as_coordinates_and_no_farther() {
    assert!(TensorSurface::torus(6e8, 4e8, [8, 6]).is_ok(), "1e9 to the point");
    let refused = unboxed(TensorSurface::torus(6e8, 6e8, [8, 6])).map(|_| ());
    assert!(
        matches!(refused, Err(Error::OutOfRange { argument: "tube", most, .. }) if most == 4e8),
        "{refused:?}"
    );
}
