//! Size and offset of every field of the structs that mirror LIGGGHTS's, by bindgen from both headers.
use crate::built::{here, source};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

const THEIRS: &str = "/usr/include/liggghts/contact_interface.h";
const MIRRORS: [(&str, &str); 3] = [
    ("SurfacesCloseData", "granlaw_surfaces_close_data"),
    ("SurfacesIntersectData", "granlaw_surfaces_intersect_data"),
    ("ForceData", "granlaw_force_data"),
];

/// Field (or `size`) to bytes, for every mirrored struct under our name.
type Layout = BTreeMap<(&'static str, String), usize>;

fn layout(header: &Path, arguments: &[&str], theirs: bool) -> Layout {
    let made = bindgen::builder()
        .header(header.to_str().unwrap())
        .clang_args(arguments)
        .allowlist_type(".*(granlaw_.*_data|SurfacesCloseData|SurfacesIntersectData|ForceData)")
        .opaque_type("std::.*")
        .generate()
        .expect("libclang reads the header; install libclang-dev")
        .to_string();
    // bindgen writes `["Offset of field: A::b"][offset_of!(A, b) - 8usize]`, and `["Size of A"][size_of::<A>() - 40usize]`.
    let facts = made.split("[\"").skip(1).filter_map(|part| {
        let (name, rest) = part.split_once("\"]")?;
        let number = rest.split_once(" - ")?.1.split_once("usize")?.0.parse().ok()?;
        let (on, field) = match name.strip_prefix("Offset of field: ") {
            Some(path) => path.rsplit_once("::")?,
            None => (name.strip_prefix("Size of ")?, "size"),
        };
        let on = on.rsplit("LIGGGHTS_ContactModels_").next()?;
        let ours = MIRRORS.iter().find(|(t, o)| if theirs { *t == on } else { *o == on })?.1;
        // LIGGGHTS's struct extends the other one, which bindgen does not count among its fields.
        (field != "close" || number != 0).then(|| ((ours, field.to_string()), number))
    });
    facts.collect()
}

fn ours(header: &Path) -> Layout {
    layout(header, &[], false)
}

fn theirs(defined: &[&str]) -> Layout {
    let arguments = [&["-x", "c++", "-std=c++17"], defined].concat();
    layout(Path::new(THEIRS), &arguments, true)
}

/// granlaw.h with a line changed.
fn planted(from: &str, to: &str) -> Layout {
    let text = fs::read_to_string(header()).unwrap();
    assert!(text.contains(from), "granlaw.h has no {from:?} to change");
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("granlaw.h");
    fs::write(&path, text.replace(from, to)).unwrap();
    ours(&path)
}

/// The fields that are not at the same place in both, or have no counterpart.
fn moved(ours: &Layout, theirs: &Layout) -> Vec<String> {
    let all = ours.keys().chain(theirs.keys().filter(|k| !ours.contains_key(k)));
    all.filter(|k| ours.get(k) != theirs.get(k)).map(|(on, field)| format!("{on}.{field}")).collect()
}

fn header() -> PathBuf {
    source().join("ffi/capi/include/granlaw.h")
}

fn installed(test: &str) -> bool {
    here(test, Path::new(THEIRS).exists(), "no contact_interface.h; install libliggghts-dev")
}

#[test]
fn the_contact_structs_lie_on_those_of_the_installed_liggghts() {
    if installed("the_contact_structs_lie_on_those_of_the_installed_liggghts") {
        let (ours, theirs) = (ours(&header()), theirs(&[]));
        assert_eq!(ours.len(), 3 + 23 + 23 + 2, "not every field was seen: {ours:#?}");
        assert_eq!(moved(&ours, &theirs), [""; 0]);
    }
}

#[test]
fn a_moved_field_is_seen() {
    if !installed("a_moved_field_is_seen") {
        return;
    }
    let theirs = theirs(&[]);
    for (from, to, seen) in [
        ("double kt, kn;", "double kn, kt;", "granlaw_surfaces_intersect_data.kn"),
        ("bool is_wall;", "int is_wall;", "granlaw_surfaces_close_data.has_force_update"),
        ("double P_diss; ", "", "granlaw_surfaces_intersect_data.P_diss"),
        ("double delta_F[3]; ", "double delta_F[4]; ", "granlaw_force_data.size"),
    ] {
        let moved = moved(&planted(from, to), &theirs);
        assert!(moved.iter().any(|m| m == seen), "{from} was changed to {to}, seen: {moved:?}");
    }
}

/// A LIGGGHTS built for superquadrics has other structs; running on it would corrupt memory.
#[test]
fn a_superquadric_build_is_seen() {
    if installed("a_superquadric_build_is_seen") {
        let other = theirs(&["-DSUPERQUADRIC_ACTIVE_FLAG", "-DNONSPHERICAL_ACTIVE_FLAG"]);
        let moved = moved(&ours(&header()), &other);
        assert!(moved.iter().any(|m| m == "granlaw_surfaces_close_data.computeflag"), "{moved:?}");
    }
}
