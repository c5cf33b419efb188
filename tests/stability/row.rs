//! A row of the catalogue of stiff and extreme cases: what goes in, what has to come out, how far it may be off and how
//! the library computes it. A row becomes a test by `rows!` and a line of the page `spec-notes/stability.md`; the page's
//! figures are what the tests measure.

/// One case of the catalogue.
pub struct Row {
    /// Its number in the catalogue: a letter for the part of the pipeline and a number.
    pub name: &'static str,
    pub input: &'static str,
    pub expected: &'static str,
    /// The greatest error that passes, and what it counts.
    pub tolerance: f64,
    pub unit: &'static str,
    /// The formulation that makes it so.
    pub how: &'static str,
    pub run: fn(&mut Worst),
}

/// The worst error that a row has seen, and over how many cases.
#[derive(Default)]
pub struct Worst {
    pub error: f64,
    pub cases: u64,
    /// How many inputs were drawn at random.
    pub fuzzed: u64,
    /// What the worst case was.
    pub place: String,
}

impl Worst {
    /// One case and its error; what is no number is the worst of all.
    pub fn see(&mut self, error: f64, place: impl FnOnce() -> String) {
        self.cases += 1;
        let error = if error.is_nan() { f64::INFINITY } else { error.abs() };
        if error > self.error {
            self.error = error;
            self.place = place();
        }
    }

    /// One case that is right or wrong: an error of 0 or 1.
    pub fn holds(&mut self, right: bool, place: impl FnOnce() -> String) {
        self.see(if right { 0.0 } else { 1.0 }, place);
    }

    /// Many cases of which some are wrong.
    pub fn count(&mut self, wrong: u64, cases: u64, place: impl FnOnce() -> String) {
        self.cases += cases.saturating_sub(1);
        self.see(wrong as f64, place);
    }

    /// Two numbers that have to be equal.
    pub fn equal<T: PartialEq + std::fmt::Debug>(&mut self, got: T, want: T, what: &str) {
        self.holds(got == want, || format!("{what}: {got:?}, want {want:?}"));
    }
}

impl Row {
    /// Runs the row and prints its line of the page.
    pub fn measure(&self) -> Worst {
        let mut worst = Worst::default();
        (self.run)(&mut worst);
        println!("{}", self.line(&worst));
        worst
    }

    /// Runs the row; panics unless it saw cases and stayed within its tolerance.
    #[track_caller]
    pub fn check(&self) {
        let worst = self.measure();
        assert!(worst.cases > 0, "{} has seen nothing", self.name);
        let (name, error, unit, place) = (self.name, worst.error, self.unit, &worst.place);
        assert!(error <= self.tolerance, "{name}: {error:e} {unit}, allowed {:e}: {place}", self.tolerance);
    }

    /// What does not depend on measurements: the beginning of the line.
    pub fn beginning(&self) -> String {
        let bound = if self.tolerance == 0.0 { "exact".to_string() } else { number(self.tolerance) };
        format!("| {} | {} | {} | {} | {bound} {} |", self.name, self.input, self.expected, self.how, self.unit)
    }

    /// The whole line.
    pub fn line(&self, worst: &Worst) -> String {
        format!("{} {} | {} | {} |", self.beginning(), number(worst.error), worst.cases, worst.fuzzed)
    }
}

/// A figure with two digits.
fn number(v: f64) -> String {
    if v == v.round() && v.abs() < 1e6 || (0.01..1000.0).contains(&v) {
        let text = format!("{v:.3}");
        text.trim_end_matches('0').trim_end_matches('.').to_string()
    } else {
        format!("{v:.1e}")
    }
}

/// Rows as data and a test for each: `function: name, input, expected, tolerance, unit, formulation;`
macro_rules! rows {
    ($($run:ident: $name:literal, $input:literal, $expected:literal, $tolerance:expr, $unit:literal, $how:literal;)*) => {
        /// The rows of this part.
        pub const ROWS: &[crate::stability::row::Row] = &[$(crate::stability::row::Row {
            name: $name,
            input: $input,
            expected: $expected,
            tolerance: $tolerance,
            unit: $unit,
            how: $how,
            run: $run,
        }),*];

        mod tests {
            $(#[test]
            fn $run() {
                super::ROWS.iter().find(|row| row.name == $name).expect("its own row").check();
            })*
        }
    };
}
pub(crate) use rows;
