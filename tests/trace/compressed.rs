//! Compressed pictures, as JPEG of a usual quality leaves them: outlines are as smooth and as sharp as what was drawn.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::PI;

use crate::support::pictures::{Ink, draw, traced};
use expline::numerics::Point;
use expline::trace::Trace;

/// Pixels along the side of a block.
const BLOCK: usize = 8;
/// The quantisation of luminance that the standard suggests (T.81, table K.1).
const SUGGESTED: [[f64; BLOCK]; BLOCK] = [
    [16.0, 11.0, 10.0, 16.0, 24.0, 40.0, 51.0, 61.0],
    [12.0, 12.0, 14.0, 19.0, 26.0, 58.0, 60.0, 55.0],
    [14.0, 13.0, 16.0, 24.0, 40.0, 57.0, 69.0, 56.0],
    [14.0, 17.0, 22.0, 29.0, 51.0, 87.0, 80.0, 62.0],
    [18.0, 22.0, 37.0, 56.0, 68.0, 109.0, 103.0, 77.0],
    [24.0, 35.0, 55.0, 64.0, 81.0, 104.0, 113.0, 92.0],
    [49.0, 64.0, 78.0, 87.0, 103.0, 121.0, 120.0, 101.0],
    [72.0, 92.0, 95.0, 98.0, 112.0, 100.0, 103.0, 99.0],
];
/// The table's share at quality 40.
const SHARE: f64 = 1.25;

/// The cosine of a frequency at a pixel, such that all together are orthonormal.
fn cosine(frequency: usize, at: usize) -> f64 {
    let scale = if frequency == 0 { 0.125_f64.sqrt() } else { 0.5 };
    scale * ((2 * at + 1) as f64 * frequency as f64 * PI / 16.0).cos()
}

/// All of them.
fn cosines() -> [[f64; BLOCK]; BLOCK] {
    core::array::from_fn(|frequency| core::array::from_fn(|at| cosine(frequency, at)))
}

/// What compression leaves of a square picture whose side is a multiple of 8.
fn compressed(side: usize, bytes: &[u8]) -> Vec<u8> {
    let (waves, mut out) = (cosines(), vec![0; bytes.len()]);
    let all = || (0..BLOCK * BLOCK).map(|k| (k / BLOCK, k % BLOCK));
    for corner in (0..side * side).step_by(BLOCK).filter(|at| (at / side).is_multiple_of(BLOCK)) {
        let place = |(y, x): (usize, usize)| corner + y * side + x;
        let mut kept = [[0.0; BLOCK]; BLOCK];
        for (v, u) in all() {
            let wave = |(y, x)| waves[v][y] * waves[u][x];
            let sum: f64 = all().map(|at| wave(at) * (f64::from(bytes[place(at)]) - 128.0)).sum();
            let step = (SHARE * SUGGESTED[v][u]).round();
            kept[v][u] = step * (sum / step).round();
        }
        for (y, x) in all() {
            let value: f64 = all().map(|(v, u)| kept[v][u] * waves[v][y] * waves[u][x]).sum();
            out[place((y, x))] = (value + 128.0).round().clamp(0.0, 255.0) as u8;
        }
    }
    out
}

fn traced_compressed(side: usize, ink: Ink) -> Trace {
    traced(side, side, &compressed(side, &draw(side, side, ink)))
}

/// How far corners are from those that were drawn, at most, and how many are near none of them.
fn corners(drawing: &Trace, drawn: &[(f64, f64)]) -> (f64, usize) {
    let found: Vec<Point> = drawing.contours.iter().flat_map(|contour| contour.cusps.clone()).collect();
    let off = |&(x, y): &(f64, f64)| {
        found.iter().map(|cusp| (cusp - Point::new(x, y)).norm()).fold(f64::MAX, f64::min)
    };
    (drawn.iter().map(off).fold(0.0, f64::max), found.len().saturating_sub(drawn.len()))
}

#[test]
fn rounded_corners_beside_squares_on_the_grid_stay_round() {
    // Compression hardly changes sides along rows and columns, and bends between them much.
    let frame = |x: f64, y: f64| {
        let (x, y) = ((x - 128.0).abs() - 85.6, (y - 128.0).abs() - 85.6);
        x.max(0.0).hypot(y.max(0.0)) <= 27.0
    };
    let panes: Vec<[(f64, f64); 4]> = [(40.82, 40.82), (133.27, 40.82), (40.82, 133.27), (133.27, 133.27)]
        .map(|(x, y)| [(x, y), (x + 81.92, y), (x + 81.92, y + 81.92), (x, y + 81.92)])
        .to_vec();
    let within = |x: f64, from: f64| x >= from && x < from + 81.92;
    let pane = |x: f64| within(x, 40.82) || within(x, 133.27);
    let ink = |x: f64, y: f64| frame(x, y) && !(pane(x) && pane(y));
    let drawing = traced_compressed(256, &ink);
    let (off, more) = corners(&drawing, &panes.concat());
    assert!(off < 0.2, "a corner of a pane is {off} px away");
    assert_eq!(more, 0, "corners that nobody drew");
    let pieces: usize = drawing.contours.iter().map(|contour| contour.curve.segment_count()).sum();
    assert!(pieces <= 26, "24 lines and arcs became {pieces}");
}

#[test]
fn superellipses_are_where_they_were_drawn_in_a_few_pieces() {
    for power in [2.2, 3.0, 4.0, 5.0, 6.0] {
        let radius = |angle: f64| {
            let (sine, cosine) = angle.sin_cos();
            88.0 / (cosine.abs().powf(power) + sine.abs().powf(power)).powf(1.0 / power)
        };
        let far = |x: f64, y: f64| (x - 127.4).hypot(y - 128.3);
        let angle = |x: f64, y: f64| (y - 128.3).atan2(x - 127.4);
        let drawing = traced_compressed(256, &|x, y| {
            far(x, y) < 86.0 || far(x, y) < 114.0 && far(x, y) <= radius(angle(x, y))
        });
        assert_eq!(
            (drawing.contours.len(), corners(&drawing, &[]).1),
            (1, 0),
            "power {power}: all is smooth"
        );
        let curve = &drawing.contours[0].curve;
        let pieces = curve.segment_count();
        assert!(pieces <= 16, "power {power}: {pieces} pieces");
        // The distance along the ray, by how oblique the ray is.
        let off = |k: usize| {
            let at = curve.evaluate(k as f64 * pieces as f64 / 2000.0, 0).expect("on the curve");
            let (far, angle) = (far(at.x, at.y), angle(at.x, at.y));
            let slope = (radius(angle + 1e-5) - radius(angle - 1e-5)) / (2e-5 * far);
            (far - radius(angle)).abs() / slope.hypot(1.0)
        };
        let mean = (0..2000).map(off).sum::<f64>() / 2000.0;
        assert!(mean < 0.025, "power {power}: {mean} px away");
    }
}
