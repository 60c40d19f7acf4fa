//! Studies of LIGGGHTS itself: the settings raise its order, and it does what the maps say.
use crate::built::{built, here};
use granlaw::critical::rayleigh;
use granlaw_tools::codes::liggghts::{Liggghts, Plugin};
use granlaw_tools::study::collision::Collision;
use granlaw_tools::study::in_liggghts::{Bench, Who};
use granlaw_tools::study::speed::{cases, Method, Truth};
use granlaw_tools::study::stability::{ask, choose, field, onset, Class, Place, Row, Scene};
use std::time::Duration;

/// LIGGGHTS and the plugin of this source, or a skip that is seen.
fn bench(test: &str) -> Option<Bench> {
    let host = match Liggghts::find() {
        Ok(host) => host,
        Err(e) => {
            here(test, false, &e.to_string());
            return None;
        }
    };
    let plugin = Plugin::open(&built().join("libgranlaw_liggghts.so"));
    let Ok(plugin) = plugin else {
        here(test, false, "the plugin was built without LIGGGHTS's headers");
        return None;
    };
    Some(Bench { host, plugin, limit: Duration::from_secs(120) })
}

/// The order of LIGGGHTS in the step, from two steps that are eight times apart.
fn order(bench: &Bench, name: &str, who: Who, coarse: f64) -> f64 {
    let case = cases().into_iter().find(|c| c.name == name).expect("a case");
    let truth = Truth::of(&case);
    let method = if who == Who::Own { Method::PluginTimed } else { Method::Stock };
    let matter = method.matter(&case);
    let before: Vec<f64> = (0..64).map(|k| (f64::from(k) + 0.5) / 64.0).collect();
    let error = |n: f64| {
        let n = n + 0.37;
        let run = (truth.outcome.duration / n, (3.0 * n) as u64);
        let all = bench.collide(&matter, &[case.collision], who, run, &before).unwrap();
        all.iter().map(|o| (case.measure.of(o) - truth.value).abs()).sum::<f64>() / 64.0
    };
    (error(coarse) / error(8.0 * coarse)).log2() / 3.0
}

#[test]
fn the_settings_raise_the_order_of_liggghts_for_pairs_and_walls() {
    let Some(bench) = bench("the_settings_raise_the_order_of_liggghts_for_pairs_and_walls") else { return };
    for (name, stock, timed, coarse) in [
        ("damped-0.9", 1.0, 2.0, 400.0),
        ("damped-0.5", 1.0, 2.0, 100.0),
        ("damped-0.5-wall", 1.0, 2.0, 100.0),
        ("hertz-0.5", 1.0, 2.0, 200.0),
        ("undamped", 2.0, 4.0, 12.0),
        ("stick-slip-td-off", 1.0, 2.0, 100.0),
    ] {
        for (who, claimed) in [(Who::Stock, stock), (Who::Own, timed)] {
            let got = order(&bench, name, who, coarse);
            assert!((got - claimed).abs() <= 0.2, "{name}, {who:?}: order {got} where {claimed} is claimed");
        }
    }
}

#[test]
fn liggghts_does_what_the_maps_say() {
    let Some(bench) = bench("liggghts_does_what_the_maps_say") else { return };
    let (phases, mut creates, mut calm) = (16, 0, 0);
    for name in ["k2max", "rest-tangential", "cdt-jkr-limit", "bond-ku", "bond-chain", "bond-rest"] {
        let field = &field(name).expect("a field");
        let row = field.rows.len() / 2;
        let mut borders = vec![None; field.rows.len()];
        borders[row] = onset(field, &field.rows[row], phases);
        for place in choose(field, &borders, 1, phases) {
            let asked = ask(&bench, field, place, phases).unwrap();
            assert_eq!(asked.theirs, asked.ours, "{}: {asked:?}", field.name);
            creates += usize::from(asked.theirs.creates());
            calm += usize::from(asked.theirs < Class::Creates);
        }
    }
    assert!(creates >= 6 && calm >= 6, "both sides of a border: {creates} {calm}");
}

/// Kinetic energy grows 75-fold at a fifth of the Rayleigh time, of which `fix check/timestep/gran` says nothing.
#[test]
fn energy_grows_75_fold_while_the_check_of_liggghts_is_silent() {
    let Some(bench) = bench("energy_grows_75_fold_while_the_check_of_liggghts_is_silent") else { return };
    let field = field("k2max").expect("a field");
    let matter = field.rows[0].matter.clone().with("coefficientMaxElasticStiffness", 100.0);
    let collision = Collision { speed: 2.0, ..field.rows[0].collisions[0] };
    let row = Row::new(100.0, matter, vec![collision], Scene::Impact);
    let dt = 0.2 * rayleigh(collision.radius, collision.density, 5e6, 0.45);
    assert!(dt <= row.warns * (1.0 + 1e-12), "the check is silent");
    let before = row.before(32);
    let steps = row.length(dt);
    let theirs = bench.collide(&row.matter, &row.collisions, Who::Stock, (dt, steps), &before).unwrap();
    let (ours, theirs) = (row.at(dt / row.unit(), 32).energy, row.judge(&theirs, 32).energy);
    assert!((70.0..80.0).contains(&theirs), "{theirs}");
    approx::assert_relative_eq!(ours, theirs, max_relative = 1e-6);
    // A tenth of that step is fine.
    assert!(row.at(0.1 * dt / row.unit(), 32).energy < 1.0);
}

/// Planted: LIGGGHTS asked about another stiffness than the map's does not agree.
#[test]
fn another_law_in_liggghts_is_seen() {
    let Some(bench) = bench("another_law_in_liggghts_is_seen") else { return };
    let mut field = field("k2max").expect("a field");
    let row = field.rows.len() / 2;
    let place = Place { row, step: 0.55 };
    let ours = field.rows[row].class(0.55, &field.rows[row].at(0.55, 16));
    assert!(ours.creates());
    let (unit, before) = (field.rows[row].unit(), field.rows[row].before(16));
    let matter = field.rows[row].matter.clone().with("coefficientMaxElasticStiffness", 1.5);
    field.rows[row].matter = matter;
    let r = &field.rows[row];
    let run = (place.step * unit, r.length(place.step * unit));
    let outcomes = bench.collide(&r.matter, &r.collisions, Who::Stock, run, &before).unwrap();
    assert_ne!(r.class(place.step, &r.judge(&outcomes, 16)), ours);
}
