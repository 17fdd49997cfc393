//! What other languages and libraries call what there is here: hints for names that are unknown, but no mistypings.

/// Their modules, in small letters without `_`, and what to write instead.
const MODULES: [(&[&str], &str); 12] = [
    (
        &["smoothunion", "roundunion", "softunion", "unionround", "blend", "smin", "fillet", "filletunion"],
        "`union(r = …)` joins its children by a fillet of that radius",
    ),
    (
        &["smoothdifference", "rounddifference", "differenceround", "smoothsubtraction", "filletdifference"],
        "`difference(r = …)` rounds the edges of what is cut, by a fillet of that radius",
    ),
    (
        &["smoothintersection", "roundintersection", "intersectionround", "filletintersection"],
        "`intersection(r = …)` rounds its edges by a fillet of that radius",
    ),
    (&["chamferunion", "unionchamfer"], "`union(r = …, joint = \"chamfer\")` joins its children by a chamfer"),
    (
        &["roundedcube", "roundcube", "cuberound", "roundedbox", "roundbox", "cuboid"],
        "`cube(…, r = …)` has edges rounded by that radius",
    ),
    (&["roundedcylinder", "roundcylinder", "cyl"], "`cylinder(…, edge = …)` has edges rounded by that radius"),
    (&["roundedsquare", "roundedrectangle", "roundedrect"], "`square(…, r = …)` has corners rounded by that radius"),
    (&["box", "block", "cubic"], "a box is written `cube([…])`"),
    (
        &["light", "lamp", "pointlight", "point", "omnilight", "bulb", "spherelight", "spherical"],
        "lights are written `sphere_light(r = …)`, `disk_light`, `rect_light`, `tube_light`, `polygon_light`, `sun`",
    ),
    (&["spotlight", "spot", "disclight"], "a round flat light is written `disk_light(r = …)`; it shines towards +z"),
    (&["arealight", "panel", "softbox", "quadlight"], "a rectangular light is written `rect_light([…])`"),
    (&["lookat", "eye", "viewpoint"], "it is written `camera(eye, target)` here"),
];

/// Their modules that only have another name here, in small letters without `_`.
const RENAMED: [(&[&str], &str); 5] = [
    (&["move", "shift"], "translate"),
    (&["subtract", "subtraction", "cut", "minus"], "difference"),
    (&["intersect", "and"], "intersection"),
    (&["directionallight", "dirlight", "distantlight", "sunlight"], "sun"),
    (&["sky", "skylight", "skydome", "ambientlight", "ambient", "background", "hdri"], "environment"),
];

/// Their parameters, and what these may be called here, the likeliest first.
const PARAMETERS: [(&[&str], &[&str]); 15] = [
    (&["radius", "rad"], &["r"]),
    (&["rounding", "fillet", "round", "smooth", "blend", "k"], &["edge", "r"]),
    (&["chamfer", "profile"], &["joint"]),
    (&["diameter", "dia"], &["d"]),
    (&["height", "length", "l"], &["h", "height", "length"]),
    (&["centre", "centered", "centred"], &["center"]),
    (&["dimensions", "dim", "dims"], &["size"]),
    (
        &["power", "lumen", "lumens", "lm", "flux", "intensity", "energy", "watts"],
        &["power", "illuminance", "luminance"],
    ),
    (&["illuminance", "lux", "lx"], &["illuminance", "power", "luminance"]),
    (&["brightness", "strength", "radiance", "nits"], &["luminance"]),
    (&["colour", "c", "tint", "sky"], &["color", "zenith"]),
    (&["twosided", "double_sided", "doublesided", "both"], &["two_sided"]),
    (&["direction", "dir", "look_at", "lookat", "center", "at"], &["aim", "target"]),
    (&["position", "pos", "from", "p"], &["eye"]),
    (&["angle", "field_of_view", "vpf"], &["fov"]),
];

/// What a module of another language is called here, if that is all the difference.
pub(crate) fn module(name: &str) -> Option<&'static str> {
    let name = name.replace('_', "").to_ascii_lowercase();
    let (_, ours) = RENAMED.iter().find(|(names, _)| names.contains(&&*name))?;
    Some(ours)
}

/// How to write what a module of another language is for.
pub(crate) fn module_hint(name: &str) -> Option<String> {
    let name = name.replace('_', "").to_ascii_lowercase();
    let (_, hint) = MODULES.iter().find(|(names, _)| names.contains(&&*name))?;
    Some((*hint).to_owned())
}

/// Which of the known parameters another language's parameter corresponds to.
pub(crate) fn parameter<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> Option<String> {
    let (_, ours) = PARAMETERS.iter().find(|(names, _)| names.contains(&name))?;
    let known: Vec<&str> = known.collect();
    let meant = ours.iter().find(|ours| known.contains(ours))?;
    Some((*meant).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn foreign_parameters_are_guessed_where_there_is_such_a_one() {
        let meant = |name: &str, known: &[&'static str]| parameter(name, known.iter().copied());
        assert_eq!(meant("radius", &["r", "joint"]).as_deref(), Some("r"));
        assert_eq!(meant("rounding", &["h", "r", "edge"]).as_deref(), Some("edge"));
        assert_eq!(meant("radius", &["v"]), None);
    }
}
