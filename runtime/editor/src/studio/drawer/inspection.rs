//! Pictures of a scene other than lit, and outlines of its parts.

use chiaro_render::{Error, Inspection, Inspector, Legend, Mask, Masker, View};

use super::super::{Outlined, Subject};

/// The most solids whose outline is drawn: a loop may make thousands.
const MOST_OUTLINED: usize = 12;

/// What looks at a subject.
pub(crate) struct Inspecting {
    inspector: Inspector,
    masker: Masker,
}

impl Inspecting {
    pub(crate) fn new(subject: &Subject) -> Result<Self, Error> {
        Ok(Self { inspector: Inspector::new(&subject.gpu, &subject.model)?, masker: Masker::default() })
    }

    /// The picture in 8 bits of sRGB and alpha, with what its colours mean.
    pub(crate) fn draw(&mut self, view: View, size: [u32; 2], what: &Inspection) -> Result<(Vec<u8>, Legend), Error> {
        let drawing = self.inspector.draw(view, size, what)?;
        Ok((drawing.pixels, drawing.legend))
    }

    /// Which pixels show one of the solids. None, if the system has no room to find out.
    pub(crate) fn mask(
        &mut self,
        view: View,
        size: [u32; 2],
        outlined: &Outlined,
        parameters: &[f64],
    ) -> Result<Option<Mask>, Error> {
        self.inspector.look(view, size, None)?;
        let mut whole: Option<Mask> = None;
        for solid in outlined.solids.iter().take(MOST_OUTLINED) {
            let Ok(part) = outlined.provenance.part(*solid) else { return Ok(None) };
            let mask = self.masker.mask(&mut self.inspector, &part, parameters)?;
            match &mut whole {
                Some(whole) => whole.covered.iter_mut().zip(mask.covered).for_each(|(covered, also)| *covered |= also),
                None => whole = Some(mask),
            }
        }
        Ok(whole)
    }
}
