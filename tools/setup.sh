#!/usr/bin/env bash
# Installs what Chiaro needs beside Rust on a Debian or Ubuntu machine: a Vulkan loader and a driver that works without
# a graphics card. With --tests, also what the test suite asks: OpenSCAD, for its example scenes.
set -euo pipefail

packages=(libvulkan1 mesa-vulkan-drivers)
if [ "${1:-}" = "--tests" ]; then
    packages+=(openscad)
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
