//! Simpler chains: what can be left out of a chain of laws, or put in place of one.
use crate::trace::{Header, LawSpec, Property};
use granlaw::laws::{prop, LAWS};
use granlaw::model::{Entry, Kind, Settings};
use serde::Serialize;

/// One change to the laws.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// No law of this kind.
    Off(#[serde(serialize_with = "kind")] Kind),
    /// Another law of this kind, by its keyword.
    Law(#[serde(serialize_with = "kind")] Kind, &'static str),
    /// The settings that make the time integration second order, which only our own names know.
    Timed,
}

fn kind<S: serde::Serializer>(k: &Kind, s: S) -> Result<S::Ok, S::Error> {
    s.serialize_str(k.name())
}

/// The settings of [`Change::Timed`].
const TIMED: [&str; 2] = [prop::CENTRED_DAMPING.name, prop::TOUCH_FRACTION.name];
/// Properties that are fitted to the scene where a law needs them: they describe an effect, not a material.
pub(super) const FITTED: [&str; 2] = [prop::RESTITUTION.name, prop::CHARACTERISTIC_VELOCITY.name];

impl Change {
    /// The kind of law that is changed; `None` if all are.
    pub fn of(&self) -> Option<Kind> {
        match self {
            Change::Off(k) | Change::Law(k, _) => Some(*k),
            Change::Timed => None,
        }
    }

    /// In words, for instance `no rolling law`.
    pub fn name(&self) -> String {
        match self {
            Change::Off(k) => format!("no {} law", k.name()),
            Change::Law(k, law) => format!("{} {law}", k.name()),
            Change::Timed => "second-order settings".into(),
        }
    }

    /// The chain with this change; `None` if it would change nothing or is not possible.
    pub fn apply(&self, from: &Header) -> Option<Header> {
        let mut to = from.clone();
        match self {
            Change::Off(k) => to.laws.retain(|l| l.kind() != Some(*k)),
            Change::Law(k, keyword) => {
                let at = to.laws.iter().position(|l| l.kind() == Some(*k))?;
                let entry = granlaw::laws::find(*k, keyword)?;
                to.laws[at] = law(entry, &from.laws[at], from)?;
            }
            Change::Timed => to.laws.iter_mut().for_each(|l| {
                let known = l.kind().and_then(|k| granlaw::laws::find(k, &l.keyword));
                let known = known.map_or(&[][..], |e| e.meta.settings);
                for s in known.iter().filter(|s| TIMED.contains(&s.name)) {
                    l.settings.insert(s.name.into(), "on".into());
                    l.taken_over = false;
                }
            }),
        }
        repack(&mut to);
        (to != *from && !to.laws.is_empty()).then_some(to)
    }
}

/// Every change that makes one of these chains simpler, or its time integration better.
pub fn simpler(chains: &[Header]) -> Vec<Change> {
    let laws = |k: Kind| chains.iter().flat_map(move |h| h.law(k));
    let mut all = Vec::new();
    for k in [Kind::Rolling, Kind::Cohesion, Kind::Tangential, Kind::Normal] {
        if laws(k).next().is_none() {
            continue;
        }
        for meta in LAWS.iter().map(|e| e.meta).filter(|m| m.kind == k) {
            // A law with less history is simpler; a normal law with as much counts too.
            let slots = laws(k).map(slots).min().unwrap_or(0);
            let less = meta.slots.len() < slots || (k == Kind::Normal && meta.slots.len() == slots);
            if less && laws(k).all(|l| l.keyword != meta.keyword) {
                all.push(Change::Law(k, meta.keyword));
            }
        }
        if k != Kind::Normal {
            all.push(Change::Off(k));
        }
    }
    all.push(Change::Timed);
    all.retain(|c| chains.iter().any(|h| c.apply(h).is_some()));
    all
}

fn slots(l: &LawSpec) -> usize {
    l.kind().and_then(|k| granlaw::laws::find(k, &l.keyword)).map_or(0, |e| e.meta.slots.len())
}

/// Puts a law in the place of another. It takes over the settings that both know, and its properties come from the whole chain.
fn law(law: &'static Entry, old: &LawSpec, chain: &Header) -> Option<LawSpec> {
    let meta = law.meta;
    let mut settings = Settings::new(law, old.taken_over);
    for (name, option) in &old.settings {
        // Settings that the new law does not know are left out.
        let _ = settings.set(name, option);
    }
    let given = |name: &str| chain.laws.iter().flat_map(|l| &l.properties).find(|p| p.name == name);
    let mut properties = Vec::new();
    for p in meta.props.iter().filter(|p| settings.need(p.need)) {
        let fitted = || {
            FITTED.contains(&p.name).then(|| vec![(p.usual.0 * p.usual.1).sqrt(); p.shape.len(chain.types)])
        };
        let values = given(p.name).map(|g| g.values.clone()).or_else(fitted)?;
        let (name, unit, shape) = (p.name.into(), p.unit.label.into(), p.shape.keyword().into());
        properties.push(Property { name, unit, shape, values });
    }
    Some(LawSpec {
        kind: old.kind.clone(),
        keyword: meta.keyword.into(),
        taken_over: old.taken_over,
        known: true,
        offset: 0,
        settings: settings.chosen().map(|(n, o)| (n.to_string(), o.to_string())).collect(),
        properties,
    })
}

/// Lays the histories of the laws one behind the other.
fn repack(h: &mut Header) {
    h.slots.clear();
    for l in &mut h.laws {
        l.offset = h.slots.len();
        let meta = l.kind().and_then(|k| granlaw::laws::find(k, &l.keyword)).map(|e| e.meta);
        h.slots.extend(meta.iter().flat_map(|m| m.slots).map(|s| s.name.to_string()));
    }
}
