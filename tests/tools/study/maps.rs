//! Maps against linear theory where that is exact, and the counting of agreement.
use granlaw::pair::{run, Start};
use granlaw_tools::study::bonded;
use granlaw_tools::study::stability::{agreement, onset, Asked, Class, Field, Found, Place};

fn field(name: &str) -> Field {
    granlaw_tools::study::stability::field(name).expect("a field")
}

/// A sphere at rest is a linear oscillator, so energy must be created where theory says.
fn onset_by(theory: impl Fn(&granlaw_tools::study::stability::Row) -> f64, name: &str) -> Result<(), String> {
    let field = field(name);
    for row in &field.rows {
        let expected = theory(row) / row.unit();
        // 600 steps tell a growth of a few per cent a step; below the limit the dashpot has long calmed everything.
        for (factor, creates) in [(0.98, false), (1.03, true)] {
            let step = factor * expected;
            let class = row.class(step, &row.at(step, 8));
            if class.creates() != creates {
                return Err(format!("{name}, e = {}: {class:?} at {factor} of the critical step", row.param));
            }
        }
    }
    Ok(())
}

#[test]
fn spheres_at_rest_fail_at_the_critical_step() {
    onset_by(|r| r.normal.step(), "rest-normal").unwrap();
    onset_by(|r| r.tangential.step(), "rest-tangential").unwrap();
}

#[test]
fn straight_bonds_and_their_chains_fail_at_the_critical_step() {
    onset_by(|r| r.tangential.step(), "bond-size").unwrap();
    onset_by(|r| r.tangential.step(), "bond-chain").unwrap();
    onset_by(|r| r.tangential.step(), "kt").unwrap();
    // Planted: a chain as if it were two bodies, shear without bending, turning left out.
    assert!(onset_by(|r| r.normal.step(), "bond-chain").is_err());
    assert!(onset_by(|r| 0.95 * r.tangential.step(), "bond-size").is_err());
    assert!(onset_by(|r| r.normal.step(), "kt").is_err());
}

/// √δ is infinitely stiff at zero, so that no step is short enough for all blows; but what it creates energy from ends at the
/// speed at which the step would do.
#[test]
fn compression_fails_at_its_tangent_and_rattles_no_faster() {
    let field = field("bond-zero");
    for row in field.rows.iter().filter(|r| r.param > 3e-3) {
        let onset = onset(&field, row, 1).expect("an onset") * row.unit();
        let part = onset / row.tangential.step();
        assert!((0.2..0.4).contains(&part), "{} m/s: {part} of the critical step", row.param);
    }
    // Blows of 0.01 to 2 mm/s all end at some 7 mm/s in steps of a tenth.
    for row in field.rows.iter().filter(|r| r.param < 2e-3) {
        let ends = row.at(0.1, 1).energy.sqrt() * row.param;
        assert!((5e-3..2e-2).contains(&ends), "{} m/s: {ends}", row.param);
    }
}

#[test]
fn damping_of_bonds_chatters_at_rest_unless_it_is_smooth() {
    let left = |name: &str| {
        let field = field(name);
        let row = &field.rows[field.rows.len() / 2];
        (row.param, row.at(0.05, 1).error)
    };
    // ½ η g Δt over g/ω is η times the step in units of 2/ω.
    let (eta, hard) = left("bond-rest");
    assert!((0.02..1.1).contains(&(hard / (0.05 * eta))), "{hard}");
    assert!(left("bond-rest-smooth").1 < 1e-8);
}

/// Two spheres in a row move bit for bit as a pair.
#[test]
fn a_row_of_two_is_a_pair() {
    let field = field("bond-ku");
    let row = &field.rows[6];
    let (collision, dt, steps) = (row.collisions[2], 0.3 * row.unit(), 512);
    let bonded = collision.bonded.expect("a row");
    let got =
        bonded::run(&mut row.matter.chain().unwrap(), &collision, &bonded, (dt, steps), bonded::Look::Energy);
    let [i, j] = bonded::ahead(&collision, &bonded, dt)[..] else { panic!("two") };
    let start = Start { bodies: [i, j], ..collision.start(dt, 0.0, steps) };
    let mut last = start.bodies;
    run(&mut row.matter.chain().unwrap(), &start, |s| last = s.bodies);
    let expected = collision.judge(&last);
    assert!(
        got.distance == expected.distance && got.restitution == expected.restitution && got.energy >= 1.0
    );
    assert!(expected.restitution != -1.0 && expected.distance != collision.judge(&[i, j]).distance);
}

#[test]
fn a_wrong_critical_step_is_seen() {
    assert!(onset_by(|r| 1.05 * r.normal.step(), "rest-normal").is_err());
    assert!(onset_by(|r| 0.95 * r.normal.step(), "rest-normal").is_err());
    // Without the turning of the sphere: 2/ω of m* instead of 2/7 m*.
    let still = |r: &granlaw_tools::study::stability::Row| {
        granlaw::model::Mode { mass: r.normal.mass, ..r.tangential }.step()
    };
    assert!(onset_by(still, "rest-tangential").is_err());
}

#[test]
fn turning_lowers_the_tangential_limit_to_0_5345() {
    let rows = field("size-ratio").rows;
    for row in &rows {
        let without_damping = row.tangential.step_centred() / row.unit();
        // √(2/7), for spheres of any sizes.
        approx::assert_relative_eq!(without_damping, (2.0f64 / 7.0).sqrt(), max_relative = 1e-9);
    }
}

#[test]
fn stiff_unloading_creates_energy_where_the_check_is_silent() {
    let field = field("k2max");
    let row =
        field.rows.iter().min_by(|a, b| (a.param - 100.0).abs().total_cmp(&(b.param - 100.0).abs())).unwrap();
    // Below the linear limit, below what LIGGGHTS warns of, and yet.
    let step = 0.6;
    assert!(step * row.unit() < row.warns && step * row.unit() < row.normal.step());
    let found = row.at(step, 32);
    assert!(found.energy > 1.2, "{found:?}");
    assert_eq!(row.class(step, &found), Class::CreatesSilently);
    let calm = row.at(0.1, 32);
    assert_eq!(row.class(0.1, &calm), Class::Fine);
}

#[test]
fn classes_are_told_apart() {
    let found = |error, energy, finite| Found { error, energy, astray: 0.0, missed: 0.0, finite };
    let class = |f: Found, warned| f.class((0.01, 0.1), 1.01, warned);
    assert_eq!(class(found(0.001, 1.0, true), false), Class::Fine);
    assert_eq!(class(found(0.05, 1.0, true), true), Class::Rough);
    assert_eq!(class(found(0.5, 1.0, true), true), Class::Wrong);
    assert_eq!(class(found(0.0, 1.02, true), true), Class::Creates);
    assert_eq!(class(found(0.0, 1.02, true), false), Class::CreatesSilently);
    assert_eq!(class(found(0.0, 101.0, true), false), Class::BlowsUp);
    assert_eq!(class(found(0.0, 1.0, false), true), Class::BlowsUp);
    assert_eq!(class(found(f64::NAN, 1.0, true), true), Class::BlowsUp);
}

#[test]
fn agreement_counts_places_near_borders_apart() {
    let asked = |near, theirs| Asked { place: Place { row: 0, step: 0.1 }, ours: Class::Fine, theirs, near };
    let all = [
        asked(false, Class::Fine),
        asked(false, Class::Creates),
        asked(true, Class::Creates),
        asked(true, Class::Fine),
    ];
    let n = agreement(all.iter());
    assert_eq!((n.all, n.agree, n.far, n.far_agree), (4, 2, 2, 1));
}
