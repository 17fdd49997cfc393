//! Series: a function for what their members have in common, which is called for each of them.

use std::mem::replace;

use chiaro_field::series::{Instance, Series};
use chiaro_field::{AllSeries, Node, NodeId};
use naga::{Function, Handle};
use rustc_hash::FxHashMap;

use super::shapes::kind;
use super::surface::Look;
use super::{Emission, Scope};
use crate::build::Value;

/// The series of a graph that is being emitted.
pub(super) struct SeriesParts<'g> {
    all: &'g AllSeries,
    members: FxHashMap<usize, Handle<Function>>,
    surfaces: FxHashMap<usize, Handle<Function>>,
}

impl<'g> SeriesParts<'g> {
    pub(super) fn new(all: &'g AllSeries) -> Self {
        Self { all, members: FxHashMap::default(), surfaces: FxHashMap::default() }
    }

    /// The series that an operand is in.
    pub(super) fn of_operand(&self, operand: NodeId) -> Option<usize> {
        self.all.of_operand(operand)
    }

    /// The series whose function a node is asked by, and which of its members it is: single shapes have functions of the
    /// vocabulary.
    pub(super) fn of_member(&self, node: NodeId) -> Option<(usize, &'g Instance)> {
        self.all.of_member(node).filter(|(series, _)| self.all.series[*series].pattern.graph.nodes.len() > 1)
    }
}

impl<'g> Emission<'g> {
    fn series(&self, series: usize) -> &'g Series {
        &self.series.all.series[series]
    }

    /// What the members of a series are called, but for letters behind it.
    pub(super) fn name_of_series(&self, series: usize) -> String {
        let graph = &self.series(series).pattern.graph;
        let span = graph.spans.get(graph.root.0 as usize);
        let told = span.and_then(|span| (self.told)(*span));
        told.unwrap_or_else(|| kind(graph, graph.root).to_owned())
    }

    /// The function of the members' distance.
    fn member_function(&mut self, series: usize) -> Handle<Function> {
        if let Some(&known) = self.series.members.get(&series) {
            return known;
        }
        let name = self.name_of_series(series);
        let own = self.series(series);
        let function = self.within_series(own, |emission| {
            let (name, float) = (emission.names.next(&name), emission.types.float);
            let mut scope = Scope::new(emission, &name, float);
            scope.tell(own);
            let value = scope.distance(own.pattern.graph.root);
            scope.finish(value)
        });
        let handle = self.define(function, format!("// One of {}, where it stands by itself.\n", own.members.len()));
        self.series.members.insert(series, handle);
        handle
    }

    /// The function of what members look like.
    fn member_surface_function(&mut self, series: usize) -> Handle<Function> {
        if let Some(&known) = self.series.surfaces.get(&series) {
            return known;
        }
        let name = self.name_of_series(series) + "_surface";
        let own = self.series(series);
        let function = self.within_series(own, |emission| {
            let (name, surface) = (emission.names.next(&name), emission.surface_type);
            let mut scope = Scope::new(emission, &name, surface);
            scope.tell(own);
            let unpainted = scope.builder.another_argument("unpainted", surface);
            let unpainted = Look::of_surface(&mut scope.builder, unpainted);
            let value = scope.surface_over(own.pattern.graph.root, unpainted);
            scope.finish(value)
        });
        let handle = self.define(function, "// The material of it.\n");
        self.series.surfaces.insert(series, handle);
        handle
    }

    /// Emits something of a series' pattern.
    fn within_series<R>(&mut self, series: &'g Series, emit: impl FnOnce(&mut Self) -> R) -> R {
        let is_in_plane = replace(&mut self.is_in_plane, series.is_plane);
        let emitted = self.within(&series.pattern.graph, &series.within, emit);
        self.is_in_plane = is_in_plane;
        emitted
    }
}

impl<'g> Scope<'_, 'g> {
    /// What to call, and with what, for the distance to nodes that are no more than a member.
    pub(super) fn only_member(&mut self, nodes: &[NodeId]) -> Option<(Handle<Function>, Vec<Value>)> {
        let [node] = *nodes else { return None };
        let node = match self.emission.graph.nodes[node.0 as usize] {
            Node::Paint(_, child) => child,
            _ => node,
        };
        let member = self.emission.series.of_member(node)?;
        Some(self.member_call(member))
    }

    fn member_call(&mut self, (series, member): (usize, &'g Instance)) -> (Handle<Function>, Vec<Value>) {
        (self.emission.member_function(series), self.member_arguments(series, member))
    }

    /// The distance to a member.
    pub(super) fn member_distance(&mut self, id: NodeId, member: (usize, &'g Instance)) -> Value {
        let (function, arguments) = self.member_call(member);
        let value = self.builder.call(function, &arguments);
        self.name_node(value, id)
    }

    /// What a member looks like; what nobody painted looks as given.
    pub(super) fn member_look(&mut self, (series, member): (usize, &'g Instance), unpainted: Look) -> Look {
        let function = self.emission.member_surface_function(series);
        let mut arguments = self.member_arguments(series, member);
        let ty = self.emission.surface_type;
        arguments.push(unpainted.compose(&mut self.builder, ty));
        let surface = self.builder.call(function, &arguments);
        Look::of_surface(&mut self.builder, surface)
    }

    /// What functions of a series are asked: the point where the member stands by itself, and its numbers.
    fn member_arguments(&mut self, series: usize, member: &'g Instance) -> Vec<Value> {
        let Series { base, is_plane, .. } = *self.emission.series(series);
        let point = self.point(base);
        let asked = match is_plane {
            true => self.mapped::<2>(&member.map, point),
            false => self.mapped::<3>(&member.map, point),
        };
        let numbers = member.numbers.iter().map(|number| self.scalar(number));
        std::iter::once(asked).chain(numbers).collect()
    }

    /// Makes the numbers that tell members apart arguments of the function.
    fn tell(&mut self, series: &'g Series) {
        for number in &series.pattern.graph.slots {
            let (name, float) = (self.emission.names.next("number"), self.emission.types.float);
            let value = self.builder.another_argument(&name, float);
            self.told.insert(number, value);
        }
    }
}
