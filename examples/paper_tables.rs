//! Six ways to follow the same tubes of the same edges, on pictures drawn here: `cargo run --example paper_tables`
//! writes the table in docs/PROFILES.md; `cargo run --release --example paper_tables times` prints how long profiles
//! take.

#[path = "profiles/estimators.rs"]
mod estimators;
#[path = "profiles/pictures.rs"]
mod pictures;

use estimators::{ALL, Followed};
use expline::numerics::{Point, Vector};
use expline::trace::{
    Chain, EdgeOptions, Edges, Gray, ProfileOptions, diameter, directed_hausdorff, edges, jaccard, profiles,
};
use pictures::Picture;
use std::error::Error;
use std::fmt::Write as _;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// The chains of a picture's edges, of pixels' centres as in the paper.
fn chains(bytes: &[u8]) -> Outcome<Vec<Chain>> {
    let gray = Gray::from_bytes(pictures::SIDE, pictures::SIDE, bytes)?;
    let mut found: Edges = edges(&gray, &EdgeOptions::default())?;
    for p in &mut found.points {
        p.point = Point::new(f64::from(p.column) + 0.5, f64::from(p.row) + 0.5);
    }
    let mut chains = profiles(&found)?;
    chains.retain(|chain| chain.points().len() >= 20);
    Ok(chains)
}

/// Sums over the tubes of a picture for one way to follow them.
#[derive(Default)]
struct Row {
    square: f64,
    absolute: f64,
    count: usize,
    numbers: usize,
    /// Sum of the distances from the picture's own edge, and of the lengths that they are weighted by.
    edge: f64,
    length: f64,
    hausdorff: f64,
    curve: Vec<(i32, i32)>,
}

impl Row {
    fn add(&mut self, followed: &Followed, points: &[Point], chord: [Point; 2], picture: &Picture) {
        for r in &followed.left_out {
            self.square += r * r;
            self.absolute += r.abs();
        }
        self.count += followed.left_out.len();
        self.numbers += followed.numbers;
        let way = chord[1] - chord[0];
        let along = way / way.norm();
        let across = Vector::new(-along.y, along.x);
        let places: Vec<Point> = (0..=200)
            .map(|i| way.norm() * f64::from(i) / 200.0)
            .map(|x| chord[0] + along * x + across * (followed.value)(x))
            .collect();
        for place in &places {
            self.edge += picture.distance(place.x, place.y) * way.norm();
        }
        self.length += way.norm() * places.len() as f64;
        self.hausdorff = self.hausdorff.max(directed_hausdorff(&places, points));
        self.curve.extend(places.iter().map(|p| (p.x.floor() as i32, p.y.floor() as i32)));
    }
}

/// What all tubes of a picture are followed like by each of [`ALL`].
fn rows(picture: &Picture, chains: &[Chain]) -> Outcome<(Vec<Row>, usize, f64)> {
    let mut rows: Vec<Row> = ALL.iter().map(|_| Row::default()).collect();
    let (mut tubes, mut longest) = (0, 0.0_f64);
    for chain in chains {
        let profile = chain.follow(&ProfileOptions::printed())?;
        longest = longest.max(diameter(chain.points()));
        for (tube, joints) in profile.tubes().iter().zip(profile.joints()) {
            let points = profile.chain().tube_points(tube);
            let chord = [joints[0].point, joints[1].point];
            let way = chord[1] - chord[0];
            let along = way / way.norm();
            let local = |p: &Point| {
                Point::new((p - chord[0]).dot(&along), (p - chord[0]).dot(&Vector::new(-along.y, along.x)))
            };
            let inside: Vec<Point> =
                points.iter().map(local).filter(|p| (0.0..=way.norm()).contains(&p.x)).collect();
            if inside.len() < 9 {
                continue;
            }
            tubes += 1;
            for (row, (_, follow)) in rows.iter_mut().zip(ALL) {
                row.add(&follow(&inside, way.norm())?, &points, chord, picture);
            }
        }
    }
    Ok((rows, tubes, longest))
}

/// The table in docs/PROFILES.md.
pub(crate) fn table() -> Outcome<String> {
    let mut text = String::new();
    for picture in pictures::all() {
        let name = picture.name;
        let chains = chains(&picture.bytes)?;
        let pixels: Vec<(i32, i32)> = chains
            .iter()
            .flat_map(|chain| chain.points())
            .map(|p| (p.x.floor() as i32, p.y.floor() as i32))
            .collect();
        let (rows, tubes, longest) = rows(&picture, &chains)?;
        writeln!(text, "\n**{name}** ({} chains, {} points, {tubes} tubes)\n", chains.len(), pixels.len())?;
        writeln!(text, "| | RMSE px | MAE px | to the edge px | Hausdorff/L | Jaccard | coefficients |")?;
        writeln!(text, "|---|---|---|---|---|---|---|")?;
        for (row, (way, _)) in rows.iter().zip(ALL) {
            let count = row.count.max(1) as f64;
            let (rmse, mae) = ((row.square / count).sqrt(), row.absolute / count);
            let share = jaccard(&pixels, &row.curve).tolerant;
            let far = row.hausdorff / longest;
            let edge = row.edge / row.length;
            let numbers = row.numbers;
            writeln!(
                text,
                "| {way} | {rmse:.3} | {mae:.3} | {edge:.3} | {far:.4} | {share:.3} | {numbers} |"
            )?;
        }
    }
    Ok(text)
}

#[allow(dead_code, reason = "the test of the table has its own")]
fn main() -> Outcome<()> {
    if std::env::args().nth(1).as_deref() == Some("times") {
        for Picture { name, bytes, .. } in pictures::all() {
            for chain in chains(&bytes)? {
                for (way, options) in
                    [("printed", ProfileOptions::printed()), ("improved", ProfileOptions::default())]
                {
                    let start = std::time::Instant::now();
                    let tubes = chain.follow(&options)?.tubes().len();
                    let spent = 1e3 * start.elapsed().as_secs_f64();
                    let mut line = String::new();
                    write!(
                        line,
                        "{name}: {way}, {} points, {tubes} tubes, {spent:.2} ms",
                        chain.points().len()
                    )?;
                    #[allow(clippy::print_stdout, reason = "this is what it is for")]
                    {
                        println!("{line}");
                    }
                }
            }
        }
        return Ok(());
    }
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/PROFILES.md");
    let text = std::fs::read_to_string(page)?;
    let head = text.split(MARK).next().unwrap_or_default();
    std::fs::write(page, format!("{head}{MARK}{}", table()?))?;
    Ok(())
}

/// Everything behind this line of docs/PROFILES.md is written by the program.
pub(crate) const MARK: &str = "<!-- below: cargo run --example paper_tables -->\n";
