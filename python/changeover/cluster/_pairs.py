"""all_pairs(): one call for every engine."""

from __future__ import annotations

import functools
import os
import time
from typing import Any, Callable, Dict, Iterable, List, Optional, SupportsIndex, Union

from .._given import Path
from .._made import Made, Progress, check_calls, count_of, fact, made
from .._pairs_given import memory_of
from ..errors import BadInput, MissingResource
from ._engine import Engine, Task, Tell, check_team, kind_of, tell_of
from ._engines import engine_for
from ._job import Wanted, Work, planned_bytes
from ._team import NoWorkers, Team
from ._worker import Memory

_progress_interval = 0.5
_most_stretches = 10_000


class Report(Made):
    """The result of a run on a cluster."""

    pairs: int = fact("That were computed and given to sink() by this run.")
    resumed: int = fact("Pairs that the journal of an earlier run had.")
    loads: int = fact("Calls of load(), as told by the workers; those of lost workers are not "
                      "known.")
    planned_loads: int = fact("Of the plan, if each worker does its own part.")
    lower_bound: Optional[int] = fact("One worker alone needs so many loads; None if there are "
                                      "several, or pairs were done before.")
    retried: int = fact("Stretches that were done again, after a worker was lost or a function "
                        "raised.")
    lost: int = fact("Workers that were lost.")
    stolen: int = fact("How often an idle worker took a part of another's work.")
    copied: int = fact("Stretches that an idle worker did too, as they were late.")
    stretches: int = fact("That were sent to workers.")
    bytes: Optional[int] = fact("That were loaded: by sizes, or as items say by nbytes; None if "
                                "unknown.")
    planned_bytes: Optional[int] = fact("Of planned_loads, by sizes.")
    most_held: int = fact("The most items that a worker had in memory.")
    most_bytes: Optional[int] = fact("The most bytes that a worker had in memory, by sizes.")
    seconds: float = fact()
    workers: List[Dict[str, Any]] = fact("A dict for each: worker, pairs, loads, busy (seconds).")

    def __repr__(self) -> str:
        of_plan = f"{count_of(self.loads, 'load')} (plan {self.planned_loads})"
        size = "" if self.bytes is None else f", {_size(self.bytes)}"
        resumed = f" + {self.resumed} resumed" if self.resumed else ""
        lost = f", {self.lost} lost, {self.retried} retried" if self.lost or self.retried else ""
        return (f"<cluster.Report: {count_of(self.pairs, 'pair')}{resumed} by "
                f"{count_of(len(self.workers), 'worker')}, "
                f"{of_plan}{size}{lost}, {self.seconds:.2f} s>")


def _size(count: int) -> str:
    size = float(count)
    for unit in ("bytes", "kB", "MB", "GB", "TB"):
        if size < 1000 or unit == "TB":
            break
        size /= 1000
    return f"{count} bytes" if unit == "bytes" else f"{size:.3g} {unit}"


class _Teller:
    """Calls progress now and then."""

    def __init__(self, progress: Tell, work: Work, clock: Callable[[], float]) -> None:
        self._progress, self._work, self._clock = progress, work, clock
        self._begin = self._last = clock()
        self.team: Optional[Team] = None

    def __call__(self, phase: str, now: bool = False) -> None:
        time_now = self._clock()
        if self._progress is None or not (now or time_now - self._last >= _progress_interval):
            return
        self._last = time_now
        work, team = self._work, self.team
        done = work.done.count - work.resumed
        elapsed = time_now - self._begin
        self._progress({
            "phase": phase, "steps": work.done.count, "of": work.wanted.count, "unit": "pairs",
            "loads": team.loads if team else 0,
            "planned_loads": team.planned_loads if team else 0,
            "workers": len(team.members) if team else 0, "retried": team.retried if team else 0,
            "elapsed": elapsed, "left": elapsed * work.left / done if done else None})


def _run_job(engine: Engine, work: Work, stretches: int, progress: Tell) -> Dict[str, Any]:
    """The facts of the report. The engine is always closed."""
    begin = time.monotonic()
    teller = _Teller(progress, work, time.monotonic)
    bound: Optional[int] = None
    size = work.wanted.size
    bytes_planned = None if size is None else 0
    team = Team(engine, work.deliver, work.replan, work.again, stretches, teller, size)
    teller.team = team
    try:
        if work.left:
            workers = engine.workers()
            if not workers:
                raise MissingResource("there are no workers; start some, and wait for them: with "
                                      "Dask client.wait_for_workers(1)")
            teller("planning")
            shares, least = work.first_shares(len(workers))
            bound = least or None
            runs = [run for share in shares for run in share]
            team.planned_loads = sum(run.loads for run in runs)
            if size is not None:
                bytes_planned = planned_bytes(runs, size)
            try:
                team.run(shares, lambda: work.left == 0)
            except NoWorkers as fault:
                raise MissingResource(
                    f"{fault}; {work.done.count} of {work.wanted.count} pairs are done") from fault
    finally:
        engine.close()
        work.close()
    teller("done", now=True)
    members = {**team.gone, **team.members}
    return {
        "pairs": work.done.count - work.resumed, "resumed": work.resumed, "loads": team.loads,
        "planned_loads": team.planned_loads, "lower_bound": bound, "retried": team.retried,
        "lost": team.lost, "stolen": team.stolen, "copied": team.copied, "stretches": team.sent,
        "bytes": team.bytes_loaded, "planned_bytes": bytes_planned, "most_held": team.most_held,
        "most_bytes": None if size is None else team.most_bytes,
        "seconds": time.monotonic() - begin,
        "workers": [{"worker": name, "pairs": each.pairs, "loads": each.loads, "busy": each.busy}
                    for name, each in sorted(members.items())]}


def all_pairs(
    client: Any, *, load: Callable[[int], Any], compute: Callable[[int, int, Any, Any], Any],
    room: Optional[int] = None,
    sink: Optional[Callable[[int, int, Any], Any]] = None, items: Optional[int] = None,
    pairs: Optional[Iterable[Iterable[SupportsIndex]]] = None,
    groups: Optional[Iterable[Iterable[SupportsIndex]]] = None, against: Optional[int] = None,
    done_items: Optional[int] = None, with_self: bool = False,
    cost: Union[None, Callable[[int, int], float], Iterable[float]] = None,
    sizes: Union[None, int, Iterable[int], Callable[[int], int]] = None,
    memory: Union[int, str, None] = None, threads: Optional[int] = None, overlap: bool = False,
    stretches: int = 16, retries: int = 0, workers: Optional[int] = None, journal: Optional[Path] = "",
    name: str = "", progress: Progress = None,
) -> Report:
    """Computes every pair of items on the workers of a cluster, each with room for `room` items or
    `memory` bytes of them.

    client: a distributed.Client; an mpi4py communicator, whose processes all make this call; or the
    module ray. load(i) returns item i; compute(i, j, first, second) returns a result for i < j;
    both run on workers. sink(i, j, result) runs here and receives each pair once, in no particular
    order.

    items, pairs, groups, against, done_items: as in load_order(). with_self: also each item with
    itself, compute(i, i, item, item); rows (i, i) of `pairs` request this for one item. cost: a
    function cost(i, j), or a number for each row of pairs: parts are cut by cost instead of by the
    number of pairs. sizes: bytes of items, a number, a list or a function; with memory a worker
    holds at most that many bytes, otherwise they are for the report.

    threads: of each worker, for load() and compute(); None: as many as Dask reports, otherwise 1.
    overlap: loads run while pairs are computed, in one of the `room` places, or in the bytes of the
    largest item. stretches: the number of parts into which the work of each worker is cut; a worker
    has one at a time, and the part of a lost worker is done again. retries: how often load() or
    compute() may raise for an item or a pair before the run ends. workers: with Ray, the number of
    actors; None: one per processor.

    journal: a file that records the pairs that sink() received; the same job continues from it,
    with any number of workers. name: of the job, if its items and pairs do not identify it.

    Workers may be lost, or join, during the run. An exception of load(), compute() or sink() ends
    the run with Failed, which names the item or the pair. Raises BadInput; MissingResource if there
    are no workers, or none are left for 5 minutes. Ctrl-C ends it with KeyboardInterrupt; a journal
    allows continuing.
    """
    held = memory_of("memory", memory)
    engine_kind = kind_of(client)
    if not 1 <= stretches <= _most_stretches:
        raise BadInput(f"stretches is a number from 1 to {_most_stretches}")
    check_team(threads, workers)
    task = Task(functools.partial(Memory, load, compute),
                {"room": room, "memory": held, "overlap": overlap}, threads)
    if engine_kind == "mpi" and client.rank != 0:
        from ._mpi import serve
        return made(Report, serve(client, task))

    def begin() -> Work:
        wanted = Wanted(items, room, pairs, against, done_items, with_self, cost, groups=groups,
                        sizes=sizes, memory=held, overlap=overlap)
        return Work(wanted, sink, retries, os.fsdecode(journal or ""), name)

    if engine_kind == "mpi":
        from ._mpi import MpiEngine
        with MpiEngine(client, task) as mpi:
            work = begin()
            facts = _run_job(mpi, work, stretches, tell_of(progress))
            mpi.tell_all(facts)
            return made(Report, facts)
    work = begin()
    try:
        engine = engine_for(client, task, workers)
    except BaseException:
        work.close()
        raise
    return made(Report, _run_job(engine, work, stretches, tell_of(progress)))


check_calls(globals())
