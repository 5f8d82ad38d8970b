//! The table of properties: how bytes stand for an input, and how seeds are made of an input.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use sweep_cdt_testing::Input;
use sweep_cdt_testing::generators::{self, BYTES};

use crate::file::File;
use crate::{
    bits, canonical, differential, edits, formats, fronts, replay, scalars, shown, stream, valid,
    verify,
};

/// The choice made by the bytes before those of the generated input, and these bytes.
pub type Lead = (&'static str, &'static [u8]);

/// A property by its name.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// As its fuzz target and its file of seeds are called.
    pub name: &'static str,
    /// Panics if the property does not hold for what the bytes stand for.
    pub test: fn(&[u8]),
    /// The points and edges that the bytes stand for, if the property tests these.
    pub input: fn(&[u8]) -> Option<Input>,
    /// The files that the bytes stand for, beside points and edges.
    pub files: fn(&[u8]) -> Vec<File>,
    /// A fuzzer makes inputs of at most so many bytes: what the property can read of an input of [`BYTES`].
    pub max_len: usize,
    /// Bytes that stand for points and edges, if there are any.
    encode: fn(&Input) -> Option<Vec<u8>>,
    /// The bytes before these: a seed is made with each.
    leads: &'static [Lead],
}

/// All properties.
pub const TARGETS: &[Target] = &[
    GENERATED.named("valid", valid::test),
    Target {
        input: |bytes| Some(bits::input(bytes)),
        encode: bits::encode,
        max_len: bits::BYTES,
        ..GENERATED.named("bits", bits::test)
    },
    Target {
        leads: SCALARS,
        ..CHOOSING.named("scalars", scalars::test)
    },
    Target {
        input: fronts::input,
        files: fronts::files,
        ..CHOOSING.named("fronts", fronts::test)
    },
    CHOOSING.named("canonical", canonical::test),
    Target {
        files: replay::files,
        leads: DAMAGES,
        ..CHOOSING.named("replay", replay::test)
    },
    Target {
        input: |_| None,
        files: verify::files,
        max_len: verify::LEAD + BYTES,
        leads: CHANGES,
        ..GENERATED.named("verify", verify::test)
    },
    Target {
        input: |_| None,
        files: formats::files,
        max_len: formats::BYTES,
        leads: FILES,
        ..GENERATED.named("formats", formats::test)
    },
    GENERATED.named("differential", differential::test),
    Target {
        leads: WINDOWS,
        ..CHOOSING.named("stream", stream::test)
    },
    CHOOSING.named("edits", edits::test),
];

/// A target whose bytes are those of a generated input.
const GENERATED: Target = Target {
    name: "",
    test: |_| {},
    input: |bytes| Some(generators::input(bytes)),
    files: |_| Vec::new(),
    max_len: BYTES,
    encode: generators::encode,
    leads: &[("nothing", &[])],
};

/// A target whose bytes are a number of eight bytes, for what it chooses itself, and those of a generated
/// input.
const CHOOSING: Target = Target {
    input: |bytes| Some(generators::input_with_choices(bytes).1),
    max_len: 8 + BYTES,
    leads: &[("the first of everything", &[0; 8])],
    ..GENERATED
};

/// The first byte chooses the scalar or the sort of numbers, the second the heuristics, the third which
/// numbers.
const SCALARS: &[Lead] = &[
    ("f32", &[0; 8]),
    ("machine integers", &[1; 8]),
    ("big integers", &[2; 8]),
    ("rationals", &[3; 8]),
    ("the plainest scalar", &[4; 8]),
    ("far from zero", &[5; 8]),
    ("divided", &[6; 8]),
    ("over the whole range of i64", &[7; 8]),
];

/// The first byte chooses the scalar, the second the window or the bands, the third the front, the fourth an altered result.
const WINDOWS: &[Lead] = &[
    ("fractions, windows of one vertex", &[0; 8]),
    ("integers, windows of two", &[1, 1, 1, 1, 0, 0, 0, 0]),
    ("doubles, the range of x known", &[2, 4, 2, 2, 0, 0, 0, 0]),
    (
        "doubles, windows of seven, the range known",
        &[3, 6, 0, 3, 0, 0, 0, 0],
    ),
    ("fractions, bands of one vertex", &[0, 8, 0, 0, 0, 0, 0, 0]),
    ("integers, bands of two", &[1, 9, 0, 1, 0, 0, 0, 0]),
    ("doubles, bands of up to seven", &[2, 10, 0, 2, 0, 0, 0, 0]),
];

/// The number is the seed of random damage.
const DAMAGES: &[Lead] = &[
    ("first damage", &[0; 8]),
    ("second damage", &[1; 8]),
    ("third damage", &[2; 8]),
    ("fourth damage", &[3; 8]),
    ("fifth damage", &[4; 8]),
    ("sixth damage", &[5; 8]),
];

/// The first byte says how many changes there are, each of four bytes: the kind, and where.
const CHANGES: &[Lead] = &[
    ("a triangle twice", &[1, 2, 1, 0, 3]),
    (
        "a triangle turned over, another one rotated",
        &[2, 3, 1, 0, 3, 4, 7, 2, 1],
    ),
];

/// The first byte says that a generated input follows, and in which style it is written; the second which
/// file is read again, or that the trace is; the other twelve are three damages. Of a file in a form of other
/// programs four bytes choose this form.
const FILES: &[Lead] = &[
    ("a damaged file", &[8; 14]),
    ("a trace", &[250; 14]),
    ("a binary mesh of another program", &[11, 5, 21, 7, 193, 95]),
];

impl Target {
    const fn named(self, name: &'static str, test: fn(&[u8])) -> Target {
        Target { name, test, ..self }
    }

    /// Writes what the bytes stand for into a folder.
    ///
    /// # Errors
    /// If the folder cannot be written.
    pub fn show(&self, bytes: &[u8], folder: &Path) -> std::io::Result<()> {
        shown::show((self.input)(bytes), self.files, bytes, folder)
    }

    /// Bytes to begin with that stand for this input, once after each lead.
    pub fn seeds(&self, input: &Input) -> Vec<Vec<u8>> {
        let bytes = (self.encode)(input);
        bytes.map_or_else(Vec::new, |bytes| self.after_leads(&bytes))
    }

    /// The bytes of a generated input, once after each lead.
    pub fn after_leads(&self, bytes: &[u8]) -> Vec<Vec<u8>> {
        let leads = self.leads.iter();
        leads.map(|(_, lead)| [lead, bytes].concat()).collect()
    }
}

/// The target of this name.
///
/// # Errors
/// If there is none.
pub fn named(name: &str) -> Result<&'static Target, String> {
    let found = TARGETS.iter().find(|target| target.name == name);
    found.ok_or_else(|| format!("there is no property {name}"))
}

/// The body of a fuzz target. With the environment variable `SWEEP_CDT_SHOW` set to a folder, what the bytes stand for is
/// written there, and nothing is tested.
///
/// # Panics
/// If the property does not hold, or the folder cannot be written.
pub fn fuzz(target: &Target, bytes: &[u8]) {
    static FOLDER: OnceLock<Option<PathBuf>> = OnceLock::new();
    match FOLDER.get_or_init(|| std::env::var_os("SWEEP_CDT_SHOW").map(PathBuf::from)) {
        Some(folder) => target.show(bytes, folder).expect("a folder to write to"),
        None => (target.test)(bytes),
    }
}

/// A fuzz target. Its mutations are of no more bytes than it can read.
#[macro_export]
macro_rules! target {
    ($name:ident) => {
        fn target() -> &'static $crate::Target {
            $crate::named(stringify!($name)).expect("a property of this name")
        }

        libfuzzer_sys::fuzz_target!(|bytes: &[u8]| $crate::fuzz(target(), bytes));

        libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, most: usize, _seed: u32| {
            let most = most.min(target().max_len);
            libfuzzer_sys::fuzzer_mutate(data, size.min(most), most)
        });
    };
}

#[test]
fn seeds_stand_for_their_input() {
    let wanted = Input::parse("0 0, 3 0, 3 2, -5 7", "0 2, 1 3");
    for target in TARGETS {
        for bytes in target.seeds(&wanted) {
            let found = (target.input)(&bytes);
            assert!(
                found.is_none_or(|found| found.to_string() == wanted.to_string()),
                "{}",
                target.name
            );
        }
    }
}

#[test]
fn a_fuzzer_does_not_cut_seeds_off() {
    for target in TARGETS {
        let seeds = crate::seeds::read(&crate::seeds::path(target.name)).expect("a file of seeds");
        let longest = seeds.keys().map(Vec::len).max();
        assert!(longest <= Some(target.max_len), "{}", target.name);
    }
}
