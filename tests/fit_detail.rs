//! Many points of a long curve: what is seen of them from afar hides nothing from the search.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::TAU;
use expline::fit::{Ask, Fit, FitStatus, Options, fit};
use expline::numerics::Point;

fn normal(seed: &mut u64) -> f64 {
    let mut sum = -6.0;
    for _ in 0..12 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        sum += (*seed >> 11) as f64 / (1_u64 << 53) as f64;
    }
    sum
}

/// A wave of so many periods, each 10 long and 8 high, through so many points with noise of 0.1.
fn wave(periods: usize, count: usize) -> Fit {
    let mut seed = 7;
    let points: Vec<Point> = (0..count)
        .map(|i| {
            let turns = periods as f64 * i as f64 / count as f64;
            let noise = Point::new(0.1 * normal(&mut seed), 0.1 * normal(&mut seed));
            Point::new(10.0 * turns, 4.0 * (TAU * turns).sin()) + noise
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
