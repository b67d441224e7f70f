//! SVG path data in and out; no XML.
