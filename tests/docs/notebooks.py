#!/usr/bin/python3
"""The notebooks of examples/notebooks: committed without results, listed, and they run from beginning to end.

usage: notebooks.py FOLDER     runs them with Debian's Jupyter; the notebooks with their results go into FOLDER;
                               ends with 77 (skipped) where there is none
       notebooks.py --check    only looks at the files
"""
import importlib.util
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "examples/notebooks").glob("*.ipynb"))


def faults_of(path):
    cells = json.loads(path.read_text())["cells"]
    code = [cell for cell in cells if cell["cell_type"] == "code"]
    faults = [f"{path.name}: a cell has results; clear them before committing" for cell in code if cell["outputs"] or cell["execution_count"] is not None]
    for number, cell in enumerate(code):
        try:
            compile("".join(cell["source"]), f"{path.name}, code cell {number}", "exec")
        except SyntaxError as error:
            faults.append(f"{path.name}: {error}")
    if not any("assert" in "".join(cell["source"]) for cell in code):
        faults.append(f"{path.name}: nothing in it is asserted, so running it tests nothing")
    return faults


def run(path, folder):
    """What nbconvert ended with and said; None if it came to no end. A notebook takes a minute, but Jupyter has waited for a kernel that had
    gone before the first cell, without end."""
    command = [sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--ExecutePreprocessor.timeout=300", "--output-dir", folder, path]
    with tempfile.TemporaryFile("w+") as words:
        running = subprocess.Popen(command, stdout=words, stderr=words, start_new_session=True)
        try:
            code = running.wait(timeout=480)
        except subprocess.TimeoutExpired:
            code = None
            os.killpg(running.pid, signal.SIGKILL)  # a kernel ends with its parent
            running.wait()
        words.seek(0)
        return code, words.read()[-3000:]


def main(arguments):
    if len(NOTEBOOKS) != 3:
        return f"examples/notebooks has {len(NOTEBOOKS)} notebooks, not three"
    faults = [fault for path in NOTEBOOKS for fault in faults_of(path)]
    if not faults and arguments != ["--check"]:
        if not all(map(importlib.util.find_spec, ("nbconvert", "ipykernel", "matplotlib"))):
            print("skipped: cmake/install-packages notebooks")
            return 77
        for path in NOTEBOOKS:
            code, said = run(path, arguments[0])
            if code is None:
                print(f"{path.name}: once more, since Jupyter stood still: {said}")
                code, said = run(path, arguments[0])
            if code != 0:
                faults.append(f"{path.name}: {said}")
                continue
            cells = json.loads((pathlib.Path(arguments[0]) / path.name).read_text())["cells"]
            for output in (output for cell in cells for output in cell.get("outputs", []) if output["output_type"] == "stream"):
                print(f"{path.name}: {''.join(output['text'])}", end="")
    return "\n".join(faults) or 0


sys.exit(main(sys.argv[1:]))
