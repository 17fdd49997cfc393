//! Numbers: literals; live ones from the uniform, or from the row of a crowd's member; and arguments of a series' pattern.

use std::num::NonZeroU32;

use chiaro_field::Graph;
use chiaro_solid::Scalar;
use naga::{
    AddressSpace, ArraySize, BinaryOperator, Expression, GlobalVariable, Handle, Literal, Span, Type, TypeInner,
};
use rustc_hash::FxHashMap;

use super::{Emission, Scope};
use crate::bindings;
use crate::build::Value;
use crate::tables::single;

/// The most live numbers: what fits into 16 KiB, which is what every device allows of a uniform buffer.
pub(super) const MAX_LIVE: usize = 4096;

/// The place of each live number.
pub(super) fn slots(graph: &Graph) -> FxHashMap<&Scalar, usize> {
    graph.slots.iter().enumerate().map(|(slot, scalar)| (scalar, slot)).collect()
}

impl Emission<'_> {
    /// The uniform variable of live numbers, declared when the first one is used.
    fn declared_live(&mut self) -> Handle<GlobalVariable> {
        if let Some(variable) = self.live_variable {
            return variable;
        }
        let length = NonZeroU32::new(self.slots.len().div_ceil(4) as u32).unwrap_or(NonZeroU32::MIN);
        let inner = TypeInner::Array { base: self.types.vec4, size: ArraySize::Constant(length), stride: 16 };
        let module = self.linker.module();
        let ty = module.types.insert(Type { name: None, inner }, Span::UNDEFINED);
        let variable = module.global_variables.append(
            GlobalVariable {
                name: Some("live".to_string()),
                space: AddressSpace::Uniform,
                binding: Some(bindings::LIVE),
                ty,
                init: None,
                memory_decorations: naga::MemoryDecorations::empty(),
            },
            Span::UNDEFINED,
        );
        self.live_variable = Some(variable);
        variable
    }
}

impl Scope<'_, '_> {
    /// A number.
    pub(super) fn scalar(&mut self, scalar: &Scalar) -> Value {
        match scalar.constant() {
            Some(value) => self.constant(value),
            None => self.live(scalar),
        }
    }

    /// A constant. NaN is an error.
    pub(super) fn constant(&mut self, value: f64) -> Value {
        if value.is_nan() {
            self.emission.fail("a number of this shape is not a number (nan)");
            return self.builder.literal(0.0);
        }
        self.builder.literal(single(value))
    }

    /// A vector of two to four numbers.
    pub(super) fn vector(&mut self, scalars: &[Scalar]) -> Value {
        let components: Vec<Value> = scalars.iter().map(|scalar| self.scalar(scalar)).collect();
        self.builder.vector(&components)
    }

    /// A vector of two to four constants.
    pub(super) fn constants(&mut self, values: &[f64]) -> Value {
        let components: Vec<Value> = values.iter().map(|value| self.constant(*value)).collect();
        self.builder.vector(&components)
    }

    fn live(&mut self, scalar: &Scalar) -> Value {
        if let Some(&told) = self.told.get(scalar) {
            return told;
        }
        let Some(&slot) = self.emission.slots.get(scalar) else {
            self.emission.fail("a live number of this shape has no slot in the field graph");
            return self.builder.literal(0.0);
        };
        if let Some(&value) = self.live.get(&slot) {
            return value;
        }
        let value = match self.row {
            Some(row) => self.number_of_row(row, slot),
            None => self.live_number(slot),
        };
        let value = self.name(value, "live");
        self.live.insert(slot, value);
        value
    }

    /// A live number from the uniform.
    fn live_number(&mut self, slot: usize) -> Value {
        let variable = self.emission.declared_live();
        let array = self.builder.add(Expression::GlobalVariable(variable));
        let vector = self.builder.component(array, slot as u32 / 4);
        let pointer = self.builder.component(vector, slot as u32 % 4);
        self.builder.load(pointer)
    }

    /// A number of a crowd's member.
    fn number_of_row(&mut self, row: Value, slot: usize) -> Value {
        let quadruple = slot / 4;
        let numbers = match self.row_numbers.get(&quadruple) {
            Some(&known) => known,
            None => {
                let offset = self.builder.add(Expression::Literal(Literal::U32(quadruple as u32)));
                let place = self.builder.binary(BinaryOperator::Add, row, offset);
                let numbers = self.call_named("crowd_numbers", &[place]);
                self.row_numbers.insert(quadruple, numbers);
                numbers
            }
        };
        self.builder.component(numbers, slot as u32 % 4)
    }
}
