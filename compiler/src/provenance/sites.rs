//! Which solids each expression of the text made.

use std::collections::HashMap;

use chiaro_field::Lineage;
use chiaro_syntax::tree::{Instance, Statement};
use chiaro_syntax::{Dialect, FileId, Sources, Span, parse};

use super::SolidId;

/// The instances of a scene's files, with the solids they came to.
#[derive(Debug)]
pub(super) struct Sites {
    sources: Sources,
    /// By the instance's head.
    solids: HashMap<Span, Vec<SolidId>>,
    /// For each file, its instances and modules: what is inside stands behind what is around it.
    files: Vec<Vec<Site>>,
    /// The signs and the heads of the instances that `#` marks.
    marked: Vec<[Span; 2]>,
}

/// An instance or the definition of a module.
#[derive(Debug)]
struct Site {
    /// The whole of it.
    extent: Span,
    /// The instance's head or the module's name.
    name: Span,
    /// The heads of the instances whose solids it made.
    heads: Vec<Span>,
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
        let mut marked = Vec::new();
        let files = sources.iter().map(|(id, file)| {
            let (tree, _) = parse(id, &file.text, Dialect::of_file(&file.name));
            sites(&tree.statements, &mut marked)
        });
        let files = files.collect();
        Self { solids, files, sources: sources.clone(), marked }
    }

    /// The sign `#` of each instance that is marked by it and came to something, with all that it
    /// came to.
    pub(super) fn highlighted(&self) -> impl Iterator<Item = (Span, &[SolidId])> {
        let trimmed = |sign: &Span| {
            let length = self.sources.text(*sign).trim_end().len() as u32;
            Span { end: sign.start + length, ..*sign }
        };
        self.marked.iter().filter_map(move |[sign, head]| Some((trimmed(sign), &**self.solids.get(head)?)))
    }

    /// The name in an instance's head.
    pub(super) fn name(&self, head: Span) -> String {
        if head.file.0 as usize >= self.files.len() {
            return String::new();
        }
        let text = self.sources.text(head);
        text.chars().take_while(|c| c.is_alphanumeric() || matches!(c, '_' | '$')).collect()
    }

    /// The solids of the innermost site about a place that made any.
    pub(super) fn at(&self, file: FileId, offset: u32) -> Vec<SolidId> {
        let heads = self.site(file, offset).map_or(&[][..], |site| &site.heads);
        let mut solids: Vec<SolidId> =
            heads.iter().filter_map(|head| self.solids.get(head)).flatten().copied().collect();
        solids.sort_unstable();
        solids.dedup();
        solids
    }

    /// What the innermost site about a place that made solids is called by.
    pub(super) fn expression(&self, file: FileId, offset: u32) -> Option<Span> {
        self.site(file, offset).map(|site| site.name)
    }

    fn site(&self, file: FileId, offset: u32) -> Option<&Site> {
        let holds = |span: &Span| span.start <= offset && offset <= span.end;
        // Between two that touch, the one that begins there counts, which stands behind.
        let mut around = self.files.get(file.0 as usize)?.iter().rev().filter(|site| holds(&site.extent));
        around.find(|site| site.heads.iter().any(|head| self.solids.contains_key(head)))
    }
}

/// The sites in some statements, each before what is in it. The signs and heads of those that `#`
/// marks are added to `marked`.
fn sites(statements: &[Statement], marked: &mut Vec<[Span; 2]>) -> Vec<Site> {
    let mut sites = Vec::new();
    let mut open: Vec<&Statement> = statements.iter().rev().collect();
    while let Some(statement) = open.pop() {
        match statement {
            Statement::Instance(Instance { modifiers, children, otherwise, span, head, .. }) => {
                if modifiers.highlight && !modifiers.disable {
                    marked.push([Span { end: head.start, ..*span }, *head]);
                }
                sites.push(Site { extent: *span, name: *head, heads: vec![*head] });
                open.extend(otherwise.iter().rev());
                open.extend(children.iter().rev());
            }
            Statement::Module(definition) => {
                let head = |statement: &Statement| match statement {
                    Statement::Instance(instance) => Some(instance.head),
                    _ => None,
                };
                let heads = definition.body.iter().filter_map(head).collect();
                sites.push(Site { extent: definition.span, name: definition.name.span, heads });
                open.extend(definition.body.iter().rev());
            }
            Statement::Block(statements) => open.extend(statements.iter().rev()),
            Statement::Use(_) | Statement::Include(_) | Statement::Assignment(_) | Statement::Function(_) => {}
        }
    }
    sites
}
