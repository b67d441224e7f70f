//! SVG path data → curves.

use super::arc::{Arc, ArcCommand};
use super::number;
use super::subpath::Subpath;
use crate::curve::HermiteCurve;
use crate::error::{Error, Result};
use crate::limits::LARGEST_COORDINATE;
use crate::numerics::{Point, Vector};

/// The longest path text that is read, in bytes.
pub const MOST_PATH_BYTES: usize = 8 << 20;
/// The most subpaths of one path, those that draw nothing included.
pub const MOST_SUBPATHS: usize = 100_000;
/// The most points of one path, over all its curves.
pub const MOST_PATH_POINTS: usize = 2_000_000;

/// What [`parse_path`] read.
#[derive(Clone, Debug, Default)]
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
/// [`Truncation`]. `OutOfRange` ⇐ a number, a coordinate or a derivative beyond ±1e9, with the byte offset.
/// `LimitExceeded` ⇐ more than [`MOST_PATH_BYTES`], [`MOST_SUBPATHS`] or [`MOST_PATH_POINTS`].
///
/// # Cost
///
/// O(bytes); allocates the curves alone.
///
/// # Source
///
/// `SVG 2, chapter 9 "Paths"` and its implementation notes on elliptical arcs (B.2).
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
    if d.len() > MOST_PATH_BYTES {
        return Err(limit("maxPathBytes", MOST_PATH_BYTES, d.len()));
    }
    let mut reader = Reader::new(d.as_bytes());
    let stopped = reader.read_all();
    match stopped {
        Err(Stop::Failed(error)) => return Err(error),
        Err(Stop::Syntax(truncation)) => reader.path.truncation = Some(truncation),
        Ok(()) => {}
    }
    reader.finish(false)?;
    match reader.path.truncation {
        Some(Truncation { found, expected, .. }) if reader.path.subpaths == 0 => {
            Err(Error::PathSyntax { offset: found, expected })
        }
        _ => Ok(reader.path),
    }
}

fn limit(limit: &'static str, most: usize, needed: usize) -> Error {
    Error::LimitExceeded { argument: "d", limit, most: most as f64, needed: needed as f64 }
}

/// Why reading stopped: text that makes no sense, or an error of the whole call.
enum Stop {
    Syntax(Truncation),
    Failed(Error),
}

type Step<T> = core::result::Result<T, Stop>;

/// What `S` or `T` goes on from: the derivative that arrived, or the control point to reflect.
#[derive(Clone, Copy)]
enum Previous {
    Other,
    Cubic(Vector),
    Quadratic(Point),
}

struct Reader<'a> {
    text: &'a [u8],
    at: usize,
    /// Where the numbers of the command being read start.
    group: usize,
    relative: bool,
    current: Point,
    start: Point,
    previous: Previous,
    /// Whether a subpath is open: a drawing command after `Z` opens a new one where the last one started.
    open: bool,
    subpath: Subpath,
    points: usize,
    path: ParsedPath,
}

impl<'a> Reader<'a> {
    fn new(text: &'a [u8]) -> Self {
        Self {
            text,
            at: 0,
            group: 0,
            relative: false,
            current: Point::zeros(),
            start: Point::zeros(),
            previous: Previous::Other,
            open: false,
            subpath: Subpath::default(),
            points: 0,
            path: ParsedPath::default(),
        }
    }

    fn read_all(&mut self) -> Step<()> {
        loop {
            self.skip_space();
            let Some(letter) = self.byte() else { return Ok(()) };
            self.group = self.at;
            let command = letter | 0x20;
            let known =
                matches!(command, b'a' | b'c' | b'h' | b'l' | b'm' | b'q' | b's' | b't' | b'v' | b'z');
            if !(letter.is_ascii_alphabetic() && known) {
                return self.expected(if self.path.subpaths == 0 {
                    "a moveto (M or m)"
                } else {
                    "a command"
                });
            }
            if self.path.subpaths == 0 && command != b'm' {
                return self.expected("a moveto (M or m)");
            }
            self.relative = letter & 0x20 != 0;
            self.at += 1;
            self.command(command)?;
        }
    }

    /// The command once, and again for as long as numbers follow.
    fn command(&mut self, command: u8) -> Step<()> {
        self.skip_space();
        if command == b'z' {
            return self.close();
        }
        self.group = self.at;
        let mut command = command;
        loop {
            match command {
                b'm' => self.moveto()?,
                b'a' => self.arc()?,
                b'h' | b'v' => self.axis_line(command == b'h')?,
                b'l' => {
                    let end = self.point()?;
                    self.line(end)?;
                }
                _ => self.bezier(command)?,
            }
            if command == b'm' {
                command = b'l';
            }
            self.skip_space();
            let comma = self.skip_comma();
            self.group = self.at;
            match self.byte() {
                Some(b'0'..=b'9' | b'+' | b'-' | b'.') => {}
                _ if comma => return self.expected("a number"),
                _ => return Ok(()),
            }
        }
    }

    fn moveto(&mut self) -> Step<()> {
        let to = self.point()?;
        self.finish(false).map_err(Stop::Failed)?;
        self.open_subpath(to)
    }

    fn open_subpath(&mut self, at: Point) -> Step<()> {
        self.path.subpaths += 1;
        if self.path.subpaths > MOST_SUBPATHS {
            return Err(Stop::Failed(limit("maxSubpaths", MOST_SUBPATHS, self.path.subpaths)));
        }
        self.open = true;
        self.previous = Previous::Other;
        (self.start, self.current) = (at, at);
        Ok(())
    }

    fn close(&mut self) -> Step<()> {
        if self.open {
            self.finish(true).map_err(Stop::Failed)?;
        }
        self.current = self.start;
        self.previous = Previous::Other;
        Ok(())
    }

    fn axis_line(&mut self, horizontal: bool) -> Step<()> {
        let value = self.number()?;
        let mut end = self.current;
        let coordinate = if horizontal { &mut end.x } else { &mut end.y };
        *coordinate = if self.relative { *coordinate + value } else { value };
        let end = self.checked(end)?;
        self.line(end)
    }

    fn line(&mut self, end: Point) -> Step<()> {
        let start = self.current;
        self.draw_bezier(end - start, start, end, 1.0)?;
        self.previous = Previous::Other;
        Ok(())
    }

    /// `C`, `S`, `Q` and `T`.
    fn bezier(&mut self, command: u8) -> Step<()> {
        let start = self.current;
        if matches!(command, b'c' | b's') {
            let leaving = match (command, self.previous) {
                (b'c', _) => (self.point()? - start) * 3.0,
                (_, Previous::Cubic(arriving)) => arriving,
                _ => Vector::zeros(),
            };
            let control = self.point()?;
            let end = self.point()?;
            self.draw_bezier(leaving, control, end, 3.0)?;
            self.previous = Previous::Cubic((end - control) * 3.0);
        } else {
            let control = match (command, self.previous) {
                (b'q', _) => self.point()?,
                (_, Previous::Quadratic(control)) => self.checked(start * 2.0 - control)?,
                _ => start,
            };
            let end = self.point()?;
            self.draw_bezier((control - start) * 2.0, control, end, 2.0)?;
            self.previous = Previous::Quadratic(control);
        }
        Ok(())
    }

    fn arc(&mut self) -> Step<()> {
        let radii = Vector::new(self.number()?, self.number()?);
        let command =
            ArcCommand { radii, rotation: self.number()?, large: self.flag()?, positive: self.flag()? };
        let offset = Vector::new(self.number()?, self.number()?);
        let start = self.current;
        let (end, chord) = if self.relative { (start + offset, offset) } else { (offset, offset - start) };
        let end = self.checked(end)?;
        if radii.x == 0.0 || radii.y == 0.0 {
            return self.line(end);
        }
        self.previous = Previous::Other;
        if end == start {
            return Ok(());
        }
        // Relative chords are as exact as their text; absolute ones carry the rounding of both ends.
        let size = if self.relative { 0.0 } else { start.amax().max(end.amax()) / chord.norm() };
        let arc = Arc::new(start, chord, &command, 4.0 * f64::EPSILON * (1.0 + size));
        let mut done = Ok(());
        arc.segments(|middle, leaving, arriving, w| {
            if done.is_ok() {
                done = self.draw_arc(middle.unwrap_or(end), leaving, arriving, w);
            }
        });
        done
    }

    /// Adds a line, parabola or cubic from the current point on, unless it has no extent.
    fn draw_bezier(&mut self, leaving: Vector, control: Point, end: Point, degree: f64) -> Step<()> {
        let start = self.current;
        let arriving = (end - control) * degree;
        self.begin_segment(end, leaving, arriving)?;
        if end != start || leaving != Vector::zeros() || arriving != Vector::zeros() {
            self.subpath.push_bezier(start, leaving, control, end, degree);
        }
        Ok(())
    }

    fn draw_arc(&mut self, end: Point, leaving: Vector, arriving: Vector, w: f64) -> Step<()> {
        let start = self.current;
        self.begin_segment(end, leaving, arriving)?;
        self.subpath.push(start, end, leaving, arriving, w);
        Ok(())
    }

    /// Checks a segment and moves the pen to its end.
    fn begin_segment(&mut self, end: Point, leaving: Vector, arriving: Vector) -> Step<()> {
        self.checked(end)?;
        self.checked(leaving)?;
        self.checked(arriving)?;
        if !self.open {
            self.open_subpath(self.start)?;
        }
        self.points += 1;
        if self.points > MOST_PATH_POINTS {
            return Err(Stop::Failed(limit("maxPoints", MOST_PATH_POINTS, self.points)));
        }
        self.current = end;
        Ok(())
    }

    /// Makes a curve of the open subpath, if it drew something.
    fn finish(&mut self, closed: bool) -> Result<()> {
        self.open = false;
        if let Some(curve) = self.subpath.take(closed)? {
            self.path.curves.push(curve);
        }
        Ok(())
    }

    fn byte(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    fn skip_space(&mut self) {
        while let Some(b' ' | b'\n' | b'\t' | b'\r' | b'\x0c') = self.byte() {
            self.at += 1;
        }
    }

    fn skip_comma(&mut self) -> bool {
        let comma = self.byte() == Some(b',');
        if comma {
            self.at += 1;
            self.skip_space();
        }
        comma
    }

    /// Space and at most one comma, unless a group of numbers just starts.
    fn skip_separator(&mut self) {
        if self.at != self.group {
            self.skip_space();
            self.skip_comma();
        }
    }

    fn number(&mut self) -> Step<f64> {
        self.skip_separator();
        let Some((value, end)) = number::read(self.text, self.at) else { return self.expected("a number") };
        if value.abs() > LARGEST_COORDINATE {
            return self.out_of_range(value);
        }
        self.at = end;
        Ok(value)
    }

    fn flag(&mut self) -> Step<bool> {
        self.skip_separator();
        let Some(digit @ (b'0' | b'1')) = self.byte() else { return self.expected("a flag (0 or 1)") };
        self.at += 1;
        Ok(digit == b'1')
    }

    fn point(&mut self) -> Step<Point> {
        let point = Point::new(self.number()?, self.number()?);
        if self.relative { self.checked(self.current + point) } else { Ok(point) }
    }

    fn checked(&self, v: Vector) -> Step<Vector> {
        // Written so that NaN fails as well.
        if v.x.abs() <= LARGEST_COORDINATE && v.y.abs() <= LARGEST_COORDINATE {
            return Ok(v);
        }
        self.out_of_range(if v.x.abs() <= LARGEST_COORDINATE { v.y } else { v.x })
    }

    fn out_of_range<T>(&self, value: f64) -> Step<T> {
        let (least, most) = (-LARGEST_COORDINATE, LARGEST_COORDINATE);
        Err(Stop::Failed(Error::OutOfRange { argument: "d", index: Some(self.group), value, least, most }))
    }

    fn expected<T>(&self, expected: &'static str) -> Step<T> {
        Err(Stop::Syntax(Truncation { offset: self.group, found: self.at, expected }))
    }
}
