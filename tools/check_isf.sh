#!/usr/bin/env bash
# Reads every example's ISF generator as a host does: by the parser of npm's package interactive-shader-format (2.9.0), whose folder is
# named; glslang compiles the shader that it makes. Its own renderer can't draw them: it has the language of WebGL 1 only.
#
#     tools/check_isf.sh node_modules/interactive-shader-format [CHIARO]
set -euo pipefail
parser=$(realpath "$1")/lib/ISFParser.js
chiaro=${2:-target/release/chiaro}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

count=0
for scene in examples_csg/*.csg; do
    "$chiaro" export "$scene" --to isf -o "$folder/scene.fs" --force --quiet
    node -e '
        const [parser, file] = process.argv.slice(1);
        const scene = new (require(parser))();
        scene.parse(require("fs").readFileSync(file, "utf8"));
        if (!scene.valid || scene.type !== "generator") throw scene.error ?? Error(`it is a ${scene.type}`);
        console.log("#version 150 compatibility\n" + scene.fragmentShader);
    ' "$parser" "$folder/scene.fs" > "$folder/scene.frag"
    glslangValidator "$folder/scene.frag" > "$folder/said" || {
        echo "$scene: $(cat "$folder/said")" >&2
        exit 1
    }
    count=$((count + 1))
done
echo "$count scenes are read, and compile"
