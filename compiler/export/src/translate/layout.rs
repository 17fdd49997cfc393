//! A text's declarations, with its comments and blank lines where they were.

use rustc_hash::FxHashSet;
use wgsl_parse::syntax::{
    Declaration, DeclarationKind, Function, GlobalDeclaration, GlobalDeclarationNode, Struct, TranslationUnit,
};

use super::comments::{Comment, comments, follows_blank_line};
use super::reach::{PARAMETERS, readers};
use super::types::Type;
use super::typing::Typing;
use super::{Dialect, Parameters, TranslationError};

/// The struct of live parameters, which targets declare as they need it.
const PARAMETERS_STRUCT: &str = "Parameters";

/// What writes one text.
pub(super) struct Writer<'a> {
    pub(super) wgsl: &'a str,
    pub(super) dialect: Dialect,
    pub(super) parameters: Parameters<'a>,
    pub(super) typing: Typing,
    /// The functions that read live parameters.
    pub(super) readers: FxHashSet<String>,
    /// The widths of vectors that HLSL needs `pick` for.
    pub(super) needs_pick: FxHashSet<usize>,
    comments: Vec<Comment>,
    /// The first comment that isn't written yet.
    next_comment: usize,
    text: String,
    depth: usize,
    /// What the function being written returns.
    pub(super) returns: Type,
    /// Lines that have to stand before the next one.
    pub(super) hoisted: Vec<String>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(
        wgsl: &'a str,
        unit: &TranslationUnit,
        dialect: Dialect,
        parameters: Parameters<'a>,
    ) -> Result<Self, TranslationError> {
        Ok(Self {
            wgsl,
            dialect,
            parameters,
            typing: Typing::new(unit)?,
            readers: readers(wgsl, unit),
            needs_pick: FxHashSet::default(),
            comments: comments(wgsl),
            next_comment: 0,
            text: String::new(),
            depth: 0,
            returns: Type::Nothing,
            hoisted: Vec::new(),
        })
    }

    /// The whole text.
    pub(super) fn write(mut self, unit: &TranslationUnit) -> Result<String, TranslationError> {
        // HLSL, Metal and GLSL want callees before callers; so do we, but for templates, which read from the top down.
        for declaration in in_order_of_use(self.wgsl, unit) {
            self.declaration(declaration)?;
        }
        let picks: String = (2..=4).filter(|width| self.needs_pick.contains(width)).map(pick).collect();
        Ok(picks + self.text.trim_start_matches('\n'))
    }

    fn declaration(&mut self, node: &GlobalDeclarationNode) -> Result<(), TranslationError> {
        let span = node.span();
        match node.node() {
            GlobalDeclaration::Declaration(declared) => match declared.kind {
                DeclarationKind::Const | DeclarationKind::Var(_) if declared.initializer.is_some() => {
                    self.comments_of(span.start);
                    self.constant(declared)?;
                }
                _ => self.skip_comments(span.end),
            },
            GlobalDeclaration::Struct(declared) if *declared.ident.name() == PARAMETERS_STRUCT => {
                self.skip_comments(span.end);
            }
            GlobalDeclaration::Struct(declared) if !self.dialect.has_structs() => {
                let members = self.typing.members(&declared.ident.name()).unwrap_or_default();
                if members.iter().any(|(_, ty)| ty.scalar().is_none()) {
                    return Err(TranslationError::unsupported("a struct of other structs or arrays"));
                }
                self.skip_comments(span.end);
            }
            GlobalDeclaration::Struct(declared) => {
                self.comments_of(span.start);
                self.structure(declared, span.end)?;
            }
            GlobalDeclaration::Function(function) => {
                self.comments_of(span.start);
                self.function(function, span.end)?;
            }
            GlobalDeclaration::Void => {}
            GlobalDeclaration::TypeAlias(_) => return Err(TranslationError::unsupported("a type alias")),
            GlobalDeclaration::ConstAssert(_) => return Err(TranslationError::unsupported("an assertion")),
        }
        Ok(())
    }

    fn constant(&mut self, declared: &Declaration) -> Result<(), TranslationError> {
        let Some(value) = &declared.initializer else { return Ok(()) };
        let name = declared.ident.name().clone();
        let ty = match &declared.ty {
            Some(ty) => self.typing.written(ty)?,
            None => self.typing.of(value)?.concrete(),
        };
        let value = self.expression(value, ty.scalar())?;
        let declarator = self.declarator(&ty, &self.name(&name));
        match &ty {
            Type::Array(element, _) if !self.dialect.has_constant_arrays() => {
                // A function that answers what is at an index.
                let head = format!("{} {}(int i)", self.dialect.type_name(element), self.name(&name));
                let rows = declarator.replacen(&self.name(&name), "rows", 1);
                self.line(&format!("{head} {{\n    const {rows} = {value};\n    return rows[i];\n}}"));
            }
            _ => self.line(&format!("{} {declarator} = {value};", self.dialect.constant())),
        }
        Ok(())
    }

    fn structure(&mut self, declared: &Struct, end: usize) -> Result<(), TranslationError> {
        let name = declared.ident.name().clone();
        self.line(&format!("struct {name} {{"));
        self.depth += 1;
        for member in &declared.members {
            self.comments_before(member.span().start);
            let ty = self.typing.written(&member.ty)?;
            let declarator = self.declarator(&ty, &self.name(&member.ident.name()));
            self.line(&format!("{declarator};"));
            self.comment_behind(member.span().end);
        }
        self.comments_before(end);
        self.depth -= 1;
        self.line("};");
        if self.dialect == Dialect::Hlsl {
            let members = self.typing.members(&name).unwrap_or_default().to_vec();
            self.hlsl_constructor(&name, &members);
        }
        Ok(())
    }

    /// HLSL has no constructors of structs.
    fn hlsl_constructor(&mut self, name: &str, members: &[(String, Type)]) {
        let parameter = |(member, ty): &(String, Type)| format!("{} {}", self.dialect.type_name(ty), self.name(member));
        let parameters: Vec<String> = members.iter().map(parameter).collect();
        self.line("");
        self.line(&format!("{name} new_{name}({}) {{", parameters.join(", ")));
        self.line(&format!("    {name} made;"));
        for (member, _) in members {
            let member = self.name(member);
            self.line(&format!("    made.{member} = {member};"));
        }
        self.line("    return made;");
        self.line("}");
    }

    fn function(&mut self, function: &Function, end: usize) -> Result<(), TranslationError> {
        let name = function.ident.name().clone();
        self.typing.open();
        let mut parameters = Vec::with_capacity(function.parameters.len() + 1);
        if matches!(self.parameters, Parameters::Passed) && self.readers.contains(&name) {
            parameters.push(format!("constant {PARAMETERS_STRUCT}& {PARAMETERS}"));
        }
        for parameter in &function.parameters {
            let ty = self.typing.written(&parameter.ty)?;
            let name = parameter.ident.name().clone();
            match self.taken_apart(&ty) {
                Some(own) => {
                    self.declare(&name, ty);
                    parameters.extend(self.members_of(&name, &own).iter().map(|(ty, name)| self.declarator(ty, name)));
                }
                None => {
                    let own = self.declare(&name, ty.clone());
                    parameters.push(self.declarator(&ty, &own));
                }
            }
        }
        let result = match &function.return_type {
            Some(ty) => self.typing.written(ty)?,
            None => Type::Nothing,
        };
        let result_name = match self.taken_apart(&result) {
            Some(own) => {
                let made = self.results(&own);
                parameters.extend(made.iter().map(|(ty, name)| format!("out {}", self.declarator(ty, name))));
                "void".to_owned()
            }
            None => self.dialect.type_name(&result),
        };
        self.line(&format!("{result_name} {}({}) {{", self.name(&name), parameters.join(", ")));
        self.returns = result;
        self.block(&function.body, end)?;
        self.line("}");
        self.typing.close();
        Ok(())
    }

    /// A type and a name of the written text, as declarations have them.
    pub(super) fn declarator(&self, ty: &Type, name: &str) -> String {
        let type_name = self.dialect.type_name(ty);
        match ty {
            Type::Array(_, count) => format!("{type_name} {name}[{count}]"),
            _ => format!("{type_name} {name}"),
        }
    }

    /// Declares a variable, and says what the written text calls it.
    pub(super) fn declare(&mut self, name: &str, ty: Type) -> String {
        let own = self.name(name);
        if !self.dialect.is_godot() || !self.typing.is_visible(&own) {
            self.typing.declare(name, ty);
            return own;
        }
        // Nothing that is visible may be hidden: `light_2` within what is in sight of another `light`.
        let free = (2..).map(|number| format!("{name}_{number}")).find(|free| !self.typing.is_visible(free));
        let own = free.unwrap_or(own);
        self.typing.declare_as(name, ty, Some(own.clone()));
        own
    }

    /// What the written text calls a variable.
    pub(super) fn variable(&self, name: &str) -> String {
        self.typing.alias(name).map_or_else(|| self.name(name), str::to_owned)
    }

    /// A name of the text, which may be a word of the language.
    pub(super) fn name(&self, name: &str) -> String {
        if self.dialect.reserves(name) { format!("{name}_") } else { name.to_owned() }
    }

    /// Indented lines one deeper.
    pub(super) fn deeper(
        &mut self,
        write: impl FnOnce(&mut Self) -> Result<(), TranslationError>,
    ) -> Result<(), TranslationError> {
        self.depth += 1;
        let result = write(self);
        self.depth -= 1;
        result
    }

    /// Writes a line, or the lines of a text.
    pub(super) fn line(&mut self, text: &str) {
        for hoisted in std::mem::take(&mut self.hoisted) {
            self.line(&hoisted);
        }
        if text.is_empty() {
            self.text.push('\n');
        }
        for line in text.lines() {
            for _ in 0..self.depth {
                self.text += "    ";
            }
            self.text += line;
            self.text.push('\n');
        }
    }

    /// Goes back to the last line's end, for what is to stand behind it.
    pub(super) fn unbroken(&mut self) {
        if self.text.ends_with('\n') {
            self.text.pop();
        }
    }

    /// Adds to the last line.
    pub(super) fn append(&mut self, text: &str) {
        self.text += text;
        self.text.push('\n');
    }

    /// The comments above a declaration, parted from what is before by a blank line where they were, or it was.
    fn comments_of(&mut self, start: usize) {
        // Declarations may be written in another order than they stand in.
        self.next_comment = self.comments.partition_point(|comment| comment.start < start);
        let mut first = self.next_comment;
        let mut reach = start;
        while let Some(comment) = first.checked_sub(1).and_then(|index| self.comments.get(index)) {
            let gap = self.wgsl.get(comment.start + comment.text.len()..reach).unwrap_or_default();
            if !comment.is_alone || !gap.trim().is_empty() || gap.matches('\n').count() > 2 {
                break;
            }
            reach = comment.start;
            first -= 1;
        }
        self.next_comment = first;
        if follows_blank_line(self.wgsl, reach) {
            self.line("");
        }
        self.comments_before(start);
    }

    /// The comments that stand before a place and are not written yet.
    pub(super) fn comments_before(&mut self, place: usize) {
        while let Some(comment) = self.comments.get(self.next_comment).filter(|comment| comment.start < place) {
            let (text, after_blank) = (comment.text.clone(), comment.after_blank);
            self.next_comment += 1;
            if after_blank && !self.text.ends_with("{\n") && !self.text.ends_with("\n\n") && !self.text.is_empty() {
                self.line("");
            }
            self.line(&text);
        }
    }

    /// The comment behind what ends there, in the same line.
    pub(super) fn comment_behind(&mut self, end: usize) {
        let Some(comment) = self.comments.get(self.next_comment) else { return };
        if comment.start >= end && !self.wgsl[end..comment.start].contains('\n') {
            let text = format!(" {}", comment.text);
            self.next_comment += 1;
            self.unbroken();
            self.append(&text);
        }
    }

    fn skip_comments(&mut self, end: usize) {
        self.next_comment = self.comments.partition_point(|comment| comment.start < end);
    }

    /// Whether a blank line should part a statement from what is before.
    pub(super) fn blank_line_before(&mut self, start: usize) {
        let first = self.comments.get(self.next_comment).filter(|comment| comment.start < start);
        let place = first.map_or(start, |comment| comment.start);
        if follows_blank_line(self.wgsl, place) && !self.text.ends_with("{\n") && !self.text.ends_with("\n\n") {
            self.line("");
        }
    }
}

/// The declarations such that everything stands before what uses it; otherwise as they stand.
fn in_order_of_use<'u>(wgsl: &str, unit: &'u TranslationUnit) -> Vec<&'u GlobalDeclarationNode> {
    let name_of = |node: &GlobalDeclarationNode| match node.node() {
        GlobalDeclaration::Declaration(declared) => Some(declared.ident.name().clone()),
        GlobalDeclaration::Struct(declared) => Some(declared.ident.name().clone()),
        GlobalDeclaration::Function(declared) => Some(declared.ident.name().clone()),
        _ => None,
    };
    let names: Vec<Option<String>> = unit.global_declarations.iter().map(name_of).collect();
    let place_of: rustc_hash::FxHashMap<&str, usize> =
        names.iter().enumerate().filter_map(|(place, name)| Some((name.as_deref()?, place))).collect();
    let mut ordered = Vec::with_capacity(names.len());
    let mut state = vec![false; names.len()];
    // A stack of places, each to be written once what it mentions is.
    for root in 0..names.len() {
        let mut stack = vec![(root, false)];
        while let Some((place, is_ready)) = stack.pop() {
            if is_ready {
                ordered.push(&unit.global_declarations[place]);
                continue;
            }
            if std::mem::replace(&mut state[place], true) {
                continue;
            }
            stack.push((place, true));
            let text = &wgsl[unit.global_declarations[place].span().range()];
            // A member or a variable may have the name of a function: only calls count.
            let is_function =
                |place: usize| matches!(unit.global_declarations[place].node(), GlobalDeclaration::Function(_));
            let mention = |(word, is_called): (&str, bool)| {
                let place = *place_of.get(word)?;
                (!state[place] && (is_called || !is_function(place))).then_some(place)
            };
            let mentioned = super::reach::words(text).filter_map(mention);
            let mut mentioned: Vec<usize> = mentioned.collect();
            mentioned.sort_unstable();
            mentioned.dedup();
            stack.extend(mentioned.into_iter().rev().map(|place| (place, false)));
        }
    }
    ordered
}

/// HLSL's choice between the components of vectors.
fn pick(width: usize) -> String {
    let components = ["x", "y", "z", "w"][..width].iter();
    let chosen: Vec<String> = components.map(|c| format!("which.{c} ? yes.{c} : no.{c}")).collect();
    format!(
        "float{width} pick(float{width} no, float{width} yes, bool{width} which) {{\n    return float{width}({});\n}}\n\n",
        chosen.join(", ")
    )
}
