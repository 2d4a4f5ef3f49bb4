"""Studies and statistics, against values from outside the program."""

import csv
import math
import tempfile
import unittest
from pathlib import Path

import hunavsim


class StatisticsTest(unittest.TestCase):
    def test_signed_rank_by_hand(self):
        # Differences 1, 2, 3, 4, -5: rank sum of the negative ones 5 of 15. Of 32 choices of signs,
        # 10 have a sum of at most 5 (0, 1, 2 once, 3, 4 twice, 5 three times), so p = 20 / 32. The
        # 15 means of pairs, sorted: -5, -2, -1.5, -1, -0.5, 1, 1.5, 2 (the median), 2, …
        result = hunavsim.compare([1.0, 2.0, 3.0, 4.0, 0.0], [0.0, 0.0, 0.0, 0.0, 5.0])
        self.assertAlmostEqual(result["p"], 20 / 32)
        self.assertTrue(result["exact"])
        self.assertAlmostEqual(result["shift"], 2.0)
        self.assertEqual(result["pairs"], 5)

    def test_wilson_interval_by_hand(self):
        # 8 of 10, z = 1.959964: centre (0.8 + z²/20) / (1 + z²/10), Wilson 1927.
        z = 1.959963984540054
        centre = (0.8 + z * z / 20) / (1 + z * z / 10)
        half = z * math.sqrt(0.8 * 0.2 / 10 + z * z / 400) / (1 + z * z / 10)
        low, high = hunavsim.rate_interval(8, 10)
        self.assertAlmostEqual(low, centre - half, places=9)
        self.assertAlmostEqual(high, centre + half, places=9)

    def test_mean_interval_from_a_table(self):
        # 1 … 5: mean 3, sd sqrt(2.5), t(4) = 2.776445 (tables of Student's t).
        low, high = hunavsim.mean_interval([1.0, 2.0, 3.0, 4.0, 5.0])
        half = 2.7764451052 * math.sqrt(2.5 / 5)
        self.assertAlmostEqual(low, 3 - half, places=6)
        self.assertAlmostEqual(high, 3 + half, places=6)

    def test_holm_by_hand(self):
        # Sorted 0.01 * 3, 0.02 * 2, 0.04 * 1; made monotonic: 0.03, 0.04, 0.04.
        adjusted = hunavsim.holm([0.04, 0.01, 0.02])
        for value, expected in zip(adjusted, [0.04, 0.03, 0.04]):
            self.assertAlmostEqual(value, expected)


class StudyTest(unittest.TestCase):
    def test_results_equal_the_table_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "study"
            calls = []
            results = hunavsim.study(
                {"scenarios": ["crossing_agents"], "seeds": 3, "duration": 5.0,
                 "values": {"robot1.planner": ["pursuit", "dwa"]}},
                output, jobs=2, progress=lambda finished, runs: calls.append((finished, runs)))
            self.assertEqual(calls[-1], (6, 6))
            with open(output / "results.csv") as file:
                table = list(csv.DictReader(file))
            self.assertEqual(len(results), len(table))
            for row, written in zip(results, table):
                self.assertEqual(row["robot1.planner"], written["robot1.planner"])
                self.assertEqual(row["path_length"], float(written["path_length"]))
            dwa = results.where(robot1__planner="dwa")
            self.assertEqual(len(dwa), 3)
            comparison = results.compare("path_length", "robot1.planner", "dwa", "pursuit")
            self.assertEqual(comparison["pairs"], 3)
            array = results.array()
            self.assertEqual(array["path_length"].tolist(), results.values("path_length"))
            again = hunavsim.load_results(output)
            self.assertEqual(again.rows, results.rows)

    def test_progress_can_stop_and_resume_continues(self):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "study"
            experiment = {"scenarios": ["crossing_agents"], "seeds": 30, "duration": 20.0}
            partial = hunavsim.study(experiment, output, jobs=1,
                                     progress=lambda finished, runs: finished < 2)
            self.assertLess(len(partial), 30)
            whole = hunavsim.study(experiment, output, resume=True)
            self.assertEqual(len(whole), 30)

    def test_wrong_experiment_raises(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(hunavsim.ScenarioError, "no_such"):
                hunavsim.study({"scenarios": ["no_such_scenario"], "seeds": 1},
                               Path(folder) / "study")


if __name__ == "__main__":
    unittest.main()
