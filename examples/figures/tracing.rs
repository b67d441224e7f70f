//! A picture of few pixels, and the curves that are found in it.

use super::plot::{disc, figure, text};
use expline::Result;
use expline::svg::{PrintOptions, to_path_d};
use expline::trace::{Gray, TraceOptions, trace};

const WIDTH: usize = 64;
const HEIGHT: usize = 36;
/// Side of a pixel on the page.
const SIDE: usize = 10;
/// Places in a pixel, along each side, where ink is looked for.
const PLACES: usize = 16;

/// A flash of six corners.
const FLASH: [(f64, f64); 6] =
    [(52.0, 3.5), (38.0, 20.5), (46.0, 20.5), (42.5, 33.0), (57.5, 15.0), (48.5, 15.0)];

/// Whether there is ink: a ring on the left, a flash on the right.
fn ink(x: f64, y: f64) -> bool {
    let distance = (x - 18.2).hypot(y - 18.1);
    let mut inside = false;
    for (i, &(x0, y0)) in FLASH.iter().enumerate() {
        let (x1, y1) = FLASH[(i + 1) % FLASH.len()];
        if (y0 > y) != (y1 > y) && x < x0 + (y - y0) * (x1 - x0) / (y1 - y0) {
            inside = !inside;
        }
    }
    inside || (8.0..14.0).contains(&distance)
}

/// The shade of every pixel: 255 less its share of ink.
fn picture() -> Vec<u8> {
    let share = |column: usize, row: usize| {
        let at = |cell: usize, place: usize| cell as f64 + (place as f64 + 0.5) / PLACES as f64;
        let hits = (0..PLACES * PLACES).filter(|k| ink(at(column, k % PLACES), at(row, k / PLACES))).count();
        255 - (255 * hits + PLACES * PLACES / 2) / (PLACES * PLACES)
    };
    (0..WIDTH * HEIGHT).map(|i| u8::try_from(share(i % WIDTH, i / WIDTH)).unwrap_or(u8::MAX)).collect()
}

/// Pixels of ink, paler than they are, under the outlines that are traced from them.
pub(crate) fn tracing() -> Result<String> {
    let pixels = picture();
    let traced = trace(Gray::from_bytes(WIDTH, HEIGHT, &pixels)?, &TraceOptions::default())?;
    let mut drawn = String::from("<g class=\"pixels\">\n");
    for (i, &shade) in pixels.iter().enumerate().filter(|(_, shade)| **shade < 255) {
        let pale = 255 - (255 - u32::from(shade)) * 2 / 5;
        let (x, y) = (i % WIDTH * SIDE, i / WIDTH * SIDE);
        drawn += &format!(
            "<path fill=\"#{pale:02x}{pale:02x}{pale:02x}\" d=\"M{x} {y}h{SIDE}v{SIDE}h-{SIDE}z\"/>\n"
        );
    }
    drawn += "</g>\n";
    let scale = SIDE as f64;
    let options = PrintOptions { decimals: Some(1), ..PrintOptions::default() };
    let mut points = 0;
    for contour in &traced.contours {
        let large = contour.curve.transformed([scale, 0.0, 0.0, scale, 0.0, 0.0])?;
        drawn += &format!("<path class=\"curve blue\" d=\"{}\"/>\n", to_path_d(&large, &options)?.d);
        for point in large.points() {
            let corner = contour.cusps.iter().any(|cusp| (cusp * scale - point).norm() < 0.1 * scale);
            drawn += &disc(if corner { "point" } else { "control" }, (point.x, point.y), 4.5);
            points += 1;
        }
    }
    let said = format!("{} curves, {points} points: two circles and six corners", traced.contours.len());
    drawn += &text("note", 10.0, (HEIGHT * SIDE) as f64 + 16.0, "start", &said);
    let (width, height) = ((WIDTH * SIDE) as u32, (HEIGHT * SIDE) as u32 + 26);
    Ok(figure(width, height, "A ring and a flash of a few pixels, and the curves traced from them", &drawn))
}
