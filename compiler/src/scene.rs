//! A compiled scene.

use std::sync::Arc;

use chiaro_field::Graph;
use chiaro_solid::{Camera, Dimension, LiveParameter, PlacedLight, Scalar, Solid, SolidKind};
use chiaro_syntax::Diagnostic;

/// A plane shape is shown as a slab of this part of its size.
const SLAB_HEIGHT: f64 = 0.02;

/// A compiled scene: its field, and what is needed to draw it.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The solid tree it was lowered from.
    pub solid: Arc<Solid>,
    /// Its field. Of a plane scene that is the plane distance, for any z.
    pub graph: Graph,
    /// Its lights, in the order of the text.
    pub lights: Vec<PlacedLight>,
    /// From where it is seen.
    pub camera: Camera,
    /// The numbers that move without a recompilation, in the order of their ids.
    pub parameters: Vec<LiveParameter>,
}

impl Scene {
    /// Lowers what the evaluator answers; warnings and errors go to `diagnostics`.
    pub(crate) fn lower(scene: chiaro_solid::Scene, diagnostics: &mut Vec<Diagnostic>) -> Self {
        let (graph, remarks) = chiaro_field::lower(&scene.root);
        diagnostics.extend(remarks);
        Self { solid: scene.root, graph, lights: scene.lights, camera: scene.camera, parameters: scene.parameters }
    }

    /// The live parameters' values until somebody moves them.
    pub fn defaults(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.default).collect()
    }

    /// Whether it is a plane shape or a solid; an empty scene is neither.
    pub fn dimension(&self) -> Option<Dimension> {
        self.solid.dimension()
    }

    /// The field to draw: the scene's own, or, of a plane scene, that of a slab with its outline.
    pub fn picture(&self) -> Graph {
        match self.dimension() {
            Some(Dimension::Plane) => chiaro_field::lower(&self.drawn()).0,
            _ => self.graph.clone(),
        }
    }

    /// The solid to draw: the scene's own, or a slab of a plane scene.
    pub(crate) fn drawn(&self) -> Arc<Solid> {
        if self.dimension() != Some(Dimension::Plane) {
            return self.solid.clone();
        }
        let bounds = self.graph.facts[self.graph.root.0 as usize].bounds;
        let width = (bounds.max[0] - bounds.min[0]).hypot(bounds.max[1] - bounds.min[1]);
        let height = if width.is_finite() && width > 0.0 { SLAB_HEIGHT * width } else { 1.0 };
        let slab = SolidKind::Extrude {
            height: Scalar::from(height),
            twist: Scalar::ZERO,
            scale: [Scalar::ONE, Scalar::ONE],
            child: self.solid.clone(),
        };
        Solid::new(slab, self.solid.span)
    }
}
