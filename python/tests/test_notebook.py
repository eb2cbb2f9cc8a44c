"""What notebooks show, pictures, frames, pickles, progress."""

import contextlib
import io
import multiprocessing
import os
import pathlib
import pickle
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
import xml.etree.ElementTree as tree
import zlib

import changeover
from changeover import _progress, cluster

try:
    import pandas
except ImportError:
    pandas = None


def well_formed(markup):
    """The element that a text is; what is no XML raises."""
    return tree.fromstring(markup)


class Shown(unittest.TestCase):
    def test_a_small_design_is_a_picture_and_a_large_one_a_table(self):
        small = changeover.design(8, 5)
        self.assertIn("minimum", small._repr_html_())
        self.assertIn("<svg", small._repr_html_())
        self.assertTrue(well_formed(small._repr_svg_()).tag.endswith("svg"))
        large = changeover.design(61, 4)
        self.assertIsNone(large._repr_svg_())
        latex = large._repr_latex_()
        self.assertIn("60 of 366 rows", latex)
        self.assertEqual(latex.count(r"\\"), 1 + 60)
        self.assertIn(r"\textbf{circular DCCD(61,4), 366 blocks", latex)
        self.assertIn("60 of 366 rows", large._repr_html_())
        well_formed(large._repr_html_())

    def test_names_are_escaped(self):
        names = ["<b>", "a&b", "c_1"]
        design = changeover.Design(
            [[names[0], names[1]], [names[1], names[2]], [names[2], names[0]]] * 30
        )
        page = design._repr_html_()
        self.assertIn("&lt;b&gt;, a&amp;b", page)
        well_formed(page)
        latex = changeover.Design(
            [["$x^^5c", "a&b"], ["a&b", "c~1"], ["c~1", "$x^^5c"]]
        )._repr_latex_()
        # Within a formula these are no letters to LaTeX or to MathJax: the names stand in a table.
        self.assertIn(r"\$x", latex)
        self.assertNotRegex(latex, r"[~^]|\$\$")
        self.assertIn(r"a\&b", latex)
        latex = changeover.Design([["c$", "cS", r"\d"], ["cS", r"\d", "/d"]])._repr_latex_()
        self.assertEqual([latex.count(name) for name in (r"c\$", "cS", "textbackslash", "/d")],
                         [1, 2, 2, 1])

    def test_a_wrong_design_is_called_so(self):
        self.assertIn("not valid", changeover.Design([[0, 1], [2, 3]])._repr_html_())

    def test_verdicts_bounds_and_tables(self):
        design = changeover.design(8, 5)
        for each in (design.verdict, changeover.bounds(8, 5), changeover.table((3, 5), (4, 9))):
            for part in (
                each._repr_html_()
                .replace("</div>\n<div>\n<strong>", "</div>\0<div>\n<strong>")
                .split("\0")
            ):
                well_formed(part)
        self.assertIn("≥ 29", changeover.bounds(20, 5)._repr_html_())
        self.assertIn("can be followed only", changeover.bounds(4, 2)._repr_html_())
        self.assertNotIn("<table", changeover.bounds(4, 2)._repr_html_())
        table = changeover.table(4, (2, 8), kind="linear")
        self.assertIn(">6=</td>", table._repr_html_())
        self.assertIn("double-change", table._repr_html_())
        self.assertEqual(len(table), 7)

    def test_run_sheets_and_load_orders(self):
        sheet = changeover.plan(9, 3, test_cost=1, change_cost=5)
        self.assertIn('text-align:left">4, 6, 9</td>', sheet._repr_html_())
        both = changeover.plan(9, 3, test_cost=1, change_cost=5, benches=2)
        self.assertIn(">bench</th>", both._repr_html_())
        order = changeover.load_order(20, 5)
        self.assertIn("20 of 46 steps", order._repr_html_())
        shares = changeover.load_order(20, 5, workers=2, epochs=2)
        page = shares._repr_html_()
        for loads, pairs in zip(shares.worker_loads, shares.worker_pairs):
            self.assertRegex(page, f">{loads}</td><td[^>]*>{pairs}</td>")
        many = changeover.load_order(200, 20, workers=30)
        self.assertIn("20 of 30 workers", many._repr_html_())
        for each in (sheet, both, order, shares, many):
            well_formed(each._repr_html_())
        if pandas:
            frame = shares.to_frame()["load"].map(len)
            self.assertEqual([frame[worker].sum() for worker in range(2)], shares.worker_loads)
            self.assertEqual(len(sheet.to_frame()), sheet.tests)
            frame = both.to_frame()
            self.assertEqual(frame.index.names, ["bench", "number"])
            self.assertEqual([list(frame.loc[bench].index) for bench in both.benches],
                             [[step["number"] for step in sheet] for sheet in both.sheets])
            self.assertEqual(list(order.to_frame()["load"].map(len))[0], 5)

    def test_what_searches_found_and_what_is_kept(self):
        found = changeover.search(9, 4, change=1, time=5)
        proved = changeover.search(6, 3, 1, exact=True)
        classes = changeover.classify(9, 4, 12, 1, "circular")
        entry = changeover.catalog.cell(20, 5)[0]
        run = cluster.simulate(items=200, room=20, workers=2, pair_seconds=0.001, item_bytes=9)
        blocks = changeover.design(9, 4).blocks
        for each, words in (
            (found, "found"), (proved, "proved: no design"), (classes, "order of the group"),
            (entry, "lower bound"), (run, "idle"), (blocks, "8 blocks of 4 elements"),
        ):
            page = each._repr_html_()
            well_formed(page)
            self.assertIn(words, page)
            self.assertEqual(len(taken_apart(each._repr_latex_())), 1)
        self.assertIn("<i>b</i> ≥", entry._repr_html_())
        self.assertEqual(blocks._repr_html_().count("<tr>"), 1 + len(blocks))


def taken_apart(latex):
    """The rows of the tables of a LaTeX text by environment. Raises for what does not fit: an
    environment or a brace that is left open, a row with more or fewer cells than columns."""
    open_braces = 0
    for sign in re.findall(r"\\.|[{}]", latex, re.DOTALL):
        open_braces += {"{": 1, "}": -1}.get(sign, 0)
        if open_braces < 0:
            raise ValueError("} without {")
    if open_braces or latex.count("\\begingroup") != latex.count("\\endgroup"):
        raise ValueError("a group is left open")
    tables, around = [], []
    for line in latex.splitlines():
        begun = re.match(r"\\begin\{(\w+)\}(?:\{(.*)\})?$", line)
        ended = re.match(r"\\end\{(\w+)\}$", line)
        if begun:
            around.append(begun[1])
            if begun[2]:
                columns = len(re.sub(r"p\{[^}]*\}", "p", begun[2]))
                tables.append([])
        elif ended:
            if not around or around.pop() != ended[1]:
                raise ValueError(f"{line} ends nothing")
        elif line.endswith(" \\\\") and around:
            cells = re.split(r"(?<!\\)&", line[:-3])
            if len(cells) != columns:
                raise ValueError(f"{len(cells)} cells for {columns} columns: {line}")
            tables[-1].append([cell.strip() for cell in cells])
    if around:
        raise ValueError(f"{around} is left open")
    return tables


hard_names = ["a_1", "R&D", "50%", "#4", "x~y", "$z", "{q", "b\\c", "[br]", "*st", "^hat", "<lt>"]


def hard_sheet():
    return changeover.plan(hard_names, 4, test_cost=1, change_cost=5)


class Latex(unittest.TestCase):
    def test_what_is_shown_on_pages_is_also_latex(self):
        sheet = changeover.plan(9, 3, test_cost=1, change_cost=5)
        both = changeover.plan(9, 3, test_cost=1, change_cost=5, benches=2)
        order = changeover.load_order(20, 5)
        shares = changeover.load_order(20, 5, workers=2)
        verdict = changeover.design(8, 5).verdict
        for each, rows in ((sheet, sheet.tests), (both, both.tests), (order, 20), (shares, 2),
                           (verdict, 9)):
            (table,) = taken_apart(each._repr_latex_())
            self.assertEqual(len(table), 1 + rows, each)
        (table,) = taken_apart(sheet._repr_latex_())
        self.assertEqual(table[0], ["number", "take out", "put in", "setup", "cost so far"])
        for step, row in zip(sheet.steps, table[1:]):
            self.assertEqual(row[3], ", ".join(step["setup"]))
            self.assertEqual(row[4], str(step["cost_so_far"]))

    def test_names_of_parts_are_text(self):
        latex = hard_sheet()._repr_latex_()
        for table in taken_apart(latex):
            self.assertEqual(len(table), 1 + hard_sheet().tests)
        for written in (r"a\_1", r"R\&D", r"50\%", r"\#4", r"x\textasciitilde{}y", r"\$z", r"\{q",
                        r"b\textbackslash{}c", r"\textasciicircum{}hat",
                        r"\textless{}lt\textgreater{}"):
            self.assertIn(written, latex)

    def test_names_are_no_formulas(self):
        names = ["A-1", "A - 1", "B_2", "D=4", "ceil(5/2)"]
        sheet = changeover.plan(names, 3, test_cost=1, change_cost=1, steps=20)
        tables = sheet._repr_latex_().partition(r"\begin{tabular}")[2]
        self.assertNotIn("$", tables)
        for name in names:
            self.assertIn(name.replace("_", r"\_"), tables)

    def test_a_wide_cell_has_lines(self):
        names = [f"a pump with a rather long name {i}" for i in range(9)]
        sheet = changeover.plan(names, 4, test_cost=1, change_cost=1)
        latex = sheet._repr_latex_()
        self.assertIn(r"p{0.4\linewidth}", latex)
        self.assertEqual(sum(len(table) - 1 for table in taken_apart(latex)), 2 * sheet.tests)

    def test_more_rows_than_a_page_is_told(self):
        sheet = changeover.plan(30, 3, test_cost=1, change_cost=5, time=0.2)
        self.assertGreater(sheet.tests, 60)
        (table,) = taken_apart(sheet._repr_latex_())
        self.assertEqual(len(table), 61)
        self.assertIn(f"60 of {sheet.tests} rows", sheet._repr_latex_())

    def test_tables_are_those_of_the_command_line(self):
        table = changeover.table((3, 6), (4, 12))
        bounds = changeover.bounds(20, 5)
        for latex in (table._repr_latex_(), table.to_latex()):
            tables = taken_apart(latex)
            self.assertEqual([len(each) for each in tables], [10, 10])
            self.assertEqual(tables[0][0][1], "$k=3$")
        self.assertIn("[ChafeeStevens2025", table._repr_latex_())
        self.assertNotIn("\\cite", table._repr_latex_() + bounds._repr_latex_())
        self.assertIn("{ChafeeStevens2025}", table.to_latex())
        self.assertEqual(taken_apart(bounds._repr_latex_()), [])
        self.assertEqual(bounds.to_latex().count("\\item"), len(bounds.all) + 1)
        program = pathlib.Path(changeover.__file__).parents[2] / "changeover"
        if not program.is_file():
            self.skipTest("no program beside the package")
        for words, latex in (("table --k 3..6 --v 4..12", table.to_latex()),
                             ("bounds 20 5 --circular", bounds.to_latex())):
            said = subprocess.run([program, *words.split(), "--format", "latex"],
                                  capture_output=True, check=True, encoding="utf-8").stdout
            self.assertEqual(latex, said)

    def test_a_table_with_holes_has_no_latex(self):
        table = changeover.table((3, 5), (4, 9), kind="linear")
        some = changeover.Table(cell for cell in table if cell.b != 6)
        self.assertLess(len(some), len(table))
        self.assertIsNone(some._repr_latex_())
        with self.assertRaisesRegex(changeover.BadInput, "not all cells of a range"):
            some.to_latex()
        self.assertIsNone(changeover.Table()._repr_latex_())
        self.assertIsNone(changeover.Table()._repr_svg_())
        self.assertEqual(some.draw().svg.count("data-v="), len(some))

    @unittest.skipUnless(shutil.which("pdflatex") and shutil.which("kpsewhich"), "no pdflatex")
    def test_it_compiles(self):
        for package in ("booktabs.sty", "longtable.sty", "amsmath.sty"):
            if subprocess.run(["kpsewhich", package], stdout=subprocess.DEVNULL).returncode != 0:
                self.skipTest(f"no {package}")
        shown = [changeover.design(8, 5), changeover.design(8, 5).verdict, hard_sheet(),
                 changeover.plan(9, 3, test_cost=1, change_cost=5, benches=2),
                 changeover.bounds(20, 5), changeover.bounds(4, 2),
                 changeover.table((3, 8), (4, 50)), changeover.load_order(20, 5),
                 changeover.load_order(20, 5, workers=2)]
        body = "\n\n".join(each._repr_latex_() for each in shown)
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "it.tex").write_text(
                "\\documentclass{article}\\usepackage[T1]{fontenc}"
                "\\usepackage{amsmath,booktabs,longtable}\n\\begin{document}\n"
                f"{body}\n\\end{{document}}\n", encoding="utf-8")
            run = subprocess.run(
                ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "it.tex"],
                cwd=folder, capture_output=True, text=True, errors="replace")
            self.assertEqual(run.returncode, 0, run.stdout[-2000:])
            self.assertIn("Output written", run.stdout)


class Pictures(unittest.TestCase):
    def test_sheets_orders_and_tables_are_drawn(self):
        sheet = changeover.plan(9, 3, test_cost=1, change_cost=5)
        both = changeover.plan(9, 3, test_cost=1, change_cost=5, benches=2)
        order = changeover.load_order(20, 5)
        shares = changeover.load_order(20, 5, workers=2)
        table = changeover.table((3, 5), (4, 9))
        for each in (sheet, both, order, shares, table):
            self.assertTrue(well_formed(each._repr_svg_()).tag.endswith("svg"))
            self.assertIn("tikzpicture", each.draw().tikz)
            self.assertNotEqual(each.draw(theme="dark").svg, each.draw().svg)
        self.assertEqual(sheet._repr_svg_().count('data-element="'), 9)
        # As many bars as times that a part is put on the bench.
        self.assertEqual(sheet._repr_svg_().count('class="stay"'),
                         sum(len(step["put_in"]) for step in sheet.steps))
        self.assertIn("tests of a stay", sheet._repr_svg_())
        self.assertEqual(order._repr_svg_().count('class="stay"'), order.loads)
        self.assertEqual(shares._repr_svg_().count('class="stay"'), shares.loads)
        self.assertIn(order._repr_svg_(), order._repr_html_())
        self.assertEqual(table._repr_svg_().count("data-v="), len(table))
        self.assertIsNone(changeover.load_order(200, 20)._repr_svg_())
        with self.assertRaisesRegex(changeover.BadInput, "at most 2000 items"):
            changeover.load_order(3000, 20).draw()
        nothing = changeover.plan(
            ["a", "b"], 2, test_cost=1, change_cost=1, done=[(["a", "b"], True)])
        self.assertIsNone(nothing._repr_svg_())
        self.assertEqual(taken_apart(nothing._repr_latex_()), [])
        with self.assertRaisesRegex(changeover.BadInput, "there is no test to draw"):
            nothing.draw()
        with self.assertRaisesRegex(changeover.BadInput, "a picture is of cells of one change"):
            changeover.Table([*table, table[0]]).draw()
        with self.assertRaisesRegex(changeover.BadInput, "theme is 'light' or 'dark', not 'pink'"):
            sheet.draw(theme="pink")
        with self.assertRaisesRegex(
            changeover.BadInput, "measure is 'ratio', 'status' or 'gap', not 'size'"
        ):
            table.draw("size")

    def test_each_kind_is_drawn(self):
        design = changeover.design(15, 5)
        for kind in ("array", "stays", "coverage", "circle", "recipe"):
            for theme in ("light", "dark"):
                picture = design.draw(kind, theme=theme)
                self.assertTrue(well_formed(picture.svg).tag.endswith("svg"))
                self.assertIn("tikzpicture", picture.tikz)
        self.assertEqual(design.draw("stays")._repr_svg_(), design.draw("stays").svg)

    def test_faults_speak_python(self):
        design = changeover.design(8, 5)
        with self.assertRaisesRegex(changeover.BadInput, "^first 9: there are fewer blocks"):
            design.draw(first=9)
        with self.assertRaisesRegex(changeover.BadInput, "no such picture"):
            design.draw("oil")
        with self.assertRaisesRegex(changeover.BadInput, "first and last"):
            changeover.design(991, 51).draw()
        large = changeover.design(200, 4).draw()
        with self.assertRaisesRegex(changeover.BadInput, "too large for TeX"):
            large.tikz

    def test_files_are_whole(self):
        picture = changeover.design(8, 5).draw()
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "d.svg"
            file.write_text("before")
            picture.save(str(file))
            self.assertEqual(file.read_text(encoding="utf-8"), picture.svg)
            self.assertEqual(file.stat().st_mode & 0o777, 0o666 & ~self.mask())
            picture.save(str(file.with_suffix(".tex")))
            self.assertEqual(file.with_suffix(".tex").read_text(encoding="utf-8"), picture.tikz)
            with self.assertRaisesRegex(
                changeover.BadInput, "unknown file extension; use .svg, .tikz or .tex"
            ):
                picture.save(str(file.with_suffix(".pdf")))
            with self.assertRaisesRegex(changeover.MissingResource, "d.svg"):
                picture.save(str(file / "x" / "d.svg"))
            self.assertEqual(sorted(os.listdir(folder)), ["d.svg", "d.tex"])

    @staticmethod
    def mask():
        mask = os.umask(0)
        os.umask(mask)
        return mask


class Sequences(unittest.TestCase):
    def test_a_design_has_its_blocks_as_members(self):
        design = changeover.design(8, 5)
        self.assertEqual(design[0], design.blocks[0])
        self.assertEqual(design[-1], list(design)[-1])
        self.assertEqual(design[1:3], design.blocks[1:3])
        with self.assertRaises(IndexError):
            design[5]

    def test_equal_designs_are_one_key(self):
        one, other = changeover.design(9, 4), changeover.design(9, 4)
        self.assertEqual(one, other)
        self.assertEqual(len({one, other, one.canonical()}), 2 if one.canonical() != one else 1)
        self.assertEqual(len({one.blocks, other.blocks, one.blocks[:3]}), 2)


@unittest.skipUnless(pandas, "no pandas")
class Frames(unittest.TestCase):
    def test_there_and_back(self):
        design = changeover.design(15, 5)
        self.assertEqual(
            changeover.Design(design.to_frame(), v=15, kind=design.kind).blocks, design.blocks
        )
        frame = changeover.table((2, 4), (4, 6)).to_frame()
        self.assertEqual(str(frame["b"].dtype), "Int64")
        self.assertEqual(list(frame[(frame.v == 4) & (frame.k == 2)]["status"]), ["impossible"] * 2)


def minimum_of(v):
    return changeover.bounds(v, 4)


class Pickles(unittest.TestCase):
    def test_answers_go_there_and_back(self):
        design = changeover.design(9, 4)
        for each in (
            design.verdict,
            changeover.bounds(9, 4),
            changeover.bounds(9, 4).all[0],
            changeover.table(4, 9)[0],
            changeover.search(9, 4, change=1, time=1),
            changeover.classify(9, 4, 6, 2, "circular"),
            design.draw(),
        ):
            again = pickle.loads(pickle.dumps(each))
            self.assertEqual(repr(again), repr(each))
            for name in dir(type(each)):
                if isinstance(getattr(type(each), name), property):
                    self.assertEqual(repr(getattr(again, name)), repr(getattr(each, name)), name)
        self.assertEqual(
            pickle.loads(pickle.dumps(design.verdict)).as_dict(), design.verdict.as_dict()
        )

    def test_what_was_tampered_with_is_refused(self):
        with self.assertRaises(TypeError):
            pickle.loads(_tampered())

    def test_what_was_damaged_is_refused(self):
        bounds = changeover.bounds(9, 4)
        rebuild, (kind, state, checksum) = bounds.__reduce_ex__(4)
        self.assertEqual(repr(rebuild(kind, state, checksum)), repr(bounds))
        for place in range(len(state)):
            wrong = state[:place] + bytes([state[place] ^ 1 << place % 8]) + state[place + 1:]
            with self.assertRaisesRegex(changeover.BadInput, "this pickle of a Bounds is damaged"):
                rebuild(kind, wrong, checksum)

    def test_what_another_version_pickled_is_read_or_refused(self):
        design = changeover.design(9, 4)
        for each in (
            design.verdict,
            changeover.bounds(9, 4),
            changeover.table(4, 9)[0],
            design.draw(),
        ):
            rebuild, (kind, state, _) = each.__reduce_ex__(4)
            facts, core = pickle.loads(state)

            def again(facts):
                text = pickle.dumps((facts, core), 4)
                return rebuild(kind, text, zlib.crc32(text))

            self.assertEqual(repr(again({**facts, "of_a_later_version": 1})), repr(each))
            names = [name for name in dir(kind) if type(getattr(kind, name)).__name__ == "_Fact"]
            self.assertGreater(len(names), 1)
            names += kind._hidden
            for name in names:
                with self.assertRaisesRegex(
                    changeover.BadInput,
                    f"another version of changeover pickled this .*, which has no {name}; create "
                    f"it again",
                ):
                    again({key: value for key, value in facts.items() if key != name})
            with self.assertRaisesRegex(
                changeover.BadInput, "another version of changeover pickled this .*; create it "
                                     "again"
            ):
                rebuild(kind, facts, core)  # As 0.1 did.

    def test_processes_exchange_them(self):
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            self.assertEqual([each.best_known for each in pool.map(minimum_of, [8, 9])],
                             [changeover.bounds(v, 4).best_known for v in (8, 9)])


def _tampered():
    from changeover import _made

    class Wrong:
        def __reduce__(self):
            return _made._made_again, (int, {}, None)

    return pickle.dumps(Wrong())


@contextlib.contextmanager
def modules(**named):
    before = {name: sys.modules.get(name) for name in named}
    sys.modules.update(named)
    try:
        yield
    finally:
        for name, module in before.items():
            sys.modules.pop(name)
            if module is not None:
                sys.modules[name] = module


def without_tqdm():
    return modules(**{"tqdm": None, "tqdm.auto": None})


@contextlib.contextmanager
def with_tqdm(faulty=""):
    """What the package uses of tqdm, and raises where it is told."""
    bars = []

    class Bar:
        def __init__(self, **named):
            bars.append(self)
            self.named, self.closed = named, False
            self.check("begin")

        def check(self, what):
            if what == faulty:
                raise RuntimeError("no widgets here")

        def set_description_str(self, words, refresh):
            self.words = words
            self.check("show")

        def close(self):
            self.closed = True
            self.check("close")

    auto = types.ModuleType("tqdm.auto")
    auto.tqdm = Bar
    with modules(**{"tqdm": types.ModuleType("tqdm"), "tqdm.auto": auto}):
        yield bars


class Progress(unittest.TestCase):
    def test_true_shows_a_line_and_takes_it_away(self):
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            found = changeover.search(40, 6, time=0.8, progress=True)
        self.assertIsNotNone(found.design)
        self.assertIn("best", said.getvalue())
        for nothing in (False, None):
            with contextlib.redirect_stderr(io.StringIO()) as said:
                changeover.search(9, 4, change=1, time=1, progress=nothing)
            self.assertEqual(said.getvalue(), "")

    def test_a_run_with_an_end_says_how_far_it_is(self):
        bar = _progress.Bar()
        with contextlib.redirect_stderr(io.StringIO()) as said, without_tqdm():
            bar({"phase": "computing", "steps": 7, "of": 28, "unit": "pairs", "elapsed": 3.2})
            bar.close()
        self.assertEqual(said.getvalue().split("\r")[1], "computing, 7 of 28 pairs, 3 s")

    def test_a_search_with_a_time_says_how_much_of_it_is_over(self):
        said = {"phase": "local search 1 of 2", "steps": 9, "unit": "moves", "elapsed": 3.2}
        bar = _progress.Bar()
        with contextlib.redirect_stderr(io.StringIO()) as line, without_tqdm():
            bar({**said, "left": 56.8})
            bar.close()
        self.assertEqual(line.getvalue().split("\r")[1], "local search 1 of 2, 3 of 60 s")
        bar = _progress.Bar()
        with contextlib.redirect_stderr(io.StringIO()) as line, without_tqdm():
            bar({**said, "left": None})
            bar.close()
        self.assertEqual(line.getvalue().split("\r")[1], "local search 1 of 2, 3 s")

    def test_what_cannot_be_shown_costs_no_result(self):
        class Full(io.StringIO):
            def write(self, _text):
                raise OSError(28, "No space left on device")

        closed = io.StringIO()
        closed.close()
        for stream in (None, closed, Full()):
            with contextlib.redirect_stderr(stream), without_tqdm():
                found = changeover.search(40, 6, time=0.6, progress=True)
            self.assertIsNotNone(found.design)
        for faulty in ("begin", "show", "close"):
            with with_tqdm(faulty) as bars, contextlib.redirect_stderr(io.StringIO()):
                self.assertIsNotNone(changeover.search(40, 6, time=0.6, progress=True).design)
            self.assertTrue(bars)

    def test_bars_of_tqdm(self):
        bar = _progress.Bar()
        with with_tqdm() as bars:
            self.assertEqual(bars, [], "a process that shows nothing has no bar")
            bar({"phase": "computing", "steps": 7, "of": 28, "unit": "pairs"})
            bar({"phase": "computing", "best": 3, "steps": 9, "of": 28, "unit": "pairs"})
            bar.close()
            (made,) = bars
            self.assertEqual((made.named["unit"], made.total, made.n, made.words, made.closed),
                             (" pairs", 28, 9, "computing, best 3", True))

    def test_what_is_no_function_is_refused(self):
        with self.assertRaisesRegex(
            TypeError, "progress is a function, True, False or None, not 3"
        ):
            changeover.search(9, 4, progress=3)


if __name__ == "__main__":
    unittest.main()
