//! Enums that are tables.

/// Defines an enum together with a table of its values: `ALL` lists the values in the order of the table, and a method gives the entry of
/// each.
///
/// ```text
/// listed! {
///     /// What it is.
/// /// Meaning of the enum.
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
            /// All values, in the order of tables.
            $vis const ALL: [Self; [$(stringify!($value)),+].len()] = [$(Self::$value),+];

            /// The entry of this value in the table.
            $vis const fn $entry(self) -> $type {
                match self { $(Self::$value => $of_value,)+ }
            }
        }
    };
}

pub(crate) use listed;
