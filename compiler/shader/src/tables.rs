//! What is too large for straight-line code and is read from a storage buffer.

use chiaro_plane::{Edge, Region};

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
            pieces.push(Piece { from: edge.start(), to: next.start(), arc });
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

    /// An outline: from and to of each piece; with arcs, also centre, sweep and 0. A line's sweep is 0.
    pub(crate) fn outline(&mut self, pieces: &[Piece]) -> Entries {
        let has_arcs = pieces.iter().any(|piece| piece.arc.is_some());
        self.entries(if has_arcs { 2 } else { 1 }, |rows| {
            for piece in pieces {
                let [from_x, from_y, to_x, to_y, center_x, center_y, sweep] = piece.numbers().map(single);
                rows.push([from_x, from_y, to_x, to_y]);
                if has_arcs {
                    rows.push([center_x, center_y, sweep, 0.0]);
                }
            }
        })
    }

    /// A polytope: the corners of each triangle.
    pub(crate) fn polytope(&mut self, triangles: &[[[f64; 3]; 3]]) -> Entries {
        self.entries(3, |rows| {
            rows.extend(triangles.iter().flatten().map(|&[x, y, z]| [x, y, z, 0.0].map(single)));
        })
    }

    fn entries(&mut self, rows_each: u32, add: impl FnOnce(&mut Vec<[f32; 4]>)) -> Entries {
        let first_row = self.tables.rows.len() as u32;
        add(&mut self.tables.rows);
        Entries { first_row, last_row: self.tables.rows.len() as u32, rows_each }
    }
}

/// The number in single precision. What is beyond 10¹⁸ becomes that, so that its square is finite; what is too small
/// for a normal number, and −0, become 0.
pub(crate) fn single(value: f64) -> f32 {
    const LIMIT: f64 = 1e18;
    let rounded = value.clamp(-LIMIT, LIMIT) as f32;
    if rounded.is_subnormal() || rounded == 0.0 { 0.0 } else { rounded }
}
