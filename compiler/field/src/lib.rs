//! Lowers a solid tree to a field graph with sound facts, and evaluates it on the CPU.
