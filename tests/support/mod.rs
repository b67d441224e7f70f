//! What the promises in this folder share: the golden data, test curves and the tolerances.

#![allow(dead_code, reason = "every file of promises takes what it needs")]

pub(crate) mod curves;
pub(crate) mod golden;
pub(crate) mod tolerance;
