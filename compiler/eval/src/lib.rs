//! Evaluates a syntax tree to a solid tree: values, scopes, built-ins, live numbers.
