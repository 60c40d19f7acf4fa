//! What can be wrong with a trace.
use std::io;
use thiserror::Error;

/// Why a trace cannot be read or written: the file, the line, what is wrong and what to do.
#[derive(Debug, Error)]
pub enum TraceError {
    /// The file cannot be opened, read or written.
    #[error("{file}: {source}; check the path, the permissions and the space on the disk")]
    Io {
        /// The file.
        file: String,
        /// What the operating system says.
        source: io::Error,
    },
    /// Not a trace.
    #[error("{file}: line 1 is not '# granlaw trace ...', so this is not a trace; write one with granlaw run --record")]
    Foreign {
        /// The file.
        file: String,
    },
    /// A trace of another format.
    #[error("{file}:{line}: format {found:?} of traces is unknown here, which reads {known}; record it again or use the granlaw that wrote it", known = super::VERSION)]
    Version {
        /// The file.
        file: String,
        /// The line.
        line: u64,
        /// The format of the file.
        found: String,
    },
    /// The header is not what it should be.
    #[error("{file}:{line}: in the header that begins here: {what}; record the trace again")]
    Header {
        /// The file.
        file: String,
        /// The line where the header begins.
        line: u64,
        /// What is wrong.
        what: String,
    },
    /// The columns are not those of the format.
    #[error(
        "{file}:{line}: column {number} is {found:?} where {expected:?} belongs; record the trace again"
    )]
    Columns {
        /// The file.
        file: String,
        /// The line.
        line: u64,
        /// The number of the column, from 1.
        number: usize,
        /// What it is called; empty where there is none.
        found: String,
        /// What it should be called; empty where there should be none.
        expected: String,
    },
    /// A row of the wrong length.
    #[error(
        "{file}:{line}: the row has {found} fields where {expected} columns are named; record the trace again"
    )]
    Length {
        /// The file.
        file: String,
        /// The line.
        line: u64,
        /// How many fields the row has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// A field that does not hold what its column should.
    #[error("{file}:{line}: {text:?} in column {column} is not {expected}; record the trace again")]
    Field {
        /// The file.
        file: String,
        /// The line.
        line: u64,
        /// The column.
        column: String,
        /// The field.
        text: String,
        /// What belongs there.
        expected: &'static str,
    },
    /// The last line is missing.
    #[error("{file}:{line}: the trace was cut short: it must end with '# end <rows>'; the run that wrote it did not finish, record it again")]
    Truncated {
        /// The file.
        file: String,
        /// The last line there is.
        line: u64,
    },
    /// The last line counts other rows than there are, or is not the last.
    #[error("{file}:{line}: {what}; the file was changed after it was written, record it again")]
    End {
        /// The file.
        file: String,
        /// The line.
        line: u64,
        /// What is wrong.
        what: String,
    },
}
