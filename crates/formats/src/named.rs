//! Formats by name.

/// A format, named by the extension of its files.
///
/// ```
/// use sweep_cdt_formats::{InputFormat, Named, OutputFormat};
///
/// assert_eq!(InputFormat::named("POLY"), Some(InputFormat::Poly));
/// assert_eq!(OutputFormat::Ele.name(), "ele");
/// let names: Vec<&str> = InputFormat::ALL.iter().map(|format| format.name()).collect();
/// assert_eq!(names[..3], ["node", "poly", "json"]);
/// ```
pub trait Named: Copy + 'static {
    /// All formats of this kind.
    const ALL: &'static [Self];

    /// The name, in lower case.
    fn name(self) -> &'static str;

    /// The format of a name, whatever its case.
    fn named(name: &str) -> Option<Self> {
        let mut all = Self::ALL.iter().copied();
        all.find(|format| format.name().eq_ignore_ascii_case(name))
    }
}

/// Makes an enum whose variants have names. A variant with an attribute `cfg` may be missing.
macro_rules! named {
    (
        $(#[$of_type:meta])*
        pub enum $Format:ident {
            $($(#[doc = $doc:literal])+ $(#[cfg($cfg:meta)])? $Variant:ident = $name:literal,)*
        }
    ) => {
        $(#[$of_type])*
        pub enum $Format {
            $($(#[doc = $doc])+ $(#[cfg($cfg)])? $Variant,)*
        }

        impl $crate::Named for $Format {
            const ALL: &'static [$Format] = &[$($(#[cfg($cfg)])? $Format::$Variant,)*];

            fn name(self) -> &'static str {
                match self {
                    $($(#[cfg($cfg)])? $Format::$Variant => $name,)*
                }
            }
        }
    };
}
