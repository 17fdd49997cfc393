//! The built-in functions that exported code may call, and what other languages call them.

/// A built-in function: WGSL's name, GLSL's and HLSL's; Metal has WGSL's unless said otherwise below.
struct Builtin {
    wgsl: &'static str,
    glsl: &'static str,
    hlsl: &'static str,
    metal: &'static str,
}

/// One that all of them call the same.
const fn same(name: &'static str) -> Builtin {
    Builtin { wgsl: name, glsl: name, hlsl: name, metal: name }
}

const fn renamed(wgsl: &'static str, glsl: &'static str, hlsl: &'static str, metal: &'static str) -> Builtin {
    Builtin { wgsl, glsl, hlsl, metal }
}

/// All of them but `select`, which languages write in their own ways.
const BUILTINS: [Builtin; 46] = [
    same("abs"),
    same("acos"),
    same("all"),
    same("any"),
    same("asin"),
    same("atan"),
    renamed("atan2", "atan", "atan2", "atan2"),
    same("ceil"),
    same("clamp"),
    same("cos"),
    same("cosh"),
    same("cross"),
    same("degrees"),
    same("determinant"),
    same("distance"),
    same("dot"),
    same("exp"),
    same("exp2"),
    renamed("faceForward", "faceforward", "faceforward", "faceforward"),
    same("floor"),
    renamed("fract", "fract", "frac", "fract"),
    renamed("inverseSqrt", "inversesqrt", "rsqrt", "rsqrt"),
    same("length"),
    same("log"),
    same("log2"),
    same("max"),
    same("min"),
    renamed("mix", "mix", "lerp", "mix"),
    same("normalize"),
    same("pow"),
    same("radians"),
    same("reflect"),
    same("refract"),
    renamed("round", "roundEven", "round", "rint"),
    same("sign"),
    same("sin"),
    same("sinh"),
    same("smoothstep"),
    same("sqrt"),
    same("step"),
    same("tan"),
    same("tanh"),
    same("transpose"),
    same("trunc"),
    renamed("dpdx", "dFdx", "ddx", "dfdx"),
    renamed("dpdy", "dFdy", "ddy", "dfdy"),
];

fn builtin(name: &str) -> Option<&'static Builtin> {
    BUILTINS.iter().find(|builtin| builtin.wgsl == name)
}

/// Whether exported code may call it.
pub(super) fn is_known(name: &str) -> bool {
    builtin(name).is_some()
}

/// What any language calls one.
pub(super) fn words() -> impl Iterator<Item = &'static str> {
    BUILTINS.iter().flat_map(|builtin| [builtin.wgsl, builtin.glsl, builtin.hlsl, builtin.metal])
}

/// What GLSL calls it.
pub(super) fn glsl(name: &str) -> Option<&'static str> {
    builtin(name).map(|builtin| builtin.glsl)
}

/// What HLSL calls it.
pub(super) fn hlsl(name: &str) -> Option<&'static str> {
    builtin(name).map(|builtin| builtin.hlsl)
}

/// What Metal calls it.
pub(super) fn metal(name: &str) -> Option<&'static str> {
    builtin(name).map(|builtin| builtin.metal)
}
