//! Pictures that are kept in `pictures/`.

use std::path::{Path, PathBuf};

use chiaro_tests::blessing;
use chiaro_tests::likeness::{Difference, Pixels};
use image::RgbaImage;

/// The folder of kept pictures.
pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("pictures")
}

/// A picture that is kept, if it is there.
pub(crate) fn kept(name: &str) -> Option<RgbaImage> {
    image::open(folder().join(format!("{name}.png"))).ok().map(|picture| picture.into_rgba8())
}

/// An image's pixels.
pub(crate) fn pixels(image: &RgbaImage) -> Pixels<'_> {
    Pixels { size: [image.width(), image.height()], rgba: image.as_raw() }
}

/// What differs from the picture that is kept under a name, if that is more than allowed. When blessing, what was drawn
/// is kept instead; what looks the same stays as it is, so that another adapter rewrites nothing.
#[allow(dead_code, reason = "one of the tests that share this draws nothing")]
pub(crate) fn changed(name: &str, drawn: &RgbaImage, most: &Difference) -> Option<String> {
    let difference = kept(name).filter(|kept| kept.dimensions() == drawn.dimensions());
    let difference = difference.map(|kept| Difference::between(pixels(&kept), pixels(drawn)));
    if difference.is_some_and(|difference| difference.is_within(most)) {
        return None;
    }
    if blessing() {
        drawn.save(folder().join(format!("{name}.png"))).unwrap();
        return None;
    }
    let seen = std::env::temp_dir().join(format!("chiaro-{name}.png"));
    drawn.save(&seen).unwrap();
    let what = difference.map_or("is not kept in this size".to_owned(), |by| format!("differs by {by}"));
    Some(format!("{name} {what}; see {}; CHIARO_BLESS=1 accepts it", seen.display()))
}
