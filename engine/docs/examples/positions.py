# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# A thousand disks fall; Python reads all positions as one array that is the world's own memory.
#
#   python3 positions.py LIBRARY      # a shared library of the engine: libscree.so
#
# Nothing but the standard library; with NumPy, `numpy.frombuffer(rows, "f4").reshape(-1, 4)` is the same memory.

import ctypes
import sys
from ctypes import POINTER, Structure, byref, c_float, c_int32, c_size_t, c_uint8, c_uint32, c_uint64, c_void_p


class Vec2(Structure):
    _fields_ = [("x", c_float), ("y", c_float)]


class Id(Structure):
    _fields_ = [("index", c_int32), ("generation", c_uint32)]


class BodyDef(Structure):
    _fields_ = [("type", c_int32), ("position", Vec2), ("angle", c_float), ("linear_velocity", Vec2),
                ("angular_velocity", c_float), ("linear_damping", c_float), ("angular_damping", c_float),
                ("gravity_scale", c_float), ("fixed_rotation", c_int32), ("bullet", c_int32), ("allow_sleep", c_int32)]


class FixtureDef(Structure):
    _fields_ = [("category_bits", c_uint64), ("mask_bits", c_uint64), ("density", c_float), ("friction", c_float),
                ("restitution", c_float), ("is_sensor", c_int32), ("group_index", c_int32),
                ("reports_contacts", c_uint8), ("reports_hits", c_uint8)]


def load(path):
    scree = ctypes.CDLL(path)
    for name, result, arguments in [
        ("default_body", BodyDef, []),
        ("default_fixture", FixtureDef, []),
        ("create_world", c_void_p, [c_void_p, c_void_p]),
        ("destroy_world", None, [c_void_p]),
        ("create_body", Id, [c_void_p, POINTER(BodyDef)]),
        ("add_edge", Id, [c_void_p, Id, POINTER(FixtureDef), Vec2, Vec2]),
        ("add_circle", Id, [c_void_p, Id, POINTER(FixtureDef), Vec2, c_float]),
        ("soft_step", c_int32, [c_void_p, c_float, c_int32]),
        ("transforms", c_void_p, [c_void_p, POINTER(c_size_t)]),
    ]:
        function = getattr(scree, "scree_" + name)
        function.restype, function.argtypes = result, arguments
    return scree


def main():
    scree = load(sys.argv[1])
    world = scree.scree_create_world(None, None)
    ground = scree.scree_create_body(world, None)
    scree.scree_add_edge(world, ground, None, Vec2(-100, 0), Vec2(100, 0))
    body, fixture = scree.scree_default_body(), scree.scree_default_fixture()
    body.type, fixture.density = 2, 1.0
    disks = []
    for i in range(1000):
        body.position = Vec2(1.5 * (i % 50) - 37.0, 2.0 + 1.5 * (i // 50))
        disks.append(scree.scree_create_body(world, byref(body)))
        scree.scree_add_circle(world, disks[-1], byref(fixture), Vec2(0, 0), 0.5)

    # One row per body: x, y, sine, cosine. The rows stay where they are while no body is created.
    count = c_size_t()
    rows = ((c_float * 4) * (len(disks) + 1)).from_address(scree.scree_transforms(world, byref(count)))
    assert count.value == len(rows)
    start = [rows[disk.index][1] for disk in disks]
    for _ in range(120):
        scree.scree_soft_step(world, 1.0 / 60.0, 4)
    fallen = [before - rows[disk.index][1] for before, disk in zip(start, disks)]
    print(f"{len(disks)} disks fell {min(fallen):.2f} to {max(fallen):.2f} m")
    scree.scree_destroy_world(world)
    assert min(fallen) > 0.5 and all(height > 0.0 for height in start)


if __name__ == "__main__":
    main()
