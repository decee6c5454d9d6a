#!/usr/bin/env python3
"""Works the pictures of interpolated surfaces out in exact integers, as docs/interpolation.md states
how they are stepped, without a line of the code under test.

usage: work_out_pixels.py SCENE                      what tests/measure/scenes/golden keeps, on stdout
       work_out_pixels.py SCENE TARGET MUL DIV FRAME a frame as PGM, the palette's indices as greys
"""
import json
import re
import sys

from chains import chains
from work_out import FRAMES, ONE, Rules, frames, light_of, refuse_unknown, wrap

WIDTH, HEIGHT = 320, 240
NEAREST = 32767
LARGE = 8191 * ONE  # what is below can be doubled


def ratio(rules, n, d):
    """n / d: both doubled as long as they fit; in two parts where a divide by the whole part needs
    it."""

    def doubled(n, d):
        for _ in range(29):
            if abs(n) >= LARGE or abs(d) >= LARGE:
                break
            n, d = 2 * n, 2 * d
        return n, d

    n, d = doubled(n, d)
    upper = 0
    if not rules.i386 and abs(d) <= abs(n):
        divisor, times = d, 0
        while abs(divisor) < LARGE and times < 29:
            divisor, times = 2 * divisor, times + 1
        upper = rules.div(n, divisor)
        for _ in range(times):
            if abs(upper) > 16384 * ONE:
                return 0
            upper = wrap(2 * upper)
        n, d = doubled(wrap(n - rules.mul(upper, d)), d)
    return wrap(upper + rules.div(n, d))


class Line:
    """A value along a row: at the first pixel, and what a pixel adds."""

    def __init__(self, rules, start, slope):
        self.rules, self.start, self.slope = rules, start, slope

    def at(self, units):
        return wrap(self.start + self.rules.mul(self.slope, units)) if units else self.start


def across(rules, start, end, units, distance):
    if units < ONE:
        return Line(rules, wrap(start + rules.mul(wrap(end - start), ratio(rules, distance, units))), 0)
    slope = ratio(rules, wrap(end - start), units)
    return Line(rules, wrap(start + rules.mul(slope, distance)), slope)


def unit(rules, v):
    for _ in range(8):
        square = rules.dot(v, v)
        if ONE - 4 <= square <= ONE + 4:
            break
        factor = rules.mul(wrap(3 * ONE - square), ONE // 2)
        v = [rules.mul(x, factor) for x in v]
    return v


def texel(bitmap, u, v):
    kind, (first, second) = bitmap
    if kind == "checker":
        return second if (u // 32 + v // 32) % 2 else first
    along = u + v // 32 % 2 * 32
    return second if v % 32 < 4 or along % 64 < 4 else first


def inside(start, step, count):
    """A coordinate of a stretch whose last pixel would leave the bitmap has a smaller step."""
    keep = lambda x: min(max(x, 0), ONE - 1)
    start = keep(start)
    last = start + (count - 1) * step
    if count > 1 and last != keep(last):
        way = keep(last) - start
        step = way // (count - 1) if way >= 0 else -(-way // (count - 1))
    return start, step


def fine(rules, n, d, times):
    doublings = 0
    while doublings < 8 and abs(n) < LARGE:
        n, doublings = 2 * n, doublings + 1
    for _ in range(times):
        n = ratio(rules, n, d)
    return n << (8 - doublings)


class Surface:
    def __init__(self, scene, data, body, rules):
        self.rules, self.body = rules, body
        self.of = data.get("surface", {"kind": "flat"})
        self.kind = self.of["kind"]
        self.near = int(scene.get("near", 64) * ONE)
        self.steps_z = scene.get("depth_measure") == "z"
        self.buffered = scene.get("depth_buffer", "off") == "on"
        if scene.get("depth_buffer", "off") not in ("off", "on") or \
                data.get("shading") or data.get("shadings"):
            sys.exit("work_out_pixels.py: not worked out here: shading, or another depth buffer")
        if "checks" in data:
            around = 2 * data["shape"]["ball"]["bands"]
            self.paints = [data["checks"][(f // around + f % around) % 2]
                           for f in range(len(body.faces))]
        else:
            self.paints = data.get("paints", [data.get("paint")] * len(body.faces))
        self.light = [0, 0, 0]
        for spot in scene.get("lights", {}).get("spots", []):
            if spot["intensity"] != [1, 1, 1]:
                sys.exit("work_out_pixels.py: not worked out here: a light's level")
            self.light = [wrap(a + b) for a, b in zip(self.light, light_of(spot))]

    def corner(self, face, i):
        """Depth, and what else the surface has there: places times depth, or the normal."""
        vertex = self.body.faces[face][i]
        place = self.body.view[vertex]
        distance = -place[2]
        nearness = ONE if distance <= self.near else min(ratio(self.rules, self.near, distance), ONE)
        depth = self.rules.mul(nearness, NEAREST * ONE)
        if self.steps_z:
            depth = place[2] + (NEAREST + 1) * ONE
        if self.kind == "flat":
            return [depth]
        if self.kind == "texture":
            low, high = 128, ONE - 128
            u, v = high if i in (1, 2) else low, high if i >= 2 else low
            return [depth, self.rules.mul(u, depth), self.rules.mul(v, depth)]
        # Normals' ends stand behind all vertices.
        end = self.body.view[len(self.body.view) // 2 + vertex]
        return [depth] + [wrap(e - p) for e, p in zip(end, place)]

    def rows(self, face):
        """Of each row of the page the values at its left and right end, in 2^-16 pixels, upwards."""
        points = [self.body.screen[v] for v in self.body.faces[face]]
        corners = [self.corner(face, i) for i in range(len(points))]
        top, sides = chains(points)
        sides = [self.ends(points, corners, side, top) for side in sides]
        return {y: (sides[0][y], sides[1][y]) for y in sides[0]}

    def ends(self, points, corners, side, top):
        """One end of the rows. On an edge values are stepped from its first row on the page."""
        ends, at = {}, None
        for y, (upper, lower, own) in enumerate(side, top):
            if not 0 <= y < HEIGHT:
                continue
            (x0, y0), (x1, y1) = points[upper], points[lower]
            if at != upper:
                at = upper
                slopes = [ratio(self.rules, wrap(b - a), (y1 - y0) * ONE)
                          for a, b in zip(corners[upper], corners[lower])]
                skipped = (own - y0) * ONE
                values = [wrap(a + self.rules.mul(s, skipped)) if skipped else a
                          for a, s in zip(corners[upper], slopes)]
            units = -((-(x0 * (y1 - y0) + (x1 - x0) * (own - y0)) * ONE) // (y1 - y0))
            ends[y] = (units, values)
            values = [wrap(a + s) for a, s in zip(values, slopes)]
        return ends

    def draw(self, face, page, depths):
        for y, ((left, from_values), (right, to_values)) in sorted(self.rows(face).items()):
            first, end = max(-(-left // ONE), 0), min(-(-right // ONE), WIDTH)
            if first >= end:
                continue
            lines = [across(self.rules, a, b, right - left, first * ONE - left)
                     for a, b in zip(from_values, to_values)]
            for x, pixel in enumerate(self.pixels(face, lines, end - first)):
                at = y * WIDTH + first + x
                if self.buffered:
                    words = [(w + 128) >> 8 for w in (lines[0].start, lines[0].slope)]
                    depth = (words[0] + x * words[1]) >> 8
                    if depth <= depths[at]:
                        continue
                    depths[at] = depth
                page[at] = pixel

    def pixels(self, face, lines, count):
        if self.kind == "flat":
            return [self.paints[face]] * count
        if self.kind == "texture":
            return self.texels(lines, count)
        if self.kind == "phong" and self.of["phong"] == "quadratic":
            return self.parabola(lines, count)
        sys.exit("work_out_pixels.py: not worked out here: " + self.kind)

    def texels(self, lines, count):
        place = lambda x: [ratio(self.rules, q.at(x * ONE), lines[0].at(x * ONE)) for q in lines[1:]]
        (bitmap,) = self.of["bitmap"].items()
        every, row, here = self.of["exact_every"], [], 0
        while len(row) < count:
            there = min(here + every, count - 1)
            drawn = there - here + (1 if there == count - 1 else 0)
            coordinates = []
            for a, b in zip(place(here), place(there)):
                step = ratio(self.rules, wrap(b - a), (there - here) * ONE) if there > here else 0
                coordinates.append(inside(a, step, drawn))
            (u, du), (v, dv) = coordinates
            row += [texel(bitmap, (u + i * du) >> 8 & 255, (v + i * dv) >> 8 & 255)
                    for i in range(drawn)]
            here = there
        return row

    def parabola(self, lines, count):
        def light(units):
            normal = unit(self.rules, [component.at(units) for component in lines[1:]])
            on_ramp = self.rules.mul(self.rules.dot(self.light, normal), 62 * ONE)
            return wrap((self.of["ramp"] * 128 + 64) * ONE + on_ramp)

        last = count - 1
        start, middle, end = (light(u) for u in (0, last * ONE // 2, last * ONE))
        word, step, second = start << 8, 0, 0
        if last:
            bend = end - 2 * middle + start
            b = fine(self.rules, 4 * middle - 3 * start - end, last * ONE, 1)
            c = fine(self.rules, 2 * bend, last * ONE, 2)
            step, second = b + c, 2 * c
        return [(word + x * step + x * (x - 1) // 2 * second) >> 24 & 255
                for x in range(count)]


def picture(scene, rules, bodies, order):
    page, depths = bytearray(WIDTH * HEIGHT), [-32768] * (WIDTH * HEIGHT)
    for i in order:
        body = bodies[i]
        data = {**scene.get("defaults", {}), **scene["objects"][i]}
        surface = Surface(scene, data, body, rules)
        for face in body.visible:
            surface.draw(face, page, depths)
    return page


def fnv(page):
    """FNV-1a, 64 bits."""
    h = 0xCBF29CE484222325
    for byte in page:
        h = (h ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return h


def main():
    scene = json.loads(re.sub(r"^\s*//.*$", "", open(sys.argv[1]).read(), flags=re.M))
    refuse_unknown(scene)
    if len(sys.argv) > 2:
        rules = Rules(sys.argv[2], sys.argv[3] == "on", sys.argv[4] == "on")
        *_, (_, bodies, order) = frames(scene, rules, int(sys.argv[5]) + 1)
        sys.stdout.buffer.write(b"P5 %d %d 255\n" % (WIDTH, HEIGHT))
        sys.stdout.buffer.write(picture(scene, rules, bodies, order))
        return
    for target in ("i386", "i8088"):
        for mul_on in (True, False):
            for div_on in (True, False):
                rules = Rules(target, mul_on, div_on)
                print("#", target, "multiply", "on" if mul_on else "off", "divide",
                      "on" if div_on else "off")
                for frame, bodies, order in frames(scene, rules, FRAMES[-1] + 1, FRAMES):
                    page = picture(scene, rules, bodies, order)
                    drawn = len(page) - page.count(0)
                    print("frame %d drawn %d hash %016x" % (frame, drawn, fnv(page)))


if __name__ == "__main__":
    main()
