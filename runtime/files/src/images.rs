//! Pictures as files.

use std::io::Cursor;
use std::path::Path;

use anyhow::{Context, Result, bail};
use exr::prelude::{Encoding, Image, SpecificChannels, WritableImage};

use crate::write;

/// The file formats of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Eight bits a channel in sRGB.
    Png,
    /// Linear radiance in 32-bit floating point.
    Exr,
}

impl Format {
    /// The format that the ending of a file's name asks for.
    pub fn of(path: &Path) -> Result<Self> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        match ending.as_deref() {
            Some("png") => Ok(Format::Png),
            Some("exr") => Ok(Format::Exr),
            _ => bail!("cannot tell the format of {}: end its name in .png or .exr", path.display()),
        }
    }
}

/// Writes eight-bit RGBA pixels, row by row from the top.
pub fn write_png(path: &Path, size: (u32, u32), rgba: Vec<u8>) -> Result<()> {
    write(path, &png(size, rgba)?)
}

/// Eight-bit RGBA pixels, row by row from the top, as the bytes of a file.
pub fn png((width, height): (u32, u32), rgba: Vec<u8>) -> Result<Vec<u8>> {
    let image = image::RgbaImage::from_raw(width, height, rgba).context("the picture has the wrong size")?;
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, image::ImageFormat::Png).context("cannot encode the picture")?;
    Ok(bytes.into_inner())
}

/// Writes linear RGB radiance, row by row from the top.
pub fn write_exr(path: &Path, size: (u32, u32), pixels: &[[f32; 4]]) -> Result<()> {
    write(path, &exr(size, pixels)?)
}

/// Linear RGB radiance, row by row from the top, as the bytes of a file.
pub fn exr((width, height): (u32, u32), pixels: &[[f32; 4]]) -> Result<Vec<u8>> {
    let (width, height) = (width as usize, height as usize);
    let channels = SpecificChannels::rgb(|at: exr::math::Vec2<usize>| {
        let [r, g, b, _] = pixels[at.y() * width + at.x()];
        (r, g, b)
    });
    let mut image = Image::from_channels((width, height), channels);
    image.layer_data.encoding = Encoding::SMALL_LOSSLESS;
    let mut bytes = Cursor::new(Vec::new());
    image.write().to_buffered(&mut bytes).context("cannot encode the picture")?;
    Ok(bytes.into_inner())
}
