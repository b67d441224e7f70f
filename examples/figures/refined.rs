//! A circle through three points, and its control points on finer and finer grids.

use expline::{InterpolatingCurve, Result};

use super::plot::{Panel, disc, figure, path, text};

/// Three points, and three levels of refinement.
pub(crate) fn refined_circle() -> Result<String> {
    let points: Vec<f64> = (0..3)
        .flat_map(|k| {
            let angle = core::f64::consts::TAU * (f64::from(k) / 3.0 + 0.25);
            [angle.cos(), angle.sin()]
        })
        .collect();
    let curve = InterpolatingCurve::new(points.clone(), 2, true, None)?;
    let mut drawn = String::new();
    for level in 0..4 {
        let left = 160.0 * f64::from(level);
        let panel = Panel { page: [left + 10.0, 24.0, 140.0, 140.0], range: [-1.45, 1.45, -1.45, 1.45] };
        let control = match level {
            0 => points.clone(),
            levels => curve.refine(levels as usize, 2, 2)?.points().to_vec(),
        };
        let places: Vec<_> = control.chunks_exact(2).map(|p| panel.place(p[0], p[1])).collect();
        let round: Vec<_> = (0..96)
            .map(|i| {
                let p = curve.evaluate(3.0 * f64::from(i) / 96.0, 0)?;
                Ok(panel.place(p[0], p[1]))
            })
            .collect::<Result<_>>()?;
        drawn += &path("polygon", &places, true);
        drawn += &path("curve", &round, true);
        for &place in &places {
            drawn += &disc(if level == 0 { "point" } else { "control" }, place, 3.0);
        }
        let words = match level {
            0 => "3 points on the circle".to_owned(),
            _ => format!("{} control points", places.len()),
        };
        drawn += &text("note", left + 80.0, 184.0, "middle", &words);
    }
    Ok(figure(
        640,
        200,
        "A circle through three points; 6, 12 and 24 control points of the same circle",
        &drawn,
    ))
}
