//! The lights and the camera.

use super::{Described, Parameter, described, named, parameter};

const POWER: Parameter = named("power", "lm", "1000", "all the light that is given off");
const LUMINANCE: Parameter = named("luminance", "cd/m²", "", "how bright the surface looks, whatever its size");
const COLOR: Parameter = named("color", "", "\"white\"", "the filter before white light: a name or [r, g, b]");
const TWO_SIDED: Parameter = named("two_sided", "", "false", "whether it shines from its back too");
const AIM: Parameter = named("aim", "", "[0, 0, 1]", "the direction that it shines in, as [x, y, z]");
const SUN_AIM: Parameter = named("aim", "", "[0, 0, -1]", "the direction that it shines in, as [x, y, z]");
const VISIBLE: Parameter = named("visible", "", "true", "whether the camera sees the light itself");
const SHADOWS: Parameter = named("shadows", "", "", "the algorithm that draws its shadows, if it is not the picture's");
const DIAMETER: Parameter = named("d", "mm", "", "diameter, instead of r");

pub(super) const LIGHTS: &[Described] = &[
    described(
        "sphere_light",
        &[parameter("r", "mm", "1", "radius; 0 makes a point"), DIAMETER, POWER, LUMINANCE, COLOR, VISIBLE, SHADOWS],
        "A ball that shines.",
        "translate([-50, 0, 20]) sphere_light(r = 5, color = \"orange\");",
    ),
    described(
        "disk_light",
        &[parameter("r", "mm", "1", "radius"), DIAMETER, POWER, LUMINANCE, COLOR, TWO_SIDED, AIM, VISIBLE, SHADOWS],
        "A disk that shines towards +z.",
        "translate([0, 0, 80]) disk_light(r = 20, aim = [0, 0, -1]);",
    ),
    described(
        "rect_light",
        &[
            parameter("size", "mm", "1", "edge lengths [x, y], or one number for both"),
            POWER,
            LUMINANCE,
            COLOR,
            TWO_SIDED,
            AIM,
            VISIBLE,
            SHADOWS,
        ],
        "A rectangle about the origin that shines towards +z.",
        "translate([0, 0, 80]) rect_light([60, 40], power = 1500, aim = [0, 0, -1]);",
    ),
    described(
        "tube_light",
        &[
            parameter("r", "mm", "1", "radius"),
            parameter("length", "mm", "1", "length"),
            DIAMETER,
            named("h", "mm", "", "length"),
            POWER,
            LUMINANCE,
            COLOR,
            VISIBLE,
            SHADOWS,
        ],
        "A cylinder along x that shines, its middle at the origin and its ends dark.",
        "translate([0, 0, 60]) tube_light(r = 2, length = 80);",
    ),
    described(
        "polygon_light",
        &[
            parameter("points", "mm", "!", "the corners, a list of [x, y]"),
            POWER,
            LUMINANCE,
            COLOR,
            TWO_SIDED,
            AIM,
            VISIBLE,
            SHADOWS,
        ],
        "A polygon of any shape that shines towards +z.",
        "translate([0, 0, 60]) polygon_light([[0, 0], [40, 0], [20, 30]], aim = [0, 0, -1]);",
    ),
    described(
        "sun",
        &[
            parameter("angle", "°", "0.53", "the angle that it is seen under"),
            named("illuminance", "lx", "100000", "what falls on a surface that faces it"),
            LUMINANCE,
            COLOR,
            SUN_AIM,
            VISIBLE,
            SHADOWS,
        ],
        "A disk infinitely far away, towards +z.",
        "sun(aim = [1, 1, -2]);",
    ),
    described(
        "environment",
        &[
            parameter("color", "", "\"white\"", "the filter before the whole sky"),
            named("zenith", "", "\"white\"", "colour straight up"),
            named("horizon", "", "", "colour of the horizon; that of the zenith, if it is not given"),
            named("ground", "", "", "colour below; that of the horizon, if it is not given"),
            named("luminance", "cd/m²", "2000", "how bright the sky is"),
        ],
        "The sky all around.",
        "environment(zenith = \"skyblue\", horizon = \"white\", ground = \"dimgray\", luminance = 500);",
    ),
    described(
        "camera",
        &[
            parameter("eye", "mm", "!", "where it stands, as [x, y, z]"),
            parameter("target", "mm", "[0, 0, 0]", "what it looks at"),
            parameter("fov", "°", "", "the vertical field of view; that of $vpf, if it is not given"),
        ],
        "From where the scene is seen, z upwards.",
        "camera(eye = [100, -200, 150], target = [0, 0, 20], fov = 30);",
    ),
];
