//! A picture in progress, and perhaps its twin by another light algorithm.

use chiaro_compiler::Scene;
use chiaro_render::{Direct, Error, Floor, Lighting, Mask, Picture, View};

use super::super::{Outlined, Subject, Wanted};

/// Pictures of one size, with what they show.
pub(crate) struct Canvas {
    picture: Picture,
    other: Option<Picture>,
    scene: std::sync::Arc<Scene>,
    shown: Option<Shown>,
}

/// What decides a picture besides its scene and size.
#[derive(Clone, PartialEq)]
struct Shown {
    view: View,
    values: Vec<f64>,
    floor: bool,
    direct: [Option<Direct>; 2],
}

impl Canvas {
    pub(crate) fn new(subject: &Subject, size: [u32; 2], first_view: View, wanted: &Wanted) -> Result<Self, Error> {
        let picture = || Picture::new(&subject.gpu, &subject.model, first_view, size);
        let other = if wanted.other.is_some() { Some(picture()?) } else { None };
        Ok(Self { picture: picture()?, other, scene: subject.scene.clone(), shown: None })
    }

    /// Makes it show what is wanted, keeping the samples it has if that is what it shows already.
    pub(crate) fn prepare(&mut self, wanted: &Wanted, view: View) -> Result<(), Error> {
        let values = wanted.parameters(&self.scene);
        let direct = [Some(wanted.direct), wanted.other];
        let now = Shown { view, values, floor: wanted.floor, direct };
        let exposure = wanted.exposure.exp2();
        let before = self.shown.take();
        for (picture, direct) in self.pictures().zip(now.direct) {
            picture.set_exposure(exposure);
            if before.as_ref() == Some(&now) {
                continue;
            }
            if before.as_ref().is_none_or(|before| before.values != now.values) {
                picture.set_parameters(&now.values)?;
            }
            if picture.view() != now.view {
                picture.set_view(now.view)?;
            }
            if before.as_ref().is_none_or(|before| before.floor != now.floor) {
                picture.set_floor(if now.floor { Floor::Measured } else { Floor::Missing })?;
            }
            picture.set_direct(direct.unwrap_or(wanted.direct))?;
        }
        if before.as_ref() != Some(&now) && !self.scene.lights.is_empty() {
            let lighting = Lighting::of(&self.scene.lights, &now.values, &now.view);
            for picture in self.pictures() {
                picture.set_lighting(lighting.clone())?;
            }
        }
        self.shown = Some(now);
        Ok(())
    }

    pub(crate) fn size(&self) -> [u32; 2] {
        self.picture.size()
    }

    pub(crate) fn compares(&self) -> bool {
        self.other.is_some()
    }

    pub(crate) fn samples(&self) -> u32 {
        self.other.as_ref().map_or(u32::MAX, Picture::samples).min(self.picture.samples())
    }

    /// Draws a whole sample.
    pub(crate) fn sample(&mut self) -> Result<(), Error> {
        self.pictures().try_for_each(Picture::sample)
    }

    /// Draws for about a tenth of a second. True when a sample is complete.
    pub(crate) fn step(&mut self) -> Result<bool, Error> {
        match &mut self.other {
            Some(other) if other.samples() < self.picture.samples() => other.step(),
            Some(_) => self.picture.step().map(|_| false),
            None => self.picture.step(),
        }
    }

    /// What it shows now.
    pub(crate) fn picture(&self, mask: Option<(Outlined, Mask)>) -> Result<super::Picture, Error> {
        Ok(super::Picture {
            size: self.picture.size(),
            rgba: self.picture.resolve()?,
            other: self.other.as_ref().map(Picture::resolve).transpose()?,
            legend: None,
            mask,
            view: self.picture.view(),
            samples: self.samples(),
            took: self.picture.timings().sample,
        })
    }

    fn pictures(&mut self) -> impl Iterator<Item = &mut Picture> {
        std::iter::once(&mut self.picture).chain(self.other.as_mut())
    }
}
