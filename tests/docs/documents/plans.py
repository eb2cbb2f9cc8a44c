"""Plans: the same document at each door, and the same refusals."""

import base64
import json
import pathlib
import random
import re
import subprocess
import sys

from doors import changeover, fault, fits, root, run


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
    """A workbook is the same question at each door: its lists on other sheets, and a run sheet that
    was filled in."""
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
