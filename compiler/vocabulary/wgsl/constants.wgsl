// Constants the vocabulary shares.

const PI: f32 = 3.14159265358979;
const TAU: f32 = 6.28318530717959;

// Added nowhere, only compared with: keeps a division away from zero without being seen in a result.
const TINY: f32 = 1e-30;

// Farther than anything in a scene, yet its square is finite.
const FAR: f32 = 1e15;
