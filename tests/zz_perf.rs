use expline::svg::*;
use std::time::Instant;
#[test]
fn perf() {
    let mut s: u64 = 7;
    let mut r = || {
        s = s.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (s >> 33) as f64 / 2147483648.0 * 1000.0
    };
    let mut d2 = String::from("M0 0");
    let mut d17 = String::from("M0 0");
    for _ in 0..1000 {
        d2.push('C');
        d17.push('C');
        for k in 0..6 {
            let v = r();
            if k > 0 {
                d2.push(' ');
                d17.push(' ');
            }
            d2 += &format!("{v:.2}");
            d17 += &format!("{v}");
        }
    }
    for (n, d) in [("2 decimals", &d2), ("full", &d17)] {
        let t = Instant::now();
        for _ in 0..200 {
            std::hint::black_box(parse_path(std::hint::black_box(d)).unwrap());
        }
        println!("parse {n} {} bytes: {:.1} us", d.len(), t.elapsed().as_secs_f64() / 200.0 * 1e6);
    }
    let c = parse_path(&d17).unwrap().curves.remove(0);
    for (n, o) in [
        ("default", PrintOptions::default()),
        ("rel", PrintOptions { relative: true, ..Default::default() }),
        ("3", PrintOptions { decimals: Some(3), ..Default::default() }),
        ("17", PrintOptions { decimals: Some(17), ..Default::default() }),
    ] {
        let p = to_path_d(&c, &o).unwrap();
        let t = Instant::now();
        for _ in 0..200 {
            std::hint::black_box(to_path_d(std::hint::black_box(&c), &o).unwrap());
        }
        println!(
            "print {n} {} bytes dev {:.2e}: {:.1} us",
            p.d.len(),
            p.deviation,
            t.elapsed().as_secs_f64() / 200.0 * 1e6
        );
    }
}
