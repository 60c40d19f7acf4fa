//! Many contacts at once in LIGGGHTS itself: one run, one time step, one pair of spheres per phase of first touch.
use super::bonded::{ahead, every};
use super::collision::{Collision, Outcome};
use super::matter::{Matter, Names};
use crate::codes::liggghts::{Laws, Liggghts, Plugin, Preload};
use crate::codes::{run, Folder, Ran, Run, RunError};
use crate::compare::{CompareError, Frame};
use crate::deck::{Deck, DeckError};
use granlaw::model::Body;
use nalgebra::Vector3;
use std::path::PathBuf;
use std::time::Duration;
use thiserror::Error;

/// Why there is no answer from LIGGGHTS.
#[derive(Debug, Error)]
pub enum LiveError {
    /// The run failed.
    #[error(transparent)]
    Run(#[from] RunError),
    /// The deck could not be written or read again.
    #[error(transparent)]
    Deck(#[from] DeckError),
    /// The dump could not be read.
    #[error(transparent)]
    Dump(#[from] CompareError),
    /// A file could not be written.
    #[error("cannot write {path}: {source}", path = path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// There is no dump.
    #[error("LIGGGHTS wrote no dump")]
    NoDump,
}

/// LIGGGHTS and the plugin.
#[derive(Debug)]
pub struct Bench {
    /// The program.
    pub host: Liggghts,
    /// The plugin.
    pub plugin: Plugin,
    /// How long a run may take.
    pub limit: Duration,
}

/// Who computes the contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Who {
    /// LIGGGHTS alone.
    Stock,
    /// Our laws under LIGGGHTS's names, by the plugin.
    TakenOver,
    /// Our laws under their own names, which have the settings.
    Own,
}

impl Who {
    fn names(self) -> Names {
        if self == Who::Own {
            Names::Own
        } else {
            Names::Stock
        }
    }
}

impl Bench {
    /// What is installed here.
    ///
    /// # Errors
    /// If LIGGGHTS or the plugin is missing.
    pub fn find(limit: Duration) -> Result<Bench, RunError> {
        Ok(Bench { host: Liggghts::find()?, plugin: Plugin::find()?, limit })
    }

    /// Shots at different phases of first touch (`before` steps ahead), all in one run of `steps` steps of `dt` \[s\]: what
    /// came of the first collision at every phase, then of the second and so on. They differ in their speeds only.
    ///
    /// # Errors
    /// If LIGGGHTS fails.
    pub fn collide(
        &self,
        matter: &Matter,
        collisions: &[Collision],
        who: Who,
        (dt, steps): (f64, u64),
        before: &[f64],
    ) -> Result<Vec<Outcome>, LiveError> {
        let collision =
            &collisions.iter().copied().max_by(|a, b| a.speed.total_cmp(&b.speed)).expect("a collision");
        let begun = |s: &Collision| before.iter().map(|b| bodies(s, dt, *b)).collect::<Vec<_>>();
        let starts: Vec<Vec<Body>> = collisions.iter().flat_map(begun).collect();
        let text = deck(matter, collision, who.names(), (dt, steps), &starts);
        let frames = self.frames(&text, who)?;
        let read = |frame: &Frame, k: usize, start: &[Body]| -> Result<Outcome, CompareError> {
            let mut bodies = start.to_vec();
            for (c, body) in bodies.iter_mut().enumerate() {
                let id = (k * start.len() + c + 1) as i64;
                let three = |names: [&str; 3]| -> Result<Vector3<f64>, CompareError> {
                    let [x, y, z] = names.map(|name| frame.value(id, name));
                    Ok(Vector3::new(x?, y?, z?))
                };
                body.x =
                    three(["x", "y", "z"])? - Vector3::from(place(collision, starts.len(), (dt, steps), k));
                body.v = three(["vx", "vy", "vz"])?;
                body.omega = three(["omegax", "omegay", "omegaz"])?;
            }
            Ok(collisions[k / before.len()].judge(&bodies))
        };
        // A particle that left the box was collision out of it.
        let gone = || Outcome { energy: f64::INFINITY, apart: true, ..Outcome::default() };
        let all = starts.iter().enumerate().map(|(k, start)| {
            let mut last = Outcome::default();
            for (at, frame) in frames.iter().enumerate() {
                let most = if at == 0 { 0.0 } else { last.energy };
                last = match read(frame, k, start) {
                    Err(CompareError::NoParticle { .. }) => return Ok(gone()),
                    other => other?,
                };
                last.energy = last.energy.max(most);
            }
            Ok(last)
        });
        Ok(all.collect::<Result<_, CompareError>>()?)
    }

    /// Run a deck and read its dump.
    ///
    /// # Errors
    /// If LIGGGHTS fails or dumps nothing.
    fn frames(&self, text: &str, who: Who) -> Result<Vec<Frame>, LiveError> {
        let (folder, ran) = self.start(text, who)?;
        let dump = ran.dumps.first().ok_or(LiveError::NoDump)?;
        Ok(folder.frames(dump)?)
    }

    /// Run a deck; what it wrote is in the folder.
    ///
    /// # Errors
    /// If LIGGGHTS fails.
    pub fn start(&self, text: &str, who: Who) -> Result<(Folder, Ran), LiveError> {
        let folder = Folder::empty()?;
        let path = folder.path().join("contacts.in");
        std::fs::write(&path, text).map_err(|source| LiveError::Io { path: path.clone(), source })?;
        let deck = Deck::read(&path)?;
        let environment = match who {
            Who::Stock => Vec::new(),
            Who::TakenOver => Preload::new(&self.plugin, Laws::Rust).env(),
            Who::Own => Preload::new(&self.plugin, Laws::Own).env(),
        };
        let ran = run(&self.host, &Run { deck: &deck, environment, limit: self.limit }, &folder)?;
        Ok((folder, ran))
    }
}

/// What moves of a collision that begins `before` steps ahead.
fn bodies(collision: &Collision, dt: f64, before: f64) -> Vec<Body> {
    match collision.row() {
        Some(bonded) => ahead(collision, &bonded, dt),
        None => collision.start(dt, before, 0).bodies[..if collision.wall { 1 } else { 2 }].to_vec(),
    }
}

/// How far a body goes if nothing stops it \[m\].
fn travel(collision: &Collision, (dt, steps): (f64, u64)) -> f64 {
    collision.speed.hypot(collision.slide) * dt * steps as f64
}

/// How far collisions are apart, and how many there are in a row.
fn grid(collision: &Collision, count: usize, run: (f64, u64)) -> (f64, usize) {
    let largest = collision.radius * collision.ratio.max(1.0);
    (6.0 * largest + 4.0 * travel(collision, run), (count as f64).sqrt().ceil() as usize)
}

/// Where a collision takes place.
fn place(collision: &Collision, count: usize, run: (f64, u64), k: usize) -> [f64; 3] {
    let (apart, side) = grid(collision, count, run);
    let [a, b] = [k % side, k / side].map(|n| (n as f64 + 0.5) * apart);
    if collision.wall {
        [a, b, 0.0]
    } else {
        [0.0, a, b]
    }
}

/// A deck with all collisions beside each other, far enough apart.
fn deck(
    matter: &Matter,
    collision: &Collision,
    names: Names,
    (dt, steps): (f64, u64),
    starts: &[Vec<Body>],
) -> String {
    let (apart, side) = grid(collision, starts.len(), (dt, steps));
    // Who leaves the box has a hundred times the energy, or nearly.
    let long =
        collision.row().map_or(0.0, |t| 2.5 * collision.radius * collision.ratio.max(1.0) * t.beads as f64);
    let (edge, high) = (side as f64 * apart, 0.5 * apart + 10.0 * travel(collision, (dt, steps)) + long);
    let region = match collision.wall {
        true => format!("0 {edge:?} 0 {edge:?} {:?} {high:?}", -0.1 * apart),
        false => format!("{:?} {high:?} 0 {edge:?} 0 {edge:?}", -high),
    };
    // What comes loose may fly far, and bins are made for all of the box.
    let search = if collision.row().is_some() { "nsq" } else { "bin" };
    let (models, switches) = (matter.models(names), matter.switches(names));
    let mut out = format!(
        "units si\natom_style granular\natom_modify map array sort 0 0\nboundary f f f\nnewton off\n\
         communicate single vel yes\nregion box block {region} units box\ncreate_box 1 box\n\
         neighbor {:?} {search}\nneigh_modify delay 0\n{}pair_style gran {models}{switches}\npair_coeff * *\n",
        0.2 * collision.radius,
        matter.properties(),
    );
    if collision.wall {
        out += &format!("fix floor all wall/gran {models} primitive type 1 zplane 0.0{switches}\n");
    }
    if let Some(rest) = collision.rest {
        let down = -rest.gravity.signum();
        out += &format!("fix weight all gravity {:?} vector 0 0 {down}\n", rest.gravity.abs());
    }
    let moved = |k: usize, b: &Body| Body {
        x: b.x + Vector3::from(place(collision, starts.len(), (dt, steps), k)),
        ..*b
    };
    let bodies: Vec<Body> =
        starts.iter().enumerate().flat_map(|(k, all)| all.iter().map(move |b| moved(k, b))).collect();
    for b in &bodies {
        out += &format!("create_atoms 1 single {:?} {:?} {:?}\n", b.x.x, b.x.y, b.x.z);
    }
    for (k, b) in bodies.iter().enumerate() {
        let (id, v, w) = (k + 1, b.v, b.omega);
        out += &format!("set atom {id} diameter {:?} density {:?}\n", 2.0 * b.radius, collision.density);
        out += &format!("set atom {id} vx {:?} vy {:?} vz {:?}\n", v.x, v.y, v.z);
        out += &format!("set atom {id} omegax {:?} omegay {:?} omegaz {:?}\n", w.x, w.y, w.z);
    }
    let format = format!("%d{}", " %.17g".repeat(9));
    // Of rows, the energy on the way is asked for too.
    let every = if collision.row().is_some() { every(steps) } else { 1 };
    let dump = format!(
        "dump all all custom {every} dump.txt id x y z vx vy vz omegax omegay omegaz\ndump_modify all format \"{format}\" sort id\n"
    );
    let [before, after] =
        if collision.row().is_some() { [dump, String::new()] } else { [String::new(), dump + "run 0\n"] };
    out + &format!(
        "{before}timestep {dt:?}\nfix move all nve/sphere\nthermo {steps}\nthermo_modify lost ignore norm no\nrun {steps}\n{after}"
    )
}
