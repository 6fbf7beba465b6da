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

/// `xy`, `zyx`, `xxxx`: two to four components.
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

const NO_ENUMERATIONS: &str = "kernels have no enumerations; use `u32` constants and `match`";

/// What to write instead of `Type::name(..)`, if that is not part of the language.
pub(crate) fn associated_function(ty: &str, name: &str) -> Option<String> {
    match name {
        "new" | "splat" | "from_cols" if is_glam(ty) => None,
        "from_bits" if ty == "f32" => None,
        _ if is_glam(ty) && !allowed(name) => {
            Some("vectors are built by `new` and `splat`, matrices by `from_cols`".to_owned())
        }
        "from" | "try_from" => Some(format!("write `x as {ty}`")),
        _ if allowed(name) => Some(format!("write it as a method, `x.{name}(..)`")),
        _ if is_primitive(ty) => Some(instead(name)),
        _ if name.starts_with(char::is_uppercase) => Some(NO_ENUMERATIONS.to_owned()),
        "new" | "default" => Some(format!("write `{ty} {{ field: value, .. }}`")),
        _ => Some("write a free function under `#[kernel]` and call that".to_owned()),
    }
}

/// What to write instead of `Type::NAME`, if that is not part of the language.
pub(crate) fn associated_constant(ty: &str, name: &str) -> Option<String> {
    match name {
        "INFINITY" | "NEG_INFINITY" | "NAN" => {
            Some("no shading language has a literal for it; test for the case before it arises".to_owned())
        }
        "MAX" | "MIN" if is_primitive(ty) => None,
        "MIN_POSITIVE" | "EPSILON" if ty == "f32" => None,
        "ZERO" | "ONE" | "NEG_ONE" | "X" | "Y" | "Z" | "W" | "NEG_X" | "NEG_Y" | "NEG_Z" | "NEG_W"
        | "IDENTITY"
            if is_glam(ty) =>
        {
            None
        }
        _ if is_glam(ty) || is_primitive(ty) => Some("write its value out".to_owned()),
        _ if name.contains(char::is_lowercase) => Some(NO_ENUMERATIONS.to_owned()),
        _ => Some("declare a `#[kernel] const` outside of the type".to_owned()),
    }
}

fn is_primitive(ty: &str) -> bool {
    matches!(ty, "f32" | "i32" | "u32" | "bool")
}

fn is_glam(ty: &str) -> bool {
    let kind = ty.trim_end_matches(['2', '3', '4']);
    kind.len() + 1 == ty.len() && matches!(kind, "Vec" | "IVec" | "UVec" | "BVec" | "Mat")
}
