// The numbers that samples are drawn with.
//
// Theory: Each pair of dimensions of each pixel has its own Owen-scrambled (0,2)-sequence of Sobol', so that any 2ⁿ
// successive samples are well spread; shuffling the order of each pair's points keeps the pairs independent. The hash
// that scrambles is Laine and Karras's (2011) as in Burley, "Practical Hash-based Owen Scrambling" (JCGT 2020).
// Practice: a pair costs some thirty integer operations and no memory.

/// A well-mixed number from two (the finaliser of MurmurHash3).
fn hash(a: u32, b: u32) -> u32 {
    var x = a ^ (b * 0x9e3779b9u + 0x7f4a7c15u);
    x = (x ^ (x >> 16u)) * 0x85ebca6bu;
    x = (x ^ (x >> 13u)) * 0xc2b2ae35u;
    return x ^ (x >> 16u);
}

/// Owen's nested scrambling of a number whose bits stand in reverse, the most significant one last.
fn scramble_reversed(bits: u32, seed: u32) -> u32 {
    var x = bits + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

/// The second Sobol' dimension of an index, its bits in reverse: Pascal's triangle modulo 2 times the index's bits.
fn sobol_second_reversed(index: u32) -> u32 {
    var x = index;
    x ^= x >> 16u;
    x ^= (x >> 8u) & 0x00ff00ffu;
    x ^= (x >> 4u) & 0x0f0f0f0fu;
    x ^= (x >> 2u) & 0x33333333u;
    x ^= (x >> 1u) & 0x55555555u;
    return x;
}

/// A number from 0 to below 1 from 32 bits.
fn unit_interval(bits: u32) -> f32 {
    return f32(bits >> 8u) / 16777216.0;
}

/// The point of the unit square that a pixel's sample has in one pair of dimensions.
fn unit_square(pixel_seed: u32, sample: u32, pair: u32) -> vec2<f32> {
    let seed = hash(pixel_seed, pair);
    let index = reverseBits(scramble_reversed(reverseBits(sample), seed));
    let first = reverseBits(scramble_reversed(index, hash(seed, 1u)));
    let second = reverseBits(scramble_reversed(sobol_second_reversed(index), hash(seed, 2u)));
    return vec2<f32>(unit_interval(first), unit_interval(second));
}

/// A point of the unit disc, evenly, from one of the unit square.
fn unit_disc(u: vec2<f32>) -> vec2<f32> {
    let angle = TAU * u.y;
    return sqrt(u.x) * vec2<f32>(cos(angle), sin(angle));
}

/// The pixel filter: a tent with a radius of one pixel.
fn tent(u: vec2<f32>) -> vec2<f32> {
    let v = 2.0 * u - 1.0;
    return sign(v) * (1.0 - sqrt(1.0 - abs(v)));
}

/// A direction about n, by the cosine of the angle between.
fn cosine_drawn(n: vec3<f32>, u: vec2<f32>) -> vec3<f32> {
    let d = unit_disc(u);
    return normalize(basis_across(n) * vec3<f32>(d, sqrt(max(1.0 - dot(d, d), 1e-4))));
}
