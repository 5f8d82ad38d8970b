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

/// Defines an enum of formats, each with its name. The variants after `with mesh-formats` are there with this feature.
macro_rules! formats {
    (
        $(#[$attribute:meta])*
        pub enum $Format:ident {
            $($(#[$doc:meta])* $Variant:ident = $name:literal,)*
        }
        $(with mesh-formats {
            $($(#[$mesh_doc:meta])* $Mesh:ident = $mesh_name:literal,)*
        })?
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum $Format {
            $($(#[$doc])* $Variant,)*
            $($(
                $(#[$mesh_doc])*
                #[cfg(feature = "mesh-formats")]
                $Mesh,
            )*)?
        }

        impl $crate::Named for $Format {
            const ALL: &'static [$Format] = &[
                $($Format::$Variant,)*
                $($(
                    #[cfg(feature = "mesh-formats")]
                    $Format::$Mesh,
                )*)?
            ];

            fn name(self) -> &'static str {
                match self {
                    $($Format::$Variant => $name,)*
                    $($(
                        #[cfg(feature = "mesh-formats")]
                        $Format::$Mesh => $mesh_name,
                    )*)?
                }
            }
        }
    };
}

pub(crate) use formats;
