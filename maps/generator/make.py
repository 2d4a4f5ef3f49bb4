#!/usr/bin/env python3
"""Writes the places and scenarios of the library: make.py [FOLDER], by default ../library.

Everything is drawn and computed by the scripts beside this one, without other libraries, and equal
in every run. Run it after a change of a script and commit what it writes.
"""

import os
import sys

sys.dont_write_bytecode = True

import classics
import clutter
import daily
import francis
import leaderboard
import places


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, "..", "library")
    drawn = {}
    for draw in places.PLACES:
        place = draw()
        place.check()
        place.write(os.path.join(folder, place.name))
        drawn[place.name] = place
    sets = {"francis": francis.scenes(), "clutter": clutter.scenes(), **classics.scenes(drawn)}
    for scene in daily.scenes(drawn):
        sets.setdefault(scene.place.name, []).append(scene)
    problems = [p for scenes in sets.values() for scene in scenes for p in scene.check()]
    if problems:
        sys.exit("\n".join(problems))
    for name, scenes in sets.items():
        for scene in scenes:
            scene.write(os.path.join(folder, name))
    leaderboard.write(folder, sets)
    print(sum(len(scenes) for scenes in sets.values()), "scenarios,", len(drawn), "places")


if __name__ == "__main__":
    main()
