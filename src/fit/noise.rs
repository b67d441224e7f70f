//! How noisy points are, found from the points alone.

use super::outline::{MOST_CORNERED, SHARP, cosine, steps};
use super::report::size_of;
use super::samples::Samples;
use crate::numerics::order::{median, sort_numbers};
use crate::numerics::{Point, Vector};

/// Fourth, sixth and eighth differences, each from its middle on, and the sum of their squares: the fourth leaves
/// nothing of a cubic, and of white noise √70 times its size.
const DIFFERENCES: [(&[f64], f64); 3] = [
    (&[6.0, -4.0, 1.0], 70.0),
    (&[20.0, -15.0, 6.0, -1.0], 924.0),
    (&[70.0, -56.0, 28.0, -8.0, 1.0], 12870.0),
];
/// Where higher differences find such a part of the noise that lower ones do, those saw the shape: of white noise all
/// find the same, this much less in one of a hundred lists of a dozen points.
const LESS: f64 = 0.5;
/// What is such a part of the drawing may be noise all the same: nearer to few points a curve has to bend for each of
/// them.
const FAINT: f64 = 1e-3;
/// The median of |N(0, 1)|.
const MEDIAN: f64 = 0.674_489_750_196_081_7;
/// Half the length of the chord that tells which way is across.
const REACH: usize = 5;
/// The step that closes a contour is another one than those beside it where the difference is such a part of a step and
/// so many standard deviations of the noise, which moves it by 2.2 of them.
const OTHER: f64 = 0.1;
const SCATTERED: f64 = 5.0;
/// Spacing is looked at over a part of all points, and over so many of them at most.
const STRETCH: usize = 50;
const LONGEST: usize = 40;
/// How much more points scatter along the curve than across it where they are even, by chance, and by how much more
/// that may be where stretches are few.
const ALIKE: f64 = 1.3;
const BY_CHANCE: f64 = 2.0;
/// What a step may be another one by, and what noise hides that in, as parts of a step.
const SLACK: f64 = 0.02;
const HIDING: f64 = 0.2;
/// By which part the lengths of stretches may differ from one quartile to the other, and by how many standard
/// deviations of the noise: the noise of both ends makes it 1.9 of them, and chance half as much again.
const UNSTEADY: f64 = 0.35;
const BY_NOISE: f64 = 2.9;
/// What is so many steps long is no step but a jump, which no point says anything about.
const JUMP: f64 = 8.0;
/// So many times as long as the steps beside it, noise apart, is the one over a gap, where points are missing.
const GAP: f64 = 4.0;
/// Steps to each side that are looked at: two, as a single point far off has two long ones.
const BESIDE: usize = 2;
/// So many points tell about their noise, and fewer than so many may be vertices of a polygon instead.
const LEAST: usize = 9;
const VERTICES: usize = 64;
/// Noise that is such a part of the drawing leaves none: of a closed one, and of open ones of fewer points than so
/// many. Differences of few points see corners, narrow bends and steps of all lengths as noise.
const SHAPELESS: f64 = 0.14;
const OPEN: [(usize, f64); 2] = [(12, 0.03), (32, 0.06)];
/// Cosines that are no farther apart are of one angle.
const EQUAL: f64 = 1e-6;
/// Of many points that are no slope on a grid one in so many turns sharply as the one before it did.
const ONWARD: usize = 3;
/// So many places tell a median to half a per cent: of more points, evenly chosen ones are looked at.
const ENOUGH: usize = 20_000;

/// The standard deviation of the noise across the curve, in the unit of the samples, from the median size of fourth
/// differences: corners and outliers are too few to move a median. Of fewer than 64 points sixth and eighth ones are
/// looked at as well, for a curve may bend much from one to the next.
///
/// Clean points give a number far below their spacing. Fewer than nine points give 0, and so do the vertices of a
/// polygon: where half of at most 500 turn by one angle of more than 50° (from 64 on, where that is no staircase), and
/// few points that would be off by much of their box: fewer than 64 of a closed curve by a seventh, fewer than 32 of an
/// open one by a sixteenth, fewer than 12 by a thirtieth. O(M log M).
///
/// # Accuracy
///
/// Within 10 % for 300 points and more whose curve turns little from one to the next (`tests/fit/data.rs`).
pub fn noise(samples: &Samples) -> f64 {
    levels(samples)[0]
}

/// Whether the points follow one another so evenly that their index is a parameter: along the curve they scatter hardly
/// more than across it, over longer stretches as well, where what spacing does by chance adds up. O(M log M).
pub fn is_regular(samples: &Samples) -> bool {
    is_regular_at(samples, levels(samples))
}

/// The same where the standard deviations are known.
pub(super) fn is_regular_at(samples: &Samples, [across, along]: [f64; 2]) -> bool {
    let points = &samples.points;
    if points.len() < LEAST {
        return false;
    }
    let mut steps = samples.steps();
    if has_gaps(&steps, across) {
        return false;
    }
    let around = 0.5 * (steps[0] + steps[steps.len() - 1]);
    let median = median(&mut steps);
    // A contour that was walked in even steps seldom ends one step before its first point.
    let last = (points[points.len() - 1] - points[0]).norm();
    let (other, most) = (OTHER * median + SCATTERED * across, JUMP * median);
    let ends = !samples.closed || (last - around).abs() < other || last > most;
    ends && along <= ALIKE * across + SLACK * median
        && (across < HIDING * median || !adds_up(samples, across))
}

/// Whether points are missing somewhere. Medians do not show that, and a hand that hurries takes longer steps one by
/// one.
fn has_gaps(steps: &[f64], noise: f64) -> bool {
    steps.windows(2 * BESIDE + 1).any(|around| {
        let beside = (0..around.len()).filter(|&m| m != BESIDE).fold(0.0, |most, m| around[m].max(most));
        around[BESIDE] > GAP * beside + SCATTERED * noise
    })
}

/// Whether points are about as far apart nearly everywhere: between the quartiles of the lengths of stretches there is
/// little but noise. What changes slowly no difference of neighbours shows; a hand that draws is slow where it begins,
/// ends and turns.
pub(super) fn is_steady(samples: &Samples, noise: f64) -> bool {
    let (points, count) = (&samples.points, samples.points.len());
    let stretch = stretch(count);
    let begins = if samples.closed { 0..count } else { 0..count - stretch };
    let length = |m: usize| (points[(m + stretch) % count] - points[m]).norm();
    let mut lengths: Vec<f64> = begins.step_by(count.div_ceil(ENOUGH)).map(length).collect();
    sort_numbers(&mut lengths);
    let [low, middle, high] = [1, 2, 3].map(|quarter| lengths[quarter * (lengths.len() - 1) / 4]);
    high - low <= UNSTEADY * middle + BY_NOISE * noise
}

/// Whether spacing changes by more than noise, over stretches that are long enough for what it does by chance to be
/// seen in it.
fn adds_up(samples: &Samples, noise: f64) -> bool {
    let count = samples.points.len();
    let stretch = stretch(count);
    let chance = BY_CHANCE * (stretch as f64 / count as f64).sqrt();
    over(samples, stretch) > (ALIKE + chance) * noise
}

/// How many steps a stretch is long among so many points.
fn stretch(count: usize) -> usize {
    (count / STRETCH).clamp(1, LONGEST)
}

/// The standard deviation along the curve that explains how far points are off the middle of those a stretch away on
/// either side, if they are even: by the median size, as noise is.
fn over(samples: &Samples, stretch: usize) -> f64 {
    let (points, count) = (&samples.points, samples.points.len());
    let centers = if samples.closed { 0..count } else { stretch..count - stretch };
    let off = |m: usize| {
        let (before, after) = (points[(m + count - stretch) % count], points[(m + stretch) % count]);
        let (chord, difference) = (after - before, before + after - 2.0 * points[m]);
        let length = chord.norm();
        if length > 0.0 { chord.dot(&difference).abs() / length } else { 0.0 }
    };
    let mut sizes: Vec<f64> = centers.step_by(count.div_ceil(ENOUGH)).map(off).collect();
    // The sum of the squared weights of this difference.
    median(&mut sizes) / (MEDIAN * 6.0_f64.sqrt())
}

/// Standard deviations across and along the curve; 0 where nothing tells about them.
pub(super) fn levels(samples: &Samples) -> [f64; 2] {
    let points = &samples.points;
    let count = points.len();
    if count < LEAST || (count <= MOST_CORNERED && turn_alike(samples)) {
        return [0.0; 2];
    }
    let mut levels = levels_by(samples, DIFFERENCES[0]);
    if count < VERTICES {
        for higher in &DIFFERENCES[1..] {
            let finer = levels_by(samples, *higher);
            if finer[0] >= LESS * levels[0] {
                break;
            }
            let faint = FAINT * size_of(points);
            levels = [0, 1].map(|part| finer[part].max(levels[part].min(faint)));
        }
    }
    let few = if samples.closed { &[(VERTICES, SHAPELESS)][..] } else { &OPEN };
    let most = few.iter().find(|(fewer, _)| count < *fewer).map_or(1.0, |(_, most)| *most);
    if levels[0] > most * size_of(points) { [0.0; 2] } else { levels }
}

/// What differences of one order find.
fn levels_by(samples: &Samples, (weights, squares): (&[f64], f64)) -> [f64; 2] {
    let (points, count, reach) = (&samples.points, samples.points.len(), weights.len() - 1);
    let centers = if samples.closed { 0..count } else { reach..count - reach };
    let sizes: Vec<[f64; 2]> =
        centers.step_by(count.div_ceil(ENOUGH)).map(|m| parts(points, samples.closed, m, weights)).collect();
    [0, 1].map(|part| {
        let mut sizes: Vec<f64> = sizes.iter().map(|size| size[part]).collect();
        median(&mut sizes) / (MEDIAN * squares.sqrt())
    })
}

/// Whether at half of the points the way turns sharply by the same angle: that is drawn, and no noise. Of many points
/// the right angles of a staircase, left and right by turns, are a slope on a grid.
pub(super) fn turn_alike(samples: &Samples) -> bool {
    let steps = steps(samples);
    let count = steps.len() - usize::from(!samples.closed);
    let turn = |m: usize| {
        let (before, after) = (steps[m], steps[(m + 1) % steps.len()]);
        (cosine(before, after), cross(before, after) > 0.0)
    };
    let turns: Vec<(f64, bool)> = (0..count).map(turn).collect();
    let is_onward = |pair: &&[(f64, bool)]| pair.iter().all(|turn| turn.0 < SHARP) && pair[0].1 == pair[1].1;
    let stairs =
        samples.points.len() >= VERTICES && ONWARD * turns.windows(2).filter(is_onward).count() < count;
    let most = if stairs { -EQUAL } else { SHARP };
    let mut cosines: Vec<f64> = turns.iter().map(|turn| turn.0).collect();
    sort_numbers(&mut cosines);
    cosines
        .windows(count.div_ceil(2))
        .any(|alike| alike[alike.len() - 1] - alike[0] < EQUAL && alike[alike.len() - 1] < most)
}

/// The size of a difference around point m, across the curve and along it.
fn parts(points: &[Point], closed: bool, m: usize, weights: &[f64]) -> [f64; 2] {
    let count = points.len();
    let at = |steps: usize, back: bool| {
        let i = match (closed, back) {
            (true, true) if m < steps => m + count - steps,
            (true, false) if m + steps >= count => m + steps - count,
            (true, true) => m - steps,
            (true, false) => m + steps,
            (false, true) => m.saturating_sub(steps),
            (false, false) => (m + steps).min(count - 1),
        };
        points[i]
    };
    let mut difference = weights[0] * points[m];
    for (i, weight) in weights.iter().enumerate().skip(1) {
        difference += (at(i, true) + at(i, false)) * *weight;
    }
    let chord = at(REACH, false) - at(REACH, true);
    let length = chord.norm();
    if length > 0.0 {
        [cross(chord, difference).abs() / length, chord.dot(&difference).abs() / length]
    } else {
        [difference.norm() * 0.5_f64.sqrt(); 2]
    }
}

/// A weight for every point, one but for those far off the middle of their eight neighbours, and the points with those
/// as near as they may be: however little it counts, the square of a distance may be worth knots.
///
/// Far is six standard deviations and as many steps as the neighbours themselves are away from that middle: corners
/// are not far. O(M).
pub(super) fn sober(samples: &Samples, noise: f64) -> (Vec<f64>, Vec<Point>) {
    const AROUND: usize = 4;
    const LITTLE: f64 = 1e-3;
    let points = &samples.points;
    let count = points.len();
    let weigh = |m: usize| {
        if count < 4 * AROUND || (!samples.closed && (m < AROUND || m + AROUND >= count)) {
            return (1.0, points[m]);
        }
        let near = |k: usize| points[(m + count + k - AROUND) % count];
        let middle = |pick: &dyn Fn(Point) -> f64| {
            let mut values: Vec<f64> =
                (0..=2 * AROUND).filter(|k| *k != AROUND).map(|k| pick(near(k))).collect();
            sort_numbers(&mut values);
            0.5 * (values[AROUND - 1] + values[AROUND])
        };
        let center = Point::new(middle(&|p| p.x), middle(&|p| p.y));
        let mut apart: Vec<f64> =
            (0..=2 * AROUND).filter(|k| *k != AROUND).map(|k| (near(k) - center).norm()).collect();
        sort_numbers(&mut apart);
        // The sixth of eight: up to two of the neighbours may be outliers themselves.
        let limit = 6.0 * noise + 1.5 * apart[AROUND + 1];
        let way = points[m] - center;
        let share = limit / way.norm();
        if share < 1.0 { (LITTLE, center + way * share) } else { (1.0, points[m]) }
    };
    (0..count).map(weigh).unzip()
}

pub(super) fn cross(a: Vector, b: Vector) -> f64 {
    a.x * b.y - a.y * b.x
}
