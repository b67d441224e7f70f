//! A count of the pixels of a picture that show a colour.

use super::compression::{Compression, Squares};
use super::hues::{Edges, is_bled};
use super::mixture::{Premultiplied, is_like, is_on_edge, squared};
use super::palette::{Item, MOST_COLORS, palette_of};
use super::tint::{Color, Tint};
use crate::error::Result;
use crate::limits::{check, with_room};

/// Bits of each channel that tell bins apart.
const BITS: u32 = 5;
/// Less opacity is a share of a colour, not a colour, but where all around is the same.
const OPAQUE: u8 = 250;
/// Less is nothing.
const FAINT: u8 = 24;
/// Bits of each channel that tell bins of translucent colours apart.
const CLEAR_BITS: u32 = 4;
/// A pixel that is like its neighbours counts for as many in the middle of something thin, which mostly show more than
/// one colour.
const FLAT: u64 = 4;
/// A pixel at the end of so many that are the same, in a row or a column, is one of a line that was drawn along it.
const RULED: u8 = 12;
/// Rows that say which pixels of the one in the middle show a colour.
const ROWS: usize = 5;

/// What the pixels of a bin weigh that show a colour, how many of them are flat, how many there are at all, and the
/// weighted sums of channels and opacity.
#[derive(Clone, Copy, Debug, Default)]
struct Bin {
    weight: u64,
    flat: u64,
    /// How many have neighbours like them on all four sides, and how many have such that are the same.
    inner: u32,
    even: u32,
    all: u64,
    sums: [u64; 4],
    /// As much of the weight, and of the flat ones, as is on an edge of hues.
    bled: u64,
    bled_flat: u64,
}

/// Counts the colours of a picture that is given row by row. Pixels between two colours are on the way from one
/// neighbour to the one on the other side, so they do not count.
#[derive(Clone, Debug)]
pub struct Census {
    width: usize,
    /// Those of opaque colours, and then those of translucent ones, by what they are on white.
    bins: Vec<Bin>,
    /// The last rows. The one in the middle is counted next, once those below have come.
    window: [Vec<u8>; ROWS],
    /// How many pixels above each of that row are the same.
    runs: Vec<u8>,
    edges: Edges,
    squares: Squares,
}

impl Census {
    /// Begins a picture of that many columns.
    ///
    /// # Errors
    ///
    /// No memory: it needs 2.7 MB.
    pub fn new(width: usize) -> Result<Self> {
        let count = (1 << (3 * BITS)) + (1 << (3 * CLEAR_BITS));
        let mut bins = with_room(count)?;
        bins.resize(count, Bin::default());
        let mut runs = with_room(width)?;
        runs.resize(width, 0);
        Ok(Self {
            width,
            bins,
            window: Default::default(),
            runs,
            edges: Edges::default(),
            squares: Squares::new(width)?,
        })
    }

    /// More rows, from red, green, blue and opacity, a byte each.
    pub fn push_rgba_rows(&mut self, bytes: &[u8]) {
        for row in bytes.chunks_exact(4 * self.width.max(1)) {
            self.push(row);
        }
    }

    fn push(&mut self, row: &[u8]) {
        self.window.rotate_left(1);
        self.window[ROWS - 1].clear();
        self.window[ROWS - 1].extend_from_slice(row);
        self.count();
    }

    /// Counts the row in the middle of the window.
    fn count(&mut self) {
        let rows = self.window.each_ref().map(|row| row.as_chunks::<4>().0);
        let row = rows[ROWS / 2];
        self.edges.count(row);
        let mut along = 0;
        for ((column, pixel), down) in row.iter().enumerate().zip(&mut self.runs) {
            let longer = |run: u8, before: Option<&[u8; 4]>| {
                if before == Some(pixel) { run.saturating_add(1) } else { 0 }
            };
            let left = row.get(column.wrapping_sub(1));
            let run = along;
            along = longer(run, left);
            if run > along
                && let Some(left) = left
                && is_like(&pixel.map(i32::from), &left.map(i32::from))
            {
                self.squares.end(column, run);
            }
            *down = longer(*down, rows[ROWS / 2 - 1].get(column));
            if pixel[3] < FAINT {
                continue;
            }
            let Seen { weight, is_bled, is_inner, is_even } = seen(&rows, column, [*down, along]);
            // A share of a colour says which one that is, if nothing else does.
            let bin = &mut self.bins[index(pixel, weight > 0)];
            bin.all += 1;
            bin.weight += weight;
            let flat = u64::from(weight == FLAT);
            bin.flat += flat;
            bin.inner += u32::from(is_inner);
            bin.even += u32::from(is_even);
            if is_bled {
                bin.bled += weight;
                bin.bled_flat += flat;
            }
            for (sum, &channel) in bin.sums.iter_mut().zip(pixel) {
                *sum += weight * u64::from(channel);
            }
        }
    }

    /// At most `most` colours of all rows given, the last row being the lowest; those of most pixels first; fewer where
    /// there are no more, none where all is transparent.
    ///
    /// What is translucent is a colour where it is the same all around, and compared as it is on white.
    ///
    /// # Errors
    ///
    /// `most` below 2 or beyond 64.
    ///
    /// # Source
    ///
    /// \[Llo82\], \[Ott20\].
    pub fn palette(&mut self, most: usize) -> Result<Vec<Tint>> {
        check("colors", None, most as f64, 2.0, MOST_COLORS as f64)?;
        self.push(&[]);
        self.push(&[]);
        let compression = Compression { squares: self.squares.are_there(), shared_hues: self.shares_hues() };
        Ok(palette_of(&mut self.items()?, most, compression))
    }

    /// Whether pixels share their hues, several together, as compression (JPEG) makes them do.
    pub fn shares_hues(&self) -> bool {
        self.edges.are_wide()
    }

    /// Bins with something in them: by the pixels that show a colour or, where none is, by all of them.
    fn items(&self) -> Result<Vec<Item>> {
        let is_wide = self.shares_hues();
        let counts = |bin: &Bin| {
            if is_wide { (bin.weight - bin.bled, bin.flat - bin.bled_flat) } else { (bin.weight, bin.flat) }
        };
        let some = self.bins.iter().any(|bin| counts(bin).0 > 0);
        let mut items = with_room(self.bins.iter().filter(|bin| bin.all > 0).count())?;
        for (i, bin) in self.bins.iter().enumerate() {
            let (weight, flat) = counts(bin);
            let count = if some { weight } else { FLAT * bin.all };
            if count == 0 {
                continue;
            }
            let middle = |k: u32| (((i >> (BITS * k)) & ((1 << BITS) - 1)) << (8 - BITS)) as f64 + 3.5;
            let (mut rgb, mut opacity) = ([middle(2), middle(1), middle(0)], 255.0);
            if bin.weight > 0 {
                let [red, green, blue, all] = bin.sums.map(|sum| sum as f64 / bin.weight as f64);
                rgb = [red, green, blue];
                opacity = if i >> (3 * BITS) == 0 { 255.0 } else { all };
            }
            let weight = count as f64 / FLAT as f64;
            let kinds = [flat, u64::from(bin.inner), u64::from(bin.even)].map(|count| count as f64);
            items.push(Item::new(weight, kinds, rgb, opacity));
        }
        Ok(items)
    }
}

/// What is to the left, to the right, above and below at a distance. Beyond the border all is as it is on the other
/// side.
#[inline(never)]
fn around(rows: &[&[[u8; 4]]; ROWS], column: usize, reach: usize) -> [[u8; 4]; 4] {
    let middle = ROWS / 2;
    let at = |row: usize, column: usize| rows[row].get(column);
    let (left, right) = (at(middle, column.wrapping_sub(reach)), at(middle, column + reach));
    let (above, below) = (at(middle - reach, column), at(middle + reach, column));
    let or = |one: Option<&[u8; 4]>, other: Option<&[u8; 4]>| *one.or(other).unwrap_or(&rows[middle][column]);
    [or(left, right), or(right, left), or(above, below), or(below, above)]
}

/// What is seen of a pixel.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    /// What it counts for.
    weight: u64,
    /// Whether it is on an edge of hues.
    is_bled: bool,
    /// Whether all is alike around it, and whether all is the same.
    is_inner: bool,
    is_even: bool,
}

/// What is seen of a pixel, by the rows around it and by how many above it and on its left are the same.
fn seen(rows: &[&[[u8; 4]]; ROWS], column: usize, runs: [u8; 2]) -> Seen {
    let pixel = rows[ROWS / 2][column];
    let near = around(rows, column, 1);
    let is_even = near == [pixel; 4];
    let inner = Seen { weight: FLAT, is_bled: false, is_inner: true, is_even };
    if is_even {
        return inner;
    }
    if pixel[3] < OPAQUE {
        return Seen::default();
    }
    let (color, near) = (pixel.map(i32::from), near.map(|near| near.map(i32::from)));
    let is_alike = |k: usize| is_like(&color, &near[k]);
    let is_flat = is_alike(0) && is_alike(2);
    if is_flat && is_alike(1) && is_alike(3) {
        return inner;
    }
    if is_on_edge(&color, near.each_ref()) {
        return Seen::default();
    }
    let is_bled =
        is_bled(&color, &near) || is_bled(&color, &around(rows, column, 2).map(|far| far.map(i32::from)));
    // Ruled lines of one pixel are as flat as what is broader, if they are beside something else on both sides: what
    // two rows share of a line has the other half on one side.
    let is_ruled = |(run, across): (u8, &[Premultiplied])| {
        let step = squared(&across[0], &across[1]);
        run >= RULED && across.iter().all(|side| squared(&color, side) > step)
    };
    let is_flat = is_flat || runs.into_iter().zip(near.chunks_exact(2)).any(is_ruled);
    Seen { weight: if is_flat { FLAT } else { 1 }, is_bled, ..Seen::default() }
}

fn index(pixel: &[u8; 4], is_color: bool) -> usize {
    let number = |[red, green, blue]: Color, bits: u32| {
        let high = |channel: u8| usize::from(channel) >> (8 - bits);
        (high(red) << (2 * bits)) | (high(green) << bits) | high(blue)
    };
    let &[red, green, blue, opacity] = pixel;
    let own = Tint { color: [red, green, blue], opacity };
    if is_color && opacity < OPAQUE {
        return (1 << (3 * BITS)) + number(own.on_white(), CLEAR_BITS);
    }
    number(own.color, BITS)
}
