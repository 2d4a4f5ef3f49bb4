"""Scenarios: reading, values, problems, saving."""

import tempfile
import unittest
from pathlib import Path

import hunavsim


class ScenarioTest(unittest.TestCase):
    def test_shipped_scenario_is_found_by_name(self):
        scenario = hunavsim.Scenario("corner_cafe_agents")
        self.assertIn("corner_cafe_agents", hunavsim.scenarios())
        self.assertTrue(Path(scenario.path).is_file())
        self.assertGreater(len(scenario.people), 3)
        self.assertTrue(all(len(place) == 2 for place in scenario.goals.values()))

    def test_unknown_name_suggests_the_nearest(self):
        with self.assertRaises(hunavsim.ScenarioError) as caught:
            hunavsim.Scenario("corner_cafe_agent")
        self.assertIn("corner_cafe_agents", str(caught.exception))

    def test_value_that_was_set_is_read_back(self):
        scenario = hunavsim.Scenario("corner_cafe_agents")
        name = scenario.people[0]
        scenario.set(f"{name}.max_vel", 0.75)
        self.assertEqual(scenario.get(f"{name}.max_vel"), 0.75)
        self.assertIsNone(scenario.get(f"{name}.no_such_key"))
        self.assertEqual(scenario.get("no.such.path", 3), 3)

    def test_copy_is_independent(self):
        scenario = hunavsim.Scenario("corner_cafe_agents")
        copy = scenario.copy()
        copy.set("seed", 77)
        self.assertNotEqual(scenario.get("seed"), 77)

    def test_wrong_values_raise_with_their_problems(self):
        scenario = hunavsim.Scenario("corner_cafe_agents")
        name = scenario.people[0]
        for path, value in [(f"{name}.max_vel", "fast"), ("nobody.max_vel", 1.0)]:
            with self.assertRaises(hunavsim.ScenarioError) as caught:
                scenario.set(path, value)
            self.assertEqual(caught.exception.problems[0].severity, "error")
            self.assertTrue(caught.exception.problems[0].code)

    def test_text_round_trip(self):
        scenario = hunavsim.Scenario("corner_cafe_agents")
        again = hunavsim.Scenario.from_text(scenario.text, scenario.path)
        self.assertEqual(again.text, scenario.text)
        with self.assertRaises(hunavsim.ScenarioError) as caught:
            hunavsim.Scenario.from_text("hunav_loader: [", "broken.yaml")
        self.assertEqual(caught.exception.problems[0].file, "broken.yaml")
        self.assertGreater(caught.exception.problems[0].line, 0)

    def test_save_writes_the_text(self):
        scenario = hunavsim.Scenario("corner_cafe_agents")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "copy.yaml"
            scenario.save(str(file))
            self.assertEqual(file.read_text(), scenario.text)
            self.assertEqual(scenario.path, str(file))
            with self.assertRaises(hunavsim.ScenarioError):
                scenario.save("/proc/no/such/folder.yaml")

    def test_check_reports_all_problems(self):
        scenario = hunavsim.Scenario("corner_cafe_agents")
        scenario.set("*.max_vel", 0.0001)
        self.assertEqual([str(p) for p in hunavsim.Scenario("corner_cafe_agents").check()
                          if p.severity == "error"], [])
        with self.assertRaises(TypeError) as caught:
            scenario.check(sed=3)
        self.assertIn("seed", str(caught.exception))
        with self.assertRaises(hunavsim.ScenarioError):
            scenario.check(planner="none_such", duration=-1)


if __name__ == "__main__":
    unittest.main()
