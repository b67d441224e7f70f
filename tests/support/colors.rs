//! Pictures of flat colours, and what is traced from them.

use expline::trace::{Census, Color, LayerTracer, Layers, Tint, TraceOptions, TracedLayer};

pub(crate) const RED: Color = [200, 16, 46];
pub(crate) const BLUE: Color = [0, 48, 135];
pub(crate) const WHITE: Color = [255, 255, 255];
pub(crate) const YELLOW: Color = [255, 205, 0];

/// Places per pixel and axis at which a picture asks for its colour.
const FINE: usize = 8;

pub(crate) type Paint<'a> = &'a dyn Fn(f64, f64) -> Option<Color>;

/// Draws what is painted with anti-aliasing, as red, green, blue and opacity.
pub(crate) fn draw(width: usize, height: usize, paint: Paint) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(4 * width * height);
    for row in 0..height {
        for column in 0..width {
            let (mut sums, mut hits) = ([0.0; 3], 0.0);
            for k in 0..FINE * FINE {
                let place = |start: usize, k: usize| start as f64 + (k as f64 + 0.5) / FINE as f64;
                if let Some(color) = paint(place(column, k % FINE), place(row, k / FINE)) {
                    hits += 1.0;
                    for (sum, channel) in sums.iter_mut().zip(color) {
                        *sum += f64::from(channel);
                    }
                }
            }
            bytes.extend(sums.map(|sum| (sum / f64::max(hits, 1.0)).round() as u8));
            bytes.push((255.0 * hits / (FINE * FINE) as f64).round() as u8);
        }
    }
    bytes
}

pub(crate) fn palette(width: usize, bytes: &[u8], most: usize) -> Vec<Color> {
    let mut census = Census::new(width).expect("a few colours");
    census.push_rgba_rows(bytes);
    census.palette(most).expect("between 2 and 64").iter().map(Tint::on_white).collect()
}

pub(crate) fn traced<T: Copy + Into<Tint>>(
    width: usize,
    height: usize,
    bytes: &[u8],
    colors: &[T],
) -> Vec<TracedLayer> {
    let mut rows = Layers::begin(width, height, colors).expect("a valid picture");
    rows.push_rgba_rows(bytes).expect("whole rows");
    let layers = rows.finish().expect("all rows");
    let mut tracer = LayerTracer::new(layers, &TraceOptions::default());
    while !tracer.step(4000.0).expect("a drawing") {}
    tracer.layers().to_vec()
}

pub(crate) fn disc(x: f64, y: f64, cx: f64, cy: f64, r: f64) -> bool {
    (x - cx).hypot(y - cy) < r
}

/// What a pixel takes of each of the pixels beside it, in 64, where a picture was scaled softly, and where it was
/// scaled so that edges stay sharp, and are seen beside them, too.
pub(crate) const SOFT: i32 = 16;
pub(crate) const SHARP: i32 = -8;

/// A picture that was scaled: each pixel takes something of those beside it, along rows and then along columns.
pub(crate) fn scaled(width: usize, bytes: &[u8], share: i32) -> Vec<u8> {
    let height = bytes.len() / (4 * width);
    let mix = |bytes: &[u8], step: usize, at: usize, place: usize, count: usize| {
        let here = i32::from(bytes[at]);
        let before = if place > 0 { i32::from(bytes[at - step]) } else { here };
        let after = if place + 1 < count { i32::from(bytes[at + step]) } else { here };
        ((share * (before + after) + (64 - 2 * share) * here + 32) / 64).clamp(0, 255) as u8
    };
    let across: Vec<u8> = (0..bytes.len()).map(|at| mix(bytes, 4, at, at / 4 % width, width)).collect();
    (0..bytes.len()).map(|at| mix(&across, 4 * width, at, at / (4 * width), height)).collect()
}

/// How far two colours are apart, at most in one channel.
pub(crate) fn apart(a: Color, b: Color) -> u8 {
    a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}
