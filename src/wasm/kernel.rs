//! The state of one instance: slots, buffers, and the small fixed record that scalar results are left in.

#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
use super::describe::describe;
#[cfg(feature = "wasm-trace")]
use super::picture::Job;
#[cfg(feature = "wasm-spline")]
use super::prepared::Prepared;
#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
use crate::HermiteCurve;
#[cfg(feature = "wasm-surface")]
use crate::TensorSurface;
#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
use crate::curve::Pieces;
#[cfg(feature = "wasm")]
use crate::curve::Sampler;
#[cfg(feature = "wasm-spline")]
use crate::curve::SplineSampler;
#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
use crate::curve::{LengthTable, NearestFinder};
#[cfg(feature = "wasm-fit")]
use crate::fit::Fitter;
#[cfg(feature = "wasm")]
use crate::numerics::Point;
#[cfg(feature = "wasm-spline")]
use crate::{BSplineCurve, InterpolatingCurve, LocalCurve};
use crate::{Error, Result};
use std::cell::RefCell;
use wasm_bindgen::prelude::wasm_bindgen;

/// How many curves can be resident at once.
#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
pub(super) const SLOTS: usize = 16;
/// How many surfaces.
#[cfg(feature = "wasm-surface")]
pub(super) const SURFACES: usize = 4;
/// What an exported function returns when it failed; the record then holds the error.
pub(super) const FAILED: i32 = -1;
/// Length of the record of scalar results.
const RECORD: usize = 16;
/// Where in the record the number of the patch is that is being read, counted from 1: what is wrong is in it.
pub(super) const PATCH: usize = 9;
/// Where in the record the addresses of the buffers are, which move when they grow.
const OUTPUT_ADDRESS: usize = 14;
const TEXT_ADDRESS: usize = 15;

#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
const NOT_RESIDENT: Error =
    Error::Degenerate { argument: "slot", index: None, reason: "no curve is resident" };

/// A curve of any kind.
#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
pub(super) enum AnyCurve {
    #[cfg(feature = "wasm")]
    Hermite(HermiteCurve),
    #[cfg(feature = "wasm-spline")]
    Interpolating(InterpolatingCurve),
    #[cfg(feature = "wasm-spline")]
    BSpline(BSplineCurve),
    #[cfg(feature = "wasm-spline")]
    Local(LocalCurve),
}

#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
impl AnyCurve {
    pub(super) fn pieces(&self) -> &dyn Pieces {
        match self {
            #[cfg(feature = "wasm")]
            Self::Hermite(curve) => curve,
            #[cfg(feature = "wasm-spline")]
            Self::Interpolating(curve) => curve,
            #[cfg(feature = "wasm-spline")]
            Self::BSpline(curve) => curve,
            #[cfg(feature = "wasm-spline")]
            Self::Local(curve) => curve,
        }
    }
}

/// A resident curve, and what was prepared for questions about it.
#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
pub(super) struct Resident {
    pub(super) curve: AnyCurve,
    pub(super) finder: Option<NearestFinder>,
    pub(super) table: Option<LengthTable>,
}

/// Everything that an instance remembers between calls.
pub(super) struct Kernel {
    /// Scalar results, error fields and buffer addresses; its own address never changes.
    pub(super) record: [f64; RECORD],
    /// Numbers written by JavaScript.
    pub(super) input: Vec<f64>,
    /// Numbers to be read by JavaScript.
    pub(super) output: Vec<f64>,
    /// Text in and out, UTF-8.
    pub(super) text: Vec<u8>,
    /// Where the last path that was written has ended.
    #[cfg(feature = "wasm")]
    pub(super) pen: Option<Point>,
    /// The tables of bulk sampling.
    #[cfg(feature = "wasm")]
    pub(super) sampler: Option<Box<Sampler>>,
    #[cfg(feature = "wasm-spline")]
    pub(super) spline_sampler: Option<Box<SplineSampler>>,
    /// The generator that was asked last.
    #[cfg(feature = "wasm-spline")]
    pub(super) generator: Option<Box<Prepared>>,
    /// The fits that are open, by their numbers.
    #[cfg(feature = "wasm-fit")]
    pub(super) fits: Vec<Option<Box<Fitter>>>,
    /// The pictures that are open, by their numbers.
    #[cfg(feature = "wasm-trace")]
    pub(super) traces: Vec<Option<Box<Job>>>,
    /// The resident curves; a list, since an array of known length would be emptied one by one.
    #[cfg(any(feature = "wasm", feature = "wasm-spline"))]
    pub(super) slots: Vec<Option<Resident>>,
    /// The resident surfaces.
    #[cfg(feature = "wasm-surface")]
    pub(super) surfaces: [Option<TensorSurface>; SURFACES],
}

thread_local! {
    static KERNEL: RefCell<Kernel> = const {
        RefCell::new(Kernel {
            record: [0.0; RECORD],
            input: Vec::new(),
            output: Vec::new(),
            text: Vec::new(),
            #[cfg(feature = "wasm")]
            pen: None,
            #[cfg(feature = "wasm")]
            sampler: None,
            #[cfg(feature = "wasm-spline")]
            spline_sampler: None,
            #[cfg(feature = "wasm-spline")]
            generator: None,
            #[cfg(feature = "wasm-fit")]
            fits: Vec::new(),
            #[cfg(feature = "wasm-trace")]
            traces: Vec::new(),
            #[cfg(any(feature = "wasm", feature = "wasm-spline"))]
            slots: Vec::new(),
            #[cfg(feature = "wasm-surface")]
            surfaces: [const { None }; SURFACES],
        })
    };
}

#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
impl Kernel {
    /// The Hermite curve in a slot; the face never asks for an empty one.
    #[cfg(feature = "wasm")]
    pub(super) fn curve(&self, slot: u32) -> Result<&HermiteCurve> {
        self.pieces(slot)?.as_hermite().ok_or_else(|| Box::new(NOT_RESIDENT))
    }

    /// The curve in a slot, of any kind.
    pub(super) fn any(&self, slot: u32) -> Result<&AnyCurve> {
        resident(&self.slots, slot)
    }

    /// The pieces of the curve in a slot.
    pub(super) fn pieces(&self, slot: u32) -> Result<&dyn Pieces> {
        Ok(self.any(slot)?.pieces())
    }

    /// Puts a curve into a slot.
    pub(super) fn keep(&mut self, slot: u32, curve: AnyCurve) {
        while self.slots.len() < SLOTS {
            self.slots.push(None);
        }
        if let Some(place) = self.slots.get_mut(slot as usize) {
            *place = Some(Resident { curve, finder: None, table: None });
        }
    }

    /// The curve in a slot, prepared for questions after its nearest point, with `count` given numbers and the output.
    pub(super) fn finder(
        &mut self,
        slot: u32,
        count: usize,
    ) -> Result<(&NearestFinder, &[f64], &mut Vec<f64>)> {
        let given = &self.input[..count.min(self.input.len())];
        match self.slots.get_mut(slot as usize) {
            Some(Some(Resident { curve, finder, .. })) => {
                Ok((finder.get_or_insert_with(|| NearestFinder::of(curve.pieces())), given, &mut self.output))
            }
            _ => Err(Box::new(NOT_RESIDENT)),
        }
    }

    /// The curve in a slot, with its lengths prepared for that tolerance.
    pub(super) fn table(&mut self, slot: u32, tolerance: f64) -> Result<(&dyn Pieces, &mut LengthTable)> {
        let Some(Some(Resident { curve, table, .. })) = self.slots.get_mut(slot as usize) else {
            return Err(Box::new(NOT_RESIDENT));
        };
        if table.as_ref().is_some_and(|known| known.tolerance() != tolerance) {
            *table = None;
        }
        let table = match table {
            Some(known) => known,
            None => table.insert(LengthTable::of(curve.pieces(), tolerance)?),
        };
        Ok((curve.pieces(), table))
    }

    /// The curve in a slot, the first `count` numbers that JavaScript wrote, and the output.
    pub(super) fn parts(&mut self, slot: u32, count: usize) -> Result<(&AnyCurve, &[f64], &mut [f64])> {
        let given = &self.input[..count.min(self.input.len())];
        Ok((resident(&self.slots, slot)?, given, &mut self.output))
    }

    /// Leaves curves in the output, one after the other.
    pub(super) fn give_curves(&mut self, curves: &[HermiteCurve]) -> usize {
        self.output.clear();
        for curve in curves {
            describe(&mut self.output, curve);
        }
        self.output.len()
    }
}

impl Kernel {
    /// The first `count` numbers that JavaScript wrote.
    #[cfg(any(feature = "wasm", feature = "wasm-spline", feature = "wasm-fit", feature = "wasm-trace"))]
    pub(super) fn given(&self, count: usize) -> &[f64] {
        &self.input[..count.min(self.input.len())]
    }

    /// Leaves scalar results in the record.
    pub(super) fn record<const N: usize>(&mut self, results: [f64; N]) {
        for (place, result) in self.record.iter_mut().zip(results) {
            *place = result;
        }
    }

    /// Hands a whole array over as the output.
    pub(super) fn give(&mut self, numbers: Vec<f64>) -> usize {
        self.output = numbers;
        self.output.len()
    }

    fn fail(&mut self, error: &Error) -> i32 {
        let number = |n: usize| n as f64;
        let at = |index: Option<usize>| index.map_or(-1.0, |i| i as f64);
        let (kind, index, value, least, most, text) = match *error {
            Error::NotFinite { index, .. } => (1.0, at(index), 0.0, 0.0, 0.0, ""),
            Error::OutOfRange { index, value, least, most, .. } => (2.0, at(index), value, least, most, ""),
            Error::WrongLength { got, needed, .. } => (3.0, -1.0, number(got), number(needed), 0.0, ""),
            Error::TooFewPoints { got, needed, .. } => (4.0, -1.0, number(got), number(needed), 0.0, ""),
            Error::Degenerate { index, reason, .. } => (5.0, at(index), 0.0, 0.0, 0.0, reason),
            Error::LimitExceeded { limit, most, needed, .. } => (6.0, -1.0, needed, 0.0, most, limit),
            Error::OutOfMemory { bytes } => (7.0, -1.0, number(bytes), 0.0, 0.0, ""),
            Error::PathSyntax { offset, expected } => (8.0, number(offset), 0.0, 0.0, 0.0, expected),
        };
        let argument = error.argument().unwrap_or("");
        self.record([kind, index, value, least, most]);
        for (place, words) in [(5, argument), (7, text)] {
            self.record[place] = words.as_ptr() as usize as f64;
            self.record[place + 1] = number(words.len());
        }
        FAILED
    }
}

#[cfg(any(feature = "wasm", feature = "wasm-spline"))]
fn resident(slots: &[Option<Resident>], slot: u32) -> Result<&AnyCurve> {
    match slots.get(slot as usize) {
        Some(Some(resident)) => Ok(&resident.curve),
        _ => Err(Box::new(NOT_RESIDENT)),
    }
}

/// The body of an exported function. Unlike that of `dyn FnMut`, its table holds one copy of the code.
trait Body {
    fn go(&mut self, kernel: &mut Kernel) -> Result<usize>;
}

impl<F: FnMut(&mut Kernel) -> Result<usize>> Body for F {
    fn go(&mut self, kernel: &mut Kernel) -> Result<usize> {
        self(kernel)
    }
}

/// Runs one exported function on the kernel and leaves its error, if any, in the record.
#[inline]
pub(super) fn run(body: &mut impl FnMut(&mut Kernel) -> Result<usize>) -> i32 {
    enter(body)
}

/// One copy of this serves all of them: the wrapping is as large as many a body.
#[inline(never)]
fn enter(body: &mut dyn Body) -> i32 {
    KERNEL.with(|cell| {
        let Ok(mut kernel) = cell.try_borrow_mut() else { return FAILED };
        let kernel = &mut *kernel;
        kernel.record[PATCH] = 0.0;
        match body.go(kernel) {
            Ok(count) => {
                kernel.record[OUTPUT_ADDRESS] = kernel.output.as_ptr() as usize as f64;
                kernel.record[TEXT_ADDRESS] = kernel.text.as_ptr() as usize as f64;
                count as i32
            }
            Err(error) => kernel.fail(&error),
        }
    })
}

/// How many numbers so many things of `each` numbers are; more than there can be where that overflows.
pub(super) fn times(count: u32, each: usize) -> usize {
    (count as usize).saturating_mul(each)
}

/// Makes a buffer hold at least `count` items, without ever aborting for want of memory.
pub(super) fn grow<T: Copy>(buffer: &mut Vec<T>, count: usize, blank: T) -> Result<()> {
    if count > buffer.len() {
        let more = count - buffer.len();
        let bytes = count.saturating_mul(size_of::<T>());
        buffer.try_reserve_exact(more).map_err(|_| Error::OutOfMemory { bytes })?;
        buffer.resize(count, blank);
    }
    Ok(())
}

/// The address of the record; constant as long as the instance lives.
#[wasm_bindgen]
pub fn record_address() -> u32 {
    KERNEL.with(|cell| cell.as_ptr() as usize as u32 + core::mem::offset_of!(Kernel, record) as u32)
}

/// Makes room for `count` numbers and returns the address to write them to; 0 when there is no memory.
///
/// `count` 0 gives the memory back.
#[wasm_bindgen]
pub fn input_address(count: u32) -> u32 {
    KERNEL.with(|cell| {
        let Ok(mut kernel) = cell.try_borrow_mut() else { return 0 };
        if count == 0 {
            kernel.input = Vec::new();
        }
        match grow(&mut kernel.input, count as usize, 0.0) {
            Ok(()) => kernel.input.as_ptr() as usize as u32,
            Err(_) => 0,
        }
    })
}

/// Makes room for `count` bytes of text and returns the address to write them to; 0 when there is no memory.
#[wasm_bindgen]
pub fn text_address(count: u32) -> u32 {
    KERNEL.with(|cell| {
        let Ok(mut kernel) = cell.try_borrow_mut() else { return 0 };
        match grow(&mut kernel.text, count as usize, 0) {
            Ok(()) => kernel.text.as_ptr() as usize as u32,
            Err(_) => 0,
        }
    })
}

/// The version of the crate, so that a face of another version notices: major·10⁶ + minor·10³ + patch.
#[wasm_bindgen]
pub fn kernel_version() -> u32 {
    const fn number(digits: &str) -> u32 {
        let (digits, mut value, mut i) = (digits.as_bytes(), 0, 0);
        while i < digits.len() {
            value = 10 * value + (digits[i] - b'0') as u32;
            i += 1;
        }
        value
    }
    const VERSION: u32 = number(env!("CARGO_PKG_VERSION_MAJOR")) * 1_000_000
        + number(env!("CARGO_PKG_VERSION_MINOR")) * 1000
        + number(env!("CARGO_PKG_VERSION_PATCH"));
    VERSION
}

/// Empties every slot and gives the buffers back.
#[wasm_bindgen]
pub fn forget() {
    KERNEL.with(|cell| {
        if let Ok(mut kernel) = cell.try_borrow_mut() {
            let kernel = &mut *kernel;
            #[cfg(any(feature = "wasm", feature = "wasm-spline"))]
            kernel.slots.clear();
            #[cfg(feature = "wasm-surface")]
            for place in &mut kernel.surfaces {
                *place = None;
            }
            for buffer in [&mut kernel.input, &mut kernel.output] {
                *buffer = Vec::new();
            }
            kernel.text = Vec::new();
        }
    });
}
