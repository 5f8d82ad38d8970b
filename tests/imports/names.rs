//! Arrows: for each import and each path the file that defines the item.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use proc_macro2::TokenStream;

use crate::scope::Scope;

/// The text of each file by its path, with `/` between folders.
pub(crate) type Tree = BTreeMap<String, String>;

/// A file names an item of another file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Arrow {
    pub(crate) from: String,
    pub(crate) line: usize,
    pub(crate) to: String,
    path: String,
}

impl fmt::Display for Arrow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Arrow {
            from,
            line,
            to,
            path,
        } = self;
        write!(f, "{from}:{line} uses `{path}` of {to}")
    }
}

/// The arrows between the files of all crates in the tree; or what cannot be understood.
pub(crate) fn arrows(tree: &Tree) -> Result<Vec<Arrow>, String> {
    let mut found = BTreeSet::new();
    let mut read = BTreeSet::new();
    for root in tree.keys().filter(|path| is_root(path)) {
        let mut package = Package::default();
        package.read(tree, root, true, Vec::new())?;
        package.arrows(&mut found)?;
        read.extend(package.modules.into_values().map(|module| module.file));
    }
    // A file may be another one's text.
    let is_text = |path: &str| {
        let name = path.rsplit('/').next().unwrap_or(path);
        let quoted = format!("include_str!(\"{name}\")");
        tree.values().any(|text| text.contains(&quoted))
    };
    match tree
        .keys()
        .find(|path| !read.contains(*path) && !is_text(path))
    {
        Some(path) => Err(format!("{path} is in no crate")),
        None => Ok(found.into_iter().collect()),
    }
}

/// Whether a file is the root of a crate, by the conventions of Cargo.
fn is_root(path: &str) -> bool {
    let mut parts = path.rsplit('/');
    let (name, folder) = (parts.next(), parts.next());
    matches!(name, Some("lib.rs" | "main.rs" | "build.rs"))
        || matches!(
            folder,
            Some("bin" | "fuzz_targets" | "tests" | "benches" | "examples")
        )
}

/// The path of a module in its crate.
type ModulePath = Vec<String>;

struct Module {
    file: String,
    scope: Scope,
}

/// What a name stands for.
enum Meaning {
    Module(ModulePath),
    /// An item of this file.
    Item(String),
}

/// The modules of a crate.
#[derive(Default)]
struct Package {
    modules: BTreeMap<ModulePath, Module>,
}

impl Package {
    /// Reads the file of a module, and of the modules in it.
    fn read(
        &mut self,
        tree: &Tree,
        file: &str,
        is_root: bool,
        path: ModulePath,
    ) -> Result<(), String> {
        let text = tree.get(file).ok_or(format!("{file} is missing"))?;
        let tokens: Result<TokenStream, _> = text.parse();
        let scope = Scope::read(tokens.map_err(|error| format!("{file}: {error}"))?);
        let (folder, name) = file.rsplit_once('/').unwrap_or(("", file));
        let folder = match name.strip_suffix(".rs") {
            Some(stem) if !is_root && stem != "mod" => format!("{folder}/{stem}"),
            _ => folder.to_owned(),
        };
        self.add(tree, file, &folder, path, scope)
    }

    /// Adds a module whose own modules have their files in the folder.
    fn add(
        &mut self,
        tree: &Tree,
        file: &str,
        folder: &str,
        path: ModulePath,
        mut scope: Scope,
    ) -> Result<(), String> {
        let child = |name: &String| [&path[..], std::slice::from_ref(name)].concat();
        for (name, inner) in std::mem::take(&mut scope.inline) {
            self.add(tree, file, &format!("{folder}/{name}"), child(&name), inner)?;
        }
        for name in &scope.files {
            let own_folder = format!("{folder}/{name}/mod.rs");
            let beside = format!("{folder}/{name}.rs");
            let place = if tree.contains_key(&own_folder) {
                own_folder
            } else {
                beside
            };
            self.read(tree, &place, false, child(name))?;
        }
        let file = file.to_owned();
        self.modules.insert(path, Module { file, scope });
        Ok(())
    }

    fn arrows(&self, found: &mut BTreeSet<Arrow>) -> Result<(), String> {
        for (path, Module { file, scope }) in &self.modules {
            let imports = scope.imports.iter().filter(|import| import.name != "*");
            let imports = imports.map(|import| (&import.path, import.line, import.is_public));
            let uses = scope.uses.iter().map(|used| (&used.path, used.line, false));
            for (names, line, is_reexport) in imports.chain(uses) {
                let spelt = names.join("::");
                match self.meaning(path, names, 0) {
                    Ok(Some(Meaning::Item(to))) if to != *file && !is_reexport => {
                        found.insert(Arrow {
                            from: file.clone(),
                            line,
                            to,
                            path: spelt,
                        });
                    }
                    Ok(_) => {}
                    Err(()) => return Err(format!("{file}:{line}: what is `{spelt}`?")),
                }
            }
        }
        Ok(())
    }

    /// What a path means in a module: nothing that is known if it leads to another crate or begins with a
    /// local name, an error if it leads into this crate and to nothing there.
    fn meaning(
        &self,
        module: &[String],
        names: &[String],
        depth: usize,
    ) -> Result<Option<Meaning>, ()> {
        let is_last = |i: usize| i + 1 == names.len();
        let mut meaning = match names[0].as_str() {
            "crate" => Meaning::Module(Vec::new()),
            "self" => Meaning::Module(module.to_vec()),
            "super" => Meaning::Module(parent(module)),
            name => match self.lookup(module, name, is_last(0), depth) {
                Some(meaning) => meaning,
                None => return Ok(None),
            },
        };
        for (i, name) in names.iter().enumerate().skip(1) {
            meaning = match meaning {
                Meaning::Module(path) if name == "super" => Meaning::Module(parent(&path)),
                Meaning::Module(path) => self.lookup(&path, name, is_last(i), depth).ok_or(())?,
                item @ Meaning::Item(_) => item,
            };
        }
        Ok(Some(meaning))
    }

    /// What a name means in a module. A function and a module can have the same name: the function is meant
    /// at the end of a path.
    fn lookup(
        &self,
        module: &[String],
        name: &str,
        is_last: bool,
        depth: usize,
    ) -> Option<Meaning> {
        /// More re-exports of re-exports than that are a circle of them.
        const DEEPEST: usize = 20;
        if depth > DEEPEST {
            return None;
        }
        let Module { file, scope } = self.modules.get(module)?;
        let child = || {
            let path = [module, &[name.to_owned()]].concat();
            self.modules
                .contains_key(&path)
                .then_some(Meaning::Module(path))
        };
        let own = || {
            let is_defined = scope.defines.contains(name) || scope.macros.contains(name);
            is_defined.then(|| Meaning::Item(file.clone()))
        };
        let exported = || {
            let mut modules = self.modules.values().filter(|_| module.is_empty());
            let definer = modules.find(|module| module.scope.macros.contains(name))?;
            Some(Meaning::Item(definer.file.clone()))
        };
        let imported = || {
            let of_name = scope.imports.iter().filter(|import| import.name == name);
            let mut meanings =
                of_name.map(|import| self.meaning(module, &import.path, depth + 1).ok().flatten());
            meanings.find_map(|meaning| meaning)
        };
        let by_glob = || {
            let globs = scope.imports.iter().filter(|import| import.name == "*");
            globs.into_iter().find_map(|import| {
                match self.meaning(module, &import.path, depth + 1) {
                    Ok(Some(Meaning::Module(path))) => self.lookup(&path, name, is_last, depth + 1),
                    _ => None,
                }
            })
        };
        let item = || own().or_else(imported);
        let meaning = if is_last {
            item().or_else(child)
        } else {
            child().or_else(item)
        };
        meaning.or_else(by_glob).or_else(exported)
    }
}

fn parent(module: &[String]) -> ModulePath {
    module[..module.len().saturating_sub(1)].to_vec()
}
