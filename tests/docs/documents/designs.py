"""Designs and dossiers: the same document at each door."""

import hashlib
import json
import pathlib
import random
import re
import subprocess
import tempfile

from doors import build, changeover, fault, fits, program, root, run


def check_designs(server, count):
    """The same document at each door; read again, it is the same design; damaged, it is refused or
    judged again."""
    rng = random.Random(3)
    keys = set()
    cells = [
        (
            rng.randint(3, 40),
            rng.randint(2, 7),
            rng.randint(1, 3),
            rng.choice(["linear", "circular"]),
            rng.choice([2, 2, 2, 3]),
        )
        for _ in range(count)
    ]
    for v, k, change, kind, strength in [
        *cells,
        (9, 5, 1, "circular", 3),
        (16, 5, 1, "linear", 2),
        (83, 4, 2, "circular", 2),
    ]:
        by_line = run(
            "design", str(v), str(k), "--change", str(change), f"--{kind}", "--strength",
            str(strength), "--format", "json",
        )
        cell = {"v": v, "k": k, "change": change, "kind": kind, "strength": strength}
        if by_line.returncode != 0:
            continue
        answer = json.loads(by_line.stdout)
        keys |= answer.keys()
        problem = fits("changeover-design-1", answer)
        if problem:
            fault(f"a design is against its schema ({problem}): {cell}")
        query = f"v={v}&k={k}&change={change}&kind={kind}&strength={strength}"
        if server.text(f"{server.address}api/download?{query}&format=json") != by_line.stdout:
            fault(f"the server answers another design: {cell}")
        shown = server.get(f"api/design?{query}")
        if fits("changeover-design-1", shown) or shown.pop("label", "") == "" or shown != answer:
            fault(f"the page's design is another document: {cell}")
        by_python = changeover.design(v, k, change=change, kind=kind, strength=strength)
        if by_python.to_json() != by_line.stdout:
            fault(f"Python answers another design: {cell}")
        if changeover.loads(by_python.to_json()) != by_python:
            fault(f"Python reads another design than it wrote: {cell}")
        again = run("verify", "-", "--json", stdin=by_line.stdout)
        if again.returncode != 0 or json.loads(again.stdout)["verdict"] != answer["verdict"]:
            fault(f"read again, it is judged otherwise: {cell} {again.stderr}")
        answer["blocks"].pop()
        damaged = run("verify", "-", "--json", stdin=json.dumps(answer))
        if damaged.returncode == 0 and answer["verdict"]["minimum"] == "proved":
            fault(f"one block fewer than the minimum is taken for a design: {cell}")
    known = json.loads((root / "docs/schema/changeover-design-1.json").read_text())
    missing = {*known["properties"]} - keys - {"label", "labels"}
    if missing:
        fault(f"no design was asked for that has {missing}")
    problem = fits(
        "changeover-design-1", json.loads(changeover.loads("a b c\na b d\nd b c\n").to_json())
    )
    if problem:
        fault(f"a design with names is against its schema: {problem}")


def without_links(page):
    """A dossier as HTML without links to theorems, which only the server's pages have."""
    page = re.sub(r'<a href="\.\./#/theorems[^"]*">([^<]*)</a>', r"\1", page)
    return re.sub(r"docs/theorems\.md, (Theorem \d+)|(?<=stays of )(Theorem \d+)(?! of)",
                  lambda found: f"{found[1] or found[2]} of Changeover", page)


def check_dossiers(server):
    """A dossier is what its schema says, and what it tells to run does what it says."""
    cells = [
        ("8", "5", "--circular"),
        ("9", "5", "--linear"),
        ("253", "13"),
        ("26.4.2.circular.65",),
        ("26", "6", "--change", "1", "--linear"),
    ]
    seen = set()
    for cell in cells:
        answer = json.loads(run("dossier", *cell, "--json").stdout)
        problem = fits("changeover-dossier-1", answer)
        if problem:
            fault(f"a dossier is against its schema ({problem}): {cell}")
        query = f"v={answer['v']}&k={answer['k']}&change={answer['change']}&kind={answer['kind']}"
        for format in ("json", "latex", "markdown", "html"):
            texts = (
                server.text(f"{server.address}api/dossier?{query}&format={format}"),
                run("dossier", *cell, "--format", format).stdout,
            )
            if format == "html":
                # The way back to the cell is the server's alone.
                back = r"<p><a [^>]*>What else is known of these parameters</a></p>\n"
                texts = (without_links(re.sub(back, "", texts[0])), without_links(texts[1]))
            if texts[0] != texts[1]:
                fault(f"the server writes another dossier: {cell} {format}")
        seen |= {key for key in ("label", "reported", "blocks") if answer[key] is not None}
        seen.add(f"{len(answer['check'])} commands")
        with tempfile.TemporaryDirectory() as folder:
            write, check = (words.split() for words in answer["check"][:2])
            subprocess.run([program, *write[1:]], cwd=folder, check=True)
            said = subprocess.run(
                [str(build / "checkdesign"), *check[1:]], cwd=folder, capture_output=True, text=True
            ).stdout.split()
            lines = [
                line
                for line in (pathlib.Path(folder) / "design.txt").read_text().splitlines(True)
                if not line.startswith("#")
            ]
        if said[0] != "valid" or said[said.index("blocks") + 1] != str(answer["b"]):
            fault(f"checkdesign says otherwise: {cell}: {said}")
        if hashlib.sha256("".join(lines).encode()).hexdigest() != answer["hash"]:
            fault(f"the blocks have another checksum: {cell}")
        if answer["blocks"] and "".join(
            " ".join(map(str, block)) + "\n" for block in answer["blocks"]
        ) != "".join(lines):
            fault(f"a dossier lists other blocks: {cell}")
    if missing := {"label", "reported", "blocks", "2 commands", "4 commands"} - seen:
        fault(f"no dossier was asked for that has {missing}")
