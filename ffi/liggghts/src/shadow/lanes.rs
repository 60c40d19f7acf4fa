//! The batched pass on calls that LIGGGHTS made one after the other: each becomes two particles of their own, so that
//! what the pass adds to them is its answer to that call alone.
use granlaw::model::LawError;
use granlaw_lanes::{batch, Arrays, Batch, Width};
use granlaw_tools::shadow::{Answer, Session};
use granlaw_tools::trace::{Header, Row};
use nalgebra::Vector3;

/// Calls that wait for each other; as many as the pass takes at once.
const WAITING: usize = 64;

/// What all contacts of a pass have in common.
#[derive(Clone, Copy, PartialEq)]
struct Common {
    step: i64,
    dt: f64,
    update: bool,
    frozen: i32,
}

/// A chain's batched pass with the calls that wait for it.
pub struct Lanes {
    batch: Box<dyn Batch>,
    slots: usize,
    common: Common,
    n: usize,
    rows: Vec<Row>,
    /// The particles, two per call.
    x: Vec<[f64; 3]>,
    v: Vec<[f64; 3]>,
    omega: Vec<[f64; 3]>,
    radius: Vec<f64>,
    mass: Vec<f64>,
    kind: Vec<i32>,
    mask: Vec<i32>,
    /// What the pass makes of them.
    f: Vec<[f64; 3]>,
    torque: Vec<[f64; 3]>,
    history: Vec<f64>,
    answer: Answer,
}

impl Lanes {
    /// For the chain of a header that the session compares; `None` where a law takes one contact at a time.
    ///
    /// # Errors
    /// What a law refuses.
    pub fn new(header: &Header, width: Width) -> Result<Option<Lanes>, LawError> {
        let Ok(setups) = header.setups() else { return Ok(None) };
        let Some(batch) = batch(&setups, &header.history_places(&setups), width)? else { return Ok(None) };
        let (slots, pairs) = (header.slots.len(), 2 * WAITING);
        Ok(Some(Lanes {
            batch,
            slots,
            common: Common { step: 0, dt: 0.0, update: false, frozen: 0 },
            n: 0,
            rows: vec![Row::default(); WAITING],
            x: vec![[0.0; 3]; pairs],
            v: vec![[0.0; 3]; pairs],
            omega: vec![[0.0; 3]; pairs],
            radius: vec![0.0; pairs],
            mass: vec![0.0; pairs],
            kind: vec![0; pairs],
            mask: vec![0; pairs],
            f: vec![[0.0; 3]; pairs],
            torque: vec![[0.0; 3]; pairs],
            history: vec![0.0; slots * WAITING],
            answer: Answer::default(),
        }))
    }

    /// A call of two particles whose surfaces overlap, with their masses and group masks. The row is taken in exchange for
    /// another.
    pub fn push(
        &mut self,
        session: &mut Session,
        at: usize,
        row: &mut Row,
        mass: [f64; 2],
        mask: [i32; 2],
        frozen: i32,
    ) {
        let call = &row.close.call;
        let common = Common { step: call.step, dt: call.dt, update: call.update, frozen };
        if self.n == WAITING || self.common != common {
            self.flush(session, at);
        }
        self.common = common;
        let n = self.n;
        for (k, body) in [&row.close.i, &row.close.j].into_iter().enumerate() {
            let p = 2 * n + k;
            (self.x[p], self.v[p], self.omega[p]) = (body.x.into(), body.v.into(), body.omega.into());
            (self.radius[p], self.mass[p], self.mask[p]) = (body.radius, mass[k], mask[k]);
            self.kind[p] = [row.types.0, row.types.1][k] as i32 + 1;
        }
        std::mem::swap(&mut self.rows[n], row);
        self.n += 1;
    }

    /// Evaluates what waits and hands it to the session.
    pub fn flush(&mut self, session: &mut Session, at: usize) {
        let n = std::mem::take(&mut self.n);
        if n == 0 {
            return;
        }
        let done = self.pass(n);
        for (k, row) in self.rows[..n].iter().enumerate() {
            if !done {
                // A contact that is not finite stops the whole pass; alone, each gets the answer that it deserves.
                session.call(at, row, 1.0);
                continue;
            }
            let vector = |of: &[[f64; 3]], p: usize| Vector3::from(of[p]);
            let a = &mut self.answer;
            (a.force_i, a.torque_i) = (vector(&self.f, 2 * k), vector(&self.torque, 2 * k));
            (a.force_j, a.torque_j) = (vector(&self.f, 2 * k + 1), vector(&self.torque, 2 * k + 1));
            a.history.clear();
            a.history.extend_from_slice(&self.history[k * self.slots..(k + 1) * self.slots]);
            session.answered(at, row, a);
        }
    }

    /// Whether the pass was carried out.
    fn pass(&mut self, n: usize) -> bool {
        self.f[..2 * n].fill([0.0; 3]);
        self.torque[..2 * n].fill([0.0; 3]);
        for (own, row) in self.history.chunks_mut(self.slots.max(1)).zip(&self.rows[..n]) {
            own.copy_from_slice(&row.before);
        }
        // Particle 2k has one neighbour, 2k + 1; that one has none.
        let ilist: [i32; WAITING] = std::array::from_fn(|k| 2 * k as i32);
        let numneigh: [i32; 2 * WAITING] = std::array::from_fn(|p| 1 - p as i32 % 2);
        let others: [i32; 2 * WAITING] = std::array::from_fn(|p| p as i32 + 1);
        let mut flags = [0; 2 * WAITING];
        let neighbours: [*const i32; 2 * WAITING] = std::array::from_fn(|p| &raw const others[p]);
        let flag: [*mut i32; 2 * WAITING] = std::array::from_fn(|p| &raw mut flags[p]);
        let begin = self.history.as_mut_ptr();
        let history: [*mut f64; 2 * WAITING] =
            std::array::from_fn(|p| begin.wrapping_add(p / 2 * self.slots));
        let arrays = Arrays {
            x: self.x.as_ptr(),
            v: self.v.as_ptr(),
            omega: self.omega.as_ptr(),
            f: self.f.as_mut_ptr(),
            torque: self.torque.as_mut_ptr(),
            radius: self.radius.as_ptr(),
            mass: self.mass.as_ptr(),
            rigid: std::ptr::null(),
            kind: self.kind.as_ptr(),
            mask: self.mask.as_ptr(),
            tag: std::ptr::null(),
            ilist: ilist.as_ptr(),
            numneigh: numneigh.as_ptr(),
            neighbours: neighbours.as_ptr(),
            flags: if self.slots > 0 { flag.as_ptr() } else { std::ptr::null() },
            history: if self.slots > 0 { history.as_ptr() } else { std::ptr::null() },
            rows: n,
            all: 2 * n,
            forced: 2 * n,
            row: self.slots,
            skin: 0.0,
            dt: self.common.dt,
            step: self.common.step,
            frozen: self.common.frozen,
            update: self.common.update,
            rebuilt: true,
        };
        // SAFETY: the arrays hold 2n particles, n rows with one neighbour, flag and row of history each, and outlive the call;
        // what the pass keeps of the list is dropped by `rebuilt` in the next.
        unsafe { self.batch.pass(&arrays) }.is_ok()
    }
}
