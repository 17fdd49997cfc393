//! The downhill simplex method of Nelder and Mead ("A Simplex Method for Function Minimization", 1965).

/// Where a function is least, nearby, and its value there.
pub(crate) fn minimized<const N: usize>(
    start: [f64; N],
    step: f64,
    rounds: usize,
    f: impl Fn(&[f64; N]) -> f64,
) -> ([f64; N], f64) {
    let valued = |point: [f64; N]| (f(&point), point);
    let mut simplex: Vec<(f64, [f64; N])> = vec![valued(start)];
    for axis in 0..N {
        let mut corner = start;
        corner[axis] += step;
        simplex.push(valued(corner));
    }
    for _ in 0..rounds {
        simplex.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (best, worst) = (simplex[0].0, simplex[N]);
        if worst.0 - best <= 1e-9 * best.abs() {
            break;
        }
        let mut middle = [0.0; N];
        for (_, corner) in &simplex[..N] {
            (0..N).for_each(|i| middle[i] += corner[i] / N as f64);
        }
        // From the worst corner through the middle of the others, this far beyond it.
        let along = |far: f64| {
            let mut point = [0.0; N];
            (0..N).for_each(|i| point[i] = middle[i] + far * (middle[i] - worst.1[i]));
            valued(point)
        };
        let reflected = along(1.0);
        let next = if reflected.0 < best {
            let expanded = along(2.0);
            if expanded.0 < reflected.0 { expanded } else { reflected }
        } else if reflected.0 < simplex[N - 1].0 {
            reflected
        } else {
            along(if reflected.0 < worst.0 { 0.5 } else { -0.5 })
        };
        if next.0 < worst.0 {
            simplex[N] = next;
            continue;
        }
        let nearest = simplex[0].1;
        for corner in &mut simplex[1..] {
            let mut point = corner.1;
            (0..N).for_each(|i| point[i] = 0.5 * (point[i] + nearest[i]));
            *corner = valued(point);
        }
    }
    simplex.sort_by(|a, b| a.0.total_cmp(&b.0));
    (simplex[0].1, simplex[0].0)
}
