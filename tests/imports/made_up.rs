//! The test of imports, tested on made-up trees.

use crate::circles;
use crate::names::{Tree, arrows};

/// The circles in a tree of files, given by path and text.
fn circles_in(files: &[(&str, &str)]) -> Vec<String> {
    let file = |&(path, text): &(&str, &str)| (path.to_owned(), text.to_owned());
    let tree: Tree = files.iter().map(file).collect();
    circles(&arrows(&tree).expect("a tree that is understood"))
}

#[track_caller]
fn assert_no_circle(files: &[(&str, &str)]) {
    assert_eq!(circles_in(files), [] as [&str; 0]);
}

const ROOT: (&str, &str) = ("src/lib.rs", "mod a;\nmod b;\nmod c;\n");

#[test]
fn arrows_in_one_direction_are_no_circle() {
    assert_no_circle(&[
        ROOT,
        ("src/a.rs", "use crate::b::B;\npub struct A(B);"),
        (
            "src/b.rs",
            "use super::c::{self, C};\npub struct B(C, c::D);",
        ),
        ("src/c.rs", "pub struct C;\npub struct D;"),
    ]);
}

#[test]
fn two_files_that_import_each_other_are_a_circle() {
    let circles = circles_in(&[
        ROOT,
        ("src/a.rs", "use crate::b::B;\npub struct A(B);"),
        ("src/b.rs", "\n\nuse super::a::A;\npub struct B(A);"),
        ("src/c.rs", ""),
    ]);
    let expected = "\
src/a.rs:1 uses `crate::b::B` of src/b.rs
src/b.rs:3 uses `super::a::A` of src/a.rs
";
    assert_eq!(circles, [expected]);
}

#[test]
fn a_circle_goes_round_a_corner() {
    let circles = circles_in(&[
        ROOT,
        ("src/a.rs", "use crate::b::B;\npub struct A;"),
        (
            "src/b.rs",
            "pub struct B;\nfn f() -> crate::c::C { crate::c::C }",
        ),
        (
            "src/c.rs",
            "use crate::a;\npub struct C;\nfn f() { Some(a::A); }",
        ),
    ]);
    let expected = "\
src/a.rs:1 uses `crate::b::B` of src/b.rs
src/b.rs:2 uses `crate::c::C` of src/c.rs
src/c.rs:3 uses `a::A` of src/a.rs
";
    assert_eq!(circles, [expected]);
}

#[test]
fn a_folder_is_a_family() {
    let child = (
        "src/a/child.rs",
        "use super::Shared;\npub fn f(_: Shared) {}",
    );
    let parent = "mod child;\npub struct Shared;\npub fn g() { child::f(Shared) }";
    assert_no_circle(&[("src/lib.rs", "mod a;"), ("src/a/mod.rs", parent), child]);

    // Two children are strangers, and so is a file beside the folder.
    let one = ("src/a/one.rs", "use super::two::Two;\npub struct One;");
    let two = ("src/a/two.rs", "use super::one::One;\npub struct Two;");
    let parent = ("src/a/mod.rs", "mod one;\nmod two;");
    let circles = circles_in(&[("src/lib.rs", "mod a;"), parent, one, two]);
    assert_eq!(circles.len(), 1, "{circles:?}");
    let beside = ("src/b.rs", "use crate::a::A;\npub struct B;");
    let parent = ("src/a/mod.rs", "use crate::b::B;\npub struct A;");
    let circles = circles_in(&[("src/lib.rs", "mod a;\nmod b;"), parent, beside]);
    assert_eq!(circles.len(), 1, "{circles:?}");
}

#[test]
fn a_reexport_leads_to_the_file_that_defines_the_item() {
    let files = |a| {
        circles_in(&[
            (
                "src/lib.rs",
                "mod a;\nmod b;\nmod c;\npub use b::*;\npub use c::C as E;",
            ),
            ("src/a.rs", a),
            ("src/b.rs", "pub use crate::a::A;\npub struct B;"),
            ("src/c.rs", "use crate::A;\npub struct C;"),
        ])
    };
    assert_eq!(files("use crate::B;\npub struct A;"), [] as [&str; 0]);
    let expected = "\
src/a.rs:1 uses `crate::E` of src/c.rs
src/c.rs:1 uses `crate::A` of src/a.rs
";
    assert_eq!(files("use crate::E;\npub struct A;"), [expected]);
}

#[test]
fn a_reexport_that_its_own_file_uses_is_an_arrow() {
    let with_code = |code: &str| {
        let lib = format!("mod a;\npub use a::A;\npub struct B;\n{code}");
        circles_in(&[
            ("src/lib.rs", &lib),
            ("src/a.rs", "use crate::B;\npub struct A;"),
        ])
    };
    assert_eq!(with_code(""), [] as [&str; 0]);
    for code in ["pub fn f() -> A { loop {} }", "fn f() { A::new() }"] {
        assert_eq!(with_code(code).len(), 1, "{code}");
    }
}

#[test]
fn one_file_alone_is_no_circle() {
    assert_no_circle(&[
        ("src/main.rs", "mod a;"),
        (
            "src/a.rs",
            "pub struct A;\npub mod inner { pub use super::A; }\n\
             #[cfg(test)]\nmod tests { use super::*;\n#[test]\nfn f() { Some(A); inner::A; } }",
        ),
    ]);
}

#[test]
fn everything_of_a_module_is_only_what_is_used() {
    let with_code = |code: &str| {
        let a = format!("use crate::b::*;\npub struct A;\n{code}");
        circles_in(&[
            ROOT,
            ("src/a.rs", &a),
            (
                "src/b.rs",
                "use crate::a::A;\npub struct B;\npub fn make() {}",
            ),
            ("src/c.rs", ""),
        ])
    };
    assert_eq!(with_code(""), [] as [&str; 0]);
    assert_eq!(with_code("fn f(_: B) {}").len(), 1);
    assert_eq!(with_code("fn f() { make() }").len(), 1);
}

#[test]
fn words_that_name_nothing_are_no_arrows() {
    assert_no_circle(&[
        ROOT,
        ("src/a.rs", "use crate::b::*;\npub struct A;"),
        (
            "src/b.rs",
            "// crate::a::A\n/// [`crate::a::A`]\npub fn make() { let a = \"crate::a::A\"; a.A(); }\n\
             pub fn f<'A>(_: &'A str) -> impl Sized + use<'A> { std::a::A }",
        ),
        ("src/c.rs", ""),
    ]);
}

#[test]
fn an_exported_macro_is_named_as_an_item_of_the_root() {
    let circles = circles_in(&[
        ("src/lib.rs", "mod a;\nmod b;"),
        (
            "src/a.rs",
            "use crate::b::B;\n#[macro_export]\nmacro_rules! m { () => {} }",
        ),
        ("src/b.rs", "pub struct B;\nfn f() { crate::m!() }"),
    ]);
    assert_eq!(circles.len(), 1, "{circles:?}");
}

#[test]
fn items_in_the_braces_of_a_macro_belong_to_the_module() {
    let circles = circles_in(&[
        ("src/lib.rs", "#[macro_use]\nmod m;\nmod a;\nmod b;"),
        ("src/m.rs", "macro_rules! m { ($item:item) => { $item } }"),
        (
            "src/a.rs",
            "use crate::b::B;\nm! { /// One.\n pub enum A { One } }",
        ),
        ("src/b.rs", "pub struct B(crate::a::A);"),
    ]);
    assert_eq!(circles.len(), 1, "{circles:?}");
}

#[test]
fn what_is_not_understood_is_an_error() {
    let error = |files: &[(&str, &str)]| {
        let file = |&(path, text): &(&str, &str)| (path.to_owned(), text.to_owned());
        arrows(&files.iter().map(file).collect()).expect_err("a mistake")
    };
    let lib = |text| ("src/lib.rs", text);
    assert_eq!(error(&[lib("mod a;")]), "src/a.rs is missing");
    assert_eq!(
        error(&[lib(""), ("src/a.rs", "")]),
        "src/a.rs is in no crate"
    );
    assert_eq!(
        error(&[lib("\nuse crate::a::A;")]),
        "src/lib.rs:2: what is `crate::a::A`?"
    );
    assert!(error(&[lib("fn f() {")]).starts_with("src/lib.rs: "));
}
