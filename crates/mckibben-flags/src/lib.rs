//! Requests state their flags with the attributes of clap's derive macros. A front end without a
//! command line compiles no clap: there these macros take their place, and make nothing.

use proc_macro::TokenStream;

/// In place of `clap::Args`.
#[proc_macro_derive(Args, attributes(arg, command, group))]
pub fn args(_: TokenStream) -> TokenStream {
    TokenStream::new()
}

/// In place of `clap::ValueEnum`.
#[proc_macro_derive(ValueEnum, attributes(value))]
pub fn value_enum(_: TokenStream) -> TokenStream {
    TokenStream::new()
}
