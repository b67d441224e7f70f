//! What only curves of any roots have: nothing of it is there in a wasm module without such curves.

pub(super) use kinds::{ListOfAnyRoots, OfAnyRoots, list_of_any_roots, of_any_roots};

/// Whether there are curves of any roots.
pub(super) const ANY_ROOTS: bool =
    cfg!(not(all(target_arch = "wasm32", feature = "binding", not(feature = "wasm-spline"))));

#[cfg(not(all(target_arch = "wasm32", feature = "binding", not(feature = "wasm-spline"))))]
mod kinds {
    /// What only curves of any roots have.
    pub(in crate::curve) type OfAnyRoots<T> = T;

    /// The value, where there are such curves.
    pub(in crate::curve) fn of_any_roots<T>(value: T) -> Option<OfAnyRoots<T>> {
        Some(value)
    }

    /// A list of what only such curves have, always empty where there are none.
    pub(in crate::curve) type ListOfAnyRoots<T> = Vec<T>;

    /// The list, where there are such curves.
    pub(in crate::curve) fn list_of_any_roots<T>(list: Vec<T>) -> ListOfAnyRoots<T> {
        list
    }
}

#[cfg(all(target_arch = "wasm32", feature = "binding", not(feature = "wasm-spline")))]
mod kinds {
    use core::convert::Infallible;
    use core::marker::PhantomData;
    use core::ops::Deref;

    /// No value is of this type: a choice that holds one cannot be, and is neither asked for nor freed.
    #[derive(Clone, Copy, Debug)]
    pub(in crate::curve) struct OfAnyRoots<T>(Infallible, PhantomData<T>);

    impl<T> Deref for OfAnyRoots<T> {
        type Target = T;

        fn deref(&self) -> &T {
            match self.0 {}
        }
    }

    pub(in crate::curve) fn of_any_roots<T>(_: T) -> Option<OfAnyRoots<T>> {
        None
    }

    /// Always empty, and nothing to free.
    #[derive(Clone, Copy, Debug, Default)]
    pub(in crate::curve) struct ListOfAnyRoots<T>(PhantomData<T>);

    impl<T> Deref for ListOfAnyRoots<T> {
        type Target = [T];

        fn deref(&self) -> &[T] {
            &[]
        }
    }

    pub(in crate::curve) fn list_of_any_roots<T>(_: Vec<T>) -> ListOfAnyRoots<T> {
        ListOfAnyRoots(PhantomData)
    }
}
