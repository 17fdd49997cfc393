//! From naga's IR to programs.
//!
//! The functions of the vocabulary are straight-line code without variables, so an expression can be translated where
//! it is first needed, and calls in their order. Anything else is refused.

use naga::{
    BinaryOperator, Block, Expression, Function, Handle, Literal, MathFunction, Module, Statement, SwizzleComponent,
    TypeInner, UnaryOperator, VectorSize,
};
use rustc_hash::FxHashMap;

use super::{Operation, Program, Slot};

/// What is refused, in words.
pub(crate) type Refused = String;

/// Translates one function, with everything it calls.
pub(crate) fn program(module: &Module, function: &Function) -> Result<Program, Refused> {
    let mut arguments = Vec::new();
    let mut arity = 0;
    for argument in &function.arguments {
        let len = len_of(&module.types[argument.ty].inner)?;
        arguments.push((arity..arity + len).map(|slot| slot as Slot).collect());
        arity += len;
    }
    let mut builder = Builder { module, arity, operations: Vec::new() };
    let results = builder.inline(function, arguments)?;
    Ok(Program { arity, operations: builder.operations, results })
}

/// A value: where its components are.
type Value = Vec<Slot>;

/// The operations so far. Equal ones are shared.
struct Builder<'m> {
    module: &'m Module,
    arity: usize,
    operations: Vec<Operation>,
}

/// One inlined call: the values its expressions have.
struct Frame<'m> {
    function: &'m Function,
    arguments: Vec<Value>,
    values: FxHashMap<Handle<Expression>, Value>,
}

impl<'m> Builder<'m> {
    fn inline(&mut self, function: &'m Function, arguments: Vec<Value>) -> Result<Value, Refused> {
        let mut frame = Frame { function, arguments, values: FxHashMap::default() };
        let returned = self.block(&function.body, &mut frame)?;
        returned.ok_or_else(|| String::from("a function without a value"))
    }

    fn block(&mut self, block: &Block, frame: &mut Frame<'m>) -> Result<Option<Value>, Refused> {
        for statement in block {
            match statement {
                Statement::Emit(_) => {}
                Statement::Call { function, arguments, result: Some(result) } => {
                    let arguments = arguments.iter().map(|argument| self.value(*argument, frame));
                    let arguments = arguments.collect::<Result<_, _>>()?;
                    let value = self.inline(&self.module.functions[*function], arguments)?;
                    frame.values.insert(*result, value);
                }
                Statement::Return { value: Some(value) } => return self.value(*value, frame).map(Some),
                other => return Err(format!("the statement {other:?}")),
            }
        }
        Ok(None)
    }

    fn value(&mut self, handle: Handle<Expression>, frame: &mut Frame<'m>) -> Result<Value, Refused> {
        if let Some(value) = frame.values.get(&handle) {
            return Ok(value.clone());
        }
        let value = self.expression(&frame.function.expressions[handle], frame)?;
        frame.values.insert(handle, value.clone());
        Ok(value)
    }

    fn expression(&mut self, expression: &Expression, frame: &mut Frame<'m>) -> Result<Value, Refused> {
        match *expression {
            Expression::FunctionArgument(index) => Ok(frame.arguments[index as usize].clone()),
            Expression::Literal(literal) => Ok(vec![self.push(Operation::Constant(number(literal)?))]),
            Expression::Constant(constant) => self.constant(self.module.constants[constant].init),
            Expression::ZeroValue(ty) => {
                let zero = self.push(Operation::Constant(0.0));
                Ok(vec![zero; len_of(&self.module.types[ty].inner)?])
            }
            Expression::Compose { ref components, .. } => {
                let parts = components.iter().map(|component| self.value(*component, frame));
                Ok(parts.collect::<Result<Vec<_>, _>>()?.concat())
            }
            Expression::Splat { size, value } => {
                let value = self.value(value, frame)?;
                Ok(vec![value[0]; size as usize])
            }
            Expression::AccessIndex { base, index } => Ok(vec![self.value(base, frame)?[index as usize]]),
            Expression::Swizzle { size, vector, pattern } => {
                let vector = self.value(vector, frame)?;
                let component = |component: &SwizzleComponent| vector[*component as usize];
                Ok(pattern[..size as usize].iter().map(component).collect())
            }
            Expression::Unary { op, expr } => {
                let value = self.value(expr, frame)?;
                match op {
                    UnaryOperator::Negate => Ok(self.each(&value, Operation::Negate)),
                    UnaryOperator::LogicalNot => Ok(self.each(&value, Operation::Not)),
                    UnaryOperator::BitwiseNot => Err(String::from("an operation on bits")),
                }
            }
            Expression::Binary { op, left, right } => {
                let (left, right) = (self.value(left, frame)?, self.value(right, frame)?);
                self.binary(op, &left, &right)
            }
            Expression::Select { condition, accept, reject } => {
                let condition = self.value(condition, frame)?;
                let (accept, reject) = (self.value(accept, frame)?, self.value(reject, frame)?);
                let select = |index: usize| {
                    let condition = condition[if condition.len() == 1 { 0 } else { index }];
                    self.push(Operation::Select(condition, accept[index], reject[index]))
                };
                Ok((0..accept.len()).map(select).collect())
            }
            Expression::Math { fun, arg, arg1, arg2, arg3: None } => {
                let mut arguments = Vec::new();
                for argument in [Some(arg), arg1, arg2].into_iter().flatten() {
                    arguments.push(self.value(argument, frame)?);
                }
                self.math(fun, &arguments)
            }
            ref other => Err(format!("the expression {other:?}")),
        }
    }

    fn constant(&mut self, init: Handle<Expression>) -> Result<Value, Refused> {
        match &self.module.global_expressions[init] {
            Expression::Literal(literal) => Ok(vec![self.push(Operation::Constant(number(*literal)?))]),
            Expression::Compose { components, .. } => {
                let parts = components.iter().map(|component| self.constant(*component));
                Ok(parts.collect::<Result<Vec<_>, _>>()?.concat())
            }
            other => Err(format!("the constant {other:?}")),
        }
    }

    fn binary(&mut self, op: BinaryOperator, left: &[Slot], right: &[Slot]) -> Result<Value, Refused> {
        let value = match op {
            BinaryOperator::Add => self.pairs(left, right, Operation::Add),
            BinaryOperator::Subtract => self.pairs(left, right, Operation::Subtract),
            BinaryOperator::Multiply => self.pairs(left, right, Operation::Multiply),
            BinaryOperator::Divide => self.pairs(left, right, Operation::Divide),
            BinaryOperator::Less => self.pairs(left, right, Operation::Less),
            BinaryOperator::LessEqual => self.pairs(left, right, Operation::LessEqual),
            BinaryOperator::Greater => self.pairs(right, left, Operation::Less),
            BinaryOperator::GreaterEqual => self.pairs(right, left, Operation::LessEqual),
            BinaryOperator::Equal => self.pairs(left, right, Operation::Equal),
            BinaryOperator::NotEqual => {
                let equal = self.pairs(left, right, Operation::Equal);
                self.each(&equal, Operation::Not)
            }
            // On truth values; naga has no others here, for there are no integers.
            BinaryOperator::And | BinaryOperator::LogicalAnd => self.pairs(left, right, Operation::Min),
            BinaryOperator::InclusiveOr | BinaryOperator::LogicalOr => self.pairs(left, right, Operation::Max),
            other => return Err(format!("the operator {other:?}")),
        };
        Ok(value)
    }

    fn math(&mut self, function: MathFunction, arguments: &[Value]) -> Result<Value, Refused> {
        let value = match (function, arguments) {
            (MathFunction::Abs, [a]) => self.each(a, Operation::Abs),
            (MathFunction::Sign, [a]) => self.each(a, Operation::Sign),
            (MathFunction::Floor, [a]) => self.each(a, Operation::Floor),
            (MathFunction::Fract, [a]) => {
                let floor = self.each(a, Operation::Floor);
                self.pairs(a, &floor, Operation::Subtract)
            }
            (MathFunction::Sqrt, [a]) => self.each(a, Operation::Sqrt),
            (MathFunction::InverseSqrt, [a]) => {
                let root = self.each(a, Operation::Sqrt);
                let one = self.push(Operation::Constant(1.0));
                self.pairs(&[one], &root, Operation::Divide)
            }
            (MathFunction::Sin, [a]) => self.each(a, Operation::Sin),
            (MathFunction::Cos, [a]) => self.each(a, Operation::Cos),
            (MathFunction::Exp, [a]) => self.each(a, Operation::Exp),
            (MathFunction::Log, [a]) => self.each(a, Operation::Ln),
            (MathFunction::Atan2, [y, x]) => self.pairs(y, x, Operation::Atan2),
            (MathFunction::Min, [a, b]) => self.pairs(a, b, Operation::Min),
            (MathFunction::Max, [a, b]) => self.pairs(a, b, Operation::Max),
            (MathFunction::Clamp, [a, low, high]) => {
                let raised = self.pairs(a, low, Operation::Max);
                self.pairs(&raised, high, Operation::Min)
            }
            (MathFunction::Mix, [a, b, t]) => {
                let one = self.push(Operation::Constant(1.0));
                let rest = self.pairs(&[one], t, Operation::Subtract);
                let (of_a, of_b) = (self.pairs(a, &rest, Operation::Multiply), self.pairs(b, t, Operation::Multiply));
                self.pairs(&of_a, &of_b, Operation::Add)
            }
            (MathFunction::Dot, [a, b]) => vec![self.dot(a, b)],
            (MathFunction::Length, [a]) => vec![self.length(a)],
            (MathFunction::Distance, [a, b]) => {
                let difference = self.pairs(a, b, Operation::Subtract);
                vec![self.length(&difference)]
            }
            (MathFunction::Normalize, [a]) => {
                let length = self.length(a);
                self.pairs(a, &[length], Operation::Divide)
            }
            (MathFunction::Cross, [a, b]) => self.cross(a, b),
            (other, _) => return Err(format!("the function {other:?}")),
        };
        Ok(value)
    }

    fn dot(&mut self, a: &[Slot], b: &[Slot]) -> Slot {
        let products = self.pairs(a, b, Operation::Multiply);
        let (first, rest) = (products[0], &products[1..]);
        rest.iter().fold(first, |sum, product| self.push(Operation::Add(sum, *product)))
    }

    fn length(&mut self, a: &[Slot]) -> Slot {
        let squared = self.dot(a, a);
        self.push(Operation::Sqrt(squared))
    }

    fn cross(&mut self, a: &[Slot], b: &[Slot]) -> Value {
        let component = |(i, j): (usize, usize)| {
            let (plus, minus) = (Operation::Multiply(a[i], b[j]), Operation::Multiply(a[j], b[i]));
            let (plus, minus) = (self.push(plus), self.push(minus));
            self.push(Operation::Subtract(plus, minus))
        };
        [(1, 2), (2, 0), (0, 1)].map(component).to_vec()
    }

    /// The operation on each component.
    fn each(&mut self, a: &[Slot], operation: fn(Slot) -> Operation) -> Value {
        a.iter().map(|a| self.push(operation(*a))).collect()
    }

    /// The operation on each pair of components; a single number goes with every component of a vector.
    fn pairs(&mut self, a: &[Slot], b: &[Slot], operation: fn(Slot, Slot) -> Operation) -> Value {
        let at = |value: &[Slot], index: usize| value[if value.len() == 1 { 0 } else { index }];
        (0..a.len().max(b.len())).map(|index| self.push(operation(at(a, index), at(b, index)))).collect()
    }

    fn push(&mut self, operation: Operation) -> Slot {
        let index = self.operations.iter().position(|known| *known == operation).unwrap_or_else(|| {
            self.operations.push(operation);
            self.operations.len() - 1
        });
        (self.arity + index) as Slot
    }
}

fn len_of(ty: &TypeInner) -> Result<usize, Refused> {
    match *ty {
        TypeInner::Scalar(_) => Ok(1),
        TypeInner::Vector { size: size @ (VectorSize::Bi | VectorSize::Tri), .. } => Ok(size as usize),
        ref other => Err(format!("the type {other:?}")),
    }
}

fn number(literal: Literal) -> Result<f64, Refused> {
    match literal {
        Literal::F64(value) => Ok(value),
        Literal::Bool(value) => Ok(f64::from(u8::from(value))),
        other => Err(format!("the literal {other:?}")),
    }
}
