#!/usr/bin/env bash
# Draws every scene of examples_csg/ into docs/pictures/ and writes docs/gallery.md, which shows them. With names of
# scenes as arguments, draws only those.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo build --release --quiet --package chiaro
mkdir -p docs/pictures
scenes=("$@")
[ "$#" -gt 0 ] || scenes=(examples_csg/*.csg)
for scene in "${scenes[@]}"; do
    name=$(basename "$scene" .csg)
    echo "$name" >&2
    target/release/chiaro render "examples_csg/$name.csg" --output "docs/pictures/$name.png" \
        --size 480x360 --samples 144 --quiet
done

{
    echo "# Gallery"
    echo
    echo "Every scene of \`examples_csg/\`, as \`chiaro render\` draws it. \`tools/gallery.sh\` draws them again."
    for scene in examples_csg/*.csg; do
        name=$(basename "$scene" .csg)
        echo
        echo "## [$name](../examples_csg/$name.csg)"
        echo
        # The comment at the top of a scene says what it is.
        sed -n '/^\/\/ /!q; s/^\/\/ //p' "$scene"
        echo
        echo "![$name](pictures/$name.png)"
    done
} > docs/gallery.md
