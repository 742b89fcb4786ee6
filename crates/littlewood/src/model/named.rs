//! Enumerations whose items have a name and a number, each written once.

use thiserror::Error;

/// A name that a table does not have.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no {noun} named '{name}'; there are {}", known.join(", "))]
pub struct UnknownName {
    /// What was looked for.
    pub noun: &'static str,
    /// The name that was given.
    pub name: String,
    /// The names that there are.
    pub known: &'static [&'static str],
}

/// A number that a table does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("there is no {noun} with the code {code}")]
pub struct UnknownCode {
    /// What was looked for.
    pub noun: &'static str,
    /// The number that was given.
    pub code: u8,
}

/// Declares an enumeration with the name and the number of each item, and what follows from them: `ALL`, `NAMES`,
/// `name`, `code`, `Display`, `FromStr`, `TryFrom<u8>`, and with the feature `serde` the names in text formats. An item may have a row
/// of what else is known of it, which a function of the given name returns.
macro_rules! named {
    (
        $(#[$meta:meta])*
        pub enum $Type:ident, $noun:literal, $(#[$row_meta:meta])* $row_vis:vis $row:ident: $Row:ty {
            $( $(#[$item_meta:meta])* $Item:ident = $code:literal, $name:literal => $value:expr; )+
        }
    ) => {
        $crate::model::named::named! {
            $(#[$meta])*
            pub enum $Type, $noun {
                $( $(#[$item_meta])* $Item = $code, $name; )+
            }
        }

        impl $Type {
            $(#[$row_meta])*
            #[inline(always)]
            #[must_use]
            $row_vis const fn $row(self) -> $Row {
                match self {
                    $( Self::$Item => $value, )+
                }
            }
        }
    };
    (
        $(#[$meta:meta])*
        pub enum $Type:ident, $noun:literal {
            $( $(#[$item_meta:meta])* $Item:ident = $code:literal, $name:literal; )+
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[repr(u8)]
        pub enum $Type {
            $( $(#[$item_meta])* #[cfg_attr(feature = "serde", serde(rename = $name))] $Item = $code, )+
        }

        impl $Type {
            /// All items, in order.
            pub const ALL: [Self; [$( $code ),+].len()] = [$( Self::$Item ),+];

            /// Their names, in the same order.
            pub const NAMES: [&'static str; [$( $code ),+].len()] = [$( $name ),+];

            /// Lower-case name, as files, flags and programs write it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $( Self::$Item => $name, )+
                }
            }

            /// Number, as arrays hold it.
            #[must_use]
            pub const fn code(self) -> u8 {
                self as u8
            }
        }

        impl core::fmt::Display for $Type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.pad(self.name())
            }
        }

        impl core::str::FromStr for $Type {
            type Err = $crate::model::named::UnknownName;

            fn from_str(name: &str) -> Result<Self, Self::Err> {
                match name {
                    $( $name => Ok(Self::$Item), )+
                    _ => Err($crate::model::named::UnknownName {
                        noun: $noun,
                        name: name.to_owned(),
                        known: &Self::NAMES,
                    }),
                }
            }
        }

        impl TryFrom<u8> for $Type {
            type Error = $crate::model::named::UnknownCode;

            fn try_from(code: u8) -> Result<Self, Self::Error> {
                match code {
                    $( $code => Ok(Self::$Item), )+
                    _ => Err($crate::model::named::UnknownCode { noun: $noun, code }),
                }
            }
        }
    };
}

pub(crate) use named;
