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

    def test_whole_numbers_are_taken_however_they_are_written(self):
        lines = ('{"command":"block_delete","switches":[1.0,2e0]}', '{"command":"tool","number":1.0,"length_mm":5}', '{"command":"events","since":1e3}',
                 '{"command":"events","since":-0}', '{"command":"events","since":18446744073709551615}')
        self.assertTrue(all(REQUEST.is_valid(json.loads(line)) for line in lines))
        self.assertEqual([answer["accepted"] for answer in self.answers(lines)], [True] * len(lines))

    def test_what_is_refused_whatever_the_state_is_wrong_by_the_schema(self):
        lines = ('{"command":"block_delete","switches":[1.5]}', '{"command":"block_delete","switches":[10.0]}', '{"command":"tool","number":1.5,"length_mm":5}',
                 '{"command":"tool","number":1e5,"length_mm":5}', '{"command":"events","since":1.5}', '{"command":"events","since":-1.0}',
                 '{"command":"events","since":18446744073709551616}', '{"command":"events","since":1e300}', '{"command":"jog","velocity_mm_s":1}',
                 '{"command":"jog"}', '{"id":1,"command":"jog"}', '{"command":"jog","x_mm":1,"x_mm_s":1}', '{"command":"jog","x_mm_s":1,"velocity_mm_s":1}')
        self.assertEqual([line for line in lines if REQUEST.is_valid(json.loads(line))], [])
        self.assertEqual([answer["accepted"] for answer in self.answers(lines)], [False] * len(lines))

    def test_a_refusal_says_what_is_wrong(self):
        self.assertEqual(self.reasons('{"command":"mdi","line":"' + "x" * 70000 + '"}', '{"command":"override","feed_percent":1e309}', '{"id":1e400,"command":"hold"}',
                                      '{"command":"hold"', '{"command":"hold"} x', "", '{"command":"h\\q"}', '"hold"', "{}"),
                         ["the line is longer than 65,536 bytes", "a number is out of range", "a number is out of range",
                          "it is no JSON: wrong at byte 18", "it is no JSON: wrong at byte 20", "the line is empty", "it is no JSON: wrong at byte 15",
                          "an object with a command is wanted", "an object with a command is wanted"])

    def test_numbers_of_an_id_come_back_as_the_nearest_double_and_whole_ones_of_64_bits_exactly(self):
        for text, back in (("18446744073709551615", 18446744073709551615), ("-9223372036854775808", -9223372036854775808), ("0.1", 0.1),
                           ("123456789012345678901234567890", 123456789012345678901234567890.0)):
            answer, = self.answers(['{"command":"hold","id":' + text + "}"])
            self.assertEqual(answer["id"], back)


if __name__ == "__main__":
    main()
