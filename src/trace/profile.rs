//! A profile from its chain to one curve: cusps, tubes, a spline for each, joined.

use super::agreement::agreement;
use super::metrics::Metrics;
use super::quasi_interpolant::choice::Rule;
use super::quasi_interpolant::knots::Knots;
use super::quasi_interpolant::selection::Method;
use super::samples::unit;
use super::tubes::chain::{Chain, Joint, Tube, TubeFit, fit_tube};
use super::tubes::cusps::{Cusp, CuspRule};
use crate::curve::{HermiteCurve, HermiteOptions};
use crate::error::{Error, Result};
use crate::generator::Space;
use crate::limits::{check, with_room};
use crate::numerics::order::sort_by_keys;
use crate::numerics::plane::{dot, norm};
use crate::numerics::{Point, Vector};

/// How a chain is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileOptions {
    /// The degree of the splines, 1 … 3.
    pub degree: usize,
    /// How splines are estimated and chosen.
    pub method: Method,
    /// A tube ends where the tangent has turned by more, in radians.
    pub angle: f64,
    /// How much of the chain on both sides tangents are taken from, in pixels; found from the noise if it is not given.
    pub window: Option<f64>,
    /// What a cusp is.
    pub cusps: CuspRule,
}

impl Default for ProfileOptions {
    /// Quadratic splines on placed knots, for places between pixels.
    fn default() -> Self {
        Self {
            degree: 2,
            method: Method::Placed { price: 1.2, floor: 0.02 },
            angle: 50_f64.to_radians(),
            window: None,
            cusps: CuspRule { gap: 1.6, window: 5.0, angle: 35_f64.to_radians(), reach: 1.5 },
        }
    }
}

impl ProfileOptions {
    /// The method as it was published, for centres of pixels: quadratic splines, means of neighbours, every point left
    /// out once.
    pub fn printed() -> Self {
        Self {
            method: Method::Mean(Rule::Least),
            cusps: CuspRule { gap: 0.0, window: 8.0, angle: 40_f64.to_radians(), reach: 1.5 },
            ..Self::default()
        }
    }
}

/// A chain with its cusps, tubes and splines.
#[derive(Clone, Debug)]
pub struct Profile {
    chain: Chain,
    cusps: Vec<Cusp>,
    tubes: Vec<Tube>,
    joints: Vec<[Joint; 2]>,
    fits: Vec<TubeFit>,
}

impl Chain {
    /// How much of the chain on both sides of a point says what its tangent is: 2 pixels and ten times the noise, from
    /// 3 to 8 pixels.
    pub fn window(&self) -> f64 {
        (10.0 * self.noise() + 2.0).clamp(3.0, 8.0)
    }

    /// Where a closed chain begins: at the cusp nearest to the lower left, or, without cusps, in the middle of its
    /// straightest stretch, where the tangent is known best. An open chain begins at its first point.
    pub fn start(&self, cusps: &[Cusp], window: f64) -> usize {
        if !self.is_closed() {
            return 0;
        }
        let corner = |cusp: &Cusp| cusp.point.x - cusp.point.y;
        let nearest = cusps.iter().min_by(|a, b| corner(a).total_cmp(&corner(b)));
        if let Some(cusp) = nearest {
            return cusp.index;
        }
        let bend = |i: usize| self.place(i, window).curvature.abs();
        let mut best = (f64::MAX, 0);
        for i in 0..self.points().len() {
            let bend = bend(i);
            if bend < best.0 {
                best = (bend, i);
            }
        }
        best.1
    }

    /// Follows the chain by one spline per tube: cusps, tubes, joints, splines.
    ///
    /// Splines meet at the cusps' own points, and elsewhere at the smoothed point of the chain, with its tangent: the
    /// curve is smooth there.
    ///
    /// # Domain
    ///
    /// Points in pixels, about one apart, as edges have them: windows, corners and noise are known in pixels. Scale
    /// others: a circle of 150 points is off by a thousandth of its radius at 10, by a third at 1.
    ///
    /// # Errors
    ///
    /// Options out of range.
    ///
    /// # Cost
    ///
    /// O(N·w) for N points with w of them in a window, and that of [`fit_tube`].
    ///
    /// # Source
    ///
    /// \[RB21, section 3\], with tubes along the chain (D 14.7) and ends held (D 14.9).
    pub fn follow(&self, options: &ProfileOptions) -> Result<Profile> {
        check("degree", None, options.degree as f64, 1.0, 3.0)?;
        let window = options.window.unwrap_or_else(|| self.window());
        let found = self.cusps(&options.cusps)?;
        let start = self.start(&found, window);
        let chain = self.rotated(start)?;
        let count = chain.points().len();
        let mut cusps: Vec<Cusp> =
            found.iter().map(|c| Cusp { index: (c.index + count - start) % count, ..*c }).collect();
        sort_by_keys(&mut cusps, &|cusp| [cusp.index as u64, 0]);
        let indices: Vec<usize> = cusps.iter().map(|cusp| cusp.index).collect();
        let tubes = chain.tubes(&indices, options.angle, window)?;
        let (fits, joints) = (with_room(tubes.len())?, with_room(tubes.len())?);
        let mut profile = Profile { chain, cusps, tubes, joints, fits };
        profile.join(window);
        for (tube, joints) in profile.tubes.iter().zip(&profile.joints) {
            let points = profile.chain.in_tube(tube);
            profile.fits.push(fit_tube(&points, *joints, options.degree, options.method)?);
        }
        Ok(profile)
    }

    fn rotated(&self, start: usize) -> Result<Self> {
        let mut points = with_room(self.points().len())?;
        points.extend_from_slice(&self.points()[start..]);
        points.extend_from_slice(&self.points()[..start]);
        Self::new(points, self.is_closed())
    }
}

impl Profile {
    /// The chain, from where it was begun.
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// The cusps, by index in the chain.
    pub fn cusps(&self) -> &[Cusp] {
        &self.cusps
    }

    /// The tubes in order.
    pub fn tubes(&self) -> &[Tube] {
        &self.tubes
    }

    /// Where each tube's spline begins and ends.
    pub fn joints(&self) -> &[[Joint; 2]] {
        &self.joints
    }

    /// The splines, one for each tube.
    pub fn fits(&self) -> &[TubeFit] {
        &self.fits
    }

    /// Finds the joints, and halves tubes whose ends are too steep for their tangents.
    fn join(&mut self, window: f64) {
        let mut i = 0;
        while i < self.tubes.len() {
            let tube = self.tubes[i];
            let joints = [self.joint(&tube, false, window), self.joint(&tube, true, window)];
            let along = unit(joints[1].point - joints[0].point);
            let steep = |joint: &Joint| joint.tangent.is_some_and(|tangent| dot(tangent, along) < 0.2);
            let whole = self.chain.is_closed() && tube.count > self.chain.points().len();
            if tube.count >= 3 && (whole || (tube.count >= 8 && joints.iter().any(steep))) {
                let half = tube.count / 2;
                let second = (tube.first + half) % self.chain.points().len();
                self.tubes[i] = Tube { count: half + 1, cusps: [tube.cusps[0], false], ..tube };
                let rest = Tube { first: second, count: tube.count - half, cusps: [false, tube.cusps[1]] };
                self.tubes.insert(i + 1, rest);
            } else {
                self.joints.push(joints);
                i += 1;
            }
        }
    }

    /// The joint at a tube's start or end.
    fn joint(&self, tube: &Tube, last: bool, window: f64) -> Joint {
        let count = self.chain.points().len();
        let index = if last { (tube.first + tube.count - 1) % count } else { tube.first };
        if !tube.cusps[usize::from(last)] {
            let place = self.chain.joint(index, window);
            return Joint { point: place.point, tangent: Some(place.tangent) };
        }
        let cusp = self.cusps.binary_search_by_key(&index, |cusp| cusp.index);
        let point = cusp.map_or(self.chain.points()[index], |i| self.cusps[i].point);
        Joint { point, tangent: None }
    }

    /// All splines as one curve, piece by piece and exactly.
    ///
    /// # Errors
    ///
    /// A chain so short that there is no curve.
    pub fn curve(&self) -> Result<HermiteCurve> {
        let mut data = HermiteOptions {
            closed: self.chain.is_closed(),
            space: Some(Space::Polynomial),
            ..HermiteOptions::default()
        };
        let mut arriving = Vector::zeros();
        let mut end = Point::zeros();
        for fit in &self.fits {
            for piece in fit.bezier()? {
                let degree = (piece.len() - 1) as f64;
                if norm(piece[piece.len() - 1] - piece[0]) < 1e-9 {
                    continue;
                }
                data.points.push(piece[0]);
                data.tangents.push((piece[1] - piece[0]) * degree);
                data.tangents_in.push(arriving);
                end = piece[piece.len() - 1];
                arriving = (end - piece[piece.len() - 2]) * degree;
            }
        }
        if data.points.len() < 2 {
            return polygon(&self.chain);
        }
        if data.closed {
            if let Some(first) = data.tangents_in.first_mut() {
                *first = arriving;
            }
        } else {
            data.points.push(end);
            data.tangents.push(arriving);
            data.tangents_in.push(arriving);
            if let (Some(first), Some(leaving)) = (data.tangents_in.first_mut(), data.tangents.first()) {
                *first = *leaving;
            }
        }
        HermiteCurve::new(data)
    }

    /// How far the curve is from the chain, in the unit of the points.
    ///
    /// # Errors
    ///
    /// As [`Profile::curve`].
    pub fn metrics(&self) -> Result<Metrics> {
        agreement(&self.curve()?, self.chain.points())
    }
}

/// A chain of a few points that are smoothed into one: straight from point to point.
fn polygon(chain: &Chain) -> Result<HermiteCurve> {
    let (points, closed) = (chain.points().to_vec(), chain.is_closed());
    let count = points.len();
    let way = |from: usize, to: usize| points[to] - points[from];
    let leaving = |i: usize| if i + 1 < count || closed { way(i, (i + 1) % count) } else { way(i - 1, i) };
    let arriving = |i: usize| if i > 0 || closed { way((i + count - 1) % count, i) } else { way(0, 1) };
    let tangents = (0..count).map(leaving).collect();
    let tangents_in = (0..count).map(arriving).collect();
    HermiteCurve::new(HermiteOptions {
        closed,
        space: Some(Space::Polynomial),
        tangents,
        tangents_in,
        points,
        ..HermiteOptions::default()
    })
}

impl TubeFit {
    /// The control points of each polynomial piece, as Bézier curves; a line has one piece of two points.
    ///
    /// # Errors
    ///
    /// Control points of another number than the knots ask for; where the allocator says no.
    pub fn pieces(&self) -> Result<Vec<Vec<Point>>> {
        if let Some(needed) = self.knots.as_ref().map(Knots::count)
            && needed != self.control.len()
        {
            return Err(Error::wrong_length("control", self.control.len(), needed));
        }
        self.bezier()
    }

    /// The same where as many control points as the knots ask for are known to be there.
    fn bezier(&self) -> Result<Vec<Vec<Point>>> {
        let Some(knots) = &self.knots else {
            return Ok(vec![self.control.clone()]);
        };
        let degree = knots.degree();
        let x: Vec<f64> = self.control.iter().map(|p| p.x).collect();
        let y: Vec<f64> = self.control.iter().map(|p| p.y).collect();
        let mut pieces = with_room(knots.piece_count())?;
        for piece in 0..knots.piece_count() {
            let (start, end) = knots.ends(piece);
            let mut places = vec![start; degree];
            let mut points = with_room(degree + 1)?;
            for r in 0..=degree {
                if r > 0 {
                    places[degree - r] = end;
                }
                points.push(Point::new(knots.blossom(&x, piece, &places), knots.blossom(&y, piece, &places)));
            }
            pieces.push(points);
        }
        Ok(pieces)
    }
}
