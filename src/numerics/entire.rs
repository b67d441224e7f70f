//! The four even entire functions that every formula of the Hermite exponential splines is made of.
//!
//! ```text
//! sc(t) = sin t / t            V(t) = (1 − cos t) / t²
//! S(t)  = (t − sin t) / t³     J(t) = (sin t − t cos t) / t³
//! ```

/// `sin t / t`, 1 at 0.
pub fn sinc(t: f64) -> f64 {
    if t == 0.0 { 1.0 } else { libm::sin(t) / t }
}

/// `(1 − cos t) / t²`, 1/2 at 0.
pub fn versine(t: f64) -> f64 {
    let s = sinc(0.5 * t);
    0.5 * s * s
}

/// `(t − sin t) / t³`, 1/6 at 0.
pub fn sine_remainder(t: f64) -> f64 {
    if t.abs() > 1.0 {
        return (t - libm::sin(t)) / (t * t * t);
    }
    let u = t * t;
    let (mut term, mut sum, mut k) = (1.0 / 6.0, 0.0, 0.0);
    while k < 10.0 {
        sum += term;
        term *= -u / ((2.0 * k + 4.0) * (2.0 * k + 5.0));
        k += 1.0;
    }
    sum
}

/// `(sin t − t cos t) / t³`, 1/3 at 0.
pub fn sine_cosine_gap(t: f64) -> f64 {
    if t.abs() > 1.0 {
        return (libm::sin(t) - t * libm::cos(t)) / (t * t * t);
    }
    let u = t * t;
    let (mut factorial, mut sum, mut k) = (1.0 / 6.0, 0.0, 0.0);
    while k < 11.0 {
        sum += (2.0 * k + 2.0) * factorial;
        factorial *= -u / ((2.0 * k + 4.0) * (2.0 * k + 5.0));
        k += 1.0;
    }
    sum
}
