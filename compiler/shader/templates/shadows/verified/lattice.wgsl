// The lattice of receivers that verified cones look at one after the other: those in every `TOP`-th row and column
// first, then those midway between them along diagonals, then midway along rows and columns, and so on.

const TOP_LOG: u32 = 1u;
/// One for the lattice, two for each halving of its spacing.
const STAGES: u32 = 1u + 2u * TOP_LOG;

/// The stage of a pixel.
fn stage_of(x: u32, y: u32) -> u32 {
    let spacing = countTrailingZeros((x | y) | (1u << TOP_LOG));
    if spacing >= TOP_LOG {
        return 0u;
    }
    let is_diagonal = (((x & y) >> spacing) & 1u) == 1u;
    return 1u + 2u * (TOP_LOG - 1u - spacing) + select(1u, 0u, is_diagonal);
}

/// Half the spacing of the lattice at a stage: how far off the pixels are that stage's are predicted from.
fn half_spacing(stage: u32) -> u32 {
    return (1u << TOP_LOG) >> ((stage + 1u) / 2u);
}
