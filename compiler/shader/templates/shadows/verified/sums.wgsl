// Sums over the cells of a light. Integers, so that the order in which cells are added doesn't matter.

/// For each receiver: the seen part of the cells' shares; the cells' shares; the evaluations.
const SUMS: u32 = 3u;
/// What 1 is in these sums.
const WHOLE: f32 = 16777216.0;

/// V.
fn visible_part(seen: u32, shares: u32, bare: f32) -> f32 {
    return min(f32(seen) / max(f32(shares), 1.0), bare);
}
