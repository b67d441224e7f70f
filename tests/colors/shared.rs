//! Pictures whose pixels share their hues, as JPEG keeps them: what is between two hues is no colour. Hairlines in
//! pictures that share nothing are.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::colors::{BLUE, Paint, RED, WHITE, YELLOW, apart, disc, draw, palette};
use expline::trace::{Census, Color, LayerTracer, Layers, TraceOptions, TracedLayer};

const SIDE: usize = 96;
const BLACK: Color = [0, 0, 0];
const DARK: Color = [40, 40, 40];
const GREEN: Color = [0, 153, 51];
const ORANGE: Color = [255, 128, 0];
const PURPLE: Color = [128, 0, 160];
/// So near is a colour that was found to the one that was drawn.
const NEAR: u8 = 8;

/// Red, green and blue of a light and two differences of hue, and the way back (ITU-T T.871).
fn rgb([y, cb, cr]: [f64; 3]) -> [f64; 3] {
    [y + 1.402 * cr, y - 0.344_136 * cb - 0.714_136 * cr, y + 1.772 * cb]
}

fn ycc([r, g, b]: [f64; 3]) -> [f64; 3] {
    let y = 0.299 * r + 0.587 * g + 0.114 * b;
    [y, (b - y) / 1.772, (r - y) / 1.402]
}

/// What is left of an opaque picture when each square of four pixels keeps one hue, the mean of theirs, and pixels take
/// three quarters along each axis from their own and one from the next.
fn shared(bytes: &[u8]) -> Vec<u8> {
    let pixels: Vec<[f64; 3]> =
        bytes.as_chunks::<4>().0.iter().map(|&[r, g, b, _]| ycc([r, g, b].map(f64::from))).collect();
    let half = SIDE / 2;
    let kept = |row: usize, column: usize, k: usize| {
        let at = 2 * row * SIDE + 2 * column;
        [at, at + 1, at + SIDE, at + SIDE + 1].iter().map(|&at| pixels[at][k]).sum::<f64>() / 4.0
    };
    let beside = |at: usize| {
        if at.is_multiple_of(2) { (at / 2).saturating_sub(1) } else { (at / 2 + 1).min(half - 1) }
    };
    let mut out = Vec::with_capacity(bytes.len());
    for (row, column) in (0..SIDE * SIDE).map(|at| (at / SIDE, at % SIDE)) {
        let hue = |k: usize| {
            let [rows, columns] = [row, column].map(|at| [(at / 2, 0.75), (beside(at), 0.25)]);
            let pairs = rows.iter().flat_map(|&r| columns.iter().map(move |&c| (r, c)));
            pairs.map(|(r, c)| r.1 * c.1 * kept(r.0, c.0, k)).sum::<f64>()
        };
        let color = rgb([pixels[row * SIDE + column][0], hue(1), hue(2)]);
        out.extend(color.map(|channel| channel.round().clamp(0.0, 255.0) as u8));
        out.push(255);
    }
    out
}

fn assert_palette(bytes: &[u8], drawn: &[Color], what: &str) {
    let found = palette(SIDE, bytes, 8);
    for &color in drawn {
        let off = found.iter().map(|&other| apart(color, other)).min();
        assert!(off <= Some(NEAR), "{what}: {color:?} among {found:?}");
    }
    assert_eq!(found.len(), drawn.len(), "{what}: {found:?}");
}

/// A disc, a bar aslant and a triangle on a ground.
fn shapes([ground, first, second, third]: [Color; 4]) -> Vec<u8> {
    draw(SIDE, SIDE, &|x, y| {
        Some(if disc(x, y, 33.3, 36.1, 21.7) {
            first
        } else if (0.31 * x + y - 84.0).abs() < 6.0 && x < 80.0 {
            second
        } else if x > 62.0 && y > 12.0 && y < 0.7 * x - 4.0 {
            third
        } else {
            ground
        })
    })
}

const SETS: [[Color; 4]; 6] = [
    [ORANGE, DARK, WHITE, BLUE],
    [WHITE, RED, BLUE, YELLOW],
    [BLUE, YELLOW, RED, WHITE],
    [YELLOW, DARK, PURPLE, GREEN],
    [GREEN, WHITE, ORANGE, DARK],
    [DARK, ORANGE, YELLOW, PURPLE],
];

#[test]
fn what_is_between_hues_that_pixels_share_is_no_colour() {
    for colors in SETS {
        let bytes = shapes(colors);
        assert_palette(&bytes, &colors, "as drawn");
        assert_palette(&shared(&bytes), &colors, "shared");
    }
}

/// What is traced where the census says whether hues are shared.
fn traced(bytes: &[u8], sharing: bool) -> Vec<TracedLayer> {
    let mut census = Census::new(SIDE).expect("a few colours");
    census.push_rgba_rows(bytes);
    let palette = census.palette(8).expect("between 2 and 64");
    let rows = Layers::begin(SIDE, SIDE, &palette).expect("a valid picture");
    let mut rows = rows.sharing_hues(sharing && census.shares_hues());
    rows.push_rgba_rows(bytes).expect("whole rows");
    let mut tracer = LayerTracer::new(rows.finish().expect("all rows"), &TraceOptions::default());
    while !tracer.step(4000.0).expect("a drawing") {}
    tracer.layers().to_vec()
}

#[test]
fn edges_are_where_light_changes_when_hues_are_shared() {
    for colors in SETS {
        let bytes = shapes(colors);
        let away = |bytes: &[u8], sharing: bool| {
            let layers = traced(bytes, sharing);
            let layer = layers.iter().find(|layer| apart(layer.color, colors[1]) <= NEAR).expect("the disc");
            let mut nearest = [f64::MAX; 2];
            for contour in &layer.contours {
                let pieces = contour.curve.segment_count();
                let at =
                    |k: usize| contour.curve.evaluate(k as f64 * pieces as f64 / 400.0, 0).expect("on it");
                let far = |k: usize| ((at(k).x - 33.3).hypot(at(k).y - 36.1) - 21.7).abs();
                let mean = (0..400).map(far).sum::<f64>() / 400.0;
                if mean < nearest[0] {
                    nearest = [mean, pieces as f64];
                }
            }
            nearest
        };
        let shared = shared(&bytes);
        let ([by_light, pieces], [by_all, _]) = (away(&shared, true), away(&shared, false));
        // What is drawn by 64 samples a pixel is a hundredth of a pixel off, and bytes are rounded.
        assert!(by_light < 0.015 && 1.3 * by_light < by_all, "{colors:?}: {by_light} px, {by_all} px");
        assert_eq!(pieces, 2.0, "{colors:?}: a disc");
    }
}

/// What is to the left, a line and what is to the right: grounds that have the line's hue between them, and grounds
/// that are one.
const RULES: [[Color; 3]; 8] = [
    [[0, 0, 255], BLACK, [255, 255, 0]],
    [[0, 255, 0], BLACK, [255, 0, 255]],
    [[255, 250, 200], WHITE, [200, 205, 255]],
    [YELLOW, PURPLE, BLUE],
    [WHITE, RED, WHITE],
    [WHITE, YELLOW, WHITE],
    [DARK, BLUE, DARK],
    [BLACK, ORANGE, BLACK],
];

#[test]
fn crisp_hairlines_keep_their_colour_whatever_is_beside_them() {
    for [left, line, right] in RULES {
        let side = |off: f64, width: f64| {
            Some(if off < 0.0 {
                left
            } else if off < width {
                line
            } else {
                right
            })
        };
        for width in [1.0, 2.0] {
            let drawn = if left == right { vec![left, line] } else { vec![left, line, right] };
            let ways: [Paint; 3] = [&|x, _| side(x - 40.0, width), &|_, y| side(y - 40.0, width), &|x, y| {
                side(x.floor() - y.floor(), width)
            }];
            for paint in ways {
                assert_palette(&draw(SIDE, SIDE, paint), &drawn, "a hairline");
            }
        }
    }
}

#[test]
fn hairlines_aslant_are_no_edges_of_shared_hues() {
    for [left, line, right] in RULES {
        let aslant = |x: f64, y: f64| {
            let off = (x - 0.37 * y - 30.0) / 1.066;
            Some(if off < 0.0 {
                left
            } else if off < 1.0 {
                line
            } else {
                right
            })
        };
        // Pixels that the line covers most show nine tenths of it; a line that is paler than that beside its grounds is
        // not asked for.
        let bytes = draw(SIDE, SIDE, &aslant);
        let off = palette(SIDE, &bytes, 8).iter().map(|&other| apart(line, other)).min();
        assert!(off <= Some(32) || apart(left, line).max(apart(right, line)) < 64, "{line:?}: {off:?}");
    }
}
