//! The words under a panel: a title, and a text broken into lines.

use std::io::{self, Write};

use super::window::PIXEL;

/// Room for a title and three lines of text.
pub(super) const HEIGHT: i64 = 86 * PIXEL;
const LINE: i64 = 18 * PIXEL;
/// About the width of a letter.
const LETTER: i64 = 7 * PIXEL;

/// The style rules of its classes.
pub(super) fn rules() -> String {
    format!(
        ".title {{ font-size: {}px; font-weight: bold }}\n\
         .caption {{ font-size: {}px }}\n",
        15 * PIXEL,
        13 * PIXEL
    )
}

/// Writes a caption with its upper left corner at a place, `width` units wide.
pub(super) fn write(
    out: &mut impl Write,
    [x, y]: [i64; 2],
    width: i64,
    title: &str,
    text: &str,
) -> io::Result<()> {
    let mut baseline = y + LINE;
    writeln!(
        out,
        "<text class=\"title\" x=\"{x}\" y=\"{baseline}\">{title}</text>"
    )?;
    let letters = usize::try_from(width / LETTER).unwrap_or(0);
    for line in wrapped(text, letters) {
        baseline += LINE;
        writeln!(
            out,
            "<text class=\"caption\" x=\"{x}\" y=\"{baseline}\">{line}</text>"
        )?;
    }
    Ok(())
}

/// The words of a text in lines of at most `letters` letters; a longer word has a line of its own.
fn wrapped(text: &str, letters: usize) -> Vec<String> {
    let length = |text: &str| text.chars().count();
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if length(line) + 1 + length(word) <= letters => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::wrapped;

    #[test]
    fn lines_are_full_and_not_overfull() {
        assert_eq!(wrapped("", 5), Vec::<String>::new());
        assert_eq!(wrapped("a bc def", 4), ["a bc", "def"]);
        assert_eq!(wrapped("a bc def", 3), ["a", "bc", "def"]);
        assert_eq!(wrapped("–– –– incircle –", 5), ["–– ––", "incircle", "–"]);
    }
}
