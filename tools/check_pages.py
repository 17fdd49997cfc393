"""Opens exported pages in headless Chromium and compares what they show with `chiaro render --one-pass`.

For each scene: the mean SSIM of both pictures in WebGL 2 and in WebGPU, or what the page says is wrong. Needs Debian's chromium, and
the Python packages playwright, numpy and pillow, and target/release/chiaro, or what CHIARO names.

    python3 tools/check_pages.py [SCENE...]
"""

import os
import pathlib
import subprocess
import sys
import tempfile

from compare_pictures import compared
from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH, HEIGHT = 320, 240
PATIENCE_MS = 300_000
# A graphics card is not needed: Chromium brings a software driver.
FLAGS = [
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--enable-features=Vulkan",
]


def chiaro(*arguments):
    command = os.environ.get("CHIARO", ROOT / "target/release/chiaro")
    subprocess.run([command, *map(str, arguments), "--quiet"], check=True)


def main(scenes):
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        folder = pathlib.Path(folder)
        browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=FLAGS)
        for scene in scenes:
            name = pathlib.Path(scene).stem
            own = folder / f"{name}.png"
            chiaro("render", "--one-pass", "--size", f"{WIDTH}x{HEIGHT}", scene, "-o", own)
            for target in ("webgl", "webgpu"):
                page_file = folder / f"{name}-{target}.html"
                chiaro("export", scene, "--to", target, "-o", page_file)
                page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
                page.goto(page_file.as_uri())
                page.wait_for_function("document.body.dataset.drawn || document.getElementById('problem')", timeout=PATIENCE_MS)
                problem = page.query_selector("#problem")
                if problem:
                    print(f"{name}, {target}: {problem.text_content()}", flush=True)
                else:
                    page.add_style_tag(content="#controls { display: none }")
                    shown = folder / f"{name}-{target}.png"
                    page.screenshot(path=shown)
                    print(f"{name}, {target}: {compared(shown, own)}", flush=True)
                page.close()
        browser.close()


if __name__ == "__main__":
    main(sys.argv[1:] or sorted((ROOT / "examples_csg").glob("*.csg")))
