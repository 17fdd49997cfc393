//! Solids with flat faces: their meshes have the corners of the solid and no other vertices.

mod support;

use chiaro_mesh::{Detail, Mesh, Model};
use support::{at, mesh_of};

/// Numbers from 0 to 1 (splitmix64).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, least: f64, greatest: f64) -> f64 {
        least + self.unit() * (greatest - least)
    }

    fn vector(&mut self, least: f64, greatest: f64) -> [f64; 3] {
        std::array::from_fn(|_| self.between(least, greatest))
    }
}

const BY_DEFAULT: Detail = Detail { tolerance: None, resolution: None };

#[track_caller]
fn assert_size(model: &Model, (triangles, vertices): (usize, usize), volume: f64, of: &str) {
    assert_eq!((model.mesh.triangles.len(), model.mesh.vertices.len()), (triangles, vertices), "{of}");
    assert!((model.mesh.volume() - volume).abs() < 1e-4 * volume, "{} of {volume}: {of}", model.mesh.volume());
}

#[test]
fn platonic_solids_have_their_corners() {
    let root = f64::sqrt;
    let golden = 0.5 * (1.0 + root(5.0));
    // Volumes for a circumscribed sphere of radius 1.
    let solids = [
        ("tetrahedron", (4, 4), 8.0 * root(3.0) / 27.0),
        ("octahedron", (8, 6), 4.0 / 3.0),
        ("icosahedron", (20, 12), root(10.0 + 2.0 * root(5.0)) * 2.0 / 3.0),
        ("dodecahedron", (36, 20), 2.0 / 9.0 * root(3.0) * root(5.0) * golden * 2.0),
    ];
    let mut random = Random(1);
    for (name, size, volume) in solids {
        let text = format!("{name}(3);");
        assert_size(&mesh_of(&text, &BY_DEFAULT), size, volume * 27.0, &text);
        for detail in [12, 20, 33, 64].map(at) {
            for turn in [[0.0; 3], random.vector(0.0, 360.0), random.vector(0.0, 360.0)] {
                let radius = random.between(0.5, 30.0);
                let text = format!("translate({:?}) rotate({turn:?}) {name}({radius});", random.vector(-9.0, 9.0));
                let model = mesh_of(&text, &detail);
                assert_size(&model, size, volume * radius.powi(3), &format!("{text} {detail:?}"));
            }
        }
    }
}

/// Half-spaces, as normals and offsets, and the polytope that they have in common.
struct Polytope(Vec<([f64; 3], f64)>);

impl Polytope {
    /// A cube with some corners and edges cut off.
    fn random(random: &mut Random) -> Self {
        let mut sides: Vec<([f64; 3], f64)> = (0..6)
            .map(|side| (std::array::from_fn(|axis| if axis == side / 2 { [-1.0, 1.0][side % 2] } else { 0.0 }), 10.0))
            .collect();
        for _ in 0..6 {
            let way = random.vector(-1.0, 1.0);
            let length = dot(way, way).sqrt();
            sides.push((way.map(|x| x / length), random.between(8.0, 14.0)));
        }
        Self(sides)
    }

    /// The corners of a side's face, in order; two or fewer if it has none.
    fn face(&self, side: usize) -> Vec<[f64; 3]> {
        let (normal, offset) = self.0[side];
        let other = if normal[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let right = cross(normal, other);
        let right = right.map(|x| x / dot(right, right).sqrt());
        let up = cross(normal, right);
        let corner = |a: f64, b: f64| std::array::from_fn(|i| offset * normal[i] + a * right[i] + b * up[i]);
        let mut face = vec![corner(-99.0, -99.0), corner(99.0, -99.0), corner(99.0, 99.0), corner(-99.0, 99.0)];
        for (number, (normal, offset)) in self.0.iter().enumerate() {
            if number != side {
                face = clipped(&face, |point| dot(*normal, point) - offset);
            }
        }
        face
    }

    /// The volume, how many triangles it takes, and the length of the shortest edge.
    fn measures(&self) -> (f64, usize, f64) {
        let mut measures = (0.0, 0, f64::MAX);
        for (side, (normal, offset)) in self.0.iter().enumerate() {
            let face = self.face(side);
            let edge = |place: usize| sub(face[(place + 1) % face.len()], face[place]);
            let areas = (1..face.len().max(2) - 1).map(|place| cross(edge(place), sub(face[0], face[place])));
            measures.0 += areas.map(|area| dot(area, *normal)).sum::<f64>() * offset / 6.0;
            measures.1 += face.len().max(2) - 2;
            measures.2 = (0..face.len()).map(|place| dot(edge(place), edge(place)).sqrt()).fold(measures.2, f64::min);
        }
        measures
    }

    fn text(&self) -> String {
        let sides =
            self.0.iter().map(|(normal, offset)| format!("half_space(normal = {normal:?}, offset = {offset});"));
        format!("intersection() {{ cube(20, center = true); {} }}", sides.skip(6).collect::<String>())
    }
}

/// The part of a polygon where a linear function is negative.
fn clipped(polygon: &[[f64; 3]], height: impl Fn([f64; 3]) -> f64) -> Vec<[f64; 3]> {
    let mut part = Vec::new();
    for (place, a) in polygon.iter().enumerate() {
        let b = polygon[(place + 1) % polygon.len()];
        let (at_a, at_b) = (height(*a), height(b));
        if at_a < 0.0 {
            part.push(*a);
        }
        if (at_a < 0.0) != (at_b < 0.0) {
            part.push(std::array::from_fn(|i| a[i] + (b[i] - a[i]) * at_a / (at_a - at_b)));
        }
    }
    part
}

/// Where no edge is shorter than some cells, a polytope has the fewest triangles; where some are, nearly so.
#[test]
fn polytopes_have_their_corners() {
    let mut random = Random(2);
    let (mut minimal, mut all) = (0, 0);
    for _ in 0..20 {
        let polytope = Polytope::random(&mut random);
        let (volume, triangles, shortest) = polytope.measures();
        let text = format!(
            "translate({:?}) rotate({:?}) {}",
            random.vector(-50.0, 50.0),
            random.vector(0.0, 360.0),
            polytope.text()
        );
        for detail in [24, 40, 56].map(at) {
            let model = mesh_of(&text, &detail);
            let found = model.mesh.triangles.len();
            let off = (model.mesh.volume() - volume).abs() / volume;
            assert!(off < 1e-3, "{off}: {text} {detail:?}");
            let is_coarse = shortest < 3.0 * model.report.cell;
            assert!(is_coarse || found == triangles, "{found} instead of {triangles}: {text} {detail:?}");
            assert!(found < 4 * triangles, "{found} instead of {triangles}: {text} {detail:?}");
            minimal += usize::from(found <= triangles);
            all += 1;
        }
    }
    assert!(2 * minimal > all, "only {minimal} of {all} are minimal");
}

/// Boxes with different coordinates, added and taken away, and turned together.
#[test]
fn boxes_united_and_cut_have_their_corners() {
    let mut random = Random(3);
    for _ in 0..8 {
        let boxes: Vec<[[f64; 2]; 3]> = boxes(&mut random);
        let volume = volume_of(&boxes);
        let solid = |[x, y, z]: &[[f64; 2]; 3]| {
            format!(
                "translate([{}, {}, {}]) cube([{}, {}, {}]); ",
                x[0],
                y[0],
                z[0],
                x[1] - x[0],
                y[1] - y[0],
                z[1] - z[0]
            )
        };
        let solids: Vec<String> = boxes.iter().map(solid).collect();
        let text = format!(
            "rotate({:?}) difference() {{ union() {{ {} {} }} {} }}",
            random.vector(0.0, 360.0),
            solids[0],
            solids[1],
            solids[2]
        );
        for detail in [36, 64].map(at) {
            let model = mesh_of(&text, &detail);
            let off = (model.mesh.volume() - volume).abs() / volume;
            assert!(off < 1e-3, "{off}: {text} {detail:?}");
            assert_eq!(needless(&model.mesh), 0, "{} triangles: {text} {detail:?}", model.mesh.triangles.len());
        }
    }
}

/// Two that are united and one that is taken away. No two sides are in one plane.
fn boxes(random: &mut Random) -> Vec<[[f64; 2]; 3]> {
    let mut places: [Vec<f64>; 3] = std::array::from_fn(|_| (0..6).map(f64::from).collect());
    (0..3)
        .map(|_| {
            std::array::from_fn(|axis| {
                let mut take = || {
                    let index = (random.unit() * places[axis].len() as f64) as usize;
                    places[axis].remove(index)
                };
                let (a, b) = (take(), take());
                [a.min(b), a.max(b)]
            })
        })
        .collect()
}

/// The volume of the first two boxes together, without the third.
fn volume_of(boxes: &[[[f64; 2]; 3]]) -> f64 {
    let is_in = |sides: &[[f64; 2]; 3], middle: [f64; 3]| {
        (0..3).all(|axis| sides[axis][0] < middle[axis] && middle[axis] < sides[axis][1])
    };
    let middles = (0..125).map(|n| [n % 5, n / 5 % 5, n / 25].map(|place| f64::from(place) + 0.5));
    let inside =
        middles.filter(|middle| (is_in(&boxes[0], *middle) || is_in(&boxes[1], *middle)) && !is_in(&boxes[2], *middle));
    inside.count() as f64
}

/// How many vertices are amid a face or a straight edge. A mesh without such has the fewest triangles that there can be.
fn needless(mesh: &Mesh) -> usize {
    let mut normals: Vec<Vec<[f64; 3]>> = vec![Vec::new(); mesh.vertices.len()];
    for (triangle, corners) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = mesh.corners(triangle);
        let normal = cross(sub(b, a), sub(c, a));
        let normal = normal.map(|x| x / dot(normal, normal).sqrt());
        for corner in corners {
            let known = &mut normals[*corner as usize];
            if !known.iter().any(|other| dot(*other, normal) > 1.0 - 1e-6) {
                known.push(normal);
            }
        }
    }
    normals.iter().filter(|normals| normals.len() < 3).count()
}

#[test]
fn plates_with_holes_have_their_corners() {
    let sides = 24;
    let ring = |radius: f64| {
        let corner = |i: usize| {
            let angle = (360.0 / sides as f64 * i as f64).to_radians();
            format!("[{}, {}]", radius * angle.cos(), radius * angle.sin())
        };
        (0..sides).map(corner).collect::<Vec<_>>().join(", ")
    };
    let text = format!(
        "rotate([10, 20, 30]) linear_extrude(4) difference() {{ polygon([{}]); polygon([{}]); }}",
        ring(10.0),
        ring(6.0)
    );
    for detail in [at(64), BY_DEFAULT] {
        let model = mesh_of(&text, &detail);
        assert_eq!(needless(&model.mesh), 0, "{detail:?}");
        // A face with n corners and one hole has n triangles, a quadrilateral two.
        assert_eq!(model.mesh.triangles.len(), 2 * 2 * sides + 2 * 2 * sides, "{detail:?}");
    }
}

/// Where parts touch, each has its own vertices, which programs that weld can tell apart.
#[test]
fn touching_parts_stay_apart() {
    for text in [
        "cube(10); translate([10, 10, 0]) cube(10);",
        "cube(10); translate([10, 10, 10]) cube(10);",
        "rotate([10, 20, 30]) { cube(10); translate([10, 10, 0]) cube(10); }",
        "for (x = [0 : 2], y = [0 : 2], z = [0 : 2]) if ((x + y + z) % 2 == 0) translate(5 * [x, y, z]) cube(5);",
        "difference() { cube(20); translate([2, 2, 2]) cube(8); translate([10, 10, 2]) cube(8); }",
        "translate([300, 0, 0]) { cube(10); translate([10, 10, 0]) cube(10); }",
    ] {
        for detail in [16, 33, 64].map(at) {
            mesh_of(text, &detail);
        }
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
