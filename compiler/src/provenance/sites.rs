//! Which solids each expression of the text made.

use chiaro_field::Lineage;
use chiaro_syntax::tree::{Instance, Statement};
use chiaro_syntax::{Dialect, FileId, Sources, Span, parse};
use std::collections::HashMap;

use super::SolidId;

/// The instances of a scene's files, with the solids they came to.
#[derive(Debug)]
pub(super) struct Sites {
    sources: Sources,
    /// By the instance's head.
    solids: HashMap<Span, Vec<SolidId>>,
    /// For each file, every instance's own extent and its head: what is inside stands behind what is around it.
    instances: Vec<Vec<(Span, Span)>>,
}

impl Sites {
    pub(super) fn new(lineage: &Lineage, sources: &Sources) -> Self {
        let mut solids: HashMap<Span, Vec<SolidId>> = HashMap::new();
        for (index, step) in lineage.steps.iter().enumerate().filter(|(_, step)| step.node.is_some()) {
            let around = step.parent.map(|parent| &lineage.step(parent).solid);
            let spans = std::iter::once(step.solid.span).chain(step.solid.via.iter().copied());
            // Of the solids in one another that an instance came to, the outermost counts.
            let is_new = |span: &Span| around.is_none_or(|around| around.span != *span);
            for span in spans.filter(is_new).filter(|span| span.start < span.end) {
                solids.entry(span).or_default().push(SolidId(index as u32));
            }
        }
        let instances = sources.iter().map(|(id, file)| {
            let (tree, _) = parse(id, &file.text, Dialect::of_file(&file.name));
            let mut instances = Vec::new();
            collect(&tree.statements, &mut instances);
            instances
        });
        Self { solids, instances: instances.collect(), sources: sources.clone() }
    }

    /// The name in an instance's head.
    pub(super) fn name(&self, head: Span) -> String {
        if head.file.0 as usize >= self.instances.len() {
            return String::new();
        }
        let text = self.sources.text(head);
        text.chars().take_while(|c| c.is_alphanumeric() || matches!(c, '_' | '$')).collect()
    }

    /// The solids of the innermost instance about a place that made any.
    pub(super) fn at(&self, file: FileId, offset: u32) -> &[SolidId] {
        let head = self.expression(file, offset);
        head.and_then(|head| self.solids.get(&head)).map_or(&[], Vec::as_slice)
    }

    /// The head of the innermost instance about a place that made solids.
    pub(super) fn expression(&self, file: FileId, offset: u32) -> Option<Span> {
        let instances = self.instances.get(file.0 as usize)?;
        let holds = |span: &Span| span.start <= offset && offset <= span.end;
        let around = instances.iter().rev().filter(|(extent, _)| holds(extent));
        // Between two instances that touch, the one that begins there counts, which stands behind.
        around.map(|(_, head)| *head).find(|head| self.solids.contains_key(head))
    }
}

/// The instances in some statements, those in modules included, each before what is in it.
fn collect(statements: &[Statement], into: &mut Vec<(Span, Span)>) {
    let mut open: Vec<&Statement> = statements.iter().rev().collect();
    while let Some(statement) = open.pop() {
        match statement {
            Statement::Instance(Instance { children, otherwise, span, head, .. }) => {
                into.push((*span, *head));
                open.extend(otherwise.iter().rev());
                open.extend(children.iter().rev());
            }
            Statement::Module(definition) => open.extend(definition.body.iter().rev()),
            Statement::Block(statements) => open.extend(statements.iter().rev()),
            Statement::Use(_) | Statement::Include(_) | Statement::Assignment(_) | Statement::Function(_) => {}
        }
    }
}
