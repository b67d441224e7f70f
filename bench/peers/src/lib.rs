//! kurbo behind plain numbers: the same calls natively and in wasm.
//!
//! In wasm the functions are bare exports without any binding layer, which is the lightest way to call them.

use std::cell::RefCell;

use kurbo::{
    BezPath, CubicBez, ParamCurve, ParamCurveArclen, ParamCurveArea, ParamCurveDeriv, ParamCurveExtrema,
    ParamCurveNearest, PathEl, Point, QuadBez, Rect, Shape,
};

/// A closed curve of cubic Béziers, prepared as kurbo likes it.
#[derive(Default)]
pub struct Curve {
    segments: Vec<CubicBez>,
    derivatives: Vec<QuadBez>,
    boxes: Vec<Rect>,
    path: BezPath,
}

impl Curve {
    /// A curve from 8 numbers per segment.
    pub fn new(numbers: &[f64]) -> Self {
        let point = |c: &[f64], i: usize| Point::new(c[2 * i], c[2 * i + 1]);
        let cubic = |c: &[f64]| CubicBez::new(point(c, 0), point(c, 1), point(c, 2), point(c, 3));
        let segments: Vec<CubicBez> = numbers.chunks_exact(8).map(cubic).collect();
        let mut path = BezPath::new();
        path.push(PathEl::MoveTo(segments[0].p0));
        for s in &segments {
            path.push(PathEl::CurveTo(s.p1, s.p2, s.p3));
        }
        path.push(PathEl::ClosePath);
        let derivatives = segments.iter().map(ParamCurveDeriv::deriv).collect();
        let boxes = segments.iter().map(ParamCurveExtrema::bounding_box).collect();
        Self { segments, derivatives, boxes, path }
    }

    /// Points at `count` uniform parameters.
    pub fn evaluate(&self, count: usize, out: &mut Vec<f64>) {
        out.clear();
        let each = count / self.segments.len();
        for s in &self.segments {
            for k in 0..each {
                let p = s.eval(k as f64 / each as f64);
                out.push(p.x);
                out.push(p.y);
            }
        }
    }

    /// Points and derivatives at `count` uniform parameters, four numbers each.
    pub fn evaluate_with_tangents(&self, count: usize, out: &mut Vec<f64>) {
        out.clear();
        let each = count / self.segments.len();
        for (s, d) in self.segments.iter().zip(&self.derivatives) {
            for k in 0..each {
                let t = k as f64 / each as f64;
                let (p, v) = (s.eval(t), d.eval(t));
                out.extend_from_slice(&[p.x, p.y, v.x, v.y]);
            }
        }
    }

    /// The tight box: four numbers.
    pub fn bounds(&self, out: &mut Vec<f64>) {
        let boxes = self.segments.iter().map(ParamCurveExtrema::bounding_box);
        let r = boxes.reduce(|a, b| a.union(b)).unwrap_or_default();
        out.clear();
        out.extend_from_slice(&[r.x0, r.y0, r.x1, r.y1]);
    }

    /// The length to an accuracy per segment.
    pub fn length(&self, accuracy: f64) -> f64 {
        self.segments.iter().map(|s| s.arclen(accuracy)).sum()
    }

    /// The signed area.
    pub fn area(&self) -> f64 {
        self.segments.iter().map(ParamCurveArea::signed_area).sum()
    }

    /// The distance from a point to the curve, segment by segment as a user of kurbo writes it.
    pub fn nearest(&self, p: Point, accuracy: f64) -> f64 {
        let squared = self.segments.iter().map(|s| s.nearest(p, accuracy).distance_sq);
        squared.fold(f64::INFINITY, f64::min).sqrt()
    }

    /// The same, leaving out segments whose box is too far away.
    pub fn nearest_pruned(&self, p: Point, accuracy: f64) -> f64 {
        let mut best = f64::INFINITY;
        for (s, b) in self.segments.iter().zip(&self.boxes) {
            let dx = (b.x0 - p.x).max(p.x - b.x1).max(0.0);
            let dy = (b.y0 - p.y).max(p.y - b.y1).max(0.0);
            if dx * dx + dy * dy < best {
                best = best.min(s.nearest(p, accuracy).distance_sq);
            }
        }
        best.sqrt()
    }

    /// The points of a polyline within a tolerance.
    pub fn flatten(&self, tolerance: f64, out: &mut Vec<f64>) {
        out.clear();
        kurbo::flatten(&self.path, tolerance, |element| {
            if let PathEl::MoveTo(p) | PathEl::LineTo(p) = element {
                out.push(p.x);
                out.push(p.y);
            }
        });
    }
}

/// A path text as kurbo holds it.
pub fn parse(d: &str) -> Option<BezPath> {
    BezPath::from_svg(d).ok()
}

/// The perimeter's control box, so that nothing of the curve is optimised away.
pub fn control_box(curve: &Curve) -> Rect {
    curve.path.bounding_box()
}

#[derive(Default)]
struct State {
    input: Vec<f64>,
    text: Vec<u8>,
    out: Vec<f64>,
    curve: Curve,
}

thread_local! {
    static STATE: RefCell<State> = RefCell::default();
}

fn with<T>(action: impl FnOnce(&mut State) -> T) -> T {
    STATE.with(|state| action(&mut state.borrow_mut()))
}

/// Room for `count` numbers of input; gives back where.
#[unsafe(no_mangle)]
pub extern "C" fn input(count: usize) -> *mut f64 {
    with(|s| {
        s.input.resize(count, 0.0);
        s.input.as_mut_ptr()
    })
}

/// Room for `count` bytes of text; gives back where.
#[unsafe(no_mangle)]
pub extern "C" fn text(count: usize) -> *mut u8 {
    with(|s| {
        s.text.resize(count, 0);
        s.text.as_mut_ptr()
    })
}

/// Where the last result is.
#[unsafe(no_mangle)]
pub extern "C" fn out() -> *const f64 {
    with(|s| s.out.as_ptr())
}

/// Takes the input as a curve.
#[unsafe(no_mangle)]
pub extern "C" fn load() {
    with(|s| s.curve = Curve::new(&s.input));
}

/// See [`Curve::evaluate`].
#[unsafe(no_mangle)]
pub extern "C" fn evaluate(count: usize) {
    with(|s| s.curve.evaluate(count, &mut s.out));
}

/// See [`Curve::evaluate_with_tangents`].
#[unsafe(no_mangle)]
pub extern "C" fn evaluate_with_tangents(count: usize) {
    with(|s| s.curve.evaluate_with_tangents(count, &mut s.out));
}

/// See [`Curve::bounds`].
#[unsafe(no_mangle)]
pub extern "C" fn bounds() {
    with(|s| s.curve.bounds(&mut s.out));
}

/// See [`Curve::length`].
#[unsafe(no_mangle)]
pub extern "C" fn length(accuracy: f64) -> f64 {
    with(|s| s.curve.length(accuracy))
}

/// See [`Curve::nearest`].
#[unsafe(no_mangle)]
pub extern "C" fn nearest(x: f64, y: f64, accuracy: f64) -> f64 {
    with(|s| s.curve.nearest(Point::new(x, y), accuracy))
}

/// See [`Curve::nearest_pruned`].
#[unsafe(no_mangle)]
pub extern "C" fn nearest_pruned(x: f64, y: f64, accuracy: f64) -> f64 {
    with(|s| s.curve.nearest_pruned(Point::new(x, y), accuracy))
}

/// See [`Curve::flatten`]; gives back how many points.
#[unsafe(no_mangle)]
pub extern "C" fn flatten(tolerance: f64) -> usize {
    with(|s| {
        s.curve.flatten(tolerance, &mut s.out);
        s.out.len() / 2
    })
}

/// See [`parse`]; 0 for an error.
#[unsafe(no_mangle)]
pub extern "C" fn parse_text() -> usize {
    with(|s| std::str::from_utf8(&s.text).ok().and_then(parse).map_or(0, |path| path.elements().len()))
}
