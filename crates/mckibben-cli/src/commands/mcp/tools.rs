//! Tools: commands of the application layer, by their schemas and within the budgets of the server.

use super::messages::{PARAMS, Wrong};
use crate::failure::Failure;
use crate::output::save_all;
use crate::progress::with;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use mckibben::budget::{Budget, Limits, Resource};
use mckibben::progress::Progress;
use mckibben_app::{BuiltFile, CommandEntry, Problem, find};
use mckibben_report::Figure;
use mckibben_server::Config;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Name of a tool, and of the command that it is.
const TOOLS: [(&str, &str); 8] = [
    ("design", "design"),
    ("state", "force"),
    ("curve", "curve"),
    ("identify", "identify"),
    ("compare", "compare"),
    ("parts", "parts-list"),
    ("joint", "joint"),
    ("export", "export"),
];

/// All tools with the schemas of their requests and answers.
pub fn list() -> Vec<Value> {
    let tool = |(name, command): (&str, &str)| -> Option<Value> {
        let entry = find(command).ok()?;
        let schema = entry.schema();
        // Only `export` changes anything, and that only in a folder that was named for it.
        let reads = name != "export";
        Some(json!({
            "name": name,
            "description": entry.about(),
            "inputSchema": schema["request"],
            "outputSchema": schema["answer"],
            "annotations": { "readOnlyHint": reads, "destructiveHint": false, "idempotentHint": true, "openWorldHint": false },
        }))
    };
    TOOLS.into_iter().filter_map(tool).collect()
}

/// Where tools are called.
pub struct Desk {
    /// Where `export` may write.
    folder: Option<PathBuf>,
    config: Config,
}

/// The work of a question, within its budget.
struct Within<'a>(&'a Budget);

impl Progress for Within<'_> {
    fn report(&self, _: usize, _: usize) {}

    fn cancelled(&self) -> bool {
        self.0.check().is_err()
    }

    fn budget(&self) -> Budget {
        self.0.clone()
    }
}

impl Desk {
    /// With the budgets of the server, and others in their place.
    pub fn new(folder: Option<&Path>, limits: &[(Resource, f64)]) -> Result<Self, Failure> {
        let mut config = Config::default();
        config.limits = with(config.limits, limits);
        config.jobs.limits = with(config.jobs.limits, limits);
        if let Some(folder) = folder {
            std::fs::create_dir_all(folder).map_err(|e| Failure::unwritable(folder, &e))?;
        }
        Ok(Self { folder: folder.map(Path::to_owned), config })
    }

    /// The longest message in bytes.
    pub fn longest(&self) -> u64 {
        self.config.body_bytes as u64
    }

    /// What a call may cost.
    pub fn budget(&self, params: &Value) -> Budget {
        let limits: Limits = match command(params) {
            Some(entry) if entry.long => self.config.jobs.limits,
            _ => self.config.limits,
        };
        Budget::new(limits)
    }

    /// Calls a tool. A problem is a result of the tool, so that the assistant reads it; only a call of no tool is an error.
    pub fn call(&self, params: &Value, budget: &Budget) -> Result<Value, Wrong> {
        let Some(entry) = command(params) else {
            let names = TOOLS.map(|tool| tool.0).join(", ");
            return Err((PARAMS, format!("there is no tool {}; the tools are {names}", params["name"])));
        };
        let done = self.answer(entry, params["arguments"].clone(), budget);
        Ok(done.unwrap_or_else(|problem| {
            json!({
                "isError": true,
                "content": [{ "type": "text", "text": format!("{problem}") }, { "type": "text", "text": json!(problem).to_string() }],
            })
        }))
    }

    fn answer(&self, entry: &CommandEntry, arguments: Value, budget: &Budget) -> Result<Value, Problem> {
        let request = if arguments.is_null() { json!({}) } else { arguments };
        if entry.touches_disk(&request) {
            return Err(Problem::new(
                mckibben_app::ProblemKind::Usage,
                "a tool reads no files of this computer",
                "hand the text over",
            ));
        }
        let mut answer = entry.read(request)?.answer(&Within(budget))?;
        let figure = answer.as_object_mut().and_then(|fields| fields.remove("figure"));
        let mut content = vec![];
        if let Some(figure) = figure.and_then(|figure| serde_json::from_value::<Figure>(figure).ok()) {
            let png = figure
                .to_png()
                .map_err(|e| Problem::new(mckibben_app::ProblemKind::Plot, e.to_string(), ""))?;
            content.push(json!({ "type": "image", "data": STANDARD.encode(png), "mimeType": "image/png" }));
        }
        if entry.name == "export"
            && let Some(folder) = &self.folder
        {
            content.push(json!({ "type": "text", "text": written(&answer, folder)? }));
        }
        content.insert(0, json!({ "type": "text", "text": answer.to_string() }));
        Ok(json!({ "content": content, "structuredContent": answer, "isError": false }))
    }
}

fn command(params: &Value) -> Option<&'static CommandEntry> {
    let (_, command) = TOOLS.iter().find(|tool| params["name"] == tool.0)?;
    find(command).ok()
}

/// Writes the files of an answer into a folder of its own below the one that was named; where they are, in a sentence.
fn written(answer: &Value, folder: &Path) -> Result<String, Problem> {
    let unwritten = |why: String| {
        Problem::new(mckibben_app::ProblemKind::Output, why, "name another folder, or another `name`")
    };
    let file = |file: &Value| -> Option<BuiltFile> {
        let text = |key: &str| file[key].as_str().map(str::to_owned);
        let content =
            text("text").map(String::into_bytes).or_else(|| STANDARD.decode(text("base64")?).ok())?;
        Some(BuiltFile { name: text("name")?, about: text("about")?, text: None, base64: None, content })
    };
    let files: Vec<BuiltFile> = answer["files"].as_array().into_iter().flatten().filter_map(file).collect();
    // Made by the program, and digits.
    let own = ["target", "hash"].map(|key| answer[key].as_str().unwrap_or_default()).join("-");
    let folder = &folder.join(own);
    save_all(&files, folder).map_err(|failure| unwritten(failure.to_text()))?;
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    Ok(format!("{} files are in {}: {}", files.len(), folder.display(), names.join(", ")))
}
