//! What must hold of every triangulation, as functions of bytes: the bodies of the fuzz targets.
//!
//! [`generators`] turn bytes into points and edges that are degenerate nearly every time; [`oracle`] tells
//! in exact integers, with no code of the crate, what must come out; each other module is one property,
//! named as its fuzz target in `fuzz/fuzz_targets`, which panics where the property does not hold. All of
//! this runs without a fuzzer too: the crate's own tests give it random bytes and the corpus.

pub mod bits;
pub mod canonical;
pub mod differential;
pub mod formats;
pub mod fronts;
pub mod generators;
pub mod input;
pub mod minimize;
pub mod oracle;
pub mod peers;
pub mod random;
pub mod reached;
pub mod replay;
pub mod runs;
pub mod scalars;
pub mod steps;
pub mod valid;
pub mod verify;

pub use input::Input;

/// A property by its name.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// As its fuzz target and its folder of seeds are called.
    pub name: &'static str,
    /// Panics if the property does not hold for what the bytes stand for.
    pub test: fn(&[u8]),
    /// The points and edges that the bytes stand for, if it is those that are tested.
    pub input: fn(&[u8]) -> Option<Input>,
    /// Bytes that stand for points and edges, if there are any.
    encode: fn(&Input) -> Option<Vec<u8>>,
    /// The property's own choices, which come before those: seeds are made with each of them.
    choices: &'static [&'static [u8]],
}

/// All properties.
pub const TARGETS: &[Target] = &[
    GENERATED.named("valid", valid::test),
    Target {
        input: |bytes| Some(bits::input(bytes)),
        encode: bits::encode,
        ..GENERATED.named("bits", bits::test)
    },
    Target {
        choices: &[
            &[0; 8], &[1; 8], &[2; 8], &[3; 8], &[4; 8], &[5; 8], &[6; 8], &[7; 8],
        ],
        ..CHOOSING.named("scalars", scalars::test)
    },
    Target {
        input: fronts::input,
        ..CHOOSING.named("fronts", fronts::test)
    },
    CHOOSING.named("canonical", canonical::test),
    Target {
        choices: &[&[0; 8], &[1; 8], &[2; 8], &[3; 8], &[4; 8], &[5; 8]],
        ..CHOOSING.named("replay", replay::test)
    },
    Target {
        input: |_| None,
        choices: &[&[1, 2, 1, 0, 3], &[2, 3, 1, 0, 3, 4, 7, 2, 1]],
        ..GENERATED.named("verify", verify::test)
    },
    Target {
        input: |_| None,
        choices: &[&[8; 14], &[250; 14]],
        ..GENERATED.named("formats", formats::test)
    },
    GENERATED.named("differential", differential::test),
];

/// A target whose bytes are those of a generated input.
const GENERATED: Target = Target {
    name: "",
    test: |_| {},
    input: |bytes| Some(generators::input(bytes)),
    encode: generators::encode,
    choices: &[&[]],
};

/// A target whose bytes are choices of its own and those of a generated input.
const CHOOSING: Target = Target {
    input: |bytes| Some(generators::input_with_choices(bytes).1),
    choices: &[&[0; 8]],
    ..GENERATED
};

impl Target {
    const fn named(self, name: &'static str, test: fn(&[u8])) -> Target {
        Target { name, test, ..self }
    }

    /// Bytes to begin with that stand for this input, once for each of some choices.
    pub fn seeds(&self, input: &Input) -> Vec<Vec<u8>> {
        let Some(bytes) = (self.encode)(input) else {
            return Vec::new();
        };
        self.after_choices(&bytes)
    }

    /// These bytes of a generated input, once after each of some choices.
    pub fn after_choices(&self, bytes: &[u8]) -> Vec<Vec<u8>> {
        let choices = self.choices.iter();
        choices.map(|lead| [*lead, bytes].concat()).collect()
    }
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
