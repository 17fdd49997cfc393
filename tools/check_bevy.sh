#!/usr/bin/env bash
# Builds the crates that `chiaro export --to bevy` writes, with clippy's warnings as errors, runs their example on a software driver, and
# tells how near the picture of a scene comes to `chiaro render --one-pass`. Needs a Rust that Bevy 0.19 takes (1.95), Debian's xvfb and
# mesa-vulkan-drivers, the Python packages numpy and pillow, and target/release/chiaro, or what CHIARO names. Bevy is built once, into
# target/bevy, which takes minutes. Pictures are left in the folder that PICTURES names, if it does.
#
#     tools/check_bevy.sh [SCENE...]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
chiaro=${CHIARO:-$root/target/release/chiaro}
work=$root/target/bevy
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$work/target} CARGO_PROFILE_DEV_DEBUG=false CARGO_INCREMENTAL=0
# A window of 1280 × 960 points has these pixels then.
export WGPU_BACKEND=vulkan WINIT_X11_SCALE_FACTOR=0.25
size=320x240
failed=0

scenes=("$@")
[ ${#scenes[@]} -gt 0 ] || scenes=("$root"/examples_csg/*.csg)
pictures=${PICTURES:-$work/pictures}
mkdir -p "$work" "$pictures"

# One workspace, so that all crates share their dependencies.
names=()
for scene in "${scenes[@]}"; do
    name=$(basename "$scene" .csg)
    names+=("\"$name\"")
    "$chiaro" export "$scene" --to bevy -o "$work/$name" --force --quiet
    cp "$root/tools/bevy_picture.rs" "$work/$name/examples"
done
printf '[workspace]\nresolver = "3"\nmembers = [%s]\n' "$(IFS=,; echo "${names[*]}")" > "$work/Cargo.toml"
cd "$work"
cargo clippy --quiet --workspace --lib --examples --features bevy/png -- -D warnings

# Draws the solid or the picture; prints what Bevy says is wrong.
shown() {
    timeout 600 xvfb-run -a -s "-screen 0 1280x960x24" "$CARGO_TARGET_DIR/debug/examples/bevy_picture" "$@" 2>&1 | grep -E "ERROR|panicked" -A 3 || true
}

for scene in "${scenes[@]}"; do
    name=$(basename "$scene" .csg)
    drawn=$pictures/$name
    rm -f "$drawn"-*.png
    cargo build --quiet -p "$name" --example bevy_picture --features bevy/png
    problems=$(shown "$drawn-solid.png"; shown "$drawn-picture.png" picture)
    "$chiaro" render --one-pass "$scene" --size "$size" -o "$drawn-own.png" --quiet
    if [ -n "$problems" ] || [ ! -s "$drawn-solid.png" ] || [ ! -s "$drawn-picture.png" ]; then
        echo "$name: the engine refuses it: $problems"
        failed=1
    else
        echo "$name: $(python3 "$root/tools/compare_pictures.py" "$drawn-picture.png" "$drawn-own.png")"
    fi
done
exit $failed
