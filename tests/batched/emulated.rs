//! The AVX-512 code on an emulated processor: no machine that tests need have a real one.
use crate::built::{built, has, here, must, said, source};
use std::process::Command;

#[test]
fn avx512_code_answers_as_liggghts_does() {
    let found = crate::live::live("avx512_code_answers_as_liggghts_does")
        && ["bochs", "xorriso", "cpio", "busybox", "apt-get"].into_iter().all(has);
    if here(
        "avx512_code_answers_as_liggghts_does",
        found,
        "no bochs, or nothing to make a disk for it; see scripts/setup.sh",
    ) {
        let mut script = Command::new(source().join("scripts/avx512.sh"));
        script.arg("--quick").env("CARGO_TARGET_DIR", built().parent().expect("a folder"));
        let said = said(&must(&mut script));
        for verdict in
            ["ok      bits", "ok      granlaw_lanes", "ok      equal spheres", "ok      another restitution"]
        {
            assert!(said.contains(verdict), "{verdict:?} is not in\n{said}");
        }
    }
}
