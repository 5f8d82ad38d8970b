#![no_main]

sweep_cdt_properties::target!(edits);
