//! What the promises in this folder share: the golden data and the tolerances.

pub(crate) mod golden;
pub(crate) mod tolerance;
