//! Roots inside brackets: Newton's method that cannot leave, and cannot creep.

/// The root of a function that changes sign once on [lo, hi]; `rising` says that it goes from − to +.
///
/// `f` gives the value and the derivative. Newton steps are taken while they stay inside the bracket and at least
/// halve the last step but one, bisection otherwise, so that 120 evaluations are never exceeded. One copy serves all
/// callers: a call through a pointer is little beside an evaluation.
#[inline(never)]
pub(crate) fn bracketed_root(
    mut lo: f64,
    mut hi: f64,
    rising: bool,
    mut x: f64,
    f: &mut dyn FnMut(f64) -> (f64, f64),
) -> f64 {
    let mut last = hi - lo;
    let mut before = last;
    if !(x > lo && x < hi) {
        x = 0.5 * (lo + hi);
    }
    for _ in 0..120 {
        let (value, slope) = f(x);
        if value == 0.0 {
            return x;
        }
        if (value < 0.0) == rising {
            lo = x;
        } else {
            hi = x;
        }
        let newton = x - value / slope;
        let inside = newton > lo && newton < hi && (newton - x).abs() < 0.5 * before;
        let next = if inside { newton } else { 0.5 * (lo + hi) };
        before = last;
        last = (next - x).abs();
        let done = last <= 2.0 * f64::EPSILON * (lo.abs() + hi.abs()) || next == lo || next == hi;
        x = next;
        if done {
            break;
        }
    }
    x
}
