//! From pixels to rays of the world, and from points of the world to pixels.

use crate::view::View;

impl View {
    /// The ray through a point of a picture of `size` pixels, which is in pixels from the upper left corner (a pixel's
    /// centre has halves): where it starts, in millimetres, and its direction, of length 1.
    pub fn ray(&self, point: [f64; 2], size: [u32; 2]) -> ([f64; 3], [f64; 3]) {
        let axes = self.axes();
        let [right, up] = self.on_plane(point, size);
        let along = [0, 1, 2].map(|axis| axes.forward[axis] + right * axes.right[axis] + up * axes.up[axis]);
        let length = dot(along, along).sqrt();
        (self.eye(), along.map(|component| component / length))
    }

    /// Where a point of the world is seen in a picture of `size` pixels, in pixels from the upper left corner, and how far
    /// before the eye it is along its direction; none if it is behind the eye.
    pub fn project(&self, point: [f64; 3], size: [u32; 2]) -> Option<([f64; 2], f64)> {
        let (axes, eye) = (self.axes(), self.eye());
        let seen = [0, 1, 2].map(|axis| point[axis] - eye[axis]);
        let depth = dot(seen, axes.forward);
        if depth <= 0.0 {
            return None;
        }
        let [width, height] = size.map(f64::from);
        let to_pixels = 0.5 * height / (depth * self.half_height());
        let across = 0.5 * width + dot(seen, axes.right) * to_pixels;
        let down = 0.5 * height - dot(seen, axes.up) * to_pixels;
        Some(([across, down], depth))
    }

    /// How far apart the rays of neighbouring pixels are at a distance of 1.
    pub fn pixel_angle(&self, size: [u32; 2]) -> f64 {
        2.0 * self.half_height() / f64::from(size[1])
    }

    /// A point of a picture on the plane at a distance of 1: to the right and upwards.
    fn on_plane(&self, point: [f64; 2], size: [u32; 2]) -> [f64; 2] {
        let [width, height] = size.map(f64::from);
        let scale = self.half_height() / (0.5 * height);
        [(point[0] - 0.5 * width) * scale, (0.5 * height - point[1]) * scale]
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_ray_passes_is_seen_at_its_pixel() {
        let view = View { target: [3.0, -2.0, 7.0], rotation: [55.0, 10.0, 25.0], distance: 90.0, field_of_view: 40.0 };
        let size = [320, 200];
        for point in [[0.0, 0.0], [160.0, 100.0], [319.5, 20.25]] {
            let (eye, direction) = view.ray(point, size);
            let ([x, y], _) = view.project([0, 1, 2].map(|axis| eye[axis] + 55.0 * direction[axis]), size).unwrap();
            assert!((x - point[0]).abs() < 1e-9 && (y - point[1]).abs() < 1e-9, "{point:?}: {x}, {y}");
            assert_eq!(view.project([0, 1, 2].map(|axis| eye[axis] - direction[axis]), size), None);
        }
    }
}
