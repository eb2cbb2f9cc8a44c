"""The check of links can fail: a whole site, and sites and pages with one fault each."""

import pathlib
import tempfile
import unittest

import check_site

WHOLE = {
    "index.html": '<html><head><link rel="stylesheet" href="s.css"><script src="a.js"></script></head><body id="top">'
    '<a href="b.html#here">b</a> <a href="https://example.org/">elsewhere</a> <img src="p.svg" style="color:red"></body></html>',
    "b.html": '<html><body><p id="here"></p><a href="index.html">back</a><a href="#here">here</a></body></html>',
    "s.css": "/* https://example.org/ */ body { background: url(p.svg); }",
    "a.js": "// see https://example.org/x\nconst name = 'http://www.w3.org/2000/svg';\n",
    "p.svg": "<svg/>",
}


class Sites(unittest.TestCase):
    def faults(self, **changes):
        with tempfile.TemporaryDirectory() as folder:
            site = pathlib.Path(folder).resolve()
            for name, text in {
                **WHOLE,
                **{name.replace("_", "."): text for name, text in changes.items()},
            }.items():
                if text is not None:
                    (site / name).write_text(text, encoding="utf-8")
            return check_site.site_faults(site)

    def page(self, inside):
        return f"<html><head>{inside}</head></html>"

    def test_a_whole_site(self):
        self.assertEqual(self.faults(), [])

    def test_what_is_loaded_from_elsewhere(self):
        for inside in (
            '<script src="https://example.org/a.js"></script>',
            '<script src="//example.org/a.js"></script>',
            '<link rel="stylesheet" href="http://example.org/s.css">',
            '<link rel="preconnect" href="https://example.org">', '<img src="/p.svg">',
            '<img srcset="p.svg 1x, https://example.org/p.svg 2x">',
            '<iframe src="https://example.org"></iframe>',
            '<p style="background: url(https://example.org/p.svg)"></p>',
            "<style>@import 'https://example.org/s.css';</style>",
            "<script>fetch('https://example.org/data')</script>",
            "<form action='https://example.org/'></form>",
            "<p onclick=\"open('https://example.org/')\"></p>",
        ):
            self.assertEqual(len(self.faults(c_html=self.page(inside))), 1, inside)
        self.assertEqual(len(self.faults(s_css="@import url(https://example.org/s.css);")), 1)
        self.assertEqual(
            len(self.faults(s_css="@font-face { src: url('//example.org/f.woff') }")), 1
        )
        self.assertEqual(len(self.faults(a_js="import('https://example.org/m.js')")), 1)
        self.assertEqual(len(self.faults(a_js="new WebSocket('wss://example.org/s')")), 1)
        self.assertEqual(len(self.faults(a_js='load("//cdn.example.org/m.js")')), 1)

    def test_what_is_not_there(self):
        for inside in (
            '<a href="c2.html">c</a>', '<a href="b.html#there">b</a>', '<a href="#there">b</a>',
            '<img src="q.svg">', '<link rel="icon" href="i.svg">', '<a href="/b.html">b</a>',
        ):
            self.assertEqual(len(self.faults(c_html=self.page(inside))), 1, inside)
        self.assertEqual(len(self.faults(s_css="p { background: url(q.svg) }")), 1)
        self.assertEqual(len(self.faults(p_svg=None)), 2)  # The page and the style sheet load it.


class Sources(unittest.TestCase):
    def faults(self, text):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            (root / "docs").mkdir()
            (root / "README.md").write_text(text, encoding="utf-8")
            (root / "docs/a.md").write_text(
                "# A `b`: c, d\n\n## Twice\n\n## Twice\n\n```\n# No heading\n```\n",
                encoding="utf-8",
            )
            return check_site.page_faults(root)

    def test_links(self):
        for right in (
            "[a](docs/a.md)", "[a](docs/a.md#a-b-c-d)", "[a](docs/a.md#twice-1)",
            "[a](https://example.org)", "`[a](no.md)`", "# Here\n\n[a](#here)", "![a](docs/a.md)",
        ):
            self.assertEqual(self.faults(right), [], right)
        for wrong in (
            "[a](docs/b.md)", "[a](docs/a.md#b)", "[a](docs/a.md#no-heading)", "[a](#here)",
            "![a](docs/a.png)", "[b.hpp](docs/a.md)", "[docs/a.h](docs/a.md)",
        ):
            self.assertEqual(len(self.faults(wrong)), 1, wrong)


if __name__ == "__main__":
    unittest.main()
