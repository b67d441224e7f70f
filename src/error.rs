//! The one error type of the crate.
//!
//! An [`Error`] names the argument at fault, the value that was given and the limit that it broke. It is
//! returned before anything has changed. Not converging, stopping at a limit of work or being cancelled are
//! not errors: they are statuses in the answers of the functions that can meet them.

use core::fmt;

/// A `Result` whose error is the crate's [`Error`], in a box: results stay small, and the way of an answer through
/// many functions stays cheap.
pub type Result<T> = core::result::Result<T, Box<Error>>;

/// What was wrong with a call, with the offending value and the limit.
///
/// [`Error::code`] is the stable string of the kind; JavaScript sees it as `ExplineError.code`. Arguments and limits of
/// two words are written as there: `tangentsIn` for `tangents_in`, `maxPoints`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A number is NaN or infinite.
    NotFinite {
        /// Name of the argument.
        argument: &'static str,
        /// Position in the argument, when it is an array.
        index: Option<usize>,
    },
    /// A number lies outside the range that is documented for it.
    OutOfRange {
        /// Name of the argument.
        argument: &'static str,
        /// Position in the argument, when it is an array.
        index: Option<usize>,
        /// The value that was given.
        value: f64,
        /// The smallest value allowed.
        least: f64,
        /// The largest value allowed.
        most: f64,
    },
    /// An array has the wrong length.
    WrongLength {
        /// Name of the argument.
        argument: &'static str,
        /// The length that was given.
        got: usize,
        /// The length that was expected.
        needed: usize,
    },
    /// Fewer points than the operation needs.
    TooFewPoints {
        /// Name of the argument.
        argument: &'static str,
        /// How many there are.
        got: usize,
        /// How many are needed.
        needed: usize,
    },
    /// The input is well formed but has no unique answer.
    Degenerate {
        /// Name of the argument.
        argument: &'static str,
        /// Position in the argument, when it is an array.
        index: Option<usize>,
        /// What is missing, in a few words.
        reason: &'static str,
    },
    /// A limit on the size of inputs or outputs would be exceeded.
    LimitExceeded {
        /// Name of the argument.
        argument: &'static str,
        /// Name of the limit.
        limit: &'static str,
        /// The limit.
        most: f64,
        /// What the call would need.
        needed: f64,
    },
    /// The allocator refused.
    OutOfMemory {
        /// How many bytes were asked for.
        bytes: usize,
    },
    /// Path data that cannot be read.
    PathSyntax {
        /// Byte offset of the first character that makes no sense.
        offset: usize,
        /// What was expected there.
        expected: &'static str,
    },
}

/// Errors ready to be returned. They are made out of line: the code that checks stays short.
#[allow(clippy::unnecessary_box_returns, reason = "an error is returned in a box")]
impl Error {
    /// A number that is not finite.
    #[cold]
    #[inline(never)]
    pub(crate) fn not_finite(argument: &'static str, index: Option<usize>) -> Box<Self> {
        Box::new(Self::NotFinite { argument, index })
    }

    /// A number that is not finite or, if it is, not in its range.
    #[cold]
    #[inline(never)]
    pub(crate) fn unfit(
        argument: &'static str,
        index: Option<usize>,
        value: f64,
        least: f64,
        most: f64,
    ) -> Box<Self> {
        if value.is_finite() {
            Self::out_of_range(argument, index, value, least, most)
        } else {
            Self::not_finite(argument, index)
        }
    }

    /// A number that is not in its range, infinite or not.
    #[cold]
    #[inline(never)]
    pub(crate) fn out_of_range(
        argument: &'static str,
        index: Option<usize>,
        value: f64,
        least: f64,
        most: f64,
    ) -> Box<Self> {
        Box::new(Self::OutOfRange { argument, index, value, least, most })
    }

    /// An array of the wrong length.
    #[cold]
    #[inline(never)]
    pub(crate) fn wrong_length(argument: &'static str, got: usize, needed: usize) -> Box<Self> {
        Box::new(Self::WrongLength { argument, got, needed })
    }

    /// Too few points.
    #[cold]
    #[inline(never)]
    pub(crate) fn too_few(argument: &'static str, got: usize, needed: usize) -> Box<Self> {
        Box::new(Self::TooFewPoints { argument, got, needed })
    }

    /// An input without a unique answer.
    #[cold]
    #[inline(never)]
    pub(crate) fn degenerate(
        argument: &'static str,
        index: Option<usize>,
        reason: &'static str,
    ) -> Box<Self> {
        Box::new(Self::Degenerate { argument, index, reason })
    }

    /// More than a limit allows.
    #[cold]
    #[inline(never)]
    pub(crate) fn limit(argument: &'static str, limit: &'static str, most: usize, needed: f64) -> Box<Self> {
        Box::new(Self::LimitExceeded { argument, limit, most: most as f64, needed })
    }

    /// Memory that is not there.
    #[cold]
    #[inline(never)]
    pub(crate) fn memory(bytes: usize) -> Box<Self> {
        Box::new(Self::OutOfMemory { bytes })
    }

    /// Path data that cannot be read.
    #[cold]
    #[inline(never)]
    pub(crate) fn path_syntax(offset: usize, expected: &'static str) -> Box<Self> {
        Box::new(Self::PathSyntax { offset, expected })
    }
}

impl Error {
    /// The same error, said of the argument that the caller knows.
    #[cold]
    #[inline(never)]
    pub(crate) fn about(mut self: Box<Self>, name: &'static str) -> Box<Self> {
        match &mut *self {
            Self::NotFinite { argument, .. }
            | Self::OutOfRange { argument, .. }
            | Self::WrongLength { argument, .. }
            | Self::TooFewPoints { argument, .. }
            | Self::Degenerate { argument, .. }
            | Self::LimitExceeded { argument, .. } => *argument = name,
            Self::PathSyntax { .. } | Self::OutOfMemory { .. } => {}
        }
        self
    }

    /// The same error, said of an argument that is one number, where a list of one was looked at.
    #[cold]
    #[inline(never)]
    pub(crate) fn of_one(mut self: Box<Self>) -> Box<Self> {
        if let Self::NotFinite { index, .. } | Self::OutOfRange { index, .. } = &mut *self {
            *index = None;
        }
        self
    }

    /// The stable code of the kind of error; part of semantic versioning.
    pub fn code(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "E_NOT_FINITE",
            Self::OutOfRange { .. } => "E_RANGE",
            Self::WrongLength { .. } => "E_LENGTH",
            Self::TooFewPoints { .. } => "E_TOO_FEW_POINTS",
            Self::Degenerate { .. } => "E_DEGENERATE",
            Self::LimitExceeded { .. } => "E_LIMIT",
            Self::OutOfMemory { .. } => "E_MEMORY",
            Self::PathSyntax { .. } => "E_PARSE_SVG",
        }
    }

    /// Name of the argument at fault, where the error has one.
    pub fn argument(&self) -> Option<&'static str> {
        match self {
            Self::NotFinite { argument, .. }
            | Self::OutOfRange { argument, .. }
            | Self::WrongLength { argument, .. }
            | Self::TooFewPoints { argument, .. }
            | Self::Degenerate { argument, .. }
            | Self::LimitExceeded { argument, .. } => Some(argument),
            Self::PathSyntax { .. } => Some("d"),
            Self::OutOfMemory { .. } => None,
        }
    }
}

/// A number in few digits: of very small and very large ones `{}` alone writes hundreds of zeros.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        let plain = value == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&value.abs());
        if plain { write!(f, "{value}") } else { write!(f, "{value:e}") }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = |f: &mut fmt::Formatter<'_>, argument: &str, index: Option<usize>| match index {
            Some(i) => write!(f, "{argument}[{i}]"),
            None => write!(f, "{argument}"),
        };
        match *self {
            Self::NotFinite { argument, index } => {
                at(f, argument, index)?;
                write!(f, " is not a finite number")
            }
            Self::OutOfRange { argument, index, value, least, most } => {
                at(f, argument, index)?;
                let value = Short(value);
                // A number of something of which there is none.
                if most < least {
                    return write!(f, " is {value}; there is none");
                }
                match (least > 0.0 && least <= f64::MIN_POSITIVE, most == f64::MAX) {
                    (true, true) => write!(f, " is {value}; expected a number above 0"),
                    (true, false) => {
                        write!(f, " is {value}; expected a number above 0, at most {}", Short(most))
                    }
                    (false, true) => write!(f, " is {value}; expected a number from {} on", Short(least)),
                    _ => write!(f, " is {value}; expected a number from {} to {}", Short(least), Short(most)),
                }
            }
            Self::WrongLength { argument, got, needed } => {
                write!(f, "{argument} has length {got}; expected {needed}")
            }
            Self::TooFewPoints { argument, got, needed } => {
                let points = if got == 1 { "point" } else { "points" };
                write!(f, "{argument} has {got} {points}; at least {needed} are needed")
            }
            Self::Degenerate { argument, index, reason } => {
                at(f, argument, index)?;
                write!(f, " has no unique answer: {reason}")
            }
            Self::LimitExceeded { argument, limit, most, needed } => {
                write!(f, "{argument} needs {}; {limit} is {}", Short(needed), Short(most))
            }
            Self::OutOfMemory { bytes } => write!(f, "no memory for {bytes} bytes"),
            Self::PathSyntax { offset, expected } => {
                write!(f, "d makes no sense at byte {offset}; expected {expected}")
            }
        }
    }
}

impl core::error::Error for Error {}

/// So that `?` works in functions that return an [`Error`] without a box.
impl From<Box<Self>> for Error {
    fn from(error: Box<Self>) -> Self {
        *error
    }
}
