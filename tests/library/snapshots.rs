//! Snapshots: plain text in `snapshots/`, to be read with the paper at hand.
//!
//! `INSTA_UPDATE=always cargo test --test library` writes them anew; then a person must look at what has
//! changed.

/// Compares with the snapshot of this name.
pub(crate) fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::new();
    settings.set_snapshot_path("../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}
