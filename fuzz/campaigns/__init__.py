"""The parts of `fuzz/campaign`: one purpose a file.

`tools` looks for the programs that a campaign needs, `processes` runs them and ends them at Ctrl-C, `plan` shares the
time out, `libfuzzer` runs one slice and reads what it says, `target` keeps what is known of a
target, `findings` describes a failure, `coverage` measures the corpora, `report` writes it all down.
"""
