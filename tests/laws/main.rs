//! What the laws answer, without LIGGGHTS and without anything that was built before: rules that hold for all laws, closed
//! forms and published numbers, an oracle, and recorded calls.
mod bond;
mod closed_forms;
mod reference;
mod universal;
