//! The figures and tables of fits are what the code draws, and show what the page says.

#[path = "../../examples/fit_figures.rs"]
mod figures;

use expline::numerics::Point;
use figures::experiments::{self, Shown};

const AGAIN: &str = "draw it again with `cargo run --example fit_figures` and look at it";

#[test]
fn the_noisy_outline_is_the_one_that_the_code_draws() {
    let drawn = figures::noisy_outline();
    assert!(drawn.as_deref() == Ok(include_str!("../../docs/figures/noisy-outline.svg")), "{AGAIN}");
}

/// The figure and the lines on the page are these.
fn is_shown(name: &str, shown: &Shown, figure: &str) {
    assert!(shown.figure == figure, "{name}: {AGAIN}");
    let page = include_str!("../../docs/FITS.md");
    let table = page.split_once(&figures::mark(name)).and_then(|(_, rest)| rest.split_once(figures::END));
    assert_eq!(table.map(|(table, _)| table), Some(shown.table.as_str()), "{name}: {AGAIN}");
}

#[test]
fn turning_the_points_moves_no_knot_unless_coordinates_are_told_apart() {
    let (rows, shown) = experiments::rotation().expect("it can be fitted");
    is_shown("rotation", &shown, include_str!("../../docs/figures/fit-rotation.svg"));
    let first = &rows[0];
    for row in &rows[1..] {
        let knots = |turned: &experiments::Turned| turned.coupled.solution.components[0].knots.clone();
        assert_eq!(knots(row), knots(first), "{} degrees", row.degrees);
        let apart = |turned: &experiments::Turned| turned.apart.solution.components[0].knots.clone();
        assert!(apart(row) != apart(first), "{} degrees: coordinates apart", row.degrees);
        assert!(row.apart.knots().0 > row.coupled.knots().0, "{} degrees", row.degrees);
    }
}

#[test]
fn knots_that_are_looked_for_do_many_times_better_than_spread_ones() {
    let (found, shown) = experiments::sparsity().expect("it can be fitted");
    is_shown("sparsity", &shown, include_str!("../../docs/figures/fit-sparsity.svg"));
    assert_eq!(found.knots, 20, "the corners of the polygon");
    assert!(found.square <= 12.09, "{}", found.square);
    assert!(found.even > 10.0 * found.square, "{} for {}", found.even, found.square);
    assert!(found.as_good > 5 * found.knots, "{} spread knots come as near", found.as_good);
}

#[test]
fn noise_does_not_add_knots() {
    let (rows, shown) = experiments::noise().expect("it can be fitted");
    is_shown("noise", &shown, include_str!("../../docs/figures/fit-noise.svg"));
    for row in &rows {
        let ((grid, joined), (others, apart)) = (row.coupled.knots(), row.apart.knots());
        assert!((row.coupled.square() / row.square - 1.0).abs() < 1e-3, "{}", row.square);
        assert!((20..=26).contains(&joined), "{joined} knots for 20 corners");
        assert!(4 * others > 5 * grid, "{others} with coordinates apart, {grid} coupled");
        assert!(2 * apart > 3 * joined, "{apart} joined with coordinates apart, {joined} coupled");
        assert!(row.truth[0] < 0.85 * row.truth[1], "{:?} from the truth", row.truth);
    }
    let counts: Vec<usize> = rows.iter().map(|row| row.coupled.knots().0).collect();
    let (least, most) = (counts.iter().min(), counts.iter().max());
    assert!(least.zip(most).is_some_and(|(a, b)| 5 * b < 6 * a), "{counts:?} at three levels");
}

#[test]
fn two_degrees_need_less_than_half_the_knots_of_one_once_they_are_pruned() {
    let (rows, shown) = experiments::hybrid().expect("it can be fitted");
    is_shown("hybrid", &shown, include_str!("../../docs/figures/fit-hybrid.svg"));
    let square = rows[0].matched.square();
    let (both, single) = rows.split_last().expect("four rows");
    for row in single {
        assert!((row.matched.square() / square - 1.0).abs() < 1e-3, "{}: one mean square", row.name);
        assert!(row.pruned.qfe <= square * 1.01, "{}: {}", row.name, row.pruned.qfe);
        assert!(2 * both.pruned.knots.len() < row.pruned.knots.len(), "{} has few knots", row.name);
        assert!(both.numbers() < row.numbers(), "{} has few numbers", row.name);
    }
    // As the convex optimum they do not: the page says so.
    assert!(both.matched.knots().1 > rows[2].matched.knots().1, "joined knots of the optimum");
    let kinks = both.pruned.knots.iter().filter(|knot| knot.degree == 1).count();
    assert!(kinks >= 2, "the kinks at the top and at the bottom are corners");
}

#[test]
fn a_contour_of_2714_points_becomes_simpler_and_keeps_its_kinks() {
    let (rows, shown) = experiments::sweep().expect("it can be fitted");
    is_shown("sweep", &shown, include_str!("../../docs/figures/fit-sweep.svg"));
    for pair in rows.windows(2) {
        assert!(pair[1].solution.knot_count() < pair[0].solution.knot_count(), "fewer knots");
        assert!(pair[1].square() > pair[0].square(), "a larger mean square");
    }
    let tips = [(120.0, 40.0), (760.0, 40.0), (20.0, 500.0), (860.0, 500.0)];
    for row in &rows {
        let places = row.places().expect("they can be evaluated");
        for (x, y) in tips {
            let near = places[0].iter().any(|p| (p - Point::new(x, y)).norm() < 40.0);
            assert!(near, "a knot of degree 1 at ({x}, {y}), where there is a kink: {:?}", row.lambdas);
        }
    }
}
