# SPDX-License-Identifier: Apache-2.0
"""Ways for the lines between the boxes of a grid: none runs through a box or a title.

All lines to one room make a net. It ends in the port on top of the room's box; those that come from further up than the
next row share a trunk, which runs down where no box stands. Between any two rows lies a channel, which has the number of
the row above it. In it lines run sideways, each net on a track of its own where they would overlap.
"""
from collections import namedtuple

# Lengths are in pixels.
LINE_GAP = 9  # between lines that run side by side
BOX_GAP = 9  # between a line and a box
BORDER_GAP = 8  # between a line and the border of a folder
PORT_GAP = 22  # between the ports under a box
PORT_MARGIN = 30  # from the ends of a box to the ports under it
BEND = 15  # what a bend costs, in length

Trunk = namedtuple("Trunk", "x low high")  # from channel `low` to channel `high`
Run = namedtuple("Run", "target start end ups downs")  # sideways from `start` to `end`; lines leave it up and down there


class Lines:
    """`boxes` by name, with left, right, row and port; `folders` with path, left, right, title_end, and the rows low and
    high; `includes` by name; lines stay between `left` and `right`."""

    def __init__(self, boxes, folders, includes, left, right):
        self.boxes, self.folders, self.includes, self.left, self.right = boxes, folders, includes, left, right
        self.sources = {target: [name for name in boxes if target in includes[name]] for target in boxes}
        self.ports = {}  # under boxes: {(source, target): x}
        for name in boxes:
            self._place_ports(name)
        self.trunks = {}
        for target in sorted(boxes, key=lambda name: self._highest(name) - boxes[name].row):
            if self._highest(target) > boxes[target].row + 1:
                self.trunks[target] = self._find_trunk(target)
        self.tracks = {}  # {(channel, target): track}, the first being the highest
        for channel in range(1, 1 + max(box.row for box in boxes.values())):
            self._assign_tracks(channel)

    def _highest(self, target):
        return max((self.boxes[name].row for name in self.sources[target]), default=0)

    def _place_ports(self, name):
        """A port for each target of a box, above the target's own where that may be."""
        box = self.boxes[name]
        low, high = box.left + PORT_MARGIN, box.right - PORT_MARGIN
        targets = sorted(self.includes[name], key=lambda other: (self.boxes[other].port, -self.boxes[other].row))
        ports = [min(max(self.boxes[target].port, low), high) for target in targets]
        for i in range(1, len(ports)):
            ports[i] = max(ports[i], ports[i - 1] + PORT_GAP)
        for i in reversed(range(len(ports))):
            ports[i] = min(ports[i], high - PORT_GAP * (len(ports) - 1 - i))
        for target, port in zip(targets, ports):
            others = [other.port for other_name, other in self.boxes.items()
                      if other_name != target and other.row == box.row - 1]
            taken = any(abs(port - other) < PORT_GAP // 2 for other in others)
            self.ports[name, target] = port + PORT_GAP // 2 if taken else port

    def _blocked(self, target, low, high):
        """The (start, end) in which no trunk to a target may run between the channels `low` and `high`."""
        crossed = range(low, high)
        for name, box in self.boxes.items():
            if box.row in crossed:
                yield box.left - BOX_GAP, box.right + BOX_GAP
            if box.row == low - 1 and name != target and self.sources[name]:
                yield box.port - LINE_GAP, box.port + LINE_GAP
        for (source, other), port in self.ports.items():
            if self.boxes[source].row == high and other != target:
                yield port - LINE_GAP, port + LINE_GAP
        ends = [target, *(name for name in self.sources[target] if self.boxes[name].row > low)]
        for folder in self.folders:
            if folder.high >= low and folder.low < high:
                yield folder.left - BORDER_GAP, folder.left + BORDER_GAP
                yield folder.right - BORDER_GAP, folder.right + BORDER_GAP
                if not any(name.startswith(folder.path + "/") for name in ends):
                    yield folder.left, folder.right
            if folder.high in crossed:
                yield folder.left, folder.title_end
        for trunk in self.trunks.values():
            if trunk.low <= high and low <= trunk.high:
                yield trunk.x - LINE_GAP, trunk.x + LINE_GAP

    def _find_trunk(self, target):
        low, high = self.boxes[target].row + 1, self._highest(target)
        blocked = list(self._blocked(target, low, high))
        ends = [self.boxes[target].port] + [self.ports[name, target] for name in self.sources[target]
                                            if self.boxes[name].row > low]
        free = [x for x in range(self.left + BORDER_GAP, self.right - BORDER_GAP)
                if not any(start < x < end for start, end in blocked)]
        if not free:
            raise SystemExit(f"draw-rooms: finds no way for the lines to {target}; wider gutters would leave more")
        return Trunk(min(free, key=lambda x: sum(abs(x - end) + BEND * (x != end) for end in ends)), low, high)

    def _runs(self, channel):
        for target, box in self.boxes.items():
            ups = [self.ports[name, target] for name in self.sources[target] if self.boxes[name].row == channel]
            downs = [box.port] if channel == box.row + 1 else []
            trunk = self.trunks.get(target)
            if trunk and trunk.low <= channel < trunk.high:
                ups.append(trunk.x)
            if trunk and trunk.low < channel <= trunk.high:
                downs.append(trunk.x)
            ends = ups + downs
            if ups and downs and min(ends) < max(ends):
                yield Run(target, min(ends), max(ends), ups, downs)

    def _assign_tracks(self, channel):
        runs = list(self._runs(channel))
        swapped = True
        while swapped:
            swapped = False
            for i in range(len(runs) - 1):
                if crossings(runs[i + 1], runs[i]) < crossings(runs[i], runs[i + 1]):
                    runs[i], runs[i + 1] = runs[i + 1], runs[i]
                    swapped = True
        for i, run in enumerate(runs):
            above = [self.tracks[channel, other.target] for other in runs[:i]
                     if other.start < run.end + LINE_GAP and run.start < other.end + LINE_GAP]
            self.tracks[channel, run.target] = 1 + max(above, default=-1)

    def tracks_in(self, channel):
        return 1 + max((track for key, track in self.tracks.items() if key[0] == channel), default=-1)

    def way(self, source, target):
        """The corners of a line after its start: [(x, channel)], where it comes to x in the net's track of the channel."""
        box, row = self.boxes[target], self.boxes[source].row
        corners = [(self.ports[source, target], row)]
        if row > box.row + 1:
            corners += [(self.trunks[target].x, row), (self.trunks[target].x, box.row + 1)]
        return corners + [(box.port, box.row + 1)]


def crossings(upper, lower):
    """How often two runs cross if one is above the other: a line goes down from the upper one, up from the lower one."""
    return (sum(lower.start < x < lower.end for x in upper.downs)
            + sum(upper.start < x < upper.end for x in lower.ups))
