"""The plan shares the time out, the disk is looked at, and libFuzzer's words are read."""

import sys
import unittest
import unittest.mock
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from campaigns import libfuzzer, plan, tools


class Plans(unittest.TestCase):
    """Whatever the numbers are, all have the same share, and no process does two things at a time."""

    def test_shares_are_equal_and_fill_the_time(self):
        for count in [1, 2, 5, 10]:
            for jobs in [1, 2, 3, 16]:
                for seconds in [0, 30, 180, 3600]:
                    self.check([f"target {i}" for i in range(count)], jobs, seconds)

    def check(self, targets, jobs, seconds):
        lanes = plan.slices(targets, jobs, seconds)
        spent = dict.fromkeys(targets, 0)
        for lane in lanes:
            clock = 0
            for target, start, end in lane:
                self.assertGreaterEqual(start, clock - 1e-6, "slices overlap")
                self.assertLessEqual(end - start, plan.LONGEST + 1e-6)
                spent[target] += end - start
                clock = end
            self.assertLessEqual(clock, seconds + 1e-6)
        share = seconds * jobs / len(targets)
        rounds = 2 + share / plan.LONGEST
        for target, sum_of_slices in spent.items():
            # What is cut off below a second is lost, at both ends of each round.
            self.assertGreaterEqual(sum_of_slices, share - 2 * plan.SHORTEST * rounds, f"{target} of {len(targets)}")
            self.assertLessEqual(sum_of_slices, share + 1e-6)

    def test_three_minutes_on_two_cores_reach_all_ten(self):
        lanes = plan.slices(list(range(10)), 2, 180)
        self.assertEqual({target for lane in lanes for target, _, _ in lane}, set(range(10)))


class Space(unittest.TestCase):
    """How much of the disk is free."""

    def test_too_little_space_is_told(self):
        for needed, is_enough in [(1e6, True), (7e18, False)]:
            with unittest.mock.patch.object(tools, "SPACE", needed):
                has_space, text = tools.space(".")
            self.assertEqual(has_space, is_enough)
            self.assertRegex(text, rf"^[\d.]+ GB of disk are free, {needed / 1e9:.0f} are needed$")


class Words(unittest.TestCase):
    """What libFuzzer prints."""

    def test_the_finding_is_told_from_slow_units(self):
        outcome = libfuzzer.Outcome(
            "Slowest unit: 12 s:\nartifact_prefix='/a b/'; Test unit written to /a b/slow-unit-01\nBase64: AA==\n"
            "Slowest unit: 20 s:\nartifact_prefix='/a b/'; Test unit written to /a b/slow-unit-02\n"
            "ALARM: working on the last Unit for 26 seconds\n"
            "artifact_prefix='/a b/'; Test unit written to /a b/timeout-03\n"
            "SUMMARY: libFuzzer: timeout\nstat::number_of_executed_units: 17\n")
        self.assertEqual([(str(file), seconds) for file, seconds in outcome.slow],
                         [("/a b/slow-unit-01", 12), ("/a b/slow-unit-02", 20)])
        self.assertEqual((outcome.artifact.name, libfuzzer.kind(outcome.artifact)), ("timeout-03", "timeout"))
        self.assertEqual((outcome.failure(), outcome.executions), ("libFuzzer: timeout", 17))

    def test_slow_units_alone_are_none(self):
        outcome = libfuzzer.Outcome("Slowest unit: 12 s:\nTest unit written to /slow-unit-01\n")
        self.assertIsNone(outcome.artifact)


if __name__ == "__main__":
    unittest.main()
