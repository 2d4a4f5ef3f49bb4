"""The places of the library. Each function draws one; points are starts and goals of scenarios."""

from place import Place

PI = 3.142


def family_house():
    p = Place("family_house", 14, 10, "House of a family: living room, kitchen, bedrooms, bath")
    p.wall(5.6, 0.2, 5.6, 10)  # living room | hall
    p.wall(5.6, 4.2, 13.8, 4.2)
    p.wall(5.6, 5.9, 13.8, 5.9)  # hall between both
    p.wall(9.2, 0.2, 9.2, 4.2)
    p.wall(9.4, 5.9, 9.4, 10)
    p.wall(0.2, 5.4, 5.6, 5.4)  # kitchen above the living room
    p.door(5.6, 5.05, 1.1, "y")
    p.door(5.6, 7.2, 1.0, "y")
    p.wall(5.6, 8.0, 7.0, 8.0)
    p.wall(7.0, 7.4, 7.0, 10)
    p.door(7.0, 8.9, 0.01, "y")
    p.door(2.9, 5.4, 1.8, "x")
    p.door(7.4, 4.2, 1.0, "x")
    p.door(11.2, 4.2, 1.0, "x")
    p.door(8.2, 5.9, 1.0, "x")
    p.door(11.4, 5.9, 1.0, "x")
    p.clear(13.7, 4.5, 14.0, 5.6)  # front door
    p.rect(13.9, 4.5, 14.0, 5.6)
    p.sofa(0.3, 1.2, 1.2, 3.4, "w")  # living room
    p.sofa(1.6, 0.3, 3.6, 1.1, "s")
    p.block(2.0, 1.9, 3.0, 2.7)
    p.block(4.9, 1.4, 5.3, 3.4)  # television
    p.plant(0.6, 4.9)
    p.plant(5.1, 0.6)
    p.block(0.2, 9.3, 4.6, 9.8)  # kitchen
    p.block(0.2, 6.4, 0.8, 9.3)
    p.table(3.0, 7.3, 1.6, 0.9, 2)
    p.bed(7.2, 1.3, "s")  # bedroom
    p.bed(8.2, 1.3, "s")
    p.block(5.8, 3.3, 6.4, 4.0)
    p.bed(12.9, 1.3, "s")  # child's room
    p.desk(9.8, 1.2, "e")
    p.block(9.4, 3.6, 10.2, 4.0)
    p.block(7.2, 9.1, 9.1, 9.8)  # bath
    p.block(8.9, 6.2, 9.25, 6.8)
    p.block(5.8, 8.2, 6.8, 9.8)
    p.desk(12.6, 9.2, "s")  # study
    p.shelf(9.6, 6.5, 9.95, 9.6)
    p.plant(13.4, 6.4)
    p.point("front_door", 13.0, 5.05, PI)
    p.point("hall", 8.0, 5.05, PI)
    p.point("living", 3.9, 3.4, 0.0)
    p.point("sofa", 2.2, 4.3, -1.5)
    p.point("kitchen", 4.7, 8.4, PI)
    p.point("stove", 1.5, 8.4, 1.571)
    p.point("bedroom", 7.4, 3.2, -1.571)
    p.point("child", 11.3, 2.6, 1.571)
    p.point("bath", 8.0, 7.6, 1.571)
    p.point("study", 11.3, 8.0, 0.0)
    return p


def office_floor():
    p = Place("office_floor", 24, 16, "Floor of an office: desks, glass meeting rooms, kitchenette")
    for x in (6.0, 12.0):  # meeting rooms
        p.glass(x, 11.5, x, 15.9)
    p.glass(0.2, 11.5, 18.0, 11.5)
    p.wall(18.0, 10.2, 18.0, 15.9)
    for x in (4.9, 10.9, 16.9):
        p.door(x, 11.5, 1.1, "x")
    p.table(2.7, 13.7, 2.6, 1.2, 3)
    p.table(8.7, 13.7, 2.6, 1.2, 3)
    p.round_table(14.6, 13.8, 0.7, 6)
    p.block(18.1, 15.2, 23.8, 15.8)  # kitchenette
    p.round_table(21.0, 12.6, 0.45, 4, 0.8)
    p.round_table(22.8, 11.0, 0.35, 3, 0.5)
    p.door(18.0, 11.0, 1.4, "y")
    for x in (3.0, 7.0, 11.0, 15.0):  # desks, two by two
        for y in (3.0, 6.8):
            p.desk(x, y + 0.42, "n")
            p.desk(x, y - 0.42, "s")
            p.desk(x + 1.62, y + 0.42, "n")
            p.desk(x + 1.62, y - 0.42, "s")
    p.wall(19.2, 0.2, 19.2, 6.0)  # lobby
    p.door(19.2, 4.6, 1.6, "y")
    p.block(20.4, 3.6, 22.6, 4.2)  # reception
    p.block(22.0, 3.6, 22.6, 5.4)
    p.sofa(20.0, 0.3, 22.0, 1.1, "s")
    p.plant(23.4, 6.2)
    p.plant(19.6, 5.6, 0.2)
    p.shelf(19.4, 7.4, 19.8, 9.4)
    p.block(23.0, 7.6, 23.7, 8.8)  # printer
    p.clear(23.7, 1.8, 24.0, 3.2)
    p.rect(23.9, 1.8, 24.0, 3.2)
    p.point("entrance", 23.0, 2.4, PI)
    p.point("lobby", 20.4, 2.4, PI)
    p.point("desks_east", 17.9, 5.0, PI)
    p.point("desks_middle", 9.8, 5.0, PI)
    p.point("desks_west", 1.2, 5.0, 0.0)
    p.point("aisle_north", 9.0, 9.8, 0.0)
    p.point("aisle_south", 9.0, 1.2, 0.0)
    p.point("meeting_1", 4.9, 12.4, 2.3)
    p.point("meeting_2", 10.9, 12.4, 2.3)
    p.point("meeting_3", 16.9, 12.4, 2.3)
    p.point("kitchenette", 19.3, 12.8, 0.8)
    p.point("coffee", 19.6, 14.5, 1.571)
    p.point("printer", 22.3, 8.2, 0.0)
    p.point("aisle_east", 18.4, 8.6, PI)
    return p


def hospital_ward():
    p = Place("hospital_ward", 26, 15, "Ward of a hospital: rooms with beds on both sides, nurses' station")
    p.wall(0.2, 5.6, 25.8, 5.6)
    p.wall(0.2, 8.4, 25.8, 8.4)
    for x in (5.2, 10.4, 15.6, 20.8):
        p.wall(x, 0.2, x, 5.6)
        if x != 15.6:
            p.wall(x, 8.4, x, 14.8)
    for k, x in enumerate((2.6, 7.8, 13.0, 18.2, 23.4)):
        p.door(x + 1.5, 5.6, 1.3, "x")
        p.bed(x - 1.35, 1.4, "s")
        p.bed(x + 0.75, 1.4, "s")
        p.block(x - 0.6, 0.3, x - 0.1, 0.8)
        p.block(x - 2.35, 4.6, x - 1.6, 5.4)
        if k not in (2, 3):
            p.door(x + 1.5, 8.4, 1.3, "x")
            p.bed(x - 1.35, 13.6, "n")
            p.bed(x + 0.75, 13.6, "n")
            p.block(x - 0.6, 14.2, x - 0.1, 14.7)
            p.block(x - 2.35, 8.6, x - 1.6, 9.3)
    p.clear(10.5, 8.2, 20.7, 8.6)  # open nurses' station
    p.block(12.4, 9.2, 18.4, 9.7)
    p.block(12.4, 9.7, 12.9, 11.6)
    p.block(17.9, 9.7, 18.4, 11.6)
    p.desk(15.4, 11.0, "s")
    p.shelf(10.6, 14.2, 20.6, 14.7)
    p.block(0.3, 6.0, 0.9, 6.9)
    p.block(10.8, 5.75, 12.4, 6.2)  # trolleys in the corridor
    p.block(19.8, 7.85, 21.2, 8.25)
    p.point("lift", 24.9, 7.0, PI)
    p.point("corridor_east", 18.0, 7.0, PI)
    p.point("station", 15.4, 8.4, 1.571)
    p.point("corridor_west", 6.0, 7.0, 0.0)
    p.point("west_end", 1.8, 7.2, 0.0)
    p.point("behind_desk", 15.4, 12.9, -1.571)
    for name, x, y in (("room_1", 2.6, 3.6), ("room_2", 7.8, 3.6), ("room_3", 13.0, 3.6),
                       ("room_4", 18.2, 3.6), ("room_5", 23.4, 3.6)):
        p.point(name, x, y, -1.571)
    for name, x, y in (("room_6", 2.6, 11.0), ("room_7", 7.8, 11.0), ("room_8", 23.4, 11.0)):
        p.point(name, x, y, 1.571)
    return p


def storage_hall():
    p = Place("storage_hall", 30, 20, "Warehouse: rows of racks, packing tables, loading gates, office")
    for k in range(5):
        y = 3.2 + 2.9 * k
        p.shelf(6.0, y, 14.0, y + 1.0)
        p.shelf(16.4, y, 23.4, y + 1.0)
    for x in (7.0, 11.5, 16.0):  # gates at the south wall
        p.clear(x, 0.1, x + 3.0, 0.2)
    p.block(3.2, 0.9, 4.3, 1.9)
    p.block(10.2, 0.6, 11.2, 1.6)
    p.block(14.6, 0.5, 15.6, 1.5)
    p.turned_block(20.4, 1.3, 1.4, 1.0, 0.35)
    p.wall(25.4, 13.6, 25.4, 19.8)  # office
    p.wall(25.4, 13.6, 29.8, 13.6)
    p.door(26.6, 13.6, 1.2, "x")
    p.desk(28.6, 18.6, "s")
    p.desk(28.6, 16.4, "s")
    p.shelf(25.6, 18.6, 26.0, 19.7)
    for y in (4.2, 7.2, 10.2):  # packing tables
        p.block(27.6, y, 29.0, y + 1.2)
    p.block(26.4, 1.0, 28.6, 2.2)  # forklift
    p.rect(28.6, 1.2, 29.5, 1.35)
    p.rect(28.6, 1.85, 29.5, 2.0)
    p.block(1.0, 17.8, 3.0, 18.8)
    p.block(0.6, 9.0, 1.7, 10.1)
    p.block(0.6, 12.2, 1.7, 13.3)
    p.point("west_aisle", 3.6, 10.0, 0.0)
    p.point("north_west", 4.6, 18.2, 0.0)
    p.point("south_west", 4.8, 2.4, 0.0)
    p.point("middle_north", 15.2, 18.2, -1.571)
    p.point("middle_south", 15.2, 2.3, 1.571)
    for k in range(4):
        p.point(f"rack_{k + 1}", 9.5, 5.15 + 2.9 * k, 0.0)
        p.point(f"rack_{k + 5}", 20.0, 5.15 + 2.9 * k, PI)
    p.point("packing", 26.6, 7.8, 0.0)
    p.point("packing_2", 26.6, 10.8, 0.0)
    p.point("east_aisle", 24.6, 10.0, -1.571)
    p.point("office", 27.0, 15.2, 1.571)
    p.point("gate_1", 8.5, 1.4, 1.571)
    p.point("gate_2", 13.0, 1.4, 1.571)
    p.point("gate_3", 17.5, 1.4, 1.571)
    return p


def factory_hall():
    p = Place("factory_hall", 30, 18, "Factory: machines, a conveyor, a fenced robot cell, tool store")
    for k in range(3):  # lathes at the north wall
        x = 3.0 + 4.2 * k
        p.block(x, 15.0, x + 2.4, 16.6)
        p.block(x + 0.2, 16.8, x + 0.9, 17.4)
        p.rect(x + 2.4, 15.4, x + 2.7, 16.0)
    p.block(3.0, 8.6, 17.0, 9.4)  # conveyor with rollers
    for k in range(27):
        p.rect(3.3 + 0.5 * k, 8.6, 3.36 + 0.5 * k, 9.4)
    p.block(5.0, 10.0, 6.0, 10.8)
    p.block(9.5, 10.0, 10.5, 10.8)
    p.block(14.0, 10.0, 15.0, 10.8)
    p.glass(20.4, 7.2, 20.4, 13.0)  # robot cell
    p.glass(20.4, 13.0, 26.6, 13.0)
    p.glass(26.6, 7.2, 26.6, 13.0)
    p.glass(20.4, 7.2, 26.6, 7.2)
    p.disc(23.5, 10.2, 0.6)
    p.disc(23.5, 10.2, 0.45, 205)
    p.turned(24.2, 10.6, 1.8, 0.3, 0.6)
    p.block(21.2, 11.4, 22.6, 12.6)
    for k in range(4):  # presses in the south
        x = 3.4 + 3.6 * k
        p.block(x, 3.4, x + 1.6, 5.4)
        p.disc(x + 0.8, 4.4, 0.4)
    p.wall(19.8, 0.2, 19.8, 4.6)  # tool store
    p.wall(19.8, 4.6, 26.0, 4.6)
    p.door(22.0, 4.6, 1.4, "x")
    for y in (0.9, 2.4):
        p.shelf(20.6, y, 25.2, y + 0.5)
    p.column(18.4, 6.2)
    p.column(18.4, 13.6)
    p.column(9.0, 13.0)
    p.block(28.4, 14.6, 29.6, 17.4)
    p.block(28.6, 1.0, 29.6, 3.4)
    p.point("gate_west", 1.2, 7.0, 0.0)
    p.point("aisle_west", 3.0, 7.0, 0.0)
    p.point("aisle_middle", 11.0, 7.0, 0.0)
    p.point("aisle_east", 19.3, 6.0, 0.0)
    p.point("cross_north", 18.6, 12.0, 1.571)
    p.point("north_aisle", 11.0, 14.2, PI)
    p.point("lathe_1", 4.2, 14.2, 1.571)
    p.point("lathe_2", 8.4, 14.2, 1.571)
    p.point("lathe_3", 12.6, 14.2, 1.571)
    p.point("press_1", 6.0, 2.4, 0.0)
    p.point("press_2", 13.2, 2.4, 0.0)
    p.point("press_3", 9.6, 6.2, -1.571)
    p.point("cell_gate", 27.8, 10.0, PI)
    p.point("tool_store", 23.0, 3.6, -1.571)
    p.point("exit_east", 28.6, 5.2, PI)
    p.point("break", 26.0, 15.6, 0.0)
    p.point("line_1", 7.8, 10.6, -1.571)
    p.point("line_2", 12.2, 10.6, -1.571)
    return p


def museum():
    p = Place("museum", 26, 18, "Museum: four galleries around a hall, exhibits, benches, cash desk")
    p.wall(8.6, 0.2, 8.6, 17.8)
    p.wall(17.4, 0.2, 17.4, 17.8)
    p.wall(0.2, 9.0, 8.6, 9.0)
    p.wall(17.4, 9.0, 25.8, 9.0)
    for y in (4.5, 13.5):
        p.door(8.6, y, 2.0, "y")
        p.door(17.4, y, 2.0, "y")
    p.door(2.6, 9.0, 2.0, "x")
    p.door(23.4, 9.0, 2.0, "x")
    for x, y in ((2.4, 2.4), (2.4, 6.4), (6.0, 2.2), (6.0, 6.6)):  # statues
        p.column(x, y, 0.9)
        p.disc(x, y, 0.3, 205)
    for x, y in ((1.6, 12.0), (1.6, 15.0), (5.0, 12.0), (5.0, 15.0)):  # show cases
        p.block(x, y, x + 1.8, y + 0.8)
    p.disc(13.0, 11.0, 1.5)  # the dinosaur
    p.disc(13.0, 11.0, 1.35, 205)
    p.turned(13.0, 11.0, 2.4, 0.2, 0.5)
    p.turned(13.0, 11.0, 1.4, 0.15, 2.1)
    p.block(11.6, 15.4, 14.4, 15.9)
    p.block(10.4, 2.6, 11.0, 5.0)  # cash desk
    p.block(11.0, 2.6, 12.2, 3.1)
    for x, y in ((19.6, 2.4), (23.0, 2.4), (21.2, 5.0), (19.4, 7.2), (24.0, 7.0)):
        p.disc(x, y, 0.5)
        p.disc(x, y, 0.35, 205)
    p.block(20.0, 13.2, 22.6, 13.7)  # benches
    p.block(20.0, 16.9, 23.0, 17.7)
    p.wall(21.4, 9.1, 21.4, 11.6)
    p.column(10.0, 8.0, 0.5)
    p.column(16.0, 8.0, 0.5)
    p.column(10.0, 14.2, 0.5)
    p.column(16.0, 14.2, 0.5)
    p.clear(13.9, 0.0, 16.1, 0.3)
    p.rect(13.9, 0.0, 16.1, 0.1)
    p.point("entrance", 15.0, 1.2, 1.571)
    p.point("cash_desk", 12.6, 4.4, PI)
    p.point("hall", 13.0, 7.0, 1.571)
    p.point("dinosaur", 15.5, 11.0, PI)
    p.point("dinosaur_west", 10.4, 11.0, 0.0)
    p.point("hall_north", 13.0, 14.2, -1.571)
    p.point("statues", 4.2, 4.5, PI)
    p.point("statue_1", 2.4, 4.4, -1.571)
    p.point("cases", 4.2, 13.9, PI)
    p.point("case_1", 2.4, 11.0, 1.571)
    p.point("vases", 21.4, 7.2, -1.571)
    p.point("vase_1", 21.2, 3.4, 1.571)
    p.point("paintings", 19.4, 11.6, 1.571)
    p.point("bench", 21.2, 15.2, -1.571)
    return p


def supermarket():
    p = Place("supermarket", 26, 18, "Supermarket: shelves, checkouts, fruit, cold counter")
    for k in range(5):
        x = 6.0 + 3.0 * k
        p.shelf(x, 6.2, x + 1.0, 10.6)
        p.shelf(x, 12.4, x + 1.0, 15.4)
    p.block(5.0, 17.0, 20.0, 17.8)  # cold counter
    p.block(24.9, 6.0, 25.8, 15.6)
    for k in range(4):  # checkouts
        x = 11.0 + 2.6 * k
        p.block(x, 2.4, x + 0.7, 4.6)
        p.rect(x + 0.7, 2.6, x + 1.0, 3.2)
    for x, y in ((2.2, 6.4), (2.2, 9.4), (2.2, 12.4)):  # fruit stands
        p.block(x - 0.9, y - 0.9, x + 0.9, y + 0.9)
        p.rect(x - 0.9, y - 0.05, x + 0.9, y + 0.05)
    p.rect(4.4, 1.2, 4.5, 4.6)  # entrance rail
    p.block(5.6, 0.3, 9.0, 0.9)  # trolleys
    for k in range(9):
        p.rect(5.6 + 0.4 * k, 0.3, 5.66 + 0.4 * k, 0.9)
    p.block(22.6, 0.6, 25.4, 1.4)
    p.block(21.8, 16.6, 25.4, 17.6)
    p.clear(1.4, 0.0, 3.6, 0.3)
    p.rect(1.4, 0.0, 3.6, 0.1)
    p.point("entrance", 2.5, 1.2, 1.571)
    p.point("fruit", 4.2, 8.0, PI)
    p.point("fruit_2", 4.2, 11.0, PI)
    for k in range(4):
        p.point(f"aisle_{k + 1}", 8.0 + 3.0 * k, 8.4, 1.571)
        p.point(f"checkout_{k + 1}", 12.5 + 2.6 * k, 5.2, -1.571)
    p.point("cross", 12.5, 11.5, 0.0)
    p.point("cross_east", 21.6, 11.5, PI)
    p.point("cold", 12.5, 16.3, 1.571)
    p.point("cold_west", 5.4, 16.2, 1.571)
    p.point("dairy", 23.6, 11.0, 0.0)
    p.point("exit", 9.6, 1.8, PI)
    p.point("behind_checkouts", 16.3, 1.4, PI)
    return p


def station_concourse():
    p = Place("station_concourse", 36, 20, "Station: ticket counters, gates, columns, kiosks, seats")
    for x in (7.5, 15.0, 22.5, 30.0):
        for y in (6.4, 13.4):
            p.column(x, y, 0.8)
    for k in range(5):  # ticket counters
        x = 3.0 + 2.2 * k
        p.block(x, 18.4, x + 1.8, 19.0)
        p.rect(x + 1.9, 18.4, x + 2.0, 19.8)
    for k in range(9):  # gates to the platforms
        p.block(26.8, 4.2 + 1.5 * k, 28.2, 4.5 + 1.5 * k)
    p.wall(27.5, 0.2, 27.5, 4.2)
    p.wall(27.5, 16.4, 27.5, 19.8)
    for y in (2.0, 9.4, 16.8):  # platforms' stairs
        p.block(31.6, y - 0.7, 35.0, y + 0.7)
        for k in range(11):
            p.rect(31.6 + 0.3 * k, y - 0.7, 31.66 + 0.3 * k, y + 0.7)
    p.block(17.4, 9.0, 20.4, 11.2)  # kiosk
    p.rect(17.4, 10.0, 20.4, 10.1)
    p.seats(9.0, 9.4, 6, "x", True)
    p.seats(9.0, 3.6, 6, "x", True)
    p.block(16.6, 0.3, 24.4, 1.1)  # shops
    p.wall(20.4, 0.2, 20.4, 1.6)
    for k in range(4):  # ticket machines
        p.block(15.6 + 1.3 * k, 19.1, 16.4 + 1.3 * k, 19.7)
    p.disc(4.0, 5.0, 0.6)  # information
    p.disc(4.0, 5.0, 0.45, 205)
    p.clear(0.0, 7.5, 0.3, 12.5)
    p.rect(0.0, 7.5, 0.1, 12.5)
    p.point("entrance", 1.4, 10.0, 0.0)
    p.point("entrance_2", 1.4, 8.4, 0.0)
    p.point("tickets", 8.0, 17.0, 1.571)
    p.point("machines", 17.4, 17.8, 1.571)
    p.point("information", 5.6, 6.4, -2.4)
    p.point("hall", 14.0, 11.8, 0.0)
    p.point("kiosk", 18.9, 12.4, -1.571)
    p.point("kiosk_south", 18.9, 7.8, 1.571)
    p.point("seats", 10.6, 7.6, 0.0)
    p.point("shops", 22.4, 2.4, -1.571)
    p.point("gates", 25.6, 9.6, 0.0)
    p.point("gates_south", 25.6, 5.2, 0.0)
    p.point("gates_north", 25.6, 15.2, 0.0)
    p.point("platform_1", 30.4, 4.0, 0.0)
    p.point("platform_2", 30.4, 11.6, 0.0)
    p.point("platform_3", 30.4, 16.6, 0.0)
    p.point("stairs_1", 35.4, 4.6, PI)
    p.point("stairs_3", 34.8, 13.2, PI)
    return p


def street_crossing():
    p = Place("street_crossing", 26, 26, "Crossing of two streets: houses at the corners, cars, lights", 0.0)
    for x0, x1 in ((0.0, 6.4), (19.6, 26.0)):  # houses with entrances
        for y0, y1 in ((0.0, 6.4), (19.6, 26.0)):
            p.block(x0, y0, x1, y1)
            p.rect(x0, (y0 + y1) / 2 - 0.05, x1, (y0 + y1) / 2 + 0.05)
    for x, y in ((8.7, 8.7), (17.3, 8.7), (8.7, 17.3), (17.3, 17.3)):  # lights at the kerbs
        p.disc(x, y, 0.12)
    for x, y in ((2.2, 8.7), (5.2, 8.7), (20.8, 17.3), (23.8, 17.3)):  # trees
        p.disc(x, y, 0.3)
        p.disc(x, y, 0.12, 205)
    for y in (1.6, 6.2, 21.4):  # parked cars, along the street to the north
        p.block(9.4, y - 1.0, 11.0, y + 3.0 - 0.2)
        p.rect(9.5, y + 1.6, 10.9, y + 1.7)
        p.rect(9.5, y - 0.3, 10.9, y - 0.2)
    for x in (1.2, 20.6):
        p.block(x, 15.0, x + 3.8, 16.6)
        p.rect(x + 1.2, 15.1, x + 1.3, 16.5)
        p.rect(x + 2.9, 15.1, x + 3.0, 16.5)
    p.block(20.4, 7.2, 23.2, 7.9)  # bus stop
    p.rect(20.2, 6.9, 23.4, 7.0)
    p.disc(7.4, 21.0, 0.25)
    p.block(6.6, 2.0, 7.3, 3.4)  # news stand
    p.point("south_west", 7.6, 7.6, 0.8)
    p.point("south_east", 18.4, 7.6, 2.4)
    p.point("north_west", 7.6, 18.4, -0.8)
    p.point("north_east", 18.4, 18.4, -2.4)
    p.point("west", 1.2, 7.4, 0.0)
    p.point("west_north", 1.2, 18.4, 0.0)
    p.point("east", 24.8, 18.6, PI)
    p.point("east_south", 24.8, 8.8, PI)
    p.point("south", 18.2, 1.2, 1.571)
    p.point("north", 18.2, 24.8, -1.571)
    p.point("south_2", 8.2, 1.2, 1.571)
    p.point("north_2", 8.2, 24.8, -1.571)
    p.point("middle", 13.4, 13.0, 0.0)
    p.point("bus_stop", 21.8, 8.8, 1.571)
    return p


def school_corridor():
    p = Place("school_corridor", 30, 14, "School: corridor with lockers between classrooms")
    p.wall(0.2, 5.6, 29.8, 5.6)
    p.wall(0.2, 8.4, 29.8, 8.4)
    for x in (7.5, 15.0, 22.5):
        p.wall(x, 0.2, x, 5.6)
        p.wall(x, 8.4, x, 13.8)
    for k in range(4):
        x = 0.2 + 7.5 * k
        p.door(x + 6.2, 5.6, 1.2, "x")
        p.door(x + 6.2, 8.4, 1.2, "x")
        p.block(x + 0.6, 0.8, x + 1.3, 2.6)  # teachers' desks
        p.block(x + 0.6, 11.4, x + 1.3, 13.2)
        for column in range(3):
            for row in range(2):
                dx, dy = x + 2.4 + 1.5 * column, 1.0 + 1.5 * row
                p.block(dx, dy, dx + 0.55, dy + 1.0)
                p.disc(dx + 0.8, dy + 0.5, 0.18)
                p.block(dx, 13.0 - dy, dx + 0.55, 14.0 - dy)
                p.disc(dx + 0.8, 13.5 - dy, 0.18)
        for y0 in (5.7, 7.9):  # lockers
            p.block(x + 0.8, y0, x + 4.8, y0 + 0.4)
            for locker in range(10):
                p.rect(x + 0.8 + 0.4 * locker, y0, x + 0.84 + 0.4 * locker, y0 + 0.4)
    p.point("west", 1.0, 7.0, 0.0)
    p.point("corridor_west", 6.4, 7.0, 0.0)
    p.point("corridor_middle", 13.9, 7.0, 0.0)
    p.point("corridor_east", 21.4, 7.0, PI)
    p.point("east", 28.9, 7.0, PI)
    for k in range(4):
        p.point(f"class_{k + 1}", 6.0 + 7.5 * k, 4.6, -1.571)
        p.point(f"class_{k + 5}", 6.0 + 7.5 * k, 9.4, 1.571)
        p.point(f"board_{k + 1}", 2.0 + 7.5 * k, 4.5, PI)
    return p


def airport_gate():
    p = Place("airport_gate", 30, 18, "Airport: two gates with desks and queues, seats, shop")
    for k in range(3):
        p.seats(3.0, 10.4 + 2.1 * k, 9, "x", True)
        p.seats(11.4, 10.4 + 2.1 * k, 8, "x", True)
    for x in (20.2, 26.2):  # gates
        p.block(x, 15.4, x + 1.8, 16.0)
        p.wall(x - 1.0, 17.0, x - 1.0, 17.8)
        p.wall(x + 2.8, 17.0, x + 2.8, 17.8)
    for x in (19.0, 24.9):  # barriers of the queues
        for k in range(2):
            p.rect(x + 1.5 * k, 11.0, x + 0.06 + 1.5 * k, 14.2)
            for post in range(3):
                p.disc(x + 0.03 + 1.5 * k, 11.0 + 1.6 * post, 0.1)
    p.wall(0.2, 5.2, 11.0, 5.2)  # shop
    p.wall(11.0, 0.2, 11.0, 2.0)
    p.door(8.8, 5.2, 2.6, "x")
    for x in (1.8, 4.2, 6.6):
        p.shelf(x, 1.4, x + 0.7, 4.0)
    p.block(8.6, 1.0, 10.2, 1.6)
    p.block(16.0, 3.4, 25.0, 4.2)  # moving walkway
    p.block(16.0, 6.0, 25.0, 6.2)
    for x in (13.6, 28.0):
        p.column(x, 7.6, 0.7)
    p.plant(11.6, 5.6)
    p.plant(29.2, 1.0)
    p.round_table(27.6, 2.6, 0.4, 3)
    p.round_table(25.8, 1.3, 0.4, 3, 0.6)
    p.point("west", 1.2, 7.6, 0.0)
    p.point("east", 28.9, 8.9, PI)
    p.point("hall", 13.0, 9.2, 0.0)
    p.point("hall_east", 22.0, 8.0, PI)
    p.point("gate_1", 21.1, 14.8, 1.571)
    p.point("gate_2", 27.1, 14.8, 1.571)
    p.point("queue_1", 19.8, 10.2, 1.571)
    p.point("queue_2", 25.6, 10.2, 1.571)
    p.point("seats_1", 5.0, 12.0, 0.0)
    p.point("seats_2", 13.0, 14.1, 0.0)
    p.point("seats_3", 9.6, 9.2, 0.0)
    p.point("shop", 9.0, 3.2, PI)
    p.point("shop_2", 3.4, 4.5, 0.0)
    p.point("walkway_in", 15.0, 5.1, 0.0)
    p.point("walkway_out", 26.2, 5.1, PI)
    p.point("cafe", 27.0, 4.2, -1.571)
    p.point("boarded", 24.1, 16.6, 1.571)
    return p


def corridor_set():
    p = Place("corridor_set", 30, 18, "Four corridors of 1.6, 2.0, 3.0 and 4.0 m between two lobbies")
    low = 0.2
    for width, thick in ((1.6, 1.2), (2.0, 1.2), (3.0, 1.2), (4.0, None)):
        middle = low + width / 2
        p.point(f"west_{int(10 * width)}", 2.0, middle, 0.0)
        p.point(f"east_{int(10 * width)}", 28.0, middle, PI)
        p.point(f"middle_{int(10 * width)}", 15.0, middle, 0.0)
        low += width
        if thick is not None:
            p.block(4.2, low, 25.8, low + thick)
            low += thick
    p.block(4.2, low, 25.8, 17.8)
    for x in (8.0, 15.0, 22.0):  # doors of rooms beside the widest corridor
        p.block(x, low, x + 1.0, low + 0.5)
    p.plant(0.6, 17.3)
    p.plant(29.4, 17.3)
    p.seats(0.4, 14.6, 3, "y")
    p.block(28.9, 14.4, 29.7, 16.0)
    p.point("lobby_west", 1.9, 16.0, 0.0)
    p.point("lobby_east", 27.6, 15.4, PI)
    return p


def doorway_set():
    p = Place("doorway_set", 24, 14, "Rooms joined by doorways of 0.9, 1.0, 1.2, 1.6 and 2.4 m")
    p.wall(8.0, 0.2, 8.0, 13.8)
    p.wall(16.0, 0.2, 16.0, 13.8)
    p.wall(0.2, 7.0, 23.8, 7.0)
    p.door(8.0, 3.5, 0.9, "y")
    p.door(16.0, 3.5, 1.2, "y")
    p.door(8.0, 10.5, 1.6, "y")
    p.door(16.0, 10.5, 1.0, "y")
    p.door(4.0, 7.0, 1.2, "x")
    p.door(20.0, 7.0, 1.6, "x")
    p.door(12.0, 7.0, 2.4, "x")
    p.table(3.0, 1.3, 1.6, 0.8, 2)
    p.shelf(0.3, 8.2, 0.8, 11.0)
    p.desk(6.6, 13.0, "s")
    p.sofa(10.4, 0.3, 13.4, 1.1, "s")
    p.round_table(10.2, 12.4, 0.5, 4)
    p.plant(15.3, 13.2)
    p.desk(22.8, 1.6, "w")
    p.shelf(17.6, 13.3, 21.6, 13.7)
    p.point("room_1", 3.0, 4.0, 0.0)
    p.point("room_2", 12.0, 4.0, 0.0)
    p.point("room_3", 20.0, 4.0, PI)
    p.point("room_4", 3.0, 10.0, 0.0)
    p.point("room_5", 12.0, 10.0, 0.0)
    p.point("room_6", 20.0, 10.0, PI)
    p.point("far_1", 1.4, 5.6, 0.0)
    p.point("far_3", 22.6, 5.6, PI)
    p.point("far_4", 2.2, 12.6, 0.0)
    p.point("far_6", 22.6, 8.4, PI)
    return p


def t_junction():
    p = Place("t_junction", 22, 15, "Two corridors of 2.4 m that meet in a T, with rooms behind glass")
    p.block(0.2, 0.2, 9.8, 8.4)
    p.block(12.2, 0.2, 21.8, 8.4)
    p.wall(0.2, 10.9, 21.8, 10.9)
    for x in (5.5, 11.0, 16.5):
        p.wall(x, 10.9, x, 14.8)
    for x in (2.0, 7.6, 14.0, 19.0):
        p.door(x, 10.9, 1.0, "x")
    p.desk(4.3, 13.9, "s")
    p.desk(9.6, 13.9, "s")
    p.table(13.4, 13.5, 1.6, 0.9, 2)
    p.shelf(20.0, 14.2, 21.6, 14.6)
    p.plant(0.6, 8.9, 0.2)
    p.plant(21.4, 8.9, 0.2)
    p.point("west", 1.6, 9.6, 0.0)
    p.point("east", 20.4, 9.6, PI)
    p.point("south", 11.0, 1.2, 1.571)
    p.point("middle", 11.0, 9.6, -1.571)
    p.point("west_near", 6.0, 9.6, 0.0)
    p.point("east_near", 16.0, 9.6, PI)
    p.point("south_near", 11.0, 5.0, 1.571)
    p.point("room_1", 2.0, 12.4, -1.571)
    p.point("room_2", 7.6, 12.4, -1.571)
    p.point("room_4", 19.0, 12.4, -1.571)
    return p


def lift_lobby():
    p = Place("lift_lobby", 16, 12, "Lobby with three lifts, reception and stairs")
    p.wall(0.2, 8.6, 15.8, 8.6)
    for k, x in enumerate((2.4, 6.4, 10.4)):  # cabins of 2.6 x 2.3 m
        p.wall(x - 1.4, 8.6, x - 1.4, 11.2)
        p.wall(x + 1.4, 8.6, x + 1.4, 11.2)
        p.wall(x - 1.4, 11.2, x + 1.4, 11.2)
        p.door(x, 8.6, 1.3, "x")
        p.rect(x - 1.4, 11.2, x + 1.4, 12)
        p.point(f"lift_{k + 1}", x, 10.0, -1.571)
        p.point(f"lift_{k + 1}_door", x, 7.6, 1.571)
    p.rect(0.2, 8.6, 1.0, 12)
    p.rect(3.8, 8.6, 5.0, 12)
    p.rect(7.8, 8.6, 9.0, 12)
    p.rect(11.8, 8.6, 12.4, 12)
    p.clear(13.0, 8.5, 15.4, 8.7)  # stairs
    for k in range(9):
        p.rect(12.8, 9.4 + 0.3 * k, 15.8, 9.46 + 0.3 * k)
    p.block(12.4, 9.4, 15.8, 11.8)
    for k in range(8):
        p.rect(12.4, 9.4 + 0.3 * k, 15.8, 9.46 + 0.3 * k)
    p.block(1.2, 2.4, 1.8, 5.4)  # reception
    p.block(0.2, 4.8, 1.8, 5.4)
    p.sofa(11.6, 0.3, 14.0, 1.1, "s")
    p.sofa(15.0, 1.4, 15.7, 3.4, "e")
    p.round_table(13.2, 2.2, 0.4, 0)
    p.plant(15.3, 0.7)
    p.plant(0.6, 8.0)
    p.plant(8.4, 8.1, 0.2)
    p.clear(6.4, 0.0, 8.6, 0.3)
    p.rect(6.4, 0.0, 8.6, 0.1)
    p.point("entrance", 7.5, 1.0, 1.571)
    p.point("reception", 2.8, 3.8, PI)
    p.point("lobby", 7.5, 4.4, 1.571)
    p.point("sofa", 11.8, 2.6, 0.0)
    p.point("east", 14.8, 5.8, PI)
    p.point("west", 1.4, 6.6, 0.0)
    p.point("stairs", 14.2, 8.0, 1.571)
    return p


def open_square():
    p = Place("open_square", 32, 26, "Square in a town: fountain, benches, trees, market stalls, café tables", 0.0)
    p.rect(0.0, 25.4, 32.0, 26.0)  # fronts of houses
    p.rect(0.0, 0.0, 13.0, 0.5)
    p.rect(19.0, 0.0, 32.0, 0.5)
    p.disc(16.0, 13.0, 2.4)  # fountain
    p.disc(16.0, 13.0, 2.2, 205)
    p.disc(16.0, 13.0, 0.5)
    for x, y in ((6.0, 6.0), (26.0, 6.0), (6.0, 20.0), (26.0, 20.0), (11.0, 20.0), (21.0, 6.0)):
        p.disc(x, y, 0.7)  # trees in round benches
        p.disc(x, y, 0.5, 254)
        p.disc(x, y, 0.5, 205)
        p.disc(x, y, 0.2)
    for x, y, a in ((12.0, 9.4, 0.78), (20.0, 9.4, -0.78), (12.0, 16.6, -0.78), (20.0, 16.6, 0.78)):
        p.turned_block(x, y, 1.8, 0.5, a + 1.571)
    for k in range(4):  # market stalls
        x = 16.6 + 3.4 * k
        p.block(x, 22.0, x + 2.2, 23.2)
        p.rect(x, 22.55, x + 2.2, 22.65)
    for x in (2.0, 4.4):  # tables of a café
        for y in (10.4, 12.8, 15.2):
            p.round_table(x, y, 0.35, 4, 0.78)
    p.block(0.0, 8.6, 0.5, 17.0)
    for k in range(8):  # bicycles
        p.rect(23.0 + 0.6 * k, 1.2, 23.08 + 0.6 * k, 2.8)
    p.disc(30.4, 12.0, 0.9)  # advertising column
    p.disc(30.4, 12.0, 0.75, 205)
    p.point("south", 16.0, 1.4, 1.571)
    p.point("north", 16.0, 24.3, -1.571)
    p.point("north_west", 2.0, 23.6, -0.8)
    p.point("north_east", 30.8, 24.3, -2.4)
    p.point("south_west", 2.0, 2.2, 0.8)
    p.point("south_east", 30.0, 3.2, 2.4)
    p.point("west", 7.6, 13.0, 0.0)
    p.point("east", 28.0, 14.4, PI)
    p.point("fountain_south", 16.0, 9.4, 1.571)
    p.point("fountain_north", 16.0, 16.8, -1.571)
    p.point("stall_1", 17.7, 21.2, 1.571)
    p.point("stall_2", 21.1, 21.2, 1.571)
    p.point("stall_3", 24.5, 21.2, 1.571)
    p.point("cafe", 6.4, 11.6, PI)
    p.point("bicycles", 22.0, 3.6, -1.571)
    return p


PLACES = (family_house, office_floor, hospital_ward, storage_hall, factory_hall, museum,
          supermarket, station_concourse, street_crossing, school_corridor, airport_gate,
          corridor_set, doorway_set, t_junction, lift_lobby, open_square)
