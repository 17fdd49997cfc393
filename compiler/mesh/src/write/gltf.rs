//! glTF 2.0: JSON beside a buffer, or both in one GLB file.

use chiaro_field::Look;
use serde_json::{Value, json};

use super::Distinct;
use crate::model::{Corner, Model};

/// glTF's numbers for the types of components, and the uses of a view of the buffer.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// A glTF file, which refers to a buffer of that name, and the buffer.
pub fn gltf(model: &Model, buffer: &str) -> (Vec<u8>, Vec<u8>) {
    let (mut document, bytes) = document(model);
    document["buffers"][0]["uri"] = json!(uri(buffer));
    (format!("{document:#}\n").into_bytes(), bytes)
}

/// A relative reference to a file (RFC 3986): what isn't unreserved is escaped.
fn uri(name: &str) -> String {
    let escaped = |byte: u8| match byte {
        b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' => char::from(byte).to_string(),
        _ => format!("%{byte:02X}"),
    };
    name.bytes().map(escaped).collect()
}

/// A GLB file.
pub fn glb(model: &Model) -> Vec<u8> {
    let (document, mut buffer) = document(model);
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    buffer.resize(buffer.len().next_multiple_of(4), 0);
    let total = 12 + 8 + text.len() + 8 + buffer.len();
    let mut bytes = Vec::with_capacity(total);
    bytes.extend(b"glTF");
    bytes.extend(2u32.to_le_bytes());
    bytes.extend((total as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", text), (b"BIN\0", buffer)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

/// The triangles of one material.
struct Primitive {
    material: u32,
    /// Position, normal and colour of each vertex, as bits.
    vertices: Vec<[u32; 10]>,
    indices: Vec<u32>,
    /// Whether the vertices have colours of their own.
    blended: bool,
}

fn document(model: &Model) -> (Value, Vec<u8>) {
    let mut buffer = Buffer::default();
    let primitives = primitives(model);
    let mut materials = Vec::new();
    let mut meshes = Vec::new();
    for primitive in &primitives {
        meshes.push(primitive_object(primitive, materials.len(), &mut buffer));
        materials.push(material_object(&model.materials[primitive.material as usize], primitive.blended));
    }
    let mut document = json!({
        "asset": { "version": "2.0", "generator": "Chiaro" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": meshes }],
        "materials": materials,
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{ "byteLength": buffer.bytes.len() }],
    });
    let is_bright = |primitive: &Primitive| model.materials[primitive.material as usize].emission > 1.0;
    if primitives.iter().any(is_bright) {
        document["extensionsUsed"] = json!(["KHR_materials_emissive_strength"]);
    }
    (document, buffer.bytes)
}

fn primitives(model: &Model) -> Vec<Primitive> {
    let mut used = model.painted.clone();
    used.sort_unstable();
    used.dedup();
    used.into_iter().map(|material| primitive(model, material)).collect()
}

fn primitive(model: &Model, material: u32) -> Primitive {
    let own = model.materials[material as usize].color;
    let mut vertices: Distinct<[u32; 10]> = Distinct::new();
    let mut indices = Vec::new();
    let mut blended = false;
    let painted = model.painted.iter().enumerate().filter(|(_, painted)| **painted == material);
    for (triangle, _) in painted {
        for (point, corner) in model.mesh.corners(triangle).into_iter().zip(&model.corners[triangle]) {
            blended |= corner.color != own;
            indices.push(vertices.number(vertex(point, corner)));
        }
    }
    Primitive { material, vertices: vertices.items, indices, blended }
}

/// A vertex in metres with y upwards.
fn vertex(point: [f64; 3], corner: &Corner) -> [u32; 10] {
    let upright = |[x, y, z]: [f64; 3]| [x, z, -y];
    let point = upright(point).map(|coordinate| coordinate / 1000.0);
    let numbers = [&point[..], &upright(corner.normal), &corner.color].concat();
    std::array::from_fn(|index| (numbers[index] as f32).to_bits())
}

fn primitive_object(primitive: &Primitive, material: usize, buffer: &mut Buffer) -> Value {
    let mut attributes = json!({
        "POSITION": buffer.attribute(primitive, 0, "VEC3"),
        "NORMAL": buffer.attribute(primitive, 3, "VEC3"),
    });
    if primitive.blended {
        attributes["COLOR_0"] = json!(buffer.attribute(primitive, 6, "VEC4"));
    }
    json!({ "attributes": attributes, "indices": buffer.indices(primitive), "material": material })
}

/// What is 1 where vertices have the colours.
fn material_object(look: &Look, blended: bool) -> Value {
    let Look { color, roughness, metallic, emission, .. } = *look;
    let base = if blended { [1.0; 4] } else { color };
    let mut object = json!({
        "pbrMetallicRoughness": {
            "baseColorFactor": base,
            "metallicFactor": metallic.clamp(0.0, 1.0),
            "roughnessFactor": roughness.clamp(0.0, 1.0),
        },
    });
    if emission > 0.0 {
        let [red, green, blue, _] = color;
        object["emissiveFactor"] = json!([red, green, blue].map(|channel| channel * emission.min(1.0)));
        if emission > 1.0 {
            object["extensions"] = json!({ "KHR_materials_emissive_strength": { "emissiveStrength": emission } });
        }
    }
    if color[3] < 1.0 {
        object["alphaMode"] = json!("BLEND");
    }
    object
}

/// The buffer, and the views and accessors of it.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Adds components of the vertices from the given one on; answers the accessor's number.
    fn attribute(&mut self, primitive: &Primitive, first: usize, kind: &str) -> usize {
        let components = if kind == "VEC4" { 4 } else { 3 };
        let rows: Vec<&[u32]> = primitive.vertices.iter().map(|vertex| &vertex[first..first + components]).collect();
        let view = self.view(rows.iter().flat_map(|row| row.iter().copied()), VERTICES);
        let mut accessor = json!({
            "bufferView": view, "componentType": FLOAT, "count": rows.len(), "type": kind,
        });
        // Positions have to say how far they reach.
        if first == 0 {
            let extreme = |choose: fn(f32, f32) -> f32, start: f32| -> Vec<f32> {
                let of_axis = |axis: usize| rows.iter().map(|row| f32::from_bits(row[axis])).fold(start, choose);
                (0..components).map(of_axis).collect()
            };
            accessor["min"] = json!(extreme(f32::min, f32::INFINITY));
            accessor["max"] = json!(extreme(f32::max, f32::NEG_INFINITY));
        }
        self.accessor(accessor)
    }

    fn indices(&mut self, primitive: &Primitive) -> usize {
        let view = self.view(primitive.indices.iter().copied(), INDICES);
        let count = primitive.indices.len();
        self.accessor(json!({
            "bufferView": view, "componentType": UNSIGNED_INT, "count": count, "type": "SCALAR",
        }))
    }

    fn accessor(&mut self, accessor: Value) -> usize {
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn view(&mut self, words: impl Iterator<Item = u32>, target: u32) -> usize {
        let start = self.bytes.len();
        self.bytes.extend(words.flat_map(u32::to_le_bytes));
        let length = self.bytes.len() - start;
        self.views.push(json!({ "buffer": 0, "byteOffset": start, "byteLength": length, "target": target }));
        self.views.len() - 1
    }
}
