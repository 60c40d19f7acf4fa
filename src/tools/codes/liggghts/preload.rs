//! What the plugin is told, and how it gets there: by `LD_PRELOAD` and variables of its own.
use super::Plugin;
use std::path::PathBuf;

/// Whose laws answer to which names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Laws {
    /// `/rs` names are ours, stock names LIGGGHTS's own.
    #[default]
    Own,
    /// Ours take over the stock names.
    Rust,
    /// As `Own`, but stock laws run in our chain, so that their calls can be recorded.
    Stock,
}

/// How the pair style goes through the contacts of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// All of them in one call; LIGGGHTS stops with the reason where that is not possible.
    Batched,
    /// One by one.
    Contact,
}

/// The plugin and what it is to do.
#[derive(Clone, Debug)]
pub struct Preload<'a> {
    /// The plugin.
    pub plugin: &'a Plugin,
    /// Whose laws run; without it, LIGGGHTS's own where calls are watched, and else those that the names in the deck say.
    pub laws: Option<Laws>,
    /// Where contact calls are recorded, if they are.
    pub record: Option<PathBuf>,
    /// Every how many steps they are; without it, in each.
    pub every: Option<u64>,
    /// Where a probe of the contacts is written, if it is.
    pub probe: Option<PathBuf>,
    /// Whether every call is held against the Rust laws.
    pub shadow: bool,
    /// The largest difference that is allowed then; without it none.
    pub tolerance: Option<f64>,
    /// File name of the deck, for the traces.
    pub deck: Option<String>,
    /// Whether the probe follows as many contacts as it has room for, at any cost.
    pub closely: bool,
    /// A probed run ends in order after so many steps.
    pub steps: Option<u64>,
    /// Whether to warn when the time step is too long for a contact.
    pub alarm: bool,
    /// How the pair style goes through its contacts; without it, batched where possible.
    pub route: Option<Route>,
    /// How many contacts go side by side, 1, 4, 8 or `widest`; without it, as many as suit the processor and the scene.
    pub lanes: Option<String>,
}

impl<'a> Preload<'a> {
    /// The plugin with its laws, and nothing else to do.
    pub fn new(plugin: &'a Plugin, laws: Laws) -> Preload<'a> {
        Preload { laws: Some(laws), ..Preload::bare(plugin) }
    }

    /// The plugin, with nothing said of what it is to do.
    pub fn bare(plugin: &'a Plugin) -> Preload<'a> {
        let (laws, record, every, probe, deck) = (None, None, None, None, None);
        let (shadow, tolerance, closely, steps) = (false, None, false, None);
        let (alarm, route, lanes) = (false, None, None);
        Preload {
            plugin,
            laws,
            record,
            every,
            probe,
            shadow,
            tolerance,
            deck,
            closely,
            steps,
            alarm,
            route,
            lanes,
        }
    }

    /// The environment that carries this to the plugin.
    pub fn env(&self) -> Vec<(&'static str, String)> {
        let laws = self.laws.map(|laws| match laws {
            Laws::Own => "own",
            Laws::Rust => "rust",
            Laws::Stock => "stock",
        });
        let route = self.route.map(|r| if r == Route::Batched { "batched" } else { "contact" });
        let path = |p: &PathBuf| p.display().to_string();
        let told = [
            ("LD_PRELOAD", Some(path(&self.plugin.path))),
            ("GRANLAW_LAWS", laws.map(str::to_string)),
            ("GRANLAW_RECORD", self.record.as_ref().map(path)),
            ("GRANLAW_EVERY", self.every.map(|n| n.to_string())),
            ("GRANLAW_PATH", route.map(str::to_string)),
            ("GRANLAW_LANES", self.lanes.clone()),
            ("GRANLAW_STEPS", self.steps.map(|n| n.to_string())),
            ("GRANLAW_TIMESTEP", self.alarm.then(|| "warn".into())),
            ("GRANLAW_PROBE", self.probe.as_ref().map(path)),
            ("GRANLAW_FOLLOW", self.closely.then(|| "all".into())),
            ("GRANLAW_SHADOW", self.shadow.then(|| "on".into())),
            ("GRANLAW_TOLERANCE", self.tolerance.map(|t| format!("{t:e}"))),
            ("GRANLAW_DECK", self.deck.clone()),
        ];
        told.into_iter().filter_map(|(name, value)| Some((name, value?))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::codes::environment::{Reader, VARIABLES};

    #[test]
    fn what_is_told_is_what_the_plugin_reads() {
        let plugin = Plugin { path: "plugin.so".into(), liggghts: "3.8.0".into() };
        let all = Preload {
            laws: Some(Laws::Rust),
            record: Some("trace.csv".into()),
            every: Some(7),
            probe: Some("scene.json".into()),
            shadow: true,
            tolerance: Some(1e-12),
            deck: Some("deck.in".into()),
            closely: true,
            steps: Some(10),
            alarm: true,
            route: Some(Route::Batched),
            lanes: Some("4".into()),
            plugin: &plugin,
        };
        let mut told: Vec<_> = all.env().into_iter().map(|(name, _)| name).collect();
        let read = VARIABLES.iter().filter(|v| v.reader == Reader::Plugin).map(|v| v.name);
        let mut read: Vec<_> = read.chain(["LD_PRELOAD"]).collect();
        told.sort_unstable();
        read.sort_unstable();
        assert_eq!(told, read);
        assert_eq!(Preload::bare(&plugin).env(), [("LD_PRELOAD", "plugin.so".to_string())]);
    }
}
