//! How large the part of a surface is that a place sees: what rounding and degenerate places are judged by.

use super::layer::Layer;
use super::normal::Jet;
use super::tensor::TensorSurface;
use crate::numerics::Vector3;

/// Points closer together than this part of their distance from the origin count as one: weights leave 1e-16 of that
/// distance in derivatives, and products of two of them must stay below the part of the size that counts.
const FARTHEST: f64 = 1e-8;

impl Layer {
    /// The smallest and largest numbers of the points in so many rows and columns from a place on.
    #[inline(never)]
    pub(super) fn bounds(&self, from: [usize; 2], count: [usize; 2]) -> [Vector3; 2] {
        let (mut least, mut most) = (Vector3::repeat(f64::MAX), Vector3::repeat(f64::MIN));
        for a in 0..count[0] {
            let Some(i) = self.rows.position(&self.u, self.u.row(from[0] + a)) else { continue };
            for b in 0..count[1] {
                let Some(j) = self.columns.position(&self.v, self.v.row(from[1] + b)) else { continue };
                for (k, &x) in self.point(i, j).iter().enumerate().take(3) {
                    (least[k], most[k]) = (least[k].min(x), most[k].max(x));
                }
            }
        }
        [least, most]
    }

    /// Half the diagonal of the box of those points, and not less than rounding makes of points that are one. It does
    /// not fall when points are added; 0 where the layer has none there.
    fn size(&self, from: [usize; 2], count: [usize; 2]) -> f64 {
        let [least, most] = self.bounds(from, count);
        if least[0] > most[0] {
            return 0.0;
        }
        let far = most.max().max(-least.min());
        (0.5 * (most - least)).norm().max(FARTHEST * far)
    }

    /// The first places, in u and in v, that weigh on a place.
    fn seen(&self, u: f64, v: f64) -> [usize; 2] {
        [self.u.nearest_place(u).interval, self.v.nearest_place(v).interval]
    }

    /// How large derivatives can be that are made of those points, coordinate by coordinate: what their rounding is a
    /// part of.
    fn most(&self, from: [usize; 2], count: [usize; 2]) -> Jet {
        let [least, most] = self.bounds(from, count);
        let far = Vector3::from_fn(|k, _| most[k].max(-least[k]).max(0.0));
        let (u, v) = (self.u.scale, self.v.scale);
        Jet { u: far * u, v: far * v, uu: far * (u * u), uv: far * (u * v), vv: far * (v * v) }
    }
}

impl TensorSurface {
    /// The size of the whole net, patches included: no place sees more.
    pub(super) fn extent(&self) -> f64 {
        self.layers.iter().map(|layer| layer.size([0, 0], [layer.u.run(), layer.v.run()])).sum()
    }

    /// The size of the points that weigh on a place. What lies elsewhere has no part in it: a point that is moved far
    /// away changes nothing where it does not act.
    pub(super) fn extent_at(&self, u: f64, v: f64) -> f64 {
        self.layers.iter().map(|layer| layer.size(layer.seen(u, v), [layer.u.width(), layer.v.width()])).sum()
    }

    /// How large derivatives can be anywhere.
    pub(super) fn most(&self) -> Jet {
        let of = |layer: &Layer| layer.most([0, 0], [layer.u.run(), layer.v.run()]);
        self.layers.iter().map(of).fold(Jet::default(), Jet::plus)
    }

    /// How large derivatives can be at a place.
    pub(super) fn most_at(&self, u: f64, v: f64) -> Jet {
        let of = |layer: &Layer| layer.most(layer.seen(u, v), [layer.u.width(), layer.v.width()]);
        self.layers.iter().map(of).fold(Jet::default(), Jet::plus)
    }
}
