//! Statements.

use wgsl_parse::syntax::{
    AssignmentStatement, CaseSelector, CompoundStatement, Declaration, DeclarationKind, ExpressionNode, ForStatement,
    IfStatement, LoopStatement, Statement, StatementNode, SwitchStatement,
};

use super::layout::Writer;
use super::types::Scalar;
use super::{Dialect, TranslationError};

type Done = Result<(), TranslationError>;

impl Writer<'_> {
    /// The statements of a block that ends before `end`, without its braces.
    pub(super) fn block(&mut self, block: &CompoundStatement, end: usize) -> Done {
        self.typing.open();
        let result = self.deeper(|writer| {
            for (index, statement) in block.statements.iter().enumerate() {
                let next = block.statements.get(index + 1).map_or(end, |next| next.span().start);
                writer.statement(statement, next)?;
            }
            writer.comments_before(end);
            Ok(())
        });
        self.typing.close();
        result
    }

    /// A statement; what stands behind it starts at `next`.
    fn statement(&mut self, node: &StatementNode, next: usize) -> Done {
        let span = node.span();
        if matches!(node.node(), Statement::Void) {
            return Ok(());
        }
        self.blank_line_before(span.start);
        self.comments_before(span.start);
        let end = span.end.min(next);
        match node.node() {
            Statement::Compound(block) => {
                self.line("{");
                self.block(block, end)?;
                self.line("}");
            }
            Statement::If(statement) => self.condition(statement, end)?,
            Statement::For(statement) => self.counted_loop(statement, end)?,
            Statement::While(statement) => {
                let condition = self.expression(&statement.condition, None)?;
                self.loop_head(&format!("while ({condition}) {{"))?;
                self.block(&statement.body, end)?;
                self.line("}");
            }
            Statement::Loop(statement) => self.endless_loop(statement, end)?,
            Statement::Switch(statement) => self.switch(statement, end)?,
            _ => {
                let text = self.simple(node)?;
                self.line(&format!("{text};"));
            }
        }
        self.comment_behind(span.end);
        Ok(())
    }

    /// A statement in one line, without the semicolon.
    fn simple(&mut self, node: &StatementNode) -> Result<String, TranslationError> {
        match node.node() {
            Statement::Declaration(declared) => self.local(declared),
            Statement::Assignment(assignment) => self.assignment(assignment),
            Statement::Increment(statement) => Ok(format!("{}++", self.expression(&statement.expression, None)?)),
            Statement::Decrement(statement) => Ok(format!("{}--", self.expression(&statement.expression, None)?)),
            Statement::Break(_) => Ok("break".to_owned()),
            Statement::Continue(_) => Ok("continue".to_owned()),
            Statement::Discard(_) if self.dialect == Dialect::Metal => Ok("discard_fragment()".to_owned()),
            Statement::Discard(_) => Ok("discard".to_owned()),
            Statement::Return(statement) => match &statement.expression {
                Some(value) => self.returned(value),
                None => Ok("return".to_owned()),
            },
            other => Err(TranslationError::unsupported(format!("the statement {other}"))),
        }
    }

    fn local(&mut self, declared: &Declaration) -> Result<String, TranslationError> {
        let name = declared.ident.name().clone();
        let ty = match (&declared.ty, &declared.initializer) {
            (Some(ty), _) => self.typing.written(ty)?,
            (None, Some(value)) => self.typing.of(value)?.concrete(),
            (None, None) => return Err(TranslationError::unsupported("a variable without a type")),
        };
        if let Some(own) = self.taken_apart(&ty) {
            return self.local_members(&name, &own, declared.initializer.as_ref());
        }
        let value = match &declared.initializer {
            Some(value) => self.expression(value, ty.scalar())?,
            None => self.zero(&ty)?,
        };
        let own = self.declare(&name, ty.clone());
        let declarator = self.declarator(&ty, &own);
        let constant = if declared.kind == DeclarationKind::Const { "const " } else { "" };
        Ok(format!("{constant}{declarator} = {value}"))
    }

    fn assignment(&mut self, assignment: &AssignmentStatement) -> Result<String, TranslationError> {
        let ty = self.typing.of(&assignment.lhs)?;
        if let Some(own) = self.taken_apart(&ty) {
            return self.members_assigned(&assignment.lhs, &own, &assignment.rhs);
        }
        let wanted = ty.scalar();
        let left = self.expression(&assignment.lhs, None)?;
        let right = self.expression(&assignment.rhs, wanted)?;
        Ok(format!("{left} {} {right}", assignment.operator))
    }

    fn condition(&mut self, statement: &IfStatement, end: usize) -> Done {
        let condition = self.expression(&statement.if_clause.expression, None)?;
        self.line(&format!("if ({condition}) {{"));
        self.block(&statement.if_clause.body, self.start_of(&statement.else_if_clauses, end))?;
        for (index, clause) in statement.else_if_clauses.iter().enumerate() {
            let condition = self.expression(&clause.expression, None)?;
            self.refuse_hoisted()?;
            self.line(&format!("}} else if ({condition}) {{"));
            let next = self.start_of(&statement.else_if_clauses[index + 1..], end);
            self.block(&clause.body, next)?;
        }
        if let Some(clause) = &statement.else_clause {
            self.line("} else {");
            self.block(&clause.body, end)?;
        }
        self.line("}");
        Ok(())
    }

    /// Where the first of these clauses starts, or the end if there is none: comments before it belong to what is before.
    fn start_of(&self, clauses: &[wgsl_parse::syntax::ElseIfClause], end: usize) -> usize {
        clauses.first().map_or(end, |clause| clause.expression.span().start)
    }

    fn counted_loop(&mut self, statement: &ForStatement, end: usize) -> Done {
        self.typing.open();
        let part = |node: &Option<StatementNode>, writer: &mut Self| match node {
            Some(node) => writer.simple(node),
            None => Ok(String::new()),
        };
        let start = part(&statement.initializer, self)?;
        let condition = match &statement.condition {
            Some(condition) => self.expression(condition, None)?,
            None => String::new(),
        };
        let update = part(&statement.update, self)?;
        self.loop_head(&format!("for ({start}; {condition}; {update}) {{"))?;
        self.block(&statement.body, end)?;
        self.line("}");
        self.typing.close();
        Ok(())
    }

    /// A `loop`: where it breaks first and its continuing part is one assignment, a `for`.
    fn endless_loop(&mut self, statement: &LoopStatement, end: usize) -> Done {
        let update = match &statement.continuing {
            None => String::new(),
            Some(continuing) if continuing.break_if.is_none() => match &continuing.body.statements[..] {
                [] => String::new(),
                [only] => self.simple(only)?,
                _ => return Err(TranslationError::unsupported("a loop that continues with several statements")),
            },
            Some(_) => return Err(TranslationError::unsupported("a loop that ends after its body")),
        };
        let (condition, rest) = match statement.body.statements.split_first() {
            Some((first, rest)) => match going_on(first) {
                Some(condition) => (condition, rest),
                None => (None, &statement.body.statements[..]),
            },
            None => (None, &[][..]),
        };
        let condition = match condition {
            Some((negated, condition)) => {
                let text = self.expression(condition, None)?;
                if negated { text } else { format!("!({text})") }
            }
            None => String::new(),
        };
        match self.dialect.is_godot() {
            // Its loops with `for` have to declare a variable.
            true if !update.is_empty() => return Err(TranslationError::unsupported("a loop without a variable")),
            true if condition.is_empty() => self.loop_head("while (true) {")?,
            true => self.loop_head(&format!("while ({condition}) {{"))?,
            false => self.loop_head(&format!("for (; {condition}; {update}) {{"))?,
        }
        let body = CompoundStatement { attributes: Vec::new(), statements: rest.to_vec() };
        self.block(&body, end)?;
        self.line("}");
        Ok(())
    }

    fn switch(&mut self, statement: &SwitchStatement, end: usize) -> Done {
        let selector = self.expression(&statement.expression, None)?;
        let wanted = self.typing.of(&statement.expression)?.scalar().map(Scalar::concrete);
        self.line(&format!("switch ({selector}) {{"));
        for clause in &statement.clauses {
            for case in &clause.case_selectors {
                let label = match case {
                    CaseSelector::Default => "default:".to_owned(),
                    CaseSelector::Expression(value) => format!("case {}:", self.expression(value, wanted)?),
                };
                self.line(&label);
            }
            self.unbroken();
            self.append(" {");
            let last = clause.body.statements.last();
            let stop = last.map_or(end, |last| last.span().end);
            self.block(&clause.body, stop)?;
            if !last.is_some_and(|last| matches!(last.node(), Statement::Return(_) | Statement::Continue(_))) {
                self.line("    break;");
            }
            self.line("}");
        }
        self.line("}");
        Ok(())
    }

    /// HLSL's compilers unroll loops unless they are told not to.
    fn loop_head(&mut self, head: &str) -> Done {
        self.refuse_hoisted()?;
        if self.dialect == Dialect::Hlsl {
            self.line("[loop]");
        }
        self.line(head);
        Ok(())
    }

    fn returned(&mut self, value: &ExpressionNode) -> Result<String, TranslationError> {
        let result = self.returns.clone();
        if let Some(own) = self.taken_apart(&result) {
            return self.members_returned(&own, value);
        }
        Ok(format!("return {}", self.expression(value, result.scalar())?))
    }
}

/// What has to be true for a loop to go on, if this statement is what ends it: `if condition { break; }`, or with the
/// `break` in an otherwise empty `else`. And whether the condition says so itself.
fn going_on(node: &StatementNode) -> Option<Option<(bool, &ExpressionNode)>> {
    let Statement::If(statement) = node.node() else { return None };
    if !statement.else_if_clauses.is_empty() {
        return None;
    }
    let breaks = |block: &CompoundStatement| matches!(&block.statements[..], [only] if matches!(only.node(), Statement::Break(_)));
    let condition = &statement.if_clause.expression;
    match &statement.else_clause {
        None if breaks(&statement.if_clause.body) => Some(Some((false, condition))),
        Some(clause) if breaks(&clause.body) && statement.if_clause.body.statements.is_empty() => {
            Some(Some((true, condition)))
        }
        _ => None,
    }
}
