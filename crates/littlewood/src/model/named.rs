//! Enumerations with a name and a code for each item.

use thiserror::Error;

/// An unknown name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no {noun} named '{name}'; there are {}", known.join(", "))]
pub struct UnknownName {
    /// Kind of item.
    pub noun: &'static str,
    /// The unknown name.
    pub name: String,
    /// The known names.
    pub known: &'static [&'static str],
}

/// An unknown code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("there is no {noun} with the code {code}")]
pub struct UnknownCode {
    /// Kind of item.
    pub noun: &'static str,
    /// The unknown code.
    pub code: u8,
}

/// Declares an enumeration with the name and the code of each item, and derives `ALL`, `NAMES`,
/// `name`, `code`, `Display`, `FromStr`, `TryFrom<u8>` and, with the feature `serde`, the names in
/// text formats. Items may have a further value, which a method of the given name returns.
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

            /// All names, in the order of `ALL`.
            pub const NAMES: [&'static str; [$( $code ),+].len()] = [$( $name ),+];

            /// Lower-case name in files, flags and programs.
            pub const fn name(self) -> &'static str {
                match self {
                    $( Self::$Item => $name, )+
                }
            }

            /// Code in arrays.
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

/// Methods without arguments that return a part of an item: `name: Type = value`.
macro_rules! getters {
    (
        $Type:ty, $receiver:tt:
        $( $(#[$meta:meta])* $vis:vis $name:ident: $T:ty = $value:expr; )+
    ) => {
        impl $Type {
            $( $crate::model::named::getter! { $receiver $(#[$meta])* $vis $name: $T = $value } )+
        }
    };
}

/// One of [`getters`], of `self` or, in brackets, of `&self`.
macro_rules! getter {
    ([$self:ident] $(#[$meta:meta])* $vis:vis $name:ident: $T:ty = $value:expr) => {
        $(#[$meta])*
        $vis const fn $name(&$self) -> $T {
            $value
        }
    };
    ($self:ident $(#[$meta:meta])* $vis:vis $name:ident: $T:ty = $value:expr) => {
        $(#[$meta])*
        $vis const fn $name($self) -> $T {
            $value
        }
    };
}

/// Methods that return the same value with other fields.
macro_rules! setters {
    ($Type:ty: $( $(#[$meta:meta])* $name:ident($($field:ident: $T:ty),+); )+) => {
        impl $Type {
            $(
                $(#[$meta])*
                #[must_use]
                pub const fn $name(self, $($field: $T),+) -> Self {
                    Self { $($field,)+ ..self }
                }
            )+
        }
    };
}

pub(crate) use {getter, getters, named, setters};
