//! Writes the model headers for a LIGGGHTS that is built from source; `scripts/dropin.sh` calls it.
use granlaw::laws::LAWS;
use granlaw::model::{Entry, Kind, Meta};
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io};

const HEADER: &str = include_str!("../../../capi/include/granlaw.h");
/// Each needs those before it.
const PARTS: [&str; 7] = [
    include_str!("../../cpp/creators.hpp"),
    include_str!("../../cpp/mirror.hpp"),
    include_str!("../../cpp/roll.hpp"),
    include_str!("../../cpp/wall.hpp"),
    include_str!("../../cpp/words.hpp"),
    include_str!("../../cpp/adapter.hpp"),
    include_str!("../../cpp/dropin.hpp"),
];

fn main() -> ExitCode {
    let Some(folder) = env::args_os().nth(1) else {
        eprintln!(
            "usage: granlaw-dropin FOLDER\nWrites one model header per law into the src folder of LIGGGHTS."
        );
        return ExitCode::from(2);
    };
    match write(Path::new(&folder)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            eprintln!("granlaw-dropin: {}: {e}", Path::new(&folder).display());
            ExitCode::from(2)
        }
    }
}

fn write(folder: &Path) -> io::Result<()> {
    fs::write(folder.join("granlaw.h"), HEADER)?;
    fs::write(folder.join("granlaw_dropin.h"), joined())?;
    LAWS.iter().try_for_each(|e| fs::write(folder.join(file(e.meta)), model(e)))
}

/// The parts in one header, without their includes of each other.
fn joined() -> String {
    let lines = PARTS.iter().flat_map(|p| p.lines());
    lines
        .filter(|l| !(l.starts_with("#include \"") && l.ends_with(".hpp\"")))
        .map(|l| format!("{l}\n"))
        .collect()
}

/// `Normal`, as in LIGGGHTS's `NormalModel`.
fn class(kind: Kind) -> &'static str {
    match kind {
        Kind::Normal => "Normal",
        Kind::Cohesion => "Cohesion",
        Kind::Tangential => "Tangential",
        Kind::Rolling => "Rolling",
    }
}

fn plain(name: &str) -> String {
    name.replace(|c: char| !c.is_ascii_alphanumeric(), "_")
}

fn file(m: &Meta) -> String {
    format!("{}_model_{}.h", m.kind.name(), plain(&m.called(false)))
}

/// A header as LIGGGHTS's build looks for: its first lines enter the law in the lists of models, the rest is the model.
fn model(e: &Entry) -> String {
    let m = e.meta;
    let (name, id, class) = (m.called(false), e.liggghts.id, class(m.kind));
    let kind = m.kind.name().to_uppercase();
    let constant = format!("{kind}_{}", plain(&name).to_uppercase());
    format!(
        "// {name}: {}.\n\
         // Made by granlaw's scripts/dropin.sh from the description of the law. SPDX-License-Identifier: GPL-2.0-or-later\n\
         #ifdef {kind}_MODEL\n\
         {kind}_MODEL({constant},{name},{id})\n\
         #else\n\
         #ifndef GRANLAW_{constant}_H\n\
         #define GRANLAW_{constant}_H\n\n\
         #include \"contact_models.h\"\n\
         #include \"granlaw_dropin.h\"\n\n\
         namespace LIGGGHTS {{\n\
         namespace ContactModels {{\n\
         template <>\n\
         class {class}Model<{constant}> : public granlaw::DropIn<{class}ModelBase, GRANLAW_{kind}, {id}> {{\n \
         public:\n  \
         using DropIn::DropIn;\n\
         }};\n\
         }}  // namespace ContactModels\n\
         }}  // namespace LIGGGHTS\n\
         #endif\n\
         #endif\n",
        m.summary
    )
}
