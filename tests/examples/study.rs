use chiaro_compiler::shader::Shadows;
use chiaro_render::*;
struct W;
impl chiaro_compiler::World for W {
    fn find(&self, _: &str, _: &str) -> Option<String> {
        None
    }
    fn read(&self, name: &str) -> std::result::Result<Vec<u8>, String> {
        std::fs::read(name).map_err(|e| e.to_string())
    }
}
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let (file, size, method, cells, eye, at, fov, light, r, out) = (
        &a[1],
        a[2].parse::<u32>().unwrap(),
        &a[3],
        a[4].parse::<u32>().unwrap(),
        v(&a[5]),
        v(&a[6]),
        a[7].parse::<f64>().unwrap(),
        v(&a[8]),
        &a[9],
        &a[10],
    );
    let c = chiaro_compiler::compile(&W, file, &Default::default());
    for d in &c.diagnostics {
        eprintln!("{}", d.message);
    }
    let s = c.scene.unwrap();
    let gpu = Gpu::new(&Preference::Any).unwrap();
    let model = Model::new(&gpu, &s.picture(), &s.defaults()).unwrap();
    let d = [0, 1, 2].map(|i| at[i] - eye[i]);
    let dist = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
    let pitch = (-d[2] / dist).acos().to_degrees(); // rotation x: angle from straight down
    let rz = (-d[0]).atan2(d[1]).to_degrees();
    let view = View { target: at, rotation: [pitch, 0.0, rz], distance: dist, field_of_view: fov };
    let mut st = Study::new(&gpu, &model, view, [size, size]).unwrap();
    let rec = st.receivers().unwrap();
    use std::io::Write;
    let mut f = std::fs::File::create(format!("{out}_rec.bin")).unwrap();
    for r in &rec {
        for x in r.position.iter().chain([&r.offset]).chain(&r.normal) {
            f.write_all(&x.to_le_bytes()).unwrap();
        }
    }
    for r in r.split(',') {
        let radius: f64 = r.parse().unwrap();
        let light = LightRow::sphere(light, radius);
        let o = st.run(Shadows::named(method).unwrap(), cells, &light).unwrap();
        let mut f = std::fs::File::create(format!("{out}_{r}.bin")).unwrap();
        for i in 0..o.visible.len() {
            for x in [o.visible[i], o.bare[i], o.evaluations[i]] {
                f.write_all(&x.to_le_bytes()).unwrap();
            }
        }
        let n = rec.iter().filter(|r| r.offset >= 0.0).count() as f64;
        println!(
            "{method} {cells} R={r}: evals {:.2} max {} V {:.4} {:?}",
            o.evaluations.iter().map(|&x| x as f64).sum::<f64>() / n,
            o.evaluations.iter().cloned().fold(0.0, f32::max),
            o.visible.iter().zip(&rec).filter(|(_, r)| r.offset >= 0.0).map(|(&v, _)| v as f64).sum::<f64>() / n,
            o.time
        );
    }
}
fn v(s: &str) -> [f64; 3] {
    let x: Vec<f64> = s.split(',').map(|x| x.parse().unwrap()).collect();
    [x[0], x[1], x[2]]
}
