"""HuNavSim Desktop in Python: scenarios, runs, metrics, studies, learning environments.

    import hunavsim
    run = hunavsim.run(hunavsim.Scenario("corner_cafe_agents"), seed=1, planner="dwa")
    print(run.metrics["path_length"], len(run.trajectory))

World frame, SI units and radians everywhere. One simulation runs at a time in a process; use
`study` for many runs in parallel.
"""

from ._hunavsim import (
    CrowdEnvironment, Observation, PersonView, Problem, Run, Scenario, ScenarioError, Simulation,
    __version__, compare, holm, load_run, mean_interval, metrics, models, planners, rate_interval,
    run, scenarios)
from .planner import Planner
from .study import Results, load_results, study

__all__ = [
    "CrowdEnvironment", "Observation", "PersonView", "Planner", "Problem", "Results", "Run",
    "Scenario", "ScenarioError", "Simulation", "__version__", "compare", "holm", "load_results",
    "load_run", "mean_interval", "metrics", "models", "planners", "rate_interval", "run",
    "scenarios", "study"]
