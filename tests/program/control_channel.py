"""The other end of `kerf run --control`: every line holds to docs/control.schema.json."""
import json
import pathlib
import socket
import subprocess
import time

import jsonschema
from command_line import Case, KERF, SOURCE

SCHEMA = json.loads((pathlib.Path(SOURCE) / "docs/control.schema.json").read_text())
LINE = "G21 G90\nG1 X400 F6000\nM2\n"  # 4 s at 100 mm/s


def validator(name):
    return jsonschema.Draft202012Validator({**SCHEMA, "$ref": f"#/$defs/{name}"})


REQUEST, REPLY = validator("request"), validator("reply")


class Client:
    """One end of a channel; every line that comes is checked."""

    def __init__(self, case, reader, writer, connection=None):
        self.case, self.reader, self.writer, self.connection, self.events = case, reader, writer, connection, []

    def write(self, text):
        self.writer.write(text.encode())
        self.writer.flush()

    def read(self):
        line = self.reader.readline()
        self.case.assertTrue(line.endswith(b"\n"), line)
        reply = json.loads(line)
        REPLY.validate(reply)
        if reply["type"] == "event":
            self.events.append(reply)
        return reply

    def read_until(self, **wanted):
        while True:
            reply = self.read()
            if all(reply.get(key) == value for key, value in wanted.items()):
                return reply

    def ask(self, command, **more):
        request = {"id": [command], "command": command, **more}
        REQUEST.validate(request)
        self.write(json.dumps(request) + "\n")
        return self.read_until(type="answer", id=[command])

    def status(self):
        self.write('{"command":"status"}\n')
        return self.read_until(type="status")


def connection_to(case, process, place):
    """To the socket at the path, once `kerf run --control` of the process listens there: a moment after the path is there."""
    connection = socket.socket(socket.AF_UNIX)
    case.addCleanup(connection.close)
    connection.settimeout(60)
    while True:
        try:
            connection.connect(place)
            return connection
        except (ConnectionRefusedError, FileNotFoundError):
            case.assertIsNone(process.poll())
            time.sleep(0.01)


def connect(case, process, place):
    return client_of(case, connection_to(case, process, place))


def client_of(case, connection):
    reader, writer = connection.makefile("rb"), connection.makefile("wb")
    case.addCleanup(reader.close)
    client = Client(case, reader, writer, connection)
    hello = client.read()
    case.assertEqual((hello["type"], hello["schema_version"]), ("hello", 1))
    return client


class ControlCase(Case):
    """Runs `kerf run --control`, and commands it."""

    def run_kerf(self, control, program=LINE, fds=(), stdin=subprocess.DEVNULL, options=(), path=None):
        """path: where the program is, in place of a file with it."""
        process = subprocess.Popen([KERF, "run", path or self.path("part.ngc", program), "--control", control, "--trace", self.path("run.csv"), *options],
                                   stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE, pass_fds=fds)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def start(self, program=LINE, options=()):
        """`kerf run` at the other end of a socket."""
        ours, theirs = socket.socketpair()
        process = self.run_kerf(str(theirs.fileno()), program, (theirs.fileno(),), options=options)
        theirs.close()
        self.addCleanup(ours.close)
        ours.settimeout(60)
        return process, self.client(ours)

    def client(self, connection):
        return client_of(self, connection)

    def end(self, process, status):
        self.assertEqual(process.wait(timeout=60), status)
        with open(self.path("run.csv"), encoding="utf-8") as file:
            return [line for line in file if not line.startswith("#")]

    def ends_at(self, process, status, **place_mm):
        """As end(); the last row is at this place."""
        rows = self.end(process, status)
        last = dict(zip(rows[0].strip().split(","), rows[-1].strip().split(",")))
        self.assertEqual({axis: float(last[f"{axis}_mm"]) for axis in place_mm}, place_mm)
