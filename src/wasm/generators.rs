//! The generators φ₁ and φ₂ of one frequency; nothing is kept between calls.

use super::curve::space_of;
use super::kernel::{Kernel, run};
use crate::generator::{HermiteGenerators, Table};
use crate::{Result, Space};
use wasm_bindgen::prelude::wasm_bindgen;

fn with(omega: f64, space: u32, body: &dyn Fn(HermiteGenerators, &mut Kernel) -> Result<usize>) -> i32 {
    run(&mut |kernel| {
        let space = space_of(space).unwrap_or(Space::Trigonometric);
        body(HermiteGenerators::new(omega, space)?, kernel)
    })
}

/// One table for the `count` places in the input.
fn tabulate(omega: f64, space: u32, table: Table, count: u32, derivative: u32) -> i32 {
    with(omega, space, &|generators, kernel| {
        let values = generators.tabulate(table, kernel.given(count as usize), derivative as usize)?;
        Ok(kernel.give(values))
    })
}

/// Nothing but the check of the frequency.
#[wasm_bindgen]
pub fn generators(omega: f64, space: u32) -> i32 {
    with(omega, space, &|_, _| Ok(0))
}

/// φ₁ at the `count` places in the input, then φ₂.
#[wasm_bindgen]
pub fn generators_evaluate(omega: f64, space: u32, count: u32, derivative: u32) -> i32 {
    tabulate(omega, space, Table::Pair, count, derivative)
}

/// The four Bernstein functions at the `count` places in the input.
#[wasm_bindgen]
pub fn generators_bernstein(omega: f64, space: u32, count: u32, derivative: u32) -> i32 {
    tabulate(omega, space, Table::Bernstein, count, derivative)
}

/// ρ₁ at the `count` places in the input, then ρ₂.
#[wasm_bindgen]
pub fn generators_greens(omega: f64, space: u32, count: u32) -> i32 {
    tabulate(omega, space, Table::Greens, count, 0)
}

/// The refinement masks of a level.
#[wasm_bindgen]
pub fn generators_mask(omega: f64, space: u32, arity: u32, level: u32) -> i32 {
    with(omega, space, &|generators, kernel| {
        let mask = generators.mask(arity as usize, level as usize)?;
        Ok(kernel.give(mask))
    })
}

/// The entries of the Gram matrix, then the Riesz bounds, in the record.
#[wasm_bindgen]
pub fn generators_gram(omega: f64, space: u32) -> i32 {
    with(omega, space, &|generators, kernel| {
        let (gram, bounds) = (generators.gram(), generators.riesz_bounds());
        kernel.record([gram.a, gram.b, gram.c, gram.d, gram.e, bounds.lower, bounds.upper]);
        Ok(7)
    })
}
