"""The one exception of this package."""

from __future__ import annotations

from typing import Any, Tuple


class Error(Exception):
    """Why the library refused something: what it was given, bytes that are no file, a limit.

    ``code``     its name, as in the C++ library: "inconsistent_mesh", "bad_option", "truncated", "invalid", "limit", ..
    ``place``    what ``at`` counts: "nowhere", "byte", "line", "face", "vertex", "edge", "mesh", "symbol", "corner"
    ``at``       byte offset, line (from 1) or element index
    ``what``     what is wrong, and what was expected
    ``limited``  for "limit": which limit, "meshes", "vertices", "faces" or "memory"
    ``needed``   for "limit": what it must be at least
    """

    def __init__(self, code: str, place: str, at: int, what: str, limited: str, needed: int, line: str) -> None:
        super().__init__(line)
        self.code, self.place, self.at, self.what = code, place, at, what
        self.limited, self.needed = limited, needed

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (self.code, self.place, self.at, self.what, self.limited, self.needed, self.args[0])


Error.__module__ = "clers"
