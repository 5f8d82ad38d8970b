//! All measurements as CSV, one line for each program on each data set.

use super::word;
use crate::judge::Verdict;
use crate::measure::Row;

/// The lines.
pub(crate) fn csv(rows: &[Row]) -> String {
    let mut text =
        "data,points,edges,inputs,program,answer,ns_median,ns_least,ns_most,bytes\n".to_owned();
    for row in rows {
        for cell in &row.cells {
            // A name holds a comma, but no quotes.
            let [points, edges] = row.size;
            text.push_str(&format!(
                "\"{}\",{points},{edges},{},{},",
                row.name, row.inputs, cell.program
            ));
            text.push_str(&match cell.outcome {
                Ok(outcome) => {
                    let verdict = match outcome.verdict {
                        Verdict::Delaunay => "delaunay",
                        Verdict::Triangulation => "not delaunay",
                        Verdict::Wrong => "wrong",
                    };
                    let [median, least, most] = outcome.time;
                    let bytes = super::bytes(outcome);
                    format!("{verdict},{median:.1},{least:.1},{most:.1},{bytes}\n")
                }
                Err(failure) => format!("{},,,,\n", word(failure)),
            });
        }
    }
    text
}
