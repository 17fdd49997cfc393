//! Printing statements.

use super::Printer;
use crate::tree::{Assignment, Instance, ModuleDefinition, Statement};

impl Printer {
    pub(super) fn file(&mut self, statements: &[Statement]) {
        let is_parameter =
            |statement: &Statement| matches!(statement, Statement::Assignment(a) if a.customizer.is_some());
        let parameters_end = statements.iter().rposition(is_parameter).unwrap_or(0);
        for (index, statement) in statements.iter().enumerate() {
            if index > 0 && is_module(statement) {
                self.blank_line();
            }
            match statement {
                Statement::Assignment(assignment) => self.top_level_assignment(assignment),
                // A brace here would hide the parameters that follow.
                Statement::Module(definition) if index < parameters_end && definition.body.len() < 2 => {
                    self.module_head(definition);
                    match definition.body.first() {
                        None => self.write(";"),
                        Some(body) => self.indented(body),
                    }
                }
                statement => self.statement(statement),
            }
            self.line_break();
            if index + 1 < statements.len() && is_module(statement) {
                self.blank_line();
            }
        }
    }

    fn top_level_assignment(&mut self, assignment: &Assignment) {
        self.comments_above(assignment);
        self.assignment(assignment);
        if let Some(customizer) = &assignment.customizer {
            self.comment_behind(customizer);
        }
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Use(path) => self.write(&format!("use <{}>", path.node)),
            Statement::Include(path) => self.write(&format!("include <{}>", path.node)),
            Statement::Assignment(assignment) => self.assignment(assignment),
            Statement::Module(definition) => {
                self.module_head(definition);
                self.write(" ");
                self.block(&definition.body);
            }
            Statement::Function(definition) => {
                self.write("function ");
                self.write(&definition.name.node);
                self.parameters(&definition.function.parameters);
                self.write(" = ");
                self.expression(&definition.function.body);
                self.write(";");
            }
            Statement::Instance(instance) => self.instance(instance),
            Statement::Block(statements) => self.block(statements),
        }
    }

    fn assignment(&mut self, assignment: &Assignment) {
        self.write(&assignment.name.node);
        self.write(" = ");
        self.expression(&assignment.value);
        self.write(";");
    }

    fn module_head(&mut self, definition: &ModuleDefinition) {
        self.write("module ");
        self.write(&definition.name.node);
        self.parameters(&definition.parameters);
    }

    fn block(&mut self, statements: &[Statement]) {
        self.brace_seen = true;
        self.write("{");
        self.indentation += 1;
        for statement in statements {
            self.line_break();
            self.statement(statement);
        }
        self.indentation -= 1;
        if !statements.is_empty() {
            self.line_break();
        }
        self.write("}");
    }

    fn instance(&mut self, instance: &Instance) {
        self.head(instance);
        let is_open = !instance.otherwise.is_empty() && instance.children.last().is_some_and(ends_in_open_if);
        self.children(&instance.children, is_open);
        if instance.otherwise.is_empty() {
            return;
        }
        if self.text.ends_with('}') {
            self.write(" ");
        } else {
            self.line_break();
        }
        self.write("else");
        match &instance.otherwise[..] {
            [Statement::Instance(otherwise)] if &*otherwise.name.node == "if" => {
                self.write(" ");
                self.instance(otherwise);
            }
            otherwise => self.children(otherwise, false),
        }
    }

    fn head(&mut self, instance: &Instance) {
        let modifiers = instance.modifiers;
        let signs =
            [(modifiers.disable, "*"), (modifiers.root, "!"), (modifiers.highlight, "#"), (modifiers.background, "%")];
        for (_, sign) in signs.into_iter().filter(|(is_set, _)| *is_set) {
            self.write(sign);
        }
        self.write(&instance.name.node);
        if matches!(&*instance.name.node, "for" | "let" | "if" | "intersection_for") {
            self.write(" ");
        }
        self.arguments(&instance.arguments);
    }

    /// Prints what an instance is applied to: one instance behind it if possible, or else a block.
    fn children(&mut self, children: &[Statement], in_braces: bool) {
        match children {
            [] => self.write(";"),
            [child @ Statement::Instance(instance)] if !in_braces => {
                let start = self.text.len();
                self.on_one_line_or(
                    |printer| {
                        printer.write(" ");
                        printer.head(instance);
                    },
                    |_| {},
                );
                let fits = self.text.len() > start;
                self.text.truncate(start);
                if fits {
                    self.write(" ");
                    self.statement(child);
                } else {
                    self.indented(child);
                }
            }
            _ => {
                self.write(" ");
                self.block(children);
            }
        }
    }

    /// Prints a statement on a line of its own.
    fn indented(&mut self, statement: &Statement) {
        self.indentation += 1;
        self.line_break();
        self.statement(statement);
        self.indentation -= 1;
    }
}

fn is_module(statement: &Statement) -> bool {
    matches!(statement, Statement::Module(_))
}

/// Whether an `else` behind a statement would become part of it.
fn ends_in_open_if(statement: &Statement) -> bool {
    let Statement::Instance(instance) = statement else { return false };
    if &*instance.name.node == "if" && instance.otherwise.is_empty() {
        return true;
    }
    let last = if instance.otherwise.is_empty() { &instance.children } else { &instance.otherwise };
    matches!(&last[..], [child] if ends_in_open_if(child))
}
