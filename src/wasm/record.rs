//! Runs of numbers, as work in steps is opened with and described by; and the places of what is open.

/// Reads numbers one after the other; what is missing is 0.
pub(super) struct Numbers<'a>(pub(super) &'a [f64]);

impl<'a> Numbers<'a> {
    pub(super) fn next(&mut self) -> f64 {
        self.take(1).first().copied().unwrap_or(0.0)
    }

    /// What is negative stands for nothing.
    pub(super) fn optional(&mut self) -> Option<f64> {
        Some(self.next()).filter(|&number| number >= 0.0)
    }

    pub(super) fn count(&mut self) -> usize {
        self.next() as usize
    }

    pub(super) fn flag(&mut self) -> bool {
        self.next() != 0.0
    }

    pub(super) fn take(&mut self, count: usize) -> &'a [f64] {
        let (head, tail) = self.0.split_at(count.min(self.0.len()));
        self.0 = tail;
        head
    }
}

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
