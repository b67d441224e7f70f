//! Normals, curvatures and meshes: right at poles, the same bits in every part.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use crate::support::tolerance::{
    CURVATURES, CURVATURES_AT_POLES, CURVATURES_BESIDE_POLES, CURVATURES_OF_COINS, NORMALS, NORMALS_AT_POLES,
};
use crate::support::unboxed;
use expline::generator::Roots;
use expline::numerics::Vector3;
use expline::surface::{Direction, Grid, Region};
use expline::{Error, TensorSurface};

fn sphere() -> TensorSurface {
    TensorSurface::sphere(2.0, [8, 4]).expect("in the ranges")
}

fn torus() -> TensorSurface {
    TensorSurface::torus(3.0, 1.0, [8, 6]).expect("in the ranges")
}

fn character() -> TensorSurface {
    TensorSurface::character().expect("a shape of ours")
}

/// A net of random points.
fn random_surface(rows: usize, cols: usize, closed: bool) -> TensorSurface {
    let mut random = Random::new(9);
    let net = (0..3 * rows * cols).map(|_| random.symmetric()).collect();
    let roots = Roots::ellipse(rows).expect("a root list by intent");
    let direction = |count| Direction { roots: roots.clone(), count, closed, level: 0 };
    TensorSurface::new(net, direction(rows), direction(cols)).expect("the net fits")
}

fn mesh(surface: &TensorSurface, grid: Grid, region: &Region) -> (Vec<f64>, Vec<f64>, usize) {
    let count = 3 * region.rows.len() * region.cols.len();
    let (mut positions, mut normals) = (vec![0.0; count], vec![0.0; count]);
    let without = surface.mesh_into(grid, region, &mut positions, &mut normals).expect("within the limits");
    (positions, normals, without)
}

#[test]
fn normals_of_a_sphere_point_outwards_up_to_the_poles_and_at_them() {
    let surface = sphere();
    for i in 0..=64 {
        for v in [0.0, 1e-300, 1e-12, 1e-9, 1e-8, 3e-8, 1e-6, 0.1, 1.0, 2.0, 3.3, 3.9999, 4.0 - 1e-10, 4.0] {
            let u = f64::from(i) * 0.125;
            let normal = surface.normal(u, v).expect("in the domain").expect("there is one");
            let outwards = surface.evaluate(u, v, 0, 0).expect("in the domain") / 2.0;
            let near_pole = !(1e-4..4.0 - 1e-4).contains(&v);
            let tolerance = if near_pole { NORMALS_AT_POLES } else { NORMALS };
            assert!((normal - outwards).norm() <= tolerance, "at {u}, {v}: {normal} for {outwards}");
            assert!((normal.norm() - 1.0).abs() < 1e-15, "a unit vector");
        }
    }
}

#[test]
fn normals_of_a_torus_are_those_of_its_tube() {
    let surface = torus();
    for i in 0..100 {
        let (u, v) = (0.08 * f64::from(i), 0.61 * f64::from(i));
        let point = surface.evaluate(u, v, 0, 0).expect("closed");
        let axis = Vector3::new(point.x, point.y, 0.0).normalize() * 3.0;
        let normal = surface.normal(u, v).expect("closed").expect("there is one");
        assert!((normal - (point - axis)).norm() <= NORMALS, "at {u}, {v}");
    }
}

#[test]
fn a_surface_without_a_tangent_plane_has_no_normal() {
    let roots = Roots::polynomials(2).expect("a root list by intent");
    let direction = |closed| Direction { roots: roots.clone(), count: 4, closed, level: 0 };
    let point = TensorSurface::new(vec![1.0; 48], direction(true), direction(true)).expect("the net fits");
    assert_eq!(point.normal(0.5, 0.5), Ok(None), "all points equal");
    let line: Vec<f64> = (0..16).flat_map(|i| [f64::from(i), 2.0 * f64::from(i), 0.5]).collect();
    let line = TensorSurface::new(line, direction(false), direction(false)).expect("the net fits");
    let grid = Grid { rows: 8, cols: 8 };
    let (positions, normals, without) = mesh(&line, grid, &grid.whole());
    assert!(positions.iter().chain(&normals).all(|x| x.is_finite()), "finite");
    assert_eq!(without, 64, "every vertex is counted");
    assert!(normals.iter().all(|x| *x == 0.0), "and has no normal");
}

#[test]
fn curvatures_of_sphere_and_torus_are_the_closed_forms() {
    let surface = sphere();
    for i in 0..=40 {
        for k in 0..=40 {
            let (u, v) = (0.2 * f64::from(i), 0.1 * f64::from(k));
            let got = surface.curvature(u, v).expect("in the domain");
            let tolerance = if k % 40 == 0 { CURVATURES_AT_POLES } else { CURVATURES };
            // Against the outward normal: 1/r², −1/r.
            assert!((got.gaussian - 0.25).abs() <= tolerance * 0.25, "K at {u}, {v}: {}", got.gaussian);
            assert!((got.mean + 0.5).abs() <= tolerance * 0.5, "H at {u}, {v}: {}", got.mean);
        }
    }
    let surface = torus();
    for k in 0..60 {
        let v = 0.1 * f64::from(k);
        let cos = (core::f64::consts::TAU * v / 6.0).cos();
        let got = surface.curvature(1.3, v).expect("closed");
        let (gaussian, mean) = (cos / (3.0 + cos), -(3.0 + 2.0 * cos) / (2.0 * (3.0 + cos)));
        assert!((got.gaussian - gaussian).abs() <= CURVATURES, "K at {v}");
        assert!((got.mean - mean).abs() <= CURVATURES, "H at {v}");
    }
}

/// K and H of the ellipsoid with these half axes at the angles a (round) and b (from the south pole), and the outer
/// normal.
fn of_ellipsoid(radii: [f64; 3], a: f64, b: f64) -> (f64, f64, Vector3) {
    let [p, q, r] = radii;
    let at = [a.cos() * b.sin(), a.sin() * b.sin(), -b.cos()];
    let gradient = Vector3::new(at[0] / p, at[1] / q, at[2] / r);
    let (h, volume) = (gradient.norm(), p * q * r);
    let inside = (0..3).map(|k| radii[k] * radii[k] * (at[k] * at[k] - 1.0)).sum::<f64>();
    let gaussian = 1.0 / (volume * h * h) / (volume * h * h);
    (gaussian, 0.5 * inside / (volume * h) / (volume * h) / h, gradient / h)
}

/// The largest relative deviations of K and H from the closed forms, and that of normals, at a list of v.
fn off_ellipsoid(radii: [f64; 3], [m, n]: [usize; 2], places: &[f64]) -> [f64; 3] {
    let surface = TensorSurface::ellipsoid(Vector3::from(radii), [m, n]).expect("in the ranges");
    let mut most = [0.0_f64; 3];
    for k in 0..23 {
        for &v in places {
            let u = m as f64 * f64::from(k) / 23.0;
            let (a, b) = (core::f64::consts::TAU * u / m as f64, core::f64::consts::PI * v / n as f64);
            let (gaussian, mean, normal) = of_ellipsoid(radii, a, b);
            let got = surface.curvature(u, v).expect("in the domain");
            let got_normal = surface.normal(u, v).expect("in the domain").expect("there is one");
            most[0] = most[0].max((got.gaussian / gaussian - 1.0).abs());
            most[1] = most[1].max((got.mean / mean - 1.0).abs());
            most[2] = most[2].max((got_normal - normal).norm());
        }
    }
    most
}

#[test]
fn curvatures_and_normals_of_what_is_thin_are_the_closed_forms() {
    let places = [0.0, 0.4, 1.0, 1.7, 2.0, 2.9, 3.5, 4.0];
    for thin in [1e-3, 3e-4, 1e-5, 1e-7, 1e-9] {
        for radii in
            [[1.0, thin, thin], [thin, 1.0, thin], [thin, thin, 1.0], [1.0, 1.0, thin], [1.0, thin, 1.0]]
        {
            for size in [1.0, 1e-6, 1e6] {
                let radii = radii.map(|radius| size * radius);
                let off = off_ellipsoid(radii, [8, 4], &places);
                // A derivative's rounding, 1e-16 of the length, is this part of the thickness; curvatures feel its
                // square.
                assert!(off[0].max(off[1]) <= CURVATURES, "curvatures of {radii:?}: {off:?}");
                assert!(off[2] <= NORMALS + 1e-15 / thin, "normals of {radii:?}: {off:?}");
            }
        }
    }
    let wire = TensorSurface::cylinder(1e-6, 1.0, [8, 2]).expect("in the ranges");
    let mean = wire.curvature(0.3, 1.0).expect("in the domain").mean;
    assert!((mean / -5e5 - 1.0).abs() <= CURVATURES, "H of a wire: {mean}");
    for tube in [3e-6, 1e-6] {
        let ring = TensorSurface::torus(1.0, tube, [8, 6]).expect("in the ranges");
        let cos = (core::f64::consts::TAU / 6.0).cos();
        let exact = cos / (tube * (1.0 + tube * cos));
        let got = ring.curvature(0.3, 1.0).expect("closed").gaussian;
        assert!((got / exact - 1.0).abs() <= 1e-15 / tube, "K of a ring: {got} for {exact}");
    }
}

#[test]
fn curvatures_beside_the_poles_of_coins_change_as_they_do() {
    // Up to where nothing is done about poles.
    let places: Vec<f64> = (0..80).map(|k| 4.0 * 2e-8 * 1.12_f64.powi(k)).collect();
    let last: Vec<f64> = places.iter().map(|v| 4.0 - v).collect();
    for thin in [0.5, 0.1, 0.03, 1e-2, 1e-3, 1e-4] {
        for radii in [[1.0, thin, 1.2], [thin, 1.0, 0.7], [2.0, 1.5, 2.0 * thin]] {
            for places in [&places, &last] {
                let off = off_ellipsoid(radii, [8, 4], places);
                let tolerance = if thin >= 0.5 { CURVATURES_BESIDE_POLES } else { CURVATURES_OF_COINS };
                assert!(off[0].max(off[1]) <= tolerance, "curvatures of {radii:?}: {off:?}");
            }
        }
    }
}

#[test]
fn normals_beside_the_poles_of_what_is_thin_point_outwards() {
    for thin in [1e-3, 5e-6, 1e-7, 1e-9] {
        for radii in
            [[1.0, thin, 0.8], [thin, 1.0, 1.3], [1.0, 0.7, thin], [thin, thin, 1.0], [thin, 1.0, thin]]
        {
            let surface = TensorSurface::ellipsoid(Vector3::from(radii), [7, 2]).expect("in the ranges");
            for k in 0..70 {
                for (u, v) in [(0.3, 1e-10), (2.6, 3e-10), (5.1, 7e-10)] {
                    let near = v * 1.3_f64.powi(k);
                    for v in [near, 2.0 - near] {
                        let normal = surface.normal(u, v).expect("in the domain").expect("there is one");
                        let point = surface.evaluate(u, v, 0, 0).expect("in the domain");
                        // The tangent plane has all of an ellipsoid on one side, its centre too.
                        assert!(normal.dot(&point) > 0.0, "{radii:?} at {u}, {v}: {normal}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_mesh_has_the_curvatures_of_what_is_thin() {
    let surface = TensorSurface::ellipsoid(Vector3::new(1e5, 1.0, 1.0), [8, 4]).expect("in the ranges");
    let grid = Grid { rows: 16, cols: 9 };
    let mut got = vec![0.0; 2 * 16 * 9];
    surface.mesh_curvatures_into(grid, &grid.whole(), &mut got).expect("within the limits");
    for i in 0..16 {
        for j in 0..9 {
            let turn = core::f64::consts::TAU / 16.0;
            let (gaussian, mean, _) = of_ellipsoid([1e5, 1.0, 1.0], turn * i as f64, turn * j as f64);
            let [k, h] = [0, 16 * 9].map(|first| got[first + 9 * i + j]);
            assert!((k / gaussian - 1.0).abs() <= 1e-10, "K at {i}, {j}: {k} for {gaussian}");
            assert!((h / mean - 1.0).abs() <= 1e-10, "H at {i}, {j}: {h} for {mean}");
        }
    }
}

#[test]
fn curvatures_at_a_pole_are_the_same_from_all_sides() {
    for segments in [[3, 2], [5, 3], [8, 4], [64, 32]] {
        let off = off_ellipsoid([1.0, 2.0, 3.0], segments, &[0.0, segments[1] as f64]);
        assert!(off[0].max(off[1]) <= CURVATURES_AT_POLES, "{segments:?}: {off:?}");
    }
    // So many points: their rounding, over the square of the distance between two that are beside each other round the
    // pole.
    let off = off_ellipsoid([1.0; 3], [1024, 1024], &[0.0, 1024.0]);
    assert!(off[0].max(off[1]) <= 1e-9, "1024 segments: {off:?}");
    let sphere = sphere().refine(3, 2).expect("within the limits");
    for u in [0.0, 0.3, 5.1] {
        for v in [0.0, 4.0] {
            let got = sphere.curvature(u, v).expect("in the domain");
            assert!((got.gaussian - 0.25).abs() <= CURVATURES_AT_POLES, "K at {u}, {v}: {}", got.gaussian);
            assert!((got.mean + 0.5).abs() <= CURVATURES_AT_POLES, "H at {u}, {v}: {}", got.mean);
        }
    }
}

#[test]
fn poles_of_u_have_the_curvatures_of_poles_of_v() {
    let surface = TensorSurface::ellipsoid(Vector3::new(1.0, 2.0, 3.0), [5, 3]).expect("in the ranges");
    let [u, v] = surface.directions().map(Clone::clone);
    let points = surface.net().as_chunks::<3>().0;
    let turned = (0..v.count).flat_map(|j| (0..u.count).flat_map(move |i| points[i * v.count + j]));
    let turned = TensorSurface::new(turned.collect(), v.clone(), u.clone()).expect("the net fits");
    for t in [0.0, 1e-5, 1e-3, 1.3, 3.0 - 1e-5, 3.0] {
        let (got, of) = (turned.curvature(t, 0.7), surface.curvature(0.7, t));
        let (got, of) = (got.expect("in the domain"), of.expect("in the domain"));
        // The normal points the other way.
        assert!((got.gaussian / of.gaussian - 1.0).abs() <= CURVATURES_BESIDE_POLES, "K at {t}");
        assert!((got.mean / of.mean + 1.0).abs() <= CURVATURES_BESIDE_POLES, "H at {t}");
    }
}

#[test]
fn curvatures_beside_a_pole_are_the_closed_forms() {
    let near: Vec<f64> = (1..60).map(|k| 0.5_f64.powi(k)).chain([4.1e-4, 4.9e-4, 5.1e-4]).collect();
    for segments in [[3, 2], [5, 3], [8, 4]] {
        let end = segments[1] as f64;
        let places: Vec<f64> = near.iter().flat_map(|d| [*d, end - d]).collect();
        let off = off_ellipsoid([1.0, 2.0, 3.0], segments, &places);
        assert!(off[0].max(off[1]) <= CURVATURES_BESIDE_POLES, "{segments:?}: {off:?}");
    }
}

#[test]
fn curvatures_inside_a_surface_that_degenerates_there_are_its_limits_or_0() {
    // z = x² − y², all of whose lines of one direction meet at the origin: K = −4 there, H = 0.
    let saddle = TensorSurface::hyperbolic_paraboloid([1.0; 3], [3, 4]).expect("in the ranges");
    for v in [0.0, 0.7, 2.0, 4.0] {
        let got = saddle.curvature(1.5, v).expect("in the domain");
        assert!((got.gaussian + 4.0).abs() <= CURVATURES && got.mean.abs() <= CURVATURES, "{v}: {got:?}");
    }
    // A torus that touches itself has a cone's tip there: no limit.
    let horn = TensorSurface::torus(1.0, 1.0, [8, 6]).expect("in the ranges");
    let got = horn.curvature(0.3, 3.0).expect("closed");
    assert_eq!((got.gaussian, got.mean), (0.0, 0.0), "no limit");
}

#[test]
fn a_mesh_has_the_surfaces_points_normals_and_curvatures() {
    for surface in [sphere(), torus(), character(), random_surface(5, 7, true)] {
        let grid = Grid { rows: 24, cols: 17 };
        let (positions, normals, without) = mesh(&surface, grid, &grid.whole());
        let mut curvatures = vec![0.0; 2 * 24 * 17];
        surface.mesh_curvatures_into(grid, &grid.whole(), &mut curvatures).expect("within the limits");
        assert_eq!(without, 0, "every vertex has a normal");
        let [end_u, end_v] = surface.domain();
        let [closed_u, closed_v] = surface.directions().map(|direction| direction.closed);
        for i in 0..24 {
            for j in 0..17 {
                let u = end_u * i as f64 / (if closed_u { 24.0 } else { 23.0 });
                let v = end_v * j as f64 / (if closed_v { 17.0 } else { 16.0 });
                let at = 3 * (17 * i + j);
                let point = surface.evaluate(u, v, 0, 0).expect("in the domain");
                let normal = surface.normal(u, v).expect("in the domain").expect("there is one");
                assert!(
                    (point - Vector3::from_column_slice(&positions[at..at + 3])).norm() < 1e-13,
                    "{i}, {j}"
                );
                assert!(
                    (normal - Vector3::from_column_slice(&normals[at..at + 3])).norm() < 1e-9,
                    "{i}, {j}"
                );
                let curvature = surface.curvature(u, v).expect("in the domain");
                let scale = 1.0 + curvature.gaussian.abs() + curvature.mean.abs();
                let [gaussian, mean] = [0, 24 * 17].map(|first| curvatures[first + 17 * i + j]);
                assert!((gaussian - curvature.gaussian).abs() < 1e-8 * scale * scale, "K at {i}, {j}");
                assert!((mean - curvature.mean).abs() < 1e-8 * scale, "H at {i}, {j}");
            }
        }
    }
}

#[test]
fn a_part_of_a_mesh_is_that_part_of_the_whole_to_the_bit() {
    let grid = Grid { rows: 60, cols: 44 };
    for before in
        [sphere(), torus(), character(), random_surface(16, 16, true), random_surface(16, 16, false)]
    {
        let [rows, cols] = before.directions().map(|direction| direction.count);
        let mut random = Random::new(rows as u64);
        for _ in 0..12 {
            let (i, j) = (random.below(rows), random.below(cols));
            let (mut positions, mut normals, _) = mesh(&before, grid, &grid.whole());
            let mut surface = before.clone();
            let point = Vector3::new(random.symmetric(), random.symmetric(), random.symmetric());
            surface.set_point(i, j, point).expect("in the net");
            let region = before.touched(grid, i, j).expect("in the net");
            let (part, part_normals, _) = mesh(&surface, grid, &region);
            for (a, row) in region.rows.clone().enumerate() {
                for (b, col) in region.cols.clone().enumerate() {
                    let from = 3 * (a * region.cols.len() + b);
                    let to = 3 * ((row % 60) * 44 + col % 44);
                    positions[to..to + 3].copy_from_slice(&part[from..from + 3]);
                    normals[to..to + 3].copy_from_slice(&part_normals[from..from + 3]);
                }
            }
            let (whole, whole_normals, _) = mesh(&surface, grid, &grid.whole());
            assert_eq!(positions, whole, "positions after net point {i}, {j} moved");
            assert_eq!(normals, whole_normals, "normals after net point {i}, {j} moved");
        }
    }
}

#[test]
fn a_point_that_is_moved_far_away_changes_no_normal_where_it_does_not_act() {
    let grid = Grid { rows: 64, cols: 64 };
    let before = TensorSurface::sphere(1.0, [16, 16]).expect("in the ranges");
    let (positions, normals, _) = mesh(&before, grid, &grid.whole());
    // A million times as large as the sphere: all other normals were once taken for those of degenerate places.
    for x in [1e3, 1e6, 1e9] {
        let mut surface = before.clone();
        let (i, j) = (0, 10);
        surface.set_point(i, j, Vector3::new(x, 0.0, 0.0)).expect("in the net");
        let region = surface.touched(grid, i, j).expect("in the net");
        let (moved, moved_normals, without) = mesh(&surface, grid, &grid.whole());
        assert_eq!(without, 0, "{x}: every vertex has a normal");
        let within = |range: &core::ops::Range<usize>, k: usize, count: usize| {
            range.contains(&k) || range.contains(&(k + count))
        };
        for k in 0..64 * 64 {
            if within(&region.rows, k / 64, 64) && within(&region.cols, k % 64, 64) {
                continue;
            }
            assert_eq!(moved[3 * k..][..3], positions[3 * k..][..3], "{x}: position {k}");
            assert_eq!(moved_normals[3 * k..][..3], normals[3 * k..][..3], "{x}: normal {k}");
        }
        let curvature = surface.curvature(8.0, 5.0).expect("in the domain");
        assert!((curvature.gaussian - 1.0).abs() < CURVATURES, "{x}: {}", curvature.gaussian);
    }
}

#[test]
fn triangles_close_the_surface_and_face_where_normals_point() {
    let grid = Grid { rows: 20, cols: 15 };
    for (surface, triangles) in
        [(torus(), 2 * 20 * 15), (sphere(), 2 * 20 * 14), (random_surface(5, 6, false), 2 * 19 * 14)]
    {
        let indices = surface.indices(grid).expect("within the limits");
        assert_eq!(indices.len(), 3 * triangles, "triangles");
        let mut edges = std::collections::BTreeMap::new();
        for t in indices.chunks_exact(3) {
            for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                *edges.entry((a, b)).or_insert(0) += 1;
            }
        }
        assert!(edges.values().all(|n| *n == 1), "no edge is run through twice in one direction");
        let open = edges.keys().filter(|(a, b)| !edges.contains_key(&(*b, *a))).count();
        let closed = surface.directions().map(|direction| direction.closed);
        let rim = if closed[0] { 0 } else { 2 * 14 }
            + if closed[1] { 0 } else { 2 * if closed[0] { 20 } else { 19 } };
        assert_eq!(open, rim, "edges of the rim");
    }
    let surface = torus();
    let indices = surface.indices(grid).expect("within the limits");
    let (positions, normals, _) = mesh(&surface, grid, &grid.whole());
    for t in indices.chunks_exact(3) {
        let at = |list: &[f64], vertex: u32| Vector3::from_column_slice(&list[3 * vertex as usize..][..3]);
        let [a, b, c] = [t[0], t[1], t[2]].map(|vertex| at(&positions, vertex));
        assert!((b - a).cross(&(c - a)).dot(&at(&normals, t[0])) > 0.0, "counterclockwise from outside");
    }
}

#[test]
fn meshes_beyond_the_limits_are_refused_before_memory_is_asked_for() {
    let surface = torus();
    let grid = Grid { rows: 100_000, cols: 100_000 };
    let refused = unboxed(surface.indices(grid));
    assert!(matches!(refused, Err(Error::LimitExceeded { argument: "rows", .. })), "{refused:?}");
    let refused = unboxed(surface.mesh_into(grid, &grid.whole(), &mut [], &mut []));
    assert!(matches!(refused, Err(Error::LimitExceeded { argument: "rows", .. })), "{refused:?}");
    let one = Grid { rows: 1, cols: 5 };
    let refused = unboxed(surface.indices(one));
    assert!(matches!(refused, Err(Error::OutOfRange { argument: "rows", .. })), "{refused:?}");
}
