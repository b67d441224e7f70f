//! What the promises in this folder share: the golden data, test curves and the tolerances.

#![allow(dead_code, reason = "every file of promises takes what it needs")]

pub(crate) mod colors;
pub(crate) mod contours;
pub(crate) mod curves;
pub(crate) mod drawing;
pub(crate) mod golden;
pub(crate) mod pictures;
pub(crate) mod printing;
pub(crate) mod tolerance;

use expline::generator::{HermiteGenerators, Root, Roots, Space};

/// The space of a golden file's case.
pub(crate) fn space(name: &str) -> Space {
    match name {
        "hyperbolic" => Space::Hyperbolic,
        "polynomial" => Space::Polynomial,
        _ => Space::Trigonometric,
    }
}

/// Generators that are known to be valid.
pub(crate) fn generators(space: Space, omega: f64) -> HermiteGenerators {
    HermiteGenerators::new(omega, space).expect("the frequency is in its range")
}

/// The largest absolute value, at least 1: golden data is compared relative to it.
pub(crate) fn scale(values: &[f64]) -> f64 {
    values.iter().fold(1.0, |most: f64, v| most.max(v.abs()))
}

/// Asserts that two lists agree within `tolerance` of the largest expected value (at least 1).
pub(crate) fn assert_all_close(what: &str, got: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(got.len(), expected.len(), "{what}: number of values");
    let scale = scale(expected);
    for (i, (got, expected)) in got.iter().zip(expected).enumerate() {
        let deviation = (got - expected).abs() / scale;
        assert!(deviation <= tolerance, "{what}[{i}]: {got} for {expected}, off by {deviation:e} of {scale}");
    }
}

/// A result whose error can be matched.
pub(crate) fn unboxed<T>(result: expline::Result<T>) -> Result<T, expline::Error> {
    result.map_err(|error| *error)
}

/// The roots of a golden file's case.
pub(crate) fn roots(list: &[Vec<f64>]) -> Roots {
    let list: Vec<Root> = list.iter().map(|r| Root { re: r[0], im: r[1] }).collect();
    Roots::new(&list, "roots").expect("the golden roots are within the limits")
}
