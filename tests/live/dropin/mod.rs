//! The drop-in headers: put into a source tree, compiled, run, and compared with Debian's LIGGGHTS byte for byte.
//! `scripts/dropin_check.sh` does the same with a whole LIGGGHTS built from Debian's source, which takes minutes.

use crate::built::{alone, built, has, here, must, said, source};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;
use tempfile::TempDir;

const HEADERS: &str = "/usr/include/liggghts";
const KINDS: [&str; 5] = ["surface", "normal", "tangential", "cohesion", "rolling"];

fn can(test: &str) -> bool {
    let found = has("liggghts") && has("mpicxx") && Path::new(HEADERS).exists();
    here(test, found, "no liggghts, libliggghts-dev or libopenmpi-dev; install them")
}

/// A tree with LIGGGHTS's headers, the sources of its makefiles' hook, and a model that someone else dropped in.
fn tree() -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    let src = dir.path().join("src");
    fs::create_dir(&src).unwrap();
    for header in fs::read_dir(HEADERS).unwrap().map(|e| e.unwrap()) {
        fs::copy(header.path(), src.join(header.file_name())).unwrap();
    }
    fs::write(src.join("Makefile.package.empty"), "PKG_LIB =   \n").unwrap();
    dir
}

fn dropin(tree: &Path) -> Command {
    let mut command = Command::new(source().join("scripts/dropin.sh"));
    command.arg(tree).arg("--from").arg(built());
    command
}

/// The lists that LIGGGHTS's `Make.sh` makes of every model header that lies there.
fn list_models(src: &Path, whitelist: &str) {
    for kind in KINDS {
        let begins = format!("{kind}_model_");
        let mut names: Vec<_> = fs::read_dir(src)
            .unwrap()
            .map(|e| e.unwrap().file_name().into_string().unwrap())
            .filter(|n| n.starts_with(&begins) && n.ends_with(".h") && n != &format!("{begins}base.h"))
            .collect();
        names.sort();
        let list: String = names.iter().map(|n| format!("#include \"{n}\"\n")).collect();
        fs::write(src.join(format!("style_{kind}_model.h")), list).unwrap();
    }
    fs::write(src.join("style_contact_model.h"), whitelist).unwrap();
}

fn mpi(ask: &str) -> Vec<String> {
    let out = must(Command::new("mpicxx").arg(format!("--showme:{ask}")));
    String::from_utf8(out.stdout).unwrap().split_whitespace().map(String::from).collect()
}

/// The compiler on a program of `tests/live/dropin` in such a tree.
fn cxx(src: &Path, program: &str) -> Command {
    let mut cxx = Command::new("c++");
    cxx.args(["-std=gnu++17", "-O2", "-w", "-fvisibility=hidden", "-DOMPI_SKIP_MPICXX", "-I"]).arg(src);
    cxx.args(mpi("compile")).arg(source().join("tests/live/dropin").join(program));
    cxx
}

/// Debian's LIGGGHTS with the drop-in models. The whole chain is on the whitelist and so compiled as one; any other
/// runs through LIGGGHTS's general class.
fn host() -> &'static Path {
    static HOST: LazyLock<PathBuf> = LazyLock::new(|| {
        let tree = tree();
        must(&mut dropin(tree.path()));
        compile(&tree.path().join("src"))
    });
    &HOST
}

fn compile(src: &Path) -> PathBuf {
    let whole =
        "NORMAL_HOOKE_HYSTERESIS_RS, TANGENTIAL_HISTORY_RS, COHESION_OFF, ROLLING_CDT_RS, SURFACE_DEFAULT";
    list_models(src, &format!("GRAN_MODEL({whole})\n"));
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("liggghts-rs");
    let mut cxx = cxx(src, "host.cpp");
    cxx.arg(src.join("granlaw/libgranlaw.a"))
        .arg("-lliggghts")
        .args(mpi("link"))
        .arg("-ldl")
        .arg("-o")
        .arg(&out);
    must(&mut cxx);
    out
}

/// A deck with `/rs` behind the names of its laws.
fn own_names(deck: &str) -> String {
    let mut changed = 0;
    let mut before = "";
    let mut out = String::new();
    for word in deck.split_inclusive([' ', '\n']) {
        let bare = word.trim_end();
        let selects = ["model", "tangential", "rolling_friction", "cohesion"].contains(&before);
        if selects && granlaw::laws::LAWS.iter().any(|e| e.meta.keyword == bare) {
            out.push_str(&word.replacen(bare, &format!("{bare}/rs"), 1));
            changed += 1;
        } else {
            out.push_str(word);
        }
        if !bare.is_empty() {
            before = bare;
        }
    }
    assert!(changed > 0, "no law of ours in the deck");
    out
}

fn run(program: &Path, deck: &str, preload: &str) -> String {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("deck.in"), deck).unwrap();
    fs::copy(source().join("liggghts_inputs/plane.stl"), dir.path().join("plane.stl")).unwrap();
    let out =
        alone(program, dir.path()).args(["-in", "deck.in"]).env("LD_PRELOAD", preload).output().unwrap();
    assert!(out.status.success(), "{}", said(&out));
    fs::read_to_string(dir.path().join("dump.txt")).expect("the deck writes dump.txt")
}

fn deck(name: &str) -> String {
    fs::read_to_string(source().join(format!("liggghts_inputs/{name}.in"))).unwrap()
}

#[test]
fn a_deck_on_the_drop_in_models_gives_the_answer_of_stock() {
    if !can("a_deck_on_the_drop_in_models_gives_the_answer_of_stock") {
        return;
    }
    let decks = [
        "hysteresis_history_cdt",
        "two_types",
        "mesh_wall",
        "hertz_history",
        "hooke_no_history_cdt",
        "frozen_partner",
    ];
    for name in decks {
        let stock = run(Path::new("liggghts"), &deck(name), "");
        let ours = run(host(), &own_names(&deck(name)), "");
        assert!(stock.lines().count() > 100 && stock == ours, "{name}: the dumps differ");
    }
    // A property a millionth off must be seen, or the comparison sees nothing.
    let good = own_names(&deck("two_types"));
    let planted = good.replace("youngsModulus peratomtype 5e6", "youngsModulus peratomtype 5.000005e6");
    assert_ne!(planted, good, "the deck has no modulus to change");
    assert!(run(host(), &planted, "") != run(host(), &good, ""), "a softer sphere was not seen");
}

/// Laws that LIGGGHTS lacks, against the plugin.
#[test]
fn laws_of_our_own_are_the_same_in_either_place() {
    if !can("laws_of_our_own_are_the_same_in_either_place") {
        return;
    }
    let plugin = built().join("libgranlaw_liggghts.so");
    for name in ["cdt_jkr_bonded", "cdt_jkr_types", "cdt_jkr_mesh_wall"] {
        let deck = own_names(&deck(name));
        let there = run(Path::new("liggghts"), &deck, plugin.to_str().unwrap());
        let here = run(host(), &deck, "");
        assert!(there.lines().count() > 100 && there == here, "{name}: the dumps differ");
    }
}

#[test]
fn both_layouts_of_the_contact_structs_give_the_same() {
    if !can("both_layouts_of_the_contact_structs_give_the_same") {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("mirror");
    let shapes = ["-DSUPERQUADRIC_ACTIVE_FLAG", "-DNONSPHERICAL_ACTIVE_FLAG"];
    let print = |defined: &[&str]| {
        let mut cxx = cxx(Path::new(HEADERS), "mirror.cpp");
        cxx.args(defined).args(["-I", "ffi/liggghts/cpp", "-I", "ffi/capi/include"]).current_dir(source());
        cxx.arg(built().join("libgranlaw.a")).args(["-lm", "-ldl", "-o"]).arg(&out);
        must(&mut cxx);
        said(&must(&mut Command::new(&out)))
    };
    let (spheres, all) = (print(&[]), print(&shapes));
    assert!(spheres.lines().filter(|l| l.split(' ').any(|n| n.len() > 10)).count() >= 2, "{spheres}");
    assert_eq!(spheres, all);

    // All model headers compile into such a LIGGGHTS as well.
    let tree = tree();
    must(&mut dropin(tree.path()));
    list_models(&tree.path().join("src"), "");
    must(cxx(&tree.path().join("src"), "host.cpp").args(shapes).arg("-fsyntax-only"));
}

/// Every file below a folder with its text.
fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut all = Vec::new();
    for path in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
        if path.is_dir() {
            all.extend(contents(&path));
        } else {
            all.push((path.clone(), fs::read(&path).unwrap()));
        }
    }
    all.sort();
    all
}

#[test]
fn what_is_dropped_in_can_be_taken_out() {
    let dir = tempfile::tempdir().unwrap();
    let src = dir.path().join("src");
    fs::create_dir(&src).unwrap();
    fs::write(src.join("contact_models.h"), "").unwrap();
    fs::write(src.join("normal_model_theirs_rs.h"), "NORMAL_MODEL(THEIRS,theirs/rs,20)\n").unwrap();
    fs::write(src.join("Makefile.package"), "PKG_LIB =   -lpoems\n").unwrap();
    let before = contents(&src);

    must(&mut dropin(dir.path()));
    let once = contents(&src);
    let models = once.iter().filter(|(p, _)| p.to_str().unwrap().ends_with("_rs.h")).count();
    assert_eq!(models, granlaw::laws::LAWS.len() + 1);
    let package = fs::read_to_string(src.join("Makefile.package")).unwrap();
    assert!(package.contains("-lpoems") && package.contains("+= ../granlaw/libgranlaw.a"), "{package}");
    // A law that an older granlaw had is not left behind, and a second run changes nothing.
    let old = fs::read_to_string(src.join("normal_model_hooke_rs.h")).unwrap();
    fs::write(src.join("normal_model_old_rs.h"), old.replace("hooke/rs", "old/rs")).unwrap();
    must(&mut dropin(dir.path()));
    assert!(contents(&src) == once);
    must(dropin(dir.path()).arg("--remove"));
    assert!(contents(&src) == before);
}

#[test]
fn a_wrong_tree_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let out = dropin(dir.path()).output().unwrap();
    assert_eq!(out.status.code(), Some(2));
    assert!(said(&out).contains("is no source tree of LIGGGHTS"), "{}", said(&out));
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}

/// A drop-in model refuses as the plugin does, in LIGGGHTS's voice.
#[test]
fn refusals_reach_the_user() {
    if !can("refusals_reach_the_user") {
        return;
    }
    let deck = own_names(&deck("cdt_jkr_twist_upstream"));
    for (from, to, said_so) in [
        ("upstream", "updream", "setting cdtJkrConvention updream: must be one of documented, upstream"),
        ("cdtJkrConvention upstream", "", "setting cdtJkrConvention must be given"),
        ("peratomtype 0.45", "peratomtype 0.75", "poissonsRatio"),
    ] {
        assert!(deck.contains(from), "the deck has no {from:?} to change");
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("deck.in"), deck.replace(from, to)).unwrap();
        let out = alone(host(), dir.path()).args(["-in", "deck.in"]).output().unwrap();
        assert_eq!(out.status.code(), Some(1), "{}", said(&out));
        assert!(said(&out).contains("ERROR") && said(&out).contains(said_so), "{}", said(&out));
    }
}
