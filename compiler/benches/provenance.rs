//! How long it takes from a click on a surface to the expressions that made it.

use chiaro_compiler::{Options, Scene, World, compile};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

struct Text(String);

impl World for Text {
    fn find(&self, _from: &str, _path: &str) -> Option<String> {
        None
    }

    fn read(&self, _name: &str) -> Result<Vec<u8>, String> {
        Ok(self.0.clone().into_bytes())
    }
}

/// Balls with a corner cut off: two primitives each. A parameter moves all of them.
fn stones(count: u32) -> String {
    format!(
        "lift = 0; // [0:0.1:1]
module stone(r) {{ difference() {{ sphere(r); translate([0, 0, r]) cube(r, center = true); }} }}
for (i = [0 : {}]) translate([3 * floor(i / 50), 3 * (i % 50), lift + (i * 7) % 5]) stone(1);",
        count / 2 - 1
    )
}

fn clicks(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("provenance");
    for count in [100, 1000, 10_000] {
        let compilation = compile(&Text(stones(count)), "stones.csg", &Options::default());
        let Some(scene): Option<&Scene> = compilation.scene.as_ref() else { return };
        let Ok(provenance) = scene.provenance(&compilation.sources) else { return };
        group.bench_with_input(BenchmarkId::new("new", count), scene, |bencher, scene| {
            bencher.iter(|| scene.provenance(&compilation.sources));
        });
        group.bench_function(BenchmarkId::new("first click", count), |bencher| {
            let mut lift = 0.0;
            bencher.iter(|| {
                // Whatever depends on the parameters is made anew.
                lift = 0.1 - lift;
                provenance.origin([-1.0, 0.0, lift], &[lift]).len()
            });
        });
        group.bench_function(BenchmarkId::new("click", count), |bencher| {
            bencher.iter(|| provenance.origin([2.0, 3.0 * 49.0, (99.0 * 7.0) % 5.0], &[0.0]).len());
        });
        group.bench_function(BenchmarkId::new("ray", count), |bencher| {
            bencher.iter(|| provenance.hit([-100.0, -100.0, 100.0], [1.0, 1.2, -0.9], &[0.0]));
        });
    }
    group.finish();
}

criterion_group!(benches, clicks);
criterion_main!(benches);
