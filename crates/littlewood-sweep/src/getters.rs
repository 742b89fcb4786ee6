//! Methods that return a part of an item, stated as the core states them.

/// Methods without arguments: `name(self) -> Type = value`.
macro_rules! getters {
    ($Type:ty: $( $(#[$meta:meta])* $name:ident($self:ident) -> $T:ty = $value:expr; )+) => {
        impl $Type {
            $(
                $(#[$meta])*
                pub const fn $name(&$self) -> $T {
                    $value
                }
            )+
        }
    };
}

pub(crate) use getters;
