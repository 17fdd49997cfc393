"""Opens what `chiaro export --to three` writes in headless Chromium, with WebGLRenderer and with WebGPURenderer.

For each scene and renderer: the mean SSIM of its picture and that of `chiaro render --one-pass`, and whether the solid beside ordinary
meshes is drawn without a message; what is wrong otherwise. Needs what check_pages.py needs, and three.js in a folder of node_modules
(`npm install three@0.187.0`), which THREE names. What is written stays in the folder OUT, to look at.

    THREE=node_modules/three python3 tools/check_three.py OUT [SCENE...]
"""

import os
import pathlib

from chromium import PATIENCE_MS, check_scenes, chiaro, one_pass, page_of, photograph
from compare_pictures import compared

CDN = "https://cdn.jsdelivr.net/npm/three@0.187.0/"
SERVED = "https://scene/"


def serve(page, folder):
    """Answers what pages ask of the network with files."""
    three = pathlib.Path(os.environ["THREE"])

    def answer(route):
        url = route.request.url.split("#")[0]
        file = three / url.removeprefix(CDN) if url.startswith(CDN) else folder / url.removeprefix(SERVED)
        if not file.is_file():
            return route.fulfill(status=404)
        route.fulfill(path=file, content_type="text/html" if file.suffix == ".html" else "text/javascript")

    page.route("**/*", answer)


def is_told(message):
    """Whether a message of the console is about the page; that reading pixels is slow is not."""
    return message.type in ("error", "warning") and "GPU stall due to ReadPixels" not in message.text


def photographed(browser, folder, name, picture):
    """What the browser says about a page until it has drawn; its picture is written."""
    page = page_of(browser)
    said = []
    page.on("console", lambda message: is_told(message) and said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    serve(page, folder)
    page.goto(SERVED + name, wait_until="commit")
    page.wait_for_function("document.body.dataset.drawn", timeout=PATIENCE_MS)
    photograph(page, picture, ".lil-gui")
    page.close()
    return said


def check(browser, scene, out):
    """Whether Chromium has anything to say about a scene's pages."""
    folder = out / scene.stem
    chiaro("export", scene, "--to", "three", "-o", folder, "--force")
    own = out / f"{scene.stem}.png"
    one_pass(scene, own)
    quiet = True
    for renderer, page in (("WebGL", "index.html"), ("WebGPU", "webgpu.html")):
        for kind in ("solid", "picture"):
            shown = out / f"{scene.stem}-{renderer}-{kind}.png"
            said = photographed(browser, folder, f"{page}#{kind}", shown)
            quiet &= not said
            result = "; ".join(said) or (compared(shown, own) if kind == "picture" else "drawn")
            print(f"{scene.stem}, {renderer}, {kind}: {result}", flush=True)
    return quiet


if __name__ == "__main__":
    check_scenes(__doc__, check)
