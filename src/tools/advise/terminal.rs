//! Advice as text for a terminal.
use super::check::Check;
use super::fresh::Fresh;
use super::ladder::Candidate;
use super::lines::{number, percent};
use super::{Advice, Found, Term};
use std::fmt::{self, Write};

/// Terms whose shares are all smaller than this are not printed; the JSON has them.
const SMALL: f64 = 0.005;

/// The advice and the results of its checks.
pub fn text(found: &Found) -> String {
    let mut t = String::new();
    let mut all = || -> fmt::Result {
        tell(&mut t, &found.advice)?;
        found.check.iter().try_for_each(|c| checked(&mut t, c))?;
        found.fresh.iter().try_for_each(|f| tried_again(&mut t, f, found.advice.options.time))
    };
    all().expect("a String takes everything");
    t
}

fn checked(t: &mut String, c: &Check) -> fmt::Result {
    writeln!(t, "\nThe whole scene, deck against advised deck; {} allowed{}", percent(c.bound), runs(c))?;
    for o in &c.observables {
        let sign = if o.within(c.bound) { " " } else { "x" };
        let scatter = o.scatter.map_or(String::new(), |s| format!("({} by chance)", percent(s)));
        writeln!(t, "{sign} {:<20} {:>8} {scatter:<22} {}", o.name, percent(o.difference), o.meaning)?;
    }
    if c.runs == 1 && !c.holds() {
        writeln!(t, "  one run of each cannot tell what the advice does from chance; --seeds 8 can")?;
    }
    let predicted = c.predicted.map_or(String::new(), |p| format!("; {} predicted", percent(p)));
    let [deck, advised] = c.seconds;
    writeln!(t, "  time {deck:.2} s and {advised:.2} s: {} of it{predicted}", percent(c.measured()))
}

/// The number of runs in words, if there were several.
pub(super) fn runs(c: &Check) -> String {
    if c.runs > 1 {
        format!("; means of {} runs each", c.runs)
    } else {
        String::new()
    }
}

fn tried_again(t: &mut String, f: &Fresh, time: f64) -> fmt::Result {
    writeln!(t, "\nFresh contacts of a run with {}\n  {}", f.run, tallied(f))?;
    for c in f.classes.iter().filter(|c| !c.within) {
        let (what, size) = c.errors.worst(time);
        writeln!(t, "x {what} wrong by {} in {}", percent(size), c.name)?;
    }
    Ok(())
}

/// How many fresh classes are within the accuracy.
pub(super) fn tallied(f: &Fresh) -> String {
    let [(i, impacts), (l, loads)] = [true, false].map(|k| f.tally(k));
    format!(
        "within the accuracy are {i} of {impacts} classes of impacts and {l} of {loads} of lasting contacts"
    )
}

/// A number to three digits.
pub(super) fn digits(x: f64) -> String {
    let short: f64 = format!("{x:.2e}").parse().unwrap_or(x);
    super::lines::number(short)
}

fn tell(t: &mut String, a: &Advice) -> fmt::Result {
    writeln!(t, "{}: what each term contributes", a.deck)?;
    terms(t, &a.terms)?;
    let o = &a.options;
    writeln!(
        t,
        "\nModels, held to {} of the deck's own in very small steps{}",
        percent(o.accuracy),
        time(o.time)
    )?;
    ladder(t, a)?;
    writeln!(t, "\nWhy")?;
    a.reasons.iter().try_for_each(|r| writeln!(t, "  {r}"))?;
    writeln!(t, "\nAdvice")?;
    match a.chosen.map(|k| &a.ladder[k]) {
        None => writeln!(
            t,
            "  none: no model that was tried is within the accuracy; ask for less, or try a smaller step"
        ),
        Some(_) if a.lines.is_empty() => writeln!(t, "  keep the deck as it is"),
        Some(r) => {
            writeln!(t, "  {}: {}", r.name(), gain(r))?;
            a.lines.iter().try_for_each(|l| writeln!(t, "  {}\n      {}", l.text, l.place))
        }
    }
}

fn time(many: f64) -> String {
    if many == 1.0 {
        String::new()
    } else {
        format!(" (contact times to {many} times that)")
    }
}

/// What a candidate is predicted to gain.
pub(super) fn gain(r: &Candidate) -> String {
    r.predicted.map_or(String::new(), |p| format!("predicted to take {} of the time", percent(p)))
}

fn terms(t: &mut String, terms: &[Term]) -> fmt::Result {
    writeln!(t, "  {:<6} {:<34} {:>11} {:>9} {:>9}", "", "", "dissipates", "momentum", "torque")?;
    let mut few: Vec<Term> = Vec::new();
    for t in terms {
        // All walls are shown together.
        let who = if t.who == "pair" { "pair" } else { "walls" };
        match few.iter_mut().find(|f| f.who == who && f.term == t.term) {
            Some(f) => {
                f.dissipated += t.dissipated;
                f.impulse += t.impulse;
                f.turn += t.turn;
            }
            None => few.push(Term { who: who.into(), ..t.clone() }),
        }
    }
    few.sort_by(|a, b| b.dissipated.total_cmp(&a.dissipated));
    let large = |t: &&Term| t.dissipated.abs().max(t.impulse).max(t.turn) >= SMALL;
    for x in few.iter().filter(large) {
        let [d, i, r] =
            [x.dissipated, x.impulse, x.turn].map(|s| if s == 0.0 { "-".into() } else { percent(s) });
        writeln!(t, "  {:<6} {:<34} {d:>11} {i:>9} {r:>9}", x.who, x.term)?;
    }
    Ok(())
}

fn ladder(t: &mut String, a: &Advice) -> fmt::Result {
    writeln!(
        t,
        "  {:<44} {:>9} {:<18} {:>10} {:>9} {:>9}",
        "", "error", "of", "step [s]", "law [ns]", "time"
    )?;
    for (k, r) in a.ladder.iter().enumerate() {
        let (what, error) =
            r.model.worst.map_or(("", String::new()), |(what, size, _)| (what, percent(size)));
        let step = r.step.map_or("none".into(), number);
        let cost = if r.cost.is_finite() { format!("{:.0}", r.cost) } else { "-".into() };
        let predicted = r.predicted.map_or("-".into(), percent);
        let sign = if a.chosen == Some(k) {
            "*"
        } else if r.holds {
            " "
        } else {
            "x"
        };
        writeln!(t, "{sign} {:<44} {error:>9} {what:<18} {step:>10} {cost:>9} {predicted:>9}", r.name())?;
    }
    writeln!(t, "  * advised, x not good enough; time of a run relative to the deck as it is, from the cost of the laws measured here")
}
