//! Field graphs as text, for people and for tests: points, then nodes with what is known of them, each referring to
//! those above it by number.

use std::fmt::Write;

use chiaro_solid::print::{number, short};
use chiaro_solid::{Affine, Profile, Scalar};
use chiaro_vocabulary::{Bounds, Class, Row};

use crate::facts::Facts;
use crate::graph::{Graph, Node, NodeId, Operation, Point};

/// A graph, its root last.
pub fn print(graph: &Graph) -> String {
    let mut text = String::new();
    for (index, slot) in graph.slots.iter().enumerate() {
        let _ = writeln!(text, "s{index} = {}", number(slot));
    }
    let scalar = |scalar: &Scalar| match graph.slots.iter().position(|slot| slot == scalar) {
        Some(slot) => format!("s{slot}"),
        None => number(scalar),
    };
    let printer = Printer { scalar: &scalar };
    for (index, point) in graph.points.iter().enumerate() {
        let _ = writeln!(text, "q{index} = {}", printer.point(point));
    }
    for (index, (node, facts)) in graph.nodes.iter().zip(&graph.facts).enumerate() {
        let _ = writeln!(text, "d{index} = {:<40} {}", printer.node(node), describe(facts));
    }
    for (index, material) in graph.materials.iter().enumerate() {
        let color = printer.list(&material.color);
        let [roughness, metallic, emission] =
            [&material.roughness, &material.metallic, &material.emission].map(printer.scalar);
        let _ = writeln!(text, "m{index} = {color}, roughness {roughness}, metallic {metallic}, emission {emission}");
    }
    let _ = writeln!(text, "scene d{}", graph.root.0);
    text
}

/// Shows live numbers by their slot.
struct Printer<'a> {
    scalar: &'a dyn Fn(&Scalar) -> String,
}

impl Printer<'_> {
    fn point(&self, point: &Point) -> String {
        match point {
            Point::World => String::from("world"),
            Point::Affine(map, from) => format!("q{} {}", from.0, self.map(map)),
            Point::Warp(row, arguments, from) => format!("{} of q{}", self.call(row, arguments), from.0),
            Point::Confined(radius, from) => format!("q{} confined to {}", from.0, (self.scalar)(radius)),
            Point::Flattened(from) => format!("q{} flattened", from.0),
        }
    }

    fn map(&self, map: &Affine) -> String {
        let rows = map.rows();
        if map.is_translation() {
            let by = [0, 1, 2].map(|i| rows[i][3].clone());
            return format!("moved {}", self.list(&by));
        }
        format!("mapped [{}; {}; {}]", self.list(&rows[0]), self.list(&rows[1]), self.list(&rows[2]))
    }

    fn node(&self, node: &Node) -> String {
        match node {
            Node::Nothing => String::from("nothing"),
            Node::Shape(row, arguments, point) => format!("{} at q{}", self.call(row, arguments), point.0),
            Node::Outline(region, point) => format!("outline of {} edges at q{}", region.edges().count(), point.0),
            Node::Loft(loft, point) => {
                format!("loft in {} stages of {} sides at q{}", loft.stages().len(), loft.sides(), point.0)
            }
            Node::Polytope(triangles, point) => format!("polytope of {} triangles at q{}", triangles.len(), point.0),
            Node::Boolean(operation, joint, children) => {
                let name = match operation {
                    Operation::Union => "union",
                    Operation::Intersection => "intersection",
                };
                let joint = joint.as_ref().map(|joint| {
                    let profile = match joint.profile {
                        Profile::Chamfer => "chamfer",
                        Profile::Fillet => "fillet",
                        Profile::Smooth => "smooth",
                    };
                    format!(" {profile} {}", (self.scalar)(&joint.radius))
                });
                format!("{name}{} of {}", joint.unwrap_or_default(), nodes(children))
            }
            Node::Negate(child) => format!("complement of d{}", child.0),
            Node::Adjust(row, arguments, child) => format!("{} of d{}", self.call(row, arguments), child.0),
            Node::Extrude(height, child, point) => {
                format!("extrude {} of d{} at q{}", (self.scalar)(height), child.0, point.0)
            }
            Node::Taper(height, scale, child, point) => {
                let (height, scale) = ((self.scalar)(height), self.list(scale));
                format!("taper {height} to {scale} of d{} at q{}", child.0, point.0)
            }
            Node::Confine(radius, lipschitz, child, point) => {
                let (radius, lipschitz) = ((self.scalar)(radius), short(*lipschitz));
                format!("confine {radius} of d{} at q{} with L {lipschitz}", child.0, point.0)
            }
            Node::Paint(material, child) => format!("paint m{} of d{}", material.0, child.0),
        }
    }

    fn call(&self, row: &Row, arguments: &[Scalar]) -> String {
        match arguments {
            [] => String::from(row.name),
            _ => format!("{} {}", row.name, self.list(arguments)),
        }
    }

    fn list(&self, numbers: &[Scalar]) -> String {
        numbers.iter().map(self.scalar).collect::<Vec<_>>().join(" ")
    }
}

fn nodes(ids: &[NodeId]) -> String {
    ids.iter().map(|id| format!("d{}", id.0)).collect::<Vec<_>>().join(" ")
}

fn describe(facts: &Facts) -> String {
    let class = match facts.class {
        Class::Exact => "exact",
        Class::ExactOutside => "exact outside",
        Class::Bound => "bound",
    };
    let slope = if facts.lipschitz == 1.0 { String::new() } else { format!(" L {}", short(facts.lipschitz)) };
    format!("{class}{slope} {}", describe_bounds(&facts.bounds))
}

fn describe_bounds(bounds: &Bounds) -> String {
    if bounds.is_empty() {
        return String::from("nowhere");
    }
    let corner = |corner: [f64; 3]| corner.map(short).join(" ");
    format!("({}) to ({})", corner(bounds.min), corner(bounds.max))
}
