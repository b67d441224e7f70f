//! Pictures of flat colours in uneven light have the colours and shapes that they have in even light. What was drawn
//! as a gradient stays.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::colors::{BLUE, RED, WHITE, YELLOW, apart, disc, draw, palette, traced};
use crate::support::pictures::Noise;
use expline::trace::{Color, LightScan, TracedLayer};

const SIDE: usize = 256;
const PAPER: Color = [236, 238, 240];
const GREEN: Color = [40, 150, 80];

/// How much light falls on a place of the unit square, for each channel, from 0 to 1.
type Light<'a> = &'a dyn Fn(f64, f64) -> [f64; 3];

/// A picture in a light, with noise of so many shades.
fn lit(bytes: &[u8], light: Light, deviation: f64) -> Vec<u8> {
    let mut noise = Noise(7);
    let mut out = bytes.to_vec();
    for (i, pixel) in out.as_chunks_mut::<4>().0.iter_mut().enumerate() {
        let place = |at: usize| (at as f64 + 0.5) / SIDE as f64;
        let light = light(place(i % SIDE), place(i / SIDE));
        for (channel, share) in pixel.iter_mut().zip(light) {
            *channel =
                (f64::from(*channel) * share + deviation * noise.normal()).round().clamp(0.0, 255.0) as u8;
        }
    }
    out
}

/// The picture in even light, if its light is found to be uneven. Its rows come as they like.
fn evened(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut scan = LightScan::new(SIDE, SIDE).expect("room");
    bytes.chunks(4 * SIDE * 7).for_each(|rows| scan.push_rgba_rows(rows));
    let light = scan.light()?;
    let mut even = bytes.to_vec();
    for (i, rows) in even.chunks_mut(4 * SIDE * 50).enumerate() {
        light.even(50 * i, rows);
    }
    Some(even)
}

/// Three pens on a whiteboard.
fn board(x: f64, y: f64) -> Option<Color> {
    let ring = |cx: f64, cy: f64, r: f64| ((x - cx).hypot(y - cy) - r).abs() < 3.0;
    Some(if ring(70.2, 80.1, 41.0) {
        RED
    } else if (y - 190.0 - 20.0 * (x / 30.0).sin()).abs() < 4.0 && (20.0..230.0).contains(&x) {
        BLUE
    } else if ring(180.4, 90.3, 30.0) || ((150.0..210.0).contains(&x) && (y - 90.0).abs() < 3.0) {
        GREEN
    } else {
        PAPER
    })
}

/// A poster without paper: four areas and a disc over them.
fn poster(x: f64, y: f64) -> Option<Color> {
    Some(if disc(x, y, 128.0, 120.0, 60.0) {
        [245, 240, 225]
    } else if y > 0.6 * x + 110.0 {
        GREEN
    } else if x > 170.0 {
        [60, 90, 150]
    } else {
        YELLOW
    })
}

fn lights() -> [(&'static str, Light<'static>); 4] {
    [
        ("from the left", &|x, y| [0.97 - 0.4 * x - 0.05 * y; 3]),
        ("of a lamp", &|x, y| [(-1.2 * ((x - 0.35).powi(2) + (y - 0.3).powi(2))).exp(); 3]),
        ("that fades in the corners", &|x, y| [1.0 - 0.7 * ((x - 0.5).powi(2) + (y - 0.5).powi(2)); 3]),
        ("that becomes warmer", &|x, _| [0.97 - 0.25 * x, 0.97 - 0.31 * x, 0.97 - 0.36 * x]),
    ]
}

fn count(layers: &[TracedLayer]) -> usize {
    layers.iter().map(|layer| layer.contours.len()).sum()
}

#[test]
fn a_drawing_in_uneven_light_has_the_colours_and_outlines_of_the_drawing() {
    for (what, paint) in [("board", &board as &dyn Fn(f64, f64) -> Option<Color>), ("poster", &poster)] {
        let drawn = draw(SIDE, SIDE, paint);
        let wanted = palette(SIDE, &drawn, 8);
        let outlines = count(&traced(SIDE, SIDE, &drawn, &wanted));
        for (name, light) in lights() {
            let uneven = lit(&drawn, light, 0.0);
            assert!(
                palette(SIDE, &uneven, 8).len() > wanted.len(),
                "{what}, light {name}: as it is it has bands"
            );
            let even = evened(&uneven).expect("uneven light");
            let found = palette(SIDE, &even, 8);
            assert_eq!(found.len(), wanted.len(), "{what}, light {name}: {found:?}");
            for &color in &wanted {
                let off = found.iter().map(|&other| apart(color, other)).min();
                // The most light is not all light: at most a fifth is missing there, in what is brightest.
                assert!(off < Some(32), "{what}, light {name}: {color:?} among {found:?}");
            }
            assert_eq!(count(&traced(SIDE, SIDE, &even, &found)), outlines, "{what}, light {name}");
        }
    }
}

#[test]
fn noise_hides_no_light() {
    for (what, paint) in [("board", &board as &dyn Fn(f64, f64) -> Option<Color>), ("poster", &poster)] {
        let drawn = draw(SIDE, SIDE, paint);
        for (name, light) in lights() {
            let uneven = lit(&drawn, light, 2.0);
            let even = evened(&uneven).expect("uneven light");
            // Of each channel what is left after the best factor: noise, and what the light is off by.
            let rest = |bytes: &[u8]| {
                let (mut both, mut squares) = (0.0, 0.0);
                let pairs = || bytes.iter().zip(&drawn).map(|(&a, &b)| (f64::from(a), f64::from(b)));
                pairs().for_each(|(a, b)| (both, squares) = (both + a * b, squares + a * a));
                pairs().map(|(a, b)| (a * both / squares - b).abs()).sum::<f64>() / drawn.len() as f64
            };
            assert!(3.0 * rest(&even) < 2.0 * rest(&uneven), "{what}, light {name}");
        }
    }
}

#[test]
fn even_light_is_left_alone() {
    for paint in [&board as &dyn Fn(f64, f64) -> Option<Color>, &poster] {
        let drawn = draw(SIDE, SIDE, paint);
        assert!(evened(&drawn).is_none(), "as it was drawn");
        assert!(evened(&lit(&drawn, &|_, _| [1.0; 3], 3.0)).is_none(), "with noise");
        assert!(evened(&lit(&drawn, &|x, _| [1.0 - 0.04 * x; 3], 0.0)).is_none(), "almost even");
    }
}

/// Shares of white.
type Shade<'a> = &'a dyn Fn(f64, f64) -> [f64; 3];

#[test]
fn gradients_that_were_drawn_stay() {
    let ball = |x: f64, y: f64, cx: f64, r: f64| {
        let light = 1.0 - 0.5 * ((x - cx + 0.3 * r).powi(2) + (y - 0.5 + 0.3 * r).powi(2)) / (r * r);
        ((x - cx).hypot(y - 0.5) < r).then_some(light)
    };
    let drawings: [(&str, Shade); 8] = [
        ("a sunset", &|x, y| match y {
            _ if (x - 0.6).hypot(y - 0.5) < 0.1 => [1.0, 0.9, 0.6],
            _ if y < 0.65 => [0.3 + y, 0.25 + 0.5 * y, 0.5 - 0.2 * y],
            _ => [0.2, 0.25, 0.3],
        }),
        ("a sky of one hue", &|_, y| {
            if y < 0.65 { [0.4, 0.6, 0.9].map(|v| v * (0.6 + 0.6 * y)) } else { [0.3, 0.6, 0.3] }
        }),
        ("a ball", &|x, y| ball(x, y, 0.5, 0.42).map_or([1.0; 3], |k| [0.9 * k, 0.3 * k, 0.2 * k])),
        ("two balls", &|x, y| {
            let one = ball(x, y, 0.27, 0.2).map(|k| [0.9 * k, 0.3 * k, 0.2 * k]);
            one.or(ball(x, y, 0.73, 0.2).map(|k| [0.2 * k, 0.4 * k, 0.9 * k])).unwrap_or([0.95; 3])
        }),
        ("a gray ramp", &|x, _| [0.2 + 0.8 * x; 3]),
        ("an icon on a gradient", &|x, y| {
            let is_cross = (x - 0.5).abs() < 0.1 && (y - 0.5).abs() < 0.35;
            if is_cross {
                [1.0; 3]
            } else {
                [0.4, 0.7, 0.95].map(|v| v * (1.0 - 0.7 * (x - 0.5).hypot(y - 0.5)))
            }
        }),
        ("a button", &|x, y| {
            let is_inside = (0.15..0.85).contains(&x) && (0.3..0.7).contains(&y);
            if is_inside { [0.4, 0.6, 1.0].map(|v| v * (1.2 - y)) } else { [0.95; 3] }
        }),
        ("a photograph", &|x, y| {
            [
                0.5 + 0.4 * (9.0 * x).sin() * (7.0 * y).cos(),
                0.5 + 0.3 * (5.0 * x + 8.0 * y).sin(),
                0.4 + 0.3 * (6.0 * y).cos(),
            ]
        }),
    ];
    for (name, shade) in drawings {
        for deviation in [0.0, 2.0] {
            let white = WHITE.map(f64::from);
            let drawn = draw(SIDE, SIDE, &|x, y| {
                let shares = shade(x / SIDE as f64, y / SIDE as f64);
                Some([0, 1, 2].map(|k| (white[k] * shares[k]).round() as u8))
            });
            assert!(evened(&lit(&drawn, &|_, _| [1.0; 3], deviation)).is_none(), "{name}, noise {deviation}");
        }
    }
}

#[test]
fn small_pictures_and_transparent_ones_have_no_light() {
    let ramp = |width: usize, opacity: u8| -> Vec<u8> {
        (0..width * width)
            .flat_map(|i| [200 - (100 * (i % width) / width) as u8, 180, 160, opacity])
            .collect()
    };
    for (width, opacity) in [(1, 255), (90, 255), (256, 254), (256, 0)] {
        let mut scan = LightScan::new(width, width).expect("room");
        scan.push_rgba_rows(&ramp(width, opacity));
        assert!(scan.light().is_none(), "{width} pixels, opacity {opacity}");
    }
}
