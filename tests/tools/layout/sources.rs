//! The modules of a crate, each with its file, what it imports, and the paths that it follows.
use super::imports::imports;
use super::words::{words, Words};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// A module's place in its crate: `trace::header` is `["trace", "header"]`, the crate itself is empty.
pub type Place = Vec<String>;

/// What one file brings into scope and follows.
#[derive(Debug, Default)]
pub struct Module {
    /// Path of the file below the crate's folder.
    pub file: String,
    /// Imported names, with what they stand for.
    pub imports: BTreeMap<String, Place>,
    /// Modules of which everything is imported.
    pub globs: Vec<Place>,
    /// Paths that the file follows.
    pub paths: Vec<Place>,
    /// The words of its code, imports left out.
    pub code: Words,
}

/// All modules of a crate.
pub type Modules = BTreeMap<Place, Module>;

/// All files of some kinds under a folder, by their paths below it, with their texts.
pub fn files(folder: &Path, kinds: &[&str]) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(&next).unwrap_or_else(|e| panic!("{}: {e}", next.display())) {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| kinds.iter().any(|k| e == *k)) {
                let name = path.strip_prefix(folder).unwrap().to_string_lossy().into_owned();
                found.push((name, fs::read_to_string(&path).unwrap()));
            }
        }
    }
    found.sort();
    found
}

/// The modules of a crate whose files are given by name and text. `tests.rs` is compiled for tests only and left out.
pub fn modules(files: &[(String, String)]) -> Modules {
    let files = || files.iter().filter(|(name, _)| !name.ends_with("tests.rs"));
    let mut modules: Modules = files().map(|(name, _)| (place(name), Module::default())).collect();
    for (name, text) in files() {
        let at = place(name);
        let module = Module { file: name.clone(), ..module(&words(text), &at, &modules) };
        modules.insert(at, module);
    }
    modules
}

/// `trace/mod.rs` is `trace`, `lib.rs` the crate.
fn place(file: &str) -> Place {
    let name = file.trim_end_matches(".rs");
    match name.strip_suffix("/mod").unwrap_or(name) {
        "lib" | "main" => Place::new(),
        name => name.split('/').map(str::to_owned).collect(),
    }
}

fn module(words: &Words, at: &Place, modules: &Modules) -> Module {
    let mut module = Module::default();
    let (imports, code) = imports(words);
    for import in imports {
        let Some(path) = absolute(&import.path, at, &module, modules) else { continue };
        if import.name == "*" {
            module.globs.push(path);
            continue;
        }
        // What is only handed on is no need of this file.
        if !import.public || code.contains(&import.name) {
            module.paths.push(path.clone());
        }
        module.imports.insert(import.name, path);
    }
    let followed =
        paths(&code).into_iter().filter_map(|p| absolute(&p, at, &module, modules)).collect::<Vec<_>>();
    module.paths.extend(followed);
    Module { code, ..module }
}

/// Every path of two names and more in code.
fn paths(code: &Words) -> Vec<Words> {
    let name = |w: &String| w.starts_with(|c: char| c.is_alphabetic() || c == '_');
    let mut found = Vec::new();
    let mut path = Words::new();
    for (i, word) in code.iter().enumerate() {
        let goes_on = i > 0 && code[i - 1] == "::" && !path.is_empty();
        if word == "::" && i > 0 && name(&code[i - 1]) {
            continue;
        }
        if !goes_on {
            found.push(std::mem::take(&mut path));
        }
        if name(word) {
            path.push(word.clone());
        }
    }
    found.push(path);
    found.retain(|p| p.len() > 1);
    found
}

/// A path from the crate's root, or nothing if it leads elsewhere.
fn absolute(path: &[String], at: &Place, module: &Module, modules: &Modules) -> Option<Place> {
    let (first, rest) = path.split_first()?;
    let child = || at.iter().chain([first]).cloned().collect::<Place>();
    let mut base = match first.as_str() {
        "crate" => Place::new(),
        "self" => at.clone(),
        "super" => at[..at.len().checked_sub(1)?].to_vec(),
        name => match module.imports.get(name) {
            Some(target) => target.clone(),
            None => Some(child()).filter(|c| modules.contains_key(c))?,
        },
    };
    for name in rest {
        match name.as_str() {
            "super" => base.truncate(base.len().checked_sub(1)?),
            name => base.push(name.to_owned()),
        }
    }
    Some(base)
}
