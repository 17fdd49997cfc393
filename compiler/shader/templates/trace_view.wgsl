// The view: where rays start, what they may meet, and the numbers they draw.
//
// Practice: one `View` a dispatch, in a uniform. lavapipe compiles a shader anew for every value of a uniform that
// alone decides a branch or a loop's end, so none of these numbers may do that.

struct View {
    /// The eye in millimetres of the world; w: the Lipschitz constant L of the scene's distance.
    eye: vec4<f32>,
    /// The way from the picture's centre to its right edge, on the plane one millimetre before the eye.
    right: vec4<f32>,
    /// Likewise to its upper edge.
    up: vec4<f32>,
    /// Where the eye looks, of length 1; w: the angle between neighbouring pixels in radians.
    forward: vec4<f32>,
    /// The least corner of the box outside which there is nothing; w: the length below which f32 can't tell points.
    box_min: vec4<f32>,
    /// The greatest corner of that box.
    box_max: vec4<f32>,
    /// The floor: x: its height; y: 1 if there is one, else 0. The studio's azimuth: z: its cosine; w: its sine.
    studio: vec4<f32>,
    /// The sky's radiance overhead; w: 1 if the scene stands in the studio, else 0.
    zenith: vec4<f32>,
    /// The sky's radiance at the horizon.
    horizon: vec4<f32>,
    /// The radiance from below the horizon.
    ground: vec4<f32>,
    /// The picture's size in pixels; z: how many samples each pixel had before; w: 1 to start at the prepass's depths,
    /// or, for the prepass itself, to march cones and not just their axes.
    size: vec4<u32>,
    /// The part of the picture that this dispatch draws: the first pixel and the size.
    part: vec4<u32>,
    /// The prepass: the edge of this level's tiles in pixels, where they are stored, and the same of the level before
    /// (an edge of 0 for none). For the trace, the level before is the finest, and x says how it lights.
    level: vec4<u32>,
}

@group(0) @binding(0) var<uniform> view: View;

/// The ray from the eye through a point of the picture, in pixels from the upper left corner.
fn camera_ray(point: vec2<f32>) -> Ray {
    let size = vec2<f32>(view.size.xy);
    let across = 2.0 * point.x / size.x - 1.0;
    let upwards = 1.0 - 2.0 * point.y / size.y;
    return Ray(view.eye.xyz, normalize(view.forward.xyz + across * view.right.xyz + upwards * view.up.xyz));
}

/// Where the tile of a prepass level that holds a pixel is stored.
fn tile_index(pixel: vec2<u32>, edge: u32, first: u32) -> u32 {
    let across = (view.size.x + edge - 1u) / edge;
    return first + (pixel.y / edge) * across + pixel.x / edge;
}
