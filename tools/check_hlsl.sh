#!/usr/bin/env bash
# Compiles every example's HLSL program with Slang, beside glslang of the test suite another front end of HLSL. slangc is in
# Slang's releases, and in PyPI's package slangtorch.
#
#     tools/check_hlsl.sh SLANGC [CHIARO]
set -euo pipefail
slangc=$1
chiaro=${2:-target/release/chiaro}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

count=0
for scene in examples_csg/*.csg; do
    "$chiaro" export "$scene" --to hlsl --program -o "$folder/scene.hlsl" --force --quiet
    for entry in "corner vertex" "pixel fragment"; do
        read -r name stage <<< "$entry"
        "$slangc" -lang hlsl -profile sm_6_0 -entry "$name" -stage "$stage" -target hlsl "$folder/scene.hlsl" -o "$folder/out.hlsl" || {
            echo "$scene: $name does not compile" >&2
            exit 1
        }
    done
    count=$((count + 1))
done
echo "$count scenes compile"
