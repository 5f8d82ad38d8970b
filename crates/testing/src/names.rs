//! Words of the command and of the lines: a list of values with their names, read in both directions.

use sweep_cdt::verify::Level;

/// The name of a value.
pub(crate) fn name_of<T: PartialEq>(all: &[(T, &'static str)], value: &T) -> &'static str {
    let found = all.iter().find(|(known, _)| known == value);
    found.map_or("", |(_, name)| name)
}

/// The value of a name, or a message with all names.
pub(crate) fn value_of<T: Copy>(all: &[(T, &'static str)], name: &str) -> Result<T, String> {
    let found = all.iter().find(|(_, known)| *known == name);
    let names: Vec<&str> = all.iter().map(|(_, name)| *name).collect();
    let error = || format!("`{name}` is none of {}", names.join(", "));
    found.map(|(value, _)| *value).ok_or_else(error)
}

/// The level of a name.
///
/// # Errors
/// A message with all names.
pub fn level(name: &str) -> Result<Level, String> {
    value_of(&Level::ALL.map(|level| (level, level.name())), name)
}
