//! The syntax tree: what was written, and where.
//!
//! The tree's laws:
//! * It says nothing of meaning: `cube` is a name like any other, and `-D` or `use` have not happened.
//! * Statements and children stand in the order of the text; nothing is hoisted.
//! * Every node's span covers its whole text. What the parser had to skip is not in the tree but in a diagnostic.
//! * Its depth is at most [`MAX_DEPTH`], so that it can be walked by recursion.
//! * A `.csg` dump is a tree of [`Instance`]s whose arguments are literals; `inf` and `nan` are [`Name`]s there.

use std::sync::Arc;

pub use crate::name::Name;
use crate::source::{Span, Spanned};

/// The deepest nesting of expressions, blocks and children that the parser accepts.
pub const MAX_DEPTH: usize = 500;

/// One parsed file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// Its statements, in the order of the text.
    pub statements: Vec<Statement>,
}

/// A statement: at the top level, in a module's body, or in a bare block.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// `use <path>`: takes a file's functions and modules.
    Use(Spanned<Name>),
    /// `include <path>`: stands for a file's text.
    Include(Spanned<Name>),
    /// `name = value;`
    Assignment(Assignment),
    /// `module name(parameters) body`
    Module(Arc<ModuleDefinition>),
    /// `function name(parameters) = body;`
    Function(Arc<FunctionDefinition>),
    /// A module instantiated: `cube(3);`
    Instance(Instance),
    /// `{ … }` as a statement of its own. It is no scope.
    Block(Vec<Statement>),
}

/// `name = value;`
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    /// The variable.
    pub name: Spanned<Name>,
    /// What it stands for.
    pub value: Expression,
    /// From the name to the semicolon.
    pub span: Span,
    /// What a Customizer comment behind the assignment says about the values it may take. Only top-level
    /// assignments of literals before the first `{` of a file have one.
    pub customizer: Option<Box<Customizer>>,
}

/// A Customizer comment: the control that moves a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Customizer {
    /// The values the comment allows.
    pub domain: Domain,
    /// The comment line above the assignment, if any.
    pub description: Option<String>,
    /// The group, from the last `/* [Name] */` above. `Hidden` groups carry no Customizer.
    pub group: Option<String>,
}

/// The values that a Customizer comment allows.
#[derive(Clone, Debug, PartialEq)]
pub enum Domain {
    /// `// [min:max]`, `// [min:step:max]` or `// [max]`; min is then 0.
    Range {
        /// The least value.
        min: f64,
        /// The distance of neighbouring values, if given.
        step: Option<f64>,
        /// The greatest value.
        max: f64,
    },
    /// `// 5`: any value, in steps of 5 (for a text, its greatest length).
    Step(f64),
    /// `// [a, b, c]` or `// [10:Label, 20:Other]`: values and what to show for them.
    Choices(Vec<(String, Option<String>)>),
    /// No comment, or none that is understood: any value.
    Any,
}

/// `module name(parameters) body`
#[derive(Clone, Debug, PartialEq)]
pub struct ModuleDefinition {
    /// Its name.
    pub name: Spanned<Name>,
    /// What it takes.
    pub parameters: Vec<Parameter>,
    /// Its statements; one, where no braces are written.
    pub body: Vec<Statement>,
    /// The whole definition.
    pub span: Span,
}

/// `function name(parameters) = body;`
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionDefinition {
    /// Its name.
    pub name: Spanned<Name>,
    /// The function.
    pub function: Arc<FunctionLiteral>,
    /// The whole definition.
    pub span: Span,
}

/// `function (parameters) body`, or the same part of a definition.
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionLiteral {
    /// What it takes.
    pub parameters: Vec<Parameter>,
    /// What it answers.
    pub body: Expression,
}

/// One parameter of a module or function.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name.
    pub name: Spanned<Name>,
    /// Its value where the caller gives none.
    pub default: Option<Expression>,
}

/// `modifiers name(arguments) children`: a module instantiated. `for`, `let`, `echo`, `assert` and `if` are
/// instances too; `if` has its condition as sole argument, and its `else` branch in `otherwise`.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// `*`, `!`, `#` and `%` in front.
    pub modifiers: Modifiers,
    /// The module's name.
    pub name: Spanned<Name>,
    /// What is passed.
    pub arguments: Vec<Argument>,
    /// What stands in braces, or the one instance that follows.
    pub children: Vec<Statement>,
    /// What stands behind `else`. Always empty but for `if`.
    pub otherwise: Vec<Statement>,
    /// The whole instance with its children.
    pub span: Span,
    /// Name and arguments only, which is what a message should point at.
    pub head: Span,
}

/// The modifier characters in front of an instance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Modifiers {
    /// `*`: the subtree is left out.
    pub disable: bool,
    /// `!`: only this subtree is shown.
    pub root: bool,
    /// `#`: highlighted; geometry all the same.
    pub highlight: bool,
    /// `%`: shown as a ghost; no geometry.
    pub background: bool,
}

/// `value` or `name = value`, in a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// The parameter's name, if it is given.
    pub name: Option<Spanned<Name>>,
    /// The value.
    pub value: Expression,
}

/// An expression and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    /// What kind it is.
    pub kind: Box<ExpressionKind>,
    /// Its whole text.
    pub span: Span,
}

impl Expression {
    /// An expression of that kind at `span`.
    pub fn new(kind: ExpressionKind, span: Span) -> Self {
        Self { kind: Box::new(kind), span }
    }
}

/// The kinds of expression.
#[derive(Clone, Debug, PartialEq)]
pub enum ExpressionKind {
    /// `undef`
    Undef,
    /// `true` or `false`
    Bool(bool),
    /// `1.5`, `0x1F`; a sign is a [`Unary`](ExpressionKind::Unary).
    Number(f64),
    /// `"text"`, its escapes resolved.
    String(Arc<str>),
    /// A variable.
    Name(Name),
    /// `[start : end]` or `[start : step : end]`
    Range {
        /// The first value.
        start: Expression,
        /// The distance of neighbours; 1 where it is left out.
        step: Option<Expression>,
        /// The value not to be passed.
        end: Expression,
    },
    /// `[a, b, for (…) c]`
    List(Vec<Element>),
    /// `-a`, `!a`, …
    Unary(UnaryOperator, Expression),
    /// `a + b`, …
    Binary(BinaryOperator, Expression, Expression),
    /// `condition ? yes : no`
    Conditional {
        /// What decides.
        condition: Expression,
        /// The value if it is true.
        yes: Expression,
        /// The value if not.
        no: Expression,
    },
    /// `list[index]`
    Index(Expression, Expression),
    /// `list.x`
    Member(Expression, Spanned<Name>),
    /// `function(arguments)`
    Call(Expression, Vec<Argument>),
    /// `function (parameters) body`
    Function(Arc<FunctionLiteral>),
    /// `let (bindings) body`
    Let(Vec<Argument>, Expression),
    /// `assert (arguments) body`
    Assert(Vec<Argument>, Option<Expression>),
    /// `echo (arguments) body`
    Echo(Vec<Argument>, Option<Expression>),
    /// What could not be read; a diagnostic says why.
    Error,
}

/// An element of a list.
#[derive(Clone, Debug, PartialEq)]
pub enum Element {
    /// One value.
    Value(Expression),
    /// `each list`: all values of a list.
    Each(Box<Element>, Span),
    /// `for (bindings) element`
    For(Vec<Argument>, Box<Element>, Span),
    /// `for (start; condition; next) element`
    Loop {
        /// The variables' first values.
        start: Vec<Argument>,
        /// Whether to go on.
        condition: Expression,
        /// The variables' next values.
        next: Vec<Argument>,
        /// What each round yields.
        body: Box<Element>,
        /// From `for` to the body's end.
        span: Span,
    },
    /// `if (condition) element else element`
    If(Expression, Box<Element>, Option<Box<Element>>, Span),
    /// `let (bindings) element`
    Let(Vec<Argument>, Box<Element>, Span),
}

/// The operators with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnaryOperator {
    /// `-a`
    Negate,
    /// `+a`
    Plus,
    /// `!a`
    Not,
    /// `~a`
    BitNot,
}

/// The operators with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the names say it")]
pub enum BinaryOperator {
    Or,
    And,
    Equal,
    NotEqual,
    Greater,
    GreaterEqual,
    Less,
    LessEqual,
    BitOr,
    BitAnd,
    ShiftLeft,
    ShiftRight,
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    Power,
}
