#!/usr/bin/env python3
"""Fails when a file includes what its folder may not use: the arrows of the design, and no others.

check_includes.py [ROOT]        checks src/, include/ and apps/ of the source tree
check_includes.py --self-test   checks that a wrong arrow of each kind is found, and no right one
"""

import pathlib
import re
import sys
import tempfile

SOURCE_ENDINGS = {".cpp", ".h"}

# The folder of src/ that a file lies in, and which folders it may include from besides its own.
MAY_USE = {
    "base": set(),
    "image": {"base"},
    "model": {"base", "image"},
    "lines": {"base", "model"},
    "gpu": {"base"},
    "framework": {"base", "model", "image", "gpu"},
    "components": {"base", "model", "image", "gpu", "lines", "framework"},
    "output": {"base", "image", "lines"},
    "api": {"base", "model", "image", "lines", "gpu", "framework", "components", "output", "croquis"},
    "bench": {"base", "output", "croquis"},
    "video": {"base"},
    "viewer": {"base", "gpu", "video", "croquis"},
}
APPS_MAY_USE = {"croquis", "bench", "viewer", "framework", "base"}
# Below the API, one public header is known: the error that everything throws.
PUBLIC_HEADERS_OF_BASE = {"croquis/error.h"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
GL_HEADER = re.compile(r"^(epoxy|GL|GLES\d?|EGL|KHR)/")
WINDOW_HEADER = re.compile(r"^GLFW/|^(backends/)?imgui|viewer")
BACK_END_NAME = re.compile(r"\b(GL[a-z]\w*|gl[A-Z]\w*|GL_\w+|EGL\w*|epoxy\w*|GLFW\w*|glfw\w*|ImGui\w*|ImVec\w*)\b")


def includes(text):
    """Yields (line, name, is_quoted) for each #include."""
    for match in INCLUDE.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, match[2], match[1] == '"'


def wrong_arrow(path, name):
    """Why the file `path` (below the root) may not include "name", or None."""
    area, folder = path.parts[0], path.parts[1]
    target = name.split("/")[0]
    if area == "include":
        return None if target == "croquis" else "a public header includes public headers only"
    if area == "apps":
        own = "/" not in name
        return None if own or target in APPS_MAY_USE else f"apps may use {', '.join(sorted(APPS_MAY_USE))} only"
    if folder not in MAY_USE:
        return f"the folder src/{folder} has no place in the design"
    allowed = MAY_USE[folder] | {folder}
    if target in allowed or (folder == "base" and name in PUBLIC_HEADERS_OF_BASE):
        return None
    return f"{folder} may use {', '.join(sorted(allowed - {folder})) or 'nothing else'} only"


def wrong_back_end(path, name):
    """Why the file may not include a header of OpenGL or of a window system, or None."""
    if path.parts[0] == "apps":
        return None
    if GL_HEADER.match(name) and path.parts[:2] != ("src", "gpu"):
        return "only src/gpu knows OpenGL's headers"
    if path.parts[:2] == ("src", "viewer") and name.startswith("imgui"):
        return None  # the viewer's panels; its window stands in apps
    if WINDOW_HEADER.search(name) and not (path.parts[:2] == ("src", "viewer") and name.startswith("viewer/")):
        return "the library knows no window and no viewer"
    return None


def complaints_about(path, text):
    """Every mistake of one file as `path:line: what`."""
    for line, name, is_quoted in includes(text):
        reason = wrong_back_end(path, name) or (wrong_arrow(path, name) if is_quoted else None)
        if reason:
            yield f"{path}:{line}: must not include {name}: {reason}"
    if path.parts[0] == "include":
        for match in BACK_END_NAME.finditer(INCLUDE.sub("", COMMENT.sub("", text))):
            yield f"{path}: must not name {match[0]}: no back end in a public header"


def sources(root):
    """Every source file below include/, src/ and apps/, relative to the root."""
    for area in ("include", "src", "apps"):
        for path in sorted((root / area).rglob("*")):
            if path.suffix in SOURCE_ENDINGS:
                yield path.relative_to(root)


def check(root):
    """All mistakes of a source tree."""
    files = list(sources(root))
    if not files:
        return [f"{root}: no source files"]
    return [mistake for path in files for mistake in complaints_about(path, (root / path).read_text())]


# A file, what it says, and the mistake that must be found; None where all is well.
SELF_TEST = [
    ("src/base/a.h", '#include "croquis/error.h"\n#include <vector>', None),
    ("src/base/a.h", '#include "croquis/picture.h"', "src/base/a.h:1: must not include croquis/picture.h"),
    ("src/base/a.h", '#include "image/image.h"', "base may use nothing else only"),
    ("src/model/a.cpp", '\n#include "model/b.h"\n#include "image/image.h"', None),
    ("src/model/a.cpp", '\n\n  #  include "gpu/context.h"', "src/model/a.cpp:3: must not include gpu/context.h"),
    ("src/lines/a.cpp", '#include "image/image.h"', "lines may use base, model only"),
    ("src/gpu/a.cpp", "#include <epoxy/gl.h>", None),
    ("src/gpu/a.cpp", '#include "framework/scene.h"', "gpu may use base only"),
    ("src/framework/a.cpp", "#include <epoxy/gl.h>", "only src/gpu knows OpenGL's headers"),
    ("src/framework/a.cpp", '#include "components/register.h"', "framework may use base, gpu, image, model only"),
    ("src/components/a.cpp", '#include "lines/chain.h"', None),
    ("src/components/a.cpp", '#include "viewer/panel.h"', "the library knows no window and no viewer"),
    ("src/components/a.cpp", "#include <imgui.h>", "the library knows no window and no viewer"),
    ("src/components/a.cpp", '#include "croquis/renderer.h"', "must not include croquis/renderer.h"),
    ("src/output/a.cpp", '#include "model/model.h"', "output may use base, image, lines only"),
    ("src/api/a.cpp", '#include "croquis/view.h"\n#include "output/png.h"', None),
    ("src/bench/a.cpp", '#include "croquis/renderer.h"\n#include "output/line_plot.h"', None),
    ("src/bench/a.cpp", '#include "framework/scene.h"', "bench may use base, croquis, output only"),
    ("src/viewer/a.cpp", '#include <imgui.h>\n#include "viewer/session.h"\n#include "croquis/renderer.h"', None),
    ("src/viewer/a.cpp", "#include <GLFW/glfw3.h>", "the library knows no window and no viewer"),
    ("src/viewer/a.cpp", "#include <backends/imgui_impl_glfw.h>", "the library knows no window and no viewer"),
    ("src/viewer/a.cpp", '#include "framework/scene.h"', "viewer may use base, croquis, gpu, video only"),
    ("src/viewer/a.cpp", '#include "video/video_writer.h"', None),
    ("src/video/a.cpp", '#include "croquis/picture.h"', "video may use base only"),
    ("src/components/a.cpp", '#include "video/video_writer.h"', "components may use"),
    ("src/odd/a.cpp", '#include "base/error.h"', "the folder src/odd has no place in the design"),
    ("apps/croquis/a.cpp", '#include "commands.h"\n#include "framework/library.h"\n#include "croquis/view.h"', None),
    ("apps/croquis/a.cpp", '#include "gpu/context.h"', "apps may use base, bench, croquis, framework, viewer only"),
    ("include/croquis/a.h", '#include "croquis/error.h"\n// OpenGL, as glClear does\n#include <string>', None),
    ("include/croquis/a.h", '#include "base/error.h"', "a public header includes public headers only"),
    ("include/croquis/a.h", "#include <epoxy/gl.h>", "only src/gpu knows OpenGL's headers"),
    ("include/croquis/a.h", "void draw(GLuint name);", "must not name GLuint"),
    ("include/croquis/a.h", "void draw(ImGuiIO& io);", "must not name ImGuiIO"),
]


def self_test():
    """The rows of SELF_TEST that go wrong."""
    failures = []
    for name, text, expected in SELF_TEST:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True)
            path.write_text(text)
            found = check(pathlib.Path(folder))
        is_right = found == [] if expected is None else len(found) == 1 and expected in found[0]
        if not is_right:
            failures.append(f"{name} with {text!r}: expected {expected!r}, found {found}")
    return failures


def main(arguments):
    """Prints mistakes; the exit status is 1 when there are any."""
    if arguments == ["--self-test"]:
        mistakes = self_test()
    else:
        mistakes = check(pathlib.Path(arguments[0] if arguments else pathlib.Path(__file__).parent.parent))
    for mistake in mistakes:
        print(mistake, file=sys.stderr)
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
