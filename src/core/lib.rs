//! Contact laws for granular simulation (DEM) that plug into LIGGGHTS.
//!
//! The rooms: [`model`] says what a law is, [`laws`] holds one file per law, [`lane`] the numbers their hot functions are
//! written in, [`chain`] runs the chosen laws over one contact, [`pair`] moves two bodies under a chain, [`critical`] knows
//! the longest stable time steps. What proves the laws right is the crate `granlaw-tools`.
//!
//! Two spheres of 1 cm that meet head-on at 1 m/s, under LIGGGHTS's `model hooke` with a restitution of 0.5:
//!
//! ```
//! use granlaw::chain::Chain;
//! use granlaw::laws::find;
//! use granlaw::model::{Body, Kind, Settings, Setup, Values};
//! use granlaw::pair::{states, Opened, Partner, Start};
//! use nalgebra::Vector3;
//!
//! let law = find(Kind::Normal, "hooke").expect("a law of LIGGGHTS");
//! let value = |name: &str| match name {
//!     "youngsModulus" => 5e6,
//!     "poissonsRatio" => 0.3,
//!     "coefficientRestitution" => 0.5,
//!     _ => 1.0,
//! };
//! let of = law.meta.props.iter().map(|p| vec![value(p.name)]).collect();
//! let setup = Setup { law, settings: Settings::new(law, false), values: Values { types: 1, of }, nktv2p: 1.0 };
//! let mut chain = Chain::packed(&[setup])?;
//!
//! let sphere = |x: f64, v: f64| Body {
//!     radius: 0.005,
//!     mass: 1.3e-3,
//!     x: Vector3::x() * x,
//!     v: Vector3::x() * v,
//!     ..Body::default()
//! };
//! let start = Start {
//!     bodies: [sphere(-0.00501, 0.5), sphere(0.00501, -0.5)],
//!     types: (0, 0),
//!     partner: Partner::Free,
//!     dt: 1e-6,
//!     steps: 4000,
//!     first: 0,
//!     gravity: Vector3::zeros(),
//!     opened: Opened::Keeps,
//! };
//! let [i, j] = states(&mut chain, &start).pop().expect("a last state").bodies;
//! // First order in the step: some 1700 steps per contact leave less than a thousandth.
//! assert!(((j.v.x - i.v.x) - 0.5).abs() < 1e-3);
//! # Ok::<(), granlaw::model::LawError>(())
//! ```
#![forbid(unsafe_code)]
#![warn(missing_docs)]

// For what `derive(Lanes)` writes.
extern crate self as granlaw;

pub mod chain;
pub mod critical;
pub mod lane;
pub mod laws;
pub mod model;
pub mod pair;
