//! Runs of segments on one ellipse: `A`.

use super::Printer;
use crate::curve::EllipseArc;
use crate::numerics::angle::sin_cos;
use crate::svg::arc_text::{self, Span};

/// Once around, and a little for rounding.
const FULL_TURN: f64 = core::f64::consts::TAU + 1e-6;
/// Longer arcs are written in two: their ends are so close that rounding them would turn the ellipse.
const LARGEST_SWEEP: f64 = 5.65;

impl Printer<'_> {
    /// The longest run of segments from `i` on that lie on one ellipse, at most once around.
    pub(super) fn arc_run(&self, i: usize) -> Option<(EllipseArc, Span)> {
        if !self.arcs {
            return None;
        }
        let ellipse = self.curve.nth_segment(i).as_ellipse_arc(self.elliptic)?;
        let (mut last, mut sweep) = (i, ellipse.sweep.abs());
        while last + 1 < self.curve.segment_count() {
            let Some(next) = self.curve.nth_segment(last + 1).as_ellipse_arc(self.elliptic) else { break };
            sweep += next.sweep.abs();
            if sweep > FULL_TURN || !self.same_ellipse(&ellipse, &next) {
                break;
            }
            last += 1;
        }
        Some((ellipse, Span { first: i, from: 0.0, last, to: 1.0 }))
    }

    fn same_ellipse(&self, a: &EllipseArc, b: &EllipseArc) -> bool {
        let near = 4.0 * self.elliptic;
        let turn = sin_cos(a.rotation - b.rotation).0 * (a.radii.x - a.radii.y);
        (a.sweep > 0.0) == (b.sweep > 0.0)
            && (a.center - b.center).amax() <= near
            && (a.radii - b.radii).amax() <= near
            && turn.abs() <= near
    }

    /// Writes a run of segments on one ellipse: as one arc, as two where one would be ill-conditioned, and as cubics
    /// where two are not good enough.
    pub(super) fn arcs(&mut self, ellipse: &EllipseArc, run: Span) {
        let whole = run.sweep(self.curve) <= LARGEST_SWEEP && self.arcs_of(ellipse, &[run]);
        if !whole && !self.arcs_of(ellipse, &run.halves(self.curve)) {
            for i in run.first..=run.last {
                self.bezier(&self.curve.nth_segment(i));
            }
            return;
        }
        self.control = None;
    }

    /// Writes one arc for each span, or nothing at all where one of them cannot be written well.
    fn arcs_of(&mut self, ellipse: &EllipseArc, spans: &[Span]) -> bool {
        let (mut from, mut planned) = (self.text.current(), [None; 2]);
        for (slot, &span) in planned.iter_mut().zip(spans) {
            let arc = arc_text::plan(self.curve, ellipse, span, from, self.grid, self.tolerance);
            let Some(arc) = arc else { return false };
            from = arc.to;
            *slot = Some(arc);
        }
        for arc in planned.iter().flatten() {
            self.measured(arc.deviation);
            self.text.arc(&arc.text, arc.to);
        }
        true
    }
}
