//! What the dialog can write.

use chiaro_compiler::export::Target;
use chiaro_exports::Format;
use egui::{ComboBox, Ui};

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Png,
    Exr,
    /// The text.
    Scene,
    Other(Format),
}

impl Kind {
    /// All of them, in groups with a heading.
    fn groups() -> [(&'static str, Vec<Kind>); 6] {
        let those = |is_it: fn(Format) -> bool| {
            Format::ALL.iter().copied().filter(|format| is_it(*format)).map(Kind::Other).collect::<Vec<_>>()
        };
        [
            ("Pictures", vec![Kind::Png, Kind::Exr]),
            ("Text", vec![Kind::Scene]),
            ("Meshes", those(|format| matches!(format, Format::Mesh(_)))),
            ("Functions for your own renderer", those(|format| matches!(format, Format::Shader(Target::Library(_))))),
            ("Programs that draw the scene", those(|format| matches!(format, Format::Shader(Target::Program(_))))),
            ("Pages and engines", those(|format| matches!(format, Format::Shader(Target::Package(_))))),
        ]
    }

    pub(super) fn name(self) -> String {
        match self {
            Kind::Scene => "OpenSCAD text".to_owned(),
            Kind::Png => "PNG picture".to_owned(),
            Kind::Exr => "EXR picture of radiance".to_owned(),
            Kind::Other(format) => format.name(),
        }
    }

    /// How the file's name ends; none, if it is a folder.
    pub(super) fn ending(self) -> Option<&'static str> {
        match self {
            Kind::Scene => Some("csg"),
            Kind::Png => Some("png"),
            Kind::Exr => Some("exr"),
            Kind::Other(format) => format.ending(),
        }
    }

    pub(super) fn is_picture(self) -> bool {
        matches!(self, Kind::Png | Kind::Exr)
    }

    /// Lets the user choose.
    pub(super) fn choose(&mut self, ui: &mut Ui) {
        let combo = ComboBox::from_id_salt("kind").selected_text(self.name()).width(ui.available_width()).height(480.0);
        let response = combo.show_ui(ui, |ui| {
            for (heading, kinds) in Self::groups() {
                ui.weak(heading);
                for kind in kinds {
                    ui.selectable_value(self, kind, kind.name());
                }
                ui.add_space(4.0);
            }
        });
        ui.ctx().accesskit_node_builder(response.response.id, |node| node.set_label("Format"));
    }
}
