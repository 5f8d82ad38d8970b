"""Campaigns with fake targets: the time is shared and kept, findings are kept apart, and Ctrl-C ends in a report."""

import signal
import time
import unittest

from fakes import Workplace


class Campaigns(unittest.TestCase):
    """Each runs a campaign of some seconds."""

    def test_every_target_has_its_share_and_the_time_is_kept(self):
        names = [f"target_{i}" for i in range(5)]
        with Workplace(*names) as place:
            status, text = place.run("--minutes", "0.1", "--jobs", "2", "--coverage")
            self.assertEqual(status, 0, text)
            self.assertEqual({name for name, _ in place.slices()}, set(names))
            self.assertRegex(text, "fuzzing 0:0[567]")
            self.assertNotIn("-max_len", place.slices()[0][1], "a target makes no input that it does not read")
            self.assertIn("| sweep/mod.rs | 2 | 1 | 50.00 % |", place.report())
            self.assertIn("| **inputs looked at** | 0 | 0 | 0 | 0 | 0 |", place.report())

    def test_a_target_that_loads_its_seeds_for_long_does_not_take_the_time_of_others(self):
        with Workplace("loading", "other") as place:
            status, text = place.run("--minutes", "0.08", "--jobs", "1")
            self.assertEqual(status, 0, text)
            self.assertRegex(text, "fuzzing 0:0[3-6]")
            self.assertEqual([name for name, _ in place.slices()], ["loading", "other"])
            self.assertRegex(place.report(), r"\| loading \| 0:02 \| 100 \|")
            self.assertIn("Not measured: `--coverage` was not asked for", place.report())
            self.assertNotIn("building the program", text)

    def test_a_slow_input_is_no_finding_and_does_not_hide_one(self):
        with Workplace("slow", "other") as place:
            status, text = place.run("--minutes", "0.05", "--jobs", "2")
            self.assertEqual(status, 1, text)
            [folder] = (place.out / "findings").iterdir()
            self.assertEqual((folder / "bytes").read_bytes(), b"small")
            self.assertIn("vertex 12", (folder / "panic.txt").read_text())
            report = place.report()
            self.assertIn("`src/sweep/mod.rs:7:9: vertex N is not there` (crash)", report)
            self.assertIn("row of b'small'", report)
            self.assertIn(f"\n{place.fuzz}/target/x86_64-fake-linux-gnu/release/slow {folder}/bytes\n", report)
            self.assertNotIn("did not fail again", report)
            self.assertIn("1 findings", report)
            self.assertRegex(report.partition("## Slow inputs")[2], r"\| slow \| 11 \| \S+/slow-unit-\w+ \|")

    def test_an_input_that_fails_does_not_block_its_target(self):
        with Workplace("seeded") as place:
            status, text = place.run("--minutes", "0.05", "--jobs", "1")
            self.assertEqual(status, 1, text)
            self.assertEqual(len(place.slices()), 2, "the seed fails once, then it is put aside")

    def test_a_target_that_does_not_run_is_told(self):
        with Workplace("absent", "other") as place:
            status, text = place.run("--minutes", "0.05", "--jobs", "2")
            self.assertEqual(status, 1, text)
            self.assertIn("absent did not run", place.report())
            self.assertIn("cannot be loaded", place.report())

    def test_interrupted_it_ends_in_a_report(self):
        with Workplace("slow", "other") as place:
            process = place.start("--minutes", "1", "--jobs", "2")
            while not place.log.exists() or "other" not in place.log.read_text():
                time.sleep(0.05)
            time.sleep(1)
            start = time.monotonic()
            process.send_signal(signal.SIGINT)
            text, _ = process.communicate(timeout=30)
            self.assertLess(time.monotonic() - start, 20, text)
            self.assertEqual(process.returncode, 1, text)
            report = place.report()
            self.assertIn("**Stopped while fuzzing", report)
            self.assertIn("Not made smaller", report)
            self.assertIn("row of b'large'", report)
            self.assertRegex(report, r"\| other \| 0:0\d \| 100 \|.*not minimised")

    def test_interrupted_at_the_coverage_it_does_not_go_on_with_other_targets(self):
        with Workplace("first", "second", "third") as place:
            process = place.start("--minutes", "0", "--jobs", "1", "--coverage", FAKE_COVERING="5")
            while process.poll() is None and not (place.log.exists() and "covering" in place.log.read_text()):
                time.sleep(0.05)
            process.send_signal(signal.SIGINT)
            text, _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 130, text)
            self.assertIn("Not measured: the campaign was stopped meanwhile", place.report())
            self.assertEqual(place.log.read_text().count("covering"), 1)

    def test_missing_tools_are_told_before_anything_else(self):
        with Workplace("other") as place:
            status, text = place.run(FAKE_MISSING="+nightly --version,fuzz --version")
            self.assertEqual(status, 2, text)
            self.assertIn("rustup toolchain install nightly", text)
            self.assertIn("cargo install cargo-fuzz", text)
            self.assertFalse(place.log.exists())

    def test_a_check_tells_and_runs_nothing(self):
        with Workplace("other") as place:
            status, text = place.run("--check", "--minutes", "5", "--jobs", "3")
            self.assertEqual(status, 0, text)
            self.assertRegex(text, r"all tools are there; [\d.]+ GB of disk are free, 3 are needed\n5 minutes of fuzzing")
            self.assertIn("3 processes at a time", text)
            self.assertFalse(place.log.exists() or place.out.exists())
            status, text = place.run("--check", FAKE_MISSING="fuzz --version")
            self.assertEqual(status, 2, text)
            self.assertIn("cargo install cargo-fuzz", text)


if __name__ == "__main__":
    unittest.main()
