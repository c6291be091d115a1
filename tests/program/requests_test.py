#!/usr/bin/env python3
"""`kerf run --control`: requests at the edge of what the schema takes, and what is said of those beyond it."""
import json
import resource

from command_line import main
from control_channel import ControlCase, REQUEST

WAITS = ("--wait-start",)


class Requests(ControlCase):
    def answers(self, lines, options=WAITS):
        """One run's answer to each line."""
        process, client = self.start(options=options)
        answers = []
        for line in lines:
            client.write(line + "\n")
            answers.append(client.read_until(type="answer"))
        client.ask("stop")
        self.end(process, 7)
        return answers

    def end(self, process, status):
        self.assertEqual(process.wait(timeout=60), status)

    def reasons(self, *lines):
        return [answer["reason"] for answer in self.answers(lines)]

    def test_values_that_are_nested_too_deeply_are_refused_and_harm_nobody(self):
        before = resource.getrlimit(resource.RLIMIT_STACK)
        resource.setrlimit(resource.RLIMIT_STACK, (4 << 20, before[1]))  # of the run, and its threads
        self.addCleanup(resource.setrlimit, resource.RLIMIT_STACK, before)
        why = "it is nested more than 64 deep"
        self.assertEqual(self.reasons('{"id":' + "[" * 32740 + "0" + "]" * 32740 + "}", '{"id":' + '{"a":' * 10000 + "0" + "}" * 10000 + "}",
                                      '{"id":' + "[" * 64 + "]" * 64 + "}", "[" * 10000), [why] * 4)

    def test_values_that_are_nested_as_deeply_as_may_be_come_back(self):
        deep = "[" * 63 + '"[[[\\"[{"' + "]" * 63
        answer, = self.answers(['{"command":"hold","id":' + deep + "}"])
        self.assertEqual(answer["id"], json.loads(deep))


if __name__ == "__main__":
    main()
