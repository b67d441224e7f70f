//! Edges lie where pictures have them, and their profiles are the lines that a viewer sees.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use expline::Error;
use expline::numerics::Point;
use expline::trace::{Chain, EdgeOptions, Edges, Gray, edges, profiles};

/// Places per pixel and axis at which a test picture asks for its shade.
const FINE: usize = 8;

/// Draws shades (0 … 255) with anti-aliasing.
fn draw(width: usize, height: usize, shade: &dyn Fn(f64, f64) -> f64) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let place = |start: usize, k: usize| start as f64 + (k as f64 + 0.5) / FINE as f64;
            let sum: f64 =
                (0..FINE * FINE).map(|k| shade(place(column, k % FINE), place(row, k / FINE))).sum();
            bytes.push((sum / (FINE * FINE) as f64).round() as u8);
        }
    }
    bytes
}

fn find(width: usize, height: usize, bytes: &[u8]) -> Edges {
    let gray = Gray::from_bytes(width, height, bytes).expect("a valid picture");
    edges(&gray, &EdgeOptions::default()).expect("edges")
}

fn chains(width: usize, height: usize, bytes: &[u8]) -> Vec<Chain> {
    profiles(&find(width, height, bytes)).expect("profiles")
}

fn ink(inside: bool) -> f64 {
    if inside { 30.0 } else { 220.0 }
}

#[test]
fn a_disk_has_one_closed_profile_within_a_twentieth_of_a_pixel() {
    let disk = draw(64, 64, &|x, y| ink((x - 31.3).hypot(y - 32.6) <= 22.7));
    let found = chains(64, 64, &disk);
    assert_eq!(found.len(), 1);
    assert!(found[0].is_closed(), "it is a ring");
    let off = |p: &Point| (p - Point::new(31.3, 32.6)).norm() - 22.7;
    let mean = found[0].points().iter().map(off).sum::<f64>() / found[0].points().len() as f64;
    let most = found[0].points().iter().map(|p| off(p).abs()).fold(0.0, f64::max);
    // A Gaussian of deviation σ moves the largest change inwards by σ²/2R: 0.02 here, and half of it again for Sobel's
    // mask and the pixels.
    assert!((-0.06..0.0).contains(&mean) && most < 0.1, "mean {mean}, most {most}");
    // The ring goes round once, and neighbours are neighbours.
    let points = found[0].points();
    let step = |i: usize| (points[(i + 1) % points.len()] - points[i]).norm();
    let length: f64 = (0..points.len()).map(step).sum();
    assert!((length - core::f64::consts::TAU * 22.7).abs() < 3.0, "{length}");
}

#[test]
fn a_mirrored_picture_has_the_mirrored_edges() {
    let shade = |x: f64, y: f64| {
        let wave = 40.0 * (0.31 * x).sin() * (0.17 * y).cos();
        wave + ink((x - 14.0).hypot(y - 21.0) <= 9.3 || (y - 5.0 - 0.4 * x).abs() < 2.0)
    };
    let picture = draw(40, 36, &shade);
    let mirrored: Vec<u8> = picture.chunks_exact(40).flat_map(|row| row.iter().rev().copied()).collect();
    let flipped: Vec<u8> = picture.chunks_exact(40).rev().flatten().copied().collect();
    let sorted = |edges: &Edges, image: &dyn Fn(Point) -> Point| {
        // Only the difference to the far border is rounded, in the sixteenth digit.
        let digits = |x: f64| (x * 1e12).round() as i64;
        let mut points: Vec<(i64, i64)> =
            edges.points.iter().map(|p| image(p.point)).map(|p| (digits(p.x), digits(p.y))).collect();
        points.sort_unstable();
        points
    };
    let same = sorted(&find(40, 36, &picture), &|p| p);
    assert!(same.len() > 100, "there are edges: {}", same.len());
    assert_eq!(same, sorted(&find(40, 36, &mirrored), &|p| Point::new(40.0 - p.x, p.y)));
    assert_eq!(same, sorted(&find(40, 36, &flipped), &|p| Point::new(p.x, 36.0 - p.y)));
}

#[test]
fn a_straight_edge_is_found_between_pixels_whatever_its_contrast() {
    for contrast in [255.0, 60.0, 12.0] {
        for place in [20.0, 20.25, 20.5, 20.9] {
            let picture = draw(40, 12, &|x, _| if x < place { 0.0 } else { contrast });
            let found = find(40, 12, &picture);
            assert!(!found.points.is_empty(), "contrast {contrast}");
            for p in &found.points {
                // Shades are rounded to half of 1 of the contrast; a parabola is not quite the Gaussian's tip.
                let allowed = 0.03 + 0.5 / contrast;
                assert!((p.point.x - place).abs() < allowed, "{} for {place} at {contrast}", p.point.x);
                assert!(p.gradient.x > 0.0, "towards the light");
            }
            assert_eq!(profiles(&found).expect("profiles").len(), 1);
        }
    }
}

#[test]
fn weak_places_count_only_where_they_are_joined_to_strong_ones() {
    // One edge fades along the picture, another is as weak and alone.
    let shade = |x: f64, y: f64| {
        let fading = if y < 10.0 { 0.0 } else { 30.0 + 170.0 * (1.0 - x / 80.0) };
        fading + if y > 28.0 { 20.0 } else { 0.0 }
    };
    let gray = Gray::from_bytes(80, 40, &draw(80, 40, &shade)).expect("a valid picture");
    let options = EdgeOptions { sigma: Some(1.0), high: Some(30.0), low: Some(5.0) };
    let found = edges(&gray, &options).expect("edges");
    assert!(found.points.iter().all(|p| p.row < 20), "the lone weak edge is gone");
    assert!(found.points.iter().any(|p| p.column > 75), "the weak end is there");
}

#[test]
fn lines_go_straight_on_through_a_crossing() {
    // Four quarters of different shades: the edges cross in the middle.
    let shade = |x: f64, y: f64| match (x < 30.3, y < 29.6) {
        (true, true) => 0.0,
        (false, true) => 100.0,
        (true, false) => 120.0,
        (false, false) => 240.0,
    };
    let found = chains(60, 60, &draw(60, 60, &shade));
    assert!(
        (2..=3).contains(&found.len()),
        "two lines, or one broken where a shade is between: {}",
        found.len()
    );
    let longest = found.iter().map(|chain| chain.points().len()).max();
    assert!(longest.is_some_and(|n| n > 50), "one goes through");
}

#[test]
fn spurs_go_and_ends_with_a_small_gap_are_joined() {
    // A line of ink, cut by a hair.
    let shade = |x: f64, y: f64| {
        ink((y - 20.3 - 0.1 * x).abs() < 4.0 && (x - 30.0).abs() > 0.2 && (4.0..56.0).contains(&x))
    };
    let found = chains(60, 40, &draw(60, 40, &shade));
    assert_eq!(found.len(), 1, "one outline");
}

#[test]
fn thresholds_and_blur_out_of_range_are_refused() {
    let gray = Gray::from_bytes(4, 4, &[0; 16]).expect("a valid picture");
    let refused = |options: EdgeOptions| edges(&gray, &options).err().map(|e| e.argument());
    let with = |sigma: f64, high: f64, low: f64| EdgeOptions {
        sigma: Some(sigma),
        high: Some(high),
        low: Some(low),
    };
    assert_eq!(refused(with(0.1, 2.0, 1.0)), Some(Some("sigma")));
    assert_eq!(refused(with(f64::NAN, 2.0, 1.0)), Some(Some("sigma")));
    assert_eq!(refused(with(1.0, -1.0, -1.0)), Some(Some("high")));
    assert_eq!(refused(with(1.0, 2.0, -1.0)), Some(Some("low")));
    assert_eq!(refused(with(1.0, 2.0, 3.0)), Some(Some("low")));
    assert_eq!(refused(with(1.0, 0.0, 0.0)), None, "0 is as low as thresholds go");
    assert!(matches!(Gray::from_bytes(0, 0, &[]).map_err(|e| *e), Err(Error::OutOfRange { .. })));
}

#[test]
fn small_flat_and_hostile_pictures_do_no_harm() {
    for (width, height) in [(1, 1), (1, 2), (2, 1), (1, 50), (50, 1), (2, 2), (3, 3), (5, 4)] {
        for kind in 0..4 {
            let byte = |i: usize| match kind {
                0 => 0,
                1 => 255,
                2 => {
                    if i.is_multiple_of(2) {
                        0
                    } else {
                        255
                    }
                }
                _ => (i * 97 % 251) as u8,
            };
            let bytes: Vec<u8> = (0..width * height).map(byte).collect();
            let found = find(width, height, &bytes);
            assert!(kind > 1 || found.points.is_empty(), "a flat picture has no edges");
            for chain in profiles(&found).expect("profiles") {
                assert!(chain.points().iter().all(|p| p.x.is_finite() && p.y.is_finite()), "finite");
            }
        }
    }
    // A checkerboard and noise: as many places as there are, no harm.
    let checker: Vec<u8> = (0..64 * 64).map(|i| if (i % 64 + i / 64) % 2 == 0 { 0 } else { 255 }).collect();
    profiles(&find(64, 64, &checker)).expect("profiles");
    let mut state = 7_u32;
    let noise: Vec<u8> = (0..96 * 96)
        .map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        })
        .collect();
    let found = find(96, 96, &noise);
    let owned: usize = profiles(&found).expect("profiles").iter().map(|chain| chain.points().len()).sum();
    // Nodes stand for their pixels, and belong to every line that ends there.
    assert!(owned > 0 && owned < 2 * found.points.len(), "{owned} of {}", found.points.len());
}
