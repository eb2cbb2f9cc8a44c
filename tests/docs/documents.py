"""documents.py ROOT BUILD REQUESTS: requests and answers are what docs/schema says, at every door; docs/doors.md is
what the program says.

So many requests of plans, and of load orders, are made at random from the schema's own keys; an answer is asked for on
the command line, of the server and in Python, and is the same document at each of them.
"""

import base64
import functools
import gzip
import hashlib
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
import xml.etree.ElementTree

try:
    import jsonschema
except ImportError:
    print("skipped: no Python module jsonschema")
    sys.exit(77)

root, build = map(pathlib.Path, sys.argv[1:3])
requests = int(sys.argv[3])
program = str(build / "changeover")
sys.path.insert(0, str(build / "python"))
import changeover  # noqa: E402

faults = 0


def fault(text):
    global faults
    faults += 1
    print(text[:2000])


def run(*arguments, stdin=None):
    return subprocess.run([program, *arguments], input=stdin, capture_output=True, text=True)


@functools.cache
def schema(name, inside=None):
    """`inside` follows keys and $defs of that schema, as in "$defs/cell"."""
    document = json.loads((root / "docs/schema" / f"{name}.json").read_text())
    here = jsonschema.RefResolver(f"{(root / 'docs/schema').as_uri()}/{name}.json", document)
    return jsonschema.Draft202012Validator(
        {"$ref": f"#/{inside}"} if inside else document, resolver=here
    )


def fits(name, document, inside=None):
    if document is None:
        return "no document"
    return jsonschema.exceptions.best_match(schema(name, inside).iter_errors(document))


def check_generated():
    for kind in ("job", "load-request"):
        kept = root / f"docs/schema/changeover-{kind}-1.json"
        if run("describe", "--schema", kind).stdout != kept.read_text():
            fault(
                f"{kept.name} is not what `changeover describe --schema {kind}` says; write it anew"
            )
    if run("describe", "--doors").stdout not in (root / "docs/doors.md").read_text():
        fault("docs/doors.md is not what `changeover describe --doors` says; write it anew")
    for file in sorted((root / "docs/schema").glob("*.json")):
        jsonschema.Draft202012Validator.check_schema(json.loads(file.read_text()))


class Server:
    def __init__(self, catalog):
        self.process = subprocess.Popen(
            [program, "serve", "--catalog", catalog], stdout=subprocess.PIPE, text=True
        )
        self.address, _, token = self.process.stdout.readline().strip().partition("?token=")
        self.token = token

    def post(self, target, body, kind="application/json"):
        return self.ask(
            urllib.request.Request(
                self.address + target,
                body.encode(),
                method="POST",
                headers={"Content-Type": kind, "X-Changeover-Token": self.token},
            )
        )

    def get(self, target):
        return self.ask(self.address + target)

    def ask(self, request):
        return json.loads(self.text(request))

    @staticmethod
    def text(request):
        try:
            with urllib.request.urlopen(request) as answer:
                return answer.read().decode()
        except urllib.error.HTTPError as refusal:
            return refusal.read().decode()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


def any_job(rng):
    """A job that may or may not make sense."""
    parts = rng.choice(
        [
            7,
            ["A", "B", "C", "D", "E"],
            [{"name": "A", "cost": 2}, {"name": "B", "cost": "1.50", "quantity": 1}, "C", "D"],
        ]
    )
    names = (
        [str(i + 1) for i in range(parts)]
        if isinstance(parts, int)
        else [p if isinstance(p, str) else p["name"] for p in parts]
    )
    pair = lambda: rng.sample(names, 2)  # noqa: E731
    job = {
        "parts": parts,
        "at_once": rng.choice([2, 3, 3, 4]),
        "test_cost": rng.choice([1, "2.50", 0]),
        "change_cost": rng.choice([1, "0.25"]),
    }
    may_be = {
        "strength": rng.choice([2, 3]),
        "pairs": [pair() for _ in range(3)],
        "never": [[*pair(), "too hot"]],
        "cost_unit": "minutes",
        "mounted": names[:1],
        "start": names[:2],
        "first": [names[:2]],
        "weights": [[*pair(), 5]],
        "budget": "30",
        "done": [names[:2], {"parts": names[1:3], "result": "FAIL"}],
        "done_first": 1,
        "trust_failed": True,
        "benches": any_benches(rng, names),
        "objective": "cost",
        "without": names[2:3],
        "hours": 8,
        "what_if": True,
        "diagnose": True,
        "shuffle": 3,
        "title": "A title",
        "steps": 300,
        "compact": False,
        "header": False,
    }
    for key in rng.sample(list(may_be), rng.choice([0, 1, 1, 2, 2, 3])):
        job[key] = may_be[key]
    leave_out_costs(rng, job)
    job.setdefault("steps", 300)
    if job.get("diagnose"):
        del job["steps"]
        if rng.random() < 0.7:
            job["done"] = may_be["done"]
    return job


def leave_out_costs(rng, job):
    """Removes one of the two usual costs now and then, which some jobs do without."""
    if rng.random() < 0.2:
        del job[rng.choice(["test_cost", "change_cost"])]


def any_model(rng):
    """A job of a model that may or may not make sense."""
    rules = [
        "",
        'IF [Browser] = "Edge" THEN [OS] = "Windows";',
        '[OS] <> "Windows" OR [N] > 2;',
        "IF [N] = 1 THEN IsNegative(X);",
    ]
    text = (
        "OS: Debian, Fedora | RHEL, Windows\nBrowser: Firefox, Edge\nN: 1, 2, 3\nX: a, ~b\n"
        + "\n".join(rng.sample(rules, 2))
        + "\n"
    )
    job = {
        "model": rng.choice([text, text, {"text": text}, text + "[OS] = 3;"]),
        "test_cost": rng.choice([1, "2.50", 0]),
        "change_cost": rng.choice([1, "0.25"]),
        "steps": 300,
    }
    may_be = {
        "strength": rng.choice([2, 3]),
        "pairs": [["Debian", "a"], ["OS: Windows", "N: 3"]],
        "never": [["Firefox", "1"]],
        "mounted": ["Firefox"],
        "start": ["Windows", "Edge"],
        "first": [["Edge", "Windows"]],
        "budget": "30",
        "done": [
            ["Windows", "Edge", "3", "a"],
            {"parts": ["Debian", "Firefox", "2", "a"], "result": "FAIL"},
        ],
        "done_first": 1,
        "trust_failed": True,
        "objective": rng.choice(["cost", "tests"]),
        "change_costs": [["OS", 30], ["OS", "Debian", "Fedora", "4"], ["N", "1", 2]],
        "what_if": True,
        "diagnose": True,
        "title": "A title",
        "benches": 2,
        "shuffle": 3,
        "at_once": 2,
    }
    for key in rng.sample(list(may_be), rng.choice([0, 1, 1, 2, 2, 3])):
        job[key] = may_be[key]
    leave_out_costs(rng, job)
    if job.get("diagnose"):
        del job["steps"]
    return job


def any_benches(rng, names):
    return rng.choice(
        [
            1,
            2,
            ["North", "South"],
            [
                {"name": "North", "start": names[:2], "hours": 7},
                {"without": names[:1]},
                {"down": True},
            ],
            [
                {"at_once": 3, "test_cost": "1.50", "change_factor": 2, "own": names[1:2]},
                {"mounted": names[:1]},
            ],
        ]
    )


def check_plans(server, count):
    rng = random.Random(1)
    # What chance may pass over.
    together = [
        {"benches": 2},
        {"what_if": True},
        {"done": [["A", "B", "C"], {"parts": ["B", "D", "C"], "result": "FAIL"}], "diagnose": True},
    ]
    kinds = {"plan": "plan", "benches": "benches", "what-if": "what_if", "diagnosis": "diagnosis"}
    seen = set()
    for number in range(count):
        job = any_job(rng) if number % 3 else any_model(rng)
        if number < len(together):
            job = {
                "parts": ["A", "B", "C", "D", "E"],
                "at_once": 3,
                "test_cost": 1,
                "change_cost": 1,
                **together[number],
            }
        body = json.dumps(job)
        by_line = run("plan", "--request", "-", "--json", stdin=body)
        by_server = server.post("api/plan", body)
        problem = fits("changeover-job-1", job)
        if by_line.returncode != 0:
            said = by_server.get("error", {}).get("message")
            if said is None:
                fault(f"the server plans what the command line refuses ({by_line.stderr}): {body}")
            seen.add("refused")
            continue
        if problem:
            fault(f"planned, but against its schema ({problem}): {body}")
        answer = json.loads(by_line.stdout)
        kind = re.fullmatch("changeover-(.*)/1", answer["format"]).group(1)
        seen.add(kind)
        problem = fits(f"changeover-{kind}-1", answer)
        if problem:
            fault(f"the answer is against its schema ({problem}): {body}")
        if by_server.get(kinds[kind]) != answer:
            fault(f"the server answers another document: {body}\n{by_line.stdout}\n{by_server}")
        shown = run("plan", "--request", "-", "--show-request", stdin=body).stdout
        if run("plan", "--request", "-", "--json", stdin=shown).stdout != by_line.stdout:
            fault(f"--show-request says something else: {body} {shown}")
        arguments = {
            key: value
            for key, value in job.items()
            if key not in ("what_if", "diagnose", "compact", "header")
        }
        if kind in ("plan", "benches"):
            if isinstance(parts := job.get("parts"), list):
                arguments["quantities"] = {
                    part["name"]: part["quantity"] for part in parts if "quantity" in part
                }
            for key, to in (
                (
                    "parts",
                    lambda p: {
                        (q if isinstance(q, str) else q["name"]): (
                            job["change_cost"] if isinstance(q, str) else q["cost"]
                        )
                        for q in p
                    }
                    if isinstance(p, list) and "change_cost" in job
                    else p,
                ),
                ("weights", lambda w: {(a, b): c for a, b, c in w}),
            ):
                if key in arguments:
                    arguments[key] = to(arguments[key])
            if "model" in job:
                costs = arguments.pop("change_costs", None)
                arguments["change_costs"] = costs and {
                    row[0] if len(row) == 2 else tuple(row[:-1]): row[-1] for row in costs
                }
                arguments["model"] = (
                    job["model"]["text"] if isinstance(job["model"], dict) else job["model"]
                )
            else:
                arguments = {
                    "parts": arguments.pop("parts"),
                    "at_once": arguments.pop("at_once"),
                    **arguments,
                }
            by_python = changeover.plan(**arguments).to_json()
            if by_python != by_line.stdout:
                fault(f"Python answers another document: {body}\n{by_line.stdout}\n{by_python}")
    missing = {*kinds, "refused"} - seen
    if missing:
        fault(f"nothing was tried of {missing}")


def check_workbooks(server):
    """A workbook is the same question at each door: its lists on other sheets, and a run sheet that was filled in."""
    tables = {
        "Parts": "part,slot,swap (min),qty\nXeon,CPU,5,1\nEpyc,CPU,4,1\nA,DIMM,2,4\nB,DIMM,2,2\nE810,NIC,3,1\nX710,NIC,1,1\n",
        "Slots": "slot,min,max\nCPU,1,1\nDIMM,3,3\nNIC,1,1\n",
        "Never": "part,part 2,why\nEpyc,X710,no driver\n",
    }
    for name, table in tables.items():
        pathlib.Path(f"{name}.csv").write_text(table)
    script = [sys.executable, root / "examples/lab/workbook.py"]
    subprocess.run(
        [*script, "make", "stock.xlsx", *(f"{name}={name}.csv" for name in tables)], check=True
    )
    made = run("plan", "stock.xlsx", "--test-cost", "9", "--steps", "300", "-o", "run.xlsx")
    if made.returncode != 0:
        fault(f"no plan of a workbook: {made.stderr}")
        return
    subprocess.run(
        [*script, "fill", "run.xlsx", "filled.xlsx", "1=pass", "2=FAILED - hang"], check=True
    )
    for book, more in (
        ("stock.xlsx", {"test_cost": 9, "steps": 300}),
        ("stock.xlsx", {"test_cost": 9, "steps": 300, "cost_column": "swap (MIN)"}),
        ("run.xlsx", {}),
        ("filled.xlsx", {}),
        ("filled.xlsx", {"diagnose": True}),
    ):
        bytes_of_it = base64.b64encode(pathlib.Path(book).read_bytes()).decode()
        documents = [
            run(
                "plan",
                "--request",
                "-",
                "--json",
                stdin=json.dumps({"parts": {"file": book}, **more}),
            ).stdout,
            run(
                "plan",
                "--request",
                "-",
                "--json",
                stdin=json.dumps({"parts": {"workbook": bytes_of_it}, **more}),
            ).stdout,
        ]
        by_server = server.post(
            "api/plan", json.dumps({"parts": {"workbook": bytes_of_it}, **more})
        )
        documents.append(json.dumps(by_server.get("diagnosis" if "diagnose" in more else "plan")))
        if "diagnose" not in more:
            documents.append(changeover.plan(pathlib.Path(book), **more).to_json())
        for parts in ({"file": book}, {"workbook": bytes_of_it}):
            problem = fits("changeover-job-1", {"parts": parts, **more})
            if problem:
                fault(f"planned, but against its schema ({problem}): {book} {more}")
        answers = [json.loads(document or "null") for document in documents]
        for answer in answers:
            problem = fits(f"changeover-{'diagnosis' if 'diagnose' in more else 'plan'}-1", answer)
            if problem:
                fault(f"an answer to {book} {more} is against its schema: {problem}")
                return
            for note in answer.pop("notes"):
                if not note.startswith(
                    (
                        book, "parts", "costs", "done", "1 further", "2 further", "3 further",
                        "5 parts", "2 pairs cannot",
                    )
                ):
                    fault(f"a note of {book}: {note}")
        if any(answer != answers[0] for answer in answers):
            fault(f"the doors differ on {book} {more}: {documents}")
    unknown = {"parts": {"workbook": "x"}, "at_once": 2}
    if "base64" not in server.post("api/plan", json.dumps(unknown))["error"]["message"]:
        fault("what is no base64 is taken for a workbook")


def check_loads(server, count):
    """The same refusals by the schema and by the program; the same document at each door that knows the options."""
    rng = random.Random(2)
    line = schema("changeover-loads-1")
    answered = 0
    keys = set()
    # What chance may pass over.
    together = [
        {"fast_room": 2, "item_bytes": 8},
        {"fast_room": 3, "workers": 2, "epochs": 2},
        {"fast_room": 3, "prefetch": True},
        {"write_back": True},
        {"workers": 3, "disjoint": True},
        {"workers": 3, "worker": 2},
        {"workers": 3, "pair_cost": [[0, 1, 2.5]]},
        {"workers": 2, "first_holder": True},
        {"items": None, "workers": 2, "pairs": [[0, 1, 2.5], [1, 2, 4]]},
        {"epochs": 2, "new_pairs": True, "spread": True},
        {"room": None, "sizes": [[i, 1 + i % 3] for i in range(20)], "memory": 9},
        {"room": None, "sizes": [[i, 1 + i % 3] for i in range(20)], "memory": 9, "workers": 3},
        {"room": None, "sizes": [[i, 1 + i % 3] for i in range(20)], "memory": 9, "workers": 2,
         "prefetch": True, "epochs": 2},
        {"room": None, "sizes": [[i, 1 + i % 3] for i in range(20)], "memory": 9,
         "fast_memory": 7},
        {"room": None, "sizes": [[i, 1 + i % 3] for i in range(20)], "memory": 9, "workers": 2,
         "disjoint": True},
    ]
    for number in range(count):
        ask = {"items": rng.choice([1, 9, 20, 64]), "room": rng.choice([2, 3, 8, 70])}
        pairs = [
            [[0, 1], [1, 2], [0, 8]],
            [["a", "b"], ["b", "a thing"]],
            {"text": "a,b\nb,\"c d\"\n"},
        ]
        groups = [[[0, 1, 2], [2, 0, 8], [3]], {"text": "a,b,c\nb,\"c d\"\n"}]
        may_be = {
            "pairs": rng.choice(pairs),
            "groups": rng.choice(groups),
            "against": 5,
            "done_items": 4,
            "fast_room": 2,
            "item_bytes": 8,
            "workers": 3,
            "disjoint": True,
            "write_back": True,
            "prefetch": True,
            "new_pairs": True,
            "ordered": True,
            "self": True,
            "shuffle": True,
            "seed": 4,
            "worker": 1,
            "from_step": 1,
            "epochs": 3,
            "spread": True,
            "sizes": [[i, 1 + i % 3] for i in range(20)],
            "memory": 9,
            "fast_memory": 6,
            "balance": True,
            "first_holder": True,
            "pair_cost": [[0, 1, 2.5]],
            "verify_beside": True,
        }
        for key in rng.sample(list(may_be), rng.choice([0, 1, 1, 2, 3])):
            ask[key] = may_be[key]
        if number < len(together):
            ask = {"items": 20, "room": 5, **together[number]}
            ask = {key: value for key, value in ask.items() if value is not None}
        elif rng.random() < 0.2:
            ask |= rng.choice(together)
        body = json.dumps(ask)
        problem = fits("changeover-load-request-1", ask)
        by_line = run("loadorder", "--request", "-", "--format", "jsonl", stdin=body)
        if problem and by_line.returncode == 0:
            fault(f"answered, but against its schema ({problem}): {body}")
        shown = run("loadorder", "--request", "-", "--show-request", stdin=body)
        if (
            by_line.returncode == 0
            and json.loads(shown.stdout) != {"format": "changeover-load-request/1", **ask}
            and not {"pairs", "groups", "pair_cost", "sizes"} & set(ask)
        ):
            fault(f"--show-request says something else: {body} {shown.stdout}")
        by_server = server.post("api/loadorder", body)
        for_all = not set(ask) - {
            "items", "room", "pairs", "groups", "against", "done_items", "workers", "balance",
            "first_holder", "epochs", "sizes", "memory", "fast_room", "fast_memory", "disjoint",
        }
        if for_all and (by_line.returncode == 0) != ("error" not in by_server):
            fault(
                f"the server and the command line disagree: {body} {by_line.stderr} {by_server.get('error')}"
            )
        if (
            set(ask)
            - {
                "items", "room", "pairs", "groups", "against", "done_items", "workers", "prefetch",
                "balance", "first_holder", "epochs", "sizes", "memory", "fast_room", "fast_memory",
                "disjoint",
            }
            and "error" not in by_server
        ):
            fault(f"the server answers what it does not know: {body}")
        for said in map(json.loads, by_line.stdout.splitlines() if by_line.returncode == 0 else []):
            keys |= said.keys()
            problem = jsonschema.exceptions.best_match(line.iter_errors(said))
            if problem:
                fault(f"a line of the answer is against its schema ({problem}): {body}")
                break
        of_python = (
            not set(ask)
            & {"item_bytes", "worker", "from_step", "balance"}
            and ask.get("pairs") not in pairs[1:]
            and ask.get("groups") not in groups[1:]
        )
        if of_python and by_line.returncode == 0:
            arguments = {
                "with_self" if key == "self" else key: value
                for key, value in ask.items()
                if key not in ("items", "room")
            }
            text = changeover.load_order(
                ask.get("items"),
                ask.get("room"),
                **({**arguments, "sizes": dict(ask["sizes"])} if "sizes" in ask else arguments),
            ).to_json()
            if text != by_line.stdout:
                fault(f"Python answers another document: {body}\n{by_line.stdout}\n{text}")
        if for_all and by_line.returncode == 0:
            head = json.loads(by_line.stdout.splitlines()[0])
            steps = list(map(json.loads, by_line.stdout.splitlines()[1:]))
            if by_server["order"] != head or by_server["steps"] != steps[:5000]:
                fault(f"the server answers another document: {body}\n{by_line.stdout}\n{by_server}")
            if head["loads"] != by_server["loads"]:
                fault(f"loads differ: {body} {head['loads']} {by_server['loads']}")
            answered += of_python  # where items have numbers
    known = json.loads((root / "docs/schema/changeover-loads-1.json").read_text())["$defs"]
    missing = {*known["head"]["properties"], *known["step"]["properties"]} - keys
    missing -= {"time_is_up"}  # only where ten seconds are too short
    if missing:
        fault(f"no load order was asked for that has {missing}")
    if answered < count / 10:
        fault(f"only {answered} of {count} load orders were answered at every door")


def check_designs(server, count):
    """The same document at each door; read again, it is the same design; damaged, it is refused or judged anew."""
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
            if (
                server.text(f"{server.address}api/dossier?{query}&format={format}")
                != run("dossier", *cell, "--format", format).stdout
            ):
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


def keys_of(said, inside, schemas, found):
    """Takes out of `found` the optional keys that this answer has: what is left of an object of the schemas was never said."""
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
    """The designs of a file of `serve --export`, as packed_designs.hpp says that they are written."""
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
    """What the explorer's pages are answered, and the files of `serve --export`, at each address that the schema has."""
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
                f"{where or method} api/{address}: against its schema ({problem.message}) at {list(problem.absolute_path)}"
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
    labels = set()
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
    if set(unpacked) != labels:
        fault(f"designs that are packed are not those of the cells: {labels ^ set(unpacked)}")
    for label, design in unpacked.items():
        look("get", "design", design, label)
        digits = hashlib.sha256(
            "".join(" ".join(map(str, block)) + "\n" for block in design["blocks"]).encode()
        ).hexdigest()[:8]
        if not label.endswith(digits):
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


os.environ["CHANGEOVER_CATALOG"] = ""
with tempfile.TemporaryDirectory() as folder, Server(f"{folder}/own.db") as one:
    os.chdir(folder)
    check_generated()
    check_explorer(one)
    check_plans(one, requests)
    check_workbooks(one)
    check_loads(one, requests)
    check_designs(one, requests // 2)
    check_dossiers(one)
sys.exit(1 if faults else 0)
