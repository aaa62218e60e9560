"""How fast the program reads a bag of a LiDAR of 64 x 1024 points at 10 Hz, and in how much memory.

Writes two bags of ROS 2 (.mcap) of a drive through a street at 10 m/s, the second four times as long,
whose points say when they were measured. Prints for each how long `ldm info` and `ldm run` take, the latter
also as a multiple of real time and of all processors together, and the most memory; and how long the run of
a bag of one scan takes, which is the time until the first frame. Exit code 1 if a run is slower than twice
real time, a first frame takes more than a second, or memory grows by more than 5 % from the short bag to the
long one. Needs a machine with nothing else to do.
"""

from __future__ import annotations

import argparse
import os
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROWS, COLUMNS, RATE_HZ = 64, 1024, 10
SPEED_M_S = 10.0
FIELDS = (("x", 0, 7), ("y", 4, 7), ("z", 8, 7), ("intensity", 12, 7), ("t", 16, 6), ("ring", 20, 4))
POINT = np.dtype({"names": [name for name, _, _ in FIELDS],
                  "formats": ["<f4", "<f4", "<f4", "<f4", "<u4", "<u2"],
                  "offsets": [offset for _, offset, _ in FIELDS], "itemsize": 32})


class Cdr:
    """Fields one after the other as ROS 2 lays them out: each at a multiple of its size."""

    def __init__(self) -> None:
        self.bytes = bytearray()

    def number(self, form: str, *values: float) -> Cdr:
        size = struct.calcsize("<" + form)
        self.bytes += bytes(-len(self.bytes) % size)
        self.bytes += struct.pack(f"<{len(values)}{form}", *values)
        return self

    def text(self, text: str) -> Cdr:
        data = text.encode() + b"\0"
        self.number("I", len(data))
        self.bytes += data
        return self

    def header(self, stamp: float, frame: str) -> Cdr:
        seconds = int(stamp)
        return self.number("i", seconds).number("I", round((stamp - seconds) * 1e9)).text(frame)

    def message(self) -> bytes:
        return b"\0\1\0\0" + bytes(self.bytes)


def cloud(stamp: float, points: np.ndarray) -> bytes:
    cdr = Cdr().header(stamp, "lidar").number("I", ROWS, COLUMNS, len(FIELDS))
    for name, offset, kind in FIELDS:
        cdr.text(name).number("I", offset).number("B", kind).number("I", 1)
    cdr.number("B", 0).number("I", POINT.itemsize, COLUMNS * POINT.itemsize, points.nbytes)
    cdr.bytes += points.tobytes()
    return cdr.number("B", 0).message()


def odometry(stamp: float) -> bytes:
    cdr = Cdr().header(stamp, "odom").text("lidar").number("d", SPEED_M_S * stamp, 0, 0, 0, 0, 0, 1)
    return cdr.number("d", *[0.0] * (36 + 6 + 36)).message()


def scan(stamp: float) -> np.ndarray:
    """A street 16 m wide with parked cars, each column measured where the sensor then is."""
    elevation, column = np.meshgrid(np.radians(np.linspace(3, -25, ROWS)), np.arange(COLUMNS), indexing="ij")
    azimuth = 2 * np.pi * column / COLUMNS
    delay = column / COLUMNS / RATE_HZ
    ray = np.stack([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    with np.errstate(divide="ignore"):
        inverse = 1 / ray
    distance = np.where(ray[2] < 0, -1.8 * inverse[2], np.inf)
    distance = np.minimum(distance, 8 * np.abs(inverse[1]))
    place = SPEED_M_S * (stamp + delay)
    first = 20 * np.floor(SPEED_M_S * stamp / 20)
    for k in range(-2, 4):
        car = (first + 20 * k, 4.0, -1.8), (first + 20 * k + 4, 5.8, -0.3)
        near, far = np.zeros_like(distance), np.full_like(distance, np.inf)
        for axis in range(3):
            origin = place if axis == 0 else 0
            a, b = (car[0][axis] - origin) * inverse[axis], (car[1][axis] - origin) * inverse[axis]
            near, far = np.maximum(near, np.minimum(a, b)), np.minimum(far, np.maximum(a, b))
        distance = np.where((near < far) & (near > 0), np.minimum(distance, near), distance)
    distance[distance > 120] = np.nan
    points = np.zeros((ROWS, COLUMNS), POINT)
    for axis, name in enumerate("xyz"):
        points[name] = distance * ray[axis]
    points["t"] = np.round(1e9 * delay)
    points["ring"] = np.arange(ROWS)[:, None]
    return points


def text(value: str) -> bytes:
    return struct.pack("<I", len(value)) + value.encode()


def write_bag(file: Path, scans: int) -> None:
    magic = b"\x89MCAP0\r\n"
    topics = (("/points", "sensor_msgs/msg/PointCloud2"), ("/odom", "nav_msgs/msg/Odometry"))
    with file.open("wb") as out:
        def record(kind: int, body: bytes) -> None:
            out.write(struct.pack("<BQ", kind, len(body)) + body)

        def message(channel: int, stamp: float, data: bytes) -> None:
            time_ns = round(stamp * 1e9)
            record(5, struct.pack("<HIQQ", channel, 0, time_ns, time_ns) + data)

        out.write(magic)
        record(1, text("ros2") + text(""))
        for number, (topic, kind) in enumerate(topics, start=1):
            record(3, struct.pack("<H", number) + text(kind) + text("ros2msg") + struct.pack("<I", 0))
            record(4, struct.pack("<HH", number, number) + text(topic) + text("cdr") + struct.pack("<I", 0))
        for k in range(scans):
            stamp = 100 + k / RATE_HZ
            message(2, stamp, odometry(stamp))
            message(1, stamp, cloud(stamp, scan(stamp)))
        message(2, 100 + scans / RATE_HZ, odometry(100 + scans / RATE_HZ))
        record(15, struct.pack("<I", 0))
        record(2, struct.pack("<QQI", 0, 0, 0))
        out.write(magic)


def measured(command: list[str]) -> tuple[float, float, float]:
    """Time, that of all processors [s], and most memory [MB] of a command that must succeed."""
    begin = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"failed: {' '.join(command)}")
    return time.monotonic() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/bin/ldm")
    parser.add_argument("--seconds", type=int, default=10, help="length of the short bag")
    parser.add_argument("--preset", default="road")
    arguments = parser.parse_args()
    faults, memory = [], []
    with tempfile.TemporaryDirectory() as folder:
        def run(bag: Path) -> tuple[float, float, float]:
            return measured([arguments.program, "run", "ldm", str(bag), "-c", arguments.preset,
                             "-o", str(Path(folder) / "out")])

        one = Path(folder) / "one.mcap"
        write_bag(one, 1)
        first, processors, _ = run(one)
        print(f"first frame after {first:.2f} s, {processors:.2f} s of processors")
        if first > 1:
            faults.append("the first frame took more than a second")
        for seconds in (arguments.seconds, 4 * arguments.seconds):
            bag = Path(folder) / "drive.mcap"
            write_bag(bag, seconds * RATE_HZ)
            info, *_ = measured([arguments.program, "info", str(bag)])
            whole, processors, most = run(bag)
            memory.append(most)
            print(f"bag of {seconds} s, {bag.stat().st_size / 1e6:.0f} MB: ldm info {info:.2f} s; ldm run "
                  f"{whole:.2f} s, {seconds / whole:.1f} times real time, {processors:.2f} s of processors, "
                  f"{most:.0f} MB")
            if seconds / whole < 2:
                faults.append(f"the run of {seconds} s was slower than twice real time")
    if memory[1] > 1.05 * memory[0]:
        faults.append("memory grew with the bag")
    for fault in faults:
        print(f"long_bags: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
