//! Crowds: a loop over the members that a cell lists, in the place of code for each.
//!
//! Members of the same pattern stand together in a list, and each pattern has a loop of its own: software GPUs run all
//! code of a branch under a mask, but leave loops after one round. The code depends on the patterns alone: scenes whose
//! members differ by numbers have the same.

use std::mem::replace;

use chiaro_field::crowd::{Crowd, Pattern};
use chiaro_field::{Crowds, NodeId};
use naga::{BinaryOperator, Block, Expression, Function, Handle, Literal, Statement};
use rustc_hash::FxHashMap;

use super::numbers::slots;
use super::shapes::FAR;
use super::surface::Look;
use super::{Emission, NO_SERIES, Scope};
use crate::build::Value;
use crate::crowd::{GRID_ROWS, PATTERN_BITS};
use chiaro_field::paints::Painted;

/// The crowds of a scene that is being emitted.
pub(super) struct CrowdParts<'g> {
    crowds: &'g Crowds,
    distances: FxHashMap<usize, Handle<Function>>,
    surfaces: FxHashMap<usize, Handle<Function>>,
    pattern_distances: FxHashMap<usize, Handle<Function>>,
    pattern_surfaces: FxHashMap<usize, Handle<Function>>,
}

/// What a loop over a cell's members comes to.
struct Nearest {
    /// The point of the grid that was asked.
    at: Value,
    distance: Value,
    /// What the list says of the nearest member.
    entry: Value,
}

impl<'g> CrowdParts<'g> {
    pub(super) fn new(crowds: &'g Crowds) -> Self {
        Self {
            crowds,
            distances: FxHashMap::default(),
            surfaces: FxHashMap::default(),
            pattern_distances: FxHashMap::default(),
            pattern_surfaces: FxHashMap::default(),
        }
    }

    pub(super) fn crowd(&self, index: usize) -> &'g Crowd {
        &self.crowds.crowds[index]
    }

    fn pattern(&self, crowd: usize, place: usize) -> (usize, &'g Pattern) {
        let pattern = self.crowd(crowd).patterns[place];
        (pattern, &self.crowds.patterns[pattern])
    }
}

impl<'g> Emission<'g> {
    /// The crowd that a node of the scene is.
    pub(super) fn crowd_of(&self, id: NodeId) -> Option<usize> {
        match self.is_in_pattern {
            true => None,
            false => self.crowds.crowds.of_node(id),
        }
    }

    /// Who painted the members.
    pub(super) fn painted_crowd(&self, crowd: usize) -> Painted {
        let mut members = self.crowds.crowd(crowd).members.iter().map(|member| self.paints.painted(member.node));
        let first = members.next().unwrap_or(Painted::Nobody);
        if members.all(|painted| painted == first) { first } else { Painted::Variously }
    }

    fn crowd_distance_function(&mut self, crowd: usize) -> Handle<Function> {
        if let Some(&known) = self.crowds.distances.get(&crowd) {
            return known;
        }
        let name = self.names.next("crowd");
        let float = self.types.float;
        let mut scope = Scope::new(self, &name, float);
        let Nearest { at, distance, .. } = scope.nearest(crowd, false);
        let point = scope.builder.argument();
        let value = scope.call_named("crowd_beyond", &[point, at, distance]);
        let function = scope.finish(value);
        let handle = self.define(function, "// The distance to the nearest of many shapes.\n");
        self.crowds.distances.insert(crowd, handle);
        handle
    }

    fn crowd_surface_function(&mut self, crowd: usize) -> Handle<Function> {
        if let Some(&known) = self.crowds.surfaces.get(&crowd) {
            return known;
        }
        let name = self.names.next("crowd_surface");
        let surface = self.surface_type;
        let mut scope = Scope::new(self, &name, surface);
        let unpainted = scope.builder.another_argument("unpainted", surface);
        let Nearest { at, entry, .. } = scope.nearest(crowd, true);
        let value = scope.look_of_entry(crowd, at, entry, unpainted);
        let function = scope.finish(value);
        let handle = self.define(function, "// The material of the nearest of many shapes.\n");
        self.crowds.surfaces.insert(crowd, handle);
        handle
    }

    fn pattern_distance(&mut self, (index, pattern): (usize, &'g Pattern)) -> Handle<Function> {
        if let Some(&known) = self.crowds.pattern_distances.get(&index) {
            return known;
        }
        let handle = self.within_pattern(pattern, |emission| {
            let name = emission.names.next("pattern");
            let (float, index) = (emission.types.float, emission.types.index);
            let mut scope = Scope::new(emission, &name, float);
            scope.row = Some(scope.builder.another_argument("row", index));
            let value = scope.distance(pattern.graph.root);
            let function = scope.finish(value);
            emission.define(function, "// The distance to a shape with these numbers.\n")
        });
        self.crowds.pattern_distances.insert(index, handle);
        handle
    }

    fn pattern_surface(&mut self, (index, pattern): (usize, &'g Pattern)) -> Handle<Function> {
        if let Some(&known) = self.crowds.pattern_surfaces.get(&index) {
            return known;
        }
        let handle = self.within_pattern(pattern, |emission| {
            let name = emission.names.next("pattern_surface");
            let (surface, index) = (emission.surface_type, emission.types.index);
            let mut scope = Scope::new(emission, &name, surface);
            scope.row = Some(scope.builder.another_argument("row", index));
            let unpainted = scope.builder.another_argument("unpainted", surface);
            let unpainted = Look::of_surface(&mut scope.builder, unpainted);
            let value = scope.surface_over(pattern.graph.root, unpainted);
            let function = scope.finish(value);
            emission.define(function, "// The material of a shape with these numbers.\n")
        });
        self.crowds.pattern_surfaces.insert(index, handle);
        handle
    }

    /// Emits something of a pattern, whose live numbers are those of a row.
    fn within_pattern<R>(&mut self, pattern: &'g Pattern, emit: impl FnOnce(&mut Self) -> R) -> R {
        let slots = replace(&mut self.slots, slots(&pattern.graph));
        let is_in_pattern = replace(&mut self.is_in_pattern, true);
        let emitted = self.within(&pattern.graph, &NO_SERIES, emit);
        (self.slots, self.is_in_pattern) = (slots, is_in_pattern);
        emitted
    }
}

impl Scope<'_, '_> {
    /// The distance to the nearest member.
    pub(super) fn crowd_distance(&mut self, crowd: usize) -> Value {
        if let Some(&value) = self.crowd_distances.get(&crowd) {
            return value;
        }
        let function = self.emission.crowd_distance_function(crowd);
        let point = self.builder.argument();
        let value = self.builder.call(function, &[point]);
        let value = self.name(value, "nearest");
        self.crowd_distances.insert(crowd, value);
        value
    }

    /// What the nearest member looks like; one that nobody painted looks as given.
    pub(super) fn crowd_look(&mut self, crowd: usize, unpainted: Look) -> Look {
        let function = self.emission.crowd_surface_function(crowd);
        let point = self.builder.argument();
        let ty = self.emission.surface_type;
        let unpainted = unpainted.compose(&mut self.builder, ty);
        let surface = self.builder.call(function, &[point, unpainted]);
        Look::of_surface(&mut self.builder, surface)
    }

    /// A loop for each pattern over the members that the point's cell lists.
    fn nearest(&mut self, crowd: usize, wants_entry: bool) -> Nearest {
        let (index, float) = (self.emission.types.index, self.emission.types.float);
        let point = self.builder.argument();
        let grid = self.word((GRID_ROWS * crowd) as u32);
        let at = self.call_named("crowd_nearest", &[point, grid]);
        let at = self.name(at, "at");
        let list = self.call_named("crowd_list", &[at, grid]);
        let first = self.call_named("crowd_word", &[list]);
        let far = self.builder.literal(FAR);
        let place = self.variable("place", index, list);
        let entry = self.variable("entry", index, first);
        let distance = self.variable("distance", float, far);
        let nearest = self.variable("nearest", index, first);

        for pattern in 0..self.emission.crowds.crowd(crowd).patterns.len() {
            let function = self.emission.crowds.pattern(crowd, pattern);
            let function = self.emission.pattern_distance(function);
            self.builder.open();
            let asked = self.builder.load(entry);
            self.leave_unless_pattern(asked, pattern);
            let bits = self.word(PATTERN_BITS);
            let row = self.builder.binary(BinaryOperator::ShiftRight, asked, bits);
            let value = self.builder.call(function, &[at, row]);
            let so_far = self.builder.load(distance);
            if wants_entry {
                let closer = self.is_closer(value, so_far, row, nearest);
                let before = self.builder.load(nearest);
                let chosen = self.builder.select(closer, asked, before);
                self.builder.store(nearest, chosen);
            }
            let least = self.builder.math(naga::MathFunction::Min, so_far, Some(value));
            self.builder.store(distance, least);
            let one = self.word(1);
            let here = self.builder.load(place);
            let next = self.builder.binary(BinaryOperator::Add, here, one);
            self.builder.store(place, next);
            let following = self.call_named("crowd_word", &[next]);
            self.builder.store(entry, following);
            let body = self.builder.close();
            self.builder.statement(Statement::Loop { body, continuing: Block::new(), break_if: None });
        }
        Nearest { at, distance: self.builder.load(distance), entry: self.builder.load(nearest) }
    }

    /// Leaves a loop if an entry is of another pattern.
    fn leave_unless_pattern(&mut self, entry: Value, pattern: usize) {
        let pattern_of_entry = self.pattern_of(entry);
        let pattern = self.word(pattern as u32);
        let condition = self.builder.binary(BinaryOperator::NotEqual, pattern_of_entry, pattern);
        self.builder.open();
        self.builder.statement(Statement::Break);
        let accept = self.builder.close();
        self.builder.statement(Statement::If { condition, accept, reject: Block::new() });
    }

    fn pattern_of(&mut self, entry: Value) -> Value {
        let mask = self.word((1 << PATTERN_BITS) - 1);
        self.builder.binary(BinaryOperator::And, entry, mask)
    }

    /// Whether a value is less than the least so far; of equal ones, the first in the text counts.
    fn is_closer(&mut self, value: Value, so_far: Value, row: Value, nearest: Value) -> Value {
        let bits = self.word(PATTERN_BITS);
        let before = self.builder.load(nearest);
        let row_before = self.builder.binary(BinaryOperator::ShiftRight, before, bits);
        let is_less = self.builder.binary(BinaryOperator::Less, value, so_far);
        let is_equal = self.builder.binary(BinaryOperator::Equal, value, so_far);
        let is_first = self.builder.binary(BinaryOperator::Less, row, row_before);
        let breaks_tie = self.builder.binary(BinaryOperator::LogicalAnd, is_equal, is_first);
        self.builder.binary(BinaryOperator::LogicalOr, is_less, breaks_tie)
    }

    /// What the member of an entry looks like.
    fn look_of_entry(&mut self, crowd: usize, at: Value, entry: Value, unpainted: Value) -> Value {
        let bits = self.word(PATTERN_BITS);
        let row = self.builder.binary(BinaryOperator::ShiftRight, entry, bits);
        let plain = self.call_named("crowd_look", &[row, unpainted]);
        let ty = self.emission.surface_type;
        let surface = self.variable("surface", ty, plain);
        for place in 0..self.emission.crowds.crowd(crowd).patterns.len() {
            let pattern = self.emission.crowds.pattern(crowd, place);
            if !pattern.1.is_painted {
                continue;
            }
            let function = self.emission.pattern_surface(pattern);
            let own = self.pattern_of(entry);
            let place = self.word(place as u32);
            let condition = self.builder.binary(BinaryOperator::Equal, own, place);
            self.builder.open();
            let look = self.builder.call(function, &[at, row, unpainted]);
            self.builder.store(surface, look);
            let accept = self.builder.close();
            self.builder.statement(Statement::If { condition, accept, reject: Block::new() });
        }
        self.builder.load(surface)
    }

    /// A variable that starts as a value.
    fn variable(&mut self, prefix: &'static str, ty: Handle<naga::Type>, value: Value) -> Value {
        let name = self.emission.names.next(prefix);
        let variable = self.builder.variable(name, ty, None);
        self.builder.store(variable, value);
        variable
    }

    fn word(&mut self, value: u32) -> Value {
        self.builder.add(Expression::Literal(Literal::U32(value)))
    }
}
