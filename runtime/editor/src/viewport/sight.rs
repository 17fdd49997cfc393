//! What is seen of each text, and how it is looked at.
//!
//! Practice: the picture of a text that is left is put by, and shown again at once when somebody
//! comes back. What is drawn then is a small picture first: it takes the place of the one that was
//! put by only where it is as good, or shows something else.

use std::sync::Arc;

use chiaro_compiler::Scene;
use chiaro_render::{Legend, Plane, View};
use egui::TextureHandle;

use super::Viewport;
use super::follow::Stance;
use crate::document::DocumentId;
use crate::studio::{Eye, Frame, Look, Wanted};

/// How many texts' pictures are put by: each is a texture of the window's size.
const MOST: usize = 8;

/// What a picture shows.
pub(super) struct Seen {
    pub(super) scene: Arc<Scene>,
    pub(super) wanted: Wanted,
    pub(super) view: View,
    size: [u32; 2],
    pub(super) samples: u32,
}

/// How a text is looked at, and what was seen of it last.
#[derive(Default)]
pub(super) struct Sight {
    document: Option<DocumentId>,
    texture: Option<TextureHandle>,
    seen: Option<Seen>,
    legend: Option<Legend>,
    eye: Eye,
    look: Look,
    /// The plane of the last section.
    plane: Option<Plane>,
    stance: Stance,
}

impl Seen {
    pub(super) fn of(frame: &Frame) -> Self {
        let Frame { scene, wanted, view, size, samples, .. } = frame;
        Self { scene: scene.clone(), wanted: wanted.clone(), view: *view, size: *size, samples: *samples }
    }

    /// Whether a frame shows the same, and not as well: in fewer pixels, or in as many with fewer
    /// samples.
    pub(super) fn is_better_than(&self, frame: &Frame) -> bool {
        let is_as_large = (0..2).all(|edge| frame.size[edge] <= self.size[edge]);
        let is_finer = is_as_large && (frame.size != self.size || frame.samples < self.samples);
        is_finer
            && frame.view == self.view
            && self.wanted.shows_like(&frame.wanted)
            && shows_like(&self.scene, &frame.scene)
    }

    /// Whether it is what is wanted now.
    #[cfg(test)]
    pub(super) fn is_wanted(&self, wanted: &Wanted) -> bool {
        let is_there = wanted.eye == self.wanted.eye || wanted.eye == Eye::At(self.view);
        is_there && self.wanted.shows_like(wanted)
    }
}

/// Whether two scenes look the same from anywhere.
fn shows_like(a: &Arc<Scene>, b: &Arc<Scene>) -> bool {
    let lights = || {
        let pairs = a.lights.iter().zip(&b.lights);
        a.lights.len() == b.lights.len()
            && pairs.into_iter().all(|(a, b)| (&a.light, &a.placement) == (&b.light, &b.placement))
    };
    Arc::ptr_eq(a, b) || a.graph.is_same_field(&b.graph) && lights()
}

impl Viewport {
    /// Looks at another text: as it was looked at before, or else anew. A picture that is there
    /// already stays until there is one of that text.
    pub(super) fn turn_to(&mut self, document: DocumentId, is_open: impl Fn(DocumentId) -> bool) {
        let known = self.put_by.iter().position(|sight| sight.document == Some(document));
        let next = known.map(|at| self.put_by.remove(at)).unwrap_or_default();
        let before = Sight {
            document: self.document.replace(document),
            // A picture of another text is nothing to be put by.
            texture: self.seen.as_ref().and(self.texture.clone()),
            seen: self.seen.take(),
            legend: self.legend.take(),
            eye: self.eye,
            look: self.look,
            plane: self.plane,
            stance: std::mem::take(&mut self.stance),
        };
        self.put_by.push(before);
        self.put_by.retain(|sight| sight.document.is_some_and(&is_open));
        let surplus = self.put_by.len().saturating_sub(MOST);
        self.put_by.drain(..surplus);

        let Sight { document: _, texture, seen, legend, eye, look, plane, stance } = next;
        self.texture = texture.or(self.texture.take());
        (self.seen, self.legend, self.eye, self.look, self.plane, self.stance) =
            (seen, legend, eye, look, plane, stance);
        (self.other, self.outline, self.outlined, self.highlight, self.selection) = (None, None, None, None, None);
    }
}
