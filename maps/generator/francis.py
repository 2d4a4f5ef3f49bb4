"""The 25 situations of Francis et al. 2025, figure 7, at three levels of difficulty."""

import math

from scene import Scene, do, go, node, once, say, select, sequence, stand, step, walk

SOURCE = ("Francis et al. 2025, Principles and Guidelines for Evaluating Social Robot Navigation "
          "Algorithms (figure 7{}); geometry after Robot SF (ll7/robot_sf_ll7)")
LEVELS = ("easy", "normal", "hard")
PI = 3.142
NEAR = ("minimum_distance_to_people", "intimate_space_intrusions", "time_to_reach_goal", "success")
TIME = ("time_to_reach_goal", "minimum_distance_to_people", "personal_space_intrusions", "success")
SPACE = ("intimate_space_intrusions", "minimum_distance_to_people", "time_to_reach_goal", "success")


def scene(key, title, level, letter, purpose, task, people, outcome, metrics=NEAR):
    s = Scene(f"francis_{key}_{LEVELS[level]}", f"{title} ({LEVELS[level]})", "Francis 2025",
              variation=("light", "strong", "strong")[level])
    s.describe(purpose, task, people, outcome, SOURCE.format(letter), LEVELS[level], metrics)
    return s


def corridor(s, length, width):
    s.room(length, width)
    return width / 2


def crossing(s, size, arm):
    """Two corridors that cross: solid corners around a free cross."""
    low, high = size / 2 - arm / 2, size / 2 + arm / 2
    s.room(size, size)
    for name, x0, y0 in (("corner_sw", 0.0, 0.0), ("corner_se", high, 0.0),
                         ("corner_nw", 0.0, high), ("corner_ne", high, high)):
        s.box(name, x0, y0, x0 + low, y0 + low)
    return size / 2


def frontal_approach(level):
    s = scene("frontal_approach", "Frontal approach", level, "a",
              "How early and how far a robot moves aside for an oncoming person",
              "Drive along the corridor", "Walk towards the robot in the middle of the corridor",
              "The robot shows its side at least 2 m before they meet and keeps 0.45 m")
    width = (6.0, 4.0, 3.0)[level]
    y = corridor(s, 26, width)
    s.robot((2.0, y, 0.0), (24.0, y))
    s.person("walker", (23.0, y, PI), [(1.5, y)], (1.0, 1.3, 1.4)[level])
    if level == 2:
        s.person("second", (24.2, y + 0.6, PI), [(1.5, y + 0.6)], 1.3)
    s.expects.append("walker reaches goal 1 before 45 s")
    return s


def pedestrian_obstruction(level):
    s = scene("pedestrian_obstruction", "Pedestrian obstruction", level, "b",
              "Whether a robot follows or passes a slow person who does not look back",
              "Drive along the corridor", "Walk slowly ahead of the robot in the same direction",
              "The robot follows, or passes with at least 0.6 m", TIME)
    y = corridor(s, 22, (5.0, 3.6, 2.8)[level])
    s.robot((1.5, y, 0.0), (20.0, y))
    s.person("slow", (6.0, y, 0.0), [(21.0, y)], (0.5, 0.4, 0.3)[level])
    if level == 2:
        s.person("slow_2", (6.6, y + 0.75, 0.0), [(21.0, y + 0.75)], 0.3)
    s.expects.append("slow never reaches goal 1 before 15 s")
    return s


def pedestrian_overtaking(level):
    s = scene("pedestrian_overtaking", "Pedestrian overtaking", level, "c",
              "Whether a robot keeps its course while people overtake it",
              "Drive along the corridor", "Come from behind and overtake the robot",
              "The robot moves less than 0.3 m to the side and does not stop")
    y = corridor(s, 30, (5.0, 4.0, 3.0)[level])
    s.robot((5.0, y, 0.0), (28.0, y))
    s.circle("bin", 17.0, y, 0.25)
    for k in range((1, 2, 3)[level]):
        offset = (0.0, 0.6, -0.6)[k]
        s.person(f"hurry_{k + 1}", (1.2 + 0.8 * k, y + offset, 0.0), [(28.8, y + offset)],
                 (1.4, 1.6, 1.7)[level])
    s.expects.append("hurry_1 reaches goal 1 before 45 s")
    return s


def robot_overtaking(level):
    s = scene("robot_overtaking", "Robot overtaking", level, "d",
              "Whether a robot overtakes slower people with room",
              "Drive along the corridor", "Walk in the robot's direction at half its speed or less",
              "The robot passes with at least 0.6 m and returns to its lane")
    y = corridor(s, 26, (6.0, 4.0, 3.2)[level])
    s.robot((1.5, y, 0.0), (24.0, y))
    for k in range((1, 2, 3)[level]):
        s.person(f"stroller_{k + 1}", (4.5 + 3.5 * k, y + (0.0, -0.5, 0.5)[k], 0.0),
                 [(25.0, y + (0.0, -0.5, 0.5)[k])], (0.5, 0.45, 0.4)[level],
                 kind_of_body="elderly")
    s.expects.append("stroller_1 comes within 2 m of goal 1 before 75 s")
    return s


def down_path(level):
    s = scene("down_path", "Down path", level, "e",
              "Whether a robot keeps its lane beside people who walk the same way",
              "Drive along one side of the corridor", "Walk along the other side, same direction",
              "No detour and no stop", TIME)
    width = (6.0, 4.4, 3.4)[level]
    corridor(s, 26, width)
    s.robot((2.0, 1.1, 0.0), (24.0, 1.1))
    s.circle("bin", 14.0, 1.0, 0.25)
    for k in range((1, 2, 3)[level]):
        s.person(f"peer_{k + 1}", (3.5 + 1.6 * k, width - 1.1, 0.0), [(25.0, width - 1.1)], 1.1)
    s.expects.append("peer_1 reaches goal 1 before 45 s")
    return s


def intersection(level, key, title, letter, people, tree_of, outcome):
    s = scene(key, title, level, letter, "Who goes first where two corridors cross",
              "Cross straight on", people, outcome)
    arm = (5.0, 4.0, 3.2)[level]
    c = crossing(s, 20, arm)
    s.robot((2.0, c, 0.0), (18.0, c))
    s.circle("bin", 5.0, c, 0.25)
    near = s.goal(c, c + arm / 2 + 0.6)
    far = s.goal(c, 1.5)
    tree = tree_of(near, far)
    s.person("crosser", (c, 16.5, -1.571), [(c, 1.5)], (1.0, 1.2, 1.3)[level], tree=tree)
    if level == 2:
        s.person("second", (c + 0.8, 18.4, -1.571), [(c + 0.8, 1.5)], 1.2)
    s.expects.append("crosser comes within 1 m of goal 2 before 40 s")
    return s


def intersection_no_gesture(level):
    return intersection(level, "intersection_no_gesture", "Intersection without gesture", "f",
                        "Walk across the robot's way without a sign", lambda near, far: None,
                        "It is decided who goes first before 1.5 s to contact")


def intersection_wait(level):
    s = intersection(
        level, "intersection_wait", "Intersection, person waits", "g",
        "Stop before the crossing, say that the robot may go, then cross",
        lambda near, far: sequence(go(near), say("After you"),
                                   select(once(do("YieldToRobot", distance="6.0", patience="3.0")),
                                          stand(2.0)), go(far)),
        "The robot goes within 1 s of the offer")
    s.expects += ['crosser says "After you" before 20 s',
                  "crosser yields at goal 1 for 1 s before 25 s"]
    return s


def intersection_proceed(level):
    s = intersection(
        level, "intersection_proceed", "Intersection, person proceeds", "h",
        "Say that they go first and cross without stopping",
        lambda near, far: sequence(go(near), say("I go first"), go(far)),
        "The robot waits until the person has crossed, then goes")
    s.expects.append('crosser says "I go first" before 20 s')
    return s


def blind_corner(level):
    s = scene("blind_corner", "Blind corner", level, "i",
              "Whether a robot expects people behind a corner that it cannot see around",
              "Turn around the corner", "Come around the same corner the other way",
              "Slow at the corner, no contact")
    arm = (4.0, 3.0, 2.4)[level]
    s.room(16, 16)
    s.box("block", 0.0, 0.0, 16.0 - arm, 16.0 - arm)
    middle = 16.0 - arm / 2
    s.robot((3.0, middle, 0.0), (middle, 3.0))
    for k in range((1, 2, 3)[level]):
        s.person(f"walker_{k + 1}", (middle - 0.4 + 0.4 * k, 3.0 + 1.5 * k, 1.571),
                 [(middle, middle), (2.0, middle)], 1.3)
    s.expects.append("walker_1 arrives before 40 s")
    return s


def narrow_hallway(level):
    s = scene("narrow_hallway", "Narrow hallway", level, "j",
              "Whether robot and person pass each other where there is hardly room",
              "Drive along the hallway", "Come towards the robot",
              "Each keeps to a side; no standstill longer than 3 s", TIME)
    y = corridor(s, 20, (2.6, 2.2, 1.9)[level])
    s.robot((1.5, y, 0.0), (18.0, y))
    s.person("oncoming", (18.4, y + 0.15, PI), [(1.4, y + 0.15)], (1.0, 1.2, 1.3)[level])
    s.expects.append("oncoming reaches goal 1 before 40 s")
    return s


def narrow_doorway(level):
    s = scene("narrow_doorway", "Narrow doorway", level, "k",
              "Who passes first through a door that is wide enough for one",
              "Drive through the door", "Come through the door the other way; give way at it",
              "One at a time, wait at most 5 s")
    gap = (1.6, 1.3, 1.1)[level]
    s.room(16, 8)
    s.wall("wall_south", (8, 0), (8, 4 - gap / 2))
    s.wall("wall_north", (8, 4 + gap / 2), (8, 8))
    s.robot((2.0, 4.0, 0.0), (14.0, 4.0))
    s.circle("plant", 4.6, 4.0, 0.25)
    door, end = s.goal(9.2, 4.9), s.goal(1.6, 5.4)
    s.person("visitor_1", (14.0, 5.0, PI), [(1.6, 5.4)], 1.2,
             tree=sequence(go(door), select(once(do("YieldToRobot", distance="4.0", patience="4.0")),
                                            stand(0.6)), go(end)))
    if level:
        s.person("visitor_2", (14.6, 3.2, PI), [(1.6, 2.6)], 1.1, start_time=3.0)
    if level == 2:
        s.person("visitor_3", (13.2, 6.6, PI), [(1.6, 6.4)], 1.3, start_time=5.0)
    s.expects += ["visitor_1 yields at goal 1 before 20 s",
                  "visitor_1 comes within 1 m of goal 2 before 30 s"]
    return s


def room_with_door(s, door_width):
    """A room of 7 x 8 m at the right of a hall; its door is at (9, 4)."""
    s.room(16, 8)
    s.wall("wall_south", (9, 0), (9, 4 - door_width / 2))
    s.wall("wall_north", (9, 4 + door_width / 2), (9, 8))


def entering_room(level):
    s = scene("entering_room", "Entering a room", level, "l",
              "Whether a robot lets people out before it goes in",
              "Enter the room", "Leave the room through the door",
              "The robot waits beside the door until it is clear")
    room_with_door(s, (2.0, 1.5, 1.2)[level])
    s.robot((2.5, 4.0, 0.0), (13.5, 4.0))
    for k in range((1, 2, 4)[level]):
        s.person(f"leaver_{k + 1}", (12.0 + 0.9 * k, 3.4 + 0.5 * k, PI), [(2.0, 2.2 + 1.1 * k)], 1.0)
    s.expects.append("leaver_1 arrives before 30 s")
    return s


def exiting_room(level):
    s = scene("exiting_room", "Exiting a room", level, "m",
              "Whether a robot gives way to people who come in",
              "Leave the room", "Enter the room through the door",
              "The robot waits inside, beside the door")
    room_with_door(s, (2.0, 1.5, 1.2)[level])
    s.robot((13.5, 4.0, PI), (2.5, 4.0))
    s.circle("plant", 5.4, 4.0, 0.25)
    for k in range((1, 2, 4)[level]):
        s.person(f"guest_{k + 1}", (3.0 + 0.9 * k, 3.0 + 0.6 * k, 0.0), [(14.0, 2.4 + 1.0 * k)], 0.9)
    s.expects.append("guest_1 arrives before 35 s")
    return s


def lift(s, door_width):
    """A cabin of 3 x 3 m at (6.5, 8) to (9.5, 11) in the north of a hall; its door faces south."""
    s.room(16, 11)
    s.wall("cabin_west", (6.5, 11), (6.5, 8), (8 - door_width / 2, 8))
    s.wall("cabin_east", (9.5, 11), (9.5, 8), (8 + door_width / 2, 8))


def entering_elevator(level):
    s = scene("entering_elevator", "Entering a lift", level, "n",
              "Whether a robot lets people get out of a lift first",
              "Enter the lift", "Get out of the lift", "People get out first, then the robot enters")
    lift(s, (1.8, 1.5, 1.2)[level])
    s.robot((8.0, 2.0, 1.571), (8.0, 9.6))
    s.circle("plant", 8.0, 4.4, 0.25)
    for k in range((1, 2, 3)[level]):
        x, y = ((7.4, 9.2), (8.5, 9.8), (8.6, 8.9))[k]
        s.person(f"rider_{k + 1}", (x, y, -1.571), [(3.0 + 5.0 * k, 2.0)], 0.8,
                 start_time=0.0)
    s.expects.append("rider_1 arrives before 35 s")
    return s


def exiting_elevator(level):
    s = scene("exiting_elevator", "Exiting a lift", level, "o",
              "Whether a robot leaves a lift in front of which people wait",
              "Leave the lift", "Wait in front of the lift, then get in",
              "The door is not blocked for more than 5 s")
    lift(s, (1.8, 1.5, 1.2)[level])
    s.robot((8.0, 9.6, -1.571), (8.0, 2.0))
    s.circle("plant", 8.0, 4.2, 0.25)
    for k in range((1, 2, 3)[level]):
        inside = s.goal(7.3 + 0.7 * k, 9.8)
        x = (6.4, 9.6, 8.2)[k]
        s.person(f"waiting_{k + 1}", (x, 6.2, 1.571), [(7.3 + 0.7 * k, 9.8)], 0.8,
                 tree=sequence(select(once(stand(5.0 + k)), stand(0.1)), go(inside), stand(60.0)))
    s.expects.append("waiting_1 comes within 1 m of goal 1 before 30 s")
    return s


def group_talk(s, members, x, y, seconds=60.0):
    """A group that stands in a circle and talks; the first member gathers the others."""
    centre = s.goal(x, y)
    radius = 0.9
    first = len(s.people) + 1
    others = ",".join(str(first + k) for k in range(1, members))
    for k in range(members):
        a = 2 * math.pi * k / members
        tree = sequence(node("ConversationFormation", main_agent_id="{id}", goal_id=centre,
                             conversation_duration=f"{seconds}", non_main_agent_ids=others,
                             time_step="{dt}")) if k == 0 else stand(seconds)
        s.person(f"member_{first + k}", (x + radius * math.cos(a), y + radius * math.sin(a), a + PI),
                 [(x, y)], 0.9, tree=tree)


def join_group(level):
    s = scene("join_group", "Joining a group", level, "p",
              "Whether a robot approaches a talking group without crossing the space between them",
              "Drive to a place at the edge of the group", "Stand in a circle and talk; one joins",
              "The robot stops outside the circle and never enters the space between the people",
              SPACE)
    s.room(14, 12)
    group_talk(s, (2, 3, 4)[level], 9.0, 6.0)
    s.person("joiner", (3.0, 9.0, 0.0), [(8.0, 7.8)], 1.0)
    s.robot((2.0, 4.0, 0.0), (7.0, 5.2))
    s.circle("plant", 4.4, 4.6, 0.25)
    s.expects += ["member_1 starts ConversationFormation before 15 s", "joiner arrives before 20 s"]
    return s


def leave_group(level):
    s = scene("leave_group", "Leaving a group", level, "q",
              "Whether a robot gives way to a person who leaves a group",
              "Drive past the group", "Talk in a circle; one says goodbye and leaves across the "
              "robot's way", "The robot lets the person pass and does not cut through the group",
              SPACE)
    s.room(14, 12)
    group_talk(s, (2, 3, 4)[level], 8.0, 7.5)
    away = s.goal(4.0, 1.5)
    s.person("leaver", (7.0, 6.2, 1.0), [(4.0, 1.5)], (1.0, 1.2, 1.4)[level],
             tree=sequence(once(stand((3.0, 2.5, 2.0)[level])), once(say("See you")), go(away)))
    s.robot((1.5, 5.0, 0.0), (12.5, 5.0))
    s.circle("plant", 10.6, 5.0, 0.25)
    s.expects += ['leaver says "See you" before 15 s', "leaver comes within 1 m of goal 2 before 30 s"]
    return s


def following_human(level):
    s = scene("following_human", "Following a person", level, "r",
              "Whether a robot keeps a steady distance to the person who leads it",
              "Drive behind the person to the same place", "Lead the way at walking speed",
              "1.0 to 2.0 m behind the person in 90 % of the time", TIME)
    y = corridor(s, 26, (6.0, 4.0, 3.0)[level])
    s.robot((2.0, y, 0.0), (22.0, y))
    leader = sequence(once(say("Follow me")), go(s.goal(13.0, y)), stand((0.5, 2.0, 4.0)[level]),
                      go(s.goal(25.0, y)), stand(60.0))
    s.person("leader", (3.6, y, 0.0), [(25.0, y)], (1.0, 0.9, 0.8)[level], tree=leader)
    if level == 2:
        s.person("oncoming", (24.0, y + 0.5, PI), [(1.5, y + 0.5)], 1.2)
    s.expects += ["leader comes within 1 m of goal 2 before 50 s", "leader says \"Follow me\" before 15 s"]
    return s


def leading_human(level):
    s = scene("leading_human", "Leading a person", level, "s",
              "Whether a robot leads a person without losing or blocking them",
              "Drive to the goal while a person follows", "Follow the robot at 1.5 m",
              "The robot is never more than 4 m ahead", TIME)
    y = corridor(s, 26, (6.0, 4.0, 3.0)[level])
    s.robot((3.5, y, 0.0), (24.0, y))
    s.circle("bin", 14.0, y, 0.25)
    s.person("follower", (1.8, y, 0.0), [(24.5, y)], (1.2, 1.0, 0.9)[level],
             tree=select(node("Sequence", do("IsRobotVisible", distance="6.0"),
                              step("ApproachRobot", closest_dist="1.5", duration="2.0",
                                   max_vel="1.2")), walk()))
    if level:
        s.person("oncoming", (24.0, y + 0.6, PI), [(1.5, y + 0.6)], 1.2)
    if level == 2:
        s.person("oncoming_2", (20.0, y - 0.6, PI), [(1.5, y - 0.6)], 1.0)
    s.expects.append("follower comes within 1 m of goal 1 before 45 s")
    return s


def accompanying_peer(level):
    s = scene("accompanying_peer", "Accompanying a peer", level, "t",
              "Whether a robot stays beside a person who walks to the same place",
              "Drive beside the person", "Walk at the robot's speed, at times slower",
              "0.7 to 1.2 m beside the person in 80 % of the time", SPACE)
    y = corridor(s, 26, (6.0, 4.0, 3.2)[level])
    s.robot((2.0, y - 0.5, 0.0), (23.0, y - 0.5))
    s.circle("bin", 14.0, y - 0.5, 0.25)
    s.person("peer", (2.0, y + 0.5, 0.0), [(23.5, y + 0.5)], (1.0, 0.95, 0.9)[level])
    if level:
        s.person("oncoming", (24.5, y - 0.4, PI), [(1.5, y - 0.4)], (1.0, 1.1, 1.3)[level])
    s.expects.append("peer reaches goal 1 before 45 s")
    return s


def crowd(s, count, x0, y0, x1, y1, cyclic=True, speed=1.1):
    """People who walk between two places each, on a regular grid so that none overlap."""
    columns = math.ceil(math.sqrt(count * (x1 - x0) / (y1 - y0)))
    rows = math.ceil(count / columns)
    for k in range(count):
        i, j = k % columns, k // columns
        x = x0 + (i + 0.5) * (x1 - x0) / columns
        y = y0 + (j + 0.5) * (y1 - y0) / rows
        a = (k * 137.508) % 360.0 * math.pi / 180.0
        to = (round(min(max(x + 7 * math.cos(a), x0), x1), 2),
              round(min(max(y + 7 * math.sin(a), y0), y1), 2))
        s.person(f"person_{k + 1}", (round(x, 2), round(y, 2), round(math.atan2(math.sin(a), math.cos(a)), 3)),
                 [to, (round(x, 2), round(y, 2))], speed, cyclic=cyclic)


def crowd_navigation(level):
    s = scene("crowd_navigation", "Crowd navigation", level, "u",
              "Whether a robot finds its way through people who walk in all directions",
              "Cross the hall", "Walk back and forth in all directions",
              "Less than 5 % of the time within a person's intimate space", SPACE)
    s.room(20, 14)
    crowd(s, (6, 11, 17)[level], 4.0, 1.5, 16.0, 12.5)
    s.robot((1.2, 7.0, 0.0), (18.8, 7.0))
    s.circle("column", 10.0, 7.0, 0.3)
    s.expects.append("person_1 reaches goal 1 before 30 s")
    return s


def stream(s, name, start, end, rate, count, speed=1.2, spread=1.0, along="x"):
    """A source at one place, from which people walk to a sink at the other."""
    (x0, y0), (x1, y1) = start, end
    a = math.atan2(y1 - y0, x1 - x0)
    dx, dy = (0.6, spread) if along == "x" else (spread, 0.6)
    s.person(f"{name}_first", (x0, y0, round(a, 3)), [(x1, y1)], speed, goal_radius=1.0)
    s.area(f"{name}_in", "source", round(x0 - dx, 2), round(y0 - dy, 2), round(x0 + dx, 2),
           round(y0 + dy, 2), like=f"{name}_first", rate=rate, count=count)
    s.area(f"{name}_out", "sink", round(x1 - 1.2 * dx, 2), round(y1 - 1.2 * dy, 2),
           round(x1 + 1.2 * dx, 2), round(y1 + 1.2 * dy, 2))


def parallel_traffic(level):
    s = scene("parallel_traffic", "Parallel traffic", level, "v",
              "Whether a robot moves between two streams of people, one each way",
              "Drive along the middle", "Walk in two lanes, one with and one against the robot",
              "The robot does not stop", TIME)
    width = (7.0, 5.4, 4.4)[level]
    corridor(s, 24, width)
    stream(s, "along", (1.2, 1.1), (22.6, 1.1), (0.25, 0.4, 0.6)[level], 20)
    stream(s, "against", (22.8, width - 1.1), (1.4, width - 1.1), (0.25, 0.4, 0.6)[level], 20)
    s.robot((1.5, width / 2, 0.0), (22.5, width / 2))
    s.circle("bin", 12.0, width / 2, 0.25)
    s.expects.append("4 people arrive before 60 s")
    return s


def perpendicular_traffic(level):
    s = scene("perpendicular_traffic", "Perpendicular traffic", level, "w",
              "Whether a robot crosses a stream of people", "Cross straight on",
              "Walk across the robot's way, one after another", "Standstill shorter than 5 s")
    arm = (5.0, 4.4, 4.0)[level]
    c = crossing(s, 18, arm)
    stream(s, "stream", (c, 16.6), (c, 1.4), (0.3, 0.5, 0.7)[level], 25, 1.2,
           round(arm / 2 - 0.7, 2), "y")
    s.robot((1.8, c, 0.0), (16.2, c))
    s.circle("bin", 4.2, c, 0.25)
    s.expects.append("3 people arrive before 50 s")
    return s


def circular_crossing(level):
    s = scene("circular_crossing", "Circular crossing", level, "x",
              "Whether a robot resolves a crossing at which everybody meets in the middle",
              "Cross to the opposite side", "Walk from a circle to the opposite point",
              "Everybody arrives in twice the free time")
    s.room(16, 16)
    count, radius = (3, 6, 9)[level], 6.4
    for k in range(count):
        a = math.pi + 2 * math.pi * (k + 1) / (count + 1)
        x, y = 8 + radius * math.cos(a), 8 + radius * math.sin(a)
        s.person(f"walker_{k + 1}", (round(x, 2), round(y, 2), round(math.atan2(8 - y, 8 - x), 3)),
                 [(round(16 - x, 2), round(16 - y, 2))], 1.0)
    s.robot((8 - radius, 8.0, 0.0), (8 + radius, 8.0))
    s.circle("column", 8.0, 8.0, 0.4)
    s.expects.append(f"{count} people arrive before 60 s")
    return s


def robot_crowding(level):
    s = scene("robot_crowding", "Robot crowding", level, "y",
              "What a robot does when curious people gather around it",
              "Cross the hall", "Walk up to the robot and stay near it for a while",
              "The robot waits or backs off without contact", SPACE)
    s.room(14, 10)
    crowd(s, (2, 4, 7)[level], 5.0, 1.5, 11.0, 8.5)
    for person in s.people:
        person["kind"] = "Curious"
        person["more"] = {"dist": 5.0, "duration": 8.0, "stop_dist": (1.5, 1.2, 1.0)[level]}
    s.robot((1.4, 5.0, 0.0), (12.6, 5.0))
    s.expects.append("person_1 reaches goal 1 before 30 s")
    return s


SITUATIONS = (frontal_approach, pedestrian_obstruction, pedestrian_overtaking, robot_overtaking,
              down_path, intersection_no_gesture, intersection_wait, intersection_proceed,
              blind_corner, narrow_hallway, narrow_doorway, entering_room, exiting_room,
              entering_elevator, exiting_elevator, join_group, leave_group, following_human,
              leading_human, accompanying_peer, crowd_navigation, parallel_traffic,
              perpendicular_traffic, circular_crossing, robot_crowding)


def scenes():
    return [situation(level) for situation in SITUATIONS for level in range(3)]
