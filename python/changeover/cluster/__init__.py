"""Jobs on existing clusters: all pairs out of core on Dask, MPI or Ray, and searches in shares on
the same clients.

    report = changeover.cluster.all_pairs(
        client, items=1000, room=100, load=read_image, compute=match, sink=store)

Workers import this package, so it must be installed on them.
"""

from ._failed import Failed
from ._pairs import Report, all_pairs
from ._searches import Improvement, classify, improve, search
from ._simulation import Simulation, simulate

__all__ = ["Failed", "Improvement", "Report", "Simulation", "all_pairs", "classify", "improve",
           "search", "simulate"]
