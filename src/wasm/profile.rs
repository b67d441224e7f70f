//! The paper's own tools: quasi-interpolants of clouds, their scores, profiles, metrics.

use super::describe::{describe, pairs};
use super::kernel::{Kernel, run, times};
use super::sections::section;
use crate::Result;
use crate::trace::{
    Chain, Cloud, End, Knots, ProfileOptions, QuasiInterpolant, directed_hausdorff, jaccard, leave_one_out,
    mean_absolute, root_mean_square,
};
use wasm_bindgen::prelude::wasm_bindgen;

/// The cloud and the knots in the input: so many points, two numbers each, and so many knots.
fn given(kernel: &Kernel, points: u32, knots: u32, degree: u32) -> Result<(Cloud, Knots)> {
    let numbers = kernel.given(times(points, 2).saturating_add(knots as usize));
    let (points, knots) = numbers.split_at(times(points, 2).min(numbers.len()));
    Ok((Cloud::new(&pairs(points))?, Knots::new(knots, degree as usize)?))
}

/// The coefficients of the quasi-interpolant of a cloud, by the mean of the nearest ordinates, in the output.
#[wasm_bindgen]
pub fn quasi_interpolate(points: u32, knots: u32, degree: u32, neighbours: u32) -> i32 {
    run(&mut |kernel| {
        let (cloud, knots) = given(kernel, points, knots, degree)?;
        let spline = QuasiInterpolant::of_means(&cloud, knots, neighbours as usize, [End::Free; 2])?;
        Ok(kernel.give(spline.coefficients().to_vec()))
    })
}

/// The root mean square error and the mean absolute one of predicting each point from all the others, in the record.
#[wasm_bindgen]
pub fn loo_score(points: u32, knots: u32, degree: u32, neighbours: u32) -> i32 {
    run(&mut |kernel| {
        let (cloud, knots) = given(kernel, points, knots, degree)?;
        let scores = leave_one_out(&cloud, &knots, neighbours as usize, [End::Free; 2])?;
        if let Some(score) = scores.last() {
            kernel.record([score.rmse, score.mae]);
        }
        Ok(0)
    })
}

/// The root mean square and the mean absolute value of the `count` numbers in the input, in the record.
#[wasm_bindgen]
pub fn residuals(count: u32) -> i32 {
    run(&mut |kernel| {
        let numbers = kernel.given(count as usize);
        let record = [root_mean_square(numbers.iter().copied()), mean_absolute(numbers.iter().copied())];
        kernel.record(record);
        Ok(0)
    })
}

/// Compares the first `first` points in the input with the `second` that follow: their directed Hausdorff distance and,
/// taken for pixels, both readings of the index of Jaccard, in the record.
#[wasm_bindgen]
pub fn compare(first: u32, second: u32) -> i32 {
    run(&mut |kernel| {
        let numbers = kernel.given(times(first, 2).saturating_add(times(second, 2)));
        let (first, second) = numbers.split_at(times(first, 2).min(numbers.len()));
        let (first, second) = (pairs(first), pairs(second));
        let pixels = |points: &[crate::numerics::Point]| -> Vec<(i32, i32)> {
            points.iter().map(|p| (libm::floor(p.x) as i32, libm::floor(p.y) as i32)).collect()
        };
        let index = jaccard(&pixels(&first), &pixels(&second));
        kernel.record([directed_hausdorff(&first, &second), index.tolerant, index.literal]);
        Ok(0)
    })
}

/// Follows the `points` points in the input, in their order, by one spline for each tube.
///
/// The output has the curve, the cusps, the metrics, and of each tube its first point, its number of points, the
/// interior knots and the neighbours that were chosen.
#[wasm_bindgen]
pub fn follow_profile(points: u32, closed: u32, degree: u32, printed: u32, angle: f64) -> i32 {
    run(&mut |kernel| {
        let chain = Chain::new(pairs(kernel.given(times(points, 2))), closed != 0)?;
        let mut options = if printed != 0 { ProfileOptions::printed() } else { ProfileOptions::default() };
        options.degree = degree as usize;
        if angle > 0.0 {
            options.cusps.angle = angle;
        }
        let profile = chain.follow(&options)?;
        let (curve, metrics) = (profile.curve()?, profile.metrics()?);
        let output = &mut Vec::new();
        section(output, &mut |to| describe(to, &curve));
        section(output, &mut |to| {
            to.extend(profile.cusps().iter().flat_map(|cusp| [cusp.point.x, cusp.point.y]))
        });
        section(output, &mut |to| {
            to.extend([metrics.rmse, metrics.mae, metrics.max, metrics.hausdorff, metrics.jaccard]);
        });
        section(output, &mut |to| {
            for (tube, fit) in profile.tubes().iter().zip(profile.fits()) {
                let choice =
                    fit.choice.map_or([0.0; 2], |choice| [choice.interior, choice.k].map(|n| n as f64));
                to.extend([tube.first as f64, tube.count as f64]);
                to.extend(choice);
            }
        });
        let numbers = core::mem::take(output);
        Ok(kernel.give(numbers))
    })
}
