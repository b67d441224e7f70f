//! Whole outlines that are ellipses.

use super::{Node, Outline, Piece};
use crate::curve::{EllipseArc, HermiteCurve};
use crate::error::Result;
use crate::numerics::plane::{cross, dot};
use crate::numerics::{Point, Vector};

/// How far an outline may be from its ellipse, in pixels.
const MOST: f64 = 0.045;

/// And its root mean square.
const RMS: f64 = 0.015;

/// No outline may be farther from its ellipse than so many times that, and so much more for each pixel of its longer
/// half axis.
const FREE: f64 = 4.0;
const LARGER: f64 = 0.035;

/// What the places next to a tip may lack of it, in pixels.
const TIP: f64 = 0.3;

/// How much less than this half axes differ that are one radius, in pixels.
const EVEN: f64 = 0.02;

/// Places on each piece: chords of a quarter turn lack 3e-6 of the area.
const PLACES: usize = 256;

/// The ellipse with the area, the centre and the second moments of the outline, as a curve that turns the same way, if
/// the outline is it. `slack` is how many times farther away than in a clean picture it may be.
///
/// Moments are means over all that is inside: they are far better known than any one point of the outline (D 14.6).
pub(in crate::trace) fn ellipse(outline: &Outline, slack: f64) -> Result<Option<HermiteCurve>> {
    let Some(places) = places_on(outline) else { return Ok(None) };
    let Some((arc, area)) = moments(&places, slack * EVEN) else { return Ok(None) };
    let slack = slack.min(FREE + LARGER * arc.radii.x);
    if !is_near(&arc, &places, slack * MOST, slack * RMS) {
        return Ok(None);
    }
    let curve = HermiteCurve::ellipse(arc.center, arc.radii, arc.rotation, 2)?;
    Ok(Some(if area < 0.0 { curve.reversed() } else { curve }))
}

/// Places on an outline without corners and lines.
fn places_on(outline: &Outline) -> Option<Vec<Point>> {
    let smooth = (0..outline.len()).all(|i| outline.nodes[i].smooth && !outline.is_line(i));
    let mut places = Vec::with_capacity(if smooth { PLACES * outline.len() } else { 0 });
    for cubic in (0..outline.len()).filter(|_| smooth).map(|i| outline.cubic(i)) {
        places.extend((0..PLACES).map(|k| cubic.point(k as f64 / PLACES as f64)));
    }
    smooth.then_some(places)
}

/// The ellipse that an outline is nowhere farther from than `most`.
pub(in crate::trace) fn rounded(outline: &Outline, most: f64) -> Option<Outline> {
    round(&places_on(outline)?, most)
}

/// A first outline for places that are nowhere farther than `most` from an ellipse.
pub(in crate::trace) fn round(places: &[Point], most: f64) -> Option<Outline> {
    let (arc, area) = moments(places, EVEN)?;
    if !is_near(&arc, places, most, 0.4 * most) {
        return None;
    }
    // The cubic of a quarter turn is off by 3e-4 of the radius, that of an eighth by 4e-6.
    let count = if arc.radii.x > 24.0 { 8 } else { 4 };
    let step = area.signum() * core::f64::consts::TAU / count as f64;
    let handle = 4.0 / 3.0 * tangent(0.25 * step);
    let (sin, cos) = crate::numerics::angle::sin_cos(arc.rotation);
    let place = |x: f64, y: f64| {
        let (x, y) = (x * arc.radii.x, y * arc.radii.y);
        Vector::new(x * cos - y * sin, x * sin + y * cos)
    };
    let mut outline = Outline::default();
    for i in 0..count {
        let (sin, cos) = crate::numerics::angle::sin_cos(step * i as f64);
        let (after_sin, after_cos) = crate::numerics::angle::sin_cos(step * (i + 1) as f64);
        let (leaving, arriving) = (place(-sin, cos) * handle, place(-after_sin, after_cos) * handle);
        let node = Node { point: arc.center + place(cos, sin), smooth: true, kept: false };
        outline.push(node, Piece::Cubic { leaving, arriving });
    }
    Some(outline)
}

fn tangent(angle: f64) -> f64 {
    let (sin, cos) = crate::numerics::angle::sin_cos(angle);
    sin / cos
}

/// Whether no place is farther from an ellipse than `most`, and the root mean square than `rms`; and whether they go
/// all round it.
fn is_near(arc: &EllipseArc, places: &[Point], most: f64, rms: f64) -> bool {
    let (sin, cos) = crate::numerics::angle::sin_cos(arc.rotation);
    let (mut square, mut reach) = (0.0, 0.0_f64);
    let near = places.iter().all(|&p| {
        // To first order the distance is the value of the ellipse's equation over its gradient.
        let off = p - arc.center;
        let (x, y) = (dot(off, Vector::new(cos, sin)), cross(Vector::new(cos, sin), off));
        let (u, v) = (x / arc.radii.x, y / arc.radii.y);
        let gradient = ((u / arc.radii.x) * (u / arc.radii.x) + (v / arc.radii.y) * (v / arc.radii.y)).sqrt();
        let distance = (0.5 * (u * u + v * v - 1.0)).abs() / gradient;
        square += distance * distance;
        reach = reach.max(x.abs());
        distance <= most
    });
    // A thin strip is near a thin ellipse that goes on beyond its ends.
    near && arc.radii.x - reach <= most + TIP && square <= rms * rms * places.len() as f64
}

/// The ellipse with the moments of a polygon, and the polygon's area. Half axes that differ by less than `even` pixels
/// are one radius.
fn moments(places: &[Point], even: f64) -> Option<(EllipseArc, f64)> {
    let origin = places[0];
    let (mut area, mut first) = (0.0, Vector::zeros());
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for (i, &p) in places.iter().enumerate() {
        let (p, q) = (p - origin, places[if i + 1 == places.len() { 0 } else { i + 1 }] - origin);
        let part = 0.5 * cross(p, q);
        area += part;
        first += (p + q) * (part / 3.0);
        xx += part * (p.x * p.x + p.x * q.x + q.x * q.x) / 6.0;
        yy += part * (p.y * p.y + p.y * q.y + q.y * q.y) / 6.0;
        xy += part * (2.0 * p.x * p.y + p.x * q.y + q.x * p.y + 2.0 * q.x * q.y) / 12.0;
    }
    if area.abs() < 3.0 {
        return None;
    }
    let middle = first / area;
    let (xx, yy, xy) =
        (xx / area - middle.x * middle.x, yy / area - middle.y * middle.y, xy / area - middle.x * middle.y);
    // A quarter of the squared half axes are the moments along them.
    let (mean, gap) = (0.5 * (xx + yy), (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt());
    if mean - gap <= 0.0 {
        return None;
    }
    let (mut long, mut short) = (2.0 * (mean + gap).sqrt(), 2.0 * (mean - gap).sqrt());
    let mut rotation = 0.5 * libm::atan2(2.0 * xy, xx - yy);
    if long - short < even {
        (long, short) = (0.5 * (long + short), 0.5 * (long + short));
        rotation = 0.0;
    }
    let radii = Vector::new(long, short);
    let arc =
        EllipseArc { center: origin + middle, radii, rotation, start: 0.0, sweep: core::f64::consts::TAU };
    Some((arc, area))
}
