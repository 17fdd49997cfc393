//! Convex hulls of points, by quickhull (Barber, Dobkin and Huhdanpaa 1996).

use rustc_hash::FxHashMap;

/// A point of space.
pub(crate) type Vec3 = [f64; 3];

/// The convex hull of some points.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Hull {
    /// There are no points.
    Empty,
    /// All points are one.
    Point(Vec3),
    /// All points lie on a line, between these two.
    Segment(Vec3, Vec3),
    /// All points lie in a plane, within this convex polygon.
    Polygon(Vec<Vec3>),
    /// The triangles of the surface, anticlockwise seen from outside.
    Solid(Vec<[Vec3; 3]>),
}

/// The convex hull of points. What is flat to nine digits counts as flat.
pub(crate) fn hull(points: &[Vec3]) -> Hull {
    let Some(first) = points.first() else { return Hull::Empty };
    let extent = points.iter().map(|p| length(sub(*p, *first))).fold(0.0, f64::max);
    let magnitude = points.iter().map(|p| length(*p)).fold(0.0, f64::max);
    let tolerance = (1e-9 * extent).max(1e-13 * magnitude);
    let farthest = |from: &dyn Fn(Vec3) -> f64| {
        let distances = points.iter().map(|p| from(*p)).enumerate();
        distances.fold((0, 0.0), |best, (index, d)| if d > best.1 { (index, d) } else { best })
    };
    let (a, _) = farthest(&|p| length(sub(p, *first)));
    let a = points[a];
    let (b, apart) = farthest(&|p| length(sub(p, a)));
    if apart <= tolerance {
        return Hull::Point(a);
    }
    let b = points[b];
    let along = scale(sub(b, a), 1.0 / apart);
    let (c, off_line) = farthest(&|p| length(cross(along, sub(p, a))));
    if off_line <= tolerance {
        return Hull::Segment(a, b);
    }
    let c = points[c];
    let normal = cross(along, sub(c, a));
    let normal = scale(normal, 1.0 / length(normal));
    let (d, off_plane) = farthest(&|p| dot(normal, sub(p, a)).abs());
    if off_plane <= tolerance {
        return Hull::Polygon(polygon(points, a, along, cross(normal, along), tolerance));
    }
    Surface::around([a, b, c, points[d]], points, tolerance).triangles()
}

/// The convex polygon around points of a plane through `origin`, by Andrew's monotone chain.
fn polygon(points: &[Vec3], origin: Vec3, x: Vec3, y: Vec3, tolerance: f64) -> Vec<Vec3> {
    let mut flat: Vec<([f64; 2], Vec3)> = points
        .iter()
        .map(|p| {
            let from_origin = sub(*p, origin);
            ([dot(from_origin, x), dot(from_origin, y)], *p)
        })
        .collect();
    flat.sort_by(|(a, _), (b, _)| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut chains: Vec<Vec3> = Vec::new();
    let mut half = |sorted: &mut dyn Iterator<Item = &([f64; 2], Vec3)>| {
        let mut chain: Vec<([f64; 2], Vec3)> = Vec::new();
        for point in sorted {
            while let [.., before, last] = chain.as_slice() {
                let (u, v) = (difference(last.0, before.0), difference(point.0, before.0));
                if u[0] * v[1] - u[1] * v[0] > tolerance * u[0].hypot(u[1]) {
                    break;
                }
                chain.pop();
            }
            chain.push(*point);
        }
        chain.pop();
        chains.extend(chain.into_iter().map(|(_, p)| p));
    };
    half(&mut flat.iter());
    half(&mut flat.iter().rev());
    chains
}

/// A closed surface of triangles that grows.
struct Surface<'a> {
    points: &'a [Vec3],
    tolerance: f64,
    faces: Vec<Face>,
    /// The face left of each directed edge.
    left_of: FxHashMap<(usize, usize), usize>,
    corners: Vec<Vec3>,
}

struct Face {
    corners: [usize; 3],
    normal: Vec3,
    offset: f64,
    /// The points beyond it that no other face has.
    beyond: Vec<usize>,
    alive: bool,
}

impl<'a> Surface<'a> {
    fn around(simplex: [Vec3; 4], points: &'a [Vec3], tolerance: f64) -> Self {
        let mut surface =
            Self { points, tolerance, faces: Vec::new(), left_of: FxHashMap::default(), corners: simplex.to_vec() };
        let [a, b, c, d] = simplex;
        let above = dot(cross(sub(b, a), sub(c, a)), sub(d, a)) > 0.0;
        let sides = if above {
            [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
        } else {
            [[0, 1, 2], [1, 0, 3], [2, 1, 3], [0, 2, 3]]
        };
        let faces = sides.map(|corners| surface.add_face(corners));
        surface.share(0..points.len(), &faces);
        surface.grow();
        surface
    }

    fn grow(&mut self) {
        let mut next = 0;
        while next < self.faces.len() {
            let face = &self.faces[next];
            let height = |index: &usize| self.height(next, self.points[*index]);
            let farthest = face.beyond.iter().copied().max_by(|a, b| height(a).total_cmp(&height(b)));
            match farthest {
                Some(point) if face.alive => self.reach(point, next),
                _ => next += 1,
            }
        }
    }

    /// Extends the surface to a point beyond a face.
    fn reach(&mut self, point: usize, from: usize) {
        let position = self.points[point];
        let visible = self.visible(position, from);
        let is_visible = |face: usize| visible.contains(&face);
        let mut rim = Vec::new();
        for &face in &visible {
            let [a, b, c] = self.faces[face].corners;
            for (start, end) in [(a, b), (b, c), (c, a)] {
                if self.left_of.get(&(end, start)).is_none_or(|other| !is_visible(*other)) {
                    rim.push((start, end));
                }
            }
        }
        let mut orphans = Vec::new();
        for &face in &visible {
            let corners = self.faces[face].corners;
            for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                self.left_of.remove(&(corners[i], corners[j]));
            }
            self.faces[face].alive = false;
            orphans.append(&mut self.faces[face].beyond);
        }
        self.corners.push(position);
        let apex = self.corners.len() - 1;
        let faces: Vec<usize> = rim.into_iter().map(|(start, end)| self.add_face([start, end, apex])).collect();
        self.share(orphans.into_iter().filter(|index| *index != point), &faces);
    }

    /// The connected faces, from one on, that a position lies beyond.
    fn visible(&self, position: Vec3, from: usize) -> Vec<usize> {
        let mut visible = vec![from];
        let mut next = 0;
        while next < visible.len() {
            let [a, b, c] = self.faces[visible[next]].corners;
            for edge in [(b, a), (c, b), (a, c)] {
                if let Some(&neighbour) = self.left_of.get(&edge)
                    && !visible.contains(&neighbour)
                    && self.height(neighbour, position) > self.tolerance
                {
                    visible.push(neighbour);
                }
            }
            next += 1;
        }
        visible
    }

    /// Gives each of the points to a face that it lies beyond; those within the surface are done with.
    fn share(&mut self, indices: impl Iterator<Item = usize>, faces: &[usize]) {
        for index in indices {
            let position = self.points[index];
            if let Some(&face) = faces.iter().find(|face| self.height(**face, position) > self.tolerance) {
                self.faces[face].beyond.push(index);
            }
        }
    }

    fn height(&self, face: usize, position: Vec3) -> f64 {
        dot(self.faces[face].normal, position) - self.faces[face].offset
    }

    fn add_face(&mut self, corners: [usize; 3]) -> usize {
        let [a, b, c] = corners.map(|corner| self.corners[corner]);
        let across = cross(sub(b, a), sub(c, a));
        let normal = scale(across, 1.0 / length(across).max(f64::MIN_POSITIVE));
        let id = self.faces.len();
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            self.left_of.insert((corners[i], corners[j]), id);
        }
        self.faces.push(Face { corners, normal, offset: dot(normal, a), beyond: Vec::new(), alive: true });
        id
    }

    fn triangles(&self) -> Hull {
        let alive = self.faces.iter().filter(|face| face.alive);
        Hull::Solid(alive.map(|face| face.corners.map(|corner| self.corners[corner])).collect())
    }
}

pub(crate) fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn scale(a: Vec3, factor: f64) -> Vec3 {
    a.map(|component| component * factor)
}

pub(crate) fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn length(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cube_of_points_has_twelve_triangles_that_face_outwards() {
        let mut points = Vec::new();
        for i in 0..5 {
            for j in 0..5 {
                for k in 0..5 {
                    points.push([f64::from(i), f64::from(j), f64::from(k)]);
                }
            }
        }
        let Hull::Solid(triangles) = hull(&points) else { panic!("a cube is solid") };
        assert_eq!(triangles.len(), 12);
        for [a, b, c] in triangles {
            let normal = cross(sub(b, a), sub(c, a));
            assert!(dot(normal, sub([2.0; 3], a)) < 0.0);
        }
    }

    #[test]
    fn points_on_a_sphere_are_all_corners() {
        let golden = 2.399_963_229_728_653;
        let point = |i: i32| {
            let z = 1.0 - (2.0 * f64::from(i) + 1.0) / 400.0;
            let (sin, cos) = (golden * f64::from(i)).sin_cos();
            [cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z]
        };
        let points: Vec<Vec3> = (0..400).map(point).collect();
        let Hull::Solid(triangles) = hull(&points) else { panic!("a ball is solid") };
        assert_eq!(triangles.len(), 2 * 400 - 4);
    }

    #[test]
    fn flat_and_straight_sets_are_seen_to_be() {
        let square =
            [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, 2.0, 1.0], [0.0, 2.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]];
        let Hull::Polygon(corners) = hull(&square) else { panic!("a square is flat") };
        assert_eq!(corners.len(), 4);
        assert_eq!(hull(&[[1.0, 1.0, 1.0], [3.0, 3.0, 3.0], [2.0, 2.0, 2.0]]), Hull::Segment([3.0; 3], [1.0; 3]));
        assert_eq!(hull(&[[1.0; 3]; 3]), Hull::Point([1.0; 3]));
        assert_eq!(hull(&[]), Hull::Empty);
    }
}
