//! The file's own definitions in words: their signatures, and the comments above them.

use chiaro_syntax::{Token, TokenKind};

use crate::index::{Definition, Index, What};

/// The most characters of a value that a signature shows.
const SHOWN_CHARACTERS: usize = 60;

/// What a definition looks like on one line.
pub(crate) fn signature(text: &str, index: &Index, definition: &Definition) -> String {
    let parameters = || {
        let parameters = definition.parameters.iter().map(|id| valued(text, &index.definitions[*id]));
        format!("{}({})", definition.name, parameters.collect::<Vec<_>>().join(", "))
    };
    match definition.what {
        What::Module => format!("module {}", parameters()),
        What::Function => format!("function {}", parameters()),
        What::Variable | What::Parameter => valued(text, definition),
    }
}

/// A name with its value.
pub(crate) fn valued(text: &str, definition: &Definition) -> String {
    match definition.value.clone().and_then(|range| text.get(range)) {
        Some(value) => format!("{} = {}", definition.name, shortened(value)),
        None => definition.name.to_string(),
    }
}

/// A text on one line, cut if it is long.
fn shortened(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    match line.char_indices().nth(SHOWN_CHARACTERS) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None => line,
    }
}

/// The comments right above a place, without the signs that make them comments. `tokens` are all tokens.
pub(crate) fn comment_above(text: &str, tokens: &[Token], place: usize) -> String {
    let mut lines = Vec::new();
    let mut end = place;
    let before = tokens.partition_point(|token| (token.end as usize) <= place);
    for (at, token) in tokens[..before].iter().enumerate().rev() {
        let gap = text.get(token.range().end..end).unwrap_or_default();
        let is_above = gap.trim().is_empty() && gap.matches('\n').count() == 1;
        let begins_line = at.checked_sub(1).is_none_or(|previous| {
            text.get(tokens[previous].range().end..token.range().start).is_some_and(|gap| gap.contains('\n'))
        });
        if !token.kind.is_comment() || !is_above || !begins_line {
            break;
        }
        end = token.range().start;
        let comment = plain(&text[token.range()], token.kind);
        lines.push(comment);
        if token.kind == TokenKind::BlockComment {
            break;
        }
    }
    lines.reverse();
    lines.join("\n").trim().to_owned()
}

/// What a comment says.
fn plain(comment: &str, kind: TokenKind) -> String {
    match kind {
        TokenKind::LineComment => comment.trim_start_matches('/').trim().to_owned(),
        _ => {
            let inside = comment.trim_start_matches("/*").trim_end_matches("*/");
            let lines = inside.lines().map(|line| line.trim().trim_start_matches('*').trim());
            lines.collect::<Vec<_>>().join("\n").trim().to_owned()
        }
    }
}
