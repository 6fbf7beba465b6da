//! Methods that kernels may call, and what to write instead of others.

/// Methods whose native result is the same on every machine and has a shader form.
const ALLOWED: &[&str] = &[
    "abs",
    "cmpeq",
    "cmpge",
    "cmpgt",
    "cmple",
    "cmplt",
    "cmpne",
    "cross",
    "dot",
    "extend",
    "is_negative_bitmask",
    "length",
    "length_squared",
    "len",
    "mul_add",
    "recip",
    "sqrt",
    "to_bits",
    "truncate",
    "wrapping_add",
    "wrapping_mul",
    "wrapping_sub",
];

/// Whether the method is part of the language.
pub(crate) fn allowed(name: &str) -> bool {
    ALLOWED.contains(&name) || is_swizzle(name)
}

/// `xy`, `zyx`, `xxxx`: at least two components, none assigned twice matters not.
fn is_swizzle(name: &str) -> bool {
    (2..=4).contains(&name.len()) && name.chars().all(|c| "xyzw".contains(c))
}

/// What to write instead of a method that is not allowed.
pub(crate) fn instead(name: &str) -> String {
    let function = match name {
        "ln" => "log",
        "powf" => "pow",
        "signum" => "sign",
        "rsqrt" => "inverse_sqrt",
        "lerp" => "mix",
        "to_degrees" => "degrees",
        "to_radians" => "radians",
        "round_ties_even" => "round",
        "count_ones" => "count_one_bits",
        "leading_zeros" => "count_leading_zeros",
        "trailing_zeros" => "count_trailing_zeros",
        "acos" | "acosh" | "all" | "any" | "asin" | "asinh" | "atan" | "atan2" | "atanh" | "ceil"
        | "clamp" | "cos" | "cosh" | "distance" | "exp" | "exp2" | "floor" | "fract" | "log2" | "max"
        | "min" | "normalize" | "reflect" | "refract" | "reverse_bits" | "round" | "saturate" | "sin"
        | "sinh" | "step" | "tan" | "tanh" | "transpose" | "trunc" => name,
        "powi" => return "multiply, or write `pow(x, n)`".to_owned(),
        "exp_m1" | "ln_1p" => return "no shading language has it; use a series kernel".to_owned(),
        "sin_cos" => return "write `sin(x)` and `cos(x)`".to_owned(),
        "iter" | "iter_mut" | "into_iter" => return "write `for i in 0..n` and index".to_owned(),
        "clone" | "to_owned" | "into" => return "kernel values are `Copy`; leave it out".to_owned(),
        "unwrap" | "expect" => return "kernels have no `Option` or `Result`".to_owned(),
        "is_nan" => return "write `x != x`".to_owned(),
        "fetch_add" | "load" | "store" => {
            return "write `atomic_add(&a, 1)`, `atomic_load(&a)`, ..".to_owned();
        }
        _ => return "write a free function under `#[kernel]` and call that".to_owned(),
    };
    format!("write the function `{function}(..)` of the prelude, whose bits are the same on every machine")
}
