//! Impacts and rolling against closed forms and published numbers. Nothing here was made by the code under test.
mod bench;
mod hertz;
mod hysteresis;
mod linear;
mod oblique;
mod orders;
mod rolling;
mod rolling_jkr;
mod timing;
mod values;
