// Lights, as the kernels get them: lengths in millimetres of the world.

/// A sphere: a.xyz the centre, a.w the radius.
const LIGHT_SPHERE: u32 = 0u;
/// A disk: a.xyz the centre, a.w the radius; b.xyz the unit normal of the side that shines.
const LIGHT_DISK: u32 = 1u;
/// A convex quadrilateral: a.xyz, b.xyz, c.xyz, d.xyz its corners, anticlockwise as seen from the side that shines. The
/// last two corners of a triangle are the same.
const LIGHT_QUAD: u32 = 2u;
/// The side of a cylinder: a.xyz the middle, a.w the radius; b.xyz the way from there to one end.
const LIGHT_TUBE: u32 = 3u;
/// A disk infinitely far away: a.xyz the unit direction towards it, a.w the sine of its angular radius.
const LIGHT_SUN: u32 = 4u;

/// It shines from its back too.
const LIGHT_TWO_SIDED: u32 = 1u;
/// Cameras see it.
const LIGHT_VISIBLE: u32 = 2u;
/// A quadrilateral with right angles.
const LIGHT_RECTANGLE: u32 = 4u;
/// Paths draw it at random at the first surface too; no shadow method does.
const LIGHT_SAMPLED: u32 = 8u;
/// There are so many lights like this one that only one of them is drawn for each receiver and sample.
const LIGHT_ONE_OF_MANY: u32 = 16u;

struct Light {
    a: vec4<f32>,
    b: vec4<f32>,
    c: vec4<f32>,
    d: vec4<f32>,
    /// Its radiance, the same in all directions; linear red, green and blue. w: nothing.
    radiance: vec4<f32>,
    /// x: one of the kinds above; y: the sum of its flags; z: nothing; w: nothing.
    kind: vec4<u32>,
}
