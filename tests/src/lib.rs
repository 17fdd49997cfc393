//! The test suite: scenes as text in, diagnostics, facts, distances and small pictures out.
