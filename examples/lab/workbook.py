#!/usr/bin/python3
"""Workbooks (.xlsx) out of tables, and results filled in, with nothing but Python.

usage: workbook.py make OUT.xlsx SHEET=TABLE.csv...
       workbook.py fill RUN.xlsx OUT.xlsx STEP=RESULT...
       workbook.py play RUN.xlsx OUT.xlsx TESTS [FAULT]...
       workbook.py show BOOK.xlsx SHEET

`make` writes a workbook as a spreadsheet program would: a sheet for each CSV file. `fill` does what
a person does at the bench: it writes a result into the column `result` of the sheet `Run sheet`, or
of another one, `RUN.xlsx:North`, in the row of that step. `play` is a bench: the first TESTS of the
sheet are run, and those fail that have all parts of a FAULT, "CD8" or "X710,CD8". `show` prints a
sheet as CSV. The same input makes the same bytes.
"""

import csv
import re
import sys
import xml.etree.ElementTree as ET
import zipfile
from xml.sax.saxutils import escape, quoteattr

MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
KIND = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
PACKAGE = "http://schemas.openxmlformats.org/package/2006"


def pack(path, members):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in members:
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), text)


def letter(column):
    """"A" for 0, "AB" for 27."""
    name = ""
    column += 1
    while column:
        column, rest = divmod(column - 1, 26)
        name = chr(ord("A") + rest) + name
    return name


def cell(row, column, text):
    place = f"{letter(column)}{row}"
    if re.fullmatch(r"\d+(\.\d+)?", text):
        return f'<c r="{place}"><v>{text}</v></c>'
    return f'<c r="{place}" t="inlineStr"><is><t xml:space="preserve">{escape(text)}</t></is></c>'


def sheet_of(table):
    rows = []
    for number, fields in enumerate(table, 1):
        cells = "".join(cell(number, column, text) for column, text in enumerate(fields) if text)
        rows.append(f'<row r="{number}">{cells}</row>' if cells else "")
    return f'<worksheet xmlns="{MAIN}"><sheetData>{"".join(rows)}</sheetData></worksheet>'


def make(path, sheets):
    """sheets: pairs of a name and its rows."""
    head = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'
    numbered = list(enumerate(sheets, 1))
    types = "".join(
        f'<Override PartName="/xl/worksheets/sheet{n}.xml" ContentType='
        '"application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml"/>'
        for n, _ in numbered
    )
    book = "".join(
        f'<sheet name={quoteattr(name)} sheetId="{n}" r:id="rId{n}"/>' for n, (name, _) in numbered
    )
    relations = "".join(
        f'<Relationship Id="rId{n}" Type="{KIND}/worksheet" Target="worksheets/sheet{n}.xml"/>'
        for n, _ in numbered
    )
    pack(
        path,
        [
            (
                "[Content_Types].xml",
                f'{head}<Types xmlns="{PACKAGE}/content-types">'
                '<Default Extension="rels" ContentType='
                '"application/vnd.openxmlformats-package.relationships+xml"/>'
                '<Default Extension="xml" ContentType="application/xml"/>'
                '<Override PartName="/xl/workbook.xml" ContentType='
                '"application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"/>'
                f"{types}</Types>",
            ),
            (
                "_rels/.rels",
                f'{head}<Relationships xmlns="{PACKAGE}/relationships"><Relationship Id="rId1" '
                f'Type="{KIND}/officeDocument" Target="xl/workbook.xml"/></Relationships>',
            ),
            (
                "xl/workbook.xml",
                f'{head}<workbook xmlns="{MAIN}" xmlns:r="{KIND}"><sheets>{book}</sheets>'
                "</workbook>",
            ),
            (
                "xl/_rels/workbook.xml.rels",
                f'{head}<Relationships xmlns="{PACKAGE}/relationships">{relations}</Relationships>',
            ),
            *((f"xl/worksheets/sheet{n}.xml", head + sheet_of(rows)) for n, (_, rows) in numbered),
        ],
    )


class Sheet:
    """A sheet of a workbook that changeover wrote."""

    def __init__(self, source, name):
        with zipfile.ZipFile(source) as archive:
            self.members = {member: archive.read(member) for member in archive.namelist()}
        book = ET.fromstring(self.members["xl/workbook.xml"])
        relations = ET.fromstring(self.members["xl/_rels/workbook.xml.rels"])
        targets = {each.get("Id"): each.get("Target") for each in relations}
        found = [
            targets[each.get(f"{{{KIND}}}id")]
            for each in book.iter(f"{{{MAIN}}}sheet")
            if each.get("name") == name
        ]
        if not found:
            sys.exit(f"{source} has no sheet {name}")
        self.member = "xl/" + found[0]
        self.texts = ["".join(text.text or "" for text in each.iter(f"{{{MAIN}}}t"))
                      for each in ET.fromstring(self.members["xl/sharedStrings.xml"])]
        ET.register_namespace("", MAIN)
        ET.register_namespace("r", KIND)
        self.sheet = ET.fromstring(self.members[self.member])
        self.rows = list(self.sheet.iter(f"{{{MAIN}}}row"))
        self.heads = {
            self.said(each): re.match("[A-Z]+", each.get("r")).group() for each in self.rows[0]
        }

    def said(self, each):
        if each.get("t") == "inlineStr":
            return "".join(text.text or "" for text in each.iter(f"{{{MAIN}}}t"))
        value = each.find(f"{{{MAIN}}}v")
        return (
            ""
            if value is None
            else self.texts[int(value.text)]
            if each.get("t") == "s"
            else value.text
        )

    def table(self):
        """A dict for each row below the head."""
        table = []
        for row in self.rows[1:]:
            cells = {re.match("[A-Z]+", each.get("r")).group(): self.said(each) for each in row}
            table.append({head: cells.get(column, "") for head, column in self.heads.items()})
        return table


def fill(book, path, results, name="Run sheet"):
    """results: what is written in the column `result`, by step; or a function that says it of
    Sheet.table(). `name` is the sheet, that of a bench if there are several."""
    source, _, named = book.partition(".xlsx:")
    source, name = (source + ".xlsx", named) if named else (book, name)
    run = Sheet(source, name)
    left = dict(results(run.table()) if callable(results) else results)
    for row, said in zip(run.rows[1:], run.table()):
        result = left.pop(said["step"], None)
        if result is not None:
            place = run.heads["result"] + row.get("r")
            filled = ET.fromstring(
                f'<c xmlns="{MAIN}" r="{place}" t="inlineStr"><is><t>{escape(result)}</t></is></c>'
            )
            before = [
                each for each in row if (len(each.get("r")), each.get("r")) < (len(place), place)
            ]
            row.insert(len(before), filled)
    if left:
        sys.exit(f"{source} has no step {', '.join(left)}")
    run.members[run.member] = ET.tostring(run.sheet, encoding="UTF-8", xml_declaration=True)
    pack(path, run.members.items())


def play(tests, faults):
    """The results of the first tests of a sheet, for fill()."""
    def results(rows):
        for row in rows[:tests]:
            mounted = {part for head, part in row.items() if head.startswith("slot_")}
            yield row["step"], "FAILED - hang" if any(
                fault <= mounted for fault in faults
            ) else "pass"

    return results


def main():
    words = sys.argv[1:]
    if len(words) >= 3 and words[0] == "make":
        sheets = []
        for word in words[2:]:
            name, _, table = word.partition("=")
            with open(table, encoding="utf-8", newline="") as file:
                sheets.append((name, list(csv.reader(file))))
        make(words[1], sheets)
    elif len(words) >= 3 and words[0] == "fill":
        fill(words[1], words[2], [tuple(word.split("=", 1)) for word in words[3:]])
    elif len(words) >= 4 and words[0] == "play":
        fill(words[1], words[2], play(int(words[3]), [set(word.split(",")) for word in words[4:]]))
    elif len(words) == 3 and words[0] == "show":
        sheet = Sheet(words[1], words[2])
        lines = csv.DictWriter(sys.stdout, list(sheet.heads), lineterminator="\n")
        lines.writeheader()
        lines.writerows(sheet.table())
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
