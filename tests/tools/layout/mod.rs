//! How the sources lie: no circles of files or rooms, one style of modules, no long files.
//!
//! An arrow leads from a file to each file of its crate that declares a name which it uses. If a `mod.rs` or `lib.rs` only
//! exports that name again, the arrow leads on to the file that declares it, so a front without code of its own is in no circle.
mod circles;
mod imports;
mod planted;
mod sources;
mod words;

use circles::{arrows, circles, told, without_fronts, Arrows};
use sources::{files, modules};
use std::path::{Path, PathBuf};

/// Crates in which the front of a room (`mod.rs`, `lib.rs`) may declare what the files of the room use, such as a trait or an interface,
/// and use those files itself.
const FRONTS_LEAD: [&str; 3] = ["src/core", "ffi/capi/src", "ffi/lanes/src"];

/// Arrows that may close a circle: crate, from, to, and the reason.
const ALLOWED: &[[&str; 4]] = &[];

/// The rooms of the tools from bottom to top; those of one floor do not use each other.
const FLOORS: &[&[&str]] = &[
    &["report", "spelling", "trace"],
    &["compare", "deck", "probe", "shadow"],
    &["codes", "replay"],
    &["advise", "bench", "study", "verify"],
];

/// The most lines of a file.
const LONGEST: usize = 400;
/// Files that may be longer, and the reason.
const LONGER: &[[&str; 2]] = &[];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The source folders of all crates, as paths below the root.
fn crates() -> Vec<String> {
    let manifest: toml::Table = std::fs::read_to_string(root().join("Cargo.toml")).unwrap().parse().unwrap();
    let members = manifest["workspace"]["members"].as_array().unwrap().iter().map(|m| m.as_str().unwrap());
    let source =
        |m: &str| if root().join(m).join("src").is_dir() { format!("{m}/src") } else { m.to_string() };
    members.map(source).chain(["src/cli".into()]).collect()
}

fn read(source: &str) -> Arrows {
    arrows(&modules(&files(&root().join(source), &["rs"])))
}

#[test]
fn no_circles_of_files() {
    let mut wrong = String::new();
    for source in crates() {
        let mut arrows = read(&source);
        if FRONTS_LEAD.contains(&source.as_str()) {
            arrows = without_fronts(&arrows);
        }
        for [_, from, to, why] in ALLOWED.iter().filter(|a| a[0] == source) {
            let closes =
                circles(&arrows).iter().any(|c| [from, to].iter().all(|f| c.iter().any(|n| n == *f)));
            if !closes || !arrows.get_mut(*from).is_some_and(|all| all.remove(*to)) {
                wrong += &format!(
                    "{source}: {from} -> {to} closes no circle any more; it need not be allowed ({why})\n"
                );
            }
        }
        for circle in circles(&arrows) {
            wrong += &format!(
                "{source}: these files form a circle; move what they share into one of its own\n{}\n",
                told(&circle, &arrows)
            );
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

/// The arrows between the rooms of a crate, by the arrows between its files.
fn rooms(files: &Arrows) -> Arrows {
    let room = |file: &str| file.split('/').next().unwrap().trim_end_matches(".rs").to_string();
    let mut rooms = Arrows::new();
    for (file, needs) in files.iter().filter(|(file, _)| *file != "lib.rs") {
        let of = room(file);
        rooms.entry(of.clone()).or_default().extend(needs.iter().map(|n| room(n)).filter(|n| *n != of));
    }
    rooms
}

/// What does not keep to the floors.
fn misplaced(rooms: &Arrows, floors: &[&[&str]]) -> Vec<String> {
    let floor = |room: &str| floors.iter().position(|f| f.contains(&room));
    let mut wrong = Vec::new();
    for (room, needs) in rooms {
        let Some(at) = floor(room) else {
            wrong.push(format!("{room} has no floor; give it one"));
            continue;
        };
        let above = needs.iter().filter(|n| floor(n).is_some_and(|f| f >= at));
        wrong.extend(above.map(|n| format!("{room} uses {n}, which does not stand below it")));
    }
    wrong
}

#[test]
fn rooms_use_only_what_stands_below() {
    assert_eq!(misplaced(&rooms(&read("src/tools")), FLOORS), Vec::<String>::new());
    let core = rooms(&read("src/core"));
    assert!(
        circles(&core).is_empty(),
        "\n{}",
        circles(&core).iter().map(|c| told(c, &core)).collect::<String>()
    );
}

#[test]
fn a_room_that_uses_one_above_or_beside_it_is_told() {
    let file = |name: &str, text: &str| (name.to_string(), text.to_string());
    let files = [
        file("lib.rs", "pub mod low; pub mod beside; pub mod high; pub mod strange;"),
        file("low/mod.rs", "mod inside;"),
        file("low/inside.rs", "use crate::high::H; use crate::beside;\nfn f() { beside::g() }"),
        file("beside.rs", "pub fn g() {}"),
        file("high.rs", "use crate::beside::g;"),
        file("strange.rs", ""),
    ];
    let wrong = misplaced(&rooms(&arrows(&modules(&files))), &[&["low", "beside"], &["high"]]);
    let told = ["low uses beside, which does", "low uses high, which does", "strange has no floor"];
    assert_eq!(wrong.len(), told.len(), "{wrong:?}");
    assert!(wrong.iter().zip(told).all(|(w, t)| w.starts_with(t)), "{wrong:?}");
}

/// Modules with children whose own file lies beside their folder instead of in it.
fn beside(files: &[String]) -> Vec<&String> {
    let children = |f: &&String| {
        f.strip_suffix(".rs").is_some_and(|f| files.iter().any(|g| g.starts_with(&format!("{f}/"))))
    };
    files.iter().filter(children).collect()
}

#[test]
fn modules_with_children_lie_in_their_folder() {
    for source in crates() {
        let names: Vec<_> = files(&root().join(&source), &["rs"]).into_iter().map(|(name, _)| name).collect();
        assert!(
            beside(&names).is_empty(),
            "{source}: {:?} should be mod.rs in the folder of that name",
            beside(&names)
        );
    }
    let planted = ["lib.rs", "a.rs", "a/b.rs", "c/mod.rs", "c/d.rs"].map(String::from);
    assert_eq!(beside(&planted), ["a.rs"]);
}

/// Files that are too long, or may be longer and are not.
fn long(files: &[(String, String)], longer: &[[&str; 2]]) -> Vec<String> {
    let excused = |name: &str| longer.iter().any(|[l, _]| *l == name);
    let too = |(name, text): &(String, String)| (text.lines().count() > LONGEST) != excused(name);
    let mut wrong: Vec<_> = files.iter().filter(|f| too(f)).map(|(name, _)| name.clone()).collect();
    wrong.extend(
        longer.iter().filter(|[l, _]| files.iter().all(|(name, _)| name != l)).map(|[l, _]| l.to_string()),
    );
    wrong
}

#[test]
fn no_file_is_long() {
    let of = |folder: &'static str| {
        let all = files(&root().join(folder), &["rs", "cpp", "hpp", "h"]);
        all.into_iter().map(move |(name, text)| (format!("{folder}/{name}"), text))
    };
    let all: Vec<_> = ["src", "ffi", "tests"].into_iter().flat_map(of).collect();
    assert!(all.len() > 200, "{} files", all.len());
    assert_eq!(
        long(&all, LONGER),
        Vec::<String>::new(),
        "more than {LONGEST} lines, or excused without need"
    );
    let planted =
        [("a", 400), ("b", 401), ("c", 401), ("d", 3)].map(|(name, n)| (name.to_string(), "x\n".repeat(n)));
    assert_eq!(long(&planted, &[["c", ""], ["d", ""], ["e", ""]]), ["b", "d", "e"]);
}

/// Which header includes which.
fn includes(files: &[(String, String)]) -> Arrows {
    let base = |path: &str| PathBuf::from(path).file_name().unwrap().to_string_lossy().into_owned();
    let included = |text: &str| {
        text.lines()
            .filter_map(|l| l.trim().strip_prefix("#include \"")?.split('"').next())
            .map(base)
            .collect()
    };
    files.iter().map(|(name, text)| (base(name), included(text))).collect()
}

#[test]
fn headers_include_each_other_in_no_circle() {
    let all = files(&root().join("ffi"), &["hpp", "h", "cpp"]);
    let arrows = includes(&all);
    assert!(arrows.values().map(|to| to.len()).sum::<usize>() > 10, "{arrows:?}");
    assert_eq!(circles(&arrows), Vec::<Vec<String>>::new());
    let planted = [("x/a.hpp", "#include \"b.hpp\""), ("y/b.hpp", "#include <v>\n#include \"x/a.hpp\"")];
    let planted = planted.map(|(name, text)| (name.to_string(), text.to_string()));
    assert_eq!(circles(&includes(&planted)), [["a.hpp", "b.hpp"]]);
}
