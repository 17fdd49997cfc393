/// Algorithm 2 as it is printed, but for a first step.
fn minimal_cone() -> MinimalCone {
    return MinimalCone(CONE_TOLERANCE, 1.0, false, false);
}
