//! The orders of convergence that are claimed of the methods.
use super::case::Case;
use super::methods::Method;

/// The power of the step with which the error of a method falls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claim {
    /// The case.
    pub case: &'static str,
    /// The method.
    pub method: Method,
    /// The order.
    pub order: f64,
    /// The number of steps per contact from which on it holds.
    pub from: f64,
}

/// The largest allowed difference between an observed order and the one claimed.
pub const WITHIN: f64 = 0.2;

/// All claims. There is none where the error depends on jumps of a law or on where its kinks lie within a step.
pub fn claims() -> Vec<Claim> {
    let mut all = Vec::new();
    let mut claim = |case, method, order, from| all.push(Claim { case, method, order, from });
    let schemes = [(Method::Verlet, Method::VerletTimed), (Method::Stock, Method::PluginTimed)];
    for (plain, timed) in schemes {
        claim("undamped", plain, 2.0, 25.0);
        claim("undamped", timed, 4.0, 12.0);
        for case in ["damped-0.5", "damped-0.5-wall", "hertz-0.5"] {
            claim(case, plain, 1.0, 100.0);
            claim(case, timed, 2.0, 100.0);
        }
        claim("damped-0.9", plain, 1.0, 100.0);
        // At 100 steps two thirds of the error are still of third order.
        claim("damped-0.9", timed, 2.0, 400.0);
        // With coarser steps slip begins within the first few steps.
        claim("slip", timed, 2.0, 1600.0);
        claim("stick-slip-td-off", plain, 1.0, 100.0);
        claim("stick-slip-td-off", timed, 2.0, 100.0);
    }
    for case in ["damped-0.9", "damped-0.5", "damped-0.5-wall", "bond", "bond-damped"] {
        claim(case, Method::Located, 2.0, 100.0);
    }
    for method in [Method::Verlet, Method::Plugin] {
        for case in ["bond-vibration", "bond", "bond-damped", "bond-chain", "bond-chain-damped"] {
            claim(case, method, 2.0, 100.0);
        }
        // √δ begins with an infinite slope.
        claim("bond-pressed", method, 1.5, 50.0);
    }
    all
}

impl Claim {
    /// Checks an observed order.
    ///
    /// # Errors
    /// If it is not as claimed, with a message.
    pub fn check(&self, observed: Option<f64>) -> Result<f64, String> {
        let Claim { case, method, order, .. } = *self;
        match observed {
            None => Err(format!("{case}, {}: too few points to see an order", method.name())),
            Some(o) if (o - order).abs() <= WITHIN => Ok(o),
            Some(o) => Err(format!("{case}, {}: order {o:.2} where {order} is claimed", method.name())),
        }
    }

    /// The claim about a case and a method.
    pub fn of(case: &Case, method: Method) -> Option<Claim> {
        claims().into_iter().find(|c| c.case == case.name && c.method == method)
    }
}
