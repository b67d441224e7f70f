//! Panels with axes, curves and marks, in the figures' common style.

/// Ink of the figures, by what it stands for.
pub(crate) const STYLE: &str = "<style>.axis{stroke:#9aa0a6;stroke-width:.8;fill:none}.tick{font:10px system-ui,sans-serif;fill:#5f6368}\
.title{font:600 12px system-ui,sans-serif;fill:#1b1f24}.note{font:11px system-ui,sans-serif;fill:#5f6368}\
.curve{fill:none;stroke:#1b1f24;stroke-width:2;stroke-linejoin:round}.blue{stroke:#0b57d0}.red{stroke:#c5221f}.teal{stroke:#0e7490}\
.thin{stroke-width:1}.dash{stroke-dasharray:6 4}.dot{stroke-dasharray:8 3 1.5 3}.part{stroke-dasharray:3 3;stroke-width:1.2}\
.point{fill:#c5221f}.control{fill:#0b57d0}.hidden{fill:none;stroke:#0b57d0;stroke-width:.8;opacity:.45}\
.net{fill:none;stroke:#0b2547;stroke-width:6;opacity:.5}.polygon{fill:#0b57d012;stroke:#0b57d0;stroke-width:1.2;stroke-linejoin:round}</style>";

/// A figure of a size, with what is in it.
pub(crate) fn figure(width: u32, height: u32, label: &str, content: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\" \
         aria-label=\"{label}\">\n{STYLE}\n<rect width=\"{width}\" height=\"{height}\" fill=\"#fbfbfa\"/>\n{content}</svg>\n"
    )
}

/// A line of text.
pub(crate) fn text(class: &str, x: f64, y: f64, anchor: &str, words: &str) -> String {
    format!("<text class=\"{class}\" x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"{anchor}\">{words}</text>\n")
}

/// A disc.
pub(crate) fn disc(class: &str, (x, y): (f64, f64), radius: f64) -> String {
    format!("<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\"/>\n")
}

/// A polyline through places of the page.
pub(crate) fn path(class: &str, places: &[(f64, f64)], closed: bool) -> String {
    let mut d = String::new();
    for (x, y) in places {
        d += &format!("{}{x:.1} {y:.1}", if d.is_empty() { 'M' } else { 'L' });
    }
    format!("<path class=\"{class}\" d=\"{d}{}\"/>\n", if closed { "Z" } else { "" })
}

/// A rectangle of the page that shows a rectangle of numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Panel {
    /// Left, top, width and height on the page.
    pub(crate) page: [f64; 4],
    /// Least and largest x, least and largest y.
    pub(crate) range: [f64; 4],
}

impl Panel {
    /// Where a pair of numbers is on the page.
    pub(crate) fn place(&self, x: f64, y: f64) -> (f64, f64) {
        let ([left, top, width, height], [x0, x1, y0, y1]) = (self.page, self.range);
        (left + width * (x - x0) / (x1 - x0), top + height * (y1 - y) / (y1 - y0))
    }

    /// Axes through 0 (or the lower left), with whole numbers written beside them.
    pub(crate) fn axes(&self, xs: &[i32], ys: &[f64]) -> String {
        let [x0, x1, y0, y1] = self.range;
        let foot = 0.0_f64.clamp(y0, y1);
        let mut drawn = path("axis", &[self.place(x0, foot), self.place(x1, foot)], false);
        drawn += &path(
            "axis",
            &[self.place(0.0_f64.clamp(x0, x1), y0), self.place(0.0_f64.clamp(x0, x1), y1)],
            false,
        );
        for &x in xs.iter().filter(|x| **x != 0) {
            let (px, py) = self.place(f64::from(x), foot);
            drawn += &path("axis", &[(px, py - 2.0), (px, py + 2.0)], false);
            drawn += &text("tick", px, py + 14.0, "middle", &format!("{x}").replace('-', "−"));
        }
        for &y in ys {
            let (px, py) = self.place(0.0_f64.clamp(x0, x1), y);
            drawn += &path("axis", &[(px - 2.0, py), (px + 2.0, py)], false);
            drawn += &text("tick", px - 5.0, py + 3.0, "end", &format!("{y}").replace('-', "−"));
        }
        drawn
    }

    /// The graph of a function over part of the range.
    pub(crate) fn graph(&self, class: &str, [from, to]: [f64; 2], function: &dyn Fn(f64) -> f64) -> String {
        let steps = 120;
        let places: Vec<_> = (0..=steps)
            .map(|i| {
                let x = from + (to - from) * f64::from(i) / f64::from(steps);
                self.place(x, function(x))
            })
            .collect();
        path(class, &places, false)
    }
}
