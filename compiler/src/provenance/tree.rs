//! The tree of solids as plain data, for a panel.

use chiaro_field::{Lineage, StepId};
use chiaro_syntax::Span;
use chiaro_vocabulary::{Bounds, Class};

use super::SolidId;
use super::sites::Sites;

/// An expression and the solids in it.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The name of the shape, the operator or the module; empty for the scene as a whole.
    pub what: String,
    /// Name and arguments; empty for the scene as a whole.
    pub span: Span,
    /// The solid it came to.
    pub solid: SolidId,
    /// Its box in the world.
    pub bounds: Bounds,
    /// What its distances are; none if there is nothing of it.
    pub class: Option<Class>,
    /// The Lipschitz constant of its distance: how many times too long it may be.
    pub lipschitz: f64,
    /// What is in it, in the order of the text.
    pub children: Vec<Tree>,
}

/// The whole scene's, with these boxes of the nodes.
pub(super) fn tree(lineage: &Lineage, sites: &Sites, bounds: &[Bounds]) -> Tree {
    let mut made: Vec<Option<Tree>> = lineage.steps.iter().map(|_| None).collect();
    // What is inside stands behind what is around it.
    for index in (0..lineage.steps.len()).rev() {
        let step = &lineage.steps[index];
        let own = |span: Span, children: Vec<Tree>| {
            let node = step.node.map(|node| node.0 as usize);
            let facts = node.map(|node| &lineage.graph.facts[node]);
            Tree {
                what: sites.name(span),
                span,
                solid: SolidId(index as u32),
                bounds: node.map_or(Bounds::EMPTY, |node| bounds[node]),
                class: facts.map(|facts| facts.class),
                lipschitz: facts.map_or(0.0, |facts| facts.lipschitz),
                children,
            }
        };
        let inner = step.children.iter().filter_map(|StepId(child)| made[*child as usize].take());
        // Several solids in one another that one instance came to are one expression.
        let is_same = |child: &Tree| child.span == step.solid.span;
        let inner = inner.flat_map(|child| if is_same(&child) { child.children } else { vec![child] }).collect();
        let mut whole = own(step.solid.span, inner);
        for span in &step.solid.via {
            whole = own(*span, vec![whole]);
        }
        made[index] = Some(whole);
    }
    made.into_iter().next().flatten().unwrap_or_else(|| unreachable!("a scene has a root"))
}
