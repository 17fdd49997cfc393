#!/usr/bin/env python3
"""Compiles every pass of exported Unity shaders with glslang, against Unity's own includes.

    python3 tools/check_unity.py CGINCLUDES PACKAGES FOLDER...

CGINCLUDES is the folder of Unity's built-in includes (UnityCG.cginc and so on), PACKAGES the one that has
com.unity.render-pipelines.universal and .core in it; FOLDERs are what `chiaro export SCENE --to unity` wrote.
glslang's front end isn't Unity's compiler, but it finds what is misspelt, mistyped or defined twice.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

# What Unity's compiler defines: for Direct3D 11, and the light that passes are compiled for.
DEFINED = ["SHADER_API_D3D11=1", "SHADER_TARGET=45", "UNITY_VERSION=202120", "UNITY_REVERSED_Z=1", "UNITY_UV_STARTS_AT_TOP=1",
           "UNITY_NO_SCREENSPACE_SHADOWS=1", "SHADER_STAGE_FRAGMENT=1", "UNITY_PBS_USE_BRDF1=1"]
VARIANTS = {
    "ForwardLit": [[], ["_MAIN_LIGHT_SHADOWS=1", "_ADDITIONAL_LIGHTS=1", "_SHADOWS_SOFT=1"]],
    "ShadowCaster": [[], ["_CASTING_PUNCTUAL_LIGHT_SHADOW=1", "SHADOWS_DEPTH=1"]],
    "FORWARD": [["DIRECTIONAL=1", "UNITY_PASS_FORWARDBASE=1"], ["DIRECTIONAL=1", "SHADOWS_SCREEN=1", "UNITY_PASS_FORWARDBASE=1", "FOG_EXP2=1"]],
    "FORWARD_DELTA": [["POINT=1", "UNITY_PASS_FORWARDADD=1"], ["SPOT=1", "SHADOWS_DEPTH=1", "UNITY_PASS_FORWARDADD=1"]],
}

# A function, and in parentheses its head.
DEFINITION = r"^((?:half|float)\d? \w+\([^)]*\))\n\{\n.*?^\}"


def adapted(folder, place):
    """Copies includes as glslang can read them: without byte order marks, and without what is defined for half and for float,
    which are one type to it."""
    folder, place = pathlib.Path(folder), pathlib.Path(place)
    for path in folder.rglob("*"):
        if path.suffix not in {".hlsl", ".cginc"}:
            continue
        text = path.read_text(encoding="utf-8-sig", errors="replace").replace("\r\n", "\n")
        text = re.sub(r"^TEMPLATE_\d_HALF\(.*$", "", text, flags=re.M)
        signatures = set(re.findall(DEFINITION, text, re.M | re.S))

        def single(match):
            of_float = re.sub(r"\bhalf", "float", match[1])
            return "" if of_float != match[1] and of_float in signatures else match[0]

        text = re.sub(DEFINITION, single, text, flags=re.M | re.S)
        copy = place / path.relative_to(folder)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(text)


def passes(text):
    """The passes of a .shader file: their names, the code that their sub-shader shares, and their own."""
    for part in re.split(r"\n    SubShader \{", text)[1:]:
        shared = "".join(re.findall(r"(?:HLSL|CG)INCLUDE\n(.*?)END(?:HLSL|CG)", part, re.S))
        for body in re.split(r"\n        Pass \{", part)[1:]:
            name = re.search(r'Name "(\w+)"', body)
            code = re.search(r"(?:HLSL|CG)PROGRAM\n(.*?)END(?:HLSL|CG)", body, re.S)[1]
            yield name[1] if name else "Picture", shared, code, "CGPROGRAM" in body


def compiled(code, entry, stage, defined, folders):
    """What glslang says against a pass, or nothing."""
    lines = [line for line in code.splitlines() if "#pragma" not in line]
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "pass.hlsl"
        path.write_text("\n".join(lines))
        command = ["glslangValidator", "-D", "-V", "-S", stage, "-e", entry, "--auto-map-bindings", "--auto-map-locations",
                   "-o", str(path) + ".spv", *[f"-I{folder}" for folder in folders], *[f"-D{define}" for define in defined], str(path)]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
    return "" if result.returncode == 0 else result.stdout


def main():
    builtin, packages, *exports = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        adapted(builtin, f"{folder}/builtin")
        adapted(packages, f"{folder}/Packages")
        compiled, failed = check(exports, f"{folder}/builtin", folder)
    print(f"{compiled} passes compile, {failed} fail")
    sys.exit(failed > 0 or compiled == 0)


def check(exports, builtin, project):
    """Says what fails, and returns how much doesn't and how much does."""
    count = failed = 0
    for export in exports:
        for path in sorted(pathlib.Path(export).glob("*.shader")):
            for name, shared, code, is_builtin in passes(path.read_text()):
                folders = [export, builtin] if is_builtin else [export, project]
                before = '#include "HLSLSupport.cginc"\n' if is_builtin else ""
                for variant in VARIANTS.get(name, [[]]):
                    for stage in ["vertex", "fragment"]:
                        entry = re.search(rf"#pragma {stage} (\w+)", code)[1]
                        said = compiled(before + shared + code, entry, stage[:4], DEFINED + variant, folders)
                        count += 1
                        failed += bool(said)
                        if said:
                            print(f"{path} {name} {stage} {' '.join(variant)}:\n{said[:3000]}")
    return count - failed, failed


if __name__ == "__main__":
    main()
