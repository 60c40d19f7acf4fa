//! `centredDamping` and `touchFraction`: by which power of the step errors fall with them, for a pair and for a wall.
use super::bench::{chain, impact, linear_stiffness, sphere, start};
use granlaw::model::{Body, Kind};
use nalgebra::Vector3;
use std::f64::consts::PI;

const R: f64 = 0.005;
const RHO: f64 = 2500.0;
const YOUNG: f64 = 5e6;
const NU: f64 = 0.45;
const PHASES: u32 = 128;

/// An impact.
#[derive(Clone, Copy)]
struct Collision {
    normal: &'static str,
    tangential: &'static str,
    e: f64,
    mu: f64,
    /// Normal velocity \[m/s\], and the tangential one over it. A slow impact is shallow: then the lever of the friction
    /// is all but constant. LIGGGHTS takes it at the end of the step, which is of first order in δ/R.
    v: f64,
    vt: f64,
    wall: bool,
}

/// Normal and tangential velocity afterwards over the normal one before.
type Rebound = [f64; 2];

impl Collision {
    fn duration(&self) -> f64 {
        let mass = sphere(R, RHO).mass;
        let (e_star, m, r) = match self.wall {
            true => (YOUNG / (2.0 * (1.0 - NU * NU)), mass, R),
            false => (YOUNG / (2.0 * (1.0 - NU * NU)), mass / 2.0, R / 2.0),
        };
        if self.normal == "hertz" {
            return 2.868265 * (m.powi(2) / (r * e_star * e_star * self.v)).powf(0.2);
        }
        PI * (m / linear_stiffness(e_star, r, m, 2.0)).sqrt() * (1.0 + (self.e.ln() / PI).powi(2)).sqrt()
    }

    fn fire(&self, chosen: &[(&str, &str)], dt: f64, before: f64) -> Rebound {
        let given = [
            ("youngsModulus", [YOUNG; 2]),
            ("poissonsRatio", [NU; 2]),
            ("characteristicVelocity", [2.0; 2]),
            ("coefficientRestitution", [self.e; 2]),
            ("coefficientFriction", [self.mu; 2]),
            ("coefficientMaxElasticStiffness", [5.0; 2]),
            ("coefficientAdhesionStiffness", [0.5; 2]),
            ("coefficientPlasticityDepth", [0.05; 2]),
        ];
        let laws = [(Kind::Normal, self.normal), (Kind::Tangential, self.tangential)];
        let mut laws = chain(&laws, &given, chosen);
        let half = if self.wall { 1.0 } else { 0.5 };
        let v = |s: f64| Vector3::new(-1.0, self.vt, 0.0) * (self.v * s);
        let body = |s: f64| Body { v: v(s), ..sphere(R, RHO) };
        let steps = (4.0 * self.duration() / dt) as u64;
        let mut start = start([body(half), body(-half)], self.wall, dt, steps);
        for body in &mut start.bodies {
            body.x -= body.v * (dt * before);
        }
        let out = impact(&mut laws, &start);
        assert!(out.apart);
        [out.e, out.last.v.y / self.v / half]
    }

    /// Mean over the phases of first touch within a step, with about `n` steps per contact.
    fn error(&self, chosen: &[(&str, &str)], n: f64, exact: Rebound) -> Rebound {
        let mut sum = [0.0; 2];
        for k in 0..PHASES {
            // By golden fractions, so that where the contact ends within a step is spread as evenly as its begin.
            let more = (f64::from(k) * 0.618_033_988_749_895).fract();
            let before = (f64::from(k) + 0.5) / f64::from(PHASES);
            let got = self.fire(chosen, self.duration() / (n + more), before);
            (0..2).for_each(|c| sum[c] += (got[c] - exact[c]).abs() / f64::from(PHASES));
        }
        sum
    }

    /// Converged: 40,000 steps per contact with both settings; `chosen` is what else is.
    fn exact(&self, chosen: &[(&str, &str)]) -> Rebound {
        let dt = self.duration() / 40_000.0;
        let both = [("centredDamping", "on"), ("touchFraction", "on")];
        let chosen: Vec<_> =
            chosen.iter().copied().filter(|(n, _)| *n == "tangential_damping").chain(both).collect();
        let all = [0.1, 0.3, 0.5, 0.7, 0.9].map(|b| self.fire(&chosen, dt, b));
        [0, 1].map(|c| all.iter().map(|r| r[c]).sum::<f64>() / 5.0)
    }
}

/// The power of the step by which the errors fall from `n` to `8 n` steps.
fn orders(shot: &Collision, chosen: &[(&str, &str)], n: f64) -> Rebound {
    let exact = shot.exact(chosen);
    let (coarse, fine) = (shot.error(chosen, n, exact), shot.error(chosen, 8.0 * n, exact));
    [0, 1].map(|c| (coarse[c] / fine[c]).log2() / 3.0)
}

/// A claim: the shot, whether γt is on, from which number of steps the orders show, and the orders of both velocities.
type Claim = (&'static str, Collision, &'static str, f64, [f64; 2]);

const BASE: Collision =
    Collision { normal: "hooke", tangential: "history", e: 0.5, mu: 5.0, v: 0.02, vt: 0.5, wall: false };
const HEAD_ON: Collision = Collision { vt: 0.0, ..BASE };
const SLIP: Collision = Collision { mu: 0.2, vt: 3.0, ..BASE };
const STICK_SLIP: Collision = Collision { mu: 0.4, vt: 0.8, e: 0.7, ..BASE };
const HERTZ: Collision = Collision { normal: "hertz", ..HEAD_ON };
const YIELDING: Collision = Collision { normal: "hooke/hysteresis", e: 0.9, v: 0.5, ..HEAD_ON };
const VISCOUS: Collision = Collision { tangential: "no_history", mu: 1e3, ..BASE };

const CLAIMS: [Claim; 13] = [
    ("head-on, undamped", Collision { e: 1.0, ..HEAD_ON }, "on", 25.0, [4.0, 0.0]),
    ("head-on, e = 0.9", Collision { e: 0.9, ..HEAD_ON }, "on", 400.0, [2.0, 0.0]),
    ("head-on, e = 0.5", HEAD_ON, "on", 100.0, [2.0, 0.0]),
    ("hertz, e = 0.9", Collision { e: 0.9, ..HERTZ }, "on", 200.0, [2.0, 0.0]),
    ("hertz, e = 0.5", HERTZ, "on", 200.0, [2.0, 0.0]),
    ("hysteresis, adhesive, e = 0.9", YIELDING, "on", 200.0, [2.0, 0.0]),
    ("stick, undamped", Collision { e: 1.0, mu: 1e9, ..BASE }, "on", 50.0, [4.0, 2.0]),
    ("stick without γt", BASE, "off", 200.0, [2.0, 2.0]),
    ("slip", SLIP, "on", 200.0, [2.0, 2.0]),
    ("slip without γt", SLIP, "off", 200.0, [2.0, 2.0]),
    ("stick and slip without γt", STICK_SLIP, "off", 100.0, [2.0, 2.0]),
    ("viscous friction", VISCOUS, "on", 100.0, [2.0, 2.0]),
    ("viscous friction that slips", Collision { mu: 0.2, vt: 3.0, ..VISCOUS }, "on", 100.0, [2.0, 2.0]),
];

const BOTH: [(&str, &str); 2] = [("centredDamping", "on"), ("touchFraction", "on")];

/// The orders of a claim under some settings, pair and wall.
fn hold((what, shot, damped, n, claimed): &Claim, settings: &[(&str, &str)]) -> Result<(), String> {
    let chosen: Vec<_> = settings.iter().copied().chain([("tangential_damping", *damped)]).collect();
    for wall in [false, true] {
        let got = orders(&Collision { wall, ..*shot }, &chosen, *n);
        // Orders above 2 come from terms that vanish sooner or, across a rotating normal, later than the others.
        let tells = |c: usize| claimed[c] > 0.0 && (claimed[c] == 2.0 || wall);
        if let Some(c) = (0..2).find(|c| tells(*c) && (got[*c] - claimed[*c]).abs() > 0.2) {
            return Err(format!(
                "{what}, wall {wall}: order {} of velocity {c} instead of {}",
                got[c], claimed[c]
            ));
        }
    }
    Ok(())
}

#[test]
fn with_both_settings_errors_fall_as_claimed() {
    for claim in &CLAIMS {
        hold(claim, &BOTH).unwrap();
    }
}

/// Planted: a first-order method under a label of second order.
#[test]
fn stock_and_either_setting_alone_are_not_what_both_claim() {
    for claim in CLAIMS.iter().filter(|c| c.1.e < 1.0) {
        for settings in [&BOTH[..0], &BOTH[..1], &BOTH[1..]] {
            let error = hold(claim, settings).expect_err("no fault seen");
            assert!(error.contains("instead of"), "{}: {error}", claim.0);
        }
    }
}

/// Where the order stays one, the error does not: the law's own jumps, met at unknown times, are what is left.
#[test]
fn damped_stick_and_slip_get_better_without_a_higher_order() {
    // How many times smaller the error of the tangential velocity is at 200 steps per contact.
    for (shot, better) in [(BASE, 100.0), (SLIP, 20.0), (STICK_SLIP, 2.0)] {
        for wall in [false, true] {
            let shot = Collision { wall, ..shot };
            let exact = shot.exact(&[]);
            let [stock, both] = [&[][..], &BOTH].map(|settings| shot.error(settings, 200.0, exact)[1]);
            assert!(stock > better * both, "{}: {stock:e} against {both:e}", shot.vt);
        }
    }
}
