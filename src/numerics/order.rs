//! Sorting, with one copy of the code for all lists.
//!
//! The standard library's sorts are made anew for every kind of element and every comparison, two to eight kilobytes of
//! wasm each: they were a quarter of fitting and of tracing. Here what is compared are one or two whole numbers made of
//! each element, in one place.

/// What an element is sorted by: the first number, and the second among those with the same first.
pub(crate) type Key = [u64; 2];

/// Lists to this length are sorted by insertion.
const SHORT: usize = 16;
/// And lists of small elements to this one, where no other memory is to be used.
const BRIEF: usize = 48;
/// Rounds of partition after which a list is sorted instead.
const MOST_ROUNDS: usize = 64;

/// A number as one that is compared like a whole number, in the order of `f64::total_cmp`.
pub(crate) fn key_of(value: f64) -> u64 {
    let bits = value.to_bits();
    bits ^ ((bits as i64 >> 63) as u64 | 1 << 63)
}

#[derive(Clone, Copy)]
struct Entry {
    key: Key,
    place: u32,
}

/// Whether an element may stand before another.
fn ordered(first: &Entry, second: &Entry) -> bool {
    first.key[0] < second.key[0] || first.key[0] == second.key[0] && first.key[1] <= second.key[1]
}

/// Sorts numbers in the order of `f64::total_cmp`.
#[inline(never)]
pub(crate) fn sort_numbers(values: &mut [f64]) {
    if values.len() > SHORT {
        return sort_by_number(values, &|value| *value);
    }
    for i in 1..values.len() {
        let (value, mut k) = (values[i], i);
        while k > 0 && key_of(value) < key_of(values[k - 1]) {
            values[k] = values[k - 1];
            k -= 1;
        }
        values[k] = value;
    }
}

/// Sorts a list by a number of each element; those with the same number stay in their order.
pub(crate) fn sort_by_number<T>(list: &mut [T], number: &dyn Fn(&T) -> f64) {
    sort_by_keys(list, &|item| [key_of(number(item)), 0]);
}

/// Sorts a list by a key of each element; those with the same key stay in their order. O(n log n), and O(n) for short
/// or sorted lists.
#[inline(never)]
pub(crate) fn sort_by_keys<T>(list: &mut [T], key: &dyn Fn(&T) -> Key) {
    let mut order = Vec::with_capacity(list.len());
    for item in &*list {
        order.push(Entry { key: key(item), place: order.len() as u32 });
    }
    sort_entries(&mut order);
    // Round every cycle of the permutation; a place that has what belongs there names itself.
    for start in 0..list.len() {
        let mut at = start;
        loop {
            let from = core::mem::replace(&mut order[at].place, at as u32) as usize;
            if from == start {
                break;
            }
            list.swap(at, from);
            at = from;
        }
    }
}

/// Sorts a list of numbers of any kind in place, without more memory; equal ones cannot be told apart. O(n log n).
#[inline(never)]
pub(crate) fn sort_in_place<T: Copy + PartialOrd>(list: &mut [T]) {
    let count = list.len();
    if count <= BRIEF {
        return insert(list);
    }
    if list.is_sorted() {
        return;
    }
    // A heap is made from its middle, and then taken apart from its end.
    for step in 0..count / 2 + count {
        let (top, end) = if step < count / 2 {
            (count / 2 - 1 - step, count)
        } else {
            (0, count - 1 - (step - count / 2))
        };
        if step >= count / 2 {
            list.swap(0, end);
        }
        let (mut at, moved) = (top, list[top]);
        loop {
            let mut child = 2 * at + 1;
            if child + 1 < end && list[child] < list[child + 1] {
                child += 1;
            }
            if child >= end || list[child] <= moved {
                break;
            }
            list[at] = list[child];
            at = child;
        }
        list[at] = moved;
    }
}

/// Sorts a short list by moving each element to its place.
fn insert<T: Copy + PartialOrd>(list: &mut [T]) {
    for i in 1..list.len() {
        let (value, mut k) = (list[i], i);
        while k > 0 && value < list[k - 1] {
            list[k] = list[k - 1];
            k -= 1;
        }
        list[k] = value;
    }
}

/// The element that is number k of the sorted list; the list is left in another order. O(n), after 64 rounds O(n log
/// n).
///
/// The list must have that many elements.
#[inline(never)]
pub(crate) fn nth(values: &mut [f64], k: usize) -> f64 {
    let (mut low, mut high) = (0, values.len() as isize - 1);
    for _ in 0..MOST_ROUNDS {
        if low >= high {
            return values[k];
        }
        // Hoare's partition around the number that stands there: what is between `behind` and `from` afterwards is in
        // its place.
        let (pivot, mut from, mut behind) = (values[k], low, high);
        while from <= behind {
            if values[from as usize] < pivot {
                from += 1;
            } else if pivot < values[behind as usize] {
                behind -= 1;
            } else {
                values.swap(from as usize, behind as usize);
                from += 1;
                behind -= 1;
            }
        }
        if behind < k as isize {
            low = from;
        }
        if from > k as isize {
            high = behind;
        }
    }
    sort_numbers(values);
    values[k]
}

/// The median, of an even number the upper one; 0 of none. The list is left in another order.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() { 0.0 } else { nth(values, values.len() / 2) }
}

/// Insertion in short runs, and then merging of runs.
#[inline(never)]
fn sort_entries(entries: &mut Vec<Entry>) {
    let count = entries.len();
    for run in entries.chunks_mut(SHORT) {
        for i in 1..run.len() {
            let (entry, mut k) = (run[i], i);
            while k > 0 && !ordered(&run[k - 1], &entry) {
                run[k] = run[k - 1];
                k -= 1;
            }
            run[k] = entry;
        }
    }
    if count <= SHORT || entries.is_sorted_by(ordered) {
        return;
    }
    let mut merged = entries.clone();
    let mut width = SHORT;
    while width < count {
        for start in (0..count).step_by(2 * width) {
            let (middle, end) = ((start + width).min(count), (start + 2 * width).min(count));
            let (mut left, mut right) = (start, middle);
            for place in &mut merged[start..end] {
                if right >= end || left < middle && ordered(&entries[left], &entries[right]) {
                    *place = entries[left];
                    left += 1;
                } else {
                    *place = entries[right];
                    right += 1;
                }
            }
        }
        core::mem::swap(entries, &mut merged);
        width *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::{key_of, nth, sort_by_keys, sort_by_number, sort_in_place, sort_numbers};
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// Numbers of which many are equal, the same on every machine.
    fn numbers(count: usize, different: u64) -> Vec<f64> {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64 ^ count as u64;
        (0..count)
            .map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 33) as f64 % different as f64 - 0.5 * different as f64
            })
            .collect()
    }

    #[test]
    fn lists_are_sorted_as_the_standard_library_sorts_them_equal_elements_in_their_order() {
        for count in [0, 1, 2, 3, 15, 16, 17, 31, 32, 33, 64, 100, 1000] {
            for different in [1, 2, 7, 1 << 40] {
                let values = numbers(count, different);
                let (mut own, mut other) = (values.clone(), values.clone());
                sort_numbers(&mut own);
                other.sort_by(f64::total_cmp);
                assert_eq!(own, other, "{count} numbers, {different} different ones");
                let mut own: Vec<(f64, usize)> = values.iter().copied().zip(0..).collect();
                let mut other = own.clone();
                sort_by_number(&mut own, &|pair| -pair.0);
                other.sort_by(|a, b| b.0.total_cmp(&a.0));
                assert_eq!(own, other, "falling, with their places");
                sort_by_keys(&mut own, &|pair| [key_of(pair.0), u64::MAX - pair.1 as u64]);
                other.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
                assert_eq!(own, other, "by two numbers");
                let mut own: Vec<(i32, u32)> = values.iter().map(|v| (*v as i32, v.abs() as u32)).collect();
                let mut other = own.clone();
                sort_in_place(&mut own);
                other.sort_unstable();
                assert_eq!(own, other, "in place");
                for k in [0, count / 3, count / 2, count.saturating_sub(1)] {
                    if k < count {
                        let mut sorted = values.clone();
                        sorted.sort_by(f64::total_cmp);
                        assert_eq!(nth(&mut values.clone(), k), sorted[k], "number {k} of {count}");
                    }
                }
            }
        }
    }

    #[test]
    fn signs_and_infinities_are_sorted_too() {
        let mut values = [0.0, f64::INFINITY, -0.0, -1.0, f64::NEG_INFINITY, 1e-300];
        sort_numbers(&mut values);
        let expected = [f64::NEG_INFINITY, -1.0, -0.0, 0.0, 1e-300, f64::INFINITY];
        assert!(values.iter().zip(expected).all(|(a, b)| a.to_bits() == b.to_bits()), "{values:?}");
    }
}
