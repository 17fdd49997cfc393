//! Words that no parameter can be called in all targets, and a text's own words.

use naga::keywords::wgsl;

use crate::translate::Dialect;

/// Whether some target keeps a word for itself: as a keyword, the name of a type or of a function, or in its template.
pub(crate) fn is_reserved(word: &str) -> bool {
    let own = [&TEMPLATE_WORDS[..], &FUNCTIONS, &RUST_WORDS, wgsl::RESERVED].into_iter().flatten().copied();
    own.chain(Dialect::words()).any(|reserved| reserved == word) || is_type(word)
}

/// The identifiers of a text that are not in its comments.
pub(crate) fn words(text: &str) -> impl Iterator<Item = &str> {
    crate::translate::words(text).map(|(word, _)| word)
}

/// Whether a word is a type of numbers, or a vector or a matrix of them: `float`, `ivec3`, `half4x4`.
fn is_type(word: &str) -> bool {
    let element = word.trim_end_matches(|c: char| c.is_ascii_digit() || c == 'x');
    let counts = word[element.len()..].split('x').all(|count| count.len() == 1);
    TYPES.contains(&word) || counts && TYPES.contains(&element)
}

/// Words of the templates.
const TEMPLATE_WORDS: [&str; 24] = [
    "p",
    "time",
    "color",
    "position",
    "normal",
    "uv",
    "vertex",
    "fragment",
    "light",
    "scale",
    "texture",
    "pixel",
    "corner",
    "eye",
    "rays",
    "turn",
    "view",
    "zoom",
    "camera",
    "resolution",
    "mouse",
    "mod",
    "parameters",
    "main",
];

/// Functions that languages have beside those that exported code calls. GLSL ES lets nothing else have the name of one.
const FUNCTIONS: [&str; 17] = [
    "all",
    "any",
    "determinant",
    "equal",
    "fma",
    "frexp",
    "inverse",
    "isinf",
    "isnan",
    "ldexp",
    "lit",
    "log10",
    "modf",
    "mul",
    "noise",
    "not",
    "saturate",
];

/// Words of Rust, which parameters are members of structs in, beside those of WGSL.
const RUST_WORDS: [&str; 4] = ["box", "dyn", "gen", "in"];

/// Types of numbers, which a count of rows and columns may follow.
const TYPES: [&str; 29] = [
    "bool",
    "bvec",
    "char",
    "dmat",
    "double",
    "dvec",
    "float",
    "fvec",
    "half",
    "hvec",
    "int",
    "ivec",
    "long",
    "mat",
    "min10float",
    "min12int",
    "min16float",
    "min16int",
    "min16uint",
    "ptrdiff_t",
    "short",
    "size_t",
    "uchar",
    "uint",
    "ulong",
    "ushort",
    "uvec",
    "vec",
    "void",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_reserved_with_their_counts() {
        for word in ["float", "half4x4", "ivec3", "mat2", "void"] {
            assert!(is_reserved(word), "{word}");
        }
        for word in ["floating", "matx", "width", "vector_x"] {
            assert!(!is_reserved(word), "{word}");
        }
    }
}
