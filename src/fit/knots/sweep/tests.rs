use super::Sweep;
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::spline::Spline;
use crate::fit::knots::stray::Leash;
use crate::numerics::Point;

const TURN: f64 = core::f64::consts::TAU;
/// The length of the parameter.
const END: f64 = 60.0;

/// Points of a smooth line at each tenth of the parameter; it waves quickly before a third of the way.
fn waves(closed: bool) -> Located {
    let parameters: Vec<f64> = (0..600).map(|i| 0.1 * f64::from(i)).collect();
    let place = |t: &f64| {
        let angle = TURN * t / END;
        let swell = libm::sin(TURN * t / 40.0);
        let quick = if closed || *t > 20.0 { 0.0 } else { 3.0 * swell * swell * libm::sin(TURN * t / 5.0) };
        Point::new(200.0 * libm::cos(angle), 200.0 * libm::sin(angle) + quick)
    };
    Located { points: parameters.iter().map(place).collect(), parameters, weights: Vec::new() }
}

/// The least squares with many even knots, and with what is to be swept of them all within a tolerance.
fn swept(closed: bool, count: usize, tolerance: f64, rounds: usize) -> (Spline, Spline, Located) {
    let located = waves(closed);
    let before = Spline::of(&FreeKnots::new(Breaks::even(3, closed, END, count), &located));
    let mut sweep = Sweep::new(&before, &located, tolerance, Leash { slack: tolerance, share: 0.5 }, -2.0);
    for _ in 0..rounds {
        if sweep.step(&located).is_none() {
            break;
        }
    }
    let (after, feet) = sweep.swept(located);
    (before, after, feet)
}

#[test]
fn every_point_stays_within_the_tolerance_whenever_the_sweep_ends() {
    for closed in [false, true] {
        for rounds in [0, 1, 2, 5, 1000] {
            let (before, after, feet) = swept(closed, 60, 0.05, rounds);
            let largest = after.distances(&feet).into_iter().fold(0.0, f64::max);
            let (was, is) = (before.space.breaks.pieces(), after.space.breaks.pieces());
            // Seven digits more than rounding of numbers near 200 takes.
            assert!(largest <= 0.05 + 1e-9, "{closed}, {rounds} rounds: {largest}");
            assert!(
                is <= was && (rounds > 0 || is == was),
                "{closed}, {rounds} rounds: {is} of {was} pieces"
            );
        }
    }
}

#[test]
fn knots_stay_where_the_curve_needs_them_and_hardly_anywhere_else() {
    let (_, after, _) = swept(false, 60, 0.05, 1000);
    let knots = &after.space.breaks.at;
    let quick = knots.iter().filter(|t| **t <= 21.0).count();
    // Four waves of height 3 within .05 take five pieces each at the most, and two thirds of a circle of 200 eight.
    assert!((8..=20).contains(&quick), "{quick} knots at the waves: {knots:?}");
    assert!(knots.len() - quick <= 8, "{} knots on the arc: {knots:?}", knots.len() - quick);
    let (_, after, _) = swept(true, 60, 0.05, 1000);
    // A circle of 200 within .05: knots that go one after the other leave twice as many as there have to be.
    assert!(after.space.breaks.pieces() <= 16, "{} pieces of a circle", after.space.breaks.pieces());
}

/// The largest jump at the knots, of the point and the derivatives below `orders`.
fn jump(spline: &Spline, orders: usize) -> f64 {
    let space = &spline.space;
    let mut largest = 0.0_f64;
    for k in 0..space.breaks.len() {
        let (before, after) = space.sides(k);
        for order in 0..orders {
            largest = largest.max((spline.at(before, 1.0, order) - spline.at(after, -1.0, order)).norm());
        }
    }
    largest
}

#[test]
fn the_curve_is_as_smooth_as_its_knots_say() {
    for closed in [false, true] {
        let (_, after, _) = swept(closed, 60, 0.05, 1000);
        assert!(jump(&after, 3) < 1e-10, "{closed}: {}", jump(&after, 3));
    }
}

#[test]
fn far_from_what_has_changed_the_curve_is_what_it_was() {
    // A straight half, and one on which every knot is needed.
    let mut before = Spline::of(&FreeKnots::new(Breaks::even(3, false, END, 59), &waves(false)));
    for i in 0..before.space.count {
        before.x[i] = 3.0 * i as f64;
        before.y[i] = if i < 32 { 0.0 } else { 20.0 * (i % 2) as f64 + (i * 7 % 5) as f64 };
    }
    let at = |spline: &Spline, t: f64| {
        let (s, t) = spline.space.find(t, 0);
        spline.on(s, t, 0)
    };
    let parameters = waves(false).parameters;
    let points = parameters.iter().map(|t| at(&before, *t)).collect();
    let located = Located { points, parameters, weights: Vec::new() };
    let mut sweep = Sweep::new(&before, &located, 0.05, Leash { slack: 1.0, share: 1.0 }, -2.0);
    while sweep.step(&located).is_some() {}
    let (after, _) = sweep.swept(located);
    let knots = &after.space.breaks.at;
    assert!(knots.iter().filter(|t| **t < 25.0).count() <= 5, "{knots:?}");
    assert!(knots.iter().filter(|t| **t > 35.0).count() >= 24, "{knots:?}");
    for i in 0..200 {
        let t = 40.0 + 0.1 * f64::from(i);
        let apart = (at(&before, t) - at(&after, t)).norm();
        assert!(apart < 1e-10, "{apart} at {t}");
    }
}

#[test]
fn corners_stay_where_there_are_any_and_become_smooth_where_not() {
    // A half circle and a chord, with a corner at every knot.
    let parameters: Vec<f64> = (0..=600).map(|i| 0.1 * f64::from(i)).collect();
    let place = |t: &f64| {
        let angle = TURN * t.min(30.0) / END;
        let back = 400.0 * ((t - 30.0) / 30.0).max(0.0);
        Point::new(200.0 * libm::cos(angle) + back, 200.0 * libm::sin(angle))
    };
    let located = Located { points: parameters.iter().map(place).collect(), parameters, weights: Vec::new() };
    let mut breaks = Breaks::even(3, false, END, 19);
    breaks.multiplicity.fill(3);
    let before = Spline::of(&FreeKnots::new(breaks, &located));
    let mut sweep = Sweep::new(&before, &located, 0.05, Leash { slack: 0.05, share: 0.5 }, -2.0);
    while sweep.step(&located).is_some() {}
    let (after, _) = sweep.swept(located);
    let breaks = &after.space.breaks;
    let corners: Vec<f64> =
        breaks.at.iter().zip(&breaks.multiplicity).filter(|(_, m)| **m == 3).map(|(t, _)| *t).collect();
    assert_eq!(corners, [30.0], "{breaks:?}");
    assert!(breaks.len() <= 5, "{breaks:?}");
}
