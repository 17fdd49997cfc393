//! The field, from trees made by hand or at random to distances.

mod crowds;
mod graphs;
mod numbers;
mod soundness;
mod trees;
