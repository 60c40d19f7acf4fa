//! The AVX-512 code on an emulated processor: no machine that tests need have a real one.
use crate::built::{built, has, here, must, said, source};
use crate::common::live;
use std::process::Command;

#[test]
fn avx512_code_answers_as_liggghts_does() {
    let test = "avx512_code_answers_as_liggghts_does";
    let found = ["bochs", "xorriso", "cpio", "busybox", "apt-get"].into_iter().all(has);
    if !live(test) || !here(test, found, "no bochs, or nothing to make a disk for it; see scripts/setup.sh") {
        return;
    }
    let mut script = Command::new(source().join("scripts/avx512.sh"));
    script.arg("--quick").env("CARGO_TARGET_DIR", built().parent().expect("a folder"));
    let said = said(&must(&mut script));
    for verdict in
        ["bits", "granlaw_lanes", "equal spheres", "four lanes are not taken", "another restitution"]
    {
        assert!(said.contains(&format!("ok      {verdict}")), "{verdict} is not in\n{said}");
    }
}
