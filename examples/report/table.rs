//! The figures as text: the main table, the table of stages, the acceptance, the CSV, and the baseline that is kept. The
//! baseline has what does not depend on the machine: E_spec of this crate, scene by scene, end to end and by stage.

use super::run::{Outcome, Row};
use super::stages::STAGES;
use std::fmt::Write as _;

/// What E_spec must not exceed in the default setting.
pub const MOST_OFF: f64 = 1e-3;
/// And lambda.
pub const MOST_LAMBDA: f64 = 1e-4;

/// One promise, kept or not.
pub struct Check {
    pub scene: String,
    pub what: &'static str,
    pub figure: String,
    pub kept: bool,
}

/// The acceptance of this crate in the default setting.
pub fn checks(outcomes: &[Outcome]) -> Vec<Check> {
    let mut checks = Vec::new();
    for o in outcomes {
        let scene = &o.subject.name;
        let mut add = |what, figure: String, kept| checks.push(Check { scene: scene.clone(), what, figure, kept });
        let off = o.rows[0].spec.off;
        add("at most 1 LSB on 99.9 % of the pixels", format!("{:.4} % off", 100.0 * off), off <= MOST_OFF);
        let lambda = o.stages[0].iter().find(|(s, _)| *s == super::stages::Stage::Lambda).and_then(|(_, f)| *f);
        if let Some(lambda) = lambda {
            add("lambda to 1e-4", short(lambda.max), lambda.max <= MOST_LAMBDA);
        }
        let (missing, doubled) = o.coverage[0];
        let figure = format!("{missing} missing, {doubled} doubled");
        add("no pixel missing or doubled", figure, missing + doubled == 0);
    }
    checks
}

/// A number with about three digits.
pub fn short(v: f64) -> String {
    match v.abs() {
        0.0 => "0".to_string(),
        a if !(1e-3..1e5).contains(&a) => format!("{v:.1e}"),
        a if a < 10.0 => format!("{v:.3}"),
        a if a < 100.0 => format!("{v:.2}"),
        _ => format!("{v:.0}"),
    }
}

/// The figures of E_spec in words, dashes where every pixel is in doubt: greatest, rms, share in per cent, p99.9.
pub fn spec_words(row: &Row) -> [String; 4] {
    let e = &row.spec;
    if e.pixels == 0 {
        return std::array::from_fn(|_| "-".to_string());
    }
    [short(e.max), short(e.rmse), format!("{:.3}", 100.0 * e.off), short(e.p999)]
}

/// The main table.
pub fn text(outcomes: &[Outcome], names: &[&str]) -> String {
    let mut out = String::from(
        "* on the front of time and E_samp.  E_spec: LSB against the f64 oracle of the same state; > 1: % of pixels.  \
         E_samp: LSB rms against the ideal under a square and under a Gaussian\n\n",
    );
    let _ = writeln!(
        out,
        "{:12} {:29} {:9} {:>8} {:>8} | {:>7} {:>7} {:>6} {:>6} | {:>6} {:>6} {:>6} {:>6}",
        "scene", "setting", "library", "ns", "instr", "max", "rms", "> 1 %", "p99.9", "square", "gauss", "PSNR", "SSIM"
    );
    for o in outcomes {
        for r in &o.rows {
            let instructions = r.instructions.map_or("-".to_string(), |i| format!("{i:.1}"));
            let [max, rms, off, p999] = spec_words(r);
            let _ = writeln!(
                out,
                "{:12} {:27}{:2} {:9} {:8.2} {:>8} | {max:>7} {rms:>7} {off:>6} {p999:>6} | {:6.2} {:6.2} {:6.2} {:6.3}",
                o.subject.name,
                r.knobs.name,
                if r.front { " *" } else { "" },
                names[r.library],
                r.ns,
                instructions,
                r.square.rmse,
                r.gauss.rmse,
                r.square.psnr,
                r.ssim
            );
        }
    }
    out
}

/// E_spec by stage: the greatest error, in the default setting.
pub fn stages(outcomes: &[Outcome], names: &[&str]) -> String {
    let mut out = format!("{:12} {:9}", "scene", "library");
    for (_, name, unit) in STAGES {
        let _ = write!(out, " {:>20}", format!("{name} [{}]", unit.split(' ').next().unwrap_or(unit)));
    }
    out.push('\n');
    for o in outcomes {
        for (library, found) in o.stages.iter().enumerate() {
            let _ = write!(out, "{:12} {:9}", o.subject.name, names[library]);
            for (stage, _, _) in STAGES {
                let figures = found.iter().find(|(s, _)| *s == stage).and_then(|(_, f)| *f);
                let _ = write!(out, " {:>20}", figures.map_or("-".to_string(), |f| short(f.max)));
            }
            out.push('\n');
        }
    }
    out
}

/// All rows with all figures.
pub fn csv(outcomes: &[Outcome], names: &[&str]) -> String {
    let mut out = String::from(
        "scene,setting,library,front,ns_per_fragment,instructions_per_fragment,spec_max_lsb,spec_rmse_lsb,spec_psnr_db,\
         spec_share_over_1_lsb,spec_p999_lsb,spec_pixels,spec_doubtful_share,samp_square_max_lsb,samp_square_rmse_lsb,\
         samp_square_psnr_db,samp_square_share_over_1_lsb,samp_square_p999_lsb,samp_gauss_max_lsb,samp_gauss_rmse_lsb,\
         samp_gauss_psnr_db,ssim\n",
    );
    for o in outcomes {
        for r in &o.rows {
            let instructions = r.instructions.map_or(String::new(), |i| format!("{i:.2}"));
            let (s, q, g) = (&r.spec, &r.square, &r.gauss);
            let _ = write!(out, "{},\"{}\",{},{}", o.subject.name, r.knobs.name, names[r.library], u8::from(r.front));
            let _ = write!(out, ",{:.3},{instructions},{:.6},{:.6},{:.3}", r.ns, s.max, s.rmse, s.psnr);
            let _ = write!(out, ",{:.6},{:.6},{},{:.6}", s.off, s.p999, s.pixels, r.doubtful);
            let _ = write!(out, ",{:.4},{:.5},{:.3},{:.6},{:.4}", q.max, q.rmse, q.psnr, q.off, q.p999);
            let _ = writeln!(out, ",{:.4},{:.5},{:.3},{:.6}", g.max, g.rmse, g.psnr, r.ssim);
        }
    }
    out
}

/// The stages of all scenes and libraries as CSV.
pub fn stages_csv(outcomes: &[Outcome], names: &[&str]) -> String {
    let mut out = String::from("scene,library,stage,unit,max,rmse,p999,count\n");
    for o in outcomes {
        for (library, found) in o.stages.iter().enumerate() {
            for (stage, figures) in found {
                let Some((_, name, unit)) = STAGES.into_iter().find(|(s, _, _)| s == stage) else { continue };
                let Some(f) = figures else { continue };
                let (scene, library) = (&o.subject.name, names[library]);
                let _ = writeln!(
                    out,
                    "{scene},{library},\"{name}\",{unit},{:.3e},{:.3e},{:.3e},{}",
                    f.max, f.rmse, f.p999, f.count
                );
            }
        }
    }
    out
}

/// The settings that every run measures, so that a baseline of any run fits any other.
fn in_every_run(row: &&Row) -> bool {
    row.library == 0 && super::knobs::settings(super::scenes::Depth::Short, true).contains(&row.knobs)
}

/// The baseline: a line for each figure.
pub fn baseline(outcomes: &[Outcome]) -> String {
    let mut out = String::from("scene\tfigure\tvalue\n");
    for o in outcomes {
        let scene = &o.subject.name;
        for r in o.rows.iter().filter(in_every_run) {
            let (name, e) = (r.knobs.name, &r.spec);
            let _ = writeln!(out, "{scene}\t{name}: max LSB\t{:.6}", e.max);
            let _ = writeln!(out, "{scene}\t{name}: rms LSB\t{:.6}", e.rmse);
            let _ = writeln!(out, "{scene}\t{name}: share over 1 LSB\t{:.6}", e.off);
        }
        for (stage, figures) in &o.stages[0] {
            let Some((_, name, unit)) = STAGES.into_iter().find(|(s, _, _)| s == stage) else { continue };
            if let Some(f) = figures {
                let _ = writeln!(out, "{scene}\t{name}: max {unit}\t{:.3e}", f.max);
                let _ = writeln!(out, "{scene}\t{name}: rms {unit}\t{:.3e}", f.rmse);
            }
        }
    }
    out
}

/// What a figure may rise by, and below which size a difference means nothing (a last digit of the file).
const RISE: f64 = 1.02;
const NOTHING: f64 = 2e-6;

/// The figures that have risen against a baseline, and what is missing on either side, in words.
pub fn risen(now: &str, kept: &str) -> Vec<String> {
    let figures = |text: &str| -> Vec<(String, f64)> {
        let line = |l: &str| {
            let (name, value) = l.rsplit_once('\t')?;
            Some((name.replace('\t', ", "), value.parse().ok()?))
        };
        text.lines().skip(1).filter_map(line).collect()
    };
    let (now, kept) = (figures(now), figures(kept));
    let find = |list: &[(String, f64)], name: &str| list.iter().find(|(n, _)| n == name).map(|(_, v)| *v);
    let mut words = Vec::new();
    for (name, value) in &now {
        match find(&kept, name) {
            Some(old) if *value > old * RISE + NOTHING => {
                words.push(format!("{name}: {} has become {}", short(old), short(*value)));
            }
            Some(_) => {}
            None => words.push(format!("{name}: not in the baseline (--bless writes a new one)")),
        }
    }
    let gone = kept.iter().filter(|(name, _)| find(&now, name).is_none());
    words.extend(gone.map(|(name, _)| format!("{name}: in the baseline, but not measured")));
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rise_is_seen_and_a_fall_is_not() {
        let kept = "scene\tfigure\tvalue\nplane\trms\t0.300000\nplane\tmax\t0\n";
        assert!(risen(kept, kept).is_empty());
        assert!(risen("h\nplane\trms\t0.305\nplane\tmax\t0\n", kept).is_empty());
        assert_eq!(risen("h\nplane\trms\t0.307\nplane\tmax\t0\n", kept), ["plane, rms: 0.300 has become 0.307"]);
        assert_eq!(risen("h\nplane\trms\t0.1\nplane\tmax\t1e-3\n", kept).len(), 1);
        assert_eq!(risen("h\nplane\trms\t0.3\nstar\tmax\t0\n", kept).len(), 2);
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.0, 1e-5, 0.5, 12.345, 512.4].map(short), ["0", "1.0e-5", "0.500", "12.35", "512"]);
    }
}
