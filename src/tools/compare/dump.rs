//! LIGGGHTS's text dumps (`dump ... custom`).
use super::error::CompareError;
use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

const FIRST: &str = "ITEM: TIMESTEP";
const ATOMS: &str = "ITEM: ATOMS ";

/// Whether a file is a text dump, by its first line.
///
/// # Errors
/// If it cannot be read.
pub fn is_dump(path: &Path) -> io::Result<bool> {
    let mut start = Vec::new();
    File::open(path)?.take(FIRST.len() as u64).read_to_end(&mut start)?;
    Ok(start == FIRST.as_bytes())
}

/// The result of comparing two dumps.
#[derive(Clone, Debug, PartialEq)]
pub struct Dumps {
    /// Number of frames that are equal byte for byte.
    pub frames: u64,
    /// The first difference, if there is one.
    pub difference: Option<Difference>,
}

/// Where two dumps differ first.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The line.
    pub line: u64,
    /// Step of the frame.
    pub step: i64,
    /// The particle, if the line is about one.
    pub id: Option<i64>,
    /// The column; `line` where it is not about a particle.
    pub column: String,
    /// The text in the dump on trial; empty where it has ended.
    pub got: String,
    /// The text in the other; empty where it has ended.
    pub expected: String,
}

/// Compare two dumps byte for byte; the second is the reference.
///
/// # Errors
/// If either cannot be read or is not a dump.
pub fn dumps(got: &Path, expected: &Path) -> Result<Dumps, CompareError> {
    let (mut a, mut b) = (Lines::open(got)?, Lines::open(expected)?);
    let mut frames = 0u64;
    loop {
        let (more_a, more_b) = (a.next()?, b.next()?);
        if a.bytes != b.bytes {
            let difference = Some(b.difference(&a));
            return Ok(Dumps { frames: frames.saturating_sub(1), difference });
        }
        if !more_a || !more_b {
            return Ok(Dumps { frames, difference: None });
        }
        frames += u64::from(b.text() == FIRST);
    }
}

/// A dump, read line by line, with the step and columns of the present frame.
struct Lines {
    input: BufReader<File>,
    file: String,
    line: u64,
    bytes: Vec<u8>,
    heading: String,
    step: i64,
    atoms: u64,
    columns: Vec<String>,
}

impl Lines {
    fn open(path: &Path) -> Result<Lines, CompareError> {
        let file = path.display().to_string();
        let failed = |source| CompareError::Io { file: file.clone(), source };
        if !is_dump(path).map_err(failed)? {
            return Err(CompareError::NotADump { file });
        }
        let input = BufReader::new(File::open(path).map_err(failed)?);
        let (bytes, heading, columns) = (Vec::new(), String::new(), Vec::new());
        Ok(Lines { input, file, line: 0, bytes, heading, step: 0, atoms: 0, columns })
    }

    fn next(&mut self) -> Result<bool, CompareError> {
        self.bytes.clear();
        let n = self.input.read_until(b'\n', &mut self.bytes);
        let n = n.map_err(|source| CompareError::Io { file: self.file.clone(), source })?;
        self.line += 1;
        if n == 0 {
            return Ok(false);
        }
        let text = self.text().trim_end().to_string();
        if text.starts_with("ITEM:") {
            if let Some(columns) = text.strip_prefix(ATOMS) {
                self.columns = columns.split_whitespace().map(String::from).collect();
            }
            self.heading = text;
        } else if self.heading == FIRST {
            self.step = self.number(&text)?;
        } else if self.heading == "ITEM: NUMBER OF ATOMS" {
            self.atoms = self.number(&text)?;
        }
        Ok(true)
    }

    /// The line without its end.
    fn text(&self) -> &str {
        std::str::from_utf8(&self.bytes).unwrap_or("").trim_end_matches(['\n', '\r'])
    }

    fn number<T: std::str::FromStr>(&self, text: &str) -> Result<T, CompareError> {
        text.trim().parse().map_err(|_| self.damaged(format!("{text:?} is not a number")))
    }

    fn damaged(&self, what: String) -> CompareError {
        CompareError::Damaged { file: self.file.clone(), line: self.line, what }
    }

    /// The values of a particle's line; `None` on other lines.
    fn particle(&self) -> Option<Vec<&str>> {
        let about_one = self.heading.starts_with(ATOMS) && !self.bytes.starts_with(b"ITEM:");
        (about_one && !self.bytes.is_empty()).then(|| self.text().split_whitespace().collect())
    }

    /// The frame that was read, if it is complete.
    fn frame(&self, particles: HashMap<i64, Vec<f64>>, step: i64) -> Result<Frame, CompareError> {
        if particles.len() as u64 != self.atoms {
            return Err(self.halved(particles.len()));
        }
        Ok(Frame { step, columns: self.columns.clone(), particles, file: self.file.clone() })
    }

    fn halved(&self, n: usize) -> CompareError {
        self.damaged(format!("a frame has {n} of its {} particles", self.atoms))
    }

    /// The present lines of both differ: finds where.
    fn difference(&self, got: &Lines) -> Difference {
        let whole = |l: &Lines| String::from_utf8_lossy(&l.bytes).trim_end().to_string();
        let mut d = Difference {
            line: self.line,
            step: self.step,
            id: None,
            column: "line".into(),
            got: whole(got),
            expected: whole(self),
        };
        let (Some(a), Some(b)) = (got.particle(), self.particle()) else { return d };
        if a.len() != b.len() || b.len() != self.columns.len() {
            return d;
        }
        let column_of_id = self.columns.iter().position(|c| c == "id");
        d.id = column_of_id.and_then(|k| b[k].parse().ok());
        if let Some(k) = (0..b.len()).find(|k| a[*k] != b[*k]) {
            (d.column, d.got, d.expected) = (self.columns[k].clone(), a[k].into(), b[k].into());
        }
        d
    }
}

/// One frame of a dump: the state of all particles at a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// The step.
    pub step: i64,
    /// The columns.
    pub columns: Vec<String>,
    /// The particles by their number.
    pub particles: HashMap<i64, Vec<f64>>,
    file: String,
}

impl Frame {
    /// The last frame of a dump.
    ///
    /// # Errors
    /// If it cannot be read, is not a dump, or ends in the middle of a frame.
    pub fn last(path: &Path) -> Result<Frame, CompareError> {
        let mut last = Frame::default();
        Frame::each(path, |frame| last = frame)?;
        Ok(last)
    }

    /// Every frame of a dump, in turn; there is at least one.
    ///
    /// # Errors
    /// As [`Frame::last`], of any frame.
    pub fn each(path: &Path, mut one: impl FnMut(Frame)) -> Result<(), CompareError> {
        let mut lines = Lines::open(path)?;
        let mut particles = HashMap::new();
        // A frame ends at the heading of the next, whose step has then replaced its own.
        let mut last = 0;
        while lines.next()? {
            if lines.text() == FIRST && lines.line > 1 {
                one(lines.frame(std::mem::take(&mut particles), last)?);
            } else if let Some(values) = lines.particle() {
                let values = values.iter().map(|v| lines.number(v)).collect::<Result<Vec<f64>, _>>()?;
                let at = lines.columns.iter().position(|c| c == "id").filter(|k| *k < values.len());
                let Some(at) = at.filter(|_| values.len() == lines.columns.len()) else {
                    let (n, c) = (values.len(), lines.columns.join(" "));
                    return Err(lines.damaged(format!("{n} values for the columns {c}, which need an id")));
                };
                particles.insert(values[at] as i64, values);
            }
            last = lines.step;
        }
        if !lines.heading.starts_with(ATOMS) {
            return Err(lines.halved(particles.len()));
        }
        one(lines.frame(particles, last)?);
        Ok(())
    }

    /// A column of a particle.
    ///
    /// # Errors
    /// If there is no such column or particle.
    pub fn value(&self, id: i64, column: &str) -> Result<f64, CompareError> {
        let file = self.file.clone();
        let Some(k) = self.columns.iter().position(|c| c == column) else {
            return Err(CompareError::NoColumn {
                file,
                column: column.into(),
                known: self.columns.join(", "),
            });
        };
        let particle = self.particles.get(&id);
        particle.map(|p| p[k]).ok_or(CompareError::NoParticle { file, step: self.step, id })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    const DUMP: &str =
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 1\n\
        ITEM: ATOMS id vx\n1 -0.5 \n2 0.25 \nITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n2\n\
        ITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 1\nITEM: ATOMS id vx\n1 -0.125 \n2 0.75 \n";

    struct Folder(tempfile::TempDir);
    impl Folder {
        fn new() -> Folder {
            Folder(tempfile::tempdir().unwrap())
        }
        fn file(&self, name: &str, text: &str) -> std::path::PathBuf {
            let path = self.0.path().join(name);
            fs::write(&path, text).unwrap();
            path
        }
    }

    #[test]
    fn equal_dumps_are_equal_and_the_first_difference_is_named() {
        let f = Folder::new();
        let stock = f.file("a", DUMP);
        assert_eq!(dumps(&stock, &stock).unwrap(), Dumps { frames: 2, difference: None });
        let d = dumps(&f.file("b", &DUMP.replace("0.75", "0.76")), &stock).unwrap();
        let at = d.difference.unwrap();
        assert_eq!((d.frames, at.line, at.step, at.id, at.column.as_str()), (1, 22, 10, Some(2), "vx"));
        assert_eq!((at.got.as_str(), at.expected.as_str()), ("0.76", "0.75"));
        let cut = dumps(&f.file("c", &DUMP[..DUMP.len() - 8]), &stock).unwrap().difference.unwrap();
        assert_eq!((cut.line, cut.got.as_str(), cut.expected.as_str()), (22, "", "2 0.75"));
        let step =
            dumps(&f.file("d", &DUMP.replace("\n10\n", "\n11\n")), &stock).unwrap().difference.unwrap();
        assert_eq!((step.line, step.step, step.column.as_str(), step.got.as_str()), (13, 10, "line", "11"));
    }

    #[test]
    fn a_number_of_the_last_frame_is_found() {
        let f = Folder::new();
        let last = Frame::last(&f.file("a", DUMP)).unwrap();
        assert_eq!(
            (last.step, last.value(1, "vx").unwrap(), last.value(2, "vx").unwrap()),
            (10, -0.125, 0.75)
        );
        let why = last.value(1, "vz").unwrap_err().to_string();
        assert!(why.contains("no column vz; it has id, vx"), "{why}");
        let why = last.value(3, "vx").unwrap_err().to_string();
        assert!(why.contains("step 10") && why.contains("no particle 3"), "{why}");
    }

    #[test]
    fn damaged_and_foreign_files_are_refused() {
        let f = Folder::new();
        let why = |name: &str, text: &str| Frame::last(&f.file(name, text)).unwrap_err().to_string();
        assert!(why("a", "x,y\n1,2\n").contains("not a text dump"));
        assert!(why("b", "").contains("not a text dump"));
        assert!(why("c", &DUMP[..DUMP.len() - 8]).contains("1 of its 2 particles"));
        assert!(why("d", "ITEM: TIMESTEP\n0\n").contains("0 of its 0 particles"));
        assert!(why("e", &DUMP.replace("id vx", "vx")).contains("which need an id"));
        assert!(why("f", &DUMP.replace("0.25", "x")).contains(":11: \"x\" is not a number"));
        assert!(!is_dump(&f.file("g", "ITEM: TIME")).unwrap());
        assert!(dumps(&f.file("h", DUMP), &f.0.path().join("none"))
            .unwrap_err()
            .to_string()
            .contains("none"));
    }
}
