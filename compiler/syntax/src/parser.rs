//! The parser: recursive descent over the tokens, total on any text.
//!
//! What cannot be read is reported, skipped, and parsing goes on, so that one run shows all mistakes. Three rules
//! keep the messages few and to the point: no two of them are about the same token; a bracket or semicolon that is
//! missing is taken as written where what follows makes sense; and whatever is skipped is skipped in whole
//! brackets.

use std::collections::HashMap;

use crate::customizer;
use crate::diagnostic::Diagnostic;
use crate::lexer::Lexer;
use crate::source::{FileId, Span};
use crate::token::{Token, TokenKind};
use crate::tree::{File, MAX_DEPTH, Name};

mod cursor;
mod expression;
mod list;
mod recovery;
mod reports;
mod statement;
mod value;

use reports::Reports;

/// The largest file that is read, in bytes.
pub const MAX_FILE_BYTES: usize = 128 << 20;

/// The most statements, expressions and list elements that a file may have, which bounds the tree's memory.
pub const MAX_NODES: usize = 16_000_000;

/// How a text is to be read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// A program.
    #[default]
    Program,
    /// A program that may be a dump of OpenSCAD's, in which the strings of `text` are not escaped.
    Dump,
}

impl Dialect {
    /// The dialect of a file of that name: [`Dialect::Dump`] for `.csg`.
    pub fn of_file(name: &str) -> Self {
        let is_dump = name.rsplit_once('.').is_some_and(|(_, extension)| extension.eq_ignore_ascii_case("csg"));
        if is_dump { Self::Dump } else { Self::Program }
    }
}

/// Reads a text. The diagnostics are in the order of the text; the tree holds whatever could be read.
pub fn parse(file: FileId, text: &str, dialect: Dialect) -> (File, Vec<Diagnostic>) {
    if text.len() > MAX_FILE_BYTES {
        let message = format!("the file is larger than {} MB", MAX_FILE_BYTES >> 20);
        return (File::default(), vec![Diagnostic::error(Span::new(file, 0..0), message)]);
    }
    let mut parser = Parser::new(file, text, dialect);
    let mut statements = parser.program();
    if !parser.stopped {
        customizer::attach(text, &mut statements);
    }
    (File { statements }, parser.reports.finish())
}

/// The parser's state. Its methods stand in the modules, by what they read.
struct Parser<'a> {
    file: FileId,
    text: &'a str,
    lexer: Lexer<'a>,
    /// The token to be read next.
    token: Token,
    /// The one behind it.
    ahead: Token,
    /// Whether an error about what stands before `ahead` makes one about `ahead` itself pointless.
    ahead_is_tainted: bool,
    /// Whether a string that is never closed may have swallowed braces, so that the others need not match.
    hides_braces: bool,
    /// Where the last token read ends.
    previous_end: u32,
    /// Where the token begins that the last error was about.
    last_error: Option<u32>,
    /// Parentheses and brackets that are open.
    open: OpenBrackets,
    /// The depth of the node being read.
    depth: usize,
    /// The depth of the deepest node of the operand being read; see [`Parser::begin_chain`].
    deepest: usize,
    nodes: usize,
    /// Whether a limit was met. The rest of the text is ignored then.
    stopped: bool,
    names: HashMap<&'a str, Name>,
    reports: Reports,
}

/// How many brackets of each kind are open.
#[derive(Clone, Copy, Default)]
struct OpenBrackets {
    parentheses: usize,
    brackets: usize,
}

impl<'a> Parser<'a> {
    fn new(file: FileId, text: &'a str, dialect: Dialect) -> Self {
        let nothing = Token { kind: TokenKind::End, start: 0, end: 0 };
        let mut parser = Self {
            file,
            text,
            lexer: Lexer::new(text, dialect),
            token: nothing,
            ahead: nothing,
            ahead_is_tainted: false,
            hides_braces: false,
            previous_end: 0,
            last_error: None,
            open: OpenBrackets::default(),
            depth: 0,
            deepest: 0,
            nodes: 0,
            stopped: false,
            names: HashMap::new(),
            reports: Reports::default(),
        };
        parser.bump();
        parser.bump();
        parser.previous_end = 0;
        parser
    }

    /// Reads something that is one level deeper, unless that is too deep.
    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> T) -> Option<T> {
        if self.depth == MAX_DEPTH {
            self.stop_at_depth();
            return None;
        }
        self.nodes += 1;
        if self.nodes > MAX_NODES {
            self.stop(format!("the file has more than {MAX_NODES} expressions and statements"));
            return None;
        }
        self.depth += 1;
        self.deepest = self.deepest.max(self.depth);
        let result = read(self);
        self.depth -= 1;
        Some(result)
    }

    /// To be called before the first operand of a chain such as `a + b + c`, whose tree leans to the left: each
    /// operator makes what has been read deeper by one. The answer is for [`Parser::end_chain`].
    fn begin_chain(&mut self) -> usize {
        std::mem::replace(&mut self.deepest, self.depth)
    }

    /// To be called for each operator of a chain. Answers whether the chain may go on.
    fn deepen_chain(&mut self) -> bool {
        self.deepest += 1;
        self.nodes += 1;
        if self.deepest > MAX_DEPTH {
            self.stop_at_depth();
        }
        !self.stopped
    }

    /// To be called behind a chain.
    fn end_chain(&mut self, deepest_before: usize) {
        self.deepest = self.deepest.max(deepest_before);
    }

    fn stop_at_depth(&mut self) {
        self.stop(format!("this is nested more than {MAX_DEPTH} levels deep"));
    }
}

#[cfg(test)]
mod tests;
