"""What the tests share: the programs, and the pixels of their pictures."""

import os
import subprocess
import zlib

BUILD = os.environ.get("TM_BUILD", os.path.join(os.path.dirname(__file__), "../../build"))


def run(program, *words, stdin=b""):
    path = os.path.join(BUILD, "bin", program)
    return subprocess.run([path, *map(str, words)], input=stdin, check=True, capture_output=True).stdout


def shape(*words):
    return run("tm-shape", "--no-provenance", *words)


def same(mesh, program, *words, stdin):
    return mesh.to_bytes() == run(program, "--no-provenance", *words, stdin=stdin)


def pixels_of(png):
    """The bytes of the pixels of a PNG of 8 bits, by the format's own description."""
    data, place, width, channels = b"", 8, 0, 0
    while place < len(png):
        size = int.from_bytes(png[place : place + 4], "big")
        kind, body = png[place + 4 : place + 8], png[place + 8 : place + 8 + size]
        if kind == b"IHDR":
            width = int.from_bytes(body[:4], "big")
            channels = {2: 3, 6: 4}[body[9]]
        if kind == b"IDAT":
            data += body
        place += size + 12
    rows, stride, pixels = zlib.decompress(data), width * channels, b""
    above = bytes(stride)
    for start in range(0, len(rows), stride + 1):
        row = bytearray(rows[start + 1 : start + 1 + stride])
        for i in range(stride):
            left = row[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            guess = left + above[i] - corner
            nearest = min((left, above[i], corner), key=lambda value: abs(guess - value))
            add = [0, left, above[i], (left + above[i]) // 2, nearest][rows[start]]
            row[i] = (row[i] + add) & 255
        above = bytes(row)
        pixels += above
    return pixels
