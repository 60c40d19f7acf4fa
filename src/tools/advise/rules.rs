//! The rules by which advice is given and judged, all in one place. They were fixed before any scene was run on advice
//! (DESIGN.md, "Rules of advice", gives the reason for each) and do not change with what comes out.
//!
//! *Which classes count.* Impacts are classed by octave of speed and by slip, lasting contacts by octave of load and by
//! pull, per pair of types and per wall. A class counts with a share of [`IMPORTANT`] of all impacts, of the momentum
//! exchanged, or of the work dissipated, or if it may have that share of the impacts in another run, as few contacts of it
//! were seen and their number is off by its root; so do the next larger ones until [`COVERED`] of the impacts and of the momentum is
//! reached. Where all classes together do not reach it, there is no advice.
//!
//! *Which errors.* Those of [`super::Errors`], each held to the accuracy in every class, against the deck's own laws in
//! very small steps ([`FINE`]). The error of a class is the mean of the sizes of its contacts' errors plus what that mean may be
//! off: its standard error times [`sure`]; a limit that is met exactly is met. Contacts of another run are held to the mean
//! plus one standard error.
//!
//! *When a term may be dropped.* When every class holds without it. Terms that may be dropped one by one are tried
//! together, and only what was tried together is recommended.
//!
//! *The step.* Multiples of the deck's own ([`LARGER`]) are tried upwards while every class holds, up to [`CRITICAL`].
//! If the deck's own does not hold, parts of it ([`SMALLER`]) until one does.
//!
//! *Which of what holds.* The least predicted time; of models that are predicted to take the same to within [`EQUAL`], the
//! simplest: with the fewest laws, then the least history, then the fewest changes.
//!
//! *Never recommended*: what was not tried; a change of a chain whose law acts across gaps (two bodies that begin at first
//! touch do not show what it does), or a step for it; a property outside the range of its law.

/// Accuracy unless asked otherwise.
pub const ACCURACY: f64 = 0.02;
/// Share of impacts, momentum or dissipation that makes a class count.
pub const IMPORTANT: f64 = 0.01;
/// Share of the impacts, and of the momentum, that the classes must stand for together.
pub const COVERED: f64 = 0.9;
/// Steps in half a period of the stiffest contact for what counts as the truth.
pub const FINE: f64 = 200.0;
/// Where within a step impacts begin, apart from an even spread over the contacts of a class.
pub const PHASES: [f64; 2] = [0.25, 0.75];
/// An impact that takes so many times longer than in the run sticks.
pub const STUCK: f64 = 5.0;
/// Multiples of the deck's time step that are tried one after the other while they hold.
pub const LARGER: [f64; 21] = [
    1.0, 1.25, 1.6, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.5, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0, 64.0,
    80.0, 100.0,
];
/// Parts of it, where it does not hold itself.
pub const SMALLER: [f64; 7] = [0.8, 0.64, 0.5, 0.4, 0.25, 0.1, 0.05];
/// Largest part of the critical step of two bodies that is recommended. With many neighbours the critical step is
/// half of that (face-centred cubic, eight springs to the mass), and a tangential spring as stiff as the normal one
/// brings it down to 0.53 of that again, because spheres turn under it.
pub const CRITICAL: f64 = 0.25;
/// Predicted times that differ by no more than this part are the same: they are right to about as much, and vary from run to
/// run with the costs that they are made of, while advice must not.
pub const EQUAL: f64 = 0.2;
/// Share of the impact classes of another run that must be within the accuracy.
pub const HELD_OUT: f64 = 0.95;
/// Largest difference of a bulk observable between the deck and the advised one, unless asked otherwise.
pub const BULK: f64 = 0.03;

/// How many standard errors are added to the mean of so many contacts: as many others, of another run, must come out within
/// the accuracy too, with a standard error of their own on top, in 95 of 100 cases. Two such means differ by √2 standard errors,
/// times Student's t (one-sided) where they are few. One contact alone tells nothing of how they differ; it counts as two
/// that differ as much as they are wrong.
pub fn sure(contacts: usize) -> f64 {
    const STUDENT: [f64; 23] = [
        6.314, 2.920, 2.353, 2.132, 2.015, 1.943, 1.895, 1.860, 1.833, 1.812, 1.796, 1.782, 1.771, 1.761,
        1.753, 1.746, 1.740, 1.734, 1.729, 1.725, 1.721, 1.717, 1.714,
    ];
    1.0 + std::f64::consts::SQRT_2 * STUDENT[contacts.saturating_sub(2).min(STUDENT.len() - 1)]
}
