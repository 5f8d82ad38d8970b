#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| sweep_cdt_properties::stream::test(bytes));
