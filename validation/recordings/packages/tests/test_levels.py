"""Readers of the twenty-sixth set, on small tables that are made here."""

import importlib.util
import io
import json
import pickle
import unittest
import zipfile

import numpy as np
from problem import Problem
from tests.made import told

READS = all(importlib.util.find_spec(name) for name in ("scipy", "pandas"))
if READS:
    import levels


def warmed(rate, warmth, taken):
    """A file of a calorimeter."""
    return json.dumps({"ID": "x", "rate": rate, "T": warmth, "latentdata": taken}).encode()


def database(tree):
    """A tree of tables as it lies in an archive of arrays."""
    out, array = io.BytesIO(), io.BytesIO()
    np.save(array, np.array(tree, dtype=object), allow_pickle=True)
    with zipfile.ZipFile(out, "w") as parts:
        parts.writestr("database.npy", array.getvalue())
    return out.getvalue()


def page(wavelengths, index):
    """A table of refractive indices."""
    return {"DATA": {"type": "tabulated nk", "wavelengths": wavelengths, "index": [complex(n, 0.1) for n in index]}}


PAIRS = b"SampleID,A,B\npair1, 1.0 2.0 3.0, 4.0 5.0 6.0\npair2, 7.0 8.0 9.0, 1.5 2.5 3.5\n"
SKIN = (
    "Skin\x93,,,,,,,,,\n,Person 1,,,Person 2,,,,,\nWavelength (nm),R1,R2,Average,R1,R2,Average,,,\n"
    "250,0.1,0.2,0.15,0.3,0.4,0.35,,,\n260,0.5,0.6,0.55,0.7,0.8,0.75,,,\n270,0.9,1.0,0.95,1.1,1.2,1.15,,,\n"
).encode("latin1")
CELLS = b"battery_id,cycle,voltage,capacity\nB1,1,3.5,1.9\nB1,2,3.5,1.8\nB1,4,3.5,1.7\nB2,2,3.5,1.6\nB2,3,3.5,1.5\nB2,4,3.5,1.4\n"


def house(power):
    """Hours of a house with solar cells."""
    return ("Hour,Solar Generation [W/kW]\n" + "".join(f"{k % 24 + 1},{value}\n" for k, value in enumerate(power))).encode()


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Readers(unittest.TestCase):
    def test_columns_get_the_names_that_they_are_to_have(self):
        self.assertEqual(told(levels.columns(b"a,b,c\n1,2,3\n4,5,6\n7,8,9\n", 2, first="c", second="a")), {"first": [3, 6], "second": [1, 4]})

    def test_columns_of_two_pairs(self):
        self.assertEqual(told(levels.pairs(PAIRS, x=("pair2", "A"), y=("pair1", "B"))), {"x": [7, 8, 9], "y": [4, 5, 6]})
        self.assertEqual(told(levels.pairs(PAIRS, step=60, rows=2, x=("pair2", "B"))), {"time_s": [0, 60], "x": [1.5, 2.5]})

    def test_a_sample_that_is_warmed_twice(self):
        fast, slow = warmed(20, [9, 10, 12, 14], [0, 1, 2, 3]), warmed(2, [9, 11, 13, 15], [0, 20, 40, 60])
        self.assertEqual(told(levels.melted(fast, slow, 9.5, 20)), {"time_s": [0, 6, 12], "slow_j_gk": [10, 30, 50], "fast_j_gk": [1, 2, 3]})

    def test_a_crystal_at_two_warmths_beside_itself_when_cold(self):
        pages = {"A-20C": page([0.4, 0.6, 0.8], [3, 2, 1]), "A-100C": page([0.5, 0.7], [5, 6]), "A-150C": page([0.3, 0.6], [7, 8])}
        read = levels.warm_crystal(database({"main": {"Si": pages}}), "main", "Si", "A-20C", ["A-100C", "A-150C"], 0.45)
        self.assertEqual(told(read), {"run": [1, 1, 2], "warmth_degc": [100, 100, 150], "cold": [2.5, 1.5, 2], "hot": [5, 6, 8]})

    def test_a_database_that_asks_for_more_than_numbers_is_refused(self):
        with self.assertRaisesRegex(Problem, "refused"):
            levels.optics(database({"main": pickle.Pickler}))

    def test_skin_is_a_row_for_each_time_that_a_person_was_seen(self):
        read = levels.skins(SKIN, times=2, short=251, long=272)
        self.assertEqual(told(read), {"run": [1, 1, 2, 2], "short": [0.1, 0.2, 0.3, 0.4], "long": [0.9, 1.0, 1.1, 1.2]})

    def test_skin_beside_skin(self):
        read = levels.skin_twice(SKIN, 2, 250, 270)
        self.assertEqual(told(read), {"run": [1, 1, 2, 2], "nm": [250, 270, 250, 270], "first": [0.1, 0.9, 0.3, 1.1], "second": [0.2, 1.0, 0.4, 1.2]})

    def test_roofs_are_read_while_both_have_the_sun(self):
        first, second = [0] * 24 + [0, 30, 40, 50, 5, 60] + [0] * 18 + [70], [0] * 24 + [9, 31, 41, 1, 51, 61] + [0] * 18 + [71]
        self.assertEqual(told(levels.roofs(house(first), house(second), 1, 2, 20)), {"time_s": [0, 3600, 14400], "first_w_kw": [30, 40, 60], "second_w_kw": [31, 41, 61]})

    def test_cells_are_put_together_by_their_cycle(self):
        self.assertEqual(told(levels.cells(CELLS, "B1", "B2")), {"first_ah": [1.8, 1.7], "second_ah": [1.6, 1.4]})


@unittest.skipUnless(READS, "scipy or pandas is not installed")
class Models(unittest.TestCase):
    def test_a_slope_that_changes_is_found_where_it_does(self):
        t, rng = np.arange(200.0), np.random.default_rng(1)
        x = rng.uniform(1, 2, 200)
        y = x * np.where(t >= 120, 1.1, 1.0)
        seen = np.ones(200, bool)
        left = {name: np.std(y - model(seen)) for name, model in levels.switched(y, x, t, np.arange(0.05, 0.96, 0.01)).items()}
        self.assertLess(left["slope that changes"], 1e-9)
        self.assertGreater(left["step"], 0.01)

    def test_a_lag_is_found_beside_others(self):
        t = np.arange(400.0)
        x = np.sin(t / 7) + np.sin(t / 31)
        y = 2 * levels.lag(x, t, 12) + 1
        seen = np.ones(400, bool)
        left = {name: np.std(y - model(seen)) for name, model in levels.behind(y, x, t, 10).items()}
        self.assertLess(left["lag, and square"], 1e-3)
        self.assertLess(left["line, and lag"], 1e-3)


if __name__ == "__main__":
    unittest.main()
