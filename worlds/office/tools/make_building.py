#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the office building: floor1.png ... and building.p, the same bytes in every run.

Usage: make_building.py DIRECTORY

Every line of the landmark graph is checked for its clearance, every room for being connected;
the script ends with status 1 and names the place where that fails.
"""

import math
import os
import sys

import floor_plans as plans
from floor_raster import CELL, Raster

CLEARANCE = 0.45
INSIDE = 0.9
JAMB = 14  # cells from a room's corner to the middle of a door


class BuildingError(Exception):
    """The plan breaks a rule of the building."""


class Room:
    """The free rectangle of a room, its doors and its furniture."""

    def __init__(self, rect, kind, row):
        self.rect = rect
        self.kind = kind
        self.row = row
        self.name = ""
        self.keep = []  # rectangles that furniture leaves free
        self.inside = []

    def centre(self):
        x0, y0, x1, y1 = self.rect
        return ((x0 + x1) / 2 * CELL, (y0 + y1) / 2 * CELL)


class Floor:
    """One storey while it is drawn: raster, rooms, landmarks, lines, doors."""

    def __init__(self, number, plan):
        self.number = number
        self.plan = plan
        self.raster = Raster(plans.WIDTH, plans.HEIGHT)
        self.rooms = []
        self.landmarks = {}
        self.edges = []
        self.doors = []
        self.spines = {}  # corridor name -> landmark names on its middle line

    def name(self, prefix, suffix):
        return f"{prefix}{self.number}_{suffix}"

    def add_landmark(self, name, x, y):
        if name in self.landmarks:
            raise BuildingError(f"landmark {name} twice")
        self.landmarks[name] = (round(x, 3), round(y, 3))
        return name

    def on_spine(self, spine, name, x, y):
        """Adds a point to a corridor's middle line, or shares one that is there already."""
        for other in self.spines.setdefault(spine, []):
            if math.dist(self.landmarks[other], (x, y)) < 1e-6:
                return other
        self.spines[spine].append(self.add_landmark(name, x, y))
        return name


def mid(pair):
    return (pair[0] + pair[1]) / 2 * CELL


def carve_corridors(floor):
    plan = floor.plan
    south, north = plan["south"], plan["north"]
    outer = plans.OUTER
    floor.raster.carve((outer, south[0], plans.WIDTH - outer, south[1]))
    floor.raster.carve((outer, north[0], plans.WIDTH - outer, north[1]))
    floor.raster.carve((plans.LOBBY_X[0], south[0], plans.LOBBY_X[1], north[1]))
    for x0, x1 in plan["cross"]:
        floor.raster.carve((x0, south[0], x1, north[1]))
    for cab in plans.CABS:
        x0, y0, x1, y1 = cab
        floor.raster.carve(cab)
        low = (y0 + y1 - plans.CAB_DOOR) // 2
        floor.raster.carve((x1, low, plans.LOBBY_X[0], low + plans.CAB_DOOR))


def carve_rooms(floor):
    plan = floor.plan
    inner, outer = plans.INNER, plans.OUTER
    spans = (
        (outer, plan["south"][0] - inner),
        (plan["south"][1] + inner, plan["split"]),
        (plan["split"] + inner, plan["north"][0] - inner),
        (plan["north"][1] + inner, plans.HEIGHT - outer),
    )
    for row, (rooms, (y0, y1)) in enumerate(zip(plan["rows"], spans)):
        for x0, x1, kind in rooms:
            room = Room((x0, y0, x1, y1), kind, row)
            floor.rooms.append(room)
            room.name = floor.name("r", f"{len(floor.rooms):02d}")
            floor.raster.carve(room.rect)


def add_crossings(floor):
    for spine in ("south", "north"):
        y = mid(floor.plan[spine])
        for index, cross in enumerate(floor.plan["cross"], 1):
            name = floor.name("x", f"{spine[0]}{index}")
            floor.on_spine(spine, name, mid(cross), y)
            floor.spines.setdefault(f"cross{index}", []).append(name)
        name = floor.name("l", spine[0])
        floor.on_spine(spine, name, mid(plans.LOBBY_X), y)
        floor.spines.setdefault("lobby", []).append(name)


def add_lobby(floor):
    middle = floor.on_spine("lobby", floor.name("l", "mid"), mid(plans.LOBBY_X), 14.0)
    for index, (_, y0, _, y1) in enumerate(plans.CABS, 1):
        front = floor.add_landmark(
            floor.name("l", f"e{index}"), plans.LOBBY_X[0] * CELL + INSIDE, mid((y0, y1)))
        floor.edges.append((front, middle))


def door_suffix(floor, room):
    number = room.name.split("_")[1]
    return number + "abc"[len(room.inside) - 1] if room.inside else number


def carve_door(floor, vertical, along, wall):
    """Opens a door: `along` is its middle along the wall, `wall` the wall's two faces."""
    low = along - plans.DOOR // 2
    if vertical:
        floor.raster.carve((wall[0], low, wall[1], low + plans.DOOR))
    else:
        floor.raster.carve((low, wall[0], low + plans.DOOR, wall[1]))


def add_door(floor, suffix, vertical, along, wall):
    carve_door(floor, vertical, along, wall)
    across, a = mid(wall), along * CELL
    half = plans.DOOR * CELL / 2
    name = floor.name("d", suffix)
    if vertical:
        floor.add_landmark(name, across, a)
        floor.doors.append((name, across, a - half, across, a + half))
    else:
        floor.add_landmark(name, a, across)
        floor.doors.append((name, a - half, across, a + half, across))
    return name


def enter(floor, room, door, vertical, face, sign, along, suffix):
    """The point 0.9 m inside a door, and the strip that furniture leaves free."""
    deep = face * CELL + sign * INSIDE
    point = (deep, along * CELL) if vertical else (along * CELL, deep)
    inside = floor.add_landmark(floor.name("i", suffix), *point)
    floor.edges.append((door, inside))
    room.inside.append(inside)
    reach = face + sign * 34
    low, high = min(face, reach), max(face, reach)
    strip = (along - 18, along + 18)
    room.keep.append((low, strip[0], high, strip[1]) if vertical else (strip[0], low, strip[1], high))


def corridor_of(floor, room):
    """(spine, faces of the wall, the room's face, direction into the room)."""
    spine = "south" if room.row < 2 else "north"
    low, high = floor.plan[spine]
    if room.row in (0, 2):
        return spine, (low - plans.INNER, low), low - plans.INNER, -1
    return spine, (high, high + plans.INNER), high + plans.INNER, 1


def pick_door_place(floor, room, spine):
    x0, _, x1, _ = room.rect
    shared = [round(floor.landmarks[n][0] / CELL) for n in floor.spines[spine]]
    fitting = [x for x in shared if x0 + JAMB <= x <= x1 - JAMB]
    if fitting:
        return min(fitting, key=lambda x: (min(x - x0, x1 - x), x))
    number = int(room.name.split("_")[1])
    return x0 + 24 if number % 2 else x1 - 24


def add_corridor_door(floor, room, along):
    spine, wall, face, sign = corridor_of(floor, room)
    suffix = door_suffix(floor, room)
    door = add_door(floor, suffix, False, along, wall)
    enter(floor, room, door, False, face, sign, along, suffix)
    front = floor.on_spine(spine, floor.name("c", suffix), along * CELL, mid(floor.plan[spine]))
    floor.edges.append((front, door))


def add_corridor_doors(floor):
    """Core rooms first, so that the rooms opposite can share their point in the corridor."""
    for room in sorted(floor.rooms, key=lambda r: (r.row in (0, 3), r.name)):
        spine = corridor_of(floor, room)[0]
        if room.kind == "open":
            add_corridor_door(floor, room, room.rect[0] + 40)
            add_corridor_door(floor, room, room.rect[2] - 40)
        else:
            add_corridor_door(floor, room, pick_door_place(floor, room, spine))


def side_place(room, other=None):
    """Along a side wall: towards the far end of the room, away from the corridor door."""
    y0, y1 = room.rect[1], room.rect[3]
    if other is not None:
        y0, y1 = max(y0, other.rect[1]), min(y1, other.rect[3])
    return (y0 + y1) // 2


def add_link(floor, link):
    room = floor.rooms[link[0] - 1]
    suffix = door_suffix(floor, room)
    if isinstance(link[1], int):
        other = floor.rooms[link[1] - 1]
        along, wall = side_place(room, other), (room.rect[2], other.rect[0])
        door = add_door(floor, suffix, True, along, wall)
        enter(floor, room, door, True, wall[0], -1, along, suffix)
        enter(floor, other, door, True, wall[1], 1, along, door_suffix(floor, other))
        return
    along = side_place(room)
    east = link[1] == "east"
    face = room.rect[2] if east else room.rect[0]
    wall = (face, face + plans.INNER) if east else (face - plans.INNER, face)
    index = next(i for i, c in enumerate(floor.plan["cross"], 1) if wall[0] in c or wall[1] in c)
    door = add_door(floor, suffix, True, along, wall)
    enter(floor, room, door, True, face, -1 if east else 1, along, suffix)
    front = floor.on_spine(f"cross{index}", floor.name("c", suffix),
                           mid(floor.plan["cross"][index - 1]), along * CELL)
    floor.edges.append((front, door))


def overlaps(a, b, gap):
    return a[0] < b[2] + gap and b[0] < a[2] + gap and a[1] < b[3] + gap and b[1] < a[3] + gap


def put(floor, room, rect, placed, gap=0):
    """Furniture that would narrow a door, or leave a slit beside other furniture, is left out."""
    x0, y0, x1, y1 = room.rect
    if rect[0] < x0 or rect[1] < y0 or rect[2] > x1 or rect[3] > y1:
        return
    if any(overlaps(rect, k, 6) for k in room.keep) or any(overlaps(rect, p, gap) for p in placed):
        return
    placed.append(rect)
    floor.raster.fill(rect)


def far_strip(room, depth, x0, x1):
    """A rectangle against the wall opposite the corridor."""
    low, high = room.rect[1], room.rect[3]
    return (x0, low, x1, low + depth) if room.row in (0, 2) else (x0, high - depth, x1, high)


def furnish_office(floor, room, desk, gap):
    x0, y0, x1, y1 = room.rect
    placed = []
    x = x0 + 8
    while x + desk <= x1 - 6:
        put(floor, room, far_strip(room, 15, x, x + desk), placed)
        x += desk + gap
    doors = [floor.landmarks[i][0] / CELL for i in room.inside]
    on_east = sum(doors) / len(doors) < (x0 + x1) / 2
    shelf = (x1 - 8, y0 + 46, x1, y1 - 46) if on_east else (x0, y0 + 46, x0 + 8, y1 - 46)
    if y1 - y0 >= 112:
        put(floor, room, shelf, placed, 6)


def furnish_meeting(floor, room):
    x0, y0, x1, y1 = room.rect
    length, cx, cy = max(32, (x1 - x0) - 84), (x0 + x1) // 2, (y0 + y1) // 2
    shift = -14 if room.row in (0, 2) else 14
    table = (cx - length // 2, cy - 11 + shift, cx + length // 2, cy + 11 + shift)
    put(floor, room, table, [])
    put(floor, room, far_strip(room, 4, cx - 20, cx + 20), [])


def furnish_shelves(floor, room):
    """Shelves against the side walls, and one row along the far wall."""
    x0, y0, x1, y1 = room.rect
    placed = []
    put(floor, room, (x0, y0 + 10, x0 + 9, y1 - 10), placed)
    put(floor, room, (x1 - 9, y0 + 10, x1, y1 - 10), placed)
    put(floor, room, far_strip(room, 9, x0 + 26, x1 - 26), placed)


def furnish_open(floor, room):
    """Islands of four desks with aisles of two metres."""
    x0, y0, x1, y1 = room.rect
    placed = []
    base = y1 - 44 if room.row == 3 else y0 + 12
    for x in range(x0 + 34, x1 - 60, 78):
        put(floor, room, (x, base, x + 36, base + 32), placed)


def furnish(floor):
    for room in floor.rooms:
        if room.kind == "office":
            furnish_office(floor, room, 32, 14)
        elif room.kind == "lab":
            furnish_office(floor, room, 50, 10)
        elif room.kind == "meeting":
            furnish_meeting(floor, room)
        elif room.kind == "open":
            furnish_open(floor, room)
        elif room.kind == "archive":
            furnish_shelves(floor, room)


def clearance_of(floor, a, b):
    """The largest of a few radii with which the line from a to b is free; 0 if none is."""
    for radius in (0.8, 0.7, 0.6, 0.5, CLEARANCE):
        if floor.raster.line_free(a, b, radius):
            return radius
    return 0.0


def place_centre(floor, room):
    """The point near the room's middle that all its doors see with the widest clearance."""
    cx, cy = room.centre()
    best = None
    for ring in range(0, 14):
        if best is not None and best[0] >= 0.8 - 0.03 * ring:
            break
        for step in range(max(1, 4 * ring)):
            angle = 2 * math.pi * step / max(1, 4 * ring)
            point = (round(cx + 0.2 * ring * math.cos(angle), 2), round(cy + 0.2 * ring * math.sin(angle), 2))
            if not inside_rect(point, room.rect) or not floor.raster.disc_free(*point, CLEARANCE):
                continue
            wide = min(clearance_of(floor, floor.landmarks[i], point) for i in room.inside)
            score = wide - 0.03 * ring
            if wide > 0 and (best is None or score > best[0] + 1e-9):
                best = (score, point)
    if best is None:
        raise BuildingError(f"no point of room {room.name} is seen from all its doors")
    floor.add_landmark(room.name, *best[1])
    floor.edges.extend((room.name, inside) for inside in room.inside)


def inside_rect(point, rect):
    return rect[0] < point[0] / CELL < rect[2] and rect[1] < point[1] / CELL < rect[3]


def link_spines(floor):
    for names in floor.spines.values():
        ordered = sorted(names, key=lambda n: floor.landmarks[n])
        floor.edges.extend(zip(ordered, ordered[1:]))


def check(floor):
    for a, b in floor.edges:
        if clearance_of(floor, floor.landmarks[a], floor.landmarks[b]) == 0.0:
            raise BuildingError(f"floor {floor.number}: {a} - {b} has less than {CLEARANCE} m clearance")
    seen, queue = set(), [next(iter(floor.landmarks))]
    while queue:
        name = queue.pop()
        if name not in seen:
            seen.add(name)
            queue.extend(b if a == name else a for a, b in floor.edges if name in (a, b))
    lost = sorted(set(floor.landmarks) - seen)
    if lost:
        raise BuildingError(f"floor {floor.number}: not connected: {', '.join(lost)}")
    if len(floor.rooms) < 20 or not 60 <= len(floor.landmarks) <= 110:
        raise BuildingError(
            f"floor {floor.number}: {len(floor.rooms)} rooms, {len(floor.landmarks)} landmarks")


def build_floor(number, plan):
    floor = Floor(number, plan)
    carve_corridors(floor)
    carve_rooms(floor)
    add_crossings(floor)
    add_lobby(floor)
    add_corridor_doors(floor)
    for link in plan["links"]:
        add_link(floor, link)
    furnish(floor)
    for room in floor.rooms:
        place_centre(floor, room)
    link_spines(floor)
    check(floor)
    return floor


def metres(*values):
    texts = (f"{v:.3f}".rstrip("0") for v in values)
    return ", ".join(t + "0" if t.endswith(".") else t for t in texts)


def floor_atoms(floor):
    k = floor.number
    yield f"floor({k}, 'floor{k}.png', {CELL})"
    for room in floor.rooms:
        yield f"room({room.name}, {k}, {metres(*(c * CELL for c in room.rect))})"
    for name, (x, y) in sorted(floor.landmarks.items()):
        yield f"landmark({name}, {k}, {metres(x, y)})"
    for name, *segment in floor.doors:
        yield f"door({name}, {k}, {metres(*segment)})"
    for a, b in sorted(tuple(sorted(e)) for e in floor.edges):
        yield f"adjacent({a}, {b})"
    for index in range(1, len(plans.CABS) + 1):
        yield f"lobby(e{index}, l{k}_e{index}, {k})"


def elevator_atoms():
    for index, (x0, y0, x1, y1) in enumerate(plans.CABS, 1):
        middle = (y0 + y1) / 2
        door_x = (x1 + plans.LOBBY_X[0]) / 2
        half = plans.CAB_DOOR / 2
        segment = (door_x, middle - half, door_x, middle + half)
        yield f"elevator(e{index}, {metres(*(c * CELL for c in (x0, y0, x1, y1) + segment))})"
        yield f"cab(e{index}, cab_e{index})"
        yield f"landmark(cab_e{index}, 0, {metres((x0 + x1) / 2 * CELL, middle * CELL)})"


HEADER = """\
% SPDX-License-Identifier: BSD-3-Clause
% The office building, written by tools/make_building.py. Metres; origin at the lower left of every
% floor, x to the east, y to the north.
%   floor(Number, Image, MetresPerPixel)          room(Room, Floor, X1, Y1, X2, Y2)
%   landmark(Name, Floor, X, Y)                   floor 0: in a cab, wherever the cab is
%   adjacent(Landmark, Landmark)                  undirected; the straight line is free
%   door(Door, Floor, X1, Y1, X2, Y2)             the shut leaf; also the landmark in its middle
%   elevator(E, X1, Y1, X2, Y2, Dx1, Dy1, Dx2, Dy2)   cab rectangle and door leaf, on every floor
%   cab(E, Landmark)  lobby(E, Landmark, Floor)   the places inside and in front of an elevator
% Landmarks: r room, i inside a door, d in a door, c in the corridor before a door, x crossing, l lobby.
"""


def write_building(floors, path):
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write(HEADER)
        count = 0
        for floor in floors:
            for atom in floor_atoms(floor):
                count += 1
                out.write(f"cnf(b{count}, axiom, {atom}).\n")
        for atom in elevator_atoms():
            count += 1
            out.write(f"cnf(b{count}, axiom, {atom}).\n")


def main(arguments):
    if len(arguments) != 1:
        print(__doc__.strip().split("\n\n")[1], file=sys.stderr)
        return 2
    try:
        floors = [build_floor(i, plan) for i, plan in enumerate(plans.FLOORS, 1)]
    except BuildingError as error:
        print(f"make_building: {error}", file=sys.stderr)
        return 1
    for floor in floors:
        floor.raster.write_png(os.path.join(arguments[0], f"floor{floor.number}.png"))
        print(f"floor {floor.number}: {len(floor.rooms)} rooms, {len(floor.landmarks)} landmarks, "
              f"{len(floor.edges)} lines")
    write_building(floors, os.path.join(arguments[0], "building.p"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
