//! Earthquake-induced structural pounding: the program and the library.
