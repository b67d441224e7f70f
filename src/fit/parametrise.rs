//! Which parameter belongs to which point.

use super::samples::Samples;
use crate::error::{Error, Result};
use crate::numerics::order::median;

/// How parameters are given to points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Parametrisation {
    /// By index where λ is asked for, as the papers do, and where points follow one another evenly; by smoothed arc
    /// length otherwise.
    #[default]
    Auto,
    /// t = 0, 1, 2 …: right where points follow one another evenly.
    Index,
    /// By the distances between the points: right where they are clean.
    Chord,
    /// By the square roots of the distances.
    Centripetal,
    /// By the length of a path through local averages, over as many points as the noise needs.
    ArcLength,
}

/// Parameters on [0, end], and the end. They ascend; one step is 1 on average.
///
/// `noise` is the standard deviation of the points, in the unit of the samples; only [`Parametrisation::ArcLength`]
/// looks at it. O(M).
pub fn parametrise(samples: &Samples, kind: Parametrisation, noise: f64) -> (Vec<f64>, f64) {
    let count = samples.points.len();
    let steps = if samples.closed { count } else { count.saturating_sub(1) };
    let step: &dyn Fn(usize) -> f64 = &|m| match kind {
        Parametrisation::Index => 1.0,
        Parametrisation::Chord => chord(samples, m, (0, 0)),
        Parametrisation::Centripetal => chord(samples, m, (0, 0)).sqrt(),
        Parametrisation::Auto | Parametrisation::ArcLength => 0.0,
    };
    let smooth = matches!(kind, Parametrisation::Auto | Parametrisation::ArcLength);
    let window = if smooth { window(samples, noise) } else { 0 };
    // Round the ends of an open curve there is nothing to average.
    let reach = |m: usize| match samples.closed {
        true => (window, window),
        false => (window.min(m), window.min(count - 2 - m)),
    };
    let mut parameters = Vec::with_capacity(count);
    let mut length = 0.0;
    for m in 0..steps {
        parameters.push(length);
        length += if smooth { chord(samples, m, reach(m)) } else { step(m) };
    }
    if !samples.closed {
        parameters.push(length);
    }
    let end = steps as f64;
    let unit = if length > 0.0 { end / length } else { 0.0 };
    // Index parameters are to be the integers themselves.
    if kind != Parametrisation::Index {
        parameters.iter_mut().for_each(|t| *t = (*t * unit).min(end));
    }
    (parameters, end)
}

/// Checks parameters that were given, and shifts them to start at 0; the end of the domain comes with them. A closed
/// curve has `period`, or goes on for one mean step after the last point.
///
/// # Errors
///
/// Another number of parameters than of points; one that is not finite, above 1e9 in size or below the one before it;
/// all the same; a period that is not longer than they are.
pub fn given(parameters: &[f64], count: usize, closed: bool, period: Option<f64>) -> Result<(Vec<f64>, f64)> {
    if parameters.len() != count {
        return Err(Error::wrong_length("parameters", parameters.len(), count));
    }
    let first = parameters.first().copied().unwrap_or(0.0);
    for (i, &t) in parameters.iter().enumerate() {
        if !t.is_finite() || t.abs() > crate::limits::LARGEST_COORDINATE {
            let most = crate::limits::LARGEST_COORDINATE;
            return Err(Error::unfit("parameters", Some(i), t, -most, most));
        }
        if i > 0 && t < parameters[i - 1] {
            return Err(Error::degenerate("parameters", Some(i), "they must not decrease"));
        }
    }
    let span = parameters.last().copied().unwrap_or(0.0) - first;
    if span <= 0.0 {
        return Err(Error::degenerate("parameters", None, "they are all equal"));
    }
    let mean = span * count as f64 / (count - 1) as f64;
    let end = if closed { period.unwrap_or(mean) } else { span };
    if end < span || (closed && end <= span) || !end.is_finite() {
        // A closed curve comes back after its last point: the least period is the next number.
        let least = if closed { span.next_up() } else { span };
        return Err(Error::out_of_range("period", None, end, least, crate::limits::LARGEST_COORDINATE));
    }
    Ok((parameters.iter().map(|t| t - first).collect(), end))
}

/// How many points to each side are averaged, for steps that the noise changes by about a seventh.
fn window(samples: &Samples, noise: f64) -> usize {
    let mut steps = samples.steps();
    let median = median(&mut steps);
    // Noise makes steps longer; what is left without it is a guess for the spacing.
    let clean = (median * median - 2.0 * noise * noise).max(0.04 * median * median).sqrt();
    let wanted = 5.0 * noise / clean.max(1e-300);
    (wanted as usize).min(samples.points.len() / 20).min(40)
}

/// The step from the average of the points around point m to that of the next one's, so many `behind` and `ahead`.
fn chord(samples: &Samples, m: usize, (behind, ahead): (usize, usize)) -> f64 {
    let (points, count) = (&samples.points, samples.points.len());
    let (from, to) = (points[(m + count - behind) % count], points[(m + 1 + ahead) % count]);
    (to - from).norm() / (behind + ahead + 1) as f64
}
