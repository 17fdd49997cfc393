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
fn dump(path: &str, v: &[f32]) {
    std::fs::write(path, v.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>()).unwrap();
}
// scratch truth N,N,N size scenes | scratch run out size scenes radii method:cells ...
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let size: u32 = a[3].parse().unwrap();
    let gpu = Gpu::new(&Preference::Any).unwrap();
    for scene in a[4].split(',') {
        let file =
            if scene.contains('/') { scene.to_string() } else { format!("/work/main/examples_csg/light/{scene}.csg") };
        let name = scene.rsplit('/').next().unwrap().trim_end_matches(".csg").to_string();
        let c = chiaro_compiler::compile(&W, &file, &Default::default());
        for d in &c.diagnostics {
            eprintln!("{}", d.message);
        }
        let s = c.scene.unwrap();
        let values = s.defaults();
        let model = Model::new(&gpu, &s.picture(), &values).unwrap();
        let view = View::framing(&s.camera, &values, &model.extent(&gpu).unwrap(), 1.0);
        let lighting = Lighting::of(&s.lights, &values, &view);
        let mut st = Study::new(&gpu, &model, view, [size, size]).unwrap();
        let rec = st.receivers().unwrap();
        let n = rec.iter().filter(|r| r.offset >= 0.0).count() as f64;
        dump(
            &format!("/tmp/lab/truth/{name}_{size}_rec"),
            &rec.iter().flat_map(|r| r.position.into_iter().chain([r.offset]).chain(r.normal)).collect::<Vec<f32>>(),
        );
        for (k, r) in a[5].split(',').enumerate() {
            for (l, source) in lighting.lights.iter().enumerate() {
                let light = match source.row.sphere_radius() {
                    Some(radius) if r != "-" => source.row.scaled(r.parse::<f64>().unwrap() / radius),
                    _ => source.row.scaled(if r == "-" { 1.0 } else { r.parse().unwrap() }),
                };
                let case = if lighting.lights.len() > 1 {
                    format!("{name}{l}_{size}_{r}")
                } else {
                    format!("{name}_{size}_{r}")
                };
                if a[1] == "truth" {
                    let rays: u32 = a[2].split(',').nth(k).unwrap().parse().unwrap();
                    let t = st.truth(&light, 0.0, rays).unwrap();
                    dump(&format!("/tmp/lab/truth/{case}_v"), &t.visible);
                    dump(&format!("/tmp/lab/truth/{case}_e0"), &t.irradiance);
                    println!("{case} {} {}", t.half_width, t.samples);
                } else {
                    for m in &a[6..] {
                        let (m, cells) = m.split_once(':').unwrap();
                        let o = st.run(Shadows::named(m).unwrap(), cells.parse().unwrap(), &light).unwrap();
                        let mut times = vec![o.time];
                        for _ in 0..std::env::var("REP").ok().and_then(|x| x.parse().ok()).unwrap_or(0) {
                            times
                                .push(st.run(Shadows::named(m).unwrap(), cells.parse().unwrap(), &light).unwrap().time);
                        }
                        times.sort();
                        dump(&format!("{}/{case}_{m}_{cells}_v", a[2]), &o.visible);
                        dump(&format!("{}/{case}_{m}_{cells}_e", a[2]), &o.evaluations);
                        println!(
                            "{case} {m} {cells} evals {:.2} max {} ms {:.1} nan {}",
                            o.evaluations.iter().map(|&x| x as f64).sum::<f64>() / n,
                            o.evaluations.iter().cloned().fold(0.0, f32::max),
                            times[times.len() / 2].as_secs_f64() * 1e3,
                            o.visible.iter().filter(|x| !x.is_finite()).count()
                        );
                    }
                }
            }
        }
    }
}
