//! What values of exported code are called: after the module of the text that they come from.

use std::collections::HashMap;

use chiaro_syntax::tree::Statement;
use chiaro_syntax::{Dialect, FileId, Sources, Span, parse};

/// The names of modules by the places they are defined at.
pub struct ModuleNames {
    /// For each file, its definitions with their names; what is inside another stands behind it.
    files: HashMap<FileId, Vec<(Span, String)>>,
}

impl ModuleNames {
    /// Those of a scene's files.
    pub fn new(sources: &Sources) -> Self {
        let names = |(id, file): (FileId, &chiaro_syntax::SourceFile)| {
            let (tree, _) = parse(id, &file.text, Dialect::of_file(&file.name));
            let mut definitions = Vec::new();
            collect(&tree.statements, &mut definitions);
            (id, definitions)
        };
        Self { files: sources.iter().map(names).collect() }
    }

    /// The innermost module that what stands there belongs to, as a word in snake case.
    pub fn of(&self, span: Span) -> Option<String> {
        let definitions = self.files.get(&span.file)?;
        let holds = |(extent, _): &&(Span, String)| extent.start <= span.start && span.end <= extent.end;
        definitions.iter().rev().find(holds).map(|(_, name)| name.clone())
    }
}

fn collect(statements: &[Statement], definitions: &mut Vec<(Span, String)>) {
    for statement in statements {
        match statement {
            Statement::Module(definition) => {
                definitions.push((definition.span, chiaro_export::snake_case(&definition.name.node, "value")));
                collect(&definition.body, definitions);
            }
            Statement::Block(statements) => collect(statements, definitions),
            _ => {}
        }
    }
}
