//! Chains on their way to curves: edges, centre lines, and outlines that quasi-interpolants follow.

use super::agreement::agreement;
use super::edges::canny::EdgeOptions;
use super::edges::centre::centre_lines;
use super::edges::maxima::MaximaScan;
use super::edges::strands::profiles;
use super::options::{Model, Source, TraceOptions};
use super::outline::corners::{CornerRule, corners};
use super::outline::division::{DivisionRule, divide, divide_open};
use super::outline::{Outline, is_about};
use super::picture::contour::{Contour, ContourScan};
use super::picture::gray::Gray;
use super::picture::light::Evening;
use super::picture::tones::{ToneScan, Tones};
use super::profile::ProfileOptions;
use super::samples::Samples;
use super::tubes::chain::Chain;
use super::tubes::cusps::CuspRule;
use super::work::{Progress, Stage, Trace, TracedContour, Work};
use crate::curve::Curve;
use crate::error::{Error, Result};
use crate::numerics::order::sort_by_number;
use crate::numerics::plane::norm;

/// Pixels of one bit of work.
const BIT: usize = 32_768;

/// Chains that are found and then followed one by one.
#[derive(Debug)]
pub(super) struct ChainWork {
    gray: Gray,
    options: TraceOptions,
    phase: Phase,
    progress: Progress,
    chains: Vec<Chain>,
    /// How far corners are rounded by the blur or the width of lines, in pixels.
    rounding: f64,
    trace: Trace,
    offer: Option<f64>,
}

/// What is done next.
#[derive(Debug)]
enum Phase {
    Light(Evening),
    Tones(Box<ToneScan>),
    Maxima(MaximaScan, f64),
    Contours(ContourScan),
    Splines,
}

impl ChainWork {
    pub(super) fn new(gray: Gray, options: TraceOptions) -> Result<Self> {
        let tones = Tones { ink: 0.0, paper: 65_280.0, noise: 0.0 };
        let total = gray.height();
        let phase = if options.finds_light() {
            Phase::Light(Evening::new(&gray)?)
        } else {
            Phase::Tones(Box::new(ToneScan::new(options.threshold.map(|shade| shade as usize))))
        };
        Ok(Self {
            gray,
            options,
            phase,
            progress: Progress { done: false, stage: Stage::Edges, completed: 0, total },
            chains: Vec::new(),
            rounding: 1.0,
            trace: Trace { contours: Vec::new(), tones, residual: 0.0 },
            offer: None,
        })
    }

    fn edge_options(&self) -> EdgeOptions {
        EdgeOptions { sigma: self.options.blur.map(|sigma| sigma.clamp(0.3, 8.0)), high: None, low: None }
    }

    fn level(&self) -> f64 {
        let tones = self.trace.tones;
        self.options.threshold.map_or(0.5 * (tones.ink + tones.paper), |shade| 256.0 * shade)
    }

    fn toned(&mut self, tones: Tones) -> Result<()> {
        self.trace.tones = tones;
        if self.options.source == Source::Edges {
            let sigma = self.edge_options().sigma(tones.noise);
            self.rounding = sigma;
            self.phase = Phase::Maxima(MaximaScan::new(&self.gray, sigma)?, sigma);
        } else {
            let scan = ContourScan::new(&self.gray, self.level(), self.options.inverted);
            self.phase = Phase::Contours(scan);
            let total = self.gray.height() + 1;
            self.progress = Progress { done: false, stage: Stage::Contours, completed: 0, total };
        }
        Ok(())
    }

    fn found(&mut self, mut chains: Vec<Chain>) -> Result<()> {
        let edges = self.options.source == Source::Edges;
        chains.retain(|chain| has_extent(chain) && !(edges && span(chain) < self.options.least()));
        let most = self.options.most_contours;
        if chains.len() > most {
            if edges {
                self.offer = speckle_for(most, chains.iter().map(span).collect());
            }
            return Err(Error::limit("data", "maxContours", most, chains.len() as f64));
        }
        self.chains = chains;
        let total = self.chains.len();
        self.progress = Progress { done: total == 0, stage: Stage::Splines, completed: 0, total };
        self.phase = Phase::Splines;
        Ok(())
    }

    /// Contours are the chains, or the outlines of the lines that are.
    fn contoured(&mut self, contours: &mut [Contour]) -> Result<()> {
        if self.options.source == Source::Brightness {
            let areas = contours.iter().map(|contour| contour.area.abs()).collect();
            self.offer = speckle_for(self.options.most_contours, areas);
        }
        let chains = if self.options.source == Source::Lines {
            let lines = centre_lines(&self.gray, self.level(), self.options.inverted, contours)?;
            self.rounding = (0.15 * lines.half_width).max(1.0);
            lines.chains
        } else {
            let mut chains = Vec::new();
            for contour in contours {
                chains.push(Chain::new(contour.points.clone(), true)?);
            }
            chains
        };
        self.found(chains)
    }

    /// The curve of one chain.
    fn follow(&mut self, i: usize) -> Result<f64> {
        let chain = &self.chains[i];
        let traced = if self.options.model == Model::QuasiInterpolant {
            quasi_interpolant(chain, &self.options, self.rounding)?
        } else {
            sparse(chain, &self.options, self.rounding)?
        };
        let hole = self.options.source == Source::Brightness && traced.curve.area().is_ok_and(|a| a < 0.0);
        self.trace.contours.push(TracedContour { hole, ..traced });
        Ok(2.0 * chain.points().len() as f64)
    }
}

/// Whether not all points are at one place.
fn has_extent(chain: &Chain) -> bool {
    let first = chain.points()[0];
    chain.points().iter().any(|p| norm(p - first) > 0.05)
}

/// The area of the square that an edge would just go round, in square pixels: what speckle says of edges, which need
/// not enclose anything.
fn span(chain: &Chain) -> f64 {
    let mut length = 0.0;
    for pair in chain.points().windows(2) {
        length += norm(pair[1] - pair[0]);
    }
    if let (true, [first, .., last]) = (chain.is_closed(), chain.points()) {
        length += norm(first - last);
    }
    length * length / 16.0
}

/// The least speckle that leaves no more than `most` of such areas; nothing where there are no more.
pub(super) fn speckle_for(most: usize, mut areas: Vec<f64>) -> Option<f64> {
    sort_by_number(&mut areas, &|area| -area);
    areas.get(most).map(|area| area * (1.0 + 1e-9) + 1e-9)
}

/// A chain as splines on placed knots, tube by tube.
fn quasi_interpolant(chain: &Chain, options: &TraceOptions, rounding: f64) -> Result<TracedContour> {
    let (angle, reach) = (options.corner, 1.5 * rounding);
    let cusps = CuspRule { gap: rounding, window: 4.0 + rounding, angle, reach };
    let profile = chain.follow(&ProfileOptions { cusps, ..ProfileOptions::default() })?;
    let cusps = profile.cusps().iter().map(|cusp| cusp.point).collect();
    let (curve, metrics) = (profile.curve()?, profile.metrics()?);
    if chain.is_closed() {
        let ring = Outline::polygon(chain.points())?;
        if !is_about(curve.area()?, ring.area(), 1.0) {
            // Splines of a few points may enclose nothing.
            let curve = ring.to_curve(vec![0.0; ring.len()])?;
            let metrics = agreement(&curve, chain.points())?;
            return Ok(TracedContour { curve, closed: true, hole: false, cusps: Vec::new(), metrics });
        }
    }
    Ok(TracedContour { curve, closed: chain.is_closed(), hole: false, cusps, metrics })
}

/// A chain as few lines and cubics between its corners.
fn sparse(chain: &Chain, options: &TraceOptions, rounding: f64) -> Result<TracedContour> {
    let closed = chain.is_closed();
    let samples = if closed { Samples::new(chain.points())? } else { Samples::open(chain.points()) };
    let rules =
        [CornerRule { gap: rounding, window: 3.0 + rounding, angle: options.corner, reach: 1.2 * rounding }];
    let corners = corners(&samples, &rules);
    // Nothing is refined afterwards: what the chain says is all that is known.
    let most = 0.6 * options.tolerance;
    let rule = DivisionRule {
        gap: 1.2 * rounding,
        straight: 0.12,
        least_run: 8.0,
        most,
        rms: 0.41 * most,
        reach: 4.0,
        chords: false,
    };
    let outline =
        if closed { divide(&samples, &corners, &rule) } else { divide_open(&samples, &corners, &rule) };
    if closed && outline.len() < 2 {
        // A ring of a few pixels: one piece would have to lead back to its start.
        return quasi_interpolant(chain, options, rounding);
    }
    let curve = if closed { outline.to_curve(vec![0.0; outline.len()])? } else { outline.to_open_curve()? };
    let cusps = corners.iter().map(|corner| corner.point).collect();
    let metrics = agreement(&curve, chain.points())?;
    Ok(TracedContour { curve, closed, hole: false, cusps, metrics })
}

impl Work for ChainWork {
    fn step(&mut self) -> Result<f64> {
        let options = self.edge_options();
        let rows = (BIT / self.gray.width()).max(1);
        match &mut self.phase {
            Phase::Light(evening) => {
                if evening.step(&mut self.gray) {
                    self.phase = Phase::Tones(Box::new(ToneScan::new(None)));
                }
                return Ok(0.2 * (self.gray.width() as f64));
            }
            Phase::Tones(scan) => {
                if let Some(tones) = scan.step(&self.gray) {
                    self.toned(tones)?;
                }
                return Ok(0.2 * self.gray.width() as f64);
            }
            Phase::Maxima(scan, sigma) => {
                for _ in 0..rows {
                    if scan.step(&self.gray)? {
                        let sigma = *sigma;
                        let scan = core::mem::replace(scan, MaximaScan::new(&self.gray, sigma)?);
                        let edges = scan.edges(&self.gray, &options, sigma)?;
                        self.found(profiles(&edges)?)?;
                        break;
                    }
                }
            }
            Phase::Contours(scan) => {
                for _ in 0..rows {
                    if !scan.step(&self.gray)? {
                        let mut found = scan.contours(self.options.least())?;
                        self.contoured(&mut found)?;
                        break;
                    }
                    self.progress.completed = scan.rows().min(self.progress.total);
                }
            }
            Phase::Splines => {
                let cost = self.follow(self.progress.completed)?;
                self.progress.completed += 1;
                self.progress.done = self.progress.completed == self.progress.total;
                return Ok(cost);
            }
        }
        Ok(1000.0)
    }

    fn progress(&self) -> Progress {
        self.progress
    }

    fn trace(&self) -> Option<&Trace> {
        self.progress.done.then_some(&self.trace)
    }

    fn offer(&self) -> Option<f64> {
        self.offer
    }
}
