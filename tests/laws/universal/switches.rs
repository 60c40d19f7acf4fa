//! hooke/hysteresis at each of its branch switches, from both sides, against the force that the equations give there.
use super::recipe::{placed, Fault, Recipe, Subject};
use super::refusals::sound;
use granlaw::laws::find;
use granlaw::model::*;
use nalgebra::Vector3;

/// A pair with k2max/kn = 5, kc/kn = 0.5, φF = 0.05 and no dashpot.
struct Bench {
    subject: Subject,
    x: Contact,
    kn: f64,
    delta_lim: f64,
}

const K2MAX: f64 = 5.0;
const KC: f64 = 0.5;

impl Bench {
    fn new(chosen: &[(&str, &str)], fault: Option<Fault>) -> Bench {
        let mut setup = sound(find(Kind::Normal, "hooke/hysteresis").unwrap(), chosen);
        for (p, v) in setup.law.meta.props.iter().zip(&mut setup.values.of) {
            match p.name {
                "coefficientRestitution" => v.fill(1.0),
                "coefficientMaxElasticStiffness" => v.fill(K2MAX),
                "coefficientAdhesionStiffness" => v.fill(KC),
                "coefficientPlasticityDepth" => v.fill(0.05),
                _ => {}
            }
        }
        let body = |tag| Body { tag, radius: 5e-3, mass: 1e-3, ..Body::default() };
        let call = Call { dt: 1e-6, step: 1, update: false, ..Call::default() };
        let x = placed(call, body(1), body(2), Vector3::x(), 1e-5);
        let mut subject = Recipe { setups: vec![setup], fault }.subject();
        let kn = subject.surfaces_intersect((0, 0), &x, &mut [0.0]).kn;
        // (2) with R* = 2.5 mm.
        Bench { subject, x, kn, delta_lim: K2MAX / (K2MAX - 1.0) * 0.05 * 5e-3 }
    }

    fn at(&self, deltan: f64) -> Contact {
        let mut x = self.x;
        x.surface.deltan = deltan;
        x
    }

    fn force(&mut self, (deltan, delta_max): (f64, f64)) -> (f64, &'static str) {
        let x = self.at(deltan);
        let branch = self.subject.observe((0, 0), &x, &[delta_max]).branch;
        (self.subject.surfaces_intersect((0, 0), &x, &mut [delta_max]).fn_, branch)
    }

    /// k2 over kn at a largest overlap (4).
    fn k2(&self, delta_max: f64) -> f64 {
        1.0 + (K2MAX - 1.0) * (delta_max / self.delta_lim).min(1.0)
    }

    /// Overlap and largest overlap on either side of a switch, the branches to be met there, and the force over kn.
    fn switch(
        &mut self,
        before: (f64, f64),
        after: (f64, f64),
        branches: [&str; 2],
        force: f64,
    ) -> Result<(), String> {
        let (a, b) = (self.force(before), self.force(after));
        if [a.1, b.1] != branches {
            return Err(format!("branches {:?} instead of {branches:?}", [a.1, b.1]));
        }
        // The sides lie 1e-9 of the overlap from the switch, the stiffest line is 5 kn.
        let tolerance = 1e-8 * self.kn * before.0;
        match [a.0, b.0].into_iter().find(|f| (f - force * self.kn).abs() > tolerance) {
            None => Ok(()),
            Some(f) => Err(format!("force {f:e} instead of {:e}", force * self.kn)),
        }
    }
}

const NEAR: f64 = 1e-9;

/// Unloading and reloading through δmax below the plastic limit.
fn loading_and_unloading(b: &mut Bench) -> Result<(), String> {
    let m = 0.6 * b.delta_lim;
    b.switch((m * (1.0 + NEAR), m), (m * (1.0 - NEAR), m), ["loading", "unloading"], m)
}

/// Out along k2 onto the adhesive line, below and above the limit.
fn unloading_and_adhesion(b: &mut Bench) -> Result<(), String> {
    for part in [0.3, 0.9, 1.0, 1.7] {
        let m = part * b.delta_lim;
        let k2 = b.k2(m);
        let d = (k2 - 1.0) * m.min(b.delta_lim) / (k2 + KC);
        b.switch((d * (1.0 + NEAR), m), (d * (1.0 - NEAR), m), ["unloading", "adhesive"], -KC * d)?;
    }
    Ok(())
}

/// Loading through the plastic limit, and a memory that passes it at a fixed overlap on either line.
fn the_plastic_limit(b: &mut Bench) -> Result<(), String> {
    let l = b.delta_lim;
    b.switch((l * (1.0 - NEAR), 0.0), (l * (1.0 + NEAR), 0.0), ["loading", "unloading"], l)?;
    let d = 0.9 * l;
    let line = K2MAX * (d - l) + l;
    b.switch((d, l * (1.0 - NEAR)), (d, l * (1.0 + NEAR)), ["unloading"; 2], line)?;
    let d = 0.5 * l;
    b.switch((d, l * (1.0 - NEAR)), (d, l * (1.0 + NEAR)), ["adhesive"; 2], -KC * d)
}

/// Turning round on the adhesive line: the memory was lowered there (6′), so that reloading starts at the same force.
fn reloading_from_adhesion(b: &mut Bench) -> Result<(), String> {
    for (part, memory) in [(0.3, 0.8), (0.1, 0.5), (0.4, 1.0), (0.3, 1.5)] {
        let d = part * b.delta_lim;
        let (mut x, mut h) = (b.at(d), [memory * b.delta_lim]);
        x.close.call.update = true;
        b.subject.surfaces_intersect((0, 0), &x, &mut h);
        if h[0] >= memory * b.delta_lim {
            return Err(format!("δmax stays at {:e}", h[0]));
        }
        b.switch((d * (1.0 - NEAR), h[0]), (d * (1.0 + NEAR), h[0]), ["adhesive", "unloading"], -KC * d)?;
    }
    Ok(())
}

/// A force about to attract is cut off at nothing.
fn limited(b: &mut Bench) -> Result<(), String> {
    let m = 0.6 * b.delta_lim;
    let k2 = b.k2(m);
    let d = (k2 - 1.0) * m / k2;
    b.switch((d * (1.0 + NEAR), m), (d * (1.0 - NEAR), m), ["unloading"; 2], 0.0)?;
    b.switch((0.5 * d, m), (0.4 * d, m), ["adhesive"; 2], 0.0)
}

type Walk = fn(&mut Bench) -> Result<(), String>;
const WALKS: [Walk; 4] =
    [loading_and_unloading, unloading_and_adhesion, the_plastic_limit, reloading_from_adhesion];

#[test]
fn forces_meet_at_every_switch() {
    for walk in WALKS {
        walk(&mut Bench::new(&[], None)).unwrap();
    }
    limited(&mut Bench::new(&[("limitForce", "on")], None)).unwrap();
}

#[test]
fn a_line_that_misses_its_end_is_seen_at_every_switch() {
    let loose = Fault::Touch(|x, h, _, s| s.fn_ += 1e-4 * s.kn * (h[0] - x.surface.deltan).abs().min(1e-6));
    // Where overlap and memory meet, nothing is added; everywhere else it is.
    assert!(loading_and_unloading(&mut Bench::new(&[], Some(loose))).is_ok());
    for walk in &WALKS[1..] {
        assert!(walk(&mut Bench::new(&[], Some(loose))).unwrap_err().contains("force"));
    }
    let stiff = Fault::Touch(|_, _, _, s| s.fn_ *= 1.001);
    for walk in WALKS {
        assert!(walk(&mut Bench::new(&[], Some(stiff))).unwrap_err().contains("force"));
    }
    // limitForce that is not done.
    assert!(limited(&mut Bench::new(&[], None)).unwrap_err().contains("force"));
}
