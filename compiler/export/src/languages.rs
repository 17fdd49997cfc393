//! Libraries and programs in shading languages.

use chiaro_syntax::Diagnostic;
use naga::back::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

use crate::context::Context;
use crate::subject::{Scene, Text};
use crate::target::{File, Language};
use crate::translate::{Dialect, Parameters, translate};

const WGSL_LIBRARY: &str = include_str!("../packages/languages/library.wgsl");
const WGSL_PROGRAM: &str = include_str!("../packages/languages/program.wgsl");
const GLSL_LIBRARY: &str = include_str!("../packages/languages/library.glsl");
const GLSL_PROGRAM: &str = include_str!("../packages/languages/program.glsl");
/// Uniforms in blocks, as Vulkan demands.
const GLSL_450_LIBRARY: &str = include_str!("../packages/languages/library_450.glsl");
const GLSL_450_PROGRAM: &str = include_str!("../packages/languages/program_450.glsl");
const HLSL_LIBRARY: &str = include_str!("../packages/languages/library.hlsl");
const HLSL_PROGRAM: &str = include_str!("../packages/languages/program.hlsl");
const METAL_LIBRARY: &str = include_str!("../packages/languages/library.metal");
const METAL_PROGRAM: &str = include_str!("../packages/languages/program.metal");

/// The functions of a scene.
pub(crate) fn library(scene: &Scene, language: Language) -> Result<Vec<File>, Diagnostic> {
    let text = scene.library()?;
    let template = match language {
        Language::Wgsl => WGSL_LIBRARY,
        Language::Glsl330 | Language::GlslEs300 => GLSL_LIBRARY,
        Language::Glsl450 => GLSL_450_LIBRARY,
        Language::Hlsl => HLSL_LIBRARY,
        Language::Metal => METAL_LIBRARY,
        Language::SpirV => {
            let message = "SPIR-V has no libraries of functions";
            return Err(Diagnostic::error(None, message).with_hint("export a whole program: --program"));
        }
    };
    Ok(File::alone(filled(scene, &text, language, template)?))
}

/// A program that draws a scene.
pub(crate) fn program(scene: &Scene, language: Language) -> Result<Vec<File>, Diagnostic> {
    let text = scene.program()?;
    match language {
        Language::Wgsl => Ok(File::alone(filled(scene, &text, language, WGSL_PROGRAM)?)),
        Language::Glsl330 | Language::Glsl450 | Language::GlslEs300 => {
            let (version, template) = match language {
                Language::Glsl330 => ("#version 330 core\n", GLSL_PROGRAM),
                Language::Glsl450 => ("#version 450 core\n", GLSL_450_PROGRAM),
                _ => ("#version 300 es\nprecision highp float;\nprecision highp int;\n", GLSL_PROGRAM),
            };
            Ok(File::alone(version.to_owned() + &filled(scene, &text, language, template)?))
        }
        Language::Hlsl => Ok(File::alone(filled(scene, &text, language, HLSL_PROGRAM)?)),
        Language::Metal => Ok(File::alone(filled(scene, &text, language, METAL_PROGRAM)?)),
        Language::SpirV => Ok(File::alone(spirv(&filled(scene, &text, Language::Wgsl, WGSL_PROGRAM)?)?)),
    }
}

fn filled(scene: &Scene, text: &Text, language: Language, template: &str) -> Result<String, Diagnostic> {
    let code = code(text, language)?;
    Context::new(scene, &text.source.parameters)?.fill(template, &code)
}

/// A scene's text in a language.
fn code(text: &Text, language: Language) -> Result<String, Diagnostic> {
    match language {
        Language::Wgsl | Language::SpirV => Ok(text.wgsl(0)),
        Language::Glsl330 | Language::Glsl450 | Language::GlslEs300 => {
            translated(text, Dialect::Glsl, &|name| name.into())
        }
        Language::Hlsl => translated(text, Dialect::Hlsl, &|name| name.into()),
        Language::Metal => translation(text, Dialect::Metal, Parameters::Passed),
    }
}

/// A scene's text in another language, with live parameters as variables that are called so.
pub(crate) fn translated(text: &Text, dialect: Dialect, name: &dyn Fn(&str) -> String) -> Result<String, Diagnostic> {
    translation(text, dialect, Parameters::Variables(name))
}

fn translation(text: &Text, dialect: Dialect, parameters: Parameters) -> Result<String, Diagnostic> {
    translate(&text.wgsl(0), dialect, parameters).map_err(|error| Diagnostic::error(None, error.to_string()))
}

/// A WGSL program's words of SPIR-V, the least significant byte first.
fn spirv(wgsl: &str) -> Result<Vec<u8>, Diagnostic> {
    let failed = |error: String| Diagnostic::error(None, format!("this scene makes no SPIR-V: {error}"));
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|error| failed(error.emit_to_string(wgsl)))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| failed(error.emit_to_string(wgsl)))?;
    let mut options = spv::Options::default();
    options.flags.remove(spv::WriterFlags::ADJUST_COORDINATE_SPACE);
    options.force_loop_bounding = false;
    let words = spv::write_vec(&module, &info, &options, None).map_err(|error| failed(error.to_string()))?;
    Ok(words.iter().flat_map(|word| word.to_le_bytes()).collect())
}
