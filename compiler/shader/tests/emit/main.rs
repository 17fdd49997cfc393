//! Graphs of every kind of node: emitted, validated, run, printed, parsed back and run again.

mod interpreter;
mod scene;

use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::Arc;

use chiaro_field::{MaterialId, Node, NodeId, Operation, Point, PointId};
use chiaro_plane::{Contour, Edge, Loft, Region};
use chiaro_shader::{MAX_NODES, Template, splice};
use chiaro_solid::{Affine, Joint, Material, ParameterId, Profile, Scalar};
use chiaro_vocabulary::rows::{REVOLVE, SLICE};
use chiaro_vocabulary::{Interval, Kind, row, rows};

use interpreter::Machine;
use scene::{GREEN, RED, Scene, assert_close, checked, random_points};

#[test]
fn a_painted_union_reads_as_a_list() {
    let mut scene = Scene::new();
    let at = scene.moved([10.0, 0.0, 0.0]);
    let cube = scene.shape("box", &[5.0, 5.0, 5.0], PointId(0));
    let ball = scene.shape("sphere", &[5.0], at);
    let red = scene.painted(RED, ball);
    scene.union(vec![cube, red]);
    let text = checked(&scene.done(), &[]).text;
    let expected = "\
// The ball of radius r around the origin.
fn sd_sphere(p: vec3<f32>, r: f32) -> f32 {
    return length(p) - r;
}

// The box that reaches half_size to each side of the origin (Quilez, \"Distance functions\").
fn sd_box(p: vec3<f32>, half_size: vec3<f32>) -> f32 {
    let q = abs(p) - half_size;
    return length(max(q, vec3(0.0))) + min(max(q.x, max(q.y, q.z)), 0.0);
}

// What a surface looks like: color is linear red, green, blue and opacity; finish is roughness, metallic,
// emission as a multiple of the color, and 0.
struct Surface {
    color: vec4<f32>,
    finish: vec4<f32>,
}

// The signed distance to the scene, in millimetres.
fn scene_distance(p: vec3<f32>) -> f32 {
    let box_a = sd_box(p, vec3(5.0, 5.0, 5.0));
    let sphere_a = sd_sphere(p - vec3(10.0, 0.0, 0.0), 5.0);
    let union_a = min(box_a, sphere_a);
    return union_a;
}

// The material of the surface at p.
fn scene_surface(p: vec3<f32>) -> Surface {
    let box_a = sd_box(p, vec3(5.0, 5.0, 5.0));
    let color_a = vec4(0.84808826, 0.4769998, 0.063723795, 1.0);
    let finish_a = vec4(0.45, 0.0, 0.0, 0.0);
    let sphere_a = sd_sphere(p - vec3(10.0, 0.0, 0.0), 5.0);
    let color_b = vec4(1.0, 0.0, 0.0, 1.0);
    let wins_a = sphere_a < box_a;
    let color_c = select(color_a, color_b, wins_a);
    return Surface(color_c, finish_a);
}
";
    assert_eq!(text, expected);
}

#[test]
fn every_shape_is_called_with_its_arguments() {
    for row in rows() {
        let mut scene = Scene::new();
        let arguments: Vec<f64> = (0..row.arity()).map(|i| 3.0 + i as f64).collect();
        match row.kind {
            Kind::Solid | Kind::Plane => scene.shape(row.name, &arguments, PointId(0)),
            Kind::Adjust => {
                let ball = scene.shape("sphere", &[5.0], PointId(0));
                scene.add(Node::Adjust(row, arguments.iter().copied().map(Scalar::from).collect(), ball))
            }
            Kind::Warp | Kind::Section => {
                let at = scene.at(Point::Warp(row, arguments.iter().copied().map(Scalar::from).collect(), PointId(0)));
                match row.kind {
                    Kind::Warp => scene.shape("sphere", &[5.0], at),
                    _ => scene.shape("circle", &[5.0], at),
                }
            }
            Kind::Helper => continue,
        };
        let checked = checked(&scene.done(), &[]);
        assert!(checked.distance([1.0, 2.0, 3.0]).is_finite(), "{}", row.name);
        assert!(checked.text.contains(&format!("{}(p", row.function)) || row.kind == Kind::Adjust, "{}", checked.text);
        let is_number = |word: &str| word.starts_with("_e");
        assert!(!checked.text.split(|c: char| !c.is_alphanumeric() && c != '_').any(is_number), "{}", checked.text);
    }
}

#[test]
fn maps_do_no_more_than_they_must() {
    let map = |rows: [[f64; 4]; 3]| {
        let mut scene = Scene::new();
        let at = scene.mapped(rows, PointId(0));
        scene.shape("ellipsoid", &[1.0, 2.0, 3.0], at);
        let checked = checked(&scene.done(), &[]);
        let p = [4.0, 5.0, 6.0];
        let local = rows.map(|row| row[3] + (0..3).map(|k| row[k] * p[k]).sum::<f64>());
        let machine = Machine { module: &checked.module, bound: HashMap::new() };
        let expected = machine.run("sd_ellipsoid", vec![local.to_vec(), vec![1.0, 2.0, 3.0]]);
        assert_close(checked.distance(p), expected[0]);
        let line = checked.text.lines().find(|line| line.contains("let ellipsoid_a = "));
        line.and_then(|line| line.trim().strip_prefix("let ellipsoid_a = sd_ellipsoid("))
            .unwrap_or_default()
            .to_string()
    };
    let turned = map([[0.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 2.0]]);
    assert_eq!(turned, "vec3(p.y, -p.x, p.z) - vec3(0.0, 0.0, -2.0), vec3(1.0, 2.0, 3.0));");
    let scaled = map([[2.0, 0.0, 0.0, 0.0], [0.0, 2.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0]]);
    assert_eq!(scaled, "p * 2.0, vec3(1.0, 2.0, 3.0));");
    let stretched = map([[2.0, 0.0, 0.0, 0.0], [0.0, 3.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);
    assert_eq!(stretched, "p * vec3(2.0, 3.0, 1.0), vec3(1.0, 2.0, 3.0));");
    let sheared = map([[1.0, 0.5, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.25, 1.0, 1.0]]);
    assert!(sheared.contains("mat3x3(vec3(1.0, 0.0, 0.0), vec3(0.5, 1.0, 0.25)"), "{sheared}");
}

#[test]
fn sections_turn_in_the_plane() {
    let mut scene = Scene::new();
    let section = scene.at(Point::Warp(&REVOLVE, vec![], PointId(0)));
    let at = scene.mapped([[0.0, -1.0, 0.0, 7.0], [1.0, 0.0, 0.0, -3.0], [0.0, 0.0, 1.0, 0.0]], section);
    scene.shape("circle", &[2.0], at);
    let checked = checked(&scene.done(), &[]);
    // The ring of radius 3 in the plane z = 7, of radius 2.
    assert_close(checked.distance([0.0, 3.0, 7.0]), -2.0);
    assert_close(checked.distance([0.0, -3.0, 12.0]), 3.0);
}

#[test]
fn extrusions_slices_and_confinements_combine() {
    let mut scene = Scene::new();
    let section = scene.at(Point::Warp(&SLICE, vec![], PointId(0)));
    let disc = scene.shape("circle", &[2.0], section);
    let tapered = scene.add(Node::Taper(Scalar::from(10.0), [0.5, 1.0].map(Scalar::from), disc, PointId(0)));
    let rod = scene.add(Node::Extrude(Scalar::from(10.0), tapered, PointId(0)));
    let flat = scene.at(Point::Flattened(PointId(0)));
    let ball = scene.shape("sphere", &[5.0], flat);
    let confined = scene.at(Point::Confined(Scalar::from(4.0), PointId(0)));
    let near = scene.shape("box", &[1.0, 1.0, 1.0], confined);
    let near = scene.add(Node::Confine(Scalar::from(4.0), 1.0, near, PointId(0)));
    let section = scene.at(Point::Confined(Scalar::from(4.0), section));
    let upright = scene.at(Point::Flattened(section));
    let pole = scene.shape("sphere", &[1.0], upright);
    let pole = scene.add(Node::Confine(Scalar::from(4.0), 1.0, pole, PointId(0)));
    scene.union(vec![rod, ball, near, pole]);
    let checked = checked(&scene.done(), &[]);
    assert_close(checked.distance([100.0, 0.0, 50.0]), 49.0_f64.hypot(40.0));
    assert_close(checked.distance([0.0, 0.0, 80.0]), -5.0);
}

#[test]
fn outlines_are_the_same_unrolled_and_in_a_loop() {
    let arc = |start: f64| Edge::Arc { center: [0.0, 0.0], radius: 5.0, start, sweep: 0.5 * PI };
    let arcs = Contour { edges: (0..4).map(|quarter| arc(0.5 * PI * f64::from(quarter))).collect() };
    for (sides, has_arcs) in [(7, false), (7, true), (60, false), (60, true)] {
        let mut region = Region::ngon(20.0, sides);
        if has_arcs {
            region.contours.push(arcs.clone());
        }
        let mut scene = Scene::new();
        scene.add(Node::Outline(Arc::new(region), PointId(0)));
        let graph = scene.done();
        let rows = splice(&graph, Template::Library).expect("small").tables.rows.len();
        assert_eq!(
            rows,
            match (sides, has_arcs) {
                (7, _) => 0,
                // Blocks of seven or eight pieces behind two rows each.
                (_, false) => 9 * (2 + 7),
                (_, true) => 9 * (2 + 2 * 8),
            }
        );
        let checked = checked(&graph, &[]);
        let apothem = 20.0 * (PI / f64::from(sides)).cos();
        let middle = if has_arcs { 5.0 } else { -apothem };
        assert_close(checked.distance([0.0, 0.0, 3.0]), middle);
        assert_close(checked.distance([25.0, 0.0, 3.0]), 5.0);
        assert!(checked.distance([0.0, 10.0, 3.0]) < 0.0);
        for p in random_points(100) {
            checked.distance(p);
        }
    }
}

#[test]
fn stages_are_the_same_unrolled_and_in_a_loop() {
    let turned = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [[cos, sin], [-sin, cos]]
    };
    for (stages, sides) in [(1, 5), (3, 5), (1, 60), (3, 60)] {
        let levels: Vec<_> = (0..=stages).map(|k| turned(-2.0 * f64::from(k))).collect();
        let loft = Arc::new(Loft::new(&Region::ngon(9.0, sides), &levels, 12.0, true));
        let mut scene = Scene::new();
        let section = scene.add(Node::Loft(loft, PointId(0)));
        scene.add(Node::Extrude(Scalar::from(12.0), section, PointId(0)));
        let graph = scene.done();
        let rows = splice(&graph, Template::Library).expect("small").tables.rows.len();
        assert_eq!(rows, if sides == 5 { 0 } else { (stages * 2 * 2 * sides) as usize });
        let checked = checked(&graph, &[]);
        assert_close(checked.distance([0.0, 0.0, 15.0]), 3.0);
        assert_close(checked.distance([9.0, 0.0, 0.0]), 0.0);
        for p in random_points(100) {
            checked.distance(p);
        }
    }
}

#[test]
fn polytopes_are_the_same_unrolled_and_in_a_loop() {
    let octant = |x: f64, y: f64, z: f64| {
        let corners = [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
        if x * y * z > 0.0 { corners } else { [corners[0], corners[2], corners[1]] }
    };
    let sign = |bit: u32| if bit == 0 { -6.0 } else { 6.0 };
    let octahedron: Vec<_> = (0..8).map(|i| octant(sign(i & 1), sign(i & 2), sign(i & 4))).collect();
    for copies in [1, 4] {
        let mut scene = Scene::new();
        scene.add(Node::Polytope(octahedron.repeat(copies).into(), PointId(0)));
        let checked = checked(&scene.done(), &[]);
        assert_eq!(checked.bound["tables"].len(), if copies == 1 { 0 } else { 96 });
        assert_close(checked.distance([0.0, 0.0, 0.0]), -6.0 / 3.0_f64.sqrt());
        assert_close(checked.distance([0.0, 9.0, 0.0]), 3.0);
    }
}

#[test]
fn joints_solve_their_equation_for_any_number_of_operands() {
    for (profile, exponent) in [(Profile::Chamfer, 1.0), (Profile::Fillet, 2.0), (Profile::Smooth, 3.0)] {
        for count in 2..6 {
            for operation in [Operation::Union, Operation::Intersection] {
                let mut scene = Scene::new();
                let balls: Vec<NodeId> = (0..count)
                    .map(|i| {
                        let at = scene.moved([f64::from(i), 0.0, 0.0]);
                        scene.shape("sphere", &[2.0], at)
                    })
                    .collect();
                scene.add(Node::Boolean(operation, Some(Joint { profile, radius: Scalar::from(3.0) }), balls));
                let checked = checked(&scene.done(), &[]);
                let p = [0.5, 1.5, 1.0];
                let sign = if operation == Operation::Union { 1.0 } else { -1.0 };
                let x = sign * checked.distance(p);
                let term = |i: i32| {
                    let d = sign * ((p[0] - f64::from(i)).hypot(p[1].hypot(p[2])) - 2.0);
                    (1.0 - (d - x) / 3.0).max(0.0).powf(exponent)
                };
                assert_close((0..count).map(term).sum(), 1.0);
            }
        }
    }
}

#[test]
fn materials_follow_the_surface() {
    let mut scene = Scene::new();
    let at = scene.moved([10.0, 0.0, 0.0]);
    let ball = scene.shape("sphere", &[5.0], PointId(0));
    let other = scene.shape("sphere", &[5.0], at);
    let (red, green) = (scene.painted(RED, ball), scene.painted(GREEN, other));
    let joint = Joint { profile: Profile::Fillet, radius: Scalar::from(4.0) };
    scene.add(Node::Boolean(Operation::Union, Some(joint), vec![red, green]));
    let checked = checked(&scene.done(), &[]);
    assert_eq!(checked.color([-5.0, 0.0, 0.0]), [1.0, 0.0, 0.0]);
    assert_eq!(checked.color([15.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
    assert_eq!(checked.color([5.0, 0.0, 0.1]), [0.5, 0.5, 0.0]);
}

#[test]
fn a_cut_looks_like_what_it_is_cut_from() {
    let mut scene = Scene::new();
    let cube = scene.shape("box", &[5.0, 5.0, 5.0], PointId(0));
    let red = scene.painted(RED, cube);
    let at = scene.moved([5.0, 0.0, 0.0]);
    let hole = scene.shape("sphere", &[2.0], at);
    let cut = scene.difference(red, hole);
    let beyond = scene.moved([0.0, 5.0, 0.0]);
    let hole = scene.shape("sphere", &[2.0], beyond);
    let green = scene.painted(GREEN, hole);
    let both = scene.difference(cut, green);
    let checked_both = checked(&scene.done(), &[]);
    assert_eq!(checked_both.color([3.0, 0.0, 0.0]), [1.0, 0.0, 0.0]);
    assert_eq!(checked_both.color([0.0, 3.0, 0.0]), [0.0, 1.0, 0.0]);
    let _ = both;
}

#[test]
fn one_material_needs_no_distances() {
    let mut scene = Scene::new();
    let cube = scene.shape("box", &[5.0, 5.0, 5.0], PointId(0));
    let red = scene.painted(RED, cube);
    let hole = scene.shape("sphere", &[2.0], PointId(0));
    scene.difference(red, hole);
    let text = checked(&scene.done(), &[]).text;
    let surface = &text[text.find("fn scene_surface").expect("it is there")..];
    assert!(!surface.contains("sd_"), "{surface}");
}

#[test]
fn live_numbers_come_from_the_uniform() {
    let mut scene = Scene::new();
    let live: Vec<Scalar> = (0..6).map(|id| Scalar::parameter(ParameterId(id), Interval::new(-9.0, 9.0))).collect();
    scene.0.slots = live.clone();
    let by = Affine::translation([live[1].clone(), Scalar::ZERO, Scalar::ZERO]);
    let at = scene.at(Point::Affine(by, PointId(0)));
    let ball = scene.add(Node::Shape(row("sphere").expect("a row"), vec![live[5].clone()], at));
    let [red, green, blue] = [&live[2], &live[3], &live[4]].map(Scalar::clone);
    scene.0.materials.push(Material::of_color([red, green, blue, Scalar::ONE]));
    scene.add(Node::Paint(MaterialId(0), ball));
    let checked = checked(&scene.done(), &[9.0, -3.0, 1.0, 0.5, 0.0, 2.0]);
    assert_close(checked.distance([7.0, 0.0, 0.0]), 2.0);
    let [red, green, blue] = checked.color([0.0; 3]);
    assert_close(red, 1.0);
    assert_close(green, 0.21404);
    assert_close(blue, 0.0);
}

#[test]
fn large_scenes_are_divided() {
    let mut scene = Scene::new();
    let place = |i: u32| [f64::from(i % 30) * 3.0, f64::from(i / 30) * 3.0, 0.0];
    let balls: Vec<NodeId> = (0..900)
        .map(|i| {
            let at = scene.moved(place(i));
            let ball = scene.shape("sphere", &[1.0], at);
            scene.within(ball, place(i).map(|c| c - 1.0), place(i).map(|c| c + 1.0));
            let color = match i % 3 {
                0 => RED,
                1 => GREEN,
                _ => return ball,
            };
            let painted = scene.painted(color, ball);
            scene.0.facts[painted.0 as usize] = scene.0.facts[ball.0 as usize];
            painted
        })
        .collect();
    scene.union(balls);
    let checked = checked(&scene.done(), &[]);
    let longest = checked.module.functions.iter().map(|(_, function)| function.expressions.len()).max();
    assert!(longest < Some(2000), "{longest:?}");
    assert!(checked.text.contains("<= max(so_far_"), "{}", checked.text);
    for p in random_points(100) {
        checked.distance(p);
    }
    for p in [[1.0, 2.0, 3.0], [40.0, 41.0, -7.0], [200.0, 0.0, 0.0]] {
        let to = |i: u32| place(i).iter().zip(p).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt() - 1.0;
        assert_close(checked.distance(p), (0..900).map(to).fold(f64::INFINITY, f64::min));
    }
    assert_eq!(checked.color([3.0, 0.0, 1.0]), [0.0, 1.0, 0.0]);
    assert_eq!(checked.color([9.0, 9.0, 1.0]), [1.0, 0.0, 0.0]);
}

#[test]
fn costly_operands_are_asked_only_where_they_count() {
    let mut scene = Scene::new();
    let mut gears: Vec<NodeId> = (0..4)
        .map(|i| {
            let by = f64::from(i) * 12.0 - 18.0;
            let at = scene.moved([by, 0.0, 0.0]);
            let gear = scene.add(Node::Outline(Arc::new(Region::ngon(5.0, 40 + 10 * i)), at));
            scene.within(gear, [by - 5.0, -5.0, f64::NEG_INFINITY], [by + 5.0, 5.0, f64::INFINITY]);
            gear
        })
        .collect();
    gears.push(scene.shape("sphere", &[4.0], PointId(0)));
    scene.union(gears);
    let checked = checked(&scene.done(), &[]);
    assert_eq!(checked.text.matches("= box_gap(").count(), 4, "{}", checked.text);
    for p in random_points(300) {
        checked.distance(p);
    }
}

#[test]
fn what_cannot_be_emitted_is_an_error() {
    let mut scene = Scene::new();
    scene.shape("sphere", &[f64::NAN], PointId(0));
    assert!(splice(&scene.done(), Template::Library).is_err());
    let mut scene = Scene::new();
    let balls = (0..MAX_NODES).map(|i| scene.shape("sphere", &[i as f64], PointId(0))).collect();
    scene.union(balls);
    let error = splice(&scene.done(), Template::Library).expect_err("it is too large");
    assert!(error.message.starts_with("too many shapes"), "{}", error.message);
}

#[test]
fn nothing_and_the_infinite_are_finite() {
    let mut scene = Scene::new();
    scene.add(Node::Nothing);
    assert_close(checked(&scene.done(), &[]).distance([0.0; 3]), 1e15);
    let mut scene = Scene::new();
    scene.shape("sphere", &[f64::INFINITY], PointId(0));
    assert_close(checked(&scene.done(), &[]).run("scene_distance", [0.0; 3])[0], -1e18);
}

#[test]
fn deep_scenes_do_not_exhaust_the_stack() {
    let mut scene = Scene::new();
    let mut tower = scene.shape("sphere", &[1.0], PointId(0));
    for level in 0..1000 {
        let ball = scene.shape("sphere", &[f64::from(level)], PointId(0));
        let painted = scene.painted(RED, ball);
        let joint = Joint { profile: Profile::Fillet, radius: Scalar::from(1.0) };
        tower = scene.add(Node::Boolean(Operation::Union, Some(joint), vec![tower, painted]));
        tower = scene.add(Node::Negate(tower));
    }
    assert!(splice(&scene.done(), Template::Trace).is_ok());
}

#[test]
fn what_is_shared_is_evaluated_once() {
    let mut scene = Scene::new();
    let ball = scene.shape("sphere", &[1.0], PointId(0));
    let cube = scene.shape("box", &[1.0, 2.0, 3.0], PointId(0));
    let red = scene.painted(RED, ball);
    let mut tower = scene.union(vec![red, cube]);
    for level in 0..60 {
        let slabs = [1.0, 2.0].map(|side| scene.shape("box", &[side, f64::from(level), 9.0], PointId(0)));
        let cut = slabs.map(|slab| scene.add(Node::Boolean(Operation::Intersection, None, vec![tower, slab])));
        tower = scene.union(cut.to_vec());
    }
    let checked = checked(&scene.done(), &[]);
    assert!(checked.text.len() < 100_000, "{}", checked.text.len());
}
