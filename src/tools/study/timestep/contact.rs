//! One kind of contact: two types, or a type and a wall.
use super::accurate::{accurate, Search};
use super::bond;
use super::limit::{Asked, Contact, Limit};
use crate::probe::{Contacts, Fastest, ParticleType, TypePair};
use crate::study::collision::Collision;
use crate::study::modes::{reached, Modes};
use crate::trace::{Header, LawSpec};
use granlaw::chain::Chain;
use granlaw::laws::prop;
use granlaw::model::Kind;
use granlaw::model::Mode;

/// Every kind of contact of a chain for which there are particles.
pub(super) fn of_chain(
    c: &Contacts,
    grains: &[ParticleType],
    asked: &Asked,
    notes: &mut Vec<String>,
) -> Vec<Contact> {
    let mut header = c.header.clone();
    if let Some(law) = header.laws.iter().find(|l| !l.known) {
        notes.push(format!(
            "{}: {} {} is left out, as granlaw has no such law",
            header.who, law.kind, law.keyword
        ));
    }
    // A bond replaces the force of the other laws, so the two are looked at separately.
    let mut bonds = Header { laws: header.bonds().cloned().into_iter().collect(), ..header.clone() };
    header.laws.retain(|l| l.known && !bonds.laws.contains(l));
    bonds.laws.retain(|l| l.known);
    if !header.laws.iter().any(|l| l.kind == Kind::Normal.name() || l.kind == Kind::Cohesion.name()) {
        notes.push(format!("{}: no law along the normal is known, so nothing can be said", header.who));
        return Vec::new();
    }
    if let Err(e) = header.chain() {
        notes.push(format!("{}: {e}", header.who));
        return Vec::new();
    }
    let mut bonds = (!bonds.laws.is_empty()).then(|| bonds.chain().ok()).flatten();
    let wall = header.who != "pair";
    let of = |kind: usize| grains.iter().find(|g| g.kind as usize == kind);
    let mut all = Vec::new();
    for i in 1..=header.types {
        // The material of a wall is the one that the scene has shown; if nothing has touched it yet, it may be any.
        let met = |j: usize| c.pairs.iter().any(|p| p.types == [i, j]);
        let partners: Vec<usize> = match wall {
            false => (i..=header.types).filter(|j| of(*j).is_some()).collect(),
            true if (1..=header.types).any(met) => (1..=header.types).filter(|j| met(*j)).collect(),
            true => (1..=header.types).collect(),
        };
        let Some(gi) = of(i) else { continue };
        for j in partners {
            let pair = (gi, if wall { None } else { of(j) });
            let seen = c.pairs.iter().find(|p| p.types == [i, j]);
            let speed = asked.speed.unwrap_or(fastest(seen, pair));
            let speed = if speed > 0.0 { speed } else { assumed(&header, notes) };
            all.extend(one(c, &header, [i, j], pair, speed, asked.accuracy));
            if let Some(chain) = &mut bonds {
                let laws = c.header.bonds().map_or(String::new(), name);
                all.extend(bond::of(chain, (&header.who, &laws), [i, j], pair, speed, asked));
            }
        }
    }
    all
}

/// The largest speed at which bodies of these types can meet \[m/s\].
fn fastest(seen: Option<&TypePair>, (gi, gj): (&ParticleType, Option<&ParticleType>)) -> f64 {
    let hardest = seen.and_then(|p| p.impact_speed.range()).map_or(0.0, |(_, most)| most);
    hardest.max(gi.fastest + gj.map_or(0.0, |g| g.fastest))
}

fn one(
    c: &Contacts,
    header: &Header,
    types: [usize; 2],
    (gi, gj): (&ParticleType, Option<&ParticleType>),
    speed: f64,
    accuracy: f64,
) -> Option<Contact> {
    let seen = c.pairs.iter().find(|p| p.types == types);
    let chain = || header.chain().expect("it was made before");
    // The smallest spheres oscillate fastest, but for some laws a large partner is worse.
    let ends = |g: Option<&ParticleType>| g.map_or(vec![0.0], |g| g.radius.to_vec());
    let sizes = ends(Some(gi)).into_iter().flat_map(|ri| ends(gj).into_iter().map(move |rj| [ri, rj]));
    let collisions = sizes.map(|[ri, rj]| Collision {
        ratio: if gj.is_some() { rj / ri } else { 1.0 },
        heavier: gj.map_or(1.0, |g| g.density[0] / gi.density[0]),
        types: (types[0] - 1, types[1] - 1),
        wall: gj.is_none(),
        ..Collision::head_on(ri, gi.density[0], speed)
    });
    let centred = centred(header);
    let looked = collisions.map(|s| {
        let modes = reached(&mut chain(), &mut chain(), &s);
        (s, modes, limit("normal", modes.normal, centred).critical)
    });
    let (collision, modes, _) = looked.min_by(|a, b| a.2.total_cmp(&b.2))?;
    let mut limits = vec![limit("normal", modes.normal, centred)];
    if modes.tangential.stiffness > 0.0 || modes.tangential.damping > 0.0 {
        limits.push(limit("tangential", modes.tangential, centred));
    }
    // A bond is infinitely stiff where its compression begins, so the fastest contact of the scene is not usable.
    let fastest = seen.filter(|_| c.header.bonds().is_none()).and_then(|p| met(&p.fastest));
    limits.extend(fastest.map(|m| limit("met in the scene", m, centred)));
    Some(Contact {
        who: header.who.clone(),
        types,
        laws: names(header),
        speed,
        radii: [collision.radius, if collision.wall { 0.0 } else { collision.radius * collision.ratio }],
        accurate: try_out(&mut chain(), &collision, &modes, accuracy),
        together: None,
        limits,
    })
}

fn try_out(chain: &mut Chain, collision: &Collision, modes: &Modes, accuracy: f64) -> Option<f64> {
    let longest = modes.normal.step_centred();
    let search = Search { longest, period: modes.period, accuracy };
    if longest.is_finite() {
        accurate(chain, collision, &search)
    } else {
        None
    }
}

fn limit(name: &'static str, mode: Mode, centred: bool) -> Limit {
    // With `centredDamping` a mode is as stable as without damping.
    let bears = if centred { Mode { damping: 0.0, ..mode } } else { mode };
    Limit { name, turns: false, mode, critical: bears.step(), safe: bears.safe() }
}

fn met(f: &Fastest) -> Option<Mode> {
    (f.stiffness > 0.0).then_some(Mode { stiffness: f.stiffness, damping: f.damping, mass: f.meff })
}

fn centred(header: &Header) -> bool {
    header.laws.iter().any(|l| l.settings.get("centredDamping").is_some_and(|o| o == "on"))
}

fn names(header: &Header) -> String {
    header.laws.iter().map(name).collect::<Vec<_>>().join(" + ")
}

fn name(l: &LawSpec) -> String {
    format!("{}{}", l.keyword, if l.taken_over { "" } else { "/rs" })
}

/// The speed that is assumed if nothing moves \[m/s\].
fn assumed(header: &Header, notes: &mut Vec<String>) -> f64 {
    let properties = || header.laws.iter().flat_map(|l| &l.properties);
    let named = properties().find(|p| p.name == prop::CHARACTERISTIC_VELOCITY.name);
    let (speed, why) = match named.and_then(|p| p.values.first()) {
        Some(v) => (*v, "characteristicVelocity"),
        None => (1.0, "a guess"),
    };
    let note =
        format!("nothing moves yet: impacts at {speed} m/s are looked at ({why}); say better with --speed");
    if !notes.contains(&note) {
        notes.push(note);
    }
    speed
}
