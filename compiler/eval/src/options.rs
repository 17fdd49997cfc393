//! What an evaluation depends on besides the text.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use chiaro_vocabulary::Interval;

use crate::Facets;

/// The stack, in bytes, that the thread which calls [`evaluate`](crate::evaluate) needs, so that scenes may recurse
/// as deeply as [`Limits`] allow.
pub const STACK_BYTES: usize = 1 << 29;

/// Where scenes come from: a file system, an editor's buffers, or a map in a test.
pub trait World: Sync {
    /// Finds the file that `path` names in a `use` or `include` statement of the file `from`: its full name, the
    /// same for the same file whichever way it was named.
    fn find(&self, from: &str, path: &str) -> Option<String>;

    /// Reads the file of that full name, or says why it can't be read.
    fn read(&self, name: &str) -> Result<Vec<u8>, String>;
}

/// The user's choices.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Values for variables of the scene's top level: name and expression.
    pub definitions: Vec<(String, String)>,
    /// What `$fn` does to curves.
    pub facets: Facets,
    /// Whether Customizer parameters and `$t` are constants, instead of live.
    pub frozen: bool,
    /// Numbers in the scene's own text that are live, such as one that an editor drags.
    pub live_literals: Vec<LiveLiteral>,
    /// Set from another thread, ends the evaluation with an error.
    pub cancelled: Option<Arc<AtomicBool>>,
    /// What no scene may exceed.
    pub limits: Limits,
}

/// A number in the text that moves without a recompilation, as a parameter of its own whose span is the number's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiveLiteral {
    /// Where in the scene's own file it starts, in bytes.
    pub start: usize,
    /// The values it may take, its present one among them; finite.
    pub range: Interval,
}

/// Limits that keep any scene from exhausting time or memory.
#[derive(Clone, Debug)]
pub struct Limits {
    /// Rounds of one loop, calls of a function by itself in tail position, and numbers of a range that is listed.
    pub rounds: u32,
    /// Work in total: expressions evaluated, list elements made or compared.
    pub steps: u64,
    /// Expressions, calls and instances nested at one time.
    pub nesting: u32,
    /// The depth of the solid tree, of which every walk by recursion can be sure.
    pub solid_depth: u32,
    /// Solids in total.
    pub solids: u64,
    /// Elements of one list.
    pub list_length: usize,
    /// Values in one list, those of its lists included.
    pub list_values: u64,
    /// Values in all lists that there are at one time.
    pub held_values: u64,
    /// Levels of lists in a list.
    pub list_depth: u32,
    /// Bytes of one text.
    pub string_bytes: usize,
    /// Bytes of all texts that are made.
    pub text_bytes: u64,
    /// Files read, and statements in all of them where an included file counts each time.
    pub statements: usize,
    /// Lines of `echo` output.
    pub echoes: usize,
    /// Bytes of `echo` output.
    pub echo_bytes: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            rounds: 1_000_000,
            steps: 150_000_000,
            nesting: 60_000,
            solid_depth: 1_000,
            solids: 1_000_000,
            list_length: 2_000_000,
            list_values: 10_000_000,
            held_values: 30_000_000,
            list_depth: 20_000,
            string_bytes: 2_000_000,
            text_bytes: 1_000_000_000,
            statements: 1_000_000,
            echoes: 10_000,
            echo_bytes: 50_000_000,
        }
    }
}
