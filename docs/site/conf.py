"""How Sphinx makes the guide and the Python reference; docs/site/build.py calls it."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import formulas  # noqa: E402 (it stands beside this file)

project = "Changeover"
author = "The Changeover developers"
copyright = author  # noqa: A001 (Sphinx's name)
version = release = os.environ["CHANGEOVER_VERSION"]

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.mathjax"]
exclude_patterns = ["files"]
nitpicky = True
# Types of the standard library have no pages here.
nitpick_ignore_regex = [
    (
        r"py:.*",
        r"(collections\.abc\.|typing\.|decimal\.|datetime\.|os\.)?"
        r"(int|str|bool|float|None|object|list|dict|tuple|range|slice|memoryview|Any|Literal|Union"
        r"|Callable|Iterable|Iterator|Mapping|Sequence|SupportsIndex|Decimal|date|PathLike|\w*Error"
        r"|Exception)",
    )
]
# Names for types of arguments, which the page of the reference explains.
nitpick_ignore = [
    ("py:class", name)
    for name in (
        "Cost", "Part", "Pair", "Parts", "Pairs", "Room", "Done", "Objective", "CostUnit",
        "Benches", "First", "Model", "Day",
    )
]
smartquotes = False
highlight_language = "none"

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_dmath_double_inline = True
myst_update_mathjax = False
suppress_warnings = ["myst.header"]  # A page of the program has a level less here and there.

html_theme = "furo"
html_title = f"Changeover {release}"
html_static_path = [os.environ["CHANGEOVER_STATIC"]]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_show_search_summary = False  # It would ask for pages, which a browser does not give to a file.
html_theme_options = {"navigation_with_keys": True}

# MathJax 2 from the site's own files. Only what Sphinx marks as a formula is looked at.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {
    "showMathMenu": False,
    "showProcessingMessages": False,
    "messageStyle": "none",
    "skipStartupTypeset": False,
    "menuSettings": {
        "assistiveMML": False,
        "collapsible": False,
        "explorer": False,
        "inTabOrder": False,
    },
    "SVG": {"font": "TeX", "scale": 92, "linebreaks": {"automatic": True, "width": "container"}},
    "tex2jax": {
        "inlineMath": [["\\(", "\\)"]],
        "displayMath": [["\\[", "\\]"]],
        "ignoreClass": "document|body|content",
        "processClass": "math",
    },
}

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autoclass_content = "class"
autodoc_class_signature = "separated"
add_module_names = False


def docstring(app, what, name, obj, options, lines):
    """Docstrings write names as `this`, which is Markdown's code and not a reference."""
    for i, line in enumerate(lines):
        lines[i] = line if "``" in line else line.replace("`", "``")


def consoles(app, doctree):
    """Indented code that begins with a prompt is a session."""
    from docutils import nodes

    for block in doctree.findall(nodes.literal_block):
        if block.get("language", "none") in ("none", "default") and block.astext().startswith("$ "):
            block["language"] = "console"


# Pages whose mathematics is plain text.
MATHEMATICS = {"theorems", "trust", "paper", "new_designs", "loadorder"}


def mathematics(app, doctree):
    """Formulas of these pages as formulas, and indices of the text as indices."""
    from docutils import nodes

    if app.env.docname not in MATHEMATICS:
        return
    if app.env.docname == "theorems":
        app.env.get_domain("math").data["has_equations"][
            "theorems"
        ] = True  # So that MathJax is loaded.
        for block in list(doctree.findall(nodes.literal_block)):
            if not block.astext().startswith("$ "):
                latex = rf"\[{formulas.to_latex(block.astext().strip())}\]"
                block.replace_self(nodes.math_block(latex, latex, nowrap=True, number=None))
    for text in list(doctree.findall(nodes.Text)):
        if isinstance(
            text.parent,
            (
                nodes.literal, nodes.literal_block, nodes.math, nodes.math_block, nodes.comment,
                nodes.raw,
            ),
        ):
            continue
        pieces = formulas.scripts(str(text))
        if any(mark for mark, _ in pieces):
            made = [
                nodes.Text(words)
                if not mark
                else (nodes.subscript if mark == "_" else nodes.superscript)("", nodes.Text(words))
                for mark, words in pieces
            ]
            text.parent.replace(text, made)


def setup(app):
    app.connect("autodoc-process-docstring", docstring)
    app.connect("doctree-read", consoles)
    app.connect("doctree-read", mathematics)
