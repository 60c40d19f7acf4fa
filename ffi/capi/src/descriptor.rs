//! `LAWS` as C sees them, built once and kept for ever.
use crate::abi::*;
use crate::c_string;
use granlaw::laws::LAWS;
use granlaw::model::{AtomProp, Entry, Kind, Need, Newton, Prop, Reach, Setting, Shape, Slot, Support};
use std::ffi::c_char;
use std::sync::OnceLock;

struct Table(Vec<granlaw_law>);
// SAFETY: the pointers lead to leaked, never changed memory.
unsafe impl Send for Table {}
// SAFETY: as above.
unsafe impl Sync for Table {}

/// One descriptor per law, in the order of `LAWS`.
pub fn table() -> &'static [granlaw_law] {
    static TABLE: OnceLock<Table> = OnceLock::new();
    &TABLE.get_or_init(|| Table(LAWS.iter().map(law).collect())).0
}

fn text(s: &str) -> *const c_char {
    c_string(s).into_raw()
}

fn law(e: &Entry) -> granlaw_law {
    let (m, b) = (e.meta, e.liggghts);
    let props: &[granlaw_prop] = Vec::leak(m.props.iter().map(prop).collect());
    let settings: &[granlaw_setting] =
        Vec::leak(e.settings().map(|s| setting(s, e.support(s.name))).collect());
    let atoms: &[granlaw_atom_prop] = Vec::leak(m.atoms.iter().map(atom).collect());
    let outputs: &[granlaw_atom_prop] = Vec::leak(m.outputs.iter().map(atom).collect());
    let slots: &[granlaw_slot] = Vec::leak(m.slots.iter().map(slot).collect());
    granlaw_law {
        kind: match m.kind {
            Kind::Normal => GRANLAW_NORMAL,
            Kind::Cohesion => GRANLAW_COHESION,
            Kind::Tangential => GRANLAW_TANGENTIAL,
            Kind::Rolling => GRANLAW_ROLLING,
        } as i32,
        keyword: text(m.keyword),
        own_keyword: text(&m.called(false)),
        id: b.id.into(),
        stock_id: b.stock_id.map_or(-1, i32::from),
        summary: text(m.summary),
        stress_strain_exponent: m.stress_strain_exponent,
        beyond_contact: m.reach == Reach::Beyond,
        coarse_graining: m.coarse_graining,
        props: props.as_ptr(),
        n_props: props.len(),
        settings: settings.as_ptr(),
        n_settings: settings.len(),
        atoms: atoms.as_ptr(),
        n_atoms: atoms.len(),
        outputs: outputs.as_ptr(),
        n_outputs: outputs.len(),
        anchors: m.anchors,
        bonds: m.bonds.map_or(std::ptr::null(), text),
        slots: slots.as_ptr(),
        n_slots: slots.len(),
    }
}

fn prop(p: &Prop) -> granlaw_prop {
    granlaw_prop {
        name: text(p.name),
        symbol: text(p.symbol),
        unit: text(p.unit.label),
        doc: text(p.doc),
        shape: match p.shape {
            Shape::Scalar => GRANLAW_SCALAR,
            Shape::PerType => GRANLAW_PER_TYPE,
            Shape::PerPair => GRANLAW_PER_PAIR,
        } as i32,
        lo: p.range.lo,
        hi: p.range.hi,
        open_lo: p.range.open_lo,
        open_hi: p.range.open_hi,
        usual_lo: p.usual.0,
        usual_hi: p.usual.1,
    }
}

fn setting(s: &Setting, support: Support) -> granlaw_setting {
    let options: &[*const c_char] = Vec::leak(s.options.iter().map(|o| text(o)).collect());
    granlaw_setting {
        name: text(s.name),
        options: options.as_ptr(),
        n_options: options.len(),
        default_option: s.default.and_then(|d| s.index(d)).map_or(-1, |k| k as i32),
        support: match support {
            Support::Full => GRANLAW_SUPPORT_FULL,
            Support::OwnOnly => GRANLAW_SUPPORT_OWN_ONLY,
            Support::StockIgnores => GRANLAW_SUPPORT_STOCK_IGNORES,
            Support::Refused => GRANLAW_SUPPORT_REFUSED,
        } as i32,
        doc: text(s.doc),
    }
}

fn atom(a: &AtomProp) -> granlaw_atom_prop {
    granlaw_atom_prop { name: text(a.name), doc: text(a.doc), place: a.place }
}

fn slot(s: &Slot) -> granlaw_slot {
    let newton = match s.newton {
        Newton::Even => "0",
        Newton::Odd => "1",
    };
    granlaw_slot {
        name: text(s.name),
        newton: text(newton),
        unit: text(s.unit.label),
        always: s.need == Need::Always,
    }
}
