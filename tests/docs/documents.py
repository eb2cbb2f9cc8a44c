"""documents.py ROOT BUILD REQUESTS: requests and answers are what docs/schema says, at every door;
docs/doors.md is what the program says.

So many requests of plans, and of load orders, are made at random from the schema's own keys; an
answer is asked for on the command line, of the server and in Python, and is the same document at
each of them.
"""

import inspect
import json
import os
import pathlib
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent / "documents"))
from designs import check_designs, check_dossiers  # noqa: E402
from doors import (  # noqa: E402
    Server, changeover, fault, faults, jsonschema, requests, root, run, takes,
)
from explorer import check_explorer  # noqa: E402
from loads import check_loads  # noqa: E402
from plans import check_plans, check_workbooks  # noqa: E402


def check_generated():
    for kind in ("job", "load-request"):
        kept = root / f"docs/schema/changeover-{kind}-1.json"
        if run("describe", "--schema", kind).stdout != kept.read_text():
            fault(
                f"{kept.name} is not what `changeover describe --schema {kind}` says; write it again"
            )
    if run("describe", "--doors").stdout not in (root / "docs/doors.md").read_text():
        fault("docs/doors.md is not what `changeover describe --doors` writes; run it again")
    for call, request, more in (
        (changeover.plan, "changeover-job/1", {"slot_of", "quantities"}),
        (changeover.load_order, "changeover-load-request/1", set()),
    ):
        arguments = {*inspect.signature(call).parameters} - {"progress", *more}
        if arguments != {*takes(request, "python").values()}:
            fault(f"docs/doors.md has other arguments than {call.__name__}(): {arguments}")
    # In C members, arguments and functions; what else the members are about is no key.
    header = (root / "include/changeover/loadorder/changeover_loadorder.h").read_text()
    members = re.search(r"typedef struct changeover_loadorder_options \{(.*?)\n\}", header, re.S)[1]
    members = set(re.findall(r"(\w+)(?:;|\)\()", re.sub(r"/\*.*?\*/", "", members, flags=re.S)))
    in_c = {*takes("changeover-load-request/1", "c").values()}
    beside = {"size", "pair_count", "unread", "cancelled", "data", "group_sizes", "group_count"}
    if members - in_c != beside or not beside <= members:
        fault(f"docs/doors.md lacks members of changeover_loadorder_options: {members - in_c}")
    for name in in_c - members:
        if not re.search(rf"\b{re.escape(name.removesuffix('()'))}\b", header):
            fault(f"docs/doors.md: C has no {name}")
    for file in sorted((root / "docs/schema").glob("*.json")):
        jsonschema.Draft202012Validator.check_schema(json.loads(file.read_text()))


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
