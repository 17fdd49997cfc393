// Constants the vocabulary shares. All constants have the digits of double precision: the CPU reads them so.

const PI: f32 = 3.1415926535897932;
const TAU: f32 = 6.2831853071795865;
const ROOT_TWO: f32 = 1.4142135623730950;
const ROOT_THREE: f32 = 1.7320508075688773;

// Added nowhere, only compared with: keeps a division away from zero without being seen in a result.
const TINY: f32 = 1e-30;

// Farther than anything in a scene, yet its square is finite.
const FAR: f32 = 1e15;
