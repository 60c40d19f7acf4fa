//! The batched pass against one contact after the other: random chains, particles and neighbour lists, every width, every
//! bit of force, torque, history and flag.
#[path = "../../../tests/laws/universal/recipe.rs"]
#[allow(dead_code)]
mod recipe;
#[path = "bits/scene.rs"]
mod scene;

use granlaw::chain::{packed, Chain};
use granlaw_lanes::{batch, fitting, Arrays, NonFinite, Trouble, Width};
use recipe::{chain_of, chains, for_all, Case, Draw, Recipe, Switches};
use scene::Scene;

type Change = fn(&mut Scene);
type Outcome = Result<(), String>;

const WIDTHS: [Width; 3] = [Width::One, Width::Four, Width::Eight];

/// What is changed between two passes; of the last four, the fits that are kept must follow.
const CHANGES: [fn(&mut Scene, &mut Draw<'_>); 6] = [
    |s, d| s.shake(d),
    |s, d| s.shake(d),
    |s, _| s.radius.iter_mut().for_each(|r| *r *= 1.01),
    |s, _| s.mass.iter_mut().for_each(|m| *m *= 1.5),
    |s, _| s.kind.iter_mut().for_each(|t| *t = 3 - *t),
    |s, _| s.mask.iter_mut().step_by(3).for_each(|m| *m ^= 2),
];

/// A fix of another origin may own the first slot of a row.
fn places(r: &Recipe) -> Vec<Vec<usize>> {
    packed(&r.setups).into_iter().map(|own| own.into_iter().map(|at| at + 1).collect()).collect()
}

/// The same from the end of the row to its beginning, so that no two slots lie behind each other.
fn backwards(r: &Recipe) -> Vec<Vec<usize>> {
    places(r).into_iter().map(|own| own.into_iter().map(|at| r.slots() + 1 - at).collect()).collect()
}

/// Several passes with changes between them; `bend` may spoil what the pass left.
fn same(r: &Recipe, d: &mut Draw<'_>, bend: Change) -> Outcome {
    let places = if d.flip() { places(r) } else { backwards(r) };
    let mut first = Scene::draw(r.slots() + 2, d);
    if d.flip() {
        first.crowd();
    }
    for width in WIDTHS {
        let mut one = Chain::new(&r.setups, &places).unwrap();
        let mut all = batch(&r.setups, &places, width).unwrap().expect("all these laws have lanes");
        let (mut a, mut b) = (first.clone(), first.clone());
        let numbers: Vec<f64> = (0..64).map(|k| (0.37 * f64::from(k) + 0.11).fract()).collect();
        for (k, change) in CHANGES.iter().enumerate() {
            if k > 0 {
                change(&mut a, &mut Draw::of(&numbers));
                change(&mut b, &mut Draw::of(&numbers));
            }
            a.one_by_one(&mut one);
            // SAFETY: the scene's own arrays.
            unsafe { all.pass(&b.arrays(k == 0)) }.map_err(|e| format!("{width:?}: {e:?}"))?;
            bend(&mut b);
            a.compare(&b).map_err(|e| format!("{width:?}, pass {k}: {e}"))?;
        }
    }
    Ok(())
}

#[test]
fn a_pass_answers_as_single_contacts_do_to_the_last_bit() {
    let touched = std::sync::atomic::AtomicUsize::new(0);
    for chain in chains() {
        for_all(&chain, Switches::Any, 24, None, |r, _, d| {
            let scene = Scene::draw(r.slots() + 2, &mut Draw::of(&[0.3, 0.7, 0.2, 0.9, 0.4, 0.6, 0.8, 0.1]));
            touched.fetch_add(scene.touching(), std::sync::atomic::Ordering::Relaxed);
            same(r, d, |_| {})
        })
        .unwrap();
    }
    assert!(touched.into_inner() > 1000, "hardly anything touched");
}

/// Many passes over a heap that falls and shakes, with one list all the while. The answer is how many of them looked at a
/// part of the list, and how many contacts began.
fn fall(r: &Recipe, d: &mut Draw<'_>, width: Width) -> Result<[usize; 2], String> {
    let mut a = Scene::draw(r.slots() + 2, d);
    // A selection reaches as far as particles shake in some ten passes.
    a.skin = 8e-3;
    let mut one = Chain::new(&r.setups, &places(r)).unwrap();
    let mut all = batch(&r.setups, &places(r), width).unwrap().expect("all these laws have lanes");
    let mut b = a.clone();
    let [mut parts, mut begun] = [0; 2];
    for k in 0..120 {
        let before = a.touching_now();
        a.drift(1e-3, 1e-4, k);
        let home = a.x[3];
        // One is nowhere for a while, and comes back where another is.
        if (110..115).contains(&k) {
            a.x[3] = [f64::NAN; 3];
        } else if k == 115 {
            a.x[3] = a.x[9].map(|x| x + 1e-3);
        }
        b.x.clone_from(&a.x);
        a.one_by_one(&mut one);
        // SAFETY: the scene's own arrays.
        unsafe { all.pass(&b.arrays(k == 0)) }.map_err(|e| format!("{width:?}: {e:?}"))?;
        a.compare(&b).map_err(|e| format!("{width:?}, pass {k}: {e}"))?;
        parts += usize::from(all.looked_at() < all.neighbours());
        begun += a.touching_now().iter().filter(|k| !before.contains(k)).count();
        if a.x[3][0].is_nan() {
            a.x[3] = home;
        }
    }
    Ok([parts, begun])
}

#[test]
fn no_contact_is_missed_while_only_near_neighbours_are_looked_at() {
    let began = std::sync::atomic::AtomicUsize::new(0);
    for names in [["hooke/hysteresis", "history"], ["hertz", "no_history"]] {
        for width in WIDTHS {
            for_all(&chain_of(&names), Switches::Any, 8, None, |r, _, d| {
                let [parts, begun] = fall(r, d, width)?;
                began.fetch_add(begun, std::sync::atomic::Ordering::Relaxed);
                if parts < 80 {
                    return Err(format!("{width:?}: only {parts} passes left neighbours out"));
                }
                Ok(())
            })
            .unwrap();
        }
    }
    assert!(began.into_inner() > 500, "hardly any contact began");
}

/// Between many particles and few nothing is kept, whichever way the contacts go.
#[test]
fn lists_grow_and_shrink_between_many_particles_and_few() {
    let touched = std::sync::atomic::AtomicUsize::new(0);
    for_all(&chain_of(&["hooke/hysteresis", "history"]), Switches::Any, 24, None, |r, _, d| {
        let (mut one, mut all) =
            (Chain::new(&r.setups, &places(r)).unwrap(), fitting(&r.setups, &places(r)).unwrap().unwrap());
        let mut scene = Scene::draw(r.slots() + 2, d);
        scene.crowd();
        for (k, n) in [36, 6, 6, 36, 8, 9, 2].into_iter().enumerate() {
            let mut a = scene.clone();
            a.keep(n);
            let mut b = a.clone();
            touched.fetch_add(usize::from(n < 9) * a.touching(), std::sync::atomic::Ordering::Relaxed);
            for rebuilt in [true, false] {
                a.one_by_one(&mut one);
                // SAFETY: the scene's own arrays.
                unsafe { all.pass(&b.arrays(rebuilt)) }.map_err(|e| format!("{n} particles: {e:?}"))?;
                a.compare(&b).map_err(|e| format!("{n} particles, list {k}: {e}"))?;
            }
        }
        Ok(())
    })
    .unwrap();
    assert!(touched.into_inner() > 50, "hardly anything touched");
}

#[test]
fn a_wrong_bit_is_seen() {
    let faults: [(&str, Change); 4] = [
        ("force", |s| s.f[5][1] = f64::from_bits(s.f[5][1].to_bits() ^ 1)),
        ("torque", |s| s.torque[5][2] = f64::from_bits(s.torque[5][2].to_bits() ^ 1)),
        ("history", |s| s.history[3] = f64::from_bits(s.history[3].to_bits() ^ 1)),
        ("flag", |s| s.flags[4] ^= 8),
    ];
    for (what, fault) in faults {
        let check = |r: &Recipe, _: &Case, d: &mut Draw<'_>| same(r, d, fault);
        let error =
            for_all(&chain_of(&["hooke/hysteresis", "history"]), Switches::Any, 1, None, check).unwrap_err();
        assert!(error.contains(what), "{what}: {error}");
    }
}

#[test]
fn a_contact_that_is_not_finite_is_named() {
    let check = |r: &Recipe, _: &Case, d: &mut Draw<'_>| {
        for width in WIDTHS {
            let mut scene = Scene::draw(r.slots() + 2, d);
            let (i, j) = scene.first_touching();
            scene.v[j][0] = f64::NAN;
            let mut all = batch(&r.setups, &places(r), width).unwrap().unwrap();
            // SAFETY: the scene's own arrays.
            let got = unsafe { all.pass(&scene.arrays(true)) };
            let Err(Trouble::NonFinite(NonFinite { i: a, j: b, vn, .. })) = got else {
                return Err(format!("{width:?}: {got:?}"));
            };
            if (a, b) != (i, j) || !vn.is_nan() {
                return Err(format!("{width:?}: {a}-{b} was named where it is {i}-{j}"));
            }
        }
        Ok(())
    };
    for_all(&chain_of(&["hertz", "no_history"]), Switches::Any, 16, None, check).unwrap();
}

#[test]
fn arrays_that_do_not_fit_together_are_refused() {
    let spoil: [(&str, Change); 4] = [
        ("neighbour list names a particle", |s| s.neighbours[2] = s.x.len() as i32),
        ("or twice", |s| s.twice()),
        ("atom type", |s| s.kind[1] = 3),
        ("no room", |s| s.row = 2),
    ];
    for (says, spoil) in spoil {
        let check = |r: &Recipe, _: &Case, d: &mut Draw<'_>| {
            let mut scene = Scene::draw(r.slots() + 2, d);
            spoil(&mut scene);
            let mut all = batch(&r.setups, &places(r), Width::One).unwrap().unwrap();
            // SAFETY: the scene's own arrays; what was spoilt is to be found before it is used.
            let first = unsafe { all.pass(&scene.arrays(true)) };
            // What was refused is not used later.
            scene.kind = vec![1; scene.kind.len()];
            // SAFETY: as above.
            let again = unsafe { all.pass(&scene.arrays(false)) };
            match first {
                Err(Trouble::Arrays(what)) if what.contains(says) => {
                    again.map_err(|e| format!("{says}: {e:?}"))
                }
                other => Err(format!("{says}: {other:?}")),
            }
        };
        for_all(&chain_of(&["hooke/hysteresis", "history"]), Switches::Any, 1, None, check).unwrap();
    }
}

#[test]
fn a_list_of_more_particles_than_there_are_is_refused() {
    let check = |r: &Recipe, _: &Case, d: &mut Draw<'_>| {
        let mut scene = Scene::draw(r.slots() + 2, d);
        let mut all = batch(&r.setups, &places(r), Width::One).unwrap().unwrap();
        // SAFETY: the scene's own arrays.
        unsafe { all.pass(&scene.arrays(true)) }.map_err(|e| format!("{e:?}"))?;
        let fewer = Arrays { all: scene.x.len() - 1, ..scene.arrays(false) };
        // SAFETY: as above, and fewer.
        match unsafe { all.pass(&fewer) } {
            Err(Trouble::Arrays(what)) if what.contains("of other particles") => Ok(()),
            other => Err(format!("{other:?}")),
        }
    };
    for_all(&chain_of(&["hooke/hysteresis", "history"]), Switches::Any, 1, None, check).unwrap();
}

#[test]
fn lanes_are_named_in_words() {
    assert_eq!(Width::named("8"), Ok(Width::Eight));
    assert_eq!(Width::named(""), Ok(Width::widest()));
    assert!(Width::named("3").unwrap_err().contains("must be 1, 4, 8 or widest"));
}
