"""What the checks in Chromium have in common: the browser, scenes, and pictures of them."""

import argparse
import base64
import contextlib
import os
import pathlib
import subprocess
import sys

from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH, HEIGHT = 320, 240
PATIENCE_MS = 600_000
# A graphics card is not needed: Chromium brings a software driver, SwiftShader. A canvas gets a texture to draw into by WebGPU only if
# the rest of Chromium uses Vulkan too, which has no surfaces without a display.
FLAGS = [
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--disable-vulkan-surface",
]

# The headless browser's own pictures leave out what WebGPU draws into a canvas: it is read as soon as it is submitted.
WATCH = """
if (globalThis.GPUCanvasContext) {
    const { getCurrentTexture } = GPUCanvasContext.prototype;
    const { submit } = GPUQueue.prototype;
    let canvas = null;
    GPUCanvasContext.prototype.getCurrentTexture = function () {
        canvas = this.canvas;
        return getCurrentTexture.call(this);
    };
    GPUQueue.prototype.submit = function (buffers) {
        submit.call(this, buffers);
        if (canvas) globalThis.submitted = canvas.toDataURL();
        canvas = null;
    };
}
"""


@contextlib.contextmanager
def chromium():
    """Headless Chromium with WebGL and WebGPU in software."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=FLAGS)
        yield browser
        browser.close()


def page_of(browser):
    """A page as large as the pictures that are compared."""
    # Clocks stand still, so that pictures are those of the scene's defaults.
    page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT}, reduced_motion="reduce")
    page.add_init_script(WATCH)
    return page


def photograph(page, picture, hidden):
    """Writes what a page shows, without the elements that a selector names."""
    url = page.evaluate("globalThis.submitted")
    if url:
        picture.write_bytes(base64.b64decode(url.split(",")[1]))
    else:
        page.screenshot(path=picture, timeout=PATIENCE_MS, style=f"{hidden} {{ display: none !important }}")


def chiaro(*arguments):
    """Runs target/release/chiaro, or what CHIARO names."""
    command = os.environ.get("CHIARO", ROOT / "target/release/chiaro")
    subprocess.run([command, *map(str, arguments), "--quiet"], check=True)


def one_pass(scene, picture):
    """Draws what pages have to show."""
    chiaro("render", "--one-pass", "--size", f"{WIDTH}x{HEIGHT}", scene, "-o", picture)


def examples():
    """All example scenes."""
    return sorted((ROOT / "examples_csg").glob("*.csg"))


def check_scenes(description, check):
    """The main program of checks that take OUT and scenes: ends with 1 unless `check` finds every scene in order."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path, metavar="OUT")
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, metavar="SCENE")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    with chromium() as browser:
        quiet = [check(browser, scene, arguments.out) for scene in arguments.scenes or examples()]
    sys.exit(not all(quiet))
