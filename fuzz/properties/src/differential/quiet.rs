//! Panics that are expected, and must neither be printed nor end the process.
//!
//! A fuzz target's process has a panic hook that aborts. One hook around it, set once, that does nothing
//! on a thread which is asking another program, costs nothing per call, and leaves all other panics as
//! they are.

use std::cell::Cell;
use std::panic::{set_hook, take_hook};
use std::sync::Once;

thread_local! {
    static IS_QUIET: Cell<bool> = const { Cell::new(false) };
}

/// Calls a function that catches its own panics, without the hook.
pub(super) fn quietly<T>(call: impl FnOnce() -> T) -> T {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let loud = take_hook();
        set_hook(Box::new(move |panic| {
            if !IS_QUIET.get() {
                loud(panic);
            }
        }));
    });
    let before = IS_QUIET.replace(true);
    let result = call();
    IS_QUIET.set(before);
    result
}

#[test]
fn only_other_panics_reach_the_hook() {
    use std::panic::catch_unwind;
    use std::sync::Mutex;

    static HEARD: Mutex<Vec<&str>> = Mutex::new(Vec::new());
    let loud = take_hook();
    set_hook(Box::new(move |panic| {
        match panic.payload().downcast_ref::<&str>() {
            Some(text @ (&"before" | &"expected" | &"after")) => {
                HEARD.lock().expect("no panic holds it").push(text);
            }
            _ => loud(panic),
        }
    }));
    assert!(catch_unwind(|| panic!("before")).is_err());
    assert!(quietly(|| catch_unwind(|| panic!("expected"))).is_err());
    assert!(catch_unwind(|| panic!("after")).is_err());
    assert_eq!(
        *HEARD.lock().expect("no panic holds it"),
        ["before", "after"]
    );
}
