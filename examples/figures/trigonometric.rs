//! Cosine, sine and the circle from three points.

use core::f64::consts::TAU;

use expline::Result;
use expline::generator::Interpolator;

use super::plot::{Panel, disc, figure, path, text};

/// A function and its name.
type Named = (&'static str, fn(f64) -> f64);

/// M = 3: three weighted translates give the function exactly.
pub(crate) fn cosine_sine_circle() -> Result<String> {
    let generator = Interpolator::for_ellipse(3)?;
    // Periodised: translates by 3 that reach into [0, 3].
    let around = |x: f64| (-2..=2).map(|n| generator.at(x - 3.0 * f64::from(n), 0)).sum::<f64>();
    let mut drawn = String::new();
    let functions: [Named; 2] = [("cos 2πt/3", f64::cos), ("sin 2πt/3", f64::sin)];
    for (i, (name, function)) in functions.into_iter().enumerate() {
        let weight = |k: i32| function(TAU * f64::from(k) / 3.0);
        let panel =
            Panel { page: [34.0 + 222.0 * i as f64, 34.0, 180.0, 170.0], range: [0.0, 3.0, -1.35, 1.35] };
        drawn += &panel.axes(&[1, 2, 3], &[-1.0, 1.0]);
        for (k, class) in (0..3).zip(["curve part red", "curve part blue", "curve part teal"]) {
            drawn += &panel.graph(class, [0.0, 3.0], &|x| weight(k) * around(x - f64::from(k)));
        }
        drawn += &panel
            .graph("curve", [0.0, 3.0], &|x| (0..3).map(|k| weight(k) * around(x - f64::from(k))).sum());
        for k in 0..=3 {
            drawn += &disc("point", panel.place(f64::from(k), weight(k)), 3.5);
        }
        drawn += &text("title", panel.page[0] + 90.0, 22.0, "middle", name);
    }
    let panel = Panel { page: [478.0, 44.0, 150.0, 150.0], range: [-1.2, 1.2, -1.2, 1.2] };
    let at = |x: f64| {
        let sum = |function: fn(f64) -> f64| {
            (0..3).map(|k| function(TAU * f64::from(k) / 3.0) * around(x - f64::from(k))).sum::<f64>()
        };
        panel.place(sum(f64::cos), sum(f64::sin))
    };
    let round: Vec<_> = (0..96).map(|i| at(3.0 * f64::from(i) / 96.0)).collect();
    drawn += &path("curve", &round, true);
    for k in 0..3 {
        drawn += &disc("point", at(f64::from(k)), 3.5);
    }
    drawn += &text("title", 553.0, 22.0, "middle", "the circle");
    Ok(figure(
        640,
        224,
        "Cosine, sine and circle from three points: the weighted generators are dashed",
        &drawn,
    ))
}
