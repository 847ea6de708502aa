//! mckibben as a WebAssembly module with a bare interface: no generated glue, any host can call it.
//!
//! The host writes a command and its request (UTF-8) into memory that [`reserve`] gave, calls
//! [`ask`], and reads the answer at [`answer`], [`answer_length`] bytes long: packed as
//! `mckibben_app::ask_packed` says, or where `ask` returned 1 a problem as JSON. It imports one
//! function, `host.progress(done, total)`. A panic writes its words to where the answer stands and
//! traps; the host then reads them and makes a new instance.

use mckibben_app::ask_packed;
use mckibben_core::progress::Progress;
use std::cell::RefCell;

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "host")]
unsafe extern "C" {
    /// So many of so many steps are done.
    fn progress(done: u32, total: u32);
}

struct Host;

impl Progress for Host {
    #[cfg(target_arch = "wasm32")]
    fn report(&self, done: usize, total: usize) {
        // SAFETY: it takes two numbers and touches no memory of this module.
        unsafe { progress(done as u32, total as u32) }
    }
}

thread_local! {
    static INPUT: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
}

/// Where the host may write so many bytes: the command, then the request.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(bytes: usize) -> *mut u8 {
    INPUT.with_borrow_mut(|input| {
        input.clear();
        input.resize(bytes, 0);
        input.as_mut_ptr()
    })
}

/// Answers what was written: the command is the first so many bytes. 0 where there is an answer, 1
/// where there is a problem.
#[unsafe(no_mangle)]
pub extern "C" fn ask(command_bytes: usize) -> u32 {
    let input = INPUT.take();
    let (command, request) = input.split_at(command_bytes.min(input.len()));
    let command = String::from_utf8_lossy(command);
    let request = String::from_utf8_lossy(request);
    let (bytes, wrong) = match ask_packed(&command, &request, &Host) {
        Ok(bytes) => (bytes, 0),
        Err(problem) => (serde_json::to_vec(&problem).unwrap_or_default(), 1),
    };
    ANSWER.replace(bytes);
    wrong
}

/// Where the answer stands.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    ANSWER.with_borrow(std::vec::Vec::as_ptr)
}

/// How many bytes it has.
#[unsafe(no_mangle)]
pub extern "C" fn answer_length() -> usize {
    ANSWER.with_borrow(Vec::len)
}

/// To be called once, before anything else: the words of a panic are left where the answer stands.
#[unsafe(no_mangle)]
pub extern "C" fn start() {
    std::panic::set_hook(Box::new(|panic| {
        let words = panic.to_string();
        let _ = ANSWER.try_with(|answer| {
            answer
                .try_borrow_mut()
                .map(|mut answer| *answer = words.into_bytes())
        });
    }));
}
