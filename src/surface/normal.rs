//! Normals, at poles and other places where the partial derivatives say nothing too.

use super::layer::Scratch;
use super::tensor::TensorSurface;
use crate::error::{Error, Result};
use crate::numerics::Vector3;

/// ∂ᵤσ × ∂ᵥσ counts where it is not smaller than this part of its own derivatives: closer to a degenerate place the
/// limit is taken. The limit is wrong by at most this part there, the product's rounding (1e-16) is the same part of
/// it.
const NEAR: f64 = 1e-8;
/// Derivatives below this part of the coordinates that they are made of are rounding, coordinate by coordinate: what
/// is thin in one direction is judged by itself, not by how long it is in another.
const NOTHING: f64 = 1e-13;
/// Rounding is a hundredth of that: of a longer product the sense is right, if not the direction.
const SENSE: f64 = 0.01;
/// Where not even that is known, a place that is so near to the last end sees its pole from the inside.
const LAST: f64 = 1e-6;
/// How far off, in units of the parameter, a place without first and second derivatives looks for its neighbours.
const STEP: f64 = 1e-3;

/// First and second derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Jet {
    pub(super) u: Vector3,
    pub(super) v: Vector3,
    pub(super) uu: Vector3,
    pub(super) uv: Vector3,
    pub(super) vv: Vector3,
}

/// Each coordinate without its sign.
fn sizes(a: &Vector3) -> Vector3 {
    Vector3::new(a.x.abs(), a.y.abs(), a.z.abs())
}

/// How much of a × b may be rounding where derivatives as large as `of_a` and `of_b` may be made of it.
pub(super) fn rounding([a, b]: [&Vector3; 2], [of_a, of_b]: [&Vector3; 2]) -> f64 {
    let ([a, b], [p, q]) = ([sizes(a), sizes(b)], [of_a, of_b]);
    let sum = Vector3::new(
        p.y * b.z + p.z * b.y + a.y * q.z + a.z * q.y,
        p.z * b.x + p.x * b.z + a.z * q.x + a.x * q.z,
        p.x * b.y + p.y * b.x + a.x * q.y + a.y * q.x,
    );
    NOTHING * sum.norm()
}

impl Jet {
    /// The sum of two.
    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            u: self.u + other.u,
            v: self.v + other.v,
            uu: self.uu + other.uu,
            uv: self.uv + other.uv,
            vv: self.vv + other.vv,
        }
    }

    /// ∂ᵤσ × ∂ᵥσ and how much of it may be rounding; `most` is how large the derivatives may be.
    fn product(&self, most: &Self) -> (Vector3, f64) {
        (self.u.cross(&self.v), rounding([&self.u, &self.v], [&most.u, &most.v]))
    }

    /// The same of its derivative along u.
    fn growth(&self, most: &Self) -> (Vector3, f64) {
        let (first, second) = (self.uu.cross(&self.v), self.u.cross(&self.uv));
        let less = rounding([&self.uu, &self.v], [&most.uu, &most.v]);
        (first + second, less + rounding([&self.u, &self.uv], [&most.u, &most.uv]))
    }

    /// The jet with u and v in each other's place: its products have the other sign.
    fn turned(&self) -> Self {
        Self { u: self.v, v: self.u, uu: self.vv, uv: self.uv, vv: self.uu }
    }

    /// Whether ∂ᵤσ × ∂ᵥσ is more than rounding.
    pub(super) fn is_regular(&self, most: &Self) -> bool {
        let (product, less) = self.product(most);
        product.norm() > less
    }
}

/// Whether a derivative is nothing but rounding.
pub(super) fn is_nothing(derivative: &Vector3, most: &Vector3) -> bool {
    derivative.iter().zip(most.iter()).all(|(x, most)| x.abs() <= NOTHING * most)
}

impl TensorSurface {
    pub(super) fn jet(&self, u: f64, v: f64, scratch: &mut Scratch) -> Jet {
        let mut at = |order| Vector3::from(self.value(u, v, order, scratch));
        Jet { u: at((1, 0)), v: at((0, 1)), uu: at((2, 0)), uv: at((1, 1)), vv: at((0, 2)) }
    }

    /// The unit normal at parameters that were checked, or 0 where there is none.
    ///
    /// Where ∂ᵤσ × ∂ᵥσ vanishes, the normal is its limit from inside the domain: the direction in which it grows
    /// (D 11.3).
    pub(super) fn normal_at(&self, u: f64, v: f64, scratch: &mut Scratch) -> Vector3 {
        let (jet, most) = (self.jet(u, v, scratch), self.most_at(u, v));
        let (here, least) = jet.product(&most);
        let (along_u, least_u) = jet.growth(&most);
        let (along_v, least_v) = jet.turned().growth(&most.turned());
        let [end_u, end_v] = self.domain();
        let [closed_u, closed_v] = self.directions().map(|direction| direction.closed);
        let by_u = along_u.norm_squared() > along_v.norm_squared();
        let (grows, doubt, t, end, closed) = if by_u {
            (along_u, least_u, u, end_u, closed_u)
        } else {
            (-along_v, least_v, v, end_v, closed_v)
        };
        let (length, growth) = (here.norm(), grows.norm());
        // What does not point to where it grows comes from no degenerate place beside this one.
        let aside = (here - grows * (here.dot(&grows) / (growth * growth))).norm();
        if length > least && (growth <= doubt || length >= NEAR * growth || aside > least) {
            return here / length;
        }
        if growth > doubt {
            // What is there of the product, be it ever so short, has the right sense; at the place itself the inside
            // has.
            let backwards = if length > SENSE * least {
                here.dot(&grows) < 0.0
            } else {
                !closed && t > (1.0 - LAST) * end
            };
            return if backwards { -grows / growth } else { grows / growth };
        }
        // Neither derivative says anything: the neighbours' mean.
        let (mut sum, mut least) = (Vector3::zeros(), 0.0);
        for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let near = |t: f64, s: f64, end: f64, closed: bool| {
                if closed { t + s * STEP } else { (t + s * STEP).max(0.0).min(end) }
            };
            let place = (near(u, a, end_u, closed_u), near(v, b, end_v, closed_v));
            let (product, doubt) = self.jet(place.0, place.1, scratch).product(&most);
            (sum, least) = (sum + product, least + doubt);
        }
        let length = sum.norm();
        if length > least { sum / length } else { Vector3::zeros() }
    }

    /// Unit normals at pairs of parameters, three numbers each: ∂ᵤσ × ∂ᵥσ, and its limit at poles and other places
    /// where it vanishes. Where the surface has none — all points equal, or on a line — the three numbers are 0.
    ///
    /// # Accuracy
    ///
    /// 1e-13; on what is r times as thin as it is long 1e-16/r, to r = 1e-12, and 1e-7 within 1e-7 of a pole
    /// (`tests/surface/shape.rs`).
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::evaluate_into`].
    pub fn normals_into(&self, u: &[f64], v: &[f64], out: &mut [f64]) -> Result<()> {
        self.at_each(u, v, out, &|u, v, scratch| self.normal_at(u, v, scratch).into())
    }

    /// The unit normal at (u, v), or nothing where the surface has none.
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::evaluate`].
    pub fn normal(&self, u: f64, v: f64) -> Result<Option<Vector3>> {
        let mut out = [0.0; 3];
        self.normals_into(&[u], &[v], &mut out).map_err(Error::of_one)?;
        Ok((out != [0.0; 3]).then(|| Vector3::from(out)))
    }
}
