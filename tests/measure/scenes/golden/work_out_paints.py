#!/usr/bin/env python3
"""Works out the colours of lit faces in exact integers, highlights included, without a line of the code
under test. Powers have 60 decimal digits before they are rounded.

usage: work_out_paints.py SCENE    what tests/measure/scenes/golden keeps, on stdout
"""
import decimal
import json
import re
import sys

from work_out import FRAMES, ONE, Rules, camera_of, coordinate, frames, light_of, nearest, refuse_unknown, wrap
from work_out_pixels import fnv

SHOWN = 8


def power(base, exponent):
    """base^exponent, to the nearest unit of 2^-16."""
    if base == ONE:
        return ONE
    units = ONE * ((decimal.Decimal(base) / ONE).ln() * exponent / ONE).exp()
    rounded = int(units + decimal.Decimal(0.5))
    # 60 digits would not decide a tie.
    assert abs(abs(units - rounded) - decimal.Decimal(0.5)) > decimal.Decimal("1e-40")
    return rounded


class Lights:
    def __init__(self, scene, rules):
        self.rules = rules
        self.ambient = [coordinate(x) for x in scene["lights"]["ambient"]]
        self.spots = []
        for spot in scene["lights"]["spots"]:
            away = [-x for x in light_of(spot)]
            to_light = [-rules.dot(row[:3], away) for row in camera_of(scene)]
            self.spots.append((to_light, [coordinate(x) for x in spot["intensity"]]))

    def in_front(self, normal):
        return [spot for spot in self.spots if self.rules.dot(spot[0], normal) > 0]

    def shade(self, full, shading, normal):
        mul = self.rules.mul
        light = list(self.ambient) if shading.get("ambient") else [0, 0, 0]
        for to_light, intensity in self.in_front(normal) if shading.get("diffuse") else ():
            cosine = self.rules.dot(to_light, normal)
            light = [a + mul(i, cosine) for a, i in zip(light, intensity)]
        return [min(mul(f, a), 255) for f, a in zip(full, light)]

    def gleam(self, highlight, normal, middle):
        rules, mul = self.rules, self.rules.mul
        to_viewer = rules.unit([-x for x in middle])
        light = [0, 0, 0]
        for to_light, intensity in self.in_front(normal):
            half = rules.unit([wrap(a + b) for a, b in zip(to_light, to_viewer)])
            cosine = min(rules.dot(half, normal), ONE)
            if cosine > 0:
                part = mul(nearest(decimal.Decimal(highlight["strength"])),
                           power(cosine, nearest(decimal.Decimal(highlight["exponent"]))))
                light = [a + mul(i, part) for a, i in zip(light, intensity)]
        return [mul(255, a) for a in light]


def between(a, b):
    """The middle, rounded toward the first operand."""
    return a + (b - a) // 2 if b >= a else a - (a - b) // 2


def paints(lights, data, body):
    full = [int(data["paint"][i:i + 2], 16) for i in (1, 3, 5)]
    shading = data["shading"]
    for face in body.visible:
        corners = body.faces[face]
        start = body.view[corners[0]]
        end = body.view[len(body.vertices) - len(body.faces) + face]
        normal = [wrap(e - s) for e, s in zip(end, start)]
        color = lights.shade(full, shading, normal)
        if "highlight" in shading:
            middle = [between(a, b) for a, b in zip(start, body.view[corners[len(corners) // 2]])]
            color = [min(c + g, 255) for c, g in zip(color, lights.gleam(shading["highlight"], normal, middle))]
        yield color


def main():
    scene = json.loads(re.sub(r"^\s*//.*$", "", open(sys.argv[1]).read(), flags=re.M))
    refuse_unknown(scene)
    for target in ("i386", "i8088"):
        for mul_on in (True, False):
            for div_on in (True, False):
                rules = Rules(target, mul_on, div_on)
                lights = Lights(scene, rules)
                print("#", target, "multiply", "on" if mul_on else "off", "divide", "on" if div_on else "off")
                for frame, bodies, order in frames(scene, rules, FRAMES[-1] + 1, FRAMES):
                    colors = []
                    for i in order:
                        data = {**scene.get("defaults", {}), **scene["objects"][i]}
                        colors += paints(lights, data, bodies[i])
                    shown = " ".join("%02x%02x%02x" % tuple(color) for color in colors[:SHOWN])
                    print("frame %d faces %d hash %016x" % (frame, len(colors), fnv(sum(colors, []))))
                    print(" ", shown)


if __name__ == "__main__":
    main()
