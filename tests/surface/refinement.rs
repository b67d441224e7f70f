//! Finer nets of the same surface, everywhere or where they are wanted.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use crate::support::tolerance::REFINED;
use crate::support::unboxed;
use expline::generator::{Root, Roots};
use expline::numerics::Vector3;
use expline::surface::{Direction, Grid};
use expline::{Error, TensorSurface};

/// Surfaces of every kind: shapes, random nets of three, four and five roots, closed and open.
fn surfaces() -> Vec<TensorSurface> {
    let mut random = Random::new(21);
    let mut list = vec![
        TensorSurface::sphere(1.0, [3, 2]).expect("in the ranges"),
        TensorSurface::torus(1.0, 0.4, [5, 3]).expect("in the ranges"),
        TensorSurface::roman_surface(1.4, [5, 5]).expect("in the ranges"),
        TensorSurface::hyperbolic_paraboloid([1.0, 1.0, 1.0], [3, 4]).expect("in the ranges"),
        TensorSurface::character().expect("a shape of ours"),
    ];
    let roots = [Roots::ellipse(7), Roots::polynomials(3), Roots::harmonics(7, 2), Roots::hyperbola(0.4)];
    for (k, roots) in roots.into_iter().enumerate() {
        let roots = roots.expect("a root list by intent");
        let direction = |count, closed| Direction { roots: roots.clone(), count, closed, level: 0 };
        let net = (0..3 * 7 * 9).map(|_| random.symmetric()).collect();
        let made = TensorSurface::new(net, direction(7, true), direction(9, k % 2 == 0));
        list.push(made.expect("the net fits"));
    }
    list
}

/// The largest distance between two surfaces of one domain.
fn distance(a: &TensorSurface, b: &TensorSurface) -> f64 {
    distance_at(37, a, b)
}

/// The same at so many places in each direction.
fn distance_at(places: u32, a: &TensorSurface, b: &TensorSurface) -> f64 {
    let [end_u, end_v] = a.domain();
    assert_eq!(a.domain(), b.domain(), "the parameter stays");
    let (mut most, share): (f64, _) = (0.0, |i: u32| f64::from(i) / f64::from(places));
    for i in 0..=places {
        for j in 0..=places {
            let (u, v) = (end_u * share(i), end_v * share(j));
            let [p, q] = [a, b].map(|surface| surface.evaluate(u, v, 0, 0).expect("in the domain"));
            most = most.max((p - q).norm());
        }
    }
    most
}

#[test]
fn refining_leaves_the_surface_as_it_is() {
    for (k, surface) in surfaces().into_iter().enumerate() {
        for (u, v) in [(1, 0), (0, 1), (1, 1), (2, 3), (4, 1)] {
            let finer = surface.refine(u, v).expect("within the limits");
            let deviation = distance(&surface, &finer);
            assert!(deviation <= REFINED, "surface {k}, levels {u}, {v}: {deviation:e}");
            let stepwise = surface.refine(u, 0).and_then(|s| s.refine(0, v)).expect("within the limits");
            assert!(distance(&surface, &stepwise) <= REFINED, "one direction after the other");
        }
    }
}

#[test]
fn refined_nets_come_nearer_by_four_with_every_level() {
    for (k, surface) in surfaces().into_iter().enumerate() {
        let away = |levels: u32| {
            let finer = surface.refine(levels, levels).expect("within the limits");
            let [rows, cols] = finer.directions().map(|direction| direction.count);
            let [end_u, end_v] = finer.domain();
            let mut most: f64 = 0.0;
            for i in 0..rows {
                for j in 0..cols {
                    let [u, v] = finer.parameters(i, j);
                    if (0.0..=end_u).contains(&u) && (0.0..=end_v).contains(&v) {
                        let point = Vector3::from_column_slice(&finer.net()[3 * (i * cols + j)..][..3]);
                        most = most.max((finer.evaluate(u, v, 0, 0).expect("in the domain") - point).norm());
                    }
                }
            }
            most
        };
        let ratio = away(4) / away(5);
        assert!((3.5..4.6).contains(&ratio), "surface {k}: {ratio}");
    }
}

#[test]
fn reducing_gives_back_what_was_refined_and_says_how_far_anything_else_is() {
    for (k, surface) in surfaces().into_iter().enumerate() {
        let finer = surface.refine(2, 1).expect("within the limits");
        let (back, deviation) = finer.reduce(2, 1).expect("it was refined");
        assert!(deviation <= REFINED, "surface {k}: {deviation:e}");
        for (a, b) in surface.net().iter().zip(back.net()) {
            assert!((a - b).abs() <= 1e-9, "surface {k}: {a} and {b}");
        }
        let mut changed = finer.clone();
        changed.set_point(3, 3, Vector3::new(0.4, 0.1, 0.2)).expect("in the net");
        let (coarse, deviation) = changed.reduce(1, 1).expect("it was refined");
        // Fourteen places and more across each field of the net: a peak rises between them by less than 3e-3 of itself.
        let measured = distance_at(400, &coarse, &changed);
        assert!(
            (0.997..1.0001).contains(&(measured / deviation)),
            "surface {k}: {measured} said to be {deviation}"
        );
    }
}

#[test]
fn of_two_peaks_in_a_row_a_reduction_tells_the_higher_though_it_lies_between_the_places_that_are_looked_at() {
    let roots = Roots::hyperbola(0.5).expect("a root list by intent");
    let direction = |count, closed| Direction { roots: roots.clone(), count, closed, level: 0 };
    let flat = TensorSurface::new(vec![0.0; 3 * 5 * 4], direction(5, false), direction(4, true));
    let mut changed = flat.and_then(|flat| flat.refine(1, 1)).expect("the net fits");
    for (i, j, x, y, z) in [(5, 7, 5.0, 9.0, 5.0), (0, 5, 1.0, 2.0, 1.0), (5, 1, 9.0, 5.0, 2.0)] {
        changed.set_point(i, j, Vector3::new(x, y, z)).expect("in the net");
    }
    let (coarse, deviation) = changed.reduce(1, 1).expect("it was refined");
    let measured = distance_at(400, &coarse, &changed);
    // What is promised; it was 1.4 % too little.
    assert!(measured <= 1.0001 * deviation, "{measured} said to be {deviation}");
}

#[test]
fn an_open_net_comes_back_with_its_points_beyond_the_ends_wherever_it_lies() {
    let mut random = Random::new(22);
    let pair = |re: f64, im: f64| [Root { re, im }, Root { re: -re, im: -im }];
    let mixed = [&[Root::default(); 3][..], &pair(0.9, 0.0), &pair(0.0, 0.8)].concat();
    let around = Roots::ellipse(5).expect("a root list by intent");
    for roots in [vec![Root::default(); 4], vec![Root::default(); 6], mixed] {
        let order = roots.len();
        let open = |count| Direction {
            roots: Roots::new(&roots, "roots").expect("a root list by intent"),
            count,
            closed: false,
            level: 0,
        };
        for far in [0.0, 1e3, 9e8] {
            // As many intervals as it takes for the surface to tell every point beyond its ends.
            let (rows, cols) = (3 * order - 5, 5);
            let net: Vec<f64> = (0..3 * rows * cols).map(|_| far + random.symmetric()).collect();
            let around = Direction { roots: around.clone(), count: cols, closed: true, level: 0 };
            let surface = TensorSurface::new(net.clone(), open(rows), around).expect("the net fits");
            let (back, _) = surface.refine(2, 1).and_then(|fine| fine.reduce(2, 1)).expect("it was refined");
            let off = back.net().iter().zip(&net).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            // The point farthest out weighs 1e-5 of the others at the end of the surface.
            assert!(off <= 1e-10 * (1.0 + far), "{order} roots, {far}: {off:e}");
        }
    }
}

#[test]
fn an_open_net_too_short_to_tell_its_points_beyond_the_ends_has_them_near_by() {
    let mut random = Random::new(24);
    for order in [4, 5, 6] {
        let roots = Roots::polynomials(order - 1).expect("a root list by intent");
        let open = |count| Direction { roots: roots.clone(), count, closed: false, level: 0 };
        let count = 2 * order - 2;
        let net: Vec<f64> = (0..3 * count * count).map(|_| random.symmetric()).collect();
        let reduced = |far: f64| {
            let moved = net.iter().map(|x| x + far).collect();
            let surface = TensorSurface::new(moved, open(count), open(count)).expect("the net fits");
            let fine = surface.refine(1, 1).expect("within the limits");
            let (back, deviation) = fine.reduce(1, 1).expect("it was refined");
            assert!(
                distance(&surface, &back).max(deviation) <= 1e-12 * (1.0 + far),
                "{order} roots: as it was"
            );
            back
        };
        let (here, there) = (reduced(0.0), reduced(1e4));
        for (a, b) in here.net().iter().zip(there.net()) {
            // Rounding of what lies far away, and how little the points weigh.
            assert!((a + 1e4 - b).abs() <= 1e-5, "{order} roots: {a} and {b} move together");
        }
    }
}

#[test]
fn a_patch_leaves_the_surface_as_it_is_and_the_net_too() {
    for surface in surfaces() {
        let [end_u, end_v] = surface.domain();
        let patched = surface.refine_at(0.3 * end_u, 0.6 * end_v, 2, 1.0).expect("within the limits");
        assert_eq!(distance(&surface, &patched), 0.0, "not a bit changes");
        assert_eq!(surface.net(), patched.net(), "no new points elsewhere");
        let shown = patched.patch_points(0).expect("there is one");
        let [(_, _, rows), (_, _, cols)] = patched.patch_window(0).expect("there is one");
        assert_eq!(shown.len(), 3 * rows * cols, "a point for each");
        assert!((6..=9).contains(&rows) && (6..=9).contains(&cols), "those within 1 unit: {rows} × {cols}");
        // The shown points are those of the refined net.
        let finer = surface.refine(2, 2).expect("within the limits");
        let count = finer.directions()[1].count;
        let [(_, first_u, _), (_, first_v, _)] = patched.patch_window(0).expect("there is one");
        let [all_u, all_v] = finer.directions().map(|direction| direction.count);
        let at = 3 * ((first_u + 1) % all_u * count + (first_v + 2) % all_v);
        assert_eq!(shown[3 * (cols + 2)..][..3], finer.net()[at..at + 3], "the refined net's point");
    }
}

#[test]
fn the_points_of_a_patch_anywhere_are_those_of_the_refined_net() {
    let mut random = Random::new(29);
    for surface in surfaces() {
        let levels = [(1, 1), (3, 1), (1, 4)];
        let finer = levels.map(|(u, v)| surface.refine(u, v).expect("within the limits"));
        for ((level_u, level_v), finer) in levels.into_iter().zip(&finer) {
            let [all_u, all_v] = finer.directions().map(|direction| direction.count);
            let [closed_u, closed_v] = finer.directions().map(|direction| direction.closed);
            for _ in 0..12 {
                let mut window = |all: usize, closed: bool| {
                    let first = random.below(all);
                    let room = if closed { all } else { all - first };
                    (first, [1, room, 1 + random.below(room)][random.below(3)])
                };
                let (u, v) = (window(all_u, closed_u), window(all_v, closed_v));
                let patched = surface
                    .add_patch((level_u, u.0, u.1), (level_v, v.0, v.1), &vec![0.0; 3 * u.1 * v.1])
                    .expect("in the grid");
                let shown = patched.patch_points(0).expect("there is one");
                for (at, number) in shown.iter().enumerate() {
                    let (i, j) = (at / 3 / v.1, at / 3 % v.1);
                    let place = 3 * ((u.0 + i) % all_u * all_v + (v.0 + j) % all_v) + at % 3;
                    let off = (number - finer.net()[place]).abs();
                    assert!(
                        off <= 4e-15 * (1.0 + number.abs()),
                        "{u:?} and {v:?} of {level_u} and {level_v}: {off:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_patch_of_the_finest_level_costs_its_own_points_and_no_more() {
    let torus = TensorSurface::torus(3.0, 1.0, [8, 6]).expect("in the ranges");
    let mut patched = torus.refine_at(7.9999, 2.0, 12, 0.001).expect("a few points of hundreds of millions");
    let [(level, first, rows), (_, _, cols)] = patched.patch_window(0).expect("there is one");
    assert_eq!((level, rows, cols), (12, 9, 8), "all within 0.001: across the seam of u");
    let shown = patched.patch_points(0).expect("there is one");
    for (k, point) in shown.as_chunks::<3>().0.iter().enumerate() {
        let (i, j) = (k / cols, k % cols);
        // The points of three roots lie at the middles of the grid's intervals.
        let u = ((first + i) as f64 + 0.5) / 4096.0;
        let [_, (_, first_v, _)] = patched.patch_window(0).expect("there is one");
        let v = ((first_v + j) as f64 + 0.5) / 4096.0;
        let on = torus.evaluate(u, v, 0, 0).expect("closed");
        assert!((on - Vector3::from(*point)).norm() < 1e-6, "control points lie near the surface");
    }
    let before = patched.clone();
    patched.set_patch_point(0, 4, 4, Vector3::new(5.0, 0.0, 0.0)).expect("in the patch");
    let after = patched.patch_points(0).expect("there is one");
    assert!((after[3 * (4 * cols + 4)] - 5.0).abs() < 1e-15, "where it was put");
    assert!(distance(&before, &patched) < 1e-15, "and nowhere but there");
    // A surface that is finer in one direction, in part or wholly, has it, too.
    for (u, v) in [(1, 0), (0, 3), (7, 7)] {
        let finer = patched.refine(u, v).expect("within the limits");
        assert_eq!(finer.patch_count(), 1, "the net is too coarse for it");
        for (du, dv) in [(0.0, 0.0), (3e-4, -2e-4), (0.5, 0.5)] {
            let [p, q] = [&patched, &finer].map(|s| s.evaluate(7.9999 + du, 2.0 + dv, 0, 0).expect("closed"));
            assert!((p - q).norm() <= 1e-12, "refined by {u}, {v}: {:e}", (p - q).norm());
        }
    }
    // So has one whose patch is fine in one direction only, and the finer one is as small as it can be.
    let displacements = vec![0.25; 3 * 4 * 3];
    let long = torus.add_patch((12, 32_766, 4), (1, 3, 3), &displacements).expect("in the grid");
    let finer = long.refine(0, 4).expect("within the limits");
    let [(_, _, rows), (level, _, cols)] = finer.patch_window(0).expect("there is one");
    assert_eq!((rows, level, cols), (4, 4, 38), "four rows of all that three points reach");
    for (u, v) in [(0.0, 2.0), (1e-4, 2.3), (7.9998, 1.1), (0.0, 3.9), (4.0, 2.0)] {
        let [p, q] = [&long, &finer].map(|s| s.evaluate(u, v, 0, 0).expect("closed"));
        assert!((p - q).norm() <= 1e-12, "at {u}, {v}: {:e}", (p - q).norm());
    }
    // What a patch may have is what a net may have.
    let refused = unboxed(torus.refine_at(1.0, 1.0, 12, 1.0)).map(|_| ());
    assert!(matches!(refused, Err(Error::LimitExceeded { argument: "levels", .. })), "{refused:?}");
}

#[test]
fn room_is_made_at_the_same_place_however_many_turns_away() {
    let torus = TensorSurface::torus(3.0, 1.0, [8, 6]).expect("in the ranges");
    let window = |u: f64, v: f64| {
        let patched = torus.refine_at(u, v, 1, 1.0).expect("within the limits");
        patched.patch_window(0).expect("there is one")
    };
    // From 2⁵³ on a step of the grid is less than a rounding of the parameter; powers of two are whole turns of 8
    // there, and of 6 with 3.
    for power in [10, 40, 53, 60, 1000] {
        let turns = libm::pow(2.0, f64::from(power));
        assert_eq!(window(turns, 3.0 * turns), window(0.0, 0.0), "2^{power} away");
        assert_eq!(window(-turns, -3.0 * turns), window(0.0, 0.0), "2^{power} away on the other side");
    }
}

#[test]
fn a_patch_all_the_way_round_may_begin_at_any_row() {
    let mut random = Random::new(23);
    let torus = TensorSurface::torus(3.0, 1.0, [8, 6]).expect("in the ranges");
    let displacements: Vec<f64> = (0..3 * 16 * 12).map(|_| 0.3 * random.symmetric()).collect();
    for (first_u, first_v) in [(0, 0), (5, 0), (0, 3), (5, 3), (15, 11)] {
        let patched =
            torus.add_patch((1, first_u, 16), (1, first_v, 12), &displacements).expect("it goes round");
        let refined = patched.refine(1, 1).expect("within the limits");
        assert_eq!(refined.patch_count(), 0, "the finer net holds all of it");
        let off = distance(&patched, &refined);
        assert!(off < 1e-13, "from {first_u} and {first_v} on {off:e}");
        // The points of the patch are those of the refined net, from its first row on.
        let shown = patched.patch_points(0).expect("there is one");
        let at = 3 * (first_u * 12 + first_v);
        let apart = (0..3).map(|k| (shown[k] - refined.net()[at + k]).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-13, "the first point is {apart:e} off");
    }
}

#[test]
fn a_patch_point_changes_its_surroundings_only_and_a_coarse_point_takes_it_along() {
    let surface = TensorSurface::torus(1.0, 0.4, [8, 6]).expect("in the ranges");
    let mut patched = surface.refine_at(7.9, 3.0, 2, 1.0).expect("within the limits");
    let shown = patched.patch_points(0).expect("there is one");
    let [_, (_, _, cols)] = patched.patch_window(0).expect("there is one");
    let target = Vector3::new(0.7, 0.1, 0.3);
    patched.set_patch_point(0, 4, 4, target).expect("in the patch");
    let after = patched.patch_points(0).expect("there is one");
    for (i, (a, b)) in shown.iter().zip(&after).enumerate() {
        let moved = i / 3 == 4 * cols + 4;
        assert!(
            if moved { (b - target[i % 3]).abs() < 1e-15 } else { a == b },
            "only the one that was moved"
        );
    }
    let mut changed = 0;
    for i in 0..160 {
        for j in 0..120 {
            let (u, v) = (0.05 * f64::from(i), 0.05 * f64::from(j));
            let [p, q] = [&surface, &patched].map(|s| s.evaluate(u, v, 0, 0).expect("closed"));
            changed += usize::from(p != q);
        }
    }
    // Three fine steps of a quarter each way: 15 × 15 of the places.
    assert!((150..=225).contains(&changed), "{changed} places changed");
    let detail =
        patched.evaluate(7.9, 3.0, 0, 0).expect("closed") - surface.evaluate(7.9, 3.0, 0, 0).expect("closed");
    let mut moved = [surface.clone(), patched.clone()];
    for s in &mut moved {
        s.set_point(0, 3, Vector3::new(0.2, 0.3, 0.1)).expect("in the net");
    }
    let [p, q] = [0, 1].map(|k| moved[k].evaluate(7.9, 3.0, 0, 0).expect("closed"));
    assert!((q - p - detail).norm() < 1e-14, "the detail came along");
    // Its mesh, its refinement and its copy from plain numbers have the detail too.
    let grid = Grid { rows: 40, cols: 30 };
    let (mut positions, mut normals) = (vec![0.0; 3600], vec![0.0; 3600]);
    patched.mesh_into(grid, &grid.whole(), &mut positions, &mut normals).expect("within the limits");
    let at = patched.evaluate(8.0 * 39.0 / 40.0, 3.0, 0, 0).expect("closed");
    assert!(
        (at - Vector3::from_column_slice(&positions[3 * (39 * 30 + 15)..][..3])).norm() < 1e-14,
        "the mesh"
    );
    for (u, v) in [(1, 0), (1, 1), (2, 2), (3, 0), (3, 3)] {
        let finer = patched.refine(u, v).expect("within the limits");
        assert!(distance(&patched, &finer) <= REFINED, "refined by {u}, {v}");
    }
    let [u, v] = patched.patch_window(0).expect("there is one");
    let copy = surface.add_patch(u, v, patched.displacements(0).expect("there is one")).expect("it fits");
    assert_eq!(copy, patched, "from plain numbers");
}

#[test]
fn patches_pushed_one_after_the_other_are_those_that_were_added_and_one_that_is_refused_changes_nothing() {
    let sphere = TensorSurface::sphere(1.0, [8, 4]).expect("in the ranges");
    let (mut pushed, mut added) = (sphere.clone(), sphere);
    let mut random = Random::new(8);
    for k in 0..40 {
        let [u, v] = [(1 + k % 3, random.below(8), 1 + random.below(3)), (1 + k % 2, random.below(4), 2)];
        let displacements: Vec<f64> = (0..3 * u.2 * v.2).map(|_| random.symmetric()).collect();
        added = added.add_patch(u, v, &displacements).expect("it fits");
        pushed.push_patch(u, v, &displacements).expect("it fits");
        let mut bad = displacements.clone();
        bad[1] = f64::NAN;
        let refused = unboxed(pushed.push_patch(u, v, &bad));
        assert_eq!(refused, Err(Error::NotFinite { argument: "displacements", index: Some(1) }));
        let refused = unboxed(pushed.push_patch(u, (2, 0, 99), &displacements));
        assert!(matches!(refused, Err(Error::OutOfRange { argument: "v.count", .. })), "{refused:?}");
        assert_eq!(pushed, added, "after patch {k}");
    }
}

#[test]
fn refinements_beyond_the_limits_are_refused() {
    let roots = Roots::polynomials(2).expect("a root list by intent");
    let direction = Direction { roots, count: 1000, closed: false, level: 0 };
    let surface =
        TensorSurface::new(vec![0.5; 3_000_000], direction.clone(), direction).expect("the net fits");
    let refused = unboxed(surface.refine(6, 6)).map(|_| ());
    assert!(matches!(refused, Err(Error::LimitExceeded { argument: "levels", .. })), "{refused:?}");
    let refused = unboxed(surface.refine(13, 0)).map(|_| ());
    assert!(matches!(refused, Err(Error::OutOfRange { argument: "levels", .. })), "{refused:?}");
    // Told what is asked for in all: one level alone is in its range.
    let refused = unboxed(surface.refine(1, 0).and_then(|finer| finer.refine(12, 0))).map(|_| ());
    let limit = Error::LimitExceeded { argument: "levels", limit: "maxLevels", most: 12.0, needed: 13.0 };
    assert_eq!(refused, Err(limit), "twelve levels on one");
    // Rows and columns closed: 2⁹·8 times 2⁷·8 are 4,194,304 to the point, and as many as may be.
    let torus = TensorSurface::torus(3.0, 1.0, [8, 8]).expect("in the ranges");
    let finest = torus.refine(9, 7).expect("exactly at the limit");
    assert_eq!(finest.net().len(), 3 * 4_194_304, "as many as the limit");
    let refused = unboxed(torus.refine(9, 8)).map(|_| ());
    assert!(matches!(refused, Err(Error::LimitExceeded { argument: "levels", .. })), "{refused:?}");
    let refused = unboxed(surface.refine_at(3.0, 3.0, 1, 1e-9)).map(|_| ());
    assert!(matches!(refused, Err(Error::Degenerate { argument: "reach", .. })), "{refused:?}");
}

#[test]
fn a_derived_surface_is_one_that_can_be_made_of_its_own_numbers_or_it_is_refused() {
    let roots = Roots::hyperbola(1.85).expect("a root list by intent");
    let direction = Direction { roots, count: 7, closed: true, level: 0 };
    let net = (0..147).map(|i| if i % 2 == 0 { 9e8 } else { -9e8 }).collect();
    let surface = TensorSurface::new(net, direction.clone(), direction).expect("the net fits");
    // Control points lie beyond the points that they interpolate: at 1.17e9 here.
    let refused = unboxed(surface.refine(1, 1)).map(|_| ());
    assert!(matches!(refused, Err(Error::OutOfRange { argument: "net", .. })), "{refused:?}");
    let sphere = TensorSurface::sphere(1.0, [8, 4]).expect("in the ranges");
    let mut moved = sphere.clone();
    let mut refused = None;
    for i in 0..8 {
        let before = moved.clone();
        let x = if i < 3 || i == 7 { 9.9e8 } else { -9.9e8 };
        // Rows beyond the pole are row 2 less twice its first harmonic: up to 1.4e9.
        if let Err(error) = moved.set_point(i, 2, Vector3::new(x, 0.0, 0.0)) {
            assert_eq!(moved, before, "a point that is refused changes nothing");
            refused = Some(*error);
        }
        assert!(moved.net().iter().all(|x| x.abs() <= 1e9), "after point {i}");
    }
    assert!(matches!(refused, Some(Error::OutOfRange { argument: "net", .. })), "{refused:?}");
}
