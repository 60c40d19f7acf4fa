//! `granlaw timestep` and the warning during a run, held against what LIGGGHTS does in longer and shorter steps.
use crate::common::{deck, live, Scratch};
use serde_json::Value;

/// A sphere that rests on a plane, pushed a little: the wall's normal mode and nothing else.
fn resting(dt: f64) -> String {
    format!(
        "units si\natom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel yes\n\
         region box block -0.05 0.05 -0.05 0.05 -0.01 0.1 units box\ncreate_box 1 box\nneighbor 0.001 bin\n\
         fix p1 all property/global youngsModulus peratomtype 5e6\nfix p2 all property/global poissonsRatio peratomtype 0.45\n\
         fix p3 all property/global characteristicVelocity scalar 2\n\
         fix p4 all property/global coefficientRestitution peratomtypepair 1 0.5\n\
         pair_style gran model hooke\npair_coeff * *\nfix floor all wall/gran model hooke primitive type 1 zplane 0.0\n\
         fix weight all gravity 9.81 vector 0 0 -1\ncreate_atoms 1 single 0 0 0.004998\n\
         set atom 1 diameter 0.01 density 2500 vz -0.001\ntimestep {dt:e}\nfix move all nve/sphere\n\
         variable v equal vz[1]\nthermo_style custom step v_v\nthermo 600\nrun 600\n\
         variable s equal abs(v_v)\nprint \"speed ${{s}}\"\n"
    )
}

fn advice(s: &Scratch, ends: i32, more: &[&str]) -> Value {
    let args = [&["timestep", "deck.in", "--json"], more].concat();
    serde_json::from_str(&s.granlaw(&args).ends(ends, &[]).out).expect("JSON")
}

/// Whether the critical step that is said is where LIGGGHTS goes from calm to blowing up.
fn holds(s: &Scratch, critical: f64) -> bool {
    let speed = |dt: f64| -> f64 {
        s.file("deck.in", &resting(dt));
        let said = s.granlaw(&["run", "--", "-in", "deck.in"]).ends(0, &[]);
        let line = said.out.lines().rfind(|l| l.starts_with("speed ")).expect("a speed").to_string();
        line[6..].trim().parse().expect("a number")
    };
    speed(0.97 * critical) < 1e-6 && speed(1.03 * critical) > 1e-3
}

#[test]
fn the_critical_step_is_that_of_liggghts() {
    if !live("the_critical_step_is_that_of_liggghts") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &resting(1e-6));
    let said = advice(&s, 0, &["--speed", "1"]);
    let wall =
        said["contacts"].as_array().unwrap().iter().find(|c| c["who"] == "wall floor").expect("the wall");
    let normal = &wall["limits"][0];
    assert!(normal["name"] == "normal" && wall["laws"] == "hooke", "{wall}");
    let critical = normal["critical"].as_f64().unwrap();
    assert!(holds(&s, critical), "{critical:e}");
    // Planted: a tenth more, a tenth less.
    assert!(!holds(&s, 1.1 * critical) && !holds(&s, 0.9 * critical));
}

#[test]
fn what_is_too_long_is_told_with_the_figures() {
    if !live("what_is_too_long_is_told_with_the_figures") {
        return;
    }
    let s = Scratch::new();
    let name = "stiffness_ratio_1000.in";
    s.file("deck.in", &deck(name, &[]));
    let words = [
        "hooke/hysteresis + history",
        "normal",
        "tangential",
        "Rayleigh",
        "would say nothing",
        "is short enough",
    ];
    s.granlaw(&["timestep", "deck.in"]).ends(0, &words);
    // LIGGGHTS's check is silent, and yet.
    s.file("deck.in", &deck(name, &[("timestep        2e-7", "timestep 4e-5")]));
    s.granlaw(&["timestep", "deck.in"]).ends(1, &["would say nothing", "the deck's 4.00e-5 s is unstable"]);
    // More accuracy, a shorter step.
    let step = |e: &str| advice(&s, 1, &["--accuracy", e])["contacts"][0]["accurate"].as_f64().unwrap();
    let steps = ["1e-2", "1e-3", "1e-4"].map(step);
    assert!(steps[0] > steps[1] && steps[1] > 2.0 * steps[2], "{steps:?}");
    s.granlaw(&["timestep", "deck.in", "--accuracy", "0"]).ends(2, &["must be a number above 0"]);
    s.granlaw(&["timestep", "none.in"]).ends(2, &["none.in"]);
}

#[test]
fn a_run_warns_once_if_it_is_asked_to() {
    if !live("a_run_warns_once_if_it_is_asked_to") {
        return;
    }
    let s = Scratch::new();
    let name = "stiffness_ratio_1000.in";
    let warning = "WARNING: the time step of 4.000e-5 is too long for hooke/hysteresis, pair, types 1-1";
    let run = |more: &[&str]| s.granlaw(&[&["run"], more, &["--", "-in", "deck.in"]].concat()).ends(0, &[]);
    s.file("deck.in", &deck(name, &[("timestep        2e-7", "timestep 4e-5")]));
    for laws in ["stock", "rust"] {
        let said = run(&["--laws", laws, "--warn-timestep"]);
        assert_eq!(said.out.matches(warning).count(), 1, "{said}");
        assert!(said.out.contains("is unstable beyond 2.387e-5"), "{said}");
    }
    let warned = s.read("dump.txt");
    assert!(!run(&["--laws", "rust"]).out.contains("is too long"));
    assert!(warned == s.read("dump.txt"), "the warning changed the run");
    s.file("deck.in", &deck(name, &[]));
    assert!(!run(&["--warn-timestep"]).out.contains("is too long"));
}

/// Two bonded spheres that twist, all else switched off.
fn twisting(dt: f64) -> String {
    let values = [
        ("radiusMultiplierBondnonlinear", 0.8),
        ("createDistanceBondnonlinear", 1.05e-3),
        ("maxDistanceBondnonlinear", 2e-3),
        ("stiffnessPerUnitAreaK_tn", 4e9),
        ("stiffnessPerUnitAreaKu_tn", 4e9),
        ("stiffnessPerUnitAreaKc_tn", 0.0),
    ];
    let zeros = ["K_fn1", "Ku_fn1", "Kc_fn1", "K_fn2", "Ku_fn2", "Kc_fn2", "K_ft", "K_tt", "Ku_tt", "Kc_tt"];
    let zeros = zeros.map(|z| (format!("stiffnessPerUnitArea{z}"), 0.0));
    let all = values.map(|(name, x)| (name.to_string(), x)).into_iter().chain(zeros).enumerate();
    let fixes: String = all
        .map(|(k, (name, x))| format!("fix b{k} all property/global {name} peratomtypepair 1 {x:e}\n"))
        .collect();
    format!(
        "units si\natom_style granular\natom_modify map array\nboundary f f f\nnewton off\ncommunicate single vel yes\n\
         region box block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\ncreate_box 1 box\nneighbor 0.0005 bin\n\
         fix p1 all property/global youngsModulus peratomtype 1e7\nfix p2 all property/global poissonsRatio peratomtype 0.3\n\
         fix p3 all property/global characteristicVelocity scalar 2\n\
         fix p4 all property/global coefficientRestitution peratomtypepair 1 0.9\n{fixes}\
         fix ts all property/global tsCreateBondnonlinear scalar 1\n\
         pair_style gran model hooke cohesion bond/nonlinear bondConvention documented dampingBond off tensionStress off &\n\
         compressionStress off shearStress off shearTorqueStress off\npair_coeff * *\n\
         create_atoms 1 single 0 0 0\ncreate_atoms 1 single 0.00101 0 0\nset group all diameter 0.001 density 2500\n\
         set atom 1 omegax 1\nset atom 2 omegax -1\ntimestep {dt:e}\nfix move all nve/sphere\n\
         compute spin all property/atom omegax\ncompute most all reduce max c_spin\nvariable s equal abs(c_most)\n\
         thermo_style custom step c_most\nthermo 1\nthermo_modify norm no\nrun 500\nprint \"speed ${{s}}\"\n"
    )
}

#[test]
fn the_critical_step_of_a_bond_is_that_of_liggghts() {
    if !live("the_critical_step_of_a_bond_is_that_of_liggghts") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &twisting(1e-8));
    let said = advice(&s, 0, &["--bonds", "1", "--speed", "0.001"]);
    let all = said["contacts"].as_array().unwrap();
    let bond = all.iter().find(|c| c["laws"] == "bond/nonlinear/rs").expect("the bond");
    let (twist, none) = (&bond["limits"][0], &bond["limits"][1]);
    assert!(twist["name"] == "twist" && none.is_null(), "{bond}");
    let critical = twist["critical"].as_f64().unwrap();
    let grows = |part: f64| {
        s.file("deck.in", &twisting(part * critical));
        let said = s.granlaw(&["run", "--warn-timestep", "--", "-in", "deck.in"]).ends(0, &[]);
        let warnings =
            said.out.matches("too long for bond/nonlinear, pair, types 1-1: twist of one bond").count();
        assert_eq!(warnings, usize::from(part > 0.1), "{said}");
        let line = said.out.lines().rfind(|l| l.starts_with("speed ")).expect("a speed").to_string();
        line[6..].trim().parse::<f64>().map_or(true, |v| v.is_nan() || v > 2.0)
    };
    assert!(!grows(0.99) && grows(1.01), "{critical:e}");
    // Planted: a twentieth more, a twentieth less. And no warning where there is nothing to fear.
    assert!(grows(1.05 * 0.99) && !grows(0.95 * 1.01) && !grows(0.05));
    s.file("deck.in", &twisting(0.99 * critical));
    s.granlaw(&["timestep", "deck.in"]).ends(1, &["bond/nonlinear/rs", "twist", "12 such on each"]);
}
