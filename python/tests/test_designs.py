"""Designs: made, verified, read, written, compared, streamed."""

import copy
import itertools
import json
import pickle
import threading
import unittest

import changeover


def is_design(blocks, v, change, circular):
    """The definition, written down again."""
    blocks = [set(block) for block in blocks]
    pairs = {frozenset(pair) for block in blocks for pair in itertools.combinations(block, 2)}
    steps = list(zip(blocks, blocks[1:])) + ([(blocks[-1], blocks[0])] if circular else [])
    return len(pairs) == v * (v - 1) // 2 and all(
        len(b - a) == change == len(a - b) for a, b in steps
    )


class Designs(unittest.TestCase):
    def test_designs_are_designs(self):
        for change in (1, 2, 3):
            for k in range(2, 6):
                for v in range(k + change, 16):
                    for kind in ("linear", "circular"):
                        with self.subTest(v=v, k=k, change=change, kind=kind):
                            design = changeover.design(v, k, change, kind) if k >= change else None
                            if design is None:
                                continue
                            self.assertTrue(is_design(design.blocks, v, change, kind == "circular"))
                            self.assertTrue(design.verdict.valid)
                            self.assertEqual(design.b, len(design.blocks))
                            known = changeover.bounds(v, k, change, kind)
                            self.assertEqual(known.best_known, design.b)
                            self.assertLessEqual(known.lower_bound, design.b)

    def test_without_a_kind_the_shorter_one_comes(self):
        for v, k in ((11, 4), (20, 5), (9, 4)):
            best = min(
                (
                    d
                    for d in (changeover.design(v, k, kind=kind) for kind in ("circular", "linear"))
                    if d
                ),
                key=lambda d: d.b,
            )
            self.assertEqual(changeover.design(v, k).b, best.b)

    def test_what_cannot_be_is_said(self):
        self.assertIsNone(changeover.design(4, 2))
        self.assertEqual(changeover.bounds(4, 2).status, "impossible")
        self.assertEqual(changeover.bounds(26, 6, 1, "linear").reported, (63, "Bean2026"))
        self.assertIsNone(changeover.bounds(20, 5).reported)
        with self.assertRaisesRegex(changeover.ImpossibleParameters, "k = 4 exceeds v = 3"):
            changeover.design(3, 4)
        with self.assertRaisesRegex(changeover.BadInput, "'linear' or 'circular'"):
            changeover.design(9, 4, kind="round")
        with self.assertRaisesRegex(changeover.BadInput, "no construction is called"):
            changeover.design(9, 4, construction="magic")
        with self.assertRaises(TypeError):
            changeover.design("nine", 4)

    def test_a_mutated_design_is_refused(self):
        design = changeover.design(11, 4, kind="circular")
        blocks = design.blocks.tolist()
        self.assertTrue(changeover.verify(blocks, v=11, change=2, kind="circular"))
        for index in range(len(blocks)):
            with self.subTest(dropped=index):
                rest = blocks[:index] + blocks[index + 1 :]
                self.assertFalse(changeover.verify(rest, v=11, change=2, kind="circular").valid)
            with self.subTest(changed=index):
                other = [list(block) for block in blocks]
                other[index][0] = next(x for x in range(11) if x not in other[index])
                self.assertFalse(changeover.verify(other, v=11, change=2, kind="circular").valid)

    def test_blocks_come_in_any_shape(self):
        lists = [[0, 1, 2], [1, 2, 3], [2, 3, 0]]
        self.assertTrue(changeover.verify(lists).valid)
        self.assertTrue(changeover.verify(tuple(map(tuple, lists))).valid)
        self.assertTrue(changeover.verify(iter(lists), change=1).valid)
        named = changeover.Design([["a", "b", "c"], ["b", "c", "d"], ["c", "d", "a"]])
        self.assertEqual(named.labels, ["a", "b", "c", "d"])
        self.assertTrue(named.verdict.valid)
        with self.assertRaises(changeover.BadInput):
            changeover.verify([[0, 1, 2], [0, 1]])
        with self.assertRaises(changeover.BadInput):
            changeover.verify([[0, 1, 1], [0, 1, 2]])
        with self.assertRaises(changeover.BadInput):
            changeover.verify([[0, 1, 7]], v=5)
        with self.assertRaises(changeover.BadInput):
            changeover.verify([])
        with self.assertRaises(changeover.BadInput):
            changeover.verify([[0, -1]])
        for wrong in ([[0.5, 1]], 7, None, "0 1 2"):
            with self.assertRaises(TypeError):
                changeover.verify(wrong)

    def test_blocks_are_a_sequence(self):
        blocks = changeover.design(9, 4, 1, "linear").blocks
        rows = blocks.tolist()
        self.assertEqual(blocks.shape, (len(rows), 4))
        self.assertEqual([list(block) for block in blocks], rows)
        self.assertEqual(blocks[-1], tuple(rows[-1]))
        for cut in (slice(2, 5), slice(None, None, -1), slice(1, None, 3), slice(5, 2)):
            self.assertEqual(blocks[cut].tolist(), rows[cut])
        self.assertEqual(blocks[1:], blocks[1:])
        with self.assertRaises(IndexError):
            blocks[len(rows)]
        view = memoryview(blocks)
        self.assertTrue(view.readonly)
        self.assertEqual(view.tolist(), rows)

    def test_a_buffer_outlives_its_design(self):
        view = memoryview(changeover.design(31, 4, kind="circular").blocks)
        rows = view.tolist()
        changeover.design(61, 4)
        self.assertTrue(is_design(rows, 31, 2, True))

    def test_formats_are_read_again(self):
        def named(some):
            return [{(some.labels or range(some.v))[x] for x in block} for block in some.blocks]

        design = changeover.design(15, 4)
        for name in ("text", "json", "csv", "gap", "sage", "designtheory", "ljcr"):
            with self.subTest(format=name):
                again = changeover.loads(design.to_string(name))
                if name in ("text", "json", "csv"):
                    self.assertEqual(named(again), named(design))
                else:
                    self.assertEqual(list(map(set, again.blocks)), list(map(set, design.blocks)))
                self.assertEqual(again.to_string(name), design.to_string(name))
        self.assertEqual(json.loads(design.to_string("json"))["verdict"]["b"], design.b)
        with self.assertRaisesRegex(changeover.BadInput, "no format is called"):
            design.to_string("pdf")
        with self.assertRaisesRegex(changeover.BadInput, "<text>:2"):
            changeover.loads("0 1 2\n0 1\n")
        with self.assertRaises(changeover.MissingResource):
            changeover.read("/nowhere/mine.txt")

    def test_sameness(self):
        design = changeover.design(11, 4, kind="circular")
        shifted = [[(x * 7 + 3) % 11 for x in block] for block in design.blocks]
        shifted = shifted[4:] + shifted[:4]
        other = changeover.Design(shifted, v=11, change=2, kind="circular")
        self.assertTrue(design.is_same_as(other))
        self.assertEqual(design.canonical().blocks, other.canonical().blocks)
        self.assertEqual(design.group_order % 11, 0)
        self.assertFalse(design.is_same_as(changeover.design(13, 4, kind="circular")))

    def test_designs_are_values(self):
        design = changeover.design(20, 5)
        self.assertEqual(design, changeover.design(20, 5))
        self.assertNotEqual(design, changeover.design(21, 5))
        self.assertEqual(pickle.loads(pickle.dumps(design)), design)
        self.assertEqual(copy.deepcopy(design).verdict.b, design.b)

    def test_an_iterator_is_for_one_thread(self):
        stream = changeover.stream(1001, 4, batch=500)
        seen, faults = [], []

        def read():
            try:
                for batch in stream:
                    seen.append(len(batch))
            except ValueError as fault:
                faults.append(str(fault))

        threads = [threading.Thread(target=read) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(all("already executing" in fault for fault in faults), faults)
        self.assertEqual(sum(seen), stream.b if len(faults) < 4 else sum(seen))

    def test_expansion(self):
        larger = changeover.design(7, 3, kind="circular").expand()
        self.assertEqual((larger.v, larger.b), (15, 35))
        self.assertTrue(is_design(larger.blocks, 15, 2, True))
        overlapping = changeover.design(7, 4).expand()  # it has no expansion set
        self.assertTrue(
            is_design(overlapping.blocks, overlapping.v, 2, overlapping.kind == "circular")
        )

    def test_streams_are_the_same_designs(self):
        design = changeover.design(101, 4)
        for batch in (1, 7, 10**6):
            stream = changeover.stream(101, 4, batch=batch)
            rows = [row for part in stream for row in part.tolist()]
            self.assertEqual(rows, design.blocks.tolist())
            self.assertEqual(stream.b, design.b)
        self.assertIsNone(changeover.stream(4, 2))

    def test_explanations_end_in_leaves(self):
        def leaves(node):
            self.assertTrue(node["citation"])
            return sum(map(leaves, node["inputs"])) if node["inputs"] else 1

        self.assertGreaterEqual(leaves(changeover.explain(24, 4)), 1)
        names = {each["name"] for each in changeover.constructions()}
        self.assertIn(changeover.explain(61, 4)["construction"], names)

    def test_bounds_say_how_many_there_are(self):
        counted = changeover.bounds(9, 4, 1, "circular").classified
        all_ = changeover.classify(9, 4, 12, 1, "circular")
        self.assertEqual(
            (counted.b, counted.standard_forms, counted.classes, counted.tight,
             counted.group_orders),
            (12, all_.standard_forms, all_.classes, all_.tight, all_.group_orders))
        self.assertIsNone(changeover.bounds(40, 5).classified)

    def test_tables_agree_with_bounds(self):
        cells = changeover.table(range(3, 5), (5, 14), 1)
        self.assertEqual(len(cells), 2 * 2 * 10)
        for cell in cells:
            known = changeover.bounds(cell.v, cell.k, 1, cell.kind)
            self.assertEqual(
                (cell.b, cell.lower_bound, cell.status),
                (known.best_known, known.lower_bound, known.status),
            )
        for wrong in ((2, 1), (0, 5)):
            with self.assertRaises(changeover.BadInput):
                changeover.table(3, wrong)


class Numpy(unittest.TestCase):
    def setUp(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("numpy is not installed")
        self.np = numpy

    def test_arrays_share_the_memory(self):
        np = self.np
        design = changeover.design(61, 4)
        first, second = np.asarray(design.blocks), np.asarray(design.blocks)
        self.assertEqual(first.shape, (366, 4))
        self.assertTrue(np.shares_memory(first, second))
        with self.assertRaises(ValueError):
            first[0, 0] = 1
        self.assertTrue(np.shares_memory(np.asarray(design.blocks[3:7]), first))

    def test_arrays_of_any_type_are_verified(self):
        np = self.np
        array = np.asarray(changeover.design(61, 4).blocks)
        for kind in (np.uint8, np.int16, np.uint16, np.int32, np.int64, np.uint64):
            self.assertTrue(
                changeover.verify(
                    array.astype(kind)[:, ::-1], v=61, change=2, kind="circular"
                ).tight
            )
        self.assertTrue(
            changeover.verify(np.asfortranarray(array), v=61, change=2, kind="circular").tight
        )
        wrong = array.astype(np.int64)
        wrong[5, 2] = -1
        with self.assertRaisesRegex(changeover.BadInput, "block 6: an element is negative"):
            changeover.verify(wrong)
        wrong[5, 2] = wrong[5, 1]
        with self.assertRaisesRegex(changeover.BadInput, r"^block \d+:? [^:]*element"):
            changeover.verify(changeover.design(61, 4), v=5)
        said = []
        for blocks in (wrong, wrong.tolist()):
            with self.assertRaisesRegex(changeover.BadInput, "twice in block 6; remove") as told:
                changeover.verify(blocks, v=61)
            said.append(str(told.exception))
        self.assertEqual(*said)
        with self.assertRaises(TypeError):
            changeover.verify(array.astype(float))

    def test_pandas(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas is not installed")
        frame = changeover.to_pandas(changeover.table(3, (5, 9)))
        self.assertEqual(len(frame), 10)
        self.assertEqual(changeover.to_pandas(changeover.design(9, 4)).shape[1], 4)


if __name__ == "__main__":
    unittest.main()
