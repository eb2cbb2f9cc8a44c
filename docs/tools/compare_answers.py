#!/usr/bin/env python3
"""Compares the answers of two builds over many seeded questions.

    docs/tools/compare_answers.py record build/release old.json    # before a change of structure
    docs/tools/compare_answers.py record build/release new.json    # after it
    docs/tools/compare_answers.py compare old.json new.json        # prints each answer that differs

A question (answers_questions.py) is a command line, a request to the server or a call from Python,
made from a seed (--seed, default 1). No question has a limit of time, so a question has the same
answer on every machine. An answer is an exit code, what was written to standard output and standard
error, and the files that were written (compressed ones by their checksum). Two recordings are equal
only if the questions are: record both with the same version of this program.
`compare` ends with 1 if any answer differs.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.error
import urllib.request

from answers_questions import Questions

PATIENCE = 120  # seconds for one question

ENVIRONMENT = {
    **os.environ,
    "CHANGEOVER_CATALOG": "",
    "NO_COLOR": "1",
    "COLUMNS": "100",
    "LC_ALL": "C.UTF-8",
}


def content(path):
    data = path.read_bytes()
    if data[:2] == b"PK":  # the parts of a workbook, without the time of writing
        import zipfile

        with zipfile.ZipFile(path) as book:
            parts = {
                name: book.read(name) for name in sorted(book.namelist()) if "docProps" not in name
            }
        return {name: hashlib.sha256(text).hexdigest() for name, text in parts.items()}
    return text_of(data)


def text_of(data):
    text = re.sub(
        r"\b\d+\.\d+ s\b|\"seconds\":[0-9.e-]+", "…", data.decode("utf-8", "surrogateescape")
    )  # how long a proof took
    if len(text) > 20000:
        checksum = hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()
        return f"{text[:2000]} … {len(text)} characters, {checksum}"
    return text.encode("utf-8", "backslashreplace").decode()


def answer_line(program, files, words):
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        for name in words:
            if name in files:
                (place / name).write_bytes(files[name].encode())
        before = set(os.listdir(folder))
        try:
            done = subprocess.run(
                [program, *words],
                cwd=folder,
                env=ENVIRONMENT,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                timeout=PATIENCE,
            )
        except subprocess.TimeoutExpired:
            return {"code": "no end"}
        written = {name: content(place / name) for name in sorted(set(os.listdir(folder)) - before)}
        return {"code": done.returncode, "out": text_of(done.stdout),
                "err": text_of(done.stderr), "files": written}


def answers_of_server(program, requests):
    with tempfile.TemporaryDirectory() as folder:
        server = subprocess.Popen(
            [program, "serve", "--port", "0"],
            cwd=folder,
            env=ENVIRONMENT,
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )
        try:
            address = server.stdout.readline().strip()
            base, _, token = address.partition("/?")
            base = base.rstrip("/") + "/"
            found = {}
            for method, path, body in requests:
                request = urllib.request.Request(
                    base + path, method=method, data=None if body is None else body.encode()
                )
                if body is not None:
                    request.add_header(
                        "Content-Type", "text/plain" if path == "api/verify" else "application/json"
                    )
                try:
                    with urllib.request.urlopen(request, timeout=PATIENCE) as got:
                        code, text = got.status, got.read()
                except urllib.error.HTTPError as refused:
                    code, text = refused.code, refused.read()
                found[f"{method} {path} {body or ''}"] = {"code": code, "out": text_of(text)}
            return found
        finally:
            server.terminate()
            server.wait(30)


PYTHON = """
import json, sys
import changeover as c
for call in json.load(sys.stdin):
    try:
        said = repr(eval(call))
    except Exception as fault:
        said = type(fault).__name__ + ": " + str(fault)
    print(json.dumps(said), flush=True)
"""


def answers_of_python(build, calls):
    done = subprocess.run(
        ["/usr/bin/python3", "-c", PYTHON],
        input=json.dumps(calls),
        text=True,
        capture_output=True,
        env={**ENVIRONMENT, "PYTHONPATH": str(build / "python")},
        timeout=20 * PATIENCE,
    )
    said = [json.loads(line) for line in done.stdout.splitlines()]
    return dict(
        zip((f"python {call}" for call in calls), said + [done.stderr] * (len(calls) - len(said)))
    )


def record(build, path, seed):
    build = pathlib.Path(build).resolve()
    program = str(build / "changeover")
    questions = Questions(seed)
    answers = {}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [
            pool.submit(answer_line, program, questions.files, words) for words in questions.lines
        ]
        for words, job in zip(questions.lines, jobs):
            answers["changeover " + " ".join(words)] = job.result()
    answers.update(answers_of_server(program, questions.requests))
    answers.update(answers_of_python(build, questions.calls))
    pathlib.Path(path).write_text(
        json.dumps(answers, indent=1, ensure_ascii=False), encoding="utf-8"
    )
    print(f"{len(answers)} answers in {path}")


def compare(old, new):
    first, second = (
        json.loads(pathlib.Path(path).read_text(encoding="utf-8")) for path in (old, new)
    )
    different = [question for question in first if first[question] != second.get(question)]
    for question in different:
        print(f"== {question!r}\n-- {first[question]!r:.1500}\n++ {second.get(question)!r:.1500}")
    only = len(set(second) - set(first))
    print(f"{len(first)} answers, {len(different)} differ, {only} only in {new}")
    return 1 if different or only else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    verbs = parser.add_subparsers(dest="verb", required=True)
    one = verbs.add_parser("record", help="ask a build and write its answers")
    one.add_argument("build", help="folder with the program changeover and the folder python")
    one.add_argument("file")
    one.add_argument("--seed", type=int, default=1)
    two = verbs.add_parser("compare", help="print the answers that differ")
    two.add_argument("old")
    two.add_argument("new")
    given = parser.parse_args()
    if given.verb == "record":
        record(given.build, given.file, given.seed)
        return 0
    return compare(given.old, given.new)


if __name__ == "__main__":
    sys.exit(main())
