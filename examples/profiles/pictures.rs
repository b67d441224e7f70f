//! Pictures like photographs, drawn by code: shaded, blurred, with noise.

/// Columns and rows.
pub(crate) const SIDE: usize = 160;

/// A small generator of noise: the same numbers everywhere.
struct Noise(u64);

impl Noise {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1_u64 << 31) as f64
    }

    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.unit()).sum::<f64>() - 6.0
    }
}

/// A softened step: 1 inside (negative distances), 0 outside.
fn inside(distance: f64) -> f64 {
    0.5 - 0.5 * libm::tanh(1.4 * distance)
}

/// A picture whose edge is known.
pub(crate) struct Picture {
    pub(crate) name: &'static str,
    pub(crate) bytes: Vec<u8>,
    /// Zero on the edge, negative inside.
    outside: fn(f64, f64) -> f64,
}

impl Picture {
    /// How far a place is from the edge, to first order.
    pub(crate) fn distance(&self, x: f64, y: f64) -> f64 {
        let slope = |a: f64, b: f64| (a - b) / 2e-4;
        let across = slope((self.outside)(x + 1e-4, y), (self.outside)(x - 1e-4, y));
        let down = slope((self.outside)(x, y + 1e-4), (self.outside)(x, y - 1e-4));
        (self.outside)(x, y).abs() / libm::hypot(across, down).max(0.2)
    }
}

/// Draws what is outside and inside of an edge; `noise` is the deviation of shades.
fn draw(
    name: &'static str,
    noise: f64,
    outside: fn(f64, f64) -> f64,
    shade: &dyn Fn(f64, f64, f64) -> f64,
) -> Picture {
    let mut random = Noise(name.bytes().map(u64::from).sum());
    let place = |i: usize| i as f64 + 0.5;
    let bytes = (0..SIDE * SIDE)
        .map(|i| (place(i % SIDE), place(i / SIDE)))
        .map(|(x, y)| shade(x, y, inside(outside(x, y))) + noise * random.normal())
        .map(|shade| shade.round().clamp(0.0, 255.0) as u8)
        .collect();
    Picture { name, bytes, outside }
}

fn polar(x: f64, y: f64) -> (f64, f64) {
    (libm::hypot(x, y), libm::atan2(y, x))
}

/// How far a place is outside a polygon, negative inside.
fn polygon(corners: &[(f64, f64)], x: f64, y: f64) -> f64 {
    let (mut nearest, mut within) = (f64::MAX, false);
    for (i, &(ax, ay)) in corners.iter().enumerate() {
        let (bx, by) = corners[(i + 1) % corners.len()];
        let (dx, dy) = (bx - ax, by - ay);
        let t = (((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        nearest = nearest.min(libm::hypot(x - ax - t * dx, y - ay - t * dy));
        if (ay > y) != (by > y) && x < ax + dx * (y - ay) / dy {
            within = !within;
        }
    }
    if within { -nearest } else { nearest }
}

const LETTER: [(f64, f64); 12] = [
    (22.0, 136.0),
    (22.0, 26.0),
    (46.0, 26.0),
    (80.0, 84.0),
    (114.0, 26.0),
    (138.0, 26.0),
    (138.0, 136.0),
    (114.0, 136.0),
    (114.0, 66.0),
    (80.0, 122.0),
    (46.0, 66.0),
    (46.0, 136.0),
];

fn petals(x: f64, y: f64) -> f64 {
    let (r, a) = polar(x - 80.0, y - 78.0);
    r - 38.0 - 24.0 * libm::fabs(libm::cos(2.5 * a))
}

fn coins(x: f64, y: f64) -> f64 {
    let coin = |cx: f64, cy: f64, r: f64| libm::hypot(x - cx, y - cy) - r;
    coin(48.0, 50.0, 30.0).min(coin(112.0, 62.0, 24.0)).min(coin(76.0, 118.0, 27.0))
}

fn cloud(x: f64, y: f64) -> f64 {
    let (r, a) = polar(x - 82.0, y - 80.0);
    r - 48.0 - 7.0 * libm::sin(3.0 * a) - 5.0 * libm::sin(7.0 * a + 1.0) - 2.0 * libm::sin(13.0 * a)
}

fn leaf(x: f64, y: f64) -> f64 {
    let (u, v) = ((x + y) * 0.5_f64.sqrt() - 113.0, (y - x) * 0.5_f64.sqrt());
    (libm::fabs(v) - 27.0 * (1.0 - (u / 66.0) * (u / 66.0))) * 0.85
}

fn oval(x: f64, y: f64) -> f64 {
    48.0 * (libm::hypot((x - 80.0) / 62.0, (y - 80.0) / 41.0) - 1.0)
}

fn gear(x: f64, y: f64) -> f64 {
    let (r, a) = polar(x - 81.0, y - 79.0);
    r - 54.0 - 9.0 * libm::tanh(3.0 * libm::sin(9.0 * a))
}

fn crescent(x: f64, y: f64) -> f64 {
    (libm::hypot(x - 80.0, y - 84.0) - 57.0).max(50.0 - libm::hypot(x - 84.0, y - 58.0))
}

/// A body, its arch with a canal, three processes: a vertebra from above.
fn vertebra(x: f64, y: f64) -> f64 {
    let body = 34.0 * (libm::hypot((x - 80.0) / 40.0, (y - 52.0) / 28.0) - 1.0);
    let arch = libm::hypot(x - 80.0, y - 92.0) - 22.0;
    let side = polygon(&[(22.0, 98.0), (138.0, 98.0), (132.0, 110.0), (28.0, 110.0)], x, y);
    let spine = polygon(&[(74.0, 104.0), (86.0, 104.0), (84.0, 146.0), (76.0, 146.0)], x, y);
    let canal = libm::hypot(x - 80.0, y - 91.0) - 12.0;
    body.min(arch).min(side).min(spine).max(-canal)
}

fn ribbon(x: f64, y: f64) -> f64 {
    let middle = y - 80.0 - 34.0 * libm::sin(x / 23.0);
    let slope = 34.0 / 23.0 * libm::cos(x / 23.0);
    (libm::fabs(middle) / libm::hypot(1.0, slope) - 8.0).max(libm::fabs(x - 80.0) - 62.0)
}

/// All pictures.
pub(crate) fn all() -> Vec<Picture> {
    vec![
        draw("petals", 3.0, petals, &|x, y, ink| {
            190.0 - 0.3 * x - (130.0 - 0.4 * libm::hypot(x - 80.0, y - 78.0)) * ink
        }),
        draw("coins", 4.0, coins, &|_, y, ink| 60.0 + 0.25 * y + 105.0 * ink),
        draw("letter", 2.0, |x, y| polygon(&LETTER, x, y), &|_, _, ink| 225.0 - 170.0 * ink),
        draw("cloud", 5.0, cloud, &|x, _, ink| 90.0 + 0.2 * x + 100.0 * ink),
        draw("leaf", 3.0, leaf, &|x, y, ink| 200.0 - (110.0 + 0.15 * (x + y)) * ink),
        draw("oval", 0.0, oval, &|_, _, ink| 40.0 + 160.0 * ink),
        draw("gear", 2.0, gear, &|x, y, ink| 70.0 + 0.2 * (x + y) + 90.0 * ink),
        draw("crescent", 3.0, crescent, &|_, y, ink| 210.0 - 0.3 * y - 120.0 * ink),
        draw("vertebra", 7.0, vertebra, &|x, y, ink| 60.0 + 0.1 * (x + y) + 70.0 * ink),
        draw("ribbon", 3.0, ribbon, &|x, _, ink| 40.0 + 0.3 * x + 110.0 * ink),
    ]
}
