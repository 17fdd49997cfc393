//! Structs taken apart, for languages without them: a variable for each member, and results as `out` parameters.

use wgsl_parse::syntax::{Expression, ExpressionNode, FunctionCall};

use super::TranslationError;
use super::layout::Writer;
use super::reach::words;
use super::types::Type;

type Text = Result<String, TranslationError>;

/// What the names of a function's results start with.
const RESULT: &str = "made";

impl Writer<'_> {
    /// The struct that a type is, if the language has none.
    pub(super) fn taken_apart(&self, ty: &Type) -> Option<String> {
        match ty {
            Type::Struct(own) if !self.dialect.has_structs() => Some(own.clone()),
            _ => None,
        }
    }

    /// The variables that a declared one is made of: types and names.
    pub(super) fn members_of(&self, variable: &str, own: &str) -> Vec<(Type, String)> {
        self.named(own, &self.variable(variable))
    }

    /// The parameters that a function's result goes to.
    pub(super) fn results(&self, own: &str) -> Vec<(Type, String)> {
        self.named(own, RESULT)
    }

    fn named(&self, own: &str, prefix: &str) -> Vec<(Type, String)> {
        let members = self.typing.members(own).unwrap_or_default();
        members.iter().map(|(member, ty)| (ty.clone(), format!("{prefix}_{member}"))).collect()
    }

    /// `s.member`.
    pub(super) fn member(&mut self, base: &ExpressionNode, own: &str, member: &str) -> Text {
        let index = self.typing.members(own).into_iter().flatten().position(|(name, _)| name == member);
        let texts = self.members(base, own)?;
        let text = index.and_then(|index| texts.into_iter().nth(index));
        text.ok_or_else(|| TranslationError::unsupported(format!("the member {member}")))
    }

    /// The values of a struct's members. What a function has to be called for stands before the line.
    pub(super) fn members(&mut self, node: &ExpressionNode, own: &str) -> Result<Vec<String>, TranslationError> {
        match node.node() {
            Expression::Parenthesized(inner) => self.members(&inner.expression, own),
            Expression::TypeOrIdentifier(name) => {
                let members = self.members_of(&name.ident.name(), own);
                Ok(members.into_iter().map(|(_, name)| name).collect())
            }
            Expression::FunctionCall(call) if self.typing.function(&call.ty.ident.name()).is_none() => {
                self.constructed_members(call, own)
            }
            Expression::FunctionCall(call) => {
                let text = self.call(call)?;
                let free = self.free_name(own);
                let members = self.named(own, &free);
                self.hoisted.push(format!("{}{};", self.declarations(&members), with_results(&text, call, &members)));
                Ok(members.into_iter().map(|(_, name)| name).collect())
            }
            _ => Err(TranslationError::unsupported("a struct that is computed so")),
        }
    }

    /// A name for a value of this struct that nothing has yet.
    fn free_name(&mut self, own: &str) -> String {
        let word = own[..1].to_ascii_lowercase() + &own[1..];
        let free = (1..).map(|number| format!("{word}_{number}")).find(|free| !self.typing.is_visible(free));
        let free = free.unwrap_or(word);
        self.typing.declare(&free, Type::Struct(own.to_owned()));
        free
    }

    fn constructed_members(&mut self, call: &FunctionCall, own: &str) -> Result<Vec<String>, TranslationError> {
        if call.arguments.is_empty() {
            return self.zeros(own);
        }
        let members = self.typing.members(own).unwrap_or_default().to_vec();
        members.iter().zip(&call.arguments).map(|((_, ty), value)| self.expression(value, ty.scalar())).collect()
    }

    fn zeros(&self, own: &str) -> Result<Vec<String>, TranslationError> {
        self.typing.members(own).into_iter().flatten().map(|(_, ty)| self.zero(ty)).collect()
    }

    /// The declarations of variables without values, a line each.
    fn declarations(&self, members: &[(Type, String)]) -> String {
        members.iter().map(|(ty, name)| format!("{};\n", self.declarator(ty, name))).collect()
    }

    /// A variable's declaration.
    pub(super) fn local_members(&mut self, name: &str, own: &str, value: Option<&ExpressionNode>) -> Text {
        let ty = Type::Struct(own.to_owned());
        // The value comes first: it may mention what the variable hides.
        if let Some(call) = value.and_then(|value| self.filling(value)) {
            let text = self.call(call)?;
            self.declare(name, ty);
            let members = self.members_of(name, own);
            return Ok(self.declarations(&members) + &with_results(&text, call, &members));
        }
        let values = match value {
            Some(value) => self.members(value, own)?,
            None => self.zeros(own)?,
        };
        self.declare(name, ty);
        let members = self.members_of(name, own);
        let line = |((ty, name), value): (&(Type, String), &String)| format!("{} = {value}", self.declarator(ty, name));
        Ok(members.iter().zip(&values).map(line).collect::<Vec<_>>().join(";\n"))
    }

    /// An assignment to a variable.
    pub(super) fn members_assigned(&mut self, left: &ExpressionNode, own: &str, value: &ExpressionNode) -> Text {
        let Expression::TypeOrIdentifier(variable) = left.node() else {
            return Err(TranslationError::unsupported("an assignment to a part of a struct"));
        };
        let members = self.members_of(&variable.ident.name(), own);
        self.assigned(&members, own, value)
    }

    /// The end of a function.
    pub(super) fn members_returned(&mut self, own: &str, value: &ExpressionNode) -> Text {
        let members = self.results(own);
        Ok(self.assigned(&members, own, value)? + ";\nreturn")
    }

    fn assigned(&mut self, members: &[(Type, String)], own: &str, value: &ExpressionNode) -> Text {
        if let Some(call) = self.filling(value) {
            return Ok(with_results(&self.call(call)?, call, members));
        }
        let mut values = self.members(value, own)?;
        // What one assignment overwrites, those that follow must not read.
        for index in 1..values.len() {
            let is_overwritten = |word: &str| members[..index].iter().any(|(_, name)| name == word);
            if words(&values[index]).any(|(word, _)| is_overwritten(word)) {
                let (ty, name) = &members[index];
                let before = format!("next_{name}");
                self.hoisted.push(format!("{} = {};", self.declarator(ty, &before), values[index]));
                values[index] = before;
            }
        }
        let line = |((_, name), value): (&(Type, String), &String)| format!("{name} = {value}");
        Ok(members.iter().zip(&values).map(line).collect::<Vec<_>>().join(";\n"))
    }

    /// The call of a function of the text that an expression is.
    fn filling<'n>(&self, node: &'n ExpressionNode) -> Option<&'n FunctionCall> {
        match node.node() {
            Expression::FunctionCall(call) => self.typing.function(&call.ty.ident.name()).map(|_| call),
            _ => None,
        }
    }

    /// An error if something has to be computed before what is about to be written, where there is no place for it.
    pub(super) fn refuse_hoisted(&self) -> Result<(), TranslationError> {
        match self.hoisted.is_empty() {
            true => Ok(()),
            false => Err(TranslationError::unsupported("a condition that makes a struct")),
        }
    }
}

/// A call with the variables that its result goes to.
fn with_results(text: &str, call: &FunctionCall, members: &[(Type, String)]) -> String {
    let names: Vec<&str> = members.iter().map(|(_, name)| name.as_str()).collect();
    let separator = if call.arguments.is_empty() { "" } else { ", " };
    format!("{}{separator}{})", text.strip_suffix(')').unwrap_or(text), names.join(", "))
}
