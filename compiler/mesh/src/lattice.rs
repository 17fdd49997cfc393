//! The cubic lattice that a surface is looked for in.

use chiaro_field::Bounds;

/// A point of the lattice, or the cell of which it is the least corner.
pub(crate) type Site = [u32; 3];

/// The most cells along a side: sites have to fit into keys.
pub(crate) const MOST_CELLS: u32 = 1 << 20;

/// How far the lattice is shifted against the box, in cells along each axis: faces that stand where the scene's
/// numbers say should not lie in the planes of lattice points.
const SHIFT: [f64; 3] = [0.137, 0.271, 0.419];

/// Points at equal steps, around a box with a cell to spare.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lattice {
    origin: [f64; 3],
    /// The length of a cell's edges, in millimetres.
    pub(crate) step: f64,
    /// How many cells there are along each axis.
    pub(crate) cells: [u32; 3],
}

impl Lattice {
    /// Around this box, finite and not empty, with so many cells along its longest side.
    pub(crate) fn around(bounds: &Bounds, resolution: u32) -> Self {
        let size = bounds.size();
        let step = size.iter().fold(0.0, |longest: f64, side| longest.max(*side)) / f64::from(resolution);
        let origin = std::array::from_fn(|axis| bounds.min[axis] - (1.0 + SHIFT[axis]) * step);
        let cells = std::array::from_fn(|axis| (size[axis] / step + 2.0 + SHIFT[axis]).ceil() as u32);
        Self { origin, step, cells }
    }

    /// Where the site is.
    pub(crate) fn point(&self, site: Site) -> [f64; 3] {
        std::array::from_fn(|axis| self.origin[axis] + self.step * f64::from(site[axis]))
    }

    /// The centre of the site's cell.
    pub(crate) fn center(&self, site: Site) -> [f64; 3] {
        self.point(site).map(|coordinate| coordinate + 0.5 * self.step)
    }

    /// The cell that a point is in.
    pub(crate) fn cell(&self, point: [f64; 3]) -> Option<Site> {
        let place: [f64; 3] = std::array::from_fn(|axis| ((point[axis] - self.origin[axis]) / self.step).floor());
        let is_in = (0..3).all(|axis| place[axis] >= 0.0 && place[axis] < f64::from(self.cells[axis]));
        is_in.then(|| place.map(|coordinate| coordinate as u32))
    }

    /// Whether the cell is one of the lattice's.
    pub(crate) fn has(&self, site: Site) -> bool {
        (0..3).all(|axis| site[axis] < self.cells[axis])
    }
}

/// The site as one number.
pub(crate) fn key([x, y, z]: Site) -> u64 {
    u64::from(x) | u64::from(y) << 21 | u64::from(z) << 42
}

/// The site of that number.
pub(crate) fn site(key: u64) -> Site {
    [0, 21, 42].map(|shift| (key >> shift & 0x1f_ffff) as u32)
}

/// The corner of a cell whose number has a bit set for each axis along which it is the greater one.
pub(crate) fn corner(cell: Site, number: u32) -> Site {
    std::array::from_fn(|axis| cell[axis] + (number >> axis & 1))
}
