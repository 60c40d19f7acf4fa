//! What a pair of atom types decides, and what is refused.
use crate::model::{LawError, Pair, Range};

/// The three stiffnesses of one way of loading.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// First loading.
    pub k: f64,
    /// Unloading and reloading.
    pub ku: f64,
    /// The line through zero.
    pub kc: f64,
    /// The part of the largest deformation that is left when the force has come back to the line through zero (5).
    pub left: f64,
}

impl Line {
    fn new(p: &Pair<'_>, names: [&'static str; 3]) -> Result<Line, LawError> {
        let [k, ku, kc] = names.map(|n| p.get(n));
        // Else unloading would end beyond zero and the force would jump there.
        if ku < k {
            return Err(p.refuse(names[1], ku, Range::at_least(k)));
        }
        Ok(Line::of(k, ku, kc))
    }

    /// From ku ≥ k ≥ 0 and kc ≥ 0.
    pub fn of(k: f64, ku: f64, kc: f64) -> Line {
        let left = if ku == k { 0.0 } else { (ku - k) / (ku + kc) };
        Line { k, ku, kc, left }
    }
}

/// One number for each mode.
#[derive(Clone, Copy, Debug)]
pub struct Modes<T> {
    /// Along the bond.
    pub normal: T,
    /// Across it.
    pub shear: T,
    /// Turning about it.
    pub twist: T,
    /// Turning out of it.
    pub bend: T,
}

/// When a bond breaks.
#[derive(Clone, Copy, Debug)]
pub enum Breaks {
    /// Beyond this distance \[m\].
    Distance(f64),
    /// At these stresses \[Pa\]; in tension `sigma` is multiplied by `ratio`.
    Stress {
        /// σmax.
        sigma: f64,
        /// τmax.
        tau: f64,
        /// Tension over compression.
        ratio: f64,
    },
}

/// What a pair of atom types decides.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    pub upstream: bool,
    pub lambda: f64,
    pub compression: Line,
    pub tension: Line,
    pub shear: f64,
    pub twist: Line,
    pub bend: Line,
    /// Which modes there are; of the normal one, in compression.
    pub on: Modes<bool>,
    pub on_tension: bool,
    pub eta: Modes<f64>,
    pub smooth: bool,
    pub breaks: Breaks,
    /// Below this distance a bond may begin \[m\].
    pub near: f64,
    /// The step in which bonds begin; `None` for always.
    pub at: Option<i64>,
}

impl Coeffs {
    pub fn new(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        let line = |k, ku, kc| Line::new(p, [k, ku, kc]);
        let damped = p.on("dampingBond") || p.on("dampingBondSmooth");
        let eta = |name| if damped { p.get(name) } else { 0.0 };
        Ok(Coeffs {
            upstream: p.option("bondConvention") == "upstream",
            lambda: p.get("radiusMultiplierBondnonlinear"),
            compression: line(
                "stiffnessPerUnitAreaK_fn1",
                "stiffnessPerUnitAreaKu_fn1",
                "stiffnessPerUnitAreaKc_fn1",
            )?,
            tension: line(
                "stiffnessPerUnitAreaK_fn2",
                "stiffnessPerUnitAreaKu_fn2",
                "stiffnessPerUnitAreaKc_fn2",
            )?,
            shear: p.get("stiffnessPerUnitAreaK_ft"),
            twist: line(
                "stiffnessPerUnitAreaK_tn",
                "stiffnessPerUnitAreaKu_tn",
                "stiffnessPerUnitAreaKc_tn",
            )?,
            bend: line("stiffnessPerUnitAreaK_tt", "stiffnessPerUnitAreaKu_tt", "stiffnessPerUnitAreaKc_tt")?,
            on: Modes {
                normal: p.on("compressionStress"),
                shear: p.on("shearStress"),
                twist: p.on("normalTorqueStress"),
                bend: p.on("shearTorqueStress"),
            },
            on_tension: p.on("tensionStress"),
            eta: Modes {
                normal: eta("dampingNormalForceBondnonlinear"),
                shear: eta("dampingTangentialForceBondnonlinear"),
                twist: eta("dampingNormalTorqueBondnonlinear"),
                bend: eta("dampingTangentialTorqueBondnonlinear"),
            },
            smooth: p.on("dampingBondSmooth"),
            breaks: breaks(p)?,
            near: p.get("createDistanceBondnonlinear"),
            at: begins(p)?,
        })
    }

    /// The largest distance at which a bond can be \[m\]. Under stress it reaches no farther than its strength
    /// stretches it, as the lines of tension lie above k2 δ.
    pub fn reach(&self, is_wall: bool) -> f64 {
        if self.lambda == 0.0 {
            return 0.0;
        }
        let near = if is_wall { 0.5 * self.near } else { self.near };
        match self.breaks {
            Breaks::Distance(max) => near.max(if is_wall { 0.5 * max } else { max }),
            Breaks::Stress { sigma, ratio, .. } => near + ratio.max(1.0) * sigma / self.tension.k,
        }
    }
}

fn breaks(p: &Pair<'_>) -> Result<Breaks, LawError> {
    let near = p.get("createDistanceBondnonlinear");
    if !p.on("stressBreak") {
        let max = p.get("maxDistanceBondnonlinear");
        // Else a bond would break in the step after it began.
        if max <= near {
            return Err(p.refuse("maxDistanceBondnonlinear", max, Range::above(near)));
        }
        return Ok(Breaks::Distance(max));
    }
    let k2 = p.get("stiffnessPerUnitAreaK_fn2");
    if k2 == 0.0 || !p.on("tensionStress") {
        return Err(p.senseless(format!(
            "stressBreak on{} with {} lets a bond stretch without end; give it a stiffness in tension or use stressBreak off",
            p.types(),
            if k2 == 0.0 { "stiffnessPerUnitAreaK_fn2 = 0" } else { "tensionStress off" },
        )));
    }
    let ratio =
        if p.on("ratioTensionCompressionBond") { p.get("ratioTensionCompressionBondnonlinear") } else { 1.0 };
    Ok(Breaks::Stress { sigma: p.get("maxSigmaBondnonlinear"), tau: p.get("maxTauBondnonlinear"), ratio })
}

fn begins(p: &Pair<'_>) -> Result<Option<i64>, LawError> {
    if p.on("createBondAlways") {
        return Ok(None);
    }
    let at = p.get("tsCreateBondnonlinear");
    if p.option("bondConvention") == "documented" && at < 1.0 {
        return Err(p.senseless(format!(
            "tsCreateBondnonlinear = {at} must be at least 1: step 0 only sets the run up, no bond begins in it; change it in fix property/global tsCreateBondnonlinear"
        )));
    }
    Ok(Some(at as i64))
}

/// What is allowed and asks for trouble.
pub fn remarks(p: &Pair<'_>) -> Vec<String> {
    let mut all = Vec::new();
    let law = p.law();
    if p.on("createBondAlways") {
        all.push(format!(
            "{law}: createBondAlways on: a bond that breaks below createDistanceBondnonlinear begins again in the next step"
        ));
    } else if p.get("tsCreateBondnonlinear") < 1.0 {
        all.push(format!(
            "{law}: tsCreateBondnonlinear below 1: no bond ever begins, step 0 only sets the run up"
        ));
    }
    if p.on("dampingBond") || p.on("dampingBondSmooth") {
        for name in [
            "dampingNormalForceBondnonlinear",
            "dampingTangentialForceBondnonlinear",
            "dampingNormalTorqueBondnonlinear",
            "dampingTangentialTorqueBondnonlinear",
        ] {
            if p.get(name) == 1.0 {
                all.push(format!("{law}: {name} = 1{}: a deflected bond never comes back", p.types()));
            }
        }
    }
    if p.option("bondConvention") == "upstream" {
        all.push(format!(
            "{law}: bondConvention upstream keeps the faults of LIGGGHTS-INL's header: results depend on the axes, on MPI ranks, and on how often a run is split or queried"
        ));
    }
    all
}
