//! What is known of a node.

use chiaro_vocabulary::{Bounds, Class};

/// Sound facts of one node, for every value of the live parameters within their ranges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facts {
    /// A box of the world around the node's solid. For plane shapes asked at a flattened point, z is unbounded.
    pub bounds: Bounds,
    /// The points with values of at most δ > 0 are within δ times this of the bounds, along each axis. So a point
    /// that is farther from them than that has a value above δ. Infinite where that is not known
    /// (or not so: below a [`Taper`](crate::Node::Taper)).
    pub growth: f64,
    /// What its values are, once divided by the Lipschitz constant.
    pub class: Class,
    /// The Lipschitz constant: the greatest slope of the node's value anywhere. The value itself is not divided by
    /// it: marching steps by value / L, while joints, offsets and normals use the value. (What stands below a
    /// [`Taper`](crate::Node::Taper) is in units that change with the height. Its constant is the one that makes the
    /// tapered distance's right; it does not hold for itself.)
    pub lipschitz: f64,
}
