/// Algorithm 2 as it is printed, but for a first step.
fn minimal_cone() -> MinimalCone {
    let tolerance = 0.1;
    return MinimalCone(tolerance, tolerance, 1.0, false, false);
}
