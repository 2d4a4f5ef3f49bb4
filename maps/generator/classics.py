"""Standard scenes of SEAN 2.0, SocialGym 2 and the literature, in the places of the library."""

import math

from francis import NEAR, PI, SPACE, TIME, crowd, group_talk, stream
from scene import Scene, go, sequence, stand, step

SEAN = "Tsoi et al. 2022, SEAN 2.0: Formalizing and Generating Social Situations for Robot Navigation"
GYM = ("Sprague et al. 2023, SocialGym 2.0: Simulator for Multi-Agent Social Robot Navigation in "
       "Shared Human Spaces")
CLASSIC = "Gao and Huang 2022, Evaluation of Socially-Aware Robot Navigation (survey of protocols)"


def scene(name, title, family, place=None, source=CLASSIC, **card):
    metrics = card.pop("metrics", NEAR)
    difficulty = card.pop("difficulty", "normal")
    variation = card.pop("variation", "strong")
    s = Scene(name, title, family, place, f"../{place.name}/{place.name}.yaml" if place else None,
              variation)
    s.describe(card["purpose"], card["task"], card["people"], card["outcome"], source, difficulty,
               metrics)
    return s


# -- SEAN 2.0 -------------------------------------------------------------------------------------


def sean(places):
    def make(key, title, place, people, outcome, metrics=NEAR, difficulty="normal"):
        return scene("sean_" + key, title, "SEAN 2.0", places[place], SEAN,
                     purpose=f"Social situation '{key.replace('_', ' ')}' of SEAN 2.0",
                     task="Drive to the other end", people=people, outcome=outcome,
                     metrics=metrics, difficulty=difficulty)

    empty = make("empty", "Empty", "t_junction", "One person stands far from the robot's way",
                 "The shortest way at full speed", TIME, "easy")
    empty.robot("west", "south")
    empty.person("far_person", "room_4", ["room_4"], 1.0, tree=stand(60.0))
    empty.expects.append("far_person stands for 10 s before 20 s")

    cross = make("cross_path", "Cross path", "t_junction", "Cross the robot's way at the junction",
                 "The robot passes behind the people or before them with room")
    cross.robot("west", "east")
    cross.circle("bin", 15.0, 9.9, 0.25)
    cross.person("crosser", "south", ["room_2"], 1.2)
    cross.person("crosser_2", (11.0, 3.0, 1.571), ["room_4"], 1.0)
    cross.expects.append("crosser arrives before 40 s")

    down = make("down_path", "Down path", "hospital_ward", "Come towards the robot in the corridor",
                "The robot keeps to one side")
    down.robot("lift", "west_end")
    down.person("nurse", "corridor_west", ["lift"], 1.3)
    down.person("visitor", "west_end", ["room_5"], 1.0)
    down.expects.append("nurse arrives before 45 s")

    join = make("join_group", "Join group", "open_square", "Talk in a circle at the fountain",
                "The robot stops outside the circle", SPACE)
    group_talk(join, 3, 9.6, 6.0)
    join.robot("west", (7.4, 4.6))
    join.expects.append("member_1 starts ConversationFormation before 15 s")

    leave = make("leave_group", "Leave group", "lift_lobby", "Talk; one after another leaves",
                 "The robot gives way", SPACE)
    group_talk(leave, 2, 6.0, 4.0)
    leave.person("leaver", (7.4, 5.2, PI), ["lift_3_door"], 1.1, start_time=0.0,
                 tree=sequence(stand(3.0), go(leave.goal("lift_3_door")), stand(60.0)))
    leave.person("leaver_2", (7.4, 2.6, PI), ["east"], 1.0,
                 tree=sequence(stand(5.0), go(leave.goal("east")), stand(60.0)))
    leave.robot("east", "west")
    leave.circle("plant", 9.4, 6.1, 0.25)
    leave.expects.append("leaver comes within 1 m of goal 2 before 30 s")
    return [empty, cross, down, join, leave]


# -- SocialGym 2 ----------------------------------------------------------------------------------


def gym(places):
    def make(key, title, place, people, outcome="Fluent motion of all without contact", metrics=NEAR,
             difficulty="normal"):
        return scene("socialgym_" + key, title, "SocialGym 2", places.get(place), GYM,
                     purpose=f"Mini-game '{key}' of SocialGym 2", task="Drive through the scene",
                     people=people, outcome=outcome, metrics=metrics, difficulty=difficulty)

    hall = make("hallway", "Hallway", "corridor_set", "Come towards the robot in a corridor of 2 m")
    hall.robot("west_20", "east_20")
    for k in range(3):
        hall.person(f"walker_{k + 1}", (24.0 + 1.6 * k, 4.0 + 0.2 * (k % 2), PI), ["west_20"], 1.1)
    hall.expects.append("walker_1 comes within 2 m of goal 1 before 45 s")

    door = make("doorway", "Doorway", "doorway_set", "Come through the doorway of 1.2 m", difficulty="hard")
    door.robot("room_2", "room_3")
    for k in range(3):
        door.person(f"walker_{k + 1}", (18.4 + 1.2 * k, 2.6 + 1.1 * k, PI), ["room_2"], 1.0)
    door.expects.append("walker_1 comes within 2 m of goal 1 before 40 s")

    cross = make("intersection", "Intersection", "t_junction", "Come from both other corridors")
    cross.robot("south", "east")
    cross.person("from_west", "west_near", ["south"], 1.2)
    cross.person("from_east", "east_near", ["west"], 1.1)
    cross.person("from_east_2", "east", ["west_near"], 1.3)
    cross.expects.append("from_west arrives before 40 s")

    ring = make("roundabout", "Roundabout", "open_square", "Walk around the fountain", metrics=SPACE)
    ring.robot("south", "north")
    for k in range(8):
        a = 2 * math.pi * k / 8
        stops = []
        for turn in range(1, 5):
            b = a + turn * math.pi / 2
            stops.append((round(16 + 3.5 * math.cos(b), 2), round(13 + 3.5 * math.sin(b), 2)))
        ring.person(f"walker_{k + 1}", (round(16 + 3.5 * math.cos(a), 2),
                                        round(13 + 3.5 * math.sin(a), 2),
                                        round(math.atan2(math.cos(a), -math.sin(a)), 3)),
                    stops, 1.1, cyclic=True)
    ring.expects.append("walker_1 reaches goal 1 before 45 s")

    space = make("open", "Open space", "open_square", "Cross the square in all directions",
                 metrics=SPACE)
    names = ("north_west", "stall_1", "east", "bicycles", "cafe", "south_west", "north_east",
             "fountain_south")
    for k, name in enumerate(names):
        space.person(f"walker_{k + 1}", name, [names[(k + 3) % 8], name], 1.2, cyclic=True)
    space.robot("south", "stall_3")
    space.expects.append("walker_1 reaches goal 1 before 60 s")
    return [hall, door, cross, ring, space]


# -- classics -------------------------------------------------------------------------------------


def classics(places):
    def make(key, title, place, purpose, people, outcome, task="Drive to the goal", metrics=NEAR,
             difficulty="normal"):
        return scene("classic_" + key, title, "Classics", places.get(place), CLASSIC,
                     purpose=purpose, task=task, people=people, outcome=outcome, metrics=metrics,
                     difficulty=difficulty)

    made = []
    s = make("frontal", "Frontal encounter", "corridor_set", "Passing in a corridor of 3 m",
             "Two people abreast come towards the robot", "The robot passes at the side")
    s.robot("west_30", "east_30")
    s.person("left_one", (27.0, 8.9, PI), [(2.0, 8.9)], 1.2, group=1)
    s.person("right_one", (27.0, 8.2, PI), [(2.0, 8.2)], 1.2, group=1)
    s.groups[1] = "pair"
    s.expects.append("left_one comes within 2 m of goal 1 before 45 s")
    made.append(s)

    s = make("crossing", "Crossing at a right angle", "station_concourse", "Order of passing",
             "Walk from the shops to the tickets across the robot's way", "No stop longer than 3 s")
    s.robot("entrance", (25.0, 11.8))
    for k in range(4):
        s.person(f"traveller_{k + 1}", (14.0 + 1.2 * k, 2.6 + 0.9 * (k % 3), 1.571),
                 [(13.2 + 0.8 * k, 17.0)], 1.2, kind_of_body="luggage" if k % 2 else "adult")
    s.expects.append("traveller_1 arrives before 45 s")
    made.append(s)

    s = make("overtaking", "Overtaking a slow walker", "school_corridor", "Overtaking in 2 m",
             "An elderly person walks slowly ahead, one comes towards the robot",
             "The robot overtakes when the way is clear", metrics=TIME)
    s.robot("west", "east")
    s.person("slow", (4.0, 7.0, 0.0), ["east"], 0.5, kind_of_body="elderly")
    s.person("oncoming", "east", ["west"], 1.2)
    s.expects.append("oncoming arrives before 45 s")
    made.append(s)

    s = make("circle", "Circle", None, "Symmetry: all cross in the middle",
             "Walk from a circle to the opposite points", "All arrive without contact", metrics=SPACE,
             difficulty="hard")
    s.room(16, 16)
    for k in range(7):
        a = math.pi + 2 * math.pi * (k + 1) / 8
        x, y = 8 + 6.4 * math.cos(a), 8 + 6.4 * math.sin(a)
        s.person(f"walker_{k + 1}", (round(x, 2), round(y, 2), round(math.atan2(8 - y, 8 - x), 3)),
                 [(round(16 - x, 2), round(16 - y, 2))], 1.1)
    s.robot((1.6, 8.0, 0.0), (14.4, 8.0))
    s.expects.append("7 people arrive before 60 s")
    made.append(s)

    s = make("parallel_traffic", "Traffic in both directions", "corridor_set",
             "Lanes in a corridor of 4 m", "Two streams, one each way", "The robot joins its lane",
             metrics=TIME)
    y = 14.2
    stream(s, "east", (2.2, y - 0.9), (27.6, y - 0.9), 0.3, 15)
    stream(s, "west", (27.8, y + 0.9), (2.4, y + 0.9), 0.3, 15)
    s.robot("west_40", "east_40")
    s.expects.append("3 people arrive before 60 s")
    made.append(s)

    s = make("perpendicular_traffic", "Crossing a stream", "street_crossing",
             "Crossing a stream of people", "Walk along the street that the robot crosses",
             "The robot finds a gap")
    stream(s, "north", (14.2, 2.0), (14.2, 24.0), 0.4, 25, 1.3, 2.0, "y")
    s.robot("west", "east")
    s.expects.append("3 people arrive before 50 s")
    made.append(s)

    s = make("blind_corner", "Blind corner between shelves", "supermarket",
             "Corners that hide people", "Come out of the aisles with a trolley", "Slow at the corners")
    s.robot((5.0, 11.5, 0.0), "cross_east")
    for k in range(4):
        s.person(f"customer_{k + 1}", f"aisle_{k + 1}", [(8.0 + 3.0 * k, 14.0), f"aisle_{k + 1}"],
                 1.1, cyclic=True)
    s.expects.append("customer_1 reaches goal 1 before 20 s")
    made.append(s)

    s = make("doorway", "Doorway of 0.9 m", "doorway_set", "Passing a door that fits one",
             "Come through the same door", "One passes at a time", difficulty="hard")
    s.robot((11.4, 5.4, PI), "room_1")
    s.person("visitor_1", "room_1", ["room_2"], 1.1)
    s.person("visitor_2", "far_1", ["room_2"], 1.0)
    s.expects.append("visitor_1 arrives before 30 s")
    made.append(s)

    s = make("chase", "Chase", "open_square", "People who run after each other do not look around",
             "Two children chase each other across the robot's way", "The robot slows down",
             difficulty="hard")
    s.robot("south", "stall_2")
    s.person("chased", "south_west", ["north_east", "west", "bicycles", "stall_1"], 1.8, cyclic=True,
             kind_of_body="child", radius=0.25)
    s.person("chaser", (3.4, 2.4, 0.8), ["north_east"], 1.8, kind_of_body="child", radius=0.25,
             tree=step("FollowAgent", target_agent_id=1, duration="120.0", closest_dist="1.2",
                       max_vel="1.8"))
    s.person("parent", "fountain_south", ["fountain_south"], 1.0, tree=stand(120.0))
    s.expects.append("chaser comes within 2.5 m of chased from 5 to 30 s")
    made.append(s)

    s = make("bottleneck", "Bottleneck", None, "A crowd leaves through one opening",
             "Leave the room through an opening of 1.6 m", "The robot does not block the opening",
             "Leave the room with the crowd", SPACE, "hard")
    s.room(18, 8)
    s.wall("south", (9, 0), (9, 3.2))
    s.wall("north", (9, 4.8), (9, 8))
    crowd(s, 12, 3.0, 1.0, 8.0, 7.0, False)
    for k, person in enumerate(s.people):
        person["goals"] = [s.goal(16.5, 1.5 + 1.0 * (k % 6))]
        person["pose"][2] = 0.0
    used = sorted({g for p in s.people for g in p["goals"]})
    s.goals = [s.goals[g - 1] for g in used]
    for person in s.people:
        person["goals"] = [used.index(g) + 1 for g in person["goals"]]
    s.robot((1.5, 4.0, 0.0), (16.0, 4.0))
    s.expects.append("8 people arrive before 60 s")
    made.append(s)
    return made


def scenes(places):
    return {"sean": sean(places), "socialgym": gym(places), "classics": classics(places)}
