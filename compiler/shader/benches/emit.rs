//! How long emission and splicing take, which is part of the time from an edit to the picture.

use chiaro_field::{Facts, Graph, Node, NodeId, Operation, Point, PointId};
use chiaro_shader::{Template, splice, wgsl};
use chiaro_solid::{Affine, Scalar};
use chiaro_vocabulary::rows::{BOX, SPHERE};
use chiaro_vocabulary::{Bounds, Class};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// A union of balls and boxes at different places.
fn union_of(count: u32) -> Graph {
    let mut points = vec![Point::World];
    let mut nodes = Vec::new();
    for i in 0..count {
        let by = [f64::from(i % 10) * 10.0, f64::from(i / 10) * 10.0, 1.0].map(|c| Scalar::from(-c));
        points.push(Point::Affine(Affine::translation(by), PointId(0)));
        let (row, arguments) = if i % 2 == 0 { (&SPHERE, vec![4.0]) } else { (&BOX, vec![3.0, 4.0, 5.0]) };
        nodes.push(Node::Shape(row, arguments.into_iter().map(Scalar::from).collect(), PointId(i + 1)));
    }
    nodes.push(Node::Boolean(Operation::Union, None, (0..count).map(NodeId).collect()));
    let facts = Facts { bounds: Bounds::ALL, growth: f64::INFINITY, class: Class::Exact, lipschitz: 1.0 };
    Graph {
        facts: vec![facts; nodes.len()],
        spans: Vec::new(),
        root: NodeId(count),
        materials: Vec::new(),
        slots: Vec::new(),
        points,
        nodes,
    }
}

fn emission(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("emit");
    for count in [10, 100, 1000, 10_000] {
        let graph = union_of(count);
        group.bench_with_input(BenchmarkId::new("trace", count), &graph, |bencher, graph| {
            bencher.iter(|| splice(graph, Template::Trace));
        });
        if count <= 1000 {
            group.bench_with_input(BenchmarkId::new("wgsl", count), &graph, |bencher, graph| {
                bencher.iter(|| wgsl(graph));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, emission);
criterion_main!(benches);
