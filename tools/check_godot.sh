#!/usr/bin/env bash
# Opens exported projects in Godot 3 on a software driver: what the engine says is wrong with either shader of a scene, and how
# near its picture comes to `chiaro render --one-pass`. Needs Debian's godot3 and xvfb, the Python packages numpy and pillow,
# and target/release/chiaro, or what CHIARO names. Pictures are left in the folder that PICTURES names, if it does.
#
#     tools/check_godot.sh [SCENE...]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
chiaro=${CHIARO:-$root/target/release/chiaro}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work LIBGL_ALWAYS_SOFTWARE=1
size=320x240
failed=0

# Shows a scene of the project in $1 and saves the picture; prints the engine's errors.
shown() {
    timeout 300 xvfb-run -a -s "-screen 0 800x600x24" \
        godot3 --path "$1" --video-driver GLES3 --audio-driver Dummy --resolution "$size" \
        -s godot_picture.gd "res://$2.tscn" "$3" 2>&1 | grep -E "SHADER ERROR|SCRIPT ERROR|Compilation Failed|error:|Parse Error" -A 2 || true
}

scenes=("$@")
[ ${#scenes[@]} -gt 0 ] || scenes=("$root"/examples_csg/*.csg)
for scene in "${scenes[@]}"; do
    name=$(basename "${scene%.*}")
    project=$work/$name
    "$chiaro" export "$scene" --to godot-3 -o "$project" --quiet
    "$chiaro" render --one-pass "$scene" --size "$size" -o "$work/own.png" --quiet
    cp "$root/tools/godot_picture.gd" "$project"
    problems=$(shown "$project" "${name}_solid" "$work/solid.png"; shown "$project" "${name}_picture" "$work/picture.png")
    if [ -n "$problems" ] || [ ! -s "$work/solid.png" ] || [ ! -s "$work/picture.png" ]; then
        echo "$name: the engine refuses it: $problems"
        failed=1
    else
        echo "$name: $(python3 "$root/tools/compare_pictures.py" "$work/picture.png" "$work/own.png")"
    fi
    if [ -n "${PICTURES:-}" ]; then
        for kind in solid picture own; do cp "$work/$kind.png" "$PICTURES/$name-$kind.png" || true; done
    fi
    rm -f "$work"/*.png
done
exit $failed
