//! Outlines and polytopes: each a function of its own, however often it occurs, that reduces its pieces. It is unrolled
//! if they are few and otherwise a loop over a table.

use chiaro_plane::{Loft, Region, Side};
use chiaro_vocabulary::rows::{
    LOFT_LEVEL, LOFT_SIDE, OUTLINE_ARC, OUTLINE_END, OUTLINE_LINE, OUTLINE_START, POLYTOPE_END, POLYTOPE_START,
    POLYTOPE_TRIANGLE,
};
use naga::{
    AddressSpace, ArraySize, BinaryOperator, Expression, GlobalVariable, Handle, Literal, Span, Statement,
    StorageAccess, Type, TypeInner, VectorSize,
};

use super::{Emission, Scope};
use crate::bindings;
use crate::build::Value;
use crate::tables::{Blocks, Entries, Piece, pieces};

/// Outlines with more pieces are loops.
const MAX_UNROLLED_PIECES: usize = 48;
/// Polytopes with more triangles are loops.
const MAX_UNROLLED_TRIANGLES: usize = 24;
/// At most so many points of an outline are asked before its blocks.
const MOST_LANDMARKS: usize = 8;
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

/// The rows that a loop goes through.
struct Rows {
    first: Value,
    last: Value,
    each: u32,
}

/// What it is, and the bits of all its numbers.
pub(super) type Key = (Kind, Vec<u64>);

/// What is reduced from pieces.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    Outline,
    Loft,
    Polytope,
}

impl Scope<'_, '_> {
    /// The distance to a region.
    #[inline(never)]
    pub(super) fn outline(&mut self, region: &Region, point: Value) -> Value {
        let pieces = pieces(region);
        let key = (Kind::Outline, pieces.iter().flat_map(Piece::numbers).map(f64::to_bits).collect());
        let vec2 = self.emission.types.vec2;
        let comment = "// An outline that the scene draws.\n";
        self.call_pieces(point, key, ("region", vec2, comment), |scope| scope.outline_here(&pieces))
    }

    /// The distance to a polytope.
    #[inline(never)]
    pub(super) fn polytope(&mut self, triangles: &[[[f64; 3]; 3]], point: Value) -> Value {
        let key = (Kind::Polytope, triangles.iter().flatten().flatten().map(|number| number.to_bits()).collect());
        let vec3 = self.emission.types.vec3;
        let comment = "// A convex polytope of the scene.\n";
        self.call_pieces(point, key, ("hull", vec3, comment), |scope| scope.polytope_here(triangles))
    }

    /// The distance, within its level, to the section of stages with flat sides.
    #[inline(never)]
    pub(super) fn loft(&mut self, loft: &Loft, point: Value) -> Value {
        let key = (Kind::Loft, loft.numbers().map(f64::to_bits).collect());
        let vec3 = self.emission.types.vec3;
        let comment = "// The section, at its height, of a solid whose stages have flat sides.\n";
        self.call_pieces(point, key, ("stages", vec3, comment), |scope| scope.loft_here(loft))
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
            false => self.outline_in_blocks(start, point, pieces),
        };
        let distance = self.call(&OUTLINE_END, &[state]);
        self.name(distance, "distance")
    }

    /// The state behind all pieces, read from a table in blocks: those that are far count as one line each.
    fn outline_in_blocks(&mut self, start: Value, point: Value, pieces: &[Piece]) -> Value {
        let Blocks { blocks, header, rows_each } = self.emission.tables.outline(pieces);
        self.emission.check_tables();
        // Some points of the outline tell from the start which blocks are far.
        let every = pieces.len().div_ceil(MOST_LANDMARKS);
        let start = pieces.iter().step_by(every).fold(start, |state, piece| {
            let landmark = self.constants(&piece.from);
            let state = self.call(&OUTLINE_LINE, &[state, point, landmark, landmark]);
            self.name(state, "edges")
        });
        let all = self.rows_of(blocks);
        self.reduction(start, all, |scope, state, block| {
            let corners = scope.row(block, 0);
            let [low, high] = scope.halves(corners);
            let near = scope.call_named("outline_near", &[state, point, low, high]);
            let name = scope.emission.names.next("next");
            let next = scope.builder.variable(name, scope.builder.types.vec2, None);

            scope.builder.open();
            let first = scope.following(block, header);
            let last = scope.following(block, blocks.rows_each);
            let behind = scope.reduction(state, Rows { first, last, each: rows_each }, |scope, state, row| {
                let rows: Vec<Value> = (0..rows_each).map(|offset| scope.row(row, offset)).collect();
                scope.piece_of_rows(state, point, &rows)
            });
            scope.builder.store(next, behind);
            let accept = scope.builder.close();

            scope.builder.open();
            let ends = scope.row(block, 1);
            let [from, to] = scope.halves(ends);
            let behind = scope.call_named("outline_far", &[state, point, from, to]);
            scope.builder.store(next, behind);
            let reject = scope.builder.close();
            scope.builder.statement(Statement::If { condition: near, accept, reject });
            scope.builder.load(next)
        })
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
                let all = self.rows_of(entries);
                self.reduction(start, all, |scope, state, row| {
                    let [a, b, c] = [0, 1, 2].map(|offset| {
                        let corner = scope.row(row, offset);
                        scope.builder.truncate(corner, VectorSize::Tri)
                    });
                    scope.call(&POLYTOPE_TRIANGLE, &[state, point, a, b, c])
                })
            }
        };
        let distance = self.call(&POLYTOPE_END, &[state]);
        self.name(distance, "distance")
    }

    fn loft_here(&mut self, loft: &Loft) -> Value {
        let point = self.builder.argument();
        let z = self.builder.component(point, 2);
        let [height, count] = [self.constant(loft.height()), self.constant(loft.stages().len() as f64)];
        let level = self.call(&LOFT_LEVEL, &[z, height, count]);
        let level = self.name(level, "level");
        let t = self.builder.component(level, 1);
        let across = self.builder.truncate(point, VectorSize::Bi);
        let start = self.call(&OUTLINE_START, &[]);
        let start = self.name(start, "edges");
        let state = match loft.stages() {
            [only] => self.stage(start, across, t, only),
            stages => {
                let name = self.emission.names.next("next");
                let next = self.builder.variable(name, self.builder.types.vec2, None);
                self.builder.store(next, start);
                let here = self.builder.component(level, 0);
                for (index, sides) in stages.iter().enumerate() {
                    let number = self.constant(index as f64);
                    let condition = self.builder.binary(BinaryOperator::Equal, here, number);
                    self.builder.open();
                    let state = self.stage(start, across, t, sides);
                    self.builder.store(next, state);
                    let accept = self.builder.close();
                    self.builder.statement(Statement::If { condition, accept, reject: naga::Block::new() });
                }
                self.builder.load(next)
            }
        };
        let distance = self.call(&OUTLINE_END, &[state]);
        self.name(distance, "distance")
    }

    /// The state behind the sides of a stage.
    fn stage(&mut self, start: Value, point: Value, t: Value, sides: &[Side]) -> Value {
        if self.emission.unroll(sides.len(), MAX_UNROLLED_PIECES) {
            return sides.iter().fold(start, |state, side| {
                let [a_below, a_above] = side.from.map(|end| self.constants(&end));
                let [b_below, b_above] = side.to.map(|end| self.constants(&end));
                let state = self.call(&LOFT_SIDE, &[state, point, t, a_below, a_above, b_below, b_above]);
                self.name(state, "edges")
            });
        }
        let entries = self.emission.tables.stage(sides);
        self.emission.check_tables();
        let all = self.rows_of(entries);
        self.reduction(start, all, |scope, state, row| {
            let [from, to] = [0, 1].map(|offset| scope.row(row, offset));
            let ([a_below, a_above], [b_below, b_above]) = (scope.halves(from), scope.halves(to));
            scope.call(&LOFT_SIDE, &[state, point, t, a_below, a_above, b_below, b_above])
        })
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
        let [from, to] = self.halves(rows[0]);
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

    /// A loop that makes a new state from the state and the first row of each entry.
    fn reduction(
        &mut self,
        start: Value,
        Rows { first, last, each }: Rows,
        step: impl FnOnce(&mut Self, Value, Value) -> Value,
    ) -> Value {
        let row_name = self.emission.names.next("row");
        let row_variable = self.builder.variable(row_name, self.builder.types.index, None);
        self.builder.store(row_variable, first);
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
        let state = self.builder.load(state_variable);
        let next = step(self, state, row);
        self.builder.store(state_variable, next);
        let body = self.builder.close();

        self.builder.open();
        let row = self.builder.load(row_variable);
        let following = self.following(row, each);
        self.builder.store(row_variable, following);
        let continuing = self.builder.close();
        self.builder.statement(Statement::Loop { body, continuing, break_if: None });
        self.builder.load(state_variable)
    }

    /// All rows of the entries. The bounds are literals: software GPUs compile anew for each value of a bound that
    /// they read from a uniform.
    fn rows_of(&mut self, Entries { first_row, last_row, rows_each }: Entries) -> Rows {
        Rows { first: self.row_number(first_row), last: self.row_number(last_row), each: rows_each }
    }

    /// A row of the table, some behind another.
    fn row(&mut self, row: Value, offset: u32) -> Value {
        let variable = self.emission.tables_variable();
        let table = self.builder.add(Expression::GlobalVariable(variable));
        let index = self.following(row, offset);
        let pointer = self.builder.add(Expression::Access { base: table, index });
        self.builder.load(pointer)
    }

    /// The number of the row that is so many behind another.
    fn following(&mut self, row: Value, offset: u32) -> Value {
        if offset == 0 {
            return row;
        }
        let offset = self.row_number(offset);
        self.builder.binary(BinaryOperator::Add, row, offset)
    }

    fn row_number(&mut self, row: u32) -> Value {
        self.builder.add(Expression::Literal(Literal::U32(row)))
    }

    /// The first two and the last two numbers of a row.
    fn halves(&mut self, row: Value) -> [Value; 2] {
        [self.builder.truncate(row, VectorSize::Bi), self.builder.last_two(row)]
    }
}
