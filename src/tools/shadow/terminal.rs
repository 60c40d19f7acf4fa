//! The result of a shadowed run, in words.
use super::{Compared, Shadow, Verdict, Worst, MEASURES};
use crate::report::rough;
use std::fmt::Write;

impl Shadow {
    /// The result as text, with the verdict.
    pub fn text(&self, tolerance: f64) -> String {
        let mut t = String::new();
        let ranks = if self.ranks == 1 { "1 rank".into() } else { format!("{} ranks", self.ranks) };
        line(
            &mut t,
            &format!("granlaw shadow: LIGGGHTS's laws and the Rust laws on the same inputs, {ranks}"),
        );
        self.chains.iter().for_each(|c| c.text(&mut t));
        line(&mut t, &self.verdict_text(tolerance));
        t
    }

    fn verdict_text(&self, tolerance: f64) -> String {
        let (calls, left_out) = (self.calls(), self.left_out());
        let (error, allowed) = (rough(self.error()), rough(tolerance));
        let rest = if left_out > 0 { format!("; {left_out} calls not compared") } else { String::new() };
        match self.verdict(tolerance) {
            Verdict::Nothing => {
                format!("  NOTHING COMPARED{rest}: no contact of a chain that both sides have")
            }
            Verdict::Agreed => {
                format!("  agreed: {calls} calls compared, worst difference {error}, allowed {allowed}{rest}")
            }
            Verdict::Differs => {
                format!(
                    "  DIFFERS: {calls} calls compared, worst difference {error}, allowed {allowed}{rest}"
                )
            }
        }
    }
}

impl Compared {
    fn text(&self, t: &mut String) {
        line(t, &format!("  {}: {}", self.who, self.laws));
        if let Some(why) = &self.left_out {
            return line(t, &format!("    {} calls NOT COMPARED: {why}", self.calls));
        }
        let equal = match self.differing {
            _ if self.calls == 0 => return line(t, "    no contact"),
            0 => "all equal to the last bit".to_string(),
            n => format!("{n} differ"),
        };
        let way = match self.batched {
            0 => "one contact at a time".to_string(),
            n if n == self.calls => format!("batched, {}", self.way),
            n => format!("{n} of them batched, {}", self.way),
        };
        line(t, &format!("    {} calls compared, {way}: {equal}", self.calls));
        let found = || MEASURES.iter().zip(&self.worst).filter_map(|(m, w)| Some((m, w.as_ref()?)));
        for (measure, w) in found() {
            line(t, &format!("    {measure}: {}", w.text()));
        }
        let mut shown = Vec::new();
        for (_, w) in found().filter(|_| self.differing > 0) {
            if !shown.contains(&(w.step, w.tags)) {
                shown.push((w.step, w.tags));
                let inputs: Vec<_> = w.inputs.iter().map(|(n, v)| format!("{n}={v}")).collect();
                line(t, &format!("    inputs at step {}, {}: {}", w.step, w.who(), inputs.join(" ")));
            }
        }
    }
}

impl Worst {
    fn text(&self) -> String {
        let Worst { step, what, rust, stock, .. } = self;
        let error = rough(self.error);
        format!(
            "{error} of its scale at step {step}, {}: {what} is {rust:e} where LIGGGHTS has {stock:e}",
            self.who()
        )
    }

    fn who(&self) -> String {
        match self.tags {
            (i, j) if j < 0 => format!("particle {i} and the wall"),
            (i, j) => format!("particles {i} and {j}"),
        }
    }
}

fn line(t: &mut String, text: &str) {
    writeln!(t, "{text}").expect("a string takes everything");
}
