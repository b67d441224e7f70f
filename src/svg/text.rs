//! The text of a path while it is written: coordinates on a decimal grid, letters and separators.

use super::number;
use crate::numerics::Point;
use crate::numerics::plane::larger;

/// Grid indices up to this can be mirrored and subtracted in 64 bits.
const LARGEST_INDEX: f64 = 1.5e18;

/// Which decimal numbers coordinates may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct DecimalGrid {
    /// `None`: any `f64`, in the shortest text that brings it back.
    decimals: Option<u32>,
}

/// A coordinate as it is written.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Coordinate {
    /// What is read back.
    pub(super) value: f64,
    /// value·10^decimals; 0 where there is no grid.
    index: i64,
}

/// A point as it is written.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Placed {
    x: Coordinate,
    y: Coordinate,
}

impl Placed {
    pub(super) fn point(self) -> Point {
        Point::new(self.x.value, self.y.value)
    }
}

impl DecimalGrid {
    pub(super) const EXACT: Self = Self { decimals: None };

    /// `decimals` behind the point, or fewer where coordinates up to `largest` have no more to say: beyond
    /// 18 significant digits there are no bits left.
    pub(super) fn new(decimals: u32, largest: f64) -> Self {
        let mut decimals = decimals;
        while decimals > 0 && number::power(decimals) * largest > LARGEST_INDEX {
            decimals -= 1;
        }
        Self { decimals: Some(decimals) }
    }

    pub(super) fn decimals(self) -> Option<u32> {
        self.decimals
    }

    /// The distance between neighbouring numbers; 0 where there is no grid.
    #[inline(never)]
    pub(super) fn unit(self) -> f64 {
        self.decimals.map_or(0.0, |decimals| 1.0 / number::power(decimals))
    }

    fn coordinate(self, value: f64) -> Coordinate {
        let Some(decimals) = self.decimals else { return Coordinate { value, index: 0 } };
        let magnitude = number::scaled(value, decimals).min(LARGEST_INDEX as u64) as i64;
        self.at(if value < 0.0 { -magnitude } else { magnitude }, decimals)
    }

    fn at(self, index: i64, decimals: u32) -> Coordinate {
        let magnitude = number::inline_decimal(index.unsigned_abs(), -(decimals as i32));
        Coordinate { value: if index < 0 { -magnitude } else { magnitude }, index }
    }

    /// The nearest point that can be written.
    #[inline(never)]
    pub(super) fn place(self, p: Point) -> Placed {
        Placed { x: self.coordinate(p.x), y: self.coordinate(p.y) }
    }

    /// What a reader makes of `control` mirrored at `center`.
    pub(super) fn mirrored(self, control: Placed, center: Placed) -> Placed {
        let mirror = |a: Coordinate, c: Coordinate| match self.decimals {
            Some(decimals) => self.at(2 * c.index - a.index, decimals),
            None => Coordinate { value: 2.0 * c.value - a.value, index: 0 },
        };
        Placed { x: mirror(control.x, center.x), y: mirror(control.y, center.y) }
    }
}

/// A number that is no coordinate: a radius, an angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plain {
    negative: bool,
    digits: u64,
    decimals: u32,
}

impl Plain {
    /// `value` to `decimals`, rounded to the nearest.
    pub(super) fn nearest(value: f64, decimals: u32) -> Self {
        Self { negative: value < 0.0, digits: number::scaled(value, decimals), decimals }
    }

    /// The shortest text that brings `value` back.
    pub(super) fn shortest(value: f64) -> Self {
        let (digits, decimals) = number::shortest(value);
        Self { negative: value < 0.0, digits, decimals }
    }

    /// One unit of the last decimal less.
    pub(super) fn less(self) -> Self {
        Self { digits: self.digits.saturating_sub(1), ..self }
    }

    /// What is read back.
    pub(super) fn value(self) -> f64 {
        let magnitude = number::decimal(self.digits, -(self.decimals as i32));
        if self.negative { -magnitude } else { magnitude }
    }
}

/// The parameters of an `A` command before its end point.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArcText {
    /// Both radii and the rotation.
    pub(super) numbers: [Plain; 3],
    pub(super) large: bool,
    pub(super) positive: bool,
}

/// What came last, on which separators depend.
#[derive(Clone, Copy, Debug)]
struct Before {
    /// The command that numbers alone repeat.
    implied: u8,
    /// A number: another one needs something between.
    number: bool,
    /// That number has a point or an exponent: one that begins with a point may follow at once.
    pointed: bool,
}

/// Path data with as few characters as its grammar allows.
#[derive(Debug)]
pub(super) struct Text {
    out: Vec<u8>,
    before: Before,
    grid: DecimalGrid,
    /// Whether relative commands are written where they are shorter.
    relative: bool,
    /// Where the pen is.
    current: Placed,
    /// The size of the largest coordinate.
    pub(super) largest: f64,
}

impl Text {
    /// Begins a path at `start`, after one that has ended at `pen`.
    pub(super) fn new(grid: DecimalGrid, relative: bool, start: Placed, pen: Option<Point>) -> Self {
        // Differences of arbitrary doubles need not lead back to them.
        let relative = relative && grid.decimals.is_some();
        let before = Before { implied: 0, number: false, pointed: false };
        let mut text = Self { out: Vec::new(), before, grid, relative: false, current: start, largest: 0.0 };
        let pen = pen.filter(|_| relative).map(|pen| (grid.place(pen), pen));
        // What is written as a difference must be one of numbers of this grid.
        let pen = pen.filter(|(placed, pen)| placed.point() == *pen).map(|(placed, _)| placed);
        text.relative = pen.is_some();
        let from = pen.unwrap_or_default();
        text.command(b'M', None, &[(start.x, from.x), (start.y, from.y)]);
        // Numbers alone after a move are lines, absolute or relative as it is.
        text.before.implied -= b'M' - b'L';
        text.relative = relative;
        text
    }

    pub(super) fn current(&self) -> Placed {
        self.current
    }

    pub(super) fn close(&mut self) {
        self.out.extend_from_slice(b"Z");
    }

    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.out
    }

    /// A line, as `H` or `V` where it is level or upright; nothing where it has no length.
    pub(super) fn line(&mut self, end: Placed) {
        let (from, both) = (self.current, [(end.x, self.current.x), (end.y, self.current.y)]);
        match (end.x != from.x, end.y != from.y) {
            (false, false) => {}
            (true, true) => self.command(b'L', None, &both),
            (true, false) => self.command(b'H', None, &both[..1]),
            (false, true) => self.command(b'V', None, &both[1..]),
        }
        self.current = end;
    }

    /// `C`, `S`, `Q`: up to three points.
    pub(super) fn bezier(&mut self, letter: u8, points: &[Placed]) {
        let mut numbers = [(Coordinate::default(), Coordinate::default()); 6];
        for (pair, p) in numbers.chunks_exact_mut(2).zip(points) {
            pair.copy_from_slice(&[(p.x, self.current.x), (p.y, self.current.y)]);
        }
        self.command(letter, None, &numbers[..2 * points.len()]);
        self.current = points.last().copied().unwrap_or(self.current);
    }

    pub(super) fn arc(&mut self, arc: &ArcText, end: Placed) {
        self.command(b'A', Some(arc), &[(end.x, self.current.x), (end.y, self.current.y)]);
        self.current = end;
    }

    /// Writes a command with its coordinates, each with what a relative one counts from, and keeps the shorter of
    /// its absolute and relative forms.
    fn command(&mut self, letter: u8, arc: Option<&ArcText>, numbers: &[(Coordinate, Coordinate)]) {
        let (start, before) = (self.out.len(), self.before);
        self.form(letter, arc, numbers);
        if !self.relative {
            return;
        }
        let (middle, absolute) = (self.out.len(), self.before);
        self.before = before;
        self.form(letter | 0x20, arc, numbers);
        if self.out.len() - middle < middle - start {
            self.out.drain(start..middle);
        } else {
            self.out.truncate(middle);
            self.before = absolute;
        }
    }

    fn form(&mut self, letter: u8, arc: Option<&ArcText>, numbers: &[(Coordinate, Coordinate)]) {
        if letter != self.before.implied {
            self.out.extend_from_slice(&[letter]);
            self.before = Before { implied: letter, number: false, pointed: false };
        }
        if let Some(arc) = arc {
            for number in arc.numbers {
                self.plain(number);
            }
            for flag in [arc.large, arc.positive] {
                self.plain(Plain { negative: false, digits: u64::from(flag), decimals: 0 });
            }
        }
        let relative = letter & 0x20 != 0;
        for &(c, base) in numbers {
            self.largest = larger(self.largest, c.value.abs());
            let number = match self.grid.decimals {
                Some(decimals) => {
                    let index = if relative { c.index - base.index } else { c.index };
                    Plain { negative: index < 0, digits: index.unsigned_abs(), decimals }
                }
                None => Plain::shortest(c.value),
            };
            self.plain(number);
        }
    }

    #[inline(never)]
    fn plain(&mut self, number: Plain) {
        let Plain { negative, digits, decimals } = number;
        // Below 1, that is: no digit stands before the point.
        let bare = || digits != 0 && decimals <= 22 && number::below_one(digits, decimals);
        let before = if negative && digits != 0 {
            Some(b'-')
        } else {
            (self.before.number && !(self.before.pointed && bare())).then_some(b' ')
        };
        self.before.pointed = number::write(&mut self.out, before, digits, decimals);
        self.before.number = true;
    }
}
