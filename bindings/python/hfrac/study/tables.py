# SPDX-License-Identifier: BSD-3-Clause
"""Tables of a study: CSV always, Parquet where pandas has an engine for it (pyarrow or fastparquet)."""
import csv
import importlib.util
import io
import pathlib
from typing import Any, Dict, Iterable, List, Sequence

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


def write_parquet(path: pathlib.Path, names: Sequence[str], rows: List[Sequence[Any]]) -> bool:
    """False: there is nothing here that writes Parquet."""
    if not importlib.util.find_spec("pandas") or not any(map(importlib.util.find_spec, ("pyarrow", "fastparquet"))):
        return False
    import pandas

    columns: Dict[str, List[Any]] = {name: [row[k] for row in rows] for k, name in enumerate(names)}
    pandas.DataFrame(columns).to_parquet(path, index=False)
    return True
