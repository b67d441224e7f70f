//! Control points from which a reader gets derivatives back to the last bit.

/// The coordinate c near p + d/3 for which 3·(c − p) is d again, to the last bit, if there is one.
#[inline(never)]
pub(super) fn returning(p: f64, d: f64) -> f64 {
    let third = d / 3.0;
    let mut found = None;
    around(third, 5, &mut |near| {
        found = around(p + near, 3, &mut |c| (c - p) * 3.0 == d);
        found.is_some()
    });
    found.unwrap_or(p + third)
}

/// The coordinate c for which 2·(c − p) is `leaving` and 2·(q − c) `arriving`, to the last bit.
#[inline(never)]
pub(super) fn returning_both(p: f64, leaving: f64, q: f64, arriving: f64) -> Option<f64> {
    let good = &mut |c: f64| (c - p) * 2.0 == leaving && (q - c) * 2.0 == arriving;
    let (one, two) = (p + 0.5 * leaving, q - 0.5 * arriving);
    // Near 0 there are many that one of the two allows, and few that both do: those between their bounds.
    let (a, b) = (0.25 * last_place(leaving), 0.25 * last_place(arriving));
    let both = 0.5 * ((one - a).max(two - b) + (one + a).min(two + b));
    [one, two, both].into_iter().find_map(|near| around(near, 5, good))
}

/// From a double to the next one further from 0.
fn last_place(value: f64) -> f64 {
    (neighbour(value, 1) - value).abs()
}

/// The first good one of `count` doubles: `near` itself, then by turns the next further from 0 and the next towards it.
#[inline(never)]
fn around(near: f64, count: i64, good: &mut dyn FnMut(f64) -> bool) -> Option<f64> {
    for k in 0..count {
        let c = neighbour(near, if k % 2 == 0 { -k / 2 } else { (k + 1) / 2 });
        if good(c) {
            return Some(c);
        }
    }
    None
}

/// The double `steps` places further from 0.
fn neighbour(value: f64, steps: i64) -> f64 {
    if value == 0.0 { value } else { f64::from_bits(value.to_bits().wrapping_add_signed(steps)) }
}
