//! Spheres, chains and impacts for the closed forms.
use granlaw::chain::Chain;
use granlaw::laws::find;
use granlaw::model::{Body, Kind, Settings, Setup, Shape, Values};
use granlaw::pair::{run, Opened, Partner, Start};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// Property values by name; of one per type, the first is the particle's and the second the wall's.
pub type Given<'a> = &'a [(&'a str, [f64; 2])];

/// A law with the values that it asks for, two atom types.
pub fn law(kind: Kind, name: &str, given: Given<'_>, chosen: &[(&str, &str)]) -> Setup {
    let law = find(kind, name).expect("a law");
    let (meta, mut settings) = (law.meta, Settings::new(law, false));
    for (name, option) in chosen.iter().filter(|(n, _)| meta.settings.iter().any(|s| s.name == *n)) {
        settings.set(name, option).unwrap();
    }
    let of = |name: &str| given.iter().find(|(n, _)| *n == name).map(|(_, v)| *v);
    let values = meta.props.iter().map(|p| match (of(p.name), p.shape) {
        (None, _) => vec![],
        (Some(v), Shape::Scalar) => vec![v[0]],
        (Some(v), Shape::PerType) => v.to_vec(),
        (Some(v), Shape::PerPair) => vec![v[0]; 4],
    });
    Setup { law, settings, values: Values { types: 2, of: values.collect() }, nktv2p: 1.0 }
}

/// A chain of a normal law and at most one law of each other kind, all from the same values.
pub fn chain(laws: &[(Kind, &str)], given: Given<'_>, chosen: &[(&str, &str)]) -> Chain {
    let setups: Vec<_> = laws.iter().map(|(kind, name)| law(*kind, name, given, chosen)).collect();
    for (name, _) in chosen {
        assert!(
            setups.iter().any(|s| s.law.meta.settings.iter().any(|k| k.name == *name)),
            "no setting {name}"
        );
    }
    Chain::packed(&setups).unwrap()
}

pub fn sphere(radius: f64, density: f64) -> Body {
    let mass = 4.0 / 3.0 * PI * radius.powi(3) * density;
    Body { tag: 1, radius, mass, ..Body::default() }
}

/// What an impact brought.
#[derive(Clone, Copy, Debug)]
pub struct Impact {
    /// Normal restitution; of an impact that has not ended, of no use.
    pub e: f64,
    /// From first touch to separation \[s\].
    pub duration: f64,
    /// From first touch to the last positive normal force \[s\].
    pub pushed: f64,
    /// Largest overlap \[m\] and normal force \[N\].
    pub overlap: f64,
    pub force: f64,
    /// Whether the surfaces are apart at the end.
    pub apart: bool,
    /// The state of i at the end.
    pub last: Body,
}

/// Two spheres along x or a sphere on the plane x = 0, just touching, with their motion as given.
pub fn start(bodies: [Body; 2], wall: bool, dt: f64, steps: u64) -> Start {
    let [mut i, mut j] = bodies;
    let plane = Partner::Plane { point: Vector3::zeros(), normal: Vector3::x() };
    (i.x, j.x) = (Vector3::x() * i.radius, Vector3::x() * -j.radius);
    j.tag = 2;
    Start {
        bodies: [i, j],
        types: (0, usize::from(wall)),
        partner: if wall { plane } else { Partner::Free },
        dt,
        steps,
        first: 0,
        gravity: Vector3::zeros(),
        opened: Opened::Keeps,
    }
}

/// Run and measure an impact that begins at first touch; a run without contact is a mistake of the test.
pub fn impact(chain: &mut Chain, start: &Start) -> Impact {
    let wall = start.partner != Partner::Free;
    let speed = |b: &[Body; 2]| b[0].v.x - if wall { 0.0 } else { b[1].v.x };
    let overlap = |b: &[Body; 2]| match wall {
        true => b[0].radius - b[0].x.x,
        false => b[0].radius + b[1].radius - (b[0].x - b[1].x).norm(),
    };
    let (mut out, mut before) = (None::<Impact>, 0.0);
    let mut end = start.bodies;
    run(chain, start, |s| {
        let (time, now) = ((s.step - start.first) as f64 * start.dt, overlap(&s.bodies));
        if s.touching {
            let o = out.get_or_insert(Impact {
                e: 0.0,
                duration: 0.0,
                pushed: 0.0,
                overlap: 0.0,
                force: 0.0,
                apart: false,
                last: s.bodies[0],
            });
            (o.overlap, o.force) = (o.overlap.max(now), o.force.max(s.response.fn_));
            o.pushed = if s.response.fn_ > 0.0 { time } else { o.pushed };
        } else if let Some(o) = out.as_mut().filter(|o| !o.apart) {
            // Surfaces part between two steps, with an all but constant velocity.
            o.duration = time + start.dt * now / (before - now);
        }
        if let Some(o) = &mut out {
            o.apart = !s.touching;
        }
        (before, end) = (now, s.bodies);
    });
    let mut out = out.expect("no contact");
    (out.e, out.last) = (-speed(&end) / speed(&start.bodies), end[0]);
    out
}

/// Stiffness of LIGGGHTS's linear spring \[N/m\], from its formula.
pub fn linear_stiffness(e_star: f64, r_star: f64, m_star: f64, vc: f64) -> f64 {
    let a = r_star.sqrt() * e_star;
    16.0 / 15.0 * a * (15.0 * m_star * vc.powi(2) / (16.0 * a)).powf(0.2)
}

/// `got` within `tolerance` of `expected`, relative to `scale`.
pub fn near(what: &str, got: f64, expected: f64, tolerance: f64, scale: f64) -> Result<(), String> {
    if (got - expected).abs() <= tolerance * scale.abs() {
        return Ok(());
    }
    Err(format!(
        "{what}: {got:.10e} instead of {expected:.10e}, off by {:e}",
        (got - expected).abs() / scale.abs()
    ))
}

/// The largest error of points on a curve.
pub fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().map(f64::abs).fold(0.0, f64::max)
}
