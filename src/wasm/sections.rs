//! What work in steps leaves and where it is kept: sections of numbers, and the places of what is open.

/// Appends one section: its length, then what `write` appends.
#[inline(never)]
pub(super) fn section(output: &mut Vec<f64>, write: &mut dyn FnMut(&mut Vec<f64>)) {
    let start = output.len();
    output.push(0.0);
    write(output);
    output[start] = (output.len() - start - 1) as f64;
}

/// Keeps what was opened and returns its number: the lowest that is free.
pub(super) fn place<T>(open: &mut Vec<Option<T>>, item: T) -> usize {
    let number = open.iter().position(Option::is_none).unwrap_or(open.len());
    if number == open.len() {
        open.push(None);
    }
    open[number] = Some(item);
    number
}
