//! What happens when the process is told to end: nothing stays behind that is not in its place.

use std::thread;

use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

/// Waits for signals on a thread of its own. Those that whoever started the process made it ignore, as `nohup` does, stay ignored.
pub(crate) fn watch() {
    let ignored = ignored();
    let signals = [SIGHUP, SIGINT, SIGTERM].into_iter().filter(|signal| ignored & (1 << (signal - 1)) == 0);
    // Without signals, the process ends as it would have: at once.
    let Ok(mut signals) = Signals::new(signals) else { return };
    let _ = thread::Builder::new().name("signals".to_owned()).spawn(move || {
        if let Some(signal) = signals.forever().next() {
            chiaro_files::abandon();
            let _ = emulate_default_handler(signal);
        }
    });
}

/// The signals that are ignored, each a bit, as Linux tells them. Elsewhere nobody tells, and the one that `nohup` ignores may be.
fn ignored() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(1 << (SIGHUP - 1))
}
