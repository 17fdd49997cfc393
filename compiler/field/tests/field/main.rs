//! The field, from trees made by hand or at random to distances.

mod graphs;
mod soundness;
mod trees;
