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

fn draw(seed: u64, noise: f64, shade: &dyn Fn(f64, f64) -> f64) -> Vec<u8> {
    let mut random = Noise(seed);
    let place = |i: usize| i as f64 + 0.5;
    (0..SIDE * SIDE)
        .map(|i| shade(place(i % SIDE), place(i / SIDE)) + noise * random.normal())
        .map(|shade| shade.round().clamp(0.0, 255.0) as u8)
        .collect()
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

/// All pictures by name.
pub(crate) fn all() -> Vec<(&'static str, Vec<u8>)> {
    let petals = draw(1, 3.0, &|x, y| {
        let (r, a) = polar(x - 80.0, y - 78.0);
        let petal = r - 38.0 - 24.0 * libm::fabs(libm::cos(2.5 * a));
        190.0 - 0.3 * x - (130.0 - 0.4 * r) * inside(petal)
    });
    let coins = draw(2, 4.0, &|x, y| {
        let coin = |cx: f64, cy: f64, r: f64, tone: f64| tone * inside(libm::hypot(x - cx, y - cy) - r);
        60.0 + 0.25 * y
            + coin(48.0, 50.0, 30.0, 110.0)
            + coin(112.0, 62.0, 24.0, 90.0)
            + coin(76.0, 118.0, 27.0, 120.0)
    });
    let letter = [
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
    let letter = draw(3, 2.0, &|x, y| 225.0 - 170.0 * inside(polygon(&letter, x, y)));
    let cloud = draw(4, 5.0, &|x, y| {
        let (r, a) = polar(x - 82.0, y - 80.0);
        let edge =
            r - 48.0 - 7.0 * libm::sin(3.0 * a) - 5.0 * libm::sin(7.0 * a + 1.0) - 2.0 * libm::sin(13.0 * a);
        90.0 + 0.2 * x + 100.0 * inside(edge)
    });
    let leaf = draw(5, 3.0, &|x, y| {
        let (u, v) = ((x + y) * 0.5_f64.sqrt() - 113.0, (y - x) * 0.5_f64.sqrt());
        let half = 27.0 * (1.0 - (u / 66.0) * (u / 66.0));
        200.0 - (110.0 + 0.3 * u) * inside((libm::fabs(v) - half) * 0.85)
    });
    let oval = draw(6, 0.0, &|x, y| {
        let d = libm::hypot((x - 80.0) / 62.0, (y - 80.0) / 41.0);
        40.0 + 160.0 * inside((d - 1.0) * 48.0)
    });
    vec![
        ("petals", petals),
        ("coins", coins),
        ("letter", letter),
        ("cloud", cloud),
        ("leaf", leaf),
        ("oval", oval),
    ]
}
