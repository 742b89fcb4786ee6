//! Enumerations with a name for each item.

/// Declares an enumeration with the name of each item, and derives `ALL` and `name`.
macro_rules! named {
    ($(#[$meta:meta])* pub enum $Type:ident { $($(#[$item_meta:meta])* $Item:ident = $name:literal,)+ }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $Type {
            $($(#[$item_meta])* $Item,)+
        }

        impl $Type {
            /// All, in order.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$Item),+];

            /// Lower-case name.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$Item => $name,)+
                }
            }
        }
    };
}

pub(crate) use named;
