//! Lists of roots: what an exponential spline is made of, and what it keeps exact.

use core::f64::consts::{PI, TAU};

use nalgebra::Complex;

use super::pairing::{oppose, pair_up};
use super::root::{Root, distance, size, tolerance};
use crate::error::{Error, Result};
use crate::limits::{LARGEST_ROOT_IM, LARGEST_ROOT_RE, MOST_ROOTS, check, too_many, with_room};
use crate::numerics::entire::stumpff;
use crate::numerics::twofold::{Twofold, cosine, exponential};

/// A list of roots that is closed under conjugation, to the last bit.
///
/// A root of multiplicity μ keeps also t, …, t^{μ−1} times its functions: (0, 0, 0, 0) are the cubics, (0, ±iω) the
/// ellipses with ω radians between two points.
///
/// # Source
///
/// [SFBGU17, sec. 2.2]; the rule of closure as corrected in docs/SOURCES.md.
#[derive(Clone, Debug, PartialEq)]
pub struct Roots {
    list: Vec<Root>,
    /// The first root that has no opposite.
    without_opposite: Option<usize>,
}

impl Roots {
    /// A list in the order given; `argument` is its name in errors.
    ///
    /// Conjugates and opposites are matched within 1e-12 and then made exact.
    ///
    /// # Errors
    ///
    /// No root or more than 16; a number that is not finite, |re| > 20 or |im| > 10; a root without its conjugate.
    pub fn new(roots: &[Root], argument: &'static str) -> Result<Self> {
        if roots.is_empty() {
            return Err(Error::too_few(argument, 0, 1));
        }
        if roots.len() > MOST_ROOTS {
            return Err(too_many(argument, "maxRoots", MOST_ROOTS, roots.len()));
        }
        let mut list = with_room(roots.len())?;
        for (i, root) in roots.iter().enumerate() {
            check(argument, Some(i), root.re, -LARGEST_ROOT_RE, LARGEST_ROOT_RE)?;
            check(argument, Some(i), root.im, -LARGEST_ROOT_IM, LARGEST_ROOT_IM)?;
            list.push(*root);
        }
        match Self::close(list) {
            Ok(roots) => Ok(roots),
            Err(i) => Err(Error::degenerate(argument, Some(i), "its conjugate is missing")),
        }
    }

    /// Makes conjugates and opposites exact, or names the root without a conjugate.
    fn close(mut list: Vec<Root>) -> core::result::Result<Self, usize> {
        let mut factors = pair_up(&mut list)?;
        let without_opposite = oppose(&mut factors);
        for f in &factors {
            list[f.second] = Root { re: f.re, im: -f.im };
            list[f.first] = Root { re: f.re, im: f.im };
        }
        Ok(Self { list, without_opposite })
    }

    /// 0 with multiplicity degree + 1: polynomials up to this degree.
    ///
    /// # Errors
    ///
    /// A degree above 15.
    pub fn polynomials(degree: usize) -> Result<Self> {
        check("degree", None, degree as f64, 0.0, (MOST_ROOTS - 1) as f64)?;
        Self::new(&vec![Root::default(); degree + 1], "roots")
    }

    /// (0, ±2πi/count): ellipses that are given by `count` points.
    ///
    /// # Errors
    ///
    /// Fewer than 3 points a turn.
    pub fn ellipse(count: usize) -> Result<Self> {
        Self::harmonics(count, 1)
    }

    /// (0, ±2πi/count, …, ±2πik/count): closed curves whose coordinates are trigonometric polynomials to order k.
    ///
    /// # Errors
    ///
    /// k above 7; a count of 2k or less: the highest harmonic would have fewer than two points a turn.
    pub fn harmonics(count: usize, k: usize) -> Result<Self> {
        check("k", None, k as f64, 0.0, ((MOST_ROOTS - 1) / 2) as f64)?;
        check("count", None, count as f64, (2 * k + 1) as f64, f64::MAX)?;
        let mut list = vec![Root::default()];
        for j in 1..=k {
            let im = TAU * j as f64 / count as f64;
            list.extend([Root { re: 0.0, im }, Root { re: 0.0, im: -im }]);
        }
        Self::new(&list, "roots")
    }

    /// (0, ±rate): hyperbolas and catenaries that grow by e^rate from point to point.
    ///
    /// # Errors
    ///
    /// A rate that is not finite, or is larger in size than a root may be ([`Self::new`]).
    pub fn hyperbola(rate: f64) -> Result<Self> {
        check("rate", None, rate, -LARGEST_ROOT_RE, LARGEST_ROOT_RE)?;
        let list = [Root::default(), Root { re: rate, im: 0.0 }, Root { re: -rate, im: 0.0 }];
        Self::new(&list, "roots")
    }

    /// Every root as often as in the list that has it most often: what each list keeps, the union keeps.
    ///
    /// # Errors
    ///
    /// More than 16 roots; no list.
    pub fn union(lists: &[Self]) -> Result<Self> {
        let mut list: Vec<Root> = Vec::new();
        for other in lists {
            let mut met = vec![false; list.len()];
            for &root in &other.list {
                let same = (0..met.len()).find(|&i| !met[i] && distance(list[i], root) <= tolerance(root));
                match same {
                    Some(i) => met[i] = true,
                    None => list.push(root),
                }
            }
        }
        Self::new(&list, "roots")
    }

    /// How many roots there are, n₀.
    pub fn order(&self) -> usize {
        self.list.len()
    }

    /// The roots in the order in which they were given.
    pub fn as_slice(&self) -> &[Root] {
        &self.list
    }

    /// Whether every root has its opposite: the splines are even then.
    pub fn is_symmetric(&self) -> bool {
        self.without_opposite.is_none()
    }

    /// Whether 0 is a root: constants are kept, and a translation of the points is a translation of the curve.
    pub fn keeps_constants(&self) -> bool {
        self.list.iter().any(|r| r.re == 0.0 && r.im == 0.0)
    }

    /// The roots on a grid that is finer by `parts`: each divided by it.
    ///
    /// # Errors
    ///
    /// `parts` not finite or not positive, or so small that a root would be larger than one may be ([`Self::new`]).
    pub fn scaled(&self, parts: f64) -> Result<Self> {
        check("parts", None, parts, f64::MIN_POSITIVE, f64::MAX)?;
        Self::new(&self.divided(parts).list, "roots")
    }

    /// [`Self::scaled`] for parts that leave roots that may be.
    #[inline(never)]
    pub(crate) fn divided(&self, parts: f64) -> Self {
        let list = self.list.iter().map(|r| Root { re: r.re / parts, im: r.im / parts }).collect();
        Self { list, without_opposite: self.without_opposite }
    }

    /// The coefficients of Π(1 − e^a z): the recurrence of what the roots stand for, at the integers.
    #[inline(never)]
    pub(crate) fn recurrence(&self) -> Vec<Twofold> {
        let mut product = vec![Twofold::ZERO; self.order() + 1];
        product[0] = Twofold::new(1.0);
        for r in self.upper() {
            let growth = exponential(r.re);
            if r.im == 0.0 {
                multiply(&mut product, [Twofold::new(1.0), growth.negative(), Twofold::ZERO]);
            } else {
                let middle = growth.times(cosine(r.im)).times(Twofold::new(-2.0));
                multiply(&mut product, [Twofold::new(1.0), middle, growth.times(growth)]);
            }
        }
        product
    }

    /// χ₀ … χ_{n−1} of Π(D − a) = Dⁿ + Σ χⱼDʲ.
    #[inline(never)]
    pub(super) fn operator(&self) -> Vec<Twofold> {
        let mut product = vec![Twofold::ZERO; self.order() + 1];
        product[0] = Twofold::new(1.0);
        for r in self.upper() {
            if r.im == 0.0 {
                multiply(&mut product, [Twofold::new(-r.re), Twofold::new(1.0), Twofold::ZERO]);
            } else {
                let square = Twofold::product(r.re, r.re).plus(Twofold::product(r.im, r.im));
                multiply(&mut product, [square, Twofold::new(-2.0 * r.re), Twofold::new(1.0)]);
            }
        }
        product.truncate(self.order());
        product
    }

    /// The same rounded.
    pub(crate) fn characteristic(&self) -> Vec<f64> {
        self.operator().iter().map(|c| c.high).collect()
    }

    /// e^{Σα}.
    pub(super) fn growth(&self) -> Twofold {
        self.list.iter().fold(Twofold::new(1.0), |product, r| product.times(exponential(r.re)))
    }

    /// The opposite of every root.
    pub(super) fn opposite(&self) -> Self {
        let list = self.list.iter().map(|r| Root { re: -r.re, im: -r.im }).collect();
        Self { list, without_opposite: self.without_opposite }
    }

    /// The index of the first root without an opposite.
    pub(super) fn without_opposite(&self) -> Option<usize> {
        self.without_opposite
    }

    /// The index of the first root with |im| ≥ π.
    pub(super) fn too_fast(&self) -> Option<usize> {
        self.list.iter().position(|r| r.im.abs() >= PI)
    }

    /// The largest |root|, or a little more.
    pub(super) fn largest(&self) -> f64 {
        self.list.iter().fold(0.0, |most: f64, r| most.max(size(*r)))
    }

    /// Every real root and every pair once: the members with im ≥ 0. Exact conjugates are the rule here.
    pub(super) fn upper(&self) -> impl Iterator<Item = Root> + '_ {
        self.list.iter().copied().filter(|r| r.im >= 0.0)
    }

    /// ∫β⁺ = β̂(0): what the values of the B-spline at a grid of step 1 sum to where 0 is a root.
    ///
    /// (e^a − 1)/a for every root a, multiplied in pairs so that it stays real (D 9.2).
    #[inline(never)]
    pub fn integral(&self) -> f64 {
        let mut product = 1.0;
        for r in self.upper() {
            let (a, b) = (0.5 * r.re, 0.5 * r.im);
            let (sinh, sin) = (stumpff(-a * a).c1, stumpff(b * b).c1);
            if r.im == 0.0 {
                product *= libm::exp(a) * sinh;
            } else {
                let most = a.abs().max(b);
                if most == 0.0 {
                    continue;
                }
                let (x, y) = (a / most, b / most);
                product *= libm::exp(r.re) * (x * x * sinh * sinh + y * y * sin * sin) / (x * x + y * y);
            }
        }
        product
    }

    /// β̂ at a root (or any complex number s in place of iω): the product of (e^{a−s} − 1)/(a − s).
    #[inline(never)]
    pub(super) fn transform(&self, s: Complex<f64>) -> Complex<f64> {
        let mut product = Complex::new(1.0, 0.0);
        for r in &self.list {
            let half = Complex::new(0.5 * (r.re - s.re), 0.5 * (r.im - s.im));
            // The factor is 1 to rounding; squares of what is smaller vanish.
            if half.re.abs() + half.im.abs() < 1e-100 {
                continue;
            }
            let (grow, turn) = (stumpff(-half.re * half.re), stumpff(half.im * half.im));
            let (sinh, sin) = (half.re * grow.c1, half.im * turn.c1);
            let sinh_half = Complex::new(sinh * turn.c0, grow.c0 * sin);
            let exp = Complex::new(turn.c0, sin) * libm::exp(half.re);
            product *= exp * sinh_half / half;
        }
        product
    }
}

/// A root whose frequency is not below a limit: the error has the largest number that is, as the range that it prints
/// has its ends.
#[cold]
pub(crate) fn too_fast(i: usize, im: f64, limit: f64) -> Box<Error> {
    let most = limit.min(im.abs()).next_down();
    Error::out_of_range("roots", Some(i), im, -most, most)
}

/// Multiplies a polynomial by one of degree at most 2, in place; there is room for the product.
#[inline(never)]
fn multiply(product: &mut [Twofold], factor: [Twofold; 3]) {
    for k in (0..product.len()).rev() {
        let mut sum = product[k].times(factor[0]);
        for (back, c) in factor.iter().enumerate().skip(1) {
            if k >= back {
                sum = sum.plus_product(product[k - back], *c);
            }
        }
        product[k] = sum;
    }
}
