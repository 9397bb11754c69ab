#!/usr/bin/python3
"""What the generator reads and what it refuses: anything it cannot bind for certain must not get through."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bindings/tools"))
from c_subset import NotInSubset, Type, read_headers  # noqa: E402
from write_fortran import FortranWriter, NameClash  # noqa: E402

GOOD = """
#define HFRAC_SIZE 3
/** Opaque. */
typedef struct hfrac_sim hfrac_sim;
/** A pair.
 *  Really. */
typedef struct hfrac_pair {
  int32_t first;      /**< [m] first */
  double second[HFRAC_SIZE]; /**< second */
  /** Before. */
  const char *name;
} hfrac_pair;
enum hfrac_kind { HFRAC_KIND_A = 1, /**< a */ HFRAC_KIND_B = -2 };
/** Does. */
HFRAC_API int32_t hfrac_do(hfrac_sim *sim, const hfrac_pair *pair, double *buffer, int64_t capacity,
                           int64_t *count);
/** Does more. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_do_more(hfrac_sim *sim);
"""


def read(text):
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "one.h").write_text(text)
        return read_headers(pathlib.Path(folder))


class Subset(unittest.TestCase):
    def test_reads_what_is_in_it(self):
        header = read(GOOD)
        self.assertEqual(header.macros, {"HFRAC_SIZE": 3})
        self.assertEqual(header.opaque, ["hfrac_sim"])
        pair = header.structs[0]
        self.assertEqual((pair.doc, pair.size), ("A pair. Really.", 40))
        self.assertEqual([(m.name, m.length, m.doc) for m in pair.members],
                         [("first", 0, "[m] first"), ("second", 3, "second"), ("name", 0, "Before.")])
        self.assertEqual(header.enums[0].values, [("HFRAC_KIND_A", 1, "a"), ("HFRAC_KIND_B", -2, "")])
        self.assertEqual([f.name for f in header.functions], ["hfrac_do", "hfrac_do_more"])
        function = header.functions[0]
        self.assertEqual((function.name, function.doc), ("hfrac_do", "Does."))
        self.assertEqual(function.parameters[1].type, Type("hfrac_pair", const=True, stars=1))
        self.assertEqual([p.may_be_null for p in function.parameters], [False, False, True, False, False])

    def test_refuses_what_is_not(self):
        for line in [
            "HFRAC_API double hfrac_f(int32_t a);",
            "HFRAC_API int32_t hfrac_f(unsigned a);",
            "HFRAC_API int32_t hfrac_f(long a);",
            "HFRAC_API int32_t hfrac_f(hfrac_sim sim);",
            "HFRAC_API int32_t hfrac_f(double ***a);",
            "HFRAC_API int32_t hfrac_f(void);",
            "HFRAC_API int32_t hfrac_f(hfrac_unknown *a);",
            "typedef struct hfrac_s { int32_t a : 3; } hfrac_s;",
            "typedef union hfrac_u { int32_t a; } hfrac_u;",
            "enum hfrac_e { HFRAC_A };",
            "extern int32_t hfrac_counter;",
            "int32_t hfrac_not_exported(int32_t a);",
        ]:
            with self.subTest(line=line), self.assertRaises(NotInSubset):
                read(GOOD + line + "\n")

    def test_names_that_differ_in_case_alone_are_refused_for_fortran(self):
        clash = "typedef struct hfrac_s { double rate; double Rate; } hfrac_s;\n"
        with self.assertRaises(NameClash):
            FortranWriter(read(clash))
        with self.assertRaises(NameClash):
            FortranWriter(read("#define HFRAC_DO 1\n" + GOOD))
        with self.assertRaises(NameClash):
            FortranWriter(read("HFRAC_API int32_t hfrac_f(double rate, double Rate);\n"))


unittest.main()
