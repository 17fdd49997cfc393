//! Programs of every example.
use chiaro_compiler::export::{Dialect, Parameters, Source, translate};
use chiaro_compiler::shader::{Setting, one_pass};
use chiaro_compiler::{ModuleNames, Options, compile};

struct DiskWorld;

impl chiaro_compiler::World for DiskWorld {
    fn find(&self, from: &str, path: &str) -> Option<String> {
        let beside = std::path::Path::new(from).parent()?.join(path);
        beside.is_file().then(|| beside.to_string_lossy().into_owned())
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        std::fs::read(name).map_err(|error| error.to_string())
    }
}

#[test]
fn translations() {
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../examples_csg")).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            continue;
        }
        let compilation = compile(&DiskWorld, &path.to_string_lossy(), &Options::default());
        let names = ModuleNames::new(&compilation.sources);
        let scene = compilation.scene.unwrap();
        let setting = Setting {
            lipschitz: 1.0,
            epsilon: 1e-4,
            bounds: [[-50.0; 3], [50.0; 3]],
            floor: Some(0.0),
            azimuth: [1.0, 0.0],
            sky: None,
            lights: vec![],
        };
        let pass = one_pass(&setting);
        let source = Source::new(&scene.picture(), &scene.parameters, &|span| names.of(span), &pass).unwrap();
        let variable = |name: &str| name.to_owned();
        for (dialect, ending) in [(Dialect::Glsl, "glsl"), (Dialect::Hlsl, "hlsl"), (Dialect::Metal, "metal")] {
            let parameters =
                if dialect == Dialect::Metal { Parameters::Passed } else { Parameters::Variables(&variable) };
            let whole = source.with_uniforms(0, 0) + &pass;
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            std::fs::create_dir_all("/tmp/exports").unwrap();
            std::fs::write(format!("/tmp/exports/{name}.wgsl"), &whole).unwrap();
            let text = translate(&whole, dialect, parameters).unwrap();
            let mut head = String::new();
            for p in &source.parameters {
                head += &format!("uniform float {};\n", p.name);
            }
            std::fs::write(format!("/tmp/exports/{name}.{ending}"), head + &text).unwrap();
        }
    }
}
