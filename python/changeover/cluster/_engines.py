"""Which engine runs a task. Each is loaded when it is asked for: its package may not be there."""

from __future__ import annotations

from typing import Any, Optional

from ._engine import Engine, Task, kind_of


def engine_for(client: Any, task: Task, workers: Optional[int]) -> Engine:
    """Of Dask or Ray; processes of MPI lead or serve, see _mpi.py."""
    if kind_of(client) == "dask":
        from ._dask import DaskEngine
        return DaskEngine(client, task)
    from ._ray import RayEngine
    return RayEngine(client, task, workers)
