//! The modules of a crate and their mutual use.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Attribute, Item, UseTree, Visibility};

/// Path of a module from the root of its crate.
type Module = Vec<String>;

/// The modules of a crate.
#[derive(Debug, Default)]
pub(super) struct Source {
    /// Every module with the paths in it, from the root of the crate.
    named: BTreeMap<Module, BTreeSet<Module>>,
    /// Re-exports of modules: name and target.
    passed_on: BTreeMap<Module, BTreeMap<String, Module>>,
    arrows: Vec<(Module, Module)>,
    n_lines: usize,
    n_public: usize,
}

impl Source {
    /// Reads the modules in a folder; excludes test code.
    pub(super) fn read(folder: &Path) -> Result<Self, String> {
        let mut files = Vec::new();
        list(folder, &mut files).map_err(|error| format!("{}: {error}", folder.display()))?;
        let mut found = Self::default();
        let mut parsed = Vec::new();
        for path in files {
            let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            let file = syn::parse_file(&text).map_err(|error| format!("{}: {error}", path.display()))?;
            let module = module_of(path.strip_prefix(folder).unwrap_or(&path));
            let before_tests = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
            if module.last().is_none_or(|name| name != "tests") {
                found.n_lines += before_tests.lines().filter(|line| is_code(line)).count();
            }
            found.named.insert(module.clone(), BTreeSet::new());
            parsed.push((module, file));
        }
        for (module, file) in &parsed {
            for item in file.items.iter().filter(|item| !is_of_tests(item)) {
                found.add(module, item);
            }
        }
        let arrows = found.named.iter().flat_map(|(module, paths)| {
            let to = paths.iter().filter_map(|path| found.home(path, 0));
            to.map(move |to| (module.clone(), to))
        });
        found.arrows = arrows.filter(|(from, to)| from != to).collect();
        Ok(found)
    }

    /// Number of code lines of its files, without tests, blank lines and comments.
    pub(super) fn n_lines(&self) -> usize {
        self.n_lines
    }

    /// Number of names that its root exports.
    pub(super) fn n_public(&self) -> usize {
        self.n_public
    }

    /// Pairs of a module and a module that it uses.
    pub(super) fn arrows(&self) -> impl Iterator<Item = (&[String], &[String])> {
        self.arrows.iter().map(|(from, to)| (&**from, &**to))
    }

    /// Modules that hold others.
    pub(super) fn folders(&self) -> BTreeSet<Module> {
        let above = |module: &Module| Some(module.split_last()?.1.to_vec());
        self.named.keys().filter_map(above).collect()
    }

    fn add(&mut self, module: &Module, item: &Item) {
        if let Item::Use(one) = item {
            let mut leaves = Vec::new();
            flatten(&one.tree, &mut Vec::new(), &mut leaves);
            let passes_on = !matches!(one.vis, Visibility::Inherited);
            for (path, name) in leaves {
                self.n_public += usize::from(module.is_empty() && matches!(one.vis, Visibility::Public(_)));
                let Some(path) = self.rooted(module, &path) else {
                    continue;
                };
                if passes_on {
                    let known = self.passed_on.entry(module.clone()).or_default();
                    known.insert(name, path.clone());
                } else {
                    self.named.entry(module.clone()).or_default().insert(path);
                }
            }
            return;
        }
        let mut paths = Vec::new();
        named_in(item.to_token_stream(), &mut paths);
        for path in paths {
            if let Some(path) = self.rooted(module, &path) {
                self.named.entry(module.clone()).or_default().insert(path);
            }
        }
    }

    /// A path as written in a module, from the root of the crate; `None` for a path into another crate.
    fn rooted(&self, module: &Module, path: &[String]) -> Option<Module> {
        let mut base = module.clone();
        let mut rest = path;
        match path.first().map(String::as_str) {
            Some("crate") => {
                base.clear();
                rest = &path[1..];
            }
            Some("self") => rest = &path[1..],
            Some("super") => {
                while rest.first().is_some_and(|first| first == "super") {
                    base.pop();
                    rest = &rest[1..];
                }
            }
            Some(first) => {
                let child = [base.clone(), vec![first.to_owned()]].concat();
                self.named.get(&child)?;
            }
            None => return None,
        }
        Some([base, rest.to_vec()].concat())
    }

    /// The module that defines the item at a path.
    fn home(&self, path: &[String], depth: usize) -> Option<Module> {
        let known = (0..=path.len()).rev().find(|&n| self.named.contains_key(&path[..n]))?;
        let (module, rest) = path.split_at(known);
        let passed_on = self.passed_on.get(module).zip(rest.first());
        match passed_on.and_then(|(names, name)| names.get(name)) {
            Some(on) if depth < 10 => self.home(&[on, &rest[1..]].concat(), depth + 1),
            _ => Some(module.to_vec()),
        }
    }
}

/// Whether a line contains code.
fn is_code(line: &str) -> bool {
    let line = line.trim();
    !line.is_empty() && !line.starts_with("//")
}

fn list(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            list(&path, files)?;
        } else if path.extension().is_some_and(|end| end == "rs") {
            files.push(path);
        }
    }
    files.sort();
    Ok(())
}

fn module_of(path: &Path) -> Module {
    let stem = path.with_extension("");
    let parts = stem.iter().map(|part| part.to_string_lossy().into_owned());
    let mut module: Module = parts.collect();
    let is_own = |last: &String| ["mod", "lib", "main"].contains(&last.as_str());
    if module.last().is_some_and(is_own) {
        module.pop();
    }
    module
}

/// Whether an item is compiled only for tests.
fn is_of_tests(item: &Item) -> bool {
    let attributes: &[Attribute] = match item {
        Item::Mod(one) => &one.attrs,
        Item::Fn(one) => &one.attrs,
        Item::Use(one) => &one.attrs,
        Item::Impl(one) => &one.attrs,
        Item::Struct(one) => &one.attrs,
        Item::Enum(one) => &one.attrs,
        Item::Macro(one) => &one.attrs,
        Item::Const(_)
        | Item::ExternCrate(_)
        | Item::ForeignMod(_)
        | Item::Static(_)
        | Item::Trait(_)
        | Item::TraitAlias(_)
        | Item::Type(_)
        | Item::Union(_)
        | Item::Verbatim(_)
        | _ => &[],
    };
    attributes
        .iter()
        .any(|attribute| attribute.path().is_ident("cfg") && attribute.to_token_stream().to_string().contains("test"))
}

/// The leaves of a tree of names, each with its local name.
fn flatten(tree: &UseTree, way: &mut Module, leaves: &mut Vec<(Module, String)>) {
    match tree {
        UseTree::Path(path) => {
            way.push(path.ident.to_string());
            flatten(&path.tree, way, leaves);
            way.pop();
        }
        UseTree::Group(group) => {
            for tree in &group.items {
                flatten(tree, way, leaves);
            }
        }
        UseTree::Name(name) if name.ident == "self" => {
            leaves.push((way.clone(), way.last().cloned().unwrap_or_default()));
        }
        UseTree::Name(name) => leaves.push(leaf(way, &name.ident, name.ident.to_string())),
        UseTree::Rename(name) => leaves.push(leaf(way, &name.ident, name.rename.to_string())),
        UseTree::Glob(_) => leaves.push((way.clone(), "*".into())),
    }
}

fn leaf(way: &Module, ident: &syn::Ident, name: String) -> (Module, String) {
    ([way.clone(), vec![ident.to_string()]].concat(), name)
}

/// Paths of at least two names in a stream of tokens, including macros and attributes.
fn named_in(tokens: TokenStream, paths: &mut Vec<Module>) {
    let mut path = Module::new();
    let mut colons = 0;
    for token in tokens {
        match token {
            TokenTree::Ident(name) if colons == 2 => {
                path.push(name.to_string());
                colons = 0;
            }
            TokenTree::Ident(name) => {
                end(&mut path, paths);
                path.push(name.to_string());
                colons = 0;
            }
            TokenTree::Punct(point) if point.as_char() == ':' => colons += 1,
            TokenTree::Group(group) => {
                end(&mut path, paths);
                colons = 0;
                named_in(group.stream(), paths);
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {
                end(&mut path, paths);
                colons = 0;
            }
        }
    }
    end(&mut path, paths);
}

fn end(path: &mut Module, paths: &mut Vec<Module>) {
    if path.len() > 1 {
        paths.push(std::mem::take(path));
    } else {
        path.clear();
    }
}
