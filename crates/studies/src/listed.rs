//! Enums that are tables.

/// An enum whose values stand in a table: `ALL` lists them in its order, and a method gives the entry of each.
///
/// ```text
/// listed! {
///     /// What it is.
///     pub enum Name { words: &'static str;
///         /// Meaning of a value.
///         Value = "its words",
///     }
/// }
/// ```
macro_rules! listed {
    ($(#[$about:meta])* $vis:vis enum $name:ident { $entry:ident: $type:ty; $($(#[$meaning:meta])* $value:ident = $of_value:expr,)+ }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        $vis enum $name { $($(#[$meaning])* $value,)+ }

        impl $name {
            /// All of them, in the order of tables.
            $vis const ALL: [Self; [$(stringify!($value)),+].len()] = [$(Self::$value),+];

            /// Its entry in the table.
            $vis const fn $entry(self) -> $type {
                match self { $(Self::$value => $of_value,)+ }
            }
        }
    };
}

pub(crate) use listed;
