//! Compressed pictures in colours, as JPEG leaves them: what its waves make beside edges is no colour.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use core::f64::consts::PI;

use crate::support::colors::{Paint, WHITE, apart, disc, draw, palette};
use expline::trace::Color;

const SIDE: usize = 128;
/// So near is a colour that was found to the one that was drawn: waves move the mean of what is thin.
const NEAR: u8 = 10;
/// The quantisation that the standard suggests (T.81, tables K.1 and K.2), which is that of quality 50; of differences
/// of hue only what is not 99.
const OF_LIGHT: [f64; 64] = [
    16.0, 11.0, 10.0, 16.0, 24.0, 40.0, 51.0, 61.0, 12.0, 12.0, 14.0, 19.0, 26.0, 58.0, 60.0, 55.0, 14.0,
    13.0, 16.0, 24.0, 40.0, 57.0, 69.0, 56.0, 14.0, 17.0, 22.0, 29.0, 51.0, 87.0, 80.0, 62.0, 18.0, 22.0,
    37.0, 56.0, 68.0, 109.0, 103.0, 77.0, 24.0, 35.0, 55.0, 64.0, 81.0, 104.0, 113.0, 92.0, 49.0, 64.0, 78.0,
    87.0, 103.0, 121.0, 120.0, 101.0, 72.0, 92.0, 95.0, 98.0, 112.0, 100.0, 103.0, 99.0,
];
const OF_HUE: [[f64; 4]; 4] =
    [[17.0, 18.0, 24.0, 47.0], [18.0, 21.0, 26.0, 66.0], [24.0, 26.0, 56.0, 99.0], [47.0, 66.0, 99.0, 99.0]];

/// A square of eight by eight, or its waves.
type Square = [[f64; 8]; 8];

/// Sums along one axis, which becomes the other one: the cosines of all waves are a rotation, here and back.
fn turned(square: &Square, back: bool) -> Square {
    let wave = |k: usize, at: usize| {
        let scale = if k == 0 { 0.125_f64.sqrt() } else { 0.5 };
        scale * ((2 * at + 1) as f64 * k as f64 * PI / 16.0).cos()
    };
    let weight = |i: usize, j: usize| if back { wave(j, i) } else { wave(i, j) };
    core::array::from_fn(|i| {
        core::array::from_fn(|row| (0..8).map(|j| weight(i, j) * square[row][j]).sum::<f64>())
    })
}

/// What is left of a plane in steps of `step(row, column)` of each wave.
fn coarsened(side: usize, plane: &mut [f64], step: &dyn Fn(usize, usize) -> f64) {
    for (top, left) in (0..side * side / 64).map(|k| (8 * (k / (side / 8)) * side, 8 * (k % (side / 8)))) {
        let square: Square =
            core::array::from_fn(|y| core::array::from_fn(|x| plane[top + y * side + left + x]));
        let mut waves = turned(&turned(&square, false), false);
        for (y, row) in waves.iter_mut().enumerate() {
            for (x, wave) in row.iter_mut().enumerate() {
                *wave = (*wave / step(y, x)).round() * step(y, x);
            }
        }
        for (y, row) in turned(&turned(&waves, true), true).iter().enumerate() {
            plane[top + y * side + left..][..8].copy_from_slice(row);
        }
    }
}

/// What compression leaves of an opaque picture, with `share` of the suggested steps, where four pixels share a hue.
fn compressed(bytes: &[u8], share: f64) -> Vec<u8> {
    let half = SIDE / 2;
    let of = |weights: [f64; 3], at: usize| -> f64 {
        (0..3).map(|k| weights[k] * f64::from(bytes[4 * at + k])).sum::<f64>()
    };
    let mut light: Vec<f64> = (0..SIDE * SIDE).map(|at| of([0.299, 0.587, 0.114], at) - 128.0).collect();
    coarsened(SIDE, &mut light, &|y, x| share * OF_LIGHT[8 * y + x]);
    let [blue, red] = [[-0.168_736, -0.331_264, 0.5], [0.5, -0.418_688, -0.081_312]].map(|weights| {
        let four = |at: usize| {
            let first = 2 * (at / half) * SIDE + 2 * (at % half);
            [first, first + 1, first + SIDE, first + SIDE + 1].iter().map(|&at| of(weights, at)).sum::<f64>()
        };
        let mut plane: Vec<f64> = (0..half * half).map(|at| four(at) / 4.0).collect();
        let suggested = |y: usize, x: usize| OF_HUE.get(y).and_then(|row| row.get(x)).copied();
        coarsened(half, &mut plane, &|y, x| share * suggested(y, x).unwrap_or(99.0));
        plane
    });
    let pixel = |at: usize| {
        let (y, hue) = (light[at] + 128.0, at / SIDE / 2 * half + at % SIDE / 2);
        let (b, r) = (blue[hue], red[hue]);
        [y + 1.402 * r, y - 0.344_136 * b - 0.714_136 * r, y + 1.772 * b, 255.0]
    };
    (0..SIDE * SIDE).flat_map(pixel).map(|channel| channel.round().clamp(0.0, 255.0) as u8).collect()
}

/// Grounds, and what is drawn on each: colours that waves and shared hues make others of.
const SETS: [[Color; 4]; 5] = [
    [WHITE, [26, 26, 26], [141, 153, 174], [239, 35, 60]],
    [WHITE, [0, 0, 0], [208, 0, 0], [27, 152, 224]],
    [[245, 240, 230], [34, 34, 34], [42, 127, 98], [228, 87, 46]],
    [[0, 63, 92], [255, 166, 0], [239, 86, 117], WHITE],
    [[232, 241, 242], [19, 41, 61], [0, 100, 148], [255, 166, 0]],
];
/// Shares of the suggested steps: those of qualities 90, 75 and 50.
const SHARES: [f64; 3] = [0.2, 0.5, 1.0];

/// A disc, a bar aslant and a triangle on a ground, apart from each other.
fn shapes([ground, first, second, third]: [Color; 4]) -> Vec<u8> {
    drawn(&|x, y| {
        if disc(x, y, 40.3, 42.1, 27.7) {
            first
        } else if (0.31 * x + y - 116.0).abs() < 7.0 && x > 9.0 && x < 104.0 {
            second
        } else if x > 76.0 && y > 12.0 && y < 0.9 * x - 42.0 && x < 119.0 {
            third
        } else {
            ground
        }
    })
}

fn drawn(color: &dyn Fn(f64, f64) -> Color) -> Vec<u8> {
    let paint: Paint = &|x, y| Some(color(x, y));
    draw(SIDE, SIDE, paint)
}

fn assert_palette(width: usize, bytes: &[u8], drawn: &[Color], what: &str) {
    let found = palette(width, bytes, 8);
    for &color in drawn {
        let off = found.iter().map(|&other| apart(color, other)).min();
        assert!(off <= Some(NEAR), "{what}: {color:?} among {found:?}");
    }
    assert_eq!(found.len(), drawn.len(), "{what}: {found:?}");
}

#[test]
fn waves_beside_edges_are_no_colours() {
    for colors in SETS {
        let bytes = shapes(colors);
        assert_palette(SIDE, &bytes, &colors, "as drawn");
        for share in SHARES {
            assert_palette(SIDE, &compressed(&bytes, share), &colors, &format!("steps of {share}"));
        }
    }
}

#[test]
fn a_part_of_a_compressed_picture_has_the_same_colours() {
    let bytes = compressed(&shapes(SETS[0]), 1.0);
    let part: Vec<u8> = bytes.chunks_exact(4 * SIDE).skip(5).flat_map(|row| &row[4 * 3..]).copied().collect();
    assert_palette(SIDE - 3, &part, &SETS[0], "three columns and five rows less");
}

#[test]
fn a_shade_that_waves_could_make_stays_where_it_was_drawn_flat() {
    // As light as what a wave makes of the ground, but even where no edge is near.
    let (ground, panel) = ([26, 26, 26], [50, 50, 50]);
    let color = |x: f64, y: f64| {
        if disc(x, y, 90.3, 84.1, 22.2) {
            WHITE
        } else if (12.4..70.6).contains(&x) && (15.3..61.7).contains(&y) {
            panel
        } else {
            ground
        }
    };
    let bytes = drawn(&color);
    for share in SHARES {
        assert_palette(
            SIDE,
            &compressed(&bytes, share),
            &[ground, panel, WHITE],
            &format!("steps of {share}"),
        );
    }
}

#[test]
fn waves_in_small_pictures_without_an_even_square_are_no_colours() {
    const SMALL: usize = 48;
    for ground in [[217, 35, 46], [255, 78, 0], [78, 73, 238], [0, 163, 224], [0, 154, 68]] {
        for (gap, thick) in [(8.0, 3.5), (9.0, 4.0), (10.0, 4.0)] {
            let rings = |x: f64, y: f64| {
                let far = (x - 23.4).hypot(y - 24.7);
                if far < 23.0 && far % gap < thick { WHITE } else { ground }
            };
            let bytes = compressed(&drawn(&rings), SHARES[0]);
            let rows = bytes.chunks_exact(4 * SIDE).take(SMALL);
            let part: Vec<u8> = rows.flat_map(|row| &row[..4 * SMALL]).copied().collect();
            assert_palette(SMALL, &part, &[ground, WHITE], &format!("rings of {thick}"));
        }
    }
}
