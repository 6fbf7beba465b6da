//! The one place where panics of naga end.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Once;

thread_local! {
    static QUIET: Cell<bool> = const { Cell::new(false) };
}

/// Runs `work`; a panic inside becomes `Err` with its words, and nothing is printed.
///
/// # Errors
/// When `work` panics.
pub fn quietly<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let former = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if !QUIET.get() {
                former(info);
            }
        }));
    });
    let outer = QUIET.replace(true);
    let outcome = catch_unwind(AssertUnwindSafe(work));
    QUIET.set(outer);
    outcome.map_err(|payload| {
        payload
            .downcast_ref::<String>()
            .cloned()
            .or_else(|| payload.downcast_ref::<&str>().map(|&s| s.to_owned()))
            .unwrap_or_else(|| "no message".to_owned())
    })
}

#[cfg(test)]
mod tests {
    use super::quietly;

    #[test]
    fn the_words_of_a_panic_come_out() {
        assert_eq!(quietly(|| 3), Ok(3));
        assert_eq!(quietly(|| -> u32 { panic!("plain") }), Err("plain".to_owned()));
        assert_eq!(quietly(|| -> u32 { panic!("with {}", 1) }), Err("with 1".to_owned()));
        assert_eq!(quietly(|| std::panic::panic_any(5)), Err::<(), _>("no message".to_owned()));
    }

    #[test]
    fn what_panics_inside_may_guard_again() {
        let outcome = quietly(|| {
            let inner = quietly(|| -> u32 { panic!("inner") });
            assert_eq!(inner, Err("inner".to_owned()));
            panic!("outer");
        });
        assert_eq!(outcome, Err::<(), _>("outer".to_owned()));
    }
}
