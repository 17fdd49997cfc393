//! Expressions.

use wgsl_parse::syntax::{
    BinaryExpression, BinaryOperator, Expression, ExpressionNode, FunctionCall, IndexingExpression, LiteralExpression,
    UnaryExpression, UnaryOperator,
};

use super::layout::Writer;
use super::reach::PARAMETERS;
use super::types::{Scalar, Type};
use super::typing::common;
use super::{Dialect, Parameters, TranslationError};

type Text = Result<String, TranslationError>;

impl Writer<'_> {
    /// The text of an expression, whose literals are of a kind that what is around wants.
    pub(super) fn expression(&mut self, node: &ExpressionNode, wanted: Option<Scalar>) -> Text {
        match node.node() {
            Expression::Literal(literal) => Ok(self.literal(node, literal, wanted)),
            Expression::Parenthesized(inner) => Ok(format!("({})", self.expression(&inner.expression, wanted)?)),
            Expression::NamedComponent(access) => {
                if let Expression::TypeOrIdentifier(base) = access.base.node()
                    && *base.ident.name() == PARAMETERS
                {
                    return Ok(self.parameter(&access.component.name()));
                }
                if let Some(own) = self.taken_apart(&self.typing.of(&access.base)?) {
                    return self.member(&access.base, &own, &access.component.name());
                }
                let base = self.expression(&access.base, None)?;
                Ok(format!("{base}.{}", self.name(&access.component.name())))
            }
            Expression::Indexing(indexing) => self.element(indexing),
            Expression::Unary(unary) => self.unary(unary, wanted),
            Expression::Binary(binary) => self.binary(binary, wanted),
            Expression::FunctionCall(call) => self.call(call),
            Expression::TypeOrIdentifier(name) => Ok(self.variable(&name.ident.name())),
        }
    }

    fn element(&mut self, indexing: &IndexingExpression) -> Text {
        let base = self.expression(&indexing.base, None)?;
        let index = self.expression(&indexing.index, Some(Scalar::I32))?;
        let is_constant = matches!(indexing.base.node(), Expression::TypeOrIdentifier(name) if self.typing.is_global(&name.ident.name()));
        if is_constant && !self.dialect.has_constant_arrays() {
            let is_signed = self.typing.of(&indexing.index)?.scalar().map(Scalar::concrete) == Some(Scalar::I32);
            return Ok(if is_signed { format!("{base}({index})") } else { format!("{base}(int({index}))") });
        }
        Ok(format!("{base}[{index}]"))
    }

    fn parameter(&self, name: &str) -> String {
        match self.parameters {
            Parameters::Variables(variable) => variable(name),
            Parameters::Passed => format!("{PARAMETERS}.{name}"),
        }
    }

    /// A literal as it is written there, but for what marks its type.
    fn literal(&self, node: &ExpressionNode, literal: &LiteralExpression, wanted: Option<Scalar>) -> String {
        let written = &self.wgsl[node.span().range()];
        match literal {
            LiteralExpression::Bool(value) => value.to_string(),
            LiteralExpression::U32(_) => self.unsigned(written.trim_end_matches('u')),
            LiteralExpression::I32(_) => written.trim_end_matches('i').to_owned(),
            LiteralExpression::AbstractInt(_) => match wanted {
                Some(Scalar::F32 | Scalar::AbstractFloat) => format!("{written}.0"),
                Some(Scalar::U32) => self.unsigned(written),
                _ => written.to_owned(),
            },
            LiteralExpression::AbstractFloat(_) | LiteralExpression::F32(_) | LiteralExpression::F16(_) => {
                let digits = written.trim_end_matches(['f', 'h']);
                if digits.contains(['.', 'e', 'E']) { digits.to_owned() } else { format!("{digits}.0") }
            }
        }
    }

    fn unsigned(&self, digits: &str) -> String {
        if self.dialect == Dialect::Godot3 { format!("uint({digits})") } else { format!("{digits}u") }
    }

    fn unary(&mut self, unary: &UnaryExpression, wanted: Option<Scalar>) -> Text {
        // Godot 3 leaves out parentheses and spaces when it writes GLSL: two signs would be a decrement.
        if self.dialect == Dialect::Godot3
            && unary.operator == UnaryOperator::Negation
            && let Some(inner) = negation(&unary.operand)
        {
            return self.expression(&inner.operand, wanted);
        }
        let is_vector = self.typing.of(&unary.operand)?.is_vector();
        let operand = self.expression(&unary.operand, wanted)?;
        Ok(match unary.operator {
            UnaryOperator::LogicalNegation if self.dialect.is_glsl() && is_vector => format!("not({operand})"),
            UnaryOperator::LogicalNegation => format!("!{operand}"),
            UnaryOperator::BitwiseComplement => format!("~{operand}"),
            UnaryOperator::Negation if operand.starts_with('-') => format!("-({operand})"),
            UnaryOperator::Negation => format!("-{operand}"),
            other => return Err(TranslationError::unsupported(format!("the operator {other}"))),
        })
    }

    fn binary(&mut self, binary: &BinaryExpression, wanted: Option<Scalar>) -> Text {
        let (left_type, right_type) = (self.typing.of(&binary.left)?, self.typing.of(&binary.right)?);
        let both = match (left_type.scalar(), right_type.scalar()) {
            (Some(left), Some(right)) => {
                let both = common(left, right);
                if both.is_abstract() { wanted.or(Some(both)) } else { Some(both) }
            }
            _ => wanted,
        };
        let left = self.expression(&binary.left, both)?;
        if binary.operator == BinaryOperator::Subtraction
            && let Some(negation) = negation(&binary.right)
            && self.dialect == Dialect::Godot3
        {
            return Ok(format!("{left} + {}", self.expression(&negation.operand, both)?));
        }
        let right = self.expression(&binary.right, both)?;
        let is_vector = left_type.is_vector() || right_type.is_vector();
        let is_bool = left_type.scalar() == Some(Scalar::Bool);
        use BinaryOperator as B;
        if let Some(function) = glsl_comparison(binary.operator).filter(|_| is_vector && self.dialect.is_glsl()) {
            return Ok(format!("{function}({left}, {right})"));
        }
        if binary.operator == B::Multiplication && self.dialect == Dialect::Hlsl {
            // HLSL's constructors take rows, so its matrices are our ones transposed.
            if left_type.is_matrix() && !is_scalar(&right_type) || right_type.is_matrix() && !is_scalar(&left_type) {
                return Ok(format!("mul({right}, {left})"));
            }
        }
        let operator = match binary.operator {
            B::BitwiseAnd | B::BitwiseOr if is_bool && is_vector => {
                return Err(TranslationError::unsupported("a Boolean operation on vectors"));
            }
            B::BitwiseAnd if is_bool => "&&".to_owned(),
            B::BitwiseOr if is_bool => "||".to_owned(),
            B::Remainder if both == Some(Scalar::F32) && self.dialect != Dialect::Hlsl => {
                return match self.dialect {
                    Dialect::Metal => Ok(format!("fmod({left}, {right})")),
                    // GLSL's mod goes down where WGSL's % goes towards zero.
                    _ => Ok(format!("(({left}) - ({right}) * trunc(({left}) / ({right})))")),
                };
            }
            operator => operator.to_string(),
        };
        Ok(format!("{left} {operator} {right}"))
    }

    pub(super) fn call(&mut self, call: &FunctionCall) -> Text {
        let name = call.ty.ident.name().clone();
        if let Some(signature) = self.typing.function(&name).cloned() {
            let mut arguments = Vec::with_capacity(call.arguments.len() + 1);
            if matches!(self.parameters, Parameters::Passed) && self.readers.contains(&name) {
                arguments.push(PARAMETERS.to_owned());
            }
            for (argument, ty) in call.arguments.iter().zip(&signature.parameters) {
                match self.taken_apart(ty) {
                    Some(own) => arguments.extend(self.members(argument, &own)?),
                    None => arguments.push(self.expression(argument, ty.scalar())?),
                }
            }
            return Ok(format!("{}({})", self.name(&name), arguments.join(", ")));
        }
        if let Some(ty) = self.typing.constructed(call)? {
            return self.construction(&ty, &call.arguments);
        }
        let types: Result<Vec<Type>, _> = call.arguments.iter().map(|argument| self.typing.of(argument)).collect();
        let types = types?;
        if name == "select" {
            return self.selection(call, &types);
        }
        let wanted = types.iter().filter_map(Type::scalar).fold(Scalar::AbstractFloat, common);
        let arguments: Result<Vec<String>, _> =
            call.arguments.iter().map(|argument| self.expression(argument, Some(wanted))).collect();
        let unknown = || TranslationError::unsupported(format!("the function {name}"));
        let function = self.dialect.builtin(&name).ok_or_else(unknown)?;
        Ok(format!("{function}({})", arguments?.join(", ")))
    }

    /// `select(no, yes, which)`.
    fn selection(&mut self, call: &FunctionCall, types: &[Type]) -> Text {
        let [no, yes, which] = &call.arguments[..] else {
            return Err(TranslationError::unsupported("select without three arguments"));
        };
        let wanted = match (types[0].scalar(), types[1].scalar()) {
            (Some(no), Some(yes)) => Some(common(no, yes).concrete()),
            _ => None,
        };
        let [no, yes] = [self.expression(no, wanted)?, self.expression(yes, wanted)?];
        let which = self.expression(which, None)?;
        if !types[2].is_vector() {
            return Ok(format!("({which} ? {yes} : {no})"));
        }
        match self.dialect {
            Dialect::Glsl | Dialect::Godot4 | Dialect::Godot3 => Ok(format!("mix({no}, {yes}, {which})")),
            Dialect::Metal => Ok(format!("select({no}, {yes}, {which})")),
            Dialect::Hlsl => {
                self.needs_pick.insert(types[2].width());
                Ok(format!("pick({no}, {yes}, {which})"))
            }
        }
    }

    /// A value of a type, made from parts.
    fn construction(&mut self, ty: &Type, arguments: &[ExpressionNode]) -> Text {
        let name = self.dialect.type_name(ty);
        match ty {
            Type::Struct(own) => {
                let members: Vec<Option<Scalar>> =
                    (self.typing.members(own).into_iter().flatten()).map(|(_, member)| member.scalar()).collect();
                let texts: Result<Vec<String>, _> =
                    arguments.iter().zip(members).map(|(argument, wanted)| self.expression(argument, wanted)).collect();
                let texts = texts?.join(", ");
                match self.dialect {
                    Dialect::Metal => Ok(format!("{name}{{{texts}}}")),
                    Dialect::Hlsl => Ok(format!("new_{name}({texts})")),
                    _ => Ok(format!("{name}({texts})")),
                }
            }
            Type::Array(element, count) => {
                let texts: Result<Vec<String>, _> =
                    arguments.iter().map(|argument| self.expression(argument, element.scalar())).collect();
                let texts = texts?.join(",\n    ");
                match self.dialect {
                    Dialect::Hlsl | Dialect::Metal => Ok(format!("{{\n    {texts}\n}}")),
                    _ => Ok(format!("{name}[{count}](\n    {texts}\n)")),
                }
            }
            _ => {
                let texts: Result<Vec<String>, _> =
                    arguments.iter().map(|argument| self.expression(argument, ty.scalar())).collect();
                let texts = texts?;
                if self.dialect == Dialect::Hlsl
                    && let Type::Vector(size, _) = ty
                    && let ([only], [text]) = (arguments, &texts[..])
                    && is_scalar(&self.typing.of(only)?)
                {
                    // HLSL's constructors don't repeat a scalar; casts do.
                    let is_simple = text.chars().all(|c| c.is_ascii_alphanumeric() || "._".contains(c));
                    return Ok(match is_simple && text.len() <= 6 {
                        true => format!("{name}({})", vec![text.as_str(); *size].join(", ")),
                        false => format!("({name})({text})"),
                    });
                }
                match texts.is_empty() {
                    true => self.zero(ty),
                    false => Ok(format!("{name}({})", texts.join(", "))),
                }
            }
        }
    }

    /// The value that WGSL gives a variable without one.
    pub(super) fn zero(&self, ty: &Type) -> Text {
        let name = self.dialect.type_name(ty);
        let number = |scalar: Scalar| match scalar.concrete() {
            Scalar::Bool => "false",
            Scalar::I32 => "0",
            Scalar::U32 => "0u",
            _ => "0.0",
        };
        match ty {
            Type::Scalar(scalar) => Ok(number(*scalar).to_owned()),
            Type::Vector(size, scalar) => match self.dialect {
                Dialect::Hlsl => Ok(format!("{name}({})", vec![number(*scalar); *size].join(", "))),
                _ => Ok(format!("{name}({})", number(*scalar))),
            },
            Type::Struct(own) => {
                let members: Vec<Type> =
                    self.typing.members(own).into_iter().flatten().map(|(_, member)| member.clone()).collect();
                let zeros: Result<Vec<String>, _> = members.iter().map(|member| self.zero(member)).collect();
                let zeros = zeros?.join(", ");
                Ok(match self.dialect {
                    Dialect::Metal => format!("{name}{{{zeros}}}"),
                    Dialect::Hlsl => format!("new_{name}({zeros})"),
                    _ => format!("{name}({zeros})"),
                })
            }
            other => Err(TranslationError::unsupported(format!("a variable of type {other} without a value"))),
        }
    }
}

/// What an expression is the negation of, whatever parentheses are around it.
fn negation(node: &ExpressionNode) -> Option<&UnaryExpression> {
    match node.node() {
        Expression::Parenthesized(inner) => negation(&inner.expression),
        Expression::Unary(unary) if unary.operator == UnaryOperator::Negation => Some(unary),
        _ => None,
    }
}

fn is_scalar(ty: &Type) -> bool {
    matches!(ty, Type::Scalar(_))
}

/// GLSL's function for a comparison of vectors.
fn glsl_comparison(operator: BinaryOperator) -> Option<&'static str> {
    match operator {
        BinaryOperator::Equality => Some("equal"),
        BinaryOperator::Inequality => Some("notEqual"),
        BinaryOperator::LessThan => Some("lessThan"),
        BinaryOperator::LessThanEqual => Some("lessThanEqual"),
        BinaryOperator::GreaterThan => Some("greaterThan"),
        BinaryOperator::GreaterThanEqual => Some("greaterThanEqual"),
        _ => None,
    }
}
