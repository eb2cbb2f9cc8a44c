#!/usr/bin/python3
"""Plants faults into the rooms that everything rests on and looks whether their tests notice.

usage: mutate.py [--list] [--again] [-j N] [ROOM | FILE]...      ./dev mutate is the door

Rooms are verify, bounds and proof; without one, all of them. Every fault is a small change at one
line of the source (planted.py). A room is built once, with all its faults in it; the tests of the
room then run once for each fault that they reach. A fault is *killed* if a test fails, crashes or
takes far longer than without it. What survives must be in survivors.txt, with the reason why it
changes nothing that can be told from outside; a survivor that is not there is a fault of the tests
and fails. A line there that does not survive any more is said, and fails as well. --list writes the
faults and runs nothing; --again runs only those that the last run did not kill, after tests were
added. The sources are never touched: build/mutation has all.

Exit code: 0 all is as survivors.txt says, 1 not, 2 wrong usage.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import re
import resource
import shlex
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import planted  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
RELEASE = os.path.join(ROOT, "build", "release")
ROOMS = ("verify", "bounds", "proof")
SECONDS, MEMORY = 1, 2 << 30  # what a run may take at least, and at most


def say(text):
    print(f"mutate: {text}", file=sys.stderr, flush=True)


def fail(text, code=1):
    say(text)
    sys.exit(code)


def compile_commands():
    path = os.path.join(RELEASE, "compile_commands.json")
    if not os.path.exists(path):
        fail("no build/release: run ./dev test first", 2)
    commands = {}
    for entry in json.load(open(path)):
        command = shlex.split(entry["command"])
        # Sources that are compiled together stand in a file that includes them, each by its whole
        # path.
        together = (
            re.findall(r'^#include "(.+)"$', open(entry["file"]).read(), flags=re.M)
            if "/Unity/" in entry["file"]
            else []
        )
        commands |= {source: command for source in together or [entry["file"]]}
    return commands


def files_of(room):
    out = []
    for top in (f"src/{room}", f"include/changeover/{room}"):
        for folder, _, names in os.walk(os.path.join(ROOT, top)):
            out += [
                os.path.relpath(os.path.join(folder, n), ROOT)
                for n in names
                if n.endswith((".cpp", ".hpp"))
            ]
    return sorted(out)


def planted_into(path):
    language = ["-x", "c++", "-std=c++20", f"-I{ROOT}/include", f"-I{ROOT}/src"]
    return planted.find_faults(os.path.join(ROOT, path), path, language)


def write_list(room, only):
    """Reading a file takes libclang seconds: what is found is written before the next one is
    begun."""
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # the reader may have seen enough
    for path in files_of(room):
        if only and path not in only:
            continue
        for fault in planted_into(path).faults:
            print(f"{fault.path}:{fault.line}: {fault.how}")
        sys.stdout.flush()


def keys_of(faults, lines):
    """What a fault is called in survivors.txt: no number of a line, so that it outlives changes
    elsewhere."""
    times = collections.Counter()
    for fault in faults:
        key = fault.key(lines[fault.line - 1])
        times[key] += 1
        yield key + (f" | {times[key]}" if times[key] > 1 else "")


def cheapest(tests):
    """Of (name, milliseconds) those that take four tenths of the time together: most faults need no
    others."""
    left = 0.4 * sum(int(ms) for _, ms in tests)
    out = []
    for name, ms in sorted(tests, key=lambda t: int(t[1])):
        left -= int(ms)
        if left >= 0:
            out.append(name)
    return out


class Room:
    def __init__(self, name, only):
        self.name = name
        self.folder = os.path.join(ROOT, "build", "mutation", name)
        self.only = only
        self.commands = compile_commands()
        self.found, self.faults, self.keys = {}, [], {}
        self.quick = []  # tests that cost little and come first
        self.without, self.fixed_without = set(), collections.defaultdict(set)
        for path in files_of(name):
            if only and path not in only:
                continue
            found = planted_into(path)
            lines = open(os.path.join(ROOT, path), encoding="utf-8").read().split("\n")
            for fault, key in zip(found.faults, keys_of(found.faults, lines)):
                fault.number = len(self.faults)
                self.faults.append(fault)
                self.keys[fault.number] = key
            self.found[path] = found

    # ---- Building
    # -------------------------------------------------------------------------------------------

    def planted_path(self, path):
        return os.path.join(self.folder, path)

    def write(self, path):
        text = planted.plant(
            open(os.path.join(ROOT, path), "rb").read(),
            self.found[path],
            self.without,
            self.fixed_without[path],
        )
        head = f'#include "{HERE}/planted.hpp"\n#line 1\n'
        if "#pragma once" in text:
            text = text.replace(
                "#pragma once",
                f'#pragma once\n#include "{HERE}/planted.hpp"\n#line '
                + str(text[: text.index("#pragma once")].count("\n") + 2),
                1,
            )
        else:
            text = head + text
        target = self.planted_path(path)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        if not os.path.exists(target) or open(target, encoding="utf-8").read() != text:
            with open(target, "w", encoding="utf-8") as out:
                out.write(text)

    def command(self, path, output, *more):
        """How `path` is compiled in build/release, but by itself, with planted headers first."""
        given = self.commands[os.path.join(ROOT, path)]
        kept, skip = [], False
        for word in given[1:]:
            if skip:
                skip = False
            elif word in ("-include", "-o", "-c"):
                skip = True
            elif not word.startswith(("-W", "-O")):
                kept.append(word)
        source = self.planted_path(path) if path in self.found else os.path.join(ROOT, path)
        first = [
            f"-I{self.folder}/include",
            f"-I{self.folder}/src",
            f"-I{os.path.dirname(os.path.join(ROOT, path))}",
        ]
        cache = (
            ["ccache"]
            if subprocess.run(["which", "ccache"], capture_output=True).returncode == 0
            else []
        )
        return [
            *cache,
            given[0],
            *first,
            *kept,
            "-O2" if path in self.found else "-O1",
            "-w", "-Wno-narrowing", "-fmax-errors=0", "-o", output, *more, source,
        ]

    def object_of(self, path):
        return os.path.join(self.folder, path.replace("/", "-") + ".o")

    def compile(self, path):
        return subprocess.run(
            self.command(path, self.object_of(path), "-c"), capture_output=True, text=True
        )

    def drop_what_fails(self, errors):
        """Not every change is C++: takes out the faults that the compiler names. False if there is
        none."""
        dropped = False
        for file, line, column in set(
            re.findall(r"^(\S+?):(\d+):(\d+): error:", errors, flags=re.M)
        ):
            path = os.path.relpath(file, self.folder)
            if path not in self.found:
                continue
            text = open(file, encoding="utf-8").read().split("\n")
            shift = next(i for i, t in enumerate(text) if t.startswith("#line")) + 1
            start = int(text[shift - 1].split()[1])
            here = text[int(line) - start + shift]
            before = here.encode()[: int(column) - 1].decode(errors="ignore")
            numbers = (
                re.findall(r"planted_\w+\((\d+)\)", before)
                or re.findall(r"planted_\w+\((\d+)\)", here)[:1]
            )
            if numbers and int(numbers[-1]) not in self.without:
                self.without.add(int(numbers[-1]))
                dropped = True
        if not dropped:
            for path, found in self.found.items():
                for name in {f[3] for f in found.fixed} - self.fixed_without[path]:
                    if re.search(rf"\b{name}\b", errors):
                        self.fixed_without[path].add(name)
                        dropped = True
        return dropped

    def build(self):
        os.makedirs(self.folder, exist_ok=True)
        sources = [p for p in files_of(self.name) if not p.endswith(".hpp")]
        tests = [
            os.path.relpath(p, ROOT)
            for p in self.commands
            if p.startswith(f"{ROOT}/tests/{self.name}/")
        ]
        for _ in range(60):
            for path in self.found:
                self.write(path)
            with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
                results = list(pool.map(self.compile, sources))
            errors = "".join(r.stderr for r in results if r.returncode != 0)
            if not errors:
                break
            if not self.drop_what_fails(errors):
                fail("the planted sources do not compile:\n" + errors[:2000])
        else:
            fail(f"{self.name}: the planted sources do not compile")
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            for path, result in zip(tests, pool.map(self.compile, tests)):
                if result.returncode != 0:
                    fail(
                        f"{path} does not compile with the planted headers:\n{result.stderr[:2000]}"
                    )
        link = (
            subprocess.run(
                ["ninja", "-C", RELEASE, "-t", "commands", f"test_{self.name}"],
                capture_output=True,
                text=True,
                check=True,
            )
            .stdout.strip()
            .split("\n")[-1]
        )
        words = [w for w in shlex.split(link) if w not in (":", "&&") and not w.endswith(".o")]
        own = [self.object_of(p) for p in [*sources, *tests]]
        at = words.index("-o")
        self.program = os.path.join(self.folder, f"test_{self.name}")
        words[at + 1] = self.program
        words = [w for w in words if not w.endswith(f"libchangeover_{self.name}.a")]
        subprocess.run([*words[:at], *own, *words[at:]], cwd=RELEASE, check=True)

    # ---- Running
    # --------------------------------------------------------------------------------------------

    def commands_to_run(self):
        if not self.quick:
            return [[self.program, "--gtest_filter=-*Slow*"]]
        return [[self.program, f"--gtest_filter={':'.join(self.quick)}"],
                [self.program, f"--gtest_filter=-*Slow*:{':'.join(self.quick)}"]]

    def run(self, fault, seconds, **environment):
        """Whether a test failed, and how: '' if none did."""
        env = {**os.environ, "CHANGEOVER_CATALOG": "", "RC_PARAMS": "seed=1", **environment}
        if fault is not None:
            env["CHANGEOVER_FAULT"] = str(fault)

        for command in self.commands_to_run():
            first = self.quick and command[1] == f"--gtest_filter={':'.join(self.quick)}"
            allowed = SECONDS if first else seconds

            def limits(most=allowed):
                resource.setrlimit(resource.RLIMIT_CPU, (most, most + 1))
                resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
                resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

            try:
                done = subprocess.run(
                    [*command, "--gtest_fail_fast"],
                    env=env,
                    stdout=subprocess.PIPE,
                    stderr=subprocess.DEVNULL,
                    preexec_fn=limits,
                    timeout=60 * seconds,
                    text=True,
                    errors="replace",
                    cwd=self.folder,
                )
            except subprocess.TimeoutExpired:
                return "time"
            if fault is None:
                self.quick += cheapest(
                    re.findall(r"\[       OK \] (\S+) \((\d+) ms\)", done.stdout)
                )
            if done.returncode in (-24, -9):
                return "time"
            if done.returncode < 0:
                return "crash"
            if done.returncode != 0:
                failed = re.findall(r"\[  FAILED  \] (\S+)", done.stdout)
                return failed[0].rstrip(",") if failed else "failed"
        return ""

    def killed_before(self):
        """What the last run killed, by key."""
        path = os.path.join(self.folder, "results")
        if not self.again or not os.path.exists(path):
            return {}
        rows = (
            line.split("\t", 2) for line in open(path, encoding="utf-8").read().split("\n") if line
        )
        return {key: how for how, _, key in rows if how not in ("survived", "not reached")}

    def look(self):
        """@return {number: how it was killed}, '' for survivors, 'not reached' for what no test
        comes to."""
        reached_file = os.path.join(self.folder, "reached")
        if os.path.exists(reached_file):
            os.remove(reached_file)
        began = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        problem = self.run(None, 600, CHANGEOVER_FAULTS_REACHED=reached_file)
        if problem:
            fail(f"{self.name}: the tests fail without any fault: {problem}")
        took = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - began
        seconds = int(max(SECONDS, 4 * took))
        wanted = [f.number for f in self.faults if f.number not in self.without]
        reached = {int(n) for n in open(reached_file).read().split()}
        say(f"{self.name}: {len(wanted)} faults, {len(self.without)} more that are no program; "
            f"the tests take {took:.1f} s and reach {len(reached & set(wanted))}")
        results = {n: "not reached" for n in wanted}
        before = self.killed_before()
        results.update({n: before[self.keys[n]] for n in wanted if self.keys[n] in before})
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool, \
                open(os.path.join(self.folder, "results"), "w", encoding="utf-8") as out:
            for number in wanted:
                if results[number] != "not reached":
                    print(
                        f"{results[number]}\t{self.faults[number].line}\t{self.keys[number]}",
                        file=out,
                    )
            numbers = [n for n in wanted if n in reached and results[n] == "not reached"]
            for number, result in zip(numbers, pool.map(lambda n: self.run(n, seconds), numbers)):
                results[number] = result
                print(
                    f"{result or 'survived'}\t{self.faults[number].line}\t{self.keys[number]}",
                    file=out,
                    flush=True,
                )
        return results


def read_explained(path):
    """{fault: why it may survive}. A line of survivors.txt is "why" with the faults below it, each
    after two blanks."""
    out, why = {}, ""
    for line in open(path, encoding="utf-8").read().split("\n"):
        if line.startswith("  "):
            if not why:
                fail(f"{path}: a fault without a reason: {line.strip()}", 2)
            out[line.strip()] = why
        elif line and not line.startswith("#"):
            why = line
    return out


class Parser(argparse.ArgumentParser):
    """Its complaints are one line."""

    def error(self, message):
        fail(f"{message}; see ./dev mutate --help", 2)


def main():
    parser = Parser(prog="./dev mutate", description=__doc__.split("\n")[0])
    parser.add_argument("--list", action="store_true", help="write the faults, run nothing")
    parser.add_argument(
        "--again", action="store_true", help="only what survived the last run; tests only grew"
    )
    parser.add_argument("-j", type=int, default=2, metavar="N", help="runs at a time (default 2)")
    parser.add_argument(
        "--understood", action="store_true", help=argparse.SUPPRESS
    )  # do these words mean anything
    parser.add_argument(
        "what",
        nargs="*",
        metavar="ROOM|FILE",
        help=f"one of {', '.join(ROOMS)}, or a file of theirs",
    )
    asked = parser.parse_args()
    if asked.j < 1:
        parser.error(f"-j {asked.j}: at least one run at a time")
    rooms = {}
    for word in asked.what or ROOMS:
        room = word if word in ROOMS else next((r for r in ROOMS if word in files_of(r)), None)
        if room is None:
            fail(f"'{word}' is no room of {', '.join(ROOMS)} and no file of theirs", 2)
        rooms.setdefault(room, set())
        if word not in ROOMS:
            rooms[room].add(word)
    if asked.understood:
        return
    explained = read_explained(os.path.join(HERE, "survivors.txt"))
    Room.jobs, Room.again = asked.j, asked.again
    faults = 0
    table = []
    for name, only in rooms.items():
        if asked.list:
            write_list(name, only)
            continue
        room = Room(name, only)
        room.build()
        began = time.time()
        results = room.look()
        survivors = {n: how for n, how in results.items() if how in ("", "not reached")}
        names = {room.keys[n] for n in survivors}
        for number, how in survivors.items():
            if room.keys[number] not in explained:
                faults += 1
                print(f"{room.faults[number].path}:{room.faults[number].line}: "
                      f"{how or 'no test notices'}: {room.faults[number].how}")
        for key in explained:
            if key.split(" | ")[0] in room.found and key not in names:
                faults += 1
                print(f"survivors.txt: this does not survive: {key}")
        table.append((name, len(results), len(results) - len(survivors), len(survivors)))
        say(
            f"{name}: {len(results) - len(survivors)} of {len(results)} killed in "
            f"{time.time() - began:.0f} s"
        )
    for row in table:
        print("%-12s %5d faults %5d killed %4d survive" % row)
    if faults:
        fail(f"{faults} differ from tests/mutation/survivors.txt")


main()
