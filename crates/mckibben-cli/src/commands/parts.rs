//! `parts list|show`.

use crate::{Context, Output, Result, examples::examples};
use clap::Subcommand;
use mckibben_app::{PartShowRequest, PartsListRequest, part_show, parts_list};

/// What has a name.
#[derive(Subcommand)]
pub enum Parts {
    /// All of them, or those of one kind
    #[command(after_long_help = examples(&[
    "parts list tubes"
]))]
    List {
        #[command(flatten)]
        request: PartsListRequest,
        #[command(flatten)]
        output: Output,
    },
    /// What has a name: its data, source and terms
    #[command(after_long_help = examples(&[
    "parts show latex-1/4x3/8in",
    "parts show dragon-skin-30",
    "design -F 60N -e 15% -p 4bar --tube latex-1/4x3/8in"
]))]
    Show {
        #[command(flatten)]
        request: PartShowRequest,
        #[command(flatten)]
        output: Output,
    },
}

impl Parts {
    pub fn run(self, context: &Context) -> Result<u8> {
        match self {
            Self::List { request, output } => output.print(context, &parts_list(&request)?),
            Self::Show { request, output } => output.print(context, &part_show(&request)?),
        }
    }
}
