//! Small pictures, thin lines and soft edges: what is between two colours is neither a colour nor a shape.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::colors::{
    BLUE, RED, SHARP, SOFT, WHITE, YELLOW, apart, disc, draw, palette, scaled, traced,
};
use crate::support::curves::Random;
use expline::trace::{Color, TracedLayer};

const GREEN: Color = [40, 160, 70];
const SKY: Color = [60, 130, 240];
const NEAR_BLUE: Color = [26, 115, 232];
const FAR_BLUE: Color = [25, 103, 210];
const PALE: Color = [174, 203, 250];
const PAPER: Color = [236, 236, 232];
const DARK: Color = [70, 70, 70];

fn contours(layers: &[TracedLayer], color: Color) -> usize {
    layers.iter().filter(|layer| layer.color == color).map(|layer| layer.contours.len()).sum()
}

/// A ring in four colours with a bar, on white: the corners of the picture are at 0 and 1.
fn ring(x: f64, y: f64) -> Option<Color> {
    let (far, angle) = ((x - 0.5).hypot(y - 0.5), (y - 0.5).atan2(x - 0.5).to_degrees());
    Some(if (0.5..0.94).contains(&x) && (0.42..0.6).contains(&y) && far < 0.45 {
        SKY
    } else if !(0.25..0.45).contains(&far) || (-35.0..0.0).contains(&angle) {
        WHITE
    } else if (0.0..45.0).contains(&angle) {
        SKY
    } else if (45.0..150.0).contains(&angle) {
        GREEN
    } else if !(-155.0..150.0).contains(&angle) {
        YELLOW
    } else {
        RED
    })
}

#[test]
fn an_icon_of_few_pixels_has_all_of_its_colours() {
    for (side, way) in [24, 32, 48].into_iter().flat_map(|side| [(side, SOFT), (side, SHARP)]) {
        let bytes = scaled(side, &draw(side, side, &|x, y| ring(x / side as f64, y / side as f64)), way);
        let found = palette(side, &bytes, 8);
        assert_eq!(found.len(), 5, "{side} pixels: {found:?}");
        for color in [WHITE, SKY, GREEN, YELLOW, RED] {
            let off = found.iter().map(|&other| apart(color, other)).min();
            // At 24 pixels a stroke is 5 wide, its edges as much as its middle.
            assert!(off < Some(40), "{side} pixels: {color:?} among {found:?}");
        }
        let layers = traced(side, side, &bytes, &found);
        let count: usize = layers.iter().map(|layer| layer.contours.len()).sum();
        assert_eq!(count, 5, "{side} pixels: one outline for each");
    }
}

#[test]
fn a_disc_of_a_colour_that_the_palette_lacks_is_one_disc_of_the_nearest() {
    let paint = |x: f64, y: f64| {
        Some(if disc(x, y, 24.0, 24.0, 9.6) {
            NEAR_BLUE
        } else if disc(x, y, 24.0, 24.0, 12.2) {
            WHITE
        } else if x > 24.0 {
            PALE
        } else {
            FAR_BLUE
        })
    };
    let layers = traced(48, 48, &draw(48, 48, &paint), &[FAR_BLUE, PALE, WHITE]);
    let count: usize = layers.iter().map(|layer| layer.contours.len()).sum();
    assert_eq!(
        count, 5,
        "what is under all, the half on it, which goes on under the ring, and the ring, both around the disc"
    );
    let circles = layers
        .iter()
        .flat_map(|layer| &layer.contours)
        .filter_map(|contour| contour.curve.as_ellipse(1e-3))
        .filter(|circle| (circle.radii.x - circle.radii.y).abs() < 1e-6);
    assert_eq!(circles.count(), 3, "the ring outside, and what is around the disc");
}

#[test]
fn a_soft_edge_is_no_band_of_the_colour_between() {
    let [gray, between, white] = [180, 215, 250].map(|shade: u8| [shade; 3]);
    let paint = |x: f64, y: f64| {
        Some(if disc(x, y, 30.0, 31.0, 20.0) {
            gray
        } else if y > 66.0 {
            between
        } else {
            white
        })
    };
    let bytes = (0..3).fold(draw(80, 80, &paint), |bytes, _| scaled(80, &bytes, SOFT));
    let layers = traced(80, 80, &bytes, &[white, gray, between]);
    assert_eq!(contours(&layers, between), 1, "what lies below");
    assert_eq!(contours(&layers, gray), 1, "the disc");
}

/// Waves of dark and of yellow lines, a pixel and a half thick, beside a blue margin.
fn writing(x: f64, y: f64) -> Option<Color> {
    if x < 18.0 {
        return Some(BLUE);
    }
    let (row, rest) = ((y / 12.0).floor(), y.rem_euclid(12.0));
    let line = (rest - 6.0 - 2.5 * (0.4 * x + row).sin()).abs() < 0.95;
    let color = if row.rem_euclid(3.0) < 1.0 { YELLOW } else { DARK };
    Some(if line && x < 88.0 { color } else { PAPER })
}

#[test]
fn lines_that_are_flat_nowhere_have_their_colours() {
    for bytes in [draw(96, 96, &writing), scaled(96, &draw(96, 96, &writing), SOFT)] {
        let found = palette(96, &bytes, 8);
        assert_eq!(found.len(), 4, "{found:?}");
        for (color, most) in [(PAPER, 2), (BLUE, 2), (DARK, 90), (YELLOW, 90)] {
            let off = found.iter().map(|&other| apart(color, other)).min();
            // Pixels show a thin line and half as much of the paper.
            assert!(off < Some(most), "{color:?} among {found:?}");
        }
    }
}

#[test]
fn a_thin_gray_line_is_drawn_in_the_gray_of_the_palette_rather_than_in_its_blue() {
    let gray = [160, 160, 160];
    let blue = [54, 113, 160];
    let paint = |x: f64, y: f64| {
        let line = x > 30.0 && (y - 24.0 - 6.0 * (0.3 * x).sin()).abs() < 0.9;
        Some(if x < 18.0 {
            blue
        } else if line {
            DARK
        } else if y > 42.0 {
            gray
        } else {
            PAPER
        })
    };
    let layers = traced(60, 60, &draw(60, 60, &paint), &[PAPER, blue, gray]);
    assert_eq!(contours(&layers, blue), 1, "the margin");
    assert!(contours(&layers, gray) >= 2, "the line and what lies below");
}

#[test]
fn what_narrow_stripes_show_between_them_is_no_colour() {
    let flag = |x: f64, y: f64| {
        let (u, v) = ((x / 24.0 - 1.0).abs(), (y / 24.0 - 1.0).abs());
        let diagonal = (u - v).abs();
        Some(if u.min(v) < 0.1 || (u.min(v) >= 0.17 && diagonal < 0.07) {
            RED
        } else if u.min(v) < 0.17 || diagonal < 0.2 {
            WHITE
        } else {
            BLUE
        })
    };
    for bytes in [draw(48, 48, &flag), scaled(48, &draw(48, 48, &flag), SOFT)] {
        let found = palette(48, &bytes, 12);
        assert_eq!(found.len(), 3, "{found:?}");
        for (color, most) in [(RED, 40), (BLUE, 40), (WHITE, 90)] {
            let off = found.iter().map(|&other| apart(color, other)).min();
            assert!(off < Some(most), "{color:?} among {found:?}");
        }
    }
}

/// A disc of one of two blues on the other, which are 22 apart in one channel, with a white bar.
fn blues(x: f64, y: f64) -> Option<Color> {
    Some(if disc(x, y, 30.0, 30.0, 18.0) {
        NEAR_BLUE
    } else if y > 52.0 {
        WHITE
    } else {
        FAR_BLUE
    })
}

#[test]
fn two_shades_that_were_drawn_so_are_two_colours_where_more_are_asked_for() {
    let bytes = draw(64, 64, &blues);
    assert_eq!(palette(64, &bytes, 8), [FAR_BLUE, NEAR_BLUE, WHITE]);
    assert_eq!(palette(64, &bytes, 2), [FAR_BLUE, WHITE], "what is like others comes last");
    let layers = traced(64, 64, &bytes, &palette(64, &bytes, 8));
    assert_eq!(contours(&layers, NEAR_BLUE), 1, "the disc");
}

#[test]
fn shades_of_one_colour_that_noise_or_a_gradient_shows_are_one_colour() {
    let mut random = Random::new(7);
    let noisy: Vec<u8> = draw(64, 64, &blues)
        .into_iter()
        .map(|byte| if byte == 255 { byte } else { (f64::from(byte) + 9.0 * random.symmetric()) as u8 })
        .collect();
    assert_eq!(palette(64, &noisy, 8).len(), 2, "noise");
    let gradient = |x: f64, _: f64| {
        let part = x.floor() / 63.0;
        let blend = |near: u8, far: u8| (f64::from(far) + part * (f64::from(near) - f64::from(far))) as u8;
        Some(core::array::from_fn(|k| blend(NEAR_BLUE[k], FAR_BLUE[k])))
    };
    assert_eq!(palette(64, &draw(64, 64, &gradient), 8).len(), 1, "a gradient");
}
