//! The kinds and flags of `light.wgsl`, for whoever writes or reads its rows.

/// A ball.
pub const SPHERE: u32 = 0;
/// A disk.
pub const DISK: u32 = 1;
/// A convex quadrilateral, or a triangle.
pub const QUAD: u32 = 2;
/// The side of a cylinder.
pub const TUBE: u32 = 3;
/// A disk infinitely far away.
pub const SUN: u32 = 4;

/// It shines from its back too.
pub const TWO_SIDED: u32 = 1;
/// Cameras see it.
pub const VISIBLE: u32 = 2;
/// A quadrilateral with right angles.
pub const RECTANGLE: u32 = 4;
/// Paths draw it at random at the first surface too.
pub const SAMPLED: u32 = 8;
/// Only one of many lights like it is drawn for each receiver and sample.
pub const ONE_OF_MANY: u32 = 16;
