//! A picture in progress, and perhaps its twin by another light algorithm.

use chiaro_compiler::Scene;
use chiaro_render::{Direct, Error, Floor, Lighting, Picture, View};

use super::super::{Subject, Wanted};

/// Pictures of one size, with what they show.
pub(crate) struct Canvas {
    picture: Picture,
    other: Option<Picture>,
    scene: std::sync::Arc<Scene>,
    shown: Option<Shown>,
    /// No sample is in progress: all pixels have the same number of them.
    is_even: bool,
    /// What it showed when it was even.
    resolved: Option<Resolved>,
}

/// The bytes of a canvas.
#[derive(Clone)]
struct Resolved {
    rgba: Vec<u8>,
    other: Option<Vec<u8>>,
}

/// What decides a picture besides its field and size.
#[derive(Clone, PartialEq)]
struct Shown {
    view: View,
    values: Vec<f64>,
    floor: bool,
    direct: [Option<Direct>; 2],
    /// The scene's own lights; none in the studio.
    lighting: Option<Lighting>,
}

impl Canvas {
    pub(crate) fn new(subject: &Subject, size: [u32; 2], first_view: View, wanted: &Wanted) -> Result<Self, Error> {
        let values = wanted.parameters(&subject.scene);
        // Pictures look for the floor when they are made: the live numbers have to be in their places by then.
        subject.model.set_parameters(&subject.gpu, &values)?;
        let picture = || Picture::new(&subject.gpu, &subject.model, first_view, size);
        let other = if wanted.other.is_some() { Some(picture()?) } else { None };
        let shown = Shown { view: first_view, values, floor: true, direct: [None; 2], lighting: None };
        let (picture, scene) = (picture()?, subject.scene.clone());
        Ok(Self { picture, other, scene, shown: Some(shown), is_even: true, resolved: None })
    }

    /// Goes on with a subject that is drawn like the one before.
    pub(crate) fn adopt(&mut self, subject: &Subject) {
        self.scene = subject.scene.clone();
    }

    /// Makes it show what is wanted, keeping the samples it has if that is what it shows already.
    pub(crate) fn prepare(&mut self, wanted: &Wanted, view: View) -> Result<(), Error> {
        let values = wanted.parameters(&self.scene);
        let direct = [Some(wanted.direct), wanted.other];
        let has_lights = !self.scene.lights.is_empty();
        let lighting = has_lights.then(|| Lighting::of(&self.scene.lights, &values, &view));
        let now = Shown { view, values, floor: wanted.floor, direct, lighting };
        let exposure = wanted.exposure.exp2();
        if self.shown.as_ref() != Some(&now) {
            (self.resolved, self.is_even) = (None, true);
        }
        // If it fails halfway, everything is set again.
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
        if before.is_none_or(|before| before.lighting != now.lighting)
            && let Some(lighting) = &now.lighting
        {
            self.pictures().try_for_each(|picture| picture.set_lighting(lighting.clone()))?;
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
        self.pictures().try_for_each(Picture::sample)?;
        self.is_even = true;
        Ok(())
    }

    /// Draws for about a tenth of a second. True when a sample is complete.
    pub(crate) fn step(&mut self) -> Result<bool, Error> {
        self.is_even = match &mut self.other {
            Some(other) if other.samples() < self.picture.samples() => other.step()?,
            Some(_) => self.picture.step().map(|_| false)?,
            None => self.picture.step()?,
        };
        Ok(self.is_even)
    }

    /// What it shows now; within a sample, what it showed before that.
    pub(crate) fn picture(&mut self, over: super::Over) -> Result<super::Picture, Error> {
        let before = self.resolved.take().filter(|_| !self.is_even);
        let resolved = before.map_or_else(|| self.resolve(), Ok)?;
        let Resolved { rgba, other } = self.resolved.insert(resolved).clone();
        Ok(super::Picture {
            size: self.picture.size(),
            rgba,
            other,
            legend: None,
            over,
            view: self.picture.view(),
            samples: self.samples(),
            took: self.picture.timings().sample,
        })
    }

    fn resolve(&self) -> Result<Resolved, Error> {
        Ok(Resolved { rgba: self.picture.resolve()?, other: self.other.as_ref().map(Picture::resolve).transpose()? })
    }

    fn pictures(&mut self) -> impl Iterator<Item = &mut Picture> {
        std::iter::once(&mut self.picture).chain(self.other.as_mut())
    }
}
