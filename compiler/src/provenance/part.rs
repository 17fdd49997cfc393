//! Solids alone where they stand.

use std::sync::Arc;

use chiaro_solid::{Boolean, Solid, SolidKind};
use chiaro_syntax::{FileId, Span};

use super::{Provenance, SolidId};

impl Provenance {
    /// Some solids as one, each alone.
    pub(super) fn alone(&self, solids: &[SolidId]) -> Arc<Solid> {
        let mut children: Vec<Arc<Solid>> = solids.iter().map(|solid| self.single(*solid)).collect();
        let nowhere = Span::new(FileId(0), 0..0);
        match children.len() {
            0 => Solid::new(SolidKind::Empty, nowhere),
            1 => children.remove(0),
            _ => Solid::new(SolidKind::Boolean { operation: Boolean::Union, joint: None, children }, nowhere),
        }
    }

    /// The solid below all that moves, bends or thickens it in the scene, and without the operands beside it. (Nothing
    /// that was cut is thickened, so what thickens a solid that is taken away thickens what it cuts out.)
    fn single(&self, id: SolidId) -> Arc<Solid> {
        let mut alone = self.solid(id).clone();
        for around in self.upwards(id).skip(1) {
            let around = self.solid(around);
            let child = alone.clone();
            let kind = match &around.kind {
                SolidKind::Offset(by, _) => SolidKind::Offset(by.clone(), child),
                SolidKind::Shell(thickness, _) => SolidKind::Shell(thickness.clone(), child),
                SolidKind::Transform(map, _) => SolidKind::Transform(map.clone(), child),
                SolidKind::Paint(material, _) => SolidKind::Paint(material.clone(), child),
                SolidKind::Twist(rate, _) => SolidKind::Twist(rate.clone(), child),
                SolidKind::Extrude { height, twist, scale, .. } => {
                    SolidKind::Extrude { height: height.clone(), twist: twist.clone(), scale: scale.clone(), child }
                }
                SolidKind::Revolve { sweep, facets, .. } => {
                    SolidKind::Revolve { sweep: sweep.clone(), facets: *facets, child }
                }
                SolidKind::Slice(_) => SolidKind::Slice(child),
                SolidKind::Boolean { .. }
                | SolidKind::Empty
                | SolidKind::Shape(..)
                | SolidKind::Region(_)
                | SolidKind::Loft(_)
                | SolidKind::SphereHull(_) => continue,
            };
            alone = Solid::new(kind, around.span);
        }
        alone
    }
}
