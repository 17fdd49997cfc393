//! Pictures of a scene other than lit, and outlines of its parts.

use chiaro_render::{Error, Inspection, Inspector, Legend, Mask, Masker, View};

use super::super::{Outlined, Subject};
use super::highlight::Highlighting;

/// What looks at a subject.
pub(crate) struct Inspecting {
    inspector: Inspector,
    masker: Masker,
    /// The mask made last, and of what.
    last_mask: Option<(Masked, Option<Mask>)>,
    highlighting: Option<Highlighting>,
    /// The highlight made last, and of what.
    last_highlight: Option<(Masked, Vec<u8>)>,
}

/// What decides a mask or a highlight.
#[derive(Clone, PartialEq)]
struct Masked {
    view: View,
    size: [u32; 2],
    outlined: Outlined,
    parameters: Vec<f64>,
}

impl Inspecting {
    pub(crate) fn new(subject: &Subject) -> Result<Self, Error> {
        let inspector = Inspector::new(&subject.gpu, &subject.model)?;
        Ok(Self { inspector, masker: Masker::default(), last_mask: None, highlighting: None, last_highlight: None })
    }

    /// The picture in 8 bits of sRGB and alpha, with what its colours mean. None if it was not to go on before it was done.
    pub(crate) fn draw(
        &mut self,
        view: View,
        size: [u32; 2],
        what: &Inspection,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<(Vec<u8>, Legend)>, Error> {
        let drawing = self.inspector.draw_while(view, size, what, goes_on)?;
        Ok(drawing.map(|drawing| (drawing.pixels, drawing.legend)))
    }

    /// Which pixels show the solids. None if the system has no room to find out, or if it was not to go on.
    pub(crate) fn mask(
        &mut self,
        view: View,
        size: [u32; 2],
        outlined: &Outlined,
        parameters: &[f64],
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<Mask>, Error> {
        let masked = Masked { view, size, outlined: outlined.clone(), parameters: parameters.to_vec() };
        if let Some((_, mask)) = self.last_mask.as_ref().filter(|(of, _)| *of == masked) {
            return Ok(mask.clone());
        }
        self.inspector.set_parameters(parameters)?;
        if !self.inspector.look_while(view, size, None, goes_on)? {
            return Ok(None);
        }
        let mask = match outlined.provenance.parts(&outlined.solids) {
            Ok(part) => Some(self.masker.mask(&mut self.inspector, &part, parameters)?),
            Err(_) => None,
        };
        self.last_mask = Some((masked, mask.clone()));
        Ok(mask)
    }

    /// The solids highlighted, in 8 bits of sRGB and alpha. None if that can't be drawn, or if it
    /// was not to go on.
    pub(crate) fn highlight(
        &mut self,
        subject: &Subject,
        view: View,
        size: [u32; 2],
        solids: &Outlined,
        parameters: &[f64],
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<Vec<u8>>, Error> {
        let masked = Masked { view, size, outlined: solids.clone(), parameters: parameters.to_vec() };
        if let Some((_, highlight)) = self.last_highlight.as_ref().filter(|(of, _)| *of == masked) {
            return Ok(Some(highlight.clone()));
        }
        self.inspector.set_parameters(parameters)?;
        if !self.inspector.look_while(view, size, None, goes_on)? {
            return Ok(None);
        }
        let scene = self.inspector.positions()?;
        self.highlighting = Highlighting::of(self.highlighting.take(), subject, solids, parameters)?;
        let Some(highlighting) = &mut self.highlighting else { return Ok(None) };
        let drawn = highlighting.draw(view, size, parameters, &scene, goes_on)?;
        self.last_highlight = drawn.clone().map(|highlight| (masked, highlight));
        Ok(drawn)
    }
}
