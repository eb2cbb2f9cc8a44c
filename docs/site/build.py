#!/usr/bin/python3
"""Builds the site: the guide (Sphinx), the references of Python (autodoc) and C++ (Doxygen).

usage: docs/site/build.py [--out build/site] [--build build/release] [--without-cpp]

The pages are those of docs/ and a few others, which must also be readable on a code host. So they
are not written for Sphinx; they are copied into one folder, and links between them are turned to
where they now are. Needs the program and the Python package of BUILD. Ends with exit code 1 at the
first warning, and with 77 where something is not installed. Nothing of what it writes asks the
network for anything.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent
# Pages that do not come from docs/, by the names they get.
elsewhere = {
    "README.md": "index.md",
    "bench/README.md": "performance.md",
    "examples/lab/README.md": "lab.md",
    "HACKING.md": "hacking.md",
    "CONTRIBUTING.md": "contributing.md",
    "CHANGELOG.md": "changelog.md",
}
mathjax = pathlib.Path("/usr/share/javascript/mathjax")
# What pages with formulas load: TeX in, SVG out. Glyphs are outlines in scripts, so there are no
# fonts to fetch.
mathjax_parts = [
    "MathJax.js", "config/TeX-AMS_SVG.js", "jax/input/TeX", "jax/output/SVG", "jax/element",
    "extensions/TeX", "extensions/MathEvents.js", "extensions/tex2jax.js",
]
awesome = pathlib.Path("/usr/share/doxygen-awesome-css")


def places() -> dict:
    """Where each source of a page comes to stand, both relative to their roots."""
    pages = {f"docs/{page.name}": page.name for page in sorted((root / "docs").glob("*.md"))}
    return {**pages, **elsewhere}


def retarget(text: str, source: str, pages: dict) -> tuple:
    """The text with relative links turned to the site, and the files outside that it links to."""
    wanted = set()
    folder = os.path.dirname(source)

    def turned(match):
        if match["code"]:
            return match.group(0)
        before, target, after = match["before"], match["target"], match["after"]
        path, mark, anchor = target.partition("#")
        if not path or re.match(r"[a-z]+:", target):
            return match.group(0)
        there = os.path.normpath(os.path.join(folder, path))
        if there in pages:
            return f"{before}{pages[there]}{mark}{anchor}{after}"
        if there.startswith("docs/img/"):
            return f"{before}{there[5:]}{after}"
        if (root / there).is_dir():  # No page of the site: the text alone stays.
            return re.sub(r"^.*?\[(.*)\]\($", r"\1", before)
        if (root / there).is_file():
            wanted.add(there)
            return f"{before}files/{there}{after}"
        sys.exit(f"{source}: the link to {target} leads nowhere")

    code = r"(?P<code>(?P<ticks>`+)(?!`)[^\n]*?(?<!`)(?P=ticks)(?!`))"
    link = r"(?P<before>\[[^\]\n]*\]\()(?P<target>[^)\s]+)(?P<after>\))"
    return re.sub(f"{code}|{link}", turned, text), wanted


def commands(described: dict) -> str:
    """The page of all verbs and options, from what the program says of itself."""
    out = [
        "# Commands",
        "",
        "Every verb and option, as `changeover describe` has them. `changeover VERB --help` adds "
        "examples.",
        "",
    ]

    def cell(words: str) -> str:
        return words.replace("|", "\\|").replace("<", "&lt;").replace("$", "\\$")

    for verb in described["verbs"]:
        names = [
            argument["name"] if argument.get("required") else f"[{argument['name']}]"
            for argument in verb["arguments"]
        ]
        out += [
            f"## {verb['typed']}",
            "",
            cell(verb["summary"]) + ".",
            "",
            f"    changeover {' '.join([verb['typed'], *names])}",
            "",
        ]
        rows = [
            (f"`{argument['name']}`", argument.get("help", "")) for argument in verb["arguments"]
        ]
        for option in verb["options"]:
            kind = "" if option["kind"] == "flag" else " " + option["kind"].upper()
            words = ", ".join(f"`{word}`" for word in option.get("words", []))
            rows.append((", ".join(f"`{name}{kind}`" for name in option["names"]),
                         cell(option.get("help", "")) + (f": {words}" if words else "")))
        if rows:
            out += ["| | |", "|:---|:---|", *(f"| {name} | {words} |" for name, words in rows), ""]
    return "\n".join(out)


def stage(folder: pathlib.Path, static: pathlib.Path, program: pathlib.Path) -> None:
    for made in (folder, static):
        shutil.rmtree(made, ignore_errors=True)
        made.mkdir(parents=True)
    pages = places()
    wanted = set()
    for source, page in pages.items():
        if page == "index.md":
            continue  # The site has its own first page.
        text, files = retarget((root / source).read_text(encoding="utf-8"), source, pages)
        (folder / page).write_text(text, encoding="utf-8")
        wanted |= files
    for file in wanted:
        (folder / "files" / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(root / file, folder / "files" / file)
    for page in here.glob("*.md"):
        shutil.copyfile(page, folder / page.name)
    described = subprocess.run(
        [program, "describe"], check=True, capture_output=True, text=True
    ).stdout
    (folder / "commands.md").write_text(commands(json.loads(described)), encoding="utf-8")
    shutil.copytree(root / "docs" / "img", folder / "img")
    for part in mathjax_parts:
        target = static / "mathjax" / part
        target.parent.mkdir(parents=True, exist_ok=True)
        if (mathjax / part).is_dir():
            shutil.copytree(mathjax / part, target)
        else:
            shutil.copyfile(mathjax / part, target)
    shutil.copyfile(here / "site.css", static / "site.css")


def version() -> str:
    return re.search(
        r"project\([^)]*VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text(encoding="utf-8")
    ).group(1)


def fill(template: str, **values: object) -> str:
    return re.sub(
        r"@([a-z_]+)@",
        lambda match: str(values[match.group(1)]),
        (here / template).read_text(encoding="utf-8"),
    )


def run(*command: object, **environment: str) -> None:
    done = subprocess.run(
        [str(word) for word in command], cwd=root, env={**os.environ, **environment}
    )
    if done.returncode:
        sys.exit(f"{command[0]} ended with code {done.returncode}")


def build_cpp(build: pathlib.Path, scratch: pathlib.Path, out: pathlib.Path) -> None:
    """The C++ reference, of the public headers and the one that the build writes."""
    for made in (scratch, out):
        shutil.rmtree(made, ignore_errors=True)
    headers = scratch / "include"
    shutil.copytree(root / "include", headers)
    shutil.copyfile(
        build / "generated/include/changeover/core/version.hpp",
        headers / "changeover/core/version.hpp",
    )
    shutil.copyfile(here / "cpp_main.dox", headers / "main.dox")
    header, layout = scratch / "header.html", scratch / "layout.xml"
    run("doxygen", "-w", "html", header, scratch / "footer.html", scratch / "style.css")
    # Doxygen's own head, and the button for light and dark.
    header.write_text(
        header.read_text(encoding="utf-8").replace(
            "</head>",
            '<script type="text/javascript" '
            'src="$relpath^doxygen-awesome-darkmode-toggle.js"></script>\n'
            '<script type="text/javascript">DoxygenAwesomeDarkModeToggle.init()</script>\n</head>',
        ),
        encoding="utf-8",
    )
    # Doxygen's own layout, with what a header says of itself before the list of what is in it.
    run("doxygen", "-l", layout)
    text = layout.read_text(encoding="utf-8")
    for kind in ("file", "class"):
        part = re.search(rf"<{kind}>.*?</{kind}>", text, re.S).group(0)
        words = re.search(r"\s*<detaileddescription[^>]*/>", part).group(0)
        changed = re.sub(
            r"\s*<briefdescription[^>]*/>",
            lambda _: words.replace('title=""', 'title=" "'),
            part.replace(words, ""),
            count=1,
        )
        text = text.replace(part, changed)
    layout.write_text(text, encoding="utf-8")
    (scratch / "Doxyfile").write_text(
        fill(
            "Doxyfile.in",
            headers=headers,
            here=here,
            out=out,
            awesome=awesome,
            version=version(),
            scratch=scratch,
            layout=layout,
        ),
        encoding="utf-8",
    )
    run("doxygen", scratch / "Doxyfile")
    settle_anchors(out)
    style = out / "doxygen.css"
    style.write_text(settled_style(style.read_text(encoding="utf-8"), out), encoding="utf-8")


def settled_style(text: str, folder: pathlib.Path) -> str:
    """The style without pictures of parts that are turned off (Doxygen 1.9.8: the search)."""
    return re.sub(
        r"url\(\s*(['\"]?)([^'\":)]+)\1\s*\)",
        lambda match: match.group(0) if (folder / match.group(2)).exists() else "none",
        text,
    )


def settle_anchors(out: pathlib.Path) -> None:
    """Turns links to private members, which Doxygen leaves out, to their page."""
    pages = {page.name: page.read_text(encoding="utf-8") for page in out.glob("*.html")}
    anchors = {
        name: set(re.findall(r'(?:id|name)="([^"]+)"', text)) for name, text in pages.items()
    }

    def settled(name: str, match: re.Match) -> str:
        there = match.group(1) or name
        return (
            match.group(0)
            if there not in anchors or match.group(2) in anchors[there]
            else f'href="{there}"'
        )

    for name, text in pages.items():
        changed = re.sub(
            r'href="([^"#:]*)#([^"]+)"', lambda match, name=name: settled(name, match), text
        )
        if changed != text:
            (out / name).write_text(changed, encoding="utf-8")


def settle_theme(out: pathlib.Path) -> None:
    """Mends what Debian's build of the theme lost. Its style imports one from the root of a web
    server, and its script another as a module, neither of which a page that is a file can: what is
    imported is put in the place of the import. And a reader whose system is dark gets the dark look
    without asking for it."""
    script = out / "_static/scripts/furo.js"
    text = script.read_text(encoding="utf-8")
    script.write_text(
        re.sub(
            r'import Gumshoe from "\./(gumshoe-patched\.js)";',
            lambda match: script.with_name(match.group(1)).read_text(encoding="utf-8"),
            text,
        ),
        encoding="utf-8",
    )
    style = out / "_static/styles/furo.css"
    text = re.sub(
        r"@import url\((/javascript/[^)]+)\);",
        lambda match: pathlib.Path("/usr/share" + match.group(1)).read_text(encoding="utf-8"),
        style.read_text(encoding="utf-8"),
    )
    if "prefers-color-scheme" not in text:
        dark = re.search(
            r"@media not print \{\s*(body\[data-theme=\"dark\"\].*?\} *\})\s*\n\n", text, re.S
        ).group(1)
        text += f"\n@media screen and (prefers-color-scheme: dark) {{\n{dark}\n".replace(
            '"dark"', '"auto"'
        )
    style.write_text(text, encoding="utf-8")


def missing(cpp: bool) -> str:
    for module, package in (
        ("sphinx", "python3-sphinx"),
        ("myst_parser", "python3-myst-parser"),
        ("furo", "furo"),
    ):
        if subprocess.run(
            [sys.executable, "-c", f"import {module}"], capture_output=True
        ).returncode:
            return package
    if not mathjax.is_dir():
        return "libjs-mathjax"
    if cpp and not shutil.which("doxygen"):
        return "doxygen"
    if cpp and not awesome.is_dir():
        return "doxygen-awesome-css"
    return ""


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--out", type=pathlib.Path, default=root / "build" / "site")
    parser.add_argument("--build", type=pathlib.Path, default=root / "build" / "release")
    parser.add_argument(
        "--without-cpp", action="store_true", help="the guide alone, which is faster"
    )
    arguments = parser.parse_args()
    package = missing(not arguments.without_cpp)
    if package:
        print(f"skipped: {package} is not installed; ./dev docs brings it")
        sys.exit(77)
    out, build = arguments.out.resolve(), arguments.build.resolve()
    scratch = out.with_name(out.name + ".work")
    stage(scratch / "pages", scratch / "static", build / "changeover")
    shutil.rmtree(out / "_static", ignore_errors=True)
    run(
        sys.executable, "-m", "sphinx", "-W", "--keep-going", "-n", "-q", "-j", "2", "-b", "html",
        "-c", here, "-d",
        scratch / "doctrees",
        scratch / "pages",
        out,
        PYTHONPATH=str(build / "python"),
        CHANGEOVER_CATALOG="",
        CHANGEOVER_VERSION=version(),
        CHANGEOVER_STATIC=str(scratch / "static"),
        PYTHONDONTWRITEBYTECODE="1",
    )
    settle_theme(out)
    if not arguments.without_cpp:
        build_cpp(build, scratch / "cpp", out / "cpp")
    for leftover in (".buildinfo", "objects.inv"):  # They are not used here.
        (out / leftover).unlink(missing_ok=True)
    print(f"the site: {out}/index.html")


if __name__ == "__main__":
    main()
