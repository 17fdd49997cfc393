//! How a surface goes through one cell, from which of the cell's corners are inside.
//!
//! On each face of a cell the surface is one or two segments between crossed edges; together they close to cycles, each
//! of them a sheet of the surface, for which the mesh has one vertex. Neighbours have to agree on the faces where two
//! pairs of opposite corners alternate. There inside corners are kept apart, except where the two segments would belong
//! to one sheet in both cells: then two vertices would be joined by two edges. Joining the corners instead makes two
//! sheets in either cell.

use std::sync::LazyLock;

/// The edges of a cell: along axis a, at b and c (the axes that follow a in turn) its number is 4 a + b + 2 c.
pub(crate) const EDGES: usize = 12;

/// The sheets of the surface in a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cycles {
    /// The number of the cycle that each edge is in; meaningless where the surface does not cross the edge.
    pub(crate) of_edge: [u8; EDGES],
    /// How many there are.
    pub(crate) count: u8,
}

impl Cycles {
    /// The sheets in a cell, of whose corners these are inside. On the faces of the set `joined`, the inside corners
    /// are joined where faces alternate.
    pub(crate) fn new(inside: u8, joined: u8) -> Self {
        if joined == 0 { APART[inside as usize] } else { trace(inside, joined) }
    }
}

/// The faces, as bits 2 axis + side, on which corners alternate and both segments are of one sheet while inside corners
/// are kept apart.
pub(crate) fn doubled_faces(inside: u8) -> u8 {
    DOUBLED[inside as usize]
}

static APART: LazyLock<[Cycles; 256]> = LazyLock::new(|| std::array::from_fn(|inside| trace(inside as u8, 0)));

static DOUBLED: LazyLock<[u8; 256]> = LazyLock::new(|| {
    std::array::from_fn(|inside| {
        let cycles = &APART[inside];
        let is_doubled = |face: &u8| {
            let face = Face::new(*face);
            let first = cycles.of_edge[face.edges[0]];
            face.alternates(inside as u8) && face.edges.iter().all(|edge| cycles.of_edge[*edge] == first)
        };
        (0..6).filter(is_doubled).fold(0, |faces, face| faces | 1 << face)
    })
});

/// A face of a cell: its corners in turn, and the edges from each to the next.
struct Face {
    corners: [u8; 4],
    edges: [usize; 4],
}

impl Face {
    fn new(number: u8) -> Self {
        let (a, side) = (usize::from(number / 2), number % 2);
        let (b, c) = ((a + 1) % 3, (a + 2) % 3);
        let corner = |at_b: u8, at_c: u8| side << a | at_b << b | at_c << c;
        let edge = |axis: usize, corner: u8| {
            let at = |axis: usize| usize::from(corner >> (axis % 3) & 1);
            4 * axis + at(axis + 1) + 2 * at(axis + 2)
        };
        let corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
        let edges = [edge(b, corners[0]), edge(c, corners[1]), edge(b, corners[3]), edge(c, corners[0])];
        Self { corners, edges }
    }

    fn insides(&self, inside: u8) -> [bool; 4] {
        self.corners.map(|corner| inside >> corner & 1 == 1)
    }

    fn alternates(&self, inside: u8) -> bool {
        let [first, second, third, fourth] = self.insides(inside);
        first == third && second == fourth && first != second
    }

    /// The pairs of edges that segments join.
    fn segments(&self, inside: u8, joined: bool) -> Vec<[usize; 2]> {
        let insides = self.insides(inside);
        if self.alternates(inside) {
            // Each segment cuts off one corner: an inside one, or an outside one if the inside ones are joined.
            let cut_off = (0..4).filter(|corner| insides[*corner] != joined);
            return cut_off.map(|corner| [self.edges[(corner + 3) % 4], self.edges[corner]]).collect();
        }
        let crossed: Vec<usize> =
            (0..4).filter(|edge| insides[*edge] != insides[(edge + 1) % 4]).map(|edge| self.edges[edge]).collect();
        crossed.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
    }
}

fn trace(inside: u8, joined: u8) -> Cycles {
    let mut leader: [usize; EDGES] = std::array::from_fn(|edge| edge);
    let mut crossed = [false; EDGES];
    for number in 0..6 {
        for [one, other] in Face::new(number).segments(inside, joined >> number & 1 == 1) {
            (crossed[one], crossed[other]) = (true, true);
            let (kept, merged) = (leader[one].min(leader[other]), leader[one].max(leader[other]));
            leader.iter_mut().filter(|edge| **edge == merged).for_each(|edge| *edge = kept);
        }
    }
    let mut cycles = Cycles { of_edge: [u8::MAX; EDGES], count: 0 };
    for edge in (0..EDGES).filter(|edge| crossed[*edge]) {
        if leader[edge] == edge {
            cycles.of_edge[edge] = cycles.count;
            cycles.count += 1;
        } else {
            cycles.of_edge[edge] = cycles.of_edge[leader[edge]];
        }
    }
    cycles
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Joining the corners of one face changes nothing on others, since a doubled face is the only one that alternates.
    #[test]
    fn a_doubled_face_is_alone_and_joining_its_corners_mends_it() {
        let mut seen = 0;
        for inside in 0..=255u8 {
            let doubled = doubled_faces(inside);
            if doubled == 0 {
                continue;
            }
            seen += 1;
            let alternating = (0..6).filter(|face| Face::new(*face).alternates(inside)).count();
            assert_eq!((alternating, doubled.count_ones()), (1, 1), "{inside:08b}");
            let face = Face::new(doubled.trailing_zeros() as u8);
            let mended = Cycles::new(inside, doubled);
            let mut sheets = face.edges.map(|edge| mended.of_edge[edge]);
            sheets.sort_unstable();
            assert!(sheets[0] == sheets[1] && sheets[1] != sheets[2] && sheets[2] == sheets[3], "{inside:08b}");
        }
        assert_eq!(seen, 36);
    }

    #[test]
    fn sheets_are_counted() {
        assert_eq!(Cycles::new(0, 0).count, 0);
        assert_eq!(Cycles::new(0b0000_0001, 0).count, 1);
        assert_eq!(Cycles::new(0b1000_0001, 0).count, 2); // opposite corners
        assert_eq!(Cycles::new(0b0110_1001, 0).count, 4); // every other corner
        assert_eq!(Cycles::new(0b0000_1111, 0).count, 1);
    }
}
