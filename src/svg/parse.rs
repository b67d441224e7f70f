//! SVG path data → curves.

use super::arc::{Arc, ArcCommand, HALF_TURN};
use super::number;
use super::subpath::Subpath;
use crate::curve::HermiteCurve;
use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, LARGEST_TANGENT, LEAST_COORDINATE, too_many};
use crate::numerics::{Point, Vector};

/// The longest path text that is read, in bytes.
pub const MOST_PATH_BYTES: usize = 8 << 20;
/// The most subpaths of one path, those that draw nothing included.
pub const MOST_SUBPATHS: usize = 100_000;
/// The most points of one path, over all its curves.
pub const MOST_PATH_POINTS: usize = 2_000_000;

/// What [`parse_path`] read.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ParsedPath {
    /// One curve for every subpath that draws something.
    pub curves: Vec<HermiteCurve>,
    /// How many subpaths the text has; those that draw nothing (a lone `M`) have no curve.
    pub subpaths: usize,
    /// Where reading stopped, when the text does not make sense to its end. All before it was read.
    pub truncation: Option<Truncation>,
}

/// Where and why reading stopped before the end of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Truncation {
    /// Byte offset from which on nothing was used: where the command, or the group of numbers, starts that could
    /// not be read.
    pub offset: usize,
    /// Byte offset of the character that makes no sense, in that command or group; the length of the text when
    /// the text ends too early.
    pub found: usize,
    /// What was expected there.
    pub expected: &'static str,
}

/// Reads SVG path data: every command, exactly.
///
/// Each subpath becomes one curve in the trigonometric space, with parameter length 1 for every segment: lines
/// run at constant speed (ω = 0), cubics are themselves (ω = 0), quadratics are raised, arcs of ellipses have
/// ω = their sweep and are split in two where it exceeds π. A subpath that ends in `Z` is closed; the line back to its
/// start is added only where the last point is elsewhere by more than rounding. Segments of no extent are left
/// out.
///
/// # Domain
///
/// The grammar of SVG 2, and `5.` as in SVG 1.1; numbers and coordinates within ±1e9.
///
/// # Accuracy
///
/// Points to the last bit as in absolute commands; in relative ones one rounding per command. Numbers are rounded
/// correctly. A closed subpath's last point is moved onto its start when the gap is below 4 ulp of
/// the largest coordinate per segment.
///
/// # Errors
///
/// `PathSyntax` ⇐ nothing could be read at all; text that makes no sense further on is no error but a
/// [`Truncation`]. `OutOfRange` ⇐ a number or a coordinate beyond ±1e9, or a derivative beyond ±8e9, with the byte
/// offset. `LimitExceeded` ⇐ more than [`MOST_PATH_BYTES`], [`MOST_SUBPATHS`] or [`MOST_PATH_POINTS`].
///
/// # Cost
///
/// O(bytes); allocates the curves alone.
///
/// # Source
///
/// \[SVG18, chapter 9 and B.2\].
///
/// # Example
///
/// ```
/// let circle = expline::svg::parse_path("M10 0A5 5 0 0 1 20 0A5 5 0 0 1 10 0Z")?.curves;
/// assert_eq!(circle[0].points().len(), 2);
/// assert!((circle[0].evaluate(0.5, 0)?.y + 5.0).abs() < 1e-14);
/// # Ok::<(), expline::Error>(())
/// ```
pub fn parse_path(d: &str) -> Result<ParsedPath> {
    parse_bytes(d.as_bytes())
}

/// The same for bytes that may be any text: whatever is not ASCII makes no sense in path data.
pub(crate) fn parse_bytes(d: &[u8]) -> Result<ParsedPath> {
    if d.len() > MOST_PATH_BYTES {
        return Err(too_many("d", "maxPathBytes", MOST_PATH_BYTES, d.len()));
    }
    let mut reader = Reader {
        text: d,
        at: 0,
        group: 0,
        numbers: [0.0; 7],
        offset: Vector::zeros(),
        current: Point::zeros(),
        start: Point::zeros(),
        open: false,
        subpath: Subpath::default(),
        points: 0,
        failure: None,
        path: ParsedPath::default(),
    };
    // Reading stops by itself at the end and where text makes no sense; what stands is kept, unless it failed.
    reader.read();
    reader.finish(false);
    let Reader { failure, path, .. } = reader;
    if let Some(error) = failure {
        return Err(error);
    }
    match path.truncation {
        Some(Truncation { found: offset, expected, .. }) if path.subpaths == 0 => {
            Err(Error::path_syntax(offset, expected))
        }
        _ => Ok(path),
    }
}

/// What derivatives are looked at by, where points are by themselves: they may be larger.
const PART: f64 = LARGEST_COORDINATE / LARGEST_TANGENT;

/// `Some` to go on, `None` to stop; why is in the reader.
type Step = Option<()>;

struct Reader<'a> {
    text: &'a [u8],
    at: usize,
    /// Where the command being read starts, or its current group of numbers.
    group: usize,
    /// That group, in absolute coordinates.
    numbers: [f64; 7],
    /// The last two of them as they were written.
    offset: Vector,
    current: Point,
    start: Point,
    /// Whether a subpath is open: a drawing command after `Z` opens a new one where the last one started.
    open: bool,
    subpath: Subpath,
    points: usize,
    failure: Option<Box<Error>>,
    path: ParsedPath,
}

impl Reader<'_> {
    fn read(&mut self) -> Step {
        loop {
            self.skip_space();
            let letter = self.byte();
            if self.at == self.text.len() {
                return Some(());
            }
            self.group = self.at;
            let mut command = letter | 0x20;
            let count = match command {
                b'z' => 0,
                b'h' | b'v' => 1,
                b'l' | b'm' | b't' => 2,
                b'q' | b's' => 4,
                b'c' => 6,
                b'a' => 7,
                _ => usize::MAX,
            };
            if self.path.subpaths == 0 && command != b'm' {
                return self.expected("a moveto (M or m)");
            }
            if count == usize::MAX {
                return self.expected("a command");
            }
            let relative = letter == command;
            self.at += 1;
            self.skip_space();
            if count == 0 {
                self.close()?;
                continue;
            }
            // The command once, and again for as long as numbers follow.
            loop {
                self.group = self.at;
                self.read_group(command, count, relative)?;
                self.draw(command, relative)?;
                if command == b'm' {
                    command = b'l';
                }
                let comma = self.skip_separator();
                self.group = self.at;
                if !matches!(self.byte(), b'0'..=b'9' | b'+' | b'-' | b'.') {
                    if comma {
                        return self.expected("a number");
                    }
                    break;
                }
            }
        }
    }

    /// Reads the numbers of one command, and makes them absolute.
    fn read_group(&mut self, command: u8, count: usize, relative: bool) -> Step {
        let base = if relative { self.current } else { Point::zeros() };
        for k in 0..count {
            if k > 0 {
                self.skip_separator();
            }
            if command == b'a' && (k == 3 || k == 4) {
                let flag = self.byte();
                if flag != b'0' && flag != b'1' {
                    return self.expected("a flag (0 or 1)");
                }
                self.at += 1;
                self.numbers[k] = f64::from(flag - b'0');
                continue;
            }
            let Some((number, end)) = number::read(self.text, self.at) else {
                return self.expected("a number");
            };
            let value = match command {
                b'a' if k < 5 => number,
                b'v' => number + base.y,
                b'a' => number + base[k - 5],
                _ => number + base[k % 2],
            };
            self.within(value)?;
            self.at = end;
            self.numbers[k] = value;
            self.offset = Vector::new(self.offset.y, number);
        }
        Some(())
    }

    fn draw(&mut self, command: u8, relative: bool) -> Step {
        let [a, b, c, d, e, f, g] = self.numbers;
        let (start, one, two, three) = (self.current, Point::new(a, b), Point::new(c, d), Point::new(e, f));
        let (control, degree) = self.subpath.last_control();
        match command {
            b'm' => {
                self.finish(false)?;
                self.open_subpath(one)
            }
            b'l' => self.bezier(one - start, start, one, 1.0),
            b'h' => self.bezier(Vector::new(a - start.x, 0.0), start, Point::new(a, start.y), 1.0),
            b'v' => self.bezier(Vector::new(0.0, a - start.y), start, Point::new(start.x, a), 1.0),
            b'c' => self.bezier((one - start) * 3.0, two, three, 3.0),
            b's' => {
                let leaving = if degree == 3.0 { (start - control) * 3.0 } else { Vector::zeros() };
                self.bezier(leaving, one, two, 3.0)
            }
            b'q' => self.bezier((one - start) * 2.0, one, two, 2.0),
            b't' => {
                let control = if degree == 2.0 { start * 2.0 - control } else { start };
                self.within(control.x)?;
                self.within(control.y)?;
                self.bezier((control - start) * 2.0, control, one, 2.0)
            }
            _ => {
                // Relative chords are as exact as their text; absolute ones carry the rounding of both ends.
                let end = Point::new(f, g);
                let (chord, size) =
                    if relative { (self.offset, 0.0) } else { (end - start, start.amax().max(end.amax())) };
                let command = ArcCommand { radii: one, rotation: c, large: d != 0.0, positive: e != 0.0 };
                self.arc(end, chord, size, &command)
            }
        }
    }

    /// A line (degree 1), parabola (2) or cubic (3) whose last control point but the end is `control`.
    fn bezier(&mut self, leaving: Vector, control: Point, end: Point, degree: f64) -> Step {
        let points = self.points;
        self.segment(end, leaving, (end - control) * degree, 0.0)?;
        self.subpath.set_control(control, degree, self.points > points);
        Some(())
    }

    fn arc(&mut self, end: Point, chord: Vector, size: f64, command: &ArcCommand) -> Step {
        let start = self.current;
        if command.radii.x == 0.0 || command.radii.y == 0.0 {
            return self.bezier(end - start, start, end, 1.0);
        }
        let nothing = end == start || chord.amax() < LEAST_COORDINATE;
        self.subpath.set_control(start, 0.0, !nothing);
        if nothing {
            return Some(());
        }
        let arc = Arc::new(start, chord, command, 4.0 * f64::EPSILON * (1.0 + size / chord.norm()));
        let (mut w, mut from) = (arc.sweep, arc.first);
        if w.abs() > HALF_TURN {
            (w, from) = (0.5 * w, arc.middle);
            self.segment(arc.point(from), arc.tangent(arc.first) * w, arc.tangent(from) * w, w.abs())?;
        }
        self.segment(end, arc.tangent(from) * w, arc.tangent(arc.last) * w, w.abs())
    }

    /// Adds a segment from the current point on, unless it has no extent.
    fn segment(&mut self, end: Point, leaving: Vector, arriving: Vector, w: f64) -> Step {
        let mut extent = 0.0;
        for v in [end - self.current, leaving, arriving] {
            extent += v.x.abs() + v.y.abs();
        }
        // Points are in range, so this is a quick test of the derivatives; what fails it is looked at closely.
        if extent.is_nan() || extent > LARGEST_COORDINATE {
            for v in [end, leaving * PART, arriving * PART] {
                self.within(v.x)?;
                self.within(v.y)?;
            }
        }
        if !self.open {
            self.open_subpath(self.start)?;
        }
        if extent >= LEAST_COORDINATE {
            self.points += 1;
            if self.points > MOST_PATH_POINTS {
                return self.failed(too_many("d", "maxPoints", MOST_PATH_POINTS, self.points));
            }
            self.subpath.push(self.current, end, leaving, arriving, w);
        }
        self.current = end;
        Some(())
    }

    fn open_subpath(&mut self, at: Point) -> Step {
        self.path.subpaths += 1;
        if self.path.subpaths > MOST_SUBPATHS {
            return self.failed(too_many("d", "maxSubpaths", MOST_SUBPATHS, self.path.subpaths));
        }
        self.open = true;
        (self.start, self.current) = (at, at);
        Some(())
    }

    fn close(&mut self) -> Step {
        self.current = self.start;
        if self.open { self.finish(true) } else { Some(()) }
    }

    /// Makes a curve of the open subpath, if it drew something.
    fn finish(&mut self, closed: bool) -> Step {
        self.open = false;
        match self.subpath.take(closed) {
            Ok(Some(curve)) => self.path.curves.push(curve),
            Ok(None) => {}
            Err(error) => return self.failed(error),
        }
        Some(())
    }

    /// The next byte, 0 at the end.
    fn byte(&self) -> u8 {
        self.text.get(self.at).copied().unwrap_or(0)
    }

    #[inline]
    fn skip_space(&mut self) {
        while let b' ' | b'\n' | b'\t' | b'\r' | b'\x0c' = self.byte() {
            self.at += 1;
        }
    }

    /// Skips what may be between two numbers: space, with at most one comma in it. Says whether there is one.
    #[inline]
    fn skip_separator(&mut self) -> bool {
        let mut comma = false;
        loop {
            match self.byte() {
                b' ' | b'\n' | b'\t' | b'\r' | b'\x0c' => {}
                b',' if !comma => comma = true,
                _ => return comma,
            }
            self.at += 1;
        }
    }

    #[inline]
    fn within(&mut self, value: f64) -> Step {
        // NaN fails as well.
        if value.abs() <= LARGEST_COORDINATE { Some(()) } else { self.beyond(value) }
    }

    #[cold]
    #[inline(never)]
    fn beyond(&mut self, value: f64) -> Step {
        let (least, most) = (-LARGEST_COORDINATE, LARGEST_COORDINATE);
        // What is left of a radius that grew beyond all numbers.
        let value = if value.is_nan() { f64::INFINITY } else { value };
        self.failed(Error::out_of_range("d", Some(self.group), value, least, most))
    }

    #[cold]
    #[inline(never)]
    fn failed(&mut self, error: Box<Error>) -> Step {
        self.failure.get_or_insert(error);
        None
    }

    #[cold]
    #[inline(never)]
    fn expected(&mut self, expected: &'static str) -> Step {
        self.path.truncation = Some(Truncation { offset: self.group, found: self.at, expected });
        None
    }
}
