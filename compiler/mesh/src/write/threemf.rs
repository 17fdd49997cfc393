//! 3MF: a zip file with the mesh as XML, by the core specification and, where colours blend, the materials extension.

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};

use zip::ZipWriter;
use zip::result::ZipResult;
use zip::write::SimpleFileOptions;

use super::{Distinct, srgb_with_opacity};
use crate::model::Model;

const CONTENT_TYPES: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"#;

const RELATIONSHIPS: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"#;

const HEAD: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02">
<metadata name="Application">Chiaro</metadata>
<resources>
"#;

/// A 3MF file, in millimetres, with each triangle's colour, of an object that is called so.
pub fn threemf(model: &Model, name: &str) -> Vec<u8> {
    let Ok(bytes) = packed(model, name) else { unreachable!("writing to memory does not fail") };
    bytes
}

fn packed(model: &Model, name: &str) -> ZipResult<Vec<u8>> {
    let mut package = ZipWriter::new(Cursor::new(Vec::new()));
    let text = xml(model, name);
    for (name, text) in
        [("[Content_Types].xml", CONTENT_TYPES), ("_rels/.rels", RELATIONSHIPS), ("3D/3dmodel.model", &text)]
    {
        package.start_file(name, SimpleFileOptions::default())?;
        package.write_all(text.as_bytes())?;
    }
    Ok(package.finish()?.into_inner())
}

fn xml(model: &Model, name: &str) -> String {
    let (colors, painted) = if model.is_blended() { color_group(model) } else { base_materials(model) };
    let name = attribute(name);
    let mut text = format!(
        "{HEAD}{colors}<object id=\"2\" name=\"{name}\" type=\"model\" pid=\"1\" pindex=\"0\">\n<mesh>\n<vertices>\n"
    );
    for vertex in &model.mesh.vertices {
        let [x, y, z] = vertex.map(|coordinate| coordinate as f32);
        let _ = writeln!(text, "<vertex x=\"{x}\" y=\"{y}\" z=\"{z}\"/>");
    }
    text += "</vertices>\n<triangles>\n";
    for ([a, b, c], paint) in model.mesh.triangles.iter().zip(painted) {
        let _ = writeln!(text, "<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\" pid=\"1\" {paint}/>");
    }
    text += "</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n<item objectid=\"2\"/>\n</build>\n</model>\n";
    text
}

/// A material for each colour, and which one each triangle has.
fn base_materials(model: &Model) -> (String, Vec<String>) {
    let mut colors: Distinct<[u8; 4]> = Distinct::new();
    let painted = model.painted.iter().map(|material| srgb_with_opacity(model.materials[*material as usize].color));
    let painted = painted.map(|color| format!("p1=\"{}\"", colors.number(color))).collect();
    let bases = colors.items.iter().map(|color| {
        let hexadecimal = hexadecimal(*color);
        format!("<base name=\"{hexadecimal}\" displaycolor=\"{hexadecimal}\"/>\n")
    });
    (format!("<basematerials id=\"1\">\n{}</basematerials>\n", bases.collect::<String>()), painted)
}

/// All colours, and which ones the corners of each triangle have.
fn color_group(model: &Model) -> (String, Vec<String>) {
    let mut colors: Distinct<[u8; 4]> = Distinct::new();
    let painted = (model.corners.iter())
        .map(|corners| {
            let [a, b, c] = corners.map(|corner| colors.number(srgb_with_opacity(corner.color)));
            format!("p1=\"{a}\" p2=\"{b}\" p3=\"{c}\"")
        })
        .collect();
    let listed = colors.items.iter().map(|color| format!("<m:color color=\"{}\"/>\n", hexadecimal(*color)));
    (format!("<m:colorgroup id=\"1\">\n{}</m:colorgroup>\n", listed.collect::<String>()), painted)
}

fn hexadecimal([red, green, blue, opacity]: [u8; 4]) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}{opacity:02X}")
}

/// A text as the value of an attribute, without the characters that XML can't have.
fn attribute(text: &str) -> String {
    let plain = text.chars().filter(|c| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}'));
    plain.collect::<String>().replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_attributes() {
        assert_eq!(attribute("a \"b\" <c> & d\n"), "a &quot;b&quot; &lt;c> &amp; d");
    }
}
