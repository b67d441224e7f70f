//! Runs of numbers, by which curves, surfaces and work in steps are described on their way in.

/// Takes the first `count` numbers off what is left, or as many as there are.
pub(super) fn take<'a>(rest: &mut &'a [f64], count: usize) -> &'a [f64] {
    let (head, tail) = rest.split_at(count.min(rest.len()));
    *rest = tail;
    head
}

/// Reads numbers one after the other; what is missing is 0.
#[cfg(any(feature = "wasm-surface", feature = "wasm-fit", feature = "wasm-trace"))]
pub(super) struct Numbers<'a>(pub(super) &'a [f64]);

#[cfg(any(feature = "wasm-surface", feature = "wasm-fit", feature = "wasm-trace"))]
impl<'a> Numbers<'a> {
    pub(super) fn next(&mut self) -> f64 {
        self.take(1).first().copied().unwrap_or(0.0)
    }

    /// What is negative stands for nothing.
    #[cfg(any(feature = "wasm-fit", feature = "wasm-trace"))]
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
        take(&mut self.0, count)
    }
}
