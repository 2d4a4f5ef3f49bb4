"""Scenario files in exactly the form in which the program saves them, and their tree files."""

import json
import math
import os

LICENCE = "MIT"
SIMULATOR = "Gazebo Classic"
# Metrics by which planners are compared where it is not the usual one: the first of minimum distance,
# intimate and personal space, time and path length that told planners apart with the seeds 1 to 12.
# Certificates use other seeds.
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "first_metrics.json"),
          encoding="utf-8") as opened:
    FIRST_METRICS = json.load(opened)
METRICS = ("minimum_distance_to_people", "intimate_space_intrusions", "time_to_reach_goal", "success")


def decimals(value, digits=1):
    """The shortest text that reads back equal, with at least so many decimals."""
    text = repr(round(float(value), 4))
    text = "0.0" if text == "-0.0" else text
    whole, _, rest = text.partition(".")
    return whole + "." + rest.ljust(digits, "0")


def text(value):
    """A text, quoted where YAML or the program needs it."""
    special = ",[]{}"
    plain = (value and value[0] not in "-?:,[]{}#&*!|>'\"%@` " and value[-1] not in " :"
             and not any(c in special for c in value) and ": " not in value and " #" not in value
             and not (value[0].isdigit() and not value.strip("0123456789abcdefoxtzABCDEFOXTZ_.:+- "))
             and value.lower() not in ("null", "y", "n", "yes", "no", "true", "false", "on", "off"))
    return value if plain else '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'


def emit(tree, indent=0):
    """Block YAML of nested dicts and lists of scalars that are already text."""
    pad, lines = " " * indent, []
    for key, value in tree.items():
        if isinstance(value, dict):
            lines.append(f"{pad}{key}:")
            lines += emit(value, indent + 2)
        elif isinstance(value, list):
            lines.append(f"{pad}{key}:")
            lines += [f"{pad}  - {item}" for item in value]
        else:
            lines.append(f"{pad}{key}: {value}")
    return lines


def xy(x, y, digits=1):
    return {"x": decimals(x, digits), "y": decimals(y, digits)}


REACTIONS = {  # keys of each reaction with their decimals, in the order of HuNavSim's editor
    "Surprised": (("dist", 3, 4.0), ("duration", 1, 10.0), ("once", 0, True)),
    "Curious": (("dist", 2, 8.0), ("duration", 1, 20.0), ("once", 0, True), ("vel", 2, 1.0),
                ("stop_dist", 2, 1.5)),
    "Scared": (("dist", 2, 4.0), ("duration", 1, 20.0), ("once", 0, True), ("vel", 3, 0.8),
               ("other_force_factor", 1, 20.0), ("safe_distance", 1, 3.0)),
    "Threatening": (("dist", 2, 4.0), ("duration", 2, 10.0), ("once", 0, True),
                    ("front_dist", 2, 1.4)),
}
DIGITS = {"Curious": {"vel": 2}, "Scared": {"vel": 3}}


def behavior_of(kind, values):
    tree = {"type": kind}
    for key, digits, default in REACTIONS.get(kind, ()):
        value = values.get(key, default)
        tree[key] = ("true" if value else "false") if key == "once" else decimals(value, digits)
    tree["configuration"] = "0"
    tree["goal_force_factor"] = "2.0"
    tree["obstacle_force_factor"] = "10.0"
    tree["social_force_factor"] = "5.0"
    if kind != "Scared":
        tree["other_force_factor"] = "20.0"
    return tree


class Scene:
    """One scenario. `place`: a Place whose map lies beside it, a relative map file, or None."""

    def __init__(self, name, title, family, place=None, map_file=None, variation="strong",
                 duration=None):
        self.name, self.place, self.map_file = name, place, map_file
        self.card = {"title": title, "family": family}
        self.variation, self.duration = variation, duration
        self.goals, self.people, self.robots = [], [], []
        self.obstacles, self.doors, self.areas = {}, {}, {}
        self.trees, self.groups = {}, {}
        self.expects, self.difficulty, self.metrics = [], "normal", METRICS

    # -- contents -------------------------------------------------------------------------------

    def goal(self, x, y=None):
        """Number of a goal: of a named point of the place, or a position."""
        point = self.at(x)[:2] if isinstance(x, str) else (x, y)
        if point not in self.goals:
            self.goals.append(point)
        return self.goals.index(point) + 1

    def at(self, name):
        return self.place.points[name]

    def person(self, name, start, goals, speed=1.2, cyclic=False, kind="Regular", tree=None,
               group=-1, heading=None, radius=0.3, goal_radius=0.4, **more):
        """`start`: point of the place, or (x, y, heading). `goals`: points or positions.
        `more`: keys of reactions (`dist` …) and of the block of HuNavSim Desktop (`start_time` …)."""
        pose = list(self.at(start) if isinstance(start, str) else start)
        if heading is not None:
            pose[2] = heading
        numbers = [self.goal(g) if isinstance(g, str) else self.goal(*g) for g in goals]
        self.people.append(dict(name=name, pose=pose, goals=numbers, speed=speed, cyclic=cyclic,
                                kind=kind, group=group, radius=radius, goal_radius=goal_radius,
                                more=more))
        if tree is not None:
            assert kind == "Regular", name
            self.trees[len(self.people)] = tree
        return len(self.people)

    def robot(self, start, goal, **more):
        pose = self.at(start) if isinstance(start, str) else start
        to = self.at(goal)[:2] if isinstance(goal, str) else goal
        self.robots.append(dict(pose=pose, goal=to, more=more))

    def wall(self, name, *points):
        self.obstacles[name] = {"kind": "wall", "xs": [decimals(x) for x, _ in points],
                                "ys": [decimals(y) for _, y in points]}

    def room(self, width, height, name="room"):
        self.wall(name, (0, 0), (width, 0), (width, height), (0, height), (0, 0))

    def box(self, name, x0, y0, x1, y1):
        self.obstacles[name] = {"kind": "box", **xy((x0 + x1) / 2, (y0 + y1) / 2),
                                "h": "0.0", "length": decimals(x1 - x0), "width": decimals(y1 - y0)}

    def circle(self, name, x, y, radius):
        self.obstacles[name] = {"kind": "circle", **xy(x, y), "radius": decimals(radius)}

    def door(self, name, x1, y1, x2, y2, is_open=True, toggles=()):
        tree = {"x1": decimals(x1), "y1": decimals(y1), "x2": decimals(x2), "y2": decimals(y2)}
        if not is_open:
            tree["open"] = "false"
        if toggles:
            tree["toggles"] = [decimals(t) for t in toggles]
        self.doors[name] = tree

    def area(self, name, kind, x0, y0, x1, y1, **more):
        tree = {"kind": kind, "xs": [decimals(x) for x in (x0, x1, x1, x0)],
                "ys": [decimals(y) for y in (y0, y0, y1, y1)]}
        for key in ("like", "rate", "from", "until", "count", "factor", "carry_speed", "carry_h"):
            if key in more:
                value = more[key]
                tree[key] = value if isinstance(value, str) else (
                    str(value) if key == "count" else decimals(value))
        self.areas[name] = tree

    def describe(self, purpose, task, people, outcome, source, difficulty="normal", metrics=None,
                 expect=()):
        self.card.update(purpose=purpose, robot_task=task, people=people, outcome=outcome,
                         source=source)
        self.difficulty = difficulty
        self.metrics = metrics or self.metrics
        self.expects += list(expect)

    # -- tests ----------------------------------------------------------------------------------

    def segments(self):
        """The sides of all obstacles and closed doors."""
        for thing in self.obstacles.values():
            if thing["kind"] == "wall":
                corners = list(zip(map(float, thing["xs"]), map(float, thing["ys"])))
                yield from zip(corners, corners[1:])
            elif thing["kind"] == "box":
                x, y = float(thing["x"]), float(thing["y"])
                a, b = float(thing["length"]) / 2, float(thing["width"]) / 2
                corners = [(x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)]
                yield from zip(corners, corners[1:] + corners[:1])

    def clearance(self, x, y):
        """Distance to the nearest obstacle of the scenario; the map is tested apart."""
        least = 99.0
        for (ax, ay), (bx, by) in self.segments():
            dx, dy = bx - ax, by - ay
            length = dx * dx + dy * dy
            t = min(1.0, max(0.0, ((x - ax) * dx + (y - ay) * dy) / length)) if length else 0.0
            least = min(least, math.hypot(x - ax - t * dx, y - ay - t * dy))
        for thing in self.obstacles.values():
            if thing["kind"] == "circle":
                gap = math.hypot(x - float(thing["x"]), y - float(thing["y"])) - float(thing["radius"])
                least = min(least, gap)
        return least

    def check(self):
        if self.trees and any(p["kind"] != "Regular" for p in self.people):
            yield f"{self.name}: trees are missing for reactions"
        yield from self.check_places()

    def check_places(self):
        """Starts and goals are free, and starts do not overlap."""
        spots = [(p["name"], *p["pose"][:2], p["radius"] + 0.05) for p in self.people]
        spots += [("robot", *r["pose"][:2], 0.4) for r in self.robots]
        for k, (name, x, y, radius) in enumerate(spots):
            for other, ox, oy, size in spots[:k]:
                if math.hypot(x - ox, y - oy) < radius + size:
                    yield f"{self.name}: {name} and {other} overlap at {x}, {y}"
        goals = [(f"goal {k + 1}", x, y, 0.3) for k, (x, y) in enumerate(self.goals)]
        goals += [("robot's goal", *r["goal"], 0.4) for r in self.robots]
        for name, x, y, radius in spots + goals:
            free = self.place is None or self.place.is_free(x, y, radius)
            if not free or self.clearance(x, y) < radius:
                yield f"{self.name}: {name} at {x}, {y} is not free"

    # -- output ---------------------------------------------------------------------------------

    def card_tree(self):
        tree = {}
        for key in ("title", "family", "purpose", "robot_task", "people", "outcome"):
            tree[key] = text(self.card[key])
        first = FIRST_METRICS.get(self.name)
        tree["metrics"] = [first] * bool(first) + [m for m in self.metrics if m != first]
        tree["difficulty"] = self.difficulty
        tree["source"] = text(self.card["source"])
        tree["licence"] = LICENCE
        if self.expects:
            tree["expect"] = [text(e) for e in self.expects]
        return tree

    def person_tree(self, number, person):
        reaction = {k: v for k, v in person["more"].items()}
        x, y, h = person["pose"]
        tree = {"id": str(number), "group_id": str(person["group"]), "skin": str((number - 1) % 8),
                "max_vel": decimals(person["speed"]), "radius": decimals(person["radius"]),
                "goal_radius": decimals(person["goal_radius"]),
                "cyclic_goals": "true" if person["cyclic"] else "false",
                "init_pose": {**xy(x, y, 3), "z": "1.250", "h": decimals(h, 3)},
                "behavior": behavior_of(person["kind"], reaction)}
        if person["goals"]:
            tree["goals"] = [str(g) for g in person["goals"]]
        return tree

    def extension_tree(self, person):
        more, tree = person["more"], {}
        if more.get("start_time"):
            tree["start_time"] = decimals(more["start_time"])
        if more.get("kind_of_body", "adult") != "adult":  # the default is not written
            tree["kind"] = more["kind_of_body"]
        if "at_end" in more:
            tree["at_end"] = more["at_end"]
        if "wait" in more:
            tree["wait"] = [decimals(w) for w in more["wait"]]
        if "tree" in more:
            tree["tree"] = more["tree"]
        return tree

    def desktop_tree(self):
        tree = {"format": "1", "card": self.card_tree()}
        if self.place is None:
            tree["map_file"] = "none"
        elif self.map_file:
            tree["map_file"] = self.map_file
        if self.duration:
            tree["duration"] = decimals(self.duration)
        tree["stuck_after"] = "20.0"
        tree["model"] = "das"
        if self.groups:
            tree["groups"] = {str(k): text(v) for k, v in sorted(self.groups.items())}
        if self.variation != "none":
            tree["variation"] = {"preset": self.variation}
        for person in self.people:
            extension = self.extension_tree(person)
            if extension:
                tree[person["name"]] = extension
        if self.robots:
            tree["robots"] = [f"robot{k + 1}" for k in range(len(self.robots))]
        for k, robot in enumerate(self.robots):
            x, y, h = robot["pose"]
            tree[f"robot{k + 1}"] = {"start": {**xy(x, y), "h": decimals(h)},
                                     "goal": xy(*robot["goal"])}
        for key, things in (("obstacles", self.obstacles), ("doors", self.doors),
                            ("areas", self.areas)):
            if things:
                tree[key] = list(things)
                tree.update(things)
        return tree

    def write(self, folder):
        self.folder = os.path.basename(folder)
        os.makedirs(folder, exist_ok=True)
        loader = {"yaml_base_name": self.name, "simulator": SIMULATOR,
                  "map": self.place.name if self.place else self.folder,
                  "publish_people": "true"}
        if self.goals:
            loader["global_goals"] = {str(k + 1): xy(x, y, 3) for k, (x, y) in enumerate(self.goals)}
        if self.people:
            loader["agents"] = [p["name"] for p in self.people]
        else:
            loader["agents"] = "[]"
        for k, person in enumerate(self.people):
            loader[person["name"]] = self.person_tree(k + 1, person)
        tree = {"hunav_loader": {"ros__parameters": loader},
                "hunavsim_desktop": {"ros__parameters": self.desktop_tree()}}
        with open(os.path.join(folder, self.name + ".yaml"), "w", encoding="utf-8") as file:
            file.write("\n".join(emit(tree)) + "\n")
        if self.trees:  # then everybody needs a tree file
            self.trees = {k + 1: self.trees.get(k + 1) or walk() for k in range(len(self.people))}
        for number, body in self.trees.items():
            name = f"{self.name}__agent_{number}_bt.xml"
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(tree_file(f"Agent{number}Tree", body))


# -- behaviour trees ------------------------------------------------------------------------------


def tree_file(name, body):
    return ('<?xml version="1.0" encoding="UTF-8"?>\n'
            f'<root main_tree_to_execute="{name}" BTCPP_format="4">\n'
            f'  <BehaviorTree ID="{name}">\n{indented(body, 4)}\n  </BehaviorTree>\n</root>\n')


def indented(body, by):
    return "\n".join(" " * by + line for line in body.split("\n"))


def node(name, *children, **ports):
    """An XML element; ports in the order given. A node of people gets agent_id="{id}"."""
    head = name + "".join(f' {key.rstrip("_")}="{value}"' for key, value in ports.items())
    if not children:
        return f"<{head}/>"
    return f"<{head}>\n" + "\n".join(indented(c, 2) for c in children) + f"\n</{name}>"


def do(name, **ports):
    """A leaf for the person of the tree."""
    return node(name, agent_id="{id}", **ports)


def step(name, **ports):
    """A leaf that also gets the time step."""
    return node(name, agent_id="{id}", time_step="{dt}", **ports)


def sequence(*children):
    return node("SequenceWithMemory", *children)


def select(*children):
    return node("Fallback", *children)


def once(*children):
    return node("RunOnce", *children)


def go(goal):
    return step("GoTo", goal_id=goal)


def say(message):
    return do("SaySomething", message=message)


def stand(seconds):
    return do("StopAndWaitTimerAction", wait_duration=decimals(seconds))


def walk():
    """One step towards the goals; the next one after each. The tree of a regular person."""
    return select(node("Sequence", node("Inverter", do("IsGoalReached")), step("RegularNav")),
                  do("UpdateGoal"))
