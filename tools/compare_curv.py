"""Compares what we export with what Curv generates for the same scenes, those of tools/curv, in one harness: WebGL 2 in headless Chromium.

Both distance functions are put into the same shader, Curv's own viewer, which looks for the surface, for its normal and for its ambient
occlusion; then both whole programs are drawn from the same place, each under its own lights. Told are sizes in bytes, and what the
process that draws takes of processors' time, as its driver is software: from the source to the first picture, and for a frame, the
median of turns. As a check that both show the same, the SSIM of the pictures with the same shader. Needs what check_pages.py needs,
and CURV, Curv's command line (github.com/curv3d/curv; the build with LEAN_BUILD will do). Pictures stay in the folder OUT, to look at.

    CURV=curv python3 tools/compare_curv.py [--height PIXELS] [--turns N] [--functions-only] OUT [SCENE.curv...]
"""

import argparse
import base64
import json
import os
import pathlib
import re
import statistics
import subprocess

from chromium import ROOT, chiaro, chromium
from compare_pictures import compared

SCENES = ROOT / "tools/curv"
HEAD = "#version 300 es\nprecision highp float;\nprecision highp int;\n"
# What Curv's viewer puts around its shaders.
VIEWER = HEAD + "uniform vec3 iResolution;\nuniform float iTime;\nout vec4 seen;\n"
MAIN = "void main() { mainImage(seen, gl_FragCoord.xy); }\n"
# Our functions under the names that Curv's shader calls.
ADAPTER = """
float dist(vec4 p) { return scene_distance(p.xyz) / SCENE_LIPSCHITZ; }
vec3 colour(vec4 p) { return scene_surface(p.xyz).color.rgb; }
"""
# The camera of all scenes.
EYE = (60, -80, 50)

HARNESS = """
globalThis.programs = {};
globalThis.start = (width, height) => {
    const canvas = new OffscreenCanvas(width, height);
    globalThis.gl = canvas.getContext("webgl2", { antialias: false });
};
globalThis.compile = (name, source, uniforms) => {
    const program = gl.createProgram();
    const corners = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }`;
    for (const [kind, text] of [[gl.VERTEX_SHADER, corners], [gl.FRAGMENT_SHADER, source]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
        throw Error(gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader)).join("") + gl.getProgramInfoLog(program));
    }
    gl.useProgram(program);
    for (const [key, value] of Object.entries(uniforms)) {
        const place = gl.getUniformLocation(program, key);
        if (key === "rays") gl.uniform1i(place, value);
        else gl["uniform" + [value].flat().length + "fv"](place, [value].flat());
    }
    programs[name] = program;
};
globalThis.draw = (name) => {
    gl.useProgram(programs[name]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
};
globalThis.picture = async (name) => {
    draw(name);
    const bytes = new Uint8Array(await (await gl.canvas.convertToBlob()).arrayBuffer());
    return btoa(bytes.reduce((text, byte) => text + String.fromCharCode(byte), ""));
};
"""


def curv(scene):
    """The shader that Curv's viewer gets."""
    output = subprocess.run([os.environ["CURV"], "-o", "jgpu", scene], check=True, capture_output=True, text=True).stdout
    return json.loads(output)["shader"]


def ours(scene, out, *kind):
    """Our text for the scene that a file of Curv's is compared with."""
    text = out / "ours.glsl"
    chiaro("export", SCENES / f"{scene.stem.split('-')[0]}.csg", "--to", "glsl-es-300", *kind, "-o", text, "--force")
    return text.read_text()


def code_bytes(text):
    """How many bytes a text has without comments and empty lines."""
    lines = [line.split("//")[0].rstrip() for line in re.sub(r"/\*.*?\*/", "", text, flags=re.S).splitlines()]
    return sum(len(line.encode()) + 1 for line in lines if line)


def distance_of_curv(shader):
    return shader[shader.index("float dist(") : shader.index("vec3 colour(")]


def distance_of_ours(library):
    """What scene_distance needs stands above it; it ends where the material's comment begins."""
    return library[: library.index("// The material of the surface at p.")]


def viewed(shader, functions=None):
    """Curv's shader as a whole; with these functions in the place of its own."""
    if functions is not None:
        start, end = shader.index("float dist("), shader.index("const vec3 bbox_min")
        shader = shader[:start] + functions + ADAPTER + shader[end:]
    return VIEWER + shader + MAIN


def uniforms_of_curv(shader, width, height):
    """Curv's camera is told in sizes of the box around the scene, with y up."""
    low, high = ([float(x) for x in re.search(rf"bbox_{end} = vec3\((.*?)\)", shader)[1].split(",")] for end in ("min", "max"))
    unit = max(b - a for a, b in zip(low, high)) / 2 / 1.3
    seen = lambda point: [(x - (a + b) / 2) / unit for x, a, b in zip(point, low, high)]
    turned = lambda v: [v[0], v[2], -v[1]]
    return {
        "iResolution": [width, height, 1],
        "u_eye3d": turned(seen(EYE)),
        "u_centre3d": turned(seen((0, 0, 0))),
        "u_up3d": [0, 1, 0],
    }


class Clock:
    """Seconds that the browser's process for graphics has been running, on all processors."""

    def __init__(self, browser):
        self.session = browser.new_browser_cdp_session()

    def now(self):
        processes = self.session.send("SystemInfo.getProcessInfo")["processInfo"]
        return next(process["cpuTime"] for process in processes if process["type"] == "GPU")

    def seconds(self, work):
        start = self.now()
        work()
        return self.now() - start


def frame_times(page, clock, names, turns):
    """The median seconds of a frame of each program, drawn in turns of about a third of a second."""
    draw = lambda name, count=1: page.evaluate("([name, count]) => { while (count--) draw(name); }", [name, count])
    counts = {name: max(1, round(0.3 / max(0.001, clock.seconds(lambda: draw(name))))) for name in names}
    times = {name: [] for name in names}
    for _ in range(turns):
        for name, count in counts.items():
            times[name].append(clock.seconds(lambda: draw(name, count)) / count)
    return {name: statistics.median(values) for name, values in times.items()}


def compare(page, clock, scene, out, height, turns, functions_only):
    # Programs show the same part of the scene as the picture's format has, which is 4:3.
    width = height * 4 // 3
    shader, library, program = curv(scene), ours(scene, out), ours(scene, out, "--program")
    view = uniforms_of_curv(shader, width, height)
    own = {"resolution": [width, height], "turn": [0, 0], "zoom": 1, "rays": 1}
    programs = {
        "curv": (viewed(shader), view),
        "ours": (viewed(shader, library), view),
        "program": (HEAD + re.sub(r"#version.*|precision .*", "", program), own),
    }
    if functions_only:
        del programs["program"]
    page.evaluate("([width, height]) => start(width, height)", [width, height])
    first = {}
    for name, (source, uniforms) in programs.items():
        arguments = [name, source, uniforms]
        first[name] = clock.seconds(lambda: page.evaluate("(all) => { compile(...all); draw(all[0]); }", arguments))
        (out / f"{scene.stem}-{name}.png").write_bytes(base64.b64decode(page.evaluate("picture", name)))
    frame = frame_times(page, clock, programs, turns)
    bytes_curv, bytes_ours = code_bytes(distance_of_curv(shader)), code_bytes(distance_of_ours(library))
    pictures = compared(out / f"{scene.stem}-curv.png", out / f"{scene.stem}-ours.png")
    ratio = lambda a, b: f"{a:.3g} / {b:.3g} = {a / b:.2f}"
    times = lambda name: " | ".join(ratio(time[name], time["curv"]) if name in time else "" for time in (first, frame))
    print(
        f"| {scene.stem} | {ratio(bytes_ours, bytes_curv)} | {times('ours')} | {ratio(len(program), len(shader))} | {times('program')} | {pictures} |",
        flush=True,
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--height", type=int, default=384, metavar="PIXELS")
    parser.add_argument("--turns", type=int, default=7, metavar="N")
    parser.add_argument("--functions-only", action="store_true", help="leave the whole programs out, which take minutes in software")
    parser.add_argument("out", type=pathlib.Path, metavar="OUT")
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, metavar="SCENE.curv")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    print("| scene | distance: bytes | first picture, s | frame, s | whole: bytes | first picture, s | frame, s | same shader |\n|---|---|---|---|---|---|---|---|")
    with chromium() as browser:
        clock = Clock(browser)
        for scene in arguments.scenes or sorted(SCENES.glob("*.curv")):
            page = browser.new_page()
            page.add_script_tag(content=HARNESS)
            compare(page, clock, scene, arguments.out, arguments.height, arguments.turns, arguments.functions_only)
            page.close()


if __name__ == "__main__":
    main()
