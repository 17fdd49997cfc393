//! The compiler from CSG scenes to shader code: the whole pipeline behind one call.
