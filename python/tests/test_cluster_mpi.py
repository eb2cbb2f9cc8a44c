"""Runs under mpirun: every process makes the same call, process 0 leads."""

import itertools
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import mpi4py
except ImportError as fault:
    print(f"skipped: {fault}")
    sys.exit(77)

# Open MPI refuses to run as root, or with more processes than cores, unless told otherwise.
environment = {
    **os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}


def mpirun(processes, *command, **named):
    return subprocess.run(["mpirun", "-n", str(processes), *command], env=environment, text=True,
                          capture_output=True, timeout=120, **named)


try:
    starts = mpirun(4, "true").returncode == 0
except OSError:
    starts = False
if not starts:
    print("skipped: mpirun is not installed, or starts nothing here")
    sys.exit(77)

begin = """
import itertools, sys, time
import changeover
from changeover import cluster
from mpi4py import MPI
comm = MPI.COMM_WORLD
got = {}
def sink(i, j, result):
    assert (i, j) not in got and result == 1000 * i + j
    got[i, j] = result
def compute(i, j, a, b):
    time.sleep(0.002)
    return 1000 * a + b
def job(**named):
    return cluster.all_pairs(comm, **{**dict(items=24, room=6, load=lambda x: x, compute=compute,
                                             sink=sink), **named})
def say(*words):
    sys.stdout.write(" ".join(map(str, (comm.rank, *words))) + "\\n")
    sys.stdout.flush()
"""


class Mpi(unittest.TestCase):
    def run_program(self, program, processes=4, arguments=(), code=0):
        ended = mpirun(processes, sys.executable, "-c", begin + program, *arguments)
        self.assertEqual(ended.returncode == 0, code == 0, ended.stderr)
        lines = [line.split(" ", 1) for line in ended.stdout.splitlines()]
        return {int(rank): said for rank, said in lines}, ended.stderr

    def test_every_pair_comes_once(self):
        for processes in (1, 4):
            said, _ = self.run_program(
                "report = job(sizes=10)\n"
                "assert set(got) == (set(itertools.combinations(range(24), 2)) if comm.rank == 0 else set())\n"
                "assert report.loads <= 1.15 * report.planned_loads and report.most_held <= 6\n"
                "assert report.planned_bytes == 10 * report.planned_loads\n"
                "assert sum(each['pairs'] for each in report.workers) == 276\n"
                "say(report.pairs, len(report.workers), report.loads)\n", processes)
            self.assertEqual(len(said), processes)
            self.assertEqual(len(set(said.values())), 1, "all processes have the report")
            self.assertRegex(said[0], rf"^276 {processes} \d+$")

    def test_a_worker_holds_so_many_bytes(self):
        said, _ = self.run_program(
            "report = job(room=None, sizes=lambda x: 1 + x % 5, memory=20, overlap=True)\n"
            "assert len(got) == (276 if comm.rank == 0 else 0) and report.most_bytes <= 20\n"
            "assert report.bytes >= 3 * 24 - 4 and report.planned_bytes <= report.bytes\n"
            "say(report.pairs)\n")
        self.assertEqual(said[0], "276")

    def test_what_raises_ends_it_everywhere(self):
        said, _ = self.run_program(
            "def bad_compute(i, j, a, b):\n"
            "    if (i, j) == (2, 19): raise KeyError('nothing')\n"
            "    return compute(i, j, a, b)\n"
            "def bad_load(x): raise OSError('gone')\n"
            "told = []\n"
            "for named in (dict(compute=bad_compute), dict(load=bad_load), dict(room=1),\n"
            "              dict(sink=lambda *_: 1 / 0), dict(journal='/no/such/place')):\n"
            "    try: job(**named)\n"
            "    except Exception as fault: told.append(str(fault).split(' (on')[0])\n"
            "got.clear()\n"
            "job()\n"
            "say('; '.join(told))\n")
        self.assertEqual(len(said), 4)
        self.assertEqual(len(set(said.values())), 1)
        self.assertRegex(
            said[3],
            r"^compute\(2, 19\) raised KeyError: 'nothing'; load\(\d+\) raised "
            r"OSError: gone; room 1: .*; sink\(\d+, \d+\) raised ZeroDivisionError: "
            r"division by zero; /no/such/place: cannot open the journal: ",
        )

    def test_what_is_no_exception_ends_it_everywhere(self):
        """Ctrl-C, and sys.exit() in a function: no process waits for another for ever."""
        for rank in (0, 2):
            for what, says in (("sys.exit(5)", r"raised SystemExit: 5 \(on process"),
                               ("raise Own('x')", r"raised Own: x \(on process"),
                               ("os.kill(os.getpid(), signal.SIGINT); time.sleep(0.1)",
                                "KeyboardInterrupt")):
                with self.subTest(rank=rank, what=what):
                    said, _ = self.run_program(
                        "import os, signal\n"
                        "class Own(BaseException): pass\n"
                        "def bad_compute(i, j, a, b):\n"
                        f"    if comm.rank == {rank} and i + j > 8:\n"
                        f"        {what}\n"
                        "    return compute(i, j, a, b)\n"
                        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
                        "try: job(compute=bad_compute)\n"
                        "except BaseException as fault: say(type(fault).__name__, fault)\n", 3)
                    self.assertEqual(len(said), 3)
                    for each in said.values():
                        self.assertRegex(each, says)

    def test_a_killed_job_goes_on_with_other_processes(self):
        with tempfile.TemporaryDirectory() as folder:
            journal = os.path.join(folder, "journal")
            program = (
                "import os\n"
                "def die(i, j, result):\n"
                "    sink(i, j, result)\n"
                "    if len(got) == 100: os.kill(os.getpid(), 9)\n"
                "job(journal=sys.argv[1], sink=die)\n")
            self.run_program(program, 3, [journal], code=1)
            said, _ = self.run_program(
                "report = job(journal=sys.argv[1])\n"
                "say(report.resumed, report.pairs, len(got))\n",
                2,
                [journal],
            )
            self.assertEqual(said[0], "99 177 177")

    def test_searches_in_shares(self):
        said, _ = self.run_program(
            "all_of_it = cluster.classify(comm, 9, 4, 6, 2, 'circular')\n"
            "result = cluster.search(comm, 9, 5, 2, exact=True, cubes=16)\n"
            "say(all_of_it.complete, all_of_it.classes, result.b, result.minimum)\n")
        import changeover
        classes = changeover.classify(9, 4, 6, 2, "circular").classes
        self.assertEqual(set(said.values()), {f"True {classes} 6 True"})


if __name__ == "__main__":
    unittest.main()
