#!/usr/bin/env bash
# Runs every fuzz target for a moment (or for the seconds given), from the scenes of the repository as seeds.
set -euo pipefail
cd "$(dirname "$0")"
seconds=${1:-20}

# The fuzzer's coverage flags are unstable; this lets the stable compiler take them.
export RUSTC_BOOTSTRAP=1
command -v cargo-fuzz >/dev/null || cargo install --quiet --locked cargo-fuzz

for target in parser evaluator; do
    mkdir -p "corpus/$target"
    cp ../scenes/*/*.csg ../scenes/*.csg ../../examples_csg/*.csg "corpus/$target/" 2>/dev/null || true
done
for target in parser evaluator field; do
    echo "fuzzing $target for $seconds seconds"
    cargo fuzz run --fuzz-dir . --sanitizer none "$target" -- \
        -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -max_len=4096 -verbosity=0
done
