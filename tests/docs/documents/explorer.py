"""Every answer of the server, and the static export, are what docs/schema/explorer-1.json says."""

import gzip
import hashlib
import json
import pathlib
import re
import time
import xml.etree.ElementTree

from doors import fault, fits, root, run


def keys_of(said, inside, schemas, found):
    """Takes out of `found` the optional keys that this answer has: what is left of the schemas was
    never said."""
    name, at = inside
    while "$ref" in at:
        file, _, path = at["$ref"].partition("#")
        if file.startswith("changeover-"):
            return  # a document that is looked at elsewhere
        name, at = file or name, schemas[file or name]
        for key in filter(None, path.split("/")):
            at = at[key]
    for one in at.get("anyOf", []) if said is not None else []:
        keys_of(said, (name, one), schemas, found)
    if isinstance(said, list) and "items" in at:
        for each in said:
            keys_of(each, (name, at["items"]), schemas, found)
    if isinstance(said, dict) and "properties" in at:
        optional = at["properties"].keys() - set(at.get("required", []))
        missing = found.setdefault(id(at), set(optional))
        missing.difference_update(said)
        for key in said.keys() & at["properties"].keys():
            keys_of(said[key], (name, at["properties"][key]), schemas, found)


def unpack(shelf):
    """The designs of a file of `serve --export`, as packed_designs.hpp says they are written."""
    index, _, rest = shelf.partition(b"\n")
    for design in json.loads(index):
        at, way = design.pop("at"), design.pop("way")
        v, k, m = design["v"], design["k"], design["change"]
        wide = 2 if v > 256 else 1
        steps = design["verdict"]["b"] - 1

        def numbers(count):
            nonlocal at
            found = [
                int.from_bytes(rest[at + i * wide : at + (i + 1) * wide], "little")
                for i in range(count)
            ]
            at += count * wide
            return found

        if way == "blocks":
            design["blocks"], last = [], [0] * k
            for _ in range(steps + 1):
                last = [(x + d) % v for x, d in zip(last, numbers(k))]
                design["blocks"].append(last)
        else:
            memory = numbers(k)
            columns = [(numbers(steps), numbers(steps)) for _ in range(m)]
            blocks, before = [sorted(memory)], [0] * m
            for i in range(steps):
                for j, (places, elements) in enumerate(columns):
                    before[j] = (before[j] + elements[i]) % v
                    memory[places[i]] = before[j]
                blocks.append(sorted(memory))
            design["blocks"] = blocks
        yield design


def check_explorer(server):
    """What the explorer's pages are answered, and the files of `serve --export`, at each address of
    the schema."""
    schemas = {
        file.name: json.loads(file.read_text()) for file in (root / "docs/schema").glob("*.json")
    }
    said = schemas["explorer-1.json"]["properties"]
    tried, found = set(), {}

    def look(method, address, answer, where=""):
        tried.add((method, address))
        problem = fits(
            "explorer-1", answer, f"properties/{method}/properties/{address.replace('/', '~1')}"
        )
        if problem:
            fault(
                f"{where or method} api/{address}: against its schema ({problem.message}) "
                f"at {list(problem.absolute_path)}"
            )
        keys_of(answer, ("explorer-1.json", said[method]["properties"][address]), schemas, found)
        return answer

    def get(address, query=""):
        return look(
            "get", address, server.get(f"api/{address.partition('?')[0]}{query}"), "get" + query
        )

    def post(address, body="", query="", kind="application/json"):
        if not isinstance(body, str):
            problem = fits(
                "explorer-1", body, f"properties/body/properties/{address.replace('/', '~1')}"
            )
            if problem:
                fault(f"what is sent to api/{address} is against its schema ({problem.message})")
            tried.add(("body", address))
            body = json.dumps(body)
        return look(
            "post", address, server.post(f"api/{address}{query}", body, kind), f"post {query}"
        )

    for address in ("about", "completeness", "constructions", "theorems"):
        get(address)
    get("table", "?k=3..6&v=4..20")
    for query in (
        "?k=3..5&v=4..20&kind=linear",
        "?k=3..5&v=4..20&kind=circular&change=1",
        "?k=4..5&v=5..9&kind=linear&strength=3",
    ):
        get("atlas", query)
        get("groups", query)
    cells = (
        "v=9&k=4&change=2&kind=linear", "v=4&k=3&change=2&kind=circular",
        "v=40&k=6&change=1&kind=linear", "v=7&k=4&change=3&kind=circular&strength=3",
        "v=9&k=4&change=2&kind=linear&strength=3", "v=7&k=3&change=2&kind=linear",
        "v=9&k=4&change=1&kind=circular", "v=100&k=30&change=7&kind=circular",
    )
    for cell in cells:
        for address in ("cell", "bounds"):
            get(address, "?" + cell)
    for cell in cells[0], cells[2], cells[3], cells[5]:
        for address in ("explain", "design"):
            get(address, "?" + cell)
    good, bad = "1 2 3\n2 3 4\n3 4 1\n", "1 2 3 4\n2 3 7 5\n"
    for text in (good, bad):
        for query in ("", "?strength=3"):
            by_server = post("verify", text, query, "text/plain")
            strength = ["--strength", "3"] if query else []
            by_line = json.loads(run("verify", "-", *strength, "--json", stdin=text).stdout)
            problem = fits("verify-1", by_line)
            if problem or any(by_server[key] != by_line[key] for key in by_line):
                fault(f"verify --json: {problem} {by_line} {by_server}")
    post(
        "repair",
        "1 3 7 8\n2 5 7 8\n0 2 3 8\n2 3 4 5\n1 2 3 6\n0 1 4 7\n0 1 5 6\n4 6 7 8\n",
        "?change=2&kind=circular",
        "text/plain",
    )
    costs = {"test_cost": 1, "change_cost": 1}
    four = {"parts": ["A", "B", "C", "D"], "at_once": 2, **costs}
    for more in ({}, {"done": [["A", "B"]]}, {"benches": 2}, {"what_if": True}):
        post("plan", {**four, "steps": 100, **more})
    post(
        "plan",
        {
            **costs,
            "parts": ["A", "B", "C"],
            "at_once": 2,
            "diagnose": True,
            "done": [{"parts": ["A", "B"], "result": "FAIL"}],
        },
    )
    post("plan/read", {"parts": {"text": "part,cost,slot\nA,1,x\nB,,y\n"}})
    post(
        "plan/read",
        {
            "parts": ["A", "B"],
            "at_once": 2,
            "done": {"text": "step,slot_1,slot_2,result\n1,A,B,ok\n"},
        },
    )
    plan = post("plan/start", {**four, "seconds": 20})["id"]
    for _ in range(600):
        if get("plan/job", f"?id={plan}")["state"] != "running":
            break
        time.sleep(0.1)
    post("plan/stop", "", f"?id={plan}")
    sheet = {
        "title": "a run",
        "tests": 2,
        "sheet": {"of": "the page"},
        "results": [{"test": "1", "result": "pass", "notes": "", "by": "", "at": ""}],
    }
    kept = post("run", sheet)
    post("run", {**sheet, **{key: kept[key] for key in ("id", "sheet_revision")}})
    post(
        "run/result",
        {"test": "2", "result": "FAIL", "notes": "hot", "by": "Ann", "sheet_revision": 2},
        f"?id={kept['id']}",
    )
    get("run")
    get("run?id", f"?id={kept['id']}")
    post("run/remove", "", f"?id={kept['id']}")
    for more in (
        {},
        {"workers": 2},
        {"pairs": [[0, 1], [1, 8]]},
        {"bytes_per_item": 8},
        {"prefetch": True},
        {"seconds": 0.1},
    ):
        post("loadorder", {"items": 9, "room": 3, **more})
    post("loadorder", {"sizes": [[0, 2], [1, 3], [2, 4]], "memory": 8, "workers": 2})
    for more in (
        {"way": "exact"},
        {"way": "exact", "v": 6, "k": 3, "change": 1, "first": [0, 1], "anew": True},
        {"way": "base-blocks", "kind": "circular", "blocks": 8},
        {"way": "locked", "v": 10, "first": [0, 1], "expansion_set": True},
        {"strength": 3},
    ):
        post(
            "search/stop",
            "",
            f"?id={post('search', {'v': 9, 'k': 4, 'kind': 'linear', 'seconds': 20, **more})['id']}",
        )
        for _ in range(600):
            if get("search")[0]["state"] != "running":
                break
            time.sleep(0.1)
    job = post("search", {"v": 9, "k": 4, "kind": "linear", "seconds": 20})["id"]
    for _ in range(600):
        if get("search")[0]["state"] != "running":
            break
        time.sleep(0.1)
    get("search?id", f"?id={job}")
    post("search/stop", "", f"?id={job}")
    post("search/keep", "", f"?id={job}")
    post("catalog/add", json.dumps(server.get(f"api/design?job={job}")))
    label = post(
        "catalog/add", "0 1 2\n1 2 3\n2 3 0\n3 0 1\n", "?change=1&kind=circular", "text/plain"
    )["label"]
    run("catalog", "retract", label, "--why", "a test", "--catalog", "own.db")
    get("cell", "?v=4&k=3&change=1&kind=circular")
    refusals = server.get("api/cell?v=1"), server.post("api/verify", "1 2 3\n2 2 3\n", "text/plain")
    for refusal in refusals:
        problem = fits("explorer-1", refusal, "$defs/refusal")
        if problem:
            fault(f"a refusal is against its schema ({problem.message})")
    run(
        "serve", "--export", "site", "--k", "3..4", "--v", "4..8", "--change", "2", "--sources",
        "https://example.org/changeover", "--address",
        "https://example.org/designs",
    )
    site = pathlib.Path("site")
    data = site / "data"
    look("get", "about", json.loads((data / "config.json").read_text()), "config.json")
    look("get", "theorems", json.loads((data / "theorems.json").read_text()), "theorems.json")
    for address in ("atlas", "groups"):
        for file in data.glob(f"{address}/*.gz"):
            look("get", address, json.loads(gzip.decompress(file.read_bytes())), str(file))
    labels, made = set(), set()
    forms = json.loads(gzip.decompress((data / "citations.json.gz").read_bytes()))
    for file in data.glob("cell/*.gz"):
        for cell in json.loads(gzip.decompress(file.read_bytes())).values():
            numbers, tree = cell.pop("cite"), cell.pop("tree")
            shared = ("v", "k", "change", "kind", "strength", "lower_bound", "reason")
            of_cell = {key: cell[key] for key in shared if key in cell}
            cell["designs"] = [{**of_cell, **design} for design in cell["designs"]]
            look("get", "cell", cell, str(file))
            if tree:
                explained = {"recipe": cell["best"]["recipe"], "tree": tree}
                look("get", "explain", explained, str(file))
            labels |= {entry["label"] for entry in cell["designs"] if "retracted" not in entry}
            if cell["best"] and not cell["best"]["label"]:
                strength = f".t{cell['strength']}" if cell.get("strength", 2) > 2 else ""
                made.add("{v}.{k}.{change}.{kind}".format(**cell) + strength)
            if len(numbers) != len(cell["designs"]):
                fault(f"{file}: not every design is cited")
            for number, design in zip(numbers, cell["designs"]):
                cited = re.sub(r"<(\w+)>", lambda word: str(design[word[1]]), forms[number])
                if cited != server.text(f"{server.address}api/cite?label={design['label']}"):
                    fault(f"{file}: what to cite is not that of {design['label']}")
    unpacked = {
        design["label"]: design
        for file in data.glob("design/*.gz")
        for design in unpack(gzip.decompress(file.read_bytes()))
    }
    if not made or set(unpacked) != labels | made:
        others = (labels | made) ^ set(unpacked)
        fault(f"designs that are packed are not those of the cells: {others}")
    for label, design in unpacked.items():
        look("get", "design", design, label)
        digits = hashlib.sha256(
            "".join(" ".join(map(str, block)) + "\n" for block in design["blocks"]).encode()
        ).hexdigest()[:8]
        if label not in made and not label.endswith(digits):
            fault(f"{label}: the packed blocks are others ({digits})")
    addresses = [
        address
        for file in site.glob("sitemap-*.gz")
        for address in re.findall("<loc>(.*?)</loc>", gzip.decompress(file.read_bytes()).decode())
    ]
    if (
        not {f"https://example.org/designs/?design={label}" for label in labels} <= set(addresses)
        or "https://example.org/designs/?cell=8.4.2.linear" not in addresses
    ):
        fault("the sitemap lacks addresses")
    entries = (
        xml.etree.ElementTree.parse(site / "feed.xml")
        .getroot()
        .findall("{http://www.w3.org/2005/Atom}entry")
    )
    if not entries or any(
        entry.find("{http://www.w3.org/2005/Atom}updated") is None for entry in entries
    ):
        fault("the feed has no entries, or some without a date")
    missing = {
        (method, address) for method in said for address in said[method]["properties"]
    } - tried
    if missing:
        fault(f"nothing was asked of {missing}")
    never = sorted({key for keys in found.values() for key in keys})
    if never:
        fault(f"no answer had the keys {never}")
