"""Each entry of docs/references.bib has its DOI and its pages, or a line that says why not."""

import csv
import pathlib
import re
import unittest

HERE = pathlib.Path(__file__).resolve().parent
BIBLIOGRAPHY = HERE.parent.parent / "docs" / "references.bib"
# Why a DOI or pages are left out. "arXiv": its number there leads to the work. "Not confirmed":
# there may be one, but no source that we could read says it. "Not seen": we know the work only by
# what others say of it.
REASONS = {
    "arXiv", "thesis", "report", "proceedings of 1964", "conference without DOIs",
    "numbered article", "not confirmed", "not seen",
}
WITH_PAGES = {"article", "inproceedings", "incollection"}


def entries(text):
    """Kind, key and fields of each entry."""
    for kind, key, body in re.findall(r"^@(\w+)\{([^,]+),\n(.*?)^\}", text, re.M | re.S):
        yield kind, key, dict(re.findall(r"^  (\w+)\s*=\s*(\{.*?\}|\w+),?$", body, re.M | re.S))


def lacking(text):
    """Pairs of a key and what its entry lacks."""
    for kind, key, fields in entries(text):
        if "doi" not in fields:
            yield key, "doi"
        if kind in WITH_PAGES and "pages" not in fields:
            yield key, "pages"


def faults(text, rows):
    """What the table of reasons does not say of these entries, or says in vain; a line each."""
    told = {(row["key"], row["lacks"]): row["why"] for row in rows}
    lacks = set(lacking(text))
    arxiv = {key for _, key, fields in entries(text) if "eprint" in fields}
    found = [f"{key} lacks {what}, and nothing says why" for key, what in lacks - told.keys()]
    found += [f"{key} has {what}, or is no entry" for key, what in told.keys() - lacks]
    found += [f"{key}: no such reason: {why}" for (key, _), why in told.items()
              if why not in REASONS]
    found += [f"{key} has no number of arXiv" for (key, _), why in told.items()
              if why == "arXiv" and key not in arxiv]
    for _, key, fields in entries(text):
        if not re.fullmatch(r"\{10\.\d{4,}/\S+\}", fields.get("doi", "{10.0000/x}")):
            found.append(f"{key}: no DOI: {fields['doi']}")
        if not re.fullmatch(r"\{\d+(:\d+)?--\d+(:\d+)?\}", fields.get("pages", "{1--2}")):
            found.append(f"{key}: no pages: {fields['pages']}")
    return sorted(found)


class References(unittest.TestCase):
    def setUp(self):
        self.text = BIBLIOGRAPHY.read_text(encoding="utf-8")
        with (HERE / "references_without.csv").open(encoding="utf-8", newline="") as file:
            self.rows = list(csv.DictReader(file))

    def test_what_an_entry_lacks_has_a_reason(self):
        self.assertEqual(faults(self.text, self.rows), [])

    def test_every_entry_is_read(self):
        self.assertEqual(len(list(entries(self.text))), self.text.count("\n@"))

    def test_the_table_is_in_order_and_says_each_thing_once(self):
        keys = [(row["key"].lower(), row["lacks"]) for row in self.rows]
        self.assertEqual(keys, sorted(set(keys)))

    def test_faults_are_found(self):
        text = ("@article{Known,\n  doi = {10.1007/X},\n  pages = {1--9}\n}\n"
                "@article{Open,\n  title = {T}\n}\n@misc{Bad,\n  doi = {doi:7}\n}\n")
        rows = [
            {"key": "Known", "lacks": "doi", "why": "thesis"},
            {"key": "Open", "lacks": "doi", "why": "arXiv"},
        ]
        self.assertEqual(faults(text, rows), [
            "Bad: no DOI: {doi:7}",
            "Known has doi, or is no entry",
            "Open has no number of arXiv",
            "Open lacks pages, and nothing says why",
        ])


if __name__ == "__main__":
    unittest.main()
