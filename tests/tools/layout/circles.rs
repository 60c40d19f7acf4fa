//! Which file needs which, and the circles among them.
use super::sources::{Modules, Place};
use std::collections::{BTreeMap, BTreeSet};

/// Each node with those that it needs.
pub type Arrows = BTreeMap<String, BTreeSet<String>>;

/// The arrows between the files of a crate.
pub fn arrows(modules: &Modules) -> Arrows {
    let needs = |place: &Place| {
        let module = &modules[place];
        let named = module.paths.iter().filter_map(|p| home(p, modules, 0));
        // Of a module that is imported whole, that which is named in the code.
        let globs = module.globs.iter().filter(|g| modules.contains_key(*g));
        let whole =
            globs.flat_map(|g| module.code.iter().map(|w| g.iter().chain([w]).cloned().collect::<Place>()));
        let whole = whole.filter(|p| exported(p, modules)).filter_map(|p| home(&p, modules, 0));
        named.chain(whole).filter(|to| to != place).map(|to| modules[&to].file.clone()).collect()
    };
    modules.iter().map(|(place, module)| (module.file.clone(), needs(place))).collect()
}

/// The module that has what a path ends in, through those that only hand it on; nothing for a path that ends in a module.
fn home(path: &Place, modules: &Modules, turns: usize) -> Option<Place> {
    for (i, name) in path.iter().enumerate() {
        let (at, next) = (path[..i].to_vec(), path[..=i].to_vec());
        if modules.contains_key(&next) {
            continue;
        }
        return match modules.get(&at)?.imports.get(name) {
            Some(onward) if turns < 20 => {
                home(&onward.iter().chain(&path[i + 1..]).cloned().collect(), modules, turns + 1)
            }
            _ => Some(at),
        };
    }
    None
}

/// Whether the module of a path has its last name: handed on, or declared.
fn exported(path: &Place, modules: &Modules) -> bool {
    let Some((name, at)) = path.split_last() else { return false };
    let module = &modules[at];
    let declares = |w: &[String]| {
        matches!(w[0].as_str(), "struct" | "enum" | "trait" | "fn" | "type" | "const" | "static")
            && w[1] == *name
    };
    module.imports.contains_key(name) || module.code.windows(2).any(declares)
}

/// The same without the arrows from a file to the front of a room that it stands in: `mod.rs`, `lib.rs`.
pub fn without_fronts(arrows: &Arrows) -> Arrows {
    let stands_in = |file: &str, front: &str| match front.strip_suffix("mod.rs") {
        Some(room) => file.starts_with(room),
        None => front == "lib.rs" || front == "main.rs",
    };
    let inner = |file: &String, to: &BTreeSet<String>| {
        (file.clone(), to.iter().filter(|front| !stands_in(file, front)).cloned().collect())
    };
    arrows.iter().map(|(file, to)| inner(file, to)).collect()
}

/// All circles: the groups of nodes of which each leads to every other.
pub fn circles(arrows: &Arrows) -> Vec<Vec<String>> {
    let ahead: BTreeMap<&str, BTreeSet<&str>> =
        arrows.keys().map(|n| (n.as_str(), reached(n, arrows))).collect();
    let mut found = BTreeSet::new();
    for (node, all) in ahead.iter().filter(|(node, all)| all.contains(*node)) {
        let back = |n: &&&str| ahead.get(**n).is_some_and(|a| a.contains(node));
        found.insert(all.iter().filter(back).map(|n| (*n).to_owned()).collect::<Vec<_>>());
    }
    found.into_iter().collect()
}

fn reached<'a>(from: &str, arrows: &'a Arrows) -> BTreeSet<&'a str> {
    let mut seen = BTreeSet::new();
    let mut open = vec![from];
    while let Some(node) = open.pop() {
        for next in arrows.get(node).into_iter().flatten() {
            if seen.insert(next.as_str()) {
                open.push(next);
            }
        }
    }
    seen
}

/// A circle in words: its arrows, one a line.
pub fn told(circle: &[String], arrows: &Arrows) -> String {
    let mut told = Vec::new();
    for from in circle {
        told.extend(
            arrows[from].iter().filter(|to| circle.contains(to)).map(|to| format!("  {from} -> {to}")),
        );
    }
    told.join("\n")
}
