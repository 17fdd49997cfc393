//! From where to look, as the command line says it.

use std::str::FromStr;

use chiaro_compiler::solid::{Camera, Scalar};

/// A view: OpenSCAD's camera angles, and perhaps its target and distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct View {
    rotation: [f64; 3],
    target_and_distance: Option<([f64; 3], f64)>,
}

/// The named views, with OpenSCAD's angles in degrees.
const NAMED: [(&str, [f64; 3]); 7] = [
    ("front", [90.0, 0.0, 0.0]),
    ("back", [90.0, 0.0, 180.0]),
    ("left", [90.0, 0.0, -90.0]),
    ("right", [90.0, 0.0, 90.0]),
    ("top", [0.0, 0.0, 0.0]),
    ("bottom", [180.0, 0.0, 0.0]),
    ("diagonal", [55.0, 0.0, 25.0]),
];

impl View {
    /// `camera` as seen from here instead.
    pub(crate) fn apply(&self, camera: &Camera) -> Camera {
        let (target, distance) = self.target_and_distance.unzip();
        Camera {
            eye: None,
            target: target.map(|point| point.map(Scalar::from)),
            rotation: Some(self.rotation.map(Scalar::from)),
            distance: distance.map(Scalar::from),
            field_of_view: camera.field_of_view.clone(),
        }
    }
}

impl FromStr for View {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if let Some((_, rotation)) = NAMED.iter().find(|(name, _)| *name == text) {
            return Ok(View { rotation: *rotation, target_and_distance: None });
        }
        let numbers: Option<Vec<f64>> =
            text.split(',').map(|number| number.trim().parse().ok().filter(|value: &f64| value.is_finite())).collect();
        match numbers.as_deref() {
            Some(&[x, y, z]) => Ok(View { rotation: [x, y, z], target_and_distance: None }),
            Some(&[tx, ty, tz, x, y, z, distance]) if distance > 0.0 => {
                Ok(View { rotation: [x, y, z], target_and_distance: Some(([tx, ty, tz], distance)) })
            }
            _ => {
                let names: Vec<&str> = NAMED.iter().map(|(name, _)| *name).collect();
                Err(format!("write {}, RX,RY,RZ or TX,TY,TZ,RX,RY,RZ,DISTANCE", names.join(", ")))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_are_names_or_numbers() {
        assert_eq!("top".parse::<View>().unwrap().rotation, [0.0; 3]);
        assert_eq!("55,0,-25".parse::<View>().unwrap().rotation, [55.0, 0.0, -25.0]);
        assert_eq!("1,2,3,4,5,6,70".parse::<View>().unwrap().target_and_distance, Some(([1.0, 2.0, 3.0], 70.0)));
        for wrong in ["", "up", "1,2", "1,2,nan", "1,2,3,4,5,6,0", "1,2,3,4,5,6,7,8"] {
            assert!(wrong.parse::<View>().is_err(), "{wrong}");
        }
    }
}
