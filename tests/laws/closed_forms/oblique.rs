//! Oblique impacts: Chung & Ooi (2011), Granular Matter 13:643, tests 4 to 8, with hertz and a shear history.
//!
//! Digitised curves are from the Kratos project's copies of the paper's figures; closed forms hold for gross sliding of
//! a solid sphere.
use super::bench::{chain, impact, near, sphere, start};
use super::hertz::{Material, ALUMINA, RIGID};
use granlaw::model::{Body, Kind};
use nalgebra::Vector3;

/// A sphere before its impact on a wall at x = 0 or on another sphere.
#[derive(Clone, Copy)]
struct Collision {
    material: Material,
    radius: f64,
    e: f64,
    mu: f64,
    /// Normal and tangential (y) velocity \[m/s\], spin about z \[rad/s\].
    vn: f64,
    vt: f64,
    omega: f64,
}

/// Against what.
enum Target {
    Wall,
    /// A wall with this modulus and Poisson's ratio.
    Elastic(f64, f64),
    /// A sphere that many times as large, dense and stiff, at rest.
    Large(f64, f64),
    /// The mirror image: opposite velocity, opposite spin.
    Mirror,
}

/// Velocities after it, and the normal restitution.
struct Rebound {
    vn: f64,
    vt: f64,
    omega: f64,
    e: f64,
}

impl Collision {
    /// With `chosen` settings of the laws.
    fn fire(&self, target: &Target, chosen: &[(&str, &str)]) -> Rebound {
        let (young, nu, rho) = self.material;
        let (size, weight) =
            if let Target::Large(size, weight) = target { (*size, *weight) } else { (1.0, 1.0) };
        let partner = match target {
            Target::Wall => (RIGID, nu),
            Target::Elastic(young, nu) => (*young, *nu),
            Target::Large(_, weight) => (young * weight, nu),
            Target::Mirror => (young, nu),
        };
        let given = [
            ("youngsModulus", [young, partner.0]),
            ("poissonsRatio", [nu, partner.1]),
            ("coefficientRestitution", [self.e; 2]),
            ("coefficientFriction", [self.mu; 2]),
        ];
        let mut laws = chain(&[(Kind::Normal, "hertz"), (Kind::Tangential, "history")], &given, chosen);
        let (v, omega) = (Vector3::new(-self.vn, self.vt, 0.0), Vector3::z() * self.omega);
        let i = Body { v, omega, ..sphere(self.radius, rho) };
        let j = match target {
            Target::Mirror => Body { v: -v, omega: -omega, ..i },
            _ => sphere(self.radius * size, rho * weight),
        };
        // A Hertz contact on a rigid wall; the others here take up to twice as long.
        let m = i.mass;
        let estimate = 2.87 * (m * m / (self.radius * (young / (1.0 - nu * nu)).powi(2) * self.vn)).powf(0.2);
        let n = 4000.0;
        let wall = matches!(target, Target::Wall | Target::Elastic(..));
        let mut start = start([i, j], wall, estimate / n, (4.0 * n) as u64);
        start.types = (0, usize::from(!matches!(target, Target::Mirror)));
        let out = impact(&mut laws, &start);
        assert!(out.apart);
        let b = out.last;
        Rebound { vn: b.v.x, vt: b.v.y, omega: b.omega.z, e: out.e }
    }
}

const STEEL: Material = (2.08e11, 0.30, 7850.0);
const POLYETHYLENE: Material = (1e9, 0.40, 1400.0);
const ALLOY: Material = (7.0e10, 0.33, 2700.0);

fn degrees(angle: f64) -> (f64, f64) {
    angle.to_radians().sin_cos()
}

/// Test 4: 3.9 m/s under an angle to the normal.
fn at_angle(material: Material, angle: f64) -> Collision {
    let (sin, cos) = degrees(angle);
    Collision { material, radius: 0.0025, e: 0.98, mu: 0.092, vn: 3.9 * cos, vt: 3.9 * sin, omega: 0.0 }
}

/// Angle \[deg\] and tangential restitution.
const E_T: [(f64, f64); 13] = [
    (5.17, 0.9481),
    (10.16, 0.6870),
    (14.99, 0.6244),
    (20.06, 0.6161),
    (25.05, 0.6343),
    (30.12, 0.6837),
    (35.03, 0.7372),
    (40.02, 0.7809),
    (50.0, 0.8451),
    (59.98, 0.8929),
    (69.96, 0.9316),
    (80.02, 0.9662),
    (85.01, 0.9827),
];
/// Angle \[deg\] and spin \[rad/s\].
const SPIN: [(f64, f64); 13] = [
    (4.95, -19.3),
    (10.08, -213.0),
    (14.97, -377.8),
    (19.94, -510.6),
    (24.91, -599.4),
    (29.96, -616.5),
    (34.93, -582.3),
    (39.98, -544.8),
    (50.0, -457.0),
    (60.02, -357.5),
    (69.96, -246.2),
    (80.06, -126.3),
    (85.03, -63.1),
];

/// Angle \[deg\] and direction in which the contact point rebounds \[deg\].
const REBOUND: [(f64, f64); 13] = [
    (4.90, 3.76),
    (9.96, -1.56),
    (14.93, -5.54),
    (19.99, -7.54),
    (24.96, -7.54),
    (29.92, -3.55),
    (34.96, 3.43),
    (39.92, 11.57),
    (49.83, 29.35),
    (59.99, 47.79),
    (69.74, 64.58),
    (79.82, 78.70),
    (84.78, 84.52),
];

/// Mean over the points of |ours − theirs|, relative to the mean of |theirs|.
fn misfit(points: &[(f64, f64)], ours: impl Fn(f64) -> f64) -> f64 {
    let off: f64 = points.iter().map(|(x, y)| (ours(*x) - y).abs()).sum();
    off / points.iter().map(|(_, y)| y.abs()).sum::<f64>()
}

/// Vst/(μ Vn) and Vst'/(μ Vn') of steel, test 5: finite elements of Wu et al.; from 6 on the sphere slides throughout.
const RECOIL: [(f64, f64); 14] = [
    (0.332, -0.28),
    (0.671, -0.493),
    (1.009, -0.747),
    (1.335, -1.0),
    (1.662, -1.267),
    (2.0, -1.533),
    (2.350, -1.813),
    (2.991, -2.44),
    (3.341, -2.693),
    (4.006, -2.787),
    (4.997, -2.0),
    (6.0, -1.013),
    (9.988, 3.013),
    (12.961, 6.013),
];
/// Vst/(μ Vn) and R ω'/(μ Vn) of steel, test 5.
const TWIST: [(f64, f64); 14] = [
    (0.353, -0.430),
    (0.682, -0.820),
    (0.994, -1.250),
    (1.341, -1.664),
    (1.688, -2.094),
    (2.0, -2.524),
    (2.329, -2.978),
    (2.988, -3.904),
    (3.318, -4.293),
    (3.994, -4.837),
    (5.0, -5.007),
    (6.006, -5.006),
    (10.01, -5.004),
    (20.0, -4.991),
];
/// The same of polyethylene.
const TWIST_PE: [(f64, f64); 5] =
    [(2.017, -2.670), (3.023, -4.050), (4.012, -4.934), (5.0, -4.966), (10.0, -4.963)];

/// Those of test 4 as MFiX computed them (its validation case DEM05): a sphere of alumina on an elastic wall with
/// E = 70 GPa, ν = 0.25, Hertz and Mindlin, e = 1.
const MFIX: [(f64, f64); 10] = [
    (2.0, 0.9967),
    (5.0, 0.9400),
    (10.0, 0.6903),
    (15.0, 0.6236),
    (20.0, 0.6150),
    (25.0, 0.6343),
    (30.0, 0.6813),
    (40.0, 0.7807),
    (50.0, 0.8456),
    (60.0, 0.8938),
];

/// Test 4 against the three curves, with the mean errors that the Kratos project accepts for its own code.
fn test_4(mu: f64) -> Result<(), String> {
    let shot = |angle| {
        let s = Collision { mu, ..at_angle(ALUMINA, angle) };
        (s, s.fire(&Target::Wall, &[]))
    };
    let e_t = misfit(&E_T, |angle| {
        let (s, r) = shot(angle);
        r.vt / s.vt
    });
    near("tangential restitution", e_t, 0.0, 1.6e-2, 1.0)?;
    // Their spin counts the other way round.
    near("spin", misfit(&SPIN, |angle| -shot(angle).1.omega), 0.0, 2.2e-2, 1.0)?;
    let rebound = misfit(&REBOUND, |angle| {
        let (s, r) = shot(angle);
        ((r.vt - s.radius * r.omega) / r.vn).atan().to_degrees()
    });
    near("rebound angle", rebound, 0.0, 2.5e-2, 1.0)
}

#[test]
fn chung_and_ooi_4_oblique_impacts_of_one_speed() {
    test_4(0.092).unwrap();
}

#[test]
fn a_friction_off_by_a_twentieth_is_seen() {
    assert!(test_4(0.092 * 1.05).unwrap_err().contains("instead of"));
}

#[test]
fn chung_and_ooi_4_as_another_code_computed_it() {
    for (angle, e_t) in MFIX {
        let shot = Collision { e: 1.0, ..at_angle(ALUMINA, angle) };
        let got = shot.fire(&Target::Elastic(7e10, 0.25), &[]);
        // The other code steps some 50 times per contact and rolls on the undeformed radius.
        near("e_t", got.vt / shot.vt, e_t, 0.01, 1.0).unwrap();
    }
}

#[test]
fn sliding_throughout_takes_mu_times_the_normal_impulse() {
    for angle in [40.0, 50.0, 60.0, 70.0, 80.0] {
        for e in [1.0, 0.98] {
            let shot = Collision { e, ..at_angle(ALUMINA, angle) };
            // The dashpot attracts at the end and damps sideways: without both, friction is μ times the push.
            let got = shot.fire(&Target::Wall, &[("limitForce", "on"), ("tangential_damping", "off")]);
            let taken = shot.mu * (1.0 + got.e) * shot.vn;
            // Only the build-up of shear at first touch is not sliding: 2e-4 of the impulse at 40 degrees.
            near("vt", shot.vt - got.vt, taken, 5e-4, taken).unwrap();
            // The lever is shorter by half the overlap, up to 1.7e-3 of R.
            near("spin", got.omega * shot.radius, 2.5 * taken, 2e-3, 2.5 * taken).unwrap();
        }
    }
}

/// Test 5: normal speed 5 m/s, e = 1, μ = 0.3, the tangential speed in units of μ Vn.
fn test_5(material: Material, x: f64) -> (f64, f64) {
    let shot = Collision { material, radius: 1e-5, e: 1.0, mu: 0.3, vn: 5.0, vt: x * 1.5, omega: 0.0 };
    let r = shot.fire(&Target::Wall, &[]);
    ((r.vt - shot.radius * r.omega) / 1.5, -shot.radius * r.omega / 1.5)
}

#[test]
fn chung_and_ooi_5_where_the_sphere_slides_throughout() {
    let slides = |points: &[(f64, f64)]| points.iter().copied().filter(|(x, _)| *x > 5.5).collect::<Vec<_>>();
    for (x, y) in slides(&RECOIL) {
        // Digitised to about 0.02; at x = 6 the end of the contact just sticks.
        near("recoil", test_5(STEEL, x).0, y, 0.05, 1.0).unwrap();
    }
    for (material, points) in [(STEEL, &TWIST[..]), (POLYETHYLENE, &TWIST_PE[..])] {
        for (x, y) in slides(points) {
            near("spin", test_5(material, x).1, y, 0.01, y).unwrap();
        }
    }
}

#[test]
fn chung_and_ooi_5_micro_slip_is_beyond_a_single_shear_spring() {
    // Below gross sliding the finite elements slip from the rim inwards; one spring either sticks or slips. That it is
    // far off there is a limit of the law to be known, not to be mended by a tolerance.
    let sticking: Vec<_> = RECOIL.into_iter().filter(|(x, _)| *x < 3.0).collect();
    assert!(misfit(&sticking, |x| test_5(STEEL, x).0) > 0.5);
}

/// Test 6: normal speed 0.2 m/s with a spin, so that 3.5 μ (1+e) Vn/Vst is x; gives −Vst'/Vst.
fn test_6(target: &Target, x: f64) -> f64 {
    let chosen = [("limitForce", "on"), ("tangential_damping", "off")];
    let at = |omega| Collision { material: ALLOY, radius: 0.1, e: 0.5, mu: 0.4, vn: 0.2, vt: 0.0, omega };
    let slow = at(0.0);
    let e = slow.fire(target, &chosen).e;
    let surface = 3.5 * slow.mu * (1.0 + e) * slow.vn / x;
    let r = at(surface / slow.radius).fire(target, &chosen);
    (r.vt - slow.radius * r.omega) / surface
}

#[test]
fn chung_and_ooi_6_and_8_spin_on_a_wall_and_on_a_large_heavy_sphere() {
    for x in [0.1, 0.187, 0.3, 0.5, 0.7] {
        let (wall, large) = (test_6(&Target::Wall, x), test_6(&Target::Large(5.0, 1000.0), x));
        // Sliding throughout: −1 + x. The build-up of shear costs up to 0.6 per cent of x, here and in test 8.
        near("recoil", wall, -1.0 + x, 0.01, x).unwrap();
        // 125,000 times as heavy, but its R is 5, not without end: 6e-5 in kn/kt and none in the impulse.
        near("recoil", large, wall, 1e-3, x).unwrap();
    }
    // The one point that the paper's curve was read at, to two digits after the point.
    near("recoil", test_6(&Target::Wall, 0.187), -0.815, 0.005, 1.0).unwrap();
}

#[test]
fn chung_and_ooi_7_counter_rotating_spheres_that_do_not_slip_keep_their_spin() {
    for angle in [5.0, 30.0, 60.0, 85.0] {
        let omega = 0.2 * f64::tan(f64::to_radians(angle)) / 0.1;
        let shot = Collision { material: ALLOY, radius: 0.1, e: 0.5, mu: 0.4, vn: 0.2, vt: 0.0, omega };
        let got = shot.fire(&Target::Mirror, &[]);
        assert_eq!((got.omega, got.vt), (omega, 0.0));
        // First order in the step: the dashpot of 4000 steps.
        near("e", got.e, 0.5, 1e-4, 1.0).unwrap();
    }
}
