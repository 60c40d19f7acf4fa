//! The rules by which advice is given and judged, all in one place. They were fixed before any scene was run on advice
//! (DESIGN.md, "Rules of advice", gives the reason for each) and do not change with what comes out.
//!
//! *Which classes count.* Impacts are classed by octave of speed and by slip, lasting contacts by octave of load and by
//! pull, per pair of types and per wall. A class counts with a share of [`IMPORTANT`] of all impacts, of the momentum
//! exchanged, or of the work dissipated. It also counts if it may have that share of the impacts in another run: the number of
//! its contacts is a matter of chance, and may differ by its square root. Of the other classes the largest count too, until
//! [`COVERED`] of the impacts and of the momentum is reached. If all classes together do not reach it, there is no advice.
//!
//! *Which errors.* Those of [`super::Errors`], each held to the accuracy in every class, against the deck's own laws in
//! very small steps ([`FINE`]). The error of a class is the mean of the absolute errors of its contacts plus a margin, the standard
//! error of that mean times [`sure`]. An error equal to the limit is within it. For contacts of another run the margin is one
//! standard error.
//!
//! *When a term may be dropped.* When every class is within the accuracy without it. Terms that may each be dropped alone are then
//! tried together, and they are only dropped together if that holds too.
//!
//! *The step.* Multiples of the deck's own ([`LARGER`]) are tried upwards while every class is within the accuracy, up to
//! [`CRITICAL`]. If the deck's own is too large, fractions of it ([`SMALLER`]) are tried until one is small enough.
//!
//! *Which model is chosen.* Of those that hold, the one with the least predicted time. Of models whose predicted times are the same to within
//! [`EQUAL`], the simplest: with the fewest laws, then the least history, then the fewest changes.
//!
//! *Never recommended*: what was not tried; another step or a change to a chain with a law that acts across gaps (two bodies that
//! begin at first touch do not show what it does); a property outside the range of its law.

/// Accuracy unless asked otherwise.
pub const ACCURACY: f64 = 0.02;
/// Share of impacts, momentum or dissipation that makes a class count.
pub const IMPORTANT: f64 = 0.01;
/// Share of the impacts, and of the momentum, that the classes must stand for together.
pub const COVERED: f64 = 0.9;
/// Steps in half a period of the stiffest contact, for the solution that counts as the truth.
pub const FINE: f64 = 200.0;
/// Moments within a step at which an impact begins. Each contact of a class adds an offset of its own, so that they spread evenly.
pub const PHASES: [f64; 2] = [0.25, 0.75];
/// An impact that takes this many times as long as in the run counts as stuck.
pub const STUCK: f64 = 5.0;
/// Multiples of the deck's time step that are tried one after the other while all classes are within the accuracy.
pub const LARGER: [f64; 21] = [
    1.0, 1.25, 1.6, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.5, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0, 64.0,
    80.0, 100.0,
];
/// Fractions of the deck's time step that are tried if it is too large itself.
pub const SMALLER: [f64; 7] = [0.8, 0.64, 0.5, 0.4, 0.25, 0.1, 0.05];
/// Largest recommended step, as a fraction of the critical step of two bodies. With many neighbours the critical step is half that of
/// two bodies (face-centred cubic lattice, eight springs to the mass); a tangential spring as stiff as the normal one leaves 0.53 of
/// that, because it also turns the spheres.
pub const CRITICAL: f64 = 0.25;
/// Predicted times that differ by no more than this fraction count as the same. Predictions are right to about that, and they vary from
/// run to run with the measured costs, while advice should not.
pub const EQUAL: f64 = 0.2;
/// Share of the impact classes of another run that must be within the accuracy.
pub const HELD_OUT: f64 = 0.95;
/// Largest difference of a bulk observable between the deck and the advised one, unless asked otherwise.
pub const BULK: f64 = 0.03;

/// How many standard errors are added to the mean error of a number of contacts. The aim: in 95 of 100 cases, as many contacts of
/// another run are within the accuracy too, with one standard error of their own added. Two such means differ by √2 standard errors,
/// times Student's t (one-sided) for few contacts. One contact alone shows no scatter; it is treated like two whose errors
/// differ by as much as its own error.
pub fn sure(contacts: usize) -> f64 {
    const STUDENT: [f64; 23] = [
        6.314, 2.920, 2.353, 2.132, 2.015, 1.943, 1.895, 1.860, 1.833, 1.812, 1.796, 1.782, 1.771, 1.761,
        1.753, 1.746, 1.740, 1.734, 1.729, 1.725, 1.721, 1.717, 1.714,
    ];
    1.0 + std::f64::consts::SQRT_2 * STUDENT[contacts.saturating_sub(2).min(STUDENT.len() - 1)]
}
