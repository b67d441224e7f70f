//! expline's segments as a source of points for kurbo's fit of cubics.

use std::ops::Range;

use expline::curve::Segment;
use expline::numerics::Vector;
use kurbo::{CurveFitSample, ParamCurveFit, Point, Vec2};

struct Source<'a>(Segment<'a>);

fn vec2(v: Vector) -> Vec2 {
    Vec2::new(v.x, v.y)
}

impl ParamCurveFit for Source<'_> {
    fn sample_pt_tangent(&self, t: f64, _: f64) -> CurveFitSample {
        let (p, tangent) = self.sample_pt_deriv(t);
        CurveFitSample { p, tangent }
    }

    fn sample_pt_deriv(&self, t: f64) -> (Point, Vec2) {
        (vec2(self.0.position(t)).to_point(), vec2(self.0.velocity(t)) * self.0.length)
    }

    fn break_cusp(&self, _: Range<f64>) -> Option<f64> {
        None
    }
}

/// How many cubics kurbo needs for the segments, each fitted for itself; `fewest` asks for as few as it can find.
pub fn cubics<'a>(segments: impl Iterator<Item = Segment<'a>>, tolerance: f64, fewest: bool) -> usize {
    let count = |segment| {
        let source = Source(segment);
        let path = if fewest {
            kurbo::fit_to_bezpath_opt(&source, tolerance)
        } else {
            kurbo::fit_to_bezpath(&source, tolerance)
        };
        path.elements().len() - 1
    };
    segments.map(count).sum()
}
