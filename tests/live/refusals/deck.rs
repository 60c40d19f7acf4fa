//! Two spheres that touch each other and a wall; a chain for either, and what comes of it.
use crate::built::{alone, built, has, here, said};
use granlaw::model::{Kind, Meta};
use std::fs;
use std::path::PathBuf;

pub fn can(test: &str) -> bool {
    let found = has("liggghts") && PathBuf::from("/usr/include/liggghts").exists();
    here(test, found, "no liggghts or libliggghts-dev; install them")
}

pub fn plugin() -> PathBuf {
    built().join("libgranlaw_liggghts.so")
}

/// A chain in which a law takes part: a normal law alone, another behind a normal law.
pub fn chain_with(meta: &Meta, taken_over: bool) -> String {
    let normal = if taken_over { "model hertz" } else { "model hertz/rs" };
    let this = format!("{} {}", meta.kind.keyword(), meta.called(taken_over));
    if meta.kind == Kind::Normal {
        this
    } else {
        format!("{normal} {this}")
    }
}

#[derive(Clone)]
pub struct Deck {
    text: String,
    env: Vec<(String, String)>,
    program: PathBuf,
    arguments: Vec<String>,
    files: Vec<(String, String)>,
}

/// What a run said on its way out, in its log, and its dump.
pub struct Ran {
    pub said: String,
    pub log: String,
    pub dump: String,
    /// What a script of the deck may have written to memory.txt.
    pub memory: String,
}

/// The chain once for the pair and once for the wall; the other side runs on LIGGGHTS's own laws.
pub fn each_side(chain: &str) -> [Deck; 2] {
    [Deck::new(chain, "model hertz"), Deck::new("model hertz", chain)]
}

impl Deck {
    pub fn new(pair: &str, wall: &str) -> Deck {
        // LIGGGHTS wants the settings of a wall behind its shape.
        let words: Vec<_> = wall.split(' ').collect();
        let kinds = ["model", "tangential", "rolling_friction", "cohesion", "surface"];
        let models = words.chunks(2).take_while(|w| kinds.contains(&w[0])).count() * 2;
        let (models, settings) = words.split_at(models);
        let wall = format!("{} primitive type 1 zplane 0.0 {}", models.join(" "), settings.join(" "));
        let text = include_str!("deck.in").replace("PAIR", pair).replace("WALL", &wall);
        Deck {
            text,
            env: Vec::new(),
            program: "liggghts".into(),
            arguments: vec!["-in".into(), "deck.in".into()],
            files: Vec::new(),
        }
    }

    /// With a text changed, which must occur.
    #[track_caller]
    pub fn with(mut self, from: &str, to: &str) -> Deck {
        assert!(self.text.contains(from), "the deck has no {from:?} to change");
        self.text = self.text.replace(from, to);
        self
    }

    /// Without the lines that hold a word.
    #[track_caller]
    pub fn without(mut self, word: &str) -> Deck {
        let rest: String =
            self.text.lines().filter(|l| !l.contains(word)).map(|l| format!("{l}\n")).collect();
        assert_ne!(rest, self.text, "the deck has no {word:?}");
        self.text = rest;
        self
    }

    pub fn env(mut self, name: &str, value: impl Into<String>) -> Deck {
        self.env.push((name.into(), value.into()));
        self
    }

    /// On the stock laws of these names.
    pub fn taken_over(self) -> Deck {
        self.env("GRANLAW_LAWS", "rust")
    }

    /// With another program in the place of `liggghts`.
    pub fn program(mut self, program: PathBuf) -> Deck {
        self.program = program;
        self
    }

    /// With other arguments than `-in deck.in`.
    pub fn arguments(mut self, arguments: &[&str]) -> Deck {
        self.arguments = arguments.iter().map(|a| a.to_string()).collect();
        self
    }

    /// With a file beside it.
    pub fn file(mut self, name: &str, text: &str) -> Deck {
        self.files.push((name.into(), text.into()));
        self
    }

    /// Run to the end and check the exit status.
    #[track_caller]
    fn run(&self, preload: &str, status: i32) -> Ran {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("deck.in"), &self.text).unwrap();
        for (name, text) in &self.files {
            fs::write(dir.path().join(name), text).unwrap();
        }
        let mut command = alone(&self.program, dir.path());
        command.args(&self.arguments).env("LD_PRELOAD", preload);
        for name in ["GRANLAW_LAWS", "GRANLAW_RECORD", "GRANLAW_EVERY"] {
            command.env_remove(name);
        }
        let out = command.envs(self.env.clone()).output().unwrap();
        let read = |name: &str| {
            String::from_utf8_lossy(&fs::read(dir.path().join(name)).unwrap_or_default()).into_owned()
        };
        let ran = Ran {
            said: said(&out),
            log: read("log.liggghts"),
            dump: read("dump.txt"),
            memory: read("memory.txt"),
        };
        assert_eq!(out.status.code(), Some(status), "{}\n{}", self.text, ran.said);
        ran
    }

    /// It runs to its end with the plugin.
    #[track_caller]
    pub fn runs(&self) -> Ran {
        self.runs_with("")
    }

    /// The same, with another library preloaded too.
    #[track_caller]
    pub fn runs_with(&self, library: &str) -> Ran {
        let ran = self.run(&format!("{library} {}", plugin().display()), 0);
        assert!(ran.dump.lines().count() > 10, "nothing was dumped");
        ran
    }

    /// It runs to its end without the plugin.
    #[track_caller]
    pub fn runs_on_stock(&self) -> Ran {
        self.run("", 0)
    }

    /// LIGGGHTS's own laws stop with these words.
    #[track_caller]
    pub fn stock_refuses(&self, words: &str) {
        let ran = self.run("", 1);
        assert!(ran.said.contains(words), "no {words:?} in\n{}", ran.said);
    }

    /// It ends with this status and these words.
    #[track_caller]
    pub fn refused(&self, status: i32, words: &str) -> Ran {
        self.refused_with("", status, words)
    }

    /// The same, with another library preloaded too.
    #[track_caller]
    pub fn refused_with(&self, library: &str, status: i32, words: &str) -> Ran {
        let ran = self.run(&format!("{library} {}", plugin().display()), status);
        assert!(ran.said.contains(words), "no {words:?} in\n{}", ran.said);
        ran
    }
}
