//! How large the part of a surface is that a place sees: what rounding and degenerate places are judged by.

use super::layer::Layer;
use super::tensor::TensorSurface;

/// Points closer together than this part of their distance from the origin count as one: weights leave 1e-16 of that
/// distance in derivatives, and products of two of them must stay below the part of the size that counts.
const FARTHEST: f64 = 1e-8;

impl Layer {
    /// Half the diagonal of the box of the points in so many rows and columns from a place on, and not less than rounding makes of
    /// points that are one. It does not fall when points are added; 0 where the layer has none there.
    #[inline(never)]
    fn size(&self, from: [usize; 2], count: [usize; 2]) -> f64 {
        let (mut least, mut most) = ([f64::MAX; 3], [f64::MIN; 3]);
        for a in 0..count[0] {
            let Some(i) = self.rows.position(&self.u, self.u.row(from[0] + a)) else { continue };
            for b in 0..count[1] {
                let Some(j) = self.columns.position(&self.v, self.v.row(from[1] + b)) else { continue };
                for (k, &x) in self.point(i, j).iter().enumerate().take(3) {
                    (least[k], most[k]) = (least[k].min(x), most[k].max(x));
                }
            }
        }
        if least[0] > most[0] {
            return 0.0;
        }
        let (mut square, mut far): (f64, f64) = (0.0, 0.0);
        for (least, most) in least.into_iter().zip(most) {
            square += (0.5 * (most - least)) * (0.5 * (most - least));
            far = far.max(most).max(-least);
        }
        square.sqrt().max(FARTHEST * far)
    }
}

impl TensorSurface {
    /// The size of the whole net, patches included: no place sees more.
    pub(super) fn extent(&self) -> f64 {
        self.layers.iter().map(|layer| layer.size([0, 0], [layer.u.run(), layer.v.run()])).sum()
    }

    /// The size of the points that weigh on a place. What lies elsewhere has no part in it: a point that is moved far away
    /// changes nothing where it does not act.
    pub(super) fn extent_at(&self, u: f64, v: f64) -> f64 {
        let size = |layer: &Layer| {
            let from = [layer.u.nearest_place(u).interval, layer.v.nearest_place(v).interval];
            layer.size(from, [layer.u.width, layer.v.width])
        };
        self.layers.iter().map(size).sum()
    }
}
