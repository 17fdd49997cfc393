//! Frames: one map for each member of a series, behind which all its shapes are where those of the others are.

use chiaro_solid::Affine;

use crate::matrix::{self, constant_rows};
use crate::pattern::LocalMap;

/// A constant map: the rows of a matrix.
type Map = [[f64; 4]; 3];

/// How far from each other two maps may bring a point: a part of how far they bring it from the origin.
const TOLERANCE: f64 = 1e-10;

/// The frame of a series' first member.
pub(super) struct Frame {
    /// From the frame to where each shape is asked.
    pub(super) maps: Vec<Affine>,
    /// The map that tells how the frame is turned: the first one that is not only of round shapes, if there is one.
    lead: usize,
    /// From where the leading shape is asked to the frame.
    from_lead: Map,
}

impl Frame {
    /// The frame of a member with these maps, which is that of its leading shape; none, if it has several and they are live, or
    /// have no inverse.
    pub(super) fn of(maps: &[LocalMap]) -> Option<Self> {
        match maps {
            [_] => Some(Self { maps: vec![Affine::identity()], lead: 0, from_lead: IDENTITY }),
            _ => Self::from(maps, &inverse(&constant_rows(&maps.get(lead(maps))?.map)?)?),
        }
    }

    /// The frame of the first of several members that are all like it: if they are moved only, it is turned as its base, with the
    /// origin where the leading shape has its own.
    pub(super) fn of_all<'m>(maps: &[LocalMap], mut others: impl Iterator<Item = &'m [LocalMap]>) -> Option<Self> {
        let lead = lead(maps);
        let turn = |maps: &[LocalMap]| constant_rows(&maps[lead].map).map(|rows| linear(&rows));
        let first = turn(maps);
        let is_moved = |other: &[LocalMap]| matches!((first, turn(other)), (Some(a), Some(b)) if is_close(&a, &b));
        if !others.all(is_moved) {
            return Self::of(maps);
        }
        let to_base = inverse(&constant_rows(&maps[lead].map)?)?;
        Self::from(maps, &moved([0, 1, 2].map(|axis| to_base[axis][3])))
    }

    /// The frame of constant maps that is `to_base` away from the base.
    fn from(maps: &[LocalMap], to_base: &Map) -> Option<Self> {
        let lead = lead(maps);
        let to_frame = inverse(to_base)?;
        let from_lead = after(&to_frame, &inverse(&constant_rows(&maps[lead].map)?)?);
        let local = maps.iter().map(|map| Some(Affine::constant(tidied(localised(map, to_base, &to_frame)?))));
        Some(Self { maps: local.collect::<Option<Vec<Affine>>>()?, lead, from_lead })
    }

    /// The map of a member with these maps, from the base to the frame.
    pub(super) fn of_member(&self, maps: &[LocalMap]) -> Affine {
        match constant_rows(&maps[self.lead].map) {
            Some(rows) => Affine::constant(tidied(after(&self.from_lead, &rows))),
            // The frame is the leading shape's, which has no other beside it.
            None => maps[self.lead].map.clone(),
        }
    }

    /// Where a member's shapes are in its own frame: where those of the first are but moved, by so much more or less along each
    /// axis, three numbers for each map; none, if they are turned or stretched otherwise.
    pub(super) fn shifts(&self, maps: &[LocalMap]) -> Option<Vec<f64>> {
        if maps.len() < 2 {
            return Some(vec![0.0; 3 * maps.len()]);
        }
        let to_frame = constant_rows(&self.of_member(maps))?;
        let to_base = inverse(&to_frame)?;
        let shifts = self.maps.iter().zip(maps).map(|(own, map)| {
            let (own, map) = (constant_rows(own)?, localised(map, &to_base, &to_frame)?);
            is_close(&linear(&own), &linear(&map)).then(|| shifted(&own, &map))
        });
        Some(shifts.collect::<Option<Vec<[f64; 3]>>>()?.concat())
    }
}

fn lead(maps: &[LocalMap]) -> usize {
    maps.iter().position(|map| !map.is_round).unwrap_or(0)
}

/// A constant map from the base as one from a frame. Round shapes are not turned with it.
fn localised(LocalMap { map, is_round }: &LocalMap, to_base: &Map, to_frame: &Map) -> Option<Map> {
    let map = constant_rows(map)?;
    if !is_round || linear(&map) != IDENTITY {
        return Some(after(&map, to_base));
    }
    let center = map.map(|row| -row[3]);
    let local = to_frame.map(|[x, y, z, shift]| x * center[0] + y * center[1] + z * center[2] + shift);
    Some(moved(local.map(|coordinate| -coordinate)))
}

/// A map without what it moves by.
fn linear(map: &Map) -> Map {
    map.map(|[x, y, z, _]| [x, y, z, 0.0])
}

/// By how much more one map moves than another, but for rounding.
fn shifted(map: &Map, other: &Map) -> [f64; 3] {
    let farthest = map.iter().chain(other).map(|row| row[3].abs()).fold(1.0, f64::max);
    [0, 1, 2]
        .map(|axis| other[axis][3] - map[axis][3])
        .map(|by| if by.abs() <= TOLERANCE * farthest { 0.0 } else { by })
}

const IDENTITY: Map = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

/// `outer` of `inner`.
fn after(outer: &Map, inner: &Map) -> Map {
    let entry = |i: usize, j: usize| {
        let shift = if j == 3 { outer[i][3] } else { 0.0 };
        (0..3).map(|k| outer[i][k] * inner[k][j]).sum::<f64>() + shift
    };
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

fn inverse(map: &Map) -> Option<Map> {
    let inverse = matrix::inverse(map);
    inverse.iter().flatten().all(|entry| entry.is_finite()).then_some(inverse)
}

fn moved(by: [f64; 3]) -> Map {
    std::array::from_fn(|i| std::array::from_fn(|j| if j == 3 { by[i] } else { f64::from(i == j) }))
}

/// The map without what rounding left where there should be nothing, or a whole number.
fn tidied(map: Map) -> Map {
    let farthest = map.iter().map(|row| row[3].abs()).fold(1.0, f64::max);
    let tidy = |entry: f64, scale: f64| match entry.round() {
        whole if (entry - whole).abs() < 1e-14 * scale => whole,
        _ => entry,
    };
    map.map(|[x, y, z, shift]| [tidy(x, 1.0), tidy(y, 1.0), tidy(z, 1.0), tidy(shift, farthest)])
}

fn is_close(one: &Map, other: &Map) -> bool {
    let farthest = one.iter().chain(other).map(|row| row[3].abs()).fold(1.0, f64::max);
    one.iter().zip(other).all(|(one, other)| {
        let linear = (0..3).all(|j| (one[j] - other[j]).abs() <= TOLERANCE);
        linear && (one[3] - other[3]).abs() <= TOLERANCE * farthest
    })
}
