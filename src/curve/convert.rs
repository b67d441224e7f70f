//! Curves of other kinds as Hermite curves: exactly where the roots allow it, else as cubics within a tolerance.

use super::hermite::{HermiteCurve, HermiteOptions};
use super::measures::cubics::to_cubics;
use super::pieces::{Pieces, hermite, in_space};
use crate::error::{Error, Result};
use crate::generator::{Roots, Space};
use crate::limits::{LARGEST_COORDINATE, LEAST_LENGTH, with_room};
use crate::numerics::{Point, Vector};

/// Tangents are below 2⁶⁵·1e9: six coordinates of 1e9 in the least step of 1e-12, cut into four million cubics.
const MOST_DOUBLINGS: usize = 65;

/// The space and the frequency of Hermite curves that hold everything these roots stand for.
///
/// That is so for 0 up to twice and one pair ±iω or ±k, and for 0 up to four times (D 10.4).
fn space_of(roots: &Roots) -> Option<(Space, f64)> {
    let (mut zeros, mut space, mut omega) = (0, Space::Polynomial, 0.0);
    for root in roots.as_slice() {
        let (kind, size) = match (root.re, root.im) {
            (0.0, 0.0) => {
                zeros += 1;
                continue;
            }
            (0.0, im) => (Space::Trigonometric, im.abs()),
            (re, 0.0) => (Space::Hyperbolic, re.abs()),
            _ => return None,
        };
        if space != Space::Polynomial && (space, omega) != (kind, size) {
            return None;
        }
        (space, omega) = (kind, size);
    }
    let pairs = roots.order() - zeros;
    let fits = if space == Space::Polynomial { zeros <= 4 } else { zeros <= 2 && pairs <= 2 };
    fits.then_some((space, omega))
}

pub(crate) fn to_hermite(curve: &dyn Pieces, tolerance: f64) -> Result<(HermiteCurve, f64)> {
    if let Some(curve) = hermite(curve) {
        return Ok((curve.clone(), 0.0));
    }
    if in_space(curve) {
        return Err(Error::degenerate("curve", None, "a curve in space is no curve of the plane"));
    }
    match curve.roots().and_then(space_of) {
        Some((space, omega)) => Ok((exactly(curve, space, omega)?, 0.0)),
        None => by_cubics(curve, tolerance),
    }
}

/// One segment for each piece.
fn exactly(curve: &dyn Pieces, space: Space, omega: f64) -> Result<HermiteCurve> {
    let mut parts = Parts::new(curve, space, curve.piece_count())?;
    parts.data.omega = vec![omega];
    for i in 0..curve.piece_count() {
        let length = curve.span(i);
        let [leaving, arriving] = curve.tangents(i);
        parts.push(curve.start(i), leaving / length, arriving / length, length);
    }
    parts.finish(curve)
}

fn by_cubics(curve: &dyn Pieces, tolerance: f64) -> Result<(HermiteCurve, f64)> {
    let cubics = to_cubics(curve, tolerance)?;
    let count = cubics.path.len() / 8;
    let mut parts = Parts::new(curve, Space::Polynomial, count)?;
    let mut next = 0;
    for i in 0..curve.piece_count() {
        let until = cubics.first.get(i + 1).map_or(count, |&first| first as usize);
        let length = curve.span(i) / (until - next).max(1) as f64;
        for cubic in cubics.path[8 * next..8 * until].chunks_exact(8) {
            let at = |k: usize| Point::new(cubic[2 * k], cubic[2 * k + 1]);
            let scale = 3.0 / length;
            parts.push(at(0), (at(1) - at(0)) * scale, (at(3) - at(2)) * scale, length);
        }
        next = until;
    }
    Ok((parts.finish(curve)?, cubics.deviation))
}

/// A Hermite curve that is put together segment by segment.
struct Parts {
    data: HermiteOptions,
    arriving: Vector,
}

impl Parts {
    fn new(curve: &dyn Pieces, space: Space, count: usize) -> Result<Self> {
        let (points, tangents) = (with_room(count + 1)?, with_room(count + 1)?);
        let (tangents_in, lengths) = (with_room(count + 1)?, with_room(count)?);
        let (closed, space, omega) = (curve.closed(), Some(space), Vec::new());
        let data = HermiteOptions { points, tangents, tangents_in, closed, space, omega, lengths };
        Ok(Self { data, arriving: Vector::zeros() })
    }

    #[inline(never)]
    fn push(&mut self, start: Point, leaving: Vector, arriving: Vector, length: f64) {
        self.data.points.push(start);
        self.data.tangents.push(leaving);
        // Derivatives on both sides of a smooth point differ by roundings; one of them serves both.
        let before =
            if (self.arriving - leaving).norm() <= 1e-12 * leaving.norm() { leaving } else { self.arriving };
        self.data.tangents_in.push(before);
        self.data.lengths.push(length);
        self.arriving = arriving;
    }

    #[inline(never)]
    fn finish(mut self, curve: &dyn Pieces) -> Result<HermiteCurve> {
        if curve.closed() {
            let first = self.data.tangents[0];
            let same = (self.arriving - first).norm() <= 1e-12 * first.norm();
            self.data.tangents_in[0] = if same { first } else { self.arriving };
        } else {
            self.data.tangents_in[0] = self.data.tangents[0];
            self.data.points.push(curve.start(curve.piece_count()));
            self.data.tangents.push(self.arriving);
            self.data.tangents_in.push(self.arriving);
        }
        self.slow_down();
        HermiteCurve::new(self.data)
    }

    /// Makes the parameter run slower by a power of 2, which changes no bit of the shape, where Hermite curves cannot
    /// have so large tangents or so short segments.
    fn slow_down(&mut self) {
        let data = &mut self.data;
        let sides = data.tangents.iter().chain(&data.tangents_in);
        let fastest = sides.fold(0.0, |most: f64, v| most.max(v.x.abs()).max(v.y.abs()));
        let shortest = data.lengths.iter().fold(f64::INFINITY, |least: f64, &length| least.min(length));
        let mut factor = 1.0;
        for _ in 0..MOST_DOUBLINGS {
            if fastest > LARGEST_COORDINATE * factor || shortest * factor < LEAST_LENGTH {
                factor *= 2.0;
            }
        }
        for tangent in data.tangents.iter_mut().chain(&mut data.tangents_in) {
            *tangent /= factor;
        }
        data.omega.iter_mut().for_each(|omega| *omega /= factor);
        data.lengths.iter_mut().for_each(|length| *length *= factor);
    }
}
