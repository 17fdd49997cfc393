//! The surface: which material is where.
//!
//! Of a union the nearest operand's material counts, of an intersection the farthest one's; joints blend theirs by
//! the weights of the joint's formula. A complement that nobody painted looks like what it is cut from. Distances are
//! evaluated only where materials differ.

use chiaro_field::{Graph, Node, NodeId, graph::Operation};
use chiaro_solid::{Joint, Material, Scalar};
use chiaro_vocabulary::rows::JOINT_WEIGHT;
use naga::{BinaryOperator, Handle, Type};
use rustc_hash::FxHashMap;

use super::{Scope, parts::children};
use crate::build::Value;

/// The number of a material, equal ones counted once.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct PaintId(usize);

/// Who painted a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Painted {
    /// Nobody: it looks as its surroundings say.
    Nobody,
    /// All of it has one material.
    Once(PaintId),
    /// Several materials.
    Variously,
}

/// The materials of a scene.
pub(super) struct Paints {
    materials: Vec<Material>,
    /// The paint of each of the graph's materials.
    paints: Vec<PaintId>,
    painted: Vec<Painted>,
}

impl Paints {
    pub(super) fn new(graph: &Graph) -> Self {
        let mut materials = vec![Material::default()];
        let mut known = FxHashMap::default();
        let paints: Vec<PaintId> = (graph.materials.iter())
            .map(|material| {
                *known.entry(numbers(material)).or_insert_with(|| {
                    materials.push(material.clone());
                    PaintId(materials.len() - 1)
                })
            })
            .collect();
        let mut painted: Vec<Painted> = Vec::with_capacity(graph.nodes.len());
        for node in &graph.nodes {
            let of_node = match node {
                Node::Paint(material, _) => Painted::Once(paints[material.0 as usize]),
                Node::Boolean(operation, _, children) => painted_together(graph, &painted, *operation, children),
                _ => children(node).first().map_or(Painted::Nobody, |child| painted[child.0 as usize]),
            };
            painted.push(of_node);
        }
        Self { materials, paints, painted }
    }

    /// Who painted the node.
    pub(super) fn painted(&self, id: NodeId) -> Painted {
        self.painted[id.0 as usize]
    }
}

/// Everything a material consists of, to compare it by.
fn numbers(material: &Material) -> [Scalar; 7] {
    let Material { color: [red, green, blue, opacity], roughness, metallic, emission } = material.clone();
    [red, green, blue, opacity, roughness, metallic, emission]
}

fn painted_together(graph: &Graph, painted: &[Painted], operation: Operation, children: &[NodeId]) -> Painted {
    let mut cut = Painted::Nobody;
    let mut together = None;
    for child in children {
        let mut own = painted[child.0 as usize];
        if is_cut(graph, operation, *child) {
            own = if own == Painted::Nobody { cut } else { own };
        } else {
            cut = own;
        }
        together = match together {
            None => Some(own),
            Some(same) if same == own => together,
            Some(_) => Some(Painted::Variously),
        };
    }
    together.unwrap_or(Painted::Nobody)
}

/// Whether the child of such a Boolean takes something away.
fn is_cut(graph: &Graph, operation: Operation, child: NodeId) -> bool {
    operation == Operation::Intersection && matches!(graph.nodes[child.0 as usize], Node::Negate(_))
}

/// A look that is not evaluated yet, or is.
#[derive(Clone, Copy, PartialEq)]
enum Appearance {
    Paint(PaintId),
    Evaluated(Look),
}

/// The components of a surface.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Look {
    color: Value,
    finish: Value,
}

/// Operands of a Boolean that look the same: the places among its children.
struct Alike {
    appearance: Appearance,
    places: Vec<usize>,
}

impl Scope<'_, '_> {
    /// The surface of the whole scene.
    pub(super) fn surface(&mut self, root: NodeId, ty: Handle<Type>) -> Value {
        let appearance = self.appearance(root, Appearance::Paint(PaintId(0)));
        let Look { color, finish } = self.look(appearance);
        self.builder.compose(ty, &[color, finish])
    }

    /// How the node looks, if what nobody painted looks as given.
    fn appearance(&mut self, id: NodeId, unpainted: Appearance) -> Appearance {
        match self.emission.paints.painted(id) {
            Painted::Nobody => return unpainted,
            Painted::Once(paint) => return Appearance::Paint(paint),
            Painted::Variously => {}
        }
        let graph = self.emission.graph;
        match &graph.nodes[id.0 as usize] {
            Node::Paint(material, _) => Appearance::Paint(self.emission.paints.paints[material.0 as usize]),
            Node::Boolean(operation, joint, operands) => {
                let alike = self.alike(*operation, operands, unpainted);
                match (&alike[..], joint) {
                    ([only], _) => only.appearance,
                    (_, None) => Appearance::Evaluated(self.foremost(*operation, operands, &alike)),
                    (_, Some(joint)) => Appearance::Evaluated(self.blended(*operation, joint, operands, &alike)),
                }
            }
            node => match children(node) {
                [child, ..] => self.appearance(*child, unpainted),
                [] => unpainted,
            },
        }
    }

    /// The operands by their looks.
    fn alike(&mut self, operation: Operation, operands: &[NodeId], unpainted: Appearance) -> Vec<Alike> {
        let graph = self.emission.graph;
        let mut alike: Vec<Alike> = Vec::new();
        let mut known: FxHashMap<PaintId, usize> = FxHashMap::default();
        let mut cut = unpainted;
        for (place, operand) in operands.iter().enumerate() {
            let appearance = if is_cut(graph, operation, *operand) {
                self.appearance(*operand, cut)
            } else {
                cut = self.appearance(*operand, unpainted);
                cut
            };
            let group = match appearance {
                Appearance::Paint(paint) => *known.entry(paint).or_insert(alike.len()),
                Appearance::Evaluated(_) => match alike.last() {
                    Some(last) if last.appearance == appearance => alike.len() - 1,
                    _ => alike.len(),
                },
            };
            match alike.get_mut(group) {
                Some(group) => group.places.push(place),
                None => alike.push(Alike { appearance, places: vec![place] }),
            }
        }
        alike
    }

    /// The look of the nearest operand of a union or the farthest of an intersection; the first of several.
    fn foremost(&mut self, operation: Operation, operands: &[NodeId], alike: &[Alike]) -> Look {
        let beats = match operation {
            Operation::Union => BinaryOperator::Less,
            Operation::Intersection => BinaryOperator::Greater,
        };
        let mut best: Option<(Value, Look)> = None;
        for group in alike {
            let nodes: Vec<NodeId> = group.places.iter().map(|place| operands[*place]).collect();
            let reduced = self.reduced(operation, &nodes);
            let distance = self.name(reduced, "extent");
            let look = self.look(group.appearance);
            best = Some(match best {
                None => (distance, look),
                Some((so_far, before)) => {
                    let wins = self.builder.binary(beats, distance, so_far);
                    let wins = self.name(wins, "wins");
                    let look = Look {
                        color: self.chosen(wins, look.color, before.color, "color"),
                        finish: self.chosen(wins, look.finish, before.finish, "finish"),
                    };
                    let extreme = self.chain(operation, &[so_far, distance]);
                    (self.name(extreme, "so_far"), look)
                }
            });
        }
        match best {
            Some((_, look)) => look,
            None => unreachable!("a Boolean has operands"),
        }
    }

    fn chosen(&mut self, condition: Value, accept: Value, reject: Value, prefix: &'static str) -> Value {
        if accept == reject {
            return accept;
        }
        let chosen = self.builder.select(condition, accept, reject);
        self.name(chosen, prefix)
    }

    /// The looks, each by its operands' weights in the joint.
    fn blended(&mut self, operation: Operation, joint: &Joint, operands: &[NodeId], alike: &[Alike]) -> Look {
        let joined = self.joint(operation, joint, operands);
        let mut sum: Option<(Value, Look)> = None;
        for group in alike {
            let weights = group.places.iter().map(|place| joined.distances[*place]).collect::<Vec<_>>();
            let weights = weights.into_iter().map(|distance| {
                let arguments = [distance, joined.joint, joined.radius, joined.exponent];
                let weight = self.call(&JOINT_WEIGHT, &arguments);
                self.name(weight, "weight")
            });
            let Some(weight) = weights.collect::<Vec<_>>().into_iter().reduce(|sum, weight| self.sum(sum, weight))
            else {
                continue;
            };
            let look = self.look(group.appearance);
            let color = self.product(look.color, weight);
            let finish = self.product(look.finish, weight);
            sum = Some(match sum {
                None => (weight, Look { color, finish }),
                Some((total, before)) => {
                    let look = Look { color: self.sum(before.color, color), finish: self.sum(before.finish, finish) };
                    (self.sum(total, weight), look)
                }
            });
        }
        let Some((total, Look { color, finish })) = sum else { unreachable!("a joint has operands") };
        let color = self.builder.binary(BinaryOperator::Divide, color, total);
        let finish = self.builder.binary(BinaryOperator::Divide, finish, total);
        Look { color: self.name(color, "color"), finish: self.name(finish, "finish") }
    }

    fn sum(&mut self, left: Value, right: Value) -> Value {
        let sum = self.builder.binary(BinaryOperator::Add, left, right);
        self.name(sum, "sum")
    }

    fn product(&mut self, left: Value, right: Value) -> Value {
        self.builder.binary(BinaryOperator::Multiply, left, right)
    }

    fn look(&mut self, appearance: Appearance) -> Look {
        match appearance {
            Appearance::Evaluated(look) => look,
            Appearance::Paint(paint) => match self.paints.get(&paint) {
                Some(look) => *look,
                None => {
                    let material = self.emission.paints.materials[paint.0].clone();
                    let look = Look { color: self.color(&material), finish: self.finish_of(&material) };
                    self.paints.insert(paint, look);
                    look
                }
            },
        }
    }

    /// The material's colour, linear, with its opacity.
    fn color(&mut self, material: &Material) -> Value {
        let [red, green, blue, opacity] = &material.color;
        let constants: Option<Vec<f64>> = [red, green, blue].iter().map(|channel| channel.constant()).collect();
        let linear = match constants {
            Some(srgb) => srgb.into_iter().map(|channel| self.constant(linear_from_srgb(channel))).collect(),
            None => {
                let srgb = self.vector(&[red, green, blue].map(Scalar::clone));
                vec![self.call_named("linear_from_srgb", &[srgb])]
            }
        };
        let opacity = self.scalar(opacity);
        let color = self.builder.vector4(&[&linear[..], &[opacity]].concat());
        self.name(color, "color")
    }

    /// The material's roughness, metallic and emission.
    fn finish_of(&mut self, material: &Material) -> Value {
        let Material { roughness, metallic, emission, .. } = material;
        let numbers = [roughness, metallic, emission, &Scalar::ZERO].map(Scalar::clone);
        let finish = self.vector(&numbers);
        self.name(finish, "finish")
    }
}

/// Linear light from a channel of sRGB (IEC 61966-2-1).
fn linear_from_srgb(channel: f64) -> f64 {
    if channel <= 0.04045 { channel.max(0.0) / 12.92 } else { ((channel + 0.055) / 1.055).powf(2.4) }
}
