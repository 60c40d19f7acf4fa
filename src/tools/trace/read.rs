//! Reading a trace, one row at a time.
use super::columns::{column_names, Cell, COLUMNS};
use super::{Header, Row, TraceError, END, MARK, VERSION};
use csv::ByteRecord;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::str::FromStr;

/// Reads a trace. It is an iterator over the rows, which ends at the first error.
pub struct Reader<R: Read> {
    lines: csv::Reader<R>,
    line: ByteRecord,
    file: String,
    header: Header,
    headers: u64,
    columns: Vec<String>,
    rows: u64,
    at: u64,
    done: bool,
}

/// The kinds of line that begin with `#`.
enum Comment {
    Head(String),
    End(String),
    Text(String),
}

impl Reader<File> {
    /// Opens a trace in a file.
    ///
    /// # Errors
    /// If it cannot be read or is not a trace of this format.
    pub fn open(path: &Path) -> Result<Reader<File>, TraceError> {
        let file = path.display().to_string();
        let input = File::open(path).map_err(|source| TraceError::Io { file: file.clone(), source })?;
        Reader::new(input, &file)
    }
}

impl<R: Read> Reader<R> {
    /// Reads a trace from any source; `file` is its name in errors.
    ///
    /// # Errors
    /// If it cannot be read or is not a trace of this format.
    pub fn new(input: R, file: &str) -> Result<Reader<R>, TraceError> {
        let lines = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .quoting(false)
            .buffer_capacity(1 << 16)
            .from_reader(input);
        let mut reader = Reader {
            lines,
            line: ByteRecord::new(),
            file: file.to_string(),
            header: Header::default(),
            headers: 0,
            columns: Vec::new(),
            rows: 0,
            at: 0,
            done: false,
        };
        let Some(Comment::Head(version)) = reader.next_line()?.then(|| reader.comment()).flatten() else {
            return Err(TraceError::Foreign { file: reader.file });
        };
        reader.head(&version)?;
        reader.check_columns()?;
        if !reader.next_line()? {
            return Err(reader.truncated());
        }
        Ok(reader)
    }

    /// The header that applies to the last row that was read; before the first row, the one at the top.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The number of headers so far; when it grows, coefficients have to be prepared again.
    pub fn headers(&self) -> u64 {
        self.headers
    }

    /// Line of the row that was read last.
    pub fn line(&self) -> u64 {
        self.at
    }

    /// Read the next row into `row`; `false` after the last.
    ///
    /// # Errors
    /// If the trace is cut short or damaged.
    pub fn read(&mut self, row: &mut Row) -> Result<bool, TraceError> {
        while !self.done {
            match self.comment() {
                None => {
                    // If no line follows, writing stopped here, and this may be half a row.
                    let parsed = self.parse(row);
                    self.at = self.here();
                    if !self.next_line()? {
                        self.done = true;
                        return Err(TraceError::Truncated { file: self.file.clone(), line: self.at });
                    }
                    parsed.inspect_err(|_| self.done = true)?;
                    self.rows += 1;
                    return Ok(true);
                }
                Some(Comment::Head(version)) => self.head(&version).inspect_err(|_| self.done = true)?,
                Some(Comment::End(count)) => self.end(&count)?,
                Some(Comment::Text(text)) => {
                    self.done = true;
                    let (file, line) = (self.file.clone(), self.here());
                    if !self.next_line()? {
                        return Err(TraceError::Truncated { file, line });
                    }
                    let what = format!("{text:?} belongs to no header");
                    return Err(TraceError::Header { file, line, what });
                }
            }
        }
        Ok(false)
    }

    fn next_line(&mut self) -> Result<bool, TraceError> {
        self.lines.read_byte_record(&mut self.line).map_err(|e| {
            self.done = true;
            let source = std::io::Error::other(e.to_string());
            TraceError::Io { file: self.file.clone(), source }
        })
    }

    fn here(&self) -> u64 {
        self.line.position().map_or(1, csv::Position::line)
    }

    fn truncated(&self) -> TraceError {
        TraceError::Truncated { file: self.file.clone(), line: self.lines.position().line() }
    }

    /// The text of the present line, if it is a comment.
    fn comment(&self) -> Option<Comment> {
        if !self.line.get(0)?.starts_with(b"#") {
            return None;
        }
        let text = self.line.iter().map(String::from_utf8_lossy).collect::<Vec<_>>().join(",");
        Some(match (text.strip_prefix(MARK), text.strip_prefix(END)) {
            (Some(version), _) => Comment::Head(version.to_string()),
            (_, Some(count)) => Comment::End(count.to_string()),
            _ => Comment::Text(text),
        })
    }

    /// Read the header that the present line begins; afterwards the present line is the one behind it.
    fn head(&mut self, version: &str) -> Result<(), TraceError> {
        let (file, line) = (self.file.clone(), self.here());
        if version != VERSION.to_string() {
            return Err(TraceError::Version { file, line, found: version.to_string() });
        }
        let mut toml = String::new();
        loop {
            if !self.next_line()? {
                return Err(self.truncated());
            }
            let Some(Comment::Text(text)) = self.comment() else { break };
            toml += text.strip_prefix("# ").unwrap_or(&text[1..]);
            toml.push('\n');
        }
        let header: Header = toml::from_str(&toml).map_err(|e| TraceError::Header {
            file: file.clone(),
            line,
            what: e.message().to_string(),
        })?;
        if self.headers > 0 && (&header.atoms, &header.slots) != (&self.header.atoms, &self.header.slots) {
            let what = "its history slots or atom properties are not those of the first header".to_string();
            return Err(TraceError::Header { file, line, what });
        }
        self.header = header;
        self.headers += 1;
        Ok(())
    }

    fn check_columns(&mut self) -> Result<(), TraceError> {
        self.columns = column_names(&self.header.atoms, &self.header.slots);
        let (line, mut fields) = (self.here(), self.line.iter());
        for number in 1.. {
            let found = fields.next().map(|f| String::from_utf8_lossy(f).into_owned());
            let expected = self.columns.get(number - 1).cloned();
            if found.is_none() && expected.is_none() {
                break;
            }
            if found != expected {
                let (found, expected) = (found.unwrap_or_default(), expected.unwrap_or_default());
                return Err(TraceError::Columns { file: self.file.clone(), line, number, found, expected });
            }
        }
        Ok(())
    }

    fn end(&mut self, count: &str) -> Result<(), TraceError> {
        let (line, rows) = (self.here(), self.rows);
        self.done = true;
        let what = match count.parse::<u64>() {
            Ok(n) if n == rows && !self.next_line()? => return Ok(()),
            Ok(n) if n == rows => "there is text behind the last line".to_string(),
            _ => format!("the last line says {count} rows where there are {rows}"),
        };
        Err(TraceError::End { file: self.file.clone(), line, what })
    }

    fn parse(&self, row: &mut Row) -> Result<(), TraceError> {
        let (found, expected) = (self.line.len(), self.columns.len());
        if found != expected {
            return Err(TraceError::Length { file: self.file.clone(), line: self.here(), found, expected });
        }
        let mut at = Fields { reader: self, next: 0 };
        for column in COLUMNS {
            match (column.cell)(row) {
                Cell::Flag(x) => *x = at.take::<u8>("0 or 1", |n| *n < 2)? == 1,
                Cell::Small(x) => *x = at.take("a whole number", |_| true)?,
                Cell::Whole(x) => *x = at.take("a whole number", |_| true)?,
                Cell::Type(x) => {
                    let types = self.header.types;
                    *x = at.take::<usize>("an atom type of the header", |n| (1..=types).contains(n))? - 1;
                }
                Cell::Number(x) => *x = at.number()?,
                Cell::Vector(v) => *v = [at.number()?, at.number()?, at.number()?].into(),
            }
        }
        for place in self.header.places() {
            for body in [&mut row.close.i, &mut row.close.j] {
                let number = at.number()?;
                if let Some(place) = place {
                    body.given[place] = number;
                }
            }
        }
        for history in [&mut row.before, &mut row.after] {
            history.resize(self.header.slots.len(), 0.0);
            history.iter_mut().try_for_each(|x| at.number().map(|n| *x = n))?;
        }
        row.complete();
        Ok(())
    }
}

/// The fields of a row, one after the other.
struct Fields<'a, R: Read> {
    reader: &'a Reader<R>,
    next: usize,
}

impl<R: Read> Fields<'_, R> {
    fn number(&mut self) -> Result<f64, TraceError> {
        self.take("a number", |_| true)
    }

    fn take<T: FromStr>(
        &mut self,
        expected: &'static str,
        fits: impl Fn(&T) -> bool,
    ) -> Result<T, TraceError> {
        let field = &self.reader.line[self.next];
        self.next += 1;
        let value = std::str::from_utf8(field).ok().and_then(|text| text.parse().ok()).filter(fits);
        value.ok_or_else(|| TraceError::Field {
            file: self.reader.file.clone(),
            line: self.reader.here(),
            column: self.reader.columns[self.next - 1].clone(),
            text: String::from_utf8_lossy(field).into_owned(),
            expected,
        })
    }
}

impl<R: Read> Iterator for Reader<R> {
    type Item = Result<Row, TraceError>;
    fn next(&mut self) -> Option<Self::Item> {
        let mut row = Row::default();
        self.read(&mut row).map(|more| more.then_some(row)).transpose()
    }
}
