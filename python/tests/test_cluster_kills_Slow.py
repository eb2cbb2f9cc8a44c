"""A hundred workers of a Dask cluster are killed, at any time; every pair still comes once."""

import itertools
import logging
import os
import random
import subprocess
import sys
import tempfile
import threading
import time
import unittest

try:
    from distributed import Client, LocalCluster
except ImportError as fault:
    print(f"skipped: {fault}")
    sys.exit(77)

from changeover import cluster

kills_wanted = int(os.environ.get("CHANGEOVER_KILLS", 100))


def load(x):
    time.sleep(0.002)
    return x


def compute(i, j, first, second):
    time.sleep(0.002)
    return 1000 * first + second


class Workers:
    """Worker processes without a nanny; a killed one is replaced."""

    def __init__(self, address, folder):
        self.command = [sys.executable, "-m", "distributed.cli.dask_worker", address, "--no-nanny",
                        "--nthreads", "1", "--no-dashboard", "--local-directory", folder]
        self.running = []

    def start(self):
        self.running.append(subprocess.Popen(self.command, stderr=subprocess.DEVNULL))

    def kill(self, process):
        process.kill()
        process.wait()
        self.running.remove(process)

    def close(self):
        for process in list(self.running):
            self.kill(process)


class Kills(unittest.TestCase):
    def test_every_pair_comes_once(self):
        rng = random.Random(1)
        killed = lost = retried = runs = 0
        every = set(itertools.combinations(range(48), 2))
        with tempfile.TemporaryDirectory() as folder, LocalCluster(
                n_workers=0, dashboard_address=None, silence_logs=logging.CRITICAL
        ) as scheduler, Client(scheduler) as client:
            workers = Workers(scheduler.scheduler_address, folder)
            for _ in range(3):
                workers.start()
            while killed < kills_wanted:
                over = threading.Event()

                def kill():
                    nonlocal killed
                    while not over.wait(rng.uniform(0.02, 1.0)) and killed < kills_wanted:
                        there = client.run(os.getpid, on_error="ignore").values()
                        known = [each for each in workers.running if each.pid in there]
                        if known:
                            workers.kill(rng.choice(known))
                            workers.start()
                            killed += 1

                got = {}

                def sink(i, j, result):
                    self.assertNotIn((i, j), got)
                    self.assertEqual(result, 1000 * i + j)
                    got[i, j] = result

                client.wait_for_workers(1)
                killer = threading.Thread(target=kill)
                killer.start()
                try:
                    report = cluster.all_pairs(client, items=48, room=10, load=load,
                                               compute=compute, sink=sink)
                finally:
                    over.set()
                    killer.join()
                self.assertEqual(set(got), every)
                self.assertLessEqual(report.most_held, 10)
                lost, retried, runs = lost + report.lost, retried + report.retried, runs + 1
            workers.close()
        print(f"{killed} workers killed in {runs} runs: {lost} lost while they ran, {retried} "
              f"stretches done again, {runs * len(every)} pairs, each once")
        self.assertGreater(lost, kills_wanted / 2)


if __name__ == "__main__":
    unittest.main()
