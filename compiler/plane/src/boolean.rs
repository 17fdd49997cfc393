//! Boolean operations on regions.
//!
//! They run on chords in exact integer arithmetic; afterwards the arcs the chords came from are put back (see
//! `recover`), so that results are bounded by true curves and have few edges.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::ShapeType;
use i_overlay::core::overlay_rule::OverlayRule;

use crate::overlay::Overlay;
use crate::region::{Contour, Region};

/// With more regions than this, a union does not look for those that are apart.
const MAX_CLUSTERED: usize = 2048;

impl Region {
    /// The points in any of the regions.
    pub fn union(regions: &[Region]) -> Region {
        let contours = clusters(regions).into_iter().flat_map(|cluster| match cluster.as_slice() {
            [alone] => alone.contours.clone(),
            _ => overlay(&cluster, &[], OverlayRule::Subject).contours,
        });
        Region { contours: contours.collect() }
    }

    /// The points of this region that are in none of the others.
    pub fn difference(&self, others: &[Region]) -> Region {
        let near: Vec<&Region> = others.iter().filter(|other| self.is_near(other)).collect();
        if near.is_empty() { self.clone() } else { overlay(&[self], &near, OverlayRule::Difference) }
    }

    /// The points in all of the regions; none if there are no regions.
    pub fn intersection(regions: &[Region]) -> Region {
        let Some((first, rest)) = regions.split_first() else { return Region::default() };
        rest.iter().fold(first.clone(), |common, next| {
            if common.is_near(next) { overlay(&[&common], &[next], OverlayRule::Intersect) } else { Region::default() }
        })
    }

    /// The points in exactly one of the two regions.
    pub fn xor(&self, other: &Region) -> Region {
        let contours = [self.contours.as_slice(), &other.contours].concat();
        Region { contours }.normalized()
    }

    /// The same points bounded by contours that do not cross: those around the region run anticlockwise, those
    /// around its holes clockwise, so that the region is always on their left.
    ///
    /// Parts thinner than about a hundred-thousandth of the diagonal of the bounding box vanish where they are
    /// bounded by arcs.
    pub fn normalized(&self) -> Region {
        match self.contours.as_slice() {
            [contour] => match contour.convex_direction() {
                Some(1) => return self.clone(),
                Some(_) => return Region { contours: vec![contour.reversed()] },
                None => {}
            },
            _ if self.is_empty() => return Region::default(),
            _ => {}
        }
        let Some(mut chords) = Overlay::around([self]) else { return Region::default() };
        chords.add(self, ShapeType::Subject);
        chords.resolve(OverlayRule::Subject, FillRule::EvenOdd)
    }

    /// Its area, in square millimetres.
    pub fn area(&self) -> f64 {
        self.normalized().contours.iter().map(Contour::signed_area).fold(0.0, |sum, area| sum + area)
    }

    /// Whether the bounding boxes meet.
    fn is_near(&self, other: &Region) -> bool {
        match (self.bounds(), other.bounds()) {
            (Some(a), Some(b)) => (0..2).all(|axis| a.0[axis] <= b.1[axis] && b.0[axis] <= a.1[axis]),
            _ => false,
        }
    }
}

fn overlay(subjects: &[&Region], clips: &[&Region], rule: OverlayRule) -> Region {
    let Some(mut chords) = Overlay::around(subjects.iter().chain(clips).copied()) else { return Region::default() };
    for subject in subjects {
        chords.add(&subject.normalized(), ShapeType::Subject);
    }
    for clip in clips {
        chords.add(&clip.normalized(), ShapeType::Clip);
    }
    chords.resolve(rule, FillRule::NonZero)
}

/// Groups the regions so that the bounding boxes of different groups are apart; leaves out what is empty.
fn clusters(regions: &[Region]) -> Vec<Vec<&Region>> {
    let some: Vec<&Region> = regions.iter().filter(|region| !region.is_empty()).collect();
    if some.len() > MAX_CLUSTERED {
        return vec![some];
    }
    let mut groups: Vec<Vec<&Region>> = Vec::new();
    for region in some {
        let (near, mut apart): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|group: &Vec<&Region>| group.iter().any(|other| other.is_near(region)));
        let mut joined: Vec<&Region> = near.into_iter().flatten().collect();
        joined.push(region);
        apart.push(joined);
        groups = apart;
    }
    groups
}
