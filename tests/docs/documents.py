"""documents.py ROOT BUILD: requests and answers are what docs/schema says, at every door; docs/doors.md is what the program says.

Requests are made at random from the schema's own keys; an answer is asked for on the command line, of the server and in
Python, and is the same document at each of them.
"""

import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import urllib.error
import urllib.request

try:
    import jsonschema
except ImportError:
    print("skipped: no Python module jsonschema")
    sys.exit(77)

root, build = map(pathlib.Path, sys.argv[1:3])
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


def schema(name):
    return jsonschema.Draft202012Validator(json.loads((root / "docs/schema" / f"{name}.json").read_text()))


def fits(name, document):
    return jsonschema.exceptions.best_match(schema(name).iter_errors(document)) if document is not None else "no document"


def check_generated():
    for kind in ("job",):
        kept = root / f"docs/schema/changeover-{kind}-1.json"
        if run("describe", "--schema", kind).stdout != kept.read_text():
            fault(f"{kept.name} is not what `changeover describe --schema {kind}` says; write it anew")
    if run("describe", "--doors").stdout not in (root / "docs/doors.md").read_text():
        fault("docs/doors.md is not what `changeover describe --doors` says; write it anew")
    for file in sorted((root / "docs/schema").glob("*.json")):
        jsonschema.Draft202012Validator.check_schema(json.loads(file.read_text()))


class Server:
    def __init__(self):
        self.process = subprocess.Popen([program, "serve"], stdout=subprocess.PIPE, text=True)
        self.address, _, token = self.process.stdout.readline().strip().partition("?token=")
        self.token = token

    def post(self, target, body):
        request = urllib.request.Request(self.address + target, body.encode(), method="POST", headers={
            "Content-Type": "application/json", "Authorization": f"Bearer {self.token}"})
        try:
            with urllib.request.urlopen(request) as answer:
                return json.loads(answer.read())
        except urllib.error.HTTPError as refusal:
            return json.loads(refusal.read())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


def any_job(rng):
    """A job that may or may not make sense."""
    parts = rng.choice([7, ["A", "B", "C", "D", "E"], [{"name": "A", "cost": 2}, {"name": "B", "cost": "1.50"}, "C", "D"]])
    names = [str(i + 1) for i in range(parts)] if isinstance(parts, int) else [p if isinstance(p, str) else p["name"] for p in parts]
    pair = lambda: rng.sample(names, 2)  # noqa: E731
    job = {"parts": parts, "at_once": rng.choice([2, 3, 3, 4]), "test_cost": rng.choice([1, "2.50", 0]), "change_cost": rng.choice([1, "0.25"])}
    may_be = {
        "strength": rng.choice([2, 3]), "pairs": [pair() for _ in range(3)], "never": [pair()], "mounted": names[:1], "start": names[:2],
        "first": [names[:2]], "weights": [[*pair(), 5]], "budget": "30", "done": [names[:2], {"parts": names[1:3], "result": "FAIL"}],
        "done_first": 1, "trust_failed": True, "benches": 2, "objective": "cost", "what_if": True, "diagnose": True, "shuffle": 3,
        "title": "A title", "steps": 300, "compact": False, "header": False,
    }
    for key in rng.sample(list(may_be), rng.choice([0, 1, 1, 2, 2, 3])):
        job[key] = may_be[key]
    job.setdefault("steps", 300)
    if job.get("diagnose"):
        del job["steps"]
    return job


def check_plans(server, count):
    rng = random.Random(1)
    kinds = {"plan": "plan", "benches": "benches", "what-if": "what_if", "diagnosis": "diagnosis"}
    seen = set()
    for _ in range(count):
        job = any_job(rng)
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
        arguments = {key: value for key, value in job.items() if key not in ("what_if", "diagnose", "compact", "header")}
        if kind in ("plan", "benches"):
            for key, to in (("parts", lambda p: {(q if isinstance(q, str) else q["name"]): (
                    job["change_cost"] if isinstance(q, str) else q["cost"]) for q in p} if isinstance(p, list) else p),
                    ("weights", lambda w: {(a, b): c for a, b, c in w})):
                if key in arguments:
                    arguments[key] = to(arguments[key])
            by_python = changeover.plan(arguments.pop("parts"), arguments.pop("at_once"), **arguments).to_json()
            if by_python != by_line.stdout:
                fault(f"Python answers another document: {body}\n{by_line.stdout}\n{by_python}")
    missing = {*kinds, "refused"} - seen
    if missing:
        fault(f"nothing was tried of {missing}")


os.environ["CHANGEOVER_CATALOG"] = ""
with tempfile.TemporaryDirectory() as folder, Server() as one:
    os.chdir(folder)
    check_generated()
    check_plans(one, 150)
sys.exit(1 if faults else 0)
