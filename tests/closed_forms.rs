//! Impacts and rolling against closed forms and published numbers. Nothing here was made by the code under test.
#[path = "closed_forms/bench.rs"]
mod bench;
#[path = "closed_forms/hertz.rs"]
mod hertz;
#[path = "closed_forms/hysteresis.rs"]
mod hysteresis;
#[path = "closed_forms/linear.rs"]
mod linear;
#[path = "closed_forms/oblique.rs"]
mod oblique;
#[path = "closed_forms/orders.rs"]
mod orders;
#[path = "closed_forms/rolling.rs"]
mod rolling;
#[path = "closed_forms/rolling_jkr.rs"]
mod rolling_jkr;
#[path = "closed_forms/timing.rs"]
mod timing;
#[path = "closed_forms/values.rs"]
mod values;
