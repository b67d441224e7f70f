//! Thin strokes in noise: the blur that evens it takes more than half of their ink, but not them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::pictures::{Noise, draw, traced};
use expline::curve::Curve;

const SIDE: usize = 96;

/// A picture with noise of a deviation, on gray paper.
fn scanned(bytes: &[u8], deviation: f64) -> Vec<u8> {
    let mut noise = Noise(11);
    bytes.iter().map(|&byte| (24.0 + 0.85 * f64::from(byte) + deviation * noise.normal()) as u8).collect()
}

/// How many contours there are, and how much ink is within them.
fn ink(bytes: &[u8]) -> (usize, f64) {
    let trace = traced(SIDE, SIDE, bytes);
    (
        trace.contours.len(),
        trace.contours.iter().map(|contour| contour.curve.area().expect("closed")).sum::<f64>().abs(),
    )
}

#[test]
fn a_frame_of_thin_lines_is_whole_in_noise() {
    for width in [1.2, 1.5, 1.8] {
        let is_ink = |x: f64, y: f64| {
            let far = (x - 48.3).abs().max((y - 47.6).abs());
            (30.0..30.0 + width).contains(&far)
        };
        let truth = 4.0 * width * (60.0 + width);
        for deviation in [5.0, 10.0] {
            let (count, area) = ink(&scanned(&draw(SIDE, SIDE, &is_ink), deviation));
            assert_eq!(count, 2, "{width} px, noise {deviation}: outside and inside");
            // What is ink is known by the darkest pixels only, which are dark by their noise.
            assert!((area / truth - 1.0).abs() < 0.3, "{width} px, noise {deviation}: {area} of {truth}");
        }
    }
}

#[test]
fn a_thin_ring_is_whole_in_noise() {
    let is_ink = |x: f64, y: f64| {
        let far = (x - 47.2).hypot(y - 48.9);
        (30.0..31.4).contains(&far)
    };
    assert_eq!(ink(&scanned(&draw(SIDE, SIDE, &is_ink), 8.0)).0, 2);
}
