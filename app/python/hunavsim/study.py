"""Studies: many runs in parallel processes, and their results."""

import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from ._hunavsim import ScenarioError, _rows, compare


class Results:
    """The rows of a study in the order of its runs.

    Each row is a dict: `run`, `scenario`, `seed`, the varied values by their path, `ok`, `reason`,
    and the metrics by key (None: undefined).
    """

    def __init__(self, rows, paths=()):
        self.rows = list(rows)
        self.paths = list(paths)  # of the varied values

    def __len__(self):
        return len(self.rows)

    def __iter__(self):
        return iter(self.rows)

    @property
    def columns(self):
        """Names of all columns in the order of their first occurrence."""
        return list(dict.fromkeys(key for row in self.rows for key in row))

    def where(self, **values):
        """The rows with these values; a dot in a path is written as `__`:
        where(robot1__planner="dwa")."""
        wanted = {key.replace("__", "."): value for key, value in values.items()}
        return Results((row for row in self.rows
                        if all(row.get(key) == value for key, value in wanted.items())),
                       self.paths)

    def values(self, column):
        """The defined values of a column, as floats; truth values are 0 and 1."""
        return [float(row[column]) for row in self.rows if row.get(column) is not None]

    def array(self):
        """A structured numpy array: floats (NaN: undefined), and text for other columns."""
        import numpy

        def is_number(column):
            return all(isinstance(row.get(column), (int, float, bool, type(None)))
                       for row in self.rows)

        columns = self.columns
        numeric = {column: is_number(column) for column in columns}
        types = [(column, "f8" if numeric[column] else "U64") for column in columns]
        array = numpy.zeros(len(self.rows), dtype=types)
        for column in columns:
            missing = float("nan") if numeric[column] else ""
            array[column] = [missing if row.get(column) is None else row[column]
                             for row in self.rows]
        return array

    def frame(self):
        """A pandas DataFrame; needs pandas."""
        import pandas
        return pandas.DataFrame(self.rows, columns=self.columns)

    def compare(self, column, by, first, second, level=0.95):
        """Compares two values of the column `by` in the metric `column`, paired by scenario, seed
        and all other varied values: shift of first - second, interval, p value, number of pairs.
        """
        others = ["scenario", "seed"] + [path for path in self.paths if path != by]
        pairs = {}
        for row in self.rows:
            if row.get(by) in (first, second) and row.get(column) is not None:
                key = tuple(row.get(name) for name in others)
                pairs.setdefault(key, {})[row[by]] = float(row[column])
        complete = [pair for pair in pairs.values() if len(pair) == 2]
        return compare([pair[first] for pair in complete], [pair[second] for pair in complete],
                       level)


def program():
    """Path of the program `hunavsim`: the environment variable HUNAVSIM, otherwise the one in PATH."""
    found = os.environ.get("HUNAVSIM") or shutil.which("hunavsim")
    if not found:
        raise FileNotFoundError("the program hunavsim is not in PATH; set HUNAVSIM to its path")
    return found


def study(experiment, output, *, jobs=None, resume=False, allow_code=False, progress=None):
    """Runs an experiment in parallel processes and returns its Results.

    experiment: path of an experiment file, or a dict with its keys (written to `output`).
    output: folder for the results. progress: called as progress(finished, runs) after each run;
    returning False stops the study, which `resume=True` continues.
    """
    output = Path(output)
    if isinstance(experiment, dict):
        output.mkdir(parents=True, exist_ok=True)
        file = output.with_name(output.name + ".experiment.yaml")
        file.write_text(json.dumps({"hunavsim_experiment": 1, **experiment}, indent=1) + "\n")
        experiment = file
    words = [program(), "batch", str(experiment), "-o", str(output), "--rows", "--quiet"]
    words += ["--jobs", str(jobs)] if jobs else []
    words += ["--resume"] if resume else []
    words += ["--allow-code"] if allow_code else []
    with tempfile.TemporaryFile("w+") as told, subprocess.Popen(
            words, stdout=subprocess.PIPE, stderr=told, text=True) as process:
        stopped = _follow(process, progress)
        process.wait()
        told.seek(0)
        errors = told.read()
    if process.returncode not in (0, 1) and not stopped:
        raise ScenarioError(errors.strip() or f"hunavsim ended with {process.returncode}")
    return load_results(output)


def _follow(process, progress):
    """Reports each finished run; True: the caller wants to stop."""
    runs = finished = 0
    for line in process.stdout:
        row = json.loads(line)
        if "runs" in row:
            runs = row["runs"]
            continue
        finished += 1
        if progress is not None and progress(finished, runs) is False:
            process.terminate()
            return True
    return False


def load_results(folder):
    """The results of a study in a folder."""
    paths, rows = _rows(str(Path(folder) / "results.sqlite"))
    return Results(rows, paths)
