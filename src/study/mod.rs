//! Studies: what the methods cost and how wrong they are, and where they fail.
pub mod about;
pub mod adaptive;
pub mod live;
pub mod located;
pub mod matter;
pub mod modes;
pub mod motion;
pub mod shot;
pub mod single;
pub mod speed;
pub mod stability;
pub mod timestep;
