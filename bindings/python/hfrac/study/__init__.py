# SPDX-License-Identifier: BSD-3-Clause
"""Studies: many runs of one case with other values, and what follows from them together.

    hfrac sweep study.toml -o out/study     runs, table, percentiles, charts, Sobol indices
    hfrac match study.toml -o out/match     parameters that explain a record

A study is a file (study_file.py). Its values come from laws (laws.py) by a design (designs.py); each run is a run folder of the
command (cases.py, pool.py), and everything else is read back from those folders. Needs Python 3.11, numpy and scipy; charts
need matplotlib.
"""
