//! Emits a field graph as a naga module and splices it into the tracing templates.
