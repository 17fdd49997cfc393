/// Algorithm 2 with longer steps, and the receiver's horizon.
fn minimal_cone() -> MinimalCone {
    return MinimalCone(0.1, -1.0, 0.0, true, true);
}
