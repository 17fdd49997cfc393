#!/usr/bin/env bash
# Compiles every example's HLSL program with Slang, beside glslang of the test suite another front end of HLSL. slangc is in
# Slang's releases, and in PyPI's package slangtorch. With the folder of a libdxcompiler.so, from DirectXShaderCompiler's releases or
# PyPI's package compushady-lrtu, DXC compiles them to DXIL, too.
#
#     tools/check_hlsl.sh SLANGC [CHIARO [FOLDER_OF_DXC]]
set -euo pipefail
slangc=$1
chiaro=${2:-target/release/chiaro}
dxc=${3:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

count=0
for scene in examples_csg/*.csg; do
    "$chiaro" export "$scene" --to hlsl --program -o "$folder/scene.hlsl" --force --quiet
    for entry in "corner vertex vs_6_0" "pixel fragment ps_6_0"; do
        read -r name stage profile <<< "$entry"
        "$slangc" -lang hlsl -profile sm_6_0 -entry "$name" -stage "$stage" -target hlsl "$folder/scene.hlsl" -o "$folder/out.hlsl" || {
            echo "$scene: $name does not compile" >&2
            exit 1
        }
        [ -z "$dxc" ] || "$slangc" -lang hlsl -pass-through dxc -dxc-path "$dxc" -profile "$profile" -entry "$name" \
            -target dxil "$folder/scene.hlsl" -o "$folder/out.dxil" || {
            echo "$scene: DXC does not compile $name" >&2
            exit 1
        }
    done
    count=$((count + 1))
done
echo "$count scenes compile"
