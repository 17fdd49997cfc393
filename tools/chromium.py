"""What the checks in Chromium have in common: the browser, scenes, and pictures of them."""

import contextlib
import os
import pathlib
import subprocess

from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH, HEIGHT = 320, 240
PATIENCE_MS = 600_000
# A graphics card is not needed: Chromium brings a software driver, SwiftShader. Canvases show what WebGPU draws only if the
# compositor uses the same driver, and that has no surfaces without a display.
FLAGS = [
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--disable-vulkan-surface",
]


@contextlib.contextmanager
def chromium():
    """Headless Chromium with WebGL and WebGPU in software."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=FLAGS)
        yield browser
        browser.close()


def page_of(browser):
    """A page as large as the pictures that are compared."""
    return browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})


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
