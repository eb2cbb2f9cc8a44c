"""The questions of compare_answers.py: command lines, requests and calls, made from a seed.

The answers that the program gives to them are recorded before and after a change of structure. A
question that is added or changed makes older recordings useless.
"""
import json
import random


class Questions:
    """Files to ask with, and command lines, requests and calls that ask."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.files = {}
        self.lines = []
        self.requests = []
        self.calls = []
        self._plans()
        self._benches()
        self._faulty_plans()
        self._loads()
        self._lists_of_pairs()
        self._designs()
        self._posts()
        self._python()

    def file(self, name, text):
        self.files[name] = text
        return name

    def ask(self, *words):
        self.lines.append([str(word) for word in words])

    def one_of(self, *choices):
        return self.random.choice(choices)

    def parts_list(self, number):
        """A list of parts in one of the forms that are read, and their names."""
        draw = self.random
        count = draw.randint(4, 11)
        names = draw.sample(
            [
                "camera", "lens a", "lens,b", "SSD 1", "GPU-A", "Käfer", "日本",
                "P\"7",
                "x", "y", "disk", "fan", "board",
            ],
            count,
        )
        costs = [draw.choice(["1", "2.50", "10", "0.05", "7"]) for _ in names]
        slots = [draw.choice(["a", "b", "c"]) for _ in names]
        separator = draw.choice([",", ";", "\t"])
        quoted = [
            '"' + name.replace('"', '""') + '"' if separator in name or '"' in name else name
            for name in names
        ]
        form = draw.choice(["names", "costs", "slots", "headless"])
        rows = {
            "names": [["name"]] + [[name] for name in quoted],
            "costs": [["part", "cost"]] + [list(row) for row in zip(quoted, costs)],
            "slots": [["part", "cost", "slot"]] + [list(row) for row in zip(quoted, costs, slots)],
            "headless": [list(row) for row in zip(quoted, costs)],
        }[form]
        text = "".join(separator.join(row) + "\n" for row in rows)
        return self.file(f"parts{number}.csv", text), names, form, slots

    def pairs_of(self, number, names, count, kind, extra=lambda: ""):
        draw = self.random
        quote = lambda name: '"' + name.replace('"', '""') + '"'
        lines = []
        for _ in range(count):
            a, b = draw.sample(names, 2)
            lines.append(f"{quote(a)},{quote(b)}{extra()}\n")
        return self.file(f"{kind}{number}.csv", "".join(lines))

    def setups_of(self, number, names, at_once, kind, results=False):
        draw = self.random
        lines = []
        for _ in range(draw.randint(1, 4)):
            chosen = draw.sample(names, min(at_once, len(names)))
            lines.append(",".join('"' + name.replace('"', '""') + '"' for name in chosen) + "\n")
        return self.file(f"{kind}{number}.csv", "".join(lines))

    def _plans(self):
        draw = self.random
        for number in range(420):
            words = ["plan"]
            at_once = draw.randint(2, 5)
            form, names, slots = "items", [], []
            if draw.random() < 0.35:
                count = draw.randint(3, 14)
                names = [str(i + 1) for i in range(count)]
                words += ["--items", count, "--change-cost", draw.choice(["1", "5", "0.25"])]
            else:
                path, names, form, slots = self.parts_list(number)
                words += [path]
                if form == "names" or draw.random() < 0.3:
                    words += ["--change-cost", draw.choice(["1", "5", "0.25"])]
            words += ["-k", at_once, "--test-cost", draw.choice(["1", "10", "12.50", "0"])]
            if form == "slots" and draw.random() < 0.9:
                rooms = sorted(set(slots))
                words += [
                    "--slot",
                    ",".join(
                        f"{room}={draw.choice(['1', '..2', '0..2', '1..3'])}" for room in rooms
                    ),
                ]
            if draw.random() < 0.2:
                words += ["--never", self.pairs_of(number, names, draw.randint(1, 3), "never")]
            if draw.random() < 0.15:
                words += ["--pairs", self.pairs_of(number, names, draw.randint(2, 9), "pairs")]
            if draw.random() < 0.1:
                words += ["--mounted", draw.choice(names).replace(",", " ")]
            if draw.random() < 0.15:
                words += ["--done", self.setups_of(number, names, at_once, "done")]
            if draw.random() < 0.1:
                words += ["--first", self.setups_of(number, names, at_once, "first")]
            if draw.random() < 0.1:
                words += [
                    "--priority",
                    self.pairs_of(number, names, 4, "worth", lambda: f",{draw.randint(1, 9)}"),
                ]
            if draw.random() < 0.1:
                words += ["--budget", draw.choice(["5", "30", "100"])]
            if draw.random() < 0.1:
                words += ["--strength", draw.choice(["2", "3"])]
            if draw.random() < 0.08:
                words += ["--what-if"]
            if draw.random() < 0.08:
                words += ["--compact"]
            if draw.random() < 0.08:
                words += ["--shuffle", draw.randint(1, 99)]
            if draw.random() < 0.1:
                words += ["--title", "Monday & more"]
            words += ["--steps", 2000, "--seed", draw.randint(1, 9)]
            form = draw.choice(["", "", "json", "csv", "markdown", "html", "xlsx", "file"])
            if form == "file":
                words += [
                    "-o",
                    draw.choice(
                        ["out.csv", "out.json", "out.md", "out.html", "out.xlsx", "out.txt"]
                    ),
                ]
            elif form == "xlsx":
                words += ["--format", "xlsx", "-o", "out.xlsx"]
            elif form:
                words += ["--format", form]
            self.ask(*words)

    def _benches(self):
        draw = self.random
        for _ in range(60):
            self.ask(
                "plan",
                "--items",
                draw.randint(4, 12),
                "-k",
                draw.randint(2, 4),
                "--test-cost",
                draw.randint(0, 9),
                "--change-cost",
                draw.randint(0, 5),
                "--benches",
                draw.randint(1, 4),
                "--objective",
                draw.choice(["makespan", "cost"]),
                "--steps",
                1000,
                "--format",
                draw.choice(["table", "json", "csv", "markdown", "html"]),
            )

    def _faulty_plans(self):
        """One fault each: the line that refuses it is an answer, too."""
        parts = self.file("good.csv", "part,cost\na,1\nb,2\nc,3\nd,4\n")
        good = ["plan", parts, "-k", "3", "--test-cost", "2", "--steps", "100"]
        for extra in (
            ["--never", "absent.csv"],
            ["--slot", "CPU=1"],
            ["--budget", "x"],
            ["--budget", "-1"],
            ["--benches", "0"],
            ["--benches", "9999"],
            ["--strength", "4"],
            ["--mounted", "z"],
            ["--done-first", "1"],
            ["--diagnose"],
            ["--objective", "cost"],
            ["--header", "--no-header"],
            ["--mounted", "a,b,c,d"],
            ["--start", "a,a"],
            ["--items", "4"],
            ["--title", "\x01"],
            ["--priority", self.file("w1.csv", "a,b,x\n")],
            ["--never", self.file("n1.csv", "a,q\n")],
            ["--never", self.file("n2.csv", "a,a\n")],
            ["--first", self.file("f1.csv", "a,b,c,d\n")],
            ["--done", self.file("d1.csv", "a,zz\n")],
            ["--change-costs", self.file("c1.csv", "a,b\n1\n")],
            ["--slots", self.file("s1.csv", "CPU,1\n")],
            ["--pairs", self.file("p1.csv", "\n")],
            ["-o", parts],
            ["-o", "absent/out.csv"],
            ["--what-if", "--format", "html"],
            ["--compact", "--format", "csv"],
            ["--never", self.file("n3.csv", "a,b\na,c\na,d\nb,c\nb,d\nc,d\n")],
        ):
            self.ask(*good, *extra)
        for text in (
            "", "a\n", "a\na\n", "part,cost\na,x\n", "part,cost\na,-1\nb,2\n",
            "\ufeffpart,cost\na,1\nb,2\n", "part,cost,cost\na,1,2\n", "a,1\nb\n",
            "\"a,1\nb,2\n",
            "part;cost\na;1,5\nb;2\n",
            "a\x00b\n",
        ):
            self.ask(
                "plan",
                self.file(f"odd{len(self.files)}.csv", text),
                "-k", 2, "--test-cost", 1, "--steps", 10,
            )
        for words in (
            ["-k", "1"],
            ["-k", "0"],
            [],
            ["-k", "x"],
            ["-k", "2"],
            ["--test-cost", "1"],
            ["-k", "2", "--test-cost", "1e3"],
            ["-k", "2", "--test-cost", "99999999999999999999"],
        ):
            self.ask("plan", parts, *words)

    def _loads(self):
        draw = self.random
        for _ in range(300):
            items = draw.randint(1, 60)
            words = ["loadorder", "--items", items, "--room", draw.randint(2, 12)]
            kind = draw.choice(
                ["plain", "plain", "against", "done", "workers", "disjoint", "prefetch", "fast"]
            )
            if kind == "against":
                words += ["--against", draw.randint(1, 30)]
            elif kind == "done":
                words += ["--done-items", draw.randint(0, items)]
            elif kind == "workers":
                words += ["--workers", draw.randint(1, 9)]
            elif kind == "disjoint":
                words += ["--workers", draw.randint(1, 4), "--disjoint"]
            elif kind == "prefetch":
                words += ["--prefetch"]
            elif kind == "fast":
                words += ["--fast-room", draw.randint(2, 6)]
            if kind in ("plain", "disjoint") and draw.random() < 0.3:
                words += ["--write-back"]
            if kind not in ("prefetch",) and draw.random() < 0.4:
                words += ["--new-pairs"]
                if kind != "fast" and draw.random() < 0.3:
                    words += [draw.choice(["--ordered", "--self", "--shuffle"])]
            words += ["--format", draw.choice(["text", "jsonl", "csv"])]
            self.ask(*words)
        for words in (
            ["--items", 5],
            ["--room", 3],
            ["--items", 0, "--room", 3],
            ["--items", 5, "--room", 1],
            ["--items", 5, "--room", 3, "--workers", 0],
            ["--items", 5, "--room", 3, "--disjoint"],
            ["--items", 2**40, "--room", 3],
            ["--items", 5, "--room", 2**40],
            ["--items", 9, "--room", 3, "--fast-room", 4],
            ["--items", 9, "--room", 3, "--fast-room", 1],
            ["--items", 9, "--room", 3, "--item-bytes", 3],
            ["--items", 9, "--room", 3, "--done-items", 10],
            ["--items", 9, "--room", 3, "--pairs", "absent"],
            ["--room", 3, "--pairs", "absent"],
            ["--items", 9, "--room", 3, "--prefetch", "--workers", 2],
        ):
            self.ask("loadorder", *words)

    def _lists_of_pairs(self):
        draw = self.random
        for number in range(120):
            items = draw.randint(2, 40)
            named = draw.random() < 0.3
            name = (lambda i: f"img{i:03}.jpg") if named else str
            pairs = {
                tuple(sorted(draw.sample(range(items), 2)))
                for _ in range(draw.randint(1, 3 * items))
            }
            separator = draw.choice([" ", ",", "\t"])
            text = "".join(f"{name(a)}{separator}{name(b)}\n" for a, b in sorted(pairs))
            path = self.file(
                f"list{number}.txt", ("# some pairs\n" if draw.random() < 0.3 else "") + text
            )
            words = [
                "loadorder",
                "--pairs",
                path,
                "--room",
                draw.randint(2, 8),
                "--format",
                draw.choice(["text", "jsonl", "csv"]),
            ]
            if draw.random() < 0.2:
                words += ["--workers", draw.randint(1, 4)]
            if draw.random() < 0.3:
                words += ["--new-pairs"]
            self.ask(*words)
        for text in (
            "", "1\n", "1 2 3\n", "1,1\n", "a b c\n", "1 x\n", "-1 2\n", "1 99999999999999999999\n",
            "\"a\n",
        ):
            self.ask(
                "loadorder", "--pairs", self.file(f"bad{len(self.files)}.txt", text), "--room", 3
            )

    def _designs(self):
        draw = self.random
        design = self.file(
            "mine.txt",
            "# v=6 k=3 change=1 linear\n0 1 2\n1 2 3\n1 3 4\n3 4 5\n4 5 0\n0 5 1\n0 2 5\n0 2 4\n",
        )
        for _ in range(300):
            v, k = draw.randint(3, 60), draw.randint(2, 9)
            kind = draw.choice([[], ["--linear"], ["--circular"]])
            change = draw.choice([[], ["--change", "1"], ["--change", "2"], ["--change", "3"]])
            verb = draw.choice(["design", "bounds", "explain", "design", "bounds"])
            form = {
                "design": ["text", "json", "csv", "table", "latex"],
                "bounds": ["text", "json"],
                "explain": ["text", "json"],
            }[verb]
            self.ask(
                verb, v, k, *kind, *change,
                *draw.choice([[], ["--format", draw.choice(form)], ["--json"]]),
            )
        for _ in range(60):
            low = draw.randint(4, 30)
            self.ask(
                "table", "--k", f"{draw.randint(3, 5)}..{draw.randint(5, 7)}", "--v",
                f"{low}..{low + draw.randint(0, 9)}",
                *draw.choice([[], ["--change", "1"], ["--change", "3"]]),
                *draw.choice([[], ["--linear"], ["--circular"]]),
                "--format",
                draw.choice(["text", "json", "csv", "markdown", "latex"]),
            )
        for form in ("text", "json", "table"):
            self.ask("verify", design, "--format", form)
            self.ask("verify", design, "--change", 1, "--linear", "--format", form)
            self.ask(
                "verify",
                self.file("wrong.txt", "0 1 2\n3 4 5\n"),
                "--change", 1, "--linear", "--format", form,
            )
        for verb in (
            "constructions", "describe", "minima", "catalog completeness", "catalog list",
            "catalog show 9 3", "catalog show 20 5 --change 1", "factorize 8",
            "classify 6 3 8 --change 1 --linear", "--help", "--version", "plan --help",
            "loadorder --help", "design --help", "search --help", "nonsense", "desing 5 3",
        ):
            self.ask(*verb.split())
        for _ in range(40):
            v, k = draw.randint(4, 8), 3
            self.ask(
                "search",
                v,
                k,
                "--exact",
                draw.choice(["--linear", "--circular"]),
                "--change",
                draw.choice([1, 2]),
                "--json",
                "--threads",
                1,
            )
        for picture in ("array", "stays", "coverage", "circle", "recipe"):
            for form in ("svg", "tikz"):
                self.ask("draw", 13, 4, "--picture", picture, "--format", form)

    def post(self, path, body):
        self.requests.append(("POST", path, body if isinstance(body, str) else json.dumps(body)))

    def _posts(self):
        draw = self.random
        for _ in range(120):
            parts = draw.randint(2, 9)
            body = {
                "parts": draw.choice(
                    [
                        parts,
                        [{"name": f"p{i}", "cost": draw.choice([1, "2.5"])} for i in range(parts)],
                    ]
                ),
                "at_once": draw.randint(2, 4),
                "test_cost": draw.choice([1, "0.5", 10]),
            }
            if draw.random() < 0.5:
                body["change_cost"] = draw.choice([1, "0.75"])
            if draw.random() < 0.2:
                body["pairs"] = [draw.sample([f"p{i}" for i in range(parts)], 2) for _ in range(2)]
            if draw.random() < 0.1:
                body["nonsense"] = 1
            self.post("api/plan", body)
        for _ in range(120):
            body = {"items": draw.randint(1, 60), "room": draw.randint(2, 9)}
            if draw.random() < 0.3:
                body["workers"] = draw.randint(1, 5)
            if draw.random() < 0.2 and body["items"] > 3:
                body["pairs"] = [draw.sample(range(body["items"]), 2) for _ in range(5)]
            self.post("api/loadorder", body)
        for body in (
            "", "{", "[]", "{}", '{"items":5}', '{"items":"x","room":3}', '{"items":5,"room":1}',
        ):
            self.post("api/loadorder", body)
            self.post("api/plan", body)
        for path in (
            "api/design?v=61&k=4&change=2&kind=circular", "api/design?v=13&k=4",
            "api/bounds?v=20&k=5", "api/table?k=3..5&v=5..12&change=1", "api/constructions",
            "api/design?v=x", "api/nothing",
        ):
            self.requests.append(("GET", path, None))
        self.post("api/verify", "0 1 2\n0 1 3\n")

    def _python(self):
        draw = self.random
        for _ in range(150):
            v, k, m = draw.randint(4, 40), draw.randint(3, 7), draw.randint(1, 3)
            self.calls.append(
                draw.choice(
                    [
                        f"c.design({v}, {k}, change={m}).b",
                        f"c.bounds({v}, {k}, change={m}).lower_bound",
                        f"c.bounds({v}, {k}, change={m}).reason", f"c.load_order({v}, {k}).loads",
                        f"c.plan({max(v // 4, 2)}, {min(k, 4)}, test_cost=2, change_cost=1).cost",
                        f"c.plan({{'a': 1, 'b': '2.5', 'c': 3, 'd': 1}}, 3, test_cost={m}).cost",
                        f"c.plan(['a', 'b', 'c', 'd', 'e'], 3, test_cost={m}, change_cost=2, "
                        "never=[('a', 'b')]).cost",
                        f"c.plan(6, 3, test_cost={m}, change_cost=1).to_csv()",
                        f"c.explain({v}, {k}, change={m})",
                        f"c.plan(5, 1, test_cost=1, change_cost=1)", f"c.load_order({v}, 1)",
                    ]
                )
            )
