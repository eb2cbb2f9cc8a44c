#!/usr/bin/python3
"""All pairs on a Dask cluster of this machine, against Dask's own graph of the same job, in one
run.

usage: PYTHONPATH=build/release/python bench/cluster_bench.py [bytes] [straggler] [kills]
[simulated] [scale]

bytes      32 items of 8 MiB in files, two workers that may take 260 MB each: a graph of one task
           for each load and for each pair, and changeover.cluster.all_pairs() with room for 8 items
straggler  one worker of two takes ten times as long for a pair: shares that stay as they are, and
           shares that are stolen
kills      a hundred workers are killed (python/tests/test_cluster_kills_Slow.py)
simulated  what simulate() says of jobs, and what Dask takes for them
scale      simulate(): 1,000,000 items on 10,000 workers
"""

import logging
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import dask
import numpy
from distributed import Client, LocalCluster, get_worker, wait

from changeover import cluster
from changeover.cluster import _team

root = pathlib.Path(__file__).resolve().parent.parent
item_bytes = 8 << 20


def workers_of(count, memory="auto", **named):
    return LocalCluster(
        n_workers=count,
        threads_per_worker=1,
        dashboard_address=None,
        memory_limit=memory,
        silence_logs=logging.CRITICAL,
        **named,
    )


def read(folder, x):
    return numpy.fromfile(f"{folder}/{x}", numpy.float32)


def product(_i, _j, first, second):
    return float(first[:100_000] @ second[:100_000])


def moved(client):
    """Bytes that the worker processes have read from files and written to files: items, and what
    they spilled."""
    def of_process():
        with open("/proc/self/io") as file:
            counts = dict(line.split(":") for line in file)
        return int(counts["rchar"]), int(counts["wchar"])
    counts = client.run(of_process).values()
    return numpy.array([sum(each[0] for each in counts), sum(each[1] for each in counts)])


def by_graph(client, folder, items):
    loads = [dask.delayed(read, pure=False)(folder, x) for x in range(items)]
    pairs = [
        dask.delayed(product, pure=False)(i, j, loads[i], loads[j])
        for i in range(items)
        for j in range(i + 1, items)
    ]
    return sum(client.gather(client.compute(pairs)))


def by_stretches(client, folder, items):
    total = []
    report = cluster.all_pairs(
        client,
        items=items,
        room=8,
        load=lambda x: read(folder, x),
        compute=product,
        sink=lambda i, j, result: total.append(result),
        sizes=item_bytes,
    )
    return sum(total), report


def bench_bytes():
    items = 32
    with tempfile.TemporaryDirectory() as folder:
        rng = numpy.random.default_rng(1)
        for x in range(items):
            rng.standard_normal(item_bytes // 4, numpy.float32).tofile(f"{folder}/{x}")
        rows = []
        for name in ("graph", "stretches") * 2:
            # Each time with new workers, whose memory is as it was.
            with workers_of(2, 260_000_000, local_directory=folder) as workers, Client(
                workers
            ) as client:
                wait(client.map(lambda x: x, range(10), pure=False))
                before, begin = moved(client), time.perf_counter()
                if name == "graph":
                    total, loads = by_graph(client, folder, items), None
                else:
                    total, report = by_stretches(client, folder, items)
                    loads = f"{report.loads} loads, plan {report.planned_loads}"
                seconds = time.perf_counter() - begin
                counts = moved(client) - before
            rows.append((name, *counts, seconds, total))
            print(
                f"{name}: {counts[0] / 1e9:.2f} GB read, {counts[1] / 1e9:.2f} GB written, "
                f"{seconds:.1f} s; {loads or ''}",
                flush=True,
            )
        assert max(row[4] for row in rows) - min(row[4] for row in rows) < 1e-3 * abs(rows[0][4])

        def mean(name, column):
            return statistics.mean(row[column] for row in rows if row[0] == name)
        both = [mean(name, 1) + mean(name, 2) for name in ("graph", "stretches")]
        print(
            f"graph / ours: bytes read {mean('graph', 1) / mean('stretches', 1):.1f}, read and "
            f"written {both[0] / both[1]:.1f}, "
            f"seconds {mean('graph', 3) / mean('stretches', 3):.1f}"
        )


def bench_straggler():
    with workers_of(2) as workers, Client(workers) as client:
        slow = sorted(client.nthreads())[0]

        def compute(_i, _j, _first, _second):
            time.sleep(0.02 if get_worker().address == slow else 0.002)

        def seconds():
            begin = time.perf_counter()
            report = cluster.all_pairs(
                client, items=32, room=8, load=lambda x: time.sleep(0.005), compute=compute
            )
            return time.perf_counter() - begin, report

        taken = {"static": [], "stolen": []}
        steal, copies = _team.Team._steal, _team.Team._copy
        for _ in range(3):
            _team.Team._steal, _team.Team._copy = lambda *_: False, lambda *_: None
            taken["static"].append(seconds()[0])
            _team.Team._steal, _team.Team._copy = steal, copies
            each, report = seconds()
            taken["stolen"].append(each)
        static, stolen = (statistics.median(each) for each in taken.values())
        print(
            f"straggler: shares that stay {static:.1f} s, stolen {stolen:.1f} s, ratio "
            f"{static / stolen:.1f}; {report}"
        )


def bench_simulated():
    print(
        "| items | room | workers | a load, ms | a pair, ms | overlap | loads | simulated loads | "
        "s | simulated s | ratio |"
    )
    print("|---:|---:|---:|---:|---:|:---|---:|---:|---:|---:|---:|")
    for count in (1, 2, 4):
        with workers_of(count) as workers, Client(workers) as client:
            for items, room, load, pair, overlap in (
                (32, 8, 0.02, 0.004, False),
                (32, 8, 0.02, 0.004, True),
                (60, 12, 0.01, 0.005, False),
                (40, 10, 0.05, 0.001, False),
            ):

                def read_item(_x, load=load):
                    time.sleep(load)

                def compute(_i, _j, _first, _second, pair=pair):
                    time.sleep(pair)
                begin = time.perf_counter()
                report = cluster.all_pairs(
                    client, items=items, room=room, load=read_item, compute=compute, overlap=overlap
                )
                seconds = time.perf_counter() - begin
                said = cluster.simulate(
                    items=items,
                    room=room,
                    workers=count,
                    pair_seconds=pair,
                    item_bytes=1,
                    latency=load,
                    overlap=overlap,
                    overhead=0.02,
                )
                print(
                    f"| {items} | {room} | {count} | {1000 * load:.0f} | {1000 * pair:.0f} | "
                    f"{'yes' if overlap else ''} | {report.loads} | "
                    f"{said.loads} | {seconds:.2f} | {said.seconds:.2f} | "
                    f"{said.seconds / seconds:.2f} |",
                    flush=True,
                )


def bench_scale():
    for named in ({}, {"store": 1e12}, {"store": 1e12, "failures": 0.01, "stragglers": 0.02}):
        for room in (10_000, 100_000):
            begin = time.perf_counter()
            said = cluster.simulate(
                items=1_000_000,
                room=room,
                workers=10_000,
                pair_seconds=1e-5,
                item_bytes=10**6,
                **named,
            )
            print(
                f"{named} room {room}: {said}; planned {said.planned_loads} loads, computing "
                f"{said.computing:.1%}, loading "
                f"{said.loading:.1%}, waiting {said.waiting:.1%}, stolen {said.stolen}, retried "
                f"{said.retried}; simulated in "
                f"{time.perf_counter() - begin:.1f} s",
                flush=True,
            )


def bench_kills():
    subprocess.run([sys.executable, root / "python/tests/test_cluster_kills_Slow.py"], check=True)


if __name__ == "__main__":
    for each in sys.argv[1:] or ["bytes", "straggler", "simulated", "scale"]:
        globals()[f"bench_{each}"]()
