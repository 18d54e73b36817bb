#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Writes the seeds of the fuzz targets to corpus/ beside this file: small valid inputs of each
kind, so that the fuzzers begin where the parsers do their work. Deterministic. Projects are made by
build/release/quadcut."""

import gzip
import math
import pathlib
import sqlite3
import struct
import subprocess
import tempfile
import zlib

CORPUS = pathlib.Path(__file__).resolve().parent / "corpus"


def write(target, name, data):
    folder = CORPUS / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(data if isinstance(data, bytes) else data.encode())


def chunk(kind, body):
    return (struct.pack(">I", len(body)) + kind + body
            + struct.pack(">I", zlib.crc32(kind + body)))


def png(width, height, depth, color, rows, extra=b"", interlace=0):
    header = struct.pack(">IIBBBBB", width, height, depth, color, 0, 0, interlace)
    raw = b"".join(b"\0" + row for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra
            + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def bmp(width, height, bits, pixels, palette=b""):
    offset = 54 + len(palette)
    return (b"BM" + struct.pack("<IIIIiiHH", offset + len(pixels), 0, offset, 40, width, height,
                                1, bits) + bytes(24) + palette + pixels)


def jpeg():
    """Eight by eight grey pixels: one block, whose codes have one bit."""
    table = b"\1" + bytes(16)
    return (b"\xff\xd8\xff\xdb\0\x43\0" + b"\1" * 64 + b"\xff\xc0\0\x0b\x08\0\x08\0\x08\1\1\x11\0"
            + b"\xff\xc4\0\x14\0" + table + b"\xff\xc4\0\x14\x10" + table
            + b"\xff\xda\0\x08\1\1\0\0\x3f\0\x3f\xff\xd9")


def gif():
    """Two by two pixels of four colours; the codes of three bits are cleared before each pixel."""
    colors = bytes([0, 0, 0, 10, 11, 12, 205, 205, 205, 254, 254, 254])
    codes = 0
    for i, code in enumerate([4, 0, 4, 1, 4, 2, 4, 3, 5]):
        codes |= code << (3 * i)
    return (b"GIF89a\2\0\2\0\x81\0\0" + colors + b"\x21\xfe\2hi\0\x2c\0\0\0\0\2\0\2\0\0\2\4"
            + struct.pack("<I", codes) + b"\0;")


def tiff(width, height, bits, photometric, pixels, compression=1, more=()):
    entries = sorted([(256, 4, 1, width), (257, 4, 1, height), (258, 3, 1, bits),
                      (259, 3, 1, compression), (262, 3, 1, photometric), (273, 4, 1, 8),
                      (277, 3, 1, 1), (278, 4, 1, height), (279, 4, 1, len(pixels)), *more])
    padded = pixels + bytes(len(pixels) % 2)
    folder = struct.pack("<H", len(entries)) + b"".join(
        struct.pack("<HHII", *entry) for entry in entries)
    return b"II*\0" + struct.pack("<I", 8 + len(padded)) + padded + folder + bytes(4)


def yaml(image="a.png", more=""):
    return (f"image: {image}\nresolution: 0.05\norigin: [-1.5, 2e0, 0.1]\nnegate: 0\n"
            f"occupied_thresh: 0.65\nfree_thresh: 0.196\n{more}")


def write_maps():
    grey = png(4, 3, 8, 0, [bytes([0, 205, 254, 255])] * 3)
    alpha = png(2, 1, 8, 4, [bytes([255, 255, 0, 0])])
    write("map", "grey.png", grey)
    write("map", "alpha.png", alpha)
    write("map", "grey16.png", png(2, 2, 16, 0, [bytes([1, 2, 255, 255])] * 2))
    write("map", "bits.png", png(9, 2, 1, 0, [b"\xa5\x80", b"\x5a\x00"]))
    write("map", "rgb.png", png(2, 1, 8, 2, [bytes([255, 255, 255, 0, 0, 0])]))
    write("map", "rgba16.png", png(1, 1, 16, 6, [bytes(8)]))
    palette = chunk(b"PLTE", bytes([0, 0, 0, 205, 205, 205, 254, 254, 254])) + chunk(b"tRNS", b"\0")
    write("map", "palette.png", png(4, 2, 2, 3, [b"\x1b", b"\x06"], palette))
    # Of a 2 x 2 image, the passes 1, 6 and 7 of an interlaced one hold pixels.
    passes = [bytes([1]), bytes([2]), bytes([3, 4])]
    write("map", "interlaced.png", png(2, 2, 8, 0, passes, interlace=1))
    write("map", "text.pgm", "P2 # a comment\n3 2\n# another\n15\n0 7 15\n15 7 0\n")
    write("map", "bytes.pgm", b"P5\n# CREATOR\n4 2 255\n\x00\xcd\xfe\xff\x00\xcd\xfe\xff")
    write("map", "words.pgm", b"P5 2 1 65535\n\x00\x00\xff\xff")
    write("map", "comment.pgm", b"P5\r\n2 2\r\n255\r\n# saved\n\x00\xcd\xfe\xff")
    write("map", "bytes.pgm.gz", gzip.compress(b"P5 2 1 255\n\x00\xfe", mtime=0))
    write("map", "colors.bmp", bmp(1, -2, 24, bytes(8)))
    write("map", "bits.bmp", bmp(3, 1, 1, b"\x40\0\0\0", bytes([0, 0, 0, 0, 254, 254, 254, 0])))
    write("map", "bytes.bmp", bmp(2, 1, 8, b"\1\0\0\0", bytes([0, 0, 0, 0, 254, 254, 254, 0])))
    write("map", "grey.jpg", jpeg())
    write("map", "colors.gif", gif())
    write("map", "bytes.tif", tiff(2, 2, 8, 1, b"\x00\xcd\xfe\xff"))
    write("map", "bits.tif", tiff(9, 2, 1, 0, b"\xa5\x80\x5a\x00"))
    write("map", "words.tif", tiff(1, 1, 16, 1, b"\xff\xff"))
    write("map", "deflate.tif", tiff(4, 4, 8, 1, zlib.compress(bytes(16)), 8))
    write("map", "packbits.tif", tiff(4, 1, 8, 1, b"\xfd\xfe", 32773))
    write("map", "tiles.tif", tiff(4, 4, 8, 1, bytes(256), more=[(322, 3, 1, 16), (323, 3, 1, 16),
                                                                 (324, 4, 1, 8), (325, 4, 1, 256)]))
    write("map", "map.yaml", yaml())
    write("map", "flow.yaml", '{image: "a", resolution: 5.0e-2, origin: [0, 0, 0], negate: no,'
                                   " occupied_thresh: 1, free_thresh: 0, mode: raw}")
    write("map", "deep.yaml", yaml(more="x: {a: [1, {b: &c 2}], d: *c}\n--- next\n"))
    write("map", "scale_and_image", yaml(more="mode: scale\n").encode() + b"\0" + alpha)
    write("map", "raw_and_image", yaml(more="mode: raw\n").encode() + b"\0P2 2 1 255 100 101")
    write("map", "pair", yaml().encode() + b"\0" + grey)


def write_logs():
    front = "FLASER 4 1.5 2.25 81.83 0.5 1 2 0.5 1.1 2.1 0.6 976055541.1 host 2683.5\n"
    robot = ("ROBOTLASER1 0 -1.570796 3.141593 0.523599 30.0 0.01 0 3 1.5 30.0 2 2 7 8 "
             "5 6 0.25 4 6 0.25 0.1 0.2 0.3 0.4 1e6 1234.5 nohost 99.5\n")
    raw = "RAWLASER2 0 -1.57 3.14 1.57 50 0.01 0 3 1 2 3 0 1234.5 nohost 99.5\n"
    head = ("# CARMEN Logfile\nPARAM robot_frontlaser_offset 0.3 nohost 0\n"
            "PARAM robot_front_laser_max 50.0 nohost 0\nSYNC tag\n"
            "ODOM 1 2 0.5 0.1 0.2 0 12.5 host 3.5\n")
    write("log", "front.log", head + front + front.replace("541.1", "540.9"))
    write("log", "rear.log", front + front.replace("FLASER", "RLASER"))
    write("log", "robot.log", head + robot)
    write("log", "raw.log", head + raw + raw.replace("LASER2", "LASER1"))
    write("log", "garbage.log", "what\n" + front + "FLASER 9 1 2\nFLASER 2 nan -1 nan 0 0\n")
    write("log", "cut.log", front + front[:40])
    write("log", "crlf.log", front.replace("\n", "\r\n") * 3)
    spread = "".join(front.replace("2.25", str(2 + 0.5 * i)).replace("81.83", "50.0")
                     for i in range(20))
    write("log", "no_return.log", spread)
    packed = gzip.compress((head + front + robot).encode(), mtime=0)
    write("log", "front.log.gz", packed)
    write("log", "joined.log.gz", packed + packed)


def write_poses():
    tum = "# t x y z qx qy qz qw\n1.5 1 2 0 0 0 0.7071 0.7071\n2.5 -1e0 2 0 0 0 0 -2\n"
    g2o = ("PARAMS_SE2OFFSET 0 0 0 0\nVERTEX_SE2 0 1 2 0.5\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
           "VERTEX_SE3:QUAT 1 1 2 3 0 0 0.5 0.5\nFIX 0\n")
    write("poses", "tum.txt", tum)
    write("poses", "graph.g2o", g2o)
    write("poses", "bad.txt", "1 2 3\n")
    write("poses", "zero.txt", "1 0 0 0 0 0 0 0\n")
    write("poses", "tum.txt.gz", gzip.compress(tum.encode(), mtime=0))


def write_legends():
    flow = ('  - {value: 1, id: 1, name: "room 1", kind: room, area_m2: 9.5, centroid: [1, 2],'
            ' label_point: [1.5, 2], color: "#a0b1c2"}\n')
    block = "  - value: 7\n    id: 65535\n    name: 'Anna''s'\n    kind: corridor\n"
    write("legend", "flow.yaml", yaml(more="format_version: 1\nnext_id: 12\nlabels:\n" + flow))
    write("legend", "block.yaml", yaml(more="format_version: 1\nlabels:\n" + flow + block))
    write("legend", "empty.yaml", yaml(more="format_version: 1\nlabels: []\n"))
    legend = yaml(more="format_version: 1\nlabels:\n" + flow + block).encode() + b"\0"
    door = ('{"features": [{"properties": {"type": "door", "a": 1, "b": 65535, "width_m": 1.5,'
            ' "room_a_width_m": 4, "room_b_width_m": 3.5, "confidence": 0.75},'
            ' "geometry": {"coordinates": [[1, 2], [2.5, 2]]}}]}')
    write("legend", "doors", legend + door.encode())
    write("legend", "no_line", legend + door.replace('{"coordinates": ', '[').replace(']]}', ']]]').encode())
    write("legend", "labels", legend + png(2, 2, 16, 0, [bytes([0, 0, 0, 1]), bytes([0, 7, 0, 1])]))
    write("legend", "twice.yaml", yaml(more="format_version: 1\nlabels:\n" + flow + flow))


def write_follows():
    patch = bytes([2, 20, 20, 60, 60, 1])
    wall = bytes([2, 50, 20, 2, 20, 2])
    split = bytes([4, 2, 128, 110, 128, 150])
    lock = bytes([4, 3, 0])
    scan = bytes([0, 128, 128, 128, 40] + [150 + i % 7 for i in range(40)])
    write("follow", "hall", patch + bytes([5]) + split + bytes([7, 6]) + lock + scan)
    write("follow", "wall", patch + wall + bytes([4, 1, 0, 1, 5, 7]) + wall + bytes([5]))
    write("follow", "scans", scan * 6 + bytes([5, 7]) + scan)


def room_log():
    """Scans of a room of 4 x 4 m, from its middle."""
    log = ""
    for turn in range(4):
        ranges = [2 / max(abs(math.cos(a)), abs(math.sin(a)))
                  for a in (math.radians(degree) for degree in range(-90, 91, 3))]
        pose = f"0 0 {turn * math.pi / 2:.6f}"
        log += (f"FLASER {len(ranges)} " + " ".join(f"{range_m:.2f}" for range_m in ranges)
                + f" {pose} {pose} {turn} host {turn}\n")
    return log


ONCE_IN_META = (("resolution", "resolution_m"), ("follow.min_change", "min_change_m2"),
                ("follow.max_wait", "max_wait_m2_scans"), ("follow.first_cut", "first_cut_m2"),
                ("follow.min_patch", "min_patch_m2"))


def make_version_2(database):
    for option, key in ONCE_IN_META:
        database.execute("INSERT INTO meta SELECT ?, CAST(value AS REAL) FROM options WHERE name = ?",
                         (key, option))
    database.execute("DELETE FROM options WHERE name = 'resolution' OR name LIKE 'follow.%' "
                     "OR name LIKE 'scan.%'")
    for table in ("covisibility", "door_lines", "poses"):
        database.execute(f"DROP TABLE {table}")
    database.execute("DELETE FROM meta WHERE key IN ('next_door_id', 'revision')")
    database.execute("PRAGMA user_version=2")


def project(*edits, change=None):
    """A project file of ours, in pages as small as there are."""
    program = CORPUS.parents[2] / "build/release/quadcut"
    with tempfile.TemporaryDirectory() as folder:
        def run(*words):
            subprocess.run([program, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        (pathlib.Path(folder) / "a.log").write_text(room_log())
        run("follow", "a.log", "-o", "out", "--project", "p", "--quiet", "--resolution", "0.1",
            "--set", "follow.first_cut=1")
        for edit in edits:
            run("edit", "p", *edit)
        database = sqlite3.connect(pathlib.Path(folder) / "p", isolation_level=None)
        # Times differ from run to run.
        database.execute("UPDATE updates SET line = '{}' || char(10)")
        if change is not None:
            change(database)
        for statement in ("journal_mode=DELETE", "page_size=512"):
            database.execute("PRAGMA " + statement)
        database.execute("VACUUM")
        database.close()
        return (pathlib.Path(folder) / "p").read_bytes()


def write_projects():
    edited = project(("rename", "1", "Hall"), ("split", "-1.9", "0", "1.9", "0"), ("lock", "1"),
                     ("undo",))
    write("project", "edited", edited)
    write("project", "version_2", project(("rename", "1", "Hall"), change=make_version_2))
    write("project", "cut", edited[:len(edited) // 2])
    broken = bytearray(edited)
    for at in range(1024, len(edited), 700):
        broken[at] ^= 0x55
    write("project", "broken", bytes(broken))
    # A table, a column, a row, what is done with it, and a value: see fuzz_project.cpp.
    write("project", "no_rooms", bytes([6, 0, 255, 0]))
    write("project", "far_tile", bytes([9, 0, 3, 2, 0x10, 0]))
    write("project", "short_tile", bytes([9, 2, 3, 5, 0, 2, 1, 2]))
    write("project", "other_option", bytes([5, 1, 0, 4, 4]) + b"area")
    write("project", "large_count", bytes([4, 1, 5, 3, 0x7f, 255, 255, 255, 255, 255, 255, 254]))


if __name__ == "__main__":
    write_maps()
    write_logs()
    write_poses()
    write_legends()
    write_follows()
    write_projects()
