"""Load orders: the same document at each door that knows the options, and the same refusals."""

import json
import random

from doors import changeover, fault, fits, jsonschema, root, run, schema, takes


def check_loads(server, count):
    """The same refusals by the schema and by the program; the same document at each door that knows
    the options."""
    rng = random.Random(2)
    line = schema("changeover-loads-1")
    answered = 0
    keys = set()
    of_server = {*takes("changeover-load-request/1", "server")}
    of_python_keys = {*takes("changeover-load-request/1", "python")}
    # What chance may pass over.
    together = [
        {"fast_room": 2, "item_bytes": 8},
        {"item_bytes": 8},
        {"from_step": 3},
        {"fast_room": 3, "workers": 2, "epochs": 2},
        {"fast_room": 3, "prefetch": True},
        {"workers": 2, "prefetch": True},
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
        for_all = set(ask) <= of_server
        if for_all and (by_line.returncode == 0) != ("error" not in by_server):
            fault(
                f"the server and the command line disagree: {body} {by_line.stderr} "
                f"{by_server.get('error')}"
            )
        if not for_all and "error" not in by_server:
            fault(f"the server answers what it does not know: {body}")
        for said in map(json.loads, by_line.stdout.splitlines() if by_line.returncode == 0 else []):
            keys |= said.keys()
            problem = jsonschema.exceptions.best_match(line.iter_errors(said))
            if problem:
                fault(f"a line of the answer is against its schema ({problem}): {body}")
                break
        of_python = (
            set(ask) <= of_python_keys
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
            if by_server["order"] != head or by_server["steps"] != steps[:10000]:
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
