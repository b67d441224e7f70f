//! What is found in a picture of squares, as if they were pixels, is found in the picture.

use super::options::{SPECKLE, TraceOptions};
use super::picture::blocks::Blocks;
use super::picture::pitch::Pitch;
use super::work::TracedContour;
use crate::numerics::Vector;
use crate::numerics::plane::{enlarge, larger, smaller};

impl Pitch {
    /// How far before the picture the squares begin. Those of two sizes begin up to a pixel later than even ones would,
    /// half of that on the average; where nothing is cut off, as mostly, that is known.
    #[inline(never)]
    fn back(&self) -> f64 {
        let count = self.count as f64;
        let late = self.lead as f64 - (count - 1.0) / 2.0;
        if late.abs() > 0.5 { late / count } else { 0.0 }
    }
}

impl Blocks {
    /// How broad and how high a square is, in pixels.
    fn sides(&self) -> Vector {
        let [columns, rows] = self.grid.map(|pitch| pitch.times());
        Vector::new(columns, rows)
    }

    /// Pixels in a square.
    pub(super) fn area(&self) -> f64 {
        self.sides().product()
    }

    /// Makes what a tracer is told of pixels what it is told of squares: no fewer than two unless fewer are asked for,
    /// as in any picture. How near the first curves are counts in squares.
    pub(super) fn adapt(&self, options: &mut TraceOptions) {
        if let Some(blur) = &mut options.blur {
            *blur /= self.sides().x;
        }
        if let Some(speckle) = &mut options.speckle {
            *speckle = larger(*speckle / self.area(), smaller(*speckle, SPECKLE));
        }
    }

    /// Makes contours of the squares those of the picture. Where the border cuts squares off, outlines end where these
    /// would.
    #[inline(never)]
    pub(super) fn enlarge(&self, contours: &mut [TracedContour]) {
        let sides = self.sides();
        let [left, top] = self.grid.map(|pitch| pitch.back());
        let back = Vector::new(left, top);
        for TracedContour { curve, cusps, metrics, .. } in contours {
            curve.enlarge(sides, back);
            enlarge(cusps, sides, back);
            for distance in [&mut metrics.rmse, &mut metrics.mae, &mut metrics.max, &mut metrics.hausdorff] {
                *distance *= larger(sides.x, sides.y);
            }
        }
    }
}
