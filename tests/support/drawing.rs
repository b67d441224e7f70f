//! What a viewer draws from path data: a plain reader by the letter of the specification, which shares nothing with
//! the crate's (the standard library reads its numbers; arcs are in SVG's own centre parametrisation).

#![allow(clippy::panic, reason = "an oracle that cannot read its input stops the test")]

use core::f64::consts::TAU;

use nalgebra::Vector2;

type Point = Vector2<f64>;

/// One drawn segment.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Piece {
    /// From a point to another.
    Line([Point; 2]),
    /// Bézier.
    Quadratic([Point; 3]),
    /// Bézier.
    Cubic([Point; 4]),
    /// Centre, radii, rotation in radians, first angle, sweep.
    Arc(Point, Point, f64, f64, f64),
}

impl Piece {
    /// The point at x in [0, 1].
    pub(crate) fn at(&self, x: f64) -> Point {
        let z = 1.0 - x;
        match *self {
            Self::Line([a, b]) => a * z + b * x,
            Self::Quadratic([a, b, c]) => a * (z * z) + b * (2.0 * x * z) + c * (x * x),
            Self::Cubic([a, b, c, d]) => {
                a * (z * z * z) + b * (3.0 * x * z * z) + c * (3.0 * x * x * z) + d * (x * x * x)
            }
            Self::Arc(center, radii, rotation, first, sweep) => {
                let (sin, cos) = (first + sweep * x).sin_cos();
                center + turned(Point::new(radii.x * cos, radii.y * sin), rotation)
            }
        }
    }
}

fn turned(v: Point, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    Point::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
}

/// A chord this close to the diameter, by its square, is the diameter: text of a few digits cannot mean anything else,
/// and the rounding of its sums would move the centre by the root of itself.
const HALF_TURN: f64 = 1e-12;

/// SVG 2, B.2.4 and B.2.5; `None` where the arc is left out or a line.
pub(crate) fn arc(
    from: Point,
    to: Point,
    radii: Point,
    degrees: f64,
    large: bool,
    positive: bool,
) -> Option<Piece> {
    if from == to || radii.x == 0.0 || radii.y == 0.0 {
        return None;
    }
    let rotation = degrees.to_radians();
    let half = turned((from - to) / 2.0, -rotation);
    let mut radii = radii.abs();
    let lambda = (half.x / radii.x).powi(2) + (half.y / radii.y).powi(2);
    let mut root = 0.0;
    if lambda > 1.0 {
        radii *= lambda.sqrt();
    } else if lambda < 1.0 - HALF_TURN {
        root = ((1.0 - lambda) / lambda).sqrt();
    }
    let side = if large == positive { -root } else { root };
    let local = Point::new(side * radii.x * half.y / radii.y, -side * radii.y * half.x / radii.x);
    let angle = |v: Point| (v.y / radii.y).atan2(v.x / radii.x);
    let first = angle(half - local);
    let mut sweep = angle(-half - local) - first;
    if positive && sweep < 0.0 {
        sweep += TAU;
    } else if !positive && sweep > 0.0 {
        sweep -= TAU;
    }
    Some(Piece::Arc(turned(local, rotation) + (from + to) / 2.0, radii, rotation, first, sweep))
}

/// A token of path data: a letter or a number.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Token {
    Letter(char),
    Number(f64),
}

fn tokens(d: &str) -> Vec<Token> {
    let bytes: Vec<char> = d.chars().collect();
    let (mut tokens, mut i, mut in_arc, mut nth) = (Vec::new(), 0, false, 0);
    while i < bytes.len() {
        let c = bytes[i];
        if c.is_ascii_alphabetic() {
            tokens.push(Token::Letter(c));
            (in_arc, nth) = (c.eq_ignore_ascii_case(&'a'), 0);
            i += 1;
        } else if c == ',' || c.is_ascii_whitespace() {
            i += 1;
        } else {
            let start = i;
            let flag = in_arc && (nth % 7 == 3 || nth % 7 == 4);
            let (mut point, mut exponent) = (false, false);
            while let Some(&c) = bytes.get(i) {
                let after_exponent = i > start && matches!(bytes[i - 1], 'e' | 'E');
                match c {
                    '0'..='9' => {}
                    '+' | '-' if i == start || after_exponent => {}
                    '.' if !point && !exponent => point = true,
                    'e' | 'E' if !exponent && i > start => exponent = true,
                    _ => break,
                }
                i += 1;
                if flag {
                    break;
                }
            }
            let text: String = bytes[start..i].iter().collect();
            tokens.push(Token::Number(
                text.parse().unwrap_or_else(|_| panic!("{text:?} in {d:?} is no number")),
            ));
            nth += 1;
        }
    }
    tokens
}

/// The subpaths of valid path data: their pieces, and whether they are closed.
pub(crate) fn drawing(d: &str) -> Vec<(Vec<Piece>, bool)> {
    let mut paths: Vec<(Vec<Piece>, bool)> = Vec::new();
    let tokens = tokens(d);
    let (mut i, mut letter) = (0, 'M');
    let (mut current, mut start) = (Point::zeros(), Point::zeros());
    let (mut cubic, mut quadratic): (Option<Point>, Option<Point>) = (None, None);
    let mut fresh = true;
    while i < tokens.len() {
        if let Token::Letter(c) = tokens[i] {
            letter = c;
            i += 1;
        }
        let mut next = || match tokens.get(i) {
            Some(&Token::Number(value)) => {
                i += 1;
                value
            }
            other => panic!("{other:?} where a number should be in {d:?}"),
        };
        let base = if letter.is_ascii_lowercase() { current } else { Point::zeros() };
        if !matches!(letter.to_ascii_uppercase(), 'M' | 'Z') && fresh {
            paths.push((Vec::new(), false));
            fresh = false;
        }
        let mut pieces = Vec::new();
        let (mut next_cubic, mut next_quadratic) = (None, None);
        let from = current;
        match letter.to_ascii_uppercase() {
            'M' => {
                current = base + Point::new(next(), next());
                start = current;
                fresh = true;
                letter = if letter == 'm' { 'l' } else { 'L' };
            }
            'Z' => {
                if let Some(path) = paths.last_mut().filter(|_| !fresh) {
                    path.1 = true;
                }
                pieces.push(Piece::Line([current, start]));
                current = start;
            }
            'L' => current = base + Point::new(next(), next()),
            'H' => current.x = base.x + next(),
            'V' => current.y = base.y + next(),
            'C' | 'S' => {
                let one = if letter.eq_ignore_ascii_case(&'c') {
                    base + Point::new(next(), next())
                } else {
                    cubic.map_or(from, |control| from * 2.0 - control)
                };
                let two = base + Point::new(next(), next());
                current = base + Point::new(next(), next());
                pieces.push(Piece::Cubic([from, one, two, current]));
                next_cubic = Some(two);
            }
            'Q' | 'T' => {
                let control = if letter.eq_ignore_ascii_case(&'q') {
                    base + Point::new(next(), next())
                } else {
                    quadratic.map_or(from, |control| from * 2.0 - control)
                };
                current = base + Point::new(next(), next());
                pieces.push(Piece::Quadratic([from, control, current]));
                next_quadratic = Some(control);
            }
            'A' => {
                let radii = Point::new(next(), next());
                let (degrees, large, positive) = (next(), next() != 0.0, next() != 0.0);
                current = base + Point::new(next(), next());
                pieces.push(
                    arc(from, current, radii, degrees, large, positive)
                        .unwrap_or(Piece::Line([from, current])),
                );
            }
            other => panic!("{other:?} is no command"),
        }
        if matches!(letter.to_ascii_uppercase(), 'L' | 'H' | 'V') && !fresh {
            pieces.push(Piece::Line([from, current]));
        }
        let closes = letter.eq_ignore_ascii_case(&'z');
        if let Some(path) = paths.last_mut().filter(|_| !fresh) {
            path.0.append(&mut pieces);
        }
        fresh |= closes;
        (cubic, quadratic) = (next_cubic, next_quadratic);
    }
    paths
}

/// A stretch of curve over [0, 1].
pub(crate) type Stretch<'a> = Box<dyn Fn(f64) -> Point + 'a>;

/// The pieces that have an extent, as stretches.
pub(crate) fn stretches(pieces: &[Piece]) -> Vec<Stretch<'_>> {
    let drawn = |piece: &&Piece| !matches!(piece, Piece::Line([a, b]) if a == b);
    pieces.iter().filter(drawn).map(|piece| Box::new(|x| piece.at(x)) as Stretch<'_>).collect()
}

/// Places on each stretch at which distances are measured.
const PLACES: u32 = 12;

/// Distances are found to this part of themselves.
pub(crate) const PRECISION: f64 = 1e-4;

/// The largest distance of a place on `from` to the nearest place on `to`.
///
/// No place is missed: intervals are halved until their ends and the greatest speed show that nothing inside them is
/// nearer.
fn farthest(from: &[Stretch<'_>], to: &[Stretch<'_>], least: f64) -> f64 {
    let place = |k: u32| f64::from(k) / f64::from(PLACES);
    let speed = |at: &Stretch<'_>| {
        let fine = (0..8 * PLACES).map(|k| (at(place(k + 1) / 8.0) - at(place(k) / 8.0)).norm());
        1.1 * f64::from(8 * PLACES) * fine.fold(0.0, f64::max)
    };
    let speeds: Vec<f64> = to.iter().map(speed).collect();
    let distance = |p: Point| {
        let mut best = to.iter().map(|at| (at(0.5) - p).norm()).fold(f64::INFINITY, f64::min);
        for (at, &speed) in to.iter().zip(&speeds) {
            let mut open = vec![(0.0, 1.0, (at(0.0) - p).norm(), (at(1.0) - p).norm())];
            while let Some((low, high, near_low, near_high)) = open.pop() {
                best = best.min(near_low).min(near_high);
                let bound = 0.5 * (near_low + near_high - speed * (high - low));
                if bound < best * (1.0 - PRECISION) - least {
                    let middle = 0.5 * (low + high);
                    let near = (at(middle) - p).norm();
                    open.push((low, middle, near_low, near));
                    open.push((middle, high, near, near_high));
                }
            }
        }
        best
    };
    from.iter().flat_map(|at| (0..=PLACES).map(|k| distance(at(place(k))))).fold(0.0, f64::max)
}

/// The distance between two drawings, both ways, to within [`PRECISION`] and `least`.
pub(crate) fn distance(one: &[Stretch<'_>], two: &[Stretch<'_>], least: f64) -> f64 {
    farthest(one, two, least).max(farthest(two, one, least))
}
