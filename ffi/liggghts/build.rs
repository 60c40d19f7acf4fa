//! Compiles the C++ half against LIGGGHTS's headers. Without them the crate still builds, as a plugin that says so.
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

const KINDS: [&str; 5] = ["surface", "normal", "tangential", "cohesion", "rolling"];

fn main() {
    println!("cargo:rerun-if-changed=cpp");
    println!("cargo:rerun-if-changed=../capi/include");
    println!("cargo:rerun-if-env-changed=LIGGGHTS_INCLUDE");
    println!("cargo:rustc-check-cfg=cfg(liggghts)");
    let headers = PathBuf::from(env::var("LIGGGHTS_INCLUDE").unwrap_or("/usr/include/liggghts".into()));
    // A path that is missing makes cargo look again at the next build, so headers installed later are found.
    for path in [&headers.join("contact_interface.h"), Path::new("/usr/bin/mpicxx")] {
        println!("cargo:rerun-if-changed={}", path.display());
    }
    match (headers.join("contact_interface.h").exists(), mpi_flags()) {
        (true, Some(mpi)) => compile(&headers, &mpi),
        (false, _) => skip("LIGGGHTS's headers are missing: install libliggghts-dev or set LIGGGHTS_INCLUDE"),
        (true, None) => skip("mpicxx is missing: install libopenmpi-dev"),
    }
}

fn skip(why: &str) {
    println!("cargo:warning=the LIGGGHTS plugin is built without LIGGGHTS ({why})");
}

fn mpi_flags() -> Option<Vec<String>> {
    let out = Command::new("mpicxx").arg("--showme:compile").output().ok()?;
    let text = String::from_utf8(out.stdout).ok()?;
    out.status.success().then(|| text.split_whitespace().map(String::from).collect())
}

fn compile(headers: &Path, mpi: &[String]) {
    println!("cargo:rustc-cfg=liggghts");
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    for kind in KINDS {
        fs::write(out.join(format!("style_{kind}_model.h")), style_list(headers, kind))
            .expect("OUT_DIR is writable");
    }
    fs::write(out.join("style_contact_model.h"), "").expect("OUT_DIR is writable");
    let mut build = cc::Build::new();
    build
        .cpp(true)
        .std("c++17")
        .opt_level(2)
        .force_frame_pointer(false)
        .warnings(false)
        .define("OMPI_SKIP_MPICXX", None);
    build.include(&out).include("cpp").include("../capi/include").file("cpp/plugin.cpp");
    for flag in mpi {
        build.flag(flag);
    }
    // System headers: LIGGGHTS's own warnings are not ours.
    build.flag("-isystem").flag(headers.to_str().expect("a UTF-8 path"));
    build.flag("-Wall").flag("-Wextra").flag("-fvisibility=hidden").flag("-ffp-contract=off");
    build.link_lib_modifier("+whole-archive").compile("granlaw_plugin");
    println!("cargo:rustc-link-lib=dylib=liggghts");
}

/// The list of models that LIGGGHTS's own build makes, which Debian does not install.
fn style_list(headers: &Path, kind: &str) -> String {
    let begins = format!("{kind}_model_");
    let mut names: Vec<_> = fs::read_dir(headers)
        .expect("the header directory is readable")
        .filter_map(|e| e.ok()?.file_name().into_string().ok())
        .filter(|n| n.starts_with(&begins) && n.ends_with(".h"))
        .collect();
    names.sort();
    names.iter().map(|n| format!("#include \"{n}\"\n")).collect()
}
