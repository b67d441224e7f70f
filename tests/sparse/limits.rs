//! How long a fit may take, said in iterations: what it has by then is given, with what is known of it.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use expline::fit::{Ask, Finish, Fit, FitStatus, Fitter, Options};
use expline::numerics::{Point, Vector};

fn outline() -> Vec<Point> {
    let place = |i: usize| {
        let (sine, cosine) = libm::sincos(core::f64::consts::TAU * i as f64 / 300.0);
        Vector::new(cosine, sine) * (100.0 + 20.0 * (5.0 * cosine + 2.0 * sine))
    };
    Random::new(3).noisy(&(0..300).map(place).collect::<Vec<_>>(), 0.5)
}

/// The fit after so many iterations at most, and how many steps it took.
fn within(most: Option<usize>, ask: &Ask) -> (Fit, usize) {
    let options = Options { closed: Some(true), most_iterations: most, ..Options::default() };
    let mut fitter = Fitter::new(&outline(), &options).expect("good points");
    fitter.ask(ask.clone()).expect("a good question");
    let mut last = 0;
    loop {
        let progress = fitter.step(0.0).expect("memory");
        assert!(progress.iteration >= last, "{ask:?}: iterations rise");
        last = progress.iteration;
        if progress.done {
            return (fitter.fit().expect("a curve"), last);
        }
    }
}

/// The largest distance from a fine polyline, which shares nothing with the feet.
fn farthest(fit: &Fit) -> f64 {
    let (start, end) = fit.curve.domain();
    let at = |i: i32| fit.curve.evaluate(start + (end - start) * f64::from(i) / 2e4, 0).expect("inside");
    let curve: Vec<Point> = (0..=20_000).map(at).collect();
    let nearest = |p: &Point| curve.iter().map(|q| (q - p).norm()).fold(f64::INFINITY, f64::min);
    outline().iter().map(nearest).fold(0.0, f64::max)
}

#[test]
fn a_search_ends_after_the_iterations_that_it_may_take_and_measures_what_it_has() {
    for ask in [Ask::Noise, Ask::Tolerance(2.0), Ask::MeanSquare(1.0)] {
        let (whole, rounds) = within(None, &ask);
        assert_eq!((whole.status, whole.iterations), (FitStatus::Converged, rounds), "{ask:?}");
        for most in [0, 1, rounds / 2, rounds - 1] {
            let (early, steps) = within(Some(most), &ask);
            assert_eq!((early.status, early.iterations), (FitStatus::MostIterations, most), "{ask:?}");
            assert_eq!(steps, most, "{ask:?}: what was told on the way");
            let far = farthest(&early);
            // A piece of the polyline is below 1 long, and no bend here is tighter than 5.
            assert!(early.max_error >= far - 1.0 / 40.0, "{ask:?}, {most}: {} below {far}", early.max_error);
        }
        let (same, _) = within(Some(rounds), &ask);
        assert_eq!(same.status, FitStatus::Converged, "{ask:?}: enough is no limit");
        assert_eq!(same.knots, whole.knots, "{ask:?}: and changes nothing");
    }
}

#[test]
fn a_solver_that_ends_early_says_so_with_the_gap_that_it_has() {
    let ask = Ask::Smoothing(0.5);
    let (early, _) = within(Some(3), &ask);
    assert_eq!((early.status, early.iterations), (FitStatus::MostIterations, 3));
    let (whole, _) = within(None, &ask);
    assert_eq!(whole.status, FitStatus::Converged);
    // The best bound of the optimum is the objective of the whole run; nothing claims to be nearer than it is.
    let missing = (early.objective - whole.objective) / early.objective;
    assert!(early.gap >= missing, "gap {:e}, truly {missing:e}", early.gap);
}

/// The most steps of one round each during which the number of iterations stays the same.
fn steps_of_an_iteration(points: &[Point], ask: Ask, options: &Options) -> usize {
    let mut fitter = Fitter::new(points, options).expect("good points");
    fitter.ask(ask).expect("a good question");
    let (mut last, mut steps, mut most) = (0, 0, 0);
    loop {
        let progress = fitter.step(0.0).expect("memory");
        (last, steps) = (progress.iteration, if progress.iteration == last { steps + 1 } else { 0 });
        most = most.max(steps);
        if progress.done {
            return most;
        }
    }
}

#[test]
fn what_comes_last_goes_over_many_points_in_many_steps_between_which_it_can_be_stopped() {
    let count = 50_000;
    let place = |i: usize| {
        let (sine, cosine) = libm::sincos(core::f64::consts::TAU * i as f64 / count as f64);
        Vector::new(cosine, sine) * 100.0
    };
    let circle: Vec<Point> = (0..count).map(place).collect();
    let points = Random::new(7).noisy(&circle, 1.0);
    let finish = Finish { merge: true, slide: true, ..Finish::default() };
    let options = Options { degrees: vec![3], closed: Some(true), finish, ..Options::default() };
    // One look at the dual curve goes around twice, far apart and closely, past 20,000 points a step.
    assert!(steps_of_an_iteration(&points, Ask::Smoothing(0.6), &options) >= 4 * 3, "off the grid");
    // From 4,096 points a step edges are drawn for a polyline.
    assert!(steps_of_an_iteration(&points, Ask::Tolerance(0.5), &options) >= count / 4096, "a polyline");
}
