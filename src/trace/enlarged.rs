//! What is found in a picture of squares, as if they were pixels, is found in the picture.

use super::options::TraceOptions;
use super::picture::blocks::Blocks;
use super::work::TracedContour;
use crate::numerics::Point;
use crate::numerics::plane::{enlarge, larger, smaller};

/// Contours of less area, in squares, are left out unless smaller ones are asked for, as in any picture.
const SPECKLE: f64 = 2.0;

impl Blocks {
    /// Pixels in a square.
    pub(super) fn area(&self) -> f64 {
        (self.size * self.size) as f64
    }

    /// Makes what a tracer is told of pixels what it is told of squares. How near the first curves are counts in squares.
    pub(super) fn adapt(&self, options: &mut TraceOptions) {
        if let Some(blur) = &mut options.blur {
            *blur /= self.size as f64;
        }
        options.speckle = larger(options.speckle / self.area(), smaller(options.speckle, SPECKLE));
    }

    /// Makes contours of the squares those of the picture. Where the border cuts squares off, outlines end where these would.
    #[inline(never)]
    pub(super) fn enlarge(&self, contours: &mut [TracedContour]) {
        let size = self.size as f64;
        let lead = Point::new(self.lead[0] as f64, self.lead[1] as f64);
        for TracedContour { curve, cusps, metrics, .. } in contours {
            curve.enlarge(size, lead);
            enlarge(cusps, size, lead);
            for distance in [&mut metrics.rmse, &mut metrics.mae, &mut metrics.max, &mut metrics.hausdorff] {
                *distance *= size;
            }
        }
    }
}
