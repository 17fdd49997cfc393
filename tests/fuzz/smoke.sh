#!/usr/bin/env bash
# Runs every fuzz target for a moment (or for the seconds given), from the scenes of the repository as seeds.
set -euo pipefail
cd "$(dirname "$0")"
seconds=${1:-8}

# The fuzzer's coverage flags are unstable; this lets the stable compiler take them.
export RUSTC_BOOTSTRAP=1
command -v cargo-fuzz >/dev/null || cargo install --quiet --locked cargo-fuzz

# Those that take a text start from scenes; the others make programs of their bytes.
of_text=(parser format assist evaluator)
of_bytes=(programs field live meshes exports)
for target in "${of_text[@]}"; do
    mkdir -p "corpus/$target"
    for scene in ../scenes/*/*.csg ../../examples_csg/*.csg; do
        folder=$(basename "$(dirname "$scene")")
        cp "$scene" "corpus/$target/$folder-$(basename "$scene")"
    done
done
cargo fuzz build --fuzz-dir . --sanitizer none
for target in "${of_text[@]}" "${of_bytes[@]}"; do
    echo "fuzzing $target for $seconds seconds"
    cargo fuzz run --fuzz-dir . --sanitizer none "$target" -- \
        -max_total_time="$seconds" -seed=1 -timeout=60 -rss_limit_mb=4096 -max_len=4096 -verbosity=0 -print_final_stats=1 2>&1 |
        sed -n '/^stat::number_of_executed_units/p; /^stat::/!p'
done
