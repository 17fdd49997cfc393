//! Runs functions of a naga module in double precision: as much of naga's IR as emitted scenes use.

use std::collections::HashMap;

use naga::{
    BinaryOperator as B, Block, Expression, Function, Handle, Literal, LocalVariable, MathFunction as M, Module,
    Statement, SwizzleComponent, UnaryOperator,
};

/// Numbers of any kind, truth values as 1 and 0, vectors and structs as lists, matrices by columns.
type Numbers = Vec<f64>;

/// A module and what is bound to it.
pub(crate) struct Machine<'m> {
    pub(crate) module: &'m Module,
    /// The rows of the variables `live` and `tables`.
    pub(crate) bound: HashMap<&'static str, Vec<[f32; 4]>>,
}

enum Value {
    Numbers(Numbers),
    Local(Handle<LocalVariable>),
    Bound(String, Vec<usize>),
}

#[derive(PartialEq)]
enum Flow {
    Next,
    Break,
    Return(Numbers),
}

struct Frame<'m> {
    function: &'m Function,
    arguments: Vec<Numbers>,
    values: HashMap<Handle<Expression>, Numbers>,
    locals: HashMap<Handle<LocalVariable>, Numbers>,
}

impl<'m> Machine<'m> {
    /// The result of the module's function with this name.
    pub(crate) fn run(&self, function: &str, arguments: Vec<Numbers>) -> Numbers {
        let found = self.module.functions.iter().find(|(_, f)| f.name.as_deref() == Some(function));
        self.call(found.unwrap_or_else(|| panic!("no function {function}")).0, arguments)
    }

    fn call(&self, handle: Handle<Function>, arguments: Vec<Numbers>) -> Numbers {
        let function = &self.module.functions[handle];
        let mut frame = Frame { function, arguments, values: HashMap::new(), locals: HashMap::new() };
        for (local, variable) in function.local_variables.iter() {
            if let Some(init) = variable.init {
                let value = self.numbers(init, &frame);
                frame.locals.insert(local, value);
            }
        }
        match self.block(&function.body, &mut frame) {
            Flow::Return(value) => value,
            _ => panic!("no result"),
        }
    }

    fn block(&self, block: &'m Block, frame: &mut Frame<'m>) -> Flow {
        for statement in block.iter() {
            let flow = match statement {
                Statement::Emit(range) => {
                    for handle in range.clone() {
                        if let Value::Numbers(value) = self.value(handle, frame) {
                            frame.values.insert(handle, value);
                        }
                    }
                    Flow::Next
                }
                Statement::Call { function, arguments, result } => {
                    let arguments = arguments.iter().map(|argument| self.numbers(*argument, frame)).collect();
                    frame.values.insert(result.unwrap(), self.call(*function, arguments));
                    Flow::Next
                }
                Statement::Store { pointer, value } => {
                    let Value::Local(local) = self.value(*pointer, frame) else { panic!("a store elsewhere") };
                    frame.locals.insert(local, self.numbers(*value, frame));
                    Flow::Next
                }
                Statement::If { condition, accept, reject } => {
                    let chosen = if self.numbers(*condition, frame)[0] != 0.0 { accept } else { reject };
                    self.block(chosen, frame)
                }
                Statement::Loop { body, continuing, break_if: None } => loop {
                    match self.block(body, frame) {
                        Flow::Next => self.block(continuing, frame),
                        Flow::Break => break Flow::Next,
                        flow => break flow,
                    };
                },
                Statement::Block(inner) => self.block(inner, frame),
                Statement::Break => Flow::Break,
                Statement::Return { value } => Flow::Return(self.numbers(value.unwrap(), frame)),
                other => panic!("{other:?}"),
            };
            if flow != Flow::Next {
                return flow;
            }
        }
        Flow::Next
    }

    fn numbers(&self, handle: Handle<Expression>, frame: &Frame<'m>) -> Numbers {
        if let Some(value) = frame.values.get(&handle) {
            return value.clone();
        }
        match self.value(handle, frame) {
            Value::Numbers(value) => value,
            _ => panic!("a pointer is no number"),
        }
    }

    fn value(&self, handle: Handle<Expression>, frame: &Frame<'m>) -> Value {
        let numbers = |handle: &Handle<Expression>| self.numbers(*handle, frame);
        let element = |base: &Handle<Expression>, index: usize| {
            self.pointer(*base, frame).map(|(name, path)| Value::Bound(name, [path, vec![index]].concat()))
        };
        Value::Numbers(match &frame.function.expressions[handle] {
            Expression::Literal(literal) => vec![number(*literal)],
            Expression::Constant(constant) => self.constant(self.module.constants[*constant].init),
            Expression::ZeroValue(_) => vec![0.0],
            Expression::Compose { components, .. } => components.iter().flat_map(numbers).collect(),
            Expression::Splat { size, value } => vec![numbers(value)[0]; *size as usize],
            Expression::AccessIndex { base, index } => match element(base, *index as usize) {
                Some(element) => return element,
                None => vec![numbers(base)[*index as usize]],
            },
            Expression::Access { base, index } => {
                return element(base, numbers(index)[0] as usize).expect("only buffers are indexed by variables");
            }
            Expression::Swizzle { size, vector, pattern } => {
                let vector = numbers(vector);
                let place = |component: &SwizzleComponent| vector[*component as usize];
                pattern[..*size as usize].iter().map(place).collect()
            }
            Expression::FunctionArgument(index) => frame.arguments[*index as usize].clone(),
            Expression::LocalVariable(local) => return Value::Local(*local),
            Expression::GlobalVariable(variable) => {
                return Value::Bound(self.module.global_variables[*variable].name.clone().unwrap(), vec![]);
            }
            Expression::Load { pointer } => match self.value(*pointer, frame) {
                Value::Local(local) => frame.locals[&local].clone(),
                Value::Bound(name, path) => {
                    let row = self.bound[name.as_str()][path[0]].map(f64::from);
                    path.get(1).map_or(row.to_vec(), |component| vec![row[*component]])
                }
                Value::Numbers(_) => panic!("no pointer"),
            },
            Expression::Unary { op, expr } => {
                let apply = |x: f64| match op {
                    UnaryOperator::Negate => -x,
                    _ => f64::from(x == 0.0),
                };
                numbers(expr).into_iter().map(apply).collect()
            }
            Expression::Binary { op, left, right } => binary(*op, &numbers(left), &numbers(right)),
            Expression::Select { condition, accept, reject } => {
                let condition = numbers(condition);
                let chosen = |(i, (a, r))| if condition[i % condition.len()] != 0.0 { a } else { r };
                numbers(accept).into_iter().zip(numbers(reject)).enumerate().map(chosen).collect()
            }
            Expression::Math { fun, arg, arg1, arg2, .. } => {
                let arguments: Vec<Numbers> =
                    [Some(arg), arg1.as_ref(), arg2.as_ref()].into_iter().flatten().map(numbers).collect();
                math(*fun, &arguments)
            }
            Expression::CallResult(_) => panic!("a call's result before the call"),
            other => panic!("{other:?}"),
        })
    }

    fn constant(&self, init: Handle<Expression>) -> Numbers {
        match &self.module.global_expressions[init] {
            Expression::Literal(literal) => vec![number(*literal)],
            Expression::Compose { components, .. } => components.iter().flat_map(|c| self.constant(*c)).collect(),
            Expression::Splat { size, value } => vec![self.constant(*value)[0]; *size as usize],
            other => panic!("{other:?}"),
        }
    }

    /// Where a pointer into a buffer points.
    fn pointer(&self, handle: Handle<Expression>, frame: &Frame<'m>) -> Option<(String, Vec<usize>)> {
        match &frame.function.expressions[handle] {
            Expression::GlobalVariable(_) => {}
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => {
                self.pointer(*base, frame)?;
            }
            _ => return None,
        }
        match self.value(handle, frame) {
            Value::Bound(name, path) => Some((name, path)),
            _ => None,
        }
    }
}

fn number(literal: Literal) -> f64 {
    match literal {
        Literal::F32(value) => value.into(),
        Literal::U32(value) => value.into(),
        Literal::Bool(value) => f64::from(value),
        other => panic!("{other:?}"),
    }
}

fn binary(op: B, left: &[f64], right: &[f64]) -> Numbers {
    if op == B::Multiply && left.len() == right.len() * right.len() && right.len() > 1 {
        let n = right.len();
        return (0..n).map(|i| (0..n).map(|j| left[j * n + i] * right[j]).sum()).collect();
    }
    pairs(left, right, |a, b| match op {
        B::Add => a + b,
        B::Subtract => a - b,
        B::Multiply => a * b,
        B::Divide => a / b,
        B::Equal => f64::from(a == b),
        B::NotEqual => f64::from(a != b),
        B::Less => f64::from(a < b),
        B::LessEqual => f64::from(a <= b),
        B::Greater => f64::from(a > b),
        B::GreaterEqual => f64::from(a >= b),
        B::And | B::LogicalAnd => f64::from(a != 0.0 && b != 0.0),
        B::InclusiveOr | B::LogicalOr => f64::from(a != 0.0 || b != 0.0),
        other => panic!("{other:?}"),
    })
}

fn math(function: M, arguments: &[Numbers]) -> Numbers {
    let one = |f: fn(f64) -> f64| arguments[0].iter().map(|x| f(*x)).collect();
    let two = |f: fn(f64, f64) -> f64| pairs(&arguments[0], &arguments[1], f);
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    match function {
        M::Abs => one(f64::abs),
        M::Sqrt => one(f64::sqrt),
        M::InverseSqrt => one(|x| 1.0 / x.sqrt()),
        M::Sign => one(|x| if x == 0.0 { 0.0 } else { x.signum() }),
        M::Sin => one(f64::sin),
        M::Cos => one(f64::cos),
        M::Floor => one(f64::floor),
        M::Atan2 => two(f64::atan2),
        M::Min => two(f64::min),
        M::Max => two(f64::max),
        M::Pow => two(f64::powf),
        M::Length => vec![dot(&arguments[0], &arguments[0]).sqrt()],
        M::Dot => vec![dot(&arguments[0], &arguments[1])],
        M::Cross => {
            let (a, b) = (&arguments[0], &arguments[1]);
            (0..3).map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]).collect()
        }
        M::Clamp => pairs(&pairs(&arguments[0], &arguments[1], f64::max), &arguments[2], f64::min),
        M::Mix => {
            let change = pairs(&arguments[1], &arguments[0], |b, a| b - a);
            pairs(&arguments[0], &pairs(&change, &arguments[2], |d, t| d * t), |a, d| a + d)
        }
        other => panic!("{other:?}"),
    }
}

/// A function of pairs of numbers; a single number goes with each of the others.
fn pairs(a: &[f64], b: &[f64], f: impl Fn(f64, f64) -> f64) -> Numbers {
    (0..a.len().max(b.len())).map(|i| f(a[i % a.len()], b[i % b.len()])).collect()
}
