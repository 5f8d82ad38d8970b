//! What a module defines, imports and uses, read from the tokens of its file.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};

/// A name that stands for a path.
#[derive(Debug)]
pub(crate) struct Import {
    pub(crate) path: Vec<String>,
    /// `*` for everything in the module of the path.
    pub(crate) name: String,
    pub(crate) is_public: bool,
    pub(crate) line: usize,
}

/// A path in code.
#[derive(Debug)]
pub(crate) struct Used {
    pub(crate) path: Vec<String>,
    pub(crate) line: usize,
}

/// A module.
#[derive(Debug, Default)]
pub(crate) struct Scope {
    pub(crate) defines: BTreeSet<String>,
    /// Macros that it defines; exported ones are named as if the root of the crate did.
    pub(crate) macros: BTreeSet<String>,
    pub(crate) imports: Vec<Import>,
    pub(crate) uses: Vec<Used>,
    /// Modules in files of their own.
    pub(crate) files: Vec<String>,
    /// Modules in this file.
    pub(crate) inline: Vec<(String, Scope)>,
}

impl Scope {
    /// Reads a file, or the part of one that is a module.
    pub(crate) fn read(tokens: TokenStream) -> Scope {
        let mut scope = Scope::default();
        scope.walk(tokens, true);
        scope
    }

    /// Reads tokens, of the module itself or of what is within braces or parentheses.
    fn walk(&mut self, tokens: TokenStream, is_outermost: bool) {
        let trees: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while at < trees.len() {
            at = match &trees[at] {
                TokenTree::Group(group) => {
                    // The braces of a macro's call hold items.
                    let is_call = at > 0 && is_punct(&trees, at - 1, '!');
                    let holds_items = is_call && group.delimiter() == Delimiter::Brace;
                    self.walk(group.stream(), is_outermost && holds_items);
                    at + 1
                }
                // An attribute.
                TokenTree::Punct(punct) if punct.as_char() == '#' => {
                    at + 1 + usize::from(group(&trees, at + 1, Delimiter::Bracket).is_some())
                }
                TokenTree::Ident(word) if word == "use" && !is_punct(&trees, at + 1, '<') => {
                    let end = (at..trees.len()).find(|&i| is_punct(&trees, i, ';'));
                    let end = end.expect("an import ends with a semicolon");
                    let is_public = is_public(&trees[..at]);
                    self.import(&trees[at + 1..end], &[], is_public);
                    end + 1
                }
                TokenTree::Ident(word) if is_outermost && word == "mod" => {
                    let name = ident(&trees, at + 1)
                        .expect("a module has a name")
                        .to_string();
                    match group(&trees, at + 2, Delimiter::Brace) {
                        Some(body) => self.inline.push((name, Scope::read(body))),
                        None => self.files.push(name),
                    }
                    at + 3
                }
                TokenTree::Ident(word) if is_outermost && defines(word) => {
                    match ident(&trees, at + 1) {
                        // `const fn` and `static mut`.
                        Some(name) if name == "fn" || name == "mut" => at + 1,
                        Some(name) => {
                            self.defines.insert(name.to_string());
                            at + 2
                        }
                        None => at + 1,
                    }
                }
                TokenTree::Ident(word) if is_macro_rules(word, &trees, at) => {
                    let name = ident(&trees, at + 2).expect("a macro has a name");
                    self.macros.insert(name.to_string());
                    at + 3
                }
                TokenTree::Ident(_) => self.path(&trees, at),
                _ => at + 1,
            };
        }
    }

    /// Records the path that begins at a word, unless it is a field, a method, a lifetime or the end of a
    /// path. Returns where the path ends.
    fn path(&mut self, trees: &[TokenTree], at: usize) -> usize {
        let before = |n: usize, c| at >= n && is_punct(trees, at - n, c);
        let is_field = before(1, '.') && !before(2, '.');
        let is_rest = before(1, ':') && before(2, ':');
        let mut end = at + 1;
        let mut path = vec![word(trees, at)];
        while is_punct(trees, end, ':') && is_punct(trees, end + 1, ':') {
            if ident(trees, end + 2).is_none() {
                break;
            }
            path.push(word(trees, end + 2));
            end += 3;
        }
        // A word alone is a variable, unless it is written like a type or a call.
        let is_type = path[0].starts_with(char::is_uppercase);
        let is_call = group(trees, end, Delimiter::Parenthesis).is_some();
        let is_named = path.len() > 1 || is_type || is_call;
        if is_named && !is_field && !is_rest && !before(1, '\'') {
            let line = trees[at].span().start().line;
            self.uses.push(Used { path, line });
        }
        end
    }

    /// Records the imports of a tree such as `a::{b, c as d, e::*}`.
    fn import(&mut self, tree: &[TokenTree], prefix: &[String], is_public: bool) {
        for tree in tree.split(|tree| matches!(tree, TokenTree::Punct(p) if p.as_char() == ',')) {
            let mut path = prefix.to_vec();
            let mut name = None;
            let mut line = 0;
            let mut at = 0;
            while at < tree.len() {
                match &tree[at] {
                    TokenTree::Ident(word) if word == "as" => {
                        name = ident(tree, at + 1).map(Ident::to_string);
                        at += 1;
                    }
                    TokenTree::Ident(word) => {
                        line = word.span().start().line;
                        path.push(word.to_string());
                    }
                    TokenTree::Punct(punct) if punct.as_char() == '*' => {
                        line = punct.span().start().line;
                        name = Some("*".to_owned());
                    }
                    TokenTree::Group(group) => {
                        let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                        self.import(&inner, &path, is_public);
                        path.clear();
                    }
                    _ => {}
                }
                at += 1;
            }
            // `a::{self}` is `a`.
            if path.len() > 1 && path[path.len() - 1] == "self" {
                path.pop();
            }
            if let Some(last) = path.last() {
                self.imports.push(Import {
                    name: name.unwrap_or_else(|| last.clone()),
                    path,
                    is_public,
                    line,
                });
            }
        }
    }
}

fn ident(trees: &[TokenTree], at: usize) -> Option<&Ident> {
    match trees.get(at) {
        Some(TokenTree::Ident(ident)) => Some(ident),
        _ => None,
    }
}

fn word(trees: &[TokenTree], at: usize) -> String {
    ident(trees, at).map(Ident::to_string).unwrap_or_default()
}

fn is_punct(trees: &[TokenTree], at: usize, c: char) -> bool {
    matches!(trees.get(at), Some(TokenTree::Punct(punct)) if punct.as_char() == c)
}

fn group(trees: &[TokenTree], at: usize, delimiter: Delimiter) -> Option<TokenStream> {
    match trees.get(at) {
        Some(TokenTree::Group(group)) if group.delimiter() == delimiter => Some(group.stream()),
        _ => None,
    }
}

/// Whether the tokens before an import end with `pub` or `pub(...)`.
fn is_public(before: &[TokenTree]) -> bool {
    let is_pub = |tree: &TokenTree| matches!(tree, TokenTree::Ident(word) if word == "pub");
    match before {
        [.., word, TokenTree::Group(group)] if group.delimiter() == Delimiter::Parenthesis => {
            is_pub(word)
        }
        [.., word] => is_pub(word),
        [] => false,
    }
}

/// Whether the name of an item follows the word.
fn defines(word: &Ident) -> bool {
    [
        "struct", "enum", "union", "trait", "type", "fn", "const", "static",
    ]
    .iter()
    .any(|keyword| word == keyword)
}

fn is_macro_rules(word: &Ident, trees: &[TokenTree], at: usize) -> bool {
    word == "macro_rules" && is_punct(trees, at + 1, '!')
}
