//! Which bracket belongs to which.

use std::ops::Range;

use chiaro_syntax::Token;

use crate::nesting::Nesting;
use crate::tokens;
use crate::words::bracket;

/// The pair of brackets that the caret touches, the one behind the caret first; or else the innermost pair around it.
/// Brackets in texts and comments are none.
pub fn brackets(text: &str, caret: usize) -> Option<[Range<usize>; 2]> {
    let pairs = pairs(&tokens(text));
    let touched = |at: usize| pairs.iter().find(|pair| pair.iter().any(|token| token.start as usize == at));
    let around = || {
        let is_around = |pair: &&[Token; 2]| (pair[0].end as usize) <= caret && caret <= pair[1].start as usize;
        pairs.iter().filter(is_around).min_by_key(|pair| pair[1].start - pair[0].start)
    };
    let found = touched(caret).or_else(|| caret.checked_sub(1).and_then(touched)).or_else(around)?;
    Some(found.map(Token::range))
}

/// All pairs. What has no partner is left out, and hides no others.
fn pairs(tokens: &[Token]) -> Vec<[Token; 2]> {
    let mut nesting = Nesting::default();
    let mut pairs = Vec::new();
    for token in tokens {
        match bracket(token.kind) {
            Some((pair, true)) => nesting.open(pair, *token),
            Some((pair, false)) => pairs.extend(nesting.close(pair).map(|opener| [opener, *token])),
            None => {}
        }
    }
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The two brackets' places for a caret at `|`.
    fn places(text: &str) -> Option<[usize; 2]> {
        let caret = text.find('|').expect("a caret");
        brackets(&text.replace('|', ""), caret).map(|pair| pair.map(|range| range.start))
    }

    #[test]
    fn a_bracket_beside_the_caret_has_its_partner() {
        assert_eq!(places("a = |(1 + [2]);"), Some([4, 12]));
        assert_eq!(places("a = (1 + [2])|;"), Some([4, 12]));
        assert_eq!(places("f(|[1])"), Some([2, 4]));
    }

    #[test]
    fn elsewhere_the_innermost_pair_around_is_meant() {
        assert_eq!(places("f([1, |2], 3)"), Some([2, 7]));
        assert_eq!(places("a |= 1;"), None);
    }

    #[test]
    fn texts_and_comments_have_no_brackets() {
        assert_eq!(places("f(|\")\" /* ) */)"), Some([1, 13]));
    }

    #[test]
    fn a_missing_bracket_spoils_only_its_own_pair() {
        assert_eq!(places("{ f(1; |}"), Some([0, 7]));
        assert_eq!(places("{ f(1]) |}"), Some([0, 8]));
    }
}
