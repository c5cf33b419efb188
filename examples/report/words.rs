//! The conclusions: for each family of scenes one paragraph on what to choose, made from the figures of this run.

use super::front::{Point, bargain, fastest, front, mean, nearest};
use super::knobs::Knobs;
use super::run::{Outcome, Row};
use super::scenes::{Depth, FAMILIES, Family};

/// A setting over all scenes of a family: geometric means of time and error.
struct Choice {
    knobs: Knobs,
    point: Point,
}

/// The settings of this crate that every scene of the family has.
fn choices(outcomes: &[&Outcome]) -> Vec<Choice> {
    let Some(first) = outcomes.first() else { return Vec::new() };
    let find = |o: &'_ Outcome, knobs: &Knobs| -> Option<Point> {
        let row: &Row = o.rows.iter().find(|r| r.library == 0 && r.knobs == *knobs)?;
        Some(Point { time: row.ns, error: row.square.rmse })
    };
    let one = |row: &Row| {
        let points: Option<Vec<Point>> = outcomes.iter().map(|o| find(o, &row.knobs)).collect();
        let points = points?;
        let time = mean(&points.iter().map(|p| p.time).collect::<Vec<_>>());
        let error = mean(&points.iter().map(|p| p.error).collect::<Vec<_>>());
        Some(Choice { knobs: row.knobs.clone(), point: Point { time, error } })
    };
    first.rows.iter().filter(|r| r.library == 0).filter_map(one).collect()
}

/// What a setting costs and how near it comes.
fn priced(c: &Choice) -> String {
    format!("{} ({:.1} ns a fragment, {:.1} LSB rms from the ideal)", c.knobs.name, c.point.time, c.point.error)
}

/// How much more or less, in words.
fn against(c: &Choice, other: &Choice) -> String {
    let (time, error) = (c.point.time / other.point.time, c.point.error / other.point.error);
    format!("{time:.2} times the time and {error:.2} times the error of {}", other.knobs.name)
}

/// The conclusion about a family, if it was drawn.
fn family(outcomes: &[Outcome], which: Family, words: &str) -> Option<String> {
    let of_family = |o: &&Outcome| o.subject.family == which && o.subject.depth != Depth::Short;
    let members: Vec<&Outcome> = outcomes.iter().filter(of_family).collect();
    let choices = choices(&members);
    let points: Vec<Point> = choices.iter().map(|c| c.point).collect();
    let (best, fast, near) = (bargain(&points)?, fastest(&points)?, nearest(&points)?);
    let usual = &choices[0];
    let mut text = format!("For {words} choose {}: the best bargain", priced(&choices[best]));
    if best != 0 {
        text.push_str(&format!(", {}", against(&choices[best], usual)));
    }
    text.push('.');
    if near != best {
        let c = &choices[near];
        text.push_str(&format!(
            " Where time does not matter, {} comes nearest: {}.",
            priced(c),
            against(c, &choices[best])
        ));
    }
    if fast != best {
        let c = &choices[fast];
        text.push_str(&format!(" Where only time matters, {}: {}.", priced(c), against(c, &choices[best])));
    }
    let beaten: Vec<&str> =
        choices.iter().zip(front(&points)).filter(|(_, on)| !on).map(|(c, _)| c.knobs.name).collect();
    if !beaten.is_empty() {
        text.push_str(&format!(
            " Never worth it here, something else being both faster and nearer: {}.",
            beaten.join("; ")
        ));
    }
    let worst = members.iter().map(|o| o.rows[0].spec.max).fold(0.0, f64::max);
    let largest = members.iter().map(|o| o.rows[0].square.rmse).fold(0.0, f64::max);
    text.push_str(&format!(
        " Exactness is not the question: the default is within {worst:.2} LSB of the specification, while sampling alone \
         is {largest:.1} LSB rms away from the ideal in the worst scene.",
    ));
    Some(text)
}

/// All conclusions: the words for the family and the paragraph.
pub fn conclusions(outcomes: &[Outcome]) -> Vec<(&'static str, String)> {
    FAMILIES.iter().filter_map(|(which, words)| Some((*words, family(outcomes, *which, words)?))).collect()
}
