//! Values of kernels as JSON: what `lobe eval` reads and writes, and how cases are kept in files.
//!
//! A row of arguments is one object with the parameters' names.
//! A structure is an object with its fields' names, a vector or array is an array, a matrix an array of
//! its columns.
//! A float is a number, or a string: hexadecimal as `"0x1.8p3"`, `"nan"`, `"inf"`, `"-inf"`.

mod hex;
mod parse;
mod print;

pub use hex::{format_hex, format_hex_f64, parse_hex};
pub use parse::{RowError, parse_row, parse_rows};
pub use print::{Floats, args_json, value_json};
