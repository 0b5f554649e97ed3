# SPDX-License-Identifier: Apache-2.0
"""Draws grids of rooms as panels of one SVG, one above the other. Lengths are in pixels."""
from collections import namedtuple
from html import escape

from rooms_picture.grid import Grid, direct_includes
from rooms_picture.lines import Lines

WIDTH = 1200
MARGIN = 16  # around panels
PANEL_PAD = 40  # from a panel's sides to its first and last column
GUTTER = 62  # between columns, for lines and the borders of folders
FOLDER_PAD = 12  # from a folder's border to the boxes or the border in it
TITLE_HEIGHT = 24  # of the strip for a folder's title
BOX_PAD = 10
NAME_SIZE, NAME_HEIGHT = 16, 21
TEXT_SIZE, TEXT_HEIGHT = 14.5, 19
TRACK_HEIGHT = 9
CHANNEL_ENDS = 28  # of a channel without tracks, which the arrowhead is in
ARROW = 7
CORNER = 6  # radius
LINE_WIDTH = 2  # even: lines at whole pixels are sharp, and no darker where two of a net lie on each other
LETTER_WIDTH = 0.55  # of the mean letter, per font size: wide enough for the usual sans-serif fonts
FONT = "system-ui, -apple-system, 'Segoe UI', 'Helvetica Neue', Helvetica, Arial, sans-serif"

PANEL_FILLS = ["#f4f6f9", "#e6ebf2", "#d6dfea"]  # by how many folders lie around
PANEL_EDGE = "#c3cedb"
BOX_EDGE = "#5b6b7f"
NAME_COLOR, TEXT_COLOR = "#14202e", "#3a4757"
LINE_COLORS = ["#2563a8", "#b4541a", "#2e7d4f", "#7b4fa3", "#a33a55", "#4d6a1f", "#0f7c86", "#6b5b3e"]

Panel = namedtuple("Panel", "title note rooms outside")  # `outside`: the names of rooms that are not of the panel's folder
Box = namedtuple("Box", "left right row port text")
Folder = namedtuple("Folder", "path left right title_end low high")


def wrapped(text, width):
    """Lines of text that are no wider than `width`."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if len(longer) * TEXT_SIZE * LETTER_WIDTH > width and lines[-1]:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


class PanelPicture:
    """A panel whose left top corner is at (MARGIN, top)."""

    def __init__(self, panel, top):
        self.panel, self.top = panel, top
        self.grid = Grid(direct_includes(panel.rooms))
        self.column_width = (WIDTH - 2 * (MARGIN + PANEL_PAD) - (self.grid.width - 1) * GUTTER) // self.grid.width
        self.boxes = {name: self._box(name) for name in self.grid.places}
        self.folders = [self._folder(path) for path in self.grid.folders]
        includes = {name: place.includes for name, place in self.grid.places.items()}
        self.lines = Lines(self.boxes, self.folders, includes, MARGIN, WIDTH - MARGIN)
        self._measure()

    def _left(self, column):
        return MARGIN + PANEL_PAD + column * (self.column_width + GUTTER)

    def _columns(self, name):
        """The first and last column of a box: it widens in its folder where no box is and no line wants to pass."""
        grid, row = self.grid, self.grid.rows[name]
        column = grid.column(name)
        taken = {grid.column(other) for other in grid.places if other != name and grid.rows[other] == row}
        for source, target in grid.lines:
            if grid.rows[target] < row < grid.rows[source]:
                taken |= {grid.column(source), grid.column(target)}
        parent = name.rpartition("/")[0]
        start = grid.column(parent)
        first = last = column
        while first > start and first - 1 not in taken:
            first -= 1
        while last + 1 < start + grid.widths[parent] and last + 1 not in taken:
            last += 1
        return first, last

    def _box(self, name):
        place = self.grid.places[name]
        first, last = self._columns(name)
        left, right = self._left(first), self._left(last) + self.column_width
        purpose = place.room.purpose
        for target, headers in place.partial.items():
            purpose += f"; of {target} only {', '.join(header[len(target) + 1:] for header in headers)}"
        port = self._left(self.grid.column(name)) + self.column_width // 2
        return Box(left, right, self.grid.rows[name], port, wrapped(purpose, right - left - 2 * BOX_PAD))

    def _folder(self, path):
        low, high = self.grid.span(path)
        columns = [self.grid.column(name) for name in self.grid.rooms_in[path]]
        deeper = [other.count("/") for other in self.grid.folders if (other + "/").startswith(path + "/")]
        pad = FOLDER_PAD * (1 + max(deeper) - path.count("/"))
        left = self._left(min(columns)) - pad
        title_end = left + FOLDER_PAD + len(self._title(path)) * NAME_SIZE * LETTER_WIDTH * 1.1
        return Folder(path, left, self._left(max(columns)) + self.column_width + pad, title_end, low, high)

    def _title(self, path):
        return path.rpartition("/")[2] + "/"

    def _measure(self):
        """From the top down: where each row begins, where each channel's first track is, where folders begin and end."""
        rows = max(box.row for box in self.boxes.values())
        self.row_top, self.row_height, self.track_top, self.folder_top, self.folder_bottom = {}, {}, {}, {}, {}
        y = self.top + TITLE_HEIGHT + 2 * FOLDER_PAD
        for row in range(rows, -1, -1):
            for folder in sorted(self.folders, key=lambda folder: folder.path):
                if folder.high == row:
                    self.folder_top[folder.path] = y
                    y += TITLE_HEIGHT + FOLDER_PAD // 2
            self.row_top[row] = y
            self.row_height[row] = max(NAME_HEIGHT + TEXT_HEIGHT * len(box.text) + 2 * BOX_PAD - 4
                                       for box in self.boxes.values() if box.row == row)
            y += self.row_height[row]
            for folder in sorted(self.folders, key=lambda folder: folder.path, reverse=True):
                if folder.low == row:
                    y += FOLDER_PAD
                    self.folder_bottom[folder.path] = y
            self.track_top[row] = y + CHANNEL_ENDS // 2
            tracks = self.lines.tracks_in(row)
            y += (CHANNEL_ENDS + max(0, tracks - 1) * TRACK_HEIGHT) if row > 0 else 0
        self.bottom = y + 2 * FOLDER_PAD

    def _points(self, source, target):
        """The corners of a line, in pixels; the last is the tip of its arrow."""
        start = self.boxes[source]
        points = [(self.lines.ports[source, target], self.row_top[start.row] + self.row_height[start.row])]
        for x, channel in self.lines.way(source, target):
            track = self.lines.tracks.get((channel, target), 0)
            points.append((x, self.track_top[channel] + track * TRACK_HEIGHT))
        return points + [(self.boxes[target].port, self.row_top[self.boxes[target].row])]

    def elements(self):
        yield rectangle(MARGIN, self.top, WIDTH - MARGIN, self.bottom, PANEL_FILLS[0], PANEL_EDGE, 10)
        yield text(MARGIN + 14, self.top + 24, self.panel.title + "/", NAME_SIZE + 3, NAME_COLOR, "bold")
        yield text(MARGIN + 14 + len(self.panel.title) * 11 + 22, self.top + 24, self.panel.note, TEXT_SIZE, TEXT_COLOR)
        for folder in self.folders:
            top = self.folder_top[folder.path]
            yield rectangle(folder.left, top, folder.right, self.folder_bottom[folder.path],
                            PANEL_FILLS[min(1 + folder.path.count("/"), len(PANEL_FILLS) - 1)], PANEL_EDGE, 8)
            yield text(folder.left + FOLDER_PAD, top + 20, self._title(folder.path), NAME_SIZE, NAME_COLOR, "bold")
        targets = [name for name in self.boxes if self.lines.sources[name]]
        for i, target in enumerate(targets):
            color = LINE_COLORS[i % len(LINE_COLORS)]
            for source in self.lines.sources[target]:
                dashed = target in self.grid.places[source].partial
                yield path(self._points(source, target), color, dashed)
            yield arrow(self.boxes[target].port, self.row_top[self.boxes[target].row], color)
        for name, box in self.boxes.items():
            yield from self._box_elements(name, box)

    def _box_elements(self, name, box):
        top = self.row_top[box.row]
        outside = name in self.panel.outside
        yield f"<g><title>{escape(self._rule(name))}</title>"
        yield rectangle(box.left, top, box.right, top + self.row_height[box.row], "#ffffff", BOX_EDGE, 6, outside)
        yield text(box.left + BOX_PAD, top + BOX_PAD + 13, name.rpartition("/")[2], NAME_SIZE, NAME_COLOR, "bold")
        for i, line in enumerate(box.text):
            yield text(box.left + BOX_PAD, top + BOX_PAD + NAME_HEIGHT + 12 + i * TEXT_HEIGHT, line, TEXT_SIZE, TEXT_COLOR)
        yield "</g>"

    def _rule(self, name):
        """All that a room may include: lines show only what does not follow from others."""
        entries = self.grid.places[name].room.may_include
        return f"{name} may include {', '.join(sorted(entries)) if entries else 'no other room'}"


def rectangle(left, top, right, bottom, fill, edge, radius, dashed=False):
    dash = ' stroke-dasharray="5 4"' if dashed else ""
    return (f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" rx="{radius}" fill="{fill}" '
            f'stroke="{edge}"{dash}/>')


def text(x, y, content, size, color, weight="normal"):
    return f'<text x="{x}" y="{y}" font-size="{size}" font-weight="{weight}" fill="{color}">{escape(content)}</text>'


def arrow(x, y, color):
    return f'<path d="M{x} {y}l-{ARROW / 2 + 1} -{ARROW + 1}h{ARROW + 2}z" fill="{color}"/>'


def path(points, color, dashed):
    """A line with rounded corners that ends where its arrowhead begins."""
    corners = [p for i, p in enumerate(points) if i == 0 or p != points[i - 1]]
    corners[-1] = (corners[-1][0], corners[-1][1] - ARROW)
    data = f"M{corners[0][0]} {corners[0][1]}"
    for before, corner, after in zip(corners, corners[1:], corners[2:]):
        radius = min(CORNER, distance(before, corner) / 2, distance(corner, after) / 2)
        start, end = towards(corner, before, radius), towards(corner, after, radius)
        data += f"L{start[0]:g} {start[1]:g}Q{corner[0]:g} {corner[1]:g} {end[0]:g} {end[1]:g}"
    data += f"L{corners[-1][0]} {corners[-1][1]}"
    dash = ' stroke-dasharray="5 4"' if dashed else ""
    return f'<path d="{data}" fill="none" stroke="{color}" stroke-width="{LINE_WIDTH}"{dash}/>'


def distance(a, b):
    return abs(a[0] - b[0]) + abs(a[1] - b[1])


def towards(a, b, length):
    """The point `length` from a on the way to b, which is right above, below or beside it."""
    whole = distance(a, b)
    return (a[0] + (b[0] - a[0]) * length / whole, a[1] + (b[1] - a[1]) * length / whole)


def picture(panels, caption):
    """The SVG of panels, the first at the top."""
    parts, y = [], MARGIN
    for line in wrapped(caption, WIDTH - 2 * MARGIN):
        parts.append(text(MARGIN, y + NAME_SIZE, line, TEXT_SIZE, TEXT_COLOR))
        y += TEXT_HEIGHT
    y += FOLDER_PAD
    for panel in panels:
        drawn = PanelPicture(panel, y)
        parts += drawn.elements()
        y = drawn.bottom + MARGIN
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{y}" viewBox="0 0 {WIDTH} {y}" '
            f'font-family="{FONT}" role="img">')
    background = f'<rect width="{WIDTH}" height="{y}" fill="#ffffff"/>'
    return "\n".join([head, f"<title>{escape(caption)}</title>", background, *parts, "</svg>"]) + "\n"
