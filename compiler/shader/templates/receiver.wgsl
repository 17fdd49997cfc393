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
    /// Of more lights than can be looked at one by one, the one that was drawn for this receiver and sample: x: its
    /// index; y: 1 over the probability of that; 0 for none.
    drawn: vec4<f32>,
}

/// Stands for the index of the light that was drawn for a receiver.
const DRAWN_LIGHT: u32 = 0xffffffffu;

/// The index of a receiver's light, where a pass is about the light of this index.
fn light_index(receiver: Receiver, index: u32) -> u32 {
    return select(index, u32(receiver.drawn.x), index == DRAWN_LIGHT);
}

/// By how much that light counts.
fn light_weight(receiver: Receiver, index: u32) -> f32 {
    return select(1.0, receiver.drawn.y, index == DRAWN_LIGHT);
}

/// Where shadow rays of a receiver start.
fn shadow_origin(receiver: Receiver) -> vec3<f32> {
    return receiver.p.xyz + receiver.p.w * receiver.n.xyz;
}
