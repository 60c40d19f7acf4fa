//! What is the same for every code, with a script in the place of LAMMPS.
use super::lammps::Lammps;
use super::{run, Code, Folder, Ran, Run, RunError, CODES};
use crate::deck::Deck;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::time::Duration;

/// A script that answers as LAMMPS does and then does as it is told.
fn lammps(dir: &Path, does: &str) -> Lammps {
    let path = dir.join("lmp");
    let help = "Large-scale Atomic/Molecular Massively Parallel Simulator - 1 Jan 2030";
    fs::write(&path, format!("#!/bin/sh\nif [ \"$1\" = -h ]; then echo '{help}'; exit; fi\n{does}\n"))
        .unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    // Another test that starts a process at this moment may hold the file open for it.
    let mut tries = std::iter::repeat_with(|| Lammps::find(Some(&path)));
    tries.find(|found| !matches!(found, Err(e) if e.to_string().contains("busy"))).unwrap().unwrap()
}

const LONG: Duration = Duration::from_secs(60);

/// What comes of a deck with a file beside it.
fn attempt(does: &str, limit: Duration) -> Result<(Folder, Ran), RunError> {
    let dir = tempfile::tempdir().unwrap();
    let code = lammps(dir.path(), does);
    let scene = dir.path().join("scene");
    fs::create_dir(&scene).unwrap();
    fs::write(scene.join("bed.lammps"), "units si\ninclude more.lmp\nrun 10\n").unwrap();
    fs::write(scene.join("more.lmp"), "atom_style sphere\n").unwrap();
    let mut deck = Deck::read(&scene.join("bed.lammps")).unwrap();
    deck.variables = vec![("cells".into(), "4".into())];
    let folder = Folder::new(&deck)?;
    let environment = vec![("EXTRA", "1".to_string())];
    let ran = run(&code, &Run { deck: &deck, environment, limit }, &folder);
    assert_eq!(fs::read_dir(&scene).unwrap().count(), 2, "nothing is left in the user's folder");
    Ok((folder, ran?))
}

#[test]
fn every_code_says_what_it_is_or_how_to_get_it() {
    for (word, find) in CODES {
        match find(None) {
            Ok(code) => {
                assert!(code.name().to_lowercase() == *word && !code.version().is_empty(), "{code:?}")
            }
            Err(e) => assert!(e.to_string().contains("is not in PATH; "), "{word}: {e}"),
        }
        let absent = find(Some(Path::new("no/where"))).unwrap_err().to_string();
        assert!(absent.contains("no/where"), "{word}: {absent}");
    }
}

#[test]
fn a_run_has_its_own_folder_and_environment() {
    let times = "Loop time of 2 on 1 procs for 10 steps with 5 atoms\nPair | 1 | 1.5 | 2 | 0.0 | 75";
    let dump = "ITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id x\n1 0.5\n";
    let (folder, ran) = attempt(
        &format!(
            "cat $2 more.lmp > both.txt; env > env.txt; echo \"$*\" >> env.txt\n\
         echo '{times}' > log.lammps; printf '{dump}' > b.dump; echo 'WARNING: so so'"
        ),
        LONG,
    )
    .unwrap();
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    assert_eq!(read("both.txt"), "units si\ninclude more.lmp\nrun 10\natom_style sphere\n");
    let env = read("env.txt");
    for line in ["EXTRA=1", "LC_ALL=C", "OMP_NUM_THREADS=1", "-in bed.lammps -var cells 4"] {
        assert!(env.lines().any(|l| l == line), "{line}: {env}");
    }
    // Cargo tells a test much, and a code nothing; the shell of the script adds the last four.
    let known = ["PATH", "HOME", "LD_LIBRARY_PATH", "PWD", "OLDPWD", "SHLVL", "_"];
    for name in env.lines().filter_map(|l| Some(l.split_once('=')?.0)) {
        let ours = ["EXTRA", "TMPDIR", "LC_ALL", "OMP_NUM_THREADS"].contains(&name);
        assert!(ours || name.starts_with("OMPI_MCA_") || known.contains(&name), "{name}: {env}");
    }
    assert!(env.contains(&format!("TMPDIR={}", folder.around().display())));
    let [t] = ran.times[..] else { panic!("{ran:?}") };
    assert_eq!((t.pair, t.whole, t.steps, t.particles), (1.5, 2.0, 10, 5));
    assert_eq!((ran.warnings, ran.log), (vec!["WARNING: so so".to_string()], format!("{times}\n")));
    assert_eq!((&ran.dumps[..], &ran.traces[..]), (&["b.dump".into()][..], &[][..]));
    assert_eq!(folder.frames(&ran.dumps[0]).unwrap()[0].value(1, "x").unwrap(), 0.5);
}

#[test]
fn a_failure_is_told_in_the_codes_own_words() {
    let failure = |does: &str| attempt(does, LONG).unwrap_err().to_string();
    let said =
        failure("echo units si > log.lammps; echo 'ERROR: Unknown pair style (src/force.cpp:1)'; exit 1");
    assert!(
        said.ends_with("bed.lammps:1: `units si`: ERROR: Unknown pair style (src/force.cpp:1)"),
        "{said}"
    );
    let said = failure("exit 3");
    assert!(said.ends_with("bed.lammps: LAMMPS ended with status 3 and gave no reason"), "{said}");
    let said = failure("kill -9 $$");
    assert!(said.ends_with("LAMMPS was ended by signal 9 and gave no reason"), "{said}");
    let said = attempt("sleep 60", Duration::from_millis(300)).unwrap_err().to_string();
    assert!(said.contains("stopped after the time limit of 0.3 s"), "{said}");
}

#[test]
fn the_version_is_asked_for() {
    let dir = tempfile::tempdir().unwrap();
    assert_eq!(lammps(dir.path(), "").version(), "1 Jan 2030");
}
