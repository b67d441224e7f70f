//! One curve, many resolutions.
