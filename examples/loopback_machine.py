#!/usr/bin/env python3
"""A machine in a process of its own, for `kerf run --driver loopback`.

    loopback_machine.py SOCKET          waits at SOCKET, drives one run, and says what came of it

It stands for a drive, or for what speaks to one: it takes a frame a period, lets each axis follow by a lag of the first order, as a
servo does, and answers where the axes are. docs/machine-interface.md has the frames, and says what this end owes.
"""
import os
import socket
import struct
import sys
import zlib

VERSION = 1
OUTPUTS = "6ddQ8di6B"  # spindle and G96; M19; digital, analog; tool; switches
TOLD = struct.Struct("<4sIq9d6d4d" + OUTPUTS + "IBBB")
TOLD_BYTES, ANSWER_BYTES = 320, 384
ENABLE, WRITE, DISABLE = 1, 2, 3
OFF, ON, STOPPING = 0, 1, 2
NO_FAULT, NOT_ENABLED, FOLLOWING_ERROR = 0, 1, 3
OUTPUTS_AT = struct.calcsize("<4sIq9d6d4d")
OUTPUTS_BYTES = struct.calcsize("<" + OUTPUTS)
SPINDLE_COOLANT_OFF = ((0, 48), (136, 2))  # bytes of the outputs that are 0 then: spindle and G96; mist, flood


def sealed(body, size):
    body += bytes(size - 4 - len(body))
    return body + struct.pack("<I", zlib.crc32(body))


class Told:
    """A frame of kerf's. ValueError: it is none."""

    def __init__(self, frame):
        if len(frame) != TOLD_BYTES or struct.unpack_from("<I", frame, TOLD_BYTES - 4)[0] != zlib.crc32(frame[:-4]):
            raise ValueError("no whole frame")
        fields = TOLD.unpack_from(frame)
        if fields[:2] != (b"KFTD", VERSION):
            raise ValueError("a frame of another version")
        self.tick, self.places, self.call = fields[2], list(fields[3:12]), fields[-1]
        self.outputs = frame[OUTPUTS_AT:OUTPUTS_AT + OUTPUTS_BYTES]


class Machine:
    """Nine axes that follow, each by a lag of its own; X, Y and Z fault when they fall too far behind."""

    LAG = 0.7  # of the way that is left, what is left a period later
    LARGEST_ERROR_MM = 50.0

    def __init__(self):
        self.places = self.told = [0.0] * 9
        self.speeds = [0.0] * 9  # a period
        self.outputs = bytes(OUTPUTS_BYTES)
        self.axes = OFF
        self.fault, self.fault_axis = NOT_ENABLED, -1
        self.ticks = 0
        self.largest_step_mm = 0.0
        self.probe = self.door_open = False
        self.digital, self.analog = 0, [0.0] * 8  # inputs

    def take(self, told):
        if told.call == ENABLE:
            self.places = self.told = told.places
            self.speeds = [0.0] * 9
            self.axes, self.fault, self.fault_axis = ON, NO_FAULT, -1
        elif told.call == DISABLE:
            self.stop(NOT_ENABLED)
        elif self.axes == ON:
            self.ticks += 1
            self.outputs = told.outputs
            self.follow(told.places)
        else:
            self.brake()

    def follow(self, places):
        self.largest_step_mm = max(self.largest_step_mm, *(abs(a - b) for a, b in zip(places[:3], self.told[:3])))
        self.told = places
        before, self.places = self.places, [p + (t - p) * (1 - self.LAG) for p, t in zip(self.places, places)]
        self.speeds = [a - b for a, b in zip(self.places, before)]
        for axis in range(3):
            if abs(self.told[axis] - self.places[axis]) > self.LARGEST_ERROR_MM:
                self.stop(FOLLOWING_ERROR, axis)

    def stop(self, fault, axis=-1):
        """All axes come to rest together, and spindle and coolant are off."""
        if self.fault == NO_FAULT:
            self.fault, self.fault_axis, self.axes = fault, axis, STOPPING
        outputs = bytearray(self.outputs)
        for at, count in SPINDLE_COOLANT_OFF:
            outputs[at:at + count] = bytes(count)
        self.outputs = bytes(outputs)

    def brake(self):
        self.places = [p + s for p, s in zip(self.places, self.speeds)]
        self.speeds = [s * 0.9 if abs(s) > 1e-6 else 0.0 for s in self.speeds]
        if not any(self.speeds):
            self.axes = OFF

    def answer(self, tick):
        errors = [t - p for t, p in zip(self.told[:3], self.places[:3])]
        body = struct.pack("<4sIq", b"KFAN", VERSION, tick) + struct.pack("<9d4d", *self.places, *errors, 0.0) + self.outputs
        inputs = struct.pack("<Q8d3H5B", self.digital, *self.analog, 0, 0, 0, self.probe, self.door_open, 0, 1, 1)
        axes = struct.pack("<9BBb", *[self.axes] * 9, self.fault, self.fault_axis)
        return sealed(body + inputs + axes, ANSWER_BYTES)


def listen(path):
    if os.path.exists(path):
        os.unlink(path)
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    listener.bind(path)
    listener.listen(1)
    return listener


def serve(connection, machine):
    """Until kerf hangs up. A frame at a time, as they come: a real drive takes one a period of its own clock, and stops by itself
    when none has come for a while."""
    while frame := connection.recv(TOLD_BYTES + 1):
        told = Told(frame)
        machine.take(told)
        connection.send(machine.answer(told.tick))


def main():
    machine = Machine()
    with listen(sys.argv[1]) as listener:
        connection, _ = listener.accept()
        try:
            serve(connection, machine)
        except (BrokenPipeError, ConnectionResetError):
            pass
    os.unlink(sys.argv[1])
    print(f"{machine.ticks} setpoints, the largest step of an axis {machine.largest_step_mm:.4f} mm, at rest at {machine.places[:3]}")


if __name__ == "__main__":
    main()
