//! The studies: methods against closed forms, orders against claims, maps against theory and against LIGGGHTS.
#[path = "built/mod.rs"]
mod built;
#[path = "study/live.rs"]
mod live;
#[path = "study/maps.rs"]
mod maps;
#[path = "study/methods.rs"]
mod methods;
#[path = "study/pages.rs"]
mod pages;
#[path = "study/timestep.rs"]
mod timestep;
