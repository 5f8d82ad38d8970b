//! Text that a terminal shows and does not obey.

/// The text with its control characters escaped. File names may hold any of them but zero.
pub(crate) fn printable(text: &str) -> String {
    escaped(text, char::is_control)
}

/// The same for text of several lines.
pub(crate) fn printable_lines(text: &str) -> String {
    escaped(text, |character| {
        character != '\n' && character.is_control()
    })
}

fn escaped(text: &str, is_unsafe: impl Fn(char) -> bool) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        if is_unsafe(character) {
            escaped.extend(character.escape_default());
        } else {
            escaped.push(character);
        }
    }
    escaped
}
