//! Writes what the C++ half sees of a chain into a trace. The structs are those of `cpp/boundary.h`.
use crate::boundary::{
    granlaw_recorded_call, granlaw_recorded_chain, granlaw_recorded_law, granlaw_recorded_particles,
};
use granlaw::laws::LAWS;
use granlaw::model::{ClosePair, Settings, Surface};
use granlaw_capi::abi::granlaw_status;
use granlaw_capi::convert::{contact, parted, settings, slice};
use granlaw_capi::status::{boundary, Failure};
use granlaw_tools::trace::{Handed, Header, LawSpec, Particle, Property, Row, TraceError, Writer};
use nalgebra::Vector3;
use std::ffi::{c_char, CStr};
use std::fs::File;
use std::path::PathBuf;

/// A trace that is being written.
pub struct Recorder {
    path: PathBuf,
    header: Header,
    row: Row,
    /// Opened when the first contact pass begins, because the head names the particles.
    writer: Option<Writer<File>>,
}

fn failed(e: TraceError) -> Failure {
    Failure::refused(format!("granlaw: recording failed: {e}"))
}

/// # Safety
/// `s` is a C string or NULL.
pub(crate) unsafe fn text(s: *const c_char) -> String {
    if s.is_null() {
        return String::new();
    }
    // SAFETY: as the caller promises.
    unsafe { CStr::from_ptr(s) }.to_string_lossy().into_owned()
}

/// # Safety
/// Pointers and lengths of `c` belong together.
pub(crate) unsafe fn header(c: &granlaw_recorded_chain) -> Result<Header, Failure> {
    // SAFETY: as the caller promises, in this block.
    unsafe {
        let laws = slice(c.laws, c.n_laws).iter().map(|l| law(l, c.types)).collect::<Result<_, _>>()?;
        Ok(Header {
            granlaw: env!("CARGO_PKG_VERSION").into(),
            liggghts: text(c.liggghts),
            deck: text(c.deck),
            units: text(c.units),
            who: text(c.who),
            rank: c.rank as usize,
            ranks: c.ranks as usize,
            every: c.every,
            types: c.types,
            nktv2p: c.nktv2p,
            dt: c.dt,
            atoms: atoms(c),
            slots: slice(c.slots, c.n_slots).iter().map(|s| text(*s)).collect(),
            laws,
            ..Header::default()
        })
    }
}

/// The properties of single atoms that the deck gives and a law reads.
fn atoms(c: &granlaw_recorded_chain) -> Vec<String> {
    let all = LAWS.iter().flat_map(|e| e.meta.atoms);
    all.filter(|a| c.given[a.place]).map(|a| a.name.to_string()).collect()
}

/// # Safety
/// As [`header`].
unsafe fn law(l: &granlaw_recorded_law, types: usize) -> Result<LawSpec, Failure> {
    let kind = granlaw::model::Kind::ALL[l.kind as usize].name().to_string();
    // SAFETY: as the caller promises.
    let keyword = unsafe { text(l.keyword) };
    let mut spec =
        LawSpec { kind, keyword, taken_over: l.taken_over, offset: l.offset, ..LawSpec::default() };
    if l.index < 0 {
        return Ok(spec);
    }
    spec.known = true;
    let meta = LAWS[l.index as usize].meta;
    // SAFETY: one option per setting and one pointer per property of that law.
    let (chosen, values) =
        unsafe { (settings(l.index as usize, l.taken_over, l.options)?, slice(l.values, meta.props.len())) };
    spec.settings = options(&chosen);
    for (p, v) in meta.props.iter().zip(values).filter(|(_, v)| !v.is_null()) {
        // SAFETY: as many values as the shape says.
        let values = unsafe { slice(*v, p.shape.len(types)) }.to_vec();
        let (name, unit, shape) = (p.name.into(), p.unit.label.into(), p.shape.keyword().into());
        spec.properties.push(Property { name, unit, shape, values });
    }
    Ok(spec)
}

fn options(s: &Settings) -> std::collections::BTreeMap<String, String> {
    s.chosen().map(|(name, option)| (name.to_string(), option.to_string())).collect()
}

#[no_mangle]
unsafe extern "C" fn granlaw_record_open(
    c: *const granlaw_recorded_chain,
    out: *mut *mut Recorder,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (c, out) = unsafe { (&*c, &mut *out) };
        // SAFETY: as above.
        let (path, header) = unsafe { (PathBuf::from(text(c.path)), header(c)?) };
        *out = Box::into_raw(Box::new(Recorder { path, header, row: Row::default(), writer: None }));
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_record_again(
    r: *mut Recorder,
    c: *const granlaw_recorded_chain,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (r, mut header) = unsafe { (&mut *r, header(&*c)?) };
        header.particles = r.header.particles.clone();
        if header == r.header {
            return Ok(());
        }
        r.header = header;
        match &mut r.writer {
            Some(w) => w.header(&r.header).map_err(failed),
            None => Ok(()),
        }
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_record_begin(
    r: *mut Recorder,
    p: *const granlaw_recorded_particles,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers; the arrays have n particles.
        let (r, p) = unsafe { (&mut *r, &*p) };
        // SAFETY: as above.
        r.header.particles = unsafe { particles(p) };
        r.writer = Some(Writer::create(&r.path, &r.header).map_err(failed)?);
        Ok(())
    })
}

/// # Safety
/// The arrays have `p.n` particles.
unsafe fn particles(p: &granlaw_recorded_particles) -> Vec<Particle> {
    let three = |v: &[f64], k: usize| Vector3::new(v[3 * k], v[3 * k + 1], v[3 * k + 2]);
    // SAFETY: as the caller promises, in this block.
    let (tag, kind, radius, mass, x, v, omega) = unsafe {
        let n = p.n;
        let s = (slice(p.tag, n), slice(p.type_, n), slice(p.radius, n), slice(p.mass, n));
        (s.0, s.1, s.2, s.3, slice(p.x, 3 * n), slice(p.v, 3 * n), slice(p.omega, 3 * n))
    };
    let one = |k: usize| Particle {
        tag: tag[k].into(),
        kind: kind[k] as usize - 1,
        radius: radius[k],
        mass: mass[k],
        x: three(x, k),
        v: three(v, k),
        omega: three(omega, k),
    };
    (0..p.n).map(one).collect()
}

#[no_mangle]
unsafe extern "C" fn granlaw_record_call(
    r: *mut Recorder,
    c: *const granlaw_recorded_call,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (r, c) = unsafe { (&mut *r, &*c) };
        // SAFETY: as above; before and after have one number per slot.
        unsafe { fill(c, r.header.slots.len(), &mut r.row) };
        let writer = r.writer.as_mut().ok_or(Failure::misuse("a call before the recording began"))?;
        writer.row(&r.row).map_err(failed)
    })
}

/// Writes a call into a row, whose memory is used again.
///
/// # Safety
/// Pointers of `c` are valid; histories have `n` numbers.
pub(crate) unsafe fn fill(c: &granlaw_recorded_call, n: usize, row: &mut Row) {
    // SAFETY: as the caller promises, in this block.
    let (pass, s, before, after, fi, fj) =
        unsafe { (&*c.pass, &*c.contact, slice(c.before, n), slice(c.after, n), &*c.i_forces, &*c.j_forces) };
    let (gap, surface, handed): (ClosePair, Surface, Handed) = if c.touch {
        // SAFETY: the contact is LIGGGHTS's own and matches the pass.
        let x = unsafe { contact(pass, s) };
        let handed = Handed { fn_: s.Fn, kn: s.kn, kt: s.kt, gamman: s.gamman, gammat: s.gammat };
        (x.close, x.surface, handed)
    } else {
        // SAFETY: as above.
        (unsafe { parted(pass, &s.close, [c.mi, c.mj]) }, Surface::default(), Handed::default())
    };
    let (mut own, mut then) = (std::mem::take(&mut row.before), std::mem::take(&mut row.after));
    own.clear();
    own.extend_from_slice(before);
    then.clear();
    then.extend_from_slice(after);
    *row = Row {
        computeflag: s.close.computeflag,
        shearupdate: s.close.shearupdate,
        touch: c.touch,
        types: (s.close.itype as usize - 1, s.close.jtype as usize - 1),
        close: gap,
        surface,
        before: own,
        after: then,
        handed,
        force_i: fi.delta_F.into(),
        torque_i: fi.delta_torque.into(),
        force_j: fj.delta_F.into(),
        torque_j: fj.delta_torque.into(),
        has_force: c.touch || s.close.has_force_update,
    };
}

#[no_mangle]
unsafe extern "C" fn granlaw_record_close(r: *mut Recorder) -> granlaw_status {
    boundary(|| {
        // SAFETY: the pointer came from granlaw_record_open and is not used again.
        let r = unsafe { Box::from_raw(r) };
        match r.writer {
            Some(w) => w.finish().map_err(failed),
            None => Ok(()),
        }
    })
}
