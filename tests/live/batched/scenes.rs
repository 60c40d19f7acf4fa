//! Rigid bodies and frozen particles, whose masses count in ways of their own, on one rank and on two.
use crate::built::{must, source};
use crate::common::{deck, live, Scratch};
use std::path::Path;

/// A deck by LIGGGHTS alone and on the batched path.
#[track_caller]
fn same(name: &str, ranks: usize, changes: &[(&str, &str)]) {
    let s = Scratch::new();
    s.file("deck.in", &deck(name, changes));
    let np = ranks.to_string();
    let mut command = s.command(Path::new("mpirun"));
    command.args(["--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np", &np]);
    must(command.args(["liggghts", "-in", "deck.in"]));
    let stock = s.read("dump.txt");
    assert!(stock.lines().count() > 100, "{name}: nothing was dumped");
    std::fs::remove_file(s.path("dump.txt")).unwrap();
    let args = ["run", "--laws", "rust", "--path", "batched", "--np", &np, "--", "-in", "deck.in"];
    s.granlaw(&args).ends(0, &["granlaw: batched path, "]);
    assert!(stock == s.read("dump.txt"), "{name} on {ranks} ranks: the dumps differ");
    // With the stock laws beside it, call by call, with the masses of the bodies.
    let shadow = ["run", "--shadow", "--np", &np, "--", "-in", "deck.in"];
    s.granlaw(&shadow).ends(0, &["calls compared, batched, ", "worst difference 0, allowed 0"]);
}

#[test]
fn rigid_bodies() {
    if live("rigid_bodies") {
        same("multisphere.in", 1, &[]);
        same(
            "multisphere.in",
            2,
            &[("run             6000", "run             1000"), ("custom 500", "custom 100")],
        );
    }
}

#[test]
fn frozen_particles() {
    if live("frozen_particles") {
        same("frozen_partner.in", 1, &[]);
        // A floor of frozen spheres, under a gas that falls on it.
        let freeze = "region low block 0 0.1 0 0.1 0 0.02\ngroup low region low\nvelocity low set 0 0 0\nfix f low freeze\ntimestep";
        let changes = [
            ("timestep", freeze),
            ("run             4000", "run             700"),
            ("custom 1000", "custom 100"),
        ];
        same("gas_two_ranks.in", 2, &changes);
    }
}

#[test]
fn steps_count_where_the_first_rank_has_no_particles() {
    if live("steps_count_where_the_first_rank_has_no_particles") {
        let s = Scratch::new();
        for file in ["tiny.in", "material.inc", "measure.inc"] {
            std::fs::copy(source().join("benchmarks").join(file), s.path(file)).unwrap();
        }
        let args = [
            "run", "--laws", "rust", "--path", "batched", "--np", "2", "--", "-in", "tiny.in", "-var",
            "steps", "50",
        ];
        s.granlaw(&args).ends(0, &["batched path ends: 51 steps, 51 contacts, 1 neighbours"]);
    }
}
