//! Shaded surfaces, quadrilateral by quadrilateral, those farthest away first.

use core::fmt::Write as _;

use expline::numerics::Vector3;
use expline::surface::Grid;
use expline::{Result, TensorSurface};

use super::plot::disc;

/// Where a surface is seen from, and where it is on the page.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// Turn about the z axis and height of the eye, in degrees.
    pub(crate) turn: f64,
    pub(crate) height: f64,
    /// Middle of the surface, place of that middle on the page, and pixels of a unit.
    pub(crate) target: Vector3,
    pub(crate) center: (f64, f64),
    pub(crate) scale: f64,
    /// The part of the domain that is drawn, in u and in v.
    pub(crate) part: [f64; 2],
    /// Whether the inside of the surface has a colour of its own.
    pub(crate) lined: bool,
}

impl View {
    /// Right, up and towards the eye.
    fn axes(&self) -> [Vector3; 3] {
        let ((sin, cos), (rise, flat)) =
            (self.turn.to_radians().sin_cos(), self.height.to_radians().sin_cos());
        let towards = Vector3::new(flat * cos, flat * sin, rise);
        let right = Vector3::new(-sin, cos, 0.0);
        [right, towards.cross(&right), towards]
    }

    fn place(&self, point: &Vector3) -> (f64, f64) {
        let [right, up, _] = self.axes();
        let from = point - self.target;
        (self.center.0 + self.scale * from.dot(&right), self.center.1 - self.scale * from.dot(&up))
    }
}

/// Steps of a colour's lightness.
const SHADES: f64 = 40.0;

/// The colour of a face: cool, and warm inside.
fn shade(normal: &Vector3, view: &View) -> String {
    let [right, up, towards] = view.axes();
    let facing = normal.dot(&towards);
    let normal = if facing < 0.0 { -normal } else { *normal };
    let light = (towards * 0.55 - right * 0.45 + up * 0.7).normalize();
    let shine = normal.dot(&light).max(0.0);
    let (dark, bright) = if view.lined && facing < 0.0 {
        ([122.0, 78.0, 24.0], [250.0, 222.0, 172.0])
    } else {
        ([18.0, 52.0, 100.0], [222.0, 236.0, 255.0])
    };
    let amount = ((0.12 + 0.88 * shine) * SHADES).round() / SHADES;
    let mixed = |k: usize| (dark[k] + (bright[k] - dark[k]) * amount).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2))
}

/// A surface of `faces` faces a unit of the net, with a line for every row and column of it.
pub(crate) fn solid(surface: &TensorSurface, view: &View, faces: usize) -> Result<String> {
    let [end_u, end_v] = surface.domain();
    let (end_u, end_v) = (end_u * view.part[0], end_v * view.part[1]);
    let [rows, cols] = [end_u, end_v].map(|end| (faces as f64 * end) as usize + 1);
    let at = |i: usize, j: usize| {
        let (u, v) = (end_u * i as f64 / (rows - 1) as f64, end_v * j as f64 / (cols - 1) as f64);
        Ok((surface.evaluate(u, v, 0, 0)?, surface.normal(u, v)?.unwrap_or_else(Vector3::zeros)))
    };
    let grid = Grid { rows, cols };
    let points = (0..grid.rows * grid.cols).map(|n| at(n / cols, n % cols)).collect::<Result<Vec<_>>>()?;
    let [.., towards] = view.axes();
    let mut quads = Vec::new();
    for i in 0..rows - 1 {
        for j in 0..cols - 1 {
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| points[i * cols + j]);
            let middle = corners.iter().fold(Vector3::zeros(), |sum, c| sum + c.0) / 4.0;
            let normal = corners.iter().fold(Vector3::zeros(), |sum, c| sum + c.1);
            let length = normal.norm();
            let normal = if length > 1e-9 { normal / length } else { towards };
            quads.push((middle.dot(&towards), normal, corners.map(|c| c.0), i % faces == 0, j % faces == 0));
        }
    }
    quads.sort_by(|a, b| a.0.total_cmp(&b.0));
    let closed = surface.directions().iter().all(|direction| direction.closed) || is_round(surface);
    let mut drawn = "<g transform=\"scale(.1)\" fill=\"currentColor\" stroke=\"currentColor\" stroke-width=\"5\" stroke-linejoin=\"round\">\n".to_owned();
    for (_, normal, corners, on_row, on_col) in &quads {
        if closed && normal.dot(&towards) < -0.15 {
            continue;
        }
        let places = corners.map(|corner| view.place(&corner));
        let _ = write!(drawn, "<path color=\"{}\" d=\"{}Z\"/>", shade(normal, view), steps(&places));
        let [a, b, _, d] = places;
        for (on, line) in [(*on_row, [a, d]), (*on_col, [a, b])] {
            if on {
                let _ = write!(drawn, "<path class=\"net\" d=\"{}\"/>", steps(&line));
            }
        }
    }
    Ok(drawn + "\n</g>\n")
}

/// Whether an open direction ends in poles, so that no inside can be seen.
fn is_round(surface: &TensorSurface) -> bool {
    let [_, end] = surface.domain();
    let at = |u: f64, v: f64| surface.evaluate(u, v, 0, 0).unwrap_or_else(|_| Vector3::zeros());
    [0.0, end].iter().all(|&v| (at(0.0, v) - at(1.0, v)).norm() < 1e-9)
}

/// A path in tenths of a pixel, relative after the first place.
fn steps(places: &[(f64, f64)]) -> String {
    let mut d = String::new();
    let mut before = (0.0_f64, 0.0_f64);
    for (i, (x, y)) in places.iter().enumerate() {
        let here = ((x * 10.0).round(), (y * 10.0).round());
        let (dx, dy) = (here.0 - before.0, here.1 - before.1);
        let comma = if dy < 0.0 { "" } else { " " };
        let _ = write!(d, "{}{dx}{comma}{dy}", if i == 0 { "M" } else { "l" });
        before = here;
    }
    d
}

/// The net's points that are on the surface: filled where they can be seen, else hollow.
pub(crate) fn net_points(surface: &TensorSurface, view: &View) -> Result<String> {
    let [rows, cols] = surface.directions().map(|direction| direction.count);
    let [end_u, end_v] = surface.domain();
    let [.., towards] = view.axes();
    let mut drawn = String::new();
    for i in 0..rows {
        for j in 0..cols {
            let [u, v] = surface.parameters(i, j);
            if !(0.0..=end_u).contains(&u) || !(0.0..=end_v).contains(&v) {
                continue;
            }
            let point = surface.evaluate(u, v, 0, 0)?;
            let seen = surface.normal(u, v)?.is_none_or(|normal| normal.dot(&towards) > -0.05);
            drawn += &disc(if seen { "control" } else { "hidden" }, view.place(&point), 2.6);
        }
    }
    Ok(drawn)
}
