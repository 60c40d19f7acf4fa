//! Advice against what is known beforehand: closed forms, scenes made so that the answer is clear, and whole scenes.
#[path = "advise/again.rs"]
mod again;
#[path = "built/mod.rs"]
mod built;
#[path = "live/mod.rs"]
mod live;
#[path = "advise/made.rs"]
mod made;
#[path = "advise/scenes.rs"]
mod scenes;
#[path = "advise/whole.rs"]
mod whole;
