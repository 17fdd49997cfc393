//! What a block of statements comes to before anything is evaluated: assignments in their order, definitions by
//! name, instances; included files merged.

use std::sync::Arc;

use chiaro_syntax::tree::{Assignment, Expression, FunctionLiteral, Instance, ModuleDefinition, Name, Statement};
use chiaro_syntax::{Diagnostic, FileId, Sources, Span};
use rustc_hash::{FxHashMap, FxHashSet};

use crate::load::{FileIndex, Library};

/// A block, sorted out.
#[derive(Default)]
pub(crate) struct Plan<'t> {
    /// The variables in the order of their first assignments, each with the last expression assigned.
    pub(crate) assignments: Vec<PlannedAssignment<'t>>,
    /// The functions defined; of those with one name, the last.
    pub(crate) functions: FxHashMap<&'t Name, &'t Arc<FunctionLiteral>>,
    /// The modules defined; of those with one name, the last.
    pub(crate) modules: FxHashMap<&'t Name, &'t ModuleDefinition>,
    /// The instances, without those disabled by `*`.
    pub(crate) instances: Vec<&'t Instance>,
    /// The files whose functions and modules are used; of those that define one name, the last.
    pub(crate) uses: Vec<FileIndex>,
}

/// A variable and what it stands for.
pub(crate) struct PlannedAssignment<'t> {
    /// The last assignment to it, whose value counts.
    pub(crate) last: &'t Assignment,
    /// Its place in the order of the first assignments is this one's.
    pub(crate) first: &'t Assignment,
}

impl<'t> PlannedAssignment<'t> {
    /// The expression that counts.
    pub(crate) fn value(&self) -> &'t Expression {
        &self.last.value
    }
}

/// Sorts out the statements of one block.
pub(crate) fn plan<'t>(
    library: &'t Library,
    sources: &Sources,
    statements: &'t [Statement],
    limit: usize,
    diagnostics: &mut Vec<Diagnostic>,
) -> Plan<'t> {
    let numbers = FxHashMap::default();
    let including = Vec::new();
    let plan = Plan::default();
    let said = FxHashSet::default();
    let mut planner = Planner { library, sources, plan, numbers, including, left: limit, said, diagnostics };
    planner.statements(statements);
    planner.plan
}

struct Planner<'t, 'a> {
    library: &'t Library,
    sources: &'a Sources,
    plan: Plan<'t>,
    /// Where in the plan's assignments a variable is.
    numbers: FxHashMap<&'t Name, usize>,
    /// The files whose inclusion is under way, each with the statement that includes it.
    including: Vec<(FileIndex, Span)>,
    /// How many statements may follow; files that include each other twice grow without bound else.
    left: usize,
    /// The places that something was said of: a file that is included twice says nothing twice.
    said: FxHashSet<Span>,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl<'t> Planner<'t, '_> {
    fn statements(&mut self, statements: &'t [Statement]) {
        for statement in statements {
            if self.left == 0 {
                return;
            }
            self.left -= 1;
            if self.left == 0 {
                self.diagnostics.push(self.too_many());
                return;
            }
            self.statement(statement);
        }
    }

    fn statement(&mut self, statement: &'t Statement) {
        match statement {
            Statement::Use(path) => {
                if let Some(file) = self.library.linked(path.span.file, &path.node) {
                    self.plan.uses.retain(|other| *other != file);
                    self.plan.uses.push(file);
                }
            }
            Statement::Include(path) => {
                let Some(file) = self.library.linked(path.span.file, &path.node) else { return };
                let id = self.library.files[file].id;
                let is_under_way = self.including.iter().any(|(other, _)| *other == file);
                if is_under_way || id == path.span.file || self.is_main(id) {
                    let message = format!("`{}` includes itself: it is left out here", path.node);
                    self.say(Diagnostic::warning(path.span, message));
                    return;
                }
                self.including.push((file, path.span));
                self.statements(&self.library.files[file].tree.statements);
                self.including.pop();
            }
            Statement::Assignment(assignment) => self.assignment(assignment),
            Statement::Module(module) => {
                self.plan.modules.insert(&module.name.node, module);
            }
            Statement::Function(definition) => {
                self.plan.functions.insert(&definition.name.node, &definition.function);
            }
            Statement::Instance(instance) if instance.modifiers.disable => {}
            Statement::Instance(instance) => self.plan.instances.push(instance),
            Statement::Block(block) => self.statements(block),
        }
    }

    fn assignment(&mut self, assignment: &'t Assignment) {
        let name: &'t Name = &assignment.name.node;
        let Some(at) = self.numbers.get(name) else {
            self.numbers.insert(name, self.plan.assignments.len());
            self.plan.assignments.push(PlannedAssignment { last: assignment, first: assignment });
            return;
        };
        let planned = &mut self.plan.assignments[*at];
        let previous = std::mem::replace(&mut planned.last, assignment);
        // A scene that changes the settings of a file it includes means to do so.
        if previous.span.file == assignment.span.file || self.is_main(previous.span.file) {
            let (line, _) = self.sources.get(previous.span.file).line_column(previous.span.start);
            let message = format!("`{name}` was assigned on line {line} already; the value there is never used");
            let warning = Diagnostic::warning(assignment.span, message)
                .with_related(previous.span, "this value is overwritten")
                .with_hint("variables have one value in a scope: the last one, even before it is assigned");
            self.say(warning);
        }
    }

    fn say(&mut self, diagnostic: Diagnostic) {
        if diagnostic.span.is_none_or(|span| self.said.insert(span)) {
            self.diagnostics.push(diagnostic);
        }
    }

    fn too_many(&self) -> Diagnostic {
        let place = self.including.first().map(|(_, place)| *place);
        let error =
            Diagnostic::error(place, "the scene has too many statements, counting files each time they are included");
        match self.including.last() {
            Some((_, innermost)) if Some(*innermost) != place => error.with_related(*innermost, "by way of this"),
            _ => error,
        }
    }

    fn is_main(&self, file: FileId) -> bool {
        self.library.files.first().is_some_and(|main| main.id == file)
    }
}
