//! What is too large for straight-line code and is read from a storage buffer.

use chiaro_plane::{Edge, Region, Side};

/// The rows to upload to [`TABLES`](crate::bindings::TABLES), 16 bytes each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tables {
    /// The rows; none, if the module has no such binding.
    pub rows: Vec<[f32; 4]>,
}

/// An edge of an outline, whose end has the very coordinates that the next edge starts with.
pub(crate) struct Piece {
    pub(crate) from: [f64; 2],
    pub(crate) to: [f64; 2],
    /// The centre and the sweep in radians of an arc.
    pub(crate) arc: Option<([f64; 2], f64)>,
    /// The corners of the box around it.
    bounds: ([f64; 2], [f64; 2]),
}

impl Piece {
    /// All that it consists of; a line has no sweep.
    pub(crate) fn numbers(&self) -> [f64; 7] {
        let (center, sweep) = self.arc.unwrap_or(([0.0; 2], 0.0));
        [self.from[0], self.from[1], self.to[0], self.to[1], center[0], center[1], sweep]
    }
}

/// The edges of all contours.
pub(crate) fn pieces(region: &Region) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for contour in &region.contours {
        for (index, edge) in contour.edges.iter().enumerate() {
            let next = &contour.edges[(index + 1) % contour.edges.len()];
            let arc = match *edge {
                Edge::Line { .. } => None,
                Edge::Arc { center, sweep, .. } => Some((center, sweep)),
            };
            pieces.push(Piece { from: edge.start(), to: next.start(), arc, bounds: edge.bounds() });
        }
    }
    pieces
}

/// A range of rows, several of which make one entry.
#[derive(Clone, Copy)]
pub(crate) struct Entries {
    pub(crate) first_row: u32,
    pub(crate) last_row: u32,
    pub(crate) rows_each: u32,
}

/// An outline in a table: blocks of as many entries each.
#[derive(Clone, Copy)]
pub(crate) struct Blocks {
    pub(crate) blocks: Entries,
    /// How many rows of a block stand before its entries.
    pub(crate) header: u32,
    /// The rows of each entry.
    pub(crate) rows_each: u32,
}

/// Fills [`Tables`].
#[derive(Default)]
pub(crate) struct TablesBuilder {
    tables: Tables,
}

impl TablesBuilder {
    /// The tables with all that was added.
    pub(crate) fn finish(self) -> Tables {
        self.tables
    }

    /// The number of rows so far.
    pub(crate) fn len(&self) -> usize {
        self.tables.rows.len()
    }

    /// An outline in blocks of successive pieces. A block starts with the box around its pieces and with where they
    /// start and end. Then come from and to of each piece; with arcs, also centre, sweep and 0. A line's sweep is 0.
    /// Short blocks are filled with lines that stay where the block ends.
    pub(crate) fn outline(&mut self, pieces: &[Piece]) -> Blocks {
        const HEADER: u32 = 2;
        let rows_each = if pieces.iter().any(|piece| piece.arc.is_some()) { 2 } else { 1 };
        let paths: Vec<&[Piece]> = pieces.chunk_by(|piece, next| piece.to == next.from).collect();
        let size = block_size(pieces.len(), paths.len());
        let blocks = self.entries(HEADER + size as u32 * rows_each, |rows| {
            for block in paths.into_iter().flat_map(|path| path.chunks(size)) {
                let (start, end) = (block[0].from, block[block.len() - 1].to);
                rows.push(box_around(block));
                rows.push([start[0], start[1], end[0], end[1]].map(single));
                let filling = Piece { from: end, to: end, arc: None, bounds: (end, end) };
                for piece in block.iter().chain(std::iter::repeat_n(&filling, size - block.len())) {
                    let [from_x, from_y, to_x, to_y, center_x, center_y, sweep] = piece.numbers().map(single);
                    rows.push([from_x, from_y, to_x, to_y]);
                    if rows_each == 2 {
                        rows.push([center_x, center_y, sweep, 0.0]);
                    }
                }
            }
        });
        Blocks { blocks, header: HEADER, rows_each }
    }

    /// A polytope: the corners of each triangle.
    pub(crate) fn polytope(&mut self, triangles: &[[[f64; 3]; 3]]) -> Entries {
        self.entries(3, |rows| {
            rows.extend(triangles.iter().flatten().map(|&[x, y, z]| [x, y, z, 0.0].map(single)));
        })
    }

    /// One stage of a loft: where each side starts, below and above, and where it ends.
    pub(crate) fn stage(&mut self, sides: &[Side]) -> Entries {
        self.entries(2, |rows| {
            let row = |[below, above]: [[f64; 2]; 2]| [below[0], below[1], above[0], above[1]].map(single);
            rows.extend(sides.iter().flat_map(|side| [row(side.from), row(side.to)]));
        })
    }

    fn entries(&mut self, rows_each: u32, add: impl FnOnce(&mut Vec<[f32; 4]>)) -> Entries {
        let first_row = self.tables.rows.len() as u32;
        add(&mut self.tables.rows);
        Entries { first_row, last_row: self.tables.rows.len() as u32, rows_each }
    }
}

/// How many pieces of an outline make one block: from afar each block costs as much as a piece, and from nearby a few
/// blocks cost all their pieces. Contours of fewer pieces fill no block.
fn block_size(pieces: usize, paths: usize) -> usize {
    pieces.isqrt().min(pieces / paths.max(1)).max(1)
}

/// The box around pieces, which rounding makes no smaller.
fn box_around(pieces: &[Piece]) -> [f32; 4] {
    let least = |axis: usize| pieces.iter().map(|piece| piece.bounds.0[axis]).fold(f64::INFINITY, f64::min);
    let greatest = |axis: usize| pieces.iter().map(|piece| piece.bounds.1[axis]).fold(f64::NEG_INFINITY, f64::max);
    let outwards = |low: f64, high: f64| (single(low).next_down(), single(high).next_up());
    let ((low_x, high_x), (low_y, high_y)) = (outwards(least(0), greatest(0)), outwards(least(1), greatest(1)));
    [low_x, low_y, high_x, high_y]
}

/// The number in single precision. What is beyond 10¹⁸ becomes that, so that its square is finite; what is too small
/// for a normal number, and −0, become 0.
pub fn single(value: f64) -> f32 {
    const LIMIT: f64 = 1e18;
    let rounded = value.clamp(-LIMIT, LIMIT) as f32;
    if rounded.is_subnormal() || rounded == 0.0 { 0.0 } else { rounded }
}
