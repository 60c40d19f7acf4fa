//! Advice against what is known beforehand: closed forms, and scenes made so that the answer is clear.
#[path = "advise/again.rs"]
mod again;
#[path = "advise/made.rs"]
mod made;
#[path = "advise/scenes.rs"]
mod scenes;
