//! The page: one HTML file without anything beside it. Promises first, then the conclusions, then a section for each scene
//! with its pictures, its plot and its table, then the hints, then how it was measured.

use super::front::mean;
use super::hints::Verdict;
use super::plot::{COLORS, difference, element, escape, plot};
use super::run::{Outcome, Row};
use super::stages::STAGES;
use super::table::{Check, short, spec_words};
use std::fmt::Write as _;

const STYLE: &str = "
:root { --ink: #1c2128; --soft: #5b6570; --line: #d9dee4; --paper: #ffffff; --tint: #f3f6f9; --good: #1a7f37; --bad: #b3261e; }
@media (prefers-color-scheme: dark) { :root { --ink: #e3e8ee; --soft: #9aa5b1; --line: #38414b; --paper: #15191e;
  --tint: #1e242b; --good: #56c271; --bad: #ff8a80; } }
body { font: 15px/1.55 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 72rem; margin: 2rem auto;
  padding: 0 1.2rem; }
h1 { font-size: 1.7rem; margin: 0 0 .3rem; } h2 { font-size: 1.25rem; margin: 2.6rem 0 .5rem; border-bottom: 1px solid var(--line);
  padding-bottom: .25rem; } h3 { font-size: 1.02rem; margin: 1.6rem 0 .3rem; }
p { max-width: 60rem; margin: .5rem 0; } .soft, figcaption { color: var(--soft); }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; margin: .6rem 0; }
th, td { padding: .18rem .6rem; text-align: right; white-space: nowrap; } th { color: var(--soft); font-weight: 600; }
th:first-child, td:first-child { text-align: left; padding-left: 0; } thead th { border-bottom: 1px solid var(--line); vertical-align: bottom; }
tr.front td { background: var(--tint); } tr.front td:first-child { font-weight: 600; } td.lib { text-align: left; }
.good { color: var(--good); font-weight: 600; } .bad { color: var(--bad); font-weight: 600; }
figure { margin: 0; } figcaption { font-size: 12px; margin-top: .2rem; max-width: 192px; }
.row { display: flex; flex-wrap: wrap; gap: .9rem; margin: .7rem 0; } .wide { overflow-x: auto; }
img { image-rendering: pixelated; display: block; border-radius: 3px; }
svg { width: 100%; max-width: 52rem; height: auto; } svg text { font: 11px system-ui, sans-serif; fill: var(--soft); }
svg text.l { font-size: 10.5px; fill: var(--ink); } svg text.a { font-size: 12px; } svg .g { stroke: var(--line); stroke-width: 1; }
.key i { display: inline-block; width: .75em; height: .75em; margin: 0 .35em 0 0; border-radius: 50%; } .key span { margin-right: 1.2em; }
nav a { margin-right: .8em; } a { color: #3273c5; } code { font-size: .95em; }
";

/// What the page tells about the run itself.
pub struct Run<'a> {
    pub names: &'a [&'a str],
    pub level: String,
    pub samples: u32,
    pub seconds: f64,
    pub instructions: bool,
}

/// The whole page.
pub fn page(
    outcomes: &[Outcome],
    checks: &[Check],
    conclusions: &[(&str, String)],
    verdicts: &[Verdict],
    run: &Run<'_>,
) -> String {
    let mut html = format!(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">\
         <title>fixedgl: error against run time</title><style>{STYLE}</style>\n<h1>Error against run time</h1>\n"
    );
    introduction(&mut html, run);
    promises(&mut html, checks);
    html.push_str("<h2>Conclusions</h2>\n");
    for (words, text) in conclusions {
        let _ = writeln!(html, "<h3>{}</h3><p>{}</p>", escape(words), escape(text));
    }
    if run.names.len() > 1 {
        side_by_side(&mut html, outcomes, run);
    }
    stage_table(&mut html, outcomes, run);
    html.push_str(
        "<h2>Hints</h2>\n<p class=\"soft\">A hint that buys no time for its error is dropped: it is accepted \
                   and can be asked for, and has no effect.</p>\n",
    );
    verdicts.iter().for_each(|v| verdict(&mut html, v));
    html.push_str("<h2>Scenes</h2>\n<nav>");
    for o in outcomes {
        let _ = write!(html, "<a href=\"#{0}\">{1}</a>", anchor(o), escape(&o.subject.name));
    }
    html.push_str("</nav>\n");
    outcomes.iter().for_each(|o| scene(&mut html, o, run));
    html.push_str("</html>\n");
    html
}

fn anchor(o: &Outcome) -> String {
    o.subject.name.replace(' ', "-")
}

fn introduction(html: &mut String, run: &Run<'_>) {
    let key = run.names.iter().zip(COLORS).fold(String::new(), |key, (name, color)| {
        format!("{key}<span><i style=\"background:{color}\"></i>{}</span>", escape(name))
    });
    let _ = writeln!(
        html,
        "<p class=\"key\">{key}</p>\n<p><b>E_spec</b> is the distance of a picture from the f64 oracle of the same GL state, in steps of 8 bits (LSB): \
         what the implementation adds. <b>E_samp</b> is its distance from the continuous scene under the aperture of a pixel, sampled {0} x {0} \
         times: what the chosen filter leaves, however exactly it is computed. They are never mixed. Time is ns a fragment on one thread ({1}), the \
         least of many turns; {2}A filled mark is on the Pareto front: nothing else in its library is at least as fast and as near. This run took \
         {3:.0} s.</p>",
        run.samples,
        escape(&run.level),
        if run.instructions {
            "instructions are callgrind's at AVX2. "
        } else {
            "instructions were not counted in this run. "
        },
        run.seconds
    );
}

fn promises(html: &mut String, checks: &[Check]) {
    let failed = checks.iter().filter(|c| !c.kept).count();
    let (class, words) = if failed == 0 { ("good", "all kept") } else { ("bad", "not all kept") };
    let _ = writeln!(
        html,
        "<h2>Promises in the default setting</h2>\n<p><span class=\"{class}\">{words}</span>: {} of {} figures.</p>\n<div class=\"wide\"><table>\
         <thead><tr><th>scene<th>at most 1 LSB on 99.9 %<th>lambda to 1e-4<th>no pixel missing or doubled</thead>",
        checks.len() - failed,
        checks.len()
    );
    let mut scenes: Vec<&str> = checks.iter().map(|c| c.scene.as_str()).collect();
    scenes.dedup();
    for name in scenes {
        let _ = write!(html, "<tr><td>{}", escape(name));
        for what in ["at most 1", "lambda", "no pixel"] {
            match checks.iter().find(|c| c.scene == name && c.what.starts_with(what)) {
                Some(c) => {
                    let class = if c.kept { "good" } else { "bad" };
                    let _ = write!(html, "<td class=\"{class}\">{}", escape(&c.figure));
                }
                None => html.push_str("<td>-"),
            }
        }
        html.push('\n');
    }
    html.push_str("</table></div>\n");
}

fn side_by_side(html: &mut String, outcomes: &[Outcome], run: &Run<'_>) {
    let of = |o: &'_ Outcome, library: usize| -> Vec<(f64, f64, f64)> {
        o.rows.iter().filter(|r| r.library == library).map(|r| (r.ns, r.spec.rmse, r.square.rmse)).collect()
    };
    let _ = writeln!(
        html,
        "<h2>{} and {}</h2>\n<p class=\"soft\">The default setting. Ratios are {1} over {0}: more than 1 means that {0} is faster or nearer.</p>\n\
         <div class=\"wide\"><table><thead><tr><th>scene<th>ns<th>ns, peer<th>ratio<th>E_spec rms<th>peer<th>&gt; 1 LSB %<th>peer<th>E_samp rms<th>peer<th>missing, doubled (peer)</thead>",
        escape(run.names[0]),
        escape(run.names[1])
    );
    let mut ratios = Vec::new();
    for o in outcomes {
        let default = |library: usize| o.rows.iter().find(|r| r.library == library);
        let (Some(a), Some(b)) = (default(0), default(1)) else { continue };
        for (ours, peer) in of(o, 0).iter().zip(of(o, 1)) {
            ratios.push(peer.0 / ours.0.max(1e-9));
        }
        let _ = writeln!(
            html,
            "<tr><td>{}<td>{:.2}<td>{:.2}<td>{:.2}<td>{}<td>{}<td>{:.3}<td>{:.3}<td>{:.2}<td>{:.2}<td>{}, {}",
            escape(&o.subject.name),
            a.ns,
            b.ns,
            b.ns / a.ns.max(1e-9),
            short(a.spec.rmse),
            short(b.spec.rmse),
            100.0 * a.spec.off,
            100.0 * b.spec.off,
            a.square.rmse,
            b.square.rmse,
            o.coverage[1].0,
            o.coverage[1].1
        );
    }
    let _ = writeln!(
        html,
        "</table></div>\n<p>Over all {} settings of all scenes the geometric mean of the ratios of time is {:.2}.</p>",
        ratios.len(),
        mean(&ratios)
    );
}

fn stage_table(html: &mut String, outcomes: &[Outcome], run: &Run<'_>) {
    html.push_str(
        "<h2>E_spec by stage</h2>\n<p class=\"soft\">The greatest error in the default setting, observed from outside in a framebuffer of \
         floats. Depth follows corners that are rounded to 1/256 pixel, on purpose.</p>\n<div class=\"wide\"><table><thead><tr><th>scene<th>library",
    );
    for (_, name, unit) in STAGES {
        let _ = write!(html, "<th>{name}<br><small>{unit}</small>");
    }
    html.push_str("</thead>\n");
    for o in outcomes {
        for (library, found) in o.stages.iter().enumerate() {
            let _ = write!(html, "<tr><td>{}<td class=\"lib\">{}", escape(&o.subject.name), escape(run.names[library]));
            for (stage, _, _) in STAGES {
                let figures = found.iter().find(|(s, _)| *s == stage).and_then(|(_, f)| *f);
                let _ = write!(html, "<td>{}", figures.map_or("-".to_string(), |f| short(f.max)));
            }
            html.push('\n');
        }
    }
    html.push_str("</table></div>\n");
}

fn verdict(html: &mut String, v: &Verdict) {
    let _ = writeln!(html, "<h3><code>{}</code>: {}</h3>\n<p>{}</p>", v.hint, v.words(), escape(&v.text));
    html.push_str("<table><thead><tr><th>trial<th>time<th>error</thead>\n");
    for t in &v.trials {
        let _ = writeln!(
            html,
            "<tr><td>{}<td>{:.2} {}<td>{:.2} {}",
            escape(&t.name),
            t.time,
            t.time_unit,
            t.error,
            t.error_unit
        );
    }
    html.push_str("</table>\n");
}

fn scene(html: &mut String, o: &Outcome, run: &Run<'_>) {
    let _ = write!(
        html,
        "<section id=\"{}\"><h2>{}</h2>\n<p>{}.</p>\n<div class=\"row\">",
        anchor(o),
        escape(&o.subject.name),
        escape(o.subject.what)
    );
    let width = o.subject.scene.width;
    let ours: Vec<usize> = (0..o.rows.len()).filter(|&i| o.rows[i].library == 0).collect();
    let best =
        ours.iter().copied().min_by(|&a, &b| o.rows[a].square.rmse.total_cmp(&o.rows[b].square.rmse)).unwrap_or(0);
    let mut show = |picture: &super::run::Picture, caption: &str| html.push_str(&element(picture, width, caption));
    let name = |i: usize| o.rows[i].knobs.name;
    show_row(&mut show, o, best, name, run);
    let _ = writeln!(html, "</div>\n{}", plot(o, run.names));
    rows(html, o, run);
    let steps: Vec<String> =
        o.convergence.iter().map(|c| format!("{0} x {0}: {1:.3} and {2:.3}", c.k, c.square, c.gauss)).collect();
    let last = o.convergence.last().map_or(0.0, |c| c.square.max(c.gauss));
    let _ = writeln!(
        html,
        "<p class=\"soft\">Convergence of the ideal (LSB rms against half as many samples a side, square and Gaussian): {}{}.</p></section>",
        steps.join("; "),
        if last > 1.0 { " <b class=\"bad\">not converged to 1 LSB</b>" } else { "" }
    );
}

fn show_row<'a>(
    show: &mut dyn FnMut(&super::run::Picture, &str),
    o: &Outcome,
    best: usize,
    name: impl Fn(usize) -> &'a str,
    run: &Run<'_>,
) {
    show(&o.pictures[0], &format!("default: {}", name(0)));
    show(&o.ideal, "the ideal under a square pixel");
    show(&difference(&o.pictures[0], &o.ideal, 4), "E_samp of the default, times 4");
    show(&o.pictures[best], &format!("nearest: {}", name(best)));
    show(&difference(&o.pictures[0], &o.spec, 64), "E_spec of the default, times 64");
    if let Some(peer) = o.rows.iter().position(|r| r.library == 1) {
        show(&difference(&o.pictures[peer], &o.spec, 64), &format!("E_spec of {}, times 64", run.names[1]));
    }
}

fn rows(html: &mut String, o: &Outcome, run: &Run<'_>) {
    html.push_str(
        "<div class=\"wide\"><table><thead><tr><th rowspan=2>setting<th rowspan=2>library<th rowspan=2>ns<th rowspan=2>instructions\
         <th colspan=4>E_spec (LSB)<th colspan=6>E_samp (LSB)<tr><th>max<th>rms<th>&gt; 1, %<th>p99.9<th>square rms<th>Gauss rms<th>max\
         <th>p99.9<th>PSNR dB<th>SSIM</thead>\n",
    );
    let mut sorted: Vec<&Row> = o.rows.iter().collect();
    sorted.sort_by(|a, b| (a.library, a.ns).partial_cmp(&(b.library, b.ns)).unwrap_or(std::cmp::Ordering::Equal));
    for r in sorted {
        let _ = writeln!(
            html,
            "<tr{}><td>{}<td class=\"lib\">{}<td>{:.2}<td>{}<td>{}<td>{:.2}<td>{:.2}<td>{:.0}<td>{:.0}<td>{:.2}<td>{:.4}",
            if r.front { " class=\"front\"" } else { "" },
            escape(r.knobs.name),
            escape(run.names[r.library]),
            r.ns,
            r.instructions.map_or("-".to_string(), |i| format!("{i:.1}")),
            spec_words(r).join("<td>"),
            r.square.rmse,
            r.gauss.rmse,
            r.square.max,
            r.square.p999,
            r.square.psnr,
            r.ssim
        );
    }
    html.push_str("</table></div>\n");
}
