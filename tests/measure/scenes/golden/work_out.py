#!/usr/bin/env python3
"""Works the golden files out in exact integers, without a line of the code under test.

usage: work_out.py SCENE                    what tests/measure/scenes/golden keeps of a scene, on stdout
       work_out.py SCENE TARGET MUL DIV N   the dump of N frames, as `fixproof render --dump` writes it
                                            (TARGET i386, i8088 or i8088-repaired; MUL and DIV on or off)
"""
import decimal
import json
import math
import os
import re
import sys

ONE = 1 << 16
FRAMES = (0, 1, 199, 599)
VERTICES = 8
decimal.getcontext().prec = 60
LIT_AT_VERTICES = {"gouraud8", "gouraud16", "environment", "phong"}


def wrap(x):
    return (x + (1 << 31)) % (1 << 32) - (1 << 31)


def sign(x):
    return -1 if x < 0 else 1


class Rules:
    """Multiply and divide as docs/semantics.md states them."""

    def __init__(self, target, mul_on, div_on):
        self.i386, self.mul_on, self.div_on = target == "i386", mul_on, div_on
        self.loses_carry = target == "i8088"

    def mul(self, a, b):
        half = ONE // 2 if self.mul_on else 0
        if self.i386:
            return wrap((a * b + half) // ONE)
        return wrap(sign(a * b) * ((abs(a * b) + half) // ONE))

    def div(self, n, d):
        divisor = abs(d) if self.i386 else (abs(d) // ONE)
        q, r = divmod(abs(n) * ONE if self.i386 else abs(n), divisor)
        if self.div_on and 2 * r >= divisor:
            q += 1
        return wrap(sign(n) * sign(d) * q)

    def unit(self, v):
        """The unit vector: doubles the vector to about 14 bits, then divides it by its length to nearest."""
        if not any(v):
            return v
        while max(map(abs, v)) < 8191 * ONE:
            v = [2 * x for x in v]
        square = sum(x * x for x in v)
        size = math.isqrt(square)
        size += square - size * size > size
        v = [self.div(x, size) for x in v]
        return v if self.i386 else self.toward_unit(v)

    def toward_unit(self, v):
        factor = self.mul(wrap(3 * ONE - self.dot(v, v)), ONE // 2)
        return [self.mul(x, factor) for x in v]

    def cross(self, a, b):
        return [wrap(self.mul(a[(i + 1) % 3], b[(i + 2) % 3]) - self.mul(a[(i + 2) % 3], b[(i + 1) % 3]))
                for i in range(3)]

    def dot(self, a, b):
        return wrap(sum(self.mul(x, y) for x, y in zip(a, b)))

    def concat(self, first, second):
        product = [[self.dot(row[:3], [r[j] for r in second]) for j in range(4)] for row in first]
        for row, moved in zip(product, first):
            lost = self.loses_carry and row[3] % ONE + moved[3] % ONE >= ONE
            row[3] = wrap(row[3] + moved[3] - (ONE if lost else 0))
        return product


def published(x):
    return int(x * 65536.0 + 0.5)  # int() truncates, as the cast of the listing


def coordinate(x):
    return int(x) * ONE if x == int(x) else published(x)


def nearest(x):
    return math.floor(x * ONE + decimal.Decimal(0.5))


def camera_of(scene):
    """World to view, rounded to nearest: the axes of a camera that looks at a point or is not turned, and
    its negated place."""
    camera = scene.get("camera", {})
    place = [decimal.Decimal(x) for x in camera.get("position", [0, 0, 0])]
    rows = [[decimal.Decimal(i == j) for j in range(3)] for i in range(3)]
    if "look_at" in camera:
        back = [p - decimal.Decimal(x) for p, x in zip(place, camera["look_at"])]
        right = [back[2], 0, -back[0]] if back[0] or back[2] else [1, 0, 0]
        up = [back[(i + 1) % 3] * right[(i + 2) % 3] - back[(i + 2) % 3] * right[(i + 1) % 3] for i in range(3)]
        rows = [[x / sum(y * y for y in axis).sqrt() for x in axis] for axis in (right, up, back)]
    return [[nearest(x) for x in row] + [nearest(-sum(x * p for x, p in zip(row, place)))] for row in rows]


def table(tenths):
    angle = math.radians(tenths / 10)
    return math.floor(math.cos(angle) * ONE + 0.5), math.floor(math.sin(angle) * ONE + 0.5)


def cube(half):
    signs = [(x, y, z) for x in (1, -1) for y in (1, -1) for z in (1, -1)]
    faces = [[1, 3, 2, 0], [5, 7, 3, 1], [4, 5, 1, 0], [3, 7, 6, 2], [5, 4, 6, 7], [0, 2, 6, 4]]
    return [[half * s for s in v] for v in signs], faces


def ball(radius, bands):
    """Bands from the top down, each a turn from -x by +z."""
    step, around = math.pi / bands, 2 * bands
    vertices = [[0, radius, 0]]
    for c in range(1, bands):
        for m in range(around):
            ring, angle = radius * math.sin(c * step), math.pi - m * step
            vertices.append([ring * math.cos(angle), radius * math.cos(c * step),
                             ring * math.sin(angle)])
    vertices.append([0, -radius, 0])
    at = lambda circle, m: 1 + (circle - 1) * around + m % around
    faces = []
    for band in range(bands):
        for m in range(around):
            if band == 0:
                faces.append([0, at(1, m + 1), at(1, m)])
            elif band == bands - 1:
                faces.append([at(band, m), at(band, m + 1), len(vertices) - 1])
            else:
                faces.append([at(band, m), at(band, m + 1), at(band + 1, m + 1), at(band + 1, m)])
    return vertices, faces


def obj(file):
    """Vertices and faces. A scene reverses the order of a face's corners after the first."""
    vertices, faces = [], []
    for line in open(os.path.join(os.path.dirname(sys.argv[1]), file)):
        kind, *words = line.split()
        if kind == "v":
            vertices.append([float(word) for word in words])
        if kind == "f":
            first, *others = [int(word) - 1 for word in words]
            faces.append([first] + others[::-1])
    return vertices, faces


def add_normals(vertices, faces, shadings):
    for face, shading in zip(faces, shadings):
        if not shading.get("diffuse") and "highlight" not in shading:
            continue
        a, b, c = (vertices[face[i]] for i in (0, 1, 2))
        u = [c[i] - a[i] for i in range(3)]
        v = [b[i] - a[i] for i in range(3)]
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        size = math.sqrt(sum(x * x for x in n))
        vertices.append([a[i] + n[i] / size for i in range(3)])


def add_vertex_normals(vertices, faces):
    """Behind the vertices, the end of each one's normal: the mean of its faces' unit normals."""
    sums = [[0.0] * 3 for _ in vertices]
    for face in faces:
        a, b, c = (vertices[face[i]] for i in (0, 1, 2))
        u = [c[i] - a[i] for i in range(3)]
        v = [b[i] - a[i] for i in range(3)]
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        for corner in face:
            sums[corner] = [s + x / math.hypot(*n) for s, x in zip(sums[corner], n)]
    vertices += [[p + x / math.hypot(*n) for p, x in zip(v, n)] for v, n in zip(list(vertices), sums)]


class Body:
    def __init__(self, scene, data, rules):
        self.rules = rules
        self.camera = camera_of(scene)
        (kind, of), = data["shape"].items()
        vertices, self.faces = cube(of["half_edge"]) if kind == "cube" else obj(of) if kind == "obj" else ball(**of)
        if data.get("surface", {}).get("kind") in LIT_AT_VERTICES:
            add_vertex_normals(vertices, self.faces)
        shadings = data.get("shadings", [data.get("shading", {})] * len(self.faces))
        add_normals(vertices, self.faces, shadings)
        # The vertices of a cube and of a file are typed in as whole numbers. Those of a ball are all computed.
        convert = published if kind == "ball" else coordinate
        self.vertices = [[convert(c) for c in v] for v in vertices]
        self.m = [[ONE * (i == j) for j in range(3)] + [coordinate(data["position"][i])]
                  for i in range(3)] if "position" in data else \
                 [[ONE * (i == j) for j in range(3)] + [0] for i in range(3)]
        spin = data.get("spin", {"tenths": [0, 0, 0]})
        self.tenths = spin["tenths"]
        self.wait, self.base = spin.get("delay", [1, 1])
        self.floating = scene.get("trigonometry") == "floating"
        self.restore = scene.get("restore_every", 0)
        self.one_row = scene.get("restore_rows", "all") == "one"
        self.rotations = 0
        self.drift = data.get("drift")
        if self.drift:
            self.step = [coordinate(s) for s in self.drift["step"]]
        self.orbit = data.get("orbit")
        if self.orbit:
            self.angle = self.orbit.get("start_tenths", 0)
            self.place()
        self.look_at = data.get("look_at")
        self.face_point()

    def place(self):
        mul, orbit = self.rules.mul, self.orbit
        radius = coordinate(orbit["radius"])
        cos, sin = table(self.angle)
        tilt_cos, tilt_sin = table(orbit.get("tilt_tenths", 0))
        along = mul(radius, sin)
        offset = [mul(radius, cos), -mul(along, tilt_sin), mul(along, tilt_cos)]
        for i in range(3):
            self.m[i][3] = wrap(coordinate(orbit["about"][i]) + offset[i])

    def face_point(self):
        if self.look_at is None:
            return
        back = [row[3] - coordinate(x) for row, x in zip(self.m, self.look_at)]
        if any(back):
            unit = lambda v: self.rules.unit(scaled(v))
            right = unit([back[2], 0, -back[0]]) if back[0] or back[2] else [ONE, 0, 0]
            back = unit(back)
            up = self.rules.cross(back, right)
            for i in range(3):
                self.m[i][:3] = right[i], up[i], back[i]

    def rotate(self):
        mul, m = self.rules.mul, self.m
        self.rotations += 1
        for axis in range(3):
            tenths = self.tenths[axis]
            if tenths == 0:
                continue
            if self.floating:
                angle = tenths * (math.pi / 1800)
                cos, sin = published(math.cos(angle)), published(math.sin(angle))
            else:
                cos, sin = table(tenths)
            a, b = (axis + 1) % 3, (axis + 2) % 3
            for j in range(3):
                above, below = m[a][j], m[b][j]
                m[a][j] = wrap(mul(cos, above) + mul(-sin, below))
                m[b][j] = wrap(mul(sin, above) + mul(cos, below))
        if self.restore and self.rotations % self.restore == 0 and self.one_row:
            m[2][:3] = self.rules.cross(m[0][:3], m[1][:3])
        elif self.restore and self.rotations % self.restore == 0:
            first = self.rules.toward_unit(m[0][:3])
            last = self.rules.toward_unit(self.rules.cross(first, m[1][:3]))
            middle = self.rules.toward_unit(self.rules.cross(last, first))
            for i, row in enumerate((first, middle, last)):
                m[i][:3] = row

    def move(self):
        self.wait -= 1
        if self.wait == 0:
            self.wait = self.base
            self.rotate()
        if self.drift:
            for i in range(3):
                self.m[i][3] = wrap(self.m[i][3] + self.step[i])
            z = self.m[2][3]
            if "stop_z" in self.drift and z > coordinate(self.drift["stop_z"]):
                self.step[2] = 0
            if "bounce_z" in self.drift:
                least, most = map(coordinate, self.drift["bounce_z"])
                if not least <= z <= most:
                    self.step[2] *= -1
        if self.orbit:
            self.angle = math.fmod(self.angle + self.orbit.get("step_tenths", 0), 3600)
            self.place()
        self.face_point()

    def prepare(self):
        self.view = [[wrap(self.rules.dot(row[:3], v) + row[3]) for row in self.to_view]
                     for v in self.vertices]
        self.screen = [self.project(v) for v in self.view]
        self.visible = [f for f, face in enumerate(self.faces) if self.shows(face)]

    def project(self, v):
        constant = published(-320.0)
        x, y = (self.rules.mul(self.rules.div(c, v[2]), constant) for c in v[:2])
        return [((x + ONE // 2) >> 16) + 160, -((y + ONE // 2) >> 16) + 120]

    def shows(self, face):
        p = [self.screen[v] for v in face]
        v = [p[1][i] - p[0][i] for i in range(2)]
        w = [p[-1][i] - p[0][i] for i in range(2)]
        return v[0] * w[1] - v[1] * w[0] > 0


def scaled(v):
    """The vector times a power of two that makes the longest component at least 8192 and less than 16384."""
    shift = 30 - max(map(abs, v)).bit_length()
    return [x << shift if shift >= 0 else (x + (1 << -shift - 1)) >> -shift for x in v]


def light_of(spot):
    """To the light: the direction's constants, made a unit vector, converted, then negated."""
    direction = [published(d) / ONE for d in spot["direction"]]
    size = math.sqrt(sum(d * d for d in direction))
    return [-published(d / size) for d in direction]


def frames(scene, rules, count, shown=None):
    """Each frame with its bodies and their order; only those of `shown`, if it is given."""
    bodies = [Body(scene, {**scene.get("defaults", {}), **data}, rules) for data in scene["objects"]]
    buffered = scene.get("depth_buffer", "off") != "off"
    by_depth = scene.get("depth_key", "center") == "center"
    order = list(range(len(bodies)))
    if by_depth and not buffered:
        order.reverse()  # each object went in before those of equal depth
    for frame in range(count):
        if frame:
            for body in bodies:
                body.move()
        for body in bodies:
            body.to_view = rules.concat(body.camera, body.m)
        if by_depth:
            # Stable. What a depth buffer hides need not be drawn: the nearest comes first.
            first = -1 if buffered else 1
            order.sort(key=lambda i: first * bodies[i].to_view[2][3])
        if shown is None or frame in shown:
            for body in bodies:
                body.prepare()
            yield frame, bodies, order


KNOWN = {"name", "camera", "frames_per_second", "conversion", "trigonometry", "depth_key", "palette", "arithmetic",
         "defaults", "objects", "lights", "restore_every", "restore_rows", "depth_buffer", "depth_measure", "near"}
KNOWN_OF_OBJECTS = {"name", "shape", "paint", "paints", "checks", "shading", "shadings", "position", "spin", "drift",
                    "orbit", "surface", "look_at"}


def refuse_unknown(scene):
    unknown = set(scene) - KNOWN
    unknown |= set(scene.get("camera", {})) - {"position", "look_at"}
    for data in [scene.get("defaults", {})] + scene["objects"]:
        unknown |= set(data) - KNOWN_OF_OBJECTS
    if scene.get("conversion", "published") != "published" or unknown:
        sys.exit("work_out.py: not worked out here: " + (", ".join(sorted(unknown)) or "conversion"))


def main():
    scene = json.loads(re.sub(r"^\s*//.*$", "", open(sys.argv[1]).read(), flags=re.M))
    refuse_unknown(scene)
    if len(sys.argv) > 2:
        target, mul_on, div_on, count = sys.argv[2], sys.argv[3] == "on", sys.argv[4] == "on", sys.argv[5]
        for frame, bodies, order in frames(scene, Rules(target, mul_on, div_on), int(count)):
            for i, b in enumerate(bodies):
                print(json.dumps({"frame": frame, "object": i, "order": order.index(i),
                                  "xform": sum(b.to_view, []), "view": b.view, "screen": b.screen,
                                  "visible": b.visible}, separators=(",", ":")))
        return
    join = lambda numbers: " ".join(map(str, numbers))
    # Without a camera there is no carry, and nothing to repair.
    for target in ("i386", "i8088") + (("i8088-repaired",) if "camera" in scene else ()):
        for mul_on in (True, False):
            for div_on in (True, False):
                rules = Rules(target, mul_on, div_on)
                print("#", target.replace("-", " "), "multiply", "on" if mul_on else "off", "divide",
                      "on" if div_on else "off")
                for frame, bodies, order in frames(scene, rules, FRAMES[-1] + 1, FRAMES):
                    i = frame % len(bodies)
                    b = bodies[i]
                    print("frame", frame, "order", join(order))
                    print("  object", i, "xform", join(sum(b.to_view, [])))
                    print("  view", ", ".join(join(v) for v in b.view[:VERTICES]))
                    print("  screen", ", ".join(join(p) for p in b.screen[:VERTICES]))
                    print("  visible", join(b.visible))


if __name__ == "__main__":
    main()
