"""Calls that fit no function."""

import copy
import inspect
import os
import pickle
import pydoc
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import changeover
import changeover.cluster
from changeover.cluster import _engine


class Kinds(unittest.TestCase):
    def test_every_function_has_the_same_default(self):
        calls = [getattr(module, name)
                 for module in (changeover, changeover.catalog, changeover.cluster)
                 for name in module.__all__
                 if inspect.isfunction(getattr(module, name)) or name == "Design"]
        found = [inspect.signature(call).parameters["kind"] for call in calls
                 if "kind" in inspect.signature(call).parameters]
        self.assertGreater(len(found), 12)
        for each in found:
            self.assertIsNone(each.default)

    def test_what_is_looked_up_is_of_both_kinds(self):
        kinds = set()
        for v in range(6, 20):
            best, bounds = changeover.design(v, 4), changeover.bounds(v, 4)
            self.assertEqual((bounds.kind, bounds.best_known), (best.kind, best.b))
            self.assertEqual(bounds, changeover.bounds(v, 4, kind=best.kind))
            tree = changeover.explain(v, 4)
            self.assertEqual((tree["kind"], tree["b"]), (best.kind, best.b))
            self.assertEqual(next(changeover.stream(v, 4)), best.blocks)
            kinds.add(best.kind)
        self.assertEqual(kinds, {"linear", "circular"})
        self.assertEqual({cell.kind for cell in changeover.table(4, 9)}, {"linear", "circular"})
        both = changeover.catalog.cell(20, 5)
        self.assertEqual([entry.b for entry in both], sorted(entry.b for entry in both))
        of_each = [changeover.catalog.cell(20, 5, kind=kind) for kind in ("circular", "linear")]
        self.assertTrue(all(of_each))
        self.assertEqual({entry.label for entry in both},
                         {entry.label for each in of_each for entry in each})

    def test_what_is_searched_for_or_given_is_linear(self):
        self.assertEqual(changeover.search(9, 4, change=1, time=1).design.kind, "linear")
        self.assertEqual(changeover.classify(6, 3, 7, 1), changeover.classify(6, 3, 7, 1, "linear"))
        self.assertNotEqual(changeover.classify(6, 3, 7, 1).complete and
                            changeover.classify(6, 3, 7, 1).classes,
                            changeover.classify(6, 3, 7, 1, "circular").classes)
        blocks = [[0, 1, 2], [1, 2, 3], [2, 3, 0], [3, 0, 1]]
        self.assertEqual((changeover.Design(blocks).kind, changeover.verify(blocks).kind),
                         ("linear", "linear"))
        circular = changeover.Design(blocks, kind="circular")
        self.assertEqual((changeover.Design(circular).kind, changeover.verify(circular).kind),
                         ("circular", "circular"))
        self.assertEqual(changeover.verify(circular, kind="linear").kind, "linear")


class Calls(unittest.TestCase):
    """What does not fit is said in one line that names the argument."""

    def said(self, function, *args, **kwargs):
        with self.assertRaises(TypeError) as caught:
            function(*args, **kwargs)
        text = str(caught.exception)
        self.assertEqual(text.splitlines(), [text])
        self.assertIsNone(caught.exception.__context__)
        return text

    def test_a_table_with_an_index_of_several_levels_is_refused(self):
        class Index:
            name, levels = None, ((), ())

        class Table:
            columns, index = ["name", "cost"], Index()

            def itertuples(self, **_):
                return iter([("a", 1), ("b", 2)])

        with self.assertRaisesRegex(
            TypeError, "parts: an index of several levels; give reset_index"
        ):
            changeover.plan(Table(), 2, test_cost=1)

    def test_the_argument_is_named_and_what_it_may_be(self):
        design = changeover.design(6, 4)
        whole = "a whole number from 0 to 2**64 - 1"
        self.assertEqual(self.said(changeover.design, "a", 4), f"design(): v is {whole}, not 'a'")
        self.assertEqual(self.said(changeover.design, 6, -4), f"design(): k is {whole}, not -4")
        self.assertEqual(
            self.said(changeover.design, 6, 4, kind=3), "design(): kind is a string or None, not 3"
        )
        self.assertEqual(
            self.said(changeover.search, 9, 4, time="1"),
            "search(): time is a number or None, not '1'",
        )
        self.assertEqual(
            self.said(design.is_same_as, 4), "Design.is_same_as(): other is a Design, not 4"
        )
        self.assertEqual(self.said(changeover.catalog.find, 3), "find(): label is a string, not 3")
        self.assertEqual(
            self.said(changeover.all_pairs, "f", 1, 2, 3),
            "all_pairs(): compute is a function, not 3",
        )
        self.assertLess(len(self.said(changeover.bounds, "v" * 10_000, 4)), 120)

    def test_the_limit_of_threads_is_one_number(self):
        said = self.said(changeover.search, 9, 4, threads=-1)
        self.assertEqual(said, "search(): threads is a whole number from 1 on, not -1")
        with self.assertRaisesRegex(ValueError, "^threads is a number from 1 to 1024$"):
            changeover.search(9, 4, threads=1025)
        with self.assertRaisesRegex(changeover.BadInput, "^threads is a number from 1 to 1024$"):
            _engine.check_team(1025, None)
        _engine.check_team(1024, None)

    def test_a_call_that_is_none_has_the_names_of_the_arguments(self):
        names = "; its arguments are v, k, change, kind, strength, construction"
        self.assertEqual(
            self.said(changeover.design, 6), "design(): missing a required argument: 'k'" + names
        )
        self.assertEqual(
            self.said(changeover.design, 6, 4, 2, "linear", 2, "x"),
            "design(): too many positional arguments" + names,
        )
        self.assertEqual(
            self.said(changeover.design, 6, 4, kid=1),
            "design(): got an unexpected keyword argument 'kid'" + names,
        )
        self.assertIn("plan() needs parts or model", self.said(changeover.plan, at_once=3))
        self.assertEqual(self.said(changeover.constructions, 1),
                         "constructions(): too many positional arguments; its arguments are none")

    def test_names_of_files_end_where_they_end(self):
        """A zero byte would end them for whatever opens files."""
        design = changeover.design(6, 4)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "kept")
            with open(file, "w", encoding="utf-8") as kept:
                kept.write(design.to_string())
            for call in (
                lambda: design.draw().save(file + "\0.svg"),
                lambda: changeover.read(file + "\0"),
                lambda: changeover.all_pairs(file + "\0", 1, 2, max),
                lambda: changeover.all_pairs(file, 1, 2, max, journal=file + "\0"),
            ):
                with self.assertRaisesRegex(
                    changeover.BadInput, r"kept.*is not a file name; remove the zero byte$"
                ):
                    call()
            self.assertEqual(changeover.read(file), design)
            self.assertEqual(os.listdir(folder), ["kept"])

    def test_what_is_gone_through_must_be_iterable(self):
        costs = {"test_cost": 1, "change_cost": 1}
        for wrong in (
            {"pairs": 5},
            {"never": [5]},
            {"first": [True]},
            {"pairs": [1.5]},
            {"done": [None]},
            {"mounted": 7},
        ):
            argument = next(iter(wrong))
            self.assertTrue(
                self.said(changeover.plan, 6, 3, **wrong, **costs).startswith(
                    f"{argument} must be a list of "),
                wrong,
            )
        self.assertTrue(self.said(changeover.plan, object(), 3, **costs).startswith(
            "parts must be a list of "))

    def test_what_functions_return_is_not_made_by_hand(self):
        for each in (
            changeover.RunSheet,
            changeover.BenchSheets,
            changeover.LoadOrder,
            changeover.Verdict,
        ):
            self.assertIn("objects cannot be constructed", self.said(each))
            self.assertIn("objects cannot be constructed", self.said(each.__new__, each))

    def test_items_and_blocks_that_cannot_be(self):
        design = changeover.design(9, 3)
        for wrong, fault in (
            ("a", TypeError),
            (1.5, TypeError),
            (None, TypeError),
            (10**30, IndexError),
            (-(10**30), IndexError),
            (design.b, IndexError),
            (-design.b - 1, IndexError),
        ):
            with self.subTest(wrong=wrong), self.assertRaises(fault) as caught:
                design.blocks[wrong]
            self.assertNotIn("\n", str(caught.exception))
        self.assertEqual(design.blocks[-1], design.blocks[design.b - 1])
        self.assertEqual(design.blocks[1:3].tolist(), design.blocks.tolist()[1:3])
        for wrong in (
            [["\ud800", "a"], ["a", "b"]],
            ["abc", "abd"],
            [b"abc", b"abd"],
            {(1, 2, 3): 0},
            {(1, 2, 3)},
            [{1: 2, 3: 4}],
        ):
            with self.subTest(wrong=wrong), self.assertRaises((TypeError, ValueError)) as caught:
                changeover.Design(wrong)
            self.assertNotIn("\n", str(caught.exception))

    def test_objects_in_which_there_is_nothing_are_refused(self):
        looks = (
            repr, copy.copy, copy.deepcopy, memoryview, len, iter,
            lambda it: it == it,
            lambda it: it[0],
            lambda it: it.__reduce_ex__(1),
            lambda it: it.__reduce_ex__(2),
            pickle.dumps,
        )
        types = [
            each
            for module in (changeover, changeover._core, changeover.catalog)
            for each in vars(module).values()
            if isinstance(each, type)
            and each.__module__.startswith("changeover")
            and not issubclass(each, (BaseException, list, tuple, dict, str))
        ]  # an empty list is one, and so are an empty dict and text
        self.assertIn(changeover.Design, types)
        for each in set(types):
            try:
                nothing = each.__new__(each)
            except TypeError as fault:
                self.assertIn("objects cannot be constructed", str(fault))
                continue
            for name, what in vars(each).items():
                if isinstance(what, property) or type(what).__name__ == "pybind11_static_property":
                    with self.subTest(each=each, name=name), self.assertRaisesRegex(
                        TypeError, "this object is empty"
                    ):
                        getattr(nothing, name)
            for look in looks:
                try:
                    look(nothing)
                except TypeError as fault:
                    self.assertNotIn("\n", str(fault))

    def test_every_function_and_method_does(self):
        seen = 0
        for owner in (
            changeover, changeover.catalog, changeover.Design, changeover.Blocks,
            changeover.Verdict, changeover.RunSheet, changeover.LoadOrder,
        ):
            for name, each in vars(owner).items():
                if (
                    name[0] != "_"
                    and callable(each)
                    and not isinstance(each, type)
                    and hasattr(each, "__wrapped__")
                ):
                    self.said(each, *[object()] * 30)
                    self.assertIn(name, str(inspect.signature(each)) + each.__name__)
                    seen += 1
        self.assertGreater(seen, 20)

    def test_what_a_value_does_when_it_is_looked_at_is_not_heard(self):
        class Index:
            def __index__(self):
                raise OverflowError("of the value")

        class Attributes:
            def __getattr__(self, name):
                raise ValueError(name)

        class Lines:
            def __repr__(self):
                return "a\nb\u2028c"

        class Silent:
            def __repr__(self):
                raise ValueError("no")

        for value in (
            Index(),
            Attributes(),
            Lines(),
            Silent(),
            10**5000,
            [10**5000],
            -1,
            "\ud800",
            1j,
        ):
            with self.subTest(type=type(value)):
                self.assertIn("v is a whole number", self.said(changeover.design, value, 4))
                self.assertIn("label is a string", self.said(changeover.catalog.find, value))
                self.assertIn("time is a number", self.said(changeover.search, 9, 4, time=value)
                              if value != -1 else "time is a number")
                self.assertIn("self is a Design", self.said(changeover.Design.expand, value))
                self.assertTrue(self.said(changeover.table, value, 4).startswith("table(): "))
        self.assertIn(
            "v is a whole number from 0 to 2**64 - 1, not a b c",
            self.said(changeover.design, Lines(), 4),
        )

    def test_what_fits_is_not_blamed(self):
        design = changeover.design(6, 4)
        for six in (6, Fraction(6), Decimal(6)):
            self.assertIn("design(): k is ", self.said(changeover.design, six, "4"))
        self.assertIn("compute is ", self.said(changeover.all_pairs, b"items", 1, 2, 3))
        self.assertIn(
            "users_only is ", self.said(changeover.catalog.entries, best_only=1, users_only="x")
        )
        self.assertTrue(design.is_same_as(design, 1))

    def test_no_part_of_a_number_is_dropped(self):
        for given in (Fraction(13, 2), Decimal("6.000001"), Decimal("nan"), 6.0, True):
            self.assertIn(
                "v is a whole number from 0 to 2**64 - 1, not ",
                self.said(changeover.design, given, 4),
            )

    def test_what_is_inside_of_an_argument_is_refused_in_one_line(self):
        def jobs(**more):
            return lambda: changeover.all_pairs("no such file", 4, 2, lambda *_: None, **more)

        def costs(pair_cost):
            return lambda: changeover.load_order(
                6, 3, workers=2, new_pairs=True, pair_cost=pair_cost
            )

        share = r"^share is \(part, parts\), two numbers"
        cost = r"^pair_cost: row 0 is not \(item, item, cost\); correct it$"
        ends = r"^table\(\): k is a whole number, a range or a pair \(first, last\), not "
        for call, words in (
            *(
                (jobs(share=wrong), share)
                for wrong in (
                    5,
                    (0,),
                    (0, 1, 2),
                    (0.0, 1),
                    (1, 1),
                    (-1, 2),
                    ("0", "1"),
                    (0, 2**64),
                )
            ),
            (jobs(earlier=[1]), "^earlier has paths of journals, not 1$"),
            (jobs(earlier=["a\0b"]),
             r"^earlier: 'a\\x00b' is not a file name; remove the zero byte$"),
            *(
                (costs(wrong), cost)
                for wrong in ({(0, 1): "x"}, {(0, 1): None}, {(0,): 1}, [(0, 1, 2, 3)])
            ),
            (costs({0: 1}), "^pair_cost must be a list of pairs of items, not '0'$"),
            (costs([(0, 1.5, 1)]), "^pair_cost: items are whole numbers, not 1.5$"),
            (
                lambda: changeover.load_order(5, 3, pairs=[(0, "x")]),
                "^pairs: items are whole numbers, not 'x'$",
            ),
            (
                lambda: changeover.load_order(None, sizes={"a": 1}, memory=5),
                "^sizes: items are whole numbers, not 'a'$",
            ),
            (
                lambda: changeover.load_order(None, sizes=[1, 1.5], memory=5),
                "^sizes: 1.5 is not a whole number of bytes$",
            ),
            (
                lambda: changeover.load_order(None, sizes=[1, "2 boxes"], memory=5),
                "'2 boxes' is not a size",
            ),
            *(
                (lambda wrong=wrong: changeover.table(wrong, 8), ends)
                for wrong in ((3, 4, 5), (3,), (3.0, 4), [3, 4], "3", -1, (1, 2**64), None)
            ),
            *(
                (
                    lambda wrong=wrong: changeover.Design([[0, 1], [2, wrong]]),
                    "^block 2: elements are whole numbers or strings, not ",
                )
                for wrong in (1.5, None, [1])
            ),
        ):
            with self.subTest(words=words), self.assertRaisesRegex(
                (TypeError, changeover.BadInput), words
            ) as caught:
                call()
            self.assertNotIn("\n", str(caught.exception))
        self.assertEqual(len(changeover.table((4, 4), range(6, 8), 2, "linear")), 2)

    def test_a_state_that_is_none_is_refused_in_one_line(self):
        for state in ({}, None, b"x", [1]):
            self.assertIn(
                "__setstate__(): ",
                self.said(changeover.Design.__new__(changeover.Design).__setstate__, state),
            )

    def test_help_says_each_signature_once_with_its_types(self):
        for owner in (
            changeover, changeover.catalog, changeover.Design, changeover.RunSheet,
            changeover.BenchSheets,
        ):
            for name, each in vars(owner).items():
                if name[0] != "_" and callable(each) and hasattr(each, "__wrapped__"):
                    signature = inspect.signature(each)
                    said = pydoc.render_doc(each, renderer=pydoc.plaintext)
                    self.assertEqual(
                        said.count(f"{name}("), 1 + (each.__doc__ or "").count(f"{name}("), name
                    )
                    self.assertIsNot(signature.return_annotation, signature.empty, name)
                    for argument in signature.parameters.values():
                        self.assertTrue(
                            argument.name == "self" or argument.annotation is not argument.empty,
                            name,
                        )
        self.assertEqual(str(inspect.signature(changeover.Design))[:8], "(blocks:")

    def test_what_is_changed_of_an_answer_changes_nothing(self):
        sheet = changeover.plan(4, 3, test_cost=1, change_cost=1, steps=10)
        steps = sheet.steps
        sheet.steps[0]["setup"].append("x")
        self.assertEqual(sheet.steps, steps)
        with self.assertRaises(AttributeError):
            sheet.tests = 3
        with self.assertRaises(AttributeError):
            sheet.more = 3

    def test_functions_can_be_sent_to_other_processes(self):
        for function in (
            changeover.design,
            changeover.verify,
            changeover.catalog.find,
            changeover.Design.expand,
        ):
            self.assertIs(pickle.loads(pickle.dumps(function)), function)

    def test_faults_of_a_callback_are_its_own(self):
        def compute(*_):
            raise TypeError("two\nlines")

        def similar(*_):
            raise TypeError("all_pairs(): incompatible function arguments")

        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "items")
            with open(path, "wb") as out:
                out.write(bytes(64))
            with self.assertRaisesRegex(TypeError, "^two\nlines$"):
                changeover.all_pairs(path, 8, 4, compute)
            with self.assertRaisesRegex(TypeError, "incompatible function arguments$"):
                changeover.all_pairs(path, 8, 4, similar)


if __name__ == "__main__":
    unittest.main()
