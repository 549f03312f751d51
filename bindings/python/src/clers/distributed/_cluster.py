"""Workers: of a cluster that runs, or of this machine; and results as they come."""

from __future__ import annotations

import contextlib
import os
import sys
import warnings
from typing import Any, Callable, Iterable, Iterator, List, Optional, Tuple, Union

from distributed import Client, LocalCluster, as_completed

Scheduler = Union[str, Client, None]


@contextlib.contextmanager
def connect(scheduler: Scheduler = None, workers: Optional[int] = None) -> Iterator[Client]:
    """A client of a scheduler: of its address, of one that is given, or of a local cluster of ``workers``
    processes, one a core if None, which ends with the block. A worker has one thread: threads of one mesh share
    less work than meshes do."""
    if isinstance(scheduler, Client):
        yield scheduler
    elif scheduler is not None:
        with Client(scheduler) as client:
            yield client
    else:
        with LocalCluster(n_workers=workers or os.cpu_count() or 1, threads_per_worker=1, processes=True,
                          dashboard_address=None) as cluster, Client(cluster) as client:
            yield client


class Bar:
    """A line on a terminal, or nothing."""

    def __init__(self, shown: Optional[bool], total: int) -> None:
        self._shown = sys.stderr.isatty() if shown is None else shown
        self._total = total

    def show(self, done: int, what: str) -> None:
        if not self._shown:
            return
        width = 30
        full = width * done // max(self._total, 1)
        sys.stderr.write(f"\r[{'#' * full}{'.' * (width - full)}] {done}/{self._total} {what}")
        if done == self._total:
            sys.stderr.write("\n")
        sys.stderr.flush()


def run(client: Client, work: Callable[..., Any], jobs: Iterable[Tuple[Any, ...]], most: int) -> Iterator[Any]:
    """Results of work(*job), as they come. No more than ``most`` jobs are handed out at a time, so that neither
    the scheduler nor this process holds what waits. A job whose worker dies is done by another."""
    waiting = iter(jobs)
    started = as_completed([])

    def start() -> bool:
        for job in waiting:
            with warnings.catch_warnings():
                # Dask would have them scattered; but what was scattered to a worker dies with it.
                warnings.filterwarnings("ignore", message="Large object")
                started.add(client.submit(work, *job, pure=False))
            return True
        return False

    while most > 0 and start():
        most -= 1
    for future in started:
        yield future.result()
        future.release()
        start()


def threads_of(client: Client) -> int:
    """How many jobs the workers do at a time; at least 1."""
    found: List[int] = list(client.nthreads().values())
    return max(sum(found), 1)
