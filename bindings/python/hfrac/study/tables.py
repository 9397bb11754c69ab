# SPDX-License-Identifier: BSD-3-Clause
"""Tables of a study, as CSV and as Parquet."""
import csv
import io
import os
import pathlib
from typing import Any, Iterable, Sequence

from .parquet import parquet
from .pool import write_whole


def word(value: Any) -> str:
    """As exact as it is; what is not finite is left empty."""
    if isinstance(value, str):
        return value
    if value is None or value != value or value in (float("inf"), float("-inf")):
        return ""
    return repr(value.item() if hasattr(value, "item") else value)


def write_csv(path: pathlib.Path, names: Sequence[str], rows: Iterable[Sequence[Any]]) -> None:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(names)
    writer.writerows([[word(value) for value in row] for row in rows])
    write_whole(path, text.getvalue())


def write_parquet(path: pathlib.Path, names: Sequence[str], rows: Sequence[Sequence[Any]]) -> None:
    aside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    aside.write_bytes(parquet(names, rows))
    aside.replace(path)
