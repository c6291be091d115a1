#!/usr/bin/env python3
"""The example's machine, which misbehaves from its Nth frame on, or at each Nth (stalls): loopback_misbehaviour.py SOURCE_DIR SOCKET HOW [N [SECONDS]]"""
import os
import sys
import time

SOURCE, SOCKET, HOW = sys.argv[1:4]
FROM = int(sys.argv[4]) if len(sys.argv) > 4 else 0
AT_REST_MM = 1e-3  # a period, of an axis that lags; the program moves by 0.02
WORKPIECE_MM = -3.0  # its top
END_MM = 40.0  # of the program, where late_trip trips
OPEN_FRAMES = 3000  # how long the door is open, or the feed is stopped
DELAY_S = float(sys.argv[5]) if len(sys.argv) > 5 else 0.0
sys.path.insert(0, f"{SOURCE}/examples")
from loopback_machine import DISABLE, FOLLOWING_ERROR, Machine, TOLD_BYTES, Told, WRITE, listen  # noqa: E402


def spoilt(answer, number):
    """What is sent in place of this answer; once, where the name does not say for ever."""
    if HOW == "garbage_for_ever":
        return b"\xff" * 384
    if HOW == "version_at_once":
        return answer[:4] + b"\x02" + answer[5:]
    if number != FROM:
        return answer
    return {"garbage": os.urandom(200), "torn": answer[:100], "version": answer[:4] + b"\x02" + answer[5:],
            "another_tick": answer_of_another_tick(), "nothing_but_zeros": bytes(384)}.get(HOW, answer)


def answer_of_another_tick():
    return Machine().answer(10 ** 12)


def send_to_who_may_be_gone(connection, answer):
    """What it was told before still waits to be read."""
    try:
        connection.send(answer)
    except (BrokenPipeError, ConnectionResetError):
        pass


def main():
    machine, number, held, ticks = Machine(), 0, [], []
    last = None
    with listen(SOCKET) as listener:
        connection, _ = listener.accept()
        if HOW == "gone_at_once":
            return
        try:
            while frame := connection.recv(TOLD_BYTES + 1):
                told = Told(frame)
                machine.door_open = HOW == "door" and FROM <= number < FROM + OPEN_FRAMES
                if HOW == "feed":
                    machine.digital = 1 << 5 if FROM <= number < FROM + OPEN_FRAMES else 0
                    machine.analog[2] = 1.0 if number < FROM + OPEN_FRAMES else 0.5
                machine.take(told)
                machine.probe = HOW == "workpiece" and machine.places[2] <= WORKPIECE_MM
                last = told.call
                if told.call == WRITE:
                    ticks.append(told.tick)
                if HOW == "stalls" and number > 0 and number % FROM == 0:
                    time.sleep(DELAY_S)
                if HOW == "silent":
                    continue
                if HOW == "trip" and number == FROM:
                    machine.stop(FOLLOWING_ERROR, 1)
                if HOW == "late_trip" and told.call == WRITE and machine.told[0] == END_MM:
                    machine.stop(FOLLOWING_ERROR, 0)
                answer = machine.answer(told.tick)
                if HOW in ("late", "late_trip") and number >= FROM:
                    held.append((time.monotonic() + DELAY_S, answer))
                    while held and held[0][0] <= time.monotonic():
                        connection.send(held.pop(0)[1])
                elif HOW == "stalls" and number >= FROM:
                    send_to_who_may_be_gone(connection, answer)
                elif number < FROM or HOW in ("late", "trip", "well", "door", "workpiece", "feed"):
                    connection.send(answer)
                else:
                    connection.send(spoilt(answer, number))
                number += 1
        except (BrokenPipeError, ConnectionResetError):
            pass
    print("told to be off" if last == DISABLE else "hung up on", "at rest" if max(map(abs, machine.speeds)) < AT_REST_MM else "moving",
          f"{len(ticks)} ticks", "in a row" if all(b == a + 1 for a, b in zip(ticks, ticks[1:])) else "not in a row")


if __name__ == "__main__":
    main()
