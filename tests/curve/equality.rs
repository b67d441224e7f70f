//! Promises about curves as values: what has the same numbers is equal, whatever way it was made, and what differs in
//! one of them is not.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::curve::Side;
use expline::generator::{Root, Roots};
use expline::{HermiteCurve, HermiteOptions, InterpolatingCurve, LocalCurve, Space};
use nalgebra::Vector2;

type Point = Vector2<f64>;

const SQUARE: [f64; 8] = [0.0, 0.0, 9.0, 0.0, 9.0, 9.0, 0.0, 9.0];

fn options() -> HermiteOptions {
    let points: Vec<Point> = SQUARE.chunks_exact(2).map(Point::from_column_slice).collect();
    HermiteOptions { tangents: points.clone(), points, closed: true, ..HermiteOptions::default() }
}

fn hermite(change: impl FnOnce(&mut HermiteOptions)) -> HermiteCurve {
    let mut options = options();
    change(&mut options);
    HermiteCurve::new(options).expect("in range")
}

#[test]
fn hermite_curves_are_equal_that_have_the_same_numbers() {
    let plain = hermite(|_| ());
    let spelt_out = hermite(|options| {
        options.space = Some(Space::Trigonometric);
        options.tangents_in = options.tangents.clone();
        options.omega = plain.omega().to_vec();
        options.lengths = vec![1.0; 4];
    });
    assert_eq!(plain, spelt_out, "what is left out is the same as what it stands for");
    let there_and_back =
        plain.with_point(1, Point::new(1.0, 2.0)).and_then(|c| c.with_point(1, Point::new(9.0, 0.0)));
    assert_eq!(there_and_back.as_ref(), Ok(&plain), "and so is what was changed back");
    let others = [
        hermite(|options| options.points[2].y += 1e-15 * 9.0),
        hermite(|options| options.tangents[2].y = 1.0),
        plain.with_tangent(2, Point::new(1.0, 1.0), Side::In).expect("in range"),
        hermite(|options| options.closed = false),
        hermite(|options| options.lengths = vec![1.0, 1.0, 2.0, 1.0]),
        hermite(|options| options.omega = vec![0.5]),
        hermite(|options| (options.space, options.omega) = (Some(Space::Hyperbolic), plain.omega().to_vec())),
        plain.refine(2).expect("few enough"),
    ];
    for (i, other) in others.iter().enumerate() {
        assert_ne!(&plain, other, "number {i}");
    }
}

#[test]
fn curves_on_a_grid_are_equal_that_have_the_same_numbers() {
    let made = |points: [f64; 8], closed, roots: Option<usize>| {
        let roots = roots.map(|count| Roots::new(&vec![Root::default(); count], "roots").expect("zeros"));
        InterpolatingCurve::new(points.to_vec(), 2, closed, roots).expect("in range")
    };
    let plain = made(SQUARE, true, Some(4));
    let moved = SQUARE.map(|number| if number == 9.0 { 8.0 } else { number });
    assert_eq!(plain, made(SQUARE, true, Some(4)), "of generators that were made one by one");
    for (i, other) in [made(moved, true, Some(4)), made(SQUARE, false, Some(4)), made(SQUARE, true, None)]
        .iter()
        .enumerate()
    {
        assert_ne!(&plain, other, "number {i}");
    }
    let fine = |m| plain.refine(1, 2, m).and_then(|curve| curve.refine(m)).expect("few enough");
    assert_eq!(fine(2), fine(2), "of one step");
    assert_ne!(fine(2), fine(4), "of another");
    let local = || LocalCurve::new(plain.clone()).refine_at(1.5, 3, 0.25).expect("in range");
    assert_eq!(local(), local(), "with room for detail");
    assert_ne!(local(), LocalCurve::new(plain.clone()), "without it");
    assert_ne!(local(), local().with_patch_point(0, 0, &[1.0, 2.0]).expect("in range"), "and with detail");
}
