/// Algorithm 2 as it must be meant.
fn minimal_cone() -> MinimalCone {
    return MinimalCone(0.15, -1.0, 1.0, false, false);
}
