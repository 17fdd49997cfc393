// The rays of a pixel.
//
// Theory: Four places on a rotated grid stand for a tent filter of one pixel: each is in another row and column, as far from
// the centre as the filter's quarters.

const RAYS: i32 = 4;

/// Where in a pixel its i-th ray goes: from the centre to the right and upwards, in pixels.
fn ray_offset(i: i32) -> vec2<f32> {
    if i == 0 {
        return vec2<f32>(-0.15, -0.55);
    }
    if i == 1 {
        return vec2<f32>(0.55, -0.15);
    }
    if i == 2 {
        return vec2<f32>(0.15, 0.55);
    }
    return vec2<f32>(-0.55, 0.15);
}
