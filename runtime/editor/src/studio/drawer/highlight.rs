//! What `#` highlights, as OpenSCAD shows it: the solid alone, translucent and pink, wherever
//! nothing is before it; so that what is cut away is seen too.

use chiaro_render::{Error, Inspection, Inspector, Model, View};

use super::super::{Outlined, Subject};

/// OpenSCAD's colour for it, in 8 bits of sRGB.
const PINK: [f64; 3] = [255.0, 81.0, 81.0];
/// How much it covers, in 8 bits.
const ALPHA: u8 = 128;
/// How bright it is where it is seen edge on.
const LEAST_BRIGHT: f64 = 0.45;
/// Surfaces that lie in each other are found so far apart at most, in pixels.
const TOLERANCE: f64 = 4.0;

/// What looks at the highlighted solids alone.
pub(crate) struct Highlighting {
    of: Outlined,
    inspector: Inspector,
}

impl Highlighting {
    /// Of some solids: what is at hand, if it is of these. None if the system has no room to find
    /// out, or if they are too much for a shader.
    pub(crate) fn of(
        at_hand: Option<Self>,
        subject: &Subject,
        solids: &Outlined,
        parameters: &[f64],
    ) -> Result<Option<Self>, Error> {
        if at_hand.as_ref().is_some_and(|known| known.of == *solids) {
            return Ok(at_hand);
        }
        let Ok(graph) = solids.provenance.parts(&solids.solids) else { return Ok(None) };
        let made = Model::new(&subject.gpu, &graph, parameters).and_then(|model| Inspector::new(&subject.gpu, &model));
        match made {
            Ok(inspector) => Ok(Some(Self { of: solids.clone(), inspector })),
            Err(error @ (Error::Scene(_) | Error::SceneSize { .. })) => {
                log::warn!("nothing is highlighted: {error}");
                Ok(None)
            }
            Err(error) => Err(error),
        }
    }

    /// The picture to be laid over the scene's, in 8 bits of sRGB and alpha, where the scene is
    /// seen at these places. None if it was not to go on before it was done.
    pub(crate) fn draw(
        &mut self,
        view: View,
        size: [u32; 2],
        parameters: &[f64],
        scene: &[[f32; 4]],
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<Vec<u8>>, Error> {
        self.inspector.set_parameters(parameters)?;
        let Some(normals) = self.inspector.draw_while(view, size, &Inspection::Normals, goes_on)? else {
            return Ok(None);
        };
        let (eye, nearness) = (view.eye(), 1.0 + TOLERANCE * view.pixel_angle(size));
        let places = self.inspector.positions()?;
        let pixels = places.iter().zip(scene).zip(normals.pixels.chunks_exact(4));
        let colored = pixels.flat_map(|((place, behind), normal)| {
            let [depth, scene_depth] = [place[3], behind[3]].map(f64::from);
            let is_seen = depth >= 0.0 && (scene_depth < 0.0 || depth <= nearness * scene_depth);
            if is_seen { color(eye, *place, normal) } else { [0; 4] }
        });
        Ok(Some(colored.collect()))
    }
}

/// The colour of a place, brighter the more it faces the eye.
fn color(eye: [f64; 3], place: [f32; 4], normal: &[u8]) -> [u8; 4] {
    let along = [0, 1, 2].map(|axis| f64::from(place[axis]) - eye[axis]);
    let length = along.iter().map(|x| x * x).sum::<f64>().sqrt().max(f64::MIN_POSITIVE);
    // A normal's picture has half of the colour for 0.
    let facing: f64 = (0..3).map(|axis| (f64::from(normal[axis]) / 127.5 - 1.0) * along[axis] / length).sum();
    let bright = LEAST_BRIGHT + (1.0 - LEAST_BRIGHT) * facing.abs().min(1.0);
    let [red, green, blue] = PINK.map(|channel| (bright * channel).round() as u8);
    [red, green, blue, ALPHA]
}
