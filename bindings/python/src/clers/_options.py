"""What encoding can be asked for."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any, Callable, Dict, Iterable, Mapping, Optional, Tuple, Union


@dataclass(frozen=True)
class Precision:
    """How exactly the values of an attribute come back: made by the functions below."""

    kind: str = "lossless"
    bits: int = 0
    size: float = 0.0
    origin: Tuple[float, ...] = ()
    or_directions: bool = False


def lossless() -> Precision:
    """Bit for bit: what an attribute that is not named gets."""
    return Precision()


def bits(count: int) -> Precision:
    """One step for all components: the longest side of the bounding box has 2**count - 1 (1 to 30)."""
    return Precision("bits", bits=count)


def step(size: float) -> Precision:
    """Multiples of ``size``: the same grid for all meshes."""
    return Precision("step", size=size)


def error(size: float) -> Precision:
    """No component is off by more than ``size``."""
    return Precision("error", size=size)


def grid(origin: Iterable[float], step: float) -> Precision:
    """Points origin + k * step: meshes that share it share values, as tiles their border."""
    return Precision("grid", size=step, origin=tuple(float(x) for x in origin))


def directions(count: int) -> Precision:
    """The nearest of about 2**(2 * count) directions (2 to 20): for normals, three floats."""
    return Precision("directions", bits=count)


def recomputed(degrees: float) -> Precision:
    """Normals that follow from positions and faces where these are no more than so many degrees away; others
    within that."""
    return Precision("recomputed", size=degrees)


Precisions = Mapping[Union[str, Tuple[str, str]], Union[Precision, int]]
Progress = Callable[[str, float], None]


def native_options(*, level: int = 5, order: str = "free", precision: Optional[Precisions] = None,
                   piece_faces: Optional[int] = None, threads: int = 1, reject: Iterable[str] = (),
                   progress: Optional[Progress] = None) -> Dict[str, Any]:
    """The options of the C++ side."""
    if order not in ("free", "keep"):
        raise ValueError(f"order '{order}', expected free or keep")
    refused = [reject] if isinstance(reject, str) else list(reject)
    for defect in refused:
        if defect not in ("nonmanifold", "degenerate", "duplicate"):
            raise ValueError(f"reject '{defect}', expected nonmanifold, degenerate or duplicate")
    precisions = []
    for key, value in (precision or {}).items():
        name, domain = (key, None) if isinstance(key, str) else key
        precisions.append((name, domain, asdict(value if isinstance(value, Precision) else bits(value))))
    return {"level": level, "keep_order": order == "keep", "precisions": precisions, "piece_faces": piece_faces,
            "threads": threads, "progress": progress,
            **{"reject_" + defect: defect in refused for defect in ("nonmanifold", "degenerate", "duplicate")}}
