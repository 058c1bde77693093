# SPDX-License-Identifier: BSD-3-Clause
"""The floors of the building as data. Every length is in cells of 0.05 m, y grows to the north.

A floor has two long corridors from west to east (`south`, `north`: low and high y), short ones from
south to north (`cross`: low and high x) and four rows of rooms: below the south corridor, above the
north one, and two rows back to back in the core between them. A row is a list of (x0, x1, kind).
`links` are extra doors: (room, room) in the shared wall, or (room, "west"|"east") to a cross
corridor. Rooms are numbered row by row from 1, south to north, west to east.
"""

WIDTH = 880
HEIGHT = 560
OUTER = 4  # thickness of outer and shaft walls
INNER = 3  # thickness of walls between rooms
DOOR = 20  # 1.0 m

LOBBY_X = (384, 480)
CABS = ((340, 230, 380, 270), (340, 290, 380, 330))
CAB_DOOR = 22  # 1.1 m

FLOORS = (
    {
        "south": (136, 180),
        "north": (380, 424),
        "cross": ((130, 174), (690, 734)),
        "rows": (
            [(4, 92, "office"), (95, 190, "office"), (193, 330, "meeting"), (333, 430, "office"),
             (433, 580, "archive"), (583, 720, "office"), (723, 876, "meeting")],
            [(4, 127, "office"), (177, 254, "office"), (257, 333, "office"), (483, 584, "office"),
             (587, 687, "office"), (737, 876, "lab")],
            [(4, 127, "lab"), (177, 333, "meeting"), (483, 584, "archive"), (587, 687, "office"),
             (737, 876, "office")],
            [(4, 150, "meeting"), (153, 250, "office"), (253, 345, "office"), (348, 505, "lab"),
             (508, 606, "office"), (609, 720, "office"), (723, 876, "lab")],
        ),
        "split": 279,
        "links": ((2, 3), (12, "east"), (23, 24)),
    },
    {
        "south": (128, 172),
        "north": (386, 432),
        "cross": ((206, 250), (620, 662)),
        "rows": (
            [(4, 120, "lab"), (123, 216, "office"), (219, 310, "office"), (313, 404, "office"),
             (407, 520, "meeting"), (523, 620, "office"), (623, 730, "office"), (733, 876, "lab")],
            [(4, 98, "office"), (101, 203, "office"), (253, 333, "archive"), (483, 617, "meeting"),
             (665, 765, "office"), (768, 876, "office")],
            [(4, 203, "meeting"), (253, 333, "office"), (483, 617, "lab"), (665, 876, "lab")],
            [(4, 110, "office"), (113, 250, "meeting"), (253, 380, "lab"), (383, 740, "open"),
             (743, 876, "office")],
        ),
        "split": 272,
        "links": ((9, 10), (22, 23), (16, "west"), (21, 22)),
    },
    {
        "south": (146, 190),
        "north": (366, 412),
        "cross": ((98, 140), (548, 592)),
        "rows": (
            [(4, 300, "open"), (303, 420, "meeting"), (423, 520, "office"), (523, 620, "office"),
             (623, 732, "lab"), (735, 876, "office")],
            [(143, 236, "office"), (239, 333, "office"), (483, 545, "store"), (595, 675, "office"),
             (678, 757, "office"), (760, 876, "office")],
            [(4, 95, "lab"), (143, 333, "lab"), (483, 545, "store"), (595, 757, "meeting"),
             (760, 876, "lab")],
            [(4, 98, "office"), (101, 200, "office"), (203, 330, "meeting"), (333, 430, "office"),
             (433, 540, "office"), (543, 690, "lab"), (693, 876, "meeting")],
        ),
        "split": 276,
        "links": ((5, 6), (16, "west"), (13, "east")),
    },
)
