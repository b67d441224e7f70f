//! The Roman surface, the hyperbolic paraboloid, and a row of shapes.

use expline::generator::Interpolator;
use expline::numerics::Vector3;
use expline::{Result, TensorSurface};

use super::plot::{Panel, figure, text};
use super::solid::{View, net_points, solid};

/// The interpolator of a direction, from −reach to reach.
fn generator(surface: &TensorSurface, direction: usize, panel: &Panel, class: &str) -> Result<String> {
    let generator = Interpolator::new(&surface.directions()[direction].roots)?;
    let reach = generator.support() as f64;
    Ok(panel.graph(class, [-reach, reach], &|x| generator.at(x, 0)))
}

/// 5 × 5 points, with the generators of both directions.
pub(crate) fn roman_surface() -> Result<String> {
    let surface = TensorSurface::roman_surface(3.0, [5, 5])?;
    let panel = Panel { page: [24.0, 40.0, 250.0, 220.0], range: [-4.2, 4.2, -0.4, 1.15] };
    let mut drawn = panel.axes(&[-4, -2, 2, 4], &[1.0]);
    drawn += &generator(&surface, 0, &panel, "curve blue")?;
    drawn += &generator(&surface, 1, &panel, "curve red dash")?;
    drawn += &text("note", 24.0, 24.0, "start", "in u: 0, ±2πi/5, ±4πi/5 (blue); in v: 0, ±4πi/5 (red)");
    // A quarter of the domain covers it once.
    let view = View {
        turn: 62.0,
        height: 30.0,
        target: Vector3::zeros(),
        center: (462.0, 150.0),
        scale: 27.5,
        part: [0.5, 0.5],
        lined: false,
    };
    drawn += &solid(&surface, &view, 14)?;
    drawn += &net_points(&surface, &view)?;
    Ok(figure(640, 300, "The Roman surface through 5 × 5 points, and its two generators", &drawn))
}

/// 9 × 9 points, of which 7 × 7 lie on the piece.
pub(crate) fn hyperbolic_paraboloid() -> Result<String> {
    let surface = TensorSurface::hyperbolic_paraboloid([4.0, 4.0, 8.0], [6, 6])?;
    let panel = Panel { page: [24.0, 40.0, 250.0, 220.0], range: [-2.3, 2.3, -0.25, 1.15] };
    let mut drawn = panel.axes(&[-2, -1, 1, 2], &[1.0]);
    drawn += &generator(&surface, 1, &panel, "curve red")?;
    drawn += &text("note", 24.0, 24.0, "start", "in v: 0, ±1/3");
    let view = View {
        turn: 118.0,
        height: 36.0,
        target: Vector3::new(0.0, 0.0, 4.0),
        center: (462.0, 160.0),
        scale: 20.0,
        part: [1.0, 1.0],
        lined: false,
    };
    drawn += &solid(&surface, &view, 4)?;
    drawn += &net_points(&surface, &view)?;
    Ok(figure(640, 300, "A hyperbolic paraboloid through 9 × 9 points, and one of its generators", &drawn))
}

/// A shape of a row: name, surface, middle, pixels of a unit, faces a unit of the net, turn, part of the domain.
type Shape = (&'static str, TensorSurface, Vector3, f64, usize, f64, f64);

fn row(label: &str, shapes: [Shape; 3]) -> Result<String> {
    let mut drawn = String::new();
    for (i, (name, surface, target, scale, faces, turn, part)) in shapes.into_iter().enumerate() {
        let left = 213.0 * i as f64;
        let center = (left + 107.0, 98.0);
        let view =
            View { turn, height: 28.0, target, center, scale, part: [part, part], lined: name == "cylinder" };
        drawn += &solid(&surface, &view, faces)?;
        drawn += &net_points(&surface, &view)?;
        drawn += &text("note", left + 107.0, 210.0, "middle", name);
    }
    Ok(figure(640, 220, label, &drawn))
}

/// Sphere, torus and cylinder.
pub(crate) fn quadrics() -> Result<String> {
    let middle = Vector3::zeros();
    row(
        "A sphere, a torus and a cylinder, with the points that they go through",
        [
            ("sphere", TensorSurface::sphere(1.0, [8, 4])?, middle, 78.0, 6, 35.0, 1.0),
            ("torus", TensorSurface::torus(1.0, 0.42, [8, 6])?, middle, 64.0, 5, 35.0, 1.0),
            ("cylinder", TensorSurface::cylinder(0.8, 1.7, [8, 2])?, middle, 74.0, 5, 35.0, 1.0),
        ],
    )
}

/// Roman surface, saddle and duckling.
pub(crate) fn shapes() -> Result<String> {
    let saddle = TensorSurface::hyperbolic_paraboloid([0.8, 0.8, 1.2], [6, 6])?;
    row(
        "The Roman surface, a hyperbolic paraboloid and a duckling, with the points that they go through",
        [
            (
                "Roman surface",
                TensorSurface::roman_surface(1.5, [5, 5])?,
                Vector3::zeros(),
                78.0,
                10,
                62.0,
                0.5,
            ),
            ("hyperbolic paraboloid", saddle, Vector3::new(0.0, 0.0, 0.6), 72.0, 3, 118.0, 1.0),
            ("duckling", TensorSurface::character()?, Vector3::new(0.0, 0.0, 0.98), 84.0, 4, 62.0, 1.0),
        ],
    )
}
