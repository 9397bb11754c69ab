# SPDX-License-Identifier: BSD-3-Clause
"""The command line of studies. `hfrac sweep` and `hfrac match` start it; by hand: python3 -m hfrac.study sweep study.toml.

Exit codes are the command's: 0 good (failed runs are told and are part of the result), 1 nothing came of it, 2 wrong usage or
study file, 130 interrupted.
"""
import sys

GOOD, FAILED, BAD_INPUT, INTERRUPTED = 0, 1, 2, 130


def main() -> int:
    if sys.version_info < (3, 11):
        print(f"hfrac: studies need Python 3.11 or newer, and this is {sys.version.split()[0]} ({sys.executable})", file=sys.stderr)
        return FAILED
    try:
        import numpy  # noqa: F401
        import scipy  # noqa: F401
    except ImportError as error:
        print(f"hfrac: studies need numpy and scipy for {sys.executable}: apt-get install python3-scipy ({error})", file=sys.stderr)
        return FAILED
    from ..errors import HfracError
    from .command import carry_out
    from .study_file import StudyError

    try:
        return carry_out(sys.argv[1:])
    except StudyError as error:
        print(f"hfrac: {error} (docs/studies.md#{error.heading})", file=sys.stderr)
        return BAD_INPUT
    except HfracError as error:
        print(f"hfrac: {error}", file=sys.stderr)
        return FAILED
    except OSError as error:
        print(f"hfrac: {error}", file=sys.stderr)
        return FAILED
    except KeyboardInterrupt:
        return INTERRUPTED


if __name__ == "__main__":
    sys.exit(main())
