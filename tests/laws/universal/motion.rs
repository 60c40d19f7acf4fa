//! Motions of two bodies near each other, and laws that follow them.
use super::recipe::{body, reseen, Draw, Recipe, Subject};
use granlaw::model::*;
use nalgebra::Vector3;

/// Evaluations of a motion.
pub const STEPS: i64 = 24;

/// Two bodies near each other that swing to and fro, evaluation by evaluation.
#[derive(Clone)]
pub struct Path {
    pub types: (usize, usize),
    pub gaps: Vec<ClosePair>,
}

/// What a law answered on the way, with the history after it.
pub type Answers = Vec<(Response, Vec<f64>)>;

impl Path {
    pub fn draw(d: &mut Draw<'_>) -> Path {
        let (is_wall, types) = (d.unit() >= 0.75, (d.flip() as usize, d.flip() as usize));
        let (mut i, mut j) = (body(1, d), body(2, d));
        let reach = if is_wall { i.radius } else { i.radius + j.radius };
        let place = d.direction() * reach * d.within(0.99, 1.01);
        (i.x, j.x) = (place + j.x, j.x);
        let swings =
            [(i.v, i.omega, d.vector(1.0), d.vector(100.0)), (j.v, j.omega, d.vector(1.0), d.vector(100.0))];
        let gaps = (1..=STEPS).map(|step| {
            // A period that never brings them back to where they were, where the sign of an overlap would be rounding.
            let (sin, cos) = (step as f64 * std::f64::consts::TAU / 9.7).sin_cos();
            let call = Call { dt: 1e-6, step, update: true, counts: true, is_wall };
            for (b, (v, w, u, o)) in [&mut i, &mut j].into_iter().zip(&swings) {
                (b.v, b.omega) = (v * cos + u * sin, w * cos + o * sin);
                b.x += b.v * call.dt;
            }
            if is_wall {
                (j.tag, j.radius, j.mass, j.omega) = (-1, 0.0, 0.0, Vector3::zeros());
            }
            seen(ClosePair { call, i, j, ..ClosePair::default() })
        });
        Path { types, gaps: gaps.collect() }
    }

    /// The same motion, each evaluation seen otherwise.
    pub fn other(&self, change: impl Fn(&mut ClosePair)) -> Path {
        let gaps = self.gaps.iter().map(|g| {
            let mut g = *g;
            change(&mut g);
            seen(g)
        });
        Path { types: self.types, gaps: gaps.collect() }
    }

    pub fn arm(&self) -> f64 {
        self.gaps[0].delta.norm()
    }
}

fn seen(mut gap: ClosePair) -> ClosePair {
    gap.delta = gap.i.x - gap.j.x;
    gap.rsq = granlaw::lane::dot(&gap.delta, &gap.delta);
    gap.meff = gap.i.mass;
    if !gap.call.is_wall {
        gap.meff = gap.i.mass * gap.j.mass / (gap.i.mass + gap.j.mass);
    }
    gap
}

/// Let the laws follow a path; `between` sees each row of history before it is used.
pub fn follow(r: &Recipe, path: &Path, mut between: impl FnMut(usize, &mut Subject, &mut [f64])) -> Answers {
    let mut subject = r.subject();
    let mut h = vec![0.0; r.slots()];
    let mut one = |(k, gap): (usize, &ClosePair)| {
        between(k, &mut subject, &mut h);
        let s = evaluate(&mut subject, path.types, gap, &mut h);
        (s, h.clone())
    };
    path.gaps.iter().enumerate().map(&mut one).collect()
}

pub fn evaluate(subject: &mut Subject, types: (usize, usize), gap: &ClosePair, h: &mut [f64]) -> Response {
    let overlap = gap.i.radius + gap.j.radius - gap.rsq.sqrt();
    if overlap <= 0.0 {
        return subject.surfaces_close(types, gap, h);
    }
    let surface = Surface { deltan: overlap, ..Surface::default() };
    subject.surfaces_intersect(types, &reseen(&Contact { close: *gap, surface }), h)
}

pub fn undisturbed(r: &Recipe, path: &Path) -> Answers {
    follow(r, path, |_, _, _| {})
}
