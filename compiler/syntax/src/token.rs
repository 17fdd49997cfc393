//! Tokens: the words of the language, with their places.

use std::ops::Range;

/// One token of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// What kind of word it is.
    pub kind: TokenKind,
    /// Offset of its first byte.
    pub start: u32,
    /// Offset behind its last byte.
    pub end: u32,
}

impl Token {
    /// The byte range, for slicing the text.
    pub fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// The kinds of token.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the names of keywords and signs say it")]
pub enum TokenKind {
    /// `cube`, `$fn`, and also `2d_shape`.
    Name,
    /// `1`, `1.`, `.5`, `1e-3`, `0x1F`; never signed.
    Number,
    /// `"text"`, quotes included.
    String,
    /// A string of an OpenSCAD dump, whose quotes and backslashes are not escaped.
    RawString,
    /// `use <path>`
    Use,
    /// `include <path>`
    Include,
    /// `// …` up to the end of the line.
    LineComment,
    /// `/* … */`
    BlockComment,
    /// A `"` that no other one follows: the rest of its line.
    UnclosedString,
    /// A `/*` that no `*/` follows: the rest of the text.
    UnclosedComment,
    /// A `use <` or `include <` without `>`: the rest of its line.
    UnclosedPath,
    /// Characters that begin no token.
    Unknown,
    /// The end of the text. [`tokens`](crate::tokens) stops before it.
    End,
    Module,
    Function,
    If,
    Else,
    Let,
    Assert,
    Echo,
    For,
    Each,
    True,
    False,
    Undef,
    OpenParenthesis,
    CloseParenthesis,
    OpenBracket,
    CloseBracket,
    OpenBrace,
    CloseBrace,
    Semicolon,
    Comma,
    Dot,
    Colon,
    Question,
    Assign,
    Plus,
    Minus,
    Star,
    Slash,
    Percent,
    Caret,
    Bang,
    Tilde,
    Hash,
    Ampersand,
    AmpersandAmpersand,
    Bar,
    BarBar,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    ShiftLeft,
    ShiftRight,
}

impl TokenKind {
    /// Whether it is a comment, which the grammar does not see.
    pub fn is_comment(self) -> bool {
        matches!(self, Self::LineComment | Self::BlockComment | Self::UnclosedComment)
    }

    /// The keyword that `word` is, or [`Name`](TokenKind::Name).
    pub(crate) fn of_word(word: &str) -> Self {
        match word {
            "module" => Self::Module,
            "function" => Self::Function,
            "if" => Self::If,
            "else" => Self::Else,
            "let" => Self::Let,
            "assert" => Self::Assert,
            "echo" => Self::Echo,
            "for" => Self::For,
            "each" => Self::Each,
            "true" => Self::True,
            "false" => Self::False,
            "undef" => Self::Undef,
            _ => Self::Name,
        }
    }

    /// Whether a module instantiation can have this as its name.
    pub fn names_module(self) -> bool {
        matches!(self, Self::Name | Self::For | Self::Let | Self::Assert | Self::Echo | Self::Each)
    }

    /// Whether an expression can begin with it.
    pub fn begins_expression(self) -> bool {
        matches!(
            self,
            Self::Name
                | Self::Number
                | Self::String
                | Self::RawString
                | Self::UnclosedString
                | Self::Function
                | Self::Let
                | Self::Assert
                | Self::Echo
                | Self::True
                | Self::False
                | Self::Undef
                | Self::OpenParenthesis
                | Self::OpenBracket
                | Self::Plus
                | Self::Minus
                | Self::Bang
                | Self::Tilde
        )
    }

    /// Whether a statement can begin with it.
    pub fn begins_statement(self) -> bool {
        self.names_module()
            || matches!(
                self,
                Self::Module
                    | Self::Function
                    | Self::If
                    | Self::Use
                    | Self::Include
                    | Self::OpenBrace
                    | Self::Bang
                    | Self::Hash
                    | Self::Percent
                    | Self::Star
            )
    }
}
