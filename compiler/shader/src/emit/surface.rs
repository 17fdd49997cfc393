//! The surface: which material is where.
//!
//! Of a union the nearest operand's material counts, of an intersection the farthest one's; joints blend theirs by
//! the weights of the joint's formula. A complement that nobody painted looks like what it is cut from. Distances are
//! evaluated only where materials differ.

use chiaro_field::paints::{PaintId, Painted, is_cut};
use chiaro_field::{Node, NodeId, Operation, linear_from_srgb};
use chiaro_solid::{Joint, Material, Scalar};
use chiaro_vocabulary::rows::JOINT_WEIGHT;
use naga::{BinaryOperator, Handle, Type};
use rustc_hash::FxHashMap;

use super::Scope;
use super::blend::Joined;
use crate::build::{Builder, Value};

/// A look that is not evaluated yet, or is.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Appearance {
    Paint(PaintId),
    Evaluated(Look),
}

/// The components of a surface.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Look {
    color: Value,
    finish: Value,
}

impl Look {
    /// That of a surface.
    pub(super) fn of_surface(builder: &mut Builder, surface: Value) -> Self {
        Self { color: builder.component(surface, 0), finish: builder.component(surface, 1) }
    }

    /// As a surface, the type of which is given.
    pub(super) fn compose(self, builder: &mut Builder, surface: Handle<Type>) -> Value {
        builder.compose(surface, &[self.color, self.finish])
    }
}

/// Operands of a Boolean that look the same: the places among its children; or the members of a crowd.
struct Alike {
    appearance: Appearance,
    places: Vec<usize>,
    crowd: Option<usize>,
}

impl Scope<'_, '_> {
    /// The surface of the whole scene.
    pub(super) fn surface(&mut self, root: NodeId) -> Value {
        self.surface_of(root, Appearance::Paint(PaintId::UNPAINTED))
    }

    /// The surface of a node; what nobody painted looks as given.
    pub(super) fn surface_over(&mut self, id: NodeId, unpainted: Look) -> Value {
        self.surface_of(id, Appearance::Evaluated(unpainted))
    }

    fn surface_of(&mut self, id: NodeId, unpainted: Appearance) -> Value {
        let appearance = self.appearance(id, unpainted);
        let look = self.look(appearance);
        look.compose(&mut self.builder, self.emission.surface_type)
    }

    /// How the node looks, if what nobody painted looks as given.
    fn appearance(&mut self, id: NodeId, unpainted: Appearance) -> Appearance {
        match self.emission.paints.painted(id) {
            Painted::Nobody => return unpainted,
            Painted::Once(paint) => return Appearance::Paint(paint),
            Painted::Variously => {}
        }
        if let Some(&known) = self.appearances.get(&(id, unpainted)) {
            return known;
        }
        let appearance = self.evaluated_appearance(id, unpainted);
        self.appearances.insert((id, unpainted), appearance);
        appearance
    }

    fn evaluated_appearance(&mut self, id: NodeId, unpainted: Appearance) -> Appearance {
        let graph = self.emission.graph;
        if let Some(member) = self.emission.series.of_member(id) {
            let unpainted = self.look(unpainted);
            return Appearance::Evaluated(self.member_look(member, unpainted));
        }
        match &graph.nodes[id.0 as usize] {
            Node::Boolean(operation, joint, operands) => {
                if let Some(crowd) = self.emission.crowd_of(id) {
                    return self.crowd_appearance(crowd, unpainted);
                }
                let alike = self.alike(*operation, operands, unpainted);
                match (&alike[..], joint) {
                    ([only], _) => only.appearance,
                    (_, None) => Appearance::Evaluated(self.foremost(*operation, operands, &alike)),
                    (_, Some(joint)) => Appearance::Evaluated(self.blended(id, *operation, joint, operands, &alike)),
                }
            }
            node => match node.children() {
                [child, ..] => self.appearance(*child, unpainted),
                [] => unpainted,
            },
        }
    }

    /// How a crowd looks, with the operands that are no members.
    fn crowd_appearance(&mut self, crowd: usize, unpainted: Appearance) -> Appearance {
        let appearance = match self.emission.painted_crowd(crowd) {
            Painted::Nobody => unpainted,
            Painted::Once(paint) => Appearance::Paint(paint),
            Painted::Variously => {
                let unpainted = self.look(unpainted);
                Appearance::Evaluated(self.crowd_look(crowd, unpainted))
            }
        };
        let others = &self.emission.crowds.crowd(crowd).others;
        let mut alike = vec![Alike { appearance, places: Vec::new(), crowd: Some(crowd) }];
        alike.extend(self.alike(Operation::Union, others, unpainted));
        match alike.iter().all(|group| group.appearance == appearance) {
            true => appearance,
            false => Appearance::Evaluated(self.foremost(Operation::Union, others, &alike)),
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
                None => alike.push(Alike { appearance, places: vec![place], crowd: None }),
            }
        }
        alike
    }

    /// The look of the nearest operand of a union or the farthest of an intersection; the first of several.
    fn foremost(&mut self, operation: Operation, operands: &[NodeId], alike: &[Alike]) -> Look {
        let Some((first, others)) = alike.split_first() else { unreachable!("a Boolean has operands") };
        let beats = match operation {
            Operation::Union => BinaryOperator::Less,
            Operation::Intersection => BinaryOperator::Greater,
        };
        let mut so_far = self.extent(operation, operands, first);
        let mut best = self.look(first.appearance);
        for (index, group) in others.iter().enumerate() {
            let extent = self.extent(operation, operands, group);
            let look = self.look(group.appearance);
            let wins = self.builder.binary(beats, extent, so_far);
            let wins = self.name(wins, "wins");
            best = Look {
                color: self.chosen(wins, look.color, best.color, "color"),
                finish: self.chosen(wins, look.finish, best.finish, "finish"),
            };
            if index + 1 < others.len() {
                let extreme = self.chain(operation, &[so_far, extent]);
                so_far = self.name(extreme, "so_far");
            }
        }
        best
    }

    /// The distance to operands that look the same.
    fn extent(&mut self, operation: Operation, operands: &[NodeId], alike: &Alike) -> Value {
        if let Some(crowd) = alike.crowd {
            return self.crowd_distance(crowd);
        }
        let nodes: Vec<NodeId> = alike.places.iter().map(|place| operands[*place]).collect();
        let extent = self.reduced(operation, &nodes);
        self.name(extent, "extent")
    }

    fn chosen(&mut self, condition: Value, accept: Value, reject: Value, prefix: &'static str) -> Value {
        if accept == reject {
            return accept;
        }
        let chosen = self.builder.select(condition, accept, reject);
        self.name(chosen, prefix)
    }

    /// The looks, each by its operands' weights in the joint.
    fn blended(
        &mut self,
        id: NodeId,
        operation: Operation,
        joint: &Joint,
        operands: &[NodeId],
        alike: &[Alike],
    ) -> Look {
        let joined = self.joint(id, operation, joint, operands);
        let weighted: Vec<(Value, Value, Value)> = (alike.iter())
            .map(|group| {
                let weight = self.weight(&joined, group);
                let look = self.look(group.appearance);
                let color = self.builder.binary(BinaryOperator::Multiply, look.color, weight);
                let finish = self.builder.binary(BinaryOperator::Multiply, look.finish, weight);
                (weight, color, finish)
            })
            .collect();
        let sum = weighted
            .into_iter()
            .reduce(|sum, next| (self.sum(sum.0, next.0), self.sum(sum.1, next.1), self.sum(sum.2, next.2)));
        let Some((total, color, finish)) = sum else { unreachable!("a joint has operands") };
        let one = self.builder.literal(1.0);
        let share = self.builder.binary(BinaryOperator::Divide, one, total);
        let share = self.name(share, "share");
        let color = self.builder.binary(BinaryOperator::Multiply, color, share);
        let finish = self.builder.binary(BinaryOperator::Multiply, finish, share);
        Look { color: self.name(color, "color"), finish: self.name(finish, "finish") }
    }

    /// How much operands that look the same count in a joint.
    fn weight(&mut self, joined: &Joined, alike: &Alike) -> Value {
        let weights: Vec<Value> = (alike.places.iter())
            .map(|place| {
                let arguments = [joined.distances[*place], joined.joint, joined.radius, joined.exponent];
                let weight = self.call(&JOINT_WEIGHT, &arguments);
                self.name(weight, "weight")
            })
            .collect();
        let Some(weight) = weights.into_iter().reduce(|sum, weight| self.sum(sum, weight)) else {
            unreachable!("some operand looks so")
        };
        weight
    }

    fn sum(&mut self, left: Value, right: Value) -> Value {
        let sum = self.builder.binary(BinaryOperator::Add, left, right);
        self.name(sum, "sum")
    }

    fn look(&mut self, appearance: Appearance) -> Look {
        match appearance {
            Appearance::Evaluated(look) => look,
            Appearance::Paint(paint) => {
                let material = self.emission.paints.material(paint).clone();
                Look { color: self.color(&material), finish: self.finish_of(&material) }
            }
        }
    }

    /// The material's colour, linear, with its opacity.
    fn color(&mut self, material: &Material) -> Value {
        if let Some(&color) = self.colors.get(&material.color) {
            return color;
        }
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
        let color = self.builder.compose(self.builder.types.vec4, &[&linear[..], &[opacity]].concat());
        self.colors.insert(material.color.clone(), color);
        self.name(color, "color")
    }

    /// The material's roughness, metallic and emission.
    fn finish_of(&mut self, material: &Material) -> Value {
        let Material { roughness, metallic, emission, .. } = material;
        let numbers = [roughness, metallic, emission, &Scalar::ZERO].map(Scalar::clone);
        if let Some(&finish) = self.finishes.get(&numbers) {
            return finish;
        }
        let finish = self.vector(&numbers);
        self.finishes.insert(numbers, finish);
        self.name(finish, "finish")
    }
}
