//! Which brackets are open, in texts whose brackets need not match.

/// The number of braces among the pairs that [`bracket`](crate::words::bracket) tells.
pub(crate) const BRACES: usize = 2;

/// The brackets that are open at a place, and something about each.
///
/// A closing bracket closes the innermost one of its kind, together with whatever was left open inside of that; but no
/// parenthesis and no bracket closes what is outside of the braces around it. Reading a whole text takes linear time.
pub(crate) struct Nesting<T> {
    open: Vec<(usize, T)>,
    /// How many parentheses and brackets are open within each open brace, and first outside of all.
    counts: Vec<[usize; 2]>,
}

impl<T> Default for Nesting<T> {
    fn default() -> Self {
        Self { open: Vec::new(), counts: vec![[0; 2]] }
    }
}

impl<T> Nesting<T> {
    /// Opens a bracket.
    pub(crate) fn open(&mut self, pair: usize, about: T) {
        match self.counts.last_mut() {
            Some(counts) if pair != BRACES => counts[pair] += 1,
            _ => self.counts.push([0; 2]),
        }
        self.open.push((pair, about));
    }

    /// Closes a bracket, and answers what is known about it. None, if there is none to close.
    pub(crate) fn close(&mut self, pair: usize) -> Option<T> {
        let is_open = match self.counts.last() {
            Some(counts) if pair != BRACES => counts[pair] > 0,
            _ => self.counts.len() > 1,
        };
        if !is_open {
            return None;
        }
        loop {
            let (popped, about) = self.open.pop()?;
            match self.counts.last_mut() {
                Some(counts) if popped != BRACES => counts[popped] -= 1,
                _ => {
                    self.counts.pop();
                }
            }
            if popped == pair {
                return Some(about);
            }
        }
    }

    /// The bracket that a closing one would close.
    pub(crate) fn opener(&self, pair: usize) -> Option<&T> {
        let is_open = match self.counts.last() {
            Some(counts) if pair != BRACES => counts[pair] > 0,
            _ => self.counts.len() > 1,
        };
        let found = || self.open.iter().rfind(|(other, _)| *other == pair).map(|(_, about)| about);
        is_open.then(found).flatten()
    }

    /// The innermost bracket: its pair and what is known about it.
    pub(crate) fn innermost(&self) -> Option<(usize, &T)> {
        self.open.last().map(|(pair, about)| (*pair, about))
    }

    /// What is known about the innermost bracket.
    pub(crate) fn innermost_mut(&mut self) -> Option<&mut T> {
        self.open.last_mut().map(|(_, about)| about)
    }

    /// Whether statements stand here: not within parentheses or brackets.
    pub(crate) fn is_block(&self) -> bool {
        self.open.last().is_none_or(|(pair, _)| *pair == BRACES)
    }

    /// All that are open, the outermost first.
    pub(crate) fn into_open(self) -> Vec<(usize, T)> {
        self.open
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_open_inside_is_closed_too() {
        let mut nesting = Nesting::default();
        nesting.open(0, 'a');
        nesting.open(1, 'b');
        assert_eq!(nesting.close(0), Some('a'));
        assert_eq!(nesting.close(1), None);
    }

    #[test]
    fn only_braces_close_braces() {
        let mut nesting = Nesting::default();
        nesting.open(0, 'a');
        nesting.open(BRACES, 'b');
        assert_eq!(nesting.close(0), None);
        nesting.open(1, 'c');
        assert_eq!(nesting.close(BRACES), Some('b'));
        assert_eq!(nesting.close(0), Some('a'));
        assert_eq!(nesting.close(BRACES), None);
    }
}
