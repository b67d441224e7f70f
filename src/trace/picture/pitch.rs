//! Squares of two sizes by turns: which columns, or rows, of pixels begin one.

/// Squares come back after as many pixels at most where a picture may be a part of another: eleven tenths and what is
/// simpler.
const PERIOD: usize = 11;
/// As many columns in a row begin a square, at most, where each eleventh is there twice; squares that are hardly larger
/// than pixels are none.
const MOST_RUN: usize = PERIOD - 1;
/// The most that a whole picture was enlarged by, if not by a whole number: sixteen pixels to the size of a preview.
pub(super) const MOST_TIMES: usize = 16;
/// As many changes along rows and columns together would be expected where no square begins, if pixels had nothing to
/// do with squares; that there is none is a chance of one in e to that power. A drawing on a grid of its own was taken
/// for another grid at 6.6, and nothing that was not enlarged at 8.
const EVIDENCE: f64 = 8.0;
/// From so many times on it need not be as many: nothing that was not enlarged was taken for squares as large.
const ROOMY: f64 = 1.25;
/// And so many along each: shades side by side, as a gradient has them, say nothing across. Four sides of a band make
/// 1.3 at 1.5 times.
const LEAST: f64 = 1.5;

/// Columns, or rows, that are not like the one before.
#[derive(Clone, Debug, Default)]
pub(super) struct Changes {
    seen: Vec<bool>,
    first: usize,
    count: usize,
    /// The longest run of them.
    run: usize,
}

/// How squares follow each other along a row or a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::trace) struct Pitch {
    pub(in crate::trace) size: usize,
    /// So many squares lie in `size` pixels.
    pub(in crate::trace) count: usize,
    /// What the first square lacks, `count` times.
    pub(in crate::trace) lead: usize,
}

/// Whether shades between others are as broad as squares of a size would be.
pub(super) type AreAsBroad<'a> = &'a dyn Fn(f64) -> bool;

impl Pitch {
    /// How broad a square is, on the average.
    pub(in crate::trace) fn times(&self) -> f64 {
        self.size as f64 / self.count as f64
    }

    /// The square that a column or row is of.
    pub(super) fn square(&self, at: usize) -> usize {
        (at * self.count + self.lead) / self.size
    }

    /// The first column or row of a square.
    pub(super) fn first(&self, square: usize) -> usize {
        (square * self.size).saturating_sub(self.lead).div_ceil(self.count)
    }
}

impl Changes {
    /// A column or row is not like the one before: the first of these, if this one is new and squares may still be
    /// found.
    pub(super) fn note(&mut self, at: usize) -> Option<usize> {
        if self.seen.len() <= at {
            self.seen.resize(at + 1, false);
        }
        if self.is_over() || core::mem::replace(&mut self.seen[at], true) {
            return None;
        }
        if self.count == 0 {
            self.first = at;
        }
        self.count += 1;
        let is_seen = |at: &usize| self.seen.get(*at) == Some(&true);
        let before = (0..at).rev().take_while(is_seen).count();
        self.run = self.run.max(before + (at..).take_while(is_seen).count());
        Some(self.first)
    }

    /// Whether too many follow each other for squares of any size.
    pub(super) fn is_over(&self) -> bool {
        self.run > MOST_RUN
    }

    /// Looks no further.
    pub(super) fn end(&mut self) {
        self.run = usize::MAX;
    }

    /// Squares of one size.
    pub(super) fn even(&self, size: usize) -> Pitch {
        Pitch { size, count: 1, lead: (size - self.first % size) % size }
    }

    /// How many changes would be expected where none of such squares begins.
    fn evidence(&self, pitch: &Pitch) -> f64 {
        self.count as f64 * (1.0 - 1.0 / pitch.times())
    }

    /// Such squares, if nothing changes where none begins.
    #[inline(never)]
    fn of(&self, size: usize, count: usize, lead: usize) -> Option<Pitch> {
        let pitch = Pitch { size, count, lead };
        let begins = |at: usize| (at * count + lead) % size < count;
        let all = || (self.first..self.seen.len()).all(|at| !self.seen[at] || begins(at));
        (self.evidence(&pitch) >= LEAST && all()).then_some(pitch)
    }
}

/// Squares of two sizes by turns that all of a picture is made of: the largest. Where a change is, each of those begins
/// one, so none hides another that is unlike it.
pub(super) fn uneven(
    changed: &[Changes; 2],
    extent: [usize; 2],
    are_as_broad: AreAsBroad,
) -> Option<[Pitch; 2]> {
    let both = [whole(changed, extent, are_as_broad), recurring(changed, are_as_broad)];
    let is_evident = |grid: &[Pitch; 2]| {
        grid[0].times() >= ROOMY || changed[0].evidence(&grid[0]) + changed[1].evidence(&grid[1]) >= EVIDENCE
    };
    let evident = both.into_iter().flatten().filter(is_evident);
    evident.reduce(|a, b| if b[0].times() > a[0].times() { b } else { a })
}

/// Those that a whole picture has a whole number of. Each is where its middle is nearest, or its beginning.
///
/// # Proof
///
/// c columns and d rows of squares, enlarged by f, are W = c f + a and H = d f + b columns and rows of pixels, a and b
/// being what rounding adds: both from -1/2 to 1/2, or both from 0 to 1, or neither above 0. W d - H c = a d - b c,
/// which is less than c or d in each case.
#[inline(never)]
fn whole(
    changed: &[Changes; 2],
    [width, height]: [usize; 2],
    are_as_broad: AreAsBroad,
) -> Option<[Pitch; 2]> {
    for count in width.div_ceil(MOST_TIMES)..=width * MOST_RUN / PERIOD {
        if !are_as_broad(width as f64 / count as f64) {
            continue;
        }
        for lead in [|count: usize| count / 2, |count: usize| (count - 1) / 2, |_| 0] {
            let Some(columns) = changed[0].of(width, count, lead(count)) else { continue };
            let rows = |other: usize| {
                let is_as_high = (width * other).abs_diff(height * count) < count.max(other);
                if is_as_high { changed[1].of(height, other, lead(other)) } else { None }
            };
            if let Some(rows) = (1..height).find_map(rows) {
                return Some([columns, rows]);
            }
        }
    }
    None
}

/// Those that come back after a few pixels, beginning anywhere.
#[inline(never)]
fn recurring(changed: &[Changes; 2], are_as_broad: AreAsBroad) -> Option<[Pitch; 2]> {
    for count in 2..PERIOD {
        for size in count + 1..=PERIOD {
            if !are_as_broad(size as f64 / count as f64) {
                continue;
            }
            // Nothing is cut off, if that may be.
            let led = |changes: &Changes| {
                (0..size).find_map(|turn| changes.of(size, count, (turn + (count - 1) / 2) % size))
            };
            if let Some(columns) = led(&changed[0])
                && let Some(rows) = led(&changed[1])
            {
                return Some([columns, rows]);
            }
        }
    }
    None
}
