//! Outlines and polytopes: each a function of its own, however often it occurs, that reduces its pieces. It is unrolled
//! if they are few and otherwise a loop over a table.

use chiaro_plane::Region;
use chiaro_vocabulary::rows::{
    OUTLINE_ARC, OUTLINE_END, OUTLINE_LINE, OUTLINE_START, POLYTOPE_END, POLYTOPE_START, POLYTOPE_TRIANGLE,
};
use naga::{
    AddressSpace, ArraySize, BinaryOperator, Expression, GlobalVariable, Handle, Literal, Span, Statement,
    StorageAccess, Type, TypeInner, VectorSize,
};

use super::{Emission, Scope};
use crate::bindings;
use crate::build::Value;
use crate::tables::{Entries, Piece, pieces};

/// Outlines with more pieces are loops.
const MAX_UNROLLED_PIECES: usize = 48;
/// Polytopes with more triangles are loops.
const MAX_UNROLLED_TRIANGLES: usize = 24;
/// When a module has this many pieces in straight-line code, all further ones are loops.
const MAX_UNROLLED_IN_MODULE: usize = 4096;
/// The most rows of tables: 64 MiB, half of what every device allows of a storage buffer.
const MAX_ROWS: usize = 1 << 22;

impl Emission<'_> {
    /// The storage buffer of tables, declared when it is first used.
    fn tables_variable(&mut self) -> Handle<GlobalVariable> {
        if let Some(variable) = self.tables_variable {
            return variable;
        }
        let inner = TypeInner::Array { base: self.types.vec4, size: ArraySize::Dynamic, stride: 16 };
        let module = self.linker.module();
        let ty = module.types.insert(Type { name: None, inner }, Span::UNDEFINED);
        let variable = module.global_variables.append(
            GlobalVariable {
                name: Some("tables".to_string()),
                space: AddressSpace::Storage { access: StorageAccess::LOAD },
                binding: Some(bindings::TABLES),
                ty,
                init: None,
                memory_decorations: naga::MemoryDecorations::empty(),
            },
            Span::UNDEFINED,
        );
        self.tables_variable = Some(variable);
        variable
    }

    /// Whether so many pieces are to be unrolled; then they count.
    fn unroll(&mut self, count: usize, most: usize) -> bool {
        let unroll = count <= most && self.unrolled + count <= MAX_UNROLLED_IN_MODULE;
        if unroll {
            self.unrolled += count;
        }
        unroll
    }

    fn check_tables(&mut self) {
        if self.tables.len() > MAX_ROWS {
            self.fail("the outlines and polytopes of this scene have too many edges for one shader");
        }
    }
}

/// The number of coordinates and the bits of all numbers of an outline or a polytope.
pub(super) type Key = (usize, Vec<u64>);

impl Scope<'_, '_> {
    /// The distance to a region.
    pub(super) fn outline(&mut self, region: &Region, point: Value) -> Value {
        let pieces = pieces(region);
        let key = (2, pieces.iter().flat_map(Piece::numbers).map(f64::to_bits).collect());
        let vec2 = self.emission.types.vec2;
        let comment = "// An outline that the scene draws.\n";
        self.call_pieces(point, key, ("region", vec2, comment), |scope| scope.outline_here(&pieces))
    }

    /// The distance to a polytope.
    pub(super) fn polytope(&mut self, triangles: &[[[f64; 3]; 3]], point: Value) -> Value {
        let key = (3, triangles.iter().flatten().flatten().map(|number| number.to_bits()).collect());
        let vec3 = self.emission.types.vec3;
        let comment = "// A convex polytope of the scene.\n";
        self.call_pieces(point, key, ("hull", vec3, comment), |scope| scope.polytope_here(triangles))
    }

    /// Calls the function for pieces with that key, which is emitted, as described, if it does not exist.
    fn call_pieces(
        &mut self,
        point: Value,
        key: Key,
        (prefix, point_type, comment): (&'static str, Handle<Type>, &'static str),
        emit: impl FnOnce(&mut Scope) -> Value,
    ) -> Value {
        let function = match self.emission.pieces.get(&key) {
            Some(&function) => function,
            None => {
                let name = self.emission.names.next(prefix);
                let float = self.emission.types.float;
                let mut scope = Scope::of_point(self.emission, &name, point_type, float);
                let value = emit(&mut scope);
                let function = scope.finish(value);
                let function = self.emission.define(function, comment);
                self.emission.pieces.insert(key, function);
                function
            }
        };
        self.builder.call(function, &[point])
    }

    fn outline_here(&mut self, pieces: &[Piece]) -> Value {
        let point = self.builder.argument();
        let start = self.call(&OUTLINE_START, &[]);
        let start = self.name(start, "edges");
        let state = match self.emission.unroll(pieces.len(), MAX_UNROLLED_PIECES) {
            true => pieces.iter().fold(start, |state, piece| self.piece(state, point, piece)),
            false => {
                let entries = self.emission.tables.outline(pieces);
                self.emission.check_tables();
                self.reduction(start, entries, |scope, state, rows| scope.piece_of_rows(state, point, rows))
            }
        };
        let distance = self.call(&OUTLINE_END, &[state]);
        self.name(distance, "distance")
    }

    fn polytope_here(&mut self, triangles: &[[[f64; 3]; 3]]) -> Value {
        let point = self.builder.argument();
        let start = self.call(&POLYTOPE_START, &[]);
        let start = self.name(start, "faces");
        let state = match self.emission.unroll(triangles.len(), MAX_UNROLLED_TRIANGLES) {
            true => triangles.iter().fold(start, |state, corners| {
                let [a, b, c] = corners.each_ref().map(|corner| self.constants(corner));
                let state = self.call(&POLYTOPE_TRIANGLE, &[state, point, a, b, c]);
                self.name(state, "faces")
            }),
            false => {
                let entries = self.emission.tables.polytope(triangles);
                self.emission.check_tables();
                self.reduction(start, entries, |scope, state, rows| {
                    let corner = |row: &Value| scope.builder.truncate(*row, VectorSize::Tri);
                    let [a, b, c] = [&rows[0], &rows[1], &rows[2]].map(corner);
                    scope.call(&POLYTOPE_TRIANGLE, &[state, point, a, b, c])
                })
            }
        };
        let distance = self.call(&POLYTOPE_END, &[state]);
        self.name(distance, "distance")
    }

    /// The state behind one piece of an outline.
    fn piece(&mut self, state: Value, point: Value, piece: &Piece) -> Value {
        let [from, to] = [piece.from, piece.to].map(|end| self.constants(&end));
        let state = match piece.arc {
            None => self.call(&OUTLINE_LINE, &[state, point, from, to]),
            Some((center, sweep)) => {
                let [center, sweep] = [self.constants(&center), self.constant(sweep)];
                self.call(&OUTLINE_ARC, &[state, point, from, to, center, sweep])
            }
        };
        self.name(state, "edges")
    }

    /// The state behind the piece in these rows of the table.
    fn piece_of_rows(&mut self, state: Value, point: Value, rows: &[Value]) -> Value {
        let from = self.builder.truncate(rows[0], VectorSize::Bi);
        let to = self.builder.last_two(rows[0]);
        let Some(&arc) = rows.get(1) else {
            return self.call(&OUTLINE_LINE, &[state, point, from, to]);
        };
        let name = self.emission.names.next("next");
        let next = self.builder.variable(name, self.builder.types.vec2, None);
        let sweep = self.builder.component(arc, 2);
        let zero = self.builder.literal(0.0);
        let is_line = self.builder.binary(BinaryOperator::Equal, sweep, zero);
        self.builder.open();
        let line = self.call(&OUTLINE_LINE, &[state, point, from, to]);
        self.builder.store(next, line);
        let accept = self.builder.close();
        self.builder.open();
        let center = self.builder.truncate(arc, VectorSize::Bi);
        let curve = self.call(&OUTLINE_ARC, &[state, point, from, to, center, sweep]);
        self.builder.store(next, curve);
        let reject = self.builder.close();
        self.builder.statement(Statement::If { condition: is_line, accept, reject });
        self.builder.load(next)
    }

    /// A loop that makes a new state from the state and each entry's rows. Its bounds are literals: software GPUs
    /// compile anew for each value of a bound that they read from a uniform.
    fn reduction(
        &mut self,
        start: Value,
        entries: Entries,
        step: impl FnOnce(&mut Self, Value, &[Value]) -> Value,
    ) -> Value {
        let row_literal = |scope: &mut Self, row| scope.builder.add(Expression::Literal(Literal::U32(row)));
        let first = row_literal(self, entries.first_row);
        let last = row_literal(self, entries.last_row);
        let each = row_literal(self, entries.rows_each);
        let variable = self.emission.tables_variable();
        let table = self.builder.add(Expression::GlobalVariable(variable));
        let row_name = self.emission.names.next("row");
        let row_variable = self.builder.variable(row_name, self.builder.types.index, Some(first));
        let state_name = self.emission.names.next("state");
        let state_variable = self.builder.variable(state_name, self.builder.types.vec2, None);
        self.builder.store(state_variable, start);

        self.builder.open();
        let row = self.builder.load(row_variable);
        let done = self.builder.binary(BinaryOperator::GreaterEqual, row, last);
        self.builder.open();
        self.builder.statement(Statement::Break);
        let accept = self.builder.close();
        self.builder.statement(Statement::If { condition: done, accept, reject: naga::Block::new() });
        let rows: Vec<Value> = (0..entries.rows_each).map(|offset| self.row(table, row, offset)).collect();
        let state = self.builder.load(state_variable);
        let next = step(self, state, &rows);
        self.builder.store(state_variable, next);
        let body = self.builder.close();

        self.builder.open();
        let following = self.builder.binary(BinaryOperator::Add, row, each);
        self.builder.store(row_variable, following);
        let continuing = self.builder.close();
        self.builder.statement(Statement::Loop { body, continuing, break_if: None });
        self.builder.load(state_variable)
    }

    /// A row of the table.
    fn row(&mut self, table: Value, row: Value, offset: u32) -> Value {
        let index = match offset {
            0 => row,
            _ => {
                let offset = self.builder.add(Expression::Literal(Literal::U32(offset)));
                self.builder.binary(BinaryOperator::Add, row, offset)
            }
        };
        let pointer = self.builder.add(Expression::Access { base: table, index });
        self.builder.load(pointer)
    }
}
