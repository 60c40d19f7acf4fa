//! The command line as people use it: what it says, how it ends, what it leaves behind.
mod bench;
mod help;
mod memory;
mod missing;
mod readme;
mod replay;
mod run;
mod stop;
mod study;
mod timestep;
mod verify;
