//! How deep faults are, against exact fractions; and what is measured.
