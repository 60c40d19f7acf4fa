//! The plots of a case.
use super::axis::Axis;
use super::escape::html as esc;
use super::plot::{Plot, Series};
use super::{Case, Curve};

type Column = fn(&Curve) -> &[f64];

/// The figures of a case, one HTML element each; none if no history was kept.
pub(super) fn figures(case: &Case) -> Vec<String> {
    if case.curves.is_empty() {
        return Vec::new();
    }
    let (time, overlap): (Column, Column) = (|c| &c.time, |c| &c.overlap);
    let force: Column = |c| &c.force;
    [
        lines("Normal force over time", &case.curves, (time, "time", "s"), (force, "force", "N")),
        lines("Overlap over time", &case.curves, (time, "time", "s"), (overlap, "overlap", "m")),
        lines("Force over overlap", &case.curves, (overlap, "overlap", "m"), (force, "force", "N")),
        errors(case),
    ]
    .iter()
    .map(figure)
    .collect()
}

fn lines<'a>(
    title: &'a str,
    curves: &'a [Curve],
    (across, x, x_unit): (Column, &str, &str),
    (up, y, y_unit): (Column, &str, &str),
) -> Plot<'a> {
    let all = |column: Column| curves.iter().flat_map(column).copied();
    let margin = if x == "time" { 0.0 } else { 0.04 };
    Plot {
        title,
        x: Axis::linear(all(across), x, x_unit, margin),
        y: Axis::linear(all(up), y, y_unit, 0.06),
        series: curves.iter().map(|c| series(c, across(c), up(c))).collect(),
        dots: false,
        limits: Vec::new(),
    }
}

fn errors(case: &Case) -> Plot<'_> {
    let with: Vec<&Curve> = case.curves.iter().filter(|c| !c.error.is_empty()).collect();
    // A limit of zero cannot be drawn on a logarithmic axis; errors of zero have a place of their own there.
    let limit = |c: &&Curve| {
        let check = case.checks.iter().find(|check| check.name == c.answer)?;
        let limit = check.tolerance.as_ref()?.limit;
        (limit > 0.0).then_some((check.name.as_str(), limit))
    };
    let limits: Vec<_> = with.iter().filter_map(limit).collect();
    let values = with.iter().flat_map(|c| c.error.iter().copied()).chain(limits.iter().map(|l| l.1));
    Plot {
        title: "Error against stock",
        x: Axis::linear(case.curves.iter().flat_map(|c| c.time.iter().copied()), "time", "s", 0.0),
        y: Axis::log(values, "error / peak force [1]"),
        series: with.iter().map(|c| series(c, &c.time, &c.error)).collect(),
        dots: true,
        limits,
    }
}

fn series<'a>(curve: &'a Curve, x: &[f64], y: &[f64]) -> Series<'a> {
    Series { answer: &curve.answer, points: x.iter().copied().zip(y.iter().copied()).collect() }
}

fn figure(plot: &Plot) -> String {
    let (title, missing) = (esc(plot.title), esc(&plot.missing()));
    format!("<figure><figcaption>{title} <small>{missing}</small></figcaption>{}</figure>\n", plot.svg())
}
