//! Interpolators of three families.

use expline::Result;
use expline::generator::{Interpolator, Root, Roots};

use super::plot::{Panel, figure, path, text};

/// (0, 0, 0), (0, 0, ±2πi/3) and (0, ±2π/3).
pub(crate) fn generators() -> Result<String> {
    let step = core::f64::consts::TAU / 3.0;
    let pair = |re: f64, im: f64| [Root { re, im }, Root { re: -re, im: -im }];
    let zero = Root::default();
    let [a, b] = pair(0.0, step);
    let families = [
        ("curve", "polynomial: 0, 0, 0", Interpolator::new(&Roots::polynomials(2)?)?),
        (
            "curve red dash",
            "trigonometric: 0, 0, ±2πi/3",
            Interpolator::new(&Roots::new(&[zero, zero, a, b], "roots")?)?,
        ),
        ("curve blue dot", "hyperbolic: 0, ±2π/3", Interpolator::new(&Roots::hyperbola(step)?)?),
    ];
    let panel = Panel { page: [30.0, 20.0, 580.0, 300.0], range: [-3.2, 3.2, -0.35, 1.15] };
    let mut drawn = panel.axes(&[-3, -2, -1, 1, 2, 3], &[0.5, 1.0]);
    for (i, (class, name, generator)) in families.iter().enumerate() {
        let reach = generator.support() as f64;
        drawn += &panel.graph(class, [-reach, reach], &|x| generator.at(x, 0));
        let y = 44.0 + 20.0 * i as f64;
        drawn += &path(class, &[(420.0, y), (452.0, y)], false);
        drawn += &text("note", 460.0, y + 4.0, "start", name);
    }
    Ok(figure(640, 340, "Interpolators of three families: 1 at 0, 0 at every other whole number", &drawn))
}
