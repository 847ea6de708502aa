//! The border that no panic crosses: a fault of the program itself becomes a [`Problem`] as well.

use crate::problem::{Problem, ProblemKind};
use mckibben::cancel::Cancel;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::{Mutex, PoisonError};

/// Where the last panic happened, if [`panics_are_problems`] was called.
static PLACE: Mutex<Option<String>> = Mutex::new(None);

/// Does the work of a request; a panic in it, on whichever thread, becomes a [`Problem`] of kind `internal`. [`ask`](crate::ask)
/// works in this way; a front end that calls the functions of the commands puts it around them.
///
/// A stack that overflows and memory that runs out are no panics: they end the process.
pub fn guarded<T, E: From<Problem>>(work: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    // What the work had in its hands is dropped with it: nobody sees a half-made value.
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|cause| Err(internal(&*cause).into()))
}

/// Does the work of a request until it is cancelled, on whichever thread it is done and whatever it calls. What came out of cancelled work
/// is neither an answer nor a reason. A panic is a [`Problem`], as in [`guarded`].
pub fn within<T, E: From<Problem>>(cancel: &Cancel, work: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    guarded(|| {
        let _entered = cancel.enter();
        let done = work();
        cancel.check().map_err(Problem::from)?;
        done
    })
}

/// For a front end that owns its process, once at its start: panics are written to nobody, and [`guarded`] says where they
/// happened. With `RUST_BACKTRACE` set they are written to standard error as ever.
pub fn panics_are_problems() {
    let usual = take_hook();
    let loud = std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value != "0");
    set_hook(Box::new(move |panic| {
        let place = panic.location().map(ToString::to_string);
        *PLACE.lock().unwrap_or_else(PoisonError::into_inner) = place;
        if loud {
            usual(panic);
        }
    }));
}

fn internal(cause: &(dyn Any + Send)) -> Problem {
    let said = cause.downcast_ref::<&str>().copied();
    let said =
        said.or_else(|| cause.downcast_ref::<String>().map(String::as_str)).unwrap_or("no reason given");
    let place = PLACE.lock().unwrap_or_else(PoisonError::into_inner).take();
    let place = place.map_or_else(String::new, |place| format!(" ({place})"));
    let message = format!("internal error of mckibben {}: {said}{place}", env!("CARGO_PKG_VERSION"));
    let hint = "please report this message with the request and its files; the same request will fail again";
    Problem::new(ProblemKind::Internal, message, hint)
}
