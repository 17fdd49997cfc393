#!/usr/bin/env bash
# Installs what Chiaro needs beside Rust on a Debian or Ubuntu machine: a Vulkan loader and a driver that works without
# a graphics card, and the libraries that a window on X11 loads. With --tests, also what the test suite asks: OpenSCAD, for
# its example scenes, compilers of shading languages and programs that run JavaScript and Python, which aren't ours, and an X
# server without a screen.
set -euo pipefail

packages=(libvulkan1 mesa-vulkan-drivers libx11-xcb1 libxcursor1 libxi6 libxkbcommon-x11-0)
if [ "${1:-}" = "--tests" ]; then
    packages+=(glslang-tools nodejs openscad python3 spirv-tools xvfb)
fi

missing=()
for package in "${packages[@]}"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
[ "${#missing[@]}" -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
fi
echo "installing ${missing[*]}" >&2
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
