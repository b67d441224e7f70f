//! Affine maps: the image of a curve or a surface is made of the images of its points.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use crate::support::unboxed;
use expline::generator::{Root, Roots};
use expline::numerics::{Point, Vector, Vector3};
use expline::surface::Direction;
use expline::{BSplineCurve, Error, HermiteCurve, InterpolatingCurve, LocalCurve, TensorSurface};
use nalgebra::{Matrix4, Vector4};

/// Points of size 1 and entries of size 2 give images of size 10; each is a sum of a dozen roundings, and so is the
/// curve.
const SAME: f64 = 1e-13;

const SPACE: [f64; 16] =
    [0.5, 1.5, -1.0, 0.0, -2.0, 0.25, 0.5, 0.0, 1.0, -0.75, 2.0, 0.0, 3.0, -4.0, 5.0, 1.0];
const PLANE: [f64; 6] = [0.5, 1.5, -2.0, 0.25, 3.0, -4.0];

/// The matrix as graphics have it, for the plane as well.
fn matrix(dimension: usize) -> (Vec<f64>, Matrix4<f64>) {
    if dimension == 3 {
        return (SPACE.to_vec(), Matrix4::from_column_slice(&SPACE));
    }
    let [a, b, c, d, e, f] = PLANE;
    (PLANE.to_vec(), Matrix4::new(a, c, 0.0, e, b, d, 0.0, f, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0))
}

/// Where the matrix takes a point (`w` 1) or a derivative (`w` 0).
fn mapped(matrix: &Matrix4<f64>, place: &[f64], w: f64) -> Vec<f64> {
    let z = place.get(2).copied().unwrap_or(0.0);
    let image = matrix * Vector4::new(place[0], place[1], z, w);
    image.as_slice()[..place.len()].to_vec()
}

fn assert_image(what: &str, matrix: &Matrix4<f64>, w: f64, before: &[f64], after: &[f64]) {
    for (is, should) in after.iter().zip(mapped(matrix, before, w)) {
        assert!((is - should).abs() < SAME, "{what}: {is} for {should}");
    }
}

fn lists() -> Vec<Roots> {
    [Roots::polynomials(3), Roots::ellipse(9), Roots::harmonics(9, 2), Roots::hyperbola(0.7)]
        .into_iter()
        .map(|roots| roots.expect("in range"))
        .collect()
}

/// Interpolating curves of all roots, in the plane and in space, closed and open.
fn curves() -> Vec<InterpolatingCurve> {
    let mut random = Random::new(11);
    let kinds = [(2, true), (2, false), (3, true), (3, false)];
    let all = lists()
        .into_iter()
        .flat_map(|roots| kinds.map(|(dimension, closed)| (roots.clone(), dimension, closed)));
    all.map(|(roots, dimension, closed)| {
        let points = (0..9 * dimension).map(|_| random.symmetric()).collect();
        InterpolatingCurve::new(points, dimension, closed, Some(roots)).expect("finite")
    })
    .collect()
}

/// Roots without 0: their splines do not keep constants.
fn unmovable() -> Roots {
    let real = |re| Root { re, im: 0.0 };
    Roots::new(&[real(0.5), real(-0.5), real(0.25), real(-0.25)], "roots").expect("symmetric")
}

#[test]
fn an_affine_image_of_a_curve_with_control_points_is_the_image_of_every_point() {
    for curve in curves() {
        let (given, matrix) = matrix(curve.dimension());
        let image = curve.transformed(&given).expect("within limits");
        let fine = curve.refine(2, 2, 3).expect("within limits");
        let finer = fine.transformed(&given).expect("within limits");
        assert_eq!(finer.domain(), fine.domain(), "to the last bit");
        for i in 0..=50 {
            let t = curve.domain().1 * f64::from(i) / 50.0;
            for order in 0..2 {
                let w = f64::from(u8::from(order == 0));
                let before = curve.evaluate(t, order).expect("inside");
                assert_image(
                    "interpolating",
                    &matrix,
                    w,
                    &before,
                    &image.evaluate(t, order).expect("inside"),
                );
                assert_image(
                    "B-splines",
                    &matrix,
                    w,
                    &fine.evaluate(t, order).expect("inside"),
                    &finer.evaluate(t, order).expect("inside"),
                );
            }
        }
    }
}

#[test]
fn patches_of_a_curve_come_along() {
    for curve in curves() {
        let (given, matrix) = matrix(curve.dimension());
        let moved = vec![0.9; curve.dimension()];
        let local = LocalCurve::new(curve).refine_at(4.5, 2, 0.5).expect("inside");
        let local =
            local.refine_at(5.0, 4, 0.2).expect("inside").with_patch_point(0, 1, &moved).expect("finite");
        let image = local.transformed(&given).expect("within limits");
        assert_image(
            "a control point",
            &matrix,
            1.0,
            &moved,
            &image.patch_points(0).expect("there")[moved.len()..],
        );
        for i in 0..=64 {
            let t = 8.0 * f64::from(i) / 64.0;
            assert_image(
                "patched",
                &matrix,
                1.0,
                &local.evaluate(t, 0).expect("inside"),
                &image.evaluate(t, 0).expect("inside"),
            );
        }
    }
}

#[test]
fn an_affine_image_of_a_surface_is_the_image_of_every_point_and_its_patches_come_along() {
    let sphere = TensorSurface::sphere(1.0, [8, 4]).expect("valid");
    let mut surface = sphere.refine_at(2.0, 2.0, 1, 1.0).expect("inside");
    surface.set_patch_point(0, 1, 1, Vector3::new(0.3, 1.5, 0.2)).expect("finite");
    let matrix = Matrix4::from_column_slice(&SPACE);
    for surface in [
        surface,
        sphere.refine(1, 1).expect("fits"),
        TensorSurface::hyperbolic_paraboloid([1.0; 3], [6, 6]).expect("valid"),
    ] {
        let image = surface.transformed(&SPACE).expect("within limits");
        let [end_u, end_v] = surface.domain();
        for (i, j) in (0..=12).flat_map(|i| (0..=12).map(move |j| (f64::from(i), f64::from(j)))) {
            let (u, v) = (end_u * i / 12.0, end_v * j / 12.0);
            for (du, w) in [(0, 1.0), (1, 0.0)] {
                let before = surface.evaluate(u, v, du, 0).expect("inside");
                let after = image.evaluate(u, v, du, 0).expect("inside");
                assert_image("surface", &matrix, w, before.as_slice(), after.as_slice());
            }
        }
    }
}

#[test]
fn the_identity_changes_no_bit() {
    let mut identity = [0.0; 16];
    for k in 0..4 {
        identity[5 * k] = 1.0;
    }
    for curve in curves() {
        let given = if curve.dimension() == 2 { &[1.0, 0.0, 0.0, 1.0, 0.0, 0.0][..] } else { &identity };
        assert_eq!(curve.transformed(given).expect("valid"), curve, "interpolating");
        let local = LocalCurve::new(curve).refine_at(4.5, 2, 0.5).expect("inside");
        assert_eq!(local.transformed(given).expect("valid"), local, "with patches");
    }
    let torus = TensorSurface::torus(3.0, 1.0, [8, 6]).expect("valid");
    assert_eq!(torus.transformed(&identity).expect("valid"), torus, "surface");
}

#[test]
fn without_a_root_0_linear_maps_are_exact_and_translations_are_refused() {
    let mut random = Random::new(12);
    let points: Vec<f64> = (0..18).map(|_| random.symmetric()).collect();
    let through = InterpolatingCurve::new(points.clone(), 2, true, Some(unmovable())).expect("finite");
    let near = BSplineCurve::new(points, 2, false, unmovable(), 1.0, 0.0).expect("finite");
    let [a, b, c, d, ..] = PLANE;
    let (turned, turned_near) = (
        through.transformed(&[a, b, c, d, 0.0, 0.0]).expect("linear"),
        near.transformed(&[a, b, c, d, 0.0, 0.0]).expect("linear"),
    );
    let (_, matrix) = matrix(2);
    for i in 0..=40 {
        let t = through.domain().1 * f64::from(i) / 40.0;
        assert_image(
            "linear",
            &matrix,
            0.0,
            &through.evaluate(t, 0).expect("inside"),
            &turned.evaluate(t, 0).expect("inside"),
        );
        let t = near.domain().0 + (near.domain().1 - near.domain().0) * f64::from(i) / 40.0;
        let (before, after) =
            (near.evaluate(t, 0).expect("inside"), turned_near.evaluate(t, 0).expect("inside"));
        assert_image("linear, near", &matrix, 0.0, &before, &after);
    }
    for error in
        [through.transformed(&PLANE), LocalCurve::new(through).base().transformed(&PLANE)].map(unboxed)
    {
        assert!(
            matches!(error, Err(Error::Degenerate { argument: "matrix", index: Some(4), .. })),
            "a translation: {error:?}"
        );
    }
    let direction = |roots| Direction { roots, count: 6, closed: true, level: 0 };
    let net = (0..108).map(|_| random.symmetric()).collect();
    let surface =
        TensorSurface::new(net, direction(unmovable()), direction(Roots::ellipse(6).expect("valid")))
            .expect("valid");
    assert!(
        matches!(
            unboxed(surface.transformed(&SPACE)),
            Err(Error::Degenerate { argument: "matrix", index: Some(12), .. })
        ),
        "a surface that keeps no constants in u"
    );
}

#[test]
fn a_matrix_that_is_wrong_is_named() {
    let spread = |i: usize, entry: f64| {
        let mut matrix = SPACE;
        matrix[i] = entry;
        matrix
    };
    let torus = TensorSurface::torus(3.0, 1.0, [8, 6]).expect("valid");
    for (wrong, index, code) in [
        (spread(6, f64::NAN), Some(6), "E_NOT_FINITE"),
        (spread(3, 0.1), Some(3), "E_RANGE"),
        (spread(15, 2.0), Some(15), "E_RANGE"),
        (spread(12, 2e9), None, "E_RANGE"),
        (spread(0, 1e308), None, "E_RANGE"),
    ] {
        let error = torus.transformed(&wrong).expect_err("wrong");
        assert_eq!((error.code(), error.argument()), (code, Some("matrix")), "{wrong:?}");
        let at = match *error {
            Error::NotFinite { index, .. } | Error::OutOfRange { index, .. } => index,
            _ => None,
        };
        assert_eq!(at, index, "{wrong:?}");
    }
    assert!(torus.transformed(&spread(15, 1.0 + 1e-7)).is_ok(), "what single precision makes of 1");
    assert!(
        torus.transformed(&SPACE[..12]).is_err_and(|error| error.code() == "E_LENGTH"),
        "without the last row"
    );
    let circle = HermiteCurve::ellipse(Point::zeros(), Vector::new(2.0, 2.0), 0.0, 4).expect("valid");
    for wrong in [[1e10, 0.0, 0.0, 1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0, f64::INFINITY, 0.0]] {
        assert_eq!(circle.transformed(wrong).expect_err("too far").argument(), Some("matrix"), "{wrong:?}");
    }
}
