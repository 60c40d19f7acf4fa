//! Why nothing could be verified at all.
use crate::codes::RunError;
use crate::deck::DeckError;
use thiserror::Error;

/// Why nothing could be verified at all.
#[derive(Debug, Error)]
pub enum VerifyError {
    /// A deck cannot be used.
    #[error(transparent)]
    Deck(#[from] DeckError),
    /// LIGGGHTS or the plugin is missing or wrong.
    #[error(transparent)]
    Run(#[from] RunError),
    /// Neither LIGGGHTS nor recorded traces.
    #[error("{missing}\nwithout it only recorded traces can be replayed, and none were found in\n  {}", looked.join("\n  "))]
    NoTraces {
        /// What is missing.
        missing: String,
        /// Where traces were looked for.
        looked: Vec<String>,
    },
    /// The shard leaves no deck.
    #[error("--shard {k}/{n} leaves none of the {decks} decks; take fewer shards")]
    EmptyShard {
        /// Number of the shard.
        k: usize,
        /// Number of shards.
        n: usize,
        /// Number of decks.
        decks: usize,
    },
    /// The operating system gives no threads.
    #[error("cannot start {jobs} jobs: {why}; take fewer with --jobs")]
    Threads {
        /// How many.
        jobs: usize,
        /// What the system says.
        why: String,
    },
}
