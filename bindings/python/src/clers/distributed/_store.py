"""What is finished, on a disk that all workers see, or in a folder of this process."""

from __future__ import annotations

import hashlib
import json
import os
from typing import Any, Dict, Optional

from .._api import replace


def digest_of(data: Any) -> str:
    return hashlib.sha256(data).hexdigest()


class Manifest:
    """Which outputs are finished, of which inputs: lines of JSON in a file that only grows. A line that was cut off
    by a crash is no entry."""

    def __init__(self, path: str, job: Dict[str, Any]) -> None:
        self._path = path
        self._entries: Dict[str, Dict[str, Any]] = {}
        head = {"job": job}
        lines = self._read()
        if lines and lines[0] == head:
            self._entries = {line["name"]: line for line in lines[1:] if "name" in line}
        text = [head, *self._entries.values()]
        replace(path, "".join(json.dumps(line, sort_keys=True) + "\n" for line in text).encode())

    def _read(self) -> Any:
        found = []
        if os.path.exists(self._path):
            with open(self._path, encoding="utf-8", errors="replace") as file:
                for line in file:
                    try:
                        found.append(json.loads(line))
                    except ValueError:
                        break
        return found

    def get(self, name: str) -> Optional[Dict[str, Any]]:
        return self._entries.get(name)

    def add(self, entry: Dict[str, Any]) -> None:
        self._entries[entry["name"]] = entry
        with open(self._path, "a", encoding="utf-8") as file:
            file.write(json.dumps(entry, sort_keys=True) + "\n")
            file.flush()
            os.fsync(file.fileno())
