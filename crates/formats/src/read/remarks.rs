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
    /// The names of one thing and of many, and how many are ignored.
    ignored: Vec<(String, String, usize)>,
    others: Vec<Remark>,
}

impl Remarks {
    /// Adds so many things that are ignored, with the name of one and of many.
    pub(super) fn ignore(&mut self, count: usize, one: &str, many: &str) {
        if count == 0 {
            return;
        }
        let place = self.ignored.iter().position(|(name, ..)| name == one);
        match place.or((self.ignored.len() == MOST_NAMES).then_some(MOST_NAMES - 1)) {
            Some(place) => self.ignored[place].2 += count,
            None => {
                // The last name stands for all that follow.
                let is_last = self.ignored.len() + 1 == MOST_NAMES;
                let names = if is_last { OTHERS } else { [one, many] };
                let [one, many] = names.map(str::to_owned);
                self.ignored.push((one, many, count));
            }
        }
    }

    /// Adds things that are ignored, whose kind the file names.
    pub(super) fn ignore_named(&mut self, count: usize, what: &str, name: &[u8]) {
        let name = quoted(name);
        self.ignore(count, &format!("{what} {name}"), &format!("{what}s {name}"));
    }

    /// Adds lines with this keyword.
    pub(super) fn ignore_lines(&mut self, count: usize, keyword: &[u8]) {
        let name = quoted(keyword);
        self.ignore(
            count,
            &format!("line of {name}"),
            &format!("lines of {name}"),
        );
    }

    #[cfg(feature = "mesh-formats")]
    pub(super) fn add(&mut self, remark: Remark) {
        self.others.push(remark);
    }

    pub(super) fn into_list(self) -> Vec<Remark> {
        let ignored = self.ignored.into_iter();
        let ignored = ignored.map(|(one, many, count)| Remark::ignored(count, &one, &many));
        self.others.into_iter().chain(ignored).collect()
    }
}
