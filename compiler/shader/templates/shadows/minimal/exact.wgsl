/// The fast soft shadow of section 4.1 with the exact segment of the disc.
fn disc_part(m: f32) -> f32 {
    return segment_area(m);
}
