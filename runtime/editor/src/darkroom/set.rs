//! A scene before the camera.

use std::sync::Arc;

use chiaro_compiler::Scene;
use chiaro_render::{Floor, Gpu, Lighting, Model, Picture, View};

use super::{Shot, aspect, said, seen};
use crate::studio::Wanted;
use crate::worker::Progress;

/// A scene with its picture in progress.
pub(super) struct Set {
    gpu: Gpu,
    scene: Arc<Scene>,
    model: Model,
    wanted: Wanted,
    /// Where the floor is, if there is one: a film has it in one place.
    floor: f64,
    /// The first view: the studio's lights stand as it sees them.
    first_view: View,
    pub(super) picture: Picture,
}

impl Set {
    pub(super) fn new(gpu: &Gpu, shot: &Shot) -> Result<Self, String> {
        let values = shot.wanted.parameters(&shot.scene);
        let model = Model::new(gpu, &shot.scene.picture(), &values).map_err(said)?;
        let floor = model.extent(gpu).map_err(said)?.min[2];
        let first_view = View::framing_model(gpu, &model, &shot.scene.camera, aspect(shot.size)).map_err(said)?;
        let picture = Picture::new(gpu, &model, first_view, shot.size).map_err(said)?;
        let (scene, wanted) = (shot.scene.clone(), shot.wanted.clone());
        let mut set = Self { gpu: gpu.clone(), scene, model, wanted, floor, first_view, picture };
        set.prepare()?;
        Ok(set)
    }

    /// The next shot of a film: of the same scene at another time, or of another scene seen in the same way.
    pub(super) fn go_on(&mut self, shot: &Shot) -> Result<(), String> {
        let values = shot.wanted.parameters(&shot.scene);
        self.wanted = shot.wanted.clone();
        if Arc::ptr_eq(&self.scene, &shot.scene) {
            self.picture.set_parameters(&values).map_err(said)?;
            return self.place();
        }
        self.model = Model::new(&self.gpu, &shot.scene.picture(), &values).map_err(said)?;
        self.picture = Picture::new(&self.gpu, &self.model, self.first_view, self.picture.size()).map_err(said)?;
        self.scene = shot.scene.clone();
        self.prepare()
    }

    fn prepare(&mut self) -> Result<(), String> {
        self.picture.set_exposure(self.wanted.exposure.exp2());
        let floor = if self.wanted.floor { Floor::At(self.floor) } else { Floor::Missing };
        self.picture.set_floor(floor).map_err(said)?;
        self.picture.set_direct(self.wanted.direct).map_err(said)?;
        self.place()
    }

    /// Puts the camera and the lights where they are now.
    fn place(&mut self) -> Result<(), String> {
        let values = self.wanted.parameters(&self.scene);
        let view = seen(&self.gpu, &self.model, &self.wanted.eye, &self.scene, self.picture.size())?;
        self.picture.set_view(view).map_err(said)?;
        if !self.scene.lights.is_empty() {
            self.picture.set_lighting(Lighting::of(&self.scene.lights, &values, &view)).map_err(said)?;
        }
        Ok(())
    }

    /// Draws that many samples; false if it was cancelled.
    pub(super) fn draw(&mut self, samples: u32, progress: &Progress) -> Result<bool, String> {
        for _ in 0..samples {
            while !self.picture.step().map_err(said)? {
                if progress.is_cancelled() {
                    return Ok(false);
                }
            }
            if progress.is_cancelled() {
                return Ok(false);
            }
            progress.step();
        }
        Ok(true)
    }
}
