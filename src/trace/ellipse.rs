//! Whole outlines that are ellipses.

use super::outline::Outline;
use crate::curve::{EllipseArc, HermiteCurve};
use crate::error::Result;
use crate::numerics::plane::{cross, dot};
use crate::numerics::{Point, Vector};

/// How far an outline may be from its ellipse, in pixels.
const MOST: f64 = 0.045;

/// And its root mean square.
const RMS: f64 = 0.015;

/// Places on each piece: chords of a quarter turn lack 3e-6 of the area.
const PLACES: usize = 256;

/// The ellipse with the area, the centre and the second moments of the outline, as a curve that turns the same way, if the outline is it.
///
/// Moments are means over all that is inside: they are far better known than any one point of the outline (D 14.6).
pub(super) fn ellipse(outline: &Outline) -> Result<Option<HermiteCurve>> {
    let smooth = (0..outline.len()).all(|i| outline.nodes[i].smooth && !outline.is_line(i));
    if !smooth {
        return Ok(None);
    }
    let mut places = Vec::with_capacity(PLACES * outline.len());
    for i in 0..outline.len() {
        let cubic = outline.cubic(i);
        places.extend((0..PLACES).map(|k| cubic.point(k as f64 / PLACES as f64)));
    }
    let Some((arc, area)) = moments(&places) else { return Ok(None) };
    let mut square = 0.0;
    let mut offs = places.iter().map(|&p| {
        // To first order the distance is the value of the ellipse's equation over its gradient.
        let (sin, cos) = crate::numerics::angle::sin_cos(arc.rotation);
        let off = p - arc.center;
        let (x, y) = (dot(off, Vector::new(cos, sin)), cross(Vector::new(cos, sin), off));
        let (u, v) = (x / arc.radii.x, y / arc.radii.y);
        let gradient = ((u / arc.radii.x) * (u / arc.radii.x) + (v / arc.radii.y) * (v / arc.radii.y)).sqrt();
        let distance = (0.5 * (u * u + v * v - 1.0)).abs() / gradient;
        square += distance * distance;
        distance
    });
    let near = offs.all(|distance| distance <= MOST);
    if !near || square > RMS * RMS * places.len() as f64 {
        return Ok(None);
    }
    let curve = HermiteCurve::ellipse(arc.center, arc.radii, arc.rotation, 2)?;
    Ok(Some(if area < 0.0 { curve.reversed() } else { curve }))
}

/// The ellipse with the moments of a polygon, and the polygon's area. Half axes that differ by less than a hundredth of a pixel are one radius.
fn moments(places: &[Point]) -> Option<(EllipseArc, f64)> {
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
    if long - short < 0.02 {
        (long, short) = (0.5 * (long + short), 0.5 * (long + short));
        rotation = 0.0;
    }
    let radii = Vector::new(long, short);
    let arc =
        EllipseArc { center: origin + middle, radii, rotation, start: 0.0, sweep: core::f64::consts::TAU };
    Some((arc, area))
}
