//! Which type each expression has. WGSL leaves it out where it can be inferred; other languages want to read it.

use rustc_hash::FxHashMap;
use wgsl_parse::syntax::{
    BinaryOperator, Expression, Function, FunctionCall, GlobalDeclaration, LiteralExpression, Struct, TranslationUnit,
    TypeExpression, UnaryOperator,
};

use super::TranslationError;
use super::types::{Scalar, Type};

/// What names stand for.
pub(crate) struct Typing {
    functions: FxHashMap<String, Signature>,
    structs: FxHashMap<String, Vec<(String, Type)>>,
    /// Constants and variables: those of the text, then those of each block that is open.
    scopes: Vec<FxHashMap<String, Variable>>,
}

/// A constant or a variable.
struct Variable {
    ty: Type,
    /// What the written text calls it, if not by its own name.
    alias: Option<String>,
}

/// What a function takes and returns.
#[derive(Clone)]
pub(crate) struct Signature {
    pub(crate) parameters: Vec<Type>,
    pub(crate) result: Type,
}

impl Typing {
    /// That of a text's declarations.
    pub(crate) fn new(unit: &TranslationUnit) -> Result<Self, TranslationError> {
        let mut typing =
            Self { functions: FxHashMap::default(), structs: FxHashMap::default(), scopes: vec![FxHashMap::default()] };
        // A struct may be mentioned above its declaration.
        for declaration in &unit.global_declarations {
            if let GlobalDeclaration::Struct(declared) = declaration.node() {
                typing.structs.insert(declared.ident.name().clone(), Vec::new());
            }
        }
        for declaration in &unit.global_declarations {
            match declaration.node() {
                GlobalDeclaration::Struct(declared) => typing.declare_struct(declared)?,
                GlobalDeclaration::Function(declared) => typing.declare_function(declared)?,
                _ => {}
            }
        }
        for declaration in &unit.global_declarations {
            if let GlobalDeclaration::Declaration(declared) = declaration.node() {
                let ty = match (&declared.ty, &declared.initializer) {
                    (Some(ty), _) => typing.written(ty)?,
                    (None, Some(value)) => typing.of(value)?.concrete(),
                    (None, None) => return Err(TranslationError::unsupported("a variable without a type")),
                };
                typing.declare(&declared.ident.name(), ty);
            }
        }
        Ok(typing)
    }

    fn declare_struct(&mut self, declared: &Struct) -> Result<(), TranslationError> {
        let member =
            |member: &wgsl_parse::syntax::StructMember| Ok((member.ident.name().clone(), self.written(&member.ty)?));
        let members: Result<Vec<_>, TranslationError> = declared.members.iter().map(|m| member(m.node())).collect();
        self.structs.insert(declared.ident.name().clone(), members?);
        Ok(())
    }

    fn declare_function(&mut self, declared: &Function) -> Result<(), TranslationError> {
        let parameters: Result<Vec<Type>, _> = declared.parameters.iter().map(|p| self.written(&p.ty)).collect();
        let result = declared.return_type.as_ref().map_or(Ok(Type::Nothing), |ty| self.written(ty))?;
        self.functions.insert(declared.ident.name().clone(), Signature { parameters: parameters?, result });
        Ok(())
    }

    /// Opens a block.
    pub(crate) fn open(&mut self) {
        self.scopes.push(FxHashMap::default());
    }

    /// Closes the innermost block.
    pub(crate) fn close(&mut self) {
        self.scopes.pop();
    }

    /// Declares a name in the innermost block.
    pub(crate) fn declare(&mut self, name: &str, ty: Type) {
        self.declare_as(name, ty, None);
    }

    /// The same, with another name in the written text.
    pub(crate) fn declare_as(&mut self, name: &str, ty: Type, alias: Option<String>) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.insert(name.to_owned(), Variable { ty, alias });
        }
    }

    /// The function of the text with this name.
    pub(crate) fn function(&self, name: &str) -> Option<&Signature> {
        self.functions.get(name)
    }

    /// The members of the text's struct with this name.
    pub(crate) fn members(&self, name: &str) -> Option<&[(String, Type)]> {
        self.structs.get(name).map(Vec::as_slice)
    }

    /// What the written text calls a variable, if not by its own name.
    pub(crate) fn alias(&self, name: &str) -> Option<&str> {
        self.variable(name)?.alias.as_deref()
    }

    /// Whether a name, or an alias, stands for anything here.
    pub(crate) fn is_visible(&self, name: &str) -> bool {
        let is_alias = |variable: &Variable| variable.alias.as_deref() == Some(name);
        self.variable(name).is_some()
            || self.functions.contains_key(name)
            || self.scopes.iter().any(|scope| scope.values().any(is_alias))
    }

    /// Whether a name stands for a constant of the text, not for a variable of a function.
    pub(crate) fn is_global(&self, name: &str) -> bool {
        self.scopes[1..].iter().all(|scope| !scope.contains_key(name)) && self.scopes[0].contains_key(name)
    }

    fn variable(&self, name: &str) -> Option<&Variable> {
        self.scopes.iter().rev().find_map(|scope| scope.get(name))
    }

    /// The type that is written there.
    pub(crate) fn written(&self, ty: &TypeExpression) -> Result<Type, TranslationError> {
        let name = ty.ident.name();
        let unknown = || TranslationError::unsupported(format!("the type {ty}"));
        let argument = |index: usize| ty.template_args.as_ref().and_then(|arguments| arguments.get(index));
        let element = || match argument(0).map(|argument| argument.expression.node()) {
            Some(Expression::TypeOrIdentifier(inner)) => self.written(inner),
            _ => Err(unknown()),
        };
        if let Some(scalar) = scalar_named(&name) {
            return Ok(Type::Scalar(scalar));
        }
        if let Some((size, scalar)) = vector_named(&name) {
            let scalar = match scalar {
                Some(scalar) => scalar,
                None => element()?.scalar().ok_or_else(unknown)?,
            };
            return Ok(Type::Vector(size, scalar));
        }
        if let Some(size) = matrix_named(&name) {
            return Ok(Type::Matrix(size));
        }
        if *name == "array" {
            let count = match argument(1).map(|argument| argument.expression.node()) {
                Some(Expression::Literal(literal)) => whole(literal).ok_or_else(unknown)?,
                _ => return Err(unknown()),
            };
            return Ok(Type::Array(Box::new(element()?), count));
        }
        match self.structs.contains_key(&**name) {
            true => Ok(Type::Struct(name.clone())),
            false => Err(unknown()),
        }
    }

    /// The type of an expression; abstract, if it consists of literals only.
    pub(crate) fn of(&self, expression: &Expression) -> Result<Type, TranslationError> {
        match expression {
            Expression::Literal(literal) => Ok(Type::Scalar(of_literal(literal))),
            Expression::Parenthesized(inner) => self.of(&inner.expression),
            Expression::NamedComponent(access) => self.of_component(&self.of(&access.base)?, &access.component.name()),
            Expression::Indexing(indexing) => match self.of(&indexing.base)? {
                Type::Vector(_, scalar) => Ok(Type::Scalar(scalar)),
                Type::Matrix(size) => Ok(Type::Vector(size, Scalar::F32)),
                Type::Array(element, _) => Ok(*element),
                other => Err(TranslationError::unsupported(format!("an index into {other}"))),
            },
            Expression::Unary(unary) => match unary.operator {
                UnaryOperator::LogicalNegation | UnaryOperator::Negation | UnaryOperator::BitwiseComplement => {
                    self.of(&unary.operand)
                }
                other => Err(TranslationError::unsupported(format!("the operator {other}"))),
            },
            Expression::Binary(binary) => {
                let (left, right) = (self.of(&binary.left)?, self.of(&binary.right)?);
                Ok(of_operation(binary.operator, left, right))
            }
            Expression::FunctionCall(call) => self.of_call(call),
            Expression::TypeOrIdentifier(name) => {
                let name = name.ident.name();
                let unknown = || TranslationError::unsupported(format!("the name {name}"));
                self.variable(&name).map(|variable| variable.ty.clone()).ok_or_else(unknown)
            }
        }
    }

    fn of_component(&self, base: &Type, component: &str) -> Result<Type, TranslationError> {
        match base {
            Type::Vector(_, scalar) => Ok(Type::of(component.len(), *scalar)),
            Type::Struct(name) => {
                let member = self.members(name).and_then(|members| members.iter().find(|(own, _)| own == component));
                let unknown = || TranslationError::unsupported(format!("the member {component} of {name}"));
                member.map(|(_, ty)| ty.clone()).ok_or_else(unknown)
            }
            other => Err(TranslationError::unsupported(format!("the component {component} of {other}"))),
        }
    }

    fn of_call(&self, call: &FunctionCall) -> Result<Type, TranslationError> {
        let name = call.ty.ident.name();
        if let Some(signature) = self.functions.get(&**name) {
            return Ok(signature.result.clone());
        }
        if let Some(constructed) = self.constructed(call)? {
            return Ok(constructed);
        }
        let arguments: Result<Vec<Type>, _> = call.arguments.iter().map(|argument| self.of(argument)).collect();
        of_builtin(&name, &arguments?)
    }

    /// The type that a call makes a value of, if it is a type that is called.
    pub(crate) fn constructed(&self, call: &FunctionCall) -> Result<Option<Type>, TranslationError> {
        let name = call.ty.ident.name();
        let is_open = call.ty.template_args.is_none();
        match vector_named(&name) {
            Some((size, None)) if is_open => {
                let mut scalar = Scalar::AbstractInt;
                for argument in &call.arguments {
                    if let Some(own) = self.of(argument)?.scalar() {
                        scalar = common(scalar, own);
                    }
                }
                return Ok(Some(Type::Vector(size, scalar.concrete())));
            }
            _ => {}
        }
        let is_type = scalar_named(&name).is_some()
            || vector_named(&name).is_some()
            || matrix_named(&name).is_some()
            || *name == "array"
            || self.structs.contains_key(&**name);
        if is_type { self.written(&call.ty).map(Some) } else { Ok(None) }
    }
}

fn scalar_named(name: &str) -> Option<Scalar> {
    match name {
        "bool" => Some(Scalar::Bool),
        "i32" => Some(Scalar::I32),
        "u32" => Some(Scalar::U32),
        "f32" => Some(Scalar::F32),
        _ => None,
    }
}

/// The size of a vector type, and what it is made of if the name says so: `vec3`, `vec3f`.
fn vector_named(name: &str) -> Option<(usize, Option<Scalar>)> {
    let rest = name.strip_prefix("vec")?;
    let size = rest.chars().next()?.to_digit(10).filter(|size| (2..=4).contains(size))? as usize;
    match &rest[1..] {
        "" => Some((size, None)),
        "f" => Some((size, Some(Scalar::F32))),
        "i" => Some((size, Some(Scalar::I32))),
        "u" => Some((size, Some(Scalar::U32))),
        _ => None,
    }
}

/// The columns of a square matrix type.
fn matrix_named(name: &str) -> Option<usize> {
    match name.trim_end_matches('f') {
        "mat2x2" => Some(2),
        "mat3x3" => Some(3),
        "mat4x4" => Some(4),
        _ => None,
    }
}

fn whole(literal: &LiteralExpression) -> Option<usize> {
    match literal {
        LiteralExpression::AbstractInt(value) => usize::try_from(*value).ok(),
        LiteralExpression::U32(value) => usize::try_from(*value).ok(),
        LiteralExpression::I32(value) => usize::try_from(*value).ok(),
        _ => None,
    }
}

fn of_literal(literal: &LiteralExpression) -> Scalar {
    match literal {
        LiteralExpression::Bool(_) => Scalar::Bool,
        LiteralExpression::AbstractInt(_) => Scalar::AbstractInt,
        LiteralExpression::I32(_) => Scalar::I32,
        LiteralExpression::U32(_) => Scalar::U32,
        LiteralExpression::AbstractFloat(_) => Scalar::AbstractFloat,
        LiteralExpression::F32(_) | LiteralExpression::F16(_) => Scalar::F32,
    }
}

/// What two scalars come to in one expression.
pub(crate) fn common(a: Scalar, b: Scalar) -> Scalar {
    match (a, b) {
        (Scalar::AbstractInt, other) | (other, Scalar::AbstractInt) => other,
        (Scalar::AbstractFloat, other) | (other, Scalar::AbstractFloat) => other,
        (own, _) => own,
    }
}

/// The wider of two types, with literals as the other wants them.
fn joined(a: &Type, b: &Type) -> Type {
    match (a.scalar(), b.scalar()) {
        (Some(x), Some(y)) if !a.is_matrix() && !b.is_matrix() => Type::of(a.width().max(b.width()), common(x, y)),
        _ => a.clone(),
    }
}

fn of_operation(operator: BinaryOperator, left: Type, right: Type) -> Type {
    use BinaryOperator as B;
    match operator {
        B::Equality | B::Inequality | B::LessThan | B::LessThanEqual | B::GreaterThan | B::GreaterThanEqual => {
            Type::of(left.width().max(right.width()), Scalar::Bool)
        }
        B::ShortCircuitAnd | B::ShortCircuitOr => Type::BOOL,
        B::ShiftLeft | B::ShiftRight => left,
        B::Multiplication if left.is_matrix() && right.is_vector() => right,
        B::Multiplication if left.is_vector() && right.is_matrix() => left,
        B::Multiplication if right.is_matrix() => right,
        _ => joined(&left, &right),
    }
}

/// The type of a built-in function's result.
fn of_builtin(name: &str, arguments: &[Type]) -> Result<Type, TranslationError> {
    let unknown = || TranslationError::unsupported(format!("the function {name}"));
    let first = arguments.first().ok_or_else(unknown)?;
    let all = || arguments.iter().skip(1).fold(first.clone(), |all, next| joined(&all, next)).concrete();
    match name {
        "length" | "distance" | "dot" | "determinant" => Ok(Type::F32),
        "any" | "all" => Ok(Type::BOOL),
        "select" => Ok(joined(first, arguments.get(1).ok_or_else(unknown)?).concrete()),
        _ if super::builtins::is_known(name) => Ok(all()),
        _ => Err(unknown()),
    }
}
