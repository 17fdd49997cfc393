"""Checks in headless Chromium what is exported for browsers.

With --shaders, Chromium's compiler of WGSL, Tint, compiles each scene's library and program. Otherwise the pages are opened and what
they show is compared with `chiaro render --one-pass`: for each scene the mean SSIM of both pictures in WebGL 2 and in WebGPU, or
what the page says is wrong. Needs Debian's chromium, the Python packages playwright, numpy and pillow, and
target/release/chiaro, or what CHIARO names.

    python3 tools/check_pages.py [--shaders] [--only webgl|webgpu] [SCENE...]
"""

import argparse
import pathlib
import sys
import tempfile

from chromium import PATIENCE_MS, chiaro, chromium, examples, one_pass, page_of, photograph
from compare_pictures import compared

# Answers Tint's messages about a text.
COMPILE = """async (code) => {
    globalThis.device ??= await (await navigator.gpu.requestAdapter()).requestDevice();
    device.pushErrorScope("validation");
    const { messages } = await device.createShaderModule({ code }).getCompilationInfo();
    const error = await device.popErrorScope();
    const said = messages.map((message) => `${message.type} in line ${message.lineNum}: ${message.message}`);
    return said.concat(error && !said.length ? [error.message] : []);
}"""


def check_shaders(browser, folder, scenes):
    """How many texts Tint has anything to say about."""
    page = page_of(browser)
    # Only pages of secure origins have WebGPU.
    page.route("**/*", lambda route: route.fulfill(body="", content_type="text/html"))
    page.goto("https://check/")
    bad = 0
    for scene in scenes:
        for kind in ([], ["--program"]):
            text = folder / "scene.wgsl"
            chiaro("export", scene, *kind, "-o", text, "--force")
            said = page.evaluate(COMPILE, text.read_text())
            bad += bool(said)
            print(f"{scene.stem}, {'program' if kind else 'library'}: {'; '.join(said) or 'compiles'}", flush=True)
    return bad


def check_pages(browser, folder, scenes, targets):
    """How many pages say that something is wrong."""
    bad = 0
    for scene in scenes:
        own = folder / f"{scene.stem}.png"
        one_pass(scene, own)
        for target in targets:
            file = folder / f"{scene.stem}-{target}.html"
            chiaro("export", scene, "--to", target, "-o", file)
            page = page_of(browser)
            page.goto(file.as_uri(), wait_until="commit")
            page.wait_for_function("document.body.dataset.drawn || document.getElementById('problem')", timeout=PATIENCE_MS)
            problem = page.query_selector("#problem")
            if problem:
                bad += 1
                print(f"{scene.stem}, {target}: {problem.text_content()}", flush=True)
            else:
                shown = file.with_suffix(".png")
                photograph(page, shown, "#controls")
                print(f"{scene.stem}, {target}: {compared(shown, own)}", flush=True)
            page.close()
    return bad


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shaders", action="store_true")
    parser.add_argument("--only", choices=["webgl", "webgpu"])
    parser.add_argument("--keep", type=pathlib.Path, help="the folder of what is written, to look at")
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, metavar="SCENE")
    arguments = parser.parse_args()
    scenes = arguments.scenes or examples()
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        folder = arguments.keep or pathlib.Path(folder)
        if arguments.shaders:
            bad = check_shaders(browser, folder, scenes)
        else:
            bad = check_pages(browser, folder, scenes, [arguments.only] if arguments.only else ["webgl", "webgpu"])
    sys.exit(bad > 0)


if __name__ == "__main__":
    main()
