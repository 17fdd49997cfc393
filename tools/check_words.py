"""Checks in headless Chromium that nothing a scene says in words runs in the pages that are exported for it.

The scene describes its live numbers by texts that would set a variable if they got out of their comments and strings, and its title
would too. Each page has to draw, and the variable must not be there. The page for three.js, whose modules come from the network, only
has to set nothing; those that are exported are run by the test suite. Needs what check_pages.py needs.

    python3 tools/check_words.py
"""

import pathlib
import sys
import tempfile

from chromium import PATIENCE_MS, chiaro, chromium, page_of

RUN = "globalThis.PWNED = 1"
HOSTILE = [
    f"</script><script>{RUN}</script>",
    f"<!-- <script>{RUN}//",
    f"--> <img src=x onerror='{RUN}'>",
    f"*/ {RUN}; /*",
    *(f"x{end}/* /* */ {RUN} // */ //" for end in "\u2028\u2029\u0085\u000b\u000c"),
    f"`; {RUN}; `",
    f"${{{RUN}}}",
    f'"; {RUN}; "',
    f"'; {RUN}; '",
    f"\\`; {RUN}; //",
    f"&lt;/script>&lt;script>{RUN}&lt;/script>",
]
TITLE = f"a</title><script>{RUN}<" + "\\script>`${" + RUN + '}";.csg'

def scene():
    """A scene with a live number for each text."""
    lines = [f"// {text}\nsize_{i} = 5; // [1:10]\ntranslate([{12 * i}, 0, 0]) sphere(size_{i});\n" for i, text in enumerate(HOSTILE)]
    return "".join(lines)


def opened(browser, url, name):
    """Whether a page draws, and nothing of the scene's words ran."""
    page = page_of(browser)
    asked = []
    page.on("dialog", lambda dialog: (asked.append(dialog.message), dialog.dismiss()))
    page.goto(url, wait_until="load")
    if name != "three":
        page.wait_for_function("document.body.dataset.drawn || document.getElementById('problem')", timeout=PATIENCE_MS)
    problem = page.query_selector("#problem")
    found = page.evaluate("({ ran: 'PWNED' in globalThis, scripts: document.scripts.length, images: document.images.length })")
    well = not found["ran"] and not problem and not asked and found["images"] == 0
    print(f"{name}: {found}, title {page.title()!r}{', ' + problem.text_content() if problem else ''}", flush=True)
    page.close()
    return well


def main():
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        folder = pathlib.Path(folder)
        file = folder / TITLE.replace("/", "_")
        file.write_text(scene(), encoding="utf-8")
        well = True
        for target in ["webgl", "webgpu"]:
            page = folder / f"{target}.html"
            chiaro("export", file, "--to", target, "-o", page)
            well &= opened(browser, page.as_uri(), target)
        chiaro("export", file, "--to", "three", "-o", folder / "three")
        well &= opened(browser, (folder / "three/index.html").as_uri(), "three")
    sys.exit(not well)


if __name__ == "__main__":
    main()
