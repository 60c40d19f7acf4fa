//! The C interface and the plugin's boundary: the committed Rust view of their headers, the structs against LIGGGHTS's, and C
//! programs that use the interface.
mod creators;
mod layout;
mod programs;

use crate::built::source;
use std::fs;
use std::path::Path;

/// A header whose structs cross between C or C++ and Rust, and what bindgen made of them.
struct Crossing {
    header: &'static str,
    bindings: &'static str,
    /// Types that only pointers lead to, as a pattern.
    opaque: &'static str,
    /// Whether Rust's compiler checks sizes and offsets again. Those of the plugin are LIGGGHTS's, on one kind of machine;
    /// the C library is for all.
    asserted: bool,
}

const LIBRARY: Crossing = Crossing {
    header: "ffi/capi/include/granlaw.h",
    bindings: "ffi/capi/src/abi.rs",
    opaque: "granlaw_chain",
    asserted: false,
};

const PLUGIN: Crossing = Crossing {
    header: "ffi/liggghts/cpp/boundary.h",
    bindings: "ffi/liggghts/src/boundary.rs",
    opaque: "granlaw_(batch|recorder|probe|shadow)",
    asserted: true,
};

impl Crossing {
    /// What bindgen makes of a header in the place of ours.
    fn made(&self, header: &Path) -> String {
        let mut builder = bindgen::builder()
            .header(header.to_str().unwrap())
            .clang_arg(format!("-I{}", source().join("ffi/capi/include").display()))
            .blocklist_function(".*")
            .blocklist_type(self.opaque)
            .prepend_enum_name(false)
            .default_enum_style(bindgen::EnumVariation::Consts)
            .disable_header_comment()
            .layout_tests(self.asserted)
            .merge_extern_blocks(true);
        builder = match self.header.ends_with("granlaw.h") {
            true => builder.allowlist_item("(granlaw|GRANLAW)_.*"),
            // What granlaw.h has is in the bindings of granlaw.h.
            false => builder
                .allowlist_file(".*boundary\\.h")
                .blocklist_file(".*granlaw\\.h")
                .raw_line("use granlaw_capi::abi::*;"),
        };
        builder.generate().expect("libclang reads the header; install libclang-dev").to_string()
    }

    /// Whether the committed bindings are those of a header in the place of ours.
    fn fits(&self, header: &Path) -> bool {
        self.made(header) == fs::read_to_string(source().join(self.bindings)).unwrap_or_default()
    }
}

#[test]
fn the_committed_bindings_are_those_of_the_header() {
    for crossing in [LIBRARY, PLUGIN] {
        let header = source().join(crossing.header);
        if std::env::var_os("GRANLAW_BLESS").is_some() {
            fs::write(source().join(crossing.bindings), crossing.made(&header)).unwrap();
        }
        let (bindings, header_name) = (crossing.bindings, crossing.header);
        assert!(
            crossing.fits(&header),
            "{bindings} is not what bindgen makes of {header_name}; run this test with GRANLAW_BLESS=1"
        );
    }
}

/// One field changes places in every struct of the plugin's boundary.
#[test]
fn bindings_of_another_boundary_are_seen() {
    let text = fs::read_to_string(source().join(PLUGIN.header)).unwrap();
    let dir = tempfile::tempdir().unwrap();
    let header = dir.path().join("boundary.h");
    let changes = [
        ("double skin, dt;", "double dt, skin;"),
        ("uint64_t passes, contacts,", "uint64_t contacts, passes,"),
        ("int32_t kind, index;", "int32_t index, kind;"),
        ("int32_t rank, ranks;", "int32_t ranks, rank;"),
        ("*radius, *mass, *x,", "*mass, *radius, *x,"),
        ("*before, *after;", "*after, *before;"),
        ("const char *bytes;\n  size_t length;", "size_t length;\n  const char *bytes;"),
    ];
    assert_eq!(
        changes.len(),
        text.matches("\ntypedef struct granlaw_").count() - 4,
        "a struct without a planted fault"
    );
    for (from, to) in changes {
        assert!(text.contains(from), "boundary.h has no {from:?} to change");
        fs::write(&header, text.replace(from, to)).unwrap();
        assert!(!PLUGIN.fits(&header), "{from} was changed to {to}, and the bindings fit");
    }
    fs::write(&header, &text).unwrap();
    assert!(PLUGIN.fits(&header), "a copy of the header is another");
}

/// Whether a file has a struct that crosses, and no header that both sides read.
fn by_hand(extension: &str, text: &str) -> bool {
    let begins = |word: &str| text.lines().any(|l| l.trim_start().starts_with(word));
    match extension {
        "rs" => begins("#[repr(C"),
        "cpp" | "hpp" => begins("struct granlaw_") || begins("extern \"C\""),
        _ => false,
    }
}

#[test]
fn no_struct_that_crosses_is_written_by_hand() {
    let made = [LIBRARY, PLUGIN].map(|c| source().join(c.bindings));
    let (mut open, mut seen) = (vec![source().join("ffi")], 0);
    while let Some(folder) = open.pop() {
        for path in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
            if path.is_dir() {
                open.push(path);
            } else if let Some(extension) = path.extension().filter(|_| !made.contains(&path)) {
                let text = fs::read_to_string(&path).unwrap();
                assert!(
                    !by_hand(extension.to_str().unwrap(), &text),
                    "{}: boundary.h is the place",
                    path.display()
                );
                seen += 1;
            }
        }
    }
    assert!(seen > 30, "only {seen} files were looked at");
    for (extension, text) in
        [("rs", "#[repr(C)]\nstruct A;"), ("hpp", "  extern \"C\" {\n"), ("cpp", "struct granlaw_a {")]
    {
        assert!(by_hand(extension, text), "{text}");
    }
}
