//! The studies: methods against closed forms, orders against claims, maps against theory.
mod maps;
mod methods;
mod pages;
mod timestep;
