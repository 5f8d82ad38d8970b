"""Writes `report.md`."""

from .processes import duration


def _table(head, rows):
    """A table in Markdown, and an empty line."""
    return [f"| {' | '.join(head)} |", "|---" * len(head) + "|", *(f"| {' | '.join(row)} |" for row in rows), ""]


def _targets(targets):
    rows = []
    for target in targets:
        rate = target.executions / target.seconds if target.seconds else 0
        corpus = f"{target.sizes[1]} ({target.sizes[0]})" if target.sizes else "not minimised"
        rows.append([target.name, duration(target.seconds), f"{target.executions:,}", f"{rate:,.0f}", corpus])
    return _table(["target", "minutes", "executions", "a second", "corpus (before)"], rows)


def _events(targets):
    """The table of degenerate events; a target has no shares where nothing was looked at."""
    shares = [target.shares() for target in targets]
    names = next((list(reached) for looked_at, reached in shares if looked_at), [])
    rows = [["**inputs looked at**", *(f"{looked_at:,}" for looked_at, _ in shares)]]
    for name in names:
        rows.append([name, *(f"{100 * reached.get(name, 0) / looked_at:.1f}" if looked_at else "-"
                             for looked_at, reached in shares)])
    return _table(["event", *(target.name for target in targets)], rows)


def _slow(targets):
    slow = sorted(((seconds, target.name, file) for target in targets for file, seconds in target.slow.items()),
                  reverse=True)
    if not slow:
        return ["None."]
    rows = [[name, str(seconds), str(file)] for seconds, name, file in slow]
    return _table(["target", "seconds", "bytes"], rows)


def _finding(finding):
    return [f"### {finding.folder.name}", "", f"`{finding.failure}` ({finding.kind}) {finding.note}".strip(), "",
            f"In `{finding.folder}`: {', '.join(finding.files())}. Once more:", "", "```sh", finding.again(), "```", "",
            "```text", finding.row(), "```", ""]


def write(campaign, path):
    """Writes the report of a campaign."""
    targets, findings = campaign.targets, campaign.findings
    total = sum(target.seconds for target in targets)
    lines = [f"# Fuzz campaign of {campaign.began:%Y-%m-%d %H:%M}", ""]
    if campaign.interrupted:
        lines += [f"**Stopped while {campaign.interrupted}.** What comes after that was left out.", ""]
    lines += [f"{total / 3600:.2f} hours of fuzzing in all, {sum(t.executions for t in targets):,} executions, "
              f"{len(findings)} findings.", ""]
    lines += _table(["stage", "minutes"], [[stage, duration(seconds)] for stage, seconds in campaign.times.items()])
    lines += _targets(targets)
    for target in targets:
        if target.broken:
            lines += [f"**{target.name} did not run:**", "", "```text", target.broken, "```", ""]
    lines += ["## Degenerate events", "",
              "How many inputs were looked at, and the share of them that reached each event, per cent.", ""]
    lines += _events(targets)
    lines += ["## Region coverage by the corpora", ""]
    if campaign.covered:
        rows = [[name, str(regions), str(missed), f"{100 * (regions - missed) / max(regions, 1):.2f} %"]
                for name, regions, missed in campaign.covered]
        lines += [*_table(["file", "regions", "missed", "covered"], rows), "coverage.txt shows every line.", ""]
    else:
        lines += [f"Not measured: {campaign.uncovered}.", ""]
    lines += ["## Findings", ""]
    for finding in findings:
        lines += _finding(finding)
    if not findings:
        lines += ["None.", ""]
    lines += ["## Slow inputs", "", "Of these libFuzzer says that they took longer than ten seconds. They are no findings.",
              "", *_slow(targets)]
    path.write_text("\n".join(lines) + "\n")
