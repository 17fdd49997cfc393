// Receivers: the surfaces that primary rays met, as the passes that light them get them.

struct Receiver {
    /// The point on the surface; w: how far along the normal shadow rays start, in millimetres; negative where there
    /// is no surface.
    p: vec4<f32>,
    /// The unit normal, outwards; w: how metallic it is, or −1 for the studio's floor.
    n: vec4<f32>,
    /// The colour, linear red, green and blue; of the studio's floor, the radiance that its lights add if all is
    /// seen of them. w: the roughness.
    color: vec4<f32>,
}

/// Where shadow rays of a receiver start.
fn shadow_origin(receiver: Receiver) -> vec3<f32> {
    return receiver.p.xyz + receiver.p.w * receiver.n.xyz;
}
