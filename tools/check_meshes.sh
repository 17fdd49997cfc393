#!/usr/bin/env bash
# Exports every scene of examples_csg/ in every mesh format, and has other programs say what they think of it: trimesh loads
# all files and OpenSCAD the STL. Prints a table; with names of scenes as arguments, of those only. Builds the command first,
# unless CHIARO names one.
set -euo pipefail
cd "$(dirname "$0")/.."

tools/setup.sh --tests
[ -n "${CHIARO:-}" ] || cargo build --release --quiet --package chiaro --no-default-features
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/python"
"$work/python/bin/pip" install --quiet numpy scipy networkx lxml trimesh

scenes=("$@")
[ "$#" -gt 0 ] || scenes=(examples_csg/*.csg)
"$work/python/bin/python" tools/check_meshes.py "$work" "${scenes[@]}"
