"""Asks questions of findings again: `python3 again.py PROGRAM [FINDING]`, in this folder, with the program installed.

Each finding is a block of JSON below a heading of `PROGRAM.md`. `--repeat 20` asks it twenty times. `--recorded`, of one
program or of all, asks the judge about the answers in the blocks instead: it fails where the verdict is not as written.
"""
import argparse
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ECHO = [sys.executable, "-IS", "-c", "import sys\nfor line in sys.stdin: print(sys.argv[1], flush=True)"]
HERE = pathlib.Path(__file__).parent


def findings(program, name):
    for page in sorted(HERE.glob(f"{program or '[a-z]*'}.md")):
        for heading, block in re.findall(r"(?ms)^## (\S+)$.*?^```json\n(.*?)^```$", page.read_text()):
            if name in (None, heading):
                yield f"{page.stem} {heading}", json.loads(block)


def ask(given, finding, program):
    """What the judge prints when `program` is asked."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        file.write(json.dumps(finding["question"]))
        file.flush()
        command = [given.judge, "ask", file.name, *shlex.split(finding["claims"]), "--repeat", str(given.repeat)]
        return subprocess.run([*command, "--", *program], stdout=subprocess.PIPE, text=True, cwd=HERE).stdout


def is_as_recorded(given, finding):
    pairs = [(finding["right"], "right")]
    if "failed" not in finding["answer"]:
        pairs.append((finding["answer"], finding["verdict"]))
    said = [ask(given, finding, ECHO + [json.dumps(answer)]).splitlines() for answer, _ in pairs]
    return all(lines and lines[-1].strip() == verdict for lines, (_, verdict) in zip(said, pairs))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?", help="the name of a page, without .md")
    parser.add_argument("finding", nargs="?", help="a heading of the page")
    parser.add_argument("--repeat", type=int, default=1)
    parser.add_argument("--judge", default="sweep-cdt-judge", help="the command")
    parser.add_argument("--recorded", action="store_true")
    given = parser.parse_args()
    chosen = list(findings(given.program, given.finding))
    wrong = 0
    for name, finding in chosen:
        if not given.recorded:
            print(f"{name}\n{ask(given, finding, shlex.split(finding['program']))}", flush=True)
        elif not is_as_recorded(given, finding):
            wrong += 1
            print(f"{name}: the judge does not say what is written")
    print(f"{len(chosen)} findings")
    sys.exit(wrong > 0 or not chosen)


main()
