//! Many `run` commands in one deck: laws are prepared at each of them, with what the deck says by then.
use super::deck::{can, Deck, Ran};
use crate::built::must;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const CHAIN: &str = "model hooke/hysteresis/rs tangential history/rs rolling_friction cdt/rs";
const STOCK: &str = "model hooke/hysteresis tangential history rolling_friction cdt";

/// A deck that changes a property between two runs.
fn changed_midway(chain: &str) -> Deck {
    let later = "coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9";
    Deck::new(chain, chain)
        .with("run             200", &format!("run 100\nfix p3 all property/global {later}\nrun 100"))
}

#[test]
fn each_run_reads_the_properties_again() {
    if !can("each_run_reads_the_properties_again") {
        return;
    }
    let (ours, stock) = (changed_midway(CHAIN).runs(), changed_midway(STOCK).runs_on_stock());
    assert!(ours.dump == stock.dump, "the dumps differ");
    let unchanged = Deck::new(STOCK, STOCK).with("run             200", "run 100\nrun 100").runs_on_stock();
    assert!(unchanged.dump != stock.dump, "the change of the property changed nothing");
}

const RUNS: usize = 1600;

/// That many times `run 1`, and the resident memory after the first quarter, when the allocator has settled, and at the end.
fn many_runs(chain: &str) -> Deck {
    let (look, runs) = ("shell sh memory.sh\n", |n: usize| "run 1\n".repeat(n));
    let all = format!("{}{look}{}{look}", runs(RUNS / 4), runs(RUNS - RUNS / 4));
    Deck::new(chain, chain).with("run             200", &all).file("memory.sh", MEMORY)
}

/// Writes the resident memory of the LIGGGHTS above it to a file.
const MEMORY: &str = "p=$$\n\
    until grep -q liggghts /proc/$p/comm; do p=$(awk '{print $4}' /proc/$p/stat); done\n\
    awk '/VmRSS/ {print $2}' /proc/$p/status >>memory.txt\n";

/// What the memory grew by \[kB\].
fn growth(ran: &Ran) -> i64 {
    let kb: Vec<i64> = ran.memory.lines().map(|l| l.parse().unwrap()).collect();
    assert_eq!(kb.len(), 2, "the memory was not seen");
    kb[1] - kb[0]
}

#[test]
fn preparing_again_does_not_leak() {
    if !can("preparing_again_does_not_leak") {
        return;
    }
    let (stock, ours) = (growth(&many_runs(STOCK).runs_on_stock()), growth(&many_runs(CHAIN).runs()));
    // Two chains of three laws for two types take 2.3 kB; a page or two may come and go with anything else.
    assert!(ours <= stock + 64, "{RUNS} runs took {ours} kB, on LIGGGHTS's own laws {stock} kB");

    // With chains that are never freed it is thousands.
    let dir = tempfile::tempdir().unwrap();
    let leaky = growth(&many_runs(CHAIN).runs_with(leak(dir.path()).to_str().unwrap()));
    assert!(leaky > stock + 512, "chains that are not freed took {leaky} kB and were not seen");
}

/// A library in which freeing a chain does nothing.
fn leak(dir: &Path) -> PathBuf {
    let (source, out) = (dir.join("leak.c"), dir.join("leak.so"));
    fs::write(&source, "void granlaw_free(void *chain) { (void)chain; }\n").unwrap();
    must(Command::new("cc").args(["-shared", "-fPIC", "-o"]).arg(&out).arg(&source));
    out
}
