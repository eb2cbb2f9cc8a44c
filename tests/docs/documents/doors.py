"""What the checks of documents share: the program, a server, schemas, and faults that are counted.

The command line of the program that imports it is ROOT BUILD REQUESTS.
"""

import functools
import json
import pathlib
import re
import subprocess
import sys
import urllib.error
import urllib.request

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

faults = []


def fault(text):
    faults.append(text)
    print(text[:2000])


@functools.cache
def takes(request, door):
    """The keys that the server takes, or the arguments in Python or C by key, as docs/doors.md
    says."""
    page = (root / "docs/doors.md").read_text()
    table = page[page.index(f"format `{request}`") :]
    rows = re.findall(
        r"^\| `(\w+)` \| `[^`]+` \| (\w+) \| (\S+)(?: \([a-z ]+\))? \| (\S+)",
        table.split("\n## ")[0],
        re.M,
    )
    at = {"server": 1, "python": 2, "c": 3}[door]
    return {row[0]: row[at].strip("`") for row in rows if row[at] != "no"}


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
