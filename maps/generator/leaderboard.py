"""The experiment of the leaderboard: all planners of the program in 48 scenarios of the library."""

import os

HARD = ("frontal_approach", "pedestrian_obstruction", "robot_overtaking", "intersection_no_gesture",
        "blind_corner", "narrow_hallway", "narrow_doorway", "entering_room", "exiting_elevator",
        "join_group", "crowd_navigation", "parallel_traffic", "perpendicular_traffic",
        "circular_crossing", "robot_crowding")
OTHERS = ("sean_cross_path", "sean_down_path", "socialgym_hallway", "socialgym_doorway",
          "socialgym_intersection", "socialgym_open")


def write(folder, sets):
    names = {scene.name: key for key, scenes in sets.items() for scene in scenes}
    chosen = [f"francis_{key}_{level}" for key in HARD for level in ("normal", "hard")]
    chosen += list(OTHERS)
    chosen += [f"clutter_{n:02d}_people" for n in (6, 18, 30)]
    chosen += ["classic_bottleneck", "classic_crossing", "classic_chase"]
    chosen += ["hospital_ward_visiting_hours", "museum_guided_tour", "supermarket_checkout_queue",
               "school_corridor_break", "airport_gate_boarding", "open_square_market_day"]
    assert len(chosen) == len(set(chosen)) == 48
    lines = ["# All planners in 48 scenarios of the library. In the folder of this file:",
             "#   hunavsim batch leaderboard.yaml -o DIR; hunavsim report DIR",
             "hunavsim_experiment: 1", "scenarios:"]
    lines += [f"  - {names[name]}/{name}.yaml" for name in chosen]
    lines += ["seeds: [" + ", ".join(str(1001 + k) for k in range(30)) + "]", "values:",
              "  robot1.planner: [pursuit, dwa, orca, social_force, mppi, social_mppi, straight]",
              "record: unsuccessful"]
    with open(os.path.join(folder, "leaderboard.yaml"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
