//! Pictures as programs blend them: shapes side by side that let through what is below both of them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::colors::{BLUE, Paint, RED, WHITE, YELLOW, disc, draw, palette, traced};
use expline::trace::{Color, TracedLayer};

const GREEN: Color = [20, 140, 60];
const SIDE: usize = 96;

type Shape<'a> = &'a dyn Fn(f64, f64) -> bool;

/// How much of each pixel a shape covers, in 255.
fn coverage(shape: Shape) -> Vec<u8> {
    let paint: Paint = &|x, y| shape(x, y).then_some(WHITE);
    draw(SIDE, SIDE, paint).chunks_exact(4).map(|pixel| pixel[3]).collect()
}

/// Shapes that were blended one after the other, each by what it covers, over a ground of one colour or over nothing.
fn blended(ground: Option<Color>, shapes: &[(Color, Shape)]) -> Vec<u8> {
    let [r, g, b] = ground.unwrap_or_default();
    let opacity = if ground.is_some() { 255 } else { 0 };
    // Premultiplied, and rounded after every shape, as pixels are.
    let mut pixels = vec![[r, g, b, opacity]; SIDE * SIDE];
    for &(color, shape) in shapes {
        for (pixel, share) in pixels.iter_mut().zip(coverage(shape)) {
            let share = f64::from(share) / 255.0;
            for (k, channel) in pixel.iter_mut().enumerate() {
                let over = color.get(k).map_or(255.0, |&own| f64::from(own));
                *channel = (over * share + f64::from(*channel) * (1.0 - share)).round() as u8;
            }
        }
    }
    let straight = |channel: u8, opacity: u8| {
        (255.0 * f64::from(channel) / f64::from(opacity.max(1))).round().min(255.0) as u8
    };
    pixels
        .into_iter()
        .flat_map(|[r, g, b, opacity]| {
            [straight(r, opacity), straight(g, opacity), straight(b, opacity), opacity]
        })
        .collect()
}

fn points(layers: &[TracedLayer]) -> usize {
    layers.iter().flat_map(|layer| &layer.contours).map(|contour| contour.curve.points().len()).sum()
}

/// The farthest that the outlines are from a straight edge, of all that is within a pixel of it and inside the disc.
fn farthest(layers: &[TracedLayer], off: &dyn Fn(f64, f64) -> f64) -> f64 {
    let mut most = 0.0_f64;
    for contour in layers.iter().flat_map(|layer| &layer.contours) {
        let (end, count) = (contour.curve.domain().1, 100 * contour.curve.points().len());
        for i in 0..count {
            let p = contour.curve.evaluate(end * i as f64 / count as f64, 0).expect("in the domain");
            let away = off(p.x, p.y).abs();
            // Beside the rim a pixel has something of three colours.
            if away < 1.0 && disc(p.x, p.y, 48.0, 48.0, 36.0) {
                most = most.max(away);
            }
        }
    }
    most
}

fn is_left(x: f64, y: f64) -> bool {
    x + 0.3 * y < 60.3
}

#[test]
fn the_edge_between_shapes_that_let_the_ground_through_is_straight_where_they_meet() {
    let rim = |x: f64, y: f64| disc(x, y, 48.0, 48.0, 40.0);
    let left = |x: f64, y: f64| rim(x, y) && is_left(x, y);
    let right = |x: f64, y: f64| rim(x, y) && !is_left(x, y);
    let edge = |x: f64, y: f64| (x + 0.3 * y - 60.3) / 1.0_f64.hypot(0.3);
    // What shows through is seen around the disc, be it a colour or nothing.
    for (ground, count) in [(Some(WHITE), 3), (Some([30, 30, 30]), 3), (None, 2)] {
        let bytes = blended(ground, &[(RED, &left), (BLUE, &right)]);
        let found = palette(SIDE, &bytes, 8);
        assert_eq!(found.len(), count, "{ground:?}: {found:?}");
        let layers = traced(SIDE, SIDE, &bytes, &found);
        // Coverage is drawn to an eighth of a pixel both ways, and rounded to a byte by each of the two.
        let most = farthest(&layers, &edge);
        assert!(most < 0.03, "{ground:?}: {most} pixels off");
        assert!(points(&layers) <= 14, "{ground:?}: {} points", points(&layers));
    }
}

#[test]
fn four_quarters_side_by_side_are_no_waves() {
    let rim = |x: f64, y: f64| disc(x, y, 48.0, 48.0, 40.0);
    let is_high = |x: f64, y: f64| y - 0.3 * x < 30.0;
    let quarter = |left: bool, high: bool| {
        move |x: f64, y: f64| rim(x, y) && is_left(x, y) == left && is_high(x, y) == high
    };
    let quarters = [quarter(true, true), quarter(false, true), quarter(true, false), quarter(false, false)];
    let bytes = blended(
        Some(WHITE),
        &[(RED, &quarters[0]), (BLUE, &quarters[1]), (YELLOW, &quarters[2]), (GREEN, &quarters[3])],
    );
    let layers = traced(SIDE, SIDE, &bytes, &palette(SIDE, &bytes, 8));
    assert_eq!(layers.len(), 5, "the ground and the quarters");
    assert!(points(&layers) <= 36, "{} points, where a mixture of two had 118", points(&layers));
}
