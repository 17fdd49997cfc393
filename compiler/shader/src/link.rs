//! Linking: a new module out of a parsed template, with only the functions that are reached.

use naga::{Block, Expression, Function, Handle, Module, Span, Statement};
use rustc_hash::FxHashMap;

use crate::template::Parsed;

/// A module in the making.
///
/// naga wants callees before their callers, so functions are copied from the template when something calls them,
/// and the template's stubs stand for functions that were defined meanwhile.
pub(crate) struct Linker {
    template: &'static Parsed,
    module: Module,
    /// Where functions of the template are in the module.
    moved: FxHashMap<Handle<Function>, Handle<Function>>,
}

impl Linker {
    /// A module with the template's types, constants and variables, and no functions yet.
    pub(crate) fn new(template: &'static Parsed) -> Self {
        let from = &template.module;
        let module = Module {
            types: from.types.clone(),
            special_types: from.special_types.clone(),
            constants: from.constants.clone(),
            overrides: from.overrides.clone(),
            global_variables: from.global_variables.clone(),
            global_expressions: from.global_expressions.clone(),
            diagnostic_filters: from.diagnostic_filters.clone(),
            diagnostic_filter_leaf: from.diagnostic_filter_leaf,
            ..Module::default()
        };
        Self { template, module, moved: FxHashMap::default() }
    }

    /// The module, for new types and variables.
    pub(crate) fn module(&mut self) -> &mut Module {
        &mut self.module
    }

    /// The function of the vocabulary or the template with this name.
    ///
    /// # Panics
    ///
    /// If there is none: the names in the vocabulary's table are those of its functions.
    pub(crate) fn function(&mut self, name: &str) -> Handle<Function> {
        match self.template.functions.get(name) {
            Some(&handle) => self.import(handle),
            None => panic!("neither the vocabulary nor the template has a function {name}"),
        }
    }

    /// Adds a function.
    pub(crate) fn define(&mut self, function: Function) -> Handle<Function> {
        self.module.functions.append(function, Span::UNDEFINED)
    }

    /// Adds a function that takes a stub's place.
    pub(crate) fn replace(&mut self, stub: &str, function: Function) -> Handle<Function> {
        let handle = self.define(function);
        if let Some(&stub) = self.template.functions.get(stub) {
            self.moved.insert(stub, handle);
        }
        handle
    }

    /// The whole module: with the template's entry points and what they call.
    pub(crate) fn finish(mut self) -> Module {
        for entry_point in &self.template.module.entry_points {
            let mut entry_point = entry_point.clone();
            self.relink(&mut entry_point.function);
            self.module.entry_points.push(entry_point);
        }
        self.module
    }

    fn import(&mut self, handle: Handle<Function>) -> Handle<Function> {
        if let Some(&moved) = self.moved.get(&handle) {
            return moved;
        }
        let mut function = self.template.module.functions[handle].clone();
        self.relink(&mut function);
        let moved = self.define(function);
        self.moved.insert(handle, moved);
        moved
    }

    /// Makes a function of the template call the module's functions.
    fn relink(&mut self, function: &mut Function) {
        for (_, expression) in function.expressions.iter_mut() {
            if let Expression::CallResult(callee) = expression {
                *callee = self.import(*callee);
            }
        }
        self.relink_block(&mut function.body);
    }

    fn relink_block(&mut self, block: &mut Block) {
        for statement in block.iter_mut() {
            match statement {
                Statement::Call { function, .. } => *function = self.import(*function),
                Statement::Block(block) => self.relink_block(block),
                Statement::If { accept, reject, .. } => {
                    self.relink_block(accept);
                    self.relink_block(reject);
                }
                Statement::Switch { cases, .. } => {
                    cases.iter_mut().for_each(|case| self.relink_block(&mut case.body));
                }
                Statement::Loop { body, continuing, .. } => {
                    self.relink_block(body);
                    self.relink_block(continuing);
                }
                _ => {}
            }
        }
    }
}
