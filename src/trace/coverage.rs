//! Which part of every pixel near an outline the outlines cover, exactly, and how that changes with their control points.

use super::blur::half_gaussian;
use super::gray::Gray;
use super::outline::Outline;
use super::tones::Tones;
use crate::error::Result;
use crate::limits::with_room;
use crate::numerics::Point;

/// Pixels around the picture that count as paper.
const FRAME: usize = 4;
/// Not a pixel of the band.
const OUTSIDE: u32 = u32::MAX;

/// The pixels near the outlines, with what the picture says of their coverage.
pub(super) struct Band {
    stride: usize,
    rows: usize,
    map: Vec<u32>,
    /// The pixels in the order of the rows.
    keys: Vec<u32>,
    pub(super) target: Vec<f32>,
    half: Vec<f64>,
}

/// How the coverage of one pixel changes with the eight coordinates of one piece's control points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    pub(super) pixel: u32,
    pub(super) weights: [f32; 8],
}

/// The coverage of the band, and the touches of all pieces in order.
pub(super) struct Coverage {
    pub(super) values: Vec<f32>,
    pub(super) touches: Vec<Touch>,
    /// The end of each piece's touches, over all outlines.
    pub(super) ends: Vec<usize>,
}

impl Band {
    /// The pixels within `reach` of the polylines.
    pub(super) fn new<'a>(
        gray: &Gray,
        tones: &Tones,
        inverted: bool,
        polylines: impl Iterator<Item = &'a [Point]>,
        reach: usize,
    ) -> Result<Self> {
        let (stride, rows) = (gray.width() + 2 * FRAME, gray.height() + 2 * FRAME);
        let mut map: Vec<u32> = with_room(stride * rows)?;
        map.resize(stride * rows, OUTSIDE);
        let reach = reach.min(FRAME) as isize;
        for polyline in polylines {
            let mut last = (isize::MIN, isize::MIN);
            for p in polyline {
                let here = (p.x.floor() as isize + FRAME as isize, p.y.floor() as isize + FRAME as isize);
                if here == last {
                    continue;
                }
                last = here;
                for row in (here.1 - reach).max(0)..=(here.1 + reach).min(rows as isize - 1) {
                    for column in (here.0 - reach).max(0)..=(here.0 + reach).min(stride as isize - 1) {
                        map[row as usize * stride + column as usize] = 0;
                    }
                }
            }
        }
        let count = map.iter().filter(|&&at| at == 0).count();
        let (mut keys, mut target) = (with_room(count)?, with_room(count)?);
        let (ink, span) = (tones.ink, tones.paper - tones.ink);
        for row in 0..rows {
            for column in 0..stride {
                let at = row * stride + column;
                if map[at] == OUTSIDE {
                    continue;
                }
                map[at] = keys.len() as u32;
                keys.push(at as u32);
                let inside = (FRAME..FRAME + gray.width()).contains(&column)
                    && (FRAME..FRAME + gray.height()).contains(&row);
                let dark = inside.then(|| 1.0 - (gray.shade(column - FRAME, row - FRAME) - ink) / span);
                let coverage = dark.map_or(0.0, |dark| if inverted { 1.0 - dark } else { dark });
                target.push(coverage as f32);
            }
        }
        Ok(Self { stride, rows, map, keys, target, half: half_gaussian(0.0) })
    }

    /// The blur of the picture, in pixels.
    fn set_blur(&mut self, sigma: f64) {
        self.half = half_gaussian(sigma);
    }

    /// The blur that makes the outlines' coverage most like the picture, in pixels.
    pub(super) fn find_blur(&mut self, outlines: &[Outline]) -> Result<()> {
        const STEP: f64 = 0.25;
        let values = self.cover(outlines)?.values;
        let mut squares = [f64::MAX; 9];
        for (i, square) in squares.iter_mut().enumerate() {
            self.set_blur(STEP * i as f64);
            let mut blurred = values.clone();
            self.blur(&mut blurred, true);
            *square = blurred.iter().zip(&self.target).map(|(a, b)| f64::from((a - b) * (a - b))).sum();
        }
        let best = (0..squares.len()).fold(0, |best, i| if squares[i] < squares[best] { i } else { best });
        let mut sigma = STEP * best as f64;
        if best > 0 && best + 1 < squares.len() {
            let (before, after) = (squares[best - 1] - squares[best], squares[best + 1] - squares[best]);
            sigma += STEP * 0.5 * (before - after) / (before + after).max(1e-12);
        }
        self.set_blur(if best == 0 { 0.0 } else { sigma });
        Ok(())
    }

    pub(super) fn len(&self) -> usize {
        self.keys.len()
    }

    fn index(&self, column: isize, row: isize) -> u32 {
        if (0..self.stride as isize).contains(&column) && (0..self.rows as isize).contains(&row) {
            self.map[row as usize * self.stride + column as usize]
        } else {
            OUTSIDE
        }
    }

    /// Blurs values of the band as the picture is blurred. What is beyond the band counts as 0, or as the pixel's own value.
    pub(super) fn blur(&self, values: &mut Vec<f32>, own: bool) {
        if self.half.len() < 2 {
            return;
        }
        for step in [1_isize, self.stride as isize] {
            let blurred = (0..values.len())
                .map(|i| {
                    let at = |offset: isize| {
                        let key = self.keys[i] as isize + offset;
                        let other = self.map.get(key as usize).copied().unwrap_or(OUTSIDE);
                        if other == OUTSIDE {
                            if own { f64::from(values[i].round()) } else { 0.0 }
                        } else {
                            f64::from(values[other as usize])
                        }
                    };
                    let mut sum = self.half[0] * f64::from(values[i]);
                    for (d, weight) in self.half.iter().enumerate().skip(1) {
                        sum += weight * (at(d as isize * step) + at(-(d as isize) * step));
                    }
                    sum as f32
                })
                .collect();
            *values = blurred;
        }
    }

    /// The exact coverage of the band by all outlines, not blurred, and the touches.
    pub(super) fn cover(&self, outlines: &[Outline]) -> Result<Coverage> {
        let mut sweep = Sweep { band: self, cells: Vec::new(), touches: Vec::new(), from: 0 };
        let mut ends = Vec::new();
        for outline in outlines {
            for i in 0..outline.len() {
                sweep.piece(outline, i);
                ends.push(sweep.touches.len());
            }
        }
        let mut cells = sweep.cells;
        // Stable: equal pixels add up in the order of the outlines, on every machine.
        cells.sort_by_key(|cell| cell.key);
        let mut values: Vec<f32> = with_room(self.len())?;
        let mut at = 0;
        let (mut row, mut running) = (u32::MAX, 0.0);
        for &key in &self.keys {
            let line = key / self.stride as u32;
            if line != row {
                row = line;
                running = 0.0;
                while at < cells.len() && cells[at].key / (self.stride as u32) < line {
                    at += 1;
                }
            }
            while at < cells.len() && cells[at].key < key {
                running += f64::from(cells[at].height);
                at += 1;
            }
            let mut value = running;
            while at < cells.len() && cells[at].key == key {
                value += f64::from(cells[at].area);
                running += f64::from(cells[at].height);
                at += 1;
            }
            values.push(-value as f32);
        }
        Ok(Coverage { values, touches: sweep.touches, ends })
    }
}

/// What one stretch of outline does to the row that it is in.
#[derive(Clone, Copy)]
struct Cell {
    key: u32,
    /// The area to the right of the stretch inside its own pixel.
    area: f32,
    /// The height of the stretch: the area in all pixels to the right.
    height: f32,
}

struct Sweep<'a> {
    band: &'a Band,
    cells: Vec<Cell>,
    touches: Vec<Touch>,
    /// The first touch of the piece.
    from: usize,
}

impl Sweep<'_> {
    fn piece(&mut self, outline: &Outline, i: usize) {
        self.from = self.touches.len();
        let cubic = outline.cubic(i);
        let steps = if outline.is_line(i) {
            1
        } else {
            // A chord of 1/n of a cubic is within |second difference|·6/(8n²) of it.
            let middle = cubic.end - cubic.start - cubic.leaving - cubic.arriving;
            let bend = (middle - cubic.leaving).norm().max((cubic.arriving - middle).norm());
            (bend * 750.0).sqrt().ceil().clamp(2.0, 4000.0) as usize
        };
        let weights = |t: f64| super::cubic::Cubic::bernstein(t);
        let mut before = cubic.start;
        for step in 0..steps {
            let (first, last) = (step as f64 / steps as f64, (step + 1) as f64 / steps as f64);
            let after = if step + 1 == steps { cubic.end } else { cubic.point(last) };
            self.edge(before, after, &|share| weights(first + (last - first) * share));
            before = after;
        }
    }

    /// Parts a straight edge at the borders of the pixels, rows and columns alike.
    fn edge(&mut self, from: Point, to: Point, weights: &dyn Fn(f64) -> [f64; 4]) {
        let frame = FRAME as f64;
        let start = [from.x + frame, from.y + frame];
        let way = [to.x - from.x, to.y - from.y];
        // The next border on each axis, as a share of the edge.
        let mut next = [2.0; 2];
        let mut step = [2.0; 2];
        for k in 0..2 {
            if way[k].abs() > 1e-12 {
                step[k] = 1.0 / way[k].abs();
                let rest = if way[k] > 0.0 {
                    start[k].floor() + 1.0 - start[k]
                } else {
                    start[k] - start[k].ceil() + 1.0
                };
                next[k] = rest * step[k];
            }
        }
        let mut share = 0.0;
        while share < 1.0 {
            let until = next[0].min(next[1]).min(1.0);
            if until > share {
                let middle = 0.5 * (share + until);
                let (x, y) = (start[0] + way[0] * middle, start[1] + way[1] * middle);
                let (dx, dy) = (way[0] * (until - share), way[1] * (until - share));
                self.part(x, y, dx, dy, weights(middle));
            }
            share = until;
            for k in 0..2 {
                if next[k] <= until {
                    next[k] += step[k];
                }
            }
        }
    }

    /// A part of an edge inside one pixel, by its middle and its extent.
    fn part(&mut self, x: f64, y: f64, dx: f64, dy: f64, weights: [f64; 4]) {
        let (column, row) = (x.floor(), y.floor());
        if row < 0.0 || row >= self.band.rows as f64 {
            return;
        }
        // Left of the frame it covers whole pixels; right of it nothing that is seen.
        let place = (column.max(0.0) as usize).min(self.band.stride - 1);
        let right = if column < 0.0 { 1.0 } else { (place as f64 + 1.0 - x).clamp(0.0, 1.0) };
        let key = (row as usize * self.band.stride + place) as u32;
        self.cells.push(Cell { key, area: (dy * right) as f32, height: dy as f32 });
        let pixel = self.band.index(column as isize, row as isize);
        if pixel == OUTSIDE {
            return;
        }
        let same = self.touches.len() > self.from && self.touches[self.touches.len() - 1].pixel == pixel;
        if !same {
            self.touches.push(Touch { pixel, weights: [0.0; 8] });
        }
        if let Some(touch) = self.touches.last_mut() {
            for (pair, weight) in touch.weights.chunks_exact_mut(2).zip(weights) {
                pair[0] += (weight * dy) as f32;
                pair[1] -= (weight * dx) as f32;
            }
        }
    }
}
