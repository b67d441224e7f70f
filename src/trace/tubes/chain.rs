//! Chains of edge points: tangents, tubes that are graphs over their chord, and the spline of each tube.

use super::parabola::Parabola;
use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, MOST_POINTS, check, too_many, with_room};
use crate::numerics::plane::{cross, dot, norm};
use crate::numerics::{Point, Vector};
use crate::trace::metrics::{mean_absolute, root_mean_square};
use crate::trace::quasi_interpolant::choice::Choice;
use crate::trace::quasi_interpolant::cloud::Cloud;
use crate::trace::quasi_interpolant::knots::Knots;
use crate::trace::quasi_interpolant::projection::REACH;
use crate::trace::quasi_interpolant::selection::{Method, choose};
use crate::trace::quasi_interpolant::{End, QuasiInterpolant};
use crate::trace::samples::{line_through, turn, unit};

/// Points in the order of a profile, open or closed.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    points: Vec<Point>,
    closed: bool,
}

/// What a chain is near one of its points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainPlace {
    /// The smoothed point.
    pub point: Point,
    /// The tangent, of length 1, in the order of the chain.
    pub tangent: Vector,
    /// The curvature; positive from x towards y.
    pub curvature: f64,
}

/// A part of a chain that is a graph over the chord between its ends. Both ends belong to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tube {
    /// Index of the first point.
    pub first: usize,
    /// How many points there are, around the chain.
    pub count: usize,
    /// Whether the chain has a cusp or an end at the first and at the last point.
    pub cusps: [bool; 2],
}

/// Where a tube's curve begins or ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// The point that the curve passes.
    pub point: Point,
    /// The tangent that it shares with its neighbour, of length 1 in the order of the chain; `None` at cusps and ends.
    pub tangent: Option<Vector>,
}

/// The spline of a tube.
#[derive(Clone, Debug, PartialEq)]
pub struct TubeFit {
    /// Control points of the spline between the joints.
    pub control: Vec<Point>,
    /// Its knots, as distances from the first joint along the chord; `None` for a line through too few points.
    pub knots: Option<Knots>,
    /// Knots and neighbours, and the error of predicting each point from the others; `None` for a line through too few
    /// points.
    pub choice: Option<Choice>,
    /// Root mean square of the ordinates' residuals, in the unit of the points.
    pub rmse: f64,
    /// Their mean absolute value.
    pub mae: f64,
}

impl Chain {
    /// A chain of at least two points.
    ///
    /// # Errors
    ///
    /// Fewer than two points, more than 16,777,216, a coordinate that is not finite or not within ±1e9.
    pub fn new(points: Vec<Point>, closed: bool) -> Result<Self> {
        if points.len() < 2 {
            return Err(Error::too_few("points", points.len(), 2));
        }
        if points.len() > MOST_POINTS {
            return Err(too_many("points", "maxPoints", MOST_POINTS, points.len()));
        }
        for (i, point) in points.iter().enumerate() {
            check("points", Some(2 * i), point.x, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
            check("points", Some(2 * i + 1), point.y, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
        }
        Ok(Self { points, closed })
    }

    /// The points.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Whether the last point is joined to the first.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The index one further, forwards or backwards; `None` at the end of an open chain.
    pub(super) fn step(&self, i: usize, forward: bool) -> Option<usize> {
        let last = self.points.len() - 1;
        match (forward, i) {
            (true, i) if i == last => self.closed.then_some(0),
            (true, i) => Some(i + 1),
            (false, 0) => self.closed.then_some(last),
            (false, i) => Some(i - 1),
        }
    }

    /// The points within `window` along the chain on one side of point i, nearest first, with their distances along it.
    /// Never more than once around.
    pub(super) fn side(&self, i: usize, window: f64, forward: bool, visit: &mut dyn FnMut(f64, Point)) {
        let (mut at, mut travelled) = (i, 0.0);
        for _ in 1..self.points.len() {
            let Some(next) = self.step(at, forward) else { return };
            travelled += norm(self.points[next] - self.points[at]);
            if travelled > window * (1.0 + 1e-12) {
                return;
            }
            at = next;
            visit(if forward { travelled } else { -travelled }, self.points[at]);
        }
    }

    /// Point, tangent and curvature at point i: the parabola in the distance along the chain that is nearest, in the
    /// mean square, to the points within `window` on both sides.
    ///
    /// # Cost
    ///
    /// O(points in the window).
    pub fn place(&self, i: usize, window: f64) -> ChainPlace {
        let i = i.min(self.points.len() - 1);
        let here = self.points[i];
        let mut parabola = Parabola::new();
        parabola.add(0.0, Vector::zeros());
        let mut add = |distance: f64, p: Point| parabola.add(distance, p - here);
        self.side(i, window, true, &mut add);
        self.side(i, window, false, &mut add);
        let Some([value, slope, bend]) = parabola.solve() else {
            // Fewer than three places: the chord.
            let ends = [self.step(i, false).unwrap_or(i), self.step(i, true).unwrap_or(i)];
            let tangent = unit(self.points[ends[1]] - self.points[ends[0]]);
            return ChainPlace { point: here, tangent, curvature: 0.0 };
        };
        let speed = norm(slope);
        let curvature = if speed > 0.0 { cross(slope, bend) / (speed * speed * speed) } else { 0.0 };
        ChainPlace { point: here + value, tangent: unit(slope), curvature }
    }

    /// Point, tangent and curvature where two tubes meet smoothly at point i: they look a pixel farther than `window`.
    pub fn joint(&self, i: usize, window: f64) -> ChainPlace {
        self.place(i, window + 1.0)
    }

    /// The direction in which the chain leaves point i: the line nearest to the points within `window` after it.
    fn leaving(&self, i: usize, window: f64) -> Vector {
        let mut points = vec![self.points[i]];
        self.side(i, window, true, &mut |_, p| points.push(p));
        line_through(&points).direction
    }

    /// Divides the chain into tubes: at every cusp, and where the tangent has turned by more than `angle` since the
    /// tube began.
    ///
    /// A closed chain begins at its first cusp, or at point 0. Every point belongs to a tube; neighbours share their
    /// joint. With `angle` below a quarter turn every tube is a graph over its chord (D 14.7).
    ///
    /// # Errors
    ///
    /// An angle or a window out of range; cusps that are not ascending indices of points.
    pub fn tubes(&self, cusps: &[usize], angle: f64, window: f64) -> Result<Vec<Tube>> {
        check("angle", None, angle, 0.05, core::f64::consts::FRAC_PI_2)?;
        check("window", None, window, 1e-9, LARGEST_COORDINATE)?;
        let count = self.points.len();
        let mut least = 0;
        for (i, &cusp) in cusps.iter().enumerate() {
            check("cusps", Some(i), cusp as f64, least as f64, count as f64 - 1.0)?;
            least = cusp + 1;
        }
        let start = if self.closed { cusps.first().copied().unwrap_or(0) } else { 0 };
        let span = if self.closed { count } else { count - 1 };
        let is_cusp = |step: usize| {
            let i = (start + step) % count;
            (!self.closed && (step == 0 || step == span)) || cusps.binary_search(&i).is_ok()
        };
        let mut tubes: Vec<Tube> = with_room(cusps.len() + 1)?;
        let mut first = 0;
        while first < span {
            let at = |step: usize| (start + step) % count;
            let from = if is_cusp(first) {
                self.leaving(at(first), window)
            } else {
                self.joint(at(first), window).tangent
            };
            let mut last = first + 1;
            while last < span && !is_cusp(last) {
                let turned = turn(from, self.place(at(last), window).tangent).abs();
                if last >= first + 4 && turned > angle && !self.near_cusp(at(last), cusps, window) {
                    break;
                }
                last += 1;
            }
            if span - last < 4 && (last..span).all(|step| !is_cusp(step)) {
                last = span;
            }
            let cusps = [is_cusp(first), is_cusp(last)];
            tubes.push(Tube { first: at(first), count: last - first + 1, cusps });
            first = last;
        }
        Ok(tubes)
    }

    fn near_cusp(&self, i: usize, cusps: &[usize], window: f64) -> bool {
        let mut near = false;
        for &cusp in cusps {
            if i.abs_diff(cusp) as f64 <= window
                || (i.abs_diff(cusp) as f64) >= self.points.len() as f64 - window
            {
                near |= norm(self.points[cusp] - self.points[i]) <= window;
            }
        }
        near
    }

    /// The points of a tube in order: no more than the chain has, and none of a tube of another chain.
    pub fn tube_points(&self, tube: &Tube) -> Vec<Point> {
        let count = self.points.len();
        if tube.first >= count {
            return Vec::new();
        }
        self.in_tube(&Tube { count: tube.count.min(count), ..*tube })
    }

    /// The points of one of its own tubes.
    pub(in crate::trace) fn in_tube(&self, tube: &Tube) -> Vec<Point> {
        (0..tube.count).map(|k| self.points[(tube.first + k) % self.points.len()]).collect()
    }
}

/// A tube in the frame that has both joints on its x axis.
struct Frame {
    start: Point,
    along: Vector,
    across: Vector,
    length: f64,
    ends: [End; 2],
}

impl Frame {
    fn new([start, end]: [Joint; 2]) -> Self {
        let chord = end.point - start.point;
        let along = unit(chord);
        let across = Vector::new(-along.y, along.x);
        let slope = |joint: Joint| match joint.tangent {
            Some(tangent) if dot(tangent, along) >= 0.2 => {
                End::Tangent(dot(tangent, across) / dot(tangent, along))
            }
            _ => End::Held,
        };
        Self { start: start.point, along, across, length: norm(chord), ends: [slope(start), slope(end)] }
    }

    /// The points between the joints, in the frame.
    fn inside(&self, points: &[Point]) -> Vec<Point> {
        let local = |p: &Point| Point::new(dot(p - self.start, self.along), dot(p - self.start, self.across));
        points.iter().map(local).filter(|p| p.x >= 0.0 && p.x <= self.length).collect()
    }

    fn fit(&self, cloud: &Cloud, knots: Knots, method: Method, choice: Choice) -> Result<TubeFit> {
        let fitted = match method {
            Method::Mean(_) => QuasiInterpolant::of_means(cloud, knots, choice.k, self.ends)?,
            Method::Placed { .. } => QuasiInterpolant::projected(cloud, knots, REACH, self.ends)?,
        };
        let residuals = fitted.residuals(cloud)?;
        let place =
            |(q, &c): (usize, &f64)| self.start + self.along * fitted.knots().abscissa(q) + self.across * c;
        Ok(TubeFit {
            control: fitted.coefficients().iter().enumerate().map(place).collect(),
            knots: Some(fitted.knots().clone()),
            choice: Some(choice),
            rmse: root_mean_square(residuals.iter().copied()),
            mae: mean_absolute(residuals.iter().copied()),
        })
    }
}

/// The weighted quasi-interpolant of a tube between its joints, with as many knots and neighbours as `method` chooses.
///
/// The frame has both joints on its x axis; points beyond them do not count. At a joint with a tangent the second
/// control point is on the tangent.
///
/// # Errors
///
/// As [`Cloud::new`] and [`Knots::even`].
///
/// # Source
///
/// \[RB21, section 3.3\].
pub fn fit_tube(points: &[Point], joints: [Joint; 2], degree: usize, method: Method) -> Result<TubeFit> {
    let frame = Frame::new(joints);
    let inside = frame.inside(points);
    let control = joints.map(|joint| joint.point).to_vec();
    let line = TubeFit { control, knots: None, choice: None, rmse: 0.0, mae: 0.0 };
    if frame.length < 1e-6 || inside.len() < 3 {
        return Ok(line);
    }
    let cloud = Cloud::new(&inside)?;
    match choose(&cloud, 0.0, frame.length, degree, frame.ends, method)? {
        Some((choice, knots)) => frame.fit(&cloud, knots, method, choice),
        None => Ok(line),
    }
}

/// As [`fit_tube`], with the number of even knots and of neighbours given.
///
/// # Errors
///
/// As [`fit_tube`]; more neighbours than there are points between the joints, joints at one place.
pub fn fit_tube_with(
    points: &[Point],
    joints: [Joint; 2],
    degree: usize,
    method: Method,
    choice: Choice,
) -> Result<TubeFit> {
    let frame = Frame::new(joints);
    let knots = Knots::even(0.0, frame.length, choice.interior, degree)?;
    frame.fit(&Cloud::new(&frame.inside(points))?, knots, method, choice)
}
