//! Building one naga function.

use naga::{
    BinaryOperator, Block, Expression, Function, FunctionArgument, FunctionResult, Handle, Literal, LocalVariable,
    MathFunction, Module, Scalar, Span, Statement, SwizzleComponent, Type, TypeInner, UnaryOperator, VectorSize,
};
use rustc_hash::FxHashMap;

/// An expression of the function being built.
pub(crate) type Value = Handle<Expression>;

/// The types that emitted code uses.
#[derive(Clone, Copy)]
pub(crate) struct Types {
    pub(crate) float: Handle<Type>,
    pub(crate) index: Handle<Type>,
    pub(crate) vec2: Handle<Type>,
    pub(crate) vec3: Handle<Type>,
    pub(crate) vec4: Handle<Type>,
    pub(crate) mat2: Handle<Type>,
    pub(crate) mat3: Handle<Type>,
}

impl Types {
    /// Those of a module, which gets what it lacks.
    pub(crate) fn of(module: &mut Module) -> Self {
        let mut add = |inner| module.types.insert(Type { name: None, inner }, Span::UNDEFINED);
        let scalar = Scalar::F32;
        let vector = |size| TypeInner::Vector { size, scalar };
        let matrix = |size| TypeInner::Matrix { columns: size, rows: size, scalar };
        Self {
            float: add(TypeInner::Scalar(scalar)),
            index: add(TypeInner::Scalar(Scalar::U32)),
            vec2: add(vector(VectorSize::Bi)),
            vec3: add(vector(VectorSize::Tri)),
            vec4: add(vector(VectorSize::Quad)),
            mat2: add(matrix(VectorSize::Bi)),
            mat3: add(matrix(VectorSize::Tri)),
        }
    }
}

/// A function in the making: expressions are evaluated in the order in which they are added.
pub(crate) struct Builder {
    pub(crate) types: Types,
    function: Function,
    /// The blocks that are open, the innermost last.
    blocks: Vec<Block>,
    /// The number of expressions that some statement evaluates already, or that need none.
    evaluated: usize,
    literals: FxHashMap<u32, Value>,
}

impl Builder {
    /// A function of the point `p`, of that type.
    pub(crate) fn new(name: &str, types: Types, point: Handle<Type>, result: Handle<Type>) -> Self {
        let argument = FunctionArgument { name: Some("p".to_string()), ty: point, binding: None };
        let function = Function {
            name: Some(name.to_string()),
            arguments: vec![argument],
            result: Some(FunctionResult { ty: result, binding: None }),
            ..Function::default()
        };
        Self { types, function, blocks: vec![Block::new()], evaluated: 0, literals: FxHashMap::default() }
    }

    /// The function that returns `value`.
    pub(crate) fn finish(mut self, value: Value) -> Function {
        self.statement(Statement::Return { value: Some(value) });
        self.function.body = self.blocks.pop().unwrap_or_default();
        self.function
    }

    /// The point `p`.
    pub(crate) fn argument(&mut self) -> Value {
        self.add(Expression::FunctionArgument(0))
    }

    /// A new argument behind the others.
    pub(crate) fn another_argument(&mut self, name: &str, ty: Handle<Type>) -> Value {
        let index = self.function.arguments.len() as u32;
        self.function.arguments.push(FunctionArgument { name: Some(name.to_string()), ty, binding: None });
        self.add(Expression::FunctionArgument(index))
    }

    /// A number.
    pub(crate) fn literal(&mut self, value: f32) -> Value {
        if let Some(&literal) = self.literals.get(&value.to_bits()) {
            return literal;
        }
        let literal = self.add(Expression::Literal(Literal::F32(value)));
        self.literals.insert(value.to_bits(), literal);
        literal
    }

    /// A vector of two to four numbers.
    pub(crate) fn vector(&mut self, components: &[Value]) -> Value {
        let ty = match components.len() {
            2 => self.types.vec2,
            3 => self.types.vec3,
            _ => self.types.vec4,
        };
        self.compose(ty, components)
    }

    /// A value of a type with components; a vector's may be shorter vectors.
    pub(crate) fn compose(&mut self, ty: Handle<Type>, components: &[Value]) -> Value {
        self.add(Expression::Compose { ty, components: components.to_vec() })
    }

    /// A component of a vector, or a pointer to one.
    pub(crate) fn component(&mut self, base: Value, index: u32) -> Value {
        self.add(Expression::AccessIndex { base, index })
    }

    /// The first components of a vector, as a shorter one.
    pub(crate) fn truncate(&mut self, vector: Value, size: VectorSize) -> Value {
        self.add(Expression::Swizzle { size, vector, pattern: SwizzleComponent::XYZW })
    }

    /// The last two components of a vector of four.
    pub(crate) fn last_two(&mut self, vector: Value) -> Value {
        use SwizzleComponent::{W, Z};
        self.add(Expression::Swizzle { size: VectorSize::Bi, vector, pattern: [Z, W, W, W] })
    }

    /// The opposite.
    pub(crate) fn negate(&mut self, expr: Value) -> Value {
        self.add(Expression::Unary { op: UnaryOperator::Negate, expr })
    }

    /// An operation on two values.
    pub(crate) fn binary(&mut self, op: BinaryOperator, left: Value, right: Value) -> Value {
        self.add(Expression::Binary { op, left, right })
    }

    /// A built-in function of one or two values.
    pub(crate) fn math(&mut self, fun: MathFunction, arg: Value, arg1: Option<Value>) -> Value {
        self.add(Expression::Math { fun, arg, arg1, arg2: None, arg3: None })
    }

    /// One of two values.
    pub(crate) fn select(&mut self, condition: Value, accept: Value, reject: Value) -> Value {
        self.add(Expression::Select { condition, accept, reject })
    }

    /// What a pointer points to, now.
    pub(crate) fn load(&mut self, pointer: Value) -> Value {
        self.add(Expression::Load { pointer })
    }

    /// Calls a function.
    pub(crate) fn call(&mut self, function: Handle<Function>, arguments: &[Value]) -> Value {
        let result = self.add(Expression::CallResult(function));
        self.statement(Statement::Call { function, arguments: arguments.to_vec(), result: Some(result) });
        result
    }

    /// Names a value; the first name stays.
    pub(crate) fn name(&mut self, value: Value, name: String) -> Value {
        self.function.named_expressions.entry(value).or_insert(name);
        value
    }

    /// A pointer to a new variable, which starts as a literal if one is given.
    pub(crate) fn variable(&mut self, name: String, ty: Handle<Type>, init: Option<Value>) -> Value {
        let variable = LocalVariable { name: Some(name), ty, init };
        let variable = self.function.local_variables.append(variable, Span::UNDEFINED);
        self.add(Expression::LocalVariable(variable))
    }

    /// Stores a value.
    pub(crate) fn store(&mut self, pointer: Value, value: Value) {
        self.statement(Statement::Store { pointer, value });
    }

    /// Opens a block, to be closed by [`close`](Self::close).
    pub(crate) fn open(&mut self) {
        self.flush();
        self.blocks.push(Block::new());
    }

    /// Closes the innermost block.
    pub(crate) fn close(&mut self) -> Block {
        self.flush();
        self.blocks.pop().unwrap_or_default()
    }

    /// Adds a statement behind the evaluation of all expressions so far.
    pub(crate) fn statement(&mut self, statement: Statement) {
        self.flush();
        if let Some(block) = self.blocks.last_mut() {
            block.push(statement, Span::UNDEFINED);
        }
    }

    /// Adds an expression.
    pub(crate) fn add(&mut self, expression: Expression) -> Value {
        if !needs_evaluation(&expression) {
            self.flush();
            let value = self.function.expressions.append(expression, Span::UNDEFINED);
            self.evaluated = self.function.expressions.len();
            return value;
        }
        self.function.expressions.append(expression, Span::UNDEFINED)
    }

    fn flush(&mut self) {
        let expressions = &self.function.expressions;
        if expressions.len() > self.evaluated {
            let range = expressions.range_from(self.evaluated);
            self.evaluated = expressions.len();
            if let Some(block) = self.blocks.last_mut() {
                block.push(Statement::Emit(range), Span::UNDEFINED);
            }
        }
    }
}

/// Whether naga wants a statement that says when the expression is evaluated.
fn needs_evaluation(expression: &Expression) -> bool {
    !matches!(
        expression,
        Expression::Literal(_)
            | Expression::FunctionArgument(_)
            | Expression::GlobalVariable(_)
            | Expression::LocalVariable(_)
            | Expression::CallResult(_)
    )
}
