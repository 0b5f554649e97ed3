# SPDX-License-Identifier: Apache-2.0
"""Which row and column of a picture each room stands in.

Rows count upwards: a room stands above all it includes, and a folder above every folder beside it that it includes
anything of. Columns are searched for so that lines are short and few cross.
"""
from collections import namedtuple
from itertools import combinations

# `includes` are the rooms that `room` may include, less those that one of these may include in turn. `partial` are those of
# which it may include some headers only, as {name: [header]}.
Place = namedtuple("Place", "room includes partial")

DETOUR = 0.75  # what a line costs, in columns, that has a box in its way
CROSSING = 0.5  # what two lines cost, in columns, that cross


def target_of(entry, names):
    """The room that an entry of may_include is, or is a header of."""
    return entry if entry in names else max((name for name in names if entry.startswith(name + "/")), key=len)


def direct_includes(rooms):
    """A Place for each room, in their order; none may include a later one."""
    names = [room.name for room in rooms]
    places, whole, reached = [], {}, {}
    for room in rooms:
        entries = {}
        for entry in room.may_include:
            entries.setdefault(target_of(entry, names), []).append(entry)
        whole[room.name] = [target for target in entries if target in entries[target]]
        reached[room.name] = set(whole[room.name]).union(*(reached[target] for target in whole[room.name]))
        includes = [target for target in entries if not any(target in reached[other] for other in whole[room.name])]
        partial = {target: entries[target] for target in includes if target not in whole[room.name]}
        places.append(Place(room, includes, partial))
    return places


class Grid:
    """`places` by name; `folders`, outer ones first; `rows` by name; `width` in columns and column() by name."""

    def __init__(self, places):
        self.places = {place.room.name: place for place in places}
        self.folders = sorted({name[:i] for name in self.places for i, letter in enumerate(name) if letter == "/"})
        self.children = {folder: self._children(folder) for folder in ["", *self.folders]}
        self.rooms_in = {path: [name for name in self.places if path in ("", name) or name.startswith(path + "/")]
                         for path in ["", *self.folders, *self.places]}
        self.lines = [(place.room.name, target) for place in places for target in place.includes]
        self.rows = {}
        self._stack("", 0)
        self.widths = {name: 1 for name in self.places}
        self.offsets = {}  # of rooms and folders: columns from the left of the folder around them
        for folder in [*reversed(self.folders), ""]:
            self._line_up(folder)
        self.width = self.widths[""]
        self._improve()

    def _children(self, folder):
        """The rooms and folders right in a folder, by where their last rooms are listed."""
        prefix = folder + "/" if folder else ""
        last = {prefix + name[len(prefix):].split("/")[0]: i
                for i, name in enumerate(self.places) if name.startswith(prefix)}
        return sorted(last, key=last.get)

    def span(self, path):
        """The lowest and the highest row of a room or folder."""
        rows = [self.rows[name] for name in self.rooms_in[path]]
        return min(rows), max(rows)

    def _stack(self, folder, lowest):
        for i, child in enumerate(self.children[folder]):
            inside = self.rooms_in[child]
            below = [sibling for sibling in self.children[folder][:i]
                     if any(line[0] in inside and line[1] in self.rooms_in[sibling] for line in self.lines)]
            row = max((self.span(sibling)[1] + 1 for sibling in below), default=lowest)
            if child in self.folders:
                self._stack(child, row)
            else:
                self.rows[child] = row

    def _overlap(self, one, other):
        """Whether two children of a folder share a row and a column."""
        (low, high), (other_low, other_high) = self.span(one), self.span(other)
        return (low <= other_high and other_low <= high
                and self.offsets[one] < self.offsets[other] + self.widths[other]
                and self.offsets[other] < self.offsets[one] + self.widths[one])

    def _line_up(self, folder):
        """Gives the children of a folder the first columns that are free, wide ones first."""
        placed = []
        for child in sorted(self.children[folder], key=lambda path: -self.widths[path]):
            self.offsets[child] = 0
            while any(self._overlap(child, other) for other in placed):
                self.offsets[child] += 1
            placed.append(child)
        self.widths[folder] = max(self.offsets[child] + self.widths[child] for child in placed)

    def column(self, name):
        return sum(self.offsets[name[:i]] for i in range(1, len(name) + 1) if i == len(name) or name[i] == "/")

    def _cost(self):
        at = {name: (self.column(name), self.rows[name]) for name in self.places}
        taken = set(at.values())
        cost = 0.0
        for source, target in self.lines:
            cost += abs(at[source][0] - at[target][0])
            between = {(at[target][0], row) for row in range(at[target][1] + 1, at[source][1])}
            cost += DETOUR if between & taken else 0
        for one, other in combinations(self.lines, 2):
            if not set(one) & set(other) and cross(at[one[0]], at[one[1]], at[other[0]], at[other[1]]):
                cost += CROSSING
        return cost

    def _moves(self):
        """Changes of offsets, as {path: offset}."""
        for folder, children in self.children.items():
            for child in children:
                for offset in range(self.widths[folder] - self.widths[child] + 1):
                    yield {child: offset}
            for one, other in combinations(children, 2):
                yield {one: self.offsets[other], other: self.offsets[one]}
            inside = [(parent, child) for parent in self.children if (parent + "/").startswith(folder + "/") or not folder
                      for child in self.children[parent]]
            yield {child: self.widths[parent] - self.widths[child] - self.offsets[child] for parent, child in inside}

    def _is_legal(self):
        return all(self.offsets[child] + self.widths[child] <= self.widths[folder] for folder in self.children
                   for child in self.children[folder]) and not any(
            self._overlap(one, other) for children in self.children.values() for one, other in combinations(children, 2))

    def _improve(self):
        """Makes the first change that lowers the cost, until none does."""
        cost, improved = self._cost(), True
        while improved:
            improved = False
            for move in list(self._moves()):
                before = dict(self.offsets)
                self.offsets.update(move)
                new_cost = self._cost() if self._is_legal() else cost
                if new_cost < cost:
                    cost, improved = new_cost, True
                    break
                self.offsets = before


def cross(a, b, c, d):
    """Whether the segments ab and cd cross, other than in their ends."""
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0
