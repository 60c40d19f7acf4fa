//! The command line as people use it: what it says, how it ends, what it leaves behind.
#[path = "cli/bench.rs"]
mod bench;
#[path = "built/mod.rs"]
mod built;
#[path = "cli/help.rs"]
mod help;
#[path = "live/mod.rs"]
mod live;
#[path = "cli/memory.rs"]
mod memory;
#[path = "cli/missing.rs"]
mod missing;
#[path = "cli/readme.rs"]
mod readme;
#[path = "cli/replay.rs"]
mod replay;
#[path = "cli/run.rs"]
mod run;
#[path = "cli/stop.rs"]
mod stop;
#[path = "cli/study.rs"]
mod study;
#[path = "cli/timestep.rs"]
mod timestep;
#[path = "cli/verify.rs"]
mod verify;
