//! The variables of the environment: those that granlaw reads, and what of the user's reaches a code.
//!
//! They are listed here and nowhere else. A run whose outcome counts gets an environment that is made here name by name, so
//! that nothing else of the user's can change a verdict; `granlaw run` is the user's own run and gets all of his.
use std::collections::BTreeMap;
use std::ffi::OsString;

/// Who reads a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reader {
    /// The plugin, inside LIGGGHTS.
    Plugin,
    /// The command line.
    CommandLine,
    /// The tests of this source.
    Tests,
}

/// A variable that granlaw reads.
#[derive(Clone, Copy, Debug)]
pub struct Variable {
    /// Its name.
    pub name: &'static str,
    /// Who reads it.
    pub reader: Reader,
    /// Values that belong together, and what they do.
    pub values: &'static [(&'static [&'static str], &'static str)],
}

const fn plugin(name: &'static str, values: &'static [(&'static [&'static str], &'static str)]) -> Variable {
    Variable { name, reader: Reader::Plugin, values }
}

/// All variables that granlaw reads.
pub const VARIABLES: &[Variable] = &[
    plugin(
        "GRANLAW_LAWS",
        &[
            (&["own"], "only the `/rs` names are ours (default, unless calls are recorded, probed or shadowed)"),
            (&["rust"], "the Rust laws stand behind LIGGGHTS's names too: an existing deck runs on them unchanged, restart files cross both ways"),
            (&["stock"], "as `own`, with LIGGGHTS's laws in our chain, where they can be recorded, probed and shadowed (default when they are)"),
        ],
    ),
    plugin(
        "GRANLAW_RECORD",
        &[(&["trace.csv"], "write traces: the pair style to `trace.csv`, a wall fix to `trace.wall-ID.csv`, on ranks `trace.rank0.csv` …")],
    ),
    plugin("GRANLAW_EVERY", &[(&["n"], "record only every n-th step")]),
    plugin(
        "GRANLAW_PATH",
        &[(&["batched", "contact"], "how the pair style goes through the contacts of a step, see below; `granlaw run --path` sets it")],
    ),
    plugin(
        "GRANLAW_LANES",
        &[(&["1", "4", "8", "widest"], "how many contacts go side by side; without it as many as the processor has registers for (`widest`), and one among eight particles or fewer; `granlaw verify` has `--lanes`")],
    ),
    plugin(
        "GRANLAW_PROBE",
        &[(&["scene.json"], "count what the contacts do, of all chains and ranks, into one file; a pair style or wall none of whose laws has a Rust twin is named and not counted; a deck without any other ends with 2")],
    ),
    plugin("GRANLAW_SHADOW", &[(&["on", "off"], "hold the Rust laws against LIGGGHTS's own in every call")]),
    plugin(
        "GRANLAW_TOLERANCE",
        &[(&["1e-12"], "the largest difference that a shadow allows; without it none")],
    ),
    plugin(
        "GRANLAW_FOLLOW",
        &[(&["all"], "a probe follows all contacts of a chain, up to 4096 at a time, in place of a sample, at several times the cost; `granlaw advise` does")],
    ),
    plugin("GRANLAW_STEPS", &[(&["n"], "end a probed run in order after n steps")]),
    plugin(
        "GRANLAW_TIMESTEP",
        &[(&["warn"], "say once for each pair of types when the time step is too long for a contact, with the figures; `granlaw run --warn-timestep`. Of many contacts a sample is looked at, and all go one by one; of bonds, those that the particles of a step can have, before any has begun")],
    ),
    plugin("GRANLAW_DECK", &[(&["name"], "what traces and probes call the deck; `granlaw` sets it")]),
    Variable {
        name: "GRANLAW_PLUGIN",
        reader: Reader::CommandLine,
        values: &[(&["path"], "which plugin `granlaw` preloads; else the one beside the executable, else `../lib/granlaw`")],
    },
    Variable {
        name: "GRANLAW_REQUIRE_LIGGGHTS",
        reader: Reader::Tests,
        values: &[(&["1"], "those that need LIGGGHTS fail where it is missing, in place of being skipped")],
    },
    Variable {
        name: "GRANLAW_BLESS",
        reader: Reader::Tests,
        values: &[(&["1"], "those of generated files write them anew")],
    },
];

/// What of the user's environment is passed on to a run whose outcome counts, and why. A name that ends in `*` stands for all
/// that begin so.
pub const PASSED_ON: &[(&str, &str)] = &[
    ("PATH", "where LIGGGHTS, `mpirun` and what a deck calls with `shell` are found"),
    ("HOME", "where MPI and Python keep what the user has set and installed"),
    ("LD_LIBRARY_PATH", "without it a LIGGGHTS of the user's own may not find its libraries"),
    ("TMPDIR", "where the folders of runs are made; a run itself is given one inside its folder"),
    ("OMPI_MCA_*", "how Open MPI is to work on this machine; on several ranks only"),
    ("PMIX_MCA_*", "the same"),
];

/// What every run whose outcome counts is given in place of the user's, and why.
pub const FIXED: &[(&str, &str, &str)] = &[
    ("LC_ALL", "C", "numbers have a point and messages are in English"),
    ("OMP_NUM_THREADS", "1", "a rank is one thread, in each code that is timed or compared"),
];

/// A rank that is alone talks to nobody. Open MPI then need not look for networks nor start a daemon, which makes it
/// start three times as fast and leaves nothing running when it is stopped; elsewhere these variables mean nothing.
const ALONE: [(&str, &str); 3] =
    [("OMPI_MCA_ess_singleton_isolated", "1"), ("OMPI_MCA_pml", "ob1"), ("OMPI_MCA_btl", "self")];

/// The environment of a run whose outcome counts, on so many ranks, from that of this process.
pub fn isolated(
    ours: impl IntoIterator<Item = (OsString, OsString)>,
    ranks: usize,
) -> BTreeMap<OsString, OsString> {
    let of_mpi = |name: &str| name.contains("_MCA_");
    let passed = |name: &str| PASSED_ON.iter().any(|(p, _)| is(p, name)) && (ranks > 1 || !of_mpi(name));
    let mut all: BTreeMap<_, _> =
        ours.into_iter().filter(|(name, _)| name.to_str().is_some_and(passed)).collect();
    all.extend(FIXED.iter().map(|(name, value, _)| (name.into(), value.into())));
    if ranks == 1 {
        all.extend(ALONE.map(|(name, value)| (name.into(), value.into())));
    }
    all
}

fn is(pattern: &str, name: &str) -> bool {
    pattern.strip_suffix('*').map_or(pattern == name, |begin| name.starts_with(begin))
}

/// The variables that granlaw reads as a table in Markdown.
pub fn variables_markdown() -> String {
    let mut out = "| environment | |\n|---|---|\n".to_string();
    for v in VARIABLES {
        let whose = if v.reader == Reader::Tests { "for the tests: " } else { "" };
        for (values, does) in v.values {
            let more: String = values[1..].iter().map(|value| format!(", `{value}`")).collect();
            out += &format!("| `{}={}`{more} | {whose}{does} |\n", v.name, values[0]);
        }
    }
    out
}

/// What runs whose outcome counts have of the environment, as a table in Markdown.
pub fn passed_on_markdown() -> String {
    let mut out = "| environment of a run | |\n|---|---|\n".to_string();
    PASSED_ON.iter().for_each(|(name, why)| out += &format!("| `{name}` of the user | {why} |\n"));
    FIXED.iter().for_each(|(name, value, why)| out += &format!("| `{name}={value}` | {why} |\n"));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn isolated_from(ours: &[(&str, &str)], ranks: usize) -> BTreeMap<String, String> {
        let ours = ours.iter().map(|(n, v)| (OsString::from(n), OsString::from(v)));
        let text = |s: OsString| s.into_string().unwrap();
        isolated(ours, ranks).into_iter().map(|(n, v)| (text(n), text(v))).collect()
    }

    #[test]
    fn what_is_not_named_does_not_get_through() {
        let nothing = isolated_from(&[], 1);
        for name in VARIABLES.iter().map(|v| v.name).chain([
            "LD_PRELOAD",
            "LAMMPS_POTENTIALS",
            "LC_NUMERIC",
            "LANG",
            "OMPI_COMM_WORLD_RANK",
            "OMP_SCHEDULE",
            "PATHS",
            "PYTHONPATH",
        ]) {
            for ranks in [1, 2] {
                assert!(!isolated_from(&[(name, "x")], ranks).contains_key(name), "{name}");
            }
            assert_eq!(isolated_from(&[(name, "x")], 1), nothing);
        }
    }

    #[test]
    fn what_is_named_gets_through_as_it_is() {
        let names = ["PATH", "HOME", "LD_LIBRARY_PATH", "TMPDIR", "OMPI_MCA_x", "PMIX_MCA_x"];
        let two = isolated_from(&names.map(|n| (n, "x")), 2);
        assert!(names.iter().all(|n| two.get(*n).is_some_and(|v| v == "x")), "{two:?}");
        // A single rank is told how to be alone, and nothing else of MPI.
        let one = isolated_from(&[("PATH", "x"), ("OMPI_MCA_x", "x"), ("OMPI_MCA_pml", "cm")], 1);
        assert_eq!((one.get("PATH").unwrap().as_str(), one.get("OMPI_MCA_x")), ("x", None));
        assert_eq!(one.get("OMPI_MCA_pml").unwrap(), "ob1");
    }

    #[test]
    fn what_is_fixed_is_not_the_users() {
        let found = isolated_from(&[("LC_ALL", "de_DE.UTF-8"), ("OMP_NUM_THREADS", "7")], 1);
        assert_eq!((found["LC_ALL"].as_str(), found["OMP_NUM_THREADS"].as_str()), ("C", "1"));
    }
}
