#!/usr/bin/env python3
"""Works out the pictures of flat faces in exact integers, without a line of the code under test, as
`fixproof render --digests` writes them: a line for every picture that differs from the one before.

usage: work_out_pictures.py SCENE TARGET MUL DIV N   (TARGET i386 or i8088; MUL and DIV on or off)
"""
import hashlib
import json
import re
import sys

from chains import spans
from work_out import Rules, coordinate, frames, light_of, refuse_unknown

WIDTH, HEIGHT = 320, 240


def shade(rules, lights, normal):
    """Of a white face: an index of the shading palette."""
    light = [coordinate(a) for a in lights["ambient"]]
    for spot in lights["spots"]:
        cosine = rules.dot(light_of(spot), normal)
        if cosine > 0:
            light = [a + rules.mul(coordinate(i), cosine) for a, i in zip(light, spot["intensity"])]
    parts = [min(rules.mul(255, a), 255) for a in light]
    if sum(part > 0 for part in parts) == 1:
        (primary,) = (i for i, part in enumerate(parts) if part)
        return 64 * (primary + 1) + (parts[primary] >> 2)
    return (parts[0] >> 6) << 4 | (parts[1] >> 6) << 2 | parts[2] >> 6


def color(scene, data, rules, body, face):
    if "shading" in data:
        if data["paint"] != "#ffffff" or data["shading"] != {"ambient": True, "diffuse": True}:
            sys.exit("work_out_pictures.py: not worked out here: other than white in all light")
        end = body.view[len(body.vertices) - len(body.faces) + face]
        start = body.view[body.faces[face][0]]
        return shade(rules, scene["lights"], [e - s for e, s in zip(end, start)])
    if "paints" not in data:
        sys.exit("work_out_pictures.py: not worked out here: paints")
    return data["paints"][face]


def main():
    scene = json.loads(re.sub(r"^\s*//.*$", "", open(sys.argv[1]).read(), flags=re.M))
    refuse_unknown(scene)
    rules = Rules(sys.argv[2], sys.argv[3] == "on", sys.argv[4] == "on")
    before = None
    for _, bodies, order in frames(scene, rules, int(sys.argv[5])):
        page = bytearray(WIDTH * HEIGHT)
        for i in order:
            data = {**scene.get("defaults", {}), **scene["objects"][i]}
            for face in bodies[i].visible:
                pixel = bytes([color(scene, data, rules, bodies[i], face)])
                points = [bodies[i].screen[v] for v in bodies[i].faces[face]]
                for y, first, end in spans(points, WIDTH, HEIGHT):
                    page[y * WIDTH + first:y * WIDTH + end] = pixel * (end - first)
        digest = hashlib.sha256(page).hexdigest()[:16]
        if digest != before:
            print(digest)
        before = digest


if __name__ == "__main__":
    main()
