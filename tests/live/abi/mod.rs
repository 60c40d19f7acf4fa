//! The C interface: the committed Rust view of `granlaw.h`, its structs against LIGGGHTS's, and C programs that use it.
mod creators;
mod layout;
mod programs;

use std::path::Path;

#[test]
fn the_committed_bindings_are_those_of_the_header() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("ffi/capi");
    let made = bindgen::builder()
        .header(here.join("include/granlaw.h").to_str().unwrap())
        .allowlist_item("(granlaw|GRANLAW)_.*")
        .blocklist_function(".*")
        .blocklist_type("granlaw_chain")
        .prepend_enum_name(false)
        .default_enum_style(bindgen::EnumVariation::Consts)
        .disable_header_comment()
        .layout_tests(false)
        .merge_extern_blocks(true)
        .generate()
        .expect("libclang reads granlaw.h; install libclang-dev")
        .to_string();
    let at = here.join("src/abi.rs");
    if std::env::var_os("GRANLAW_BLESS").is_some() {
        std::fs::write(&at, &made).unwrap();
    }
    let committed = std::fs::read_to_string(&at).unwrap_or_default();
    assert!(
        made == committed,
        "src/abi.rs is not what bindgen makes of granlaw.h; run this test with GRANLAW_BLESS=1"
    );
}
