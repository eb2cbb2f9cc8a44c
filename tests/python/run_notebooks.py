"""run_notebooks.py FOLDER: runs the cells of each notebook, in order and in one process a notebook,
and shows what each last line gives as a notebook would: as HTML, a picture or text. Nothing of it
may fail."""

import ast
import json
import pathlib
import sys
import xml.etree.ElementTree as tree


def run(path):
    document = json.loads(path.read_text(encoding="utf-8"))
    assert document["nbformat"] == 4 and len({cell["id"] for cell in document["cells"]}) == len(
        document["cells"]
    )
    space = {"__name__": "__main__"}
    rich = 0
    for number, cell in enumerate(document["cells"]):
        if cell["cell_type"] != "code":
            continue
        assert (
            cell["outputs"] == [] and cell["execution_count"] is None
        ), f"{path}: cell {number} is kept with its output"
        body = ast.parse("".join(cell["source"]), f"{path.name}, cell {number}")
        last = body.body.pop() if isinstance(body.body[-1], ast.Expr) else None
        exec(compile(body, path.name, "exec"), space)
        if last is None:
            continue
        value = eval(compile(ast.Expression(last.value), path.name, "eval"), space)
        for name in ("_repr_html_", "_repr_svg_"):
            if hasattr(value, name):
                tree.fromstring(f"<cell>{getattr(value, name)()}</cell>")
                rich += 1
        assert repr(value)
    return rich


notebooks = sorted(pathlib.Path(sys.argv[1]).glob("*.ipynb"))
shown = {path.name: run(path) for path in notebooks}
if not shown or 0 in shown.values():
    sys.exit(f"a notebook shows nothing rich: {shown}")
