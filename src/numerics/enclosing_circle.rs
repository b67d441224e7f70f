//! The smallest circle around points of the plane.

use super::Vector;
use super::plane::{cross, norm, square};

/// A circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its centre.
    pub centre: Vector,
    /// Its radius.
    pub radius: f64,
}

/// The smallest circle that encloses the points: (0, 0) with radius 0 for none.
///
/// The farthest point outside joins the two or three that carry the circle, of which the smallest circle of the four is
/// found by trying; the radius grows each time. Each round is O(n); rounds are few, and never more than 1000. The
/// radius answered encloses all points whatever rounding did.
pub fn enclosing_circle(points: &[Vector]) -> Circle {
    let Some(&first) = points.first() else {
        return Circle { centre: Vector::zeros(), radius: 0.0 };
    };
    let mut carriers = vec![first];
    let mut circle = Circle { centre: first, radius: 0.0 };
    for _ in 0..1000 {
        let (far, distance) = farthest(points, circle.centre);
        if distance <= circle.radius * (1.0 + 1e-14) {
            break;
        }
        carriers.push(far);
        let Some((better, kept)) = of_few(&carriers) else { break };
        if better.radius <= circle.radius {
            break;
        }
        (circle, carriers) = (better, kept);
    }
    circle.radius = farthest(points, circle.centre).1;
    circle
}

fn farthest(points: &[Vector], from: Vector) -> (Vector, f64) {
    let mut best = (from, -1.0);
    for point in points {
        let distance = square(point - from);
        if distance > best.1 {
            best = (*point, distance);
        }
    }
    (best.0, best.1.max(0.0).sqrt())
}

/// The smallest circle of at most four points and those that carry it.
fn of_few(points: &[Vector]) -> Option<(Circle, Vec<Vector>)> {
    let mut best: Option<(Circle, Vec<Vector>)> = None;
    let mut consider = |circle: Circle, carriers: &[Vector]| {
        let holds = points.iter().all(|p| norm(p - circle.centre) <= circle.radius * (1.0 + 1e-12));
        let better = best.as_ref().is_none_or(|(other, _)| circle.radius < other.radius);
        if holds && better && circle.radius.is_finite() {
            best = Some((circle, carriers.to_vec()));
        }
    };
    for i in 0..points.len() {
        for j in 0..i {
            let centre = (points[i] + points[j]) * 0.5;
            let radius = norm(points[i] - centre).max(norm(points[j] - centre));
            consider(Circle { centre, radius }, &[points[i], points[j]]);
            for k in 0..j {
                let (u, v) = (points[j] - points[i], points[k] - points[i]);
                let twice = 2.0 * cross(u, v);
                let (a, b) = (square(u), square(v));
                let offset = Vector::new(v.y * a - u.y * b, u.x * b - v.x * a) / twice;
                consider(
                    Circle { centre: points[i] + offset, radius: norm(offset) },
                    &[points[i], points[j], points[k]],
                );
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::{Vector, enclosing_circle, norm};

    #[test]
    fn circles_hold_all_points_and_none_is_smaller() {
        let mut seed = 9_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for count in 1..60 {
            let points: Vec<Vector> = (0..count).map(|_| Vector::new(next(), 0.3 * next())).collect();
            let circle = enclosing_circle(&points);
            assert!(
                points.iter().all(|p| norm(p - circle.centre) <= circle.radius * (1.0 + 1e-12)),
                "encloses"
            );
            // Moving the centre in any direction makes some point farther: no smaller circle is near, and so none is.
            for i in 0..12 {
                let angle = f64::from(i) * core::f64::consts::FRAC_PI_6;
                let moved = circle.centre + Vector::new(libm::cos(angle), libm::sin(angle)) * 1e-4;
                let farthest = points.iter().fold(0.0_f64, |most, p| most.max(norm(p - moved)));
                assert!(farthest > circle.radius, "{count} points, direction {i}");
            }
        }
    }

    #[test]
    fn equal_points_and_points_on_a_line_have_circles() {
        let p = Vector::new(2.0, 3.0);
        assert!(enclosing_circle(&[p, p, p]).radius <= 0.0, "a point");
        let line: Vec<Vector> = (0..7).map(|i| Vector::new(f64::from(i), 2.0 * f64::from(i))).collect();
        let circle = enclosing_circle(&line);
        assert!((circle.radius - 0.5 * 180.0_f64.sqrt()).abs() < 1e-12, "half the line");
    }
}
