#!/usr/bin/python3
"""Reads the site as it was built, or the pages of the sources, and lists their broken links.

usage: check_site.py SITE          all HTML, style sheets and scripts of a folder
       check_site.py --pages ROOT  the pages of the sources, as a code host shows them

Of a site: nothing that a page loads (scripts, styles, pictures, fonts, frames) is anywhere but in
the site, links between pages lead to files and anchors that are there, and no script has an address
to ask. Of the sources: links lead to files and headings that are there, and a link that has the
name of a header leads to it.
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse

LOADED = {
    ("script", "src"),
    ("img", "src"),
    ("source", "src"),
    ("source", "srcset"),
    ("iframe", "src"),
    ("embed", "src"),
    ("object", "data"),
    ("video", "src"),
    ("audio", "src"),
    ("track", "src"),
    ("input", "src"),
    ("use", "href"),
    ("image", "href"),
    ("form", "action"),
    ("video", "poster"),
    ("img", "srcset"),
    ("base", "href"),
}
# Links that the browser follows by itself; others (canonical, author) are words.
LOADED_LINKS = {
    "stylesheet", "icon", "shortcut icon", "preconnect", "dns-prefetch", "preload", "prefetch",
    "modulepreload", "manifest", "search", "apple-touch-icon", "mask-icon",
}
# Addresses in scripts that are names, or a link in a menu that these pages do not show (MathJax):
# nothing asks them.
NAMES_IN_SCRIPTS = ("http://www.w3.org/", "https://www.w3.org/", "http://www.mathjax.org/")


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.loaded, self.links, self.anchors, self.styles, self.scripts, self.inside = (
            [],
            [],
            set(),
            [],
            [],
            None,
        )

    def handle_starttag(self, tag, attributes):
        given = {name: value or "" for name, value in attributes}
        line = self.getpos()[0]
        if "id" in given:
            self.anchors.add(given["id"])
        if tag == "a" and "name" in given:
            self.anchors.add(given["name"])
        if tag in ("a", "area") and "href" in given:
            self.links.append((line, given["href"]))
        if tag == "link" and given.get("rel", "").lower() in LOADED_LINKS:
            self.loaded.append((line, given.get("href", "")))
        if (
            tag == "meta"
            and given.get("http-equiv", "").lower() == "refresh"
            and "url=" in given.get("content", "").lower()
        ):
            self.links.append((line, re.split("url=", given["content"], flags=re.I)[1]))
        for name, value in given.items():
            if (tag, name) in LOADED:
                self.loaded += (
                    [(line, part.split()[0]) for part in value.split(",")]
                    if name == "srcset"
                    else [(line, value)]
                )
            if name == "style":
                self.styles.append((line, value))
            if name.startswith("on"):
                self.scripts.append((line, value))
        self.inside = tag if tag in ("style", "script") else None
        if tag == "script" and given.get("type", "").lower() not in (
            "",
            "text/javascript",
            "module",
            "application/javascript",
        ):
            self.inside = None

    def handle_endtag(self, tag):
        if tag == self.inside:
            self.inside = None

    def handle_data(self, data):
        if self.inside == "style":
            self.styles.append((self.getpos()[0], data))
        elif self.inside == "script":
            self.scripts.append((self.getpos()[0], data))


def leaves(address):
    """Is it of another place than the folder of the site?"""
    return (
        re.match(r"(?!data:|blob:|javascript:|about:)[A-Za-z][A-Za-z0-9+.-]*:|/", address)
        is not None
    )


def style_faults(text):
    """What a style sheet loads from elsewhere, and what it loads at all."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    loaded = [match.group(2) for match in re.finditer(r"url\(\s*(['\"]?)(.*?)\1\s*\)", text)]
    loaded += [match.group(2) for match in re.finditer(r"@import\s+(['\"])(.*?)\1", text)]
    return loaded


def script_faults(text):
    """Addresses in a script, without its comments."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r"(?m)(^|[\s;{}])//(?![\w.-]+\.[a-z]+/).*$", r"\1", text)
    found = [
        match.group(0)
        for match in re.finditer(
            r"(?:(?:https?|wss?):)//[A-Za-z0-9.-]+\.[A-Za-z]{2,}[^\s'\"`)]*", text
        )
    ]
    found += [
        match.group(1)
        for match in re.finditer(r"['\"`](//[A-Za-z0-9-]+\.[A-Za-z0-9./-]+)['\"`]", text)
    ]
    return [address for address in found if not address.startswith(NAMES_IN_SCRIPTS)]


def site_faults(site):
    faults, pages = [], {}
    for file in sorted(site.rglob("*.html")):
        pages[file.resolve()] = page = Page()
        page.feed(file.read_text(encoding="utf-8"))
        page.close()
    if not pages:
        return [f"{site}: no pages"]

    def target(file, address):
        path = urllib.parse.unquote(address.split("#")[0].split("?")[0])
        return (file.parent / path).resolve() if path else file

    for file, page in pages.items():
        where = file.relative_to(site.resolve())
        for line, address in page.loaded + [
            (line, each) for line, text in page.styles for each in style_faults(text)
        ]:
            if leaves(address):
                faults.append(f"{where}:{line}: loads {address}")
            elif (
                address
                and not re.match("data:|about:|blob:|javascript:", address)
                and not target(file, address).exists()
                and not address.startswith("#")
            ):
                faults.append(f"{where}:{line}: loads {address}, which is not there")
        for line, text in page.scripts:
            faults += [
                f"{where}:{line}: a script has the address {address}"
                for address in script_faults(text)
            ]
        for line, address in page.links:
            if re.match(r"https?:|mailto:|javascript:", address):
                continue
            if leaves(address):
                faults.append(f"{where}:{line}: leads to {address}")
                continue
            there = target(file, address)
            anchor = urllib.parse.unquote(address.partition("#")[2])
            if not there.exists():
                faults.append(f"{where}:{line}: leads to {address}, which is not there")
            elif anchor and there in pages and anchor not in pages[there].anchors:
                faults.append(
                    f"{where}:{line}: leads to {address}, but there is no such place on that page"
                )
    for file in sorted(site.rglob("*.css")):
        for address in style_faults(file.read_text(encoding="utf-8")):
            if leaves(address) or (
                not address.startswith(("data:", "#")) and not target(file, address).exists()
            ):
                faults.append(f"{file.relative_to(site)}: loads {address}")
    for file in sorted(site.rglob("*.js")):
        faults += [f"{file.relative_to(site)}: has the address {address}"
                   for address in script_faults(file.read_text(encoding="utf-8"))]
    return faults


def headings(text):
    """The anchors that a code host gives to the headings of a page."""
    found, counts = set(), {}
    text = re.sub(r"(?ms)^```.*?^```", "", text)
    for match in re.finditer(r"(?m)^#{1,6} +(.*?) *#*$", text):
        words = (
            re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", match.group(1))
            .replace("`", "")
            .replace("*", "")
        )
        anchor = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        number = counts.get(anchor, 0)
        counts[anchor] = number + 1
        found.add(anchor if number == 0 else f"{anchor}-{number}")
    return found


def page_faults(root):
    faults = []
    pages = [
        page
        for page in [
            *root.glob("*.md"),
            *(root / "docs").glob("*.md"),
            *(root / "bench").glob("*.md"),
        ]
    ]
    if not pages:
        return [f"{root}: no pages"]
    for page in sorted(pages):
        text = page.read_text(encoding="utf-8")
        for number, line in enumerate(text.split("\n"), 1):
            for match in re.finditer(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
                address = match.group(1)
                called = re.search(r"\[([\w/]+\.hp?p?)$", line[: line.find(f"]({address})")])
                if called and not f"/{address}".endswith(f"/{called.group(1)}"):
                    faults.append(
                        f"{page.relative_to(root)}:{number}: calls {address} {called.group(1)}"
                    )
                if re.match(r"[a-z]+:", address):
                    continue
                path, _, anchor = address.partition("#")
                there = (page.parent / path).resolve() if path else page.resolve()
                if not there.exists():
                    faults.append(
                        f"{page.relative_to(root)}:{number}: leads to {address}, which is not there"
                    )
                elif (
                    anchor
                    and there.suffix == ".md"
                    and anchor not in headings(there.read_text(encoding="utf-8"))
                ):
                    faults.append(
                        f"{page.relative_to(root)}:{number}: leads to {address}, "
                        "but there is no such heading"
                    )
    return faults


def main():
    if len(sys.argv) == 3 and sys.argv[1] == "--pages":
        faults = page_faults(pathlib.Path(sys.argv[2]))
    elif len(sys.argv) == 2:
        site = pathlib.Path(sys.argv[1])
        if not site.is_dir():
            print(f"skipped: {site} was not built")
            sys.exit(77)
        faults = site_faults(site)
    else:
        sys.exit(__doc__)
    print(
        "\n".join(faults)
        if faults
        else "all links lead somewhere, and nothing is loaded from elsewhere"
    )
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
