//! A report made by hand that holds every outcome and every awkward number.
use granlaw_tools::report::{About, Case, Check, Curve, Outcome, Parameter, Report, Shows, Tolerance, Worst};

/// Five cases: agreed, disagreed, partly skipped, failed, and one without any check.
pub fn report() -> Report {
    Report { about: about(), cases: vec![agreed(), disagreed(), partly_skipped(), failed(), empty()] }
}

fn about() -> About {
    About {
        granlaw: "0.1.0".into(),
        liggghts: Some("LIGGGHTS-PUBLIC 3.8.0, compiled 2023-01-05".into()),
        plugin: Some("target/release/libgranlaw_liggghts.so".into()),
        machine: "linux x86_64, 2 cores".into(),
        command: "granlaw verify --jobs 2 liggghts_inputs".into(),
        notes: vec!["deck big_scene.in: only every 100th step was recorded".into()],
    }
}

fn agreed() -> Case {
    Case {
        name: "head_on_plastic".into(),
        title: "Two equal spheres beyond the plastic limit, kc = 0".into(),
        deck: "liggghts_inputs/head_on_plastic.in".into(),
        laws: vec!["normal hooke/hysteresis".into(), "tangential history".into(), "rolling off".into()],
        parameters: parameters(),
        checks: vec![
            check("replay", Shows::Port, Outcome::Agreed, 1e-14, Some(worst(812, 0.0, 0.0, 0.0))),
            check("recorded", Shows::Boundary, Outcome::Agreed, 0.0, None),
            check("plugin", Shows::Boundary, Outcome::Agreed, 0.0, None),
            check(
                "two-body",
                Shows::Integrator,
                Outcome::Agreed,
                1e-9,
                Some(worst(455, 12.25, 12.250000000375, 3.06e-11)),
            ),
            check(
                "final vx of 1",
                Shows::Physics,
                Outcome::Agreed,
                1e-6,
                Some(worst(2000, -0.33603219, -0.3360322, 2.98e-8)),
            ),
        ],
        curves: curves(700),
        calls: 1_400,
        seconds: 0.61,
        log: None,
    }
}

fn disagreed() -> Case {
    let why = "3.1e-3 of the peak force at step 455, limit 1e-14";
    Case {
        name: "oblique_slip".into(),
        title: "Oblique impact, slip with spin | μ = 0.1".into(),
        deck: "liggghts_inputs/oblique_slip.in".into(),
        laws: vec!["normal hooke".into(), "tangential history".into(), "rolling cdt".into()],
        checks: vec![
            check(
                "replay",
                Shows::Port,
                Outcome::Disagreed(why.into()),
                1e-14,
                Some(worst(455, 12.28, 12.25, 3.1e-3)),
            ),
            check(
                "plugin",
                Shows::Boundary,
                Outcome::Disagreed("dump.txt differs".into()),
                0.0,
                Some(worst(456, f64::NAN, 12.25, f64::NAN)),
            ),
        ],
        curves: spoiled(),
        calls: 40_000,
        seconds: 1.9,
        ..Case::default()
    }
}

fn partly_skipped() -> Case {
    let no = || Outcome::Skipped("LIGGGHTS was not found".into());
    Case {
        name: "wall_mesh".into(),
        title: "Sphere on a mesh wall".into(),
        checks: vec![
            check(
                "replay",
                Shows::Port,
                Outcome::Agreed,
                1e-14,
                Some(worst(12, 1.0, 1.0 + f64::EPSILON, 2.2e-16)),
            ),
            check("plugin", Shows::Boundary, no(), 0.0, None),
            check("two-body", Shows::Integrator, no(), 1e-9, None),
        ],
        calls: 12,
        ..Case::default()
    }
}

fn failed() -> Case {
    let why =
        "LIGGGHTS stopped: Fix property/global: Illegal value (deck line 14: fix m1 all property/global …)";
    Case {
        name: "bad_property".into(),
        title: "Young's modulus below zero".into(),
        checks: vec![check("recorded", Shows::Boundary, Outcome::CouldNotRun(why.into()), 0.0, None)],
        log: Some(
            "LIGGGHTS (Version 3.8.0)\n\nERROR: Illegal value (../fix_property_global.cpp:120)\n\u{1b}[0m"
                .into(),
        ),
        ..Case::default()
    }
}

fn empty() -> Case {
    Case { name: "no_contact".into(), title: "Two spheres that never meet".into(), ..Case::default() }
}

/// A check with a limit and its reason.
pub fn check(name: &str, shows: Shows, outcome: Outcome, limit: f64, worst: Option<Worst>) -> Check {
    let reason = match limit {
        0.0 => "the same operations in the same order give the same bits",
        l if l < 1e-12 => "round-off of a few operations",
        _ => "velocity Verlet at dt = tc/500 errs by 1e-10, measured order 2",
    };
    Check {
        name: name.into(),
        shows,
        outcome,
        tolerance: Some(Tolerance { limit, reason: reason.into() }),
        worst,
    }
}

fn worst(step: i64, got: f64, expected: f64, error: f64) -> Worst {
    let (what, norm) = ("f_i.x of 1-2".into(), "relative to the peak force".into());
    Worst { step, what, got, expected, error, norm }
}

fn parameters() -> Vec<Parameter> {
    let p = |name: &str, symbol: &str, unit: &str, shape: &str, values: &[f64]| Parameter {
        name: name.into(),
        symbol: symbol.into(),
        unit: unit.into(),
        shape: shape.into(),
        values: values.to_vec(),
    };
    vec![
        p("youngsModulus", "E", "Pa", "per type", &[5e6, 7.25e7]),
        p("poissonsRatio", "ν", "1", "per type", &[0.45, 0.3]),
        p("coefficientMaxElasticStiffness", "k2max/kn", "1", "per type pair", &[5.0, 4.0, 4.0, 12.5]),
        p("characteristicVelocity", "vc", "m/s", "scalar", &[2.0]),
    ]
}

/// Loading along one slope, unloading along a steeper one, in all four answers.
pub fn curves(points: usize) -> Vec<Curve> {
    let time: Vec<f64> = (0..points).map(|k| k as f64 * 2e-7).collect();
    let phase = |t: f64| t / time[points - 1] * std::f64::consts::PI;
    let overlap: Vec<f64> = time.iter().map(|t| 2.5e-4 * phase(*t).sin()).collect();
    let load =
        |k: usize| if 2 * k < points { 5e4 * overlap[k] } else { (2e5 * (overlap[k] - 1.875e-4)).max(0.0) };
    let force: Vec<f64> = (0..points).map(load).collect();
    let answer = |name: &str, error: Vec<f64>| Curve {
        answer: name.into(),
        time: time.clone(),
        overlap: overlap.clone(),
        force: force.clone(),
        error,
    };
    let round_off = |k: usize| if k.is_multiple_of(3) { 0.0 } else { 1.1e-16 * (1.0 + (k % 5) as f64) };
    vec![
        answer("stock", Vec::new()),
        answer("replay", (0..points).map(round_off).collect()),
        answer("plugin", vec![0.0; points]),
        answer("two-body", (0..points).map(|k| 3e-11 * (k as f64 / points as f64).powi(2)).collect()),
    ]
}

/// Long curves, one of which blows up.
fn spoiled() -> Vec<Curve> {
    let mut curves = curves(20_000);
    curves.truncate(3);
    for k in 12_000..20_000 {
        curves[1].force[k] *= 1.2;
        curves[1].error[k] = 3.1e-3;
    }
    curves[2].force[15_000] = f64::NAN;
    curves[2].force[15_001] = f64::INFINITY;
    curves[2].error[15_000] = f64::NAN;
    curves
}
