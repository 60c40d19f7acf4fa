//! Writing a trace, one row at a time.
use super::columns::{column_names, Cell, COLUMNS};
use super::{Header, Row, TraceError, END, MARK, VERSION};
use granlaw::model::ClosePair;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a trace; it is complete only after [`Writer::finish`].
pub struct Writer<W: Write> {
    out: csv::Writer<W>,
    file: String,
    slots: Vec<String>,
    atoms: Vec<String>,
    places: Vec<Option<usize>>,
    rows: u64,
    scratch: Row,
    text: String,
    rename: Option<(PathBuf, PathBuf)>,
}

impl Writer<File> {
    /// Begins a trace in a file. Until it is finished the file is called `<path>.part`.
    ///
    /// # Errors
    /// If the file cannot be made or written.
    pub fn create(path: &Path, header: &Header) -> Result<Writer<File>, TraceError> {
        let mut part = path.as_os_str().to_owned();
        part.push(".part");
        let part = PathBuf::from(part);
        let file = part.display().to_string();
        let out = File::create(&part).map_err(|source| TraceError::Io { file: file.clone(), source })?;
        let mut writer = Writer::new(out, &file, header)?;
        writer.rename = Some((part, path.to_owned()));
        Ok(writer)
    }
}

impl<W: Write> Writer<W> {
    /// Begins a trace in any target; `file` is its name in errors.
    ///
    /// # Errors
    /// If writing fails.
    pub fn new(out: W, file: &str, header: &Header) -> Result<Writer<W>, TraceError> {
        // Only numbers and comments are written, so nothing needs quotes.
        let out = csv::WriterBuilder::new()
            .flexible(true)
            .quote_style(csv::QuoteStyle::Never)
            .buffer_capacity(1 << 16)
            .from_writer(out);
        let mut writer = Writer {
            out,
            file: file.to_string(),
            slots: header.slots.clone(),
            atoms: header.atoms.clone(),
            places: header.places().collect(),
            rows: 0,
            scratch: Row::default(),
            text: String::new(),
            rename: None,
        };
        writer.head(header)?;
        writer.lines(&column_names(&header.atoms, &header.slots).join(","))?;
        Ok(writer)
    }

    /// Writes a header that applies from here on, after coefficients were prepared again. The slots must be the same.
    ///
    /// # Errors
    /// Other slots or atom properties, or if writing fails.
    pub fn header(&mut self, header: &Header) -> Result<(), TraceError> {
        if (&header.slots, &header.atoms) != (&self.slots, &self.atoms) {
            let what = format!(
                "history slots or atom properties change from {:?} {:?} to {:?} {:?}",
                self.slots, self.atoms, header.slots, header.atoms
            );
            return Err(self.failed(io::Error::new(io::ErrorKind::InvalidInput, what)));
        }
        self.head(header)
    }

    /// Writes one call.
    ///
    /// # Errors
    /// A history of another length than the header says, or if writing fails.
    pub fn row(&mut self, row: &Row) -> Result<(), TraceError> {
        let n = self.slots.len();
        if row.before.len() != n || row.after.len() != n {
            let what = format!("a row has {}/{} slots, not {n}", row.before.len(), row.after.len());
            return Err(self.failed(io::Error::new(io::ErrorKind::InvalidInput, what)));
        }
        self.rows += 1;
        self.write(row).map_err(|e| self.failed(into_io(e)))
    }

    /// Write the last line and give the file its name.
    ///
    /// # Errors
    /// If writing or renaming fails.
    pub fn finish(mut self) -> Result<(), TraceError> {
        self.lines(&format!("{END}{}", self.rows))?;
        self.out.flush().map_err(|e| self.failed(e))?;
        match &self.rename {
            Some((from, to)) => fs::rename(from, to).map_err(|e| self.failed(e)),
            None => Ok(()),
        }
    }

    fn head(&mut self, header: &Header) -> Result<(), TraceError> {
        let toml = toml::to_string(header)
            .map_err(|e| self.failed(io::Error::new(io::ErrorKind::InvalidInput, e.to_string())))?;
        self.lines(&format!("{MARK}{VERSION}"))?;
        toml.lines().filter(|l| !l.is_empty()).try_for_each(|line| self.lines(&format!("# {line}")))
    }

    fn lines(&mut self, line: &str) -> Result<(), TraceError> {
        self.out.write_record([line]).map_err(|e| self.failed(into_io(e)))
    }

    fn write(&mut self, row: &Row) -> csv::Result<()> {
        self.scratch.clone_from(row);
        let ClosePair { i, j, .. } = &mut self.scratch.close;
        (i.mass, j.mass) = (i.felt_mass(), j.felt_mass());
        for column in COLUMNS {
            match (column.cell)(&mut self.scratch) {
                Cell::Flag(x) => put(&mut self.out, &mut self.text, format_args!("{}", i32::from(*x)))?,
                Cell::Small(x) => put(&mut self.out, &mut self.text, format_args!("{x}"))?,
                Cell::Whole(x) => put(&mut self.out, &mut self.text, format_args!("{x}"))?,
                Cell::Type(x) => put(&mut self.out, &mut self.text, format_args!("{}", *x + 1))?,
                Cell::Number(x) => number(&mut self.out, &mut self.text, *x)?,
                Cell::Vector(v) => {
                    v.iter().try_for_each(|x| number(&mut self.out, &mut self.text, *x))?;
                }
            }
        }
        for place in &self.places {
            for body in [&row.close.i, &row.close.j] {
                number(&mut self.out, &mut self.text, place.map_or(f64::NEG_INFINITY, |k| body.given[k]))?;
            }
        }
        for x in row.before.iter().chain(&row.after) {
            number(&mut self.out, &mut self.text, *x)?;
        }
        self.out.write_record(None::<&[u8]>)
    }

    fn failed(&self, source: io::Error) -> TraceError {
        TraceError::Io { file: self.file.clone(), source }
    }
}

/// Writes a number. Zero, by far the most frequent, is kept short.
fn number<W: Write>(out: &mut csv::Writer<W>, text: &mut String, x: f64) -> csv::Result<()> {
    if x == 0.0 {
        out.write_field(if x.is_sign_negative() { "-0" } else { "0" })
    } else {
        put(out, text, format_args!("{x:e}"))
    }
}

fn put<W: Write>(out: &mut csv::Writer<W>, text: &mut String, what: fmt::Arguments<'_>) -> csv::Result<()> {
    text.clear();
    fmt::write(text, what).expect("a string takes everything");
    out.write_field(&*text)
}

fn into_io(e: csv::Error) -> io::Error {
    match e.into_kind() {
        csv::ErrorKind::Io(e) => e,
        other => io::Error::other(format!("{other:?}")),
    }
}
