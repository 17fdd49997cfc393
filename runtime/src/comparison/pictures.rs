//! The pictures of a report: of V, shaded, and of the local SSIM; and V as numbers.

use std::path::{Path, PathBuf};

use anyhow::Result;
use chiaro_files::images;

use super::metrics::shaded;

/// Where a case's pictures go, and what they have in common.
pub(crate) struct Pictures<'a> {
    pub(crate) folder: &'a Path,
    /// The case's index in the report.
    pub(crate) index: usize,
    pub(crate) size: (u32, u32),
    /// Which pixels see a surface.
    pub(crate) mask: &'a [bool],
    /// What V is multiplied by in the shaded picture, from 0 to 1.
    pub(crate) shade: &'a [f32],
}

impl Pictures<'_> {
    /// Writes what is seen of the light, as a picture, shaded, and as numbers.
    pub(crate) fn write(&self, method: &str, visible: &[f32]) -> Result<()> {
        self.grey(&self.path(method, "v.png"), visible)?;
        self.grey(&self.path(method, "shaded.png"), &shaded(self.mask, visible, self.shade))?;
        let rows: Vec<[f32; 4]> = visible.iter().map(|&v| [v, v, v, 1.0]).collect();
        images::write_exr(&self.path(method, "v.exr"), self.size, &rows)
    }

    /// Writes the map of the local SSIM of V.
    pub(crate) fn write_map(&self, method: &str, map: &[f32]) -> Result<()> {
        self.grey(&self.path(method, "ssim.png"), map)
    }

    fn path(&self, method: &str, kind: &str) -> PathBuf {
        self.folder.join(format!("{}_{kind}", stem(self.index, method)))
    }

    fn grey(&self, path: &Path, values: &[f32]) -> Result<()> {
        let pixel = |&value: &f32| {
            let byte = (255.0 * value.clamp(0.0, 1.0)).round() as u8;
            [byte, byte, byte, 255]
        };
        images::write_png(path, self.size, values.iter().flat_map(pixel).collect())
    }
}

/// How the names of a method's pictures begin.
pub(crate) fn stem(index: usize, method: &str) -> String {
    format!("{index}_{}", method.replace(' ', "_"))
}
