//! The text of a report: where, with what and how was measured, and the tables.

use std::fmt::Write;
use std::process::Command;

use super::table::{Entry, Table, distinct};
use super::view::{Plot, View, short};
use crate::measure::{Row, Turn, processor};

/// How the rows came about.
#[derive(Clone, Debug)]
pub(crate) struct Method<'a> {
    pub(crate) experiment: &'a str,
    pub(crate) about: &'a str,
    pub(crate) commit: &'a str,
    pub(crate) repetitions: usize,
}

/// Title, method and data.
pub(super) fn head(method: &Method<'_>, rows: &[Row]) -> String {
    let Method {
        experiment,
        about,
        commit,
        repetitions,
    } = method;
    let timed = if *repetitions == 0 {
        "No time was measured.".to_owned()
    } else {
        format!(
            "Then all variants of a cell run in turn, {repetitions} times, each \
             time in another order. Times are medians over these turns of the processor's time, where \
             the system tells it; those of the phases are times on the clock. The counters of the crate are on then, \
             and those of all structures but the crate's own.\n\
             - Spread: in half of the rows the slowest turn took at most {:.0} % more than the fastest, in nine of \
             ten at most {:.0} %.{}",
            spread(rows, 0.5),
            spread(rows, 0.9),
            disturbed(rows),
        )
    };
    let mut text = format!(
        "# {experiment}\n\n{about}\n\n## Method\n\n\
         - Machine: {}. Compiler: {}. Commit: {commit}.\n\
         - Each variant runs once to count. {timed}\n\
         - All variants of a cell gave the same triangles, or there would be no report.\n\
         - Counts are in `{experiment}.csv`, the same in every run; all turns are in `{experiment}-turns.csv`.\n\n",
        processor(),
        compiler(),
    );
    text.push_str(
        "## Data\n\n| data | points | edges | triangles | front: mean | longest | swept |\n",
    );
    text.push_str("|---|---:|---:|---:|---:|---:|---|\n");
    for cell in distinct(rows.iter().map(|row| (&row.data, row.size))) {
        let row = rows.iter().find(|row| (&row.data, row.size) == cell);
        let Some(row) = row else { continue };
        let swept = if row.is_divided {
            "abandoned"
        } else {
            "to the end"
        };
        let front = if row.searches == 0 {
            ["".to_owned(), "".to_owned()]
        } else {
            [short(row.front_mean), row.front_max.to_string()]
        };
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {swept} |",
            row.data, row.points, row.edges, row.triangles, front[0], front[1],
        );
    }
    text.push_str("\nThe front is that of the first variant. Where its sweep was abandoned, divide and conquer made the result.\n\n");
    text
}

/// By how many per cent the slowest turn exceeds the fastest, in this share of the rows at most.
fn spread(rows: &[Row], share: f64) -> f64 {
    let spread = |row: &Row| {
        let times = || row.turns.iter().map(Turn::ms);
        let least = times().min_by(f64::total_cmp)?;
        Some(100.0 * (times().max_by(f64::total_cmp)? / least - 1.0))
    };
    let mut spreads: Vec<f64> = rows.iter().filter_map(spread).collect();
    spreads.sort_by(f64::total_cmp);
    let place = (share * spreads.len() as f64) as usize;
    spreads.get(place).copied().unwrap_or_default()
}

/// A warning, if other programs kept the processor from the turns.
fn disturbed(rows: &[Row]) -> String {
    let turns = || rows.iter().flat_map(|row| &row.turns);
    let count = turns().filter(|turn| turn.is_disturbed()).count();
    if count == 0 {
        return String::new();
    }
    let share = 100.0 * count as f64 / turns().count() as f64;
    let text = format!(
        "**The machine was busy**: in {share:.1} % of the turns the clock ran over a tenth longer than the processor. \
         Phases, which the clock tells, are too long there."
    );
    eprintln!("{}", text.replace('*', ""));
    format!("\n- {text}")
}

/// A view: its plots, and its tables folded away.
pub(super) fn section(view: &View, tables: &[Table], plots: &[Plot]) -> String {
    let mut text = format!("## {}\n\n{}\n\n", view.title, view.about);
    for Plot { file, about, .. } in plots {
        let _ = writeln!(text, "![{about}]({file})\n");
    }
    for table in tables {
        text.push_str(&markdown(table));
    }
    text
}

fn markdown(table: &Table) -> String {
    let mut text = format!("{}:\n\n| | {} |\n", table.title, table.columns.join(" | "));
    let _ = writeln!(text, "|---|{}", "---:|".repeat(table.columns.len()));
    for line in &table.lines {
        let cell = |entry: &Entry| match entry {
            Entry::Number(x) => short(*x),
            Entry::Ratio(ratio) => format!(
                "{} ({} to {})",
                short(ratio.middle),
                short(ratio.low),
                short(ratio.high)
            ),
            Entry::LeftOut => "left out".to_owned(),
            Entry::Unknown => String::new(),
        };
        let cells: Vec<String> = line.cells.iter().map(cell).collect();
        let _ = writeln!(text, "| {} | {} |", line.variant, cells.join(" | "));
    }
    text + "\n"
}

/// The compiler of this program.
fn compiler() -> &'static str {
    env!("COMPILER")
}

/// The commit of the sources, if they are in a repository and Git is there.
pub(crate) fn commit() -> String {
    let output = Command::new("git")
        .args(["describe", "--always", "--dirty", "--abbrev=12"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output();
    match output {
        Ok(output) if output.status.success() => {
            String::from_utf8_lossy(&output.stdout).trim().to_owned()
        }
        _ => "unknown".to_owned(),
    }
}
