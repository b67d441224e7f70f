//! A curve as the measures see it: one smooth piece after another.

use super::HermiteCurve;
use super::any_roots::{ANY_ROOTS, OfAnyRoots, of_any_roots};
use super::piece::{HERMITE, Piece};
use super::space_piece::{SpacePiece, Triple};
use super::spline_curve::lattice::Place;
use super::spline_curve::{Generator, SplineCurve};
use crate::error::Result;
use crate::generator::Roots;
use crate::numerics::{Point, Vector};

/// The pieces that a curve consists of; every kind of curve gives them in its own way.
///
/// Derivatives here are by a piece's own x, from 0 to 1.
pub trait Pieces {
    /// 2 or 3.
    fn coordinate_count(&self) -> usize;

    /// Whether the end is joined to the start.
    fn closed(&self) -> bool;

    /// How many pieces there are.
    fn piece_count(&self) -> usize;

    /// The parameter where piece i starts; that of the end for i = `piece_count`.
    fn knot(&self, i: usize) -> f64;

    /// How much of the parameter piece i takes. Far from 0 the difference of its knots would be of their roundings.
    fn span(&self, i: usize) -> f64 {
        self.knot(i + 1) - self.knot(i)
    }

    /// The coefficients of ascending powers of y = x − 1/2 on piece i, all coordinates of each in turn. Not for kinds
    /// whose pieces have another closed form.
    fn coefficients(&self, i: usize, out: &mut Vec<f64>);

    /// Points or derivatives by t at all parameters, all coordinates in turn, with every check.
    fn values(&self, t: &[f64], derivative: usize, out: &mut [f64]) -> Result<()>;

    /// The curve itself where it is a Hermite curve.
    fn as_hermite(&self) -> Option<&HermiteCurve> {
        None
    }

    /// The roots per unit of t, where the pieces are all that they stand for.
    fn roots(&self) -> Option<&Roots> {
        None
    }

    /// The piece that t lies on, and the x there.
    fn find(&self, t: f64) -> Result<(usize, f64)>;

    /// Piece i of a plane curve.
    fn piece(&self, i: usize) -> Piece {
        Piece::polynomial(&list(&|out| self.coefficients(i, out)))
    }

    /// The point where piece i starts, or the end, to the last bit.
    fn start_into(&self, i: usize, out: &mut [f64]) -> Result<()> {
        self.values(&[self.knot(i)], 0, out)
    }

    /// The point of a plane curve where piece i starts, or the end.
    fn start(&self, i: usize) -> Point {
        let mut point = Point::zeros();
        match self.start_into(i, point.as_mut_slice()) {
            Ok(()) => point,
            // A knot that is a rounding outside the domain.
            Err(_) => self.piece(i.min(self.piece_count() - 1)).position(if i == 0 { -0.5 } else { 0.5 }),
        }
    }

    /// The derivatives at both ends of piece i of a plane curve.
    fn tangents(&self, i: usize) -> [Vector; 2] {
        let piece = self.piece(i);
        [piece.jet(-0.5).first, piece.jet(0.5).first]
    }

    /// Two points that with the ends of piece i of a plane curve make a box that holds it.
    fn handles(&self, i: usize) -> [Point; 2] {
        self.piece(i).corners()
    }
}

/// Whether a curve is in space; Hermite curves are not.
#[inline(always)]
pub(crate) fn in_space(curve: &dyn Pieces) -> bool {
    ANY_ROOTS && curve.coordinate_count() == 3
}

/// The curve itself where it is a Hermite curve.
#[inline(always)]
pub(super) fn hermite(curve: &dyn Pieces) -> Option<&HermiteCurve> {
    if HERMITE { curve.as_hermite() } else { None }
}

fn list(fill: &dyn Fn(&mut Vec<f64>)) -> Vec<f64> {
    let mut numbers = Vec::new();
    fill(&mut numbers);
    numbers
}

/// Piece i of a curve in space.
pub(super) fn space_piece(curve: &dyn Pieces, i: usize) -> SpacePiece {
    SpacePiece::polynomial(&list(&|out| curve.coefficients(i, out)))
}

/// The point where piece i of a curve in space starts, to the last bit.
pub(super) fn space_start(curve: &dyn Pieces, i: usize) -> Result<Triple> {
    let mut point = [0.0; 3];
    curve.start_into(i, &mut point)?;
    Ok(point)
}

impl Pieces for HermiteCurve {
    fn coordinate_count(&self) -> usize {
        2
    }

    fn closed(&self) -> bool {
        self.is_closed()
    }

    fn piece_count(&self) -> usize {
        self.segment_count()
    }

    fn knot(&self, i: usize) -> f64 {
        self.knots()[i]
    }

    fn coefficients(&self, _: usize, _: &mut Vec<f64>) {}

    fn values(&self, t: &[f64], derivative: usize, out: &mut [f64]) -> Result<()> {
        self.evaluate_into(t, derivative, out)
    }

    fn find(&self, t: f64) -> Result<(usize, f64)> {
        self.locate(t)
    }

    fn as_hermite(&self) -> Option<&HermiteCurve> {
        Some(self)
    }

    fn piece(&self, i: usize) -> Piece {
        Piece::new(&self.nth_segment(i))
    }

    fn start(&self, i: usize) -> Point {
        self.points()[if i < self.points().len() { i } else { 0 }]
    }

    fn tangents(&self, i: usize) -> [Vector; 2] {
        let segment = self.nth_segment(i);
        [segment.leaving * segment.length, segment.arriving * segment.length]
    }

    fn handles(&self, i: usize) -> [Point; 2] {
        self.nth_segment(i).inner_points()
    }
}

impl<G: Generator> Pieces for SplineCurve<G> {
    fn coordinate_count(&self) -> usize {
        self.lattice.dimension
    }

    fn closed(&self) -> bool {
        self.lattice.closed
    }

    fn piece_count(&self) -> usize {
        self.lattice.piece_count()
    }

    fn knot(&self, i: usize) -> f64 {
        self.lattice.knot(i)
    }

    fn span(&self, _: usize) -> f64 {
        self.lattice.span()
    }

    fn start_into(&self, i: usize, out: &mut [f64]) -> Result<()> {
        self.lattice.start_into(i, out);
        Ok(())
    }

    fn coefficients(&self, i: usize, out: &mut Vec<f64>) {
        self.lattice.piece_into(i, out);
    }

    fn values(&self, t: &[f64], derivative: usize, out: &mut [f64]) -> Result<()> {
        self.lattice.evaluate_into(t, derivative, out)
    }

    fn roots(&self) -> Option<&Roots> {
        Some(self.generator.list())
    }

    fn find(&self, t: f64) -> Result<(usize, f64)> {
        let Place { cell, part, y } = self.lattice.locate(t, None)?;
        Ok((cell * self.lattice.shape.per_cell + part, y + 0.5))
    }
}

/// A piece of a curve of either dimension, for measures that look at speeds only. Where no curve is in space, no piece
/// is, and what measures them is left out.
pub(super) enum AnyPiece {
    Plane(Piece),
    Space(OfAnyRoots<SpacePiece>),
}

impl AnyPiece {
    pub(super) fn new(curve: &dyn Pieces, i: usize) -> Self {
        let in_space = if in_space(curve) { of_any_roots(space_piece(curve, i)) } else { None };
        in_space.map_or_else(|| Self::Plane(curve.piece(i)), Self::Space)
    }

    /// The speed at y.
    pub(super) fn speed(&self, y: f64) -> f64 {
        match self {
            Self::Plane(piece) => crate::numerics::plane::norm(piece.jet(y).first),
            Self::Space(piece) => piece.speed(y),
        }
    }

    /// The length from lo to hi, within a tolerance.
    pub(super) fn length(&self, lo: f64, hi: f64, tolerance: f64) -> f64 {
        match self {
            Self::Plane(piece) => super::speed::piece_length(piece, lo, hi, tolerance),
            Self::Space(piece) => piece.length(lo, hi, tolerance),
        }
    }
}

#[cfg(test)]
mod tests;
