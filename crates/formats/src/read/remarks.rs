//! Remarks as a reader makes them: kinds of things that it ignores, each with its number.
//!
//! Names come from the file, so that there may be any number of kinds: [`MOST_NAMES`] are said. So a remark costs no more
//! than a short search.

use crate::Remark;
use crate::read::source::quoted;

/// So many kinds of ignored things are named.
const MOST_NAMES: usize = 12;

/// The names of one thing and of many, where there are more kinds.
const OTHERS: [&str; 2] = ["thing of another kind", "things of other kinds"];

/// What a reader has to say, as it goes on.
#[derive(Default)]
pub(super) struct Remarks {
    ignored: Vec<Ignored>,
    others: Vec<Remark>,
}

/// Things of one kind that are ignored.
struct Ignored {
    /// The name of one thing and of many.
    kind: [&'static str; 2],
    /// What the file calls them, or nothing.
    name: Vec<u8>,
    count: usize,
}

impl Remarks {
    /// Adds so many things that are ignored, with the name of one and of many.
    pub(super) fn ignore(&mut self, count: usize, one: &'static str, many: &'static str) {
        self.ignore_named(count, [one, many], b"");
    }

    /// Adds things that are ignored, with the name of one and of many, and what the file calls them.
    pub(super) fn ignore_named(&mut self, count: usize, kind: [&'static str; 2], name: &[u8]) {
        if count == 0 {
            return;
        }
        let mut ignored = self.ignored.iter();
        let place = ignored.position(|other| other.kind == kind && other.name == name);
        match place.or((self.ignored.len() == MOST_NAMES).then_some(MOST_NAMES - 1)) {
            Some(place) => self.ignored[place].count += count,
            None => {
                // The last name stands for all that follow.
                let is_last = self.ignored.len() + 1 == MOST_NAMES;
                let (kind, name) = if is_last {
                    (OTHERS, &b""[..])
                } else {
                    (kind, name)
                };
                let name = name.to_vec();
                self.ignored.push(Ignored { kind, name, count });
            }
        }
    }

    pub(super) fn add(&mut self, remark: Remark) {
        self.others.push(remark);
    }

    pub(super) fn into_list(self) -> Vec<Remark> {
        let remark = |Ignored { kind, name, count }| {
            let shown = match &name[..] {
                b"" => String::new(),
                name => format!(" {}", quoted(name)),
            };
            let [one, many] = kind.map(|kind| format!("{kind}{shown}"));
            Remark::ignored(count, &one, &many)
        };
        let ignored = self.ignored.into_iter().map(remark);
        self.others.into_iter().chain(ignored).collect()
    }
}
