//! Translucent colours come back in the shade that they have on white paper, and whole.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::colors::{BLUE, RED, disc, draw, traced};
use expline::trace::{Census, Color, Tint};

const SIDE: usize = 64;

fn tints(bytes: &[u8]) -> Vec<Tint> {
    let mut census = Census::new(SIDE).expect("a few colours");
    census.push_rgba_rows(bytes);
    census.palette(8).expect("8 colours")
}

/// A picture of which only a part of 255 is there.
fn faded(mut bytes: Vec<u8>, part: u8) -> Vec<u8> {
    for pixel in bytes.chunks_exact_mut(4) {
        pixel[3] = (f64::from(pixel[3]) * f64::from(part) / 255.0).round() as u8;
    }
    bytes
}

fn is_there(x: f64, y: f64) -> bool {
    disc(x, y, 31.2, 28.9, 17.5)
}

#[test]
fn a_translucent_disc_is_the_same_circle_as_an_opaque_one_in_the_colour_that_it_has_on_white() {
    for part in [255, 222, 138, 97, 31] {
        let bytes = faded(draw(SIDE, SIDE, &|x, y| is_there(x, y).then_some(RED)), part);
        let found = tints(&bytes);
        assert_eq!(found, [Tint { color: RED, opacity: part }], "{part}");
        let layers = traced(SIDE, SIDE, &bytes, &found);
        let on_white =
            RED.map(|channel| (255.0 - (255.0 - f64::from(channel)) * f64::from(part) / 255.0).round() as u8);
        assert_eq!(layers.iter().map(|layer| layer.color).collect::<Vec<_>>(), [on_white]);
        assert_eq!(layers[0].contours.len(), 1);
        let circle = layers[0].contours[0].curve.as_ellipse(1e-3).expect("a circle");
        // The picture was asked at places an eighth of a pixel apart; opacity has as many steps as there is of it.
        let most = 0.0625 + 0.5 / f64::from(part);
        assert!((circle.radii.x - 17.5).abs() < most && (circle.radii.y - 17.5).abs() < most, "{part}");
    }
}

#[test]
fn what_is_translucent_beside_something_opaque_is_a_colour_of_its_own() {
    // A ring around a disc of a third of its blue, with nothing between.
    let ring = |x: f64, y: f64| disc(x, y, 32.0, 32.0, 28.0) && !disc(x, y, 32.0, 32.0, 20.0);
    let core = |x: f64, y: f64| disc(x, y, 32.0, 32.0, 12.0);
    let mut bytes = draw(SIDE, SIDE, &|x, y| ring(x, y).then_some(BLUE));
    let faint = faded(draw(SIDE, SIDE, &|x, y| core(x, y).then_some(BLUE)), 85);
    for (pixel, other) in bytes.chunks_exact_mut(4).zip(faint.chunks_exact(4)) {
        if other[3] > 0 {
            pixel.copy_from_slice(other);
        }
    }
    let found = tints(&bytes);
    assert_eq!(found.len(), 2, "{found:?}");
    let layers = traced(SIDE, SIDE, &bytes, &found);
    let shown: Vec<(Color, usize)> = layers.iter().map(|layer| (layer.color, layer.contours.len())).collect();
    assert_eq!(shown, [(BLUE, 2), ([170, 186, 215], 1)], "a ring, and a paler disc");
}

#[test]
fn a_soft_shadow_adds_no_colour() {
    let shadow = |x: usize, y: usize| {
        let far = (x as f64 - 36.0).hypot(y as f64 - 36.0);
        (90.0 * (1.0 - (far / 28.0).powi(2)).max(0.0)).round() as u8
    };
    let mut bytes = draw(SIDE, SIDE, &|x, y| is_there(x, y).then_some(RED));
    for (i, pixel) in bytes.chunks_exact_mut(4).enumerate() {
        if pixel[3] == 0 {
            pixel.copy_from_slice(&[0, 0, 0, shadow(i % SIDE, i / SIDE)]);
        }
    }
    assert_eq!(tints(&bytes), [Tint::from(RED)]);
}

#[test]
fn lines_so_thin_that_no_pixel_is_covered_have_their_colour_on_nothing() {
    let line = |x: f64, y: f64| (y - 0.3 * x - 20.0).abs() < 0.4 && x > 5.0 && x < 59.0;
    let found = tints(&draw(SIDE, SIDE, &|x, y| line(x, y).then_some(RED)));
    assert_eq!(found.len(), 1, "{found:?}");
    // As near as the bins of colours are narrow.
    let off = found[0].color.iter().zip(RED).map(|(a, b)| a.abs_diff(b)).max();
    assert!(off <= Some(4) && found[0].opacity == 255, "{found:?}");
}
