"""What OSS-Fuzz and ClusterFuzzLite get: each target with its own options, its seeds and its dictionary."""

import shutil
import subprocess
import unittest
import zipfile

from fakes import Workplace


@unittest.skipUnless(shutil.which("zip"), "without zip")
class Builds(unittest.TestCase):
    """`build.sh` with a cargo that pretends."""

    def test_each_target_has_what_belongs_to_it(self):
        with Workplace("valid", "formats") as place:
            source, out = place.fuzz.parent / "source", place.fuzz.parent / "out"
            source.mkdir()
            out.mkdir()
            (source / "sweep-cdt").symlink_to(place.fuzz.parent)
            (place.fuzz / "dictionaries").mkdir()
            (place.fuzz / "dictionaries/formats.dict").write_text('"point"\n')
            subprocess.run(["bash", "-eu", place.fuzz / "oss-fuzz/build.sh"], check=True, capture_output=True,
                           env=place.settings(SRC=str(source), OUT=str(out)))
            self.assertEqual({file.name for file in out.iterdir()},
                             {"valid", "valid.options", "valid_seed_corpus.zip", "formats", "formats.options",
                              "formats_seed_corpus.zip", "formats.dict"})
            self.assertEqual((out / "valid.options").read_text(),
                             "[libfuzzer]\ntimeout = 25\nentropic = 0\nuse_counters = 0\n")
            self.assertEqual((out / "formats.options").read_text(),
                             "[libfuzzer]\ntimeout = 25\nentropic = 0\nuse_counters = 0\n")
            self.assertEqual(zipfile.ZipFile(out / "valid_seed_corpus.zip").namelist(), ["seed_0001"])


if __name__ == "__main__":
    unittest.main()
