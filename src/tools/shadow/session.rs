//! All chains of a run on one rank.
use super::measure::{Answer, Measure, Pair};
use super::{Compared, Shadow, Worst};
use crate::trace::{Header, LawSpec, Row, Writer};
use granlaw::chain::Chain;
use granlaw::laws::find;
use granlaw::model::Setup;

/// Collects what a rank sees of a run.
#[derive(Default)]
pub struct Session {
    chains: Vec<Watched>,
    ranks: usize,
}

struct Watched {
    found: Compared,
    header: Header,
    /// The Rust laws; `None` where nothing can be compared.
    chain: Option<Chain>,
    measure: Measure,
    answer: Answer,
}

impl Session {
    /// The index of a chain, with its coefficients as they are from now on.
    pub fn chain(&mut self, header: Header) -> usize {
        self.ranks = header.ranks;
        let (chain, left_out) = match rust(&header) {
            Ok(setups) => match Chain::new(&setups, &header.history_places(&setups)) {
                Ok(chain) => (Some(chain), None),
                Err(e) => (None, Some(e.to_string())),
            },
            Err(why) => (None, Some(why)),
        };
        let names: Vec<_> = header.laws.iter().map(name).collect();
        let (who, laws) = (header.who.clone(), names.join(", "));
        let found = Compared { who, laws, left_out, ..Compared::default() };
        let known = self.chains.iter().position(|w| w.found.is(&found));
        let at = known.unwrap_or(self.chains.len());
        if known.is_none() {
            let (measure, answer) = (Measure::default(), Answer::default());
            self.chains.push(Watched { found, header, chain, measure, answer });
        } else {
            (self.chains[at].header, self.chains[at].chain) = (header, chain);
        }
        at
    }

    /// Compares a call with LIGGGHTS's answer; `share` is the part of a wall contact that counts, 1 for a pair.
    ///
    /// # Panics
    /// If `at` is no place that [`Session::chain`] gave.
    pub fn call(&mut self, at: usize, row: &Row, share: f64) {
        let w = &mut self.chains[at];
        w.found.calls += 1;
        if let Some(chain) = &mut w.chain {
            w.answer.of(chain, row, share);
            let differences = w.measure.differences(row, &w.answer);
            w.keep(row, differences);
        }
    }

    /// Whether calls of a chain are compared.
    pub fn compares(&self, at: usize) -> bool {
        self.chains[at].chain.is_some()
    }

    /// From now on calls of a chain may be [`answered`](Session::answered) through the batched pass; `way` names it.
    pub fn side_by_side(&mut self, at: usize, way: &str) {
        self.chains[at].found.way = way.to_string();
    }

    /// Compares a call with LIGGGHTS's answer; that of the Rust laws was computed elsewhere.
    pub fn answered(&mut self, at: usize, row: &Row, rust: &Answer) {
        let w = &mut self.chains[at];
        w.found.calls += 1;
        w.found.batched += 1;
        let differences = w.measure.differences(row, rust);
        w.keep(row, differences);
    }

    /// The run is over.
    pub fn finish(self) -> Shadow {
        let chains = self.chains.into_iter().map(|w| w.found).collect();
        Shadow { ranks: self.ranks.max(1), chains }
    }
}

impl Watched {
    fn keep(&mut self, row: &Row, differences: [Option<Pair>; 3]) {
        if differences.iter().all(Option::is_none) {
            return;
        }
        self.found.differing += 1;
        for (k, pair) in differences.into_iter().enumerate() {
            let Some(pair) = pair else { continue };
            if self.found.worst[k].as_ref().is_none_or(|w| pair.error > w.error) {
                self.found.worst[k] = Some(worst(&self.header, row, k, &pair));
            }
        }
    }
}

/// The Rust laws to compare with.
///
/// # Errors
/// Why there is none, in words.
fn rust(header: &Header) -> Result<Vec<Setup>, String> {
    let lacking: Vec<_> = header.laws.iter().filter(|l| !l.known).map(name).collect();
    if !lacking.is_empty() {
        return Err(format!("granlaw has no {}", lacking.join(", ")));
    }
    // In a shadowed run stock names are LIGGGHTS's own laws, and Rust laws run only where the deck itself names them.
    if let Some(ours) = header.laws.iter().find(|l| !l.taken_over) {
        let twin =
            ours.kind().and_then(|k| find(k, &ours.keyword)).is_some_and(|e| e.liggghts.stock_id.is_some());
        return Err(match twin {
            true => {
                format!("the deck itself runs granlaw's {}/rs; take LIGGGHTS's law, without /rs", name(ours))
            }
            false => format!("LIGGGHTS has no {}", name(ours)),
        });
    }
    header.setups().map_err(|e| e.to_string())
}

fn name(law: &LawSpec) -> String {
    format!("{} {}", law.kind, law.keyword)
}

fn worst(header: &Header, row: &Row, measure: usize, p: &Pair) -> Worst {
    let axis = ["x", "y", "z"].get(p.at).copied().unwrap_or_default();
    let what = match measure {
        0 => format!("force_{}.{axis}", ["i", "j"][p.of]),
        1 => format!("torque_{}.{axis}", ["i", "j"][p.of]),
        _ => format!("after.{}", header.slots[p.at]),
    };
    let (step, tags) = (row.close.call.step, (row.close.i.tag, row.close.j.tag));
    Worst { error: p.error, step, tags, what, rust: p.rust, stock: p.stock, inputs: inputs(header, row) }
}

/// The inputs of a call, by the columns of a trace: all but those of the answer.
fn inputs(header: &Header, row: &Row) -> Vec<(String, String)> {
    let mut trace = Vec::new();
    let written = Writer::new(&mut trace, "inputs", header).and_then(|mut w| {
        w.row(row)?;
        w.finish()
    });
    written.expect("memory takes a row of the header's slots");
    let text = String::from_utf8(trace).expect("a trace is text");
    let mut lines = text.lines().filter(|l| !l.starts_with('#')).map(|l| l.split(','));
    let (Some(names), Some(values)) = (lines.next(), lines.next()) else { return Vec::new() };
    let all = names.zip(values).map(|(n, v)| (n.to_string(), v.to_string()));
    let answers = ["force_", "torque_", "after."];
    let handed = ["fn", "kn", "kt", "gamman", "gammat", "has_force"];
    all.filter(|(n, _)| !handed.contains(&&**n) && !answers.iter().any(|a| n.starts_with(a))).collect()
}
