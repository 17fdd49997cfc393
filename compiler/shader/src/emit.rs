//! Emission: the field graph as straight-line functions, or with loops over the members of crowds.
//!
//! * Every shape and operator of the vocabulary is a call of its function; nothing of it is repeated here.
//! * A [`Scope`] is one function of the point `p`. Within it each point and node is evaluated once.
//! * A node has the same name wherever it is evaluated.
//! * Constants are literals. Live numbers are loaded from a uniform, large outlines from a storage buffer.

mod blend;
mod crowds;
mod guards;
mod numbers;
mod parts;
mod pieces;
mod points;
mod series;
mod shapes;
mod surface;

use std::borrow::Cow;
use std::mem::{replace, take};
use std::sync::LazyLock;

use chiaro_field::paints::Paints;
use chiaro_field::{AllSeries, Crowds, Graph, NodeId, PointId};
use chiaro_solid::Scalar;
use chiaro_syntax::{Diagnostic, Span};
use chiaro_vocabulary::Row;
use naga::{Function, GlobalVariable, Handle, Module, Type};
use rustc_hash::FxHashMap;

use crate::build::{Builder, Types, Value};
use crate::link::Linker;
use crate::names::Names;
use crate::tables::{Tables, TablesBuilder};
use crate::template::Parsed;

/// The most nodes of a scene that may become straight-line code, which drivers take long to compile. Members of crowds don't
/// count.
pub const MAX_NODES: usize = 20_000;

/// A scene in a module.
pub(crate) struct Emitted {
    pub(crate) module: Module,
    pub(crate) tables: Tables,
    /// The functions that stand for the graph, callees first.
    pub(crate) functions: Vec<OwnFunction>,
    /// The names of nodes' values, with the text each node came from.
    pub(crate) names: FxHashMap<String, Span>,
}

/// A function that stands for some of the graph.
pub(crate) struct OwnFunction {
    pub(crate) handle: Handle<Function>,
    /// What a reader should know of it; of `scene.wgsl`'s functions, that text knows.
    pub(crate) comment: Cow<'static, str>,
}

/// What a value that comes from an expression is to be called, if anything is known about that.
type ToldNames<'g> = &'g dyn Fn(Span) -> Option<String>;

static NO_CROWDS: Crowds = Crowds { crowds: Vec::new(), patterns: Vec::new() };
static NO_SERIES: LazyLock<AllSeries> = LazyLock::new(AllSeries::default);

/// Emits `scene_distance` and `scene_surface` in the place of a template's stubs, all of it as straight-line code.
pub(crate) fn emit(graph: &Graph, template: &'static Parsed) -> Result<Emitted, Diagnostic> {
    emit_all(graph, &NO_CROWDS, &NO_SERIES, template, &|_| None)
}

/// The same with loops over the members of these crowds; if there are any, of a template that knows of crowds.
pub(crate) fn emit_with_crowds(
    graph: &Graph,
    crowds: &Crowds,
    template: &'static Parsed,
) -> Result<Emitted, Diagnostic> {
    emit_all(graph, crowds, &NO_SERIES, template, &|_| None)
}

/// The same for people to read: with functions for these series, and values called by these names.
pub(crate) fn emit_to_read<'g>(
    graph: &'g Graph,
    series: &'g AllSeries,
    template: &'static Parsed,
    told: ToldNames<'g>,
) -> Result<Emitted, Diagnostic> {
    emit_all(graph, &NO_CROWDS, series, template, told)
}

fn emit_all<'g>(
    graph: &'g Graph,
    crowds: &'g Crowds,
    series: &'g AllSeries,
    template: &'static Parsed,
    told: ToldNames<'g>,
) -> Result<Emitted, Diagnostic> {
    check_size(graph, crowds, series)?;
    let mut emission = Emission::new(graph, crowds, series, template, told);
    emission.scene_distance();
    emission.scene_surface();
    emission.finish()
}

/// How many nodes become code.
fn emitted_nodes(graph: &Graph, crowds: &Crowds, series: &AllSeries) -> usize {
    let mut patterns: Vec<usize> = crowds.crowds.iter().flat_map(|crowd| crowd.patterns.iter().copied()).collect();
    patterns.sort_unstable();
    patterns.dedup();
    let patterns = patterns.into_iter().map(|pattern| crowds.patterns[pattern].graph.nodes.len()).sum::<usize>();
    let mut is_member = vec![false; graph.nodes.len()];
    for member in crowds.crowds.iter().flat_map(|crowd| &crowd.members) {
        is_member[member.node.0 as usize] = true;
    }
    let within = series.series.iter().map(|series| emitted_nodes(&series.pattern.graph, &NO_CROWDS, &series.within));
    let mut counts = vec![false; graph.nodes.len()];
    counts[graph.root.0 as usize] = true;
    // What refers stands behind what it refers to.
    for (index, node) in graph.nodes.iter().enumerate().rev().filter(|(index, _)| *index <= graph.root.0 as usize) {
        let children = node.children().iter().filter(|child| !is_member[child.0 as usize]);
        if counts[index] && series.of_member(NodeId(index as u32)).is_none() {
            children.for_each(|child| counts[child.0 as usize] = true);
        }
    }
    patterns + within.sum::<usize>() + counts.into_iter().filter(|counts| *counts).count()
}

fn check_size(graph: &Graph, crowds: &Crowds, series: &AllSeries) -> Result<(), Diagnostic> {
    let root = graph.spans.get(graph.root.0 as usize).copied();
    let count = emitted_nodes(graph, crowds, series);
    if count > MAX_NODES {
        let message = format!("too many shapes for one shader: {count}, of at most {MAX_NODES}");
        return Err(Diagnostic::error(root, message)
            .with_hint("fewer or larger shapes, or operators such as repeat in the place of loops, need less code"));
    }
    let (live, most) = (graph.slots.len(), numbers::MAX_LIVE);
    if live > most {
        let message = format!("too many live numbers for one shader: {live}, of at most {most}");
        return Err(Diagnostic::error(root, message).with_hint("make some of the parameters constant"));
    }
    Ok(())
}

/// What the functions of one module share.
struct Emission<'g> {
    graph: &'g Graph,
    told: ToldNames<'g>,
    linker: Linker,
    types: Types,
    names: Names,
    node_names: FxHashMap<NodeId, String>,
    /// The names of values, with the text that they come from.
    named: FxHashMap<String, Span>,
    point_names: FxHashMap<PointId, String>,
    /// Where live numbers are.
    slots: FxHashMap<&'g Scalar, usize>,
    /// The uniform of live numbers.
    live_variable: Option<Handle<GlobalVariable>>,
    parts: parts::Parts,
    paints: Paints,
    crowds: crowds::CrowdParts<'g>,
    series: series::SeriesParts<'g>,
    /// Whether the graph is that of a crowd's pattern.
    is_in_pattern: bool,
    /// Whether the graph is that of a series whose world is a plane.
    is_in_plane: bool,
    /// The type `Surface`.
    surface_type: Handle<Type>,
    tables: TablesBuilder,
    tables_variable: Option<Handle<GlobalVariable>>,
    /// The functions of outlines and polytopes.
    pieces: FxHashMap<pieces::Key, Handle<Function>>,
    /// How many pieces of outlines and polytopes have become straight-line code.
    unrolled: usize,
    /// The functions that stand for the graph.
    functions: Vec<OwnFunction>,
    /// The node being evaluated, for diagnostics.
    current: Option<Span>,
    failure: Option<Diagnostic>,
}

impl<'g> Emission<'g> {
    fn new(
        graph: &'g Graph,
        crowds: &'g Crowds,
        series: &'g AllSeries,
        template: &'static Parsed,
        told: ToldNames<'g>,
    ) -> Self {
        let stub = &template.module.functions[template.functions["scene_surface"]];
        let Some(surface) = &stub.result else { unreachable!("scene.wgsl declares the result") };
        let mut linker = Linker::new(template);
        let types = Types::of(linker.module());
        Self {
            graph,
            told,
            linker,
            types,
            names: Names::new(template.functions.keys().cloned()),
            node_names: FxHashMap::default(),
            named: FxHashMap::default(),
            point_names: FxHashMap::default(),
            slots: numbers::slots(graph),
            live_variable: None,
            parts: parts::Parts::new(graph, series),
            paints: Paints::new(graph),
            crowds: crowds::CrowdParts::new(crowds),
            series: series::SeriesParts::new(series),
            is_in_pattern: false,
            is_in_plane: false,
            surface_type: surface.ty,
            tables: TablesBuilder::default(),
            tables_variable: None,
            pieces: FxHashMap::default(),
            unrolled: 0,
            functions: Vec::new(),
            current: None,
            failure: None,
        }
    }

    fn scene_distance(&mut self) {
        let (root, float) = (self.graph.root, self.types.float);
        let mut scope = Scope::new(self, "scene_distance", float);
        let distance = scope.distance(root);
        let function = scope.finish(distance);
        self.replace("scene_distance", function);
    }

    fn scene_surface(&mut self) {
        let (root, ty) = (self.graph.root, self.surface_type);
        let mut scope = Scope::new(self, "scene_surface", ty);
        let surface = scope.surface(root);
        let function = scope.finish(surface);
        self.replace("scene_surface", function);
    }

    fn replace(&mut self, stub: &str, function: Function) {
        let handle = self.linker.replace(stub, function);
        self.functions.push(OwnFunction { handle, comment: Cow::default() });
    }

    /// Adds a function that stands for some of the graph.
    fn define(&mut self, function: Function, comment: impl Into<Cow<'static, str>>) -> Handle<Function> {
        let handle = self.linker.define(function);
        self.functions.push(OwnFunction { handle, comment: comment.into() });
        handle
    }

    /// Emits something of another graph, which has these series.
    fn within<R>(&mut self, graph: &'g Graph, series: &'g AllSeries, emit: impl FnOnce(&mut Self) -> R) -> R {
        let graph = replace(&mut self.graph, graph);
        let parts = replace(&mut self.parts, parts::Parts::new(self.graph, series));
        let paints = replace(&mut self.paints, Paints::new(self.graph));
        let series = replace(&mut self.series, series::SeriesParts::new(series));
        let node_names = take(&mut self.node_names);
        let point_names = take(&mut self.point_names);
        let emitted = emit(self);
        (self.graph, self.parts, self.paints, self.series) = (graph, parts, paints, series);
        (self.node_names, self.point_names) = (node_names, point_names);
        emitted
    }

    /// What values of a node are called, but for letters behind it.
    fn told_name(&self, node: NodeId) -> String {
        let kind = shapes::kind(self.graph, node);
        let told = self.graph.spans.get(node.0 as usize).and_then(|span| (self.told)(*span));
        told.map_or(kind.to_owned(), |own| format!("{own}_{kind}"))
    }

    fn finish(self) -> Result<Emitted, Diagnostic> {
        match self.failure {
            Some(failure) => Err(failure),
            None => {
                let names = self.named;
                let (module, tables) = (self.linker.finish(), self.tables.finish());
                Ok(Emitted { module, tables, functions: self.functions, names })
            }
        }
    }

    /// Remembers the first thing that can't be emitted; the module is thrown away then.
    fn fail(&mut self, message: &str) {
        self.failure.get_or_insert_with(|| Diagnostic::error(self.current, message));
    }
}

/// One function being emitted.
struct Scope<'e, 'g> {
    emission: &'e mut Emission<'g>,
    builder: Builder,
    points: FxHashMap<PointId, Value>,
    distances: FxHashMap<NodeId, Value>,
    joints: FxHashMap<NodeId, blend::Joined>,
    /// The distances to the nearest members of crowds.
    crowd_distances: FxHashMap<usize, Value>,
    /// Where the numbers of a pattern's member are.
    row: Option<Value>,
    /// The numbers of it, four at a time.
    row_numbers: FxHashMap<usize, Value>,
    /// The numbers that the function is told.
    told: FxHashMap<&'g Scalar, Value>,
    /// Live numbers by slot.
    live: FxHashMap<usize, Value>,
    /// How nodes look, depending on how they look where nobody painted them.
    appearances: FxHashMap<(NodeId, surface::Appearance), surface::Appearance>,
    /// The colours and finishes of materials.
    colors: FxHashMap<[Scalar; 4], Value>,
    finishes: FxHashMap<[Scalar; 4], Value>,
}

impl<'e, 'g> Scope<'e, 'g> {
    /// A function of a point of the graph's world.
    fn new(emission: &'e mut Emission<'g>, name: &str, result: Handle<Type>) -> Self {
        let point = if emission.is_in_plane { emission.types.vec2 } else { emission.types.vec3 };
        Self::of_point(emission, name, point, result)
    }

    /// A function of a point of that type.
    fn of_point(emission: &'e mut Emission<'g>, name: &str, point: Handle<Type>, result: Handle<Type>) -> Self {
        let builder = Builder::new(name, emission.types, point, result);
        Self {
            emission,
            builder,
            points: FxHashMap::default(),
            distances: FxHashMap::default(),
            joints: FxHashMap::default(),
            crowd_distances: FxHashMap::default(),
            row: None,
            row_numbers: FxHashMap::default(),
            told: FxHashMap::default(),
            live: FxHashMap::default(),
            appearances: FxHashMap::default(),
            colors: FxHashMap::default(),
            finishes: FxHashMap::default(),
        }
    }

    fn finish(self, value: Value) -> Function {
        self.builder.finish(value)
    }

    /// Calls a function of the vocabulary.
    fn call(&mut self, row: &Row, arguments: &[Value]) -> Value {
        self.call_named(row.function, arguments)
    }

    /// Calls a function of the vocabulary or of `scene.wgsl`.
    fn call_named(&mut self, function: &str, arguments: &[Value]) -> Value {
        let function = self.emission.linker.function(function);
        self.builder.call(function, arguments)
    }

    /// Names a value with the next name of this prefix.
    fn name(&mut self, value: Value, prefix: &'static str) -> Value {
        let name = self.emission.names.next(prefix);
        self.builder.name(value, name)
    }

    /// Names a node's value as everywhere.
    fn name_node(&mut self, value: Value, node: NodeId) -> Value {
        if let Some(name) = self.emission.node_names.get(&node) {
            return self.builder.name(value, name.clone());
        }
        let told = self.emission.told_name(node);
        let name = self.emission.names.next(&told);
        self.emission.node_names.insert(node, name.clone());
        if let Some(span) = self.emission.graph.spans.get(node.0 as usize) {
            self.emission.named.insert(name.clone(), *span);
        }
        self.builder.name(value, name)
    }

    /// Names a point's value as everywhere.
    fn name_point(&mut self, value: Value, point: PointId, prefix: &'static str) -> Value {
        let Emission { names, point_names, .. } = &mut *self.emission;
        let name = point_names.entry(point).or_insert_with(|| names.next(prefix)).clone();
        self.builder.name(value, name)
    }
}
