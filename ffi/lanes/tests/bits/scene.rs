//! A heap of particles with a neighbour list, laid out as LIGGGHTS has it.
use crate::recipe::Draw;
use granlaw::chain::Chain;
use granlaw::model::{Body, Call, ClosePair, Contact, Response};
use granlaw_lanes::Arrays;
use nalgebra::Vector3;

/// Particles, ghosts behind the owned ones, and one row of neighbours per owned particle.
#[derive(Clone, Default)]
pub struct Scene {
    pub x: Vec<[f64; 3]>,
    pub v: Vec<[f64; 3]>,
    pub omega: Vec<[f64; 3]>,
    pub f: Vec<[f64; 3]>,
    pub torque: Vec<[f64; 3]>,
    pub radius: Vec<f64>,
    pub mass: Vec<f64>,
    pub rigid: Vec<f64>,
    pub kind: Vec<i32>,
    pub mask: Vec<i32>,
    tag: Vec<i32>,
    ilist: Vec<i32>,
    pub numneigh: Vec<i32>,
    pub neighbours: Vec<i32>,
    pub flags: Vec<i32>,
    pub history: Vec<f64>,
    pub row: usize,
    pub skin: f64,
    owned: usize,
    update: bool,
    first: Vec<*const i32>,
    first_flag: Vec<*mut i32>,
    first_history: Vec<*mut f64>,
}

const N: usize = 36;
const FROZEN: i32 = 2;
/// The bits of a neighbour that are its index.
const NEIGHBOUR: usize = 0x1FFF_FFFF;

/// Numbers for all particles from a few draws.
struct Many(u64);

impl Many {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn vector(&mut self, size: f64) -> [f64; 3] {
        std::array::from_fn(|_| size * (2.0 * self.unit() - 1.0))
    }
}

impl Scene {
    pub fn draw(row: usize, d: &mut Draw<'_>) -> Scene {
        let mut m = Many((d.unit() * 1e15) as u64);
        let alike = d.flip();
        let (rigid, frozen) = (d.flip(), d.flip());
        let r = 5e-3;
        let mut s =
            Scene { row, owned: N - (d.unit() * 6.0) as usize, update: d.unit() < 0.8, ..Scene::default() };
        for k in 0..N {
            let size = if alike { 1.0 } else { 0.8 + 0.4 * m.unit() };
            s.x.push(m.vector(4.0 * r));
            s.v.push(m.vector(1.0));
            s.omega.push(if k % 7 == 0 { [0.0; 3] } else { m.vector(100.0) });
            s.f.push(m.vector(1e-3));
            s.torque.push(m.vector(1e-6));
            s.radius.push(r * size);
            s.mass.push(1.3e-3 * size * size * size);
            s.kind.push(if alike { 1 } else { 1 + (m.unit() * 2.0) as i32 });
            s.mask.push(1 + if frozen && m.unit() < 0.2 { FROZEN } else { 0 });
            s.rigid.push(if m.unit() < 0.3 { 0.1 } else { 0.0 });
            s.tag.push(100 + k as i32);
        }
        if !rigid {
            s.rigid.clear();
        }
        s.list(&mut m);
        s
    }

    /// Most of what is near, and some of what is not, in no particular order.
    fn list(&mut self, m: &mut Many) {
        self.numneigh = vec![0; N];
        self.ilist = (0..self.owned as i32).rev().collect();
        for &i in &self.ilist {
            for j in (0..N as i32).filter(|j| *j > i) {
                if m.unit() < 0.5 {
                    // LIGGGHTS keeps bits of its own above the index.
                    self.neighbours.push(j | if m.unit() < 0.1 { 1 << 30 } else { 0 });
                    self.flags.push((m.unit() * 16.0) as i32);
                    self.history.extend((0..self.row).map(|_| 1e-4 * (m.unit() - 0.2)));
                    self.numneigh[i as usize] += 1;
                }
            }
        }
    }

    /// Many contacts per particle, where there were few.
    pub fn crowd(&mut self) {
        self.x.as_flattened_mut().iter_mut().for_each(|x| *x *= 0.4);
    }

    /// The first `n` particles alone.
    pub fn keep(&mut self, n: usize) {
        let listed = |k: usize| k < n;
        let (ilist, numneigh) = (std::mem::take(&mut self.ilist), self.numneigh.clone());
        let (neighbours, flags, history) = (
            std::mem::take(&mut self.neighbours),
            std::mem::take(&mut self.flags),
            std::mem::take(&mut self.history),
        );
        let mut at = 0;
        for i in ilist {
            let row = at..at + numneigh[i as usize] as usize;
            at = row.end;
            if !listed(i as usize) {
                continue;
            }
            self.ilist.push(i);
            let stay: Vec<_> = row.filter(|k| listed(neighbours[*k] as usize & NEIGHBOUR)).collect();
            self.numneigh[i as usize] = stay.len() as i32;
            for k in stay {
                self.neighbours.push(neighbours[k]);
                self.flags.push(flags[k]);
                self.history.extend_from_slice(&history[self.row * k..][..self.row]);
            }
        }
        for v in [&mut self.x, &mut self.v, &mut self.omega, &mut self.f, &mut self.torque] {
            v.truncate(n);
        }
        for v in [&mut self.radius, &mut self.mass, &mut self.rigid] {
            v.truncate(n);
        }
        self.kind.truncate(n);
        self.mask.truncate(n);
        self.owned = self.owned.min(n);
    }

    pub fn shake(&mut self, d: &mut Draw<'_>) {
        let mut m = Many((d.unit() * 1e15) as u64);
        for k in 0..N {
            let step = m.vector(2e-4);
            (0..3).for_each(|c| self.x[k][c] += step[c]);
            self.v[k] = m.vector(1.0);
        }
    }

    /// All move by `together`, and each by up to `apart` of its own.
    pub fn drift(&mut self, together: f64, apart: f64, seed: usize) {
        let mut m = Many(seed as u64);
        for x in &mut self.x {
            let own = m.vector(apart);
            (0..3).for_each(|c| x[c] += together + own[c]);
        }
    }

    /// The second row of neighbours becomes another one of the first particle.
    pub fn twice(&mut self) {
        self.ilist[1] = self.ilist[0];
    }

    /// LIGGGHTS's view of it.
    pub fn arrays(&mut self, rebuilt: bool) -> Arrays {
        self.first = vec![std::ptr::null(); N];
        self.first_flag = vec![std::ptr::null_mut(); N];
        self.first_history = vec![std::ptr::null_mut(); N];
        let mut at = 0;
        for &i in &self.ilist {
            let i = i as usize;
            self.first[i] = self.neighbours[at..].as_ptr();
            self.first_flag[i] = self.flags[at..].as_mut_ptr();
            self.first_history[i] = self.history[self.row * at..].as_mut_ptr();
            at += self.numneigh[i] as usize;
        }
        Arrays {
            x: self.x.as_ptr(),
            v: self.v.as_ptr(),
            omega: self.omega.as_ptr(),
            f: self.f.as_mut_ptr(),
            torque: self.torque.as_mut_ptr(),
            radius: self.radius.as_ptr(),
            mass: self.mass.as_ptr(),
            rigid: if self.rigid.is_empty() { std::ptr::null() } else { self.rigid.as_ptr() },
            kind: self.kind.as_ptr(),
            mask: self.mask.as_ptr(),
            tag: self.tag.as_ptr(),
            ilist: self.ilist.as_ptr(),
            numneigh: self.numneigh.as_ptr(),
            neighbours: self.first.as_ptr(),
            flags: self.first_flag.as_ptr(),
            history: self.first_history.as_ptr(),
            rows: self.ilist.len(),
            all: self.x.len(),
            forced: self.owned,
            row: self.row,
            skin: self.skin,
            dt: 1e-5,
            step: 7,
            frozen: FROZEN,
            update: self.update,
            rebuilt,
        }
    }

    /// Every neighbour whose surface overlaps: particles and the number in the list.
    fn contacts(&self) -> Vec<(usize, usize, usize)> {
        let mut found = Vec::new();
        let mut at = 0;
        for &i in &self.ilist {
            for k in at..at + self.numneigh[i as usize] as usize {
                let (i, j) = (i as usize, self.neighbours[k] as usize & NEIGHBOUR);
                let d: [f64; 3] = std::array::from_fn(|c| self.x[i][c] - self.x[j][c]);
                let reach = self.radius[i] + self.radius[j];
                if d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach {
                    found.push((i, j, k));
                }
            }
            at += self.numneigh[i as usize] as usize;
        }
        found
    }

    pub fn touching(&self) -> usize {
        self.contacts().len()
    }

    /// The numbers in the list of those that touch.
    pub fn touching_now(&self) -> Vec<usize> {
        self.contacts().into_iter().map(|(_, _, k)| k).collect()
    }

    pub fn first_touching(&self) -> (usize, usize) {
        let (i, j, _) = self.contacts()[0];
        (i, j)
    }

    /// The pass as LIGGGHTS's own loop goes about it: one contact after the other through the chain.
    pub fn one_by_one(&mut self, chain: &mut Chain) {
        let call = Call { dt: 1e-5, step: 7, update: self.update, ..Call::default() };
        for (i, j, k) in self.contacts() {
            let held = |k: usize| self.mask[k] & FROZEN != 0;
            let mass = |k: usize| self.rigid.get(k).copied().filter(|m| *m > 0.0).unwrap_or(self.mass[k]);
            let (mi, mj) = (mass(i), mass(j));
            let mut meff = mi * mj / (mi + mj);
            if held(i) {
                meff = mj;
            }
            if held(j) {
                meff = mi;
            }
            let body = |k: usize, m: f64| Body {
                tag: self.tag[k].into(),
                radius: self.radius[k],
                mass: m,
                frozen: held(k),
                x: self.x[k].into(),
                v: self.v[k].into(),
                omega: self.omega[k].into(),
                ..Body::default()
            };
            let (bi, bj) = (body(i, mi), body(j, mj));
            let delta: Vector3<f64> = bi.x - bj.x;
            let rsq = delta.x * delta.x + delta.y * delta.y + delta.z * delta.z;
            let x = Contact::pair(ClosePair { call, i: bi, j: bj, delta, rsq, meff });
            let types = (self.kind[i] as usize - 1, self.kind[j] as usize - 1);
            let mut s = Response::default();
            let marks =
                chain.surfaces_intersect(types, &x, &mut self.history[self.row * k..][..self.row], &mut s);
            self.flags[k] = (self.flags[k] | marks.set) & !marks.clear;
            for c in 0..3 {
                self.f[i][c] += s.force[c];
                self.torque[i][c] += s.torque_i[c];
                if j < self.owned {
                    self.f[j][c] += 0.0 - s.force[c];
                    self.torque[j][c] += s.torque_j[c];
                }
            }
        }
    }

    /// Bit by bit.
    pub fn compare(&self, o: &Scene) -> Result<(), String> {
        let vectors = |a: &[[f64; 3]], b: &[[f64; 3]], what: &str| {
            let differ = |k: &usize| a[*k].map(f64::to_bits) != b[*k].map(f64::to_bits);
            let say = |k: usize| format!("{what} of {k} is {:?} where {:?} was expected", b[k], a[k]);
            (0..a.len()).find(differ).map_or(Ok(()), |k| Err(say(k)))
        };
        vectors(&self.f, &o.f, "force")?;
        vectors(&self.torque, &o.torque, "torque")?;
        if let Some(k) =
            (0..self.history.len()).find(|k| self.history[*k].to_bits() != o.history[*k].to_bits())
        {
            return Err(format!(
                "history {k} is {:e} where {:e} was expected",
                o.history[k], self.history[k]
            ));
        }
        match (0..self.flags.len()).find(|k| self.flags[*k] != o.flags[*k]) {
            Some(k) => Err(format!("flag {k} is {} where {} was expected", o.flags[k], self.flags[k])),
            None => Ok(()),
        }
    }
}
