//! Pictures that were scaled up by repeating pixels are traced as what was scaled up; drawings of squares stay squares.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::support::colors;
use crate::support::pictures::{Noise, draw, inside, traced};
use expline::numerics::Point;
use expline::trace::{
    BlockScan, Blocks, Color, Gray, LayerTracer, Layers, Source, Trace, TraceOptions, TracedContour,
    TracedLayer, trace,
};

/// An arrow aslant, in a picture of 96 pixels.
const ARROW: [(f64, f64); 7] =
    [(14.4, 31.9), (67.6, 50.5), (72.3, 36.9), (85.2, 62.5), (59.5, 73.9), (64.2, 60.4), (11.0, 41.8)];
const SIDE: usize = 96;

fn arrow() -> Vec<u8> {
    draw(SIDE, SIDE, &|x, y| inside(&ARROW, x, y) || (x - 30.3).hypot(y - 75.2) < 12.7)
}

/// Every pixel, of `each` bytes, so many times in a row and in a column.
fn repeated(bytes: &[u8], each: usize, side: usize, times: usize) -> Vec<u8> {
    resized(bytes, each, side, [times, 1], 0)
}

/// So many pixels in a row and in a column for every `count` of them, each where its middle is nearest; `lead` says how
/// middles are rounded.
fn resized(bytes: &[u8], each: usize, side: usize, [size, count]: [usize; 2], lead: usize) -> Vec<u8> {
    let wide = side * size / count;
    let nearest = |at: usize| (at * count + lead) / size;
    let pixel = |i: usize| each * (nearest(i / wide) * side + nearest(i % wide));
    (0..wide * wide).flat_map(|i| &bytes[pixel(i)..pixel(i) + each]).copied().collect()
}

/// What pictures on scaled displays, and in browsers that zoom, are enlarged by.
const FRACTIONS: [[usize; 2]; 8] = [[5, 4], [4, 3], [3, 2], [7, 4], [9, 4], [5, 2], [11, 10], [6, 5]];

/// Contours are those of another picture, so many times as large and moved back. Where that is no power of two,
/// products are rounded.
fn assert_enlarged(contours: &[TracedContour], from: &[TracedContour], times: f64, back: [f64; 2]) {
    assert_stretched(contours, from, [times; 2], back);
    for (large, small) in contours.iter().zip(from) {
        let off = large.metrics.max - times * small.metrics.max;
        assert!(off.abs() < 1e-9, "distances are in pixels of the picture");
    }
}

/// The same, if not as much along rows as along columns.
fn assert_stretched(contours: &[TracedContour], from: &[TracedContour], times: [f64; 2], back: [f64; 2]) {
    assert_eq!(contours.len(), from.len(), "as many contours");
    let most = 1e-12 * times[0].max(times[1]) * SIDE as f64;
    let is_there = |p: &Point, q: &Point| {
        (0..2).all(|axis| (p[axis] - (times[axis] * q[axis] - back[axis])).abs() <= most)
    };
    for (large, small) in contours.iter().zip(from) {
        let lists = [(large.curve.points(), small.curve.points()), (&large.cusps, &small.cusps)];
        for (points, old) in lists {
            assert_eq!(points.len(), old.len(), "as many points and corners");
            assert!(points.iter().zip(old).all(|(p, q)| is_there(p, q)), "{points:?} for {old:?}");
        }
        for (p, q) in large.curve.tangents().iter().zip(small.curve.tangents()) {
            let off = p - Point::new(times[0] * q.x, times[1] * q.y);
            assert!(off.norm() <= 2.0 * most, "{p:?} for {q:?}");
        }
        assert_eq!(large.curve.omega(), small.curve.omega(), "arcs stay arcs");
    }
}

#[test]
fn a_drawing_enlarged_by_repeating_pixels_is_traced_as_the_drawing_and_enlarged() {
    let bytes = arrow();
    let small = traced(SIDE, SIDE, &bytes);
    for times in [2, 3, 4, 8] {
        let large = traced(times * SIDE, times * SIDE, &repeated(&bytes, 1, SIDE, times));
        assert_enlarged(&large.contours, &small.contours, times as f64, [0.0; 2]);
        assert_eq!(large.contours[0].curve.points().len(), ARROW.len(), "the arrow has its own corners");
    }
}

#[test]
fn a_drawing_enlarged_by_a_fraction_is_traced_as_the_drawing_and_enlarged() {
    let mut noise = Noise(3);
    let clean = arrow();
    let grainy: Vec<u8> =
        clean.iter().map(|&shade| (f64::from(shade) * 0.9 + 25.0 * noise.unit()) as u8).collect();
    for (bytes, fractions) in [(&clean, &FRACTIONS[..]), (&grainy, &FRACTIONS[..4])] {
        let small = traced(SIDE, SIDE, bytes);
        for &[size, count] in fractions {
            // A middle between two pixels is that of either.
            for lead in [(count - 1) / 2, count / 2] {
                let wide = SIDE * size / count;
                let large = traced(wide, wide, &resized(bytes, 1, SIDE, [size, count], lead));
                assert_enlarged(&large.contours, &small.contours, size as f64 / count as f64, [0.0; 2]);
            }
        }
    }
}

#[test]
fn a_drawing_enlarged_to_any_size_is_traced_as_the_drawing_and_enlarged() {
    let bytes = arrow();
    let small = traced(SIDE, SIDE, &bytes);
    for wide in [107, 128, 171, 250, 333, 901] {
        let times = wide as f64 / SIDE as f64;
        // Each pixel where its middle is nearest, or where it begins: then all are half a pixel late, less half a step
        // of the rounding.
        let late = (SIDE - 1) as f64 / (2 * SIDE) as f64;
        for (lead, back) in [(SIDE / 2, 0.0), ((SIDE - 1) / 2, 0.0), (0, -late)] {
            let large = traced(wide, wide, &resized(&bytes, 1, SIDE, [wide, SIDE], lead));
            assert_enlarged(&large.contours, &small.contours, times, [back; 2]);
        }
    }
}

#[test]
fn sides_that_were_rounded_each_by_itself_are_enlarged_each_by_itself() {
    let rows = 80;
    let bytes = &arrow()[..rows * SIDE];
    let small = traced(SIDE, rows, bytes);
    for [wide, high] in [[171, 142], [171, 143], [251, 209], [125, 104]] {
        let column = |x: usize| (x * SIDE + SIDE / 2) / wide;
        let row = |y: usize| (y * rows + rows / 2) / high;
        let pixel = |i: usize| bytes[row(i / wide) * SIDE + column(i % wide)];
        let large = traced(wide, high, &(0..wide * high).map(pixel).collect::<Vec<u8>>());
        let times = [wide as f64 / SIDE as f64, high as f64 / rows as f64];
        assert_stretched(&large.contours, &small.contours, times, [0.0; 2]);
    }
}

#[test]
fn a_part_cut_out_of_a_drawing_enlarged_by_a_fraction_is_traced_where_it_is() {
    let bytes = arrow();
    let small = traced(SIDE, SIDE, &bytes);
    for [size, count] in FRACTIONS {
        let (wide, times) = (SIDE * size / count, size as f64 / count as f64);
        let large = resized(&bytes, 1, SIDE, [size, count], count / 2);
        for left in 1..=size {
            let top = (2 * left) % size;
            let part: Vec<u8> =
                large.chunks(wide).skip(top).flat_map(|row| &row[left..wide - 1]).copied().collect();
            let cut = traced(wide - 1 - left, wide - top, &part);
            assert_eq!(cut.contours.len(), small.contours.len(), "{size}/{count}, {left} columns cut off");
            for (cut, small) in cut.contours.iter().zip(&small.contours) {
                assert_eq!(cut.curve.points().len(), small.curve.points().len(), "as many points");
                for (p, q) in cut.curve.points().iter().zip(small.curve.points()) {
                    let off = p + Point::new(left as f64, top as f64) - q * times;
                    // Where middles were rounded to is known to one part in so many of a pixel; tracing itself begins
                    // elsewhere.
                    let most = 1.0 / count as f64 + 1e-6;
                    assert!(off.amax() <= most, "{size}/{count}, {left} columns cut off: {off:?}");
                }
            }
        }
    }
}

#[test]
fn marks_in_every_fifth_place_are_what_was_drawn() {
    let mut noise = Noise(11);
    let sizes: Vec<f64> = (0..16 * 16).map(|_| noise.unit()).collect();
    let mark = |x: f64, y: f64| {
        let size = sizes[(y / 5.0) as usize * 16 + (x / 5.0) as usize];
        (x % 5.0 - 2.5, y % 5.0 - 2.5, size)
    };
    let dots = draw(80, 80, &|x, y| {
        let (x, y, size) = mark(x, y);
        x.hypot(y) < 0.5 + size
    });
    let mut bars = draw(80, 80, &|x, y| {
        let (x, y, size) = mark(x, y);
        x.abs() < 0.6 + 0.8 * size && y.abs() < 1.3 - 0.8 * size
    });
    // Each in a shade of its own.
    for (i, shade) in bars.iter_mut().enumerate() {
        *shade = 255 - ((255 - *shade) as f64 * (0.4 + 0.6 * sizes[i / 400 * 16 + (i / 5 + 7) % 16])) as u8;
    }
    for (bytes, what) in [(dots, "dots"), (bars, "bars")] {
        let rgba: Vec<u8> = bytes.iter().flat_map(|&shade| [shade, shade, shade, 255]).collect();
        let mut scan = BlockScan::new(80);
        scan.push(&rgba, 4);
        assert_eq!(scan.blocks(), None, "gaps between {what} that are alike say nothing of the {what}");
        // The same marks enlarged are found, so it is not for their number.
        let mut scan = BlockScan::new(100);
        scan.push(&resized(&rgba, 4, 80, [5, 4], 2), 4);
        assert_eq!(scan.blocks().map(|blocks| blocks.extent()), Some([80; 2]), "{what}");
    }
}

#[test]
fn bands_and_gradients_are_what_was_drawn() {
    // 128 shades in 171 columns come as the columns of an enlarged picture would, and the two rows that change may be
    // rows of one: two by chance.
    let shade = |x: usize| (255 - (x * 128 + 64) / 171) as u8;
    let gradient = |i: usize| if (31..102).contains(&(i / 171)) { shade(i % 171) } else { 255 };
    // Rectangles whose sides lie anywhere, each in a shade of its own.
    let mut noise = Noise(13);
    let sides: Vec<[f64; 4]> = (0..12)
        .map(|k| {
            let [left, top] = [14.0 * f64::from(k) + 2.0 * noise.unit(), 20.0 + 40.0 * noise.unit()];
            [left, top, left + 5.0 + 5.0 * noise.unit(), top + 30.0 + 40.0 * noise.unit()]
        })
        .collect();
    let overlap = |a: f64, b: f64, at: usize| (b.min(at as f64 + 1.0) - a.max(at as f64)).max(0.0);
    let rectangle = |i: usize| {
        let cover = |(k, [a, b, c, d]): (usize, &[f64; 4])| {
            overlap(*a, *c, i % 171) * overlap(*b, *d, i / 171) * (0.5 + k as f64 / 24.0)
        };
        (255.0 * (1.0 - sides.iter().enumerate().map(cover).sum::<f64>())) as u8
    };
    for (what, picture) in [("gradient", &gradient as &dyn Fn(usize) -> u8), ("rectangles", &rectangle)] {
        let rgba: Vec<u8> = (0..171 * 131).flat_map(|i| [picture(i), picture(i), picture(i), 255]).collect();
        let mut scan = BlockScan::new(171);
        scan.push(&rgba, 4);
        assert_eq!(scan.blocks(), None, "{what}");
    }
}

#[test]
fn edges_and_centre_lines_are_enlarged_as_well() {
    let bytes = draw(SIDE, SIDE, &|x, y| ((x - 47.3).hypot(y - 48.6) - 30.2).abs() < 1.6);
    for source in [Source::Edges, Source::Lines] {
        let options = TraceOptions { source, ..TraceOptions::default() };
        let of = |side: usize, bytes: &[u8]| -> Trace {
            trace(Gray::from_bytes(side, side, bytes).expect("a picture"), &options).expect("a drawing")
        };
        let large = of(2 * SIDE, &repeated(&bytes, 1, SIDE, 2));
        assert_enlarged(&large.contours, &of(SIDE, &bytes).contours, 2.0, [0.0; 2]);
    }
}

#[test]
fn a_part_cut_out_of_an_enlarged_picture_is_traced_where_it_is() {
    let (times, bytes) = (4, arrow());
    let large = repeated(&bytes, 1, SIDE, times);
    let small = traced(SIDE, SIDE, &bytes);
    let wide = times * SIDE;
    for [left, top, right, bottom] in [[1, 3, 0, 0], [2, 0, 3, 1], [3, 3, 1, 2]] {
        let rows = large.chunks(wide).take(wide - bottom).skip(top);
        let part: Vec<u8> = rows.flat_map(|row| &row[left..wide - right]).copied().collect();
        let cut = traced(wide - left - right, wide - top - bottom, &part);
        assert_enlarged(&cut.contours, &small.contours, times as f64, [left as f64, top as f64]);
    }
}

#[test]
fn speckles_are_counted_in_pixels_of_the_picture() {
    let bytes = draw(SIDE, SIDE, &|x, y| {
        inside(&ARROW, x, y) || (x - 30.3).hypot(y - 75.2) < 12.7 || (x - 80.0).hypot(y - 15.0) < 2.1
    });
    let large = repeated(&bytes, 1, SIDE, 4);
    let count = |speckle: f64| {
        let options = TraceOptions { speckle: Some(speckle), ..TraceOptions::default() };
        let gray = Gray::from_bytes(4 * SIDE, 4 * SIDE, &large).expect("a picture");
        trace(gray, &options).expect("a drawing").contours.len()
    };
    // The dot has 14 pixels of its own, and 222 of the picture.
    assert_eq!(
        [0.0, 2.0, 100.0, 300.0].map(count),
        [3, 3, 3, 2],
        "the dot goes where it is less than a speckle"
    );
}

/// Whether a place is a corner of squares of eight pixels.
fn is_on_grid(p: &Point) -> bool {
    (0..2).all(|axis| p[axis] % 8.0 == 0.0)
}

#[test]
fn squares_of_two_shades_are_what_was_drawn() {
    // A creature as games have them, the same on both sides.
    let mut noise = Noise(5);
    let half: Vec<u8> =
        (0..12 * 24).map(|i| if noise.unit() < 0.5 + (i % 12) as f64 / 24.0 { 0 } else { 255 }).collect();
    let whole: Vec<u8> =
        half.chunks(12).flat_map(|row| row.iter().chain(row.iter().rev())).copied().collect();
    let found = traced(24 * 8, 24 * 8, &repeated(&whole, 1, 24, 8));
    let corners: Vec<&Point> = found.contours.iter().flat_map(|contour| contour.curve.points()).collect();
    assert!(corners.len() > 100, "{} corners", corners.len());
    assert!(corners.into_iter().all(is_on_grid), "all outlines run around squares");
}

#[test]
fn rectangles_on_a_grid_stay_rectangles() {
    // Bars of a chart, three of 64 columns each.
    let bars = |shade: &dyn Fn(usize) -> u8| -> Vec<u8> {
        let cell = |i: usize| {
            let (x, y) = (i % 64, i / 64);
            let bar = x / 3;
            if x % 3 > 0 && x < 60 && y < 60 && y + 2 * (bar * 7 % 20) > 50 { shade(bar) } else { 255 }
        };
        (0..64 * 64).map(cell).collect()
    };
    let found = traced(512, 512, &repeated(&bars(&|_| 0), 1, 64, 8));
    assert_eq!(found.contours.len(), 20, "as many bars");
    for contour in &found.contours {
        let points = contour.curve.points();
        assert!(points.len() == 4 && points.iter().all(is_on_grid), "{points:?}");
    }
    // Each in a shade of its own, they are no softer: shades of edges lie between those on both sides.
    let shaded = bars(&|bar| (7 * bar) as u8);
    let rgba: Vec<u8> = shaded.iter().flat_map(|&shade| [shade, shade, shade, 255]).collect();
    let mut scan = BlockScan::new(512);
    scan.push(&repeated(&rgba, 4, 64, 8), 4);
    assert_eq!(scan.blocks(), None);
    let found = traced(512, 512, &repeated(&shaded, 1, 64, 8));
    assert_eq!(found.contours.len(), 20, "as many bars");
    for contour in &found.contours {
        // Ink is as dark as the darkest bars; beside paler ones that moves a side by some hundredths of a square.
        let is_near = |p: &Point| (0..2).all(|axis| (p[axis] / 8.0 - (p[axis] / 8.0).round()).abs() < 0.1);
        let points = contour.curve.points();
        assert!(points.len() == 4 && points.iter().all(is_near), "{points:?}");
    }
}

#[test]
fn squares_of_chosen_colours_are_what_was_drawn() {
    // All colours of a palette, in any order; with twice as many they are those of edges.
    for (count, are_squares, size) in
        [(32, true, [10, 1]), (64, false, [10, 1]), (32, true, [3, 2]), (64, false, [3, 2])]
    {
        let mut noise = Noise(7);
        let palette: Vec<[u8; 4]> = (0..count)
            .map(|_| [0, 1, 2, 3].map(|k| if k < 3 { (noise.unit() * 256.0) as u8 } else { 255 }))
            .collect();
        let mut cells = vec![[255; 4]; 40 * 40];
        for cell in cells.chunks_mut(4).step_by(4) {
            cell.fill_with(|| palette[(noise.unit() * f64::from(count)) as usize]);
        }
        let mut scan = BlockScan::new(40 * size[0] / size[1]);
        scan.push(&resized(cells.as_flattened(), 4, 40, size, 0), 4);
        assert_eq!(scan.blocks().is_none(), are_squares, "{count} colours");
    }
}

#[test]
fn a_table_shown_in_colours_is_made_of_its_squares() {
    let mut noise = Noise(9);
    let cells: Vec<u8> = (0..40 * 40).flat_map(|_| [(); 4].map(|()| (noise.unit() * 256.0) as u8)).collect();
    let mut scan = BlockScan::new(40 * 10);
    scan.push(&repeated(&cells, 4, 40, 10), 4);
    assert_eq!(scan.blocks(), None, "each cell is a value of its own");
}

/// Layers of a picture that may be made of squares, and those squares.
fn layered(side: usize, rgba: &[u8], palette: &[Color]) -> (Vec<TracedLayer>, Option<Blocks>) {
    let mut scan = BlockScan::new(side);
    // In two parts, as files are read.
    let (upper, lower) = rgba.split_at(4 * side * 7);
    scan.push(upper, 4);
    scan.push(lower, 4);
    let blocks = scan.blocks();
    let [width, height] = blocks.map_or([side; 2], |blocks| blocks.extent());
    let pixel = |i: usize| 4 * blocks.map_or(i, |blocks| blocks.pixel(i));
    let thin: Vec<u8> = (0..width * height).flat_map(|i| &rgba[pixel(i)..pixel(i) + 4]).copied().collect();
    let mut rows = Layers::begin(width, height, palette).expect("a valid picture");
    rows.push_rgba_rows(&thin).expect("whole rows");
    let layers = rows.finish().expect("all rows");
    let mut tracer = LayerTracer::of_squares(layers, &TraceOptions::default(), blocks);
    while !tracer.step(4000.0).expect("a drawing") {}
    (tracer.layers().to_vec(), blocks)
}

#[test]
fn drawings_of_several_colours_are_enlarged_layer_by_layer() {
    let paint = |x: f64, y: f64| {
        Some(match () {
            () if colors::disc(x, y, 40.3, 41.7, 20.4) => colors::RED,
            () if inside(&ARROW, x, y) => colors::BLUE,
            () => colors::WHITE,
        })
    };
    let rgba = colors::draw(SIDE, SIDE, &paint);
    let palette = [colors::WHITE, colors::RED, colors::BLUE];
    let (small, none) = layered(SIDE, &rgba, &palette);
    assert_eq!(none, None, "the drawing itself is of pixels");
    for [size, count] in [[2, 1], [4, 1], [3, 2], [5, 4], [171, SIDE]] {
        let (wide, times) = (SIDE * size / count, size as f64 / count as f64);
        let (large, blocks) =
            layered(wide, &resized(&rgba, 4, SIDE, [size, count], (count - 1) / 2), &palette);
        assert_eq!(blocks.map(|blocks| blocks.extent()), Some([SIDE; 2]), "its squares are found");
        assert_eq!(large.len(), small.len(), "as many layers");
        for (large, small) in large.iter().zip(&small) {
            assert_eq!(large.color, small.color, "in their order");
            assert_enlarged(&large.contours, &small.contours, times, [0.0; 2]);
        }
    }
}
