//! Tables, panels and letters on them: ruled lines of a pixel, pale colours side by side, and what is thin beside them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::colors::{WHITE, draw, palette, traced};
use expline::curve::Curve;
use expline::trace::Color;

const BLACK: Color = [0, 0, 0];
const GRAY: Color = [204, 204, 204];
const PALE: Color = [238, 238, 238];
const SIDE: usize = 96;

/// Waves a pixel and a third thick: nowhere are they flat, and pixels show all shades between them and the ground.
fn is_written(x: f64, y: f64) -> bool {
    let wave = y.rem_euclid(12.0) - 6.0 - 2.5 * (0.4 * x + 0.7 * (y / 12.0).floor()).sin();
    (20.0..76.0).contains(&x) && (20.0..76.0).contains(&y) && wave.abs() < 0.66
}

/// A white panel with writing on a pale ground.
fn panel(x: f64, y: f64) -> Option<Color> {
    let is_inside = (12.0..84.0).contains(&x) && (12.0..84.0).contains(&y);
    Some(if is_written(x, y) {
        BLACK
    } else if is_inside {
        WHITE
    } else {
        PALE
    })
}

/// Writing with a frame of one pixel around it, and a line through it.
fn table(x: f64, y: f64) -> Option<Color> {
    let [column, row] = [x, y].map(f64::floor);
    let is_inside = (10.0..=86.0).contains(&column) && (10.0..=86.0).contains(&row);
    let is_ruled = is_inside && (column == 10.0 || column == 86.0 || [10.0, 48.0, 86.0].contains(&row));
    Some(if is_ruled {
        GRAY
    } else if is_written(x, y) && !(46.0..51.0).contains(&row) {
        BLACK
    } else {
        WHITE
    })
}

#[test]
fn a_panel_with_writing_on_a_ground_nearly_as_pale_keeps_its_colour() {
    let found = palette(SIDE, &draw(SIDE, SIDE, &panel), 6);
    for color in [WHITE, PALE] {
        assert!(found.contains(&color), "{color:?} among {found:?}");
    }
}

#[test]
fn ruled_lines_beside_writing_keep_their_colour() {
    let found = palette(SIDE, &draw(SIDE, SIDE, &table), 6);
    assert!(found.contains(&GRAY), "{found:?}");
}

#[test]
fn writing_has_no_fringes_of_the_colour_of_lines_beside_it() {
    let layers = traced(SIDE, SIDE, &draw(SIDE, SIDE, &table), &[WHITE, GRAY, BLACK]);
    let lines = layers.iter().filter(|layer| layer.color == GRAY).flat_map(|layer| &layer.contours);
    let area = lines.map(|contour| contour.curve.area().expect("closed")).sum::<f64>().abs();
    let truth = 77.0 * 77.0 - 75.0 * 75.0 + 75.0;
    // What lies on a fringe counts with it: 162 square pixels where a few pixels of thin ink are as pale as the lines
    // are and beside nothing darker; all that are as pale made 353.
    assert!((area - truth).abs() < 200.0, "{area} of {truth}");
}

#[test]
fn dots_are_kept_where_there_are_two_colours() {
    let letters = |x: f64, y: f64| {
        let k = ((x - 5.0) / 7.0).floor();
        let (u, v) = (x - 5.1 - 7.0 * k, y - 6.2);
        let is_across = (0.0..1.15).contains(&u) && (0.0..12.0).contains(&k);
        let is_there = is_across && ((3.6..12.6).contains(&v) || (0.0..1.15).contains(&v));
        Some(if is_there { BLACK } else { WHITE })
    };
    let layers = traced(SIDE, 24, &draw(SIDE, 24, &letters), &[WHITE, BLACK]);
    let marks: Vec<usize> =
        layers.iter().filter(|layer| layer.color == BLACK).map(|layer| layer.contours.len()).collect();
    assert_eq!(marks, [24], "twelve strokes with a dot each");
}
