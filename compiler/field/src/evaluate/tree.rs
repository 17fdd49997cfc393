//! A tree of boxes over the operands of a large union.

use chiaro_vocabulary::Bounds;

use crate::graph::NodeId;

/// Boxes of boxes, halved at the middle of their longest side.
#[derive(Debug)]
pub(super) struct Tree {
    branches: Vec<Branch>,
}

#[derive(Debug)]
struct Branch {
    bounds: Bounds,
    content: Content,
}

#[derive(Debug)]
enum Content {
    Operand(NodeId),
    /// The second half; the first stands right behind.
    Halves(u32),
}

impl Tree {
    /// A tree over operands with their boxes, one at least; the boxes are finite.
    pub(super) fn new(mut boxed: Vec<(Bounds, NodeId)>) -> Self {
        let mut tree = Self { branches: Vec::with_capacity(2 * boxed.len()) };
        tree.grow(&mut boxed);
        tree
    }

    fn grow(&mut self, boxed: &mut [(Bounds, NodeId)]) {
        let bounds = boxed.iter().fold(Bounds::EMPTY, |all, (bounds, _)| all.union(bounds));
        let here = self.branches.len();
        if let [(_, operand)] = boxed {
            self.branches.push(Branch { bounds, content: Content::Operand(*operand) });
            return;
        }
        let size = bounds.size();
        let longest = (0..3).max_by(|a, b| size[*a].total_cmp(&size[*b])).unwrap_or(0);
        let middle = boxed.len() / 2;
        let centre = |item: &(Bounds, NodeId)| item.0.center()[longest];
        boxed.select_nth_unstable_by(middle, |a, b| centre(a).total_cmp(&centre(b)));
        self.branches.push(Branch { bounds, content: Content::Halves(0) });
        let (first, second) = boxed.split_at_mut(middle);
        self.grow(first);
        self.branches[here].content = Content::Halves(self.branches.len() as u32);
        self.grow(second);
    }

    /// Calls `ask` with the operands, the nearer boxes first, while `ask` answers how far the nearest operand so far
    /// is: none that lies farther is asked.
    pub(super) fn nearest(&self, point: [f64; 3], mut best: f64, ask: &mut impl FnMut(NodeId) -> f64) {
        let distance = |branch: u32| self.branches[branch as usize].bounds.distance(point);
        let mut open = vec![(distance(0), 0u32)];
        while let Some((gap, branch)) = open.pop() {
            // A box that holds the point may hold an operand that does so deeper than all others.
            if gap > 0.0 && gap > best {
                continue;
            }
            match self.branches[branch as usize].content {
                Content::Operand(operand) => best = ask(operand),
                Content::Halves(second) => {
                    let (first, second) = ((distance(branch + 1), branch + 1), (distance(second), second));
                    let (nearer, farther) = if first.0 <= second.0 { (first, second) } else { (second, first) };
                    open.push(farther);
                    open.push(nearer);
                }
            }
        }
    }
}
