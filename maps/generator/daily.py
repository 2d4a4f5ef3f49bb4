"""Daily life in every place. Together these scenarios use every node for people."""

from francis import NEAR, PI, SPACE, TIME, group_talk, stream
from scene import Scene, do, go, node, once, say, select, sequence, stand, step, walk

SOURCE = "HuNavSim Desktop; a scene of daily life in the manner of Francis et al. 2025, section 6"


def scene(places, place, key, title, people, outcome, metrics=NEAR, difficulty="normal"):
    s = Scene(f"{place}_{key}", title, "Daily life", places[place])
    s.describe(f"Service robot in daily life: {title.lower()}", "Drive to the goal of its errand",
               people, outcome, SOURCE, difficulty, metrics)
    return s


def repeat(child):
    """A tree that never ends: the child again and again."""
    return node("KeepRunningUntilFailure", node("ForceSuccess", child))


def delayed(seconds, child):
    return node("TimeDelay", child, delay=f"{seconds}")


def talk(goal, others, seconds):
    return node("ConversationFormation", main_agent_id="{id}", goal_id=goal,
                conversation_duration=f"{seconds}", non_main_agent_ids=others, time_step="{dt}")


def house_morning(places):
    s = scene(places, "family_house", "morning", "Morning in a family",
              "Breakfast, a child that is curious about the robot, someone in the bath",
              "The robot brings its load to the kitchen without frightening the child")
    s.robot("front_door", "kitchen")
    stove, sofa, bath = s.goal("stove"), s.goal("sofa"), s.goal("bath")
    s.person("mother", "bedroom", ["stove"], 1.1,
             tree=sequence(do("UseObject", goal_id=bath, duration="4.0"), go(stove),
                           do("UseObject", goal_id=stove, duration="20.0")))
    s.person("father", "study", ["sofa"], 1.0,
             tree=sequence(stand(2.0), go(s.goal("hall")), say("Good morning"), go(sofa), stand(30.0)))
    s.person("child", "child", ["living"], 1.0, kind_of_body="child", radius=0.25,
             tree=select(node("Sequence", do("IsRobotVisible", distance="4.0"),
                              node("Inverter", node("TimeExpiredCondition", seconds="6.0", ts="{dt}",
                                                    only_once="true")),
                              step("CuriousNav", agent_vel="0.8", stop_distance="1.0")),
                         walk()))
    s.expects += ["mother starts UseObject before 15 s", 'father says "Good morning" before 40 s']
    return s


def house_guests(places):
    s = scene(places, "family_house", "guests", "Guests arrive",
              "The host opens the door, greets the guests and leads them to the living room",
              "The robot leaves the hall free", SPACE)
    s.robot("kitchen", "bedroom")
    hall, living, sofa = s.goal("hall"), s.goal("living"), s.goal("sofa")
    s.person("host", "living", ["living"], 1.1,
             tree=sequence(go(s.goal(12.0, 5.05)), node("LookAtAgent", observer_id="{id}", target_id=2),
                           say("Come in"), go(hall), go(living), stand(30.0)))
    listen = step("IsSpeaking", target_id=1, distance_threshold="6.0", duration="30.0")
    s.person("guest_1", "front_door", ["living"], 1.0,
             tree=sequence(listen, step("FollowAgent", target_agent_id=1, duration="25.0",
                                        closest_dist="1.2"), go(sofa), stand(30.0)))
    s.person("guest_2", "hall", ["sofa"], 0.9, kind_of_body="elderly",
             tree=sequence(step("FollowAgent", target_agent_id=2, duration="40.0",
                                closest_dist="1.0"), stand(10.0)))
    s.expects += ['host says "Come in" before 30 s', "guest_1 hears host before 32 s"]
    return s


def office_morning(places):
    s = scene(places, "office_floor", "mail_round", "Mail round in an office",
              "Work at desks, fetch coffee, talk in the aisle", "The robot brings mail to meeting 3")
    s.robot("entrance", "meeting_3")
    coffee, printer = s.goal("coffee"), s.goal("printer")
    for k, (start, back) in enumerate((("desks_east", "aisle_east"), ("desks_middle", "aisle_north"),
                                       ("desks_west", "aisle_south"), ("lobby", "kitchenette"))):
        target = (coffee, printer)[k % 2]
        s.person(f"colleague_{k + 1}", start, [back], 1.2,
                 tree=node("ProbabilityChoice", do("UseObject", goal_id=target, duration="4.0"),
                           go(s.goal(back)), stand(3.0), weights="3;2;1"))
    s.expects.append("colleague_1 comes within 3 m of goal 1 before 90 s")
    return s


def office_meeting(places):
    s = scene(places, "office_floor", "meeting_ends", "A meeting ends",
              "Six people leave a meeting room; two stay and talk at its door",
              "The robot passes the talking people outside their circle", SPACE)
    s.robot("printer", "desks_west")
    centre = s.goal(9.4, 9.9)
    s.person("chair", "meeting_2", [(9.4, 9.9)], 1.1,
             tree=sequence(talk(centre, "2", 25.0), go(s.goal("desks_middle")), stand(30.0)))
    s.person("speaker", (10.0, 12.3, -1.571), ["desks_west"], 1.0)
    for k, goal in enumerate(("aisle_east", "coffee", "aisle_south", "lobby")):
        s.person(f"colleague_{k + 1}", (2.4 + 0.8 * k, 12.2, -1.571), [goal], 1.2)
    s.expects += ["chair starts ConversationFormation before 15 s", "2 people arrive before 60 s"]
    return s


def ward_visiting(places):
    s = scene(places, "hospital_ward", "visiting_hours", "Visiting hours",
              "Visitors look for rooms, nurses hurry, one visitor asks at the desk",
              "The robot takes medicine to room 2 and lets nurses pass")
    s.robot("lift", "room_2")
    desk = s.goal("station")
    s.person("visitor_1", "corridor_east", ["room_4"], 1.0,
             tree=sequence(do("WaitInQueue", goal_id=desk, spacing="0.9", duration="4.0"),
                           go(s.goal("room_4")), stand(40.0)))
    s.person("visitor_2", "corridor_west", ["room_6"], 0.9,
             tree=sequence(do("WaitInQueue", goal_id=desk, spacing="0.9", duration="4.0",
                              patience="20.0"), go(s.goal("room_6")), stand(40.0)))
    s.person("nurse", "room_1", ["room_5", "room_1"], 1.5, cyclic=True,
             tree=select(do("YieldToRobot", distance="2.5", patience="1.0"), walk()))
    s.person("patient", "room_3", ["room_3"], 0.5, kind_of_body="wheelchair", radius=0.4,
             tree=sequence(go(s.goal("corridor_west")), stand(5.0), go(s.goal("room_3")), stand(10.0)))
    s.person("doctor", "room_7", ["room_8"], 1.3)
    s.expects += ["visitor_1 starts WaitInQueue before 15 s", "visitor_1 ends WaitInQueue before 30 s",
                  "doctor arrives before 45 s"]
    return s


def ward_emergency(places):
    s = scene(places, "hospital_ward", "emergency", "Emergency on the ward",
              "Staff run to a room; a bystander steps back", "The robot clears the corridor",
              TIME, "hard")
    s.robot("west_end", "lift")
    room = s.goal("room_5")
    for k, start in enumerate(("station", "corridor_west", "room_6")):
        s.person(f"staff_{k + 1}", start, ["room_5"], 1.8)
    s.person("bystander", "corridor_east", ["corridor_east"], 1.0,
             tree=select(node("Sequence", node("IsAgentClose", observer_id="{id}", target_agent_id=1,
                                               threshold="3.0"),
                              once(say("Careful")),
                              do("FleeFrom", target_agent_id=1, safe_distance="3.0", duration="4.0",
                                 speed="1.2")), stand(0.2)))
    s.expects += [f"staff_1 comes within 2 m of goal {room} before 25 s",
                  'bystander says "Careful" before 25 s']
    return s


def storage_picking(places):
    s = scene(places, "storage_hall", "picking", "Order picking",
              "Workers fetch goods from racks and pack them", "The robot crosses the aisles with care")
    s.robot("gate_1", "packing_2")
    for k in range(5):
        rack, table = f"rack_{1 + (2 * k) % 8}", ("packing", "packing_2")[k % 2]
        a, b = s.goal(rack), s.goal(table)
        s.person(f"picker_{k + 1}", f"rack_{(1, 3, 5, 7, 8)[k]}", [rack, table], 1.3,
                 tree=repeat(sequence(do("UseObject", goal_id=a, duration="3.0"),
                                      node("Cooldown", say("Order complete"), duration="20.0")
                                      if k == 0 else stand(0.5),
                                      do("UseObject", goal_id=b, duration="4.0"))))
    s.expects += ["picker_1 starts UseObject before 15 s", "picker_1 says before 60 s"]
    return s


def storage_shift(places):
    s = scene(places, "storage_hall", "shift_change", "Shift change",
              "Workers leave through the office while others come in",
              "The robot finishes its way against the flow", NEAR, "hard")
    s.robot("office", "gate_2")
    for k in range(4):
        s.person(f"leaving_{k + 1}", f"rack_{k + 1}", [(27.0, 17.4)], 1.3)
    for k in range(4):
        s.person(f"coming_{k + 1}", (26.2 + 0.9 * (k % 2), 16.2 + 1.1 * (k // 2), -1.571),
                 [f"rack_{k + 5}"], 1.3)
    s.expects.append("4 people arrive before 60 s")
    return s


def storage_story(places):
    s = scene(places, "storage_hall", "two_workers", "Two workers, after the paper of HuNavSim 2.0",
              "One checks racks and waits for the other, who calls; both leave together",
              "The robot passes while the workers look at it")
    rack, rack_2, last, place = (s.goal("rack_1"), s.goal("rack_5"), s.goal("middle_north"),
                                 s.goal("east_aisle"))
    s.robot("west_aisle", "packing")
    s.person("worker_1", "south_west", ["rack_1"], 1.4,
             tree=sequence(go(rack), do("LookAtPoint", goal_id=rack_2), stand(3.0), go(place),
                           step("IsLookingAtMe", target_id=2, distance_threshold="15.0",
                                angle_threshold="0.3", duration="60.0"),
                           step("FollowAgent", target_agent_id=2, duration="30.0")))
    s.person("worker_2", "middle_south", ["rack_5"], 1.4,
             tree=sequence(go(rack_2), do("LookAtPoint", goal_id=rack), stand(4.0), go(last),
                           node("RetryUntilSuccessful",
                                node("IsAtPosition", agent_id=1, goal_id=place, tolerance="0.6"), num_attempts="100"),
                           node("LookAtAgent", observer_id="{id}", target_id=1, yaw_tolerance="0.02"),
                           stand(1.0), once(say("Follow me")), go(s.goal("office")), stand(20.0)))
    s.expects += ["worker_1 comes within 1 m of goal 4 before 60 s",
                  'worker_2 says "Follow me" before 90 s']
    return s


def factory_shift(places):
    s = scene(places, "factory_hall", "production", "Production",
              "Operate machines, fetch tools, warn each other", "The robot supplies the cell")
    s.robot("gate_west", "cell_gate")
    for k, (machine, store) in enumerate((("lathe_1", "lathe_2"), ("press_1", "press_2"),
                                          ("lathe_3", "tool_store"), ("press_3", "line_1"))):
        a, b = s.goal(machine), s.goal(store)
        s.person(f"worker_{k + 1}", machine, [machine, store], 1.2,
                 tree=sequence(do("UseObject", goal_id=a, duration=f"{3 + k}.0"), go(b), stand(2.0)))
    s.person("foreman", "break", ["aisle_middle"], 1.2,
             tree=select(node("Sequence", do("IsRobotVisible", distance="8.0"),
                              node("Cooldown", node("Sequence", do("LookAtRobot"),
                                                    say("Mind the robot")), duration="15.0")),
                         do("PassOnSide", side="left", distance="4.0", clearance="1.0"),
                         walk()))
    s.expects.append("worker_1 starts UseObject before 15 s")
    return s


def factory_drill(places):
    s = scene(places, "factory_hall", "evacuation_drill", "Evacuation drill",
              "An alarm; everybody leaves by the nearest exit", "The robot stays out of the way of those who leave",
              SPACE, "hard")
    s.robot("lathe_2", "tool_store")
    s.area("exit_west", "exit", 0.3, 5.8, 1.8, 8.2)
    s.area("exit_right", "exit", 27.6, 4.0, 29.6, 6.4)
    s.person("warden", "aisle_middle", ["aisle_middle"], 1.2,
             tree=sequence(once(say("Alarm! Leave the hall")), do("GoToNearestExit"), stand(60.0)))
    for k, start in enumerate(("lathe_1", "lathe_3", "press_1", "press_2", "line_1", "cell_gate",
                               "tool_store", "break", "north_aisle")):
        s.person(f"worker_{k + 1}", start, ["aisle_middle"], 1.4,
                 tree=sequence(select(once(step("IsAnyoneSpeaking", distance_threshold="20.0",
                                                duration="3.0")), stand(0.1)),
                               do("GoToNearestExit"), stand(60.0)))
    s.expects += ["warden says before 15 s", "worker_3 enters exit_west before 30 s",
                  "3 people enter exit_west before 60 s"]
    return s


def museum_tour(places):
    s = scene(places, "museum", "guided_tour", "Guided tour",
              "A guide leads a group from exhibit to exhibit and explains",
              "The robot passes the group outside its circle", SPACE)
    s.robot("entrance", "bench")
    stops = [s.goal("dinosaur"), s.goal("paintings"), s.goal("hall_north")]
    s.person("guide", "hall", ["dinosaur"], 0.9, group=1,
             tree=sequence(node("SetGroupWalk", main_agent_id="{id}", non_main_agent_ids="2,3,4",
                                time_step="{dt}", duration="6.0"),
                           go(stops[0]), say("This one is 70 million years old"), stand(6.0),
                           go(stops[1]), stand(6.0), go(stops[2]), stand(20.0)))
    for k in range(3):
        s.person(f"visitor_{k + 1}", (12.2 + 0.8 * k, 6.0, 1.571), ["dinosaur"], 1.0, group=1,
                 tree=select(step("FollowAgent", target_agent_id=1, duration="60.0",
                                  closest_dist=f"{1.2 + 0.3 * k:.1f}"), stand(1.0)))
    s.groups[1] = "tour"
    s.expects.append("guide says before 40 s")
    return s


def museum_quiet(places):
    s = scene(places, "museum", "quiet_afternoon", "Quiet afternoon",
              "Visitors wander through the galleries and look at exhibits",
              "The robot does not cross in front of people who look at an exhibit")
    s.robot("cash_desk", "case_1")
    s.area("east_gallery", "wait", 17.8, 0.6, 25.4, 8.6)
    s.area("west_gallery", "wait", 0.6, 0.6, 8.2, 8.6)
    for k, area in enumerate(("west_gallery", "west_gallery", "east_gallery", "east_gallery")):
        s.person(f"visitor_{k + 1}", ("statues", "statue_1", "vases", "vase_1")[k], ["hall"], 0.8,
                 tree=sequence(do("WanderInArea", area=area, duration=f"{8 + 2 * k}.0"), stand(3.0),
                               go(s.goal("hall"))))
    s.person("guard", "hall_north", ["cases", "hall"], 0.8, cyclic=True,
             tree=select(node("Sequence", do("IsRobotClose", threshold="2.5"),
                              do("IsRobotFacingAgent"), do("StopMovement"), do("LookAtRobot")),
                         node("Sequence", do("ResumeMovement"), walk())))
    s.expects.append("visitor_1 starts WanderInArea before 15 s")
    return s


def supermarket_rush(places):
    s = scene(places, "supermarket", "checkout_queue", "Queue at the checkouts",
              "Shop, queue at two checkouts and leave", "The robot passes behind the queue")
    s.robot("dairy", "exit")
    first, second = s.goal("checkout_1"), s.goal("checkout_2")
    for k in range(6):
        queue = (first, second)[k % 2]
        start = ("aisle_1", "aisle_2", "aisle_3", "aisle_4", "cross", "fruit")[k]
        s.person(f"customer_{k + 1}", start, ["exit"], 1.1,
                 tree=sequence(do("WaitInQueue", goal_id=queue, spacing="1.0", duration="5.0"),
                               go(s.goal(1.4 + 0.5 * k, 2.6)), stand(60.0)))
    s.expects += ["customer_1 ends WaitInQueue before 60 s"]
    return s


def supermarket_shopping(places):
    s = scene(places, "supermarket", "shopping", "Saturday shopping",
              "Families shop; a child is scared of the robot", "The robot keeps away from the child")
    s.robot("entrance", "cold")
    for k in range(5):
        goals = ["fruit", f"aisle_{1 + k % 4}", "cold_west", "dairy"]
        goals = goals[k % 4:] + goals[:k % 4]
        s.person(f"customer_{k + 1}", goals[-1] if k < 4 else "cross_east", goals, 1.0, cyclic=True,
                 wait=[3.0] * 4, kind_of_body=("adult", "adult", "elderly", "luggage", "adult")[k])
    s.person("child", "fruit_2", ["cross"], 1.0, kind="Scared", kind_of_body="child", radius=0.25)
    s.expects.append("customer_1 reaches goal 1 before 110 s")
    return s


def station_rush(places):
    s = scene(places, "station_concourse", "rush_hour", "Rush hour",
              "Travellers stream between entrance and platforms; some buy tickets",
              "The robot reaches the tickets without blocking the streams", NEAR, "hard")
    stream(s, "arriving", (2.0, 11.4), (30.6, 10.6), 0.5, 30, 1.4, 0.8)
    stream(s, "leaving", (30.8, 7.4), (2.0, 8.6), 0.4, 25, 1.3, 0.5)
    tickets = s.goal("tickets")
    for k in range(3):
        s.person(f"buyer_{k + 1}", (5.0 + 1.5 * k, 14.6, 1.571), ["gates"], 1.1,
                 tree=sequence(do("WaitInQueue", goal_id=tickets, spacing="1.0", duration="6.0"),
                               go(s.goal("gates_north")), stand(60.0)))
    s.robot("information", "machines")
    s.expects += ["buyer_1 starts WaitInQueue before 15 s"]
    return s


def station_waiting(places):
    s = scene(places, "station_concourse", "waiting", "Waiting for a train",
              "Two meet, talk and walk on together; a traveller asks around",
              "The robot keeps out of the circle", SPACE)
    s.robot("entrance_2", "shops")
    centre = s.goal(13.0, 7.6)
    s.person("friend_1", "seats", [(13.0, 7.6)], 1.1,
             tree=sequence(do("WaitForAgent", target_agent_id=2, distance="4.0", duration="40.0"),
                           talk(centre, "2", 12.0),
                           node("SetGroupId", agent_id="{id}", group_id=7), go(s.goal("kiosk_south")),
                           stand(30.0)))
    s.person("friend_2", "hall", [(13.0, 7.6)], 1.2,
             tree=sequence(go(centre), node("SetGroupId", agent_id="{id}", group_id=7),
                           select(node("Sequence", do("IsAgentGroupFormed", distance="2.0"),
                                       go(s.goal("kiosk_south"))), go(s.goal(17.8, 7.4))),
                           stand(30.0)))
    s.person("stranger", "information", ["kiosk"], 1.0,
             tree=sequence(do("FindNearestAgent", target_agent_id="{nearest}"),
                           step("ApproachAgent", target_agent_id="{nearest}", closest_dist="1.2",
                                max_vel="1.2", duration="20.0"),
                           node("LookAtAgent", observer_id="{id}", target_id="{nearest}"),
                           say("Which platform, please?"), go(s.goal("gates_south")), stand(30.0)))
    s.person("listener", "kiosk_south", ["kiosk_south"], 1.0,
             tree=sequence(node("RetryUntilSuccessful",
                                step("IsAnyoneLookingAtMe", distance_threshold="8.0",
                                     angle_threshold="0.4", duration="10.0"), num_attempts="-1"),
                           say("Hello"), stand(30.0)))
    s.expects += ["friend_1 starts ConversationFormation before 45 s",
                  'stranger says "Which platform, please?" before 60 s']
    return s


def crossing_traffic(places):
    s = scene(places, "street_crossing", "green_light", "Green light",
              "Wait at the kerb, then cross all at once", "The robot crosses with the others", NEAR, "hard")
    s.robot("south_west", "north_east")
    for k, (start, end) in enumerate((("south_east", "north_west"), ("north_west", "south_east"),
                                      ("north_east", "south_west"), ("west", "east_south"),
                                      ("south", "north"))):
        goal = s.goal(end)
        s.person(f"walker_{k + 1}", start, [end], 1.3,
                 tree=select(node("Sequence", node("IsTimeBetween", from_="0.0", until="4.0"),
                                stand(0.2)), sequence(go(goal), stand(60.0))))
    s.expects += ["walker_1 never leaves", f"walker_1 comes within 1 m of goal 1 before 40 s"]
    return s


def crossing_bus(places):
    s = scene(places, "street_crossing", "bus_stop", "At the bus stop",
              "Some wait for the bus; others walk past", "The robot passes the waiting people")
    s.robot("east_south", "south")
    for k in range(4):
        s.person(f"waiting_{k + 1}", (19.6 + 0.9 * k, 10.2 + 0.3 * (k % 2), 1.571),
                 [(19.6 + 0.9 * k, 10.2)], 0.8,
                 tree=sequence(stand(20.0 + k), go(s.goal(19.6 + 0.9 * k, 11.6)), stand(60.0)))
    s.person("passer_1", "north", ["south"], 1.3)
    s.person("passer_2", "west", ["east_south"], 1.2)
    s.expects += ["waiting_1 stands for 10 s before 15 s", "passer_1 arrives before 45 s"]
    return s


def school_break(places):
    s = scene(places, "school_corridor", "break", "Break",
              "Pupils run from the classrooms through the corridor", "The robot waits at the wall", SPACE, "hard")
    s.robot("west", "class_4")
    for k in range(8):
        room = f"class_{1 + k}"
        target = ("east", "west", "corridor_middle", "corridor_east")[k % 4]
        s.person(f"pupil_{k + 1}", room, [target, room], 1.5, cyclic=True, kind_of_body="child",
                 radius=0.25)
    s.person("teacher", "corridor_middle", ["corridor_middle"], 1.0,
             tree=select(node("Sequence", do("IsCrowded", distance="2.5", count="2"),
                              node("Cooldown", say("Slowly, please"), duration="10.0")),
                         sequence(go(s.goal("corridor_east")), go(s.goal("corridor_middle")))))
    s.expects += ["pupil_1 reaches goal 1 before 40 s", "teacher says before 60 s"]
    return s


def school_lesson(places):
    s = scene(places, "school_corridor", "lessons_begin", "Lessons begin",
              "Teachers go to their rooms; a late pupil runs; one is dared to block the robot",
              "The robot waits until the way is free again", TIME)
    s.robot("east", "class_1")
    for k in range(3):
        s.person(f"teacher_{k + 1}", ("west", "corridor_west", "corridor_middle")[k],
                 [f"class_{k + 5}"], 1.1)
    s.person("late_one", (4.8, 7.0, 0.0), ["class_4"], 1.8, kind_of_body="child", radius=0.25)
    s.person("bold_one", "corridor_east", ["corridor_east"], 1.0, kind_of_body="child", radius=0.25,
             tree=select(node("Sequence", do("IsRobotVisible", distance="5.0"),
                              node("RunOnce", step("BlockRobot", front_dist="1.2", duration="5.0"))),
                         stand(0.2)))
    s.expects += ["teacher_1 arrives before 30 s", "late_one arrives before 30 s"]
    return s


def airport_boarding(places):
    s = scene(places, "airport_gate", "boarding", "Boarding",
              "Queue at two gates and board", "The robot passes between the queues")
    s.robot("west", "queue_2")
    s.robots[0]["goal"] = (28.9, 11.0)
    gate_1, gate_2 = s.goal("gate_1"), s.goal("gate_2")
    for k in range(8):
        s.person(f"traveller_{k + 1}", (3.0 + 1.9 * k, 8.4 + 0.8 * (k % 2), 0.0), ["boarded"], 1.2,
                 kind_of_body=("luggage", "adult")[k % 2],
                 tree=sequence(do("WaitInQueue", goal_id=(gate_1, gate_2)[k % 2], spacing="1.0",
                                  duration="3.0"),
                               go(s.goal(24.1, 14.6) if k % 2 == 0 else s.goal(28.9, 16.4)),
                               stand(60.0)))
    s.area("walkway", "speed", 16.0, 4.2, 25.0, 6.0, carry_speed=0.65)
    s.person("rider", "walkway_in", ["walkway_out"], 1.1, kind_of_body="luggage")
    s.expects += ["traveller_8 starts WaitInQueue before 20 s", "rider arrives before 20 s"]
    return s


def airport_last_call(places):
    s = scene(places, "airport_gate", "last_call", "Last call",
              "Late travellers run to the gate; one is threatening towards the robot, one surprised",
              "The robot gives way", NEAR, "hard")
    s.robot("east", "shop")
    for k in range(3):
        s.person(f"late_{k + 1}", ("west", "hall", "shop_2")[k], ["gate_2"], 1.8,
                 kind_of_body="luggage")
    s.person("angry_one", "hall_east", ["walkway_out"], 1.1, kind="Threatening", duration=6.0)
    s.person("surprised_one", "seats_3", ["west"], 1.0, kind="Surprised", duration=6.0)
    s.person("scared_one", "walkway_in", ["hall"], 1.0, kind="Scared", duration=8.0)
    s.area("walkway", "speed", 16.0, 4.2, 25.0, 6.0, carry_speed=0.65)
    s.expects.append("late_2 comes within 2 m of goal 1 before 40 s")
    return s


def corridors_night(places):
    s = scene(places, "corridor_set", "cleaning", "Cleaning shift",
              "Cleaners work in the corridors and take turns with the robot", "The robot chooses a free corridor",
              TIME)
    s.robot("lobby_west", "lobby_east")
    for k, key in enumerate(("20", "30", "40")):
        a, b = s.goal(f"west_{key}"), s.goal(f"east_{key}")
        s.person(f"cleaner_{k + 1}", f"middle_{key}", [f"west_{key}", f"east_{key}"], 0.6,
                 tree=repeat(sequence(go(a), stand(1.0), go(b))))
    s.person("guard", "lobby_east", ["lobby_west", "lobby_east"], 1.1, cyclic=True,
             tree=select(node("Sequence", do("IsRobotClose", threshold="2.0"),
                                            step("AvoidRobot", safe_distance="2.5", duration="2.0",
                                                 runaway_vel="1.0")),
                         walk()))
    s.expects.append("cleaner_1 comes within 1 m of goal 1 before 60 s")
    return s


def doors_house_move(places):
    s = scene(places, "doorway_set", "moving_day", "Moving day",
              "Carry boxes through the doors; a door is closed for a while", "The robot waits at the door", TIME, "hard")
    s.robot("room_4", "room_6")
    s.door("inner_door", 16.0, 10.0, 16.0, 11.0, True, (12.0, 18.0))
    for k, (start, end) in enumerate((("room_1", "room_5"), ("room_3", "room_5"), ("room_2", "room_4"))):
        a, b = s.goal(end), s.goal(start)
        s.person(f"carrier_{k + 1}", start, [end, start], 1.0, kind_of_body="luggage",
                 tree=repeat(sequence(go(a), stand(3.0), go(b), stand(2.0))))
    s.expects.append("carrier_1 comes within 1 m of goal 1 before 60 s")
    return s


def junction_interest(places):
    s = scene(places, "t_junction", "new_robot", "The new robot",
              "Employees react to a robot that they do not know", "The robot stays predictable", SPACE)
    s.robot("south", "west")
    s.person("curious_one", "west_near", ["east"], 1.0,
             tree=select(node("Sequence", do("IsRobotVisible", distance="5.0"),
                              node("Inverter", node("TimeExpiredCondition", seconds="6.0", ts="{dt}",
                                                    only_once="true")),
                              step("CuriousNav", agent_vel="0.8", stop_distance="1.4")),
                         walk()))
    s.person("surprised_one", "east_near", ["west"], 1.0,
             tree=select(node("Sequence", do("IsRobotVisible", distance="4.0"),
                              node("Inverter", node("TimeExpiredCondition", seconds="4.0", ts="{dt}",
                                                    only_once="true")), step("SurprisedNav")),
                         walk()))
    s.person("scared_one", "east", ["room_1"], 1.0,
             tree=select(node("Sequence", do("IsRobotVisible", distance="4.0"),
                              node("Inverter", node("TimeExpiredCondition", seconds="5.0", ts="{dt}",
                                                    only_once="true")),
                              step("ScaredNav", runaway_vel="1.0", safe_distance="3.0")),
                         walk()))
    s.person("angry_one", "room_2", ["room_4"], 1.0,
             tree=select(node("Sequence", do("IsRobotVisible", distance="4.0"),
                              node("Inverter", node("TimeExpiredCondition", seconds="4.0", ts="{dt}",
                                                    only_once="true")),
                              step("ThreateningNav", goal_dist="1.4")),
                         walk()))
    s.expects.append("curious_one comes within 2 m of goal 1 before 40 s")
    return s


def lobby_evening(places):
    s = scene(places, "lift_lobby", "going_home", "Going home",
              "People come out of the lifts; some greet at the reception", "The robot enters the lift last")
    s.robot("entrance", "lift_2")
    reception = s.goal("reception")
    for k in range(3):
        s.person(f"employee_{k + 1}", f"lift_{k + 1}", ["entrance"], 1.2)
    s.person("visitor", "west", ["reception"], 1.0,
             tree=sequence(do("WaitInQueue", goal_id=reception, spacing="0.8", duration="8.0"),
                           node("RandomChanceCondition", probability="0.5"),
                           go(s.goal("sofa")), stand(30.0)))
    s.person("pushy_one", "stairs", ["sofa"], 1.0,
             tree=sequence(node("RetryUntilSuccessful",
                                node("IsAgentVisible", observer_id="{id}", agent_id=1, distance="6.0",
                                     field_of_view="3.0"), num_attempts="-1"),
                           step("BlockAgent", target_agent_id=1, front_dist="1.0", duration="3.0"),
                           go(s.goal("sofa")), stand(30.0)))
    s.expects += ["employee_1 arrives before 30 s", "visitor starts WaitInQueue before 15 s"]
    return s


def square_market(places):
    s = scene(places, "open_square", "market_day", "Market day",
              "Stroll between stalls, queue, sit at the fountain", "The robot delivers to the café", SPACE, "hard")
    s.robot("north_east", "cafe")
    for k in range(3):
        stall = s.goal(f"stall_{k + 1}")
        for j in range(2):
            s.person(f"buyer_{2 * k + j + 1}", (17.0 + 3.4 * k + 1.2 * j, 18.6 - 0.9 * j, 1.571),
                     [f"stall_{k + 1}"], 1.1,
                     tree=sequence(do("WaitInQueue", goal_id=stall, spacing="0.9", duration="6.0"),
                                   go(s.goal("east") if j else s.goal("west")), stand(5.0)))
    s.area("round_fountain", "wait", 12.6, 17.0, 19.4, 20.4)
    for k in range(3):
        s.person(f"stroller_{k + 1}", (12.9 + 1.8 * k, 19.9 - 1.2 * (k % 2), 0.0), ["west"], 0.9,
                 tree=do("WanderInArea", area="round_fountain"))
    s.expects += ["stroller_1 starts WanderInArea before 20 s"]
    return s


def square_musician(places):
    s = scene(places, "open_square", "street_music", "Street music",
              "Passers-by stop to listen to a musician; the goals are set by their trees",
              "The robot passes behind the audience", SPACE)
    s.robot("north_west", "south_east")
    spot = s.goal("fountain_south")
    s.person("musician", "fountain_south", ["fountain_south"], 0.8,
             tree=sequence(delayed(1.0, say("A song for you")), stand(10.0)))
    for k, (start, end) in enumerate((("west", "south_east"), ("south", "east"), ("bicycles", "cafe"))):
        near = s.goal(14.4 + 1.4 * k, 7.4)
        goal = s.goal(end)
        s.person(f"passer_{k + 1}", start, [(14.4 + 1.4 * k, 7.4), end], 1.1,
                 tree=select(node("Sequence",
                                  once(do("SetGoal", goal_id=near)),
                                  node("Inverter", once(do("SetGoal", goal_id=goal)))),
                             node("Sequence", node("IsAgentClose", observer_id="{id}",
                                                   target_agent_id=1, threshold="2.8"),
                                  node("RunOnce", node("LookAtAgent", observer_id="{id}", target_id=1,
                                                       yaw_tolerance="0.1")),
                                  node("RunOnce", stand(6.0))),
                             walk()))
    s.expects.append("musician says before 15 s")
    return s


DAYS = (house_morning, house_guests, office_morning, office_meeting, ward_visiting, ward_emergency,
        storage_picking, storage_shift, storage_story, factory_shift, factory_drill, museum_tour,
        museum_quiet, supermarket_rush, supermarket_shopping, station_rush, station_waiting,
        crossing_traffic, crossing_bus, school_break, school_lesson, airport_boarding,
        airport_last_call, corridors_night, doors_house_move, junction_interest, lobby_evening,
        square_market, square_musician)


def scenes(places):
    return [day(places) for day in DAYS]
