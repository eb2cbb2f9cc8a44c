"""The table of components in docs/packages.md names what cmake/rooms.cmake lets each one link."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# What the page calls a library; it says elsewhere that all need fmt. Headers are compiled in.
CALLED = {
    "Threads": ["threads"], "Bliss": ["bliss", "GMP"], "EXPAT": ["expat"], "LibZip": ["libzip"],
    "XlsxWriter": ["libxlsxwriter"], "SQLite": ["SQLite"], "CaDiCaL": ["CaDiCaL"], "fmt": [],
    "nlohmann_json": [],
}


def linked(cmake):
    """The libraries of each module, with those of the modules below it."""
    own = {name: [] for name in re.search(r"CHANGEOVER_ROOMS (.*?)\)", cmake, re.S)[1].split()}
    for name, libraries in re.findall(r"CHANGEOVER_LIBRARIES_(\w+) ([^)]*)\)", cmake):
        own[name] += re.findall(r"(\w+)::", libraries)
    below = dict(re.findall(r"set\(CHANGEOVER_KNOWS_(\w+) ?([^)]*)\)", cmake))

    def libraries(name):
        here = {word for library in own[name] for word in CALLED[library]}
        return here.union(*(libraries(module) for module in below[name].split()))
    return {name: libraries(name) for name in own}


def told(page):
    """What the rows of the table say, "as OTHER" put in full."""
    rows = {}
    for name, text in re.findall(r"^\| `(\w+)` \| [^|]* \| ?([^|]*?) ?\|$", page, re.M):
        rows[name] = set()
        text = text.removeprefix("as ")
        for word in re.split(r", | and ", text) if text else []:
            rows[name] |= rows.get(word, {word})
    return rows


def faults(page, cmake):
    rows = told(page)
    return [
        f"{name}: the page says {sorted(rows.get(name, set()))}, it links {sorted(libraries)}"
        for name, libraries in linked(cmake).items()
        if name != "paper" and rows.get(name) != libraries
    ]


class Components(unittest.TestCase):
    def setUp(self):
        self.page = (ROOT / "docs" / "packages.md").read_text(encoding="utf-8")
        self.cmake = (ROOT / "cmake" / "rooms.cmake").read_text(encoding="utf-8")

    def test_the_table_says_what_is_linked(self):
        self.assertEqual(faults(self.page, self.cmake), [])

    def test_a_wrong_row_is_found(self):
        without = self.page.replace("libzip, libxlsxwriter |", "libzip |", 1)
        self.assertNotEqual(without, self.page)
        self.assertIn("io: ", faults(without, self.cmake)[0])
        renamed = self.page.replace("| `plan` |", "| `plans` |", 1)
        self.assertEqual(len(faults(renamed, self.cmake)), 1)


if __name__ == "__main__":
    unittest.main()
