//! Many points of a long curve: what is seen of them from afar hides nothing from the search.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::curves::Random;
use core::f64::consts::TAU;
use expline::fit::{Ask, Fit, FitStatus, Options, fit};
use expline::numerics::Point;

/// A wave of so many periods, each 10 long and 8 high, through so many points with noise of 0.1.
fn wave(periods: usize, count: usize) -> Fit {
    let mut random = Random::new(7);
    let points: Vec<Point> = (0..count)
        .map(|i| {
            let turns = periods as f64 * i as f64 / count as f64;
            Point::new(10.0 * turns, 4.0 * (TAU * turns).sin()) + random.noise() * 0.1
        })
        .collect();
    let options = Options { closed: Some(false), ..Options::default() };
    fit(&points, Ask::Noise, &options).expect("a curve")
}

/// Averages of a fortieth of a period and of a third: with the second alone, the wave is not there.
#[test]
fn what_is_left_of_a_long_wave_is_its_noise() {
    for periods in [10, 150] {
        let fitted = wave(periods, 6000);
        assert_eq!(fitted.status, FitStatus::Converged, "{periods} periods");
        assert!((fitted.noise - 0.1).abs() < 0.01, "{periods} periods: the noise is found, {}", fitted.noise);
        // Distances are across the curve only; it follows a little of the noise.
        assert!(fitted.rms < 1.1 * 0.1, "{periods} periods: {}", fitted.rms);
        assert!(fitted.max_error < 6.0 * 0.1, "{periods} periods: {}", fitted.max_error);
        let knots = fitted.knots.len();
        assert!((periods..=8 * periods).contains(&knots), "{periods} periods: {knots} knots");
    }
}
