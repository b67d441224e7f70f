//! Pictures of more than two tones are no drawings of ink: their outlines stay where the brightness crosses the
//! threshold.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::numerics::Point;
use expline::trace::{Gray, TraceOptions, trace};

const SIDE: usize = 200;

/// Shades from 0 to 255, the mean of sixteen places in each pixel.
fn shaded(shade: &dyn Fn(f64, f64) -> f64) -> Vec<u8> {
    let at = |v: usize, k: usize| v as f64 + (k as f64 + 0.5) / 4.0;
    let mean = |x: usize, y: usize| (0..16).map(|k| shade(at(x, k % 4), at(y, k / 4))).sum::<f64>() / 16.0;
    (0..SIDE * SIDE).map(|i| mean(i % SIDE, i / SIDE).round() as u8).collect()
}

/// The largest distance along all curves of a trace.
fn farthest(bytes: &[u8], distance: &dyn Fn(Point) -> f64) -> f64 {
    let gray = Gray::from_bytes(SIDE, SIDE, bytes).expect("a valid picture");
    let trace = trace(gray, &TraceOptions::default()).expect("a drawing");
    assert!(!trace.contours.is_empty(), "nothing was found");
    let mut most = 0.0_f64;
    for contour in &trace.contours {
        for i in 0..4000 {
            let t = contour.curve.domain().1 * f64::from(i) / 4000.0;
            most = most.max(distance(contour.curve.evaluate(t, 0).expect("inside the domain")));
        }
    }
    most
}

/// Compression leaves this: the same numbers everywhere, −1 to 1.
fn noise(x: f64, y: f64) -> f64 {
    let cell = (x as u32).wrapping_mul(374_761_393) ^ (y as u32).wrapping_mul(668_265_263);
    f64::from(cell.wrapping_mul(1_274_126_177) >> 16) / 32_768.0 - 1.0
}

#[test]
fn the_outline_of_a_shaded_ball_has_no_hairs() {
    let middle = Point::new(98.3, 101.6);
    let paper =
        |x: f64, y: f64| if (20.0..180.0).contains(&x) && (20.0..180.0).contains(&y) { 60.0 } else { 255.0 };
    let ball = |x: f64, y: f64| {
        let r = (Point::new(x, y) - middle).norm();
        if r < 70.0 { 245.0 - 2.4 * r } else { paper(x, y) }
    };
    let bytes = shaded(&|x, y| ball(x, y) + 2.0 * noise(x, y));
    let square = |p: Point| {
        (p.x - 20.0).abs().min((p.x - 180.0).abs()).min((p.y - 20.0).abs()).min((p.y - 180.0).abs())
    };
    // The threshold is somewhere between the tones; the ball's outline is a circle of one radius.
    let gray = Gray::from_bytes(SIDE, SIDE, &bytes).expect("a valid picture");
    let tones = gray.tones();
    let level = 0.5 * (tones.ink + tones.paper) / 256.0;
    let radius = (245.0 - level) / 2.4;
    let off = farthest(&bytes, &|p| square(p).min(((p - middle).norm() - radius).abs()));
    // Noise of two shades moves the crossing by a pixel where a pixel is 2.4 shades.
    assert!(off < 1.8, "{off}");
}

#[test]
fn where_discs_of_four_tones_meet_no_thorn_grows() {
    let discs = [(50.0, 88.0, 91.0), (82.5, 112.0, 136.0), (115.0, 88.0, 98.0), (147.5, 112.0, 188.0)];
    let shade = |x: f64, y: f64| {
        let over = discs.iter().rev().find(|(cx, cy, _)| (x - cx).hypot(y - cy) < 35.0);
        over.map_or(255.0, |disc| disc.2)
    };
    let off = farthest(&shaded(&shade), &|p| {
        discs.iter().map(|(cx, cy, _)| ((p.x - cx).hypot(p.y - cy) - 35.0).abs()).fold(f64::MAX, f64::min)
    });
    // A threshold between tones that are no ink and no paper lies beside the edge by a third of a pixel; two thirds
    // more is what steps to the next tone take.
    assert!(off < 1.1, "{off}");
}
